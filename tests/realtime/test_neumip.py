"""The model neumip in Slang against Dr.Jit: interpolated texels and whole queries.

The bar is that of `queries.py` for single precision. No query searches along rays, so none may miss it.

Covers: realtime/neumip_tables.py
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from drjit.llvm import Array2f
from numpy.typing import NDArray

from loomlight.assets.heightfield import Heightfield
from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text
from loomlight.models.neumip.model import NeumipModel
from loomlight.models.neumip.networks import NETWORKS, Weights
from loomlight.models.neumip.pyramid import CHANNELS, PyramidShape
from loomlight.realtime.tables import Packed, pack_fabrics
from tests.realtime.mapped import mapped
from tests.realtime.queries import directions, share_beyond, vectors

COUNT = 4096


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
    weights = Weights(shape, texels(shape.texels), of_offset, layers, np.full((faces, 3), 0.5, np.float32))
    return NeumipModel(source, weights)


def packed(model: NeumipModel, half: bool = False) -> Packed:
    return pack_fabrics([None], neumip=[model], half=half)


def pairs(rows: NDArray[np.float32]) -> Array2f:
    return Array2f(*(np.ascontiguousarray(column) for column in rows.T))


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
    results = ";".join(("f.x; f.y; f.z", *(f"seen.latent[{k}]" for k in range(CHANNELS))))
    arguments = {"centre": centre, "light": light, "view": view, "dx": dx, "dy": dy}
    bsdf = model.at(vectors(view), Footprint(pairs(centre), pairs(dx), pairs(dy)))
    value = np.array(bsdf.value(vectors(light))).T
    assert value.max() > 0.2
    assert (value[light[:, 2] * view[:, 2] < 0] == 0).all()
    expected = np.concatenate([value, np.array(bsdf._latent).T], axis=1)
    assert (np.ptp(expected, axis=0) > 0.2).all()
    found = mapped("neumip footprint", body, results, arguments, packed(model))
    assert share_beyond(found, expected) == 0
    halves = mapped("neumip footprint", body, results, arguments, packed(model, half=True))
    # Halves round each channel by up to 2⁻¹² of itself; such networks turn that into a few thousandths.
    np.testing.assert_allclose(halves, expected, atol=1e-2)
    assert np.sqrt(np.mean(np.square(halves - expected)[:, :3])) < 1e-3 * np.sqrt(np.mean(value**2))
