"""The draft in its panel and over the whole window: it fits, scrolls and zooms, and is edited there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import SIZES, Visit, by_id, fabric_of, open_editor, wait_until


@pytest.fixture
def page(served: Served, visit: Visit) -> Iterator[Any]:
    """The page of the gallery's denim, 28 ends wide."""
    open_editor(served, visit, "?fabric=denim")
    yield visit.page
    assert visit.complaints == []


def bits_of(page: Any) -> str:
    drawdown: str = fabric_of(page)["draft"]["drawdown"]
    return drawdown


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES.values(), ids=SIZES)
def test_denim_fits_into_its_panel(page: Any, size: tuple[int, int]) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    by_id(page, "tab-draft").click()
    by_id(page, "draft-grid").wait_for()
    assert page.evaluate(
        "(() => { const { scrollWidth, clientWidth } = document.querySelector('.draft-scroll');"
        "return scrollWidth <= clientWidth; })()"
    )


def test_a_wide_draft_is_scrolled_zoomed_and_edited_over_the_whole_window(page: Any) -> None:
    by_id(page, "tab-draft").click()
    for field, count in (("ends-count", "640"), ("picks-count", "300")):
        by_id(page, field).fill(count)
        by_id(page, field).press("Enter")
    by_id(page, "draft-wide").click()
    sight = by_id(page, "draft-in-sight")
    assert sight.inner_text().startswith("Ends 1–")
    assert "picks 1–" in sight.inner_text()
    area = page.locator(".draft-window-area")
    area.evaluate("(area) => { area.scrollLeft = area.scrollWidth; area.scrollTop = 0; }")
    wait_until(page, "document.querySelector('.draft-window output').textContent.includes('640 of 640')")
    assert "300 of 300" in sight.inner_text()
    before = bits_of(page)
    grid = by_id(page, "draft-grid")
    size = int(grid.get_attribute("data-cell"))
    # The crossing at the left below warp colours and threading of 4 shafts, each with a cell between.
    grid.click(position={"x": 0.5 * size, "y": (2 + 4 + 1 + 0.5) * size})
    assert bits_of(page) != before
    by_id(page, "draft-zoom").press("End")
    assert int(grid.get_attribute("data-cell")) > size
    page.keyboard.press("Escape")
    assert by_id(page, "draft-window").count() == 0
    assert by_id(page, "draft-wide").is_visible()


@pytest.mark.slow
def test_arrows_go_on_beyond_the_window(page: Any) -> None:
    by_id(page, "tab-draft").click()
    by_id(page, "ends-count").fill("640")
    by_id(page, "ends-count").press("Enter")
    by_id(page, "draft-wide").click()
    last = int(by_id(page, "draft-in-sight").inner_text().split("–")[1].split()[0])
    for _ in range(last + 2):
        by_id(page, "draft-grid").press("ArrowRight")
    wait_until(page, "document.querySelector('.draft-window output').textContent.startsWith('Ends 4–')")


@pytest.mark.slow
def test_ends_are_threaded_by_an_order_and_long_floats_are_told(page: Any) -> None:
    by_id(page, "tab-weave").click()
    by_id(page, "weave-satin-8-3").click()
    by_id(page, "tab-draft").click()
    by_id(page, "floats-marked").check()
    said = by_id(page, "floats").inner_text()
    assert said.startswith("8 on the face (spots), 8 on the back (rings)")
    assert "warp 7 on the face" in said
    by_id(page, "floats-limit-count").fill("7")
    by_id(page, "floats-limit-count").press("Enter")
    assert by_id(page, "floats").inner_text().startswith("None is longer.")
    by_id(page, "ends-count").fill("14")
    by_id(page, "ends-count").press("Enter")
    by_id(page, "order-of-threading").select_option("point")
    shafts = [*range(1, 9), *range(7, 1, -1)]
    assert fabric_of(page)["draft"]["loom"]["threading"] == [[shaft] for shaft in shafts]
    by_id(page, "undo").click()
    assert fabric_of(page)["draft"]["loom"]["threading"] != [[shaft] for shaft in shafts]
