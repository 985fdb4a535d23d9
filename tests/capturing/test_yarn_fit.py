"""Yarns are fitted to a repeat.

Covers: capturing/yarn_fit.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.capturing.photographer import Light
from loomlight.capturing.tile import Tile, rendered
from loomlight.capturing.yarn_fit import (
    PARAMETERS,
    Cloth,
    Fit,
    YarnFitter,
    even_fabric,
    with_model_errors,
    yarns_of_kind,
)
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


def test_bounds_reach_to_kinds_of_yarn_that_look_alike() -> None:
    """Two kinds that leave as much are half of their difference from their mean; a far one counts little."""
    colours = np.full((1, 3), 0.5)

    def of_kind(kind: str, cost: float) -> Fit:
        return Fit(yarns_of_kind(kind, (colours, colours)), cost, colours, {"roughness": (0.1, 0.2)})

    alike = [of_kind("cotton", 1e-4), of_kind("mercerised cotton", 1e-4)]
    fit = with_model_errors(alike[0], [*alike, of_kind("silk", 1e-2)])
    apart = np.log([kind.yarns.numbers["roughness"][0] for kind in alike])
    error = np.sqrt(0.25 * (apart[0] - apart[1]) ** 2 + PARAMETERS["roughness"].misfit ** 2)
    value = fit.yarns.numbers["roughness"][1]
    low, high = fit.bounds("roughness", 1)
    # Of a normal distribution 90 % lie within 1.645 deviations.
    assert np.log(high / value) == pytest.approx(1.645 * np.hypot(0.2, error), rel=1e-6)
    assert np.log(value / low) == pytest.approx(np.log(high / value))
