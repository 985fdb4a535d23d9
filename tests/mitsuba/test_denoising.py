"""Denoised pictures: closer to the truth, the same every time, and left alone where asked.

Covers: mitsuba/path.py
"""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.picture_settings import RenderSettings
from loomlight.mitsuba import build_scene, denoising, material_bsdf, render

SIZE = (64, 48)


@pytest.fixture(scope="module")
def draped() -> Any:
    return build_scene("drape", material_bsdf("plain"), size=SIZE)


def shot(shown: Any, **options: Any) -> np.ndarray:
    return render(shown.scene, integrator=shown.integrator, **options)


def error(picture: np.ndarray, reference: np.ndarray) -> float:
    return float(np.sqrt(np.square(picture - reference).mean()))


def test_a_denoised_picture_is_closer_and_the_same_again(draped: Any) -> None:
    # 16 times the samples of what is compared, a quarter of its noise.
    reference = shot(draped, spp=64, seed=9)
    raw, first, again = (shot(draped, spp=4, seed=1, denoise=how) for how in ("off", "auto", "auto"))
    assert first.shape == raw.shape == (48, 64, 3)
    assert first.dtype == np.float32
    assert np.isfinite(first).all()
    # Measured: 0.4 of it, and 0.06 for the noise of the reference.
    assert error(first, reference) < 0.7 * error(raw, reference)
    # Noise goes, brightness stays: within what four samples of 3 000 pixels leave open.
    np.testing.assert_allclose(first.mean(), reference.mean(), rtol=0.01)
    np.testing.assert_allclose(first, again, rtol=1e-5, atol=1e-6)


def test_exposure_is_none_of_the_denoisers_business(draped: Any) -> None:
    plain, bright = (shot(draped, spp=2, denoise="auto", exposure=stops) for stops in (0, 3))
    np.testing.assert_allclose(bright, 8 * plain, rtol=1e-5)


def test_off_changes_nothing_and_leaves_nothing_behind(draped: Any) -> None:
    before = shot(draped, spp=2)
    shot(draped, spp=2, denoise="auto")
    assert not draped.integrator.apart
    # Threads add samples up in an order of their own.
    np.testing.assert_allclose(shot(draped, spp=2, denoise="off"), before, rtol=1e-5, atol=1e-6)


@pytest.mark.slow
def test_films_with_alpha_keep_it() -> None:
    film = {"type": "hdrfilm", "width": 32, "height": 24, "pixel_format": "rgba"}
    film |= {"crop_offset_x": 4, "crop_width": 20}
    camera = mi.ScalarTransform4f().look_at([0, 0, 3], [0, 0, 0], [0, 1, 0])
    parts = {
        "type": "scene",
        "cloth": {"type": "rectangle", "bsdf": {"type": "diffuse"}},
        "light": {"type": "constant"},
        "sensor": {"type": "perspective", "to_world": camera, "film": film},
    }
    scene = mi.load_dict(parts)
    integrator = mi.load_dict({"type": "footprint_path", "hide_emitters": True})
    picture = render(scene, spp=4, integrator=integrator, denoise="auto")
    truth = render(scene, spp=256, integrator=integrator)
    assert picture.shape == truth.shape == (24, 20, 4)
    # Edges of few samples: in trials 0.02.
    assert np.abs(picture - truth).mean() < 0.04


def test_without_the_library_one_sentence_says_so(monkeypatch: pytest.MonkeyPatch, draped: Any) -> None:
    monkeypatch.setattr(denoising, "_MODULE", "no_such_library")
    denoising._library.cache_clear()
    try:
        with pytest.warns(LoomlightWarning, match="not denoised.*pip install mitsuba-oidn"):
            found = shot(draped, spp=2, denoise="auto")
    finally:
        denoising._library.cache_clear()
    np.testing.assert_allclose(found, shot(draped, spp=2), rtol=1e-5, atol=1e-6)


def test_other_ways_are_refused(draped: Any) -> None:
    with pytest.raises(InputError, match='denoise = "on" is unknown: use auto or off'):
        shot(draped, spp=1, denoise="on")
    with pytest.raises(InputError, match="denoise"):
        RenderSettings(denoise="yes")


def test_guides_have_no_noise(draped: Any) -> None:
    """Other seeds give the same guides, but for the places of samples at edges."""
    integrator = draped.integrator
    sensor = draped.scene.sensors()[0]
    first, second = (np.array(integrator.guides(draped.scene, sensor, seed, 8)) for seed in (1, 2))
    assert first.shape == (48, 64, 6)
    noisy = [shot(draped, spp=8, seed=seed) for seed in (1, 2)]
    # Of light; the mean distance of two pictures of as many samples is several times as large.
    change = np.abs(first - second)[..., 3:].mean() / first[..., 3:].mean()
    assert change < 0.5 * np.abs(noisy[0] - noisy[1]).mean() / noisy[0].mean()


def test_guides_in_passes_take_the_lights_of_one(draped: Any) -> None:
    sensor = draped.scene.sensors()[0]

    def light(spp: int, start: int = 0) -> np.ndarray:
        return np.array(draped.integrator.guides(draped.scene, sensor, 1, spp, start))[..., 3:]

    whole, parts = light(8), [light(2, start) for start in (0, 2, 4, 6)]
    # Samples lie elsewhere in their pixels; single parts differ by some hundredths, as lights do.
    np.testing.assert_allclose(np.mean(parts, axis=0).mean(), whole.mean(), rtol=0.02)
    assert np.std([part.mean() for part in parts]) > 0.01 * whole.mean()
