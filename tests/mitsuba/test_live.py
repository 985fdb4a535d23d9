"""Live pictures: edits show at once, as they would in a picture that is traced anew.

Covers: mitsuba/bsdf.py
"""

from __future__ import annotations

import gc
import traceback
import weakref
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, material_bsdf
from loomlight.mitsuba.bsdf import model_bsdfs
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.pixels import samples_are_pixels
from studies.instruments.scene_edits import SceneEdits
from tests.helpers.fabrics import CHEAPEST
from tests.marks import slow

SHEEN = 'weave = "twill 2/1"\n[sheen]\nstrength = 0.5\n'
SHOWN: dict[str, Any] = {"size": (12, 12), "light": "directional", "max_depth": 2, "zoom": 3.0}
# Several values each: a picture that went on showing old memory would be right once.
EDITS = [
    ("warp.diffuse_reflect", ([0.1, 0.2, 0.3], [0.6, 0.5, 0.4], [0.3, 0.1, 0.5])),
    ("weft.roughness", (0.2, 0.6, 0.9)),
    ("warp.height_scale", (0.3, 0.9, 0.6)),
    ("sheen.strength", (0.1, 0.9)),
]


def traced_anew(shown: Any, seed: int) -> np.ndarray:
    return np.array(mi.render(shown.scene, integrator=shown.integrator, spp=1, seed=seed))


records = pytest.mark.parametrize("recorded", [False, True])
slow_unless_recorded = pytest.mark.parametrize("recorded", [slow(False), True])


@pytest.mark.quick("point-True")
@pytest.mark.parametrize(
    ("model", "recorded"),
    # An edit of `clustered` takes its time: what is not recorded is the same for all models.
    [("lobes", True), ("point", True), slow("lobes", False), slow("point", False), slow("clustered", True)],
)
def test_edits_show_as_if_the_picture_were_traced_anew(model: str, recorded: bool) -> None:
    cloth = fabric_from_text(SHEEN)
    shown = build_scene("flat", material_bsdf(cloth, model, **CHEAPEST.get(model, {})), **SHOWN)
    live = LivePicture(shown.scene, integrator=shown.integrator, records=recorded)
    edits = SceneEdits(shown.scene)
    before = live.take(1)
    np.testing.assert_allclose(before, traced_anew(shown, 1), rtol=1e-4, atol=1e-6)
    assert not np.allclose(live.take(2), before, rtol=1e-2)
    kept = []
    for name, values in EDITS:
        for value in values:
            kept.append(edits.apply({name: value}))
            now = live.take(1)
            assert np.abs(now - before).max() > 1e-4
            before = now
        # After the last value: a picture that shows an earlier one is wrong by now.
        # Threads add samples up in an order of their own.
        np.testing.assert_allclose(before, traced_anew(shown, 1), rtol=1e-4, atol=1e-6)
    # Pictures traced anew every time would pass all of the above.
    assert (live._launch.n_cached_recordings > 0) == recorded


@pytest.mark.slow
@slow_unless_recorded
def test_another_weave_shows(recorded: bool) -> None:
    shown = build_scene("flat", material_bsdf("twill 2/1"), **SHOWN)
    live = LivePicture(shown.scene, integrator=shown.integrator, records=recorded)
    (cloth,) = (s.bsdf() for s in shown.scene.shapes() if s.bsdf() in model_bsdfs())
    before = live.take(1)
    for weave in ("satin 5/2", "plain"):
        cloth.set_source(fabric_from_text(weave))
        now = live.take(1)
        np.testing.assert_allclose(now, traced_anew(shown, 1), rtol=1e-4, atol=1e-6)
        assert np.abs(now - before).max() > 1e-2
        before = now
    other = build_scene("flat", material_bsdf("plain"), **SHOWN)
    np.testing.assert_allclose(before, traced_anew(other, 1), rtol=1e-3, atol=1e-4)


def test_no_samples_is_a_fault() -> None:
    shown = build_scene("flat", {"type": "diffuse"}, **SHOWN)
    with pytest.raises(InputError, match="spp = 0"):
        LivePicture(shown.scene, spp=0)


@pytest.mark.slow
def test_nothing_refers_to_itself() -> None:
    """What refers to itself lives until Python's collector runs: were that while calls are traced, freeing
    a BSDF would end the process.
    """
    gc.collect()
    gc.disable()
    try:
        shown = build_scene("flat", material_bsdf("plain"), **SHOWN)
        cloths = {weakref.ref(s.bsdf()) for s in shown.scene.shapes() if s.bsdf() in model_bsdfs()}
        live = LivePicture(shown.scene, integrator=shown.integrator)
        SceneEdits(shown.scene).apply({"weft.roughness": 0.3})
        live.take(1)
        assert len(cloths) == 1
        del live, shown
        assert [cloth() for cloth in cloths] == [None]
    finally:
        gc.enable()


@pytest.mark.slow
@records
def test_nothing_is_collected_while_calls_are_traced(recorded: bool) -> None:
    shown = build_scene("flat", material_bsdf("plain"), **SHOWN)
    live = LivePicture(shown.scene, integrator=shown.integrator, records=recorded)
    shown.scene.shapes()[0].bsdf().set_source(fabric_from_text(SHEEN))
    seen: list[str] = []

    def look(phase: str, facts: dict[str, int]) -> None:
        stack = traceback.extract_stack()
        seen.append("traced" if any(frame.name == "_loop_body" for frame in stack) else "elsewhere")

    thresholds = gc.get_threshold()
    gc.callbacks.append(look)
    gc.set_threshold(5, 2, 2)
    try:
        live.take(2)
    finally:
        gc.set_threshold(*thresholds)
        gc.callbacks.remove(look)
    # Otherwise the threshold would have been too high to see anything.
    assert "elsewhere" in seen
    assert "traced" not in seen


FILMS = {
    "colours": {"rfilter": {"type": "box"}},
    "transparent": {"rfilter": {"type": "box"}, "pixel_format": "rgba"},
    "a part": {"rfilter": {"type": "box"}, "crop_offset_x": 3, "crop_width": 7, "crop_height": 9},
    "grey": {"rfilter": {"type": "box"}, "pixel_format": "luminance"},
    "smooth": {"rfilter": {"type": "gaussian"}},
}


def filmed(film: dict[str, Any]) -> Any:
    """A ball of cloth in the sun, as a film of 12 by 10 pixels shows it."""
    camera = {
        "type": "perspective",
        "fov": 25,
        "to_world": mi.ScalarTransform4f().look_at([0, 0, 6], [0.2, 0.1, 0], [0, 1, 0]),
        "film": {"type": "hdrfilm", "width": 12, "height": 10, **film},
    }
    ball = {"type": "sphere", "bsdf": material_bsdf("twill 2/1", "lobes")((200.0, 200.0))}
    light = {"type": "directional", "direction": [-0.3, -0.4, -1.0]}
    return mi.load_dict({"type": "scene", "ball": ball, "sun": light, "sensor": camera})


@pytest.mark.quick("1-smooth")
@pytest.mark.parametrize("film", FILMS)
@pytest.mark.parametrize("spp", [1, 2])
def test_pictures_are_what_the_film_would_show(film: str, spp: int) -> None:
    scene = filmed(FILMS[film])
    alone = film in ("colours", "transparent", "a part") and spp == 1
    assert samples_are_pixels(scene.sensors()[0], spp) == alone
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    live = LivePicture(scene, spp=spp, integrator=integrator)
    found = live.take(3)
    wanted = np.array(mi.render(scene, integrator=integrator, spp=spp, seed=3))
    assert found.shape == wanted.shape
    assert wanted.std() > 0.02
    np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=1e-6)
    # Who renders without us may ask the film afterwards.
    developed = np.array(scene.sensors()[0].film().bitmap(), dtype=np.float32)
    assert developed.std() > 0.02
