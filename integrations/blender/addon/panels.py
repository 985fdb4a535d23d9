# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel, in the sidebar of the 3D view and among the properties of materials."""

from __future__ import annotations

import textwrap
from typing import ClassVar

import bpy

from . import operators
from .material import COLOURS, RELIEF, SCALE, SHEEN, group_node

_LINE = 44


class _Panel:
    bl_label = "Loomlight"

    def draw(self, context: bpy.types.Context) -> None:
        """Draws the fabric, the button, what was said, and what may be changed at once."""
        layout, settings = self.layout, context.scene.loomlight
        layout.use_property_split, layout.use_property_decorate = True, False
        _draw_source(layout, settings)
        if settings.source != "READY":
            _draw_changes(layout, settings)
        layout.prop(settings, "displacement")
        row = layout.row()
        row.scale_y = 1.4
        if operators.is_running():
            row.operator("loomlight.cancel", icon="X")
        else:
            row.operator("loomlight.apply", icon="CHECKMARK")
        for number, line in enumerate(textwrap.wrap(settings.message, _LINE)):
            icon = "ERROR" if settings.is_fault else "INFO"
            layout.label(text=line, icon=icon if number == 0 else "BLANK1")
        _draw_material(layout, context.object)


def _draw_source(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    layout.row().prop(settings, "source", expand=True)
    if settings.source == "GALLERY":
        layout.template_icon_view(settings, "fabric", show_labels=True, scale=6)
        layout.prop(settings, "fabric", text="")
    elif settings.source == "WEAVE":
        layout.template_icon_view(settings, "weave_example", show_labels=True, scale=6)
        layout.prop(settings, "weave")
    elif settings.source == "FILE":
        layout.prop(settings, "file")


def _draw_changes(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    for name in ("warp", "weft"):
        row = layout.row(heading=name.capitalize())
        row.prop(settings, f"use_{name}", text="")
        colour = row.row()
        colour.enabled = getattr(settings, f"use_{name}")
        colour.prop(settings, name, text="")
    for name in ("yarn", "ends_per_cm", "picks_per_cm", "roughness"):
        layout.prop(settings, name)


def _draw_material(layout: bpy.types.UILayout, thing: bpy.types.Object | None) -> None:
    """What changes at once: colours and sheen of the material, the scale of the object."""
    node = group_node(thing.active_material) if thing is not None else None
    if node is None:
        return
    box = layout.box()
    box.label(text=thing.active_material.name, icon="MATERIAL")
    for name in (*COLOURS.values(), SHEEN, RELIEF):
        box.prop(node.inputs[name], "default_value", text=name)
    if SCALE in thing:
        box.prop(thing, f'["{SCALE}"]', text="mm per UV")


class LOOMLIGHT_PT_sidebar(_Panel, bpy.types.Panel):  # noqa: N801 (Blender's convention)
    """The panel of the 3D view."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Loomlight"


class LOOMLIGHT_PT_material(_Panel, bpy.types.Panel):  # noqa: N801 (Blender's convention)
    """The panel of the material properties."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_options: ClassVar[set[str]] = {"DEFAULT_CLOSED"}


def register() -> None:
    """Adds the panels."""
    bpy.utils.register_class(LOOMLIGHT_PT_sidebar)
    bpy.utils.register_class(LOOMLIGHT_PT_material)


def unregister() -> None:
    """Takes them away."""
    bpy.utils.unregister_class(LOOMLIGHT_PT_material)
    bpy.utils.unregister_class(LOOMLIGHT_PT_sidebar)
