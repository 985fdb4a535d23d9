"""Fibres of kinds of yarn: they lie in their yarns on our crowns, twist and stray as asked, and are shown.

Covers: studies/instruments/fibre_scene.py, studies/instruments/yarn_cloths.py
"""

from __future__ import annotations

import math
from dataclasses import replace

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from drjit.llvm import Bool, Float

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import choose_variant
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.fibre_scene import Shown, fibre_bsdf, fibre_scene
from studies.instruments.fibre_yarns import (
    Window,
    YarnMake,
    fibre_count,
    yarn_curves,
    yarn_lines,
    yarn_makes,
)
from studies.instruments.yarn_cloths import ABSORPTION, OF_GAPS, cloth, flat_scene

require_llvm()

TWILL = fabric_from_text('weave = "twill 2/1"\nyarn = "linen"\n')
STRAIGHT = YarnMake(
    plies=1, ply_twist=0.0, twist=0.0, tilt=0.0, slub=0.0, hairiness=0.0, packing=0.5, fibre=0.02
)
WINDOW = Window(50, 50, 53, 53)


def test_crowns_are_those_of_our_cloth() -> None:
    """Where a thread is on top, within a twentieth of its width, as crowns are smoothed."""
    layout = TWILL.layout()
    warp, weft = yarn_lines(layout)
    geometry = YarnGeometry(layout)
    for pick, end in np.argwhere(layout.warp_on_top):
        x, y = warp[end].centre, weft[pick].centre
        height = Float(geometry.surface(Float(x), Float(y), Bool(False)).height)
        dr.eval(height)
        middle, _ = warp[end].height(np.array([y]))
        assert middle[0] + warp[end].rise == pytest.approx(height[0], abs=warp[end].half_width / 10)
        # The weft's own direction is -x. It lies lower, and the sections have room.
        under, _ = weft[pick].height(np.array([-x]))
        assert under[0] + weft[pick].rise < middle[0]


@pytest.mark.parametrize("plies", [1, 2, 3])
def test_fibres_lie_in_the_tubes_of_their_yarns(plies: int) -> None:
    make = replace(STRAIGHT, plies=plies, ply_twist=0.4, twist=-0.1, tilt=0.2)
    for curves in yarn_curves(TWILL, WINDOW, (make, make)):
        lines = yarn_lines(TWILL.layout())[0 if curves.is_warp else 1]
        line = lines[curves.thread]
        assert len(curves.fibres) == plies * fibre_count(line, make)
        across = np.stack(curves.fibres)[..., 0 if curves.is_warp else 1]
        off = (across - line.centre + 0.5 * line.length) % line.length - 0.5 * line.length
        assert np.abs(off).max() + curves.radius < 1.001 * line.half_width
        # They fill it.
        assert np.abs(off).max() > 0.85 * line.half_width


@pytest.mark.slow
@pytest.mark.parametrize("twist", [-0.4, 0.3])
def test_fibres_twist_as_asked_in_both_families(twist: float) -> None:
    """On top of its yarn a fibre runs along cos ψ e_along − sin ψ e_across; a weft's frame is turned."""
    make = replace(STRAIGHT, twist=twist)
    # On long floats, where yarns are straight.
    floats = fabric_from_text('weave = "twill 8/8"\nyarn = "linen"\n')
    for curves in yarn_curves(floats, Window(50, 50, 59, 59), (make, make), points=12):
        line = yarn_lines(floats.layout())[0 if curves.is_warp else 1][curves.thread]
        points = np.stack(curves.fibres)
        step = np.diff(points, axis=1)[..., :2]
        sideways, along = (step[..., 0], step[..., 1]) if curves.is_warp else (step[..., 1], -step[..., 0])
        own = points[:, :-1, 1] if curves.is_warp else -points[:, :-1, 0]
        middle, slope = line.height(own)
        on_top = (middle + line.rise > line.crown.max() - 1e-3) & (np.abs(slope) < 0.02)
        is_top = on_top & (points[:, :-1, 2] > middle + 0.85 * line.rise)
        # Fibres deeper within are less steep, as those of a rope are.
        slope = (-sideways / along / ((points[:, :-1, 2] - middle) / line.rise))[is_top]
        assert slope.size > 10
        # Crowns are bent, and longer than their middle lines.
        assert slope.mean() == pytest.approx(math.tan(twist), rel=0.06)


def test_fibres_stray_by_the_deviation_asked_for() -> None:
    """Of slopes across, of fibres deep within, which no outline holds back."""
    make = replace(STRAIGHT, tilt=0.15, packing=0.3)
    slopes = []
    for curves in yarn_curves(TWILL, WINDOW, (make, make), points=40):
        line = yarn_lines(TWILL.layout())[0 if curves.is_warp else 1][curves.thread]
        points = np.stack(curves.fibres)
        step = np.diff(points, axis=1)
        side = 0 if curves.is_warp else 1
        off = (points[..., side] - line.centre + 0.5 * line.length) % line.length - 0.5 * line.length
        inner = np.abs(off).max(axis=1) < 0.6 * line.half_width
        slopes.append((step[..., side] / step[..., 1 - side])[inner].ravel())
    assert np.concatenate(slopes).std() == pytest.approx(math.tan(0.15), rel=0.15)


@pytest.mark.slow
def test_hairs_are_as_many_as_the_models_and_leave_the_yarn() -> None:
    """Of a side two in a square of 17 widths of a fibre; a tenth at least stands above all yarns."""
    make = replace(STRAIGHT, hairiness=0.5)
    wide = Window(50, 50, 62, 62)
    threads = yarn_curves(TWILL, wide, (make, make), points=2)
    length = sum(12.0 for _ in threads)
    wanted = 2 * 0.5 * 2 / 17**2 / make.fibre**2 * 2 * yarn_lines(TWILL.layout())[0][0].half_width * length
    found = sum(len(curves.hairs) for curves in threads)
    # Poisson's deviation is 2 %, and cells at the ends stand over.
    assert found == pytest.approx(wanted, rel=0.12)
    heights = np.array([hair[:, 2].max() for curves in threads for hair in curves.hairs])
    crown = max(line.crown.max() for family in yarn_lines(TWILL.layout()) for line in family)
    assert (heights > crown).mean() > 0.1
    assert not yarn_curves(TWILL, WINDOW, (STRAIGHT, STRAIGHT), points=2)[0].hairs


def test_windows_show_the_same_cloth() -> None:
    large, small = (yarn_curves(TWILL, Window(50, 50, size, size)) for size in (54, 52))
    one, other = large[0], next(curves for curves in small if curves.thread == large[0].thread)
    count = other.fibres[0].shape[0] - 3
    np.testing.assert_allclose(one.fibres[3][:count], other.fibres[3][:count], atol=1e-9)


def test_makes_are_those_of_the_fabric_file() -> None:
    warp, weft = yarn_makes(cloth("wool"))
    assert (warp.plies, warp.hairiness, warp.packing) == (2, 1.0, 0.45)
    assert math.degrees(weft.tilt) == pytest.approx(12)
    assert set(ABSORPTION) == set(OF_GAPS)


def test_fibres_are_shown_in_the_place_of_the_cloth() -> None:
    """Fibres fill the picture as the cloth does; the edge of the sheet around them is out of it."""
    choose_variant(None)
    fabric = fabric_from_text('weave = "plain"\nyarn = "filament polyester"\n')
    shown = flat_scene(fabric, 24, 2)
    scene = fibre_scene(fabric, shown, Shown(2, fibres_across=12, points=8))
    aov = mi.load_dict({"type": "aov", "aovs": "place:position"})
    place = np.asarray(mi.render(scene, spp=1, integrator=aov))[..., -3:]
    on_cloth = place[..., 2] > -3
    assert on_cloth.mean() > 0.9
    # Two threads of 0.5 mm; what lies lower is as much farther from the camera, which is 2.2 mm away.
    assert np.abs(place[on_cloth][:, :2]).max() == pytest.approx(0.5, rel=0.2)


def test_gloss_follows_the_roughness_of_the_file() -> None:
    colour = np.array([0.5, 0.5, 0.5])
    silk, wool = (fibre_bsdf(colour, roughness)["longitudinal_roughness"] for roughness in (0.1, 0.6))
    # (0.726 β + 0.812 β²) is the deviation of outgoing light, 1.09 α.
    for rough, alpha in ((silk, 0.1), (wool, 0.6)):
        assert 0.726 * rough + 0.812 * rough**2 == pytest.approx(1.09 * alpha, rel=0.01)
