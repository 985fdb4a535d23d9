"""Uneven threads: places stay near, move smoothly, repeat nowhere, and shaders move them alike."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm import Array2f, Float
from numpy.typing import NDArray

from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.variation import UNEVENNESS, Unevenness
from tests.helpers.slang import mapped

COUNT = 200_000


def fabric_of(warp: float, weft: float) -> Fabric:
    return fabric_from_text(f'weave = "plain"\n[warp]\nslub = {warp}\n[weft]\nslub = {weft}\n')


def unevenness_of(fabric: Fabric) -> Unevenness:
    layout = fabric.layout()
    return Unevenness(fabric.appearance(), (layout.warp.spacing.mean(), layout.weft.spacing.mean()))


def moved(fabric: Fabric, places: NDArray[np.float32]) -> NDArray[np.float64]:
    """Displacements [n, 2], millimetres."""
    return np.array(unevenness_of(fabric).place(Array2f(places.T)), np.float64).T - places


def random_places(side: float) -> NDArray[np.float32]:
    return np.random.default_rng(1).uniform(-side, side, (COUNT, 2)).astype(np.float32)


def test_even_yarns_stay() -> None:
    place = Array2f(Float([1.0]), Float([2.0]))
    assert unevenness_of(fabric_of(0, 0)).place(place) is place
    shift = moved(fabric_of(0.5, 0), random_places(50))
    assert (shift[:, 1] == 0).all()
    assert shift[:, 0].std() > 0


def test_displacements_are_small_and_have_mean_0() -> None:
    fabric = fabric_of(1, 0.25)
    spacing = np.array([fabric.layout().warp.spacing.mean(), fabric.layout().weft.spacing.mean()])
    share = moved(fabric, random_places(100)) / spacing / (UNEVENNESS * np.array([1, 0.5]))
    # The last digit of 100 mm is 4e-5 of a spacing.
    assert np.abs(share).max() <= 1 + 1e-3
    # Some ten thousand cells of independent corners.
    assert np.abs(share.mean(axis=0)).max() < 0.02
    assert share.std(axis=0).min() > 0.25


def test_threads_do_not_fold() -> None:
    """The draft's coordinate grows across the threads everywhere: none shows twice."""
    fabric = fabric_of(1, 1)
    places, step = random_places(20), np.float32(0.01)
    for axis in (0, 1):
        beyond = places.copy()
        beyond[:, axis] += step
        growth = (moved(fabric, beyond) - moved(fabric, places))[:, axis] / (beyond - places)[:, axis]
        assert growth.min() > -1


def test_neighbouring_repeats_differ() -> None:
    fabric = fabric_of(0.5, 0.5)
    places = random_places(20)
    beside = places + np.float32(np.array(fabric.repeat_mm))
    assert np.corrcoef(moved(fabric, places)[:, 0], moved(fabric, beside)[:, 0])[0, 1] < 0.5
    far = places + np.float32(40 * np.array(fabric.repeat_mm))
    assert abs(np.corrcoef(moved(fabric, places)[:, 0], moved(fabric, far)[:, 0])[0, 1]) < 0.05


@pytest.mark.slow
def test_shaders_move_places_alike() -> None:
    fabric, places = fabric_of(0.9, 0.1), random_places(50)[:10_000]
    found = mapped(
        "unevenness",
        "let place = uneven_place(fabric, float2(x, y));",
        "place.x; place.y",
        {"x": places[:, 0].copy(), "y": places[:, 1].copy()},
        (fabric.layout(), fabric.appearance()),
    )
    expected = np.array(unevenness_of(fabric).place(Array2f(places.T))).T
    # The last digits of 50 mm; corners of cells fall on either side.
    np.testing.assert_allclose(found, expected, atol=5e-5)
