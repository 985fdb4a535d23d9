"""Positions of samples: even over the crossings, and within them."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Float, UInt32

from loomlight.core.backend import array_types
from loomlight.models.lobes.rays import SamplePositions
from tests.helpers.fabrics import STRESSING

from .cloths import geometry_of


def test_positions_are_even_over_crossings_and_within_them() -> None:
    geometry = geometry_of("long rib")
    count = 4096
    lane = dr.arange(UInt32, 3 * count)
    x, y = SamplePositions(geometry, array_types(Float)).at(lane % count, lane // count)
    places = np.stack([x.numpy(), y.numpy()], axis=1).reshape(3, count, 2)
    picks, ends = geometry.layout.warp_on_top.shape
    for some in places:
        crossing = some / geometry.size * [ends, picks]
        assert (crossing >= 0).all()
        assert (crossing <= [ends, picks]).all()
        within = crossing % 1.0
        for values, cells in ((crossing, (ends, picks)), (within, (8, 8))):
            upper = (ends, picks) if values is crossing else (1, 1)
            counts = np.histogram2d(*values.T, bins=cells, range=[[0, side] for side in upper])[0]
            expected = count / counts.size
            # Random places would deviate three or four times as much in the worst of these cells.
            assert np.abs(counts - expected).max() < 2 * math.sqrt(expected)
    # Sets differ.
    assert not np.isclose(places[0], places[1]).any(axis=1).all()


@pytest.mark.parametrize("name", STRESSING)
def test_lattices_measure_families_with_less_noise(name: str) -> None:
    """The share of a family, seen from above by as many points as a node has rays, over many sets."""
    geometry = geometry_of(name)
    count, sets = 512, 128
    lane = dr.arange(UInt32, sets * count)
    index, number = lane % count, lane // count
    positions = SamplePositions(geometry, array_types(Float))
    places = positions.at(index, number), positions.in_lattice(index, count, number)
    shares = []
    for x, y in places:
        assert (x.numpy() >= 0).all()
        assert (x.numpy() <= geometry.size[0]).all()
        assert (y.numpy() >= 0).all()
        assert (y.numpy() <= geometry.size[1]).all()
        point = geometry.surface(x, y, False)
        shares.append((point.is_warp & ~point.hole).numpy().reshape(sets, count).mean(axis=1))
    even, lattice = shares
    # Means to three of their deviations. Deviations of 128 sets are known to 6 %; quotients are 0.21 to 0.54.
    assert abs(even.mean() - lattice.mean()) < 3 * (even.std() + lattice.std()) / math.sqrt(sets)
    assert lattice.std() < 0.65 * even.std()
