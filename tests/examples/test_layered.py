"""The files of layered drafts are those that their maker writes, and read back as the same cloth.

Covers: examples/makers/layered.py
"""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np

from examples.makers.layered import DRAFTS, main
from loomlight.core.errors import LoomlightWarning
from loomlight.weave import load_draft

FOLDER = Path(__file__).parents[2] / "examples" / "layered"


def test_files_are_those_that_the_maker_writes(tmp_path: Path) -> None:
    main(tmp_path)
    made = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    assert made == {file.name: file.read_bytes() for file in FOLDER.iterdir()}
    assert len(made) == len(DRAFTS) == 10


def test_files_hold_the_lifting_plans() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        for make in DRAFTS:
            draft, read = make(), load_draft(FOLDER / f"{make.__name__.replace('_', '-')}.wif")
            np.testing.assert_array_equal(read.drawdown, draft.drawdown)
            assert read.title == draft.title
