"""Launches on any number of cores, and the cache of object files."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.files import cache_folder
from loomlight.core.simd import (
    CompiledKernel,
    KernelBuilder,
    SimdTarget,
    aligned,
    host_target,
    jit,
    kernels_work,
)

from .kernels import computed


def sum_of_inputs(target: SimdTarget) -> CompiledKernel:
    kernel = KernelBuilder("sum", target, inputs=2, outputs=1)
    with kernel.each_block(), kernel.each_vector():
        kernel.store_output(0, kernel.load_input(0) + kernel.load_input(1))
    return CompiledKernel(kernel)


def test_the_self_test_passes() -> None:
    assert kernels_work()


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_any_number_of_cores_computes_every_query(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jit, "core_count", lambda: cores)
    for count in (0, 1, 47, 48, 49, 10_000):
        x = np.arange(count, dtype=np.float32)
        (actual,) = computed(lambda _, inputs: [inputs[0] + 1], x)
        np.testing.assert_array_equal(actual, x + 1)


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_every_block_is_computed_once(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The output is an input too, so a block that ran twice would count twice."""
    monkeypatch.setattr(jit, "core_count", lambda: cores)
    kernel = sum_of_inputs(SimdTarget(4, 16))
    # Whole blocks, blocks that are not full, and about as many queries as a thread takes at a time.
    for count in (1, 12, 1019, 1020, 1024, 1032, 12 * 100_000, 1_000_003):
        x = np.arange(count, dtype=np.float32) % 1000 + 1
        total = np.zeros_like(x)
        kernel.launch(count, [x, total], [total], [])
        np.testing.assert_array_equal(total, x)


def test_threads_may_launch_at_the_same_time() -> None:
    kernel, wrong = sum_of_inputs(host_target()), []

    def launch(seed: int) -> None:
        x = np.random.default_rng(seed).random(5000, np.float32)
        for _ in range(20):
            actual = np.empty_like(x)
            kernel.launch(len(x), [x, x], [actual], [])
            wrong.append(int((actual != 2 * x).sum()))

    threads = [threading.Thread(target=launch, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == [0] * 80


def test_arrays_of_another_kind_are_refused() -> None:
    kernel, good = sum_of_inputs(host_target()), np.zeros(10, np.float32)
    for bad in (np.zeros(10), np.zeros(20, np.float32)[::2], np.zeros(9, np.float32)):
        with pytest.raises(ValueError, match="contiguous float32 arrays of 10 numbers"):
            kernel.launch(10, [good, bad], [good], [])
    with pytest.raises(ValueError, match=r"\(inputs, outputs\) = \(2, 1\)"):
        kernel.launch(10, [good], [good], [])


def test_aligned_copies_begin_at_a_cache_line() -> None:
    for count in (1, 17, 1000):
        values = np.arange(count, dtype=np.float32).reshape(1, -1)
        actual = aligned(values)
        assert actual.ctypes.data % 64 == 0
        np.testing.assert_array_equal(actual, values)


def squares(count: int) -> tuple[np.ndarray, np.ndarray]:
    """What numpy and a kernel of no other test compute."""
    x = np.arange(count, dtype=np.float32)
    (actual,) = computed(lambda kernel, inputs: [inputs[0] * inputs[0] + 0.71875], x)
    return x * x + np.float32(0.71875), actual


def test_object_files_are_cached(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    np.testing.assert_array_equal(*squares(100))
    (stored,) = cache_folder("simd_kernels").iterdir()
    whole = stored.read_bytes()

    def never(*_: object) -> bytes:
        raise AssertionError("compiled again")

    with monkeypatch.context() as patch:
        patch.setattr(jit, "_optimise", never)
        np.testing.assert_array_equal(*squares(100))
    # A truncated file and one with a wrong byte are compiled again.
    for damaged in (whole[: len(whole) // 2], whole[:-1] + bytes([whole[-1] ^ 1]), b""):
        stored.write_bytes(damaged)
        np.testing.assert_array_equal(*squares(100))
        assert stored.read_bytes() == whole


def test_kernels_work_without_a_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    np.testing.assert_array_equal(*squares(100))
