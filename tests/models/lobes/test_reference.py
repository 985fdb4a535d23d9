"""The prefiltered regime in Dr.Jit against its reference in NumPy: the same formulas, written twice.

Covers: models/lobes/prefiltered.py
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.models.lobes.bsdf import LobeWeights
from loomlight.models.lobes.model import LobesModel
from loomlight.models.separable import Components
from tests.helpers.fabrics import STRESSING

from .cloths import FootprintQueries, model_of, prefiltered_parts, random_queries, reference_of
from .reference import LobesReference, Parallelogram

QUERIES = 250
# Float32 against float64. Steep highlights (α = 0.1) magnify errors of the half vector, most of all where
# light and view are nearly opposite.
RELATIVE, ABSOLUTE = 1e-4, 1e-6
# Weights of directions' nodes are rounded to whole units, footprints to nodes: ties may be rounded either
# way, 1 query in 1000.
FLIPPED, UNIT = 0.01, 1e-2


def queries_of(model: LobesModel, seed: int) -> FootprintQueries:
    return random_queries(model.fabric, model.tables.base_size, QUERIES, seed)


def agree(actual: NDArray[np.float32], expected: NDArray[np.float64], name: str) -> None:
    np.testing.assert_allclose(actual, expected, rtol=UNIT, atol=1e-4, err_msg=name)
    differs = ~np.isclose(actual, expected, rtol=RELATIVE, atol=ABSOLUTE)
    assert differs.mean() <= FLIPPED, (name, actual[differs][:5], expected[differs][:5])


def parallelogram(queries: FootprintQueries, lane: int) -> Parallelogram:
    """One footprint."""
    return Parallelogram(queries.centres[lane], *queries.edges[lane])


def reference_parts(reference: LobesReference, queries: FootprintQueries) -> dict[str, NDArray[np.float64]]:
    """Components and hole of the reference, by name [n]."""
    actual = [
        reference.components_and_hole(queries.lights[lane], queries.views[lane], parallelogram(queries, lane))
        for lane in range(QUERIES)
    ]
    parts = {
        part.name: np.array([getattr(one, part.name) for one, _ in actual]) for part in fields(Components)
    }
    return parts | {"hole": np.array([hole for _, hole in actual])}


@pytest.mark.quick("smooth satin")
@pytest.mark.parametrize("name", STRESSING)
def test_both_agree_on_components_and_holes(name: str) -> None:
    model = model_of(name)
    queries = queries_of(model, seed=1)
    # Both faces, both sides of light, all levels.
    assert {(v > 0, lit > 0) for v, lit in zip(queries.views[:, 2], queries.lights[:, 2], strict=True)} == {
        (a, b) for a in (False, True) for b in (False, True)
    }
    level = np.log2(np.maximum(queries.sizes / model.tables.base_size, 1)).astype(int)
    assert set(level) >= set(range(len(model.tables.levels) - 1))
    actual, expected = prefiltered_parts(model, queries), reference_parts(reference_of(model), queries)
    for part, values in expected.items():
        agree(actual[part], values, part)
    assert all(values.max() > 0.02 for values in expected.values())


@pytest.mark.quick("5")
@pytest.mark.parametrize("groups", [1, 5, 16])
def test_both_agree_on_any_number_of_groups(groups: int) -> None:
    """Five leave bytes of padding in each family's last pack."""
    model = model_of("translucent twill", groups)
    queries = queries_of(model, seed=2)
    actual, expected = prefiltered_parts(model, queries), reference_parts(reference_of(model), queries)
    for part, values in expected.items():
        agree(actual[part], values, part)


@pytest.mark.parametrize("name", ["smooth satin", "translucent twill"])
def test_both_agree_on_the_density(name: str) -> None:
    model = model_of(name)
    queries = queries_of(model, seed=3)
    at = model.at(queries.view, queries.footprint)
    mixture = at.mixture
    _, (sums,) = at.prefiltered([queries.light], mixture, True)
    actual = (sums.density / sums.weight_sum).numpy()
    lobe_weights = [
        [np.broadcast_to(getattr(family, part.name).numpy(), QUERIES) for part in fields(LobeWeights)]
        for family in (mixture.warp, mixture.weft)
    ]
    reference = reference_of(model)
    expected = [
        reference.group_density(
            queries.lights[lane],
            queries.views[lane],
            parallelogram(queries, lane),
            tuple(LobeWeights(*(float(part[lane]) for part in family)) for family in lobe_weights),
        )
        for lane in range(QUERIES)
    ]
    agree(actual, np.array(expected), name)


def test_a_reference_of_other_bytes_disagrees() -> None:
    """The tables decide: the warp's bytes of the levels that large footprints read show."""
    model = model_of("smooth satin")
    queries = queries_of(model, seed=4)
    actual = prefiltered_parts(model, queries)
    tables = model.tables
    damaged = tables.coverage.copy()
    damaged[:, tables.levels[-3, 0] :, : 2 * tables.packs] //= 2
    reference = reference_of(LobesModel(model.fabric, replace(tables, coverage=damaged)))
    expected = reference_parts(reference, queries)["specular_warp"]
    large = queries.sizes > 16 * tables.base_size
    assert large.any()
    assert not np.allclose(actual["specular_warp"][large], expected[large], rtol=UNIT, atol=1e-4)
