"""Spacing and width of the threads of a fabric, from the file or from the draft."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.fabric.yarns import kind_of
from loomlight.weave.draft import Threads
from loomlight.weave.textile import CM_PER_INCH, DEFAULT_SETT_PER_CM, yarn_diameter_mm

_MM_PER_CM = 10.0


def family_spacing(
    fields: FabricFile, name: str, threads: Threads, other: Threads, count: int
) -> NDArray[np.float64]:
    """Distance that each thread of family `name` ("warp" or "weft") takes up [count], millimetres.

    The file's threads/cm come first; the draft's spacing, where there is one, keeps its proportions
    and is scaled to them. Without either, the other family's density is used, so that the cloth is square.
    """
    density = threads_per_cm(fields, name)
    if threads.spacing_mm is not None:
        scale = 1.0 if density is None else _MM_PER_CM / density / float(threads.spacing_mm.mean())
        return threads.spacing_mm * scale
    if density is None:
        density = threads_per_cm(fields, "weft" if name == "warp" else "warp")
    if density is not None:
        return np.full(count, _MM_PER_CM / density)
    if other.spacing_mm is not None:
        return np.full(count, float(other.spacing_mm.mean()))
    return np.full(count, _MM_PER_CM / DEFAULT_SETT_PER_CM)


def threads_per_cm(fields: FabricFile, name: str) -> float | None:
    """Threads/cm that the file gives for a family, in centimetres or in inches; None without."""
    per_cm, per_inch = (
        (fields.ends_per_cm, fields.epi) if name == "warp" else (fields.picks_per_cm, fields.ppi)
    )
    return per_inch / CM_PER_INCH if per_inch is not None else per_cm


def family_width(
    fields: FabricFile, name: str, threads: Threads, spacing: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Width of each thread of family `name`, millimetres, as many as `spacing`.

    The family's own width or gap comes first, then its count, the draft's thickness, the file's gap, and the
    gap of its kind of yarn. A yarn of a count is at least as wide as it is when round; where its kind leaves
    a smaller gap it spreads towards that, by the kind's `spread` at most, as an ellipse of the same area.

    Raises:
        InputError: a yarn count that cannot be read.
    """
    table: YarnTable = getattr(fields, name)
    of_count = None if table.count is None else yarn_diameter(table, f"{name}.count")
    if table.width_mm is not None:
        return np.full_like(spacing, table.width_mm)
    if table.gap is not None:
        return spacing * (1 - table.gap)
    if of_count is not None:
        kind = kind_of(table)
        return np.clip((1 - kind.gap) * spacing, of_count, of_count * kind.spread)
    if threads.thickness_mm is not None:
        return threads.thickness_mm
    return spacing * (1 - (kind_of(table).gap if fields.gap is None else fields.gap))


def yarn_diameter(table: YarnTable, field: str) -> float:
    """Diameter of a round yarn of the table's count and kind, millimetres.

    Raises:
        InputError: a yarn count that cannot be read; the message names `field`.
    """
    kind = kind_of(table)
    try:
        return yarn_diameter_mm(str(table.count), density=kind.density, packing=kind.packing)
    except InputError as error:
        raise InputError(f"{field}: {error}") from error
