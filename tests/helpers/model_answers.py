"""Models of the registry, baked as cheaply as may be, and all that they answer at once."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cache
from typing import Any, get_type_hints

import drjit as dr
import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class, model_names
from loomlight.models.separable import Components, FamilyAlbedos, SeparableBsdf
from loomlight.scattering.point import DirectionSample
from tests.helpers.arrays import numbers
from tests.helpers.fabrics import CHEAPEST, CLOTHS, TEXTS
from tests.helpers.queries import Queries
from tests.marks import slow_among


def is_separable(name: str) -> bool:
    """Whether a model keeps components and albedos apart; others give colours alone."""
    return issubclass(get_type_hints(model_class(name).at)["return"], SeparableBsdf)


def bake_cheaply(name: str, cloth: Fabric) -> Model:
    """A model with the options of its cheapest bake."""
    return make_model(name, cloth, **CHEAPEST.get(name, {}))


@cache
def built(name: str, cloth: str, between_yarns: bool = True) -> Model:
    """A model of one of `CLOTHS`, baked once for all tests of a process.

    Args:
        between_yarns: whether yarns light each other, where the fabric does not say it.
    """
    chosen = fabric_from_text(CLOTHS[cloth])
    if not between_yarns:
        chosen = edited_fabric(chosen, {"interreflection": False})
    return bake_cheaply(name, chosen)


every_model = pytest.mark.parametrize("name", model_names())
separable_models = pytest.mark.parametrize("name", [*filter(is_separable, model_names())])
# Of cloths that no other test bakes for.
_SLOW = ("clustered", "neumip", "latent")
every_model_once = pytest.mark.parametrize("name", slow_among(model_names(), _SLOW))
separable_models_once = pytest.mark.parametrize(
    "name", slow_among(filter(is_separable, model_names()), _SLOW)
)
# Plain cloth has holes and lets light through its yarns.
every_fabric = pytest.mark.parametrize("cloth", slow_among(TEXTS, {*TEXTS} - {"plain"}))


@dataclass
class Answers:
    """All outputs of a model for queries, computed at once: one kernel serves most of these tests."""

    components: Components | None
    hole: Any
    albedos: FamilyAlbedos | None
    value: Any
    pdf: Any
    through: Any

    @property
    def parts(self) -> dict[str, NDArray[np.float32]]:
        """Components, where there are any, and the hole by name."""
        parts = {}
        if self.components is not None:
            parts = {part.name: getattr(self.components, part.name).numpy() for part in fields(Components)}
        return parts | {"hole": self.hole.numpy()}


def answers(model: Model, queried: Queries, light: Any = None) -> Answers:
    """The outputs of `model` for the queries, or for another light."""
    light = queried.light if light is None else light
    at = model.at(queried.view, queried.footprint)
    separable = isinstance(at, SeparableBsdf)
    assert separable == is_separable(model.name)
    components, albedos = (at.components(light), at.albedos) if separable else (None, None)
    value, pdf = at.value_and_pdf(light)
    actual = Answers(components, at.hole, albedos, value, pdf, at.null_transmission)
    dr.eval(actual)
    return actual


def drawn(model: Model, queried: Queries, seed: int) -> DirectionSample:
    """A direction of each query."""
    at = model.at(queried.view, queried.footprint)
    actual = at.sample(*numbers(np.random.default_rng(seed), len(queried)))
    dr.eval(actual)
    return actual


def close(
    actual: NDArray[np.float32], wanted: NDArray[np.float32], rtol: float = 2e-3, lanes: int | None = None
) -> None:
    """Two kernels round differently, and in a shadow's edge or a yarn's that decides: 1 lane in 200 may.

    Args:
        lanes: how many these were chosen from.
    """
    near = np.isclose(actual, wanted, rtol=rtol, atol=1e-5)
    alike = near if near.ndim == 1 else near.all(axis=0)
    apart = actual[..., ~alike][..., :3], wanted[..., ~alike][..., :3]
    assert (~alike).sum() < 0.005 * (lanes or alike.size), (alike.mean(), *apart)
