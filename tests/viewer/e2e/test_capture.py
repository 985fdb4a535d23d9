"""A photograph of cloth that is dropped on the page becomes its fabric."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.capturing.pictures import WIDTH_MM, photographed_twill
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, wait_until


def asked_about(visit: Visit, served: Served, photo: Path) -> Any:
    """The page that was told of a picture that it is a photograph of cloth."""
    visit.page.goto(f"http://127.0.0.1:{served.port}/")
    visit.page.get_by_test_id("files").set_input_files(photo)
    visit.page.get_by_test_id("picture-is-cloth").click()
    return visit.page


@pytest.fixture(scope="module")
def photo(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return photographed_twill(tmp_path_factory.mktemp("photo") / "swatch.png")


@pytest.mark.slow
def test_a_photograph_becomes_the_fabric(served: Served, visit: Visit, photo: Path) -> None:
    page = asked_about(visit, served, photo)
    # Nothing is sent before it is known how wide the cloth is.
    page.get_by_test_id("capture-start").click()
    assert "how many millimetres" in page.get_by_test_id("capture-fault").inner_text()
    page.get_by_test_id("capture-width").fill(str(WIDTH_MM))
    page.get_by_test_id("capture-start").click()
    page.get_by_test_id("capture-progress").wait_for()
    # Who cancels may begin anew.
    page.get_by_test_id("capture-cancel").click()
    page.get_by_test_id("capture-progress").wait_for(state="detached")
    assert page.get_by_test_id("capture-fault").count() == 0
    page.get_by_test_id("capture-start").click()
    page.get_by_test_id("capture").wait_for(state="detached")
    wait_until(page, "window.loomlight.fabric().fields.weave === 'twill 2/1 z'")
    fields = page.evaluate("window.loomlight.fabric().fields")
    assert fields["ends_per_cm"] == pytest.approx(16, rel=0.02)
    assert "swatch.png: twill 2/1 z" in page.locator(".notices").inner_text()
    assert visit.complaints == []


def test_without_python_a_sentence_says_how(served: Served, visit: Visit, photo: Path) -> None:
    def alone(route: Any) -> None:
        session = route.fetch().json() | {"has_python": False}
        route.fulfill(body=json.dumps(session), content_type="application/json")

    visit.page.route("**/api/session", alone)
    page = asked_about(visit, served, photo)
    assert "start `loomlight view`" in page.locator(".notices").inner_text()
    assert page.get_by_test_id("capture").count() == 0
