"""The order of colours among the threads of a photographed cloth: stripes and checks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.crossings import Crossings
from loomlight.core.colour import delta_e_2000, lab_of_linear, srgb_to_linear

# Threads of one dye differ by less (CIEDE2000): shades of uneven yarns, and noise, reach about 4.
_SAME_DYE = 7.0
# The same of one thread alone: a stripe of one differs by more.
_LONE = 14.0
# Shades that differ by less and follow one another without order are unevenness too: stripes repeat.
_UNEVEN = 12.0
MAX_COLOURS = 8
# Threads that may break an order that repeats, as a share.
_MAX_BREAKS = 0.06


@dataclass(frozen=True, eq=False)
class ColourOrder:
    """The colours of a family.

    Attributes:
        colours: linear RGB [k, 3], as the cloth shows them.
        order: which of them each thread of one repeat has [n].
        first: which thread of the repeat column 0, or row 0, of the crossings is.
        repeats: whether it was seen to repeat; otherwise it is all threads of the picture.
    """

    colours: NDArray[np.float64]
    order: NDArray[np.intp]
    first: int
    repeats: bool

    def of_threads(self, count: int) -> NDArray[np.intp]:
        """The colour of each thread of the table [count]."""
        return np.asarray(self.order[(np.arange(count) + self.first) % len(self.order)])


def grouped_order(order: ColourOrder, times: int, ahead: int) -> ColourOrder:
    """The order of threads of which so many lie in the place of one.

    Args:
        ahead: threads before column 0, or row 0, of the finer table from the first one of the coarser.
    """
    if times == 1:
        return order
    return ColourOrder(order.colours, order.order.repeat(times), times * order.first + ahead, order.repeats)


def colour_orders(crossings: Crossings, warp_up: NDArray[np.bool_]) -> tuple[ColourOrder, ColourOrder]:
    """Those of warp and weft, from the crossings where each is on top, bool [picks, ends]."""
    linear = srgb_to_linear(np.clip(crossings.colour, 0, 1))
    return _order(linear, warp_up), _order(linear.transpose(1, 0, 2), ~warp_up.T)


def _order(shown: NDArray[np.float64], on_top: NDArray[np.bool_]) -> ColourOrder:
    """The order of the threads of columns."""
    weight = on_top.sum(axis=0)
    seen = weight > 0
    threads = np.full((shown.shape[1], 3), np.nan)
    # A median of each thread: crossings at its floats' ends are darker.
    for number in np.flatnonzero(seen):
        threads[number] = np.median(shown[on_top[:, number], number], axis=0)
    if not seen.any():
        whole = np.median(shown.reshape(-1, 3), axis=0)[None]
        return ColourOrder(whole, np.zeros(1, np.intp), 0, True)
    labels = np.zeros(len(threads), np.intp)
    found = _clusters(threads[seen], weight[seen])
    labels[seen] = found
    # A thread that never shows takes the colour of the one before.
    for number in np.flatnonzero(~seen):
        labels[number] = labels[number - 1] if number else found[0]
    colours = np.array(
        [
            np.average(threads[seen][found == each], axis=0, weights=weight[seen][found == each])
            for each in range(found.max() + 1)
        ]
    )
    period = _period(labels, len(colours))
    if period is None and _largest_difference(colours) < _UNEVEN:
        mean = np.average(threads[seen], axis=0, weights=weight[seen])
        return ColourOrder(mean[None], np.zeros(1, np.intp), 0, True)
    if period is None:
        return ColourOrder(colours, labels, 0, False)
    repeat = np.array([np.bincount(labels[start::period]).argmax() for start in range(period)], np.intp)
    return ColourOrder(colours, repeat, 0, True)


def _largest_difference(colours: NDArray[np.float64]) -> float:
    """CIEDE2000 between the two of linear RGB [k, 3] that differ most."""
    labs = lab_of_linear(colours)
    return float(delta_e_2000(labs[:, None], labs[None, :]).max())


def _clusters(threads: NDArray[np.float64], weight: NDArray[np.intp]) -> NDArray[np.intp]:
    """Labels of colours: groups of threads whose means are nearest are joined until all are distinct."""
    labs = lab_of_linear(threads)
    groups = [[number] for number in range(len(threads))]
    means = list(labs)
    while len(groups) > 1:
        stacked = np.array(means)
        apart = delta_e_2000(stacked[:, None], stacked[None, :])
        np.fill_diagonal(apart, np.inf)
        one, other = sorted(divmod(int(np.argmin(apart)), len(groups)))
        if apart[one, other] > _SAME_DYE and len(groups) <= MAX_COLOURS:
            break
        groups[one] += groups.pop(other)
        means.pop(other)
        means[one] = np.average(labs[groups[one]], axis=0, weights=weight[groups[one]])
    # A single thread of nearly the same shade among many is unevenness.
    if len(threads) >= 8:
        for lone in [group for group in groups if len(group) == 1]:
            others = [group for group in groups if group is not lone]
            off = [float(delta_e_2000(labs[lone].mean(axis=0), labs[group].mean(axis=0))) for group in others]
            if off and min(off) < _LONE:
                others[int(np.argmin(off))] += lone
                groups = others
    labels = np.zeros(len(threads), np.intp)
    for label, group in enumerate(sorted(groups, key=min)):
        labels[group] = label
    return labels


def _period(labels: NDArray[np.intp], colours: int) -> int | None:
    """Threads of the shortest order that repeats at least twice; None if none does."""
    if colours == 1:
        return 1
    for period in range(2, len(labels) // 2 + 1):
        if float((labels[period:] != labels[:-period]).mean()) <= _MAX_BREAKS:
            return period
    return None
