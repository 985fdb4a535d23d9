"""Albedo maps: levels are means, and frames far away are tinted as Mitsuba's."""

from __future__ import annotations

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import fabric_from_text
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.scene import map_words
from studies.accuracy.realtime_frames import mitsuba_frame


def unpacked(words: np.ndarray) -> np.ndarray:
    return np.square(np.stack([(words >> shift) & 1023 for shift in (0, 10, 20)], axis=-1) / 1023)


def test_levels_are_means() -> None:
    texels = np.random.default_rng(0).uniform(size=(8, 8, 3))
    words, levels = map_words(texels)
    assert levels == 4
    assert words.size == 64 + 16 + 4 + 1
    np.testing.assert_allclose(unpacked(words[:64]).reshape(8, 8, 3), texels, atol=1e-3)
    np.testing.assert_allclose(unpacked(words[-1:])[0], texels.mean(axis=(0, 1)), atol=1e-3)


def test_other_sizes_are_resampled() -> None:
    words, levels = map_words(np.full((3, 5, 3), 0.25))
    assert levels == 4
    np.testing.assert_allclose(unpacked(words), 0.25, atol=1e-3)


@pytest.mark.slow
def test_frames_are_tinted_as_those_of_mitsuba() -> None:
    """A map that is unlike in all four corners, so that a turned one would show."""
    mi.set_variant("llvm_ad_rgb")
    text = 'weave = "plain"\n[warp]\ncolor = "#d0d0d0"\n[weft]\ncolor = "#d0d0d0"\n'
    row, column = np.mgrid[:64, :64] / 64
    wave = 0.5 + 0.5 * np.sin(4 * np.pi * row) * np.sin(4 * np.pi * column)
    albedo = np.stack([row, column, wave], axis=-1)
    cloths = [Cloth(rectangle(0.1, 0.1), fabric_from_text(text), albedo=albedo)]
    camera, size, lights = Camera((0, 0, 0.2)), (24, 24), [DirectionalLight((0.2, 0.1, 1))]
    found = Renderer(cloths, size, "point").render(camera, lights, passes=4, samples=32).linear[..., :3]
    expected = mitsuba_frame(cloths, camera, size, lights, spp=128)
    assert flip_mean(found, expected, np.ones(size, bool)) <= 0.03


def test_what_is_no_picture_is_one_sentence() -> None:
    fabric = fabric_from_text('weave = "plain"\n')
    with pytest.raises(InputError, match=r"albedo of shape \(4, 4\) is no picture"):
        Cloth(rectangle(0.1, 0.1), fabric, albedo=np.zeros((4, 4)))
