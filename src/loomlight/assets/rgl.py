"""Measured BSDFs of EPFL's RGL (Dupuy & Jakob 2018): `.bsdf`, which Mitsuba's `measured` BSDF reads.

The file is a "tensor_file": its magic, version and number of fields, then of each field its name, dimensions,
type, offset and shape. Mitsuba maps the data as the header says, so that a header is checked here.
"""

from __future__ import annotations

import math
import os
import struct
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.files import require_file

SUFFIX = ".bsdf"
_MAGIC = b"tensor_file\0\1\0"
_MAX_FIELDS, _MAX_AXES = 64, 8
# By the format's numbers of types; 0 is none.
_DTYPES = (None, "u1", "i1", "<u2", "<i2", "<u4", "<i4", "<u8", "<i8", "<f2", "<f4", "<f8")
# Fields that the BSDF reads in RGB, with their number of dimensions.
_NEEDED = {"theta_i": 1, "phi_i": 1, "ndf": 2, "sigma": 2, "vndf": 4, "luminance": 4, "rgb": 5}


def measured_xml(file: Path) -> str:
    """The `<bsdf>` element that reads a file of its own folder."""
    bsdf = ElementTree.Element("bsdf", type="measured")
    ElementTree.SubElement(bsdf, "string", name="filename", value=file.name)
    return ElementTree.tostring(bsdf, encoding="unicode")


def require_rgl(path: str | os.PathLike[str]) -> None:
    """Raises InputError if a file is no measured BSDF that RGB can be read of, is truncated or not finite."""
    require_file(path)
    content = Path(path).read_bytes()
    if not content.startswith(_MAGIC):
        raise InputError(f"{path} is no measured BSDF of RGL: one begins with tensor_file and version 1.0.")
    try:
        fields = _fields(content, path)
    except (struct.error, UnicodeDecodeError, IndexError, ValueError) as error:
        raise InputError(f"{path} is truncated or damaged: its header cannot be read.") from error
    for name, axes in _NEEDED.items():
        if name not in fields:
            advice = ": take the file whose name ends in _rgb" if name == "rgb" else ""
            raise InputError(f"{path} lacks the field {name}{advice}.")
        values = fields[name]
        if values.ndim != axes or values.dtype != np.float32 or not values.size:
            raise InputError(f"{path} is damaged: the field {name} must be float32 of {axes} dimensions.")
        if not np.isfinite(values).all():
            raise InputError(f"{path} is damaged: the field {name} holds NaN or infinity.")
    phi, theta = len(fields["phi_i"]), len(fields["theta_i"])
    for name in ("vndf", "luminance", "rgb"):
        shape = fields[name].shape
        if shape[:2] != (phi, theta) or shape[-1] != shape[-2] or (name == "rgb" and shape[2] != 3):
            raise InputError(f"{path} is damaged: the field {name} does not fit to its angles.")


def _fields(content: bytes, path: str | os.PathLike[str]) -> dict[str, np.ndarray]:
    """Arrays by name; Mitsuba reads all of them, so that none may lie outside the file."""
    (count,) = struct.unpack_from("<I", content, len(_MAGIC))
    place = len(_MAGIC) + 4
    found: dict[str, np.ndarray] = {}
    if count > _MAX_FIELDS:
        raise ValueError(count)
    for _ in range(count):
        (length,) = struct.unpack_from("<H", content, place)
        name = content[place + 2 : place + 2 + length].decode()
        place += 2 + length
        axes, kind, offset = struct.unpack_from("<HBQ", content, place)
        if axes > _MAX_AXES or not _DTYPES[kind]:
            raise ValueError(axes)
        shape = struct.unpack_from(f"<{axes}Q", content, place + 11)
        place += 11 + 8 * axes
        dtype, size = np.dtype(_DTYPES[kind]), math.prod(shape)
        if offset + size * dtype.itemsize > len(content):
            raise InputError(f"{path} is truncated or damaged: the field {name[:40]} is not within the file.")
        found[name] = np.frombuffer(content, dtype, size, offset).reshape(shape)
    return found
