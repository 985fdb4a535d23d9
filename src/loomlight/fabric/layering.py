"""The planes of layered cloth: the threads of each layer of a drawdown, and the room that they have there."""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.weave.layer_drafts import binding_points
from loomlight.weave.layers import Layers, find_layers, layer_sizes, single_layer
from loomlight.yarn.layout import ClothLayout, FamilyLayout, Layer, Stacking, Ties, shared_spacing

_Threads = NDArray[np.intp]
# Called with a family, "warp" or "weft", some of its threads and the room of each; returns their widths.
WidthOf = Callable[[str, _Threads, NDArray[np.float64]], NDArray[np.float64]]
# Width of the thread that stands for the family which a layer of floating threads has not: none sees it.
_HAIRLINE_MM = 1e-5
# A thread that ties is squeezed between those of the layer that it ties, to this share of their spacings.
_TIE_WIDTH = 0.8


# Drawdowns whose layers are remembered, by their digests: edits of a fabric seldom change the weave.
_MOST_KEPT = 8
_kept: OrderedDict[tuple[tuple[int, ...], bytes], Layers] = OrderedDict()


def layers_of(drawdown: NDArray[np.bool_]) -> Layers:
    """The layers that a drawdown [picks, ends] is shown with, found at the first call for it.

    What no thread binds together lies in layers for sure. All else must have its threads in turns, as every
    loom's set-up has: among few threads in no order some lie upon others by chance.
    """
    key = drawdown.shape, hashlib.blake2b(np.packbits(drawdown).tobytes()).digest()
    if key not in _kept:
        found = find_layers(drawdown)
        if len(layer_sizes(drawdown)) < 2 and not _takes_turns(found, drawdown.shape):
            found = single_layer(*drawdown.shape)
        _kept[key] = found
        if len(_kept) > _MOST_KEPT:
            _kept.popitem(last=False)
    _kept.move_to_end(key)
    return _kept[key]


def _takes_turns(found: Layers, shape: tuple[int, ...]) -> bool:
    """Whether the systems of both families follow one another in a turn that repeats within the draft."""
    turns = []
    for count, family in zip(shape, ("picks", "ends"), strict=True):
        system = np.full(count, -1)
        for number, of_system in enumerate(found.systems):
            system[getattr(of_system, family)] = number
        turns.append(any(np.array_equal(np.roll(system, step), system) for step in range(1, count // 2 + 1)))
    return all(turns)


def front_drawdown(drawdown: NDArray[np.bool_], found: Layers) -> NDArray[np.bool_]:
    """The drawdown of the threads in front in most of the cloth; all of it where there is a single layer."""
    planes = _planes(found)
    if len(planes) == 1:
        return drawdown
    ends, picks = _threads_of(found, found.stacks[0][0])
    return drawdown[np.ix_(picks, ends)] if ends.size and picks.size else drawdown


def stacked_layers(
    drawdown: NDArray[np.bool_],
    found: Layers,
    families: tuple[FamilyLayout, FamilyLayout],
    width_of: WidthOf,
) -> tuple[tuple[Layer, ...], Stacking | None]:
    """Layers of a cloth and where which lies upon which; none of a cloth of one layer.

    What lies in one plane somewhere is a layer: a cloth, threads that float, or several woven as one.

    Args:
        families: warp and weft as if all their threads lay in one plane.
    """
    planes = _planes(found)
    if len(planes) == 1:
        return (), None
    ranks = np.full((len(found.stacks), len(planes)), -1, np.int8)
    for number, stack in enumerate(found.stacks):
        for rank, systems in enumerate(stack):
            ranks[number, planes.index(systems)] = rank
    layers = tuple(
        _layer(drawdown, _threads_of(found, plane), ranks[found.regions, number] >= 0, families, width_of)
        for number, plane in enumerate(planes)
    )
    return layers, Stacking(ranks, found.regions) if len(found.stacks) > 1 else None


def ties_between(drawdown: NDArray[np.bool_], found: Layers, layers: tuple[Layer, ...]) -> tuple[Ties, ...]:
    """Where threads of a cloth's layers, see `stacked_layers`, tie into the outermost ones, and are seen.

    A drawdown says that two threads of unlike layers cross the other way round, not which of them leaves its
    layer. It is taken to be the end: one from behind rises to the front, one of the front dives to the back.
    Ends that float are tied down by the picks across them.
    """
    planes = _planes(found)
    if len(planes) == 1:
        return ()
    pick, end = np.nonzero(binding_points(drawdown, found))
    if pick.size == 0:
        return ()
    stack, up = found.regions[pick, end].astype(np.intp), drawdown[pick, end]
    plane_of = np.zeros((len(found.stacks), len(found.systems)), np.intp)
    rank_of = np.zeros_like(plane_of)
    for number, groups in enumerate(found.stacks):
        for rank, systems in enumerate(groups):
            plane_of[number, list(systems)], rank_of[number, list(systems)] = planes.index(systems), rank
    of_end, of_pick = (np.zeros(count, np.intp) for count in drawdown.shape[::-1])
    for number, system in enumerate(found.systems):
        of_end[system.ends], of_pick[system.picks] = number, number
    floats = np.array([system.kind == "extra warp" for system in found.systems])[of_end[end]]
    is_warp, back = up | ~floats, ~up & ~floats
    over = np.where(is_warp, of_pick[pick], of_end[end])
    last = rank_of.max(axis=1)[stack]
    seen = rank_of[stack, over] == np.where(back, last, 0)
    own = np.where(is_warp, of_end[end], of_pick[pick])
    kinds = np.stack([plane_of[stack, own], plane_of[stack, over], is_warp, back], axis=1)
    ties = []
    for kind in np.unique(kinds[seen], axis=0):
        here = seen & (kinds == kind).all(axis=1)
        ties.append(_ties(layers, kind.tolist(), pick[here], end[here]))
    return tuple(ties)


def _ties(layers: tuple[Layer, ...], kind: list[int], pick: _Threads, end: _Threads) -> Ties:
    """Ties at crossings, of a kind: number of their layer, of the one tied, whether ends tie, on the back."""
    own, over, is_warp, back = layers[kind[0]], layers[kind[1]], bool(kind[2]), bool(kind[3])
    across, along = (own, over) if is_warp else (over, own)
    places = np.zeros((along.picks.size, across.ends.size), bool)
    places[np.searchsorted(along.picks, pick), np.searchsorted(across.ends, end)] = True
    # One thread that stands for a family which floats take none of leaves all room.
    rooms = [
        family.spacing.mean() for family in (over.layout.warp, over.layout.weft) if family.spacing.size > 1
    ]

    def squeezed(family: FamilyLayout) -> FamilyLayout:
        return replace(family, width=np.minimum(family.width, _TIE_WIDTH * min(rooms)))

    warp, weft = across.layout.warp, along.layout.weft
    warp, weft = (squeezed(warp), weft) if is_warp else (warp, squeezed(weft))
    layout = ClothLayout(places if is_warp != back else ~places, warp, weft)
    layer = Layer(layout, across.ends, along.picks, (across.start[0], along.start[1]))
    return Ties(layer, kind[0], kind[1], is_warp, back)


def _planes(found: Layers) -> list[tuple[int, ...]]:
    """The systems of each plane, as they first come from the front, in the order of stacks."""
    return list(dict.fromkeys(systems for stack in found.stacks for systems in stack))


def _threads_of(found: Layers, systems: tuple[int, ...]) -> tuple[_Threads, _Threads]:
    """Ends and picks of some systems, ascending."""
    ends, picks = (
        np.sort(np.concatenate([getattr(found.systems[number], family) for number in systems]))
        for family in ("ends", "picks")
    )
    return ends, picks


def _layer(
    drawdown: NDArray[np.bool_],
    threads: tuple[_Threads, _Threads],
    present: NDArray[np.bool_],
    families: tuple[FamilyLayout, FamilyLayout],
    width_of: WidthOf,
) -> Layer:
    placed = [_in_plane(*each, width_of) for each in zip(("warp", "weft"), threads, families, strict=True)]
    (warp, ends, left), (weft, picks, bottom) = placed
    ends_float, picks_float = threads[1].size == 0, threads[0].size == 0
    # Threads that float lie over the hairline.
    own = np.full((picks.size, ends.size), ends_float)
    if not (ends_float or picks_float):
        # Where it is no layer of the cloth its threads are others', over which they float. None sees it:
        # plain weave, the flattest, lets planes lie as near as they do.
        plain = np.add.outer(np.arange(picks.size), np.arange(ends.size)) % 2 == 0
        crossings = np.ix_(picks, ends)
        own = np.where(present[crossings], drawdown[crossings], plain)
    return Layer(ClothLayout(own, warp, weft), ends, picks, (left, bottom))


def _in_plane(
    name: str, threads: _Threads, family: FamilyLayout, width_of: WidthOf
) -> tuple[FamilyLayout, _Threads, float]:
    """Some threads of a family that fill a plane, their numbers, and where the room of the first begins."""
    if threads.size == 0:
        hairline = replace(family, spacing=np.array([family.spacing.sum()]), width=np.array([_HAIRLINE_MM]))
        return hairline, np.zeros(1, np.intp), 0.0
    spacing, start = shared_spacing(family.spacing, threads)
    return replace(family, spacing=spacing, width=width_of(name, threads, spacing)), threads, start
