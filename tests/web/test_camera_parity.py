"""The camera that the page copies as options shows in Python what the page shows.

Covers: core/camera_settings.py, mitsuba/camera.py
"""

from __future__ import annotations

import json
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from loomlight.cli.options import Given, takes
from loomlight.core.camera_settings import CameraSettings
from loomlight.mitsuba.camera import chosen_view
from tests.limits import HANG

WEB = Path(__file__).parents[2] / "web"


def _answers(questions: list[dict[str, Any]]) -> list[dict[str, Any]]:
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules").is_dir():
        pytest.skip("needs Node and `npm install` in web/")
    done = subprocess.run(
        [node, "editor/tools/camera_report.mjs"],
        cwd=WEB,
        input=json.dumps(questions),
        capture_output=True,
        text=True,
        timeout=HANG,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    answers: list[dict[str, Any]] = json.loads(done.stdout)
    return answers


def _read(options: str) -> CameraSettings:
    """As the command line reads them."""
    found: list[Given] = []
    small = typer.Typer()

    @small.command()
    @takes(CameraSettings)
    def show(given: Given) -> None:
        found.append(given)

    result = CliRunner().invoke(small, shlex.split(options))
    assert result.exception is None, result.output
    return CameraSettings(**found[0])


@pytest.mark.slow
def test_copied_cameras_show_points_where_the_page_does() -> None:
    """To half a pixel of a picture of a thousand: garments and swatches, turned, moved and from near."""
    rng = np.random.default_rng(4)
    questions: list[dict[str, Any]] = []
    for number in range(24):
        points = rng.normal(size=(30, 3)) * 10 ** rng.uniform(-2, 0.5) + rng.normal(size=3)
        questions.append(
            {
                "positions": points.ravel().tolist(),
                "from": [[0.35, 0.55, 1], [0, 0, 1], [0.3, 0.35, 1], [0, 1, 0]][number % 4],
                "size": [[1000, 700], [600, 1000], [800, 800]][number % 3],
                "turn": rng.uniform(-1, 1, 2).tolist() if number % 2 else [0, 0],
                "move": rng.uniform(-0.2, 0.2, 2).tolist(),
                "closer": float(rng.uniform(0.5, 1.2)),
            }
        )
    for question, answer in zip(questions, _answers(questions), strict=True):
        points = np.reshape(question["positions"], (-1, 3))
        width, height = question["size"]
        view = chosen_view(_read(answer["options"]), points, np.array([0.0, 0, 1]), (width, height))
        right = np.cross(view.up, view.backward)
        offset = points - view.origin
        half = np.tan(np.radians(view.field_of_view) / 2) / min(width, height)
        depth = offset @ -view.backward
        x = offset @ (right / np.linalg.norm(right)) / depth / half / width
        y = offset @ np.cross(view.backward, right / np.linalg.norm(right)) / depth / half / height
        found = np.stack([0.5 + x / 2, 0.5 - y / 2], axis=1)
        near = 0.3 * np.linalg.norm(view.origin - view.target)
        seen = (depth > near) & (np.abs(found - 0.5) < 1).all(axis=1)
        assert seen.sum() > 5
        page = np.array(answer["places"])
        np.testing.assert_allclose(found[seen] * [width, height], page[seen] * [width, height], atol=0.5)


@pytest.mark.slow
def test_the_page_frames_as_python_does() -> None:
    """The same direction and middle; from a hundredth farther, which the page leaves as a margin."""
    points = np.random.default_rng(5).normal(size=(40, 3))
    stays = {"turn": [0, 0], "move": [0, 0], "closer": 1.0}
    sizes = [[900, 600], [500, 900]]
    questions: list[dict[str, Any]] = [
        {"positions": points.ravel().tolist(), "from": [0.3, 0.35, 1], "size": size, **stays}
        for size in sizes
    ]
    for size, answer in zip(sizes, _answers(questions), strict=True):
        settings = _read(answer["options"])
        own = chosen_view(CameraSettings(), points, np.array([0.3, 0.35, 1]), (size[0], size[1]))
        np.testing.assert_allclose(settings.target, own.target, atol=1e-3)
        assert settings.distance == pytest.approx(np.linalg.norm(own.origin - own.target), rel=0.02)
        np.testing.assert_allclose(settings.angles, (own.azimuth, own.elevation), atol=0.01)
