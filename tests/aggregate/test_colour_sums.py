"""Coverage and mean albedos over footprints, against the rays themselves."""

from __future__ import annotations

import numpy as np
from drjit.llvm.ad import Array2f64, Float

from loomlight.aggregate.slices import FabricSlices
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from studies.instruments.reference import reference
from tests.helpers.directions import directions

from .colour_sums import ColourSums
from .fabrics import woven

require_llvm()


def test_coverage_is_what_holes_leave() -> None:
    rng = np.random.default_rng(0)
    model = woven("twill 3/1")
    view = directions(rng, 1)[0]
    extent = np.array(model.surface.size)
    centres, sizes = rng.random((40, 2)) * extent, rng.uniform(0.1, 2, (40, 2)) * extent
    actual = ColourSums(model, view, Float).over(centres, sizes)
    boxes = box_footprint(Box(Array2f64(centres.T.copy()), Array2f64(sizes.T.copy())))
    estimate = reference(model, boxes, view, view, 4000, seed=1)
    spread = 5 * np.sqrt(estimate.variance[:, 4]) + 5e-3  # and the grid's own error
    assert (np.abs(1 - actual.coverage.sum(axis=1) - estimate.hole) < spread).all()


def test_albedos_of_threads_alike_are_those_of_the_threads() -> None:
    model = woven("plain")
    for family in (model.appearance.warp, model.appearance.weft):
        family.diffuse_reflect[:] = family.diffuse_reflect[0]
    actual = ColourSums(model, [0.3, 0.1, 0.9], Float).over([[0.1, 0.2]], [[0.7, 0.5]])
    for index, family in enumerate((model.appearance.warp, model.appearance.weft)):
        np.testing.assert_allclose(actual.albedos[0, index, 0], family.diffuse_reflect[0], rtol=1e-5)


def test_components_with_mean_albedos_come_near_the_exact_colours() -> None:
    rng = np.random.default_rng(2)
    model = woven("basket 2/2")
    extent = np.array(model.surface.size)
    light, view = directions(rng, 1, False)[0], directions(rng, 1, False)[0]
    centres, sizes = rng.random((200, 2)) * extent, rng.uniform(0.1, 1, (200, 1)) * np.ones(2) * extent
    colours = ColourSums(model, view, Float).over(centres, sizes)
    means = FabricSlices(model, Float, with_colours=True).slice(light, view).box_means(centres, sizes)
    diffuse = np.einsum("nf,nfc->nc", means[:, 0:2], colours.albedos[:, :, 0])
    specular = np.einsum("nf,nfc->nc", means[:, 2:4], colours.albedos[:, :, 2])
    one_mean = np.concatenate([model.appearance.warp.diffuse_reflect, model.appearance.weft.diffuse_reflect])
    flat = means[:, 0:2].sum(axis=1)[:, None] * one_mean.mean(axis=0)
    flat = flat + means[:, 2:4].sum(axis=1)[:, None] * one_mean.mean(axis=0) * 4 / 3
    exact = means[:, 5:]
    near, far = (np.abs(guess - exact).mean() / exact.mean() for guess in (diffuse + specular, flat))
    # Shade and colour still correlate within a family; every thread here has a colour of its own.
    assert near < 0.15
    assert near < far / 2
