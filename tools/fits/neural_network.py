"""Trains the network of `neural` anew and puts it, and all that follows from it, into the package.

    python -m tools.fits.neural_network [CONFIG] [--folder DIR]

For the night after yarns have changed (`loomlight doctor` says so): training with its data, the encoder and
the decoder as ONNX, the sampler that draws directions for it, and the shaders that hold its shape. Run again,
it goes on where it was stopped. Studies make records and pictures of it: `python -m studies --stale`.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from argparse import ArgumentParser
from pathlib import Path

from loomlight.core.files import replacing
from studies.papers.chen2024.training.decoder import export_decoder

REPOSITORY = Path(__file__).parents[2]
_CONFIG = REPOSITORY / "studies/papers/chen2024/neural.toml"
_PACKAGE = REPOSITORY / "src/loomlight/models/neural/weights"


def main() -> None:
    """Runs every step; the first that fails ends it."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("config", type=Path, nargs="?", default=_CONFIG)
    parser.add_argument("--folder", type=Path, default=Path("runs/neural"))
    options = parser.parse_args()
    _run("studies.papers.chen2024.training", str(options.config), "-o", str(options.folder))
    put_into_package(options.folder, _PACKAGE)
    _run("tools.fits.neural_sampler", "--folder", str(options.folder / "sampler"))
    _run("tools.generate.shaders")
    _run("tools.generate.shaders", "--web")


def put_into_package(trained: Path, package: Path) -> None:
    """Copies weights and encoder from the folder of a training, and exports the decoder beside them."""
    for name in ("neural.safetensors", "neural.onnx"):
        with replacing(package / name) as temporary:
            shutil.copyfile(trained / name, temporary)
    export_decoder(package / "neural.safetensors")


def _run(module: str, *arguments: str) -> None:
    # Each in a process of its own: what one has loaded of the package's old network must not reach the next.
    result = subprocess.run([sys.executable, "-m", module, *arguments], cwd=REPOSITORY, check=False)
    if result.returncode:
        sys.exit(result.returncode)


if __name__ == "__main__":
    main()
