"""What Python makes of a fabric for the page, which asks through a server or a widget of a notebook."""

from __future__ import annotations

import json
import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.viewer.fabric_json import fabric_of_json
from loomlight.viewer.openness_json import openness_json
from loomlight.viewer.saving import FORMATS, saved, tables_of

Asked = dict[str, Any]


@dataclass(frozen=True)
class Answer:
    """Bytes, their media type, and the name of the file that they are."""

    content: bytes
    media_type: str = "application/octet-stream"
    name: str | None = None


def answer(place: str, asked: Asked) -> Answer:
    """The answer to what a page posts to `place`, one of `ANSWERS`: keys of `FabricJson`, and what is asked.

    Warnings about the fabric are left out: the page shows its own while the user edits.

    Raises:
        LoomlightError: a fabric or a request that cannot be, or a missing dependency.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        return ANSWERS[place](asked)


def _save(asked: Asked) -> Answer:
    form = str(asked.get("format"))
    model, size = str(asked.get("model") or "lobes"), asked.get("size", 1024)
    if not isinstance(size, int):
        raise InputError(f"size = {size!r} is no whole number of texels.")
    content = saved(fabric_of_json(asked), form, model, size)
    stem = re.sub(r"[^\w-]+", "-", str(asked.get("name") or "fabric")).strip("-").lower()[:80] or "fabric"
    return Answer(content, FORMATS[form], f"{stem}.{form}")


def _tables(asked: Asked) -> Answer:
    return Answer(tables_of(fabric_of_json(asked), str(asked.get("model"))))


def _openness(asked: Asked) -> Answer:
    return Answer(json.dumps(openness_json(fabric_of_json(asked))).encode(), "application/json")


ANSWERS: dict[str, Callable[[Asked], Answer]] = {
    "api/save": _save,
    "api/tables": _tables,
    "api/openness": _openness,
}
