"""The artworks of the examples: of the colours that their fabric files name, and woven as they say.

Covers: examples/makers/artwork.py
Covers: examples/makers/brocades.py
"""

from __future__ import annotations

import tomllib
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from examples.makers import artwork, brocades
from loomlight.fabric.read import load_fabric

FOLDER = artwork.OUTPUT
# Columns and rows of each picture.
SIZES = {
    "peonies": (artwork.WIDTH, artwork.HEIGHT),
    "waves": (artwork.WIDTH, artwork.HEIGHT),
    "jamdani": (brocades.JAMDANI.ends, brocades.JAMDANI.rows),
    "pomegranates": (brocades.POMEGRANATES.ends, brocades.POMEGRANATES.rows),
}


@pytest.mark.parametrize("name", SIZES)
def test_colours_are_those_of_the_fabric_file(name: str) -> None:
    fields = tomllib.loads((FOLDER / f"{name}.toml").read_text("utf-8"))
    with Image.open(FOLDER / f"{name}.png") as picture:
        assert picture.size == SIZES[name]
        counted = picture.convert("RGB").getcolors(256)
    assert counted is not None
    assert {f"#{red:02x}{green:02x}{blue:02x}" for _, (red, green, blue) in counted} == set(fields["weaves"])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "picks", "size_mm"),
    [
        ("peonies", 3600, (400, 900)),
        ("waves", 5008, (400, 900)),
        ("jamdani", 1018, (200, 225)),
        ("pomegranates", 2400, (640 / 4.8, 2400 / 10.8)),
    ],
)
def test_they_are_woven_without_a_warning(name: str, picks: int, size_mm: tuple[float, float]) -> None:
    """Of waves and of jamdani the extra weft has a pick in the rows alone that show it."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fabric = load_fabric(FOLDER / f"{name}.toml")
        fabric.appearance()
    assert (fabric.draft.ends, fabric.draft.picks) == (SIZES[name][0], picks)
    assert fabric.repeat_mm == pytest.approx(size_mm)


@pytest.mark.slow
def test_the_files_are_those_that_the_maker_writes(tmp_path: Path) -> None:
    artwork.main(tmp_path)
    brocades.main(tmp_path)
    for name in SIZES:
        made, kept = (np.asarray(Image.open(folder / f"{name}.png")) for folder in (tmp_path, FOLDER))
        # Sines differ in their last bits from machine to machine: some crossings on an edge.
        assert (made != kept).mean() < 1e-5
