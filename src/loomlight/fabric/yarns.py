"""Kinds of yarn by name: what a fabric file need not say of a yarn of that fibre and spinning.

Densities of fibres and packing of yarns are from Morton and Hearle 2008, angles of twist those of usual twist
factors (Hearle, Grosberg and Backer 1969). Gloss, stray, slubs, hairs, gaps and spreads were set by eye.

`mass_cv` is about the middle of what the trade takes for usual, not checked against Uster's statistics, per
cent of the mass of 8 mm: carded ring-spun cotton 14 to 16, combed 11 to 13, open-end 13 to 15, viscose 11 to
13, worsted 13 to 17, woollen 18 to 25, wet-spun linen 20 to 28; of two plies it is a root of two less.
Filament has 1 to 3; that of dupion, its thick places where double cocoons tangle, and shades were set by eye.
Lengths of fibres are those of the trade (Morton and Hearle 2008); of flax it is that of bundles, as ultimates
of 25 mm lie in them end to end.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from loomlight.fabric.fields import YARNS, FabricFile, YarnTable
from loomlight.weave.textile import COTTON_DENSITY, DEFAULT_PACKING


@dataclass(frozen=True)
class Yarn:
    """A kind of yarn.

    Attributes:
        fields: of `[warp]` or `[weft]`, in the place of those that a file omits.
        density: of the fibre, g/cm³.
        packing: share of the cross-section that is fibre.
        gap: share of a thread's spacing that the yarn leaves open in cloth.
        spread: its largest width in cloth over its round diameter, at least 1.
    """

    fields: YarnTable
    density: float
    packing: float
    gap: float
    spread: float


def _yarn(density: float, packing: float, gap: float, spread: float, **fields: float) -> Yarn:
    return Yarn(YarnTable.model_validate(fields), density, packing, gap, spread)


with Path(__file__).with_name("yarns.toml").open("rb") as _file:
    PRESETS = MappingProxyType({name: _yarn(**of_kind) for name, of_kind in tomllib.load(_file).items()})
# The names are in `fields.py`, which checks them.
assert set(PRESETS) == set(YARNS)
# Share of a thread's spacing that a yarn without a name leaves open.
GAP = 0.2
# Of a table that names none: round, of cotton's weight.
_ANY = Yarn(YarnTable(), COTTON_DENSITY, DEFAULT_PACKING, GAP, 1.0)


def with_yarns(fields: FabricFile) -> FabricFile:
    """`fields` with what kinds of yarn say of the fields of `[warp]` and `[weft]` that the file omits."""
    tables = {name: _filled(getattr(fields, name), fields.yarn) for name in ("warp", "weft")}
    return fields.model_copy(update=tables)


def kind_of(table: YarnTable) -> Yarn:
    """Kind of yarn of `[warp]` or `[weft]`; without a name a round one of cotton's density and packing."""
    return _ANY if table.yarn is None else PRESETS[table.yarn]


def _filled(table: YarnTable, of_both: str | None) -> YarnTable:
    name = table.yarn or of_both
    if name is None:
        return table
    given = PRESETS[name].fields.model_dump(exclude_none=True) | table.model_dump(exclude_none=True)
    return YarnTable.model_validate(given | {"yarn": name})
