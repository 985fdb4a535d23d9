"""Neural appearance as a multi-scale model: values, directions and albedos of one trained source.

The back of a fabric has textures of its own; other sources look alike from both sides. Light on the other
side than the view gives nothing, and holes are black: the published model transmits no light (zeltner2024).
A pyramid of latents is read, of which networks make the answers:

    frames   8 → 12                     latent → normals and tangents of two shading frames, without bias
    decoder  24 → 2×16, 2×32, 3×64 → 3  both directions in both frames, features of the half vector, latent →
                                        log f·cos + 3
    sampler  11 → 32 → 32 → 32 → 9      view, latent → lobes (`scattering/lobe_mixture.py`)
    albedo   11 → 16 → 3                view, latent → log of the share of light that is scattered, + 1
    auxiliary 8 → 16 → 6                latent → log of the mean albedo, + 1; roughness; slopes of the normal

The order of inputs and outputs is that of listings 2 and 3 of the supplemental of zeltner2024, whose decoder
has 20 inputs: no features. Without learned frames both directions are in the frame of the face, 6 inputs in
place of 12, and there are 3 features in place of 4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self, final

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, FloatType, Int, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import DRJIT, array_types, clip, maximum, minimum, upload
from loomlight.core.errors import InputError
from loomlight.core.fleet import Report
from loomlight.models.interface import ShaderTables
from loomlight.models.networks import Layers, ReluNetwork
from loomlight.models.random_numbers import hashed, uniform
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
    fetch_texels,
    level_taps,
    trilinear_taps,
    wrapped,
)
from loomlight.models.texture.settings import DECODERS, FEATURES, MIPS, PRECISIONS, LatentOptions
from loomlight.models.texture.tables import LatentTables, network_layers, pyramid_numbers, texel_numbers
from loomlight.scattering.lobe_mixture import (
    LOBE_OUTPUTS,
    LobeMixture,
    lobe_mixture,
    mixture_density,
    output_roughness,
    sample_mixture,
)
from loomlight.scattering.point import DirectionSample, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile

# Channels of a texel.
CHANNELS = 8
FRAMES = 2
SAMPLER_WIDTHS = (3 + CHANNELS, 32, 32, 32, LOBE_OUTPUTS)
ALBEDO_WIDTHS = (3 + CHANNELS, 16, 3)
# Outputs: albedo [3], roughness, slopes of the normal [2].
AUXILIARY_WIDTHS = (CHANNELS, 16, 6)
# Bound of these slopes.
MAX_AUXILIARY_SLOPE = 4.0
# Offsets of the exponential outputs: of networks that begin near 0.
VALUE_OFFSET, ALBEDO_OFFSET = 3.0, 1.0
# Bound of an exponent: values stay finite, and no training reaches it.
MAX_EXPONENT = 12.0
# Added to tan² of the half vector's angle: a lobe of a roughness of 0.003 is the sharpest that the feature
# resolves, that of a polished glaze. Below, the least cosines of half vectors and lights.
SLOPE_FLOOR, MIN_HALF, MIN_LIGHT = 1e-5, 0.02, 0.01


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

    ¼ log(tan² θ_h + 1e-5) for each frame, (1 - cos θ_d)^5 and log cos θ_light (θ_h, θ_d: Rusinkiewicz 1998).
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
        layers: weights [outputs, inputs] and biases of "decoder", "sampler", "albedo" and "auxiliary".
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


@dataclass(frozen=True)
class Auxiliary:
    """What guides denoisers: of a footprint, free of noise, and alike from everywhere.

    Attributes:
        albedo: mean share of light that is scattered, 0 to 1.
        roughness: α of the specular lobe seen from above, mixed with the 1 of a diffuse surface by its share
            of the light, 1e-4 to 1.
        normal: unit vector, in the middle of what both lobes lie about, on the side of the view.
    """

    albedo: Color3
    roughness: Float
    normal: Vec3


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

    def auxiliary(self, latent: Sequence[Float]) -> Auxiliary:
        """What guides denoisers; the normal is in the frame of the face that is seen."""
        outputs = self._networks["auxiliary"](latent)
        albedo = (clip(_exponential(output - ALBEDO_OFFSET), 0, 1) for output in outputs[:3])
        slopes = (clip(output, -MAX_AUXILIARY_SLOPE, MAX_AUXILIARY_SLOPE) for output in outputs[4:])
        normal = dr.normalize(self._types.Vector3(*(-slope for slope in slopes), 1))
        return Auxiliary(self._types.Color3(*albedo), minimum(output_roughness(outputs[3]), 1), normal)

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


# -------------------------------------------------------------------------------------------------- the model

# Of files: to be raised when the same tensors mean something else.
_FILE_VERSION = 4


@final
class LatentBsdf(TexturedBsdf):
    """The BSDF of footprints for one view: latent, frames and lobes, which no light changes."""

    @property
    def directional_albedo(self) -> Color3:
        """The learned share of light that this view sees, for the termination of paths, 0 to 1."""
        albedo = self._device.albedo(self._latent, self._facing)
        return array_types(self.view.x).Color3(*(clip(channel, 0, 1) for channel in albedo))

    @property
    def auxiliary(self) -> Auxiliary:
        """What guides denoisers; the normal is in the frame of the surface, z < 0 of its back."""
        found = self._device.auxiliary(self._latent)
        return replace(found, normal=to_face_frame(found.normal, self._back))

    @property
    def roughness(self) -> Float:
        """α as the network decodes it, 0 to 1."""
        return self.auxiliary.roughness

    @cached_property
    def _latent(self) -> list[Float]:
        types, shape = self._types, self._model.weights.shape
        u, v, size, faces = self._place()
        level = clip(size, 0, shape.levels - 1)
        if self._model.mips == "trilinear":
            return self._device.latent(u, v, level, faces)
        # Listing 1: the nearer of two levels is the more probable one.
        seed = hashed(self.view, self.footprint, (shape.width_mm, shape.height_mm))
        lower = dr.floor(level)
        upper = uniform(seed, 0) < level - lower
        chosen = types.Int32(lower) + dr.select(upper, types.Int32(1), types.Int32(0))
        return self._device.latent_of_level(u, v, chosen, faces)

    @cached_property
    def _frames(self) -> list[Frame]:
        return self._device.frames(self._latent)

    @cached_property
    def _mixture(self) -> LobeMixture:
        return self._device.mixture(self._latent, self._facing)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos, 1/sr; 0 for lights on the other side."""
        facing = to_face_frame(light, self._back)
        value = self._device.value(self._latent, self._frames, facing, self._facing)
        return dr.select((facing.z > 0) & active, value, 0)

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample`, 1/sr; directions below the surface are drawn too, and carry no light."""
        facing = to_face_frame(light, self._back)
        return mixture_density(self._mixture, [*facing], [*self._facing])

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A direction of the lobes (listing 4)."""
        types = array_types(self.view.x)
        drawn = sample_mixture(self._mixture, [*self._facing], choice, [*u])
        light = to_face_frame(dr.normalize(types.Vector3(*drawn)), self._back)
        pdf = self.pdf(light)
        weight = dr.select(pdf > 0, self.value(light) / maximum(pdf, 1e-30), 0)
        # Never, in every lane.
        return DirectionSample(light, pdf, weight, types.Bool(choice < 0))


@final
class LatentModel(TexturedModel[Weights, DeviceWeights]):
    """zeltner2024: latent textures and networks that are trained for one source; see `TexturedModel`.

    Attributes:
        mips: how levels are chosen, of `MIPS`.
        precision: of the numbers in a file, of `PRECISIONS`; they are computed with in float32.
        multiply_adds: of the decoder, texels and frames included.
    """

    name, bsdf, device = "latent", LatentBsdf, DeviceWeights
    options_class = LatentOptions

    def __init__(
        self, source: Source, weights: Weights, mips: str = MIPS[0], precision: str = PRECISIONS[0]
    ) -> None:
        # A model draws alike before it is stored and afterwards.
        super().__init__(source, weights.rounded(precision))
        self.mips, self.precision = mips, precision
        numbers = [matrix.size for matrix, _ in weights.layers["decoder"]]
        taps = 4 if mips == "stochastic" else 8
        # Sums of the frames, and both directions in them.
        frames = 0 if weights.frames is None else weights.frames.size + FRAMES * (6 + 18)
        self.multiply_adds = sum(numbers) + frames + taps * CHANNELS
        self.bytes_fetched = 4 * taps * CHANNELS

    @classmethod
    def for_source(
        cls, source: Source, options: LatentOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model trained for a source. A training that was stopped goes on.

        Raises:
            InputError: a source of which no queries can be taken.
            MissingDependencyError: PyTorch is missing.
        """
        chosen = options or LatentOptions()
        weights = run_training(cls.name, source, chosen.settings(), chosen, report)
        return cls(source, weights, chosen.mips, chosen.precision)

    def to_loom(self) -> LoomFile:
        """A file of textures and networks."""
        weights, shape = self.weights, self.weights.shape
        tensors = {"latents": weights.latents, "reflectance": weights.reflectance}
        if weights.frames is not None:
            tensors["frames"] = weights.frames
        tensors |= tensors_of_layers(weights.layers)
        decoder = next(name for name, hidden in DECODERS.items() if hidden == weights.hidden)
        settings: dict[str, bool | int | float | str] = {
            "version": _FILE_VERSION,
            "columns": shape.columns,
            "rows": shape.rows,
            "faces": shape.faces,
            "is_apart": shape.is_apart,
            "decoder": decoder,
            "features": FEATURES[0] if weights.with_features else FEATURES[1],
            "mips": self.mips,
            "precision": self.precision,
        }
        stored = {name: values.astype(self.precision) for name, values in tensors.items()}
        return LoomFile(self.name, self.source, stored, settings)

    def shader_tables(self, half: bool = True) -> ShaderTables:
        """Networks and latents.

        Args:
            half: latents in half precision, else as the model keeps them.
        """
        weights, shape = self.weights, self.weights.shape
        # Without learned frames both are the axes: their weights are 0.
        frames = np.zeros((6 * FRAMES, CHANNELS), np.float32) if weights.frames is None else weights.frames
        is_half = half or self.precision == "float16"
        given = pyramid_numbers(shape) | {
            "decoder": network_layers(_of_all_inputs(weights)),
            "hidden": weights.hidden[0],
            "frames": [(frames, None)],
            "sampler": network_layers(weights.layers["sampler"]),
            "albedo": network_layers(weights.layers["albedo"]),
            "auxiliary": network_layers(weights.layers["auxiliary"]),
            "texels": texel_numbers(weights.latents, is_half),
            "texel_elements": 1 if is_half else 2,
            "width": shape.width_mm,
            "height": shape.height_mm,
            "is_trilinear": int(self.mips == "trilinear"),
            "is_apart": int(shape.is_apart),
        }
        return ShaderTables(LatentTables(), given)

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of textures and networks in a file.

        Raises:
            InputError: another model's file, one of another version, or tensors that are missing or of
                another shape.
        """
        loom.require_model(cls.name)
        if loom.settings.get("version") != _FILE_VERSION:
            raise InputError(f"{loom.file}: its networks are of another version of loomlight: bake it again.")
        shape = replace(shape_of_loom(loom), is_apart=loom.setting("is_apart", bool))
        decoder, mips, precision, features = (
            _choice(loom, name, known)
            for name, known in (
                ("decoder", tuple(DECODERS)),
                ("mips", MIPS),
                ("precision", PRECISIONS),
                ("features", FEATURES),
            )
        )
        kind = np.dtype(precision)
        latents = loom.tensor("latents", (shape.faces * shape.texels, CHANNELS), kind)
        reflectance = loom.tensor("reflectance", (shape.faces, 3), kind)
        frames = None
        if "frames" in loom.tensors:
            frames = loom.tensor("frames", (6 * FRAMES, CHANNELS), kind)
        widths = {
            "decoder": decoder_widths(DECODERS[decoder], frames is not None, features == FEATURES[0]),
            "sampler": SAMPLER_WIDTHS,
            "albedo": ALBEDO_WIDTHS,
            "auxiliary": AUXILIARY_WIDTHS,
        }
        layers = {name: layers_of_loom(loom, name, each, kind) for name, each in widths.items()}
        return cls(loom.source, Weights(shape, latents, frames, layers, reflectance), mips, precision)

    def facts(self) -> dict[str, str]:
        """The source, and the size of textures and decoder."""
        return {**super().facts(), "decoder": " → ".join(str(width) for width in self.weights.hidden)}


def _of_all_inputs(weights: Weights) -> Layers:
    """The decoder with zeros for the inputs that it lacks: the second frame, and features."""
    (matrix, bias), *others = weights.layers["decoder"]
    wide = np.zeros((len(matrix), decoder_widths((), with_frames=True, with_features=True)[0]), np.float32)
    frames = 1 if weights.frames is None else FRAMES
    first = 6 * FRAMES
    wide[:, : 6 * frames] = matrix[:, : 6 * frames]
    wide[:, -CHANNELS:] = matrix[:, -CHANNELS:]
    if weights.with_features:
        features = matrix[:, 6 * frames : -CHANNELS]
        wide[:, first : first + frames] = features[:, :frames]
        wide[:, first + FRAMES : first + FRAMES + 2] = features[:, frames:]
    return [(wide, bias), *others]


def _choice(loom: LoomFile, name: str, known: tuple[str, ...]) -> str:
    """A setting that is one of some names.

    Raises:
        InputError: another one.
    """
    value = loom.setting(name, str)
    if value not in known:
        raise InputError(f'{loom.file}: {name} = "{value}" is wrong: it is one of {", ".join(known)}.')
    return value
