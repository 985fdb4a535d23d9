"""Nothing that is typed, linked or kept ends the page: faults are told and work is kept."""

from __future__ import annotations

import base64
import json
import zlib
from pathlib import Path
from typing import Any

import pytest

from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import (
    Visit,
    address_of,
    by_id,
    fabric_of,
    open_editor,
    wait_for_cloth,
    wait_until,
)

THIN = {"weave": "plain", "ends_per_cm": 15, "warp": {"count": "thin"}}


@pytest.fixture
def page(served: Served, visit: Visit) -> Any:
    """The page, once the cloth is shown."""
    open_editor(served, visit)
    return visit.page


def reload(page: Any) -> None:
    page.reload()
    wait_for_cloth(page)


def enter(page: Any, field: str, text: str) -> None:
    by_id(page, field).fill(text)
    by_id(page, field).press("Enter")


def link_of(fields: dict[str, Any]) -> str:
    """The part of an address that carries a fabric, as the page writes it."""
    deflate = zlib.compressobj(wbits=-15)
    packed = deflate.compress(json.dumps({"fields": fields}).encode()) + deflate.flush()
    return "#f=" + base64.urlsafe_b64encode(packed).decode().rstrip("=")


def test_a_count_is_read_as_mills_write_it_and_nonsense_is_told_beside_it(page: Any) -> None:
    by_id(page, "tab-yarns").click()
    enter(page, "field-both.count", "20s")
    row = page.locator(".row", has=by_id(page, "field-both.count"))
    assert "30 tex" in row.inner_text()
    for text, said in (("nonsense", "is not known; write it like"), ("60/2 Nm", 'write "Nm 60/2"')):
        enter(page, "field-both.count", text)
        assert said in row.locator(".fault").inner_text()
        assert by_id(page, "field-both.count").input_value() == text
        assert fabric_of(page)["fields"]["warp"]["count"] == "20s"
    assert by_id(page, "notice-fault").count() == 0
    address_of(page)
    reload(page)
    assert fabric_of(page)["fields"]["weft"]["count"] == "20s"
    by_id(page, "tab-yarns").click()
    by_id(page, "field-both.count").fill("nonsense")
    by_id(page, "field-both.count").press("Escape")
    assert by_id(page, "field-both.count").input_value() == "20s"


@pytest.mark.parametrize(
    ("tab", "field", "text", "said"),
    [
        ("yarns", "number-both.roughness", "7", "from 0.01 to 1"),
        ("yarns", "number-ends_per_cm", "many", '"many" is no number'),
        ("draft", "ends-count", "1", "from 2 to 16384"),
        ("draft", "shafts-count", "-1", "from 1 to 16384"),
        ("light", "number-scene.exposure", "9", "from -4 to 4"),
        ("colour", "order-warp", "4q", '"4q" is no run of threads'),
    ],
)
def test_what_cannot_be_is_told_beside_its_field(
    editor: Any, tab: str, field: str, text: str, said: str
) -> None:
    held = "JSON.stringify([window.loomlight.fabric(), window.loomlight.state().scene])"
    kept = editor.evaluate(held)
    by_id(editor, f"tab-{tab}").click()
    enter(editor, field, text)
    assert said in editor.locator(".fault").inner_text()
    assert by_id(editor, field).input_value() == text
    assert editor.evaluate(held) == kept
    by_id(editor, field).press("Escape")  # takes the fault away


@pytest.mark.slow
def test_what_was_kept_and_cannot_be_shown_is_set_aside(page: Any, tmp_path: Path) -> None:
    by_id(page, "tab-weave").click()
    by_id(page, "weave-satin-5-2").click()
    # Until it was kept as one that stands.
    wait_until(page, "localStorage.getItem('loomlight.good.1')?.includes('satin 5/2')")
    damaged = json.dumps({"fabric": {"fields": THIN}, "before": None, "scene": {}})
    page.goto("about:blank")
    page.go_back()
    page.evaluate("history.replaceState(null, '', location.pathname)")
    page.add_init_script(
        f"if (!sessionStorage.done) {{ localStorage['loomlight.document.1'] = {damaged!r}; }}"
        "sessionStorage.done = 1;"
    )
    reload(page)
    assert fabric_of(page)["fields"]["weave"] == "satin 5/2"
    said = by_id(page, "notice-fault").inner_text()
    assert "set aside" in said
    assert 'warp.count: The yarn count "thin" is not known' in said
    with page.expect_download() as downloaded:
        by_id(page, "aside").click()
    file = tmp_path / downloaded.value.suggested_filename
    downloaded.value.save_as(file)
    assert json.loads(json.loads(file.read_text())["text"])["fabric"]["fields"] == THIN
    reload(page)
    assert by_id(page, "notice-fault").count() == 0
    # The page opens its own file again, without the field, and says what is wrong with it.
    by_id(page, "files").set_input_files(file)
    wait_until(page, f"window.loomlight.fabric().fields.weave === {THIN['weave']!r}")
    assert 'warp.count: The yarn count "thin" is not known' in by_id(page, "notice-warning").inner_text()
    assert "count" not in fabric_of(page)["fields"].get("warp", {})


@pytest.mark.slow
def test_a_link_that_cannot_be_shown_is_set_aside(served: Served, visit: Visit) -> None:
    open_editor(served, visit, link_of(THIN))
    assert 'The yarn count "thin" is not known' in by_id(visit.page, "notice-fault").inner_text()
    assert visit.page.evaluate("location.hash") == ""
    open_editor(served, visit, link_of({**THIN, "warp": {"count": "2/60 Nm"}}))
    assert visit.complaints == []


def test_undo_survives_a_reload_and_so_does_the_light(page: Any) -> None:
    by_id(page, "tab-light").click()
    enter(page, "number-scene.exposure", "1.5")
    by_id(page, "tab-weave").click()
    for weave in ("plain", "satin-5-2", "satin-8-3"):
        by_id(page, f"weave-{weave}").click()
    by_id(page, "undo").click()
    address_of(page)
    reload(page)
    assert page.evaluate("window.loomlight.state().scene.exposure") == 1.5
    by_id(page, "redo").click()
    assert fabric_of(page)["fields"]["weave"] == "satin 8/3"
    for weave in ("satin 5/2", "plain", "twill 3/1"):
        by_id(page, "undo").click()
        assert fabric_of(page)["fields"]["weave"] == weave


@pytest.mark.slow
def test_a_part_that_fails_says_so_and_the_page_goes_on(page: Any) -> None:
    by_id(page, "weave-plain").click()
    page.evaluate(
        "() => { window.kept = CanvasRenderingContext2D.prototype.strokeRect;"
        "CanvasRenderingContext2D.prototype.moveTo = () => { throw new Error('the ink is gone'); }; }"
    )
    by_id(page, "tab-draft").click()
    said = by_id(page, "guard").inner_text()
    assert "The draft panel cannot be shown" in said
    assert "the ink is gone" in said
    by_id(page, "tab-yarns").click()
    by_id(page, "field-both.roughness").press("End")
    assert fabric_of(page)["fields"]["warp"]["roughness"] == 1
    by_id(page, "tab-draft").click()
    by_id(page, "guard-undo").click()
    assert "roughness" not in fabric_of(page)["fields"].get("warp", {})
    with page.expect_download() as downloaded:
        by_id(page, "guard-save").click()
    assert downloaded.value.suggested_filename == "plain.toml"
    page.evaluate("() => { delete CanvasRenderingContext2D.prototype.moveTo; }")
    page.evaluate("() => { CanvasRenderingContext2D.prototype.moveTo = () => undefined; }")
    by_id(page, "guard-again").click()
    assert by_id(page, "draft-grid").is_visible()


@pytest.mark.slow
def test_what_fails_as_soon_as_it_is_given_back_is_set_aside(page: Any) -> None:
    by_id(page, "weave-plain").click()
    wait_until(page, "localStorage.getItem('loomlight.good.1')?.includes('plain')")
    by_id(page, "weave-satin-5-2").click()
    wait_until(page, "localStorage.getItem('loomlight.document.1')?.includes('satin')")
    good = page.evaluate("localStorage.getItem('loomlight.good.1')").replace("satin 5/2", "plain")
    page.add_init_script(
        f"if (!sessionStorage.done) {{ localStorage['loomlight.good.1'] = {good!r};"
        "let isFirst = true; const { fillRect } = CanvasRenderingContext2D.prototype;"
        "CanvasRenderingContext2D.prototype.fillRect = function (...at) {"
        "if (isFirst) { isFirst = false; throw new Error('the ink is gone'); } fillRect.apply(this, at); }; }"
        "sessionStorage.done = 1;"
    )
    reload(page)
    wait_until(page, "window.loomlight.fabric().fields.weave === 'plain'")
    assert "the weave panel fails (The ink is gone.)" in by_id(page, "notice-fault").inner_text()
    assert "satin 5/2" in page.evaluate("localStorage.getItem('loomlight.aside.1')")
    assert by_id(page, "guard").count() == 0


@pytest.mark.slow
def test_a_fabric_that_kills_its_tab_is_shown_no_third_time(page: Any) -> None:
    by_id(page, "weave-satin-5-2").click()
    address_of(page)
    page.add_init_script(
        "if (!sessionStorage.done) sessionStorage['loomlight.starts'] = '2'; sessionStorage.done = 1;"
    )
    reload(page)
    assert fabric_of(page)["fields"]["weave"] != "satin 5/2"
    assert "ended without a word" in by_id(page, "notice-fault").inner_text()


@pytest.mark.slow
def test_notices_leave_by_themselves_and_faults_stay(page: Any) -> None:
    by_id(page, "files").set_input_files({"name": "a.txt", "mimeType": "text/plain", "buffer": b""})
    assert by_id(page, "notice-fault").is_visible()
    page.clock.install()
    by_id(page, "link").click()
    by_id(page, "notice-done").wait_for()
    page.clock.run_for(6_000)
    assert by_id(page, "notice-done").count() == 0
    page.clock.run_for(120_000)
    assert by_id(page, "notice-fault").is_visible()
