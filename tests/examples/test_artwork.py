"""The artworks of the examples: of the colours that their fabric files name, and woven as they say.

Covers: examples/makers/artwork.py
"""

from __future__ import annotations

import tomllib
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from examples.makers import artwork
from loomlight.fabric.read import load_fabric

FOLDER = artwork.OUTPUT


@pytest.mark.parametrize("name", ["peonies", "waves"])
def test_colours_are_those_of_the_fabric_file(name: str) -> None:
    fields = tomllib.loads((FOLDER / f"{name}.toml").read_text("utf-8"))
    with Image.open(FOLDER / f"{name}.png") as picture:
        assert picture.size == (artwork.WIDTH, artwork.HEIGHT)
        counted = picture.convert("RGB").getcolors(256)
    assert counted is not None
    assert {f"#{red:02x}{green:02x}{blue:02x}" for _, (red, green, blue) in counted} == set(fields["weaves"])


@pytest.mark.slow
@pytest.mark.parametrize(("name", "picks"), [("peonies", 3600), ("waves", 5008)])
def test_they_are_woven_without_a_warning(name: str, picks: int) -> None:
    """Of waves the extra weft has a pick in the rows alone that show it."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fabric = load_fabric(FOLDER / f"{name}.toml")
        fabric.appearance()
    assert (fabric.draft.ends, fabric.draft.picks) == (2400, picks)
    assert fabric.repeat_mm == pytest.approx((400, 900))


@pytest.mark.slow
def test_the_files_are_those_that_the_maker_writes(tmp_path: Path) -> None:
    artwork.main(tmp_path)
    for name in ("peonies", "waves"):
        made, kept = (np.asarray(Image.open(folder / f"{name}.png")) for folder in (tmp_path, FOLDER))
        # Sines differ in their last bits from machine to machine: some crossings on an edge.
        assert (made != kept).mean() < 1e-5
