"""Samplers of models: directions follow their density, weights are values over it, and no light is made.

Of single lobes the same is asked in test_lobes.py, of plugins of Mitsuba in test_bsdfs.py, of shaders in
test_shaders.py.

Covers: models/lobes/bsdf.py, models/neural/proposal.py, models/point.py
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import product

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.interface import Model
from loomlight.models.lobes.bsdf import LobesBsdf
from loomlight.models.lobes.model import LobesModel
from loomlight.models.registry import model_class, model_names
from loomlight.scattering.point import DirectionSample
from tests.helpers.arrays import numbers, vectors
from tests.helpers.chi_square import cell_counts, cell_shares, p_value
from tests.helpers.fabrics import STRESSING, TEXTS
from tests.helpers.model_answers import answers, built, close, drawn, every_model_once
from tests.helpers.queries import queries
from tests.marks import slow

require_llvm()

# Models and cloths: all of all, those that stress tables of groups, and yarns whose detail shows close up.
PAIRS = [(name, cloth) for name in model_names() for cloth in TEXTS]
PAIRS += [("lobes", cloth) for cloth in (*STRESSING, "white")]
PAIRS += [("point", "detailed"), ("lobes", "detailed")]
QUICK_WEIGHTS = {*product(("latent", "lobes", "neumip", "neural", "point"), ["plain"]), ("point", "detailed")}


@pytest.mark.parametrize(
    ("name", "cloth"), [pair if pair in QUICK_WEIGHTS else slow(*pair) for pair in PAIRS]
)
def test_weight_is_value_over_density(name: str, cloth: str) -> None:
    model = built(name, cloth)
    # Detail shows in footprints far below a thread.
    queried = queries(model.source, 1500, seed=7, smallest=0.002 if cloth == "detailed" else 0.1)
    actual = drawn(model, queried, seed=8)
    passes, pdf, weight = actual.is_null.numpy(), actual.pdf.numpy(), actual.weight.numpy()
    np.testing.assert_allclose(np.linalg.norm(actual.light.numpy(), axis=0), 1, atol=1e-4)
    assert np.isfinite(weight).all()
    assert (weight >= 0).all() or model_class(name).estimates
    again = answers(model, queried, actual.light)
    density, value, through = (part.numpy() for part in (again.pdf, again.value, again.through))
    smooth = ~passes & (density > 0)
    assert smooth.mean() > 0.5
    close(pdf[smooth], density[smooth])
    close(weight[:, smooth], value[:, smooth] / density[smooth])
    # Straight on means straight on, and the weight is the light that passes over the chance to be drawn.
    np.testing.assert_allclose(actual.light.numpy()[:, passes], -queried.view.numpy()[:, passes], atol=1e-5)
    # Rays are chosen that one of both kernels lets through.
    close(weight[0, passes] * pdf[passes], through[passes], lanes=len(queried))


@dataclass(frozen=True)
class Seen:
    """One footprint seen from one direction.

    Attributes:
        polar, azimuth: of the view, degrees; beyond 90° it sees the back.
        size: of the footprint's edges, in the unit of `side_of`.
        shift: of its centre, in the same unit.
        edges: both in units of the size.
    """

    polar: float
    azimuth: float
    size: float
    shift: float = 0.0
    edges: tuple[tuple[float, float], tuple[float, float]] = ((1.0, 0.2), (-0.1, 0.8))

    def query(self, model: Model, unit: float, count: int) -> tuple[Array3f, Footprint]:
        """View and footprint, `count` times. Opaque numbers: all cases of a model share their kernels."""

        def filled(*parts: float) -> list[Float]:
            return [dr.opaque(Float, float(part), count) for part in parts]

        polar, azimuth = math.radians(self.polar), math.radians(self.azimuth)
        view = (math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar))
        centre = 0.37 * np.asarray(model.source.repeat_mm) + self.shift * unit
        edges = (Array2f(*filled(*self.size * unit * np.asarray(edge))) for edge in self.edges)
        return Array3f(*filled(*view)), Footprint(Array2f(*filled(*centre)), *edges)

    def shares(self, model: Model, unit: float, points: int = 8) -> NDArray[np.float64]:
        """Integrals of the density over the cells of `chi_square.py`."""

        def density(lights: NDArray[np.float64]) -> NDArray[np.float64]:
            # Groups of lobes are found once for all lights.
            at = model.at(*self.query(model, unit, 1 if isinstance(model, LobesModel) else len(lights)))
            if isinstance(at, LobesBsdf):
                dr.eval(at.mixture)
            return at.pdf(vectors(lights)).numpy().astype(np.float64)

        return cell_shares(density, points)

    def draw(self, model: Model, unit: float, count: int, seed: int) -> DirectionSample:
        """So many directions."""
        actual = model.at(*self.query(model, unit, count)).sample(
            *numbers(np.random.default_rng(seed), count)
        )
        dr.eval(actual)
        return actual


@dataclass(frozen=True)
class Scan:
    """What a model is looked at by.

    Attributes:
        seen: by each, with a seed of its own.
        draws: directions of each.
        least: p-value that none may fall below; one so unlikely would turn up in one of a hundred runs of the
            suite, were the seeds not fixed.
        unit: of sizes, millimetres, of a model.
    """

    seen: tuple[Seen, ...]
    draws: int
    least: float
    unit: Callable[[Model], float]
    first_seed: int = 9


def shorter_side(model: Model) -> float:
    return float(min(model.source.repeat_mm))


def smallest_square(model: Model) -> float:
    """Of the pyramid of groups: below it `lobes` looks at points, above at groups, and about it at both."""
    assert isinstance(model, LobesModel)
    return model.tables.base_size


AZIMUTH = math.degrees(math.atan2(0.8, 0.6))
THREE = tuple(Seen(polar, AZIMUTH, size) for polar, size in ((25.0, 0.3), (70.0, 1.5), (140.0, 0.8)))
VIEWS = (0.0, 0.0), (35.0, 20.0), (60.0, 250.0), (84.0, 130.0), (140.0, 300.0)
GROUPED = tuple(Seen(*view, size) for view, size in product(VIEWS, (0.3, 1.0, 6.0)))
POINT = ((1.0, 0.0), (0.0, 1.0))
CLOSE = Seen(13.0, 297.0, 0.01, edges=POINT), Seen(65.0, 36.0, 0.01, edges=POINT)
SCANS = {
    "a view": Scan(THREE[:1], 20_000, 1e-3, shorter_side),
    "three views": Scan(THREE, 20_000, 2e-4, shorter_side),
    "all regimes": Scan(GROUPED, 8_000, 1e-4, smallest_square, 0),
    "close up": Scan(CLOSE, 100_000, 1e-4, lambda model: 1.0),
}
SCANNED = [(name, "plain", "a view") for name in ("latent", "neumip", "neural", "point")]
SCANNED += [("point", "detailed", "close up")]
SCANNED += [slow(name, cloth, "three views") for name in model_names() for cloth in TEXTS]
SCANNED += [slow("lobes", cloth, "all regimes") for cloth in (*STRESSING, "white")]


@pytest.mark.parametrize(("name", "cloth", "scan"), SCANNED)
def test_directions_are_distributed_by_their_density(name: str, cloth: str, scan: str) -> None:
    model, asked, values = built(name, cloth), SCANS[scan], []
    unit, count = asked.unit(model), asked.draws
    for seed, seen in enumerate(asked.seen, asked.first_seed):
        shares = seen.shares(model, unit)
        actual = seen.draw(model, unit, count, seed)
        passes, chance = actual.is_null.numpy(), actual.pdf.numpy()
        through = float(chance[passes].mean()) if passes.any() else 0.0
        if abs(shares.sum() + through - 1) > 3e-3:
            # A narrow lobe needs a finer rule.
            shares = seen.shares(model, unit, points=24)
        # The rule's error at the edge of a lobe is a few thousandths of a cell.
        assert abs(shares.sum() + through - 1) < 5e-3, seen
        np.testing.assert_allclose(chance[passes], through, rtol=1e-3)
        assert abs(passes.mean() - through) < 4.5 * math.sqrt(max(through, 1e-3) / count), seen
        counts = cell_counts(actual.light.numpy().T[~passes].astype(np.float64))
        values.append(p_value(counts, shares * count))
        assert values[-1] > asked.least, seen
    # p-values are uniform, so small faults of many cases show in their mean. Three standard deviations of it:
    # one of the five fabrics so far off would turn up in one run of a hundred, too. If every cell is wrong by
    # 5 %, up or down, that is found in 20 of 20 patterns; at four deviations in 2, as in 2 by one case alone.
    assert abs(np.mean(values) - 0.5) < 3 / math.sqrt(12 * len(values)), values


# Fabric, view, how much wider, how many threads away and how many degrees turned: of all directions 5 to 13 %
# would lie in other cells.
@pytest.mark.slow
@pytest.mark.parametrize(
    ("cloth", "view", "wider", "away", "turned"),
    [
        ("smooth satin", VIEWS[1], 1, 2, 0),
        ("long rib", VIEWS[1], 1, 2.5, 0),
        ("smooth satin", VIEWS[4], 8, 0, 0),
        ("smooth satin", VIEWS[3], 1, 0, 12),
    ],
)
def test_the_density_of_another_footprint_is_detected(
    cloth: str, view: tuple[float, float], wider: float, away: float, turned: float
) -> None:
    """The test above rejects a density that is slightly wrong."""
    model, seen = built("lobes", cloth), Seen(*view, 1.0)
    unit = smallest_square(model)
    actual = seen.draw(model, unit, 8_000, seed=0)
    counts = cell_counts(actual.light.numpy().T[~actual.is_null.numpy()].astype(np.float64))
    other = replace(seen, azimuth=view[1] + turned, size=wider, shift=away)
    for asked, passes in ((seen, True), (other, False)):
        shares = asked.shares(model, unit)
        value = p_value(counts, shares / shares.sum() * counts.sum())
        assert (value > 1e-4) == passes, value


@pytest.mark.quick("lobes-False", "point-False", "point-True", "neural-False")
@pytest.mark.parametrize("between_yarns", [False, True])
@every_model_once
def test_no_light_is_made(name: str, between_yarns: bool) -> None:
    model = built(name, "white", between_yarns)
    if not model.conserves_energy:
        pytest.skip("a learned model may return more than it gets, and says so")
    rng = np.random.default_rng(10)
    places, each = 64, 512
    queried = queries(model.source, places, seed=11)[np.repeat(np.arange(places), each)]
    weight = drawn(model, queried, seed=12).weight.numpy()[0].reshape(places, each)
    mean, error = weight.mean(axis=1), weight.std(axis=1) / math.sqrt(each)
    # 64 means of 512 weights, none of which may pass 5 deviations. How open a point is, is fitted: single
    # points are off by 0.03 of their D with a deviation of 0.2 (`openness.py`), their mean is not.
    room = 0.1 if between_yarns and not model.filters else 1e-4
    assert (mean <= 1 + 5 * error + room).all()
    assert mean.mean() <= 1 + 1e-4
    # White cloth sends back most of what it gets, or the bound above says nothing.
    assert mean.mean() > 0.5
    # The same light by uniform directions: what is drawn is all there is.
    lights = rng.normal(size=(len(queried), 3))
    queried.lights = lights / np.linalg.norm(lights, axis=1, keepdims=True)
    actual = answers(model, queried)
    value, through = (
        part.reshape(places, each) for part in (actual.value.numpy()[0], actual.through.numpy())
    )
    uniform = 4 * math.pi * value + through
    spread = np.sqrt(error**2 + uniform.var(axis=1) / each)
    assert (np.abs(uniform.mean(axis=1) - mean) < 5 * spread + 1e-3).all()
