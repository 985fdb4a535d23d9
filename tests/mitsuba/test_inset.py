"""A close-up in the corner: of so many threads, marked where it was taken."""

from __future__ import annotations

import mitsuba as mi
import numpy as np
import pytest

from loomlight.fabric import load_fabric
from loomlight.mitsuba import build_scene, choose_variant
from loomlight.mitsuba.camera import FIELD_OF_VIEW
from loomlight.mitsuba.inset import FRAME, Inset, composed, framed, resized

choose_variant()
WHITE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.8}}
SIZE = (320, 240)


@pytest.mark.parametrize(
    ("weave", "threads"), [("plain", 18), ("twill 4/4", 20), ("herringbone 2/2 16", 36), ("damask 480", 36)]
)
def test_it_shows_enough_threads_to_name_the_weave(weave: str, threads: int) -> None:
    shown = build_scene("flat", WHITE, size=SIZE)
    inset = Inset.of(load_fabric(weave), shown, SIZE)
    # Half a millimetre a thread where a draft says nothing.
    distance = np.linalg.norm(inset.view.origin - np.array(shown.point))
    assert 2e3 * distance * np.tan(np.radians(FIELD_OF_VIEW) / 2) == pytest.approx(0.5 * threads)
    whole = np.linalg.norm(shown.view.origin - np.array(shown.point))
    assert inset.magnification == pytest.approx(inset.side / 240 * whole / distance)


def test_the_middle_of_any_film_is_cut() -> None:
    shown = build_scene("flat", WHITE, size=SIZE)
    inset = Inset.of(load_fabric("plain"), shown, SIZE)
    film = np.zeros((240, 320, 3), dtype=np.float32)
    film[:, 40:280] = 0.5
    film[60:180, 100:220] = 1
    for picture in (film, film[::2, ::2]):
        cut = inset.cut(picture)
        assert cut.shape == (inset.side, inset.side, 3)
        assert cut.mean() == pytest.approx(0.5 + 0.5 / 4, rel=1e-3)
        assert cut[0, 0, 0] == 0.5


def test_smaller_pictures_are_means_and_larger_ones_interpolated() -> None:
    picture = np.random.default_rng(0).random((6, 9, 3)).astype(np.float32)
    means = picture.reshape(2, 3, 3, 3, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(resized(picture, (3, 2)), means, rtol=1e-5)
    flat = np.full((2, 2, 3), 0.25, dtype=np.float32)
    np.testing.assert_allclose(resized(flat, (5, 7)), 0.25)
    assert resized(flat, (5, 7)).shape == (7, 5, 3)


def test_it_is_composed_of_a_frame_and_a_mark() -> None:
    whole = np.full((240, 320, 3), 0.25, dtype=np.float32)
    inset = np.full((80, 80, 3), 0.5, dtype=np.float32)
    picture = composed(whole, inset, 10.0, 6)
    assert picture.shape == whole.shape
    assert (picture == 0.5).all(axis=2).sum() == 80 * 80
    assert (picture[6 : 6 + FRAME, 6:90] == 1).all()
    # The mark: a line around 8 pixels in the middle, which stay.
    assert (picture[116:124, 156:164] == 0.25).all()
    assert (picture[115, 155:165] == 1).all()
    assert (whole == 0.25).all()
    assert framed(inset, 2).shape == (84, 84, 3)


def test_the_camera_moves_without_new_kernels() -> None:
    import drjit as dr

    from loomlight.mitsuba import render

    shown = build_scene("flat", WHITE, size=(16, 16))
    shown.look_from(shown.view)
    render(shown.scene, spp=1)
    shown.look_from(shown.view.closer(4.0, np.array(shown.point)))
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        render(shown.scene, spp=1)
        kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    assert kernels
    assert all(kernel["cache_hit"] for kernel in kernels)
    assert mi.variant() == "llvm_ad_rgb"
