"""Trains the sampler of `neural` for the package's decoder, and writes its weights into the package.

python -m tools.fits.neural_sampler [--steps N] [--fabrics N] [--folder DIR] [--output FILE]
"""

from __future__ import annotations

import time
from argparse import ArgumentParser
from dataclasses import replace
from pathlib import Path

from loomlight.core.llvm import require_llvm
from loomlight.models.neural.weights import shipped_weights
from tools.fits.neural_sampler_training import SamplerSettings, train_sampler, write_sampler

_OUTPUT = Path(__file__).parents[2] / "src/loomlight/models/neural/weights/neural_sampler.safetensors"


def main() -> None:
    """Trains, writes, and prints processor seconds and the loss."""
    parser = ArgumentParser(description=__doc__)
    defaults = SamplerSettings()
    parser.add_argument("--steps", type=int, default=defaults.steps)
    parser.add_argument("--fabrics", type=int, default=defaults.fabrics)
    parser.add_argument("--folder", type=Path, default=Path("runs/neural-sampler"))
    parser.add_argument("--output", type=Path, default=_OUTPUT)
    options = parser.parse_args()
    require_llvm()
    start, weights = time.process_time(), shipped_weights()
    settings = replace(defaults, steps=options.steps, fabrics=options.fabrics)

    def report(step: int, steps: int, loss: float) -> None:
        if step % 100 == 0:
            print(f"{step} of {steps}: {loss:.4f}, {time.process_time() - start:.0f} CPU seconds", flush=True)

    write_sampler(options.output, train_sampler(weights, settings, options.folder, report), weights)


if __name__ == "__main__":
    main()
