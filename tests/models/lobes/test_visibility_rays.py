"""Samples of view hits, against all view rays."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.models.lobes.rays import (
    launch_rays,
    launch_views,
    top_down_samples,
    upload_cloth,
    view_samples,
)
from tests.helpers.fabrics import STRESSING

from .cloths import geometry_of

PER_FAMILY = 8


@pytest.mark.parametrize("name", STRESSING)
def test_view_samples_are_those_that_views_hit(name: str) -> None:
    """Fractions of families and holes are those of the rays that tables are made of."""
    geometry = geometry_of(name)
    cloth = upload_cloth(geometry, Float)
    views = launch_views(cloth, PER_FAMILY)
    seen = view_samples(views)
    rays = launch_rays(cloth, top_down_samples(cloth), views)
    hits = views.hits.is_warp.numpy()
    passing = np.zeros(len(hits), bool) if rays.view_is_null is None else rays.view_is_null.numpy()
    for back in (False, True):
        some, many = seen.back == back, (np.arange(len(hits)) >= len(hits) // 2) == back
        for actual, expected in (
            (seen.hole[some], passing[many]),
            ((seen.is_warp & ~seen.hole)[some], (hits & ~passing)[many]),
        ):
            # 4.5 deviations of random rays; these are even.
            bound = 4.5 * math.sqrt(0.25 / some.sum())
            assert abs(actual.mean() - expected.mean()) < bound
