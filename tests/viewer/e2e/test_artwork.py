"""Artwork in the editor's page: a picture whose colours are weaves, kept, saved, opened, refused."""

from __future__ import annotations

import base64
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from loomlight.fabric import load_fabric
from tests.limits import HANG
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import (
    AXE,
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

# Red, white and navy; more of the first, fewest of the last.
COLOURS = ("#c00000", "#ffffff", "#001040")
SIZE = (48, 32)


@pytest.fixture(scope="module")
def artwork(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A picture of three colours in blocks."""
    index = np.zeros((SIZE[1], SIZE[0]), np.uint8)
    index[8:24, 8:32] = 1
    index[12:20, 16:24] = 2
    picture = Image.fromarray(index)
    picture.putpalette([int(colour[at : at + 2], 16) for colour in COLOURS for at in (1, 3, 5)])
    file: Path = tmp_path_factory.mktemp("artwork") / "kite.png"
    picture.save(file)
    return file


def drawdown_of(fabric: dict[str, Any]) -> np.ndarray[Any, np.dtype[np.bool_]]:
    draft = fabric["draft"]
    bits = np.unpackbits(np.frombuffer(base64.b64decode(draft["drawdown"]), np.uint8))
    return bits[: draft["ends"] * draft["picks"]].reshape(draft["picks"], draft["ends"]).astype(bool)


def drop(page: Any, file: Path) -> None:
    """Drops a file on the page."""
    transfer = page.evaluate_handle(
        """([name, text]) => { const t = new DataTransfer();
        t.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name)); return t; }""",
        [file.name, base64.b64encode(file.read_bytes()).decode()],
    )
    page.dispatch_event(".page", "drop", {"dataTransfer": transfer})


def saved_files(page: Any, count: int, folder: Path) -> list[Path]:
    """The files that *Save fabric* hands over."""
    saved: list[Any] = []
    page.on("download", lambda download: saved.append(download))
    by_id(page, "save").click()
    by_id(page, "save-toml").click()
    end = time.monotonic() + HANG
    while len(saved) < count:
        assert time.monotonic() < end
        page.wait_for_timeout(20)
    files = [folder / download.suggested_filename for download in saved]
    for download, file in zip(saved, files, strict=True):
        download.save_as(file)
    return files


def test_a_dropped_artwork_is_woven_and_saved(editor: Any, artwork: Path, tmp_path: Path) -> None:
    before = pixels_of(editor)
    drop(editor, artwork)
    wait_until(editor, "window.loomlight.fabric().fields.weaves !== undefined")
    # The lighter a colour, the more of the weft shows; shares are of pixels.
    weaves = {"#c00000": "twill 2/2", "#ffffff": "sateen 8/3", "#001040": "satin 8/3"}
    assert fabric_of(editor)["fields"] == {"image": "kite.png", "weaves": weaves}
    listed = by_id(editor, "artwork").locator("li").all_inner_texts()
    shares = zip(COLOURS, ("75.0", "20.8", "4.2"), strict=True)
    assert [text.split()[:2] for text in listed] == [list(share) for share in shares]
    size = by_id(editor, "artwork-size").inner_text()
    assert size == "48 ends and 32 picks, 20 × 20 a centimetre: 2.40 × 1.60 cm."
    first = pixels_other_than(editor, before)

    by_id(editor, "artwork-c00000-1").fill("plain")
    by_id(editor, "artwork-c00000-1").press("Enter")
    assert pixels_other_than(editor, first)
    made = fabric_of(editor)
    assert made["fields"]["weaves"]["#c00000"] == "plain"
    by_id(editor, "artwork-longest-count").fill("3")
    by_id(editor, "artwork-longest-count").press("Enter")
    bound = fabric_of(editor)
    assert (drawdown_of(bound) != drawdown_of(made)).any()
    by_id(editor, "undo").click()
    assert fabric_of(editor) == made

    by_id(editor, "artwork-ffffff-1").fill("satin 8/2")
    by_id(editor, "artwork-ffffff-1").press("Enter")
    assert "3, 5" in by_id(editor, "artwork").locator(".fault").inner_text()
    assert fabric_of(editor) == made

    files = saved_files(editor, 2, tmp_path)
    assert sorted(file.name for file in files) == ["kite.png", "kite.toml"]
    # What Python weaves of the files is what the page shows.
    fabric = load_fabric(tmp_path / "kite.toml")
    np.testing.assert_array_equal(fabric.draft.drawdown, drawdown_of(made))
    by_id(editor, "weave-plain").click()
    by_id(editor, "files").set_input_files(files)
    wait_until(editor, "window.loomlight.fabric().fields.weave === undefined")
    assert fabric_of(editor) == made


def test_several_wefts(editor: Any, artwork: Path, tmp_path: Path) -> None:
    by_id(editor, "files").set_input_files(artwork)
    wait_until(editor, "window.loomlight.fabric().fields.weaves !== undefined")
    by_id(editor, "artwork-wefts-more").click()
    assert fabric_of(editor)["fields"]["weaves"]["#001040"] == ["satin 8/3", "back"]
    by_id(editor, "artwork-001040-2").fill("sateen 8/3")
    by_id(editor, "artwork-001040-2").press("Enter")
    by_id(editor, "artwork-regulator").fill("2")
    by_id(editor, "artwork-regulator").press("Enter")
    made = fabric_of(editor)
    # The extra weft is woven in the eight rows of navy alone.
    assert (made["draft"]["ends"], made["draft"]["picks"]) == (48, 40)
    files = saved_files(editor, 2, tmp_path)
    fabric = load_fabric(next(file for file in files if file.suffix == ".toml"))
    np.testing.assert_array_equal(fabric.named_draft.drawdown, drawdown_of(made))
    np.testing.assert_allclose(fabric.named_draft.weft.spacing_mm, made["draft"]["weft"]["spacing_mm"])


def test_a_picture_of_two_colours_is_a_drawdown_until_one_says_so(editor: Any, tmp_path: Path) -> None:
    pixels = np.where(np.indices((16, 16)).sum(0) // 8 % 2, 250, 10).astype(np.uint8)
    Image.fromarray(pixels).save(tmp_path / "two.png")
    by_id(editor, "files").set_input_files(tmp_path / "two.png")
    wait_until(editor, "window.loomlight.fabric().fields.image === 'two.png'")
    drawn = fabric_of(editor)
    np.testing.assert_array_equal(drawdown_of(drawn), pixels[::-1] < 128)
    by_id(editor, "artwork-as-weaves").click()
    assert fabric_of(editor)["fields"]["weaves"] == {"#0a0a0a": "satin 8/3", "#fafafa": "sateen 8/3"}
    by_id(editor, "artwork-as-drawdown").click()
    assert fabric_of(editor) == drawn


def test_a_picture_of_many_colours_is_woven_in_its_main_ones(editor: Any, tmp_path: Path) -> None:
    """Three areas with noise, as a squeezed photograph of a drawing has."""
    index = np.repeat(np.array([0, 1, 1, 2]), 16)[None].repeat(48, 0)
    painted = np.array([[int(colour[at : at + 2], 16) for at in (1, 3, 5)] for colour in COLOURS])[index]
    noise = np.random.default_rng(1).integers(-6, 7, painted.shape)
    Image.fromarray(np.clip(painted + noise, 0, 255).astype(np.uint8)).save(tmp_path / "poster.png")
    by_id(editor, "files").set_input_files(tmp_path / "poster.png")
    by_id(editor, "picture-colours-count").fill("1")
    by_id(editor, "picture-colours-count").press("Enter")
    assert "2 to 24 colours" in by_id(editor, "photograph").inner_text()
    by_id(editor, "picture-colours-count").fill("3")
    by_id(editor, "picture-colours-count").press("Enter")
    by_id(editor, "picture-is-main-colours").click()
    wait_until(editor, "window.loomlight.fabric().fields.image === 'poster.png'")
    made = fabric_of(editor)
    assert sorted(made["fields"]["weaves"].values()) == ["sateen 8/3", "satin 8/3", "twill 2/2"]
    assert (made["draft"]["ends"], made["draft"]["picks"]) == (64, 48)
    files = saved_files(editor, 2, tmp_path)
    fabric = load_fabric(next(file for file in files if file.suffix == ".toml"))
    np.testing.assert_array_equal(fabric.draft.drawdown, drawdown_of(made))


def test_what_is_no_artwork_is_told_and_changes_nothing(editor: Any, artwork: Path, tmp_path: Path) -> None:
    before = fabric_of(editor)
    photograph = tmp_path / "photograph.png"
    Image.fromarray(np.random.default_rng(0).integers(0, 256, (240, 240, 3), dtype=np.uint8)).save(photograph)
    by_id(editor, "files").set_input_files(photograph)
    said = by_id(editor, "photograph").inner_text()
    assert "colours. In an artwork each colour is a weave, and at most 255 can be" in said
    assert by_id(editor, "picture-is-artwork").count() == 0
    by_id(editor, "picture-is-nothing").click()

    (tmp_path / "text.png").write_text("no picture")
    Image.new("1", (16400, 2)).save(tmp_path / "wide.png")
    toml = tmp_path / "kite.toml"
    toml.write_text('image = "kite.png"\n[weaves]\n"#c00000" = "plain"\n"#ffffff" = "plain"\n')
    for files, fault in (
        ([tmp_path / "text.png"], "text.png is no picture that this browser reads."),
        ([tmp_path / "wide.png"], "at most 16384 ends and picks can be used."),
        ([toml], "kite.toml needs its artwork, kite.png: open both files together."),
        ([toml, artwork], 'kite.png has 64 pixels of "#001040"; weaves names no such colour'),
    ):
        by_id(editor, "files").set_input_files(files)
        wait_until(editor, f"document.body.innerText.includes({fault!r})")
    assert fabric_of(editor) == before


def test_a_reload_and_a_link_keep_the_artwork(served: Served, visit: Visit, artwork: Path) -> None:
    open_editor(served, visit)
    by_id(visit.page, "files").set_input_files(artwork)
    wait_until(visit.page, "window.loomlight.fabric().fields.weaves !== undefined")
    by_id(visit.page, "artwork-ffffff-1").fill("basket 2/2")
    by_id(visit.page, "artwork-ffffff-1").press("Enter")
    made = fabric_of(visit.page)
    address = address_of(visit.page)
    visit.page.reload()
    wait_for_cloth(visit.page)
    assert fabric_of(visit.page) == made
    by_id(visit.page, "undo").click()
    assert fabric_of(visit.page)["fields"]["weaves"]["#ffffff"] == "sateen 8/3"
    with visiting(visit.page.context.browser) as other:
        open_editor(served, other, address)
        assert fabric_of(other.page) == made
        by_id(other.page, "artwork-c00000-1").fill("satin 5")
        by_id(other.page, "artwork-c00000-1").press("Enter")
        assert fabric_of(other.page)["fields"]["weaves"]["#c00000"] == "satin 5"


@pytest.mark.slow
@pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm install in web/")
def test_the_list_of_colours_is_accessible_and_fits(served: Served, visit: Visit, artwork: Path) -> None:
    visit.page.set_viewport_size({"width": 390, "height": 844})
    open_editor(served, visit)
    by_id(visit.page, "files").set_input_files(artwork)
    wait_until(visit.page, "window.loomlight.fabric().fields.weaves !== undefined")
    by_id(visit.page, "artwork-wefts-more").click()
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    visit.page.evaluate(AXE.read_text(encoding="utf-8"))
    found = visit.page.evaluate("axe.run()")["violations"]
    assert [(fault["id"], [node["html"][:120] for node in fault["nodes"]]) for fault in found] == []
