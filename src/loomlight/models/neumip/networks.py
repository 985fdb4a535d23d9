"""Both networks and both textures as numbers, and their evaluation on any backend.

    offset    9 → 25 → 25 → 25 → 1   texel of the offset texture, view → ray depth (eq. 5)
    decoder  11 → 25 → 25 → 25 → 3   texel of the pyramid, light, view → π f·cos, by ReLU (section 3.2)

Sources that light passes through have up to two more, which the paper does not describe (its section 8
proposes the second):

    transmission  11 → 25 → 25 → 25 → 3   the same of lights on the other side
    opacity        9 → 16 → 16 → 1        texel of the pyramid, view → share that passes straight, by sigmoid

A third one, which the paper's section 7 asks for, describes the directions that are drawn:

    sampler  10 → 32 → 32 → 19 or 9   texel of the pyramid, view (x, y, z) → lobes (`two_sided_lobes.py`)

Other directions are x and y of unit vectors. On CPUs a fused SIMD kernel evaluates the networks; on GPUs, for
derivatives, and in symbolic calls Dr.Jit's cooperative vectors do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, UInt, Vec3
from loomlight.core.backend import array_types, clip, maximum, upload
from loomlight.models.mip_pyramid import (
    DrjitFunctions,
    PyramidShape,
    Taps,
    bilinear_taps,
    fetch_texels,
    trilinear_taps,
    wrapped,
)
from loomlight.models.relu_network import Layers, ReluNetwork
from loomlight.scattering.lobe_mixture import OPAQUE_OUTPUTS, OUTPUTS, TwoSidedLobes

# Channels of a texel of each of the two textures (Table 4).
CHANNELS = 7
# Width of the hidden layers of offset and decoder.
HIDDEN = 25
OFFSET_WIDTHS = (CHANNELS + 2, HIDDEN, HIDDEN, HIDDEN, 1)
DECODER_WIDTHS = (CHANNELS + 4, HIDDEN, HIDDEN, HIDDEN, 3)
OPACITY_WIDTHS = (CHANNELS + 2, 16, 16, 1)
NETWORKS = {
    "offset": OFFSET_WIDTHS,
    "decoder": DECODER_WIDTHS,
    "transmission": DECODER_WIDTHS,
    "opacity": OPACITY_WIDTHS,
}
SAMPLER_HIDDEN = (32, 32)
# The networks learn π f·cos, which is about an albedo.
EXPOSURE = math.pi
# Texels are stored in rows of eight numbers, so that a row is two loads of four.
_ROW = 8


@dataclass(frozen=True, eq=False)
class Weights:
    """A trained material.

    Attributes:
        shape: of the textures.
        features: texels of the pyramid [faces · shape.texels, 7], a face after another, fine levels first.
        offset_texels: of the offset texture [faces · rows · columns, 7]; None without the offset module.
        layers: weights [outputs, inputs] and biases of "decoder", and of the other `NETWORKS` that there are.
        reflectance: mean albedo of each face [faces, 3].
        open_area: mean share of light that passes straight through, 0 to 1.
        sampler: network of directions that are drawn; None draws as an untrained one would, of zeros.
    """

    shape: PyramidShape
    features: NDArray[np.float32]
    offset_texels: NDArray[np.float32] | None
    layers: dict[str, Layers]
    reflectance: NDArray[np.float32]
    open_area: float = 0.0
    sampler: Layers | None = None

    @property
    def count(self) -> int:
        """Weights of the networks, as Table 4 counts them."""
        return sum(w.size + b.size for layers in self.layers.values() for w, b in layers)

    @property
    def transmits(self) -> bool:
        """Whether lights on the other side are seen."""
        return "transmission" in self.layers

    @property
    def has_holes(self) -> bool:
        """Whether light passes straight through."""
        return "opacity" in self.layers


def sampler_widths(transmits: bool) -> tuple[int, ...]:
    """Widths of the sampler's layers, inputs first."""
    return CHANNELS + 3, *SAMPLER_HIDDEN, OUTPUTS if transmits else OPAQUE_OUTPUTS


class DeviceWeights:
    """A trained material on one backend."""

    def __init__(self, weights: Weights, float_type: FloatType) -> None:
        self._shape, self._types = weights.shape, array_types(float_type)
        self._functions = DrjitFunctions(self._types)
        self._features = upload(float_type, _padded(weights.features))
        self._offset_texels = None
        if weights.offset_texels is not None:
            self._offset_texels = upload(float_type, _padded(weights.offset_texels))
        self._sampler = None if weights.sampler is None else ReluNetwork(weights.sampler, float_type)
        self._sampler_outputs = sampler_widths(weights.transmits)[-1]
        self._networks = {name: ReluNetwork(layers, float_type) for name, layers in weights.layers.items()}

    def depth(self, u: Float, v: Float, view: Sequence[Float], face: UInt) -> Float:
        """The ray depth r of eq. 5, in units of `PyramidShape.length_mm`.

        Args:
            u, v: in repeats.
            view: x and y of the view in the frame of the face that is seen.
            face: index of its textures.
        """
        shape = self._shape
        start = self._types.Int32(face) * (shape.columns * shape.rows)
        u, v = u - dr.floor(u), v - dr.floor(v)
        taps = bilinear_taps(u, v, shape.columns, shape.rows, start, self._functions)
        (depth,) = self._networks["offset"]([*self._texel(self._offset_texels, taps), *view])
        return depth

    def latent(self, u: Float, v: Float, level: Float, face: UInt) -> list[Float]:
        """The interpolated texel of the pyramid, `CHANNELS` numbers.

        Args:
            level: log2 of the footprint's size in texels of level 0.
        """
        start = self._types.Int32(face) * self._shape.texels
        taps = trilinear_taps(self._shape, *wrapped(u, v), level, start, self._functions)
        return self._texel(self._features, taps)

    def value(
        self, latent: Sequence[Float], light: Sequence[Float], view: Sequence[Float], network: str = "decoder"
    ) -> list[Float]:
        """f·cos, three channels, 1/sr, of x and y of light and view in the frame of the face seen.

        Args:
            network: "decoder", or "transmission" for lights on the other side.
        """
        outputs = self._networks[network]([*latent, *light, *view])
        return [maximum(value, 0) * (1 / EXPOSURE) for value in outputs]

    def lobes(self, latent: Sequence[Float], view: Vec3) -> TwoSidedLobes:
        """The lobes of the sampler network, for a view in the frame of the face seen."""
        if self._sampler is None:
            return TwoSidedLobes.of([0 * view.z] * self._sampler_outputs)
        return TwoSidedLobes.of(self._sampler([*latent, *view]))

    def _texel(self, table: Float, taps: Taps) -> list[Float]:
        return fetch_texels(table, taps, self._types)[:CHANNELS]

    def straight_through(self, latent: Sequence[Float], view: Sequence[Float]) -> Float:
        """Share of light that passes straight through, 0 to 1."""
        (value,) = self._networks["opacity"]([*latent, *view])
        return dr.rcp(1 + dr.exp(-clip(value, -30, 30)))


def quantised(texels: NDArray[np.float32]) -> tuple[NDArray[np.int8], NDArray[np.float32]]:
    """Texels as bytes, and the power of two for each channel [7] that they are multiples of."""
    mantissa, exponent = np.frexp(np.maximum(np.abs(texels).max(axis=0), 1e-20) / np.float32(127))
    steps = np.ldexp(np.float32(1), exponent - (mantissa == 0.5))
    return np.rint(texels / steps).astype(np.int8), steps


def _padded(texels: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.pad(texels, ((0, 0), (0, _ROW - CHANNELS)))
