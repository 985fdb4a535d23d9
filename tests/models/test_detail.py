"""Close-ups of `lobes`, where it looks at points: the detail of yarns and the light between them."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float

from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes.model import LobesModel
from loomlight.models.registry import make_model
from loomlight.models.separable import SeparableBsdf
from tests.helpers.arrays import vectors
from tests.helpers.directions import directions
from tests.helpers.fabrics import EVERYTHING, SMOOTH
from tests.helpers.model_answers import built
from tests.helpers.queries import Queries

SIDE = 0.5  # of a thread, millimetres


def footprints(rng: np.random.Generator, count: int, size: float) -> Footprint:
    centre = Array2f(*(Float((40 * rng.random(count)).astype(np.float32)) for _ in range(2)))
    edge = Float(size)
    return Footprint(centre, Array2f(edge, 0), Array2f(0, edge))


@pytest.mark.slow
def test_lobes_and_point_agree_close_up() -> None:
    """In footprints of a hundredth of a thread one point is evaluated, its detail and its colour included."""
    rng, count = np.random.default_rng(12), 2000
    footprint = footprints(rng, count, SIDE / 100)
    view, light = (vectors(directions(rng, count)) for _ in range(2))
    near, point = (
        built(name, "detailed").at(view, footprint).value(light).numpy() for name in ("lobes", "point")
    )
    # Another quality of the search moves hits at outlines.
    assert np.isclose(near, point, rtol=0.02, atol=1e-4).all(axis=0).mean() > 0.97


@pytest.mark.slow
def test_lobes_from_afar_know_no_detail() -> None:
    rng, count = np.random.default_rng(13), 500
    footprint = footprints(rng, count, 2 * SIDE)
    view, light = (vectors(directions(rng, count)) for _ in range(2))
    detailed = built("lobes", "detailed")
    assert isinstance(detailed, LobesModel)
    smooth = LobesModel(fabric_from_text(SMOOTH), detailed.tables, detailed.options)
    values = [chosen.at(view, footprint).value(light).numpy() for chosen in (smooth, detailed)]
    np.testing.assert_allclose(*values, rtol=1e-4, atol=1e-6)


@pytest.mark.slow
def test_light_between_yarns_of_close_ups_is_that_of_their_points() -> None:
    """Footprints of a fifth of a thread, against the mean over points of the same footprints."""
    cloth = fabric_from_text(EVERYTHING)
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
