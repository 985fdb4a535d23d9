"""The model of a fabric and its options; everything else is in the contract.

Covers: models/texture/settings.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.cli.main import run
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import make_model, model_from_loom
from loomlight.models.texture.latent import LatentModel
from loomlight.models.texture.settings import LATENT_QUALITIES, LatentOptions
from loomlight.sources.loom_file import write_loom

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')


@pytest.mark.slow
def test_levels_are_chosen_in_proportion_to_their_distance() -> None:
    """The mean of stochastic values is the mixture of both levels' values; trilinear ones mix latents."""
    trained = make_model("latent", TWILL, steps=30)
    assert isinstance(trained, LatentModel)
    stochastic, trilinear = (
        LatentModel(TWILL, trained.weights, mips) for mips in ("stochastic", "trilinear")
    )
    texel, count = trained.weights.shape.texel_mm, 4000
    light = Array3f(0.2, 0.1, 0.97)

    def values(model: LatentModel, level: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float32]]:
        side = texel * 2.0**level
        # Edges that differ in their last digits, as those of samples do.
        jitter = Float(1 + 1e-4 * np.random.default_rng(1).random(count, np.float32))
        footprint = Footprint(
            Array2f(0.3, 0.2), Array2f(side * jitter, dr.zeros(Float, count)), Array2f(0, side / jitter)
        )
        found: np.ndarray[tuple[int, ...], np.dtype[np.float32]] = (
            model.at(Array3f(0.1, 0.0, 0.995), footprint).value(light).numpy()
        )
        return found

    low, high, between = (values(stochastic, level) for level in (0.0, 1.0, 0.3))
    assert abs((np.isclose(between, high, rtol=1e-4).all(axis=0)).mean() - 0.3) < 0.04
    assert np.isclose(between, low, rtol=1e-4)[0].mean() > 0.6
    np.testing.assert_allclose(values(trilinear, 1.0), high, rtol=1e-3)
    assert np.ptp(values(trilinear, 0.3), axis=1).max() < 1e-3
    assert trilinear.bytes_fetched == 2 * stochastic.bytes_fetched


def test_options() -> None:
    chosen = LatentOptions(
        quality="full",
        resolution=32,
        decoder="3x64",
        rung="encoder",
        loss="cube-root",
        seed=3,
        steps=90,
        features="none",
    )
    assert chosen.settings() == replace(
        LATENT_QUALITIES["full"],
        resolution=32,
        decoder="3x64",
        rung="encoder",
        features="none",
        loss="cube-root",
        seed=3,
        steps=90,
        sampler_steps=30,
    )


@pytest.mark.slow
def test_a_rung_without_frames_comes_back_from_a_file(tmp_path: Path) -> None:
    chosen = [
        "rung=encoder",
        "decoder=2x16",
        "features=none",
        "mips=trilinear",
        "steps=2",
        f"folder={tmp_path / 'kept'}",
    ]
    settings = [part for setting in chosen for part in ("--set", setting)]
    assert run(["bake", "plain", "--model", "latent", "-o", str(tmp_path / "a.loom"), *settings]) == 0
    assert (tmp_path / "kept" / "sampler.safetensors").exists()
    model = model_from_loom(tmp_path / "a.loom")
    assert isinstance(model, LatentModel)
    assert model.weights.frames is None
    assert not model.weights.with_features
    assert model.weights.hidden == (16, 16)
    assert model.mips == "trilinear"


def test_half_precision_is_half_a_file_and_draws_alike(tmp_path: Path) -> None:
    whole = make_model("latent", TWILL, steps=2)
    assert isinstance(whole, LatentModel)
    half = LatentModel(TWILL, whole.weights, precision="float16")
    write_loom(tmp_path / "whole.loom", whole.to_loom())
    write_loom(tmp_path / "half.loom", half.to_loom())
    read = model_from_loom(tmp_path / "half.loom")
    assert isinstance(read, LatentModel)
    assert read.precision == "float16"
    assert (tmp_path / "half.loom").stat().st_size < 0.55 * (tmp_path / "whole.loom").stat().st_size
    footprint = Footprint(Array2f(0.3, 0.2), Array2f(0.1, 0), Array2f(0, 0.1))
    light = Array3f(0.2, 0.1, 0.97)
    exact, stored, again = (
        model.at(Array3f(0.1, 0, 0.995), footprint).value(light).numpy() for model in (whole, half, read)
    )
    np.testing.assert_array_equal(stored, again)
    # A few roundings of 2^-11 in the exponent.
    np.testing.assert_allclose(stored, exact, rtol=5e-3)
