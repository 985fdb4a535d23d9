"""Query sets: seeded, stratified, on the sides that a fabric admits."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from loomlight.aggregate.queries import (
    MIN_COSINE,
    admits_transmission,
    fabric_scale,
    query_set,
    stratified_hemisphere,
)
from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text

TWILL = fabric_scale(fabric_from_text("twill 3/1").layout())


def test_sets_depend_on_seed_and_step_alone() -> None:
    one, same, later, other = (
        query_set(TWILL, 20, 30, seed, step) for seed, step in ((1, 2), (1, 2), (1, 3), (2, 2))
    )
    for name in ("lights", "views", "pairs", "centres", "sizes"):
        np.testing.assert_array_equal(getattr(one, name), getattr(same, name))
    for different in (later, other):
        assert not np.array_equal(one.centres, different.centres)
        assert not np.array_equal(one.lights, different.lights)


@pytest.mark.parametrize("count", [1, 2, 7, 64, 500])
def test_directions_fill_the_hemisphere_evenly(count: int) -> None:
    rng = np.random.default_rng(0)
    sets = [stratified_hemisphere(rng, count) for _ in range(max(2, 20_000 // count))]
    vectors = np.concatenate(sets)
    np.testing.assert_allclose(np.linalg.norm(vectors, axis=1), 1, rtol=1e-12)
    height = (vectors[:, 2] - MIN_COSINE) / (1 - MIN_COSINE)
    azimuth = np.arctan2(vectors[:, 1], vectors[:, 0]) / (2 * np.pi) % 1
    # Uniform alone and together; strata only make the statistic smaller.
    assert stats.kstest(height, "uniform").pvalue > 1e-3
    assert stats.kstest(azimuth, "uniform").pvalue > 1e-3
    counts = np.histogram2d(height, azimuth, bins=4)[0]
    assert np.abs(counts - counts.mean()).max() < 5 * np.sqrt(counts.mean())
    # One height in each of `count` layers.
    layers = np.sort(height[:count]) - (np.arange(count) + 0.5) / count
    assert np.abs(layers).max() <= 0.5 / count + 1e-12


@pytest.mark.parametrize(("transmits", "back"), [(False, False), (False, True), (True, False), (True, True)])
def test_sides_are_those_the_fabric_admits(transmits: bool, back: bool) -> None:
    queries = query_set(TWILL, 400, 3, 5, transmits=transmits, back=back, lights=40, views=100)
    light = queries.lights[queries.pairs[:, 0], 2]
    view = queries.views[queries.pairs[:, 1], 2]
    assert (view < 0).mean() == (0.5 if back else 0.0)
    assert (light * view < 0).mean() == pytest.approx(0.5 if transmits else 0.0, abs=0.01)
    # Dealt like cards: every direction serves as often as its fellows.
    uses = np.bincount(queries.pairs[:, 1], minlength=100)
    assert uses.min() == uses.max() == 4
    assert np.bincount(queries.pairs[:, 0], minlength=40).min() >= 10 - 1 if back else True


def test_footprints_are_log_uniform_and_anywhere() -> None:
    queries = query_set(TWILL, 50, 200, 6)
    low, high = TWILL.size_range
    assert low == pytest.approx(TWILL.repeat / 128)
    assert high == pytest.approx(5 * TWILL.repeat)
    share = np.log(queries.sizes / low) / np.log(high / low)
    assert stats.kstest(share.ravel(), "uniform").pvalue > 1e-3
    assert np.abs(np.sort(share, axis=1) - (np.arange(200) + 0.5) / 200).max() <= 0.5 / 200 + 1e-12
    for axis in (0, 1):
        place = queries.centres[..., axis] / TWILL.extent[axis]
        assert stats.kstest(place.ravel(), "uniform").pvalue > 1e-3


def test_long_repeats_begin_at_the_threads() -> None:
    scale = fabric_scale(fabric_from_text("satin 16/5").layout())
    assert scale.size_range[0] == pytest.approx(8 * scale.thread / 128)
    assert scale.size_range[1] == pytest.approx(5 * scale.repeat)


def test_bands_are_those_of_the_protocol() -> None:
    sizes = np.array([0.1, 0.24, 0.26, 1.9, 2.1, 3.9, 4.1, 20]) * TWILL.thread
    np.testing.assert_array_equal(TWILL.bands(sizes), [0, 0, 1, 1, 2, 2, 3, 3])
    plain = fabric_scale(fabric_from_text("plain").layout())
    # A repeat of two threads leaves no third band.
    assert 2 not in plain.bands(np.geomspace(*plain.size_range, 500))


def test_transmission_is_asked_of_the_threads() -> None:
    opaque = fabric_from_text('weave = "plain"\n[warp]\ntranslucency = 0.0\n[weft]\ntranslucency = 0.0')
    clear = fabric_from_text('weave = "plain"\n[warp]\ntranslucency = 0.0\n[weft]\ntranslucency = 0.2')
    assert not admits_transmission(opaque.appearance())
    assert admits_transmission(clear.appearance())


@pytest.mark.parametrize(
    "wrong",
    [{"pairs": 0}, {"footprints": 0}, {"lights": 1}, {"views": 1}],
    ids=lambda wrong: next(iter(wrong)),
)
def test_sets_of_nothing_are_refused(wrong: dict[str, int]) -> None:
    with pytest.raises(InputError, match="give at least"):
        query_set(TWILL, **{"pairs": 4, "footprints": 4, "seed": 0, **wrong})
