"""The estimate in machine code against Dr.Jit's: one set of formulas, fetched and summed in other ways."""

from __future__ import annotations

from dataclasses import fields, replace

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.compiled_queries import answered
from loomlight.core.lane_code import Vectors
from loomlight.core.machine_code import vectors
from loomlight.models.interface import Response
from loomlight.models.lobes import model as lobes_model
from loomlight.models.lobes.compiled import CompiledEstimate
from loomlight.models.lobes.estimate_code import ANSWERS
from loomlight.models.lobes.model import LobesModel
from loomlight.scattering.point import on_face

from .cloths import TEXTS, Asked, asked_of, far_parts, model_of

QUERIES = 3001  # the last block is not full
# Of other processors: LLVM splits vectors that are too long.
WIDTHS = [vectors(), Vectors(4, 16), Vectors(8, 16), Vectors(16, 32)]
# Rounding of what terms cancel to. Where a footprint lies half-way between two nodes it may go to either, and
# so may roundings of weights to whole units: one query in 100, by no more than neighbours differ.
RELATIVE, ABSOLUTE, FLIPPED, UNIT = 1e-4, 1e-6, 0.01, 2e-2


def compiled_parts(
    model: LobesModel, asked: Asked, wide: Vectors | None = None, wanted: Float | None = None
) -> dict[str, NDArray[np.float32]]:
    """What machine code says of the groups alone, by name [n]."""
    appearance = model.fabric.appearance()
    code = CompiledEstimate(
        model.tables,
        model.estimator(array_types(Float)).pyramid(),
        model.fabric.layout().size,
        (appearance.warp.roughness, appearance.weft.roughness),
        appearance.optical_depth,
        wide,
    )
    light, view, footprint = asked.light, asked.view, asked.footprint
    back = view.z < 0
    edges = footprint.duv_dx, footprint.duv_dy
    queries = [footprint.centre, *edges, on_face(view, back), back, on_face(light, back)]
    queries.append(Float(1) if wanted is None else wanted)
    found = answered(Float, queries, ANSWERS, code.run)
    return {part.name: value.numpy() for part, value in zip(fields(Response), found, strict=True)}


def agree(found: dict[str, NDArray[np.float32]], wanted: dict[str, NDArray[np.float32]]) -> None:
    for name, values in wanted.items():
        np.testing.assert_allclose(found[name], values, rtol=UNIT, atol=1e-3, err_msg=name)
        apart = ~np.isclose(found[name], values, rtol=RELATIVE, atol=ABSOLUTE)
        assert apart.mean() <= FLIPPED, (name, found[name][apart][:5], values[apart][:5])
        assert values.max() > 0.01, name


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
@pytest.mark.parametrize("name", TEXTS)
def test_machine_code_says_what_drjit_does(name: str, wide: Vectors) -> None:
    model = model_of(name)
    asked = asked_of(model.fabric, model.tables.size, QUERIES, seed=1)
    agree(compiled_parts(model, asked, wide), far_parts(model, asked))


@pytest.mark.parametrize("groups", [1, 5, 16, 64])
def test_any_number_of_groups(groups: int) -> None:
    """Fewer than a vector has lanes, more, and with padding."""
    model = model_of("translucent twill", groups)
    asked = asked_of(model.fabric, model.tables.size, QUERIES, seed=2)
    agree(compiled_parts(model, asked), far_parts(model, asked))


def test_what_is_not_wanted_is_nothing() -> None:
    """Whole blocks of it, and some lanes of a block."""
    model = model_of("open plain")
    asked = asked_of(model.fabric, model.tables.size, QUERIES, seed=3)
    wanted = (np.arange(QUERIES) >= 1000) & (np.arange(QUERIES) % 3 > 0)
    found = compiled_parts(model, asked, wanted=Float(wanted.astype(np.float32)))
    whole = compiled_parts(model, asked)
    for name, values in found.items():
        np.testing.assert_array_equal(values, np.where(wanted, whole[name], 0))


def test_evaluations_are_the_same_either_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """Close up, in between and far; what all queries share may be given once."""
    model = model_of("translucent twill")
    asked = asked_of(model.fabric, 0.1, QUERIES, seed=4)
    light, view, footprint = asked.light, type(asked.view)(0.1, 0.2, 0.97), asked.footprint
    calls = []
    run = CompiledEstimate.run
    monkeypatch.setattr(CompiledEstimate, "run", lambda *given: (calls.append(1), run(*given))[1])
    found = model.evaluate(light, view, footprint)
    dr.eval(found)
    assert calls == [1]
    monkeypatch.setattr(lobes_model, "answers_now", lambda *_: False)
    wanted = model.evaluate(light, view, footprint)
    dr.eval(wanted)
    assert calls == [1]
    parts = [part.name for part in fields(Response)]
    agree(*({name: getattr(one, name).numpy() for name in parts} for one in (found, wanted)))


def test_odd_numbers_harm_no_other_lane() -> None:
    """Nothing is read where there is no table, whatever is asked."""
    model = model_of("open plain")
    asked = asked_of(model.fabric, model.tables.size, 96, seed=6)
    whole = compiled_parts(model, asked)
    odd = [np.nan, np.inf, -np.inf, 0.0, 1e30, -1e30, 3e38]
    spoilt = np.arange(96) % 3 == 0
    for part in ("lights", "views", "centres", "sizes"):
        for value in odd:
            values = getattr(asked, part).copy()
            values[spoilt] = value
            with np.errstate(all="ignore"):
                found = compiled_parts(model, replace(asked, **{part: values}))
            for name, numbers in found.items():
                np.testing.assert_array_equal(numbers[~spoilt], whole[name][~spoilt])


def test_derivatives_go_by_drjit() -> None:
    model = model_of("open plain")
    asked = asked_of(model.fabric, 4 * model.tables.size, 10, seed=5)
    light = asked.light
    dr.enable_grad(light)
    assert dr.grad_enabled(model.evaluate(light, asked.view, asked.footprint).specular_warp)
