"""The editor's page in a real Chromium: drafts, colours, undo, links, files, faults; the cloth shown flat."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tests.limits import HANG
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import (
    AXE,
    SIZES,
    Visit,
    address_of,
    by_id,
    fabric_of,
    open_editor,
    pixels_of,
    pixels_other_than,
    visiting,
    wait_for_cloth,
    wait_until,
)

FIXTURES = Path(__file__).parents[2] / "cases" / "drafts"


def click_cell(page: Any, column: int, row_from_top: int) -> None:
    """Clicks a cell of the draft's drawing, counted from its left and top."""
    grid = by_id(page, "draft-grid")
    size = int(grid.get_attribute("data-cell"))
    grid.click(position={"x": (column + 0.5) * size, "y": (row_from_top + 0.5) * size})


def test_a_click_brings_the_other_thread_on_top_and_undo_takes_it_back(editor: Any) -> None:
    before = fabric_of(editor)
    by_id(editor, "tab-draft").click()
    shafts = before["draft"]["ends"]  # a twill of as many shafts as ends
    click_cell(editor, 0, 2 + shafts + 1)
    after = fabric_of(editor)
    assert after["draft"]["drawdown"] != before["draft"]["drawdown"]
    assert "weave" not in after["fields"]
    editor.keyboard.press("Control+z")
    assert fabric_of(editor)["draft"]["drawdown"] == before["draft"]["drawdown"]
    editor.keyboard.press("Control+y")
    assert fabric_of(editor)["draft"]["drawdown"] == after["draft"]["drawdown"]


def test_light_between_yarns_is_a_switch_of_the_fabric(editor: Any) -> None:
    by_id(editor, "tab-finish").click()
    by_id(editor, "between-yarns-off").check()
    assert fabric_of(editor)["fields"]["interreflection"] is False
    editor.keyboard.press("Control+z")
    assert "interreflection" not in fabric_of(editor)["fields"]


def test_keys_edit_the_draft(editor: Any) -> None:
    before = fabric_of(editor)
    by_id(editor, "tab-draft").click()
    by_id(editor, "draft-grid").focus()
    for key in ("ArrowRight", "ArrowUp", "Space"):
        editor.keyboard.press(key)
    assert fabric_of(editor)["draft"]["drawdown"] != before["draft"]["drawdown"]


def test_lift_plan_and_treadling_weave_the_same(editor: Any) -> None:
    by_id(editor, "tab-draft").click()
    before = fabric_of(editor)
    by_id(editor, "plan-liftplan").click(force=True)
    lifted = fabric_of(editor)
    by_id(editor, "plan-treadling").click(force=True)
    treadled = fabric_of(editor)
    assert lifted["draft"]["loom"]["liftplan"]
    assert treadled["draft"]["loom"]["tieup"]
    assert lifted["draft"]["drawdown"] == treadled["draft"]["drawdown"] == before["draft"]["drawdown"]


@pytest.mark.parametrize(
    ("tab", "control", "keys", "field"),
    [
        ("yarns", "field-both.roughness", "End", ("warp", "roughness")),
        ("yarns", "field-both.gap", "End", ("weft", "gap")),
        ("yarns", "field-ends_per_cm", "ArrowRight", ("ends_per_cm",)),
        ("finish", "field-sheen.strength", "End", ("sheen", "strength")),
        ("yarns", "field-both.thick_places", "End", ("weft", "thick_places")),
        ("finish", "field-variation.irregularity", "End", ("variation", "irregularity")),
        ("finish", "field-variation.colour_noise", "End", ("variation", "colour_noise")),
    ],
)
def test_sliders_set_fields(editor: Any, tab: str, control: str, keys: str, field: tuple[str, ...]) -> None:
    before = _value(fabric_of(editor)["fields"], field)
    by_id(editor, f"tab-{tab}").click()
    by_id(editor, control).press(keys)
    after = _value(fabric_of(editor)["fields"], field)
    assert after is not None
    assert before is None or after > before


def _value(fields: dict[str, Any], keys: tuple[str, ...]) -> Any:
    value: Any = fields
    for key in keys:
        value = (value or {}).get(key)
    return value


def test_colour_and_weave_change_the_picture(editor: Any) -> None:
    plain = pixels_of(editor)
    by_id(editor, "tab-colour").click()
    by_id(editor, "colour-warp-0").evaluate(
        "(input) => { input.value = '#ff0000'; input.dispatchEvent(new Event('input', {bubbles: true})); }"
    )
    red = pixels_other_than(editor, plain)
    excess = [sum(data[0::3]) - sum(data[2::3]) for data in (plain, red)]
    assert excess[1] > excess[0] + len(red)
    by_id(editor, "tab-weave").click()
    by_id(editor, "weave-name").fill("herringbone 2/2 8")
    by_id(editor, "weave-apply").click()
    assert pixels_other_than(editor, red)


def test_a_dropped_draft_is_shown_and_a_broken_one_told(editor: Any, tmp_path: Path) -> None:
    by_id(editor, "files").set_input_files(FIXTURES / "sinking-liftplan.wif")
    wait_until(editor, "window.loomlight.fabric().fields.draft === 'sinking-liftplan.wif'")
    kept = fabric_of(editor)
    broken = tmp_path / "broken.wif"
    broken.write_text("[WIF]\nVersion=1.1\n[THREADING]\n1=1\n2=2\n")
    transfer = editor.evaluate_handle(
        "(text) => { const t = new DataTransfer(); t.items.add(new File([text], 'broken.wif')); return t; }",
        broken.read_text(),
    )
    editor.dispatch_event(".page", "drop", {"dataTransfer": transfer})
    said = by_id(editor, "notice-fault").inner_text()
    assert "broken.wif" in said
    assert "[LIFTPLAN] is missing" in said
    assert fabric_of(editor) == kept


def test_a_fault_in_a_weave_is_told_with_what_would_be_right(editor: Any) -> None:
    kept = fabric_of(editor)
    by_id(editor, "tab-weave").click()
    by_id(editor, "weave-name").fill("satin 8/2")
    by_id(editor, "weave-apply").click()
    assert "3, 5" in editor.locator(".fault").inner_text()
    assert fabric_of(editor) == kept


def test_saved_files_open_as_the_same_fabric(editor: Any, tmp_path: Path) -> None:
    by_id(editor, "tab-draft").click()
    by_id(editor, "ends-more").click()
    by_id(editor, "tab-yarns").click()
    by_id(editor, "field-both.specular").press("End")
    made = fabric_of(editor)
    saved = []
    editor.on("download", lambda download: saved.append(download))
    by_id(editor, "save").click()
    by_id(editor, "save-toml").click()
    end = time.monotonic() + HANG
    while len(saved) < 2:
        assert time.monotonic() < end
        editor.wait_for_timeout(20)
    files = [tmp_path / download.suggested_filename for download in saved]
    for download, file in zip(saved, files, strict=True):
        download.save_as(file)
    assert sorted(file.suffix for file in files) == [".toml", ".wif"]
    by_id(editor, "tab-weave").click()
    by_id(editor, "weave-plain").click()
    by_id(editor, "files").set_input_files(files)
    wait_until(editor, "window.loomlight.fabric().fields.weave === undefined")
    opened = fabric_of(editor)
    assert opened["draft"]["drawdown"] == made["draft"]["drawdown"]
    assert opened["fields"]["warp"] == made["fields"]["warp"]


def test_a_photograph_is_asked_about_and_notices_of_files_go(editor: Any, tmp_path: Path) -> None:
    # Plain weave, with noise.
    colours = np.random.default_rng(0).integers(0, 60, (8, 8, 3), dtype=np.uint8)
    colours[np.indices((8, 8)).sum(0) % 2 == 1] += 190
    Image.fromarray(colours).save(photograph := tmp_path / "holiday.png")
    (broken := tmp_path / "broken.wif").write_text("[WIF]\nVersion=1.1\n")
    before = fabric_of(editor)
    by_id(editor, "files").set_input_files(broken)
    assert "broken.wif" in by_id(editor, "notice-fault").inner_text()
    by_id(editor, "files").set_input_files(photograph)
    assert "holiday.png has 64 colours" in by_id(editor, "photograph").inner_text()
    assert by_id(editor, "notice-fault").count() == 0
    by_id(editor, "picture-is-nothing").click()
    assert fabric_of(editor) == before
    by_id(editor, "files").set_input_files(photograph.rename(tmp_path / "plain.png"))
    by_id(editor, "picture-is-drawdown").click()
    wait_until(editor, "window.loomlight.fabric().fields.image === 'plain.png'")


def test_what_is_said_beside_a_field_goes_with_undo(editor: Any) -> None:
    by_id(editor, "tab-yarns").click()
    for sett in ("21", "9999"):
        by_id(editor, "number-picks_per_cm").fill(sett)
        by_id(editor, "number-picks_per_cm").press("Enter")
    fault = editor.locator("[data-field=picks_per_cm] .fault")
    assert fault.inner_text().startswith("Picks per cm = 9999")
    by_id(editor, "undo").click()
    fault.wait_for(state="detached")


def test_a_picture_and_a_material_are_saved(editor: Any) -> None:
    for form, suffix in (("png", ".png"), ("wif", ".wif")):
        by_id(editor, "save").click()
        with editor.expect_download() as downloaded:
            by_id(editor, f"save-{form}").click()
        assert downloaded.value.suggested_filename.endswith(suffix)
        assert Path(downloaded.value.path()).stat().st_size > 100


def test_the_address_carries_the_fabric_and_a_reload_loses_nothing(served: Served, visit: Visit) -> None:
    open_editor(served, visit)
    by_id(visit.page, "tab-yarns").click()
    by_id(visit.page, "field-both.roughness").press("End")
    made = fabric_of(visit.page)
    address = address_of(visit.page)
    visit.page.reload()
    wait_for_cloth(visit.page)
    assert fabric_of(visit.page) == made
    with visiting(visit.page.context.browser) as other:
        open_editor(served, other, address)
        assert fabric_of(other.page) == made


def test_before_and_after_are_wiped(editor: Any) -> None:
    by_id(editor, "compare").click()
    by_id(editor, "compare-keep").click()
    by_id(editor, "tab-weave").click()
    by_id(editor, "weave-houndstooth-4").click()
    wipe = by_id(editor, "wipe")
    wipe.press("ArrowLeft")
    assert wipe.get_attribute("aria-valuenow") == "48"
    wiped = pixels_of(editor)
    by_id(editor, "compare").click()
    by_id(editor, "compare-off").click()
    assert pixels_other_than(editor, wiped)


@pytest.mark.slow
@pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm install in web/")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES.values(), ids=SIZES)
def test_every_panel_is_accessible_and_fits(
    served: Served, visit: Visit, size: tuple[int, int], scheme: str
) -> None:
    open_editor(served, visit)
    editor = visit.page
    editor.set_viewport_size({"width": size[0], "height": size[1]})
    editor.emulate_media(color_scheme=scheme)
    editor.evaluate(AXE.read_text(encoding="utf-8"))
    for tab in ("weave", "draft", "colour", "yarns", "finish", "light"):
        by_id(editor, f"tab-{tab}").click()
        assert editor.evaluate("document.documentElement.scrollWidth <= innerWidth"), tab
        found = editor.evaluate("axe.run()")["violations"]
        faults = [(fault["id"], [node["html"][:120] for node in fault["nodes"]]) for fault in found]
        assert faults == [], tab
