"""Passes of frames are timed one by one, with an adapter's clock and without.

Covers: studies/instruments/adapter_times.py, studies/speed/frames.py
"""

from __future__ import annotations

from functools import partial
from typing import Any

import pytest

from loomlight.core.errors import InputError, LoomlightError
from loomlight.fabric import fabric_from_text
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.device import TIMESTAMPS, default_adapter
from studies.harness.study import Run
from studies.instruments import adapter_times
from studies.instruments.adapter_times import measured_limits, pass_times
from studies.speed import frames
from studies.speed.frames import FrameSpeed, tables
from tests.helpers.graphics import require_graphics


@pytest.fixture(autouse=True, scope="module")
def _graphics() -> None:
    require_graphics()


@pytest.fixture(scope="module")
def renderer() -> Renderer:
    cloth = Cloth(rectangle(1.0, 1.0), fabric_from_text("plain"), (1000.0, 1000.0))
    return Renderer([cloth], size=(16, 16), model="point")


@pytest.mark.parametrize("by_clock", [True, False])
def test_every_pass_of_a_frame_is_timed(
    by_clock: bool, renderer: Renderer, monkeypatch: pytest.MonkeyPatch
) -> None:
    if by_clock and TIMESTAMPS not in renderer.adapter.device.features:
        pytest.skip("the adapter has no timestamps")
    # Software drivers have timestamps too, which tell when passes end.
    monkeypatch.setattr(adapter_times, "has_clock", lambda adapter: by_clock)
    device = renderer.adapter.device
    lights = [DirectionalLight(towards=(0.5, 0.3, 0.8))]
    frame = partial(renderer.render, Camera(origin=(0, -0.1, 0.17)), lights, samples=1, passes=2)
    times = pass_times(renderer, frame, 2)
    assert {"raster", "first_layer", "shade_points", "tone_map"} <= set(times.within)
    assert all(0 <= times.within[name] <= times.until[name] for name in times.within)
    assert times.until["shade_points"] > 0
    assert renderer.adapter.device is device


def test_limits_are_of_what_the_loops_do(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a pass that takes 20 ms of 64 steps, and copies of 10 ms."""
    asked: list[tuple[str, int]] = []

    def least(adapter: Any, wgsl: str, entry: str, buffers: dict[str, Any], groups: int) -> float:
        asked.append((entry, groups))
        return 20.0 if entry == "arithmetic" else 10.0

    monkeypatch.setattr(adapter_times, "_least", least)
    monkeypatch.setattr(adapter_times, "_COPIED", 1 << 20)
    adapter = default_adapter()
    limits = measured_limits(adapter)
    groups = asked[0][1]
    assert [entry for entry, _ in asked] == ["arithmetic", "copies"]
    # Four multiply-adds of four numbers, two operations each.
    assert limits.flops == pytest.approx(4 * 4 * 2 * 64 * 256 * groups / 0.02)
    assert limits.bytes == pytest.approx(2 * (1 << 20) / 0.01)


def test_loops_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """They compile, and copies arrive."""
    monkeypatch.setattr(adapter_times, "_LONG", 0.0)
    monkeypatch.setattr(adapter_times, "_COPIED", 1 << 16)
    limits = measured_limits(default_adapter())
    assert limits.flops > 0
    assert limits.bytes > 0


def test_a_frame_that_an_adapter_refuses_is_a_row_that_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def times(fabric: str, row: str, size: tuple[int, int]) -> dict[str, Any]:
        if row == "point":
            raise LoomlightError("It binds too few buffers.")
        ms = {"raster": 1.0, "layers": 1.0, "shading": 4.0, "rest": 1.0}
        return {"ms": ms, "within": {}, "until": {}, "seconds_of_a_frame": 0.01}

    monkeypatch.setattr(frames, "_times", times)
    monkeypatch.setattr(frames, "measured_limits", lambda adapter: adapter_times.Limits(1e9, 1e9))
    settings = FrameSpeed(sizes="16x16,32x16", models="lobes,point")
    found = frames.measure(settings, Run()).figures
    small, large = tables(found)
    assert small.rows["`point`"][0] == "It binds too few buffers."
    assert (small.title, large.title) == (
        "Milliseconds of a frame of 16 × 16",
        "Milliseconds of a frame of 32 × 16",
    )
    # 19177 operations a pixel, of the record of `speed/realtime`.
    operations = found["frames"][0]["counts"]["operations"]
    best, share = small.rows["`lobes`"][-2:]
    assert best == pytest.approx(1e3 * 256 * operations / 1e9)
    assert share == pytest.approx(best / 4)


@pytest.mark.parametrize("sizes", ["1920", "1920x", "axb", "4x4"])
def test_sizes_that_are_none(sizes: str) -> None:
    with pytest.raises(InputError, match="is no size: write pixels such as 1920x1080"):
        frames.measure(FrameSpeed(sizes=sizes), Run())
