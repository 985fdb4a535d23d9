"""Small networks compute fastest on one thread, and bit for bit the same on any machine's count of them."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

os.environ["OMP_NUM_THREADS"] = "1"  # of processes that tests start
torch = pytest.importorskip("torch")
torch.set_num_threads(1)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """Names of the fabrics that the encoder was run for, with empty caches."""
    from tests.helpers.neural_networks import counted_runs

    return counted_runs(monkeypatch, tmp_path / "cache", "run_encoder")
