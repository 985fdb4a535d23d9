"""Groups that come of halving, against formulas in double precision."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.lane_code import Vectors
from loomlight.models.lobes import parting as module
from loomlight.models.lobes.parting import LEARNT_FROM, Parting

PER_FAMILY = 8
# Coordinates are float32 about their mean, of which 2048 are added up.
ROUNDING = 1e-6


def centres_of(features: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    return Parting([features], count).centres([count])[0]


def cloud(count: int, seed: int) -> NDArray[np.float64]:
    rng = np.random.default_rng(seed)
    return rng.normal(size=(count, 6)) * [1, 0.5, 0.2, 0.6, 0.1, 0.1] + rng.normal(size=6)


def halves_by_numpy(points: NDArray[np.float64], count: int) -> tuple[NDArray[np.float64], float]:
    """Means of so many parts, halved as `Parting` says, and the mean squared distance from them."""

    def error(part: NDArray[np.float64]) -> float:
        return float(np.square(part - part.mean(axis=0)).sum())

    parts = [points]
    while len(parts) < count:
        widest = max(range(len(parts)), key=lambda number: error(parts[number]))
        part = parts[widest]
        offsets = part - part.mean(axis=0)
        along = offsets @ np.linalg.eigh(offsets.T @ offsets)[1][:, -1]
        at = 0.0
        for _ in range(4):
            at = 0.5 * (along[along > at].mean() + along[along <= at].mean())
        parts[widest] = part[along <= at]
        parts.append(part[along > at])
    return np.array([part.mean(axis=0) for part in parts]), sum(map(error, parts)) / len(points)


def in_order(centres: NDArray[np.float64]) -> NDArray[np.float64]:
    return centres[np.lexsort(centres.T)]


@pytest.mark.parametrize(("count", "groups"), [(100, 2), (2048, 2), (1500, 5), (2048, 12)])
def test_halves_are_those_of_double_precision(count: int, groups: int) -> None:
    points = cloud(count, count + groups).round(4)
    parting = Parting([points, cloud(50, 1)], 16)
    wanted, error = halves_by_numpy(points, groups)
    # A point or two near the middle of both halves go either way.
    np.testing.assert_allclose(in_order(parting.halves(0, groups)), in_order(wanted), atol=0.02)
    assert parting.error(0, groups) == pytest.approx(error, rel=1e-3)


def test_families_do_not_know_each_other() -> None:
    clouds = [cloud(2048, 7), cloud(3, 8), np.zeros((0, 6)), cloud(900, 9)]
    together = Parting(clouds, 12)
    counts = [12, 4, 2, 7]
    centres = together.centres(counts)
    for family, (points, count, found) in enumerate(zip(clouds, counts, centres, strict=True)):
        assert together.points_of(family) == len(points)
        alone = Parting([points], 12)
        np.testing.assert_array_equal(found, alone.centres([count])[0])
        assert together.error(family, count) == alone.error(0, count)


@pytest.mark.parametrize("lanes", [4, 8, 32])
def test_shorter_and_longer_vectors_part_alike(lanes: int, monkeypatch: pytest.MonkeyPatch) -> None:
    points = cloud(1000, 11)
    wanted = centres_of(points, PER_FAMILY)
    module._halving.cache_clear()
    module._means.cache_clear()
    try:
        with monkeypatch.context() as patch:
            patch.setattr(module, "vectors", lambda: Vectors(lanes, 16))
            found = centres_of(points, PER_FAMILY)
    finally:
        module._halving.cache_clear()
        module._means.cache_clear()
    # Sums in another order; a point between two groups may change sides.
    np.testing.assert_allclose(in_order(found), in_order(wanted), atol=0.01)


def test_as_many_groups_as_there_can_be() -> None:
    points = cloud(LEARNT_FROM, 12)
    parting = Parting([points], 128)
    centres = parting.centres([128])[0]
    assert len(np.unique(centres.round(6), axis=0)) == 128
    errors = [parting.error(0, count) for count in range(1, 129)]
    # Each halving lowers it.
    assert (np.diff(errors) < 0).all()
    with pytest.raises(ValueError, match="up to 2048 points are parted into up to 128 groups"):
        Parting([points], 129)
    with pytest.raises(ValueError, match="up to 2048 points"):
        Parting([cloud(LEARNT_FROM + 1, 1)], 8)


@pytest.mark.parametrize("count", [1, 100, 2047])
def test_fewer_different_points_than_groups(count: int) -> None:
    """Flat threads of one direction: one point, eight groups of it, whatever its mean is rounded to."""
    rng = np.random.default_rng(count)
    for point in ([0, 0, 0.5, 1, 0, 0.0], *rng.uniform(-1, 1, (200, 6)).round(4)):
        centres = centres_of(np.tile(point, (count, 1)), PER_FAMILY)
        np.testing.assert_allclose(centres, np.tile(point, (PER_FAMILY, 1)), atol=ROUNDING)


def test_halves_are_parted_where_points_part() -> None:
    """Four heaps of different size: each is a group, whatever the order of the points."""
    rng = np.random.default_rng(5)
    heaps = np.zeros((4, 6))
    heaps[:, :2] = [[0, 0], [1, 0.1], [0, 1.2], [1.1, 1]]
    heap = rng.permutation(np.repeat(np.arange(4), [300, 100, 50, 550]))
    features = heaps[heap] + 0.02 * rng.normal(size=(len(heap), 6))
    for order in (np.arange(len(heap)), rng.permutation(len(heap))):
        centres = centres_of(features[order], 4)
        for number in range(4):
            distance = np.linalg.norm(centres - features[heap == number].mean(axis=0), axis=1)
            # Coordinates are rounded to four digits.
            assert distance.min() < 1e-4


def test_groups_err_less_than_halves_alone_and_far_less_than_one() -> None:
    """Steps of k-means only lower the sum of squared distances."""
    rng = np.random.default_rng(6)
    features = rng.normal(size=(1000, 6)) * [1, 0.5, 0.2, 0.6, 0.1, 0.1]

    def error(centres: NDArray[np.float64]) -> float:
        return float(np.square(features[:, None] - centres).sum(axis=2).min(axis=1).mean())

    halved = Parting([features], 8)
    halves, found = halved.halves(0, 8), halved.centres([8])[0]
    assert error(found) < error(halves) < 0.5 * error(halved.halves(0, 1))
    # Until steps of k-means each point counts with its own half, near another's or not.
    assert error(halves) <= halved.error(0, 8) * (1 + ROUNDING)
