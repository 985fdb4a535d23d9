"""Two processes that torchrun starts train what one trains.

Covers: training/loop.py, training/processes.py
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from tests.limits import HANG

pytest.importorskip("torch")

CONFIG = """
[network]
width = 4
latent_size = 8
hidden = 16
[data]
layouts = "paper"
fabrics = 2
pairs = 64
footprints = 16
lights = 16
views = 16
texels_per_thread = 8
[training]
steps = 3
fabrics = 2
queries = 64
decoder_steps = 2
"""


@pytest.mark.slow
def test_two_processes_train_what_one_trains(tmp_path: Path) -> None:
    config = tmp_path / "tiny.toml"
    config.write_text(CONFIG)
    train = ["-m", "papers.chen2024.training", str(config), "-o"]
    starter = ["-m", "torch.distributed.run", "--standalone", "--nproc-per-node", "2"]
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    for command in ([*train, str(tmp_path / "one")], [*starter, *train, str(tmp_path / "two")]):
        done = subprocess.run(
            [sys.executable, *command], env=environment, capture_output=True, text=True, timeout=HANG
        )
        assert done.returncode == 0, done.stderr
        # One process speaks for all.
        assert done.stdout.count("neural.safetensors") == 1
    one, two = (load_file(tmp_path / name / "neural.safetensors") for name in ("one", "two"))
    assert one.keys() == two.keys()
    for name in one:
        # Sums of two gradients in another order: a rounding of float32 each step, which Adam's division by
        # small second moments enlarges.
        np.testing.assert_allclose(two[name], one[name], rtol=1e-4, atol=1e-6, err_msg=name)
    files = sorted(str(path.relative_to(tmp_path / "one")) for path in (tmp_path / "one").rglob("*"))
    assert files == sorted(str(path.relative_to(tmp_path / "two")) for path in (tmp_path / "two").rglob("*"))
