"""Materials as sources: any textured BSDF of Mitsuba, as its XML and the files that it names.

A material is a Mitsuba scene file that holds a `<bsdf>`, or that element alone. Files that it names (bitmaps,
a `measured` BSDF, spectra) are found beside it. A TOML file may stand in front of it:

    material = "ceramic.xml"
    size_mm = [80.0, 80.0]             # of a unit of u and of v; 100 by default
    bsdf = "body"                      # the id of the BSDF, where the file holds several
    name = "glazed ceramic"

What is kept is one self-contained `<bsdf>`: references (`<ref>`) are replaced by what they refer to, and
parameters (`<default>`) by their values. A BSDF that a scene file's BSDF refers to is no candidate.
"""

from __future__ import annotations

import copy
import math
import os
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Annotated, Any, ClassVar
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from loomlight.core.errors import InputError
from loomlight.core.files import read_text, require_file
from loomlight.core.images import PICTURE_SUFFIXES, read_map
from loomlight.core.sentences import closest, shown, speaking_of
from loomlight.sources import scene_text
from loomlight.sources.toml_source import SizedSource, SourceFields, has_field, read_fields

Bytes = NDArray[np.uint8]

_FIELD = "material"
_SUFFIX = ".xml"
DEFAULT_SIZE_MM = 100.0
# Texels a side of a texture: the latents of a larger one would not fit into the memory of most machines.
MAX_TEXTURE_SIDE = 4096
# A file's size in bytes; a measured BSDF has some 10 MB.
_MAX_FILE = 1 << 28
_DEEPEST = 64
_TENSOR = "file."
_CIRCLE = "its references form a circle: a BSDF cannot be a part of itself."


class _Record(BaseModel):
    """The header of a material in a `.loom` file; its files are tensors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    size_mm: list[Annotated[float, Field(gt=0, le=1e6)]] = Field(min_length=2, max_length=2)
    xml: str
    files: list[str]


class _File(SourceFields):
    """The fields of a material's TOML file."""

    noun = "a material"
    expected: ClassVar[Mapping[str, str]] = {
        "material": 'the name of a Mitsuba file in quotes, such as "ceramic.xml"',
        "size_mm": "two lengths above 0, such as [80.0, 80.0]",
        "bsdf": "the id of a BSDF in quotes",
    }

    material: str
    bsdf: str | None = None
    size_mm: list[Annotated[float, Field(ge=1e-3, le=1e6)]] = Field(
        default_factory=lambda: [DEFAULT_SIZE_MM] * 2, min_length=2, max_length=2
    )


@dataclass(frozen=True, eq=False)
class Material(SizedSource):
    """A BSDF of Mitsuba over a unit of u and of v, which repeats.

    Attributes:
        name: in messages.
        size_mm: of a unit of u and of v, millimetres.
        xml: the `<bsdf>` element; files are named as `files` names them.
        files: bytes of each file, by the name in `xml`.
    """

    name: str
    size_mm: tuple[float, float]
    xml: str
    files: Mapping[str, Bytes]

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """The same: a model of the material takes its place on any mesh."""
        return self.size_mm

    def write_files(self, folder: str | os.PathLike[str]) -> ElementTree.Element:
        """Writes all files to a folder; the `<bsdf>` element that names them there by their full paths."""
        root = ElementTree.fromstring(self.xml)
        for name, content in self.files.items():
            (Path(folder) / name).write_bytes(content.tobytes())
        for element in scene_text.naming_files(root):
            element.set("value", str(Path(folder, element.get("value", "")).absolute()))
        return root


def is_material_file(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a Mitsuba XML file, a measured `.bsdf`, or a TOML file that names one."""
    file = Path(path)
    return file.suffix.lower() in (_SUFFIX, RGL_SUFFIX) or has_field(path, _FIELD)


def load_material(path: str | os.PathLike[str]) -> Material:
    """The material of an XML file, or of a TOML file that names one.

    Raises:
        InputError: no such file, no BSDF, several of them, a file that is missing, a texture that is damaged,
            too large or not finite; it is named.
    """
    file = Path(path)
    with speaking_of(str(file)):
        size = (DEFAULT_SIZE_MM, DEFAULT_SIZE_MM)
        if file.suffix.lower() == RGL_SUFFIX:
            require_file(file)
            return material_from_xml(measured_xml(file), file.parent, file.stem, size)
        if file.suffix.lower() == _SUFFIX:
            return material_from_xml(read_text(file), file.parent, file.stem, size)
        fields = read_fields(file, _File)
        xml = file.parent / fields.material
        width, height = fields.size_mm
        with speaking_of(f"material = {shown(fields.material)}"):
            return material_from_xml(
                read_text(xml), xml.parent, fields.name or file.stem, (width, height), fields.bsdf
            )


def material_from_xml(
    text: str,
    folder: str | os.PathLike[str],
    name: str,
    size_mm: tuple[float, float],
    bsdf: str | None = None,
) -> Material:
    """The material of Mitsuba's XML, whose files lie in a folder.

    Args:
        bsdf: the id of the BSDF; None for the only one.

    Raises:
        InputError: as `load_material`.
    """
    root = scene_text.parsed_text(text)
    found = _chosen(root, bsdf)
    defined = {
        element.get("id", ""): element
        for element in root.iter()
        if element.get("id") and element.tag != "ref"
    }
    _resolve(found, defined, 0)
    found.attrib.pop("id", None)
    found.attrib.pop("name", None)
    found.set("version", root.get("version", "3.0.0"))
    names: dict[Path, str] = {}
    files: dict[str, Bytes] = {}
    for element in scene_text.naming_files(found):
        file = Path(folder, element.get("value", ""))
        if file not in names:
            names[file] = f"{len(names)}-{scene_text.NO_FILE_CHARACTER.sub('_', file.name)[-40:]}"
            files[names[file]] = _content(file)
        element.set("value", names[file])
    scene_text.put_spectra_in(found, Path(folder).joinpath)
    scene_text.require_closed(found, files)
    # What follows the element in its scene is no part of it.
    found.tail = None
    return Material(name, size_mm, ElementTree.tostring(found, encoding="unicode"), files)


def material_record(source: Material) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a material, as JSON, and its files as tensors."""
    names = list(source.files)
    record = _Record(name=source.name, size_mm=list(source.size_mm), xml=source.xml, files=names)
    return record.model_dump(), {
        f"{_TENSOR}{number}": source.files[name] for number, name in enumerate(names)
    }


def material_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> Material:
    """The material of a record and its tensors; nothing else is read.

    Raises:
        ValidationError: another record than `material_record` makes.
        InputError: tensors or XML that make no material; the message names the one at fault.
    """
    del folder
    header = _Record.model_validate(record)
    root = scene_text.parsed_text(header.xml)
    files = {}
    for number, name in enumerate(header.files):
        content = tensors.get(f"{_TENSOR}{number}")
        if content is None or content.dtype != np.uint8 or content.ndim != 1:
            raise InputError(f"the tensor source.{_TENSOR}{number} must hold the bytes of a file, uint8.")
        if PurePath(name).name != name or name in files:
            raise InputError(f"its source names the file {shown(name)}, which is no name of a file alone.")
        files[scene_text.require_inside(name)] = content
    if root.tag != "bsdf":
        raise InputError(f"its source is no BSDF: it begins with <{root.tag}>, not with <bsdf>.")
    scene_text.require_closed(root, files)
    width, height = header.size_mm
    return Material(header.name, (width, height), ElementTree.tostring(root, encoding="unicode"), files)


def _chosen(root: ElementTree.Element, wanted: str | None) -> ElementTree.Element:
    if root.tag == "bsdf":
        return root
    candidates = list(root.iter("bsdf"))
    if wanted is not None:
        for element in candidates:
            if element.get("id") == wanted:
                return element
        known = [element.get("id", "") for element in candidates if element.get("id")]
        raise InputError(f"bsdf = {shown(wanted)} is no BSDF of it: {closest(wanted, known)}")
    referenced = {element.get("id") for outer in candidates for element in outer.iter("ref")}
    inner = {element for outer in candidates for element in outer.iter("bsdf") if element is not outer}
    left = [element for element in candidates if element not in inner and element.get("id") not in referenced]
    if candidates and not left:
        raise InputError(_CIRCLE)
    if not left:
        raise InputError("it holds no <bsdf>: write one into its <scene>.")
    if len(left) > 1:
        names = ", ".join(element.get("id", element.get("type", "?")) for element in left)
        raise InputError(f'it holds several BSDFs ({names}): name one in a TOML file, bsdf = "id".')
    return left[0]


def _resolve(element: ElementTree.Element, defined: Mapping[str, ElementTree.Element], depth: int) -> None:
    """Replaces references inside an element by copies of what they refer to."""
    if depth > _DEEPEST:
        raise InputError(_CIRCLE)
    for position, child in enumerate(element):
        if child.tag == "ref":
            target = defined.get(child.get("id", ""))
            if target is None:
                raise InputError(f"it refers to {shown(child.get('id'))}, which it does not define.")
            child = copy.deepcopy(target)
            child.attrib.pop("id", None)
            name = element[position].get("name")
            if name is not None:
                child.set("name", name)
            element[position] = child
        _resolve(child, defined, depth + 1)


def _content(file: Path) -> Bytes:
    """The bytes of a file; a texture's are checked."""
    with speaking_of(f"filename = {shown(file.name)}"):
        if not file.is_file():
            raise InputError(f"{file} does not exist.")
        if file.stat().st_size > _MAX_FILE:
            raise InputError(f"{file} is larger than {_MAX_FILE >> 20} MiB.")
        suffix = file.suffix.lower()
        if suffix == RGL_SUFFIX:
            require_rgl(file)
        if suffix in (".exr", *PICTURE_SUFFIXES):
            pixels = read_map(file, 3)
            height, width = pixels.shape[:2]
            if max(width, height) > MAX_TEXTURE_SIDE or min(width, height) < 1:
                raise InputError(
                    f"the texture {file} has {width} × {height} texels: 1 to {MAX_TEXTURE_SIDE} a side "
                    "can be learned."
                )
            if not np.isfinite(pixels).all():
                raise InputError(f"the texture {file} holds NaN or infinity: write numbers alone.")
        return np.frombuffer(file.read_bytes(), np.uint8)


# -------------------------------------------------------------------------------------- measured BSDFs of RGL
# Measured BSDFs of EPFL's RGL (Dupuy & Jakob 2018): `.bsdf`, which Mitsuba's `measured` BSDF reads.
#
# The file is a "tensor_file": its magic, version and number of fields, then of each field its name,
# dimensions, type, offset and shape. Mitsuba maps the data as the header says, so that a header is checked
# here.


RGL_SUFFIX = ".bsdf"
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
