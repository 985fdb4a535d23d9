"""Machine code that is run on all cores, and kept."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from loomlight.core import machine_code
from loomlight.core.files import cache_folder
from loomlight.core.lane_code import Code, Vectors
from loomlight.core.machine_code import MachineCode, aligned, vectors

from .lanes import computed


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_any_number_of_cores_answers_every_query(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "cores", lambda: cores)
    for count in (0, 1, 47, 48, 49, 10_000):
        x = np.arange(count, dtype=np.float32)
        (found,) = computed(lambda _, given: [given[0] + 1], x)
        np.testing.assert_array_equal(found, x + 1)


def test_threads_may_ask_at_once() -> None:
    code = Code("twice", vectors())
    with code.blocks(), code.each_vector():
        code.answer(1, 2 * code.given(0))
    compiled, wrong = MachineCode(code), []

    def ask(seed: int) -> None:
        x = np.random.default_rng(seed).random(5000, np.float32)
        for _ in range(20):
            found = np.empty_like(x)
            compiled.run(len(x), [x], [found], [])
            wrong.append(int((found != 2 * x).sum()))

    threads = [threading.Thread(target=ask, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == [0] * 80


def test_arrays_that_code_cannot_read_are_refused() -> None:
    code = Code("same", vectors())
    with code.blocks(), code.each_vector():
        code.answer(1, code.given(0))
    compiled, good = MachineCode(code), np.zeros(10, np.float32)
    for bad in (np.zeros(10), np.zeros(20, np.float32)[::2], np.zeros(9, np.float32)):
        with pytest.raises(ValueError, match="float32 in a row"):
            compiled.run(10, [bad], [good], [])


def test_aligned_numbers_begin_with_a_line() -> None:
    for count in (1, 17, 1000):
        values = np.arange(count, dtype=np.float32).reshape(1, -1)
        found = aligned(values)
        assert found.ctypes.data % 64 == 0
        np.testing.assert_array_equal(found, values)


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_every_block_is_answered_once(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Threads share a count of blocks; what is answered twice would count twice."""
    monkeypatch.setattr(machine_code, "cores", lambda: cores)
    wide = Vectors(4, 16)
    code = Code("once", wide)
    with code.blocks(), code.each_vector():
        code.answer(1, code.given(1) + code.given(0))
    compiled = MachineCode(code)
    # Whole blocks, and about as many as are taken at once.
    for count in (1, 12, 1019, 1020, 1024, 1032, 12 * 100_000, 1_000_003):
        x = np.arange(count, dtype=np.float32) % 1000 + 1
        found = np.zeros_like(x)
        compiled.run(count, [x], [found], [])
        np.testing.assert_array_equal(found, x)


def squares_of(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Numbers, and what code makes of them that no other test writes."""
    given = np.arange(count, dtype=np.float32)
    (found,) = computed(lambda code, lanes: [lanes[0] * lanes[0] + 0.71875], given)
    return given * given + np.float32(0.71875), found


def test_what_was_compiled_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    np.testing.assert_array_equal(*squares_of(100))
    (kept,) = cache_folder("machine_code").iterdir()
    whole = kept.read_bytes()
    compiled = machine_code._optimised

    def never(*_: object) -> bytes:
        raise AssertionError("compiled anew")

    monkeypatch.setattr(machine_code, "_optimised", never)
    np.testing.assert_array_equal(*squares_of(100))
    monkeypatch.setattr(machine_code, "_optimised", compiled)
    # Half a file, or one with a wrong byte, is none.
    for damaged in (whole[: len(whole) // 2], whole[:-1] + bytes([whole[-1] ^ 1]), b""):
        kept.write_bytes(damaged)
        np.testing.assert_array_equal(*squares_of(100))
        assert kept.read_bytes() == whole


def test_nothing_need_be_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    np.testing.assert_array_equal(*squares_of(100))
