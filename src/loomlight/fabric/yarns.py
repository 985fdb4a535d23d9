"""Kinds of yarn by name: what a fabric file need not say of a yarn of that fibre and spinning.

Densities of fibres and packing of yarns are from Morton and Hearle 2008, angles of twist those of usual twist
factors (Hearle, Grosberg and Backer 1969). Gloss, stray, slubs and hairs were set by eye.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from loomlight.fabric.file import YARNS, FabricFile, YarnTable
from loomlight.weave.textile import COTTON_DENSITY, DEFAULT_PACKING


@dataclass(frozen=True)
class Yarn:
    """A kind of yarn.

    Attributes:
        fields: of `[warp]` or `[weft]`, in the place of those that a file omits.
        density: of the fibre, g/cm³.
        packing: share of the cross-section that is fibre.
    """

    fields: YarnTable
    density: float
    packing: float


def _yarn(density: float, packing: float, **fields: float) -> Yarn:
    return Yarn(YarnTable.model_validate(fields), density, packing)


with Path(__file__).with_name("yarns.toml").open("rb") as _file:
    PRESETS = MappingProxyType({name: _yarn(**of_kind) for name, of_kind in tomllib.load(_file).items()})
# The names are in `file.py`, which checks them.
assert set(PRESETS) == set(YARNS)


def with_yarns(fields: FabricFile) -> FabricFile:
    """`fields` with what kinds of yarn say of the fields of `[warp]` and `[weft]` that the file omits."""
    tables = {name: _filled(getattr(fields, name), fields.yarn) for name in ("warp", "weft")}
    return fields.model_copy(update=tables)


def yarn_density(table: YarnTable) -> tuple[float, float]:
    """Density of the fibre, g/cm³, and packing of the yarn of `[warp]` or `[weft]`: cotton's by default."""
    if table.yarn is None:
        return COTTON_DENSITY, DEFAULT_PACKING
    return PRESETS[table.yarn].density, PRESETS[table.yarn].packing


def _filled(table: YarnTable, of_both: str | None) -> YarnTable:
    name = table.yarn or of_both
    if name is None:
        return table
    given = PRESETS[name].fields.model_dump(exclude_none=True) | table.model_dump(exclude_none=True)
    return YarnTable.model_validate(given | {"yarn": name})
