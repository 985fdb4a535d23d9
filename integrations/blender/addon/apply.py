# SPDX-License-Identifier: GPL-3.0-or-later
"""What *Apply* does to a scene: all of it at the end, so that whatever fails before has changed nothing."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy

from .job import read_manifest
from .material import MARK, SCALE, make_material
from .uv_scale import uv_size

__all__ = ["clothe", "read_manifest"]


def clothe(
    things: Sequence[bpy.types.Object], maps: Path, manifest: dict[str, Any], relief: bool
) -> bpy.types.Material:
    """Gives mesh objects the material of a folder of maps in their active slots, and the scale of their uv.

    Raises:
        MapsError: the folder cannot be used; then nothing has changed.
    """
    material = make_material(maps, manifest, relief)
    metres = bpy.context.scene.unit_settings.scale_length
    replaced = set()
    for thing in things:
        size = uv_size(thing, metres)
        if size is not None:
            thing[SCALE] = (*size, 0.0)
        if not thing.material_slots:
            thing.data.materials.append(material)
        else:
            replaced.add(thing.active_material)
            thing.material_slots[thing.active_material_index].material = material
    _remove_unused(replaced)
    return material


def _remove_unused(materials: set[bpy.types.Material | None]) -> None:
    """Removes materials of this add-on that nothing uses any more, with their groups and maps."""
    for material in materials:
        if material is None or MARK not in material or material.users:
            continue
        node = material.node_tree.nodes.get(MARK)
        group = node.node_tree if node is not None else None
        bpy.data.materials.remove(material)
        if group is None or group.users or MARK not in group:
            continue
        images = {part.image for part in group.nodes if part.type == "TEX_IMAGE" and part.image is not None}
        bpy.data.node_groups.remove(group)
        for image in images:
            if not image.users:
                bpy.data.images.remove(image)
