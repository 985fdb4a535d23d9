"""Procedural variation: its numbers are uniform, unrelated and seeded, and it creates no light."""

from __future__ import annotations

import drjit as dr
import drjit.llvm.ad as jit
import numpy as np
import pytest
from scipy import stats

from loomlight.scattering.albedo import Albedos, albedos_from_colour, check_albedos, layer_albedo_bound
from loomlight.scattering.variation import (
    bounded_gain,
    fibre_gain,
    thread_gain,
    uniform_hash,
    vary_albedos,
)

THREADS, CELLS = 512, 512


def field(seed: int = 3) -> np.ndarray:
    """Uniform numbers [thread, cell]."""
    thread, cell = (grid.ravel().astype(np.uint32) for grid in np.indices((THREADS, CELLS)))
    value = uniform_hash(jit.UInt32(thread), jit.UInt32(cell), seed)
    return value.numpy().reshape(THREADS, CELLS).astype(float)


def test_numbers_are_uniform() -> None:
    values = field().ravel()
    assert values.min() > 0
    assert values.max() < 1
    observed = np.bincount((values * 1000).astype(int), minlength=1000)
    assert stats.chisquare(observed).pvalue > 1e-3


def test_numbers_do_not_repeat_along_threads_or_across() -> None:
    """The power spectrum of white noise is exponential with mean 1: no peak, no lattice."""
    noise = field() - 0.5
    power = np.abs(np.fft.rfft2(noise)) ** 2 / (noise.size / 12)
    power = power[1:, 1:-1].ravel()
    # The largest of n exponential variables: ln n, and a thousandth of all runs go beyond ln n + 7.
    assert power.max() < np.log(len(power)) + 7
    assert power.mean() == pytest.approx(1, abs=5 / np.sqrt(len(power)))


def test_neighbours_and_seeds_are_unrelated() -> None:
    first, other = field(3), field(4)
    # Correlation of independent numbers has the deviation 1/sqrt(n).
    limit = 4.5 / np.sqrt(first.size)
    for pair in (
        (first[1:], first[:-1]),
        (first[:, 1:], first[:, :-1]),
        (first[1:, 1:], first[:-1, :-1]),
        (first, first.T),
        (first, other),
    ):
        off_diagonal = ~np.eye(*pair[0].shape, dtype=bool)
        assert abs(np.corrcoef(pair[0][off_diagonal], pair[1][off_diagonal])[0, 1]) < limit
    np.testing.assert_array_equal(first, field(3))


def test_gains_have_mean_one() -> None:
    thread = dr.arange(jit.UInt32, 1 << 18)
    gain = fibre_gain(thread, thread // 7, 1.0, 5).numpy()
    # Exponential, cut at 10: mean 1 − e^{−10}, variance just below 1.
    assert gain.mean() == pytest.approx(1, abs=4 / np.sqrt(len(gain)))
    assert gain.max() <= 10
    assert stats.kstest(gain, "expon").pvalue > 1e-3
    half = fibre_gain(thread, thread // 7, 0.5, 5).numpy()
    np.testing.assert_allclose(half, 0.5 + 0.5 * gain, rtol=1e-5)
    colour = thread_gain(thread, 0.3, 5).numpy()
    assert colour.min() >= 0.7 - 1e-6
    assert colour.max() <= 1.3 + 1e-6
    assert colour.mean() == pytest.approx(1, abs=4 * 0.3 / np.sqrt(3 * len(colour)))
    assert np.all(fibre_gain(thread, thread, 0.0, 5).numpy() == 1)
    assert np.all(thread_gain(thread, 0.0, 5).numpy() == 1)
    # The two gains of a thread do not move together.
    assert abs(np.corrcoef(fibre_gain(thread, thread * 0, 1.0, 5).numpy(), colour)[0, 1]) < 4.5 / 2**9


def test_varied_albedos_stay_inside_the_bound() -> None:
    rng = np.random.default_rng(14)
    count, depth = 1 << 14, 2.0
    given = albedos_from_colour(rng.random((count, 3)), rng.random(count), rng.random(count), depth)
    colours = tuple(jit.Array3f(values.T.astype(np.float32)) for values in given)
    thread = dr.arange(jit.UInt32, count)
    varied = vary_albedos(colours, thread, thread + 9, (1.0, 1.0, jit.UInt32(7), layer_albedo_bound(depth)))
    rows = Albedos(*(np.minimum(values.numpy().T.astype(float), 1) for values in varied))
    assert all(values.numpy().max() < 1 + 1e-6 for values in varied)
    check_albedos(rows, "warp", depth)
    # It did vary, hue aside: channels share one gain.
    ratio = rows.specular_reflect / given.specular_reflect
    assert ratio.std() > 0.3
    np.testing.assert_allclose(ratio, ratio[:, :1].repeat(3, 1), rtol=1e-3)


def test_bounded_gain_is_finite_everywhere() -> None:
    gain, zero, one = jit.Float(10), jit.Array3f(0), jit.Array3f(1)
    assert bounded_gain(gain, zero, one).numpy()[0] == 10
    assert bounded_gain(gain, one, zero).numpy()[0] == 0
    assert bounded_gain(gain, one, one).numpy()[0] == 1
    assert bounded_gain(gain, jit.Array3f(0.5, 0.1, 0.1), one).numpy()[0] == pytest.approx(2)
    assert np.isfinite(bounded_gain(gain, zero, zero).numpy()).all()
