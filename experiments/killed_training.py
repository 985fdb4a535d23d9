"""Kills a training with signal 9 at random moments, also while it makes data, and resumes it each time.

    python -m experiments.killed_training [--kills 10] [--output experiments/results/killed_training.json]

The weights at the end must be those of an undisturbed run, bit for bit. A few minutes on two cores.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file

from benchmarks.harness import Figures, run

CONFIG = """
[network]
width = 8
[data]
fabrics = 40
pairs = 64
footprints = 64
lights = 16
views = 16
texels_per_thread = 16
[training]
steps = 700
decoder_steps = 400
fabrics = 3
queries = 512
"""
# Seconds until a kill, uniformly: longer than a start takes, so that some work is done before most of them.
_MOMENTS = 5.0, 12.0


def add_options(parser: ArgumentParser) -> None:
    """How often it is killed, and when."""
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)


def measure(options: Namespace) -> Figures:
    """An undisturbed training and one that is killed, and whether they end in the same weights."""
    rng = np.random.default_rng(options.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        config = folder / "config.toml"
        config.write_text(CONFIG)
        whole = _trained(config, folder / "whole")
        kills: list[dict[str, float | int | bool]] = []
        while len(kills) < options.kills:
            kills.append(_killed(config, folder / "killed", float(rng.uniform(*_MOMENTS))))
            print(f"killed: {kills[-1]}", file=sys.stderr, flush=True)
        resumed = _trained(config, folder / "killed")
    same = whole.keys() == resumed.keys() and all(np.array_equal(whole[k], resumed[k]) for k in whole)
    missed = [] if same else ["the same weights"]
    return {"kills": kills, "same_weights": same, "missed": missed, "config": CONFIG.strip()}


# What `loomlight train neural` runs, with a checkpoint twice a second in place of one a minute.
_TRAINING = """
import sys
from pathlib import Path
from loomlight.models.neural.training.config import read_config
from loomlight.models.neural.training.train import train_neural
train_neural(read_config(sys.argv[1]), Path(sys.argv[2]), keep_every=0.5)
"""


def _command(config: Path, folder: Path) -> list[str]:
    return [sys.executable, "-c", _TRAINING, str(config), str(folder)]


def _trained(config: Path, folder: Path) -> dict[str, np.ndarray]:
    subprocess.run(_command(config, folder), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return load_file(folder / "neural.safetensors")


def _killed(config: Path, folder: Path, seconds: float) -> dict[str, float | int | bool]:
    """Starts the training, kills it after some seconds, and returns its progress."""
    process = subprocess.Popen(_command(config, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(seconds)
    running = process.poll() is None
    process.kill()
    process.wait()
    return {
        "after_seconds": round(seconds, 2),
        "running": running,
        "fabrics_made": len(list(folder.glob("pool-*/*.safetensors"))),
        "checkpoint": (folder / "checkpoint.safetensors").exists(),
    }


if __name__ == "__main__":
    run(measure, add_options)
