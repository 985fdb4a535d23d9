"""Designs have the published sizes, and ours as a design is ours as a model.

Covers: evaluation/baselines/designs.py
"""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch", exc_type=ImportError)

from loomlight.evaluation.baselines.designs import DESIGNS, OURS, RAINER19, RAINER20  # noqa: E402
from loomlight.evaluation.baselines.neural_textures import NeuralTextures  # noqa: E402
from loomlight.models.neumip.pyramid import PyramidShape  # noqa: E402
from loomlight.models.neumip.training.network import NeumipNetwork  # noqa: E402

SHAPE = PyramidShape(8, 8, 2.0, 2.0)


@pytest.mark.parametrize(("name", "weights", "channels"), [(RAINER19, 35725, 14), (RAINER20, 38269, 38)])
def test_sizes_are_those_of_table_4(name: str, weights: int, channels: int) -> None:
    design = DESIGNS[name]
    network = NeuralTextures(design, SHAPE)
    counted = sum(p.numel() for part, p in network.named_parameters() if part.startswith("decoder"))
    assert (design.weights, design.channels) == (weights, channels)
    assert counted == weights
    assert network.features[0].shape == (channels, 8, 8)


def test_ours_as_a_design_is_the_model() -> None:
    torch.manual_seed(1)
    model, network = NeumipNetwork(SHAPE, True, 2.0), NeuralTextures(DESIGNS[OURS], SHAPE, 2.0)
    with torch.no_grad():
        model.offset_texture.normal_()
    state = {name: part[0] if part.ndim == 4 else part for name, part in model.state_dict().items()}
    network.load_state_dict(state)
    positions, levels = torch.rand(64, 2), 4 * torch.rand(64)
    lights, views = (0.7 * (2 * torch.rand(64, 2) - 1) for _ in range(2))
    faces = torch.zeros(64, dtype=torch.int64)
    for blur in (0.0, 1.5):
        expected, _ = model(positions, levels, lights, views, faces, blur)
        actual, _ = network(positions, levels, lights, views, faces, blur)
        # The same operations in the same order.
        torch.testing.assert_close(actual, expected, rtol=1e-5, atol=1e-6)


def test_whitened_outputs_are_means_and_deviations() -> None:
    network = NeuralTextures(DESIGNS[RAINER19], SHAPE).eval()
    with torch.no_grad():
        for texture in network.features:
            texture[8:11], texture[11:] = 0.4, 0.0
    shown = network.value(
        *(part.numpy() for part in (torch.rand(8, 2), torch.zeros(8), torch.zeros(8, 2), torch.zeros(8, 2)))
    )
    assert shown == pytest.approx(0.4 / torch.pi, rel=1e-5)
