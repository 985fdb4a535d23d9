"""Slices against brute force on the same grid points, and what their grids leave out.

Covers: aggregate/tables.py, aggregate/slices.py
"""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float
from scipy import stats

from loomlight.aggregate.components import CHANNELS
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from studies.instruments.reference import brute_force
from tests.helpers.directions import directions

from .fabrics import NAMES, woven

require_llvm()

PAIRS = 24
BOXES = 20
SAMPLES = 2048


def _boxes(rng: np.random.Generator, slices: FabricSlices, pairs: int, boxes: int) -> tuple[np.ndarray, ...]:
    """Boxes [pairs, boxes, 2] anywhere, from a texel to five repeats, neither square nor aligned."""
    extent = np.array([slices.grid.width, slices.grid.height])
    centres = rng.uniform(-3, 3, (pairs, boxes, 2)) * extent
    largest, smallest = np.log(5), np.log(1 / 128)
    size = np.exp(rng.uniform(smallest, largest, (pairs, boxes, 1)))
    return centres, size * extent * np.exp(rng.uniform(-0.5, 0.5, (pairs, boxes, 2)))


def _scores(name: str, roughness: tuple[float, float], seed: int) -> np.ndarray:
    """z-scores of one random channel of every query whose channel varies over its footprint."""
    rng = np.random.default_rng(seed)
    model = woven(name, roughness)
    slices = FabricSlices(model, Float)
    lights, views = directions(rng, PAIRS), directions(rng, PAIRS)
    pairs = np.stack([np.arange(PAIRS)] * 2, axis=1)
    centres, sizes = _boxes(rng, slices, PAIRS, BOXES)
    means = slices.box_means(lights, views, pairs, centres, sizes).reshape(-1, len(CHANNELS))
    estimate = brute_force(
        model,
        slices.grid,
        np.repeat(lights, BOXES, axis=0),
        np.repeat(views, BOXES, axis=0),
        centres.reshape(-1, 2),
        sizes.reshape(-1, 2),
        SAMPLES,
        seed,
        Float,
    )
    # The channels of one query depend on the same points; one is drawn among those that vary there. Where a
    # share of the footprint below 30 of the samples carries all of a channel, its mean is not yet normal.
    lit = (estimate.mean**2 > 30 * estimate.variance) & (estimate.variance > 1e-12)
    choice = np.where(lit, rng.random(lit.shape), -1).argmax(axis=1)
    chosen = np.arange(len(means)), choice
    constant = (estimate.variance <= 1e-12) & (sizes.reshape(-1, 2).max(axis=1) < 0.02)[:, None]
    # On walls the yarn's frame depends on where within its bracket the search ends, which the rounding of
    # either kernel decides: 2 of 306 differ.
    agree = np.isclose(means[constant], estimate.mean[constant], rtol=1e-3, atol=1e-4)
    assert agree.mean() > 0.98
    scores = (means - estimate.mean)[chosen] / np.sqrt(np.maximum(estimate.variance[chosen], 1e-30))
    return scores[lit.any(axis=1)]


@pytest.mark.slow
def test_slices_are_what_brute_force_finds_on_their_points() -> None:
    cases = [(name, (0.3, 0.15)) for name in NAMES] + [("satin 5/2", (0.06, 0.8))]
    scores = np.concatenate([_scores(name, alpha, seed) for seed, (name, alpha) in enumerate(cases)])
    assert len(scores) > 2000
    count = len(scores)
    # Four standard deviations of the mean and of the variance of a normal sample.
    assert abs(scores.mean()) < 4 / np.sqrt(count)
    assert abs(scores.var() - 1) < 4 * np.sqrt(2 / count)
    assert stats.kstest(scores, "norm").pvalue > 1e-3


def _totals(name: str, texels: int, back: bool, sizes: tuple[float, float]) -> np.ndarray:
    """f·cos at albedos 0.4 and 0.6 over squares of so many threads, log-uniform: [pairs, boxes]."""
    rng = np.random.default_rng(11)
    model = woven(name, (0.3, 0.15))
    slices = FabricSlices(model, Float, texels_per_thread=texels)
    lights, views = directions(rng, 24), directions(rng, 24, back)
    pairs = np.stack([np.arange(24)] * 2, axis=1)
    centres = rng.uniform(0, 1, (24, 64, 2)) * [slices.grid.width, slices.grid.height]
    threads = np.exp(rng.uniform(*np.log(sizes), (24, 64, 1))) * np.ones(2)
    means = slices.box_means(lights, views, pairs, centres, threads * min(model.surface.finest))
    return means[..., :4] @ [0.4, 0.4, 0.6, 0.6]


@pytest.mark.quick("plain-True")
@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("name", ["plain", "satin 5/2", "uneven"])
def test_half_the_step_changes_less_than_a_percent_from_a_quarter_yarn_up(name: str, back: bool) -> None:
    for sizes in ((0.25, 2.0), (2.0, 20.0)):
        coarse, fine = (_totals(name, texels, back, sizes) for texels in (32, 64))
        assert abs(coarse.mean() / fine.mean() - 1) < 0.003
        assert np.abs(coarse - fine).mean() < 0.01 * fine.mean()


def test_mapped_shadows_keep_the_means() -> None:
    rng = np.random.default_rng(3)
    model = woven("twill 3/1")
    lights, views = directions(rng, 12), directions(rng, 12)
    pairs = np.stack(np.meshgrid(np.arange(12), np.arange(12)), axis=-1).reshape(-1, 2)
    extent = np.array(model.surface.size)
    centres = rng.uniform(0, 1, (len(pairs), 32, 2)) * extent
    sizes = np.full_like(centres, 0.25 * extent.max())
    searched, mapped = (
        FabricSlices(model, Float, shadows=shadows).box_means(lights, views, pairs, centres, sizes)
        for shadows in ("searched", "mapped")
    )
    np.testing.assert_array_equal(searched[..., 4], mapped[..., 4])
    for channel in range(4):
        difference = mapped[..., channel] - searched[..., channel]
        scale = searched[..., channel].mean()
        assert abs(difference.mean()) < 0.01 * scale
        assert np.abs(difference).mean() < 0.03 * scale


def test_colours_are_the_components_times_the_albedos_where_threads_are_alike() -> None:
    rng = np.random.default_rng(4)
    model = woven("plain")
    for family in (model.appearance.warp, model.appearance.weft):
        for name in ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit"):
            getattr(family, name)[:] = getattr(family, name)[0]
    slices = FabricSlices(model, Float, with_colours=True)
    view = directions(rng, 1, back=True)[0]
    for light, side in (
        (directions(rng, 1, back=True)[0], "reflect"),
        (directions(rng, 1, back=False)[0], "transmit"),
    ):
        values = slices.slice(light, view).values
        families = model.appearance.warp, model.appearance.weft
        albedos = [getattr(f, f"diffuse_{side}")[0] for f in families]
        albedos += [getattr(f, f"specular_{side}")[0] for f in families]
        expected = np.einsum("kc,krx->crx", np.array(albedos), values[:4])
        np.testing.assert_allclose(values[5:], expected, rtol=1e-4, atol=1e-6)


def test_too_large_drafts_are_refused() -> None:
    model = woven("plain")
    with pytest.raises(InputError, match="16 million fit"):
        FabricSlices(model, Float, texels_per_thread=4000)


@pytest.mark.parametrize("light", [[0, 0, 0], [1, 0, 0], [0, 0, float("nan")]])
def test_directions_in_the_plane_are_refused(light: list[float]) -> None:
    with pytest.raises(InputError, match="do not lie in the cloth"):
        FabricSlices(woven("plain"), Float).slice(light, [0, 0, 1])
