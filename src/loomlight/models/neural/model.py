"""The universal network as a multi-scale model: latents of one fabric, and a network shared by all."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import ClassVar, Self, final

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum
from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.core.settings import setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.fabric_model import FilteredFabricModel, fabric_in_loom, number_of, plane_source
from loomlight.models.interface import Parameter, ShaderTables, Values
from loomlight.models.networks import LearnedProposal, ReluNetwork
from loomlight.models.neural.codings import light_visibility_of
from loomlight.models.neural.decoder import Decoder, ViewActivations, decoder_cost, decoder_of, shader_network
from loomlight.models.neural.encoded_fabric import (
    AnisotropicTaps,
    EncodedFabric,
    mean_pitch,
    near_weight,
    sizes_of,
    taps_of_footprint,
)
from loomlight.models.neural.encoding import encode, encode_pair, repeat_threads
from loomlight.models.neural.latent_table import LatentTable
from loomlight.models.neural.proposal import (
    Proposal,
    neural_proposal,
    proposal_of,
    sampler_layers,
    sampler_of,
)
from loomlight.models.neural.weights import Weights, read_weights, shipped_weights
from loomlight.models.options import Options
from loomlight.models.separable import Components, Evaluation, FilteredBsdf
from loomlight.scattering.point import DirectionSample, Tint, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import upload_extent
from loomlight.yarn.visibility import first_hit

_NETWORK = "neural"
# By one network for all fabrics, or by lobes about the fibres.
SAMPLERS = ("learned", "lobes")
# Scene parameters of a family that the encoder sees.
_ENCODED = ("roughness", "height_scale", "inclination", "twist")


@final
class NeuralBsdf(FilteredBsdf):
    """The BSDF of footprints for one view: the decoder's activations that do not depend on the light."""

    def __init__(self, model: NeuralModel, view: Vec3, footprint: Footprint, tint: Tint | None) -> None:
        super().__init__(model.means, model.irregular, model.fabric.appearance(), view, footprint, tint)
        self._model = model
        self._decoder = decoder_of(model.weights, array_types(view.x).Float)
        self._query = model.query(view, footprint)

    @property
    def _table(self) -> LatentTable:
        return self._model.table(array_types(self.view.x).Float)

    @cached_property
    def _activations(self) -> ViewActivations:
        return self._decoder.view_activations(self._table, *self._query)

    @cached_property
    def hole(self) -> Float:
        """Fraction of the view rays that pass through holes, 0 to 1."""
        return self.irregular_hole(self._decoder.hole(self._table, *self._query))

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Components for a light and the hole, in one run of the network."""
        facing = to_face_frame(light, self._back)
        *decoded, hole = self._decoder.components_and_hole(self._table, facing, *self._query)
        return self._evaluation(decoded, hole, light)

    def _evaluate_activated(self, light: Vec3) -> Evaluation:
        """The same, of the part that no light changes: for what needs that part for more than one light."""
        decoded = self._decoder.components(self._activations, to_face_frame(light, self._back))
        return self._evaluation(decoded, self._activations.hole, light)

    def _evaluation(self, decoded: list[Float], hole: Float, light: Vec3) -> Evaluation:
        blend = self._model.fabric.appearance().diffuse_blend
        lit = light_visibility_of(decoded[0] + decoded[1], light, self.view, blend)
        even = Evaluation(Components.of(decoded, minimum(lit, 1 - hole)), hole)
        return self.irregular_evaluation(even)

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._proposal.density(to_face_frame(light, self._back))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """Null transmission through holes, else a direction of the proposal."""
        facing, is_null = self._proposal.draw(choice, u)
        light = to_face_frame(facing, self._back)
        pdf = dr.select(is_null, self._proposal.null, self._proposal.density(facing))
        value = self.composed(self._evaluate_activated(light), light)
        # Null transmission is drawn with the probability of its transmittance.
        weight = dr.select(is_null, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    def value_and_pdf(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both, of one run of the part that no light changes, which the learned sampler sees too."""
        return self.composed(self._evaluate_activated(light), light), self.pdf(light)

    def value_pdf_sample_and_null_transmission(
        self, light: Vec3, choice: Float, u: Vec2
    ) -> tuple[Color3, Float, DirectionSample, Float]:
        """All four, of one run of the part that no light changes."""
        null_transmission = self.null_transmission_of(self.irregular_hole(self._activations.hole))
        return *self.value_and_pdf(light), self.sample(choice, u), null_transmission

    @cached_property
    def _sampler(self) -> ReluNetwork | None:
        if self._model.sampler != SAMPLERS[0]:
            return None
        return sampler_of(self._model.weights, array_types(self.view.x).Float)

    @cached_property
    def _proposal(self) -> Proposal | LearnedProposal:
        """The mixture that directions are drawn from; densities carry no derivatives."""
        null = dr.detach(self.null_transmission_of(self.irregular_hole(self._activations.hole)))
        albedos = dr.detach(self.albedos_in_mirror)
        view, fibres = to_face_frame(self.view, self._back), self._table.fibres(self._back)
        if self._sampler is not None:
            angular = dr.detach(self._activations.angular)
            return neural_proposal(self._sampler, angular, albedos, null, self.sheen, view, fibres)
        layer = self._model.fabric.appearance().layer_bound
        return proposal_of(
            albedos, null, self.sheen.strength, layer, view, fibres, self._table.lobe_roughness
        )


@dataclass(frozen=True, kw_only=True)
class NeuralOptions(Options):
    """Options of `neural`."""

    title: ClassVar[str] = "option of neural"

    refined: bool = setting(
        True, "The last layer is fitted to the fabric: most of a second, and half the error of highlights."
    )
    weights: str | os.PathLike[str] | Weights | None = setting(
        None,
        "A weights file that `python -m studies.papers.chen2024.training` wrote.",
        otherwise="that of the package",
        metavar="PATH",
    )
    sampler: str | None = setting(
        None,
        "Directions are drawn by a network for all fabrics, learned, or by lobes about the fibres.",
        choices=SAMPLERS,
        otherwise="learned, of other weights than the package's lobes",
    )
    other: Source | None = setting(
        None,
        "A second fabric to interpolate latents with; colours are those of the first.",
        expected="the path of a second fabric, or a weave's name",
        otherwise="none",
        metavar="FABRIC",
    )
    blend: float = setting(
        0.0,
        "Weight of the other fabric: 0 is this one, 1 the other; other values extrapolate.",
        expected="a number, such as 0.5",
    )


@final
class NeuralModel(FilteredFabricModel):
    """chen2024: an encoder once a fabric, a small decoder a query.

    Edits of a family's threads run the encoder, and fit the last layer where it is refined; other edits need
    neither. With two fabrics, ``blend`` is a scene parameter too.

    Attributes:
        weights: the shared network.
        sampler: what directions are drawn by, of `SAMPLERS`.
        encoded: latents of both faces; of a mixture, the interpolated latents.
        multiply_adds: of one query.
        bytes_fetched: by one query.
    """

    name = "neural"
    conserves_energy = False
    symbolic = False
    options_class = NeuralOptions
    options: NeuralOptions

    def __init__(
        self,
        fabric: Fabric,
        encoded: EncodedFabric,
        weights: Weights,
        options: NeuralOptions | None = None,
        endpoints: tuple[EncodedFabric, EncodedFabric] | None = None,
    ) -> None:
        """A model of encoded latents; see `for_source` to encode them.

        Args:
            endpoints: latents of this fabric and of the other one, before interpolation.
        """
        super().__init__(fabric)
        self.encoded = encoded
        self.weights = weights
        self.options = options or NeuralOptions()
        learned = sampler_layers(weights) is not None
        self.sampler = self.options.sampler or SAMPLERS[0 if learned else 1]
        if self.sampler == SAMPLERS[0] and not learned:
            raise InputError(
                'sampler = "learned" is of the package\'s network alone, '
                f'and {weights.source} is another one: give "lobes".'
            )
        self._endpoints = endpoints
        layout = fabric.layout()
        picks, count = layout.warp_on_top.shape
        width, height = layout.size
        self._threads_per_mm = count / width, picks / height
        self._pitch = mean_pitch(layout)
        self._surface = YarnGeometry(layout)
        self._tables: dict[type, LatentTable] = {}
        cost = decoder_cost(weights, encoded.correction is not None)
        self.multiply_adds = cost.per_view + cost.per_light
        self.bytes_fetched = cost.bytes_fetched

    @classmethod
    def for_source(
        cls, source: Source, options: NeuralOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model of a fabric, from the cache or by the encoder.

        Raises:
            InputError: no fabric, a repeat of more than 64 threads a side, or weights that cannot be read.
        """
        del report
        fabric, chosen = plane_source(source, cls.name), options or NeuralOptions()
        network = chosen.weights if isinstance(chosen.weights, Weights) else _network(chosen.weights)
        if chosen.other is None:
            encoded = encode(fabric, network, llvm_float(), refined=chosen.refined)
            return cls(fabric, encoded, network, chosen)
        second = plane_source(chosen.other, cls.name)
        endpoints = encode_pair(fabric, second, network, llvm_float(), chosen.refined)
        return cls(fabric, endpoints[0].mixed(endpoints[1], chosen.blend), network, chosen, endpoints)

    def with_source(self, source: Source) -> Self:
        """The model of another fabric by the same network, mixed with the same second fabric."""
        return type(self).for_source(source, replace(self.options, weights=self.weights))

    def with_fabric(self, fabric: Fabric, edits: frozenset[str]) -> Self:
        """The model of an edited fabric; the encoder runs if its inputs change."""
        if any(name.endswith(_ENCODED) for name in edits):
            return self.with_source(fabric)
        return type(self)(fabric, self.encoded, self.weights, self.options, self._endpoints)

    def parameters(self, types: ArrayTypes) -> Values:
        """Numbers and albedos of the fabric, and ``blend`` where it is mixed with another."""
        values = dict(super().parameters(types))
        if self.options.other is not None:
            values["blend"] = Parameter(types.Float(self.options.blend))
        return values

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The model after an edit."""
        model = super().updated(values, changed)
        if model._endpoints is None or number_of(values["blend"]) == model.options.blend:
            return model
        blend = number_of(values["blend"])
        mixed = type(self)(
            model.fabric,
            model._endpoints[0].mixed(model._endpoints[1], blend),
            model.weights,
            replace(model.options, blend=blend),
            model._endpoints,
        )
        return mixed.with_means(model.means)

    def upload(self, types: ArrayTypes) -> None:
        """Uploads albedos and latents to a backend."""
        super().upload(types)
        self._surface.upload(types)
        upload_extent(self._surface, types)
        self.table(types.Float)

    def to_loom(self) -> LoomFile:
        """A file of latents, fibres and correction, with the checksum of the network that decodes them."""
        return LoomFile(
            model=self.name,
            source=self.fabric,
            tensors=self.encoded.arrays(),
            settings={"sampler": self.sampler},
            networks={_NETWORK: self.weights.sha256},
        )

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of latents in a file.

        Raises:
            InputError: another model's file, another network's latents, or latents of another fabric.
        """
        fabric = fabric_in_loom(loom, cls.name)
        weights = shipped_weights()
        loom.require_network(_NETWORK, weights.sha256)
        picks, ends = repeat_threads(fabric)
        encoded = loom.tables(EncodedFabric, sizes_of(picks, ends, weights.table), picks=picks, ends=ends)
        # Files of the first versions do not say what draws directions.
        sampler = loom.setting("sampler", str) if "sampler" in loom.settings else None
        return cls(fabric, encoded, weights, NeuralOptions(sampler=sampler))

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> NeuralBsdf:
        """The BSDF of footprints for one view each."""
        del active
        return NeuralBsdf(self, view, footprint, tint)

    def query(self, view: Vec3, footprint: Footprint) -> tuple[AnisotropicTaps, Vec3, Mask]:
        """Anisotropic taps in threads, the view in the frame of the face seen, and whether it is the back."""
        types = array_types(view.x)
        back = types.Bool(view.z < 0)
        across, along = self._threads_per_mm
        x, y = footprint.centre.x * across, footprint.centre.y * along
        side, first, second = taps_of_footprint(footprint, self._pitch)
        steps = first.x * across, first.y * along, second.x * across, second.y * along
        taps = AnisotropicTaps(x, y, side * (1 / self._pitch), *steps)
        seen = to_face_frame(view, back)
        if self.weights.table.parallax:
            taps = self._at_yarns(taps, footprint.centre, seen, back)
        return taps, seen, back

    def _at_yarns(self, taps: AnisotropicTaps, centre: Vec2, view: Vec3, back: Mask) -> AnisotropicTaps:
        """Taps of small footprints moved to where their view ray meets yarn.

        Args:
            centre: of the footprints, where rays cross the plane of the cloth, millimetres.
            view: in the frame of the face that is seen.
        """
        near = near_weight(taps.size(dr), dr)
        is_symbolic = dr.flag(dr.JitFlag.SymbolicScope)
        if not is_symbolic and dr.none(near > 0):
            return taps
        number_type = dr.uint32_array_t(near)
        # Of all lanes, where the footprints of all are of one size.
        is_near = dr.select(near > 0, number_type(1), dr.zeros(number_type, dr.width(centre, view)))
        # From afar few lanes are near, and the search of all would take longer than the network.
        # Derivatives of where a ray meets yarn would be wrong as well as dear.
        with dr.suspend_grad():
            x, y = dr.switch(
                is_near,
                [lambda *_: (type(near)(0), type(near)(0)), self._yarn_met],
                # The last one is none of truth values, which Dr.Jit would take for active lanes.
                *(back, centre, view),
                mode="symbolic" if is_symbolic else "evaluated",
            )
        across, along = self._threads_per_mm
        return replace(taps, x=dr.fma(near * across, x, taps.x), y=dr.fma(near * along, y, taps.y))

    def _yarn_met(self, back: Mask, centre: Vec2, view: Vec3) -> tuple[Float, Float]:
        """From where view rays cross the plane of the cloth to where they meet yarn, millimetres.

        It is 0 where they pass through holes.
        """
        hit = first_hit(self._surface, centre.x, centre.y, view, back)
        return tuple(dr.select(hit.hole, 0, met - at) for met, at in ((hit.x, centre.x), (hit.y, centre.y)))

    def decoder(self, float_type: type) -> Decoder:
        """The network on one backend; all fabrics share it."""
        return decoder_of(self.weights, float_type)

    def table(self, float_type: type) -> LatentTable:
        """The latents on one backend, uploaded once."""
        if float_type not in self._tables:
            self._tables[float_type] = LatentTable(self.weights, self.encoded, float_type)
        return self._tables[float_type]

    def shader_tables(self, half: bool = True) -> ShaderTables:
        """Latents and fibres, the network that all fabrics share, and the threads of the repeat.

        Raises:
            InputError: a network of another shape than that of the shaders.
        """
        ends_per_mm, picks_per_mm = self._threads_per_mm
        given = {
            "network": shader_network(self.weights),
            "ends_per_mm": ends_per_mm,
            "picks_per_mm": picks_per_mm,
            "pitch": self._pitch,
        }
        return ShaderTables(self.encoded, given)

    def own_facts(self) -> dict[str, str]:
        """The fabric that latents are interpolated with."""
        other, blend = self.options.other, self.options.blend
        return {"other": "none" if other is None else f'"{other.name}", blend = {blend:g}'}


def _network(path: str | os.PathLike[str] | None) -> Weights:
    """The network in a file, or that of the package: one object a file, so that fabrics share its kernels."""
    if path is None:
        return shipped_weights()
    require_file(path)
    return _read_once(str(path), os.stat(path).st_mtime_ns)


@cache
def _read_once(path: str, _modified: int) -> Weights:
    return read_weights(path)
