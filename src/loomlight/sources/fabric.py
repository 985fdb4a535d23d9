"""A fabric as a source of a `.loom`, which needs no other file: its fields as text, its draft as tensors.

A fabric file names a draft, and the draft may be a file of its own. The record holds what that draft says
about cloth: the drawdown, and colours, spacing and thickness of every thread, in float64, so that the fabric
comes back exactly. How a loom weaves it (threading, tie-up, notes) is left to the draft's own file.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePath
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import FabricFile
from loomlight.fabric.read import parse_fabric_file
from loomlight.fabric.resolve import yarn_diameter
from loomlight.fabric.write import fabric_toml
from loomlight.fabric.yarns import GAP, with_yarns
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, Threads
from loomlight.weave.load import DRAFT_SUFFIXES

Tensor: TypeAlias = NDArray[Any]
"""An array of any type that a `.loom` can hold."""

_FAMILIES = ("warp", "weft")
# Share of the spacing that threads kept open before schema 4.
_FORMER_MIN_GAP = 0.02
_LENGTHS_MM = (1e-6, 1e6)
_RANGES = {"colors": (0.0, 1.0), "spacing_mm": _LENGTHS_MM, "thickness_mm": _LENGTHS_MM}


class _FabricRecord(BaseModel):
    """The header of a fabric in a `.loom` file; the draft is in the tensors.

    Attributes:
        name: of the fabric.
        title: of its draft.
        toml: the text of the fabric file. A path in it names the origin of the draft; it is not read.
    """

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    name: str
    title: str
    toml: str


def fabric_record(fabric: Fabric) -> tuple[dict[str, Any], dict[str, Tensor]]:
    """The record of a fabric, as JSON, and the tensors beside it."""
    draft = fabric.named_draft
    tensors: dict[str, Tensor] = {"drawdown": np.asarray(draft.drawdown, np.bool_)}
    for family in _FAMILIES:
        threads: Threads = getattr(draft, family)
        for field in _RANGES:
            values = getattr(threads, field)
            if values is not None:
                tensors[f"{family}.{field}"] = np.asarray(values, np.float64)
        if threads.color_index is not None:
            tensors[f"{family}.color_index"] = np.asarray(threads.color_index, np.int64)
    toml = fabric_toml(_without_folders(fabric.fields), fabric.folder, fabric.folder)
    return _FabricRecord(name=fabric.name, title=draft.title, toml=toml).model_dump(), tensors


def _without_folders(fields: FabricFile) -> FabricFile:
    """The fields with bare names of the draft's files, as folders are private, and without maps' pictures."""
    paths = {name: getattr(fields, name) for name in ("draft", "image") if getattr(fields, name)}
    names = {name: PurePath(path).name for name, path in paths.items()}
    weaves = {
        colour: [PurePath(weave).name if _is_file(weave) else weave for weave in given]
        if isinstance(given, list)
        else PurePath(given).name
        if _is_file(given)
        else given
        for colour, given in fields.weaves.items()
    }
    return fields.model_copy(update={**names, "maps": {}, "weaves": weaves})


def _is_file(weave: str) -> bool:
    return PurePath(weave).suffix.lower() in DRAFT_SUFFIXES


def fabric_from_record(record: Mapping[str, Any], tensors: Mapping[str, Tensor], folder: str) -> Fabric:
    """The fabric of a record and its tensors; nothing else is read.

    Args:
        folder: where the `.loom` lies.

    Raises:
        ValidationError: another record than `fabric_record` makes.
        InputError: fields or tensors that make no fabric; the message names the one at fault.
    """
    header = _FabricRecord.model_validate(record)
    if "drawdown" not in tensors:
        raise InputError("the tensor source.drawdown is missing: without it there is no fabric.")
    drawdown = tensors["drawdown"]
    if drawdown.dtype != np.bool_ or drawdown.ndim != 2 or (drawdown.view(np.uint8) > 1).any():
        raise InputError("the tensor source.drawdown must hold true and false [picks, ends].")
    picks, ends = drawdown.shape
    threads = {
        family: _threads(family, tensors, count)
        for family, count in zip(_FAMILIES, (ends, picks), strict=True)
    }
    fields = parse_fabric_file(header.toml)
    draft = Draft(drawdown, threads["warp"], threads["weft"], title=header.title)
    return make_fabric(fields, draft, header.name, folder)


def of_former_defaults(record: Mapping[str, Any], schema: int) -> dict[str, Any]:
    """The record of a source as schema `schema` has it, whose fabric states what was a default then.

    Before schema 3 there was no light between yarns, before 4 yarns of all kinds were round beside a count
    and left a gap of 0.2 without, and threads kept 0.02 of the spacing apart. What is no fabric stays
    as it is: reading it says what is wrong.
    """
    if record.get("kind") != "fabric" or not isinstance(record.get("toml"), str):
        return dict(record)
    try:
        fields = parse_fabric_file(record["toml"])
    except InputError:
        return dict(record)
    stated: dict[str, Any] = {}
    if schema < 3 and fields.interreflection is None:
        stated["interreflection"] = False
    if fields.gap is not None:
        stated["gap"] = max(fields.gap, _FORMER_MIN_GAP)
    for family in _FAMILIES:
        table = getattr(with_yarns(fields), family)
        if table.gap is not None:
            width = {"gap": max(table.gap, _FORMER_MIN_GAP)}
        elif table.yarn and table.count is not None and table.width_mm is None:
            width = {"width_mm": yarn_diameter(table, f"{family}.count")}
        else:
            width = {}
        stated[family] = getattr(fields, family).model_copy(update=width)
        if table.yarn and fields.gap is None:
            stated["gap"] = GAP
    return {**record, "toml": fabric_toml(fields.model_copy(update=stated), "", "")}


def _threads(family: str, tensors: Mapping[str, Tensor], count: int) -> Threads:
    values: dict[str, Any] = {
        field: _checked(f"{family}.{field}", tensors[f"{family}.{field}"], count, bounds)
        for field, bounds in _RANGES.items()
        if f"{family}.{field}" in tensors
    }
    index = tensors.get(f"{family}.color_index")
    if index is not None:
        fits = index.dtype == np.int64 and index.shape == (count,)
        if not fits or not ((index >= 0) & (index < 2 * MAXIMUM_THREADS)).all():
            raise InputError(
                f"the tensor source.{family}.color_index must hold {count} rows of a palette, int64."
            )
        values["color_index"] = index.astype(np.intp)
    return Threads(**values)


def _checked(name: str, values: Tensor, count: int, bounds: tuple[float, float]) -> NDArray[np.float64]:
    shape = (count, 3) if name.endswith("colors") else (count,)
    low, high = bounds
    good = values.dtype == np.float64 and values.shape == shape
    if not good or not ((values >= low) & (values <= high)).all():
        raise InputError(
            f"the tensor source.{name} must hold {list(shape)} float64 numbers from {low:g} to {high:g}."
        )
    return values
