"""Yarns are fitted to a repeat.

Covers: capturing/yarn_fit.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.capturing.photographer import Light
from loomlight.capturing.tile import Tile, rendered
from loomlight.capturing.yarn_fit import Cloth, YarnFitter, even_fabric, yarns_of_kind
from loomlight.weave.named import named_weave


@pytest.mark.slow
def test_colours_that_the_repeat_does_not_show_stay_as_they_were() -> None:
    """A stripe of many colours is fitted by a part of its threads, which may lack some of them."""
    draft, light = named_weave("plain"), Light()
    warp = np.array([[0.3, 0.1, 0.1], [0.1, 0.3, 0.1], [0.1, 0.1, 0.3]])
    weft = np.full((1, 3), 0.5)
    cloth = Cloth(draft, (np.array([0, 0]), np.array([0, 0])), (3, 1), (20.0, 20.0))
    shown = rendered(even_fabric(cloth, yarns_of_kind("cotton", (warp, weft))), (8, 8), light)
    tile = Tile(shown, np.ones(shown.shape[:2]), np.zeros(shown.shape[:2]), (8, 8))
    fitter = YarnFitter(cloth, tile, light)
    fit = fitter.improved(fitter.begun("cotton", (warp, weft)), apart=False, steps=1)
    assert fit.yarns.colours[0][1:] == pytest.approx(warp[1:])
    assert fit.cost < 1e-3  # of the picture that the same yarns made
