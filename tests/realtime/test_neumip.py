"""The model neumip in Slang against Dr.Jit: depths, texels and whole queries, and frames against Mitsuba.

The bar is that of `queries.py` for single precision. No query searches along rays, so none may miss it.

Covers: realtime/neumip_tables.py
"""

from __future__ import annotations

from itertools import pairwise

import mitsuba as mi
import numpy as np
import pytest
from drjit.llvm import Array2f, Float, UInt32
from numpy.typing import NDArray

from experiments.realtime_frames import mitsuba_frame
from loomlight.assets.heightfield import Heightfield
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.evaluation.pictures import flip_mean
from loomlight.fabric import fabric_from_text
from loomlight.models.neumip.model import NeumipModel
from loomlight.models.neumip.networks import NETWORKS, Weights
from loomlight.models.neumip.pyramid import CHANNELS, PyramidShape
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.tables import Packed, pack_fabrics
from tests.realtime.mapped import mapped
from tests.realtime.queries import directions, share_beyond, vectors

COUNT = 4096
SIDE = 0.1


def heightfield() -> Heightfield:
    one = np.ones((1, 1), np.float32)
    return Heightfield("tile", (4.0, 2.0), 0.5, 0.5, one, np.ones((1, 1, 3), np.float32), one, 0 * one)


def random_model(faces: int = 2, offset: bool = True) -> NeumipModel:
    """Numbers of the size of trained ones: depths of a few texels, values of a colour."""
    rng = np.random.default_rng(3)
    source = fabric_from_text('weave = "plain"') if faces == 2 else heightfield()
    shape = PyramidShape(16, 8, *source.repeat_mm, faces)
    layers = {
        name: [
            (
                np.float32(rng.normal(0, np.sqrt(2 / before), (after, before))),
                np.float32(rng.normal(0, 0.1, after)),
            )
            for before, after in pairwise(NETWORKS[name])
        ]
        for name in (("decoder", "offset") if offset else ("decoder",))
    }
    layers["decoder"][-1] = (layers["decoder"][-1][0], np.float32([1, 0.8, 0.6]))

    def texels(count: int) -> NDArray[np.float32]:
        return np.float32(rng.normal(0, 0.5, (faces * count, CHANNELS)))

    of_offset = texels(shape.columns * shape.rows) if offset else None
    weights = Weights(
        shape, texels(shape.texels), of_offset, layers, np.full((faces, 3), 0.5, np.float32)
    )
    return NeumipModel(source, weights)


def packed(model: NeumipModel, half: bool = False) -> Packed:
    return pack_fabrics([None], neumip=[model], half=half)


def pairs(rows: NDArray[np.float32]) -> Array2f:
    return Array2f(*(np.ascontiguousarray(column) for column in rows.T))


def test_depths_and_texels() -> None:
    model = random_model()
    rng = np.random.default_rng(4)
    uv, view = np.float32(rng.uniform(-3, 3, (COUNT, 2))), directions(rng, COUNT)[:, :2].copy()
    level, back = np.float32(rng.uniform(-2, 7, COUNT)), rng.random(COUNT) < 0.5
    body = (
        "let depth = neumip_depth(fabric.neumip, uv, view, back ? 1u : 0u);"
        "let texel = neumip_texel(fabric.neumip, uv, level, back ? 1u : 0u);"
    )
    results = "depth;" + ";".join(f"channel(texel, {k})" for k in range(CHANNELS))
    arguments = {"uv": uv, "view": view, "level": level, "back": back}
    found = mapped("neumip", body, results, arguments, packed(model))
    device = model.device_weights(Float)
    u, v = pairs(uv)
    face = UInt32(back)
    expected = [device.depth(u, v, list(pairs(view)), face), *device.latent(u, v, Float(level), face)]
    for column, values in enumerate(expected):
        assert np.ptp(found[:, column]) > 0.5, column
        assert share_beyond(found[:, column], np.array(values)) == 0, column


@pytest.mark.parametrize(("faces", "offset"), [(2, True), (1, False)])
def test_queries_of_neumip(faces: int, offset: bool) -> None:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""
    model = random_model(faces, offset)
    rng = np.random.default_rng(5)
    centre = np.float32(rng.uniform(-8, 8, (COUNT, 2)))
    light, view = directions(rng, COUNT), directions(rng, COUNT)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), COUNT))
    angle, ratio = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0.1, 1, COUNT)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    dx = np.float32(np.stack([cosine, sine], axis=1))
    dy = np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1))
    body = (
        "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy;"
        "NeumipView seen; neumip_view(fabric, p, view, seen); let f = neumip_value(fabric, seen, light);"
    )
    arguments = {"centre": centre, "light": light, "view": view, "dx": dx, "dy": dy}
    bsdf = model.at(vectors(view), Footprint(pairs(centre), pairs(dx), pairs(dy)))
    expected = np.array(bsdf.value(vectors(light))).T
    assert expected.max() > 0.2
    assert (expected[light[:, 2] * view[:, 2] < 0] == 0).all()
    # Halves keep eleven binary places of each channel.
    for half, bar in ((False, 0.0), (True, 0.25)):
        found = mapped("neumip footprint", body, "f.x; f.y; f.z", arguments, packed(model, half))
        assert share_beyond(found, expected) <= bar
        np.testing.assert_allclose(found, expected, atol=5e-3 if half else 1e-4)
