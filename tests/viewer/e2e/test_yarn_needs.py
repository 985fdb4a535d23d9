"""The page reckons the yarn of a piece, keeps the piece, and refuses what cannot be."""

from __future__ import annotations

from typing import Any

import pytest

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, by_id, open_editor


def _write(page: Any, field: str, text: str) -> None:
    by_id(page, f"plan-{field}").fill(text)
    by_id(page, f"plan-{field}").press("Enter")


@pytest.mark.slow
def test_a_piece_is_reckoned_kept_and_saved(served: Served, visit: Visit) -> None:
    page = visit.page
    open_editor(served, visit, "?fabric=denim")
    by_id(page, "tab-yarns").click()
    needs = by_id(page, "yarn-needs")
    before = needs.inner_text()
    for field, text in (
        ("lengthM", "2"),
        ("widthCm", "100"),
        ("warpTakeUp", "10"),
        ("loomWasteM", "0,5"),
        ("weftTakeUp", "5"),
        ("weftWaste", "0"),
    ):
        _write(page, field, text)
    after = needs.inner_text()
    assert after != before
    # Ends of 2 m × 1.1 + .5 m each.
    fields = page.evaluate("window.loomlight.fabric().fields")
    ends = round(100 * fields["ends_per_cm"])
    assert f"{ends:,}\t{round(ends * 2.7):,}" in after
    _write(page, "lengthM", "-3")
    assert 'Length = "-3" cannot be' in page.locator(".plan-fields .fault").inner_text()
    assert needs.inner_text() == after
    with page.expect_download() as found:
        by_id(page, "needs-save").click()
    rows = found.value.path().read_text().splitlines()
    assert rows[0] == "family,colour,threads,metres,grams"
    assert sum(float(row.split(",")[2]) for row in rows[1:] if row.startswith("warp")) == ends
    page.reload()
    by_id(page, "tab-yarns").click()
    assert by_id(page, "yarn-needs").inner_text() == after
    # Empty: the crimp of the weave, between none and that of a jammed cloth.
    _write(page, "warpTakeUp", "")
    assert 0 < float(by_id(page, "plan-warpTakeUp").get_attribute("placeholder")) < 30
    assert visit.complaints == []
