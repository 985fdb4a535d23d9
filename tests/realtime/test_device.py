"""Adapters and buffers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.realtime import Camera, Cloth, Renderer, device, rectangle
from loomlight.realtime.device import Adapter, default_adapter


class Adapterless:
    """A wgpu that finds nothing."""

    class gpu:  # noqa: N801
        @staticmethod
        def enumerate_adapters_sync() -> list[Any]:
            return []


def new_adapter() -> Adapter:
    """An adapter with a device of its own: that of other tests keeps its compiled shaders."""
    return default_adapter.__wrapped__()


def test_no_adapter_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(device, "wgpu_module", lambda: Adapterless)
    with pytest.raises(MissingDependencyError, match="mesa-vulkan-drivers"):
        new_adapter()


def test_buffers_give_back_what_was_written() -> None:
    adapter = default_adapter()
    values = np.arange(7, dtype=np.float32)
    buffer = adapter.storage(values)
    adapter.write(buffer, np.float32([9]), offset=8)
    np.testing.assert_array_equal(adapter.read(buffer, np.float32, 7), [0, 1, 9, 3, 4, 5, 6])
    assert buffer.size % 16 == 0


def test_a_table_beyond_the_limits_is_one_sentence() -> None:
    adapter = default_adapter()
    small = type("Small", (), {"limits": {"max-storage-buffer-binding-size": 64}})
    with pytest.raises(MissingDependencyError, match=r"at most 64 bytes in a table, but 100 are needed"):
        Adapter(adapter.name, True, small).empty_storage(100)


def test_a_lost_device_is_one_sentence() -> None:
    lost = new_adapter()
    cloth = Cloth(rectangle(0.1, 0.1), fabric_from_text('weave = "plain"\n'))
    renderer = Renderer([cloth], (4, 4), "point", lost)
    lost.device.destroy()
    with pytest.raises(MissingDependencyError, match="was lost, by a reset of its driver"):
        renderer.render(Camera((0, 0, 0.1)), [])


def test_an_adapter_with_few_buffers_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(device, "STORAGE_BUFFERS", 10_000)
    with pytest.raises(MissingDependencyError, match="storage buffers to a shader, but 10000 are needed"):
        new_adapter()


def test_other_faults_pass_through() -> None:
    with pytest.raises(RuntimeError, match="a defect"), default_adapter().guarded():
        raise RuntimeError("a defect")
