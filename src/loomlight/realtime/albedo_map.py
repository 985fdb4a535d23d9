"""Albedo maps for shaders: a pyramid of means of a texture, packed into words."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image

MAX_SIDE = 2048  # texels
ROOT_STEPS = 1023  # ten bits


def map_words(texels: NDArray[np.floating]) -> tuple[NDArray[np.uint32], int]:
    """Words of all levels, the finest first, and their number.

    A word holds square roots of red, green and blue in ten bits each. v runs down the picture.

    Args:
        texels: linear RGB [rows, columns, 3], 0 to 1, the top row first.
    """
    side = min(MAX_SIDE, 1 << math.ceil(math.log2(max(texels.shape[:2]))))
    level = _resized(np.clip(np.asarray(texels, np.float32), 0, 1), side)
    words = [_packed(level)]
    while len(level) > 1:
        half = len(level) // 2
        level = level.reshape(half, 2, half, 2, 3).mean(axis=(1, 3))
        words.append(_packed(level))
    return np.concatenate(words), len(words)


def _resized(texels: NDArray[np.float32], side: int) -> NDArray[np.float32]:
    """A square of `side` texels."""
    if texels.shape[:2] == (side, side):
        return texels
    planes = [
        Image.fromarray(np.ascontiguousarray(texels[..., channel])).resize(
            (side, side), Image.Resampling.BOX if side <= min(texels.shape[:2]) else Image.Resampling.BILINEAR
        )
        for channel in range(3)
    ]
    return np.stack([np.asarray(plane, np.float32) for plane in planes], axis=-1)


def _packed(level: NDArray[np.float32]) -> NDArray[np.uint32]:
    roots = np.rint(np.sqrt(level) * ROOT_STEPS).astype(np.uint32).reshape(-1, 3)
    return roots[:, 0] | (roots[:, 1] << np.uint32(10)) | (roots[:, 2] << np.uint32(20))
