"""Kinds of yarn by name: what a fabric file need not say of a yarn of that fibre and spinning.

Densities of fibres and packing of yarns are from Morton and Hearle 2008, angles of twist those of usual twist
factors (Hearle, Grosberg and Backer 1969). Gloss, stray, slubs and hairs were set by eye.
"""

from __future__ import annotations

from dataclasses import dataclass
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


PRESETS = MappingProxyType(
    {
        "cotton": _yarn(
            COTTON_DENSITY,
            DEFAULT_PACKING,
            specular=0.2,
            roughness=0.42,
            translucency=0.12,
            twist_deg=-20,
            fibre_tilt_deg=11,
            hairiness=0.4,
            slub=0.25,
        ),
        "mercerised cotton": _yarn(
            COTTON_DENSITY,
            0.65,
            specular=0.45,
            roughness=0.24,
            translucency=0.1,
            twist_deg=-4,
            plies=2,
            ply_twist_deg=26,
            fibre_tilt_deg=5,
            hairiness=0.06,
            slub=0.05,
        ),
        "linen": _yarn(
            1.50,
            0.65,
            specular=0.4,
            roughness=0.3,
            translucency=0.18,
            twist_deg=-14,
            fibre_tilt_deg=9,
            hairiness=0.12,
            slub=0.9,
        ),
        "wool": _yarn(
            1.31,
            0.45,
            specular=0.15,
            roughness=0.6,
            translucency=0.1,
            twist_deg=-6,
            plies=2,
            ply_twist_deg=24,
            fibre_tilt_deg=12,
            hairiness=1,
            slub=0.2,
        ),
        "silk": _yarn(
            1.34,
            0.7,
            specular=0.9,
            roughness=0.1,
            translucency=0.1,
            twist_deg=-3,
            fibre_tilt_deg=2.5,
        ),
        "filament polyester": _yarn(
            1.38,
            0.7,
            specular=0.8,
            roughness=0.14,
            translucency=0.08,
            twist_deg=0,
            fibre_tilt_deg=1.5,
        ),
        "viscose": _yarn(
            1.51,
            0.6,
            specular=0.6,
            roughness=0.22,
            translucency=0.12,
            twist_deg=-14,
            fibre_tilt_deg=6,
            hairiness=0.12,
            slub=0.08,
        ),
    }
)
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
