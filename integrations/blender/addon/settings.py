# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panel asks for, kept in the scene, and the fabric file that it comes to."""

from __future__ import annotations

from typing import Any

import bpy

from . import fabric_file, pictures

# Kinds of yarn as a fabric file names them.
YARNS = (
    "cotton",
    "combed cotton",
    "open-end cotton",
    "mercerised cotton",
    "linen",
    "wool",
    "woollen",
    "worsted",
    "silk",
    "dupion silk",
    "filament polyester",
    "viscose",
)
_OWN = "OWN"
_FAMILIES = ("warp", "weft")


def _take_weave(settings: LoomlightSettings, context: bpy.types.Context) -> None:
    settings.weave = settings.weave_example


# Blender evaluates annotations where a lambda would not find this module's names.
def _fabrics(settings: LoomlightSettings, context: bpy.types.Context) -> list[pictures.Item]:
    return pictures.fabrics()


def _weaves(settings: LoomlightSettings, context: bpy.types.Context) -> list[pictures.Item]:
    return pictures.weaves()


# Blender makes properties of annotations that are calls, which no type checker takes for types.
class LoomlightSettings(bpy.types.PropertyGroup):
    """The fabric that *Apply* puts onto the selected objects."""

    source: bpy.props.EnumProperty(  # type: ignore[valid-type]
        name="From",
        items=(
            ("GALLERY", "Gallery", "A fabric that comes with the add-on"),
            ("WEAVE", "Weave", "A weave by its name"),
            ("FILE", "File", "A fabric file, a WIF or a picture of a drawdown"),
            ("READY", "Ready", "The fabric that this copy of the add-on was written for; needs no loomlight"),
        ),
    )
    fabric: bpy.props.EnumProperty(name="Fabric", items=_fabrics)  # type: ignore[valid-type]
    weave_example: bpy.props.EnumProperty(  # type: ignore[valid-type]
        name="Weaves", items=_weaves, update=_take_weave
    )
    weave: bpy.props.StringProperty(  # type: ignore[valid-type]
        name="Weave", description="Such as twill 2/1, satin 8/3, herringbone 2/2 8", default="twill 2/1"
    )
    file: bpy.props.StringProperty(name="File", subtype="FILE_PATH")  # type: ignore[valid-type]
    use_warp: bpy.props.BoolProperty(name="Warp", description="Dye the warp in one colour")  # type: ignore[valid-type]
    use_weft: bpy.props.BoolProperty(name="Weft", description="Dye the weft in one colour")  # type: ignore[valid-type]
    warp: bpy.props.FloatVectorProperty(  # type: ignore[valid-type]
        name="Warp", subtype="COLOR", size=3, min=0, max=1, default=(0.018, 0.042, 0.147)
    )
    weft: bpy.props.FloatVectorProperty(  # type: ignore[valid-type]
        name="Weft", subtype="COLOR", size=3, min=0, max=1, default=(0.5, 0.46, 0.38)
    )
    yarn: bpy.props.EnumProperty(  # type: ignore[valid-type]
        name="Yarn",
        items=((_OWN, "The fabric's", "As the fabric has it"), *((name, name, "") for name in YARNS)),
    )
    ends_per_cm: bpy.props.FloatProperty(  # type: ignore[valid-type]
        name="Ends per cm", description="Warp threads; 0 is as the fabric has it", min=0, max=1000
    )
    picks_per_cm: bpy.props.FloatProperty(  # type: ignore[valid-type]
        name="Picks per cm", description="Weft threads; 0 is as the fabric has it", min=0, max=1000
    )
    roughness: bpy.props.FloatProperty(  # type: ignore[valid-type]
        name="Roughness", description="Of the fibres; 0 is as the fabric has it", min=0, max=1
    )
    displacement: bpy.props.BoolProperty(  # type: ignore[valid-type]
        name="Displacement", description="Yarns displace a finely divided mesh where they are near"
    )
    message: bpy.props.StringProperty(options={"SKIP_SAVE"})  # type: ignore[valid-type]
    is_fault: bpy.props.BoolProperty(options={"SKIP_SAVE"})  # type: ignore[valid-type]

    def text(self) -> str:
        """The fabric file.

        Raises:
            FileError: a file that cannot be used.
        """
        return fabric_file.fabric_text(self._source(), self._changes())

    def _source(self) -> dict[str, Any]:
        if self.source == "GALLERY":
            return fabric_file.fields_of_file(str(pictures.gallery_file(self.fabric)))
        if self.source == "FILE":
            path = bpy.path.abspath(self.file)
            return {"name": bpy.path.display_name_from_filepath(path)} | fabric_file.fields_of_file(path)
        weave = " ".join(self.weave.split())
        if not weave:
            raise fabric_file.FileError("The weave has no name: write one, such as twill 2/1.")
        return {"name": weave, "weave": weave}

    def _changes(self) -> dict[str, Any]:
        """Fields that replace those of the source; None takes away what would say the same thing twice."""
        changes: dict[str, Any] = {name: {} for name in _FAMILIES}
        for name in _FAMILIES:
            if getattr(self, f"use_{name}"):
                changes[name] |= {"color": hex_of(getattr(self, name)), "albedo": None}
            if self.roughness > 0:
                changes[name]["roughness"] = max(self.roughness, 0.01)
            if self.yarn != _OWN:
                changes[name]["yarn"] = None
        if self.yarn != _OWN:
            changes["yarn"] = self.yarn
        for per_cm, per_inch in (("ends_per_cm", "epi"), ("picks_per_cm", "ppi")):
            if getattr(self, per_cm) > 0:
                changes |= {per_cm: max(getattr(self, per_cm), 0.1), per_inch: None}
        return changes


def hex_of(linear: bpy.types.bpy_prop_array) -> str:
    """A linear colour as "#rrggbb", sRGB."""

    def coded(value: float) -> int:
        value = min(max(value, 0.0), 1.0)
        return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))

    return "#" + "".join(f"{coded(value):02x}" for value in linear)


def register() -> None:
    """Adds the settings to scenes."""
    bpy.utils.register_class(LoomlightSettings)
    bpy.types.Scene.loomlight = bpy.props.PointerProperty(type=LoomlightSettings)


def unregister() -> None:
    """Takes them away."""
    del bpy.types.Scene.loomlight
    bpy.utils.unregister_class(LoomlightSettings)
