"""Checks of fabric files and drafts: what no cloth can be, and what is rather a slip than a wish."""

from __future__ import annotations

import warnings

import numpy as np

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.weave.draft import Draft
from loomlight.weave.textile import unbound_threads
from loomlight.yarn.layout import MIN_GAP, ClothLayout

# Yarns of a count are flattened in dense cloth; their nominal diameter may exceed the spacing by this factor.
_FLATTENED = 2.0


def require_interlacing(draft: Draft) -> None:
    """Raises InputError if no thread interlaces: one family is on top at every crossing."""
    if draft.drawdown.all() or not draft.drawdown.any():
        on_top = "warp" if draft.drawdown.all() else "weft"
        raise InputError(
            f"none of its {draft.ends} ends and {draft.picks} picks interlaces: the {on_top} is on top at "
            "every crossing, so nothing holds the cloth together; see which shafts each pick lifts."
        )


def warn_of_slips(fields: FabricFile, draft: Draft, layout: ClothLayout, source: str) -> None:
    """Warns, in a sentence each, of a family that never interlaces and of yarns wider than their spacing.

    Both are used: threads that never interlace lie straight, and widths are cut to 99.5 % of the spacing.

    Args:
        source: the file, which sentences begin with; "" for none.
    """
    beginning = f"{source}: " if source else ""
    for sentence in (*_loose(draft), *_wide(fields, layout)):
        warnings.warn(f"{beginning}{sentence}", LoomlightWarning, stacklevel=2)


def _loose(draft: Draft) -> list[str]:
    """Single loose threads are common in drafts, for a brocade or where the loom has one thread more."""
    ends, picks = unbound_threads(draft)
    return [
        f"none of its {count} {name} interlaces: they lie straight, above some {others} and below others."
        for loose, count, name, others in (
            (ends, draft.ends, "ends", "picks"),
            (picks, draft.picks, "picks", "ends"),
        )
        if len(loose) == count
    ]


def _wide(fields: FabricFile, layout: ClothLayout) -> list[str]:
    sentences = []
    for name, family in (("warp", layout.warp), ("weft", layout.weft)):
        table: YarnTable = getattr(fields, name)
        spacing = float(np.max(family.spacing))
        width = float(np.max(family.width))
        if table.width_mm is not None and table.width_mm > spacing:
            given = f"width_mm = {table.width_mm:g}"
        elif table.count is not None and width > _FLATTENED * spacing:
            given = f'count = "{table.count}", a yarn of {width:.3g} mm,'
        else:
            continue
        sentences.append(
            f"{name}.{given} is wider than a thread's spacing of {spacing:.3g} mm: "
            f"{(1 - MIN_GAP) * spacing:.3g} mm of it are shown."
        )
    return sentences
