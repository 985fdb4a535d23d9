"""NeuMIP as a multi-scale model: colours of one trained source at any place, scale and pair of directions.

The back of a source of two faces has textures of its own; other sources look alike from both sides. Two
textures are read, an offset texture and a pyramid, and two networks answer (kuznetsov2021):

    offset    9 → 25 → 25 → 25 → 1   texel of the offset texture, view → ray depth (eq. 5)
    decoder  11 → 25 → 25 → 25 → 3   texel of the pyramid, light, view → π f·cos, by ReLU (section 3.2)

Sources that light passes through, such as fabrics, have up to two more, which the paper does not describe
(its section 8 proposes the second); the published model transmits no light:

    transmission  11 → 25 → 25 → 25 → 3   the same of lights on the other side
    opacity        9 → 16 → 16 → 1        texel of the pyramid, view → share that passes straight, by sigmoid

A third one, which the paper's section 7 asks for, describes the directions that are drawn:

    sampler  10 → 32 → 32 → 19 or 9   texel of the pyramid, view (x, y, z) → lobes (`lobe_mixture.py`)

Other directions are x and y of unit vectors. On CPUs a fused SIMD kernel evaluates the networks; on GPUs, for
derivatives, and in symbolic calls Dr.Jit's cooperative vectors do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self, final

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, FloatType, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum, upload
from loomlight.core.fleet import Report
from loomlight.core.tables import Layer
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import ShaderTables
from loomlight.models.networks import Layers, LearnedProposal, ReluNetwork
from loomlight.models.texture.model import (
    TexturedBsdf,
    TexturedModel,
    layers_of_loom,
    run_training,
    shape_of_loom,
    tensors_of_layers,
)
from loomlight.models.texture.pyramid import (
    DrjitFunctions,
    PyramidShape,
    Taps,
    bilinear_taps,
    fetch_texels,
    trilinear_taps,
    wrapped,
)
from loomlight.models.texture.settings import NeumipOptions
from loomlight.models.texture.tables import NeumipTables, network_layers, pyramid_numbers, texel_numbers
from loomlight.scattering.lobe_mixture import OPAQUE_OUTPUTS, OUTPUTS, TwoSidedLobes
from loomlight.scattering.point import DirectionSample, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile, Setting

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


# Below this cosine the parallax of eq. 6 grows no further.
MIN_COSINE = 0.6


def shifted(
    shape: PyramidShape, u: Float, v: Float, depth: Float, view_x: Float, view_y: Float, slope: Float
) -> tuple[Float, Float]:
    """Where a query reads the textures of a surface that is no plane: the position of eq. 7, in repeats.

    Args:
        depth: r, in units of `PyramidShape.length_mm`.
        slope: 1 / max(cosine of the view, `MIN_COSINE`).
    """
    across, along = shape.unit
    reach = depth * slope
    return u + reach * view_x * across, v + reach * view_y * along


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


# -------------------------------------------------------------------------------------------------- the model


@final
class NeumipBsdf(TexturedBsdf):
    """The BSDF of footprints for one view: the latent of stage 1, which no light changes (section 6)."""

    @cached_property
    def hole(self) -> Float:
        """Share of the view rays that pass straight through, less what sheen over them takes, 0 to 1."""
        if not self._model.weights.has_holes:
            return super().hole
        return self._device.straight_through(self._latent, [self._facing.x, self._facing.y])

    @cached_property
    def _latent(self) -> list[Float]:
        u, v, level, face = self._place()
        if self._model.weights.offset_texels is not None:
            x, y = self._facing.x, self._facing.y
            depth = self._device.depth(u, v, [x, y], face)
            slope = dr.rcp(maximum(self._facing.z, MIN_COSINE))
            u, v = shifted(self._model.weights.shape, u, v, depth, x, y, slope)
        return self._device.latent(u, v, level, face)

    @cached_property
    def _proposal(self) -> LearnedProposal:
        lobes = self._device.lobes(dr.detach(self._latent), dr.detach(self._facing))
        return LearnedProposal(dr.detach(self.hole), lobes, self._facing)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos, 1/sr; 0 for lights on the other side unless the source transmits."""
        types, facing = array_types(self.view.x), to_face_frame(light, self._back)
        directions = [facing.x, facing.y], [self._facing.x, self._facing.y]
        near = types.Color3(*self._device.value(self._latent, *directions))
        far = types.Color3(0)
        if self._model.weights.transmits:
            far = types.Color3(*self._device.value(self._latent, *directions, "transmission"))
        value = dr.select(facing.z > 0, near, dr.select(facing.z < 0, far, 0))
        return dr.select(active, value, 0)

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample`, 1/sr; by the sampler network."""
        return self._proposal.density(to_face_frame(light, self._back))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A direction of the proposal, or straight on in proportion to the hole."""
        types = array_types(self.view.x)
        through = self.hole
        facing, is_null = self._proposal.draw(choice, u)
        light = dr.select(is_null, -self.view, to_face_frame(facing, self._back))
        pdf = dr.select(is_null, through, self.pdf(light))
        value = dr.select(is_null, types.Color3(through), self.value(light))
        weight = dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0)
        return DirectionSample(light, pdf, weight, is_null)


@final
class NeumipModel(TexturedModel[Weights, DeviceWeights]):
    """kuznetsov2021: textures and networks that are trained for one source; see `TexturedModel`."""

    name, bsdf, device = "neumip", NeumipBsdf, DeviceWeights
    has_holes = True
    options_class = NeumipOptions

    def __init__(self, source: Source, weights: Weights) -> None:
        super().__init__(source, weights)
        numbers = [w.size for layers in weights.layers.values() for w, _ in layers]
        offset_taps = 0 if weights.offset_texels is None else 4
        self.multiply_adds = sum(numbers) + (8 + offset_taps) * CHANNELS
        self.bytes_fetched = 4 * (8 + offset_taps) * CHANNELS

    @classmethod
    def for_source(
        cls, source: Source, options: NeumipOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model trained for a source. A training that was stopped goes on.

        Raises:
            InputError: a source of which no queries can be taken.
            MissingDependencyError: PyTorch is missing.
        """
        chosen = options or NeumipOptions()
        settings = chosen.settings(is_fabric=isinstance(source, Fabric))
        return cls(source, run_training(cls.name, source, settings, chosen, report))

    @property
    def open_area(self) -> float:
        """Mean share of light that passes straight through, 0 to 1."""
        return self.weights.open_area

    def to_loom(self) -> LoomFile:
        """A file of textures and networks."""
        weights = self.weights
        tensors = {**_stored("features", weights.features), "reflectance": weights.reflectance}
        if weights.offset_texels is not None:
            tensors |= _stored("offset_texels", weights.offset_texels)
        sampler = {} if weights.sampler is None else {"sampler": weights.sampler}
        tensors |= tensors_of_layers({**weights.layers, **sampler})
        shape = weights.shape
        settings: dict[str, Setting] = {"columns": shape.columns, "rows": shape.rows, "faces": shape.faces}
        settings |= {"footprint_texels": shape.footprint_texels, "open_area": weights.open_area}
        return LoomFile(self.name, self.source, tensors, settings)

    def shader_tables(self, half: bool = True) -> ShaderTables:
        """Networks and textures, and what shadows know of holes.

        Args:
            half: texels in half precision, else in single precision.
        """
        weights, shape = self.weights, self.weights.shape

        def network(name: str, is_there: bool = True) -> Sequence[Layer] | None:
            return network_layers(weights.layers[name]) if is_there else None

        offset = weights.offset_texels
        unit_x, unit_y = shape.unit
        given = pyramid_numbers(shape) | {
            "decoder": network("decoder"),
            "features": texel_numbers(weights.features, half),
            "has_offset": int(offset is not None),
            "offset": network("offset", offset is not None),
            "offset_texels": None if offset is None else texel_numbers(offset, half),
            "texel_elements": 1 if half else 2,
            "unit_x": unit_x,
            "unit_y": unit_y,
            "transmits": int(weights.transmits),
            "transmission": network("transmission", weights.transmits),
            "has_holes": int(weights.has_holes),
            "opacity": network("opacity", weights.has_holes),
        }
        of_source = {"is_open": int(weights.has_holes), "mean_hole": self.open_area}
        return ShaderTables(NeumipTables(), given, of_source)

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of textures and networks in a file.

        Raises:
            InputError: another model's file, or tensors that are missing or of another shape.
        """
        loom.require_model(cls.name)
        shape = shape_of_loom(loom)
        faces = shape.faces
        features = _texels(loom, "features", faces * shape.texels)
        reflectance = loom.tensor("reflectance", (faces, 3), np.float32)
        offset_texels = None
        further = ("transmission", "opacity")
        names = ["decoder", *(name for name in further if f"{name}.0.weight" in loom.tensors)]
        if "offset_texels" in loom.tensors:
            offset_texels = _texels(loom, "offset_texels", faces * shape.starts[1])
            names.append("offset")
        layers = {name: layers_of_loom(loom, name, NETWORKS[name]) for name in names}
        sampler = None
        if "sampler.0.weight" in loom.tensors:
            sampler = layers_of_loom(loom, "sampler", sampler_widths("transmission" in layers))
        open_area = loom.setting("open_area", float)
        weights = Weights(shape, features, offset_texels, layers, reflectance, open_area, sampler)
        return cls(loom.source, weights)

    def facts(self) -> dict[str, str]:
        """The source, and the size of textures and networks."""
        return {**super().facts(), "weights": f"{self.weights.count}"}


def _stored(name: str, texels: NDArray[np.float32]) -> dict[str, NDArray[Any]]:
    """Texels as a file has them: bytes and their steps, or floats where those would round."""
    codes, steps = quantised(texels)
    return {name: codes, f"{name}_steps": steps} if np.array_equal(codes * steps, texels) else {name: texels}


def _texels(loom: LoomFile, name: str, count: int) -> NDArray[np.float32]:
    if f"{name}_steps" not in loom.tensors:
        return loom.tensor(name, (count, CHANNELS), np.float32)
    steps = loom.tensor(f"{name}_steps", (CHANNELS,), np.float32)
    return steps * loom.tensor(name, (count, CHANNELS), np.int8)
