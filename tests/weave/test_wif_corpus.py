"""Files of other programs, and an independent reader, as judges of ours."""

import io
import re
import warnings
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from dtx_to_wif import make_liftplan
from dtx_to_wif import read_wif as independent_read

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave import Draft, named_weave, read_wif
from loomlight.weave.wif_reader import draft_of
from loomlight.weave.wif_text import parse_wif_text
from loomlight.weave.wif_writer import wif_text_of

from .conftest import corpus
from .test_wif import assert_same

# Section, key and value that are at fault in each bad file, found by reading it.
FAULTS = {
    "default-warp-color-too-big": "[WARP] Color=11 ",
    "default-warp-color-too-small": "[WARP] Color=0 ",
    "default-weft-color-too-big": "[WEFT] Color=11 ",
    "default-weft-color-too-small": "[WEFT] Color=0 ",
    "missing-liftplan": "[LIFTPLAN] is missing",
    "missing-tieup": "[TREADLING] 1=6 needs the section [TIEUP], which is missing",
    "missing-treadling": "[TIEUP] 1=1,2,3 needs the section [TREADLING], which is missing",
    "missing_color_table_warp": "[WARP COLORS] 1=3 names a colour of [COLOR TABLE]",
    "missing_color_table_weft": "[WEFT COLORS] 1=3 names a colour of [COLOR TABLE]",
    "too-many-treadles-in-treadline": "[TREADLING] 1=1,6,7 presses treadle 7",
    "warp_color-too-big": "[WEFT COLORS] 6=11 ",
    "warp_color-too-small": "[WARP COLORS] 1=0 ",
    "weft_color-too-big": "[WEFT COLORS] 1=11 ",
    "weft_color-too-small": "[WARP COLORS] 4=0 ",
}


def independent_drawdown(text: str, shape: tuple[int, int]) -> np.ndarray:
    """What dtx_to_wif makes of the file, as far as its threads go."""
    pattern = independent_read(io.StringIO(text))
    # It stops at a treadle that is pressed and tied to nothing.
    pattern.tieup = defaultdict(set, pattern.tieup)
    lifts = make_liftplan(pattern)
    return np.array(
        [
            [
                bool(pattern.threading.get(end, set()) & lifts.get(pick, set())) == pattern.is_rising_shed
                for end in range(1, shape[1] + 1)
            ]
            for pick in range(1, shape[0] + 1)
        ]
    )


def read_silently(file: Path) -> Draft:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return read_wif(file)


# Whose threads are thicker than their spacing.
_THICK = ("2229", "41753")


@pytest.mark.parametrize("file", corpus("good"))
@pytest.mark.filterwarnings("ignore::UserWarning")  # the other reader's own
def test_good_files_load_silently_and_as_another_reader_has_them(file: Path) -> None:
    if file.stem in _THICK:
        with pytest.warns(LoomlightWarning, match=r"54\.1 ends/cm, 0\.185 mm apart and 0\.213 mm thick"):
            draft = read_wif(file)
    else:
        draft = read_silently(file)
    assert np.array_equal(draft.drawdown, independent_drawdown(file.read_text(), draft.drawdown.shape))


@pytest.mark.parametrize("file", [*corpus("good"), *corpus("warn")])
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning", "ignore::UserWarning")
def test_files_survive_writing(file: Path) -> None:
    draft = read_wif(file)
    written = wif_text_of(draft)
    assert_same(draft_of(parse_wif_text(written, "again")), draft)
    before, after = independent_read(io.StringIO(file.read_text())), independent_read(io.StringIO(written))
    for name in (
        "threading",
        "color_table",
        "warp_colors",
        "weft_spacing",
        "warp",
        "notes",
        "private_sections",
    ):
        assert getattr(before, name) == getattr(after, name), name


@pytest.mark.parametrize("file", corpus("warn"))
def test_files_with_an_unused_wrong_default_warn(file: Path) -> None:
    family = "WARP" if "warp" in file.stem else "WEFT"
    with pytest.warns(
        LoomlightWarning, match=rf"\[{family}\] Color=(11|0) is not in \[COLOR TABLE\]"
    ) as caught:
        draft = read_wif(file)
    assert len(caught) == 1
    assert draft.warp.colors is not None
    assert draft.weft.colors is not None


@pytest.mark.parametrize("file", corpus("bad"))
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
def test_bad_files_are_refused_where_they_are_wrong(file: Path) -> None:
    with pytest.raises(InputError, match=re.escape(FAULTS[file.stem])) as caught:
        read_wif(file)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize("name", ["twill 2/1", "satin 8/3", "houndstooth", "waffle 8", "argyle 64"])
def test_another_reader_reads_what_we_write(name: str) -> None:
    draft = named_weave(name)
    text = wif_text_of(draft)
    if draft.palette is None:
        # That reader stops at a file without colours, which the specification allows.
        text += "\r\n[COLOR PALETTE]\r\nRange=0,1\r\n[COLOR TABLE]\r\n1=0,0,0\r\n"
        text = text.replace("Threads=", "Color=1\r\nThreads=")
    assert np.array_equal(draft.drawdown, independent_drawdown(text, draft.drawdown.shape))
