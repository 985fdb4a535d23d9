"""Colour cards: added by the panel and by a drop, used by name and by click, kept, refused in a sentence."""

from __future__ import annotations

from typing import Any

import pytest

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, by_id, fabric_of, open_editor, wait_until

_TABLE = "Name;L*;a*;b*\n# D50\nSignal 3;54,29;80,81;69,89\nNavy;29,57;68,30;-112,03\n"


def _file(name: str, text: str) -> dict[str, Any]:
    return {"name": name, "mimeType": "text/plain", "buffer": text.encode()}


@pytest.mark.slow
def test_a_house_keeps_its_standards(served: Served, visit: Visit) -> None:
    page = visit.page
    open_editor(served, visit)
    by_id(page, "tab-colour").click()
    by_id(page, "card-files").set_input_files([_file("house.csv", _TABLE)])
    card = by_id(page, "card")
    card.wait_for()
    assert card.inner_text().split() == ["Signal", "3", "Navy"]
    by_id(page, "written-warp-0").fill("signal 3")
    by_id(page, "written-warp-0").press("Enter")
    # Lab of sRGB's red relative to D50.
    assert by_id(page, "colour-warp-0").input_value() == "#ff0000"
    assert by_id(page, "written-warp-0").get_attribute("title") == "Signal 3 (house)"
    assert fabric_of(page)["fields"]["warp"]["color"] == "#ff0000"
    by_id(page, "card-search").fill("nav")
    card.get_by_role("button").click()
    wait_until(page, "document.querySelector('[data-testid=brush-written]').value === '#0000ff'")
    # Chosen among files of any kind, a second card comes first, and both are kept.
    by_id(page, "files").set_input_files([_file("mill.gpl", "GIMP Palette\nName: Mill\n1 2 3 Tar\n")])
    by_id(page, "card-choice").wait_for()
    page.reload()
    by_id(page, "tab-colour").click()
    assert by_id(page, "card-choice").locator("option").all_inner_texts() == ["Mill", "house"]
    by_id(page, "card-remove").click()
    assert by_id(page, "card").inner_text().split() == ["Signal", "3", "Navy"]
    # What is no card is refused beside the button, by its name, and changes nothing.
    by_id(page, "card-files").set_input_files([_file("broken.ase", "ASEF")])
    page.locator(".fault").wait_for()
    assert page.locator(".fault").inner_text().startswith("broken.ase: it is no Adobe Swatch Exchange file")
    assert by_id(page, "card").is_visible()
    assert visit.complaints == []
