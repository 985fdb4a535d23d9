"""Compiled loops: right, kept on disk where that is possible, and without Python's lock."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numba import config
from numpy.typing import NDArray

from loomlight.core.numba_kernel import numba_kernel


def _dot(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    total = 0.0
    for number in range(len(first)):
        total += first[number] * second[number]
    return total


@pytest.mark.parametrize("any_sum_order", [False, True])
def test_kernels_are_right_and_kept(
    any_sum_order: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(config, "CACHE_DIR", "")
    kernel = numba_kernel(any_sum_order=any_sum_order)(_dot)
    assert config.CACHE_DIR == ""
    first, second = np.random.default_rng(0).normal(size=(2, 1000))
    # Double precision, a thousand terms of about 1.
    assert kernel(first, second) == pytest.approx(first @ second, abs=1e-12)
    assert list((tmp_path / "loomlight" / "numba").rglob("*.nbc"))


def test_what_cannot_be_kept_is_compiled_all_the_same() -> None:
    """Numba keeps nothing of functions that are in no file."""
    names: dict[str, object] = {}
    # A name that was executed into a dictionary has no type to check.
    exec("def double(number):\n    return 2 * number\n", names)
    assert numba_kernel()(names["double"])(21) == 42  # type: ignore[type-var, operator]
