"""Designs have the published sizes, and ours as a design is ours as a model.

Covers: studies/papers/kuznetsov2021/neural_textures.py
Covers: studies/papers/kuznetsov2021/designs.py, studies/papers/kuznetsov2021/encoded_textures.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch", exc_type=ImportError)

# These need torch: they follow the line that skips the file without it.
from loomlight.models.registry import btf_of  # noqa: E402
from loomlight.models.texture.neumip import quantised  # noqa: E402
from loomlight.models.texture.neumip_training import NeumipNetwork, gains_of, taken_queries  # noqa: E402
from loomlight.models.texture.pyramid import PyramidShape, Taps  # noqa: E402
from loomlight.models.texture.queries import Queries  # noqa: E402
from loomlight.models.texture.settings import NeumipSettings  # noqa: E402
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, RAINER19, RAINER20  # noqa: E402
from studies.papers.kuznetsov2021.encoded_textures import (  # noqa: E402
    PAIRS,
    EncodedTextures,
    TiledBatches,
    apparent_brdfs,
    trained_encodings,
)
from studies.papers.kuznetsov2021.materials import paper_heightfield  # noqa: E402
from studies.papers.kuznetsov2021.neural_textures import NeuralTextures, blur_of, blurred  # noqa: E402

SHAPE = PyramidShape(8, 8, 2.0, 2.0)


@pytest.mark.parametrize(("name", "weights", "channels"), [(RAINER19, 35725, 14), (RAINER20, 38269, 38)])
def test_sizes_are_those_of_table_4(name: str, weights: int, channels: int) -> None:
    design = DESIGNS[name]
    network = NeuralTextures(design, SHAPE)
    counted = sum(p.numel() for part, p in network.named_parameters() if part.startswith("decoder"))
    assert (design.weights, design.channels) == (weights, channels)
    assert counted == weights
    assert network.features[0].shape == (channels, 8, 8)


def test_encoded_textures_are_those_of_their_apparent_brdfs() -> None:
    """Two materials share networks; texels of coarse levels have the colours of means."""
    rng = np.random.default_rng(1)
    apparent = rng.random((2, 8, 8, PAIRS, 3), np.float32)
    first = EncodedTextures(DESIGNS[RAINER19], SHAPE, apparent[0])
    second = EncodedTextures(DESIGNS[RAINER19], SHAPE, apparent[1], networks=(first.encoder, first.decoder))
    assert first.decoder is second.decoder
    rows = first.rows().detach().numpy()
    assert rows.shape == (SHAPE.texels, 14)
    for level in range(SHAPE.levels):
        found = rows[
            SHAPE.starts[level] : SHAPE.starts[level] + SHAPE.sizes[level][0] * SHAPE.sizes[level][1]
        ]
        # Means of means over as many texels.
        wanted = np.pi * apparent[0].mean(axis=(0, 1, 2))
        np.testing.assert_allclose(found[:, 8:11].mean(axis=0), wanted, rtol=1e-4)
    assert np.allclose(rows[:64, 8:11], np.pi * apparent[0].mean(axis=2).reshape(64, 3), rtol=1e-4)


@pytest.mark.slow
def test_encoders_learn_two_materials_at_once(tmp_path: Path) -> None:
    """The error of both falls; the folder keeps what is measured, and the training."""
    sources = [paper_heightfield(name, 16) for name in ("straight wool", "cliff rock")]
    settings = replace(NeumipSettings(), resolution=8, queries=60 * 8**2, samples=2, batch=1024)
    design = DESIGNS[RAINER20]
    queries = [taken_queries(source, btf_of(source, "neumip"), settings, tmp_path) for source in sources]
    apparent = [apparent_brdfs(source, settings, tmp_path, 2) for source in sources]
    losses = []
    for steps in (1, 60):
        torch.manual_seed(1)
        first = EncodedTextures(design, SHAPE, apparent[0], gains_of(queries[0]))
        networks = first.encoder, first.decoder
        second = EncodedTextures(design, SHAPE, apparent[1], gains_of(queries[1]), networks)
        used, folder = replace(settings, steps=steps), tmp_path / f"{steps}"
        trained_encodings(design, (first, second), queries, used, folder, "two")
        errors = []
        for known, textures in zip(queries, (first, second), strict=True):
            lights, views = known.lights[:, :2], known.views[:, :2]
            shown = textures.value(known.positions, known.levels, lights, views)
            errors.append(np.square(shown - known.values).mean())
        losses.append(errors)
    assert (np.array(losses[1]) < 0.7 * np.array(losses[0])).all()
    assert len(list(tmp_path.glob("apparent-*"))) == 2


def test_only_texels_that_are_read_are_encoded() -> None:
    rng = np.random.default_rng(2)
    network = EncodedTextures(DESIGNS[RAINER19], SHAPE, rng.random((8, 8, PAIRS, 3), np.float32))
    taps = Taps([torch.tensor([3, 7]), torch.tensor([7, 60])], [torch.tensor([0.5, 1.0]), torch.ones(2)])
    rows = network.rows()
    wanted = torch.stack([0.5 * rows[3] + rows[7], rows[7] + rows[60]])
    torch.testing.assert_close(network.texels(taps), wanted)
    seen: list[int] = []
    network.encoder.register_forward_hook(lambda module, inputs, output: seen.append(len(inputs[0])))
    network.texels(taps)
    assert seen == [3]


def test_a_batch_is_of_one_tile_and_a_pass_has_every_query_once() -> None:
    rng = np.random.default_rng(3)
    count, batch = 1 << 12, 64
    columns = {
        "positions": rng.random((count, 2), np.float32),
        "levels": np.zeros(count, np.float32),
        "lights": np.zeros((count, 3), np.float32),
        "views": np.zeros((count, 3), np.float32),
        "faces": np.zeros(count, np.uint8),
        "is_transmission": np.zeros(count, np.uint8),
        "values": np.zeros((count, 3), np.float32),
        "holes": np.zeros(count, np.float32),
    }
    network = EncodedTextures(DESIGNS[RAINER19], SHAPE, np.ones((8, 8, PAIRS, 3), np.float32))
    batches = TiledBatches(network, Queries(**columns), replace(NeumipSettings(), batch=batch), "cpu")
    order, second = (
        np.concatenate([batches._chosen(first + step) for step in range(count // batch)])
        for first in (0, count // batch)
    )
    assert sorted(order) == sorted(second) == list(range(count))
    assert not np.array_equal(order, second)
    tiles = np.floor(4 * columns["positions"][order]).reshape(-1, batch, 2)
    spread = [len(np.unique(part, axis=0)) for part in tiles]
    # A batch at the border of two tiles has both.
    assert np.mean(np.array(spread) == 1) > 0.7
    assert max(spread) == 2


def test_ours_as_a_design_is_the_model() -> None:
    torch.manual_seed(1)
    model, network = NeumipNetwork(SHAPE, True, 2.0), NeuralTextures(DESIGNS[OURS], SHAPE, 2.0)
    with torch.no_grad():
        network.offset_texture.normal_()
        # Both divide their textures by the scale.
        model.features.copy_(network.rows() / 2)
        model.offset_texture.copy_(network.offset_texture.permute(1, 2, 0).flatten(0, 1))
    model.decoder.load_state_dict(network.decoder.state_dict())
    model.offset.load_state_dict(network.offset.state_dict())
    positions, levels = torch.rand(64, 2), 4 * torch.rand(64)
    lights, views = (0.7 * (2 * torch.rand(64, 2) - 1) for _ in range(2))
    faces = torch.zeros(64, dtype=torch.int64)
    expected, _ = model(positions, levels, lights, views, faces)
    actual, _ = network(positions, levels, lights, views, faces)
    # The same operations in the same order.
    torch.testing.assert_close(actual, expected, rtol=1e-5, atol=1e-6)
    # Those of the model are rounded to bytes.
    features = np.multiply(*quantised(network.weights().features))
    np.testing.assert_allclose(features, model.weights(np.zeros((1, 3), np.float32)).features)


def test_a_blur_is_a_periodic_gaussian() -> None:
    texture = torch.zeros(1, 1, 16, 32)
    texture[..., 0, 0] = 1
    found = blurred(texture, 1.5)[0, 0].numpy()
    along, across = (np.minimum(np.arange(n), n - np.arange(n)) for n in (16, 32))
    wanted = np.exp(-(along[:, None] ** 2 + across**2) / (2 * 1.5**2))
    # Its integral over texels differs from its values by less.
    np.testing.assert_allclose(found, wanted / wanted.sum(), atol=1e-4)
    assert blurred(texture, 0.01) is texture


def test_schedules() -> None:
    shape = PyramidShape(512, 512, 1.0, 1.0)
    assert blur_of(shape, 0) == 8
    # A half-life of 3333 of 30 000 steps.
    assert blur_of(shape, 1 / 9) == pytest.approx(4)
    assert blur_of(PyramidShape(16, 16, 1.0, 1.0), 0) == 2


def test_whitened_outputs_are_means_and_deviations() -> None:
    network = NeuralTextures(DESIGNS[RAINER19], SHAPE).eval()
    with torch.no_grad():
        for texture in network.features:
            texture[8:11], texture[11:] = 0.4, 0.0
    shown = network.value(
        *(part.numpy() for part in (torch.rand(8, 2), torch.zeros(8), torch.zeros(8, 2), torch.zeros(8, 2)))
    )
    assert shown == pytest.approx(0.4 / torch.pi, rel=1e-5)
