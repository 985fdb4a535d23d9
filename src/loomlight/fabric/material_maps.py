"""Colour, opacity and roughness of a fabric's yarns on a grid, for materials of other programs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric

if TYPE_CHECKING:  # it loads Dr.Jit, and fabrics do without
    from loomlight.yarn.maps import SurfaceMaps


def material_maps(fabric: Fabric, maps: SurfaceMaps) -> dict[str, NDArray[np.float32]]:
    """Maps of a fabric for `write_maps`, on the grid of baked maps of its own layout.

    Returns:
        color [rows, columns, 3], the colour of the thread that shows, linear RGB, or its albedo where the
        file gives that; opacity, 0 in holes; roughness, the root of the fibres' α, as α of other programs is
        its square. Holes have the colour of a thread beside them, so that filters bring in no other.
    """
    warp, weft = (_colours(fabric, family) for family in ("warp", "weft"))
    # A thread of the other family may have an index that this one lacks.
    of_warp, of_weft = (colours[np.minimum(maps.thread, len(colours) - 1)] for colours in (warp, weft))
    appearance = fabric.appearance()
    alpha = np.where(maps.warp, appearance.warp.roughness, appearance.weft.roughness)
    return {
        "color": np.where(maps.warp[..., None], of_warp, of_weft).astype(np.float32),
        "opacity": (~maps.hole).astype(np.float32),
        "roughness": np.sqrt(alpha).astype(np.float32),
    }


def _colours(fabric: Fabric, family: str) -> NDArray[np.float64]:
    """Colours of the threads of a family [n, 3]."""
    colours = getattr(fabric.draft, family).colors
    appearance = getattr(fabric.appearance(), family)
    if colours is None or getattr(fabric.fields, family).diffuse_reflect is not None:
        return np.asarray(appearance.diffuse_reflect + appearance.diffuse_transmit)
    return np.asarray(colours)
