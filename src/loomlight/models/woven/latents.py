"""Latents as decoders fetch them, and the fetch in numpy. Lengths are in threads."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from loomlight.models.woven.encoding import EncodedFabric
from loomlight.models.woven.pyramid import FINEST, Level
from loomlight.models.woven.weights import Weights


def fetched_channels(weights: Weights) -> int:
    """Numbers that are fetched of one texel."""
    table = weights.table
    return table.hidden if table.fusion else table.latent_size


def fetched_latents(weights: Weights, encoded: EncodedFabric) -> NDArray[np.float32]:
    """Latents of both faces [2 texels, channels], multiplied by the first layer where there is fusion.

    That layer is linear, so multiplying before the interpolation is as good as after it.
    """
    latents = encoded.both
    if weights.table.fusion:
        first = weights.tensor("decoder.fusion.0.weight")[:, : weights.table.latent_size]
        latents = latents @ first.T + weights.tensor("decoder.fusion.0.bias")
    return latents


class LatentRows:
    """Latents of both faces in rows, with a margin around each level so that no tap wraps around."""

    def __init__(self, weights: Weights, encoded: EncodedFabric) -> None:
        self._ends, self._picks = np.float32(encoded.ends), np.float32(encoded.picks)
        texels = len(encoded.faces[0])
        faces = fetched_latents(weights, encoded).reshape(2, texels, -1)
        self._single = texels == 1
        levels = encoded.levels
        if not self._single:
            faces = np.concatenate([_with_margin(faces, level) for level in levels], axis=1)
        self._width = np.float32(faces.shape[1])
        self._rows = np.ascontiguousarray(faces.reshape(-1, faces.shape[2]))
        self._last = len(levels) - 1
        strides = np.array([level.columns + 2 for level in levels])
        sizes = strides * [level.rows + 2 for level in levels]
        # The texel above and right of the margin's corner is the level's first. Whole numbers below 2^24 are
        # exact in single precision.
        self._first = (np.cumsum(sizes) - sizes + strides + 1).astype(np.float32)
        self._stride = strides.astype(np.float32)
        self._per_thread = np.array([level.per_thread for level in levels], np.float32)
        # A texel of a running mean stands around its upper corner, other texels around their middle.
        self._corner = np.array([1.0 if level.window > 1 else 0.5 for level in levels], np.float32)

    def at(
        self,
        x: NDArray[np.float32],
        y: NDArray[np.float32],
        size: NDArray[np.float32],
        back: NDArray[np.bool_],
    ) -> NDArray[np.float32]:
        """Interpolated rows [n, channels] of footprints: centres and sides [n], and the face that is seen."""
        if self._single:
            return self._rows[back.astype(np.intp)]
        texels, shares = self._taps(x, y, size, back)
        # A sparse product reads each row once and keeps no copy.
        starts = np.arange(0, 8 * len(x) + 1, 8, dtype=np.int32)
        taps = csr_array((shares.ravel(), texels.ravel(), starts), shape=(len(x), len(self._rows)))
        return taps @ self._rows

    def _taps(
        self,
        x: NDArray[np.float32],
        y: NDArray[np.float32],
        size: NDArray[np.float32],
        back: NDArray[np.bool_],
    ) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
        """Rows and weights [n, 8]; see `pyramid.taps`."""
        x, y = _wrapped(x, self._ends), _wrapped(y, self._picks)
        place = np.clip(np.log2(np.fmax(size, 1e-6)) + FINEST, 0, self._last)
        lower = np.minimum(place.astype(np.intp), self._last - 1)
        blend = place - lower.astype(np.float32)
        texels = np.empty((len(x), 8), np.int32)
        shares = np.empty((len(x), 8), np.float32)
        face = back * self._width
        for side, share in enumerate((1 - blend, blend)):
            level = lower + side
            per_thread, corner = self._per_thread.take(level), self._corner.take(level)
            u, v = x * per_thread - corner, y * per_thread - corner
            column, row = np.floor(u), np.floor(v)
            right, up = u - column, v - row
            stride = self._stride.take(level)
            start = row * stride + column + self._first.take(level) + face
            for tall, along in enumerate((share - share * up, share * up)):
                texel = (start + stride if tall else start).astype(np.int32)
                tap = 4 * side + 2 * tall
                texels[:, tap] = texel
                texels[:, tap + 1] = texel + 1
                across = along * right
                shares[:, tap] = along - across
                shares[:, tap + 1] = across
        return texels, shares


def _wrapped(value: NDArray[np.float32], period: np.float32) -> NDArray[np.float32]:
    """Near the origin, where float32 is finest, and 0 to the period, whatever comes in: rows must exist."""
    return np.fmin(np.fmax(value - period * np.floor(value / period), 0), period)


def _with_margin(faces: NDArray[np.float32], level: Level) -> NDArray[np.float32]:
    """A level of both faces with the texels around it, a period away [2, texels, channels]."""
    count = level.rows * level.columns
    maps = faces[:, level.first : level.first + count].reshape(2, level.rows, level.columns, -1)
    return np.pad(maps, ((0, 0), (1, 1), (1, 1), (0, 0)), mode="wrap").reshape(2, -1, maps.shape[3])
