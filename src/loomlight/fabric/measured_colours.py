"""Colours that a fabric file names by files of spectrophotometers, read once: fields hold linear RGB then."""

from __future__ import annotations

from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.spectra import is_spectrum, read_spectrum
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.fabric.thread_order import is_one_colour

_FIELDS = ("color", "albedo", "specular_tint", "diffuse_reflect", "diffuse_transmit", "specular_reflect")


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
            for field in (*_FIELDS, "specular_transmit")
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
