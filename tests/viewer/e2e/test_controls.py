"""Controls beside drafts and sliders: prints, written colours, weight; what the flat view leaves out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tests.viewer.e2e.pages import (
    by_id,
    fabric_of,
    pixels_of,
    pixels_other_than,
    wait_until,
)


def test_a_print_darkens_the_cloth_and_is_taken_off(editor: Any, tmp_path: Path) -> None:
    picture = tmp_path / "red.png"
    Image.fromarray(np.full((8, 8, 3), (255, 0, 0), np.uint8)).save(picture)
    by_id(editor, "tab-finish").click()
    plain = pixels_of(editor)
    by_id(editor, "print-file").set_input_files(picture)
    printed = pixels_other_than(editor, plain)
    red, green, blue = (sum(printed[axis::3]) for axis in range(3))
    assert red > green
    assert blue < sum(plain[2::3])
    by_id(editor, "print-off").click()
    assert pixels_other_than(editor, printed) == plain
    picture.write_bytes(b"no picture")
    by_id(editor, "print-file").set_input_files(picture)
    assert "red.png is no picture" in by_id(editor, "notice-fault").inner_text()


def test_colours_are_written_as_hex_and_as_lab(editor: Any) -> None:
    by_id(editor, "tab-colour").click()
    for text, color in (("#ff0000", "#ff0000"), ("lab(100, 0, 0)", "#ffffff")):
        by_id(editor, "written-warp-0").fill(text)
        by_id(editor, "written-warp-0").press("Enter")
        wait_until(editor, f"document.querySelector('[data-testid=written-warp-0]').value === '{color}'")
        assert fabric_of(editor)["fields"]["warp"]["color"] == color
    for text, said in (("navy", 'write sRGB hex such as "#20305c"'), ("navy.csv", "loomlight view")):
        by_id(editor, "written-warp-0").fill(text)
        by_id(editor, "written-warp-0").press("Enter")
        assert said in editor.locator(".fault").inner_text()
    assert fabric_of(editor)["fields"]["warp"]["color"] == "#ffffff"


def test_weight_sets_the_sett_of_counted_yarns(editor: Any) -> None:
    by_id(editor, "tab-yarns").click()
    assert by_id(editor, "weight").inner_text() == "unknown: it takes the yarn count of warp and weft"
    by_id(editor, "field-both.count").fill("30 tex")
    by_id(editor, "field-both.count").press("Enter")
    light = int(by_id(editor, "weight").input_value())
    by_id(editor, "weight").fill(str(2 * light))
    by_id(editor, "weight").press("Enter")
    fields = fabric_of(editor)["fields"]
    assert fields["ends_per_cm"] == fields["picks_per_cm"] > 30
    assert by_id(editor, "weight").input_value() == str(2 * light)
    by_id(editor, "undo").click()
    assert "ends_per_cm" not in fabric_of(editor)["fields"]


@pytest.mark.parametrize("field", ["specular_tint", "nep_color"])
def test_lustre_and_neps_have_a_colour(editor: Any, field: str) -> None:
    by_id(editor, "tab-yarns").click()
    by_id(editor, f"field-both.{field}").evaluate(
        "(input) => { input.value = '#ffcc44'; input.dispatchEvent(new Event('input', {bubbles: true})); }"
    )
    assert fabric_of(editor)["fields"]["weft"][field] == "#ffcc44"


def test_what_needs_webgpu_says_so(editor: Any) -> None:
    assert "flat, without light" in by_id(editor, "no-webgpu").inner_text()
    by_id(editor, "no-webgpu").locator("summary").click()
    assert "WebGPU" in by_id(editor, "no-webgpu").inner_text()
    by_id(editor, "tab-light").click()
    assert editor.get_by_text("light needs a browser with WebGPU").is_visible()
    by_id(editor, "compare").click()
    assert by_id(editor, "compare-models").is_disabled()
    editor.keyboard.press("Escape")  # closes the dialogue
