"""Models that show yarns close up: their samplers, their agreement, and what is left from afar."""

from __future__ import annotations

from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float

from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.lobes.model import LobesModel
from loomlight.models.registry import make_model
from tests.helpers.arrays import numbers, vectors
from tests.helpers.chi_square import cell_counts, cell_shares, p_value
from tests.helpers.directions import directions

SMOOTH = 'weave = "twill 2/2"\ngap = 0.1\n'
DETAIL = "plies = 2\nfibre_tilt_deg = 12\nslub = 0.5\nhairiness = 1\n"
WITH_DETAIL = f"{SMOOTH}[warp]\n{DETAIL}[weft]\n{DETAIL}"
SIDE = 0.5  # of a thread, millimetres


@cache
def model(name: str) -> Model:
    # Few groups: what they average is no matter here.
    options = {"groups": 2} if name == "lobes" else {}
    return make_model(name, fabric_from_text(WITH_DETAIL), **options)


def footprints(rng: np.random.Generator, count: int, size: float) -> Footprint:
    centre = Array2f(*(Float((40 * rng.random(count)).astype(np.float32)) for _ in range(2)))
    edge = Float(size)
    return Footprint(centre, Array2f(edge, 0), Array2f(0, edge))


@pytest.mark.parametrize("towards", [(0.1, -0.2, 0.97), (0.7, 0.5, 0.4)])
def test_chi_square_of_turned_frames(towards: tuple[float, float, float]) -> None:
    """Of `point`; directions of `lobes` are drawn from its groups, which know no detail."""
    rng, count = np.random.default_rng(11), 100_000
    centre = (40 * rng.random(2)).tolist()
    footprint = Footprint(Array2f(*centre), Array2f(0.01, 0), Array2f(0, 0.01))
    direction = np.asarray(towards) / np.linalg.norm(towards)

    def at(rows: int) -> FootprintBsdf:
        return model("point").at(vectors(np.tile(direction, (rows, 1))), footprint)

    def density(rows: np.ndarray) -> np.ndarray:
        return np.asarray(at(len(rows)).pdf(vectors(rows)).numpy())

    sampled = at(count).sample(*numbers(rng, count))
    drawn = sampled.light.numpy().T[~sampled.is_null.numpy()]
    assert p_value(cell_counts(drawn), cell_shares(density) * count) > 1e-4


@pytest.mark.slow
def test_lobes_and_point_agree_close_up() -> None:
    """In footprints of a hundredth of a thread one point is evaluated, its detail and its colour included."""
    rng, count = np.random.default_rng(12), 2000
    footprint = footprints(rng, count, SIDE / 100)
    view, light = (vectors(directions(rng, count)) for _ in range(2))
    near, point = (model(name).at(view, footprint).value(light).numpy() for name in ("lobes", "point"))
    # Another quality of the search moves hits at outlines.
    assert np.isclose(near, point, rtol=0.02, atol=1e-4).all(axis=0).mean() > 0.97


@pytest.mark.slow
def test_lobes_from_afar_know_no_detail() -> None:
    rng, count = np.random.default_rng(13), 500
    footprint = footprints(rng, count, 2 * SIDE)
    view, light = (vectors(directions(rng, count)) for _ in range(2))
    detailed = model("lobes")
    assert isinstance(detailed, LobesModel)
    smooth = LobesModel(fabric_from_text(SMOOTH), detailed.tables, detailed.options)
    values = [chosen.at(view, footprint).value(light).numpy() for chosen in (smooth, detailed)]
    np.testing.assert_allclose(*values, rtol=1e-4, atol=1e-6)


@pytest.mark.quick("point")
@pytest.mark.parametrize("name", ["point", "lobes"])
def test_weights_are_values_over_densities(name: str) -> None:
    rng, count = np.random.default_rng(14), 4000
    at = model(name).at(vectors(directions(rng, count)), footprints(rng, count, SIDE / 300))
    sampled = at.sample(*numbers(rng, count))
    value, pdf = at.value(sampled.light), at.pdf(sampled.light)
    dr.eval(sampled, value, pdf)
    drawn = (sampled.pdf.numpy() > 1e-3) & ~sampled.is_null.numpy()
    expected = value.numpy()[:, drawn] / pdf.numpy()[drawn]
    close = np.isclose(sampled.weight.numpy()[:, drawn], expected, rtol=5e-3, atol=1e-4)
    assert close.all(axis=0).mean() > 0.995
