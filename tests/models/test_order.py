"""Answers of a BSDF depend on their arguments alone, in whichever order they are asked for.

Covers: models/interface.py, models/separable.py
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.registry import make_model, model_names
from loomlight.models.separable import SeparableBsdf
from tests.helpers.arrays import numbers
from tests.helpers.directions import directions
from tests.helpers.queries import Queries, queries

require_llvm()

# With all that answers share: holes, sheen, light between yarns, threads of several colours.
CLOTH = """
    weave = "satin 5/2"
    gap = 0.2
    interreflection = true
    [warp]
    color = ["#e0c060", "#80a0c0"]
    translucency = 0.2
    [weft]
    color = "#f0f0f0"
    [sheen]
    strength = 0.3
    """
CHEAPEST = {"clustered": {"clusters": 4, "texels": 32}}


@cache
def built(name: str) -> Model:
    return make_model(name, fabric_from_text(CLOTH), **CHEAPEST.get(name, {}))


@cache
def asked() -> tuple[Queries, Float, Array2f]:
    return queries(fabric_from_text(CLOTH), 200, seed=31), *numbers(np.random.default_rng(32), 200)


def questions(at: FootprintBsdf) -> dict[str, Callable[[], Any]]:
    """All that can be asked of a BSDF, by name."""
    queried, choice, u = asked()
    light = queried.light
    found: dict[str, Callable[[], Any]] = {
        "hole": lambda: at.hole,
        "null transmission": lambda: at.null_transmission,
        "reflectance": lambda: at.diffuse_reflectance,
        "value": lambda: at.value(light),
        "pdf": lambda: at.pdf(light),
        "value and pdf": lambda: at.value_and_pdf(light),
        "sample": lambda: at.sample(choice, u),
        "value and null transmission": lambda: at.value_and_null_transmission(light),
        "everything": lambda: at.value_pdf_sample_and_null_transmission(light, choice, u),
    }
    if isinstance(at, SeparableBsdf):
        separable = at
        found["albedos"] = lambda: separable.albedos
        found["components"] = lambda: separable.components(light)
        found["bounced"] = lambda: separable.bounced(separable.evaluate(light))
    return found


def leaves(answer: Any) -> list[NDArray[np.float32]]:
    """The arrays of an answer."""
    if answer is None:
        return []
    if isinstance(answer, tuple):
        return [leaf for part in answer for leaf in leaves(part)]
    if hasattr(answer, "__dataclass_fields__"):
        return leaves(tuple(vars(answer).values()))
    return [answer.numpy()]


def answers(at: FootprintBsdf, names: list[str]) -> dict[str, list[NDArray[np.float32]]]:
    """Answers to questions in an order, each before the next."""
    return {name: leaves(questions(at)[name]()) for name in names}


# Questions whose answers share a search. Each order compiles kernels of its own, so `make test-all` asks all
# questions of all models.
SHARED = ("bounced", "components", "hole", "value")
CHEAP = ("lobes", "point", "neural")
models = [pytest.param(name, marks=() if name in CHEAP else pytest.mark.slow) for name in model_names()]
asked_of = [(name, SHARED) for name in CHEAP]
asked_of += [pytest.param(name, (), marks=pytest.mark.slow) for name in model_names()]


@pytest.mark.quick("neural-chosen2")
@pytest.mark.parametrize(("name", "chosen"), asked_of)
def test_no_answer_depends_on_what_was_asked_before(name: str, chosen: tuple[str, ...]) -> None:
    """Any question comes before and after any other, of objects that were asked nothing else."""
    model, queried = built(name), asked()[0]

    def fresh() -> FootprintBsdf:
        return model.at(queried.view, queried.footprint)

    names = [*(chosen or questions(fresh()))]
    alone = {question: answers(fresh(), [question])[question] for question in names}
    for order in (names, names[::-1]):
        for question, actual in answers(fresh(), order).items():
            for one, other in zip(actual, alone[question], strict=True):
                np.testing.assert_array_equal(one, other, err_msg=f"{question} of {order}")


@pytest.mark.parametrize("name", models)
def test_parameters_are_read_and_nothing_else_happens(name: str) -> None:
    model, queried = built(name), asked()[0]

    def value(of: Model) -> NDArray[np.float32]:
        return of.at(queried.view, queried.footprint).value(queried.light).numpy()

    before = value(model)
    values = model.parameters(array_types(Float))
    bound = model.bound_to(values)
    np.testing.assert_allclose(value(bound), before, rtol=1e-4, atol=1e-6)
    if not values:
        assert bound is model
        return
    values["weft.diffuse_reflect"].value.x = 0.05
    assert np.abs(value(bound)[0] - before[0]).max() > 0.01
    if name not in ("point", "samples"):
        # Whose parameters are their own arrays: gradients reach what it computes with.
        np.testing.assert_array_equal(value(model), before)


@pytest.mark.slow
def test_light_between_yarns_of_close_ups_is_that_of_their_points() -> None:
    """Footprints of a fifth of a thread, against the mean over points of the same footprints."""
    cloth = fabric_from_text(CLOTH)
    count, rng = 500, np.random.default_rng(34)
    centres = rng.random((count, 2)) * cloth.repeat_mm
    edges = np.tile(0.04 * np.eye(2), (count, 1, 1))
    queried = Queries(directions(rng, count), directions(rng, count), centres, edges)
    # Points of each footprint, a footprint each.
    places = centres[:, None] + 0.04 * (rng.random((count, 64, 2)) - 0.5)
    each = [part.repeat(64, axis=0) for part in (queried.lights, queried.views)]
    points = Queries(*each, places.reshape(-1, 2), edges.repeat(64, axis=0))
    means = []
    for name, asked in (("lobes", queried), ("point", points)):
        at = make_model(name, cloth).at(asked.view, asked.footprint)
        assert isinstance(at, SeparableBsdf)
        bounced = at.bounced(at.evaluate(asked.light))
        assert bounced is not None
        means.append([part.numpy().reshape(count, -1).mean(axis=1) for part in bounced])
    actual, expected = means
    for one, other in zip(actual, expected, strict=True):
        assert abs(one.mean() - other.mean()) < 0.02 * other.mean()
