"""Blocks of the draft over the whole window: selected by mouse, keys and touch, changed, filled, undone."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, by_id, fabric_of, open_editor, visiting, wait_until

SIDE = 16


def drawdown_of(page: Any) -> NDArray[np.uint8]:
    """[picks, ends], 1 where the warp is on top."""
    draft = fabric_of(page)["draft"]
    bits = np.unpackbits(np.frombuffer(base64.b64decode(draft["drawdown"]), np.uint8))
    return bits[: draft["picks"] * draft["ends"]].reshape(draft["picks"], draft["ends"])


def open_twill(served: Served, visit: Visit) -> Any:
    """A twill 2/2 of 16 ends and picks, its draft over the whole window."""
    page = visit.page
    open_editor(served, visit)
    by_id(page, "tab-weave").click()
    by_id(page, "weave-twill-2-2").click()
    by_id(page, "tab-draft").click()
    for field in ("ends-count", "picks-count"):
        by_id(page, field).fill(str(SIDE))
        by_id(page, field).press("Enter")
    by_id(page, "draft-wide").click()
    return page


@pytest.fixture
def page(served: Served, visit: Visit) -> Iterator[Any]:
    yield open_twill(served, visit)
    assert visit.complaints == []


def place_of(page: Any, end: int, pick: int) -> tuple[float, float]:
    """Where a crossing is on the screen; warp colours and 4 shafts stand above, with a cell between."""
    grid = by_id(page, "draft-grid")
    box = grid.bounding_box()
    size = int(grid.get_attribute("data-cell"))
    return box["x"] + (end + 0.5) * size, box["y"] + (2 + 4 + 1 + SIDE - 1 - pick + 0.5) * size


def drag(page: Any, first: tuple[int, int], last: tuple[int, int]) -> None:
    page.mouse.move(*place_of(page, *first))
    page.mouse.down()
    page.mouse.move(*place_of(page, *last), steps=4)
    page.mouse.up()


def test_a_block_is_selected_by_mouse_filled_mirrored_and_undone_one_by_one(page: Any) -> None:
    twill = drawdown_of(page)
    by_id(page, "selection-mode").click()
    drag(page, (2, 3), (6, 9))
    assert by_id(page, "selection").inner_text() == "5 × 7 from end 3, pick 4"
    assert (drawdown_of(page) == twill).all()
    by_id(page, "selection-weave").fill("plain")
    by_id(page, "selection-fill").click()
    filled = drawdown_of(page)
    pick, end = np.mgrid[3:10, 2:7]
    assert (filled[3:10, 2:7] == (pick % 2 == end % 2)).all()
    filled_outside, twill_outside = filled.copy(), twill.copy()
    filled_outside[3:10, 2:7] = twill_outside[3:10, 2:7] = 0
    assert (filled_outside == twill_outside).all()
    by_id(page, "undo").click()
    by_id(page, "selection-mirror-ends").click()
    mirrored = drawdown_of(page)
    assert (mirrored[3:10, 2:7] == twill[3:10, 2:7][:, ::-1]).all()
    by_id(page, "selection-turn").click()
    assert by_id(page, "selection").inner_text() == "7 × 5 from end 3, pick 4"
    # Clockwise as one sees it, pick 1 below: counterclockwise of an array whose rows go down.
    assert (drawdown_of(page)[3:8, 2:9] == np.rot90(mirrored[3:10, 2:7])).all()
    by_id(page, "undo").click()
    by_id(page, "undo").click()
    assert (drawdown_of(page) == twill).all()
    # What cannot be is said beside the buttons, and changes nothing.
    by_id(page, "selection-weave").fill("twill of my aunt")
    by_id(page, "selection-fill").click()
    assert "twill of my aunt" in page.locator(".selection-bar .fault").inner_text()
    assert (drawdown_of(page) == twill).all()


@pytest.mark.slow
def test_keys_select_copy_paste_shift_and_repeat(page: Any) -> None:
    twill = drawdown_of(page)
    grid = by_id(page, "draft-grid")
    grid.focus()
    # From end 1, pick 1 on: three ends and two picks.
    for key in ("Shift+ArrowRight", "Shift+ArrowRight", "Shift+ArrowUp"):
        grid.press(key)
    assert by_id(page, "selection").inner_text() == "3 × 2 from end 1, pick 1"
    grid.press("i")
    block = 1 - twill[:2, :3]
    assert (drawdown_of(page)[:2, :3] == block).all()
    grid.press("Control+c")
    grid.press("Escape")
    assert by_id(page, "selection").inner_text() == "Nothing is selected."
    # The cursor is at end 3, pick 2: the copy is put from there on.
    grid.press("Control+v")
    assert (drawdown_of(page)[1:3, 2:5] == block).all()
    grid.press("Alt+ArrowUp")
    assert (drawdown_of(page)[1:3, 2:5] == np.roll(block, 1, axis=0)).all()
    grid.press("Alt+ArrowDown")
    grid.press("t")
    repeats = np.roll(np.tile(block, (SIDE, SIDE)), (1, 2), axis=(0, 1))[:SIDE, :SIDE]
    # Rolled to where the block lies; 16 ends are no whole number of three, so only whole ones are compared.
    assert (drawdown_of(page)[1:, 2:] == repeats[1:, 2:]).all()
    grid.press("Control+x")
    assert not drawdown_of(page)[1:3, 2:5].any()
    for _ in range(6):
        page.keyboard.press("Control+z")
    assert (drawdown_of(page) == twill).all()
    # A copy is repeated in a selection that is larger.
    grid.press("Escape")
    grid.press("Control+a")
    grid.press("Control+Shift+v")
    assert (drawdown_of(page) == np.tile(block, (SIDE, SIDE))[:SIDE, :SIDE]).all()


@pytest.mark.slow
def test_a_finger_selects(served: Served, browser: Any) -> None:
    with visiting(browser, has_touch=True) as visit:
        page = open_twill(served, visit)
        by_id(page, "selection-mode").tap()
        touch = page.context.new_cdp_session(page)
        for kind, crossing in (("touchStart", (1, 2)), ("touchMove", (4, 4)), ("touchEnd", None)):
            points = [] if crossing is None else [dict(zip("xy", place_of(page, *crossing), strict=True))]
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        assert by_id(page, "selection").inner_text() == "4 × 3 from end 2, pick 3"
        before = drawdown_of(page)
        by_id(page, "selection-face").click()
        assert (drawdown_of(page)[2:5, 1:5] == 1 - before[2:5, 1:5]).all()
        assert visit.complaints == []


@pytest.mark.slow
def test_two_fingers_scroll_and_size_and_paint_nothing(served: Served, browser: Any) -> None:
    with visiting(browser, has_touch=True) as visit:
        page = open_twill(served, visit)
        for field in ("ends-count", "picks-count"):
            by_id(page, field).fill("300")
            by_id(page, field).press("Enter")
        before = drawdown_of(page)
        size = int(by_id(page, "draft-grid").get_attribute("data-cell"))
        touch = page.context.new_cdp_session(page)

        def touches(kind: str, *places: tuple[float, float]) -> None:
            points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        touches("touchStart", (500, 400))
        touches("touchStart", (500, 400), (600, 400))
        # Steps as small as fingers make: between the moves of the two, their distance changes by one.
        for step in range(1, 51):
            touches("touchMove", (500 - 4 * step, 400), (600 - 4 * step, 400))
        touches("touchEnd")
        # 200 pixels to the left are 200 / size ends.
        first = "Number(document.querySelector('.draft-window output').textContent.match(/\\d+/)[0])"
        wait_until(page, f"Math.abs({first} - 1 - {200 / size}) <= 1.5")
        touches("touchStart", (500, 400), (600, 400))
        for step in range(1, 6):
            touches("touchMove", (500 - 10 * step, 400), (600 + 10 * step, 400))
        touches("touchEnd")
        # Twice as far apart: cells of twice the size, or the largest.
        grid = "document.querySelector('[data-testid=draft-grid]').dataset.cell"
        wait_until(page, f"Number({grid}) === {min(2 * size, 36)}")
        assert (drawdown_of(page) == before).all()
        # One finger paints when it is lifted.
        x, y = (page.locator(".draft-grid").bounding_box()[side] for side in "xy")
        touches("touchStart", (x + 5 * size, y + 20 * size))
        touches("touchEnd")
        assert (drawdown_of(page) != before).sum() == 1
        assert visit.complaints == []


@pytest.mark.slow
def test_a_click_in_the_report_of_floats_goes_there(page: Any) -> None:
    by_id(page, "selection-mode").click()
    drag(page, (0, 5), (9, 5))
    page.keyboard.press("Delete")
    by_id(page, "floats-marked").check()
    first = by_id(page, "float-0")
    assert first.inner_text().startswith("Pick 6")
    by_id(page, "draft-zoom").press("End")
    first.click()
    said = by_id(page, "selection").inner_text()
    assert "× 1 from end" in said
    assert said.endswith("pick 6")
