"""Compiles the CUDA export of each model by nvcc: `make test` does without it, as it takes 320 MB.

    pip install nvidia-cuda-nvcc nvidia-cuda-crt nvidia-nvvm nvidia-cuda-runtime nvidia-cuda-cccl
    python -m tools.checks.compile_cuda [--nvcc FILE] [--architecture sm_90]

No graphics card is needed. Prints the registers that ptxas gives each kernel.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import sysconfig
import tempfile
from argparse import ArgumentParser
from collections.abc import Callable
from pathlib import Path

from loomlight.exporters import export
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.models.interface import Model
from loomlight.models.registry import REALTIME_MODELS
from loomlight.realtime.materials import Material
from studies.instruments.random_networks import random_latent, random_neumip

# Trained models have random numbers: the text is the same.
_TRAINED: dict[str, Callable[[Fabric], Model]] = {
    "neumip": random_neumip,
    "latent": lambda fabric: random_latent(fabric, "3x64"),
}


def found_nvcc() -> Path | None:
    """The nvcc on the path, or that of the packages."""
    on_path = shutil.which("nvcc")
    if on_path is not None:
        return Path(on_path)
    return next(Path(sysconfig.get_paths()["purelib"]).glob("nvidia/*/bin/nvcc"), None)


def compiled(nvcc: Path, model: str, architecture: str, folder: Path) -> str:
    """Compiles one export and returns what ptxas says of it.

    Raises:
        subprocess.CalledProcessError: nvcc refuses the text; its message is printed.
    """
    fabric = fabric_from_text("twill 2/1")
    material: Material = _TRAINED[model](fabric) if model in _TRAINED else fabric
    export(material, "cuda", folder, model)
    command = [
        str(nvcc),
        f"-arch={architecture}",
        "-cubin",
        "-Xptxas",
        "-v",
        "-o",
        "out.cubin",
        "cloth_queries.cu",
    ]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr, file=sys.stderr)
        done.check_returncode()
    return "\n".join(line for line in done.stderr.splitlines() if "registers" in line)


def main() -> None:
    """Compiles all of them."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--nvcc", type=Path, default=found_nvcc())
    parser.add_argument("--architecture", default="sm_90")
    options = parser.parse_args()
    if options.nvcc is None:
        sys.exit("nvcc is not installed: give its path as --nvcc, or install the packages named in --help.")
    for model in REALTIME_MODELS:
        with tempfile.TemporaryDirectory() as folder:
            print(model, compiled(options.nvcc, model, options.architecture, Path(folder) / "export"))


if __name__ == "__main__":
    main()
