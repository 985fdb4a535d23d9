"""Which weave the crossings of a photograph show: named weaves in all places, told by colour and shading.

Of a structure each end has one colour, each pick has one, and each crossing shows that of the thread on top;
warp and weft each have a mean of the two numbers of shading. What is left after these means are taken out
says how well the structure fits, a likelihood whose variances are unknown.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.crossings import Crossings
from loomlight.weave.named import named_weave
from loomlight.weave.recognition import weave_name
from loomlight.weave.structures import satin_steps

Structure = NDArray[np.bool_]

# Share of a channel's variance that noise has at least: what no photograph is free of.
_NOISE_FLOOR = 0.02
# Of a weave without a name: threads of its repeat, crossings that may break it, and the share of the variance
# that two groups of crossings may leave.
_MAX_FREE, _MAX_BREAKS, _MAX_WITHIN = 24, 0.08, 0.35
# Rounds in which the edge between two groups settles.
_ROUNDS = 12
# Deviation of encoded colours below which two families look alike.
_SAME_COLOUR = 0.012
# The same of hues, shares of the sum of channels, and the sum below which they are mostly noise.
_SAME_HUE, _DARK = 0.004, 0.15


@dataclass(frozen=True, eq=False)
class WeaveFit:
    """One structure in its best place.

    Attributes:
        name: as `named_weave` reads it; "" of a weave without one.
        structure: bool [picks, ends], one repeat, True where the warp is on top.
        shift: which pick and end of the repeat row 0 and column 0 of the crossings are.
        score: logarithm of its likelihood, above that of one family alone.
        unsigned: the same, whichever family the shading says is on top.
    """

    name: str
    structure: Structure
    shift: tuple[int, int]
    score: float
    unsigned: float

    def table(self, shape: tuple[int, int]) -> Structure:
        """The drawdown of all crossings, bool [picks, ends]."""
        return placed(self.structure, self.shift, shape)


def placed(structure: Structure, shift: tuple[int, int], shape: tuple[int, int]) -> Structure:
    """A repeat over a whole table, begun at a pick and an end of it."""
    picks, ends = structure.shape
    rows, columns = (np.arange(shape[0]) + shift[0]) % picks, (np.arange(shape[1]) + shift[1]) % ends
    return np.asarray(structure[np.ix_(rows, columns)])


@cache
def candidates() -> tuple[tuple[str, bytes, tuple[int, int]], ...]:
    """Names and structures of all weaves that are tried; no two are the same in other places."""
    found: dict[tuple[tuple[int, int], bytes], str] = {}
    for name in _names():
        structure = named_weave(name).drawdown
        found.setdefault((structure.shape, _canonical(structure)), name)
    return tuple(
        (name, np.packbits(named_weave(name).drawdown).tobytes(), named_weave(name).drawdown.shape)
        for name in found.values()
    )


def _names() -> Iterator[str]:
    yield "plain"
    for over in range(1, 6):
        for under in range(1, 6):
            if 3 <= over + under <= 8:
                yield from (f"twill {over}/{under} {way}" for way in "zs")
    for parts in ("1/1/2/2", "2/1/1/2", "3/1/1/3", "3/1/1/1", "1/1/1/3", "2/2/1/1", "3/2/1/2", "3/3/1/1"):
        yield from (f"twill {parts} {way}" for way in "zs")
    for ends in (5, 6, 7, 8, 10):
        for step in satin_steps(ends):
            yield from (f"{kind} {ends}/{step}" for kind in ("satin", "sateen"))
    for counts in ("2/2", "3/3", "2/1", "3/1", "4/4"):
        yield from (f"{kind} rib {counts}" for kind in ("warp", "weft"))
    for ends, picks in ((2, 2), (3, 3), (4, 4), (2, 1), (1, 2), (3, 2), (2, 3)):
        yield f"basket {ends}/{picks}"
    for parts in ("2/2", "2/1", "3/1", "1/3", "3/3"):
        for leg in (4, 6, 8, 9, 10, 12, 16):
            yield f"herringbone {parts} {leg}"
    for parts in ("2/2", "3/1", "1/3", "2/1"):
        for leg in (4, 6, 8):
            yield f"diamond {parts} {leg}"
    yield from ("waffle 6", "waffle 8", "waffle 10", "crepe")


def _canonical(structure: Structure) -> bytes:
    """The least of all its shifts."""
    picks, ends = structure.shape
    return min(
        np.roll(structure, (down, right), axis=(0, 1)).tobytes()
        for down in range(picks)
        for right in range(ends)
    )


@cache
def _names_of_candidates() -> dict[tuple[tuple[int, int], bytes], str]:
    return {(shape, _canonical(named_weave(name).drawdown)): name for name, _, shape in candidates()}


def candidate_name(structure: Structure) -> str | None:
    """The name of the weave that is tried and is this structure in some place; None if none is."""
    return _names_of_candidates().get((structure.shape, _canonical(structure)))


def fit_weaves(crossings: list[Crossings], most: int | None = None) -> list[WeaveFit]:
    """All weaves in their best places, best first.

    Args:
        crossings: of the face, and where there is a photograph of it, of the back, seen from behind.
        most: crossings of the repeat of a weave that is tried; all weaves are by default.
    """
    evidence = [_Evidence(part) for part in crossings]
    fits = []
    for name, packed, shape in candidates():
        if most is not None and shape[0] * shape[1] > most:
            continue
        bits = np.unpackbits(np.frombuffer(packed, np.uint8), count=shape[0] * shape[1])
        structure = bits.reshape(shape).astype(bool)
        fits.append(_best_place(name, structure, evidence))
    return sorted(fits, key=lambda fit: -fit.score)


def fit_drafts(crossings: list[Crossings], fits: list[WeaveFit]) -> list[WeaveFit]:
    """Weaves that no candidate is: crossings told apart by colour, and their repeat; two, or none.

    Args:
        fits: of the candidates.
    """
    up = _parted(crossings[0].colour)
    sides = None if up is None else [_repeat_of(rows) for rows in (up, up.T)]
    if up is None or sides is None or None in sides:
        return []
    picks, ends = (int(side or 0) for side in sides)
    # What most crossings at one place of the repeat are.
    structure = _folded(np.where(up, 0.5, -0.5), (picks, ends)) > 0
    known = {_canonical(fit.structure) for fit in fits if fit.structure.shape == structure.shape}
    found = []
    for each in (structure, ~structure):
        # Each end and each pick is on top somewhere and below elsewhere, or it would fall out of the cloth.
        bound = all(each.any(axis=axis).all() and not each.all(axis=axis).any() for axis in (0, 1))
        if not bound or _canonical(each) in known:
            continue
        fit = fit_structure(_name_of(each), each, crossings)
        # Each crossing of the repeat is free: a choice of two that a name has not.
        cost = float(np.log(2) * each.size)
        found.append(WeaveFit(fit.name, each, fit.shift, fit.score - cost, fit.unsigned - cost))
    return found


def _name_of(structure: Structure) -> str:
    """The name of a structure if it has one that is read again as the same, else ""."""
    name = weave_name(structure)
    if name is None or name.startswith("mostly"):
        return ""
    again = named_weave(name).drawdown
    return name if again.shape == structure.shape and _canonical(again) == _canonical(structure) else ""


def _parted(colour: NDArray[np.float64]) -> Structure | None:
    """Crossings in two groups by colour, bool [picks, ends]; None where they are no two."""
    flat = colour.reshape(-1, 3) - colour.mean(axis=(0, 1))
    _, _, axes = np.linalg.svd(flat, full_matrices=False)
    along = flat @ axes[0]
    edge = 0.0
    for _ in range(_ROUNDS):
        low, high = along[along <= edge], along[along > edge]
        if not low.size or not high.size:
            return None
        edge = 0.5 * float(low.mean() + high.mean())
    within = low.size * low.var() + high.size * high.var()
    if within > _MAX_WITHIN * along.size * along.var():
        return None
    return np.asarray((along > edge).reshape(colour.shape[:2]))


def _repeat_of(rows: Structure) -> int | None:
    """After how many rows a table is the same again, but for few crossings; None if it is seen but once."""
    for period in range(1, min(_MAX_FREE, len(rows) // 2) + 1):
        if float((rows[period:] != rows[:-period]).mean()) <= _MAX_BREAKS:
            return period
    return None


def fit_structure(name: str, structure: Structure, crossings: list[Crossings]) -> WeaveFit:
    """One structure in its best place."""
    return _best_place(name, structure, [_Evidence(part) for part in crossings])


def complement_of(fit: WeaveFit, fits: list[WeaveFit], face: Crossings) -> WeaveFit | None:
    """Of the fits of all weaves that of the cloth whose families have changed places; None if unnamed.

    Args:
        face: the crossings that tell how likely it is in this place.
    """
    opposite = ~fit.structure
    wanted = opposite.shape, _canonical(opposite)
    for other in fits:
        if (other.structure.shape, _canonical(other.structure)) == wanted:
            # In the place where the same crossings are told apart.
            place = next(
                (down, right)
                for down in range(opposite.shape[0])
                for right in range(opposite.shape[1])
                if np.array_equal(placed(other.structure, (down, right), opposite.shape), opposite)
            )
            shift = (
                (fit.shift[0] + place[0]) % opposite.shape[0],
                (fit.shift[1] + place[1]) % opposite.shape[1],
            )
            # The other may be likeliest in another place, as a twill is that is its own complement.
            signed, _ = _Evidence(face).scores(other.structure)
            score = other.score - float(signed.max() - signed[shift])
            return WeaveFit(other.name, other.structure, shift, score, fit.unsigned)
    return None


def _best_place(name: str, structure: Structure, evidence: list[_Evidence]) -> WeaveFit:
    score, unsigned, shift = evidence[0].best(structure)
    for behind in evidence[1:]:
        # From behind, left is right, and the other family is on top.
        of_back, unsigned_of_back, _ = behind.best(~structure[:, ::-1])
        score, unsigned = score + of_back, unsigned + unsigned_of_back
    # A structure of many crossings has as many more places where chance may fit it.
    chance = float(np.log(structure.size)) + _unseen(structure.shape, evidence[0].shape)
    return WeaveFit(name, structure, shift, score - chance, unsigned - chance)


def _unseen(repeat: tuple[int, int], shape: tuple[int, int]) -> float:
    """What a repeat that the picture shows once or barely costs, in logarithms of a likelihood.

    A thread that was not seen again in a second repeat is a free choice of two, not one that was checked.
    """
    missing = [max(0.0, 2 * threads - shown) for threads, shown in zip(repeat, shape, strict=True)]
    return float(np.log(2) * sum(missing))


class _Evidence:
    """The channels of a table of crossings."""

    def __init__(self, crossings: Crossings) -> None:
        # Hues beside colours: highlights make crossings of one yarn bright and dark, but of about one hue.
        hue = crossings.colour / (crossings.colour.sum(axis=-1, keepdims=True) + _DARK)
        self._colours = [
            (part - part.mean(axis=(0, 1)), same**2 * part.size)
            for part, same in ((crossings.colour, _SAME_COLOUR), (hue, _SAME_HUE))
        ]
        self._shading = [_bounded(part) for part in (crossings.roundness, crossings.edging)]
        self.shape = crossings.shape
        self._votes = crossings.votes

    def best(self, structure: Structure) -> tuple[float, float, tuple[int, int]]:
        """The score of a structure in its best place, the same unsigned, and that place."""
        signed, unsigned = self.scores(structure)
        down, right = np.unravel_index(int(np.argmax(signed)), signed.shape)
        place = int(down), int(right)
        return float(signed[place]), float(unsigned[place]), place

    def scores(self, structure: Structure) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Logarithms of the likelihood in all places, against no weave, signed and unsigned [picks, ends]."""
        turned = _turned(structure)
        gain = np.zeros(structure.shape)
        for colour, floor in self._colours:
            total = float(np.square(colour).sum()) + floor
            explained = _explained(turned, colour)
            # Of picks the table is laid on its side, and the weft is what is on top.
            explained += _explained(~turned.transpose(1, 0, 3, 2), colour.transpose(1, 0, 2)).T
            gain -= 0.5 * np.log(np.maximum((total - explained) / total, _NOISE_FLOOR))
        unsigned = gain.copy()
        counts = _folded(np.ones(self.shape), structure.shape)
        over_count = np.einsum("abpq,pq->ab", turned, counts)
        under_count = counts.sum() - over_count
        for channel in self._shading:
            sums = _folded(channel, structure.shape)
            over = np.einsum("abpq,pq->ab", turned, sums)
            under = sums.sum() - over
            apart = over / np.maximum(over_count, 1) - under / np.maximum(under_count, 1)
            share = over_count / counts.sum()
            between = share * (1 - share) * np.square(apart) / (float(channel.var()) + 1e-9)
            part = -0.5 * np.log(np.maximum(1 - between, _NOISE_FLOOR))
            gain += np.where(apart > 0, part, -part)
            unsigned += part
        return self._votes * gain, self._votes * unsigned


def _turned(structure: Structure) -> NDArray[np.bool_]:
    """A repeat begun at each of its picks and ends, bool [picks, ends, picks, ends]."""
    picks, ends = structure.shape
    rows = (np.arange(picks)[:, None] + np.arange(picks)[None, :]) % picks
    columns = (np.arange(ends)[:, None] + np.arange(ends)[None, :]) % ends
    return structure[rows[:, None, :, None], columns[None, :, None, :]]


def _folded(channel: NDArray[np.float64], repeat: tuple[int, int]) -> NDArray[np.float64]:
    """Sums over all crossings at one place of a repeat [picks, ends]."""
    return _folded_along(_folded_along(channel, repeat[0]).swapaxes(0, 1), repeat[1]).swapaxes(0, 1)


def _folded_along(table: NDArray[np.float64], period: int) -> NDArray[np.float64]:
    """Sums over rows of one number modulo a period [period, ...]."""
    missing = -len(table) % period
    padded = np.concatenate([table, np.zeros((missing, *table.shape[1:]))])
    return np.asarray(padded.reshape(-1, period, *table.shape[1:]).sum(axis=0))


def _explained(turned: NDArray[np.bool_], colour: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sum of squares of the mean of each end where it is on top, in all places [picks, ends]."""
    picks, ends = turned.shape[:2]
    sums = _folded_along(colour, picks)
    counts = _folded_along(np.ones(colour.shape[:2]), picks)
    # Which end of the repeat each end of the table is.
    of_table = turned[..., np.arange(colour.shape[1]) % ends].astype(np.float64)
    total = np.einsum("abpi,pic->abic", of_table, sums)
    number = np.einsum("abpi,pi->abi", of_table, counts)
    return np.asarray((np.square(total).sum(axis=-1) / np.maximum(number, 1)).sum(axis=-1))


def _bounded(channel: NDArray[np.float64]) -> NDArray[np.float64]:
    """A channel whose few wild values count no more than three deviations."""
    middle = np.median(channel)
    spread = 1.4826 * np.median(np.abs(channel - middle)) + 1e-9
    return np.asarray(np.clip(channel - middle, -3 * spread, 3 * spread))
