"""Files that cannot be used, each told in one sentence; nothing that was made is lost.

Broken WIF files are in test_editing.py, a server that ends in test_page.py, bad requests in ../test_app.py.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.limits import HANG
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, by_id, fabric_of, open_editor, visiting, wait_until

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
{uv}element face 1
property list uchar int vertex_indices
end_header
0 0 0{a}
1 0 0{b}
0 1 0{c}
3 0 1 2
"""
UV = "property float s\nproperty float t\n"


@pytest.fixture
def page(editor: Any) -> Iterator[Any]:
    """The page; whatever a test opens, the fabric stays."""
    made = fabric_of(editor)
    yield editor
    assert fabric_of(editor) == made


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("empty.obj", "# nothing\n", "empty.obj holds no triangles"),
        ("cut.glb", "glTF", "cut.glb is damaged or no mesh: OBJ, PLY and GLB are read"),
        ("notes.txt", "hello", "notes.txt is neither a fabric (.toml) nor a draft"),
        ("cut.toml", 'weave = "plain', "cut.toml"),
        ("alone.toml", 'draft = "a.wif"', "alone.toml needs its draft, a.wif: open both files together"),
        ("measured.toml", 'weave = "plain"\nwarp.color = "navy.csv"', "which a page cannot read"),
        ("cut.exr", "v/1", "cut.exr is damaged or no picture of surroundings"),
        ("cut.hdr", "#?RADIANCE\n", "cut.hdr is damaged or no picture of surroundings"),
    ],
)
def test_a_useless_file_is_told(page: Any, tmp_path: Path, name: str, text: str, said: str) -> None:
    file = tmp_path / name
    file.write_text(text)
    by_id(page, "files").set_input_files(file)
    assert said in by_id(page, "notice-fault").inner_text()


@pytest.mark.parametrize("suffix", [".wif", ".toml", ".obj", ".ply", ".hdr"])
def test_200_mib_are_refused_unread(page: Any, tmp_path: Path, suffix: str) -> None:
    file = tmp_path / f"large{suffix}"
    with file.open("wb") as stream:
        stream.truncate(200 << 20)
    by_id(page, "files").set_input_files(file)
    said = by_id(page, "notice-fault").inner_text()
    assert file.name in said
    assert "MiB" in said


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("cloth.obj", TRIANGLE + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"),
        ("cloth.ply", PLY.format(uv=UV, a=" 0 0", b=" 1 0", c=" 0 1")),
        # The server cuts these.
        ("bare.obj", TRIANGLE + "f 1 2 3\n"),
        ("bare.ply", PLY.format(uv="", a="", b="", c="")),
    ],
)
def test_a_mesh_is_worn(page: Any, tmp_path: Path, name: str, text: str) -> None:
    file = tmp_path / name
    file.write_text(text)
    before = page.evaluate("window.loomlight.state().scene")
    by_id(page, "files").set_input_files(file)
    wait_until(page, "window.loomlight.state().scene.shape === 'mesh'")
    assert before["surroundings"] == page.evaluate("window.loomlight.state().scene.surroundings")
    assert by_id(page, "notice-fault").count() == 0


@pytest.mark.slow
def test_a_browser_without_webgpu_is_told_so(served: Served, browser: Any) -> None:
    with visiting(browser) as visit:
        visit.page.add_init_script("delete Navigator.prototype.gpu")
        open_editor(served, visit)
        by_id(visit.page, "no-webgpu").locator("summary").click()
        assert "This browser has no WebGPU." in by_id(visit.page, "no-webgpu").inner_text()
        assert visit.complaints == []


@pytest.mark.slow
def test_a_link_that_was_cut_is_told(served: Served, visit: Visit) -> None:
    open_editor(served, visit, "#f=abc")
    assert "it may have been cut" in by_id(visit.page, "notice-fault").inner_text()


def test_port_in_use_is_one_sentence_and_nothing_is_left_running(served: Served) -> None:
    asked = [sys.executable, "-m", "loomlight", "view", "--no-browser", "--port", str(served.port)]
    done = subprocess.run(asked, capture_output=True, text=True, timeout=HANG, check=False)
    assert done.returncode == 2
    assert f"--port {served.port} is in use" in done.stderr
    assert "Traceback" not in done.stderr
