"""Neural appearance as a multi-scale model: values, directions and albedos of one trained source.

The back of a fabric has textures of its own; other sources look alike from both sides. Light on the other
side than the view gives nothing, and holes are black: the published model transmits no light.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Self, final

import drjit as dr
import numpy as np

from loomlight.assets.loom_file import LoomFile
from loomlight.assets.sources import Source
from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum
from loomlight.core.errors import InputError
from loomlight.models.interface import Report
from loomlight.models.latent.networks import (
    ALBEDO_WIDTHS,
    CHANNELS,
    FRAMES,
    SAMPLER_WIDTHS,
    DeviceWeights,
    Frame,
    Weights,
    decoder_widths,
)
from loomlight.models.latent.settings import DECODERS, FEATURES, MIPS, PRECISIONS, LatentOptions
from loomlight.models.random_numbers import hashed, uniform
from loomlight.models.textured_model import (
    TexturedBsdf,
    TexturedModel,
    layers_of_loom,
    run_training,
    shape_of_loom,
    tensors_of_layers,
)
from loomlight.scattering.lobe_mixture import LobeMixture, mixture_density, sample_mixture
from loomlight.scattering.point import DirectionSample, to_face_frame

# Of files: to be raised when the same tensors mean something else.
_FILE_VERSION = 2


@final
class LatentBsdf(TexturedBsdf):
    """The BSDF of footprints for one view: latent, frames and lobes, which no light changes."""

    @property
    def directional_albedo(self) -> Color3:
        """The learned share of light that this view sees, for the termination of paths, 0 to 1."""
        albedo = self._device.albedo(self._latent, self._facing)
        return array_types(self.view.x).Color3(*(clip(channel, 0, 1) for channel in albedo))

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
        }
        layers = {name: layers_of_loom(loom, name, each, kind) for name, each in widths.items()}
        return cls(loom.source, Weights(shape, latents, frames, layers, reflectance), mips, precision)

    def facts(self) -> dict[str, str]:
        """The source, and the size of textures and decoder."""
        return {**super().facts(), "decoder": " → ".join(str(width) for width in self.weights.hidden)}


def _choice(loom: LoomFile, name: str, known: tuple[str, ...]) -> str:
    """A setting that is one of some names.

    Raises:
        InputError: another one.
    """
    value = loom.setting(name, str)
    if value not in known:
        raise InputError(f'{loom.file}: {name} = "{value}" is wrong: it is one of {", ".join(known)}.')
    return value
