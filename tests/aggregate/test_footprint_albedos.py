"""Mean albedos over footprints from tables, against rays, against sums over a fine grid, and their bounds.

Covers: aggregate/tables.py
"""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Bool, Float
from numpy.typing import NDArray

from loomlight.aggregate import footprint_albedos
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.footprint import Box, Footprint, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout

from .colour_sums import ALBEDOS, ColourSums
from .fabrics import NAMES, woven

require_llvm()


def boxes(centres: NDArray[np.float64], sizes: NDArray[np.float64]) -> Footprint:
    centre, size = (Array2f(np.ascontiguousarray(part.T, np.float32)) for part in (centres, sizes))
    return box_footprint(Box(centre, size))


def means(
    model: YarnScattering, centres: NDArray[np.float64], sizes: NDArray[np.float64], back: bool
) -> NDArray[np.float32]:
    """[n, 2, 4, 3], as `ColourSums` has them."""
    actual = FootprintAlbedos(model.surface, model.appearance).over(boxes(centres, sizes), Bool(back))
    dr.eval(actual)
    parts = [[np.array(getattr(family, name)) for name in ALBEDOS] for family in actual]
    parts = [[np.broadcast_to(part, (3, len(centres))) for part in family] for family in parts]
    return np.moveaxis(np.array(parts), -1, 0)


def shown(
    model: YarnScattering, x: NDArray[np.float64], y: NDArray[np.float64], back: bool
) -> NDArray[np.int64]:
    """Thread that shows from straight above: 1 + end, −1 − pick, or 0 for a hole; from the point model."""
    point = model.surface.surface(Float(x.astype(np.float32)), Float(y.astype(np.float32)), Bool(back))
    warp = point.warp_thread.numpy().astype(np.int64) + 1
    weft = -1 - point.weft_thread.numpy().astype(np.int64)
    return np.where(point.hole.numpy(), 0, np.where(point.is_warp.numpy(), warp, weft))


@pytest.mark.parametrize("name", NAMES)
def test_tables_of_large_drafts_say_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their entries are read one by one, those of others with their neighbours: the same whole numbers."""
    rng = np.random.default_rng(2)
    model = woven(name)
    extent = np.array(model.surface.size)
    queries = rng.uniform(-2, 3, (2000, 2)) * extent, rng.uniform(0.05, 2.5, (2000, 2)) * extent
    actual = means(model, *queries, back=False)
    monkeypatch.setattr(footprint_albedos, "_MAX_PAIRED", 0)
    # Sums of the same floats in an order that compilers choose.
    np.testing.assert_allclose(means(model, *queries, back=False), actual, rtol=1e-5, atol=1e-6)


@pytest.mark.quick("twill 3/1-True", "plain-False")
@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("name", NAMES)
def test_means_are_those_of_a_fine_grid(name: str, back: bool) -> None:
    rng = np.random.default_rng(1)
    model = woven(name)
    extent = np.array(model.surface.size)
    centres = rng.uniform(-2, 3, (12, 2)) * extent
    sizes = np.exp(rng.uniform(math.log(0.05), math.log(2.5), (12, 2))) * extent
    actual = means(model, centres, sizes, back)
    step = (np.arange(400) + 0.5) / 400 - 0.5
    for centre, size, mean in zip(centres, sizes, actual, strict=True):
        x, y = np.meshgrid(centre[0] + step * size[0], centre[1] + step * size[1])
        thread = shown(model, x.ravel(), y.ravel(), back)
        for number, family in enumerate((model.appearance.warp, model.appearance.weft)):
            mine = np.abs(thread[thread > 0 if number == 0 else thread < 0]) - 1
            if len(mine) < 0.02 * thread.size:
                continue
            for albedo, name_of in enumerate(ALBEDOS):
                exact = getattr(family, name_of)[mine].mean(axis=0)
                # Rows of the grid move an edge by 1/800 of the box, a share 50 times as large of what shows.
                np.testing.assert_allclose(mean[number, albedo], exact, atol=0.02 * exact.max())


@pytest.mark.slow
@pytest.mark.parametrize("back", [False, True])
def test_straight_views_see_the_same(back: bool) -> None:
    rng = np.random.default_rng(2)
    for name in ("twill 3/1", "uneven"):
        model = woven(name)
        extent = np.array(model.surface.size)
        centres, sizes = rng.random((300, 2)) * extent, rng.uniform(0.2, 2, (300, 2)) * extent
        rays = ColourSums(model, [0, 0, -1.0 if back else 1.0], Float).over(centres, sizes)
        actual = means(model, centres, sizes, back)
        seen = rays.coverage > 0.05
        error = np.abs(actual - rays.albedos).max(axis=(2, 3))[seen]
        # The grid's texels are 1/32 thread: where one thread's edge is all that shows, they move the mean.
        assert error.mean() < 2e-3
        assert error.max() < 0.03


def test_oblique_views_shift_what_shows() -> None:
    """What parallax moves is not in the tables: threads that all differ are 10 % off at 60°."""
    rng = np.random.default_rng(3)
    model = woven("twill 3/1")
    extent = np.array(model.surface.size)
    centres, sizes = rng.random((300, 2)) * extent, np.full((300, 2), 0.5) * extent
    actual = means(model, centres, sizes, False)
    errors = []
    for degrees in (0, 30, 60):
        view = [math.sin(math.radians(degrees)) * 0.6, math.sin(math.radians(degrees)) * 0.8, 0]
        view[2] = math.cos(math.radians(degrees))
        rays = ColourSums(model, view, Float).over(centres, sizes)
        covered = rays.coverage[..., None, None] > 0.05
        scale = (rays.albedos * covered).sum() / covered.sum()
        errors.append((np.abs(actual - rays.albedos) * covered).sum() / covered.sum() / scale)
    assert errors[0] < 2e-3
    assert errors[0] < errors[1] < errors[2] < 0.12


def test_threads_alike_cost_nothing() -> None:
    layout = woven("plain").surface.layout
    grey = FamilyAppearance(*(np.full((2, 3), value) for value in (0.4, 0.1, 0.3, 0.2)), 0.3)
    tables = FootprintAlbedos(YarnGeometry(layout), Appearance(grey, grey))
    assert tables.bytes == 0
    centre = dr.zeros(Array2f, 5)
    warp, weft = tables.over(Footprint(centre, centre, centre), Bool(False))
    for albedos in (warp, weft):
        for name, value in zip(ALBEDOS, (0.4, 0.1, 0.3, 0.2), strict=True):
            np.testing.assert_allclose(np.array(getattr(albedos, name)).ravel(), value, rtol=1e-6)


def test_every_footprint_has_an_answer_within_its_threads() -> None:
    """Points, holes, gaps, places where a family is hidden, and footprints far away or of many repeats."""
    rng = np.random.default_rng(4)
    for name in NAMES:
        model = woven(name)
        extent = np.array(model.surface.size)
        sizes = np.exp(rng.uniform(math.log(1e-7), math.log(1e4), (3000, 1))) * extent
        centres = rng.uniform(-50, 50, (3000, 2)) * extent
        actual = means(model, centres, sizes, False)
        assert np.isfinite(actual).all()
        for number, family in enumerate((model.appearance.warp, model.appearance.weft)):
            for albedo, part in enumerate(ALBEDOS):
                rows = getattr(family, part)
                assert (actual[:, number, albedo] >= rows.min(axis=0) - 2e-3).all()
                assert (actual[:, number, albedo] <= rows.max(axis=0) + 2e-3).all()
        # Thousands of repeats have the mean of one.
        whole = means(model, extent[None] / 2, extent[None], False)[0]
        large = sizes[:, 0] > 2000 * extent[0]
        assert large.any()
        np.testing.assert_allclose(actual[large], np.broadcast_to(whole, actual[large].shape), atol=1e-3)


def test_the_repeat_does_not_show() -> None:
    model = woven("uneven")
    extent = np.array(model.surface.size)
    rng = np.random.default_rng(5)
    centres, sizes = rng.random((500, 2)) * extent, rng.uniform(0.05, 1, (500, 2)) * extent
    here, there = (means(model, centres + shift * extent, sizes, True) for shift in (0, np.array([3, -2])))
    np.testing.assert_allclose(here, there, atol=1e-4)


@pytest.mark.quick("641-3")
@pytest.mark.parametrize(("threads", "colours"), [(641, 3), (1024, 5000)])
def test_large_drafts(threads: int, colours: int) -> None:
    rng = np.random.default_rng(6)
    palette = rng.random((colours, 3))[rng.integers(0, colours, threads)]
    spacing = np.full(threads, 0.25)
    family = FamilyLayout(spacing, 0.8 * spacing, 0.4, 0.0, 1.0)
    layout = ClothLayout(rng.random((threads, threads)) < 0.4, family, family)
    albedos = FamilyAppearance(0.3 * palette, 0.2 * palette**2, 0.4 * palette, 0.1 * palette, 0.3)
    model = YarnScattering(YarnGeometry(layout), Appearance(albedos, albedos))
    tables = FootprintAlbedos(model.surface, model.appearance)
    assert tables.bytes < 70e6
    assert tables.truncation < 1e-6
    # A single thread close to the end of the repeat: where sums are largest and boxes smallest.
    count = 400
    place = threads - 1 - rng.integers(0, 40, (count, 2))
    actual = means(model, (place + 0.5) * 0.25, np.full((count, 2), 0.05), False)
    on_top = layout.warp_on_top[place[:, 1], place[:, 0]]
    assert 0.2 < on_top.mean() < 0.6
    for number, threads_of in ((0, place[:, 0]), (1, place[:, 1])):
        visible = on_top if number == 0 else ~on_top
        exact = albedos.diffuse_reflect[threads_of]
        np.testing.assert_allclose(actual[visible, number, 0], exact[visible], atol=1e-3)
        # Hidden threads answer too.
        np.testing.assert_allclose(actual[~visible, number, 0], exact[~visible], atol=1e-2)
