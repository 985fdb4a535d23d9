"""The fields of a fabric file with their types and ranges. Fields that a file omits are None.

Defaults that depend on the weave or on the draft are chosen later (`defaults.py`, `spacing.py`), so that
a file that is read and written again says no more than it did.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema
from pydantic_core import PydanticCustomError

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.core.spectra import is_spectrum
from loomlight.weave.artwork import MAX_COLOURS
from loomlight.weave.bitmaps import MAX_WEFTS, parse_order
from loomlight.weave.draft import MAXIMUM_THREADS

# Stands in a message for the field's name, which only the translation into a sentence knows.
FIELD = "⟦field⟧"


def _colour(value: object) -> object:
    if is_spectrum(value):
        return value
    try:
        parse_colour(value, FIELD)
    except InputError as error:
        raise PydanticCustomError("sentence", "{text}", {"text": str(error)}) from error
    return value


def _colours(value: object) -> object:
    if value == []:
        text = f'{FIELD} = [] holds no colour: write "#rrggbb", a linear RGB triple, or a list of these.'
        raise PydanticCustomError("sentence", "{text}", {"text": text})
    try:
        listed = colours_in_order(value, FIELD)
    except InputError as error:
        raise PydanticCustomError("sentence", "{text}", {"text": str(error)}) from error
    for colour in listed:
        _colour(colour)
    return value


# Kinds of yarn; `yarns.py` says what they are.
YARNS = (
    "cotton",
    "combed cotton",
    "open-end cotton",
    "mercerised cotton",
    "linen",
    "wool",
    "woollen",
    "worsted",
    "silk",
    "dupion silk",
    "filament polyester",
    "viscose",
)


def _yarn(value: str) -> str:
    name = " ".join(value.lower().split())
    if name not in YARNS:
        known = ", ".join(f'"{yarn}"' for yarn in YARNS)
        text = (
            f'{FIELD} = "{" ".join(value.split())[:40]}" is no kind of yarn that has a name: write {known}.'
        )
        raise PydanticCustomError("sentence", "{text}", {"text": text})
    return name


Colour = Annotated[Any, AfterValidator(_colour), WithJsonSchema({"type": "colour"})]
Colours = Annotated[Any, AfterValidator(_colours), WithJsonSchema({"type": "colours"})]
YarnName = Annotated[str, AfterValidator(_yarn), WithJsonSchema({"type": "yarn"})]
Fraction = Annotated[float, Field(ge=0, le=1)]
Gap = Annotated[float, Field(ge=0, le=0.95)]
PerMetre = Annotated[float, Field(ge=0, le=200)]


class Table(BaseModel):
    """A table of the file: unknown keys, NaN and values of another type are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class YarnTable(Table):
    """[warp] or [weft]."""

    yarn: YarnName | None = None
    color: Colours | None = None
    albedo: Colours | None = None
    specular: Fraction | None = None
    specular_tint: Colour | None = None
    specular_grazing: Annotated[float, Field(ge=0, le=4)] | None = None
    translucency: Fraction | None = None
    roughness: Annotated[float, Field(ge=0.01, le=1)] | None = None
    height_scale: Annotated[float, Field(ge=0.01, le=2)] | None = None
    inclination_deg: Annotated[float, Field(ge=0, le=80)] | None = None
    twist_deg: Annotated[float, Field(ge=-89, le=89)] | None = None
    plies: Annotated[int, Field(ge=1, le=12)] | None = None
    ply_twist_deg: Annotated[float, Field(ge=-60, le=60)] | None = None
    fibre_tilt_deg: Annotated[float, Field(ge=0, le=30)] | None = None
    slub: Fraction | None = None
    hairiness: Fraction | None = None
    mass_cv: Annotated[float, Field(ge=0, le=0.6)] | None = None
    fibre_length_mm: Annotated[float, Field(ge=5, le=2000)] | None = None
    thick_places: PerMetre | None = None
    thick_length_mm: Annotated[float, Field(ge=2, le=1000)] | None = None
    thick_size: Annotated[float, Field(ge=0, le=5)] | None = None
    shade: Fraction | None = None
    melange: Fraction | None = None
    neps: PerMetre | None = None
    nep_length_mm: Annotated[float, Field(ge=1, le=30)] | None = None
    nep_color: Colour | None = None
    gap: Gap | None = None
    count: Annotated[str, Field(min_length=1)] | None = None
    width_mm: Annotated[float, Field(ge=0.001, le=1000)] | None = None
    diffuse_reflect: Colour | None = None
    diffuse_transmit: Colour | None = None
    specular_reflect: Colour | None = None
    specular_transmit: Colour | None = None


class SheenTable(Table):
    """[sheen]."""

    strength: Fraction | None = None
    roughness: Fraction | None = None


class VariationTable(Table):
    """[variation]."""

    fibre_noise: Fraction | None = None
    colour_noise: Fraction | None = None
    irregularity: Annotated[float, Field(ge=0, le=2)] | None = None
    seed: Annotated[int, Field(ge=0, le=2**32 - 1)] | None = None


# How a map changes what the fabric has, and the sides from which one may be thrown onto a garment.
MAP_MODES = ("multiply", "replace")
MAP_SIDES = ("front", "back", "left", "right", "above", "below")


def _one_of(choices: tuple[str, ...]) -> AfterValidator:
    def require(value: str) -> str:
        if value not in choices:
            text = f'{FIELD} = "{value[:40]}" does not exist: write {" or ".join(choices)}.'
            raise PydanticCustomError("sentence", "{text}", {"text": text})
        return value

    return AfterValidator(require)


class MapTable(Table):
    """One of [maps]: a picture over the surface that changes one parameter; see `surface_maps.py`."""

    picture: Annotated[str, Field(min_length=1)]
    mode: Annotated[str, _one_of(MAP_MODES)] | None = None
    low: Annotated[float, Field(ge=-1000, le=1000)] | None = None
    high: Annotated[float, Field(ge=-1000, le=1000)] | None = None
    fabrics: list[Annotated[str, Field(min_length=1)]] | None = None
    uv: Annotated[str, Field(min_length=1)] | None = None
    side: Annotated[str, _one_of(MAP_SIDES)] | None = None
    width_mm: Annotated[float, Field(ge=0.1, le=100_000)] | None = None
    at_mm: Annotated[list[float], Field(min_length=2, max_length=2)] | None = None
    repeat: bool | None = None


def _maps_by_name(value: object) -> object:
    """Maps by dotted name: `[maps.warp] roughness = "a.png"` is `warp.roughness`, a path alone a picture."""
    if not isinstance(value, dict):
        return value
    found: dict[str, object] = {}
    for name, each in value.items():
        if isinstance(each, str):
            found[name] = {"picture": each}
        elif isinstance(each, dict) and not each.keys() & MapTable.model_fields.keys():
            inner = _maps_by_name(each)
            assert isinstance(inner, dict)
            found |= {f"{name}.{field}": table for field, table in inner.items()}
        else:
            found[name] = each
    return found


Maps = Annotated[dict[str, MapTable], BeforeValidator(_maps_by_name), WithJsonSchema({"type": "maps"})]
# Of [weaves], for a weft that lies free on the back of the cloth.
BACK_WEAVE = "back"
_HEX_COLOUR = re.compile(r"#(?:[0-9a-f]{3}|[0-9a-f]{6})")


def plain_hex(colour: str) -> str:
    """The colour "#rrggbb" in small letters of one that is written with three digits or in capitals."""
    text = colour.strip().lower()
    return "#" + "".join(2 * digit for digit in text[1:]) if len(text) == 4 else text


def _weaves(value: object) -> object:
    """Weaves by colour, each a text or a list of as many texts as there are wefts."""

    def fault(text: str) -> PydanticCustomError:
        return PydanticCustomError("sentence", "{text}", {"text": text})

    if not isinstance(value, dict):
        raise fault(f'{FIELD} is no table: write a weave a colour, "#c00000" = "satin 8/3".')
    if len(value) > MAX_COLOURS:
        raise fault(f"{FIELD} has {len(value)} colours; an artwork has at most {MAX_COLOURS}.")
    wefts: dict[str, int] = {}
    for colour, given in value.items():
        name = f'{FIELD}."{str(colour)[:40]}"'
        if not isinstance(colour, str) or _HEX_COLOUR.fullmatch(colour.strip().lower()) is None:
            raise fault(f'{name} is no colour of a picture: write it as "#c00000".')
        if plain_hex(colour) in wefts:
            raise fault(f"{name} is there twice: keep one of them.")
        listed = given if isinstance(given, list) else [given]
        if not 1 <= len(listed) <= MAX_WEFTS:
            raise fault(
                f"{name} lists {len(listed)} weaves, one a weft; 1 to {MAX_WEFTS} wefts can be woven."
            )
        if not all(isinstance(weave, str) and weave.strip() for weave in listed):
            raise fault(f'{name} names no weave: write one in quotes, "satin 8/3", or a list of one a weft.')
        first = next(iter(wefts.items()), (plain_hex(colour), len(listed)))
        if len(listed) != first[1]:
            raise fault(
                f'{name} has {len(listed)} weaves and "{first[0]}" {first[1]}: each colour has one a weft.'
            )
        wefts[plain_hex(colour)] = len(listed)
    return value


def _weft_order(value: str) -> str:
    try:
        parse_order(value, FIELD)
    except InputError as error:
        raise PydanticCustomError("sentence", "{text}", {"text": str(error)}) from error
    return value


Weaves = Annotated[dict[str, str | list[str]], BeforeValidator(_weaves), WithJsonSchema({"type": "weaves"})]


class ArtworkTable(Table):
    """[artwork]: how an image is woven whose colours are [weaves]."""

    longest_float: Annotated[int, Field(ge=2, le=MAXIMUM_THREADS)] | None = None
    order: Annotated[str, Field(min_length=1), AfterValidator(_weft_order)] | None = None
    regulator: Annotated[int, Field(ge=2, le=MAX_WEFTS)] | None = None
    nearest: bool | None = None


Density = Annotated[float, Field(ge=0.1, le=1000)]
DensityPerInch = Annotated[float, Field(ge=0.254, le=2540)]


class FabricFile(Table):
    """A whole fabric file."""

    name: str | None = None
    description: str | None = None
    weave: Annotated[str, Field(min_length=1)] | None = None
    draft: Annotated[str, Field(min_length=1)] | None = None
    image: Annotated[str, Field(min_length=1)] | None = None
    ends_per_cm: Density | None = None
    picks_per_cm: Density | None = None
    epi: DensityPerInch | None = None
    ppi: DensityPerInch | None = None
    gap: Gap | None = None
    yarn: YarnName | None = None
    wear: Fraction | None = None
    diffuse_blend: Fraction | None = None
    optical_depth: Annotated[float, Field(ge=0.01, le=100)] | None = None
    interreflection: bool | None = None
    warp: YarnTable = YarnTable()
    weft: YarnTable = YarnTable()
    sheen: SheenTable = SheenTable()
    variation: VariationTable = VariationTable()
    maps: Maps = Field(default_factory=dict)
    weaves: Weaves = Field(default_factory=dict)
    artwork: ArtworkTable = ArtworkTable()


@cache
def field_schemas(table: type[Table]) -> dict[str, dict[str, Any]]:
    """JSON schemas of a table's fields by their names, in the order of the file.

    "type" may be "colour", "colours", "yarn", "maps" or "weaves" too; numbers have "minimum" and "maximum",
    texts that may not be empty "minLength"; a table has "$ref", which ends in the name of its class.
    """
    properties = table.model_json_schema()["properties"]
    return {name: schema.get("anyOf", [schema])[0] for name, schema in properties.items()}


def yarn_range(field: str) -> tuple[float, float]:
    """Range of a number of `[warp]` and `[weft]`, in the unit of the file."""
    schema = field_schemas(YarnTable)[field]
    return float(schema["minimum"]), float(schema["maximum"])


# ------------------------------------------------------------------------------------ colours in thread order
# A colour, a list of colours, or runs such as "20 #223355, 20 #eeeeee".


# Commas outside of brackets: lab(52, -10, 30) is one colour.
_COMMA = re.compile(r",(?![^(]*\))")
_RUN = re.compile(r"(?:([0-9]{1,9}) *[x×]? *)?(#[0-9a-fA-F]+|lab\([^)]*\))", re.IGNORECASE)


def is_one_colour(value: object) -> bool:
    """Whether `value` is written as one colour, not as a list of colours or as runs of threads."""
    if isinstance(value, str):
        return _runs(value) is None
    if not isinstance(value, list):
        return True
    return len(value) > 0 and all(isinstance(part, int | float) for part in value)


def colours_in_order(value: Any, field: str) -> list[Any]:
    """The colours of threads, one after the other, as `color` and `albedo` of a fabric file write them.

    Args:
        value: a colour; a list of colours and of runs; or runs with commas between them, each a number of
            threads and a colour.

    Raises:
        InputError: a run of no threads, or more threads than a repeat may have; the message names `field`.
    """
    parts = value if isinstance(value, list) and not is_one_colour(value) else [value]
    found: list[Any] = []
    for part in parts:
        runs = _runs(part) if isinstance(part, str) else None
        for count, colour in [(1, part)] if runs is None else runs:
            if count < 1:
                raise InputError(f'{field} = "{part}" holds a run of 0 threads: write 1 or more.')
            if len(found) + count > MAXIMUM_THREADS:
                raise InputError(
                    f"{field} has more than {MAXIMUM_THREADS} threads, which no repeat may have."
                )
            found.extend([colour] * count)
    return found


def _runs(text: str) -> list[tuple[int, str]] | None:
    """Threads and colour of every run; None of a text that is one colour, or no colour at all."""
    matches = [_RUN.fullmatch(part.strip()) for part in _COMMA.split(text)]
    runs = [(int(match[1] or 1), match[2]) for match in matches if match is not None]
    is_list = len(matches) > 1 or any(match is not None and match[1] for match in matches)
    return runs if is_list and len(runs) == len(matches) else None
