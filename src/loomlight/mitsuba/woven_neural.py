"""`woven_neural`: the universal network of chen2024 as a Mitsuba BSDF, for any distance, one sample a pixel.

It averages over the footprint that `footprint_path` hands it. In a symbolic call a network is seventy times
slower (`loomlight.models.woven.decoder`), so that integrator does without them where such a BSDF is about.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache
from typing import Any

import mitsuba as mi

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.files import require_file
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.mitsuba.fabric_props import number_of_props, other_fabric_of, truth_of_props
from loomlight.mitsuba.footprint_bsdf import SeenCloth, footprint_bsdf_class, number_of
from loomlight.models.interface import FamilyAlbedos, Response
from loomlight.models.woven.decoder import Seen
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.encoding import encode, encode_pair
from loomlight.models.woven.model import WovenModel
from loomlight.models.woven.weights import Weights, read_weights, shipped_weights
from loomlight.scattering.point import DirectionSample


def woven_neural_class() -> type:
    """The BSDF's class in the current variant, for `mi.register_bsdf`."""
    base: Any = footprint_bsdf_class()

    class WovenNeural(base):
        """Woven cloth over footprints, by the universal network.

        Parameters beside those of `FootprintBsdf`:
            other: a second fabric, a path or a weave's name, whose latents this one's are mixed with.
            blend: how much of the other one: 0 (default) is this one, 1 the other; beyond, extrapolated.
                Colours stay this one's.
            refined: whether the last layer is fitted to the fabric, true by default: most of a second for a
                fabric that the cache does not have, and highlights twice as exact. Off, threads are edited
                live.
            weights: a weights file that `loomlight train woven` wrote; by default that of the package.

        Scene parameters are those of `FootprintBsdf`, and ``blend`` where there is another fabric. A change
        of a family's threads costs one run of the encoder, and one fit where it is refined; one of anything
        else neither.
        """

        baked_parameters = ("roughness", "height_scale", "inclination", "twist")
        symbolic = False

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.other = other_fabric_of(props)
            self.weights = _weights_of(props)
            self._refined = truth_of_props(props, "refined", True)
            self._blend = mi.Float(number_of_props(props, "blend", 0.0, "a number, such as 0.5"))
            if self.other is not None:
                self.own_parameters["blend"] = self._blend
            self.finish()

        def bake(self) -> None:
            """Runs the encoder, or reads its cache."""
            self._encoded: tuple[EncodedFabric, ...]
            if self.other is None:
                own = encode(self.fabric, self.weights, llvm_float(), refined=self._refined)
                self._encoded = (own,)
            else:
                self._encoded = encode_pair(
                    self.fabric, self.other, self.weights, llvm_float(), self._refined
                )

        def assembled(self) -> WovenModel:
            """The model of mixed latents."""
            latents = self._encoded[0]
            if self.other is not None:
                latents = latents.mixed(self._encoded[1], number_of(self._blend))
            return WovenModel(self.fabric, latents, self.weights)

        def seen_cloth(self, albedos: FamilyAlbedos, view: Any, footprint: Footprint) -> SeenCloth:
            """What the first part of the decoder makes of views."""
            return _SeenByNetwork(self.model, self.model.seen(view, footprint), albedos, view)

        def mean_albedos(self, means: FootprintAlbedos, view: Any, footprint: Footprint) -> FamilyAlbedos:
            """As the threads lie under the footprint, without parallax."""
            return FamilyAlbedos(*means.over(footprint, view.z < 0))

        def hole(self, view: Any, footprint: Footprint) -> Any:
            """The decoder's hole."""
            return self.model.hole(view, footprint)

        def to_string(self) -> str:
            """The fabric, and the one that it is mixed with."""
            other = (
                "none" if self.other is None else f'"{self.other.name}", blend = {number_of(self._blend):g}'
            )
            return str(self.described(other=other))

    return WovenNeural


@dataclass
class _SeenByNetwork:
    """A `SeenCloth` whose decoder has seen the view."""

    model: WovenModel
    seen: Seen
    albedos: FamilyAlbedos
    view: Any

    def response(self, light: Any, lit: Any = True) -> Response:
        return self.model.lit(self.seen, light, self.view)

    def pdf(self, light: Any) -> Any:
        return self.model.pdf_seen(self.seen, self.albedos, light, self.view)

    def response_and_pdf(self, light: Any) -> tuple[Response, Any]:
        return self.response(light), self.pdf(light)

    def sample(self, choice: Any, u: Any) -> DirectionSample:
        return self.model.sample_seen(self.seen, self.albedos, self.view, choice, u)

    def respond_and_sample(self, light: Any, choice: Any, u: Any) -> tuple[Response, Any, DirectionSample]:
        return *self.response_and_pdf(light), self.sample(choice, u)


def runs_network(bsdf: Any) -> bool:
    """Whether a BSDF evaluates a network, which symbolic calls make slow."""
    return type(bsdf).__name__ == "WovenNeural"


def _weights_of(props: Any) -> Weights:
    """The network that the properties name: one object a file, so that fabrics share its kernels."""
    if "weights" not in props:
        return shipped_weights()
    path = str(props["weights"])
    require_file(path)
    return _read_once(path, os.stat(path).st_mtime_ns)


@cache
def _read_once(path: str, _modified: int) -> Weights:
    return read_weights(path)
