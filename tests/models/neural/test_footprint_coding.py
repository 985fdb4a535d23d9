"""Levels of the latent field: weights sum to 1, ramps are interpolated, means are centred correctly."""

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.neural.encoded_fabric import (
    FINEST_LEVEL,
    AnisotropicTaps,
    levels_of,
    taps,
    taps_of_footprint,
)

torch = pytest.importorskip("torch")
require_llvm()


def _fetched(table: np.ndarray, picks: int, ends: int, *footprint: np.ndarray) -> np.ndarray:
    index, weight = taps(levels_of(picks, ends), *(np.asarray(part, np.float32) for part in footprint))
    return (table[index] * weight).sum(1)


@pytest.mark.parametrize(("picks", "ends"), [(2, 2), (5, 8), (10, 5)])
def test_weights_add_up_and_texels_exist(picks: int, ends: int) -> None:
    rng = np.random.default_rng(picks)
    x, y = rng.uniform(-20, 40, (2, 500))
    size = np.exp(rng.uniform(np.log(0.005), np.log(200), 500))
    levels = levels_of(picks, ends)
    index, weight = taps(levels, *(part.astype(np.float32) for part in (x, y, size)))
    last = levels[-1].first + levels[-1].columns * levels[-1].rows
    assert index.min() >= 0
    assert index.max() < last
    # float32 coordinates up to 40·8 texels have 2e-5 of a texel.
    np.testing.assert_allclose(weight.sum(1), 1, atol=1e-5)
    assert weight.min() >= -1e-5


def test_small_footprints_read_the_finest_level_where_they_lie() -> None:
    picks, ends = 4, 6
    levels = levels_of(picks, ends)
    finest = levels[0]
    table = np.zeros(levels[-1].first + 1, np.float32)
    column = np.arange(finest.columns)
    table[: finest.columns * finest.rows] = np.tile((column + 0.5) / finest.per_thread, finest.rows)
    x = np.linspace(0.5, 5.5, 40)
    actual = _fetched(table, picks, ends, x, np.full(40, 1.3), np.full(40, 0.01))
    np.testing.assert_allclose(actual, x, atol=1e-5)


@pytest.mark.parametrize("window", [2, 4, 8])
def test_running_means_of_a_wave_are_those_of_boxes(window: int) -> None:
    """The encoder's pooling and a footprint's taps agree on the centre of a mean."""
    from studies.papers.chen2024.training.network import _wider

    ends = 16
    thread = np.arange(ends)
    wave = np.cos(2 * np.pi * (thread + 0.5) / ends).astype(np.float32)
    means = torch.from_numpy(np.tile(wave, (4, 1)))[None, None]
    wide = 2
    while wide <= window:
        means = _wider(means, wide)
        wide *= 2
    levels = levels_of(4, ends)
    level = levels[FINEST_LEVEL + window.bit_length() - 1]
    assert level.window == window
    table = np.zeros(levels[-1].first + 1, np.float32)
    table[level.first : level.first + level.columns * level.rows] = means.numpy().ravel()
    x = thread.astype(np.float64)
    actual = _fetched(table, 4, ends, x, np.full(ends, 1.0), np.full(ends, float(window)))
    index = (thread[:, None] + np.arange(-window // 2, window // 2)) % ends
    np.testing.assert_allclose(actual, wave[index].mean(1), atol=1e-5)


def _steps(first: list[float], second: list[float], least: float) -> tuple[float, np.ndarray, np.ndarray]:
    footprint = Footprint(Array2f(0), Array2f(*first), Array2f(*second))
    side, *steps = taps_of_footprint(footprint, least)
    return float(side.numpy()[0]), *(np.array(step).ravel() for step in steps)


def test_compact_footprints_have_two_taps_along_either_edge() -> None:
    side, first, second = _steps([3.0, 1.0], [-1.5, 2.5], 1.0)
    np.testing.assert_allclose(first, [0.75, 0.25], rtol=1e-6)
    np.testing.assert_allclose(second, [-0.375, 0.625], rtol=1e-6)
    # Twelve variances: those of the edges, summed over both axes.
    total = 3.0**2 + 1 + 1.5**2 + 2.5**2
    assert 2 * side**2 + 12 * (first @ first + second @ second) == pytest.approx(total, rel=1e-5)


def test_taps_below_a_thread_are_not_divided() -> None:
    side, first, second = _steps([1.5, 0.0], [0.0, 1.5], 1.0)
    assert side == pytest.approx(1.5)
    assert not first.any()
    assert not second.any()
    # Long footprints have their row at any size.
    _, first, second = _steps([0.2, 0.0], [0.0, 1.0], 1.0)
    assert first[1] > 0
    np.testing.assert_allclose(second, first / 2, atol=1e-7)


def test_taps_vanish_where_threads_alias_with_pixels() -> None:
    """Waves with an odd number of periods along an edge are 0 over the pixel, and over its taps."""
    edges = np.array([[2.2, 2.2], [-2.2, 2.2]])
    side, first, second = _steps(*edges.tolist(), 1.0)
    for periods in ((1, 0), (0, 1), (1, 1), (1, -1), (3, 0)):
        wave = np.linalg.solve(edges, periods)
        places = np.cos(2 * np.pi * (first @ wave)) * np.cos(2 * np.pi * (second @ wave))
        assert abs(places * np.prod(np.sinc(side * wave))) < 1e-6
    # One square of the same variance lets an eighth of the first ones through.
    wave = np.linalg.solve(edges, (1, 0))
    assert abs(np.prod(np.sinc(np.hypot(2.2, 2.2) * wave))) > 0.12


def test_the_size_is_that_of_all_taps() -> None:
    footprint = Footprint(Array2f(0), Array2f(0, 3), Array2f(-3, 0))
    side, first, second = taps_of_footprint(footprint, 1.0)
    found = AnisotropicTaps(0, 0, side, first.x, first.y, second.x, second.y).size(dr)
    np.testing.assert_allclose(found.numpy(), 3, rtol=1e-5)
