"""U3M materials made in memory: constants, and pictures by the field that they belong to."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

import numpy as np
from PIL import Image

from loomlight.sources.u3m import U3mMaterial
from loomlight.sources.u3m_file import U3mFile

SIZE = {"width": 12.0, "height": 8.0, "dpi": {"x": 50.8, "y": 50.8}}


def png(values: Any) -> bytes:
    """A PNG of 8-bit values [rows, columns, 3], the upper row first."""
    stream = io.BytesIO()
    Image.fromarray(np.asarray(values, np.uint8)).save(stream, format="png")
    return stream.getvalue()


def image(path: str, mode: str = "normal", **size: Any) -> dict[str, Any]:
    """The `image` of a document."""
    return {"path": path, "repeat": {"mode": mode, "rotation": 0}, **SIZE, **size}


def visual(**fields: Any) -> dict[str, Any]:
    """A visual: numbers are constants, three numbers a colour, and dictionaries stand as they are."""
    found: dict[str, Any] = {"shader": "principled"}
    for name, value in fields.items():
        if isinstance(value, tuple):
            value = {"constant": dict(zip("rgb", value, strict=True)), "texture": None}
        found[name] = value if isinstance(value, dict) else {"constant": value, "texture": None}
    return found


def material(
    front: Mapping[str, Any] | None, back: Mapping[str, Any] | None = None, **files: bytes
) -> U3mMaterial:
    """A material of two visuals; files are named NAME.png."""
    document = {"schema": "1.1", "material": {"name": "bought", "front": front, "back": back, "side": None}}
    return U3mMaterial(U3mFile("bought", document, {f"{name}.png": each for name, each in files.items()}))
