"""Layered cloth against dense marching through its layers one by one, and what its light does."""

from __future__ import annotations

import math
from dataclasses import replace

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.interreflection import Scattered, beneath
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, Layer, Stacking, Ties, shared_spacing
from loomlight.yarn.rays import REFERENCE_QUALITY
from loomlight.yarn.stack import StackedGeometry, cloth_geometry
from loomlight.yarn.visibility import first_hit, unoccluded
from tests.helpers.layouts import PLAIN, TWILL, even_layout

require_llvm()
mi.set_variant("llvm_ad_rgb")

COUNT = 2000
STEPS = 1000


def layered(drawdowns: list[NDArray[np.bool_]], gap: float = 0.3) -> ClothLayout:
    """Layers whose threads take turns in the draft, as those of double weave do."""
    count = len(drawdowns)
    side = len(drawdowns[0])
    whole = even_layout(np.zeros((count * side, count * side), bool), spacing=0.2, gap=gap)
    layers = []
    for number, drawdown in enumerate(drawdowns):
        threads = np.arange(number, count * side, count)
        spacing, start = shared_spacing(whole.warp.spacing, threads)
        family = replace(whole.warp, spacing=spacing, width=spacing * (1 - gap))
        layers.append(Layer(ClothLayout(drawdown, family, family), threads, threads, (start, start)))
    return replace(whole, layers=tuple(layers))


def in_blocks(layout: ClothLayout, ranks: list[list[int]]) -> ClothLayout:
    """The layers in as many blocks side by side as there are stacks."""
    picks, ends = layout.warp_on_top.shape
    regions = np.tile(np.arange(ends) * len(ranks) // ends, (picks, 1)).astype(np.uint8)
    return replace(layout, stacking=Stacking(np.array(ranks, np.int8), regions))


TWO = layered([np.tile(PLAIN, (2, 2)), TWILL])
THREE = layered([np.tile(PLAIN, (2, 2)), TWILL, np.tile(PLAIN, (2, 2))], gap=0.45)
# The layers change places, and one of three ends.
BLOCKS = in_blocks(TWO, [[0, 1], [1, 0]])
SHORT = in_blocks(THREE, [[0, 1, 2], [1, -1, 0]])


def tied(layout: ClothLayout) -> ClothLayout:
    """The first two layers, tied thrice on either face: by ends of the second in front, the first behind."""
    ties = []
    for own, over, back in ((1, 0, False), (0, 1, True)):
        across, along = layout.layers[own], layout.layers[over]
        places = np.zeros((along.picks.size, across.ends.size), bool)
        places[0, 1] = places[2, 2] = places[3, 2] = True
        warp = replace(across.layout.warp, width=0.7 * across.layout.warp.width)
        plane = ClothLayout(places ^ back, warp, along.layout.weft)
        layer = Layer(plane, across.ends, along.picks, (across.start[0], along.start[1]))
        ties.append(Ties(layer, own, over, True, back))
    return replace(layout, ties=tuple(ties))


TIED = tied(TWO)
TIED_BLOCKS = tied(BLOCKS)
LAYOUTS = pytest.mark.parametrize(
    "layout",
    [
        pytest.param(TWO, marks=pytest.mark.slow),
        pytest.param(THREE, marks=pytest.mark.slow),
        BLOCKS,
        pytest.param(SHORT, marks=pytest.mark.slow),
        TIED,
        pytest.param(TIED_BLOCKS, marks=pytest.mark.slow),
    ],
    ids=["two", "three", "blocks", "short", "tied", "tied blocks"],
)


def _marched(
    stack: StackedGeometry,
    start: NDArray[np.float64],
    towards: NDArray[np.float64],
    back: bool,
    length: float,
) -> NDArray[np.float64]:
    """Distance at which rays from `start` [n, 3] are first within the outline of yarn and below it, or inf.

    Each layer is asked by itself: its plane is where the one before and it both end, by their own heights.
    """
    layout = stack.layout
    highest = [layer.height_bounds[1] for layer in stack.layers]
    if layout.stacking is None:
        ranks, regions = [list(range(len(highest)))], np.zeros(layout.warp_on_top.shape, int)
    else:
        ranks, regions = layout.stacking.ranks.tolist(), layout.stacking.regions.astype(int)
    orders = [sorted((rank, layer) for layer, rank in enumerate(of_stack) if rank >= 0) for of_stack in ranks]
    pitch = layout.warp.spacing[0]
    hit = np.full(len(start), np.inf)
    for number in range(STEPS):
        distance = length * (number + 0.5) / STEPS
        place = start + distance * towards
        column, row = (np.floor(place[:, axis] / pitch).astype(int) for axis in (0, 1))
        region = regions[row % regions.shape[0], column % regions.shape[1]]
        heights = []
        for layer, placed in zip(stack.layers, layout.layers, strict=True):
            height, hole = layer.height(
                mi.Float(place[:, 0] - placed.start[0]),
                mi.Float(place[:, 1] - placed.start[1]),
                dr.full(mi.Bool, back, len(start)),
            )
            heights.append((height.numpy(), hole.numpy()))
        below = np.zeros(len(start), bool)
        for stack_number, order in enumerate(orders):
            here = region == stack_number
            depth, covered = 0.0, np.zeros(len(start), bool)
            middle = sum(highest[layer] for _, layer in order)
            for place_in_order, (_, layer) in enumerate(order[::-1] if back else order):
                height, hole = heights[layer]
                if place_in_order == 0:
                    plane = middle - highest[layer]
                    for tie, dip, covers in _ties_at(stack, place, layer, back):
                        there = here & covers & ~covered
                        below |= there & (place[:, 2] < tie + plane)
                        covered |= there
                        height = height - dip
                # Down by what this layer reaches up to its plane, then by as much below.
                plane = middle - depth - highest[layer]
                depth += 2 * highest[layer]
                there = here & ~hole & ~covered
                below |= there & (place[:, 2] < height + plane)
                covered |= there
        hit[below & np.isinf(hit)] = distance
    return hit


def _ties_at(
    stack: StackedGeometry, place: NDArray[np.float64], layer: int, back: bool
) -> list[tuple[NDArray[np.float64], ...]]:
    """Of the ties over a layer their height, by how much the layer dives, and whether they cover it."""
    found = []
    for tie in stack.layout.ties:
        if tie.over != layer or tie.back != back:
            continue
        x, y = (place[:, axis] - tie.layer.start[axis] for axis in (0, 1))
        alone = YarnGeometry(tie.layer.layout)
        point = alone.surface(mi.Float(x), mi.Float(y), dr.full(mi.Bool, back, len(place)))
        warp, weft = tie.layer.layout.warp, tie.layer.layout.weft
        (column, u), (row, v) = (
            (np.floor(at / family.spacing[0]).astype(int) % family.spacing.size, at / family.spacing[0] % 1)
            for at, family in ((x, warp), (y, weft))
        )
        here = tie.places[row, column]
        half = warp.width[0] / 2
        covers = here & (np.abs(u - 0.5) * warp.spacing[0] < half)
        # Circles of 80° have dropped by half their chord times tan 40° at its ends.
        dip = warp.height_scale * half * math.tan(math.radians(40))
        dip = dip * here * (4 * u * (1 - u)) ** 2 * (4 * v * (1 - v)) ** 2
        found.append((point.height.numpy(), dip, covers))
    return found


@pytest.mark.parametrize("back", [False, True])
@LAYOUTS
def test_rays_meet_what_dense_marching_meets(layout: ClothLayout, back: bool) -> None:
    """View rays end where the first layer's yarn, or another's in its holes, is first met."""
    stack = StackedGeometry(layout)
    rng = np.random.default_rng(5)
    high, low = stack.height_bounds[1], stack.height_bounds[0]
    tilt, turn = np.arccos(rng.uniform(0.4, 1, COUNT)), rng.uniform(0, 2 * math.pi, COUNT)
    view = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], axis=1)
    place = rng.uniform(0, stack.size[0], (COUNT, 2))
    hit = first_hit(
        stack,
        mi.Float(place[:, 0]),
        mi.Float(place[:, 1]),
        mi.Vector3f(view.T),
        dr.full(mi.Bool, back, COUNT),
        quality=REFERENCE_QUALITY,
    )
    start = np.column_stack([place + view[:, :2] / view[:, 2:] * high, np.full(COUNT, high)])
    length = (high - low) / 0.4
    found = _marched(stack, start, -view, back, length)
    seen = ~hit.hole.numpy()
    # Rays that graze are decided by the marching's step, a fortieth of a thread.
    assert np.mean(seen == np.isfinite(found)) > 0.99
    both = seen & np.isfinite(found)
    assert both.sum() > COUNT / 2
    height = high - found[both] * view[both, 2]
    assert np.mean(np.abs(height - hit.height.numpy()[both]) < 3 * length / STEPS) > 0.98


def test_light_reaches_what_dense_marching_leaves_free() -> None:
    stack = StackedGeometry(TWO)
    rng = np.random.default_rng(6)
    place = rng.uniform(0, stack.size[0], (COUNT, 2))
    x, y = mi.Float(place[:, 0]), mi.Float(place[:, 1])
    back = dr.full(mi.Bool, False, COUNT)
    point = stack.surface(x, y, back)
    tilt, turn = np.arccos(rng.uniform(0.3, 1, COUNT)), rng.uniform(0, 2 * math.pi, COUNT)
    light = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], axis=1)
    kept = ~point.hole.numpy() & ((point.normal.numpy().T * light).sum(axis=1) > 0.05)
    free = unoccluded(
        stack, x, y, point.height, mi.Vector3f(light.T), back, quality=REFERENCE_QUALITY
    ).numpy()
    start = np.column_stack([place, point.height.numpy() + 4e-4])
    length = 2 * stack.height_bounds[1] / 0.3
    found = _marched(stack, start, light, False, length)
    assert 0.2 < free[kept].mean() < 0.95
    # As above; a step of the marching may also jump over a corner of yarn.
    assert np.mean(free[kept] == np.isinf(found[kept])) > 0.985


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("layout", [TIED, TIED_BLOCKS], ids=["tied", "tied blocks"])
def test_slopes_are_those_of_heights(layout: ClothLayout, back: bool) -> None:
    """By differences over 2 µm, of which single precision leaves 1e-3; and normals are those of slopes."""
    stack = StackedGeometry(layout)
    rng = np.random.default_rng(12)
    count, step = 20000, 1e-3
    x, y = (mi.Float(rng.uniform(0, stack.size[0], count)) for _ in range(2))
    face, ahead = dr.full(mi.Bool, back, count), dr.full(mi.Bool, True, count)
    here = stack.probe(x, y, face, ahead, ahead)
    for slope, (right, up) in ((here.slope_x, (step, 0)), (here.slope_y, (0, step))):
        before, after = (stack.probe(x + side * right, y + side * up, face, ahead, ahead) for side in (-1, 1))
        one_yarn = (before.yarn == here.yarn) & (after.yarn == here.yarn) & ~here.hole
        error = dr.abs((after.height - before.height) / (2 * step) - slope).numpy()[one_yarn.numpy()]
        assert one_yarn.numpy().mean() > 0.8
        # Curvature jumps where arcs begin and end, at a share of places in proportion to the step.
        assert np.mean(error > 0.02) < 0.01
    point = stack.surface(x, y, face)
    normal = dr.normalize(mi.Vector3f(-here.slope_x, -here.slope_y, 1))
    assert np.allclose((point.normal - normal).numpy()[:, ~here.hole.numpy()], 0, atol=1e-5)
    # Fibres lie in the surface.
    along = dr.dot(point.tangent, point.normal).numpy()[~here.hole.numpy()]
    assert np.abs(along).max() < 1e-4


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("layout", [TIED, TIED_BLOCKS], ids=["tied", "tied blocks"])
def test_no_height_is_above_the_bounds_of_its_cell_or_of_all(layout: ClothLayout, back: bool) -> None:
    stack = StackedGeometry(layout)
    rng = np.random.default_rng(13)
    count = 20000
    x, y = (mi.Float(rng.uniform(0, stack.size[0], count)) for _ in range(2))
    face, ahead = dr.full(mi.Bool, back, count), dr.full(mi.Bool, True, count)
    here = stack.probe(x, y, face, ahead, ahead)
    low, high = stack.height_bounds
    kept = ~here.hole.numpy()
    height = here.height.numpy()[kept]
    assert (height <= here.cell_bounds.cell_max.numpy()[kept] + 1e-5).all()
    assert (height >= low).all()
    assert (height <= high + 1e-5).all()
    for radius, share in stack.max_heights(x, y, face, ahead, ahead):
        # Within the window, to its middle.
        reach = 0.5 * radius * stack.finest[0]
        there = stack.probe(x + reach, y + reach, face, ahead, ahead)
        inside = ~there.hole.numpy()
        assert (there.height.numpy() <= share.numpy() * high + 1e-5)[inside].all()


def test_planes_are_those_that_heights_are_above() -> None:
    """What is left above it is the height of the layer by itself, of which light between yarns knows."""
    stack = StackedGeometry(TWO)
    rng = np.random.default_rng(14)
    x, y = (mi.Float(rng.uniform(0, stack.size[0], COUNT)) for _ in range(2))
    front = dr.full(mi.Bool, False, COUNT)
    point = stack.surface(x, y, front)
    start = TWO.layers[0].start
    alone = stack.layers[0].surface(x - start[0], y - start[1], front)
    shown = ~alone.hole.numpy()
    assert np.allclose((point.height - point.plane).numpy()[shown], alone.height.numpy()[shown], atol=1e-6)
    assert (alone.plane.numpy() == 0).all()


def test_ties_show_the_thread_that_ties_and_the_layers_beneath() -> None:
    stack = StackedGeometry(TIED)
    # The middle of the second end of the second layer over the first pick of the first: draft ends and picks.
    x, y = mi.Float((3 + 0.5) * 0.2), mi.Float(0.5 * 0.2)
    front = dr.full(mi.Bool, False, 1)
    point = stack.surface(x, y, front)
    assert (bool(point.is_warp[0]), point.warp_thread[0]) == (True, 3)
    assert [bool(sheet.covered[0]) for sheet in stack.sheets(x, y, front)] == [True]
    # It is a whole crossing of plain weave high above the plane, which is 0 at both ends of its cell.
    assert point.height[0] > stack.levels[0, 0] + 0.01
    assert not bool(StackedGeometry(TWO).surface(x, y, front).warp_thread[0] == 3)


def test_each_face_shows_its_own_threads() -> None:
    stack = StackedGeometry(TWO)
    rng = np.random.default_rng(7)
    x, y = (mi.Float(rng.uniform(0, stack.size[0], COUNT)) for _ in range(2))
    for back, layer in ((False, 0), (True, 1)):
        point = stack.surface(x, y, dr.full(mi.Bool, back, COUNT))
        own = stack.layers[layer]
        start = stack.layout.layers[layer].start
        alone = own.surface(x - start[0], y - start[1], dr.full(mi.Bool, back, COUNT))
        covered = ~alone.hole.numpy()
        thread = np.where(point.is_warp.numpy(), point.warp_thread.numpy(), point.weft_thread.numpy())
        assert (thread[covered] % 2 == layer).all()
        assert (thread[~covered] % 2 == 1 - layer)[~point.hole.numpy()[~covered]].all()
        assert np.allclose(point.normal.numpy()[:, covered], alone.normal.numpy()[:, covered])
        both = (1 - own.layout.warp.open_share) * 2 - (1 - own.layout.warp.open_share) ** 2
        assert abs(covered.mean() - both) < 4 * math.sqrt(both * (1 - both) / COUNT)


def test_one_plane_is_the_geometry_of_before() -> None:
    assert type(cloth_geometry(even_layout(PLAIN))) is YarnGeometry
    assert type(cloth_geometry(TWO)) is StackedGeometry


def test_sheets_are_those_behind_the_one_that_shows() -> None:
    stack = StackedGeometry(THREE)
    rng = np.random.default_rng(8)
    x, y = (mi.Float(rng.uniform(0, stack.size[0], COUNT)) for _ in range(2))
    for back in (False, True):
        face = dr.full(mi.Bool, back, COUNT)
        covered = [
            ~layer.surface(x - placed.start[0], y - placed.start[1], face).hole.numpy()
            for layer, placed in zip(stack.layers, stack.layout.layers, strict=True)
        ]
        count = sum(covered).astype(int) if isinstance(sum(covered), np.ndarray) else 0
        behind = sum(sheet.covered.numpy().astype(int) for sheet in stack.sheets(x, y, face))
        assert (behind == np.maximum(count - 1, 0)).all()


def test_sheets_upon_one_another_lose_no_light() -> None:
    """Two sheets that absorb nothing send all on, and a black one behind takes what comes through."""
    white = beneath(Scattered(mi.Float(0.6), mi.Float(0.4)), Scattered(mi.Float(0.3), mi.Float(0.7)))
    assert math.isclose((white.back + white.through)[0], 1, abs_tol=1e-6)
    # By the series of light to and fro.
    series = 0.6 + 0.4 * 0.3 * 0.4 * sum((0.6 * 0.3) ** order for order in range(40))
    assert math.isclose(white.back[0], series, abs_tol=1e-6)
    black = beneath(Scattered(mi.Float(0.6), mi.Float(0.4)), Scattered(mi.Float(0), mi.Float(0)))
    assert (black.back[0], black.through[0]) == (pytest.approx(0.6), 0)


def _model(layout: ClothLayout, reflect: float, transmit: float) -> YarnScattering:
    count = layout.warp.spacing.size
    albedos = [np.full((count, 3), value) for value in (reflect, transmit, 0.0, 0.0)]
    family = FamilyAppearance(*albedos, 0.3)
    return YarnScattering(StackedGeometry(layout), Appearance(family, family))


@LAYOUTS
def test_layered_cloth_never_sends_back_more_than_it_gets(layout: ClothLayout) -> None:
    """White furnace: yarn that absorbs nothing, weights of sampled directions, from both faces."""
    model = _model(layout, 0.6, 0.4)
    rng = np.random.default_rng(9)
    count = 1 << 16
    for z in (0.8, -0.8):
        view = dr.normalize(mi.Vector3f(0.4, 0.2, z)) + dr.zeros(mi.Vector3f, count)
        x, y = (mi.Float(rng.uniform(0, layout.size[0], count)) for _ in range(2))
        point = model.locate(x, y, view)
        numbers = [mi.Float(rng.random(count)) for _ in range(3)]
        drawn = model.sample(point, view, numbers[0], mi.Vector2f(numbers[1], numbers[2]))
        weight = drawn.weight.numpy().mean(axis=0)
        assert np.isfinite(weight).all()
        assert weight.mean() <= 1 + 4 * weight.std() / math.sqrt(count)
        # Single scattering loses what neighbouring yarns block, no more than half of the light.
        assert weight.mean() > 0.5


def test_layers_behind_hold_back_light_and_return_it() -> None:
    """Yarn of R and T upon yarn of R' and T' shows T² R' / (1 − R R') more; T T' / (1 − R R') pass."""
    model = _model(TWO, 0.5, 0.3)
    rng = np.random.default_rng(10)
    x, y = (mi.Float(rng.uniform(0, TWO.size[0], COUNT)) for _ in range(2))
    back = dr.full(mi.Bool, False, COUNT)
    hole = mi.Bool(model.surface.surface(x, y, back).hole)
    point = model.at(x, y, back, hole)
    covered = model.surface.sheets(x, y, back)[0].covered.numpy()
    up, down = mi.Vector3f(0, 0, 1), mi.Vector3f(0, 0, -1)
    gained = model.evaluate(point, up, up) - model.evaluate(replace(point, bounced=None), up, up)
    assert np.allclose(gained.numpy()[0][covered], 0.3 * 0.5 * 0.3 / (1 - 0.25) / math.pi, rtol=1e-4)
    assert np.allclose(gained.numpy()[0][~covered], 0, atol=1e-6)
    through = model.evaluate(point, down, up).numpy()[0][covered]
    assert np.allclose(through, 0.3 * 0.3 / (1 - 0.25) / math.pi, rtol=1e-4)


def test_planes_lie_as_near_as_what_is_shown_of_them_lets_them() -> None:
    """Floats count where their layer is one of the cloth, not where its threads are another's."""
    plain, floats = np.tile(PLAIN, (8, 8)), np.tile(PLAIN, (8, 8))
    # The other half, without the crossings next to the border, which cells of the layer reach into.
    floats[:, 10:14] = np.arange(16)[:, None] < 8
    stacks = [
        StackedGeometry(in_blocks(layered([front, plain]), [[0, 1], [-1, 0]])) for front in (floats, plain)
    ]
    floating = StackedGeometry(layered([floats, plain])).reaches[0]
    hidden, without = (stack.reaches[0] for stack in stacks)
    assert floating > 3 * without
    # Words hold heights in 15ths of the layer's highest, rounded up.
    assert without <= hidden * (1 + 1e-6) <= without + floating / 15 * (1 + 1e-6)


def test_straight_yarn_has_its_thickness() -> None:
    """Wadding: planes are half of its section's drop and the cloth's crowns apart."""
    straight = np.ones((4, 4), bool)
    stack = StackedGeometry(layered([np.tile(PLAIN, (2, 2)), straight]))
    drop = max(
        float(family.edge_drop.max()) * scale
        for family, scale in zip(stack.layers[1].families, stack.height_scale, strict=True)
    )
    assert np.isclose(stack.reaches[1], drop / 2)
    assert np.isclose(-np.diff(stack.levels[0])[0], stack.reaches.sum())
