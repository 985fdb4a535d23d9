"""The model lobes in Slang against its Python twin: estimate over groups, mean albedos, footprints, frames.

Fabrics here have no sheen. The bar is that of `queries.py`; a footprint whose tap or point falls on the edge
of a cell or yarn may take the other side, which rounding decides.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.fabric.read import edited_fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.models.registry import make_model
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import FOOTPRINT, places, share_beyond
from tests.helpers.slang import mapped
from tests.helpers.whole_queries import lobes_values

EXAMPLES = Path(__file__).parents[2] / "examples"
COUNT = 20_000
MAX_FLIPS = 1e-3
# Open cloth of slub yarns with neps, whose shades vary.
IRREGULAR = (
    'weave = "twill 2/1"\nends_per_cm = 20\npicks_per_cm = 16\nyarn = "linen"\n[warp]\ngap = 0.2\n'
    '[weft]\ngap = 0.3\nshade = 0.1\nmelange = 0.2\nneps = 9\nnep_color = "#301008"\n'
    "[variation]\ncolour_noise = 0.3\n"
)
fabrics = pytest.mark.parametrize("name", ["denim", "even denim", "damask", "silk-satin", "irregular"])


def lobes_of(name: str) -> LobesModel:
    return make_model("lobes", fabric_of(name))


def fabric_of(name: str) -> Fabric:
    if name == "irregular":
        return fabric_from_text(IRREGULAR)
    fabric = load_fabric(EXAMPLES / f"{name.removeprefix('even ')}.toml")
    return edited_fabric(fabric, {"variation.irregularity": 0}) if name.startswith("even") else fabric


class Queries:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""

    def __init__(self, model: LobesModel, smallest: float = 0.01) -> None:
        rng = np.random.default_rng(23)
        at = places(rng, model.fabric.layout(), COUNT)
        self.light, self.view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
        side = np.exp(rng.uniform(np.log(smallest), np.log(10), COUNT))
        angle, ratio = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0.2, 1, COUNT)
        cosine, sine = side * np.cos(angle), side * np.sin(angle)
        self.dx = np.float32(np.stack([cosine, sine], axis=1))
        self.dy = np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1))
        self.arguments = {
            "x": at.x,
            "y": at.y,
            "light": self.light,
            "view": self.view,
            "dx": self.dx,
            "dy": self.dy,
        }
        self.footprint = Footprint(Array2f(at.x, at.y), pairs(self.dx), pairs(self.dy))
        self.looks = (model.fabric.layout(), model.fabric.appearance(), model.tables)


@pytest.mark.slow
@fabrics
def test_estimate_over_groups(name: str) -> None:
    model = lobes_of(name)
    queries = Queries(model)
    body = (
        FOOTPRINT + "let c = prefiltered_components(fabric, p, to_face_frame(light, back),"
        "to_face_frame(view, back), back);"
    )
    results = "c.diffuse_warp; c.diffuse_weft; c.specular_warp; c.specular_weft; c.hole"
    found = mapped("prefiltered footprint point", body, results, queries.arguments, queries.looks)
    at = model.at(vectors(queries.view), queries.footprint)
    hole, (sums,) = at.prefiltered([vectors(queries.light)], None, True)
    parts = sums.components
    expected = [parts.diffuse_warp, parts.diffuse_weft, parts.specular_warp, parts.specular_weft, hole]
    for column, values in enumerate(expected):
        assert share_beyond(found[:, column], np.array(values)) <= MAX_FLIPS


@pytest.mark.slow
def test_a_frame_of_tables_baked_on_the_adapter_is_that_of_python() -> None:
    cloth = Cloth(rectangle(0.5, 0.5), load_fabric(EXAMPLES / "silk-satin.toml"))
    light = [DirectionalLight((0.5, 0.3, 0.8), (1, 1, 1))]
    camera = Camera((0, -0.4, 0.5))
    frames = [
        Renderer([cloth], (16, 16), "lobes", bake=place).render(camera, light, passes=1).linear
        for place in ("cpu", "gpu")
    ]
    assert frames[0].max() > 0.1
    assert share_beyond(frames[1], frames[0]) <= MAX_FLIPS


@pytest.mark.slow
def test_mean_albedos_of_coloured_threads() -> None:
    model = lobes_of("wool-houndstooth")
    queries = Queries(model)
    body = FOOTPRINT + "let a = albedos_over(fabric, p, back);"
    results = (
        "a.warp.diffuse_reflect.x; a.warp.specular_transmit.z;"
        "a.weft.diffuse_transmit.y; a.weft.specular_reflect.x"
    )
    found = mapped("albedos footprint", body, results, queries.arguments, queries.looks)
    warp, weft = model.means.over(queries.footprint, vectors(queries.view).z < 0)
    expected = [
        warp.diffuse_reflect.x,
        warp.specular_transmit.z,
        weft.diffuse_transmit.y,
        weft.specular_reflect.x,
    ]
    assert np.ptp(found[:, 0]) > 0.1
    for column, values in enumerate(expected):
        assert share_beyond(found[:, column], np.array(values)) <= MAX_FLIPS


@pytest.mark.quick("silk-satin")
@fabrics
def test_queries_of_lobes(name: str) -> None:
    model = lobes_of(name)
    queries = Queries(model)
    found = lobes_values(queries.arguments, queries.looks)
    value = np.array(model.at(vectors(queries.view), queries.footprint).value(vectors(queries.light)))
    assert value.max() > 0.1
    # Beside the flips of searches, points change their family where a hair covers half of them.
    assert share_beyond(found.T, value) <= 2 * MAX_FLIPS


@pytest.mark.slow
def test_a_frame_shades_the_footprints_of_its_pixels() -> None:
    """Against the Python model at footprints that this test derives from the camera."""
    size, side, distance = 32, 0.5, 0.6
    model = lobes_of("denim")
    camera = Camera((0, -0.6 * distance, 0.8 * distance))
    towards = np.array([0.5, 0.3, 0.8]) / np.linalg.norm([0.5, 0.3, 0.8])
    renderer = Renderer([Cloth(rectangle(side, side), model.fabric)], (size, size), "lobes")
    frame = renderer.render(camera, [DirectionalLight(towards, (1, 1, 1))], passes=1).linear[..., :3]

    axes = camera.axes(size, size)

    def on_cloth(row: NDArray[np.float64], column: NDArray[np.float64]) -> NDArray[np.float64]:
        right, up = 2 * column[..., None] / size - 1, 1 - 2 * row[..., None] / size
        ray = axes["forward"] + right * axes["right"] + up * axes["up"]
        return axes["origin"] - ray * (axes["origin"][2] / ray[..., 2:])

    row, column = (part.ravel() + 0.5 for part in np.mgrid[:size, :size].astype(float))
    centre = on_cloth(row, column)
    # uv is 100 mm a unit and spans the cloth.
    scale, step = 100 / side, 1e-3
    dx = (on_cloth(row, column + step) - on_cloth(row, column - step))[:, :2] * (scale / (2 * step))
    dy = (on_cloth(row + step, column) - on_cloth(row - step, column))[:, :2] * (scale / (2 * step))
    view = axes["origin"] - centre
    view /= np.linalg.norm(view, axis=1, keepdims=True)
    footprint = Footprint(
        pairs(np.float32((centre[:, :2] + side / 2) * scale)), pairs(np.float32(dx)), pairs(np.float32(dy))
    )
    light = np.broadcast_to(np.float32(towards), view.shape)
    at = model.at(vectors(np.float32(view)), model.on_cloth(footprint))
    expected = np.array(at.value(vectors(light))).T
    error = np.abs(frame.reshape(-1, 3) - expected)
    # Positions agree to 1e-5 of the picture: taps and points beside an edge take its other side.
    assert np.mean(error > 1e-4 + 1e-2 * expected) < 0.02
    assert frame.mean() == pytest.approx(expected.mean(), rel=1e-3)
