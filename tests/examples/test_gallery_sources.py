"""The gallery's sources: curves and maps repeat, and the files in git are those that the makers write.

Covers: examples/makers/jersey.py, examples/makers/corduroy.py, examples/makers/leather.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from examples.makers import corduroy, jersey, leather, merl_library
from loomlight.sources.heightfield import load_heightfield
from loomlight.sources.merl import load_merl
from loomlight.sources.tile import load_tile
from studies.instruments.fibre_tile import Curve

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize(("name", "write"), [("jersey", jersey.main), ("corduroy", corduroy.main)])
def test_tiles_in_git_are_those_that_are_made(
    name: str, write: Callable[[Path], None], tmp_path: Path
) -> None:
    """Numbers may differ by rounding: sines are not the same on all processors."""
    write(tmp_path)
    made, kept = (load_tile(folder / f"{name}.toml") for folder in (tmp_path, EXAMPLES / name))
    assert replace(made, files={}).__dict__ == replace(kept, files={}).__dict__
    assert made.files.keys() == kept.files.keys()
    for file, text in made.files.items():
        new, old = (np.array(held.split(), np.float64) for held in (text, kept.files[file]))
        np.testing.assert_allclose(new, old, atol=1.01e-3)
    # A clone stays small.
    assert sum(map(len, kept.files.values())) < 400_000


def _ends(curves: list[Curve]) -> list[np.ndarray]:
    return [points[-3:] - points[:3] for points, _ in curves]


def test_loops_and_ground_go_on_in_the_next_repeat() -> None:
    """Three control points at the end are those of the beginning, a repeat on: so are splines and slopes."""
    width = jersey.WALES * jersey.WALE_MM
    for stripe in jersey.jersey():
        np.testing.assert_allclose(_ends(stripe), np.full((len(stripe), 3, 3), [width, 0, 0]), atol=1e-9)
    sides = {(corduroy.RIB_MM, 0, 0), (0, corduroy.LENGTH_MM, 0)}
    found = {tuple(np.round(step, 9) + 0.0) for ends in _ends(corduroy.ground()) for step in ends}
    assert found == sides


def _refined(fibres: list[np.ndarray]) -> np.ndarray:
    """The middle line of some fibres [n, 3], with twenty times as many points."""
    line = np.mean(fibres, axis=0)
    places = np.linspace(0, len(line) - 1, 20 * len(line))
    return np.stack([np.interp(places, np.arange(len(line)), column) for column in line.T], axis=1)


def test_each_course_passes_through_the_one_below() -> None:
    """Its legs lie before that one's head where both cross, and its feet behind that one's legs."""
    lower, upper = (
        _refined(
            [
                points
                for stripe in jersey.jersey()
                for points, _ in stripe
                if abs(points[:, 1].mean() - (course + 0.5) * jersey.COURSE_MM) < 0.2
            ],
        )
        for course in (0, 1)
    )
    apart = np.linalg.norm(lower[:, None, :2] - upper[None, :, :2], axis=2)
    # The crossings of centre lines.
    first, second = np.nonzero(apart < 0.02)
    heights = lower[first, 2] - upper[second, 2]
    is_head = lower[first, 1] > jersey.COURSE_MM
    assert is_head.any()
    assert not is_head.all()
    assert (heights[is_head] < 0).all()
    assert (heights[~is_head] > 0).all()


def test_tips_of_the_pile_lie_on_its_outline() -> None:
    curves = [points for shade in corduroy.pile() for points, _ in shade]
    tips = np.array([points[-2] for points in curves])
    across = np.abs(tips[:, 0] / corduroy.RIB_MM - 0.5) * 2
    middle, side = tips[across < 0.2, 2].mean(), tips[across > 0.75, 2].mean()
    assert side < 0.7 * middle


def test_leather_in_git_is_what_is_made_and_repeats(tmp_path: Path) -> None:
    kept = load_heightfield(EXAMPLES / "leather" / "leather.toml")
    leather.main(tmp_path)
    (tmp_path / "leather.toml").write_bytes((EXAMPLES / "leather" / "leather.toml").read_bytes())
    made = load_heightfield(tmp_path / "leather.toml")
    # Half a step of 16 and of 8 bits more or less; sRGB's steepest slope is 12.92.
    np.testing.assert_allclose(made.height, kept.height, atol=1.1 / 65535)
    np.testing.assert_allclose(made.albedo, kept.albedo, atol=0.01)
    for axis in (0, 1):
        steps = np.abs(np.diff(kept.height, axis=axis, append=kept.height.take([0], axis)))
        assert np.take(steps, -1, axis).mean() < 2 * steps.mean()


def test_a_library_is_read_back(tmp_path: Path) -> None:
    merl_library.main(tmp_path / "library", 1)
    library = load_merl(tmp_path / "library")
    assert library.names == ("analytic-plastic-000",)
