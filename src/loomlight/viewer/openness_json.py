"""Openness of a fabric's yarns, for a page that computes everything else of light between yarns itself."""

from __future__ import annotations

from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric


def openness_json(fabric: Fabric) -> dict[str, list[float]]:
    """Flat lists by name: the parts that shaders read, and what the inversion of colours needs beside them.

    They depend on where yarns lie, on roughness, optical depth and the diffuse blend alone, whatever the
    colours are and whether or not the fields ask for light between yarns. Parts are those of
    `realtime.openness_tables.PARTS`, others those of `Openness`.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    require_llvm()
    from loomlight.realtime.openness_tables import openness_parts
    from loomlight.scattering.openness import openness_of

    appearance = fabric.appearance()
    openness = appearance.openness
    if openness is None:
        roughness = appearance.warp.roughness, appearance.weft.roughness
        openness = openness_of(fabric.layout(), appearance.diffuse_blend, roughness, appearance.optical_depth)
    parts = {name.lower(): part for name, part in openness_parts(openness, appearance).items()}
    facing = {"facing": openness.facing, "facing_layer": openness.facing_layer}
    return {name: part.ravel().tolist() for name, part in (parts | facing).items()}
