"""Where a garment is cut into pieces: few, large, hardly stretched when they lie flat, with straight grain.

Limbs are found by how a band around their end grows, and end at a plane through the armpit. What is left is
cut where it turns from front to back, and further where a cut makes it lie flat.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.flattening import FlatTriangles, flattened, stretches
from loomlight.mesh.surface import (
    Surface,
    across,
    blurred,
    corners_of,
    crease_conductance,
    distances,
    pieces_of,
    together,
)

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

UP = np.array([0.0, 1.0, 0.0])
FRONT = np.array([0.0, 0.0, 1.0])
# A piece lies flat where 98 % of its area is stretched by less; its grain is straight within so many degrees.
MAX_STRETCH, MAX_ANGLE = 1.12, 14.0
# Pieces of a component, and the share of its area below which nothing is cut further.
_MAX_PIECES, _MIN_SHARE = 24, 0.01
# What a cut has to save of a piece's cost; and what a seam as long as the root of the area costs.
_MIN_GAIN, _SEAM_COST = 0.15, 0.02
# Degrees between a limb's axis and the vertical, from which on it has a grain of its own.
_OWN_AXIS = 22.0
# Borders shorter than that, of the root of the area, are holes.
_SHORT_LOOP = 0.2
# A band around a limb's end grows by that factor where the limb ends.
_GROWS = 1.25
# The shortest limb, of the way around it.
_SHORTEST = 0.25


@dataclass(frozen=True, eq=False)
class Cut:
    """A surface in pieces.

    Attributes:
        label: the piece of each triangle [m], from 0.
        kept: of 3 m edges those that are not cut.
        axis: the direction in space that lies along the warp, of each piece [k, 3].
        is_limb: of each piece [k].
    """

    label: Indices
    kept: Mask
    axis: Floats
    is_limb: Mask


def cut(surface: Surface) -> Cut:
    """Cuts a surface, whose triangles may be in several components."""
    component = pieces_of(surface, np.zeros(len(surface.areas), np.int64))
    label = np.zeros(len(surface.areas), np.int64)
    kept = across(surface, component)
    centre = np.average(surface.middles, axis=0, weights=surface.areas)
    axes: list[Floats] = []
    limbs: list[bool] = []
    for number in range(int(component.max()) + 1):
        (here,) = np.nonzero(component == number)
        edges = (3 * here[:, None] + np.arange(3)).ravel()
        part = surface.some(component == number)
        leans = leaning_axis(part, np.ones(len(here), bool)) is not None
        for region, axis, is_limb in _regions(part, np.ones(len(here), bool)):
            for piece, opened in _pieces(part, region, axis, centre):
                label[here[piece]] = len(axes)
                kept[edges[opened]] = False
                axes.append(axis)
                limbs.append(is_limb or leans)
    kept &= across(surface, label)
    return Cut(label, kept, np.array(axes), np.array(limbs))


def leaning_axis(surface: Surface, chosen: Mask) -> Floats | None:
    """The axis of a tube that leans, upwards; None of what stands upright, lies flat, or is no tube."""
    normals, areas = surface.normals[chosen], surface.areas[chosen]
    spread = np.einsum("mi,mj,m->ij", normals, normals, areas) / areas.sum()
    values, vectors = np.linalg.eigh(spread)
    axis: Floats = vectors[:, 0] * (-1 if vectors[1, 0] < 0 else 1)
    leans = values[1] - values[0] > 0.15 and axis @ UP < np.cos(np.radians(_OWN_AXIS))
    return axis if leans else None


def main_axis(surface: Surface, chosen: Mask) -> Floats:
    """The direction that lies along the warp of a region: the vertical, or that of a tube that leans.

    Of what lies flat on the ground the longer side.
    """
    axis = leaning_axis(surface, chosen)
    if axis is not None:
        return axis
    areas = surface.areas[chosen]
    if np.average(surface.normals[chosen][:, 1] ** 2, weights=areas) < 0.8:
        return UP
    middles = surface.middles[chosen]
    middles = middles - np.average(middles, axis=0, weights=areas)
    extent = np.einsum("mi,mj,m->ij", middles, middles, areas)[::2, ::2]
    values, vectors = np.linalg.eigh(extent)
    if values[0] > 0.8 * values[1]:
        return -FRONT
    return np.array([vectors[0, 1], 0.0, vectors[1, 1]]) * (1 if vectors[1, 1] < 0 else -1)


# ---------------------------------------------------------------------------------------------------- limbs


def _regions(surface: Surface, whole: Mask) -> Iterator[tuple[Mask, Floats, bool]]:
    """The regions of a component whose grain runs in directions of their own."""
    rest = whole.copy()
    main = main_axis(surface, whole)
    for limb in _limbs(surface, whole):
        limb = limb & rest
        axis = main_axis(surface, limb) if limb.any() else main
        if limb.any() and abs(axis @ main) < np.cos(np.radians(_OWN_AXIS)):
            yield limb, axis, True
            rest &= ~limb
    for piece in _parts(surface, rest):
        yield piece, main, False


def _parts(surface: Surface, chosen: Mask) -> Iterator[Mask]:
    """The connected parts of a region, largest first."""
    number = pieces_of(surface, chosen.astype(np.int64))
    found = np.unique(number[chosen])
    areas = [surface.areas[number == each].sum() for each in found]
    for each in np.argsort(-np.array(areas), kind="stable"):
        yield number == found[each]


def _loops(surface: Surface, chosen: Mask, kept: Mask, shortest: float = 0.0) -> list[Indices]:
    """The vertices of each loop of border edges of a region, the longest loop first."""
    inner = kept & (surface.twins >= 0)
    inner &= np.repeat(chosen, 3) & np.repeat(chosen, 3)[surface.twins]
    (edge,) = np.nonzero(np.repeat(chosen, 3) & ~inner)
    start = surface.triangles.ravel()[edge]
    end = np.roll(surface.triangles, -1, axis=1).ravel()[edge]
    if not len(edge):
        return []
    used, ends = np.unique(np.concatenate([start, end]), return_inverse=True)
    loop = together(len(used), ends[: len(edge)], ends[len(edge) :])
    length = np.linalg.norm(surface.positions[end] - surface.positions[start], axis=1)
    lengths = np.bincount(loop[ends[: len(edge)]], length, int(loop.max()) + 1)
    return [used[loop == each] for each in np.argsort(-lengths, kind="stable") if lengths[each] >= shortest]


def _limbs(surface: Surface, whole: Mask) -> Iterator[Mask]:
    """Regions around open ends of tubes that leave a component, such as sleeves."""
    total = surface.areas[whole].sum()
    side = np.sqrt(total)
    loops = _loops(surface, whole, np.ones(3 * len(whole), bool), _SHORT_LOOP * side)[:12]
    if len(loops) < 3:
        return
    # Some six bands in the shortest of sleeves.
    width = 0.025 * side
    for loop in loops:
        far = distances(surface, loop)[surface.triangles]
        end = _end_of_limb(_bands(far[whole], surface.areas[whole], width), width)
        if end is None:
            continue
        limb = whole & (far.mean(axis=1) < end * width)
        if surface.areas[limb].sum() < 0.3 * total:
            yield _beyond_armpit(surface, whole, limb, far.mean(axis=1), end * width, loop)


def _bands(far: Floats, areas: Floats, width: float) -> Floats:
    """The area in each band of `width` of what is `far` at the corners of triangles [m, 3]."""
    low, reach = far.min(axis=1), np.ptp(far, axis=1)
    parts = 8
    at = low[:, None] + reach[:, None] * ((np.arange(parts) + 0.5) / parts)
    found = np.bincount((at / width).astype(int).ravel(), np.repeat(areas / parts, parts))
    return found.astype(np.float64)


def _end_of_limb(bands: Floats, width: float) -> int | None:
    """The first band that is much longer than those before it, if these are of about one length."""
    for at in range(4, len(bands) - 2):
        usual = float(np.median(bands[1:at]))
        if (bands[at : at + 3] > _GROWS * usual).all():
            is_steady = bands[1:at].max() < 1.5 * bands[1:at].min()
            return at if is_steady and at * width > _SHORTEST * usual / width else None
    return None


def _beyond_armpit(
    surface: Surface, whole: Mask, limb: Mask, far: Floats, reach: float, loop: Indices
) -> Mask:
    """A limb as far as a plane through the place where it meets the body first, as armholes lie."""
    front = np.flatnonzero(whole & (np.abs(far - 0.9 * reach) < 0.15 * reach))
    middles = surface.middles
    axis = main_axis(surface, limb)
    middle = np.average(middles[limb], axis=0, weights=surface.areas[limb])
    axis = axis * np.sign(axis @ (surface.positions[loop].mean(axis=0) - middle))
    inward = np.average(middles[whole], axis=0, weights=surface.areas[whole]) - middle
    inward -= (inward @ axis) * axis
    inward /= max(float(np.linalg.norm(inward)), 1e-300)
    pit = middles[front[np.argmax(middles[front] @ inward)]]
    # The saddle there lies flat on neither side.
    pit = pit - 0.12 * reach * inward
    level = axis - (axis @ UP) * UP
    length = np.linalg.norm(level)
    out = 0.35 * axis + level / length if length > 0.2 else axis
    beyond = whole & ((middles - pit) @ out > 0) & (far < 2.5 * reach)
    beyond &= (far < reach) | ((middles - pit) @ inward < 0)
    number = pieces_of(surface, beyond.astype(np.int64))
    near = np.isin(surface.triangles, loop).any(axis=1) & beyond
    if not near.any():
        return limb
    found = number == np.bincount(number[near]).argmax()
    share = surface.areas[found].sum() / surface.areas[limb].sum()
    return found if 0.6 < share < 2.5 else limb


# ---------------------------------------------------------------------------------------------------- pieces


@dataclass(frozen=True, eq=False)
class _Trial:
    """A region laid flat: whether it may stay as it is, and what it costs."""

    is_good: bool
    cost: float


def _tried(surface: Surface, chosen: Mask, kept: Mask, axis: Floats, rounds: int) -> _Trial:
    part = np.flatnonzero(chosen)
    inside = np.repeat(chosen, 3)
    corners = corners_of(surface, kept & inside & inside[surface.twins])[part]
    corners = np.unique(corners, return_inverse=True)[1].reshape(-1, 3)
    flat = FlatTriangles.of(surface.positions[surface.triangles[part]], corners)
    grain = np.broadcast_to(axis, (len(part), 3))
    jacobian = flat.jacobian(flattened(flat, grain, rounds=rounds, tolerance=2e-3))
    stretch = np.minimum(stretches(jacobian), 4.0)
    order = np.argsort(stretch)
    share = np.cumsum(flat.areas[order]) / flat.areas.sum()
    worst = stretch[order[min(int(np.searchsorted(share, 0.98)), len(order) - 1)]]
    angle = grain_angles(flat, jacobian, grain)
    weight = flat.areas * np.hypot(*flat.along(grain).T)
    mean_angle = float(np.average(np.abs(angle), weights=np.maximum(weight, 1e-300)))
    cost = float((flat.areas * (stretch - 1)).sum() + flat.areas.sum() * mean_angle / 200)
    return _Trial(bool(worst < MAX_STRETCH and mean_angle < MAX_ANGLE), cost)


def grain_angles(flat: FlatTriangles, jacobian: Floats, grain: Floats) -> Floats:
    """Degrees by which the grain of each triangle is turned against that of all."""
    in_plane = flat.along(grain)
    u, v = np.einsum("mkj,mj->km", jacobian, in_plane)
    weight = flat.areas * np.hypot(*in_plane.T) / np.maximum(np.hypot(u, v), 1e-300)
    turn = np.arctan2((weight * u).sum(), (weight * v).sum())
    return np.degrees((np.arctan2(u, v) - turn + np.pi) % (2 * np.pi) - np.pi)


def _pieces(surface: Surface, region: Mask, axis: Floats, centre: Floats) -> list[tuple[Mask, Mask]]:
    """A region in pieces, and the edges that are cut within each; `centre` is the garment's middle."""
    total = surface.areas[region].sum()
    conductance = crease_conductance(surface)
    none = np.zeros(3 * len(region), bool)
    waiting = [(region, none, _tried(surface, region, ~none, axis, 12))]
    done: list[tuple[Mask, Mask]] = []
    while waiting:
        waiting.sort(key=lambda each: each[2].cost)
        piece, opened, trial = waiting.pop()
        area = surface.areas[piece].sum()
        if trial.is_good or area < _MIN_SHARE * total or len(waiting) + len(done) + 1 >= _MAX_PIECES:
            done.append((piece, opened))
            continue
        best = None
        for parts, seam, cuts, is_usual in _candidates(surface, piece, opened, axis, conductance, centre):
            trials = [_tried(surface, part, ~cuts, axis, 12) for part in parts]
            cost = sum(each.cost for each in trials) + _SEAM_COST * seam * np.sqrt(area)
            if is_usual and all(each.is_good for each in trials):
                best = 0.0, parts, cuts, trials
                break
            if best is None or cost < best[0]:
                best = cost, parts, cuts, trials
        if best is None or best[0] > (1 - _MIN_GAIN) * trial.cost:
            done.append((piece, opened))
            continue
        waiting += [(part, best[2], each) for part, each in zip(best[1], best[3], strict=True)]
    return done


def _candidates(
    surface: Surface, piece: Mask, opened: Mask, axis: Floats, conductance: Floats, centre: Floats
) -> Iterator[tuple[list[Mask], float, Mask, bool]]:
    """Ways to cut a piece: its parts, the length of the seam, the edges that are cut within them.

    Last, whether it is how a tailor cuts, first of all: a tube open along a seam, or front from back.
    """
    areas, normals, middles = surface.areas[piece], surface.normals, surface.middles
    inside = np.where(np.repeat(piece, 3) & np.repeat(piece, 3)[surface.twins], conductance, 0.0)
    mean = np.average(normals[piece], axis=0, weights=areas)
    if np.linalg.norm(mean) < 0.3:
        mean = np.zeros(3)
    offset = normals[piece] - mean
    _, vectors = np.linalg.eigh(np.einsum("mi,mj,m->ij", offset, offset, areas))
    away = middles - np.average(middles[piece], axis=0, weights=areas)
    is_round = not mean.any()
    scores = [normals @ (FRONT - (FRONT @ axis) * axis)] if is_round else []
    scores += [(normals - mean) @ vectors[:, 2], (normals - mean) @ vectors[:, 1]]
    blurry = len(scores)
    place = away[piece]
    _, spread = np.linalg.eigh(np.einsum("mi,mj,m->ij", place, place, areas))
    scores += [
        away @ spread[:, 2],
        away @ spread[:, 1],
        away @ axis,
    ]
    length = _edge_lengths(surface)
    seam = _opening(surface, piece, opened, axis, centre)
    if seam is not None:
        yield [piece], float(length[seam & ~opened].sum() / 2), opened | seam, True
    for number, score in enumerate(scores):
        if number < blurry:
            score = blurred(surface, np.where(piece, score, 0), inside, 12)
        parts = _halves(surface, piece, score > 0)
        if len(parts) < 2:
            continue
        side = np.zeros(len(piece), np.int64)
        for at, part in enumerate(parts, 1):
            side[part] = at
        seam = np.repeat(piece, 3) & np.repeat(piece, 3)[surface.twins] & (surface.twins >= 0)
        seam &= ~across(surface, side)
        yield parts, float(length[seam].sum() / 2), opened, is_round and number == 0


def _opening(surface: Surface, piece: Mask, opened: Mask, axis: Floats, centre: Floats) -> Mask | None:
    """The edges of a seam along a tube, where it is seen least; None of what is no tube."""
    loops = _loops(surface, piece, ~opened, _SHORT_LOOP * np.sqrt(surface.areas[piece].sum()))
    if len(loops) != 2:
        return None
    tube = Surface.of(surface.positions, surface.triangles[piece])
    away = distances(tube, loops[0])
    middle = np.average(tube.middles, axis=0, weights=tube.areas)
    hidden = centre - middle
    hidden -= (hidden @ axis) * axis
    length = float(np.linalg.norm(hidden))
    hidden = hidden / length if length > 0.1 * np.sqrt(tube.areas.sum()) else -FRONT
    ends = loops[1]
    here = int(ends[np.argmax((surface.positions[ends] - middle) @ hidden - away[ends])])
    start, end = tube.triangles.ravel(), np.roll(tube.triangles, -1, axis=1).ravel()
    a, b = np.concatenate([start, end]), np.concatenate([end, start])
    edges = np.zeros(3 * len(piece), bool)
    ends_of = np.stack([surface.triangles, np.roll(surface.triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = ends_of.min(axis=1), ends_of.max(axis=1)
    while away[here] > 0:
        near = b[a == here]
        length = np.linalg.norm(surface.positions[near] - surface.positions[here], axis=1)
        there = int(near[np.argmin(away[near] + length)])
        if not away[there] < away[here]:
            return None
        edges |= (low == min(here, there)) & (high == max(here, there))
        here = there
    return edges & np.repeat(piece, 3)


def _halves(surface: Surface, piece: Mask, side: Mask) -> list[Mask]:
    """Connected parts on both sides; what is small goes to the part around it."""
    total = surface.areas[piece].sum()
    for _ in range(3):
        label = np.where(piece, side.astype(np.int64), 2)
        number = pieces_of(surface, label)
        areas = np.bincount(number, surface.areas)
        small = piece & (areas[number] < 0.06 * total)
        if not small.any():
            break
        side = np.where(small, ~side, side)
    number = pieces_of(surface, np.where(piece, side.astype(np.int64), 2))
    return [number == each for each in np.unique(number[piece])]


def _edge_lengths(surface: Surface) -> Floats:
    ends = surface.positions[np.roll(surface.triangles, -1, axis=1)] - surface.positions[surface.triangles]
    return np.linalg.norm(ends, axis=2).ravel()
