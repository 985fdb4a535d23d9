"""Fabrics there and back as JSON; no path among their fields is read."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError
from loomlight.fabric import load_fabric
from loomlight.viewer.messages import artwork_json, fabric_json, fabric_of_json
from loomlight.viewer.session import session

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("name", ["wool-houndstooth", "linen"])
def test_fabrics_come_back_as_they_were(name: str) -> None:
    fabric = load_fabric(EXAMPLES / f"{name}.toml")
    back = fabric_of_json(json.loads(json.dumps(fabric_json(fabric))))
    assert back.fields == fabric.fields
    np.testing.assert_array_equal(back.draft.drawdown, fabric.draft.drawdown)
    np.testing.assert_array_equal(
        back.appearance().warp.diffuse_reflect, fabric.appearance().warp.diffuse_reflect
    )


def test_no_path_is_read() -> None:
    fabric = fabric_json(load_fabric("twill 3/1"))
    fabric["fields"] = {"draft": "/etc/passwd"}
    assert fabric_of_json(fabric).draft.ends == 4


def test_faults_name_the_field() -> None:
    fabric = fabric_json(load_fabric("twill 3/1"))
    fabric["fields"]["warp"] = {"roughness": 7}
    with pytest.raises(InputError, match=r"warp\.roughness = 7"):
        fabric_of_json(fabric)


def test_a_page_begins_with_the_picture_of_an_artwork(tmp_path: Path) -> None:
    # Rows of 200 pixels: runs of 300, whose number takes two groups of 7 bits, and of single pixels.
    index = np.zeros((4, 200), np.uint8)
    index[3, 100:] = index[2, 197] = 1
    picture = Image.fromarray(index)
    picture.putpalette([0xC0, 0, 0, 0xFF, 0xFF, 0xFF])
    picture.save(tmp_path / "art.png")
    Image.fromarray(np.eye(4, dtype=np.uint8) * 255).save(tmp_path / "steep.png")
    file = tmp_path / "art.toml"
    file.write_text('image = "art.png"\n[weaves]\n"#c00000" = "plain"\n"#FFF" = "steep.png"\n')
    fabric = load_fabric(file)
    found = session(fabric, has_python=True)["artwork"]
    assert found == artwork_json(fabric)
    assert (found["ends"], found["rows"], found["colours"]) == (200, 4, ["#c00000", "#ffffff"])
    # The lowest row first: 100 of the first colour, 100 of the second, 197, 1 and 2 + 400.
    runs = bytes([0, 100, 1, 100, 0, 197 & 127 | 128, 1, 1, 1, 0, 402 & 127 | 128, 402 >> 7])
    assert base64.b64decode(found["runs"]) == runs
    # White pixels from the upper left: the weft is on top there, and dark crossings are the warp's.
    drawdown = base64.b64encode(bytes([0b1110_1101, 0b1011_0111])).decode()
    assert found["drafts"] == [{"name": "steep.png", "ends": 4, "picks": 4, "drawdown": drawdown}]
    # A page goes without a picture that is gone, or that is no more what was woven.
    picture.crop((0, 0, 100, 4)).save(tmp_path / "art.png")
    assert artwork_json(fabric) is None
    (tmp_path / "art.png").unlink()
    assert artwork_json(fabric) is None
    assert artwork_json(load_fabric("plain")) is None
