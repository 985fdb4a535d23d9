"""Layers of a draft: interlacements that lie upon one another and that no thread binds together.

Lifting a thread lifts every thread above it. A drawdown falls apart where some ends and picks can be lifted
off all others; since every end of a repeat crosses every pick, one repeat does so as endless cloth does.
"""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning


def layer_sizes(warp_up: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Ends and picks of each layer of a drawdown, from the top; threads that never interlace are in none.

    Let t ends and s of m picks be lifted off. Those ends pass over all m − s other picks, and those picks are
    below no other end, so that Σ (picks below those ends) − Σ (ends above those picks) = t·(m − s), which no
    other choice exceeds. Hence the ends that pass over most picks and the picks below fewest ends tell.

    Source: C. R. J. Clapham, When a fabric hangs together, Bull. London Math. Soc. 12 (1980).
    """
    picks, ends = warp_up.shape
    below_end = np.sort(np.count_nonzero(warp_up, axis=0))
    above_pick = np.sort(np.count_nonzero(warp_up, axis=1))
    lifted = np.arange(picks + 1)
    # Ends that pass over more than the other picks, and over as many: the latter lie upon them, or are loose.
    least = ends - np.searchsorted(below_end, picks - lifted, side="right")
    most = ends - np.searchsorted(below_end, picks - lifted, side="left")
    of_ends = np.concatenate([[0], np.cumsum(below_end[::-1])])[least]
    of_picks = np.concatenate([[0], np.cumsum(above_pick)])
    apart = np.flatnonzero(of_ends - of_picks == least * (picks - lifted))
    sizes = zip((least[apart[1:]] - most[apart[:-1]]).tolist(), np.diff(apart).tolist(), strict=True)
    return [(of_layer, in_layer) for of_layer, in_layer in sizes if of_layer > 0 and in_layer > 0]


def warn_of_layers(warp_up: NDArray[np.bool_], file: str) -> None:
    """Warns in a sentence, which begins with the file, of a drawdown that holds layers."""
    sizes = layer_sizes(warp_up)
    if len(sizes) > 1:
        (ends, picks), (under_ends, under_picks) = sizes[:2]
        warnings.warn(
            f"{file} holds {len(sizes)} layers of cloth that no thread binds together ({ends} ends and "
            f"{picks} picks lie above {under_ends} ends and {under_picks} picks); they are drawn in a single "
            "plane.",
            LoomlightWarning,
            stacklevel=3,
        )
