"""The universal network as a multi-scale model: latents of one fabric and a network that all share."""

from __future__ import annotations

import math
from typing import Any, Self, final

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.assets.loom_file import LoomFile
from loomlight.core.backend import array_types, channel_mean, maximum
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import FamilyAlbedos, Model, Response
from loomlight.models.woven.decoder import Decoder, Seen, decoder_cost, decoder_of
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.encoder import repeat_threads
from loomlight.models.woven.encoding import encode
from loomlight.models.woven.fibres import Fibres
from loomlight.models.woven.footprint_coding import AnisotropicTaps, levels_of, mean_pitch
from loomlight.models.woven.latent_table import LatentTable
from loomlight.models.woven.weights import Weights, shipped_weights
from loomlight.scattering.albedo import layer_albedo_bound
from loomlight.scattering.point import DirectionSample, to_face_frame
from loomlight.yarn.geometry import YarnGeometry

_NETWORK = "woven"


@final
class WovenModel(Model):
    """chen2024: an encoder once a fabric, a small decoder a query.

    Attributes:
        weights: the shared network.
        encoded: latents of both faces.
        multiply_adds: of one query.
        bytes_fetched: by one query.
    """

    name = "woven"
    filters = True
    conserves_energy = False

    def __init__(self, fabric: Fabric, encoded: EncodedFabric, weights: Weights) -> None:
        """A model of latents that are at hand; see `for_fabric`."""
        self.fabric = fabric
        self.encoded = encoded
        self.weights = weights
        layout = fabric.layout()
        picks, ends = layout.warp_on_top.shape
        width, height = layout.size
        self._threads_per_mm = ends / width, picks / height
        self._pitch = mean_pitch(layout)
        self._albedos = FootprintAlbedos(YarnGeometry(layout), fabric.appearance())
        self._tables: dict[type, LatentTable] = {}
        cost = decoder_cost(weights, encoded.correction is not None)
        self.multiply_adds = cost.seen + cost.lit
        self.bytes_fetched = cost.bytes_fetched

    @classmethod
    def for_fabric(cls, fabric: Fabric) -> Self:
        """The model of a fabric by the weights of the package, refined, or what the cache has of it.

        Raises:
            InputError: a repeat of more than 64 threads a side.
        """
        weights = shipped_weights()
        return cls(fabric, encode(fabric, weights, llvm_float(), refined=True), weights)

    def to_loom(self) -> LoomFile:
        """Latents, fibres and correction, and the checksum of the network that decodes them."""
        front, back = self.encoded.faces
        tensors: dict[str, NDArray[Any]] = {
            "front": front,
            "back": back,
            "fibres": self.encoded.fibres.array(),
        }
        if self.encoded.correction is not None:
            tensors["correction"] = self.encoded.correction
        return LoomFile(
            model=self.name,
            fabric=self.fabric,
            tensors=tensors,
            networks={_NETWORK: self.weights.sha256},
        )

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of latents in a file.

        Raises:
            InputError: another model's file, another network's latents, or latents of another fabric.
        """
        loom.require_model(cls.name)
        weights = shipped_weights()
        loom.require_network(_NETWORK, weights.sha256)
        picks, ends = repeat_threads(loom.fabric)
        texels = levels_of(picks, ends)[-1].first + 1 if weights.table.latent == "field" else 1
        front, back = (
            loom.tensor(side, (texels, weights.table.latent_size), np.float16) for side in ("front", "back")
        )
        fibres = Fibres.from_array(loom.tensor("fibres", (4, 2), np.float32))
        flaw = fibres.flaw()
        if flaw is not None:
            raise InputError(f"{loom.source}: of the tensor model.fibres the {flaw}. Bake it again.")
        correction = None
        if "correction" in loom.tensors:
            correction = loom.tensor("correction", weights.table.corrected_shape, np.float32)
        return cls(loom.fabric, EncodedFabric(picks, ends, (front, back), fibres, correction), weights)

    def evaluate(self, light: Any, view: Any, footprint: Footprint) -> Response:
        """Components and hole of footprints."""
        types = array_types(view.x)
        facing = to_face_frame(light, types.Bool(view.z < 0))
        decoder, table = self._decoder(types.Float), self._table(types.Float)
        found = decoder.answers(table, facing, *self._asked(view, footprint))
        return Response(*found)

    def albedos(self, view: Any, footprint: Footprint) -> FamilyAlbedos:
        """Mean albedos of the threads over footprints as they lie under them, without parallax."""
        return FamilyAlbedos(*self._albedos.over(footprint, view.z < 0))

    def seen(self, view: Any, footprint: Footprint) -> Seen:
        """What no light changes, to be computed once for several lights."""
        float_type = array_types(view.x).Float
        return self._decoder(float_type).seen(self._table(float_type), *self._asked(view, footprint))

    def hole(self, view: Any, footprint: Footprint) -> Any:
        """Share of the view rays that pass through footprints: Float."""
        float_type = array_types(view.x).Float
        return self._decoder(float_type).hole(self._table(float_type), *self._asked(view, footprint))

    def _asked(self, view: Any, footprint: Footprint) -> tuple[Any, ...]:
        """Squares in threads, the view in the frame of the face that it sees, and which that is."""
        types = array_types(view.x)
        back = types.Bool(view.z < 0)
        across, along = self._threads_per_mm
        x, y = footprint.centre.x * across, footprint.centre.y * along
        side, step = footprint.anisotropic_taps()
        squares = AnisotropicTaps(x, y, side * (1 / self._pitch), step.x * across, step.y * along)
        return squares, to_face_frame(view, back), back

    def lit(self, seen: Seen, light: Any, view: Any) -> Response:
        """The response to one light of what is seen."""
        types = array_types(view.x)
        facing = to_face_frame(light, types.Bool(view.z < 0))
        diffuse_warp, diffuse_weft, specular_warp, specular_weft = self._decoder(types.Float).components(
            seen, facing
        )
        return Response(diffuse_warp, diffuse_weft, specular_warp, specular_weft, seen.hole)

    def sample(self, view: Any, footprint: Footprint, choice: Any, u: Any) -> DirectionSample:
        """Straight through the holes, else by the cosine to either side in proportion to albedos."""
        return self.sample_seen(self.seen(view, footprint), self.albedos(view, footprint), view, choice, u)

    def sample_seen(
        self, seen: Seen, albedos: FamilyAlbedos, view: Any, choice: Any, u: Any
    ) -> DirectionSample:
        """`sample` of what is at hand already."""
        types = array_types(view.x)
        through, reflected = self._shares(seen.hole, albedos, view)
        light = self._drawn(through, reflected, view, choice, u)
        passes = types.Bool(choice < through)
        light = dr.select(passes, -view, light)
        pdf = dr.select(passes, through, _density(through, reflected, light, view))
        value = self.composed(self.lit(seen, light, view), albedos, light, view)
        # A ray goes straight through with the very share of light that does.
        weight = dr.select(passes, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, passes=passes)

    def pdf(self, light: Any, view: Any, footprint: Footprint) -> Any:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""
        return self.pdf_seen(self.seen(view, footprint), self.albedos(view, footprint), light, view)

    def pdf_seen(self, seen: Seen, albedos: FamilyAlbedos, light: Any, view: Any) -> Any:
        """`pdf` of what is at hand already."""
        return _density(*self._shares(seen.hole, albedos, view), light, view)

    def _shares(self, hole: Any, albedos: FamilyAlbedos, view: Any) -> tuple[Any, Any]:
        """Probability of passing straight through, and of reflection among all else."""
        through = self.straight_through(view, hole)
        highlight = layer_albedo_bound(self.fabric.appearance().optical_depth)

        def energy(side: str) -> Any:
            diffuse, specular = (
                sum(
                    channel_mean(getattr(family, f"{term}_{side}")) for family in (albedos.warp, albedos.weft)
                )
                for term in ("diffuse", "specular")
            )
            return diffuse + highlight * specular

        sheen = self.fabric.appearance().sheen.strength
        reflected, transmitted = energy("reflect") + sheen, energy("transmit")
        # Black cloth reflects nothing, but some direction has to be drawn.
        return through, (reflected + 1e-6) / (reflected + transmitted + 1e-6)

    def _drawn(self, through: Any, reflected: Any, view: Any, choice: Any, u: Any) -> Any:
        types = array_types(view.x)
        radius, angle = dr.sqrt(u.x), 2 * math.pi * u.y
        sine, cosine = dr.sincos(angle)
        height = dr.sqrt(maximum(1 - u.x, 1e-12))
        near = choice < through + (1 - through) * reflected
        up = dr.select(near ^ (view.z < 0), height, -height)
        return types.Vector3(radius * cosine, radius * sine, up)

    def _decoder(self, float_type: type) -> Decoder:
        return decoder_of(self.weights, float_type)

    def _table(self, float_type: type) -> LatentTable:
        if float_type not in self._tables:
            self._tables[float_type] = LatentTable(self.weights, self.encoded, float_type)
        return self._tables[float_type]


def _density(through: Any, reflected: Any, light: Any, view: Any) -> Any:
    side = dr.select(light.z * view.z > 0, reflected, 1 - reflected)
    return (1 - through) * side * dr.abs(light.z) * dr.inv_pi
