"""Adapters and buffers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.realtime import device
from loomlight.realtime.device import Adapter, default_adapter


class Adapterless:
    """A wgpu that finds nothing."""

    class gpu:  # noqa: N801
        @staticmethod
        def enumerate_adapters_sync() -> list[Any]:
            return []


def test_no_adapter_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(device, "wgpu_module", lambda: Adapterless)
    default_adapter.cache_clear()
    try:
        with pytest.raises(MissingDependencyError, match="mesa-vulkan-drivers"):
            default_adapter()
    finally:
        default_adapter.cache_clear()


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
