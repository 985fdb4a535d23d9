"""Small untrained networks: tests of parity need no trained weights."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import torch

from loomlight.fabric.fabric import Fabric
from loomlight.models.neural import encoding
from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.encoding import clear_encodings
from loomlight.models.neural.weights import Weights, read_weights
from studies.papers.chen2024.training.export import export_encoder
from studies.papers.chen2024.training.network import ClothNetwork
from studies.papers.chen2024.training.weights_file import write_weights

# The shapes that are trained: what ships, what was published, and the ablations.
TABLES: dict[str, dict[str, Any]] = {
    "field": {"bundles": True},
    "field, parallax": {"bundles": True, "parallax": True},
    "field, no bundles": {},
    "vector, published": {"latent": "vector", "fibres": False, "heights": False},
    "plain, not fused": {"position": "plain", "fusion": False},
}


def network(name: str, hidden: int = 32) -> ClothNetwork:
    """A network of `TABLES`, narrower, whose weights are all different from zero."""
    torch.manual_seed(1)
    made = ClothNetwork(NetworkTable(width=8, hidden=hidden, **TABLES[name]))
    with torch.no_grad():
        for key, values in made.named_parameters():
            if key.endswith("gain"):
                values.fill_(0.3)
            elif key.startswith("decoder") and key.endswith("weight"):
                values.mul_(2)
        # Outputs of a fresh network lie about 0, where they are cut off and parity would say nothing.
        made.decoder.angular[-1].bias.fill_(1.0)
        made.decoder.hole[-1].bias.fill_(0.4)
    return made


def written(made: ClothNetwork, path: Path, half: bool = False, **changes: Any) -> Path:
    """The network as a weights file, and its encoder beside it."""
    given: dict[str, Any] = {"linear_diffuse": linear_diffuse(made), "recipe": {}, "provenance": {}}
    state = {name: values.numpy() for name, values in made.state_dict().items()}
    write_weights(path, made.table, state, half=half, **(given | changes))
    export_encoder(path)
    return path


def linear_diffuse(made: ClothNetwork) -> bool:
    """Whether the network's diffuse outputs are linear, as published."""
    return made.table.latent == "vector"


def weights_of(made: ClothNetwork, folder: Path) -> Weights:
    """The network without torch, in single precision."""
    return read_weights(written(made, folder / "weights.safetensors"))


def counted_runs(monkeypatch: pytest.MonkeyPatch, folder: Path, function: str) -> list[str]:
    """Names of the fabrics that a function of `encoding` is called for from here on, with empty caches.

    Args:
        folder: of the cache on disk.
    """
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder))
    clear_encodings()
    actual: list[str] = []
    run = getattr(encoding, function)

    def counted(fabric: Fabric, *arguments: Any) -> Any:
        actual.append(fabric.name)
        return run(fabric, *arguments)

    monkeypatch.setattr(encoding, function, counted)
    return actual
