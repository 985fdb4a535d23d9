"""The model of a fabric and its options; everything else is in the contract.

Covers: models/latent/settings.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.aggregate.slices import FabricSlices
from loomlight.assets.loom_file import LoomFile, write_loom
from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.footprint import Box, Footprint, box_footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.latent.model import LatentModel
from loomlight.models.latent.settings import QUALITIES, settings_of
from loomlight.models.registry import make_model, model_from_loom
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')


def test_means_of_the_whole_cloth_are_learned_on_both_faces() -> None:
    """The front shows more warp, the back more weft: red and blue."""
    # SOAP needs twice as many steps as this test has.
    model = make_model("latent", TWILL, steps=400, optimiser="adam")
    slices = FabricSlices(
        YarnScattering(YarnGeometry(TWILL.layout()), TWILL.appearance()), llvm_float(), with_colours=True
    )
    width, height = TWILL.repeat_mm
    for side in (1, -1):
        light, view = [0.3, 0.2, 0.93 * side], [-0.2, 0.4, 0.89 * side]
        light, view = ((np.array(v) / np.linalg.norm(v)).tolist() for v in (light, view))
        exact = slices.slice(light, view)
        first = exact.channels.index("red")
        truth = exact.values[first : first + 3].mean(axis=(1, 2))
        footprint = box_footprint(Box(Array2f(0, 0), Array2f(width, height)))
        at = model.at(Array3f(*view), footprint)
        actual = at.value(Array3f(*light)).numpy()[:, 0]
        np.testing.assert_allclose(actual, truth, rtol=0.3, atol=0.006)
        assert (actual[0] > actual[2]) == (truth[0] > truth[2])
        # Shares of light are those of the drawn directions' weights.
        count = 4000
        rng = np.random.default_rng(0)
        numbers = [Float(rng.random(count, np.float32)) for _ in range(3)]
        drawn = at.sample(numbers[0], Array2f(*numbers[1:]))
        mean = drawn.weight.numpy().mean(axis=1)
        np.testing.assert_allclose(at.directional_albedo.numpy()[:, 0], mean, rtol=0.3, atol=0.02)


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
    assert settings_of("full", 32, "3x64", "encoder", "cube-root", 3, 90) == replace(
        QUALITIES["full"],
        resolution=32,
        decoder="3x64",
        rung="encoder",
        loss="cube-root",
        seed=3,
        steps=90,
        sampler_steps=30,
    )


@pytest.mark.parametrize(
    ("setting", "says"),
    [
        ("quality=best", 'quality = "best" does not exist: known are preview, full, published'),
        ("decoder=2x33", 'decoder = "2x33" does not exist'),
        ("rung=frame", 'rung = "frame" does not exist: did you mean frames?'),
        ("resolution=100", "resolution = 100 is wrong: give a power of two from 8 to 1024"),
        ("mips=nearest", 'mips = "nearest" is wrong: give stochastic or trilinear'),
        ("precision=int8", 'precision = "int8" is wrong: give float32 or float16'),
        ("device=tpu", 'device = "tpu" is wrong: give cpu or cuda'),
        ("loss=l2", 'loss = "l2" does not exist'),
    ],
)
def test_a_wrong_option_is_one_sentence(
    setting: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "a.loom"
    assert run(["bake", "plain", "--model", "latent", "-o", str(output), "--set", setting]) == 2
    error = capsys.readouterr().err
    assert says in error
    assert len(error.splitlines()) == 1
    assert not list(tmp_path.iterdir())


def test_a_rung_without_frames_comes_back_from_a_file(tmp_path: Path) -> None:
    chosen = ["rung=encoder", "decoder=2x16", "mips=trilinear", "steps=2", f"folder={tmp_path / 'kept'}"]
    settings = [part for setting in chosen for part in ("--set", setting)]
    assert run(["bake", "plain", "--model", "latent", "-o", str(tmp_path / "a.loom"), *settings]) == 0
    assert (tmp_path / "kept" / "sampler.safetensors").exists()
    model = model_from_loom(tmp_path / "a.loom")
    assert isinstance(model, LatentModel)
    assert model.weights.frames is None
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


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"columns": 3}, "columns = 3 is wrong: it is a power of two up to 4096"),
        ({"columns": 32}, "model.latents is"),
        ({"precision": "int8"}, 'precision = "int8" is wrong: it is one of float32, float16'),
        ({"precision": "float16"}, "model.latents is"),
        ({"faces": 4}, "faces = 4 is wrong"),
        ({"decoder": "9x9"}, 'decoder = "9x9" is wrong: it is one of 2x16, 2x32, 3x64'),
        ({"decoder": "3x64"}, "model.decoder.0.weight is"),
    ],
)
def test_a_file_that_fits_not_is_refused(changes: dict[str, int | str], says: str) -> None:
    loom = make_model("latent", TWILL, steps=1).to_loom()
    wrong = LoomFile(loom.model, loom.source, loom.tensors, {**loom.settings, **changes})
    with pytest.raises(InputError) as caught:
        LatentModel.from_loom(wrong)
    assert says in str(caught.value)
