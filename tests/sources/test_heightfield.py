"""Height field files and their records; what is wrong is one sentence.

Covers: sources/toml_source.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.sources.heightfield import (
    Heightfield,
    heightfield_from_record,
    heightfield_record,
    is_heightfield_file,
    load_heightfield,
)
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom

TEXT = 'height_map = "h.png"\nsize_mm = [4, 2.0]\nheight_mm = 0.5\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A height map of 16 bits, and a coloured picture whose first row is at the top."""
    heights = np.linspace(0, 65535, 32).reshape(4, 8)
    Image.fromarray(heights.astype(np.uint16)).save(tmp_path / "h.png")
    colours = np.zeros((2, 2, 3), np.uint8)
    colours[0, 1] = 255, 0, 0
    Image.fromarray(colours).save(tmp_path / "c.png")
    return tmp_path


def written(folder: Path, text: str) -> Path:
    file = folder / "wool.toml"
    file.write_text(text)
    return file


def test_maps_are_read_with_the_bottom_row_first(folder: Path, tmp_path: Path) -> None:
    file = written(folder, TEXT + 'albedo = "c.png"\nroughness = "c.png"\nmetallic = 0.25')
    assert is_heightfield_file(file)
    actual = load_source(file)
    assert isinstance(actual, Heightfield)
    assert (actual.name, actual.repeat_mm, actual.height_mm) == ("wool", (4.0, 2.0), 0.5)
    # 16 bits, not 8.
    np.testing.assert_allclose(np.sort(actual.height.ravel()), np.linspace(0, 1, 32), atol=2e-5)
    assert actual.height[-1, 0] == 0
    np.testing.assert_allclose(actual.albedo[1, 1], [1, 0, 0])
    assert actual.roughness[1, 1] == pytest.approx(1 / 3)
    assert actual.roughness[0, 0] == pytest.approx(0.01)
    assert actual.metallic.shape == (1, 1)
    write_loom(tmp_path / "a.loom", LoomFile("neumip", actual))
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(again, Heightfield)
    for name in ("height", "albedo", "roughness", "metallic"):
        assert np.array_equal(getattr(again, name), getattr(actual, name))
    assert again.normal is None
    assert (again.size_mm, again.height_mm) == (actual.size_mm, actual.height_mm)


def test_a_fabric_file_is_none(folder: Path) -> None:
    assert not is_heightfield_file(written(folder, 'weave = "plain"'))
    assert not is_heightfield_file(written(folder, "no toml ["))
    assert not is_heightfield_file("plain")
    assert not is_heightfield_file(folder / "none.toml")


def test_models_of_fabrics_say_that_it_is_none(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(folder, TEXT)
    assert run(["bake", str(file), "--model", "lobes", "-o", str(folder / "a.loom")]) == 2
    assert "wool is no fabric, and the model lobes takes nothing else" in capsys.readouterr().err
    assert run(["render", str(file), "-o", str(folder / "a.png"), "--size", "16x16"]) == 2
    assert "wool is no fabric, and the model lobes takes nothing else" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (TEXT.replace("4, 2.0", "4, 0"), "size_mm"),
        (TEXT.replace("[4, 2.0]", "4"), "size_mm = 4 cannot be used: write two lengths above 0"),
        (TEXT.replace("height_mm = 0.5", ""), "height_mm is missing: write a length from 0"),
        (TEXT + "hight = 1", '"hight" is no field that a height field has: did you mean height_m'),
        (TEXT + 'albedo = "none.png"', "none.png does not exist"),
        (TEXT + 'albedo = "#12345"', 'albedo = "#12345" is no colour'),
        (TEXT + "roughness = 2", "roughness = 2 cannot be used: write a number from 0.01 to 1"),
        (TEXT.replace("h.png", "wool.toml"), "no picture that can be read"),
    ],
)
def test_a_fault_is_one_sentence(text: str, says: str, folder: Path) -> None:
    with pytest.raises(InputError) as caught:
        load_heightfield(written(folder, text))
    assert says in str(caught.value)
    assert str(folder / "wool.toml") in str(caught.value)


def test_files_hold_maps_as_their_pixels(folder: Path) -> None:
    """The same floats from fewer bytes; maps of other numbers, and those of former files, are floats."""
    rng = np.random.default_rng(4)
    for name, channels in (("albedo.png", 3), ("normal.png", 3), ("height.png", 1)):
        pixels = rng.integers(256, size=(16, 16, channels), dtype=np.uint8)
        Image.fromarray(pixels.squeeze()).save(folder / name)
    text = 'albedo = "albedo.png"\nnormal_map = "normal.png"\nroughness = 0.6\n'
    text += 'height_map = "height.png"\nsize_mm = [2, 2]\nheight_mm = 1\n'
    source = load_heightfield(written(folder, text))
    record, maps = heightfield_record(source)
    kinds = {name: str(values.dtype) for name, values in maps.items()}
    assert kinds.pop("albedo") == "uint8"
    assert set(kinds.values()) == {"uint16"}
    floats = {name: getattr(source, name) for name in maps}
    for tensors in (maps, floats):
        back = heightfield_from_record(record, tensors, "")
        for name, values in floats.items():
            np.testing.assert_array_equal(getattr(back, name), values)
    smooth = replace(source, height=rng.random((16, 16), np.float32))
    assert heightfield_record(smooth)[1]["height"] is smooth.height
