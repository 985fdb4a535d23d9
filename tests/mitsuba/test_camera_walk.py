"""What lies behind holes is blended in: the same picture in the mean, without specks."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import render
from loomlight.mitsuba.bsdf import SceneTraits
from loomlight.mitsuba.plugins import material_bsdf
from tests.marks import slow

LIGHTS = {
    "directional": {"type": "directional", "direction": [0.3, -0.2, -1], "irradiance": 3.0},
    "constant": {"type": "constant", "radiance": 0.7},
}
# Holes are a quarter of it.
CLOTH = 'weave = "plain"\ngap = 0.5'
# Lights and depths of paths.
SLOW = [slow(light, 5) for light in LIGHTS]
WHITE = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.8}}


def layers(light: str, cloth: dict[str, Any] | None = None, size: int = 12) -> Any:
    """Two sheets of open cloth, one tilted, before a white wall."""
    place = mi.ScalarTransform4f
    cloth = cloth or material_bsdf(fabric_from_text(CLOTH), "lobes")((30.0, 30.0))
    sheets = {
        "front": place().translate([-0.5, 0, 0.4]).rotate([0, 1, 0], 30),
        "back": place().translate([0, 0.4, -0.4]),
    }
    return mi.load_dict(
        {
            "type": "scene",
            **{name: {"type": "rectangle", "to_world": to, "bsdf": cloth} for name, to in sheets.items()},
            "wall": {
                "type": "rectangle",
                "to_world": place().translate([0, 0, -1]).scale(4),
                "bsdf": WHITE,
            },
            "light": LIGHTS[light],
            "sensor": {
                "type": "perspective",
                "fov": 30,
                "to_world": place().look_at([0, 0, 4], [0, 0, 0], [0, 1, 0]),
                "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"}},
                "sampler": {"type": "independent"},
            },
        }
    )


@contextmanager
def by_chance(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Paths meet what lies behind holes by chance."""
    of = SceneTraits.of.__func__  # type: ignore[attr-defined]
    with monkeypatch.context() as patch:
        left_out = classmethod(lambda cls, scene: replace(of(cls, scene), filtered_holes=False))
        patch.setattr(SceneTraits, "of", left_out)
        yield


def pictures(scene: Any, depth: int, count: int, spp: int) -> np.ndarray:
    """Grey pictures of different seeds [count, height, width]."""
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": depth})
    each = [render(scene, spp=spp, seed=seed, integrator=integrator) for seed in range(count)]
    return np.array(each, dtype=np.float64)[..., :3].mean(axis=-1)


@pytest.mark.slow
@pytest.mark.parametrize(("light", "depth"), [("directional", 2), *SLOW])
def test_blending_changes_no_expectation(monkeypatch: pytest.MonkeyPatch, light: str, depth: int) -> None:
    scene = layers(light)
    # At four samples shares under 4 % are left to Russian roulette.
    blended = pictures(scene, depth, 24, 4)
    with by_chance(monkeypatch):
        gambled = pictures(scene, depth, 24, 16)
    variance = blended.var(axis=0, ddof=1) / 24 + gambled.var(axis=0, ddof=1) / 24
    z = (blended.mean(axis=0) - gambled.mean(axis=0)) / np.sqrt(np.maximum(variance, 1e-10))
    # Of 144 pixels with 24 pictures a side: rms 1.04 ± 0.07; the whole picture to four standard errors.
    assert np.sqrt(np.mean(z**2)) < 1.3
    assert abs((blended - gambled).mean()) < 4 * np.sqrt(variance.sum()) / variance.size


@pytest.mark.slow
def test_one_sample_has_no_specks(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = layers("directional")
    blended = pictures(scene, 2, 8, 1)[:, 3:-3, 3:-3]
    with by_chance(monkeypatch):
        gambled = pictures(scene, 2, 8, 1)[:, 3:-3, 3:-3]
    # Beside the edges of sheets and of their shadows, which jitter meets or not.
    blended_noise, gambled_noise = (np.median(each.std(axis=0, ddof=1)) for each in (blended, gambled))
    assert blended_noise < 0.02 * blended.mean()
    assert gambled_noise > 0.1 * gambled.mean()


@pytest.mark.slow
def test_derivatives_see_through_holes() -> None:
    """Of the wall's brightness, with which the light that comes off it grows in proportion."""
    scene = layers("directional")
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    params = mi.traverse(scene)
    key = "wall.bsdf.reflectance.value"

    def brightness(value: float) -> float:
        params[key] = mi.Color3f(value)
        params.update()
        return float(np.mean(render(scene, spp=128, seed=1, integrator=integrator)))

    difference = brightness(0.8) - brightness(0.0)
    value = mi.Color3f(0.8)
    dr.enable_grad(value)
    params[key] = value
    params.update()
    dr.backward(dr.mean(mi.render(scene, params, integrator=integrator, spp=512, seed=2), axis=None))
    # 73 728 samples: noise of half a percent.
    np.testing.assert_allclose(np.array(dr.grad(params[key])).sum(), difference / 0.8, rtol=0.02)
