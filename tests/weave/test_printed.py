"""Drafts as PDF: as large as the cloth, with rulers that measure it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pypdfium2
import pytest

from loomlight.core.errors import InputError
from loomlight.weave import named_weave
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.loom import warped
from loomlight.weave.printed import PAPERS_MM, write_draft_pdf
from loomlight.weave.textile import with_setts

RED, GREEN, WHITE = (1.0, 0, 0), (0, 1.0, 0), (1.0, 1, 1)
# Pixels a millimetre that pages are drawn at to be measured.
PER_MM = 6


def two_ends() -> Draft:
    """Plain weave, whose end 1 is red and 4 mm, end 2 green and 6 mm; picks are white, 5 mm."""
    plain = named_weave("plain")
    warp = Threads(np.array([RED, GREEN]), np.array([4.0, 6.0]))
    return replace(plain, warp=warp, weft=Threads(np.array([WHITE, WHITE]), np.array([5.0, 5.0])))


def pages(path: Path) -> list[np.ndarray[Any, Any]]:
    """The pages as pixels, as a reader of PDF draws them."""
    document = pypdfium2.PdfDocument(path)
    scale = PER_MM * 25.4 / 72
    drawn = [page.render(scale=scale).to_numpy()[..., 2::-1].copy() for page in document]
    document.close()
    return drawn


def columns_of(pixels: np.ndarray[Any, Any], colour: tuple[int, int, int]) -> np.ndarray[Any, Any]:
    """Columns of pixels in which there is a colour."""
    return np.flatnonzero((pixels == colour).all(axis=2).any(axis=0))


@pytest.mark.parametrize("scale", [1, 2.5])
def test_threads_are_as_wide_as_in_the_cloth(tmp_path: Path, scale: float) -> None:
    write_draft_pdf(two_ends(), tmp_path / "a.pdf", scale=scale)
    (page,) = pages(tmp_path / "a.pdf")
    assert page.shape[:2] == pytest.approx((297 * PER_MM, 210 * PER_MM), abs=1)
    red, green = columns_of(page, (255, 0, 0)), columns_of(page, (0, 255, 0))
    # A pixel on each side may be mixed.
    assert np.ptp(red) + 1 == pytest.approx(4 * scale * PER_MM, abs=2)
    assert np.ptp(green) + 1 == pytest.approx(6 * scale * PER_MM, abs=2)
    assert green.max() < red.min()  # end 1 is on the right


def test_the_other_corner_and_the_back(tmp_path: Path) -> None:
    write_draft_pdf(two_ends(), tmp_path / "a.pdf", origin="bottom-left")
    write_draft_pdf(two_ends(), tmp_path / "b.pdf", origin="bottom-left", face="back")
    (front,), (back,) = pages(tmp_path / "a.pdf"), pages(tmp_path / "b.pdf")
    assert columns_of(front, (255, 0, 0)).max() < columns_of(front, (0, 255, 0)).min()
    assert columns_of(back, (255, 0, 0)).min() > columns_of(back, (0, 255, 0)).max()


def places_of_numbers(path: Path) -> list[tuple[str, float, float]]:
    """Digits of the first page with their middles, millimetres from the lower left corner."""
    document = pypdfium2.PdfDocument(path)
    text = document[0].get_textpage()
    found = []
    for index in range(text.count_chars()):
        left, low, right, high = (length * 25.4 / 72 for length in text.get_charbox(index))
        character = text.get_text_range(index, 1)
        if character.isdecimal():
            found.append((character, (left + right) / 2, (low + high) / 2))
    document.close()
    return found


@pytest.mark.parametrize("scale", [1, 3])
def test_rulers_measure_the_cloth(tmp_path: Path, scale: int) -> None:
    """Digits below the cloth stand a centimetre of cloth, and an inch of it, apart."""
    draft = warped(with_setts(named_weave("plain"), 10, 10), 52, 52)
    write_draft_pdf(draft, tmp_path / "a.pdf", scale=scale, paper="a2", drawdown=True)
    digits = places_of_numbers(tmp_path / "a.pdf")
    # Digits of a line have middles that differ by less than a millimetre, and lines are 7 mm apart.
    inches = min(y for digit, _, y in digits if digit == "2")
    for level, last, unit in ((inches, 2, 25.4), (inches + 7, 5, 10)):
        line = {digit: x for digit, x, y in digits if abs(y - level) < 1}
        assert set(line) == set(map(str, range(last + 1)))
        # Middles of digits differ by their side bearings, some tenths of a millimetre.
        assert abs(line[str(last)] - line["0"]) == pytest.approx(last * unit * scale, abs=0.4)


def test_a_large_draft_goes_over_sheets_that_join(tmp_path: Path) -> None:
    draft = warped(two_ends(), 60, 20)  # 300 x 100 mm
    write_draft_pdf(draft, tmp_path / "a.pdf", drawdown=True, origin="top-left")
    left, right = pages(tmp_path / "a.pdf")
    inner = slice(12 * PER_MM, -12 * PER_MM)
    joined = np.concatenate([left[inner, inner], right[inner, inner]], axis=1)
    red = columns_of(joined, (255, 0, 0))
    # From the first end to the last but one; a pixel at each end and at each side of the joint.
    assert np.ptp(red) + 1 == pytest.approx((300 - 6) * PER_MM, abs=4)


def test_paper_lies_where_that_takes_fewer_sheets(tmp_path: Path) -> None:
    write_draft_pdf(warped(two_ends(), 44, 4), tmp_path / "a.pdf", drawdown=True)  # 220 mm wide
    (page,) = pages(tmp_path / "a.pdf")
    assert page.shape[1] > page.shape[0]


def test_what_is_too_large_or_unknown_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    path = tmp_path / "a.pdf"
    cloth = warped(named_weave("plain"), 4096, 4096)
    with pytest.raises(InputError, match=r"drawn of 8\.39 million areas, and at most 2 million"):
        write_draft_pdf(cloth, path)
    with pytest.raises(InputError, match=r"covers \d+ sheets of letter; at most 100"):
        write_draft_pdf(warped(named_weave("plain"), 1000, 1000), path, scale=8, paper="letter")
    for scale in (0, -1, float("nan"), 101):
        with pytest.raises(InputError, match=r"scale .* out of range"):
            write_draft_pdf(two_ends(), path, scale=scale)
    with pytest.raises(InputError, match='paper "b5" is not known'):
        write_draft_pdf(two_ends(), path, paper="b5")  # type: ignore[arg-type]  # none of the sizes
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("paper", PAPERS_MM)
def test_every_paper_has_its_size(tmp_path: Path, paper: Any) -> None:
    title = replace(named_weave("waffle 8"), title="Würfel ☃ " + "x" * 200)
    write_draft_pdf(title, tmp_path / "a.pdf", paper=paper)
    document = pypdfium2.PdfDocument(tmp_path / "a.pdf")
    size = [side * 25.4 / 72 for side in document[0].get_size()]
    assert size == pytest.approx(PAPERS_MM[paper], abs=0.01)
    assert "Würfel ?" in document[0].get_textpage().get_text_range()
    document.close()
