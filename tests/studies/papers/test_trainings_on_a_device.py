"""All tensors of a training's step lie on its device.

On "meta", a device of PyTorch's without numbers, what lies elsewhere is refused as on a card.

Covers: studies/papers/kuznetsov2021/encoded_textures.py, studies/papers/kuznetsov2021/neural_textures.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch", exc_type=ImportError)

# These need torch: they follow the line that skips the file without it.
from loomlight.core.errors import InputError  # noqa: E402
from loomlight.fabric import fabric_from_text  # noqa: E402
from loomlight.models.registry import make_model  # noqa: E402
from loomlight.models.texture.neumip_training import NeumipBatches, NeumipNetwork  # noqa: E402
from loomlight.models.texture.pyramid import PyramidShape  # noqa: E402
from loomlight.models.texture.queries import Queries  # noqa: E402
from loomlight.models.texture.settings import NeumipSettings  # noqa: E402
from studies.papers.kuznetsov2021 import equal_cost  # noqa: E402
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, RAINER19, WITHOUT  # noqa: E402
from studies.papers.kuznetsov2021.encoded_textures import (  # noqa: E402
    PAIRS,
    EncodedTextures,
    TiledBatches,
)
from studies.papers.kuznetsov2021.materials import paper_heightfield  # noqa: E402
from studies.papers.kuznetsov2021.neural_textures import NeuralTextures, published_error  # noqa: E402

DEVICE = "meta"
SHAPE = PyramidShape(8, 8, 2.0, 2.0)
SETTINGS = replace(NeumipSettings(), batch=64)


@pytest.fixture
def queries() -> Queries:
    rng = np.random.default_rng(1)
    count = 256
    directions = np.tile(np.array([0.5, 0.3, 0.8], np.float32), (count, 1))
    return Queries(
        positions=rng.random((count, 2), np.float32),
        levels=np.zeros(count, np.float32),
        lights=directions,
        views=directions,
        faces=np.zeros(count, np.uint8),
        is_transmission=np.zeros(count, np.uint8),
        values=rng.random((count, 3), np.float32),
        holes=np.zeros(count, np.float32),
    )


def _losses(batches: NeumipBatches) -> list[str]:
    return [loss.device.type for loss in batches.losses(3)]


@pytest.mark.parametrize("name", [OURS, WITHOUT])
def test_the_published_recipe(name: str, queries: Queries) -> None:
    network = NeuralTextures(DESIGNS[name], SHAPE).to(DEVICE)
    network.blur = 2.0
    batches = NeumipBatches(network, network.gains, queries, SETTINGS, DEVICE, published_error)
    assert _losses(batches) == [DEVICE]
    # A batch elsewhere is refused: the device tells.
    elsewhere = NeumipBatches(network, network.gains, queries, SETTINGS, "cpu", published_error)
    with pytest.raises(RuntimeError, match="meta"):
        _losses(elsewhere)


@pytest.mark.parametrize("offset", [True, False])
def test_neumip(offset: bool, queries: Queries) -> None:
    network = NeumipNetwork(SHAPE, offset).to(DEVICE)
    assert _losses(NeumipBatches(network, (1.0, 1.0), queries, SETTINGS, DEVICE)) == [DEVICE]


def test_encoded_textures(queries: Queries, monkeypatch: pytest.MonkeyPatch) -> None:
    """How many texels a batch reads is not known without numbers: here all."""

    def all_of(texels: torch.Tensor, return_inverse: bool) -> tuple[torch.Tensor, torch.Tensor]:
        assert return_inverse
        return texels.flatten(), texels

    monkeypatch.setattr(torch, "unique", all_of)
    apparent = np.ones((8, 8, PAIRS, 3), np.float32)
    network = EncodedTextures(DESIGNS[RAINER19], SHAPE, apparent).to(DEVICE)
    assert _losses(TiledBatches(network, queries, SETTINGS, DEVICE)) == [DEVICE]


def _of_table_2(folder: Path) -> None:
    source = paper_heightfield("turtle shell", 16)
    budget = equal_cost.Budget(8, 64, 30, steps=1)
    equal_cost.EqualCost([source], budget, folder, device="cuda").trained(OURS, source)


def _of_neumip(folder: Path) -> None:
    make_model("neumip", fabric_from_text("plain"), folder=folder, device="cuda")


def _of_latent(folder: Path) -> None:
    make_model("latent", fabric_from_text("plain"), folder=folder, device="cuda")


@pytest.mark.parametrize("train", [_of_table_2, _of_neumip, _of_latent])
def test_a_card_that_is_missing_is_said_before_anything_is_made(
    train: Callable[[Path], None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(torch.cuda, "is_available", lambda: False)
    with pytest.raises(InputError, match='device = "cuda" needs an NVIDIA card'):
        train(tmp_path / "made")
    assert not list(tmp_path.rglob("*.safetensors"))
