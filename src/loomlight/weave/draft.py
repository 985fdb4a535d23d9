"""A draft: the drawdown (the thread on top at every crossing) and the threads.

The periodic binary matrix W[pick, end] is 1 (True) where the warp is on top; end 1 and pick 1 are index 0.
Below: what the WIF file of a draft has beyond it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.images import drawn_png

# Ends, and picks, of one repeat. Each crossing takes a byte here, and 12 bytes where it is rendered.
MAXIMUM_THREADS = 16384


@dataclass(frozen=True, eq=False)
class Threads:
    """One family of threads of a draft, in thread order; what a draft does not say is None.

    Attributes:
        colors: linear RGB [n, 3] in [0, 1].
        spacing_mm: distance that each thread takes up [n], millimetres, > 0.
        thickness_mm: diameter [n], millimetres, > 0; may exceed the spacing (dense cloth).
        color_index: 0-based row of the draft's palette that each thread has [n]; colours that are
            swapped by role (dark and light, say) are swapped by it, see `palette.with_palette`.
    """

    colors: NDArray[np.float64] | None = None
    spacing_mm: NDArray[np.float64] | None = None
    thickness_mm: NDArray[np.float64] | None = None
    color_index: NDArray[np.intp] | None = None


@dataclass(frozen=True, eq=False)
class LoomPlan:
    """The loom plan of a drawdown, which a draft drawing shows around it.

    Attributes:
        threading: shafts that carry each end, as sets of 1-based numbers (an empty set: on no shaft).
        shafts: how many shafts.
        treadles: how many treadles; 0 for a liftplan.
        tieup: shafts tied to each treadle, index 0 is treadle 1; None for a liftplan.
        treadling: treadles pressed for each pick; None for a liftplan.
        liftplan: shafts lifted for each pick; None for tie-up and treadling.
        rising_shed: whether a lifted shaft raises its ends (True) or lowers them.

    A file may hold a liftplan beside tie-up and treadling; the latter then say what is woven.
    """

    threading: tuple[frozenset[int], ...]
    shafts: int
    treadles: int = 0
    tieup: tuple[frozenset[int], ...] | None = None
    treadling: tuple[frozenset[int], ...] | None = None
    liftplan: tuple[frozenset[int], ...] | None = None
    rising_shed: bool = True


@dataclass(frozen=True, eq=False)
class Draft:
    """A weave draft. `drawdown` is bool [picks, ends], True where the warp is on top.

    Attributes:
        drawdown: bool [picks, ends], True where the warp is on top.
        warp: the ends, from left to right.
        weft: the picks, from the bottom upwards.
        title: name of the draft, one line.
        loom: how a loom weaves it, where that is known.
        palette: linear RGB [k, 3] in [0, 1] that the threads' `color_index` points into.
        notes: lines of text that came with the draft.
        source: other content of the file, so that writing it again loses nothing.

    Raises:
        InputError: an empty drawdown, or more than 16384 ends or picks.
    """

    drawdown: NDArray[np.bool_]
    warp: Threads = field(default_factory=Threads)
    weft: Threads = field(default_factory=Threads)
    title: str = ""
    loom: LoomPlan | None = None
    palette: NDArray[np.float64] | None = None
    notes: tuple[str, ...] = ()
    source: WifSource | None = None

    def __post_init__(self) -> None:
        picks, ends = self.drawdown.shape
        if picks == 0 or ends == 0:
            raise InputError(f"The draft has {ends} ends and {picks} picks; it needs at least one of each.")
        if max(picks, ends) > MAXIMUM_THREADS:
            raise InputError(
                f"The draft has {ends} ends and {picks} picks; at most {MAXIMUM_THREADS} of each can be used."
            )

    def _repr_png_(self) -> bytes | None:
        """The drawdown as PNG, which notebooks display."""
        return drawn_png(self)

    @property
    def ends(self) -> int:
        """Number of warp threads of one repeat."""
        return int(self.drawdown.shape[1])

    @property
    def picks(self) -> int:
        """Number of weft threads of one repeat."""
        return int(self.drawdown.shape[0])


# ----------------------------------------------------------------------- what a WIF file has beyond the draft
# Content of a WIF file beyond the draft, kept so that a file that is written again loses nothing.


# A section's lines in their order: key and value; None where the line had no "=".
Entries = tuple[tuple[str, str | None], ...]


@dataclass(frozen=True)
class FamilyDefaults:
    """Values of [WARP] or [WEFT] for all of its threads.

    Attributes:
        threads: the number of threads that is declared; None if none is.
        unit: name of the unit of lengths as the file spells it; "" if the file does not say.
        color_index: 0-based row of the palette; None without a default colour.
        spacing_mm: default spacing, millimetres.
        thickness_mm: default thickness, millimetres.
    """

    threads: int | None = None
    unit: str = ""
    color_index: int | None = None
    spacing_mm: float | None = None
    thickness_mm: float | None = None


@dataclass(frozen=True)
class WifSource:
    """The rest of a WIF file.

    Attributes:
        warp: the defaults of [WARP].
        weft: the defaults of [WEFT].
        color_range: the lowest and highest component in the file's colour table.
        entries: by section in capitals, the keys of known sections that say nothing about the cloth
            ("SOURCE PROGRAM" of [WIF], "AUTHOR" of [TEXT]).
        sections: private and unknown sections, name and lines, in file order.
    """

    warp: FamilyDefaults = field(default_factory=FamilyDefaults)
    weft: FamilyDefaults = field(default_factory=FamilyDefaults)
    color_range: tuple[int, int] = (0, 255)
    entries: tuple[tuple[str, Entries], ...] = ()
    sections: tuple[tuple[str, Entries], ...] = ()
