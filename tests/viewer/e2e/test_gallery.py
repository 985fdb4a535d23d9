"""The gallery: searched, every fabric with a picture, and one's own kept in it."""

from __future__ import annotations

import pytest

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, by_id, fabric_of, open_editor, wait_until


@pytest.mark.slow
def test_the_gallery_is_searched_and_keeps_fabrics_of_ones_own(served: Served, visit: Visit) -> None:
    page = visit.page
    open_editor(served, visit, "?fabric=denim")
    fabrics = page.locator(".tile[data-testid^=fabric-]")
    assert fabrics.count() == 28
    wait_until(
        page,
        "[...document.querySelectorAll('.tile[data-testid^=fabric-] img')]"
        ".filter((image) => image.naturalWidth >= 320).length === 28",
    )
    by_id(page, "gallery-search").fill("wool twill")
    wait_until(page, "document.querySelectorAll('.tile[data-testid^=fabric-]').length < 28")
    found = fabrics.evaluate_all("(tiles) => tiles.map((tile) => tile.dataset.testid)")
    assert {"fabric-kilt-tartan", "fabric-gabardine"} <= set(found)
    assert "fabric-denim" not in found
    by_id(page, "gallery-search").fill("")
    # One's own: an edit of denim, kept, found again after others and a reload, and removed.
    by_id(page, "tab-draft").click()
    by_id(page, "ends-count").fill("56")
    by_id(page, "ends-count").press("Enter")
    mine = fabric_of(page)
    by_id(page, "tab-weave").click()
    by_id(page, "keep-fabric").click()
    name = mine["fields"]["name"]
    by_id(page, f"own-{name}").wait_for()
    by_id(page, "keep-fabric").click()
    assert page.locator(".fault").inner_text() == f"It is kept already, as {name}."
    by_id(page, "fabric-linen").click()
    page.reload()
    by_id(page, f"own-{name}").click()
    assert fabric_of(page) == mine
    page.get_by_role("button", name=f"Remove {name} from your fabrics").click()
    by_id(page, f"own-{name}").wait_for(state="detached")
    assert visit.complaints == []
