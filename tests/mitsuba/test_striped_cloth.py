"""Stripes of cloth are as sharp as the point model's samples show them."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import render
from loomlight.mitsuba.plugins import material_bsdf
from tests.marks import slow

# Pixels of the picture, threads a pixel, and threads of a stripe.
COLUMNS, ROWS, THREADS, STRIPE = 24, 48, 4, 40


def picture(model: str, spp: int, rfilter: str, seeds: range) -> np.ndarray:
    """Means of columns of flat cloth whose black and white stripes go up and down [width].

    Args:
        seeds: of the pictures to average.
    """
    colours = ", ".join(['"#000000"'] * STRIPE + ['"#ffffff"'] * STRIPE)
    fabric = fabric_from_text(
        'weave = "satin 5/2"\nends_per_cm = 20\npicks_per_cm = 20\n'
        f'[warp]\ncolor = [{colours}]\nspecular = 0.0\n[weft]\ncolor = "#000000"\nspecular = 0.0\n'
    )
    place = mi.ScalarTransform4f
    # A unit of uv is the plate, 4 by 8 units; the picture shows 2 by 4.
    uv_size = (2 * COLUMNS * THREADS * 0.5, 2 * ROWS * THREADS * 0.5)
    scene: dict[str, Any] = {
        "type": "scene",
        "cloth": {
            "type": "rectangle",
            "to_world": place().scale([2, 4, 1]),
            "bsdf": material_bsdf(fabric, model)(uv_size),
        },
        "light": {"type": "directional", "direction": [0.3, -0.2, -1]},
        "sensor": {
            "type": "orthographic",
            "to_world": place().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0]),
            "film": {"type": "hdrfilm", "width": COLUMNS, "height": ROWS, "rfilter": {"type": rfilter}},
            "sampler": {"type": "multijitter"},
        },
    }
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    loaded = mi.load_dict(scene)
    shown = [render(loaded, spp=spp, seed=seed, integrator=integrator) for seed in seeds]
    return np.asarray(np.mean(shown, axis=0)[..., :3].mean(axis=(0, 2)))


@pytest.mark.slow
@pytest.mark.parametrize("rfilter", ["box", slow("gaussian")])
def test_edges_of_stripes_are_those_of_many_point_samples(rfilter: str) -> None:
    truth = picture("point", 256, rfilter, range(4))
    step = truth.max() - truth.min()
    for spp in (1, 16):
        # As many samples in all: at an edge the places of 64 % of the variance leave noise.
        shown = picture("lobes", spp, rfilter, range(16 // spp))
        # The model's own brightness may be off by a few percent: compared is the shape.
        shown = (shown - shown.min()) / (shown.max() - shown.min()) * step + truth.min()
        error = np.abs(shown - truth).max() / step
        assert error < 0.03, (rfilter, spp, error)
