"""Pictures of a page's stage by Python.

Covers: viewer/picture.py, viewer/picture_worker.py, mitsuba/stage_picture.py.
"""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from safetensors.numpy import save

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.viewer import picture_worker
from loomlight.viewer.messages import fabric_json
from loomlight.viewer.picture import stage_of
from loomlight.viewer.picture_worker import PictureMaker
from tests.viewer.conftest import Served

SIZE = (48, 36)
PAPER = (0.9, 0.87, 0.8)


def request(**changes: Any) -> bytes:
    """What a page sends of a swatch of 2 cm, seen from the front, that lies left of the middle."""
    said: dict[str, Any] = {
        "fabric": fabric_json(
            fabric_from_text('weave = "plain"\nwarp.color = "#c02020"\nweft.color = "#c02020"')
        ),
        "uvSizeMm": [20, 20],
        "size": SIZE,
        "camera": {"origin": [0, 0, 0.1], "target": [0, 0, 0]},
        "lamp": {"towards": [0.3, 0.4, 0.9], "irradiance": [2, 2, 2]},
        "turn": 0,
        "background": PAPER,
        "ground": {"normal": [0, 0, 1], "offset": -0.002, "lampShare": 0.7},
        "exposure": 0,
    }
    corners = [[-0.02, -0.01], [0, -0.01], [0, 0.01], [-0.02, 0.01]]
    tensors = {
        "positions": np.array([[x, y, 0] for x, y in corners], np.float32),
        "normals": np.tile(np.array([0, 0, 1], np.float32), (4, 1)),
        "uv": np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32),
        "triangles": np.array([[0, 1, 2], [0, 2, 3]], np.uint32),
        "environment": np.full((4, 8, 3), 0.2, np.float32),
    }
    return save(tensors, {"stage": json.dumps({**said, **changes})})


def test_a_stage_is_read_as_the_page_says_it() -> None:
    stage = stage_of(request(exposure=1.5, turn=30))
    assert stage.fabric.draft.ends == 2
    assert (stage.size, stage.exposure, stage.turn) == (SIZE, 1.5, 30)
    assert stage.environment is not None
    assert stage.environment.shape == (4, 8, 3)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "describes no stage"),
        (b"\x10" + bytes(20), "describes no stage"),
        (request(size=[48, 100_000]), "48 × 100000 is out of range"),
        (request(background=[0.5, float("nan"), 0.5]), "no vector of three numbers"),
        (request(fabric={"name": "", "fields": {"weave": 3}}), "draft"),
    ],
)
def test_what_is_no_stage_is_refused(content: bytes, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        stage_of(content)


def test_a_request_that_is_no_stage_is_answered_in_a_sentence(
    local: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(_: PictureMaker, content: bytes, asked: object = None) -> bytes:
        stage_of(content)
        raise AssertionError

    monkeypatch.setattr(PictureMaker, "picture", refused)
    status, _, body = local.ask("POST", "/api/picture", b"none")
    assert status == 422
    assert "describes no stage" in json.loads(body)["error"]


def test_a_picture_is_kept_for_the_next_visit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[bytes] = []

    def png(_: PictureMaker, content: bytes) -> bytes:
        made.append(content)
        return b"png of " + content

    monkeypatch.setattr(PictureMaker, "_made", png)
    monkeypatch.setattr(picture_worker, "MAX_KEPT", 2)
    folder = tmp_path / "stages"
    for content in (b"a", b"b", b"a", b"c", b"a"):
        assert PictureMaker(folder).picture(content) == b"png of " + content
    assert made == [b"a", b"b", b"c"]
    assert len(list(folder.iterdir())) == 2


@pytest.mark.slow
def test_a_stage_is_rendered_from_its_camera_on_its_paper(tmp_path: Path) -> None:
    maker = PictureMaker(tmp_path)
    try:
        with pytest.raises(InputError, match="describes no stage"):
            maker.picture(b"none")
        png = maker.picture(request())
    finally:
        maker.close()
    pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(float)
    assert pixels.shape == (*SIZE[::-1], 3)
    # Red cloth left of the middle, of 2 cm at 10 cm: 26 degrees are 36 pixels high.
    covers = pixels[..., 0] - pixels[..., 1] > 40
    columns, rows = np.flatnonzero(covers.any(0)), np.flatnonzero(covers.any(1))
    side = SIZE[1] * 0.01 / (0.1 * np.tan(np.radians(13)))
    assert abs(columns[0] - (SIZE[0] / 2 - side)) <= 1
    assert abs(columns[-1] - SIZE[0] / 2) <= 1
    assert abs(rows[0] - (SIZE[1] - side) / 2) <= 1
    # Paper, 8 bits of its sRGB; far from the cloth there is no shadow.
    np.testing.assert_allclose(pixels[18, -1], [243, 239, 231], atol=2)
