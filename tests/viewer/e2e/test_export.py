"""What the page exports, read back: pictures with their opacity, maps, a glTF file, a material.

Lit pictures are read back in test_lit_frame.py, where the page is lit already.

Covers: viewer/answers.py
"""

from __future__ import annotations

import json
import struct
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.fabric.maps import sample_maps, write_maps
from loomlight.fabric.read import load_fabric
from loomlight.models.registry import model_from_loom
from loomlight.viewer.answers import saved
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import Visit, exported, open_editor, picture_of

FABRIC = "twill 3/1"  # what `served` opens
PAPER = (245, 241, 232)


@pytest.fixture
def editor(served: Served, visit: Visit) -> Any:
    """A page of each test's own: its dialogue stays open."""
    open_editor(served, visit)
    return visit.page


@pytest.mark.slow
def test_maps_are_those_of_bake_maps(editor: Any, tmp_path: Path) -> None:
    archive = zipfile.ZipFile(exported(editor, "maps", texels="96"))
    from drjit.llvm import Float

    fabric = load_fabric(FABRIC)
    ours = write_maps(sample_maps(fabric, (96, 96), Float), tmp_path / "maps.png")
    assert sorted(archive.namelist()) == sorted(file.name for file in ours)
    assert {f"maps_{name}.png" for name in ("color", "normal", "height", "roughness", "opacity")} <= {
        file.name for file in ours
    }
    *pictures, facts = ours
    assert json.loads(archive.read(facts.name)) == json.loads(facts.read_text())
    for file in pictures:
        theirs = picture_of(archive.read(file.name))
        assert theirs.shape[:2] == (96, 96)
        # One step of 8 bits: the kernels' rounding may differ with and without derivatives.
        np.testing.assert_allclose(theirs.astype(int), picture_of(file).astype(int), atol=1)
    assert picture_of(archive.read("maps_normal.png")).std() > 10


@pytest.mark.slow
def test_gltf_is_that_of_export(editor: Any) -> None:
    theirs, ours = _images(exported(editor, "gltf").read_bytes()), _images(saved(load_fabric(FABRIC), "glb"))
    assert theirs.keys() == ours.keys() > {"base_color", "normal"}
    for name, picture in ours.items():
        assert theirs[name].shape == picture.shape
        np.testing.assert_allclose(theirs[name].astype(int), picture.astype(int), atol=1)


def _images(content: bytes) -> dict[str, NDArray[np.uint8]]:
    """The textures of a .glb by name."""
    magic, version, size, length = struct.unpack_from("<4sIII", content)
    assert (magic, version, size) == (b"glTF", 2, len(content))
    tree, binary = json.loads(content[20 : 20 + length]), content[28 + length :]
    found = {}
    for image in tree["images"]:
        view = tree["bufferViews"][image["bufferView"]]
        found[image["name"]] = picture_of(binary[view["byteOffset"] :][: view["byteLength"]])
    return found


@pytest.mark.slow
def test_material_is_read_again(editor: Any, tmp_path: Path) -> None:
    file = tmp_path / "twill.loom"
    file.write_bytes(exported(editor, "loom", model="point").read_bytes())
    model = model_from_loom(file)
    assert (model.name, model.source.name) == ("point", FABRIC)


def test_a_flat_picture_has_the_size_and_the_opacity_that_were_asked_for(editor: Any) -> None:
    clear = picture_of(exported(editor, "picture", width="300", height="200", transparent=True))
    assert clear.shape == (200, 300, 4)
    assert clear[0, 0, 3] == 0
    assert (clear[90:110, 140:160, 3] == 255).all()
    paper = picture_of(exported(editor, "picture", transparent=False))
    assert (paper[..., 3] == 255).all()
    assert tuple(paper[0, 0, :3]) == PAPER
    np.testing.assert_array_equal(paper[90:110, 140:160], clear[90:110, 140:160])
    assert paper[90:110, 140:160, :3].std() > 5  # there are yarns
