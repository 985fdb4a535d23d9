"""What maps over a surface may change: the names of `[maps]`, and which fields go together."""

from __future__ import annotations

from loomlight.core.errors import InputError
from loomlight.core.sentences import closest
from loomlight.fabric.fields import (
    FabricFile,
    SheenTable,
    Table,
    VariationTable,
    YarnTable,
    field_schemas,
)

FAMILIES = ("warp", "weft")
# Maps of colours: of both families, or of one.
COLOURS = ("color", "warp.color", "weft.color")
FABRIC = "fabric"
_TOP = ("wear", "diffuse_blend")
_TABLES: dict[str, type[Table]] = {
    "warp": YarnTable,
    "weft": YarnTable,
    "sheen": SheenTable,
    "variation": VariationTable,
}


def require_maps(fields: FabricFile) -> None:
    """Raises InputError for a map of what no map can change, and for fields that do not go together."""
    for name, table in fields.maps.items():
        fields_of(name)
        where = f"maps.{name}"
        if name != FABRIC and table.fabrics is not None:
            raise InputError(f"{where}.fabrics goes with the map fabric alone, which chooses among them.")
        if name == FABRIC and not table.fabrics:
            raise InputError(f'{where} chooses among fabrics: write fabrics = ["FILE.toml"] for white.')
        if name in (*COLOURS, FABRIC):
            for field in ("low", "high"):
                if getattr(table, field) is not None:
                    raise InputError(f"{where}.{field} goes with maps of numbers: leave it out.")
        if name == FABRIC and table.mode is not None:
            raise InputError(f"{where}.mode goes with colours and numbers: leave it out.")
        if table.at_mm is not None and table.side is None and table.width_mm is None:
            raise InputError(f"{where}.at_mm places a picture of some width: write width_mm too.")
        given = [field for field in ("uv", "side", "width_mm") if getattr(table, field) is not None]
        if table.uv is not None and len(given) > 1:
            raise InputError(f"{where}.uv and {where}.{given[1]} both say where the picture lies: keep one.")


def fields_of(name: str) -> list[str]:
    """Dotted names of the fabric's fields that the map `name` changes; none of the map of fabrics.

    Raises:
        InputError: no map can change that.
    """
    if name == FABRIC:
        return []
    if name == "color" or name in _numbers(YarnTable):
        return [f"{family}.{name}" for family in FAMILIES]
    if name in _TOP or name in COLOURS:
        return [name]
    table, _, field = name.partition(".")
    if table in _TABLES and field in _numbers(_TABLES[table]):
        return [name]
    known = [*COLOURS, FABRIC, *_TOP, *_numbers(YarnTable)]
    known += [f"{key}.{each}" for key, fields in _TABLES.items() for each in _numbers(fields)]
    raise InputError(f"maps.{name} is nothing that a picture can change: {closest(name, known)}")


def _numbers(table: type[Table]) -> list[str]:
    return [name for name, schema in field_schemas(table).items() if schema.get("type") == "number"]


def range_of(field: str) -> tuple[float, float]:
    """Range of a number by its dotted name, in the unit of the file."""
    table, _, name = field.rpartition(".")
    schema = field_schemas(_TABLES[table] if table else FabricFile)[name]
    return float(schema["minimum"]), float(schema["maximum"])
