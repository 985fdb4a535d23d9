"""Which grid of threads a photograph shows: the one on whose crossings a weave shows most clearly.

On threads where there are none crossings mix several, and no weave explains them: in our renders the
likeliest weave of the true grid has up to five times the evidence of that of a false one. Small weaves are
enough to tell, as large ones are made of them.
"""

from __future__ import annotations

from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.photo import Photo
from loomlight.capturing.thread_grid import ThreadGrid, find_grids
from loomlight.capturing.weave_choice import Seen
from loomlight.capturing.weave_match import Structure, WeaveFit, fit_structure, fit_weaves

# Crossings of the repeat of a weave that is tried at most.
_SMALL = 64
# Evidence of the grid that repeats most surely below which its crossings are all alike, as loops of a knit:
# their halves would pass for crossings. Of woven cloth even a false grid shows twice as much.
_ALIKE = 0.03


def likeliest_grid(photo: Photo, given: tuple[str, Structure] | None = None) -> tuple[Seen, WeaveFit]:
    """A photograph with the threads whose crossings show most of a weave, and the likeliest small weave.

    Args:
        given: name and structure of the weave, where it is known.

    Raises:
        InputError: no period, or threads that are too fine or too few.
    """
    grids = find_grids(photo.encoded)
    first = _on_grid(photo, grids[0], given)
    if _evidence(first) < _ALIKE:
        return first
    return max([first, *(_on_grid(photo, grid, given) for grid in grids[1:])], key=_evidence)


def _evidence(found: tuple[Seen, WeaveFit]) -> float:
    """What a crossing shows of the weave, a logarithm of a likelihood."""
    return found[1].score / found[0].crossings.votes


def _on_grid(photo: Photo, grid: ThreadGrid, given: tuple[str, Structure] | None) -> tuple[Seen, WeaveFit]:
    crossings = find_crossings(photo.encoded, grid)
    return Seen(photo, grid, crossings), _likeliest(crossings, given)


def _likeliest(crossings: Crossings, given: tuple[str, Structure] | None) -> WeaveFit:
    return fit_weaves([crossings], _SMALL)[0] if given is None else fit_structure(*given, [crossings])
