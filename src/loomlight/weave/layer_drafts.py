"""One layer of a drawdown by itself, as a draft; where threads bind layers; and all of them in words."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.layers import ROWS_AT_ONCE, Bits, Indices, Layers, ThreadSystem, find_layers, layer_sizes
from loomlight.weave.recognition import weave_name
from loomlight.weave.textile import sett_per_cm


@dataclass(frozen=True, eq=False)
class LayerDraft:
    """One layer of a drawdown by itself, as if nothing lay upon it.

    It has a column for each end, and a row for each pick, of the finest cloth that is somewhere in this
    layer; where another is, the threads next to there.

    Attributes:
        end: 0-based end of the whole drawdown that each column and row shows, uint16 [rows, columns].
        pick: its 0-based pick, likewise.
        warp_up: bool [rows, columns], True where the warp is on top.
    """

    end: NDArray[np.uint16]
    pick: NDArray[np.uint16]
    warp_up: Bits


def layer_draft(warp_up: Bits, layers: Layers, layer: int) -> LayerDraft:
    """One layer by itself.

    Args:
        warp_up: the whole drawdown, bool [picks, ends].
        layers: its layers.
        layer: 0 for the front, 1 for what lies behind it, …; −1 for the back. Where fewer lie upon one
            another, the one furthest behind.
    """
    picks, ends = warp_up.shape
    groups = [stack[layer if layer < 0 else min(layer, len(stack) - 1)] for stack in layers.stacks]
    threads = [_threads_of(layers, group) for group in groups]
    columns = max((of_end for of_end, _ in threads), key=len)
    rows = max((of_pick for _, of_pick in threads), key=len)
    end_at = np.stack([_next_to(of_end, columns, ends) for of_end, _ in threads]).astype(np.uint16)
    pick_at = np.stack([_next_to(of_pick, rows, picks) for _, of_pick in threads]).astype(np.uint16)
    stack = layers.regions[np.ix_(rows, columns)]
    end = end_at[stack, np.arange(len(columns))[None]]
    pick = pick_at[stack, np.arange(len(rows))[:, None]]
    return LayerDraft(end, pick, warp_up[pick, end])


def named_layer(draft: Draft, name: str) -> LayerDraft:
    """The layer "front", "back", or the one of a number from 1, which is the front.

    Raises:
        InputError: another name, or more than the layers that the draft has.
    """
    layers = find_layers(draft.drawdown)
    if name == "back":
        return layer_draft(draft.drawdown, layers, -1)
    number = 1 if name == "front" else int(name) if name.isascii() and name.isdigit() and len(name) < 4 else 0
    if not 1 <= number <= layers.depth:
        single = (
            "the draft has a single layer" if layers.depth == 1 else f"the draft has {layers.depth} layers"
        )
        raise InputError(
            f'The layer "{name[:20]}" is not there: {single}; "front", "back" and 1 to {layers.depth} are.'
        )
    return layer_draft(draft.drawdown, layers, number - 1)


def plain_draft(draft: Draft, layer: LayerDraft) -> Draft | None:
    """The layer as a draft of its own threads; None if cloths change places in it.

    Each thread takes up the room of those that lie above and below it.
    """
    end, pick = layer.end[0], layer.pick[:, 0]
    if np.any(layer.end != end[None]) or np.any(layer.pick != pick[:, None]):
        return None
    return Draft(
        layer.warp_up,
        _kept(draft.warp, end.astype(np.intp), draft.ends),
        _kept(draft.weft, pick.astype(np.intp), draft.picks),
        title=draft.title,
        palette=draft.palette,
    )


def binding_points(warp_up: Bits, layers: Layers) -> Bits:
    """Where a thread lies upon one of a layer in front of its own, and binds the two, bool [picks, ends]."""
    of_end, of_pick = _system_of_threads(layers, warp_up.shape)
    depth = _depths(layers)
    binding = np.empty(warp_up.shape, bool)
    for first in range(0, len(warp_up), ROWS_AT_ONCE):
        rows = slice(first, first + ROWS_AT_ONCE)
        stack = layers.regions[rows]
        end, pick = depth[stack, of_end[None]], depth[stack, of_pick[rows, None]]
        binding[rows] = np.where(warp_up[rows], end > pick, end < pick)
    return binding


def _threads_of(layers: Layers, group: tuple[int, ...]) -> tuple[Indices, Indices]:
    """Ends and picks of a layer's systems; across extra threads lie those of their host, without one all."""
    picks_of_all, ends_of_all = (np.arange(count) for count in layers.regions.shape)
    ends, picks = [], []
    for at in group:
        system = layers.systems[at]
        host = None if system.host is None else layers.systems[system.host]
        ends.append(system.ends if system.ends.size else ends_of_all if host is None else host.ends)
        picks.append(system.picks if system.picks.size else picks_of_all if host is None else host.picks)
    return np.unique(np.concatenate(ends)), np.unique(np.concatenate(picks))


def _next_to(threads: Indices, places: Indices, count: int) -> Indices:
    """Of these threads, of `count` that repeat, the one nearest to each place; of two, the later."""
    around = np.concatenate([threads[-1:] - count, threads, threads[:1] + count])
    after = np.searchsorted(around, places)
    before = around[after - 1]
    return np.where(places - before < around[after] - places, before, around[after]) % count


def _kept(threads: Threads, kept: Indices, count: int) -> Threads:
    def some(values: NDArray | None) -> NDArray | None:
        return None if values is None else values[kept]

    spacing = threads.spacing_mm
    if spacing is not None:
        # Each thread has the room up to the next one that is kept.
        until = np.concatenate([[0.0], np.cumsum(np.concatenate([spacing, spacing]))])
        spacing = until[np.append(kept[1:], kept[0] + count)] - until[kept]
    return Threads(some(threads.colors), spacing, some(threads.thickness_mm), some(threads.color_index))


def _system_of_threads(layers: Layers, shape: tuple[int, ...]) -> tuple[Indices, Indices]:
    of_pick, of_end = np.zeros(shape[0], np.intp), np.zeros(shape[1], np.intp)
    for at, system in enumerate(layers.systems):
        of_end[system.ends], of_pick[system.picks] = at, at
    return of_end, of_pick


def _depths(layers: Layers) -> NDArray[np.int8]:
    """How far behind each system lies in each stack, 0 in front [stacks, systems]."""
    depth = np.zeros((len(layers.stacks), len(layers.systems)), np.int8)
    for at, stack in enumerate(layers.stacks):
        for below, group in enumerate(stack):
            depth[at, list(group)] = below
    return depth


# --------------------------------------------------------------------------------------------------- in words


def layers_text(draft: Draft) -> str:
    """Order, weaves, setts and stitches of a draft's layers in a few lines for a person; "" for one layer."""
    layers = find_layers(draft.drawdown)
    exact = layer_sizes(draft.drawdown)
    if len(layers.systems) == 1:
        if len(exact) == 1 or not exact:
            return ""
        return (
            f"layers: {len(exact)} that no thread binds together; as the threads of one do not lie among "
            "those of another, it cannot be told where each is"
        )
    names = [chr(ord("A") + at) for at in range(len(layers.systems))]
    lines = [f"layers: {layers.depth}, {_stacks_text(layers, names)}"]
    for name, system in zip(names, layers.systems, strict=True):
        lines.append(f"  {name}: {_system_text(draft, layers, system, names)}")
    return "\n".join([*lines, *_binding_text(draft, layers, names)])


def _stacks_text(layers: Layers, names: list[str]) -> str:
    said = [
        " upon ".join(
            " and ".join(names[at] for at in group) + (" woven as one" if len(group) > 1 else "")
            for group in stack
        )
        for stack in layers.stacks
    ]
    if len(said) == 1:
        return said[0]
    shares = layers.shares()
    order = np.argsort(-shares, kind="stable")
    return "; ".join(f"{said[at]} in {100 * shares[at]:.3g} % of the cloth" for at in order)


def _system_text(draft: Draft, layers: Layers, system: ThreadSystem, names: list[str]) -> str:
    ends, picks = _counted("end", system.ends), _counted("pick", system.picks)
    if system.kind != "cloth":
        host = "" if system.host is None else f" of {names[system.host]}"
        return f"{system.kind}{host}, {ends or picks}"
    warp, weft = _kept(draft.warp, system.ends, draft.ends), _kept(draft.weft, system.picks, draft.picks)
    setts = ""
    if (across := sett_per_cm(warp)) is not None and (along := sett_per_cm(weft)) is not None:
        setts = f", {across:.3g} ends/cm and {along:.3g} picks/cm"
    of_own = np.ix_(system.picks, system.ends)
    at = layers.systems.index(system)
    alone = np.array([(at,) in stack for stack in layers.stacks])
    weave = weave_name(draft.drawdown[of_own], None if alone.all() else alone[layers.regions[of_own]])
    return f"{weave or 'cloth'}, {ends} and {picks}{setts}"


def _counted(word: str, threads: Indices) -> str:
    """Threads by number and the first of them, "8 ends (1, 3, 5 …)"; "" for none."""
    if threads.size == 0:
        return ""
    first = ", ".join(str(int(thread) + 1) for thread in threads[:3])
    plural = "" if threads.size == 1 else "s"
    return f"{threads.size} {word}{plural} ({first}{' …' if threads.size > 3 else ''})"


def _binding_text(draft: Draft, layers: Layers, names: list[str]) -> list[str]:
    """A line for each two systems: at how many of their crossings one binds the other."""
    binding = binding_points(draft.drawdown, layers)
    lines = []
    for one, above in enumerate(layers.systems):
        for other in range(one + 1, len(layers.systems)):
            below = layers.systems[other]
            crossings = [np.ix_(above.picks, below.ends), np.ix_(below.picks, above.ends)]
            bound = sum(int(np.count_nonzero(binding[part])) for part in crossings)
            total = sum(binding[part].size for part in crossings)
            if bound:
                lines.append(f"  {names[one]} and {names[other]} are bound at {bound} of {total} crossings")
    return lines or ["  no thread binds one to another"]
