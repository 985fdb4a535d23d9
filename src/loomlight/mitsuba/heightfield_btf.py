"""The BTF of a height field: paths traced over a mesh of its tile, which repeats (kuznetsov2021 section 4).

The reference plane lies at the mean height.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.assets.heightfield import Heightfield
from loomlight.mesh.cloth_mesh import ClothMesh, joined
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.periodic_paths import COPIES, PeriodicPaths, Tile
from loomlight.mitsuba.variants import choose_variant

# Vertices of a path.
MAX_BOUNCES = 4
# Distance of starts of rays from the surface, in texels of the height map.
_EPSILON = 1e-2


class HeightfieldBtf(PeriodicPaths):
    """f·cos of paths through a height field; no ray passes through it."""

    faces, transmits, has_holes = 1, False, False

    def __init__(self, source: Heightfield) -> None:
        choose_variant(None)
        relief = source.height_mm * (source.height - source.height.mean(dtype=np.float64))
        super().__init__(
            Tile(
                mi.load_dict({"type": "scene", "relief": _tiles(source, relief)}),
                source.size_mm,
                float(relief.max()),
                float(relief.min()),
                # Vertices lie in the middle of texels.
                (0.5 * source.size_mm[0] / relief.shape[1], 0.5 * source.size_mm[1] / relief.shape[0]),
                _EPSILON * min(source.size_mm) / max(source.height.shape),
                MAX_BOUNCES,
            )
        )


def _tiles(source: Heightfield, relief: NDArray[np.floating[Any]]) -> Any:
    """A mesh of all copies of the tile."""
    one = _mesh(source, relief)
    width, height = source.size_mm
    shifts = range(-COPIES, COPIES + 1)
    offsets = [np.array([column * width, row * height, 0]) for row in shifts for column in shifts]
    copies = [replace(one, positions=one.positions + offset) for offset in offsets]
    return to_shape(joined(copies), _bsdf(source))


def _mesh(source: Heightfield, relief: NDArray[np.floating[Any]]) -> ClothMesh:
    """The relief over one tile, a vertex a texel of the height map, and one more at the far sides."""
    rows, columns = relief.shape
    width, height = source.size_mm
    across, along = width / columns, height / rows
    slope_x = (np.roll(relief, -1, 1) - np.roll(relief, 1, 1)) / (2 * across)
    slope_y = (np.roll(relief, -1, 0) - np.roll(relief, 1, 0)) / (2 * along)
    normals = np.stack([-slope_x, -slope_y, np.ones_like(relief)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    z, normal = (
        np.pad(part, ((0, 1), (0, 1), (0, 0))[: part.ndim], mode="wrap") for part in (relief, normals)
    )
    v, u = np.meshgrid(
        (np.arange(rows + 1) + 0.5) / rows, (np.arange(columns + 1) + 0.5) / columns, indexing="ij"
    )
    positions = np.stack([u * width, v * height, z], axis=-1)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    right, up, far = corner + 1, corner + columns + 1, corner + columns + 2
    triangles = np.concatenate([np.stack([corner, right, far], 1), np.stack([corner, far, up], 1)])
    uv = np.stack([u, v], axis=-1).reshape(-1, 2)
    return ClothMesh(positions.reshape(-1, 3), normal.reshape(-1, 3), uv, triangles, "relief")


def _bsdf(source: Heightfield) -> dict[str, Any]:
    """Mitsuba's principled BSDF of the maps."""
    principled = {
        "type": "principled",
        "base_color": _texture(source.albedo),
        "roughness": _texture(source.roughness[..., None]),
        "metallic": _texture(source.metallic[..., None]),
        "specular": source.specular,
    }
    if source.normal is None:
        return principled
    return {"type": "normalmap", "normalmap": _texture(source.normal), "bsdf": principled}


def _texture(values: NDArray[np.float32]) -> dict[str, Any]:
    """A map [rows, columns, channels], numbers as they are."""
    return {
        "type": "bitmap",
        "data": mi.TensorXf(np.ascontiguousarray(values, np.float32)),
        "raw": True,
        "wrap_mode": "repeat",
    }
