"""The coverage pyramid: its levels, its size, and sums of coverage."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.models.lobes.coverage import spacing_of
from loomlight.models.lobes.hemisphere import pack_count
from loomlight.models.lobes.model import LobesModel, LobesOptions
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.fabrics import STRESSING

from .cloths import geometry_of, pyramid_of, random_cloth

PER_FAMILY = 8


def test_levels_are_a_pyramid() -> None:
    for name in STRESSING:
        geometry = geometry_of(name)
        coverage = pyramid_of(geometry, PER_FAMILY)[1]
        first, columns, rows = coverage.levels.T
        assert (first == np.concatenate([[0], np.cumsum(columns * rows)[:-1]])).all()
        assert (columns[1:] == -(-columns[:-1] // 2)).all()
        assert (rows[1:] == -(-rows[:-1] // 2)).all()
        assert (columns[-1], rows[-1]) == (1, 1)
        assert coverage.bytes.shape == (2, (columns * rows).sum(), 4 * (pack_count(PER_FAMILY) + 1))
        # Nodes of the first level lie a third of its squares apart or less.
        assert columns[0] * coverage.base_size >= 3 * geometry.size[0] * (1 - 1e-6)


@pytest.mark.slow
def test_repeats_of_sixteen_threads_are_small() -> None:
    for groups in (8, 64):
        assert (
            LobesModel.for_source(random_cloth(16, 16), LobesOptions(groups=groups)).tables.nbytes < 2_000_000
        )


@pytest.mark.slow
def test_the_largest_drafts_stay_bounded() -> None:
    """641 × 641 crossings, all different."""
    cloth = random_cloth(641, 641)
    assert LobesModel.for_source(cloth).tables.nbytes < 64_000_000
    geometry = YarnGeometry(cloth.layout())
    assert spacing_of(geometry, PER_FAMILY).base_size < 3 * geometry.size[0] / 641
    # A small draft has the smallest squares there are.
    small = YarnGeometry(random_cloth(16, 16).layout())
    assert spacing_of(small, PER_FAMILY).base_size == pytest.approx(small.size[0] / 16)


@pytest.mark.parametrize(
    "text",
    [
        # Three nodes where two and a bit would do, and 80 where 66 would: squares are many cells wide.
        'weave = "plain"\nends_per_cm = 80\npicks_per_cm = 10\n',
        'weave = "plain"\nends_per_cm = 10\npicks_per_cm = 200\n',
        'weave = "twill 19/3"\n',
    ],
)
def test_no_group_counts_less_than_nothing(text: str) -> None:
    """As a byte it would count as much as all there is."""
    coverage = pyramid_of(YarnGeometry(fabric_from_text(text).layout()), PER_FAMILY)[1]
    shares = (coverage.bytes * coverage.scale[:, None] / 255).sum(axis=-1)
    # Each of 17 bytes is off by half a 255th of the group's largest share.
    np.testing.assert_allclose(shares, 1, atol=2e-2)
