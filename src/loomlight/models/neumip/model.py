"""NeuMIP as a multi-scale model: colours of one trained source at any place, scale and pair of directions.

The back of a source of two faces has textures of its own; other sources look alike from both sides. Sources
that light passes through, such as fabrics, have a second decoder for lights on the other side and a network
of holes; the published model transmits no light.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, Self, final

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.assets.loom_file import LoomFile, Setting
from loomlight.assets.sources import Source
from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Report
from loomlight.models.learned_proposal import LearnedProposal
from loomlight.models.neumip.networks import (
    CHANNELS,
    NETWORKS,
    DeviceWeights,
    Weights,
    quantised,
    sampler_widths,
)
from loomlight.models.neumip.parallax import MIN_COSINE, shifted
from loomlight.models.neumip.settings import NeumipOptions
from loomlight.models.textured_model import (
    TexturedBsdf,
    TexturedModel,
    layers_of_loom,
    run_training,
    shape_of_loom,
    tensors_of_layers,
)
from loomlight.scattering.point import DirectionSample, to_face_frame


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
