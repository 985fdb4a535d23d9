"""What a page asks Python about a fabric's yarns: their openness, and joint visibility of light and view."""

from __future__ import annotations

from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.yarn.geometry import YarnGeometry


def openness_json(fabric: Fabric) -> dict[str, list[float]]:
    """Flat lists by name: the parts that shaders read, and what the inversion of colours needs beside them.

    "joint" has the words of `LobeTables.joint`. All depend on where yarns lie, on roughness, optical depth
    and the diffuse blend alone, whatever the colours are and whether or not the fields ask for light between
    yarns. Parts are those of `realtime.openness_tables.PARTS`, others those of `Openness`.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    require_llvm()
    from loomlight.models.lobes.model import DEFAULT_GROUPS
    from loomlight.models.lobes.tables import bake_joint
    from loomlight.realtime.openness_tables import openness_parts
    from loomlight.realtime.word_table import packed_bytes
    from loomlight.scattering.openness import openness_of

    appearance = fabric.appearance()
    openness = appearance.openness
    if openness is None:
        roughness = appearance.warp.roughness, appearance.weft.roughness
        openness = openness_of(fabric.layout(), appearance.diffuse_blend, roughness, appearance.optical_depth)
    parts = {name.lower(): part for name, part in openness_parts(openness, appearance).items()}
    facing = {"facing": openness.facing, "facing_layer": openness.facing_layer}
    joint = bake_joint(YarnGeometry(fabric.layout()), appearance.diffuse_blend, DEFAULT_GROUPS, llvm_float())
    lists = {name: part.ravel().tolist() for name, part in (parts | facing).items()}
    return lists | {"joint": packed_bytes(joint).tolist()}
