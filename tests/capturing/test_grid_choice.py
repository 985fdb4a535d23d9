"""Of the grids that a photograph may show the true one is taken."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.capturing.grid_choice import likeliest_grid
from loomlight.capturing.photo import Photo, read_photo
from loomlight.capturing.photographer import Light, photograph, straight
from loomlight.capturing.thread_grid import find_grid
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric import fabric_from_text
from tests.capturing.pictures import knitted, save

# As in test_thread_grid.py.
TOLERANCE = 0.005
# Plied threads of one colour, whose grooves lie alike.
MERCERISED = """
weave = "twill 1/2 s"
yarn = "mercerised cotton"
ends_per_cm = 22
picks_per_cm = 23
[warp]
color = "#bbb886"
[weft]
color = "#bbb886"
"""


def photographed(encoded: NDArray[np.float64], folder: Path) -> Photo:
    return read_photo(save(folder / "photo.png", encoded), 20.0)


@pytest.mark.slow
def test_the_strongest_period_may_be_that_of_plies(tmp_path: Path) -> None:
    side, px_per_mm = 320, 32.0
    framing = straight((side, side), side / px_per_mm, 0.03)
    picture = photograph(fabric_from_text(MERCERISED), framing, Light(), 2)
    encoded = 0.9 * np.clip(linear_to_srgb(picture), 0, 1)
    px = 10 * px_per_mm / 22, 10 * px_per_mm / 23
    first = find_grid(encoded)
    assert abs(first.warp.per_px * px[0] - 1) > 0.1, "the strongest period is true: draw a harder cloth"
    seen, fit = likeliest_grid(photographed(encoded, tmp_path))
    assert 1 / seen.grid.warp.per_px == pytest.approx(px[0], rel=TOLERANCE)
    assert 1 / seen.grid.weft.per_px == pytest.approx(px[1], rel=TOLERANCE)
    assert fit.name == "twill 1/2 s"


def test_halves_of_loops_are_no_crossings(tmp_path: Path) -> None:
    """A knit whose loops are all alike shows V shapes, which on a grid of half the sett are a plain weave."""
    seen, fit = likeliest_grid(photographed(knitted(px=20.0), tmp_path))
    assert 1 / seen.grid.warp.per_px == pytest.approx(20.0, rel=TOLERANCE)
    assert fit.score < 0.1 * seen.crossings.votes
