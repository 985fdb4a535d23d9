"""Places of points in footprints: unbiased for any function, and better than chance for what repeats."""

from __future__ import annotations

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, UInt32
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.models.point import (
    MIN_CELLS,
    FootprintPlaces,
    PointModel,
    PrimitiveCell,
    SampledModel,
    SamplesOptions,
)
from studies.accuracy.unbiased import SIGNIFICANCE, Means, holm, random_cases, scores
from tests.marks import slow

require_llvm()

CLOTHS = {
    "satin": 'weave = "satin 8/3"\ngap = 0.3',
    "noisy twill": 'weave = "twill 2/1"\ngap = 0.25\n[variation]\nfibre_noise = 0.8\ncolour_noise = 0.3',
    "striped plain": (
        'weave = "plain"\n[warp]\ncolor = ["#ffffff", "#ffffff", "#ffffff", "#102030"]\n'
        '[weft]\ncolor = "#806040"'
    ),
    "figured": 'weave = "argyle 32"',
    "herringbone": 'weave = "herringbone"\ngap = 0.1\n[sheen]\nstrength = 0.3\nroughness = 0.4',
}


def footprints(centres: NDArray[np.float64], edges: NDArray[np.float64]) -> Footprint:
    """Footprints of centres [n, 2] and edges [n, 2, 2]."""
    rows = (centres, edges[:, 0], edges[:, 1])
    return Footprint(*(Array2f(np.ascontiguousarray(part.T, np.float32)) for part in rows))


def seeds(rng: np.random.Generator, count: int) -> UInt32:
    """A seed a lane."""
    return UInt32(rng.integers(0, 2**32, count, dtype=np.uint32))


@pytest.mark.quick("plain")
@pytest.mark.parametrize("weave", ["plain", "satin 8/3", "herringbone"])
def test_places_lie_in_footprints_and_fill_them(weave: str) -> None:
    cell = PrimitiveCell(fabric_from_text(f'weave = "{weave}"').layout())
    rng, count = np.random.default_rng(3), 1 << 16
    side = np.sqrt(abs(np.linalg.det(cell.shifts)))
    for case in range(6):
        angle = 0.0 if case == 0 else rng.uniform(0, 2 * np.pi)
        angles = np.array([angle, angle + (np.pi / 2 if case == 0 else rng.uniform(0.5, 2.5))])
        # From little more than a cell to rows that are cut into parts.
        lengths = side * np.exp(rng.uniform(np.log(1.6), np.log(20), 2))
        edges = lengths[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        centre = rng.uniform(-50, 50, 2)
        many = footprints(np.tile(centre, (count, 1)), np.tile(edges, (count, 1, 1)))
        pixel = dr.gather(UInt32, seeds(rng, count // 64), dr.arange(UInt32, count) // 64)
        places = FootprintPlaces(cell, many, pixel)
        place, weight = places.at(dr.arange(UInt32, count) % 64)
        on_cell = abs(np.linalg.det(edges)) > MIN_CELLS * side**2
        assert (places.on_cell.numpy() == on_cell).all()
        found, weights = place.numpy().T, np.broadcast_to(weight.numpy(), count)
        s = np.linalg.solve(edges.T, (found - centre).T).T + 0.5
        # Single precision at 50 mm.
        assert ((s > -1e-4) & (s < 1 + 1e-4))[weights > 0].all()
        means = np.histogram2d(*s[weights > 0].T, bins=3, range=[[0, 1]] * 2, weights=weights[weights > 0])[0]
        # 1024 independent sequences of 64 points; a ninth of the footprint has a deviation below .3 a net.
        np.testing.assert_allclose(means / count * 9, 1, atol=0.04)
        # What repeats with the cell, against random places of the footprint.
        turns = np.linalg.inv(cell.shifts)
        uniform = centre + (rng.random((count * 4, 2)) - 0.5) @ edges
        waves = [np.exp(2j * np.pi * (at @ turns)) for at in (found, uniform)]
        assert np.abs((weights[:, None] * waves[0]).mean(axis=0) - waves[1].mean(axis=0)).max() < 0.012


def z_of(fabric: Fabric, count: int, seed: int) -> NDArray[np.float64]:
    """z of `samples` of 16 points for random parallelograms [n, 3], against uniform points of `point`.

    Footprints stay where they are, as chance differs elsewhere: edges that differ by rounding draw others.
    """
    asked, rng = random_cases(fabric, count, seed), np.random.default_rng(seed)

    def means(model: PointModel | SampledModel, repeats: int, spread: float) -> Means:
        lanes = np.repeat(np.arange(count), repeats)
        moved = spread * (rng.random((len(lanes), 1, 2)) - 0.5) @ asked.edges[lanes]
        edges = asked.edges[lanes] * (1 + 1e-5 * rng.uniform(-1, 1, (len(lanes), 1, 1)))
        footprint = footprints(asked.centres[lanes] + moved[:, 0], edges)
        view, light = (
            Array3f(np.ascontiguousarray(part[lanes].T, np.float32)) for part in (asked.views, asked.lights)
        )
        value = model.at(view, footprint).value(light).numpy().astype(np.float64)
        values = value.T.reshape(count, repeats, 3)
        return Means(values.mean(axis=1), values.var(axis=1, ddof=1) / repeats)

    return scores(
        means(SampledModel(fabric, SamplesOptions(points=16)), 256, 0.0),
        means(PointModel(fabric), 1 << 14, 1.0),
    )


@pytest.mark.parametrize("cloth", ["noisy twill", *(slow(name) for name in CLOTHS if name != "noisy twill")])
def test_means_are_the_references(cloth: str) -> None:
    z = z_of(fabric_from_text(CLOTHS[cloth]), 24, 5)
    # 24 cases of 3 colours that depend on each other: the deviation of the mean square is below .35.
    assert 0.3 < (z**2).mean() < 2.0
    assert holm(z, SIGNIFICANCE) == 0


def test_points_over_the_cell_scatter_far_less() -> None:
    satin, rng, count = fabric_from_text(CLOTHS["satin"]), np.random.default_rng(8), 4096
    edges = 3.5 * np.array([[0.9, 0.4], [-0.3, 1.0]])
    view, light = (np.array(v) / np.linalg.norm(v) for v in ((0.3, 0.2, 1.0), (-0.4, 0.5, 0.9)))
    variances = []
    for model in (PointModel(satin), SampledModel(satin, SamplesOptions(points=64))):
        centres = rng.uniform(-9, 9, (count, 2))
        footprint = footprints(centres, np.tile(edges, (count, 1, 1)))
        lanes = [dr.repeat(Array3f(*v.tolist()), count) for v in (view, light)]
        variances.append(model.at(lanes[0], footprint).value(lanes[1]).numpy()[0].var())
    # 64 independent points would have a 64th.
    assert variances[1] < variances[0] / 180
