"""A training is the same however often it is stopped, and learns what it is shown.

Covers: models/texture/neumip_training.py, models/texture/queries.py
Covers: models/texture/btfs.py, models/texture/training.py, training/layers.py
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.aggregate.slices import FabricSlices
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import btf_of, model_from_loom
from loomlight.models.texture.btfs import FabricBtf
from loomlight.models.texture.neumip import NeumipModel, sampler_widths
from loomlight.models.texture.neumip_training import (
    NeumipNetwork,
    gains_of,
    rate_factor,
    sampler_divergence,
    taken_queries,
    train_neumip,
    trained_sampler,
)
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.queries import NeumipStream, Queries
from loomlight.models.texture.settings import NEUMIP_QUALITIES, NeumipSettings
from loomlight.models.texture.training import TrainingFolder
from loomlight.scattering.point import YarnScattering
from loomlight.sources.loom_file import write_loom
from loomlight.training.layers import relu_layers
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.references.gaussian_means import gaussian_means

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')


def short(**changes: int) -> NeumipSettings:
    return replace(NEUMIP_QUALITIES["preview"], resolution=8, queries=60 << 7, steps=30, batch=512, **changes)


@pytest.mark.slow
def test_dark_cloth_is_not_black(tmp_path: Path) -> None:
    """Without `gains_of` 0.92 of what shines through were 0 after 400 steps, and 0.25 of the rest."""
    colours = "".join(f'[{family}]\ncolor = "#101014"\n' for family in ("warp", "weft"))
    cloth = fabric_from_text(f'weave = "twill 2/1"\ninterreflection = false\n{colours}')
    settings = replace(short(), steps=120)
    queries = taken_queries(cloth, FabricBtf(cloth), settings, tmp_path)
    near, far = gains_of(queries)
    assert far > near > 2
    weights = train_neumip(cloth, settings, tmp_path)
    model = NeumipModel(cloth, weights)
    for beyond in (0, 1):
        chosen = queries[np.flatnonzero(queries.is_transmission == beyond)]
        values = shown(model, chosen)
        # Losses of logarithms learn less than means of noisy values; black is −1.
        assert abs(values.mean() / chosen.values.mean() - 1) < 0.3
        assert (values == 0).mean() < 0.12


def shown(model: NeumipModel, queries: Queries) -> NDArray[np.float32]:
    """The model's f·cos [n, 3] for queries."""
    shape = model.weights.shape
    front = np.where(queries.faces == 1, -1, 1)
    turns = front * np.where(queries.is_transmission == 1, -1, 1), front
    light, view = (
        Array3f(*np.ascontiguousarray(xy.T), Float(np.sqrt(1 - np.square(xy).sum(axis=1)) * turn))
        for xy, turn in zip((queries.lights[:, :2], queries.views[:, :2]), turns, strict=True)
    )
    extent = np.array([shape.width_mm, shape.height_mm], np.float32)
    sides = Float(shape.footprint_mm * np.exp2(queries.levels))
    centre = Array2f(np.ascontiguousarray((queries.positions * extent).T))
    found: NDArray[np.float32] = (
        model.at(view, box_footprint(Box(centre, Array2f(sides, sides)))).value(light).numpy()
    )
    return found


@pytest.mark.slow
def test_files_keep_the_sampler_network_which_learns_what_the_decoders_scatter(tmp_path: Path) -> None:
    weights = train_neumip(TWILL, short(), tmp_path / "run")
    file = tmp_path / "twill.loom"
    write_loom(file, NeumipModel(TWILL, weights).to_loom())
    again = model_from_loom(file).weights  # type: ignore[attr-defined]
    for one, other in zip(again.sampler, weights.sampler or [], strict=True):
        assert all(map(np.array_equal, one, other))
    btf = btf_of(TWILL, "neumip")
    network = NeumipNetwork(PyramidShape.of(TWILL.repeat_mm, 8, 2), True, 1.0, btf.transmits, btf.has_holes)
    untrained = relu_layers(sampler_widths(True))
    settings = replace(short(), steps=200)
    layers = trained_sampler(network, settings, TrainingFolder(tmp_path, "this one"))
    trained = relu_layers(sampler_widths(True))
    with torch.no_grad():
        for place, (weight, bias) in zip(trained[::2], layers, strict=True):
            place.weight.copy_(torch.from_numpy(weight))
            place.bias.copy_(torch.from_numpy(bias))
    losses = [
        float(sampler_divergence(network, net, np.random.default_rng(1), 1024).detach())
        for net in (untrained, trained)
    ]
    assert losses[1] < losses[0] - 0.02


@pytest.mark.slow
def test_queries_are_gaussian_means() -> None:
    """Against Gaussian means of slices: the stream's own draws, with enough rays to compare."""
    shape = PyramidShape.of(TWILL.repeat_mm, 16, 2)
    stream = NeumipStream(FabricBtf(TWILL), shape, (400, 400), seed=2)
    queries = stream.part(0, 60)
    assert np.array_equal(stream.part(0, 60).values, queries.values)
    assert not np.array_equal(stream.part(1, 60).positions, queries.positions)
    slices = FabricSlices(
        YarnScattering(YarnGeometry(TWILL.layout()), TWILL.appearance()), llvm_float(), with_colours=True
    )
    errors, truths = [], []
    for k in range(len(queries)):
        side = -1 if queries.faces[k] else 1
        light, view = (
            [*xy, sign * math.sqrt(max(0.0, 1 - float(np.square(xy).sum())))]
            for xy, sign in (
                (queries.lights[k, :2], -side if queries.is_transmission[k] else side),
                (queries.views[k, :2], side),
            )
        )
        sigma = shape.texel_mm / math.sqrt(12) * 2 ** float(queries.levels[k])
        centre = queries.positions[k : k + 1] * np.array(TWILL.repeat_mm)
        exact = slices.slice(light, view)
        first = exact.channels.index("red")
        truth = gaussian_means(exact.grid, exact.values, centre, sigma)[0, first : first + 3]
        errors.append(queries.values[k] - truth)
        truths.append(truth)
    # 400 rays each; the slice's grid errs by a hundredth.
    assert np.abs(errors).sum() < 0.08 * np.abs(truths).sum()
    assert abs(np.sum(errors)) < 0.02 * np.sum(truths)


def test_larger_footprints_have_more_rays() -> None:
    """Of a source that counts them: one for a texel, four for four texels a side, and six for larger ones."""

    class Counting(FabricBtf):
        def values(self, positions: Any, lights: Any, views: Any, seed: Any) -> Any:
            del lights, views, seed
            self.points = positions
            return np.ones((len(positions), 3), np.float32)

    shape = replace(PyramidShape.of(TWILL.repeat_mm, 16, 2), footprint_texels=2)
    btf = Counting(TWILL)
    queries = NeumipStream(btf, shape, (1, 6), seed=2).part(0, 4000)
    assert np.allclose(queries.values, 1)
    assert -1 <= queries.levels.min() < -0.9
    # Twice the repeat, and a little below it.
    assert 4.4 < queries.levels.max() <= np.log2(2 * 16 / 2) + 1
    expected = np.minimum(np.ceil(2 ** (queries.levels + 1)), 6).sum()
    # Filled up to a multiple of a quarter of the queries.
    assert 0 <= len(btf.points) - expected < 1001


def test_queries_of_a_folder_are_read_and_damaged_ones_taken_again(tmp_path: Path) -> None:
    first = taken_queries(TWILL, FabricBtf(TWILL), short(), tmp_path)
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:-100])
    again = taken_queries(TWILL, FabricBtf(TWILL), short(), tmp_path)
    assert np.array_equal(first.values, again.values)
    assert len(first) == 60 * 64 * 2


def test_schedules() -> None:
    assert rate_factor(0.02) == pytest.approx(1, abs=2e-3)
    assert rate_factor(1) == pytest.approx(0, abs=1e-6)


def test_a_source_without_queries_is_refused() -> None:
    with pytest.raises(TypeError, match="is no kind of source"):
        btf_of(Path("a"), "neumip")  # type: ignore[arg-type]  # no source: that is what is refused
