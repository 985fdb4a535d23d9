"""Photographs that came over the network are captured by a process of limited time, which nobody outlives.

Covers: viewer/photo_capture.py, viewer/capture_worker.py
"""

from __future__ import annotations

import asyncio
import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from loomlight.viewer import photo_capture
from loomlight.viewer.messages import CaptureLine, fabric_of_json
from loomlight.viewer.photo_capture import MAX_PHOTO, capture_lines
from tests.capturing.pictures import WIDTH_MM, knitted, photographed_twill, save
from tests.viewer.conftest import Served


def lines_of(content: bytes, name: str, width_mm: float = WIDTH_MM, **limits: Any) -> list[CaptureLine]:
    async def read() -> list[bytes]:
        return [line async for line in capture_lines(content, name, width_mm, "flash", **limits)]

    return [CaptureLine.model_validate_json(line) for line in asyncio.run(read())]


@pytest.mark.slow
def test_a_photograph_becomes_a_fabric_of_the_page(local: Served, tmp_path: Path) -> None:
    photo = photographed_twill(tmp_path / "photo.png").read_bytes()
    status, headers, body = local.ask("POST", f"/api/capture?name=photo.png&width_mm={WIDTH_MM}", photo)
    assert (status, headers["content-type"]) == (200, "application/x-ndjson")
    lines = [CaptureLine.model_validate_json(line) for line in body.splitlines()]
    shares = [line.share for line in lines]
    assert shares == sorted(shares)
    assert len(shares) > 5
    found = lines[-1].found
    assert found is not None
    assert [line.found for line in lines[:-1]] == [None] * (len(lines) - 1)
    fabric = fabric_of_json(found.fabric.model_dump())
    assert fabric.fields.weave == "twill 2/1 z"
    assert fabric.fields.ends_per_cm == pytest.approx(16, rel=0.02)
    assert found.summary.startswith("twill 2/1 z, ")
    # Fields as the page's sliders have them.
    assert all(name.partition(".")[0] in ("warp", "weft") for name in found.unfixed)


@pytest.mark.slow
def test_what_is_no_cloth_is_said_without_the_folder_that_it_lay_in(tmp_path: Path) -> None:
    content = save(tmp_path / "knit.png", knitted()).read_bytes()
    last = lines_of(content, "../knit.png", 20.0)[-1]
    assert last.found is None
    assert (last.error or "").startswith("knit.png: its crossings look all alike")


def test_time_is_limited() -> None:
    (last,) = lines_of(b"", "photo.jpg", seconds=0.01)
    assert (last.error or "").startswith("photo.jpg was given up: it took more than 0.01 s")


@pytest.mark.slow
def test_the_process_ends_with_the_page(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    begun: list[subprocess.Popen[bytes]] = []

    def start(*arguments: Any, **options: Any) -> subprocess.Popen[bytes]:
        begun.append(subprocess.Popen(*arguments, **options))
        return begun[-1]

    monkeypatch.setattr(photo_capture, "Popen", start)
    content = photographed_twill(tmp_path / "photo.png").read_bytes()

    async def leave() -> bytes:
        lines = capture_lines(content, "photo.png", WIDTH_MM, "flash")
        first = await anext(lines)
        await lines.aclose()
        return first

    assert json.loads(asyncio.run(leave()))["share"] < 0.5
    (process,) = begun
    assert process.poll() is not None


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ("width_mm=wide", "'wide' is no number of millimetres"),
        ("", "'' is no number of millimetres"),
        ("width_mm=20&light=sun", "light = 'sun' is unknown: write flash or window"),
    ],
)
def test_what_cannot_be_asked_is_said(asked: str, said: str, local: Served) -> None:
    status, _, body = local.ask("POST", f"/api/capture?{asked}", b"x")
    assert status == 422
    assert said in json.loads(body)["error"]


def test_a_large_photograph_is_refused(local: Served) -> None:
    size = {"Content-Length": str(MAX_PHOTO + 1)}
    assert local.ask("POST", "/api/capture?width_mm=20", b"x", size)[0] == 413
