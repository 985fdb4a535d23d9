"""The model clustered in Slang against Dr.Jit: base and residual of whole queries, and the mean of frames.

The bar is that of `queries.py`. Footprints end at whole texels: rounding decides a few queries otherwise.

Covers: realtime/words.py
"""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import UInt
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import Fabric
from loomlight.models.clustered.model import ClusteredModel
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.words import Packed, pack_fabrics
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import share_beyond
from tests.helpers.slang import mapped
from tests.helpers.untrained import IRREGULAR_TWILL, OPEN_TWILL, small_clustered, with_samples

require_llvm()
COUNT = 4096
# Of two texels and a box: each may fall on another side of an edge.
MAX_FLIPS = 4e-3


def packed(model: ClusteredModel) -> Packed:
    fabric = model.fabric
    return pack_fabrics([(fabric.layout(), fabric.appearance())], None, [model.shader_tables()])


def queries() -> dict[str, NDArray[np.generic]]:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""
    rng = np.random.default_rng(5)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), COUNT))
    angle, ratio = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0.1, 1, COUNT)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    return {
        "centre": np.float32(rng.uniform(-5, 5, (COUNT, 2))),
        "dx": np.float32(np.stack([cosine, sine], axis=1)),
        "dy": np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1)),
        "light": clear_of_the_plane(rng, COUNT),
        "view": clear_of_the_plane(rng, COUNT),
        "seed": rng.integers(1, 2**32, COUNT, dtype=np.uint32),
    }


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rank", "samples", "fabric"),
    [
        (0, 0, OPEN_TWILL),
        (1, 0, OPEN_TWILL),
        (3, 0, OPEN_TWILL),
        (1, 2, OPEN_TWILL),
        (1, 0, IRREGULAR_TWILL),
        (1, 2, IRREGULAR_TWILL),
    ],
)
def test_queries_of_clustered(rank: int, samples: int, fabric: Fabric) -> None:
    """The base alone, its densities compressed to several ranks, and with two texels of the residual."""
    model = with_samples(small_clustered(rank, fabric), samples)
    rows = queries()
    footprint = Footprint(*(pairs(rows[name]) for name in ("centre", "dx", "dy")))
    at = model.at(vectors(rows["view"]), footprint, seed=UInt(rows["seed"]))
    value = np.array(at.value(vectors(rows["light"]))).T
    expected = np.concatenate([value, np.array(at.null_transmission)[:, None]], axis=1)
    assert value.max() > 0.1
    body = (
        "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy;"
        "let f = clustered_value(fabric, p, light, view, seed, number);"
    )
    arguments = rows | {"number": np.full(COUNT, samples, np.uint32)}
    found = mapped("clustered footprint", body, "f.x; f.y; f.z; f.w", arguments, packed(model))
    assert share_beyond(found, expected) <= (MAX_FLIPS if samples else 1e-3)


@pytest.mark.slow
def test_passes_of_a_frame_tend_to_the_surface() -> None:
    """A pixel of a millimetre from above, in which light and view are those of the frame."""
    towards = np.float32([0.5, 0.3, 0.8]) / np.linalg.norm([0.5, 0.3, 0.8])
    field = 2 * np.degrees(np.arctan(0.5 * 1e-3 / 0.02))
    renderer = Renderer([Cloth(rectangle(0.1, 0.1), small_clustered(1))], (1, 1))
    assert renderer.model == "clustered"
    light = DirectionalLight(towards, (1.0, 1.0, 1.0))
    camera = Camera((0, 0, 0.02), field_of_view=float(field))
    found = renderer.render(camera, [light], passes=512, background=(0, 0, 0)).linear[0, 0]
    many = 4096
    edges = pairs(np.float32([[1, 0]])), pairs(np.float32([[0, 1]]))
    footprint = Footprint(pairs(np.float32([[50, 50]])), *edges)
    seed = UInt(np.random.default_rng(2).integers(0, 2**32, many, dtype=np.uint32))
    at = small_clustered(1).at(vectors(np.float32([[0, 0, 1]])), footprint, seed=seed)
    expected = np.array(at.value(vectors(towards[None]))).mean(axis=1)
    # Means of 1024 texels, whose spread the base takes in part.
    np.testing.assert_allclose(found[:3], expected, rtol=0.05)
    assert found[3] == pytest.approx(1 - float(np.array(at.null_transmission)[0]), abs=0.02)
