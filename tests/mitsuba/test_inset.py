"""A close-up in the corner: of so many threads, marked where it was taken."""

from __future__ import annotations

import gc

import mitsuba as mi
import numpy as np
import pytest

from loomlight.fabric import load_fabric
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.mitsuba.camera import FIELD_OF_VIEW, View
from loomlight.mitsuba.pictures import FRAME, Inset, resized

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


@pytest.mark.slow
def test_the_corner_is_the_picture_from_nearer() -> None:
    """Against a picture of its own from there: same means of texture, footprints and shading."""
    size, cloth = (240, 180), material_bsdf(load_fabric("twill 3/1"))
    shown = build_scene("drape", cloth, size=size)
    inset = Inset.of(load_fabric("twill 3/1"), shown, size)
    shown.integrator.corner = inset.corner
    actual = render(shown.scene, spp=64, integrator=shown.integrator, denoise="off")
    near = build_scene("drape", cloth, size=(inset.side, inset.side))
    near.look_from(inset.view)
    expected, again = (
        render(near.scene, spp=64, seed=seed, integrator=near.integrator, denoise="off") for seed in (1, 2)
    )
    square = slice(inset.margin, inset.margin + inset.side)
    # Pixels at the edges get their neighbours' samples.
    inner = (slice(2, -2), slice(2, -2))
    difference, noise = (actual[square, square] - expected)[inner], (again - expected)[inner]
    assert np.abs(difference.mean(axis=(0, 1))).max() < 0.01 * expected.mean()
    # No more than what two pictures differ by; texture is several times as much.
    assert np.square(difference).mean() < 1.2 * np.square(noise).mean()
    assert np.var(expected[inner]) > 8 * np.square(noise).mean()


def test_smaller_pictures_are_means_and_larger_ones_interpolated() -> None:
    picture = np.random.default_rng(0).random((6, 9, 3)).astype(np.float32)
    means = picture.reshape(2, 3, 3, 3, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(resized(picture, (3, 2)), means, rtol=1e-5)
    flat = np.full((2, 2, 3), 0.25, dtype=np.float32)
    np.testing.assert_allclose(resized(flat, (5, 7)), 0.25)
    assert resized(flat, (5, 7)).shape == (7, 5, 3)


def test_it_is_framed_and_marked() -> None:
    view = View(np.zeros(3), np.ones(3))
    inset = Inset(view, (320, 240), side=80, margin=8, magnification=10.0)
    whole = np.full((240, 320, 3), 0.25, dtype=np.float32)
    picture = inset.drawn_on(whole)
    assert picture.shape == whole.shape
    assert (picture[8:88, 8:88] == 0.25).all()
    assert (picture[8 - FRAME : 8, 8 - FRAME : 88 + FRAME] == 1).all()
    assert (picture[88 : 88 + FRAME, 8 - FRAME : 88 + FRAME] == 1).all()
    # The mark: a line around 8 pixels in the middle, which stay.
    assert (picture[116:124, 156:164] == 0.25).all()
    assert (picture[115, 155:165] == 1).all()
    assert (picture == 1).all(axis=2).sum() == (84**2 - 80**2) + (10**2 - 8**2)
    assert (whole == 0.25).all()


def test_close_ups_of_all_fabrics_share_a_kernel() -> None:
    import drjit as dr

    # Kernels know of all living BSDFs: none may die in between.
    gc.collect()
    shown = build_scene("flat", WHITE, size=SIZE)
    for weave in ("plain", "damask 480"):
        shown.integrator.corner = Inset.of(load_fabric(weave), shown, SIZE).corner
        with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
            dr.kernel_history_clear()
            render(shown.scene, spp=1, integrator=shown.integrator)
            kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    assert kernels
    assert all(kernel["cache_hit"] for kernel in kernels)


@pytest.mark.parametrize("view", ["back", "top", "bottom", "-100,35"])
def test_the_close_up_shows_cloth_from_every_side(view: str) -> None:
    """Its axis meets the cloth first, and not the ball from below, which is left out with the floor."""
    fabric = load_fabric("plain")
    shown = build_scene("drape", WHITE, size=SIZE, view=view)
    inset = Inset.of(fabric, shown, SIZE)
    ray = mi.Ray3f(inset.view.origin.tolist(), (-shown.view.backward).tolist())
    hit = shown.scene.ray_intersect(ray)
    np.testing.assert_allclose(np.array(hit.p).ravel(), shown.point, atol=1e-3)
