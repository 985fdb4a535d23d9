"""What passes take on a graphics adapter, by its own clock where it has one, and what it could do at most.

Software drivers have timestamps too, but lavapipe writes that of a pass's beginning when its work is done:
there, as on adapters without them, passes are timed until their results are read back.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from typing import Any
from unittest.mock import patch

import numpy as np

from loomlight.realtime.device import TIMESTAMPS, Adapter, wgpu_module
from loomlight.realtime.renderer import Renderer

# Passes between two looks at the clock.
_MAX_PASSES = 256


class PassClock:
    """Adds up milliseconds of the passes that a device encodes, by the adapter's timestamps."""

    def __init__(self, device: Any) -> None:
        """
        Args:
            device: of wgpu, with the feature `TIMESTAMPS`.
        """
        wgpu = wgpu_module()
        from wgpu.backends.wgpu_native._ffi import lib

        self._device, self._count = device, 0
        self._queries = device.create_query_set(type="timestamp", count=2 * _MAX_PASSES)
        usage = wgpu.BufferUsage.QUERY_RESOLVE | wgpu.BufferUsage.COPY_SRC
        self._ticks = device.create_buffer(size=16 * _MAX_PASSES, usage=usage)
        # Of wgpu's C interface, as WebGPU itself has no ticks of other lengths.
        self._nanoseconds = float(lib.wgpuQueueGetTimestampPeriod(device.queue._internal))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._device, name)

    def create_command_encoder(self, **options: Any) -> _TimedEncoder:
        """The device's, whose passes are timed."""
        return _TimedEncoder(self._device.create_command_encoder(**options), self)

    def writes(self) -> Mapping[str, Any]:
        """Timestamps of the next pass."""
        self._count += 1
        return {
            "query_set": self._queries,
            "beginning_of_pass_write_index": 2 * self._count - 2,
            "end_of_pass_write_index": 2 * self._count - 1,
        }

    def milliseconds(self) -> tuple[list[float], list[float]]:
        """Of each pass since the last call, and from the end of the one before to its end; waits for them.

        The latter are bounds from above: an adapter that waits for commands is idle between passes.
        """
        count, self._count = self._count, 0
        encoder = self._device.create_command_encoder()
        encoder.resolve_query_set(self._queries, 0, 2 * count, self._ticks, 0)
        self._device.queue.submit([encoder.finish()])
        ticks = np.frombuffer(self._device.queue.read_buffer(self._ticks, 0, 16 * count), np.uint64)
        begun, ended = ticks.reshape(-1, 2).astype(np.int64).T
        until = np.diff(ended, prepend=begun[:1])
        within, between = (self._nanoseconds * 1e-6 * ticks for ticks in (ended - begun, until))
        return within.tolist(), between.tolist()


class _TimedEncoder:
    """A command encoder whose passes write timestamps."""

    def __init__(self, encoder: Any, clock: PassClock) -> None:
        self._encoder, self._clock = encoder, clock

    def __getattr__(self, name: str) -> Any:
        return getattr(self._encoder, name)

    def begin_compute_pass(self, **options: Any) -> Any:
        return self._encoder.begin_compute_pass(timestamp_writes=self._clock.writes(), **options)

    def begin_render_pass(self, **options: Any) -> Any:
        return self._encoder.begin_render_pass(timestamp_writes=self._clock.writes(), **options)


@contextmanager
def _clocked(adapter: Adapter) -> Iterator[PassClock]:
    """A clock in the place of the adapter's device."""
    device = adapter.device
    adapter.device = PassClock(device)
    try:
        yield adapter.device
    finally:
        adapter.device = device


def has_clock(adapter: Adapter) -> bool:
    """Whether passes are timed by the adapter."""
    return TIMESTAMPS in adapter.device.features and not adapter.is_software


@dataclass(frozen=True)
class PassTimes:
    """Milliseconds of the passes of a frame by the names of their entry points: the least of some rounds.

    Attributes:
        within: from their beginnings to their ends; without a clock until the work is read back.
        until: from the end of the pass before; without a clock the same.
    """

    within: dict[str, float]
    until: dict[str, float]


def pass_times(renderer: Renderer, frame: Callable[[], object], rounds: int) -> PassTimes:
    """The times of the passes of a frame."""
    names: list[str] = []
    spent: list[float] = []
    adapter, timed = renderer.adapter, has_clock(renderer.adapter)

    def named(launch: Callable[..., None]) -> Callable[..., None]:
        def launch_named(entry: str = "raster", *arguments: object) -> None:
            names.append(entry)
            start = time.perf_counter()
            launch(*(() if entry == "raster" else (entry, *arguments)))
            if not timed:
                adapter.read(renderer._resources["pixels"], np.uint32, 1)
                spent.append(1e3 * (time.perf_counter() - start))

        return launch_named

    def round_once() -> tuple[dict[str, float], dict[str, float]]:
        names.clear()
        spent.clear()
        frame()
        within, until = adapter.device.milliseconds() if timed else (spent, spent)
        return _summed(names, within), _summed(names, until)

    with (
        patch.object(renderer, "_draw", named(renderer._draw)),
        patch.object(renderer, "_compute", named(renderer._compute)),
        _clocked(adapter) if timed else nullcontext(),
    ):
        found = [round_once() for _ in range(rounds)]
    within, until = (
        {name: min(one[name] for one in each) for name in each[0]} for each in zip(*found, strict=True)
    )
    return PassTimes(within, until)


def _summed(names: Sequence[str], values: Sequence[float]) -> dict[str, float]:
    found: dict[str, float] = {}
    for name, value in zip(names, values, strict=True):
        found[name] = found.get(name, 0.0) + value
    return found


# --------------------------------------------------------------------------------------------- what could be

_ARITHMETIC = """
@binding(0) @group(0) var<storage, read_write> found_0 : array<vec4<f32>>;
@compute @workgroup_size(256)
fn arithmetic(@builtin(global_invocation_id) id : vec3<u32>) {{
    let k = f32(id.x & 7u) * 0.001;
    var a = vec4<f32>(k); var b = a + 0.1; var c = a + 0.2; var d = a + 0.3;
    for (var i = 0; i < {steps}; i = i + 1) {{
        a = fma(a, vec4<f32>(0.999), b); b = fma(b, vec4<f32>(0.998), c);
        c = fma(c, vec4<f32>(0.997), d); d = fma(d, vec4<f32>(0.996), a);
    }}
    found_0[id.x] = a + b + c + d;
}}
"""
_COPY = """
@binding(0) @group(0) var<storage, read_write> from_0 : array<vec4<f32>>;
@binding(1) @group(0) var<storage, read_write> found_0 : array<vec4<f32>>;
@compute @workgroup_size(256)
fn copies(@builtin(global_invocation_id) id : vec3<u32>, @builtin(num_workgroups) groups : vec3<u32>) {
    for (var i = id.x; i < arrayLength(&found_0); i = i + groups.x * 256u) {
        found_0[i] = from_0[i] + 1.0;
    }
}
"""
# Operations of a step: four multiply-adds of four numbers.
_STEP = 32
_GROUPS, _COPY_GROUPS = 1 << 12, 1 << 14
# Milliseconds that a pass should take, and the bytes of a buffer that is copied at most.
_LONG, _COPIED = 20.0, 1 << 28
_ROUNDS = 3


@dataclass(frozen=True)
class Limits:
    """What an adapter reaches in loops that do nothing else.

    Attributes:
        flops: of multiply-adds in single precision, each two, a second.
        bytes: that are read and written a second.
    """

    flops: float
    bytes: float


def measured_limits(adapter: Adapter) -> Limits:
    """The limits of an adapter, by WGSL; loops grow until a pass is long enough to be timed."""
    groups = 1 << 4 if adapter.is_software else _GROUPS
    found = adapter.empty_storage(16 * 256 * groups)
    steps = 64
    while True:
        shader = _ARITHMETIC.format(steps=steps)
        taken = _least(adapter, shader, "arithmetic", {"found": found}, groups)
        if taken >= _LONG or steps >= 1 << 20:
            break
        steps *= 4
    flops = _STEP * steps * 256 * groups / (1e-3 * taken)
    most = int(adapter.device.limits["max-storage-buffer-binding-size"])
    size = min(_COPIED, most) // 4096 * 4096
    buffers = {name: adapter.empty_storage(size) for name in ("from", "found")}
    taken = _least(adapter, _COPY, "copies", buffers, min(_COPY_GROUPS, size // 4096))
    return Limits(flops, 2 * size / (1e-3 * taken))


def _least(adapter: Adapter, wgsl: str, entry: str, buffers: Mapping[str, Any], groups: int) -> float:
    """Milliseconds of a pass: the least of some after a first one."""
    pipeline = adapter.pipeline(wgsl, entry)
    bound = adapter.bindings(pipeline, wgsl, buffers)

    def launch() -> None:
        encoder = adapter.device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, bound)
        compute.dispatch_workgroups(groups)
        compute.end()
        adapter.device.queue.submit([encoder.finish()])

    def wait() -> None:
        adapter.read(buffers["found"], np.uint32, 1)

    launch()
    wait()
    if has_clock(adapter):
        with _clocked(adapter) as clock:
            for _ in range(_ROUNDS):
                launch()
            return min(clock.milliseconds()[0])
    taken = []
    for _ in range(_ROUNDS):
        start = time.perf_counter()
        launch()
        wait()
        taken.append(1e3 * (time.perf_counter() - start))
    return min(taken)
