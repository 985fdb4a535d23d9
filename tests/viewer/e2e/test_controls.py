"""Controls beside drafts and sliders: prints, written colours, weight; what the flat view leaves out."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tests.viewer.conftest import Served
from tests.viewer.e2e.conftest import visiting, wait_until
from tests.viewer.e2e.test_editing import by_id, fabric_of, open_editor, pixels_of, pixels_other_than


@pytest.fixture(scope="module")
def page(served: Served, browser: Any) -> Iterator[Any]:
    """One page for all tests, each of which sets something else."""
    with visiting(browser) as visit:
        open_editor(served, visit)
        yield visit.page
        assert visit.complaints == []


def test_a_print_darkens_the_cloth_and_is_taken_off(page: Any, tmp_path: Path) -> None:
    picture = tmp_path / "red.png"
    Image.fromarray(np.full((8, 8, 3), (255, 0, 0), np.uint8)).save(picture)
    by_id(page, "tab-finish").click()
    plain = pixels_of(page)
    by_id(page, "print-file").set_input_files(picture)
    printed = pixels_other_than(page, plain)
    red, green, blue = (sum(printed[axis::3]) for axis in range(3))
    assert red > green
    assert blue < sum(plain[2::3])
    by_id(page, "print-off").click()
    assert pixels_other_than(page, printed) == plain
    picture.write_bytes(b"no picture")
    by_id(page, "print-file").set_input_files(picture)
    assert "red.png is no picture" in by_id(page, "notice-fault").inner_text()


def test_colours_are_written_as_hex_and_as_lab(page: Any) -> None:
    by_id(page, "tab-colour").click()
    for text, color in (("#ff0000", "#ff0000"), ("lab(100, 0, 0)", "#ffffff")):
        by_id(page, "written-warp-0").fill(text)
        by_id(page, "written-warp-0").press("Enter")
        wait_until(page, f"document.querySelector('[data-testid=written-warp-0]').value === '{color}'")
        assert fabric_of(page)["fields"]["warp"]["color"] == color
    for text, said in (("navy", 'write sRGB hex such as "#20305c"'), ("navy.csv", "loomlight view")):
        by_id(page, "written-warp-0").fill(text)
        by_id(page, "written-warp-0").press("Enter")
        assert said in page.locator(".fault").inner_text()
    assert fabric_of(page)["fields"]["warp"]["color"] == "#ffffff"


def test_weight_sets_the_sett_of_counted_yarns(page: Any) -> None:
    by_id(page, "tab-yarns").click()
    assert by_id(page, "weight").inner_text() == "unknown: it takes the yarn count of warp and weft"
    by_id(page, "field-both.count").fill("30 tex")
    by_id(page, "field-both.count").press("Enter")
    light = int(by_id(page, "weight").input_value())
    by_id(page, "weight").fill(str(2 * light))
    by_id(page, "weight").press("Enter")
    fields = fabric_of(page)["fields"]
    assert fields["ends_per_cm"] == fields["picks_per_cm"] > 30
    assert by_id(page, "weight").input_value() == str(2 * light)
    by_id(page, "undo").click()
    assert "ends_per_cm" not in fabric_of(page)["fields"]


@pytest.mark.parametrize("field", ["specular_tint", "nep_color"])
def test_lustre_and_neps_have_a_colour(page: Any, field: str) -> None:
    by_id(page, "tab-yarns").click()
    by_id(page, f"field-both.{field}").evaluate(
        "(input) => { input.value = '#ffcc44'; input.dispatchEvent(new Event('input', {bubbles: true})); }"
    )
    assert fabric_of(page)["fields"]["weft"][field] == "#ffcc44"


def test_what_needs_webgpu_says_so(page: Any) -> None:
    assert "flat, without light" in by_id(page, "no-webgpu").inner_text()
    by_id(page, "no-webgpu").locator("summary").click()
    assert "WebGPU" in by_id(page, "no-webgpu").inner_text()
    by_id(page, "tab-light").click()
    assert page.get_by_text("light needs a browser with WebGPU").is_visible()
    by_id(page, "compare").click()
    assert by_id(page, "compare-models").is_disabled()
