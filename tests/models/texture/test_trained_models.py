"""The models that are trained, `neumip` and `latent`: what they learn, and trainings that are stopped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.aggregate.slices import FabricSlices
from loomlight.core.errors import InputError
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import make_model
from loomlight.models.texture.latent_training import train_latent
from loomlight.models.texture.neumip_training import train_neumip
from loomlight.models.texture.settings import LATENT_QUALITIES, NEUMIP_QUALITIES
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from tests.marks import slow

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')
STEPS = {"neumip": 400, "latent": 800}
TOLERANCES = {"neumip": {"rtol": 0.25, "atol": 0.004}, "latent": {"rtol": 0.3, "atol": 0.006}}


@pytest.mark.slow
@pytest.mark.parametrize("name", [slow("neumip"), "latent"])
def test_means_of_the_whole_cloth_are_learned_on_both_faces(name: str) -> None:
    """The front shows more warp, the back more weft: red and blue."""
    model = make_model(name, TWILL, steps=STEPS[name])
    slices = FabricSlices(
        YarnScattering(YarnGeometry(TWILL.layout()), TWILL.appearance()), llvm_float(), with_colours=True
    )
    for side in (1, -1):
        light, view = [0.3, 0.2, 0.93 * side], [-0.2, 0.4, 0.89 * side]
        light, view = ((np.array(v) / np.linalg.norm(v)).tolist() for v in (light, view))
        exact = slices.slice(light, view)
        first = exact.channels.index("red")
        truth = exact.values[first : first + 3].mean(axis=(1, 2))
        at = model.at(Array3f(*view), box_footprint(Box(Array2f(0, 0), Array2f(*TWILL.repeat_mm))))
        actual = at.value(Array3f(*light)).numpy()[:, 0]
        np.testing.assert_allclose(actual, truth, **TOLERANCES[name])
        assert (actual[0] > actual[2]) == (truth[0] > truth[2])
        if name == "latent":
            # Shares of light are those of the drawn directions' weights, as far as 800 steps learn them: with
            # the rounding of different processors, trainings differ by up to 0.04 in a dark colour.
            rng = np.random.default_rng(0)
            numbers = [Float(rng.random(4000, np.float32)) for _ in range(3)]
            mean = at.sample(numbers[0], Array2f(*numbers[1:])).weight.numpy().mean(axis=1)
            np.testing.assert_allclose(at.directional_albedo.numpy()[:, 0], mean, rtol=0.3, atol=0.05)


class Stopped(Exception):  # noqa: N818 (no error: what a user does)
    """A training is stopped."""


def stopping(every: int) -> Callable[[int, int], None]:
    calls = 0

    def stop(done: int, total: int) -> None:
        nonlocal calls
        calls += 1
        if calls % every == 0:
            raise Stopped

    return stop


def arrays_of(weights: Any) -> list[NDArray[np.float32]]:
    layers = [part for pairs in weights.layers.values() for pair in pairs for part in pair]
    textures = ("features", "offset_texels", "latents", "frames", "reflectance")
    return layers + [getattr(weights, name) for name in textures if hasattr(weights, name)]


@pytest.mark.quick("latent")
@pytest.mark.parametrize("name", STEPS)
def test_a_stopped_training_goes_on_to_the_same_weights(name: str, tmp_path: Path) -> None:
    """In each of its phases."""
    train: Any = train_neumip if name == "neumip" else train_latent
    if name == "neumip":
        short: Any = replace(NEUMIP_QUALITIES["preview"], resolution=8, queries=60 << 7, steps=30, batch=512)
    else:
        short = replace(
            LATENT_QUALITIES["preview"], resolution=8, queries=4000, samples=2, steps=20, batch=256
        )
        short = replace(short, sampler_steps=8, sampler_batch=64)
    whole = train(TWILL, short, tmp_path / "whole")
    stop, stops, resumed = stopping(9), 0, None
    while resumed is None:
        try:
            resumed = train(TWILL, short, tmp_path / "stopped", stop, keep_every=0.0)
        except Stopped:
            stops += 1
    assert stops >= 3
    for actual, wanted in zip(arrays_of(resumed), arrays_of(whole), strict=True):
        assert actual is not None
        assert np.array_equal(actual, wanted)
    # Another seed is another training, which the folder does not mix up.
    with pytest.raises(InputError, match="belongs to another configuration"):
        train(TWILL, replace(short, seed=1), tmp_path / "whole")
