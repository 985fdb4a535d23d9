"""The surface of a fabric's cloth from straight above, as pictures show it: for maps and textures.

Threads wander and are thick and thin, plies and fibres turn normals, hairs lie on top, and colours vary from
thread to thread. In pictures none of that ever repeats, while textures have to tile: over a tile of whole
repeats threads are numbered anew, and near its left and lower edge what varies along threads fades into what
would follow beyond the right and the upper one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask
from loomlight.core.backend import array_types, upload
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance
from loomlight.scattering.detail import turned_frame
from loomlight.scattering.hairs import under_hair
from loomlight.scattering.interreflection import Interreflection
from loomlight.scattering.openness import openness_of
from loomlight.scattering.point import Albedos, YarnScattering
from loomlight.scattering.variation import UNEVEN_CELL, Unevenness
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout

Numbers = NDArray[np.float32]
# Spacings over which the ends of a tile fade into each other: of where threads run, whose noise has cells of
# this length, and of fibres and slubs; at most so much of the tile.
_PLACE_BAND, _DETAIL_BAND, _MAX_DETAIL_BAND = UNEVEN_CELL, 1.0, 0.25
# Normals of a map point away from the cloth, while plies and fibres may turn them down at steep flanks.
_MIN_NORMAL_Z = 0.02


@dataclass
class ClothPoints:
    """Points of the cloth, in the frame of the face that is seen.

    Attributes:
        height: of the yarn's smooth surface, millimetres; 0 in holes.
        normal, tangent: unit vectors [n, 3], of plies, fibres and hairs.
        warp: the family of the yarn that shows, bool.
        hole: whether neither family is there, bool.
        threads: index of the end and of the pick that cross here, in the repeat [2, n].
        warp_share: of the warp in what shows, with the hair on top, 0 to 1.
        gain: what diffuse albedos are multiplied with here, mean 1.
        openness: share of the sky that the yarn sees, 0 to 1; 1 in holes.
    """

    height: Numbers
    normal: Numbers
    tangent: Numbers
    warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    threads: NDArray[np.int32]
    warp_share: Numbers
    gain: Numbers
    openness: Numbers


class ClothSurface:
    """The cloth of a fabric.

    Args:
        tile: repeats, across and up, after which the cloth is to be the same again; None is cloth as
            pictures have it, whose threads all differ.
    """

    def __init__(self, fabric: Fabric, float_type: FloatType, tile: tuple[int, int] | None = None) -> None:
        self._types = array_types(float_type)
        layout, appearance = fabric.layout(), fabric.appearance()
        spacings = (float(layout.warp.spacing.mean()), float(layout.weft.spacing.mean()))
        self._unevenness = Unevenness(appearance, spacings)
        self._scattering = _TiledScattering(YarnGeometry(layout), appearance, tile)
        self._between = _interreflection(layout, appearance, float_type)
        varies = self._scattering.has_detail or self._scattering.varies
        self._tile = np.multiply(layout.size, tile) if tile is not None and varies else None
        self._spacings = np.array(spacings)

    def at(self, x: NDArray[Any], y: NDArray[Any], size: float, back: bool = False) -> ClothPoints:
        """The cloth at places [n] in millimetres, as footprints whose side is `size` millimetres show it."""
        x, y, shift = self._within_tile(x, y)
        found = self._sampled(x + shift[0], y + shift[1], size, back)
        if self._tile is None:
            return found
        detail_band = np.minimum(_DETAIL_BAND * self._spacings, _MAX_DETAIL_BAND * self._tile)
        in_bands = np.flatnonzero((x < detail_band[0]) | (y < detail_band[1]))
        if not in_bands.size:
            return found
        shift = shift[:, in_bands]

        def varied(x: NDArray[Any], y: NDArray[Any]) -> NDArray[Any]:
            there = self._sampled(x + shift[0], y + shift[1], size, back)
            # A fibre has no front and no rear.
            turned = (there.tangent * found.tangent[in_bands]).sum(axis=1, keepdims=True) < 0
            tangent = np.where(turned, -there.tangent, there.tangent)
            return np.concatenate([there.normal.T, tangent.T, [there.gain, there.warp_share]])

        faded = _faded(varied, x[in_bands], y[in_bands], self._tile, detail_band, keep_deviation=False)
        normal = _unit(faded[:3].T)
        tangent = faded[3:6].T - (faded[3:6].T * normal).sum(axis=1, keepdims=True) * normal
        found.normal[in_bands], found.tangent[in_bands] = normal, _unit(tangent)
        found.gain[in_bands], found.warp_share[in_bands] = faded[6:]
        return found

    def place(self, x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
        """Where in the draft the cloth at places [n] is [2, n], both in millimetres."""
        x, y, shift = self._within_tile(x, y)
        return np.stack([x, y]) + shift

    def _within_tile(
        self, x: NDArray[Any], y: NDArray[Any]
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[np.float64]]:
        """Places in the tile, and by how much its threads are displaced there [2, n], millimetres."""
        if self._tile is None:
            return x, y, self._displacement(x, y)
        width, height = self._tile
        x, y = x - width * np.floor(x / width), y - height * np.floor(y / height)
        band = np.minimum(_PLACE_BAND * self._spacings, self._tile)
        return x, y, _faded(self._displacement, x, y, self._tile, band)

    def _displacement(self, x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
        """By how much the threads at places are displaced [2, n], millimetres."""
        place = self._types.Vector2(*(upload(self._types.Float, part.astype(np.float32)) for part in (x, y)))
        moved = self._unevenness.place(place)
        # Of even threads, Dr.Jit knows that the difference is one 0.
        return np.stack([np.broadcast_to(part.numpy(), x.shape) for part in moved - place]).astype(np.float64)

    def _sampled(self, x: NDArray[Any], y: NDArray[Any], size: float, back: bool) -> ClothPoints:
        types, scattering = self._types, self._scattering
        x, y = (upload(types.Float, part.astype(np.float32)) for part in (x, y))
        behind, side = dr.full(types.Bool, back, dr.width(x)), dr.opaque(types.Float, size)
        point = scattering.surface.surface(x, y, behind)
        normal, tangent = point.normal, point.tangent
        warp_share = dr.select(point.is_warp, types.Float(1), 0)
        hair = None
        if scattering.has_detail:
            thread = scattering.thread_number(point)
            frame = turned_frame(scattering.detail(types), point, behind, thread, side)
            hairs = scattering.hairs(point, behind, side)
            if hairs is not None:
                hair = hairs.seen(types.Vector3(0, 0, 1))
                frame = under_hair(frame, hair)
                warp_share = dr.lerp(warp_share, dr.select(hair.is_warp, types.Float(1), 0), hair.cover)
            normal, tangent = frame.normal, frame.tangent
        gain = dr.full(types.Float, 1, dr.width(x))
        if scattering.has_detail or scattering.varies:
            # Reflected and transmitted light vary alike.
            warp, weft = scattering.parameters(types)
            pairs = (
                (warp.albedo(number, point.warp_thread), weft.albedo(number, point.weft_thread))
                for number in range(len(ALBEDO_NAMES))
            )
            base = Albedos(*(dr.select(point.is_warp, *pair) for pair in pairs))
            varied = scattering.varied(point, base, behind, side, hair)
            before, after = (dr.sum(of.diffuse_reflect + of.diffuse_transmit) for of in (base, varied))
            gain = dr.select(before > 0, after / before, 1)
        blocked = self._between.blocked_at(point.is_warp, behind, point.normal.z, point.height)
        openness = dr.select(point.hole, 1, 1 - blocked.by_warp - blocked.by_weft)
        level = dr.select(point.hole, 0, point.height)
        ends, picks = types.UInt32(point.warp_thread), types.UInt32(point.weft_thread)
        parts = (level, normal, tangent, point.is_warp, point.hole, ends, picks, warp_share, gain, openness)
        dr.eval(parts)
        arrays = [part.numpy() for part in parts]
        level, normal, tangent, is_warp, hole, ends, picks, warp_share, gain, openness = arrays
        normal, tangent = normal.T.astype(np.float32), tangent.T.astype(np.float32)
        normal[:, 2] = np.maximum(normal[:, 2], _MIN_NORMAL_Z)
        normal = _unit(normal)
        tangent = _unit(tangent - (tangent * normal).sum(axis=1, keepdims=True) * normal)
        return ClothPoints(
            height=level.astype(np.float32),
            normal=normal,
            tangent=tangent,
            warp=is_warp.astype(bool),
            hole=hole.astype(bool),
            threads=np.stack([ends, picks]).astype(np.int32),
            warp_share=warp_share.astype(np.float32),
            gain=gain.astype(np.float32),
            openness=openness.astype(np.float32),
        )


class _TiledScattering(YarnScattering):
    """Yarns whose threads are the same again after some repeats."""

    def __init__(self, surface: YarnGeometry, appearance: Appearance, tile: tuple[int, int] | None) -> None:
        super().__init__(surface, appearance)
        self._repeats = tile

    def repeat_number(self, repeat: Float, is_warp: Mask) -> Float:
        """Number of the repeat within the tile."""
        if self._repeats is None:
            return repeat
        types = array_types(repeat)
        count = dr.select(is_warp, *(dr.opaque(types.Float, float(number)) for number in self._repeats))
        return repeat - count * dr.floor(repeat / count)


def _interreflection(layout: ClothLayout, appearance: Appearance, float_type: FloatType) -> Interreflection:
    """Light between yarns, for the share of the sky that they see; of fabrics that go without it too."""
    if appearance.openness is None:
        roughness = (appearance.warp.roughness, appearance.weft.roughness)
        openness = openness_of(layout, appearance.diffuse_blend, roughness, appearance.optical_depth)
        appearance = replace(appearance, openness=openness)
    return Interreflection(appearance, array_types(float_type))


def _faded(
    values: Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]],
    x: NDArray[Any],
    y: NDArray[Any],
    tile: NDArray[np.float64],
    band: NDArray[np.float64],
    keep_deviation: bool = True,
) -> NDArray[Any]:
    """Values [k, n] at places within a tile from (0, 0) on, near whose lower edges those beyond fade in.

    Args:
        band: its width at the left and at the lower edge, millimetres.
        keep_deviation: of values of mean 0, whose mean varies less than they do.
    """
    weights = []
    for place, width in zip((x, y), band, strict=True):
        share = np.clip(place / width, 0, 1)
        here = share * share * (3 - 2 * share)
        pair = np.stack([here, 1 - here])
        weights.append(pair / np.linalg.norm(pair, axis=0) if keep_deviation else pair)
    total: NDArray[Any] | float = 0.0
    for i in (0, 1):
        for j in (0, 1):
            total = total + weights[0][i] * weights[1][j] * values(x + i * tile[0], y + j * tile[1])
    return np.asarray(total)


def _unit(vectors: NDArray[Any]) -> NDArray[Any]:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-12)
