"""Latent textures and networks as numbers, and their evaluation on any backend.

    frames   8 → 12                     latent → normals and tangents of two shading frames, without bias
    decoder  24 → 2×16, 2×32, 3×64 → 3  both directions in both frames, features of the half vector, latent →
                                        log f·cos + 3
    sampler  11 → 32 → 32 → 32 → 9      view, latent → lobes (`scattering/lobe_mixture.py`)
    albedo   11 → 16 → 3                view, latent → log of the share of light that is scattered, + 1

The order of inputs and outputs is that of listings 2 and 3 of the supplemental of zeltner2024, whose decoder
has 20 inputs: no features. Without learned frames both directions are in the frame of the face, 6 inputs in
place of 12, and there are 3 features in place of 4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, FloatType, Int, UInt, Vec3
from loomlight.core.backend import DRJIT, array_types, minimum, upload
from loomlight.models.mip_pyramid import (
    DrjitFunctions,
    PyramidShape,
    fetch_texels,
    level_taps,
    trilinear_taps,
    wrapped,
)
from loomlight.models.relu_network import Layers, ReluNetwork
from loomlight.scattering.lobe_mixture import LOBE_OUTPUTS, LobeMixture, lobe_mixture

# Channels of a texel.
CHANNELS = 8
FRAMES = 2
SAMPLER_WIDTHS = (3 + CHANNELS, 32, 32, 32, LOBE_OUTPUTS)
ALBEDO_WIDTHS = (3 + CHANNELS, 16, 3)
# Offsets of the exponential outputs: of networks that begin near 0.
VALUE_OFFSET, ALBEDO_OFFSET = 3.0, 1.0
# Bound of an exponent: values stay finite, and no training reaches it.
MAX_EXPONENT = 12.0
# Added to tan² of the half vector's angle: a lobe of a roughness of 0.017 is the sharpest that the feature
# resolves. Below, the least cosines of half vectors and lights.
SLOPE_FLOOR, MIN_HALF, MIN_LIGHT = 3e-4, 0.02, 0.01


def decoder_widths(hidden: tuple[int, ...], with_frames: bool, with_features: bool) -> tuple[int, ...]:
    """Widths of the decoder's layers, inputs first."""
    frames = FRAMES if with_frames else 1
    return (CHANNELS + 6 * frames + (frames + 2 if with_features else 0), *hidden, 3)


def half_vector_features(
    seen: Sequence[tuple[Sequence[Any], Sequence[Any]]],
    view: Sequence[Any],
    light: Sequence[Any],
    functions: Any,
) -> list[Any]:
    """What highlights, Fresnel's rise and the horizon depend on: small networks hardly find it by products.

    ¼ log(tan² θ_h + 3e-4) for each frame, (1 - cos θ_d)^5 and log cos θ_light (θ_h, θ_d: Rusinkiewicz 1998).
    In frames whose tangent is not at right angles to the normal, θ_h is 0 where the half vector is at right
    angles to tangent and bitangent.

    Args:
        seen: coordinates of view and light in each frame.
        view, light: coordinates in the frame of the face that is seen.
        functions: of arrays, such as `DRJIT`.
    """
    maximum, log = functions.maximum, functions.log
    features = []
    for pair in seen:
        x, y, z = (a + b for a, b in zip(*pair, strict=True))
        across = maximum(z, MIN_HALF)
        features.append(0.25 * log((x * x + y * y) / (across * across) + SLOPE_FLOOR))
    x, y, z = (a + b for a, b in zip(view, light, strict=True))
    rest = 1 - functions.sqrt(maximum(0.25 * (x * x + y * y + z * z), 1e-8))
    fourth = rest * rest * rest * rest
    return [*features, rest * fourth, log(maximum(light[2], MIN_LIGHT))]


@dataclass(frozen=True, eq=False)
class Weights:
    """A trained material.

    Attributes:
        shape: of the textures.
        latents: texels of the pyramid [faces · shape.texels, 8], a face after another, fine levels first.
        frames: weights [12, 8] of normal and tangent of each frame; None without learned frames.
        layers: weights [outputs, inputs] and biases of "decoder", "sampler" and "albedo".
        reflectance: mean albedo of each face [faces, 3].
    """

    shape: PyramidShape
    latents: NDArray[np.float32]
    frames: NDArray[np.float32] | None
    layers: dict[str, Layers]
    reflectance: NDArray[np.float32]

    @property
    def hidden(self) -> tuple[int, ...]:
        """Widths of the decoder's hidden layers."""
        return tuple(len(bias) for _, bias in self.layers["decoder"][:-1])

    @property
    def with_features(self) -> bool:
        """Whether the decoder is given `half_vector_features`."""
        inputs: int = self.layers["decoder"][0][0].shape[1]
        return inputs > decoder_widths((), self.frames is not None, with_features=False)[0]

    def rounded(self, precision: str) -> Weights:
        """The same numbers rounded to "float32" or "float16", in float32.

        Half precision holds them with a relative error of 2^-11, up to 65504.
        """
        kind = np.dtype(precision)

        def rounded(values: NDArray[np.float32]) -> NDArray[np.float32]:
            return values.astype(kind).astype(np.float32)

        layers = {
            name: [(rounded(weight), rounded(bias)) for weight, bias in parts]
            for name, parts in self.layers.items()
        }
        frames = None if self.frames is None else rounded(self.frames)
        return replace(
            self,
            latents=rounded(self.latents),
            frames=frames,
            layers=layers,
            reflectance=rounded(self.reflectance),
        )


# Tangent, bitangent and normal, which need not be orthogonal.
Frame = tuple[Vec3, Vec3, Vec3]


class DeviceWeights:
    """A trained material on one backend."""

    def __init__(self, weights: Weights, float_type: FloatType) -> None:
        self._shape, self._types = weights.shape, array_types(float_type)
        self._functions = DrjitFunctions(self._types)
        self._latents = upload(float_type, weights.latents)
        self._frames = None if weights.frames is None else weights.frames.tolist()
        self._with_features = weights.with_features
        self._networks = {name: ReluNetwork(layers, float_type) for name, layers in weights.layers.items()}

    def latent_of_level(self, u: Float, v: Float, level: Int, face: UInt) -> list[Float]:
        """The latent of one level, `CHANNELS` numbers, interpolated between texels.

        Args:
            u, v: in repeats.
            level: a whole number.
            face: index of its textures.
        """
        taps = level_taps(self._shape, *wrapped(u, v), *self._place(level, face))
        return fetch_texels(self._latents, taps, self._types)

    def latent(self, u: Float, v: Float, level: Float, face: UInt) -> list[Float]:
        """The latent between two levels; see `latent_of_level`."""
        taps = trilinear_taps(self._shape, *wrapped(u, v), *self._place(level, face))
        return fetch_texels(self._latents, taps, self._types)

    def frames(self, latent: Sequence[Float]) -> list[Frame]:
        """The learned frames (listing 2); empty without them."""
        if self._frames is None:
            return []
        sums = [_dot(row, latent) for row in self._frames]
        return [_frame(self._types.Vector3, sums[first : first + 6]) for first in range(0, 6 * FRAMES, 6)]

    def value(self, latent: Sequence[Float], frames: list[Frame], light: Vec3, view: Vec3) -> Color3:
        """f·cos, 1/sr, of directions in the frame of the face that is seen."""
        pair = ([*view], [*light])
        seen = [
            ([dr.dot(view, axis) for axis in frame], [dr.dot(light, axis) for axis in frame])
            for frame in frames
        ] or [pair]
        inputs = [number for both in seen for direction in both for number in direction]
        if self._with_features:
            inputs += half_vector_features(seen, *pair, DRJIT)
        outputs = self._networks["decoder"]([*inputs, *latent])
        return self._types.Color3(*(_exponential(output - VALUE_OFFSET) for output in outputs))

    def mixture(self, latent: Sequence[Float], view: Vec3) -> LobeMixture:
        """The density that lights are drawn with (listing 3)."""
        return lobe_mixture(self._networks["sampler"]([*view, *latent]))

    def albedo(self, latent: Sequence[Float], view: Vec3) -> Color3:
        """The share of light that is scattered towards the view's side."""
        outputs = self._networks["albedo"]([*view, *latent])
        return self._types.Color3(*(_exponential(output - ALBEDO_OFFSET) for output in outputs))

    def _place(self, level: Any, face: UInt) -> tuple[Any, Int, DrjitFunctions]:
        return level, self._types.Int32(face) * self._shape.texels, self._functions


def _dot(row: list[float], latent: Sequence[Float]) -> Float:
    total = row[0] * latent[0]
    for weight, value in zip(row[1:], latent[1:], strict=True):
        total = dr.fma(value, weight, total)
    return total


def _frame(vector: Any, sums: list[Float]) -> Frame:
    normal = dr.normalize(vector(sums[0], sums[1], sums[2] + 1))
    tangent = dr.normalize(vector(sums[3] + 1, sums[4], sums[5]))
    return tangent, dr.cross(normal, tangent), normal


def _exponential(exponent: Float) -> Float:
    return dr.exp(minimum(exponent, MAX_EXPONENT))
