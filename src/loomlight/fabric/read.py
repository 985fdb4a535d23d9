"""Fabrics from files and from text: the two ways in.

Below, in the order of reading: the text into valid fields, sentences about faults, colours that files of
spectrophotometers name, and what is rather a slip than a wish.
"""

from __future__ import annotations

import os
import tomllib
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

import numpy as np
from annotated_types import Ge, Le
from numpy.typing import NDArray
from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import read_text, require_file
from loomlight.core.sentences import closest, one_line, shown, speaking_of
from loomlight.core.spectra import is_spectrum, read_spectrum
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import (
    BACK_WEAVE,
    FIELD,
    ArtworkTable,
    FabricFile,
    MapTable,
    YarnTable,
    is_one_colour,
    plain_hex,
)
from loomlight.fabric.map_fields import require_maps
from loomlight.fabric.resolve import threads_per_cm
from loomlight.scattering.albedo import Albedos
from loomlight.weave.artwork import BACK, Artwork, colour_index, weave_artwork
from loomlight.weave.bitmaps import parse_order
from loomlight.weave.draft import Draft
from loomlight.weave.load import DRAFT_SUFFIXES, load_draft
from loomlight.weave.named import named_weave
from loomlight.weave.textile import DEFAULT_SETT_PER_CM, unbound_threads
from loomlight.yarn.layout import MIN_GAP, ClothLayout

FABRIC_SUFFIX = ".toml"
# A fabric has one of these, so a new one replaces what there was; the same holds for a density's two units.
_DRAFTS = ("weave", "draft", "image")
# What says how an image is woven, which goes with it.
_ARTWORK = ("weaves", "artwork")
_SAME_DENSITY = {"ends_per_cm": "epi", "epi": "ends_per_cm", "picks_per_cm": "ppi", "ppi": "picks_per_cm"}


def load_fabric(path: str | os.PathLike[str]) -> Fabric:
    """The fabric of a fabric file (.toml), of a draft (.wif, a picture of a drawdown), or of a weave's name.

    A draft alone is a fabric in its own colours and spacing. What has no suffix and is no file is read as
    the name of a weave, such as "twill 3/1".

    Raises:
        InputError: no such file, no fabric, or values that cannot be; the message names file and field.

    Warns:
        LoomlightWarning: a family of threads that never interlaces, or yarns wider than their spacing.
    """
    file = Path(path)
    suffix = file.suffix.lower()
    folder = str(file.parent)
    if suffix in DRAFT_SUFFIXES:
        return _made(_only(draft=file.name), folder, file.stem, str(file))
    if suffix == FABRIC_SUFFIX:
        text = read_text(file)
        with speaking_of(str(file)):
            fields = parse_fabric_file(text)
        return _made(fields, folder, file.stem, str(file))
    if suffix or _exists(file) or file.is_absolute():
        shown = one_line(str(file)) if str(path) else '""'
        raise InputError(f"{shown} is no fabric: give a fabric file (.toml), a draft (.wif, .png), a weave.")
    return fabric_from_text(str(path))


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def fabric_from_text(text: str, folder: str | os.PathLike[str] = ".") -> Fabric:
    """The fabric of a weave's name ("twill 3/1") or of the text of a fabric file.

    Args:
        text: a name, or TOML; what holds an equals sign is TOML.
        folder: the folder that paths in the TOML are relative to.

    Raises:
        InputError: an unknown weave, or a text that is no fabric file.
    """
    if "=" not in text and text.strip():
        return _made(_only(weave=text.strip()), os.fspath(folder), text.strip(), "")
    with speaking_of("the fabric"):
        fields = parse_fabric_file(text)
    return _made(fields, os.fspath(folder), "fabric", "the fabric")


def fabric_from_fields(fields: Mapping[str, Any], folder: str | os.PathLike[str] = ".") -> Fabric:
    """The fabric of fields by their dotted names: "weave", "warp.roughness", "sheen.strength".

    Args:
        folder: the folder that paths among the fields are relative to.

    Raises:
        InputError: an unknown field, or values that make no fabric; the message names the field.
    """
    with speaking_of("the fabric"):
        valid = validate_fields(_merged({}, fields))
    return _made(valid, os.fspath(folder), "fabric", "the fabric")


def edited_fabric(fabric: Fabric, fields: Mapping[str, Any]) -> Fabric:
    """The fabric with other values of some fields, by their dotted names; see `fabric_from_fields`.

    No draft is read again unless another weave, draft, image or artwork is among the fields.

    Raises:
        InputError: an unknown field, or values that contradict the draft; the message names the field.
    """
    with speaking_of("the fabric"):
        valid = validate_fields(_merged(fabric.fields.model_dump(exclude_none=True), fields))
        if any(name.partition(".")[0] in (*_DRAFTS, *_ARTWORK) for name in fields):
            return _made(valid, fabric.folder, "fabric", "the fabric")
        valid = with_measured_colours(valid, fabric.folder)
        return make_fabric(valid, fabric.named_draft, valid.name or fabric.name, fabric.folder)


def _merged(values: Mapping[str, Any], fields: Mapping[str, Any]) -> dict[str, Any]:
    """Values of a fabric file, tables as dictionaries, with fields by dotted name put in."""
    merged = dict(values)
    if any(name in fields for name in _DRAFTS):
        merged = {name: value for name, value in merged.items() if name not in (*_DRAFTS, *_ARTWORK)}
    for name, value in fields.items():
        merged.pop(_SAME_DENSITY.get(name, ""), None)
        table, _, field = name.rpartition(".")
        if table:
            merged[table] = {**merged.get(table, {}), field: value}
        else:
            merged[name] = value
    return merged


def _only(**field: str) -> FabricFile:
    """A fabric file of one field, which a user gave without writing one."""
    try:
        return FabricFile.model_validate(field)
    except ValidationError as error:  # a name from the system that is no UTF-8
        raise InputError(f"{one_line(next(iter(field.values())))}: {sentence_of(error)}") from error


def _made(fields: FabricFile, folder: str, fallback_name: str, source: str) -> Fabric:
    with speaking_of(source):
        fields = with_measured_colours(fields, folder)
        draft = _draft_of(fields, folder)
        require_interlacing(draft)
        name = fields.name or draft.title or fields.weave or fallback_name
        fabric = make_fabric(fields, draft, name, folder)
    warn_of_slips(fields, draft, fabric.layout(), source)
    return fabric


def _draft_of(fields: FabricFile, folder: str) -> Draft:
    """The draft of a fabric file's `weave`, `draft` or `image`; paths are relative to `folder`.

    Raises:
        InputError: an unknown weave, or a file that is no draft.
    """
    if fields.weave is not None:
        return named_weave(fields.weave)
    name = "draft" if fields.draft is not None else "image"
    path = _file_of(str(getattr(fields, name)), folder, name)
    return (
        weave_artwork(path, _artwork_of(fields, folder), _rows_per_cm(fields))
        if fields.weaves
        else load_draft(path)
    )


def _file_of(given: str, folder: str, name: str) -> Path:
    """The file that a field names, relative to `folder`.

    Raises:
        InputError: no such file; the message names the field.
    """
    path = Path(folder) / given
    try:
        require_file(path)
    except InputError as error:
        raise InputError(f'{name} = "{given[:80]}" names no draft: {error}') from error
    return path


def _rows_per_cm(fields: FabricFile) -> float:
    """Rows of an artwork per centimetre: the picks that take up cloth, square where the file does not say."""
    return threads_per_cm(fields, "weft") or threads_per_cm(fields, "warp") or DEFAULT_SETT_PER_CM


def _artwork_of(fields: FabricFile, folder: str) -> Artwork:
    """The structures that `weaves` names: a weave, a draft's file, or "back".

    Raises:
        InputError: one that is none of these; the message names its colour.
    """
    table = fields.artwork
    names = {
        plain_hex(colour): [given] if isinstance(given, str) else given
        for colour, given in fields.weaves.items()
    }
    structures = {
        name: _structure(name, folder, colour) for colour, listed in names.items() for name in listed
    }
    return Artwork(
        weaves={colour: [structures[name] for name in listed] for colour, listed in names.items()},
        names=names,
        order=parse_order(table.order) if table.order is not None else (),
        extra_from=table.regulator,
        longest_float=table.longest_float,
        nearest=table.nearest or False,
    )


@dataclass(frozen=True)
class ArtworkPicture:
    """The picture of a fabric whose colours are weaves.

    Attributes:
        colours: "#rrggbb" in small letters.
        index: which of them each pixel has, uint8 [rows, ends], the bottom row first.
        drafts: the drawdowns of drafts' files among the weaves, bool [picks, ends], by their names.
    """

    colours: Sequence[str]
    index: NDArray[np.uint8]
    drafts: Mapping[str, NDArray[np.bool_]]


def picture_of_artwork(fields: FabricFile, folder: str) -> ArtworkPicture:
    """The picture that a fabric file with `weaves` names, read from `folder`.

    Raises:
        InputError: it is not there, or no more what the file says.
    """
    artwork = _artwork_of(fields, folder)
    path = _file_of(str(fields.image), folder, "image")
    colours = list(artwork.weaves)
    drafts = {
        name: structure
        for colour, names in artwork.names.items()
        for name, structure in zip(names, artwork.weaves[colour], strict=True)
        if structure is not None and _is_draft(name)
    }
    return ArtworkPicture(colours, colour_index(path, colours, artwork.nearest), drafts)


def _is_draft(name: str) -> bool:
    return Path(name).suffix.lower() in DRAFT_SUFFIXES


def _structure(name: str, folder: str, colour: str) -> NDArray[np.bool_] | None:
    """The drawdown of one of `weaves`; None of a weft on the back."""
    if name.strip().lower() == BACK_WEAVE:
        return BACK
    if _is_draft(name):
        return load_draft(_file_of(name, folder, f'weaves."{colour}"')).drawdown
    with speaking_of(f'weaves."{colour}"'):
        return named_weave(name).drawdown


# ------------------------------------------------------------------------------------------- text into fields


def parse_fabric_file(text: str) -> FabricFile:
    """The fields of a fabric file's text, each valid by itself and all of them together.

    Raises:
        InputError: no TOML, an unknown field, a value of another type or range, contradicting fields.
    """
    if not text.strip():
        raise InputError('it is empty: weave = "twill 3/1" alone would be a fabric.')
    try:
        values = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"it is no valid TOML: {_reason(error)}.") from error
    except RecursionError as error:
        raise InputError("it is no fabric file: its values are nested too deeply.") from error
    except ValueError as error:  # an integer of thousands of digits, a month 13
        raise InputError(f"it is no valid TOML: {_reason(error)}.") from error
    return validate_fields(values)


def validate_fields(values: Mapping[str, Any]) -> FabricFile:
    """The fields of a fabric from plain values, tables as mappings.

    Raises:
        InputError: an unknown field, a value of another type or range, contradicting fields.
    """
    try:
        fields = FabricFile.model_validate(values)
    except ValidationError as error:
        raise InputError(sentence_of(error)) from error
    _require_consistent(fields)
    return fields


def _reason(error: ValueError) -> str:
    reason = str(error).split(";")[0].rstrip(".")
    return reason[:1].lower() + reason[1:]


def _require_consistent(fields: FabricFile) -> None:
    sources = [name for name in ("weave", "draft", "image") if getattr(fields, name) is not None]
    if not sources:
        raise InputError(
            'it has no weave: write weave = "twill 3/1", draft = "file.wif" or image = "file.png".'
        )
    _refuse_together(fields, sources[:2])
    if fields.weaves and fields.image is None:
        raise InputError(
            'weaves say what the colours of an artwork are: write image = "artwork.png" with them.'
        )
    if fields.artwork != ArtworkTable() and not fields.weaves:
        raise InputError(
            '[artwork] says how [weaves] are woven, and there are none: write "#c00000" = "satin 8/3" there.'
        )
    _refuse_together(fields, ["ends_per_cm", "epi"])
    _refuse_together(fields, ["picks_per_cm", "ppi"])
    for family in ("warp", "weft"):
        _refuse_together(getattr(fields, family), ["width_mm", "gap"], f"{family}.")
    require_maps(fields)


def _refuse_together(table: object, names: list[str], prefix: str = "") -> None:
    given = [name for name in names if getattr(table, name) is not None]
    if len(given) > 1:
        first, second = (f"{prefix}{name} = {_value(table, name)}" for name in given[:2])
        raise InputError(f"{first} and {second} say the same thing twice: keep one of them.")


def _value(table: object, name: str) -> str:
    value = getattr(table, name)
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"


# ------------------------------------------------------------------------------------- sentences about faults
# One each: field, value, and what would be right.


def sentence_of(error: ValidationError) -> str:
    """The first fault that pydantic found, as one sentence without the file's name."""
    fault = error.errors(include_url=False)[0]
    path = [str(part) for part in fault["loc"]]
    name = ".".join(path)
    if fault["type"] == "extra_forbidden":
        return _unknown(path)
    if fault["type"] == "sentence":
        return str(fault["ctx"]["text"]).replace(FIELD, name)
    if fault["type"] == "string_too_short":
        return f'{name} = "" is empty: write a value, or leave the field out.'
    if fault["type"] == "string_unicode":
        return f"{name} holds bytes that are no text in UTF-8: rename the file, or write the value anew."
    if path[0] == "weaves":
        return f"{name} cannot be used: write a weave in quotes for each colour, or a list of one a weft."
    if path[0] == "maps":
        return _fault_of_map(path, fault["input"])
    field = _field_at(path)
    if field is None:
        return f"{name} = {shown(fault['input'])} cannot be used: {fault['msg']}."
    return f"{name} = {shown(fault['input'])} cannot be used: {_expected(field, fault['input'])}."


def _fault_of_map(path: list[str], given: object) -> str:
    """What is wrong with a field of `[maps]`, which pydantic names by its map and its place in a list."""
    name = ".".join(path[:3])
    if path[2:] == ["picture"] and isinstance(given, dict):
        return f'{".".join(path[:2])} names no picture: write picture = "FILE.png".'
    if len(path) < 2:
        return f"{name} = {shown(given)} cannot be used: it is a table of pictures, a name each."
    if len(path) < 3:
        return f'{name} = {shown(given)} cannot be used: write the path of a picture, "FILE.png", or a table.'
    if path[2] == "at_mm":
        return f"{name} = {shown(given)} cannot be used: write two numbers, such as [0, 50]."
    if path[2] == "fabrics":
        return f'{name} = {shown(given)} cannot be used: write fabric files in quotes, ["FILE.toml"].'
    return f"{name} = {shown(given)} cannot be used: {_expected(MapTable.model_fields[path[2]], given)}."


def _tables(model: type[BaseModel]) -> dict[str, type[BaseModel]]:
    return {
        name: field.annotation
        for name, field in model.model_fields.items()
        if isinstance(field.annotation, type) and issubclass(field.annotation, BaseModel)
    }


def _unknown(path: list[str]) -> str:
    *parents, key = path
    if parents[:1] == ["maps"]:
        return f"{shown(key)} is no field that a map has: {closest(key, MapTable.model_fields)}"
    model: type[BaseModel] = FabricFile
    for parent in parents:
        model = _tables(model)[parent]
    place = f"[{'.'.join(parents)}] has" if parents else "a fabric file has"
    return f"{shown(key)} is no field that {place}: {_place_of(key, model)}"


def _place_of(key: str, model: type[BaseModel]) -> str:
    tables = _tables(FabricFile)
    homes = [f"[{name}]" for name, table in tables.items() if key in table.model_fields]
    if homes:
        return f"it belongs under {' or '.join(homes)}."
    if key in FabricFile.model_fields and model is not FabricFile:
        return "it belongs at the top of the file, above the first table."
    return closest(key, model.model_fields)


def _field_at(path: list[str]) -> FieldInfo | None:
    model: type[BaseModel] = FabricFile
    for position, part in enumerate(path):
        field = model.model_fields.get(part)
        if field is None or position == len(path) - 1:
            return field
        table = _tables(model).get(part)
        if table is None:
            return field
        model = table
    return None


def _expected(field: FieldInfo, given: object) -> str:
    annotation = field.annotation
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return "it is a table of fields"
    kinds, bounds = _kinds_and_bounds(annotation)
    low = next((bound.ge for bound in bounds if isinstance(bound, Ge)), None)
    high = next((bound.le for bound in bounds if isinstance(bound, Le)), None)
    if bool in kinds and not kinds & {int, float, str}:
        meant = {0: "false", 1: "true"}.get(given) if isinstance(given, int) else None
        return f"write {meant or 'true or false'}"
    if float in kinds:
        return f"write a number from {_number(low)} to {_number(high)}"
    if int in kinds:
        return f"write a whole number from {_number(low)} to {_number(high)}"
    return "write text in quotes" if str in kinds else "write a value of another kind"


def _number(bound: object) -> str:
    return str(bound) if isinstance(bound, int) else f"{bound:g}"


def _kinds_and_bounds(annotation: object) -> tuple[set[type], list[object]]:
    """The plain types and the bounds anywhere inside an annotation such as Annotated[float, …] | None."""
    if isinstance(annotation, type):
        return {annotation}, []
    kinds: set[type] = set()
    bounds: list[object] = []
    for part in get_args(annotation):
        if isinstance(part, FieldInfo):
            bounds += part.metadata
        elif isinstance(part, type):
            kinds.add(part)
        else:
            inner_kinds, inner_bounds = _kinds_and_bounds(part)
            kinds |= inner_kinds
            bounds += inner_bounds
    return kinds, bounds


# ------------------------------------------------------------------------------------------- measured colours
# Colours that a fabric file names by files of spectrophotometers, read once: fields hold linear RGB then.


_FIELDS = ("color", "albedo", "specular_tint", "nep_color", *Albedos._fields)


def with_measured_colours(fields: FabricFile, folder: str) -> FabricFile:
    """The fields with linear RGB in the places of spectra, whose paths are relative to `folder`.

    Raises:
        InputError: a file that cannot be read, or holds no spectrum; or both a colour and an albedo.
    """
    tables = {}
    for name in ("warp", "weft"):
        table: YarnTable = getattr(fields, name)
        if table.color is not None and table.albedo is not None:
            raise InputError(f"{name}.color and {name}.albedo both say what colour yarns are: leave one out.")
        found = {
            field: _measured(getattr(table, field), folder, f"{name}.{field}")
            for field in _FIELDS
            if getattr(table, field) is not None
        }
        tables[name] = table.model_copy(update=found)
    return fields.model_copy(update=tables)


def _measured(value: Any, folder: str, field: str) -> Any:
    if is_spectrum(value):
        # Six digits are finer than any instrument.
        linear = np.clip(read_spectrum(value, folder, field), 0, 1)
        return [round(float(part), 6) for part in linear]
    if isinstance(value, list) and not is_one_colour(value):
        return [_measured(part, folder, field) for part in value]
    return value


# ------------------------------------------------------------------------------------------------------ slips
# What no cloth can be, and what is rather a slip than a wish.


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
