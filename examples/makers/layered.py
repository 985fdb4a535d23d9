"""Ten drafts of layered cloth, as `Draft`s; run, it writes them as WIF files.

Each is a lifting plan of a few rules: which ends and picks belong to which cloth, the weave of each cloth,
and which cloth lies in front. What lies in front passes over all of what lies behind; single crossings that
break the rule bind cloths to one another.
Run: python -m examples.makers.layered examples/layered
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.structures import Structure, plain, sateen, twill
from loomlight.weave.wif_writer import write_wif

PALETTE = {"A": "#c02020", "B": "#2030c0", "C": "#e8e0cc", "D": "#3a3a3a"}
SPACING_MM = 0.4


def double_plain() -> Draft:
    """Two plain cloths that nothing binds: red over blue, ends and picks in turn."""
    return _draft("double plain", "ABAB", "ABAB", stacked("ABAB", "ABAB", {"A": plain(), "B": plain()}))


def tube(width: int = 12) -> Draft:
    """Two plain cloths that one weft weaves in turn, `width` ends in front and one less behind.

    Around the tube the ends are odd in number, so that the weft, which goes round and round, finds plain
    weave wherever it comes again. Pick 1 passes the front from the left, pick 2 the back from the right.
    """
    around = [*range(0, 2 * width - 1, 2), *range(2 * width - 3, 0, -2)]
    order = "".join("AB"[end % 2] for end in range(2 * width - 1))
    drawdown = np.zeros((4, len(order)), dtype=bool)
    for pick in range(4):
        cloth = "AB"[pick % 2]
        turn = pick // 2 * len(around)
        for step, end in enumerate(around):
            # Seen from outside, warp and weft are on top in turn; the back's outside is its underside.
            outside_is_warp = (turn + step) % 2 == 0
            woven = outside_is_warp if order[end] == "A" else not outside_is_warp
            drawdown[pick, end] = woven if order[end] == cloth else order[end] == "A"
    return _draft("tube", order, "ABAB", drawdown, colours={"A": "A", "B": "A"})


def pocket(inside: int = 24, border: int = 8) -> Draft:
    """Squares of two plain cloths, which all ends and picks join to one plain cloth between the squares."""
    order = "AB" * ((inside + border) // 2)
    apart = stacked(order, order, {"A": plain(), "B": plain()})
    joined = np.indices(apart.shape).sum(axis=0) % 2 == 0
    in_square = np.arange(len(order)) < inside
    return _draft("pocket", order, order, np.where(in_square[:, None] & in_square[None], apart, joined))


def pattern_double_weave(block: int = 16) -> Draft:
    """Two plain cloths that change places in squares of `block` ends and picks, as a chequerboard."""
    order = "AB" * block
    side = np.arange(2 * block) // block
    a_in_front = side[:, None] == side[None]
    return _draft(
        "two-block pattern double weave",
        order,
        order,
        stacked(order, order, {"A": plain(), "B": plain()}, front=lambda first: a_in_front == (first == "A")),
    )


def four_layers() -> Draft:
    """Four plain cloths that nothing binds."""
    order = "ABCDABCD"
    return _draft("four layers", order, order, stacked(order, order, dict.fromkeys("ABCD", plain())))


def extra_weft_figure(side: int = 32) -> Draft:
    """A plain cloth with a second weft after each of its picks: a diamond in front, floats behind elsewhere.

    In the diamond every eighth end binds the floats, behind it every sixteenth, where the pick of the ground
    before covers that end.
    """
    ends, picks = "A" * side, "AB" * side
    across = np.abs(np.arange(side) - side / 2 + 0.5)
    along = np.abs(np.arange(side) - side / 2 + 0.5)
    figure = along[:, None] + across[None] < 3 * side / 8
    floats = _filled(sateen(8, 3), side)
    behind = ~np.roll(_filled(sateen(16, 7), side), 1, axis=1)
    drawdown = np.empty((2 * side, side), dtype=bool)
    drawdown[::2] = _filled(plain(), side)
    drawdown[1::2] = np.where(figure, floats, behind)
    return _draft("extra-weft figure", ends, picks, drawdown, colours={"A": "C", "B": "A"})


def matelasse(groups: int = 16) -> Draft:
    """A fine plain cloth over a coarse one, wadding between them, quilted along the lines of a diamond.

    Of each group of two ends of the face and one behind, and of four picks of the face, one of wadding and
    one behind, the end behind rises over a pick of the face where the group lies on a line.
    """
    ends, picks = "AAB" * groups, "AACAAB" * groups
    drawdown = stacked(ends, picks, {"A": plain(), "C": plain(), "B": plain()})
    line = np.arange(groups)
    on_line = ((line[:, None] + line[None]) % groups == 0) | ((line[:, None] - line[None]) % groups == 0)
    drawdown[0::6, 2::3] |= on_line
    return _draft("matelassé", ends, picks, drawdown, colours={"A": "C", "B": "D", "C": "B"})


def backed_twill() -> Draft:
    """One warp, two wefts: a weft-faced twill, and behind each pick one that binds below its floats."""
    drawdown = np.empty((8, 4), dtype=bool)
    drawdown[::2] = twill((1, 3))
    # The picks before and after cover the end that binds the pick behind.
    drawdown[1::2] = ~np.roll(twill((1, 3)), 2, axis=1)
    return _draft("backed twill", "AAAA", "AB" * 4, drawdown, colours={"A": "C", "B": "B"})


def stitched_double_cloth() -> Draft:
    """A 2/2 twill over another; each end behind rises over one pick of the face between two raised ends."""
    order = "AB" * 8
    drawdown = stacked(order, order, {"A": twill((2, 2)), "B": twill((2, 2))})
    pick = np.arange(8)
    drawdown[2 * pick, 2 * (5 * pick % 8) + 1] = True
    return _draft("stitched double cloth", order, order, drawdown)


def pique() -> Draft:
    """A plain cloth, wadding behind it, and ends behind all that pull it down along waved lines."""
    ends, picks = "AAB" * 8, "AAAAC" * 8
    drawdown = stacked(ends, picks, {"A": plain(), "C": plain(), "B": plain()})
    stitching = np.arange(8)
    for first in (5 * np.abs(stitching - 4), 5 * ((np.abs(stitching - 4) + 4) % 8)):
        for pick in (first, first + 1):
            drawdown[pick, 3 * stitching + 2] = True
    return _draft("piqué", ends, picks, drawdown, colours={"A": "C", "B": "D", "C": "A"})


DRAFTS: tuple[Callable[[], Draft], ...] = (
    double_plain,
    tube,
    pocket,
    pattern_double_weave,
    four_layers,
    extra_weft_figure,
    matelasse,
    backed_twill,
    stitched_double_cloth,
    pique,
)


def _filled(structure: Structure, side: int) -> NDArray[np.bool_]:
    """A weave repeated to `side` ends and picks."""
    picks, ends = structure.shape
    return np.tile(structure, (-(-side // picks), -(-side // ends)))[:side, :side]


def stacked(
    ends: str,
    picks: str,
    weaves: Mapping[str, Structure],
    front: Callable[[str], NDArray[np.bool_]] | None = None,
) -> NDArray[np.bool_]:
    """Cloths upon one another, bool [picks, ends].

    Args:
        ends: the cloth of each end, a letter.
        picks: the cloth of each pick.
        weaves: of each cloth, bool [its picks, its ends], repeated; in their order from the front.
        front: where the cloth of a letter lies in front of the other, bool [picks, ends]; None: by order.
    """
    drawdown = np.empty((len(picks), len(ends)), dtype=bool)
    order = list(weaves)
    of_end, of_pick = np.array(list(ends)), np.array(list(picks))
    for one in order:
        columns = np.flatnonzero(of_end == one)
        for other in order:
            rows = np.flatnonzero(of_pick == other)
            part = np.ix_(rows, columns)
            if one == other:
                weave = weaves[one]
                own_pick, own_end = np.arange(len(rows)), np.arange(len(columns))
                drawdown[part] = weave[np.ix_(own_pick % weave.shape[0], own_end % weave.shape[1])]
            else:
                in_front = order.index(one) < order.index(other)
                drawdown[part] = in_front if front is None else front(one)[part]
    return drawdown


def _draft(
    title: str,
    ends: str,
    picks: str,
    drawdown: NDArray[np.bool_],
    colours: Mapping[str, str] | None = None,
) -> Draft:
    """The draft with a colour of `PALETTE` for each cloth: that of its letter, or of the one in `colours`."""
    palette = np.array([parse_colour(colour, "palette") for colour in PALETTE.values()])
    letters = list(PALETTE)

    def threads(names: str) -> Threads:
        index = np.array([letters.index((colours or {}).get(name, name)) for name in names], dtype=np.intp)
        return Threads(palette[index], np.full(len(names), SPACING_MM), None, index)

    return Draft(drawdown, threads(ends), threads(picks), title=title, palette=palette)


def main(folder: Path) -> None:
    """Writes a WIF file for each draft."""
    folder.mkdir(parents=True, exist_ok=True)
    for make in DRAFTS:
        write_wif(make(), folder / f"{make.__name__.replace('_', '-')}.wif")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
