"""A weights file of the universal network with random numbers in it, to try the machinery without training.

python -m tools.random_neural_weights neural.safetensors [--latent field] [--width 32]
"""

from __future__ import annotations

import argparse
from pathlib import Path

import torch

from loomlight.core.provenance import provenance
from loomlight.models.neural.architecture import NetworkTable
from studies.papers.chen2024.training.export import export_encoder
from studies.papers.chen2024.training.network import ClothNetwork
from studies.papers.chen2024.training.weights_file import write_weights


def main() -> None:
    """Writes the file, and its encoder beside it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    parser.add_argument("--latent", choices=("field", "vector"), default="field")
    parser.add_argument("--width", type=int, default=NetworkTable().width)
    arguments = parser.parse_args()
    torch.manual_seed(0)
    table = NetworkTable(latent=arguments.latent, width=arguments.width)
    network = ClothNetwork(table)
    write_weights(
        arguments.output,
        table,
        {name: values.numpy() for name, values in network.state_dict().items()},
        linear_diffuse=False,
        recipe={},
        provenance=provenance("python -m tools.random_neural_weights", Path(__file__).parent),
        trained=False,
    )
    export_encoder(arguments.output)


if __name__ == "__main__":
    main()
