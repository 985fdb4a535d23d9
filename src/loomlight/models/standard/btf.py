"""Reflectance of a U3M material for training: its own formulas in batches, its maps as inputs of an encoder.

Normals become slopes with their first and second moments, which filter linearly (LEAN mapping, Olano & Baker
2010). Light from the other side is left out, as `latent` has none, and holes are black.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from drjit.llvm import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.standard.maps import FaceMaps, averaged
from loomlight.models.standard.model import StandardModel
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA
from loomlight.models.texture.queries import FOUR_POINTS, EncodedBtf, Texels
from loomlight.sources.u3m import U3mMaterial

_Floats = NDArray[np.float32]
# Evaluations in one launch.
_BATCH = 1 << 20
# Slopes are 1 at 45°; inputs of steeper ones are clipped here.
_STEEPEST = 2.0
# Points are squares of this share of the finest texel.
_POINT = 0.01


class U3mBtf(EncodedBtf):
    """f·cos of a U3M material; points are in repeats."""

    def __init__(self, source: U3mMaterial) -> None:
        """
        Raises:
            InputError: its faces repeat after different lengths.
        """
        require_llvm()
        self._model = StandardModel(source)
        front, back = self._model.maps
        both = all(face.has_pictures for face in source.faces)
        if both and not np.allclose(front.size_mm, back.size_mm, rtol=1e-2):
            raise InputError(
                f"{source.name} repeats after {front.size_mm[0]:g} × {front.size_mm[1]:g} mm in front and "
                f"{back.size_mm[0]:g} × {back.size_mm[1]:g} mm behind: latent learns faces of one size."
            )
        self.faces = 1 if back is front else 2
        self._size = source.size_mm
        self._texels = max(max(face.levels[0].shape[:2]) for face in (front, back))

    @property
    def extent(self) -> tuple[float, float]:
        """1: points are in repeats."""
        return 1.0, 1.0

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos [n, 3] at points of the plane [n, 2], in repeats; exact, so the seed is not used."""
        del seed
        found = np.empty((len(points), 3), np.float32)
        side = _POINT * min(self._size) / self._texels
        for first in range(0, len(points), _BATCH):
            part = slice(first, first + _BATCH)
            place = points[part] * np.array(self._size, np.float32)
            step, zero = dr.full(Float, side, len(place)), dr.zeros(Float, len(place))
            footprint = Footprint(Array2f(*place.T), Array2f(step, zero), Array2f(zero, step))
            at = self._model.at(Array3f(*views[part].T), footprint)
            found[part] = np.array(at.value(Array3f(*lights[part].T))).T
        return found

    def texels(self, resolution: int) -> U3mTexels:
        """The texels of the maps, no finer than those are; see `EncodedBtf.texels`."""
        return U3mTexels(self._model.maps[: self.faces], resolution)


class U3mTexels(Texels):
    """Texels of a material's maps, of the back as they lie behind the front: x runs the front's way."""

    turns = FOUR_POINTS
    inputs = (
        "base.r", "base.g", "base.b", "alpha", "roughness", "anisotropy.x", "anisotropy.y", "metalness",
        "transmission", "specular", "specular_tint", "sheen", "sheen_tint",
        "slope.x", "slope.y", "slope.xx", "slope.yy", "slope.xy",
    )  # fmt: skip

    def __init__(self, faces: tuple[FaceMaps, ...], resolution: int) -> None:
        rows, columns = (
            min(resolution, 1 << (max(face.levels[0].shape[axis] for face in faces) - 1).bit_length())
            for axis in (0, 1)
        )
        self.resolution = (columns, rows)
        self.sigma = np.asarray([1 / columns / SIZE_OF_SIGMA, 1 / rows / SIZE_OF_SIGMA], np.float32)
        self._inputs = np.stack([_inputs(face, (columns, rows), bool(k)) for k, face in enumerate(faces)])

    @property
    def slopes(self) -> _Floats:
        """Of the flat surface and of the normal map; see `Texels.slopes`."""
        mapped = self._inputs[..., -5:-3]
        return np.stack([np.zeros_like(mapped), mapped], axis=1)

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Filtered inputs [height, width, K] of a level; see `Texels.encoder_inputs`."""
        inputs = self._inputs[face]
        for _ in range(level):
            for axis in (0, 1):
                if inputs.shape[axis] > 1:
                    inputs = averaged(inputs, inputs.shape[axis] // 2, axis)
        return np.ascontiguousarray(inputs, np.float32)


def _inputs(face: FaceMaps, resolution: tuple[int, int], is_back: bool) -> _Floats:
    """Inputs of the finest texels [height, width, K], about −1 to 1."""
    values = face.levels[0]
    normal = values[..., 4:7]
    slope = np.clip(-normal[..., :2] / np.maximum(normal[..., 2:], 0.1), -_STEEPEST, _STEEPEST)
    slope, twice = np.asarray(slope, np.float32), values[..., 8:10]
    if is_back:
        signs = np.array([1, -1], np.float32)
        slope, twice = -slope * signs, twice * signs
    x, y = slope[..., :1], slope[..., 1:]
    parts = [2 * values[..., :4] - 1, 2 * values[..., 7:8] - 1, twice, 2 * values[..., 10:] - 1]
    found = np.concatenate([*parts, x, y, x * x, y * y, x * y], axis=-1).astype(np.float32)
    if is_back:
        found = found[:, ::-1]
    for axis, count in enumerate(resolution[::-1]):
        # Coarser maps are repeated until they can be averaged.
        if count > found.shape[axis]:
            found = np.repeat(found, -(-count // found.shape[axis]), axis)
        found = averaged(found, count, axis)
    return found
