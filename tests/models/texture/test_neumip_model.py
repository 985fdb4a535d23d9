"""The model of a fabric and its options; everything else is in the contract.

Covers: models/texture/settings.py, models/options.py, models/texture/model.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f

from loomlight.aggregate.slices import FabricSlices
from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import make_model, model_from_loom, parse_options
from loomlight.models.texture.neumip import NeumipModel
from loomlight.models.texture.settings import NEUMIP_QUALITIES, NeumipOptions
from loomlight.scattering.point import YarnScattering
from loomlight.sources.loom_file import write_loom
from loomlight.yarn.geometry import YarnGeometry

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')


@pytest.mark.slow
def test_holes_and_light_from_behind_are_learned() -> None:
    """Sheer cloth: the mean over the repeat, as slices have it."""
    sheer = fabric_from_text(
        'weave = "plain"\ngap = 0.4\n[warp]\ncolor = "#c04020"\ntranslucency = 0.6\n'
        '[weft]\ncolor = "#c04020"\ntranslucency = 0.6'
    )
    model = make_model("neumip", sheer, steps=400)
    assert isinstance(model, NeumipModel)
    slices = FabricSlices(
        YarnScattering(YarnGeometry(sheer.layout()), sheer.appearance()), llvm_float(), with_colours=True
    )
    light, view = [0.2, 0.3, -0.93], [-0.2, 0.1, 0.97]
    light, view = ((np.array(v) / np.linalg.norm(v)).tolist() for v in (light, view))
    exact = slices.slice(light, view)
    truth = exact.values.mean(axis=(1, 2))
    first, hole = exact.channels.index("red"), exact.channels.index("hole")
    at = model.at(Array3f(*view), box_footprint(Box(Array2f(0, 0), Array2f(*sheer.repeat_mm))))
    assert at.null_transmission.numpy()[0] == pytest.approx(truth[hole], abs=0.05)
    actual = at.value(Array3f(*light)).numpy()[:, 0]
    np.testing.assert_allclose(actual, truth[first : first + 3], rtol=0.3, atol=0.004)
    assert 0.5 * truth[hole] < model.open_area < 1.5 * truth[hole]


def test_options() -> None:
    actual = parse_options("neumip", ["quality=full", "offset=false", "resolution=32", "seed=3"])
    assert actual.chosen() == {"quality": "full", "offset": False, "resolution": 32, "seed": 3}
    assert isinstance(actual, NeumipOptions)
    full, preview = NEUMIP_QUALITIES["full"], NEUMIP_QUALITIES["preview"]
    assert actual.settings(is_fabric=True) == replace(full, resolution=32, offset=False, seed=3)
    assert parse_options("lobes", []).chosen() == {}
    # Paths cost more than steps: one ray a query.
    traced = NeumipOptions().settings(is_fabric=False)
    assert (traced.max_resolution, traced.samples, traced.batch) == (128, 1, preview.batch // 2)
    assert traced.queries == preview.queries


def test_the_baseline_without_offset_comes_back_from_a_file(tmp_path: Path) -> None:
    arguments = ["--set", "offset=false", "--set", "steps=2", "--set", f"folder={tmp_path / 'kept'}"]
    assert run(["bake", "plain", "--model", "neumip", "-o", str(tmp_path / "a.loom"), *arguments]) == 0
    assert (tmp_path / "kept" / "checkpoint.safetensors").exists()
    model = model_from_loom(tmp_path / "a.loom")
    assert isinstance(model, NeumipModel)
    assert model.weights.offset_texels is None
    # Plain cloth of the default spacing lets light through its yarns.
    assert set(model.weights.layers) - {"opacity"} == {"decoder", "transmission"}
    assert model.weights.shape.footprint_texels == 2
    # Files of before say nothing: their finest level is for footprints of a texel.
    loom = model.to_loom()
    del loom.settings["footprint_texels"]
    assert NeumipModel.from_loom(loom).weights.shape.footprint_texels == 1


@pytest.mark.slow
def test_texels_are_bytes_in_files_and_floats_where_bytes_would_round(tmp_path: Path) -> None:
    """Files of before hold floats: those open too."""
    model = make_model("neumip", TWILL)
    assert isinstance(model, NeumipModel)
    loom = model.to_loom()
    assert loom.tensors["features"].dtype == loom.tensors["offset_texels"].dtype == np.int8
    back = NeumipModel.from_loom(loom)
    for name in ("features", "offset_texels"):
        np.testing.assert_array_equal(getattr(back.weights, name), getattr(model.weights, name))
    finer = replace(model.weights, features=model.weights.features + np.float32(1e-4))
    write_loom(tmp_path / "a.loom", NeumipModel(TWILL, finer).to_loom())
    read = model_from_loom(tmp_path / "a.loom")
    assert isinstance(read, NeumipModel)
    np.testing.assert_array_equal(read.weights.features, finer.features)
    del loom.tensors["features_steps"]
    with pytest.raises(InputError, match=r"features is .* int8: it should be .* float32"):
        NeumipModel.from_loom(loom)


def test_textures_have_about_ten_texels_a_yarn() -> None:
    """Seven warp colours under four picks, 28 yarns a repeat; up to what a quality allows."""
    for weave, colours, columns, rows in (
        ("twill 3/1", 7, 256, 32),
        ("plain", 1, 32, 32),
        ("plain", 30, 256, 16),
    ):
        yarns = ", ".join('"#c04020"' for _ in range(colours))
        cloth = fabric_from_text(
            f'weave = "{weave}"\nends_per_cm = 10\npicks_per_cm = 10\n[warp]\ncolor = [{yarns}]'
        )
        shape = NEUMIP_QUALITIES["full"].shape(cloth, 2)
        assert (shape.columns, shape.rows) == (columns, rows)
