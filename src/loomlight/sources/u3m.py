"""U3M materials as sources: what their pictures say of each face, decoded; see `u3m_file.py` for the files.

Of U3M 1.0 and 1.1, what `principled` materials of cloth have is read: base colour, alpha, normal, roughness,
anisotropy, metalness, specular, sheen and transmission. Displacement, clear coat, refraction and subsurface
are left out, as is a `side`.
"""

from __future__ import annotations

import io
import json
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageCms
from pydantic import BaseModel, ConfigDict

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.sentences import shown, speaking_of
from loomlight.sources.toml_source import SizedSource
from loomlight.sources.u3m_file import U3mFile, is_relative_path, named_files, read_u3m

Values = NDArray[np.float32]

# Texels of a picture that is decoded, and of one that is kept: larger ones are halved.
_MAX_PIXELS, _MAX_TEXELS = 1 << 26, 1 << 22
_MAX_SIDE = 1 << 14
_FORMATS = ("PNG", "JPEG", "TIFF")
_MIN_MM, _MAX_MM = 1e-3, 1e6
_WHOLE = 0.01
# Of a face without pictures.
_PLAIN_MM = 100.0
_MIRRORED = {"normal": (), "mirror_x": (1,), "mirror_y": (0,), "mirror_xy": (0, 1)}
_TENSOR = "file."


@dataclass(frozen=True, eq=False)
class Map:
    """A quantity over a face.

    Attributes:
        values: [rows, columns, channels], linear, row 0 at the lower edge; one texel of a constant.
        size_mm: width and height of what they show, which repeats; None of a constant.
    """

    values: Values
    size_mm: tuple[float, float] | None = None


def are_whole(repeats: float) -> bool:
    """Whether a number of repeats is whole, 1 or more, but for what documents round."""
    return repeats > 0.5 and abs(repeats - round(repeats)) <= _WHOLE


@dataclass(frozen=True, eq=False)
class U3mFace:
    """What a visual of U3M shows, as seen from its own side: x to the right, y up, z towards the eye.

    Attributes:
        base: base colour, linear RGB.
        alpha: opacity. normal: vectors, not of unit length.
        roughness, anisotropy, metalness, specular, specular_tint, sheen, sheen_tint, transmission: 0 to 1.
        rotation: of the direction along which highlights are wide, in turns from x towards y.
    """

    base: Map
    alpha: Map
    normal: Map
    roughness: Map
    anisotropy: Map
    rotation: Map
    metalness: Map
    specular: Map
    specular_tint: Map
    sheen: Map
    sheen_tint: Map
    transmission: Map

    @property
    def size_mm(self) -> tuple[float, float]:
        """Width and height after which the face repeats: the largest of a picture, if all others fit into it.

        Else those of its base colour.
        """
        sizes = [each.size_mm for each in vars(self).values() if each.size_mm is not None]
        if not sizes:
            return _PLAIN_MM, _PLAIN_MM
        own = self.base.size_mm or sizes[0]
        largest = [max(size[axis] for size in sizes) for axis in (0, 1)]
        width, height = (
            whole if all(are_whole(whole / size[axis]) for size in sizes) else own[axis]
            for axis, whole in enumerate(largest)
        )
        return width, height


# Fields of `U3mFace` that are numbers, by their name in a document, and the value of one that is missing.
_NUMBERS: Mapping[str, tuple[str, float]] = {
    "alpha": ("alpha", 1.0),
    "roughness": ("roughness", 0.7),
    "anisotropy": ("anisotropy_value", 0.0),
    "rotation": ("anisotropy_rotation", 0.0),
    "metalness": ("metalness", 0.0),
    "specular": ("specular_value", 0.5),
    "specular_tint": ("specular_tint", 0.0),
    "sheen": ("sheen_value", 0.0),
    "sheen_tint": ("sheen_tint", 0.0),
    "transmission": ("transmission", 0.0),
}
# What is left out, by its name in a document.
_LEFT_OUT = {"clearcoat_value": "clear coat", "subsurface_value": "subsurface"}


class _Record(BaseModel):
    """The header of a U3M in a `.loom` file; its files are tensors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    name: str
    document: str
    files: list[str]
    noun: ClassVar[str] = "a U3M"


@dataclass(frozen=True, eq=False)
class U3mMaterial(SizedSource):
    """A material of U3M.

    Attributes:
        file: its document and files, as they were read.
    """

    file: U3mFile

    def __post_init__(self) -> None:
        self.faces  # noqa: B018  # says what is wrong when the material is read

    @property
    def name(self) -> str:
        """As the document calls it."""
        name = self.file.document["material"].get("name")
        return name if isinstance(name, str) and name else self.file.name

    @property
    def size_mm(self) -> tuple[float, float]:  # type: ignore[override]
        """Width and height after which its front repeats, millimetres."""
        return self.faces[0].size_mm

    @cached_property
    def faces(self) -> tuple[U3mFace, U3mFace]:
        """The front, and the back: a face that is null is as the other one."""
        material = self.file.document["material"]
        given = {name: material.get(name) for name in ("front", "back", "side")}
        first = next((name for name, value in given.items() if value is not None), None)
        if first is None:
            raise InputError("it has neither front nor back, so that nothing of it can be shown.")
        decoded: dict[str, U3mFace] = {}
        for name in ("front", "back"):
            source = name if given[name] is not None else ("front" if given["front"] is not None else first)
            if source not in decoded:
                with speaking_of(f"material.{source}"):
                    decoded[source] = _Decoder(self.file.files, source).face(given[source])
            decoded[name] = decoded[source]
        return decoded["front"], decoded["back"]


def load_u3m(path: str | os.PathLike[str]) -> U3mMaterial:
    """The material of a `.u3m` or `.u3ma`.

    Raises:
        InputError: no such file, a damaged one, a field or a picture that cannot be used; it is named.
    """
    file = read_u3m(path)
    with speaking_of(str(path)):
        return U3mMaterial(file)


def u3m_record(source: U3mMaterial) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a material, as JSON, and its files as tensors."""
    names = list(source.file.files)
    text = json.dumps(source.file.document, ensure_ascii=False)
    record = _Record(name=source.file.name, document=text, files=names)
    return record.model_dump(), {
        f"{_TENSOR}{number}": np.frombuffer(source.file.files[name], np.uint8)
        for number, name in enumerate(names)
    }


def u3m_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> U3mMaterial:
    """The material of a record and its tensors; nothing else is read.

    Raises:
        ValidationError: another record than `u3m_record` makes.
        InputError: tensors or a document that make no material; the message names the one at fault.
    """
    del folder
    header = _Record.model_validate(record)
    files = {}
    for number, name in enumerate(header.files):
        content = tensors.get(f"{_TENSOR}{number}")
        if content is None or content.dtype != np.uint8 or content.ndim != 1:
            raise InputError(f"the tensor source.{_TENSOR}{number} must hold the bytes of a file, uint8.")
        if not is_relative_path(name) or name in files:
            raise InputError(f"its source names the file {shown(name)}, which no U3M can hold.")
        files[name] = content.tobytes()
    try:
        document = json.loads(header.document)
    except (ValueError, RecursionError) as error:
        raise InputError("its source holds a document that is no JSON.") from error
    if not isinstance(document, dict) or not isinstance(document.get("material"), dict):
        raise InputError('its source holds a document without the field "material".')
    for name in named_files(document):
        if name not in files:
            raise InputError(f"its source lacks the file {shown(name)}, which its document names.")
    return U3mMaterial(U3mFile(header.name, document, files))


# ----------------------------------------------------------------------------------------------------- decode


class _Decoder:
    """Decodes the visuals of a document; each picture once."""

    def __init__(self, files: Mapping[str, bytes], face: str) -> None:
        self._files, self._face = files, face
        self._pictures: dict[tuple[str, bool], Values] = {}

    def face(self, visual: Any) -> U3mFace:
        """The maps of a visual.

        Raises:
            InputError: a value of another kind, or a picture that cannot be read; it is named.
        """
        fields = _table(visual, "a visual")
        shader = fields.get("shader", "principled")
        if shader != "principled":
            raise InputError(f'shader = {shown(shader)} is unknown: U3M has "principled".')
        for name, noun in _LEFT_OUT.items():
            value = fields.get(name)
            if isinstance(value, dict) and (value.get("texture") or value.get("constant") not in (0, None)):
                warnings.warn(
                    f"{self._face}.{name}: {noun} is left out of pictures.", LoomlightWarning, stacklevel=2
                )
        numbers: dict[str, Map] = {}
        for name, (field, default) in _NUMBERS.items():
            with speaking_of(field):
                numbers[name] = self._number(fields.get(field), default, clipped=name != "rotation")
        with speaking_of("basecolor"):
            base = self._color(fields.get("basecolor"))
        with speaking_of("normal"):
            normal = self._normal(fields.get("normal"))
        return U3mFace(base=base, normal=normal, **numbers)

    def _number(self, value: Any, default: float, clipped: bool) -> Map:
        if value is None:
            return Map(_constant(default))
        field = _table(value, "constant and texture")
        if field.get("texture") is None:
            found = Map(_constant(_number(field.get("constant", default), "constant")))
        else:
            texture = _table(field["texture"], "a texture")
            offset, factor = (_number(texture.get(k, d), k) for k, d in (("offset", 0.0), ("factor", 1.0)))
            pixels, size = self._image(texture.get("image"), color=False)
            found = Map(offset + factor * pixels.mean(axis=2, keepdims=True), size)
        return Map(np.clip(found.values, 0, 1), found.size_mm) if clipped else found

    def _color(self, value: Any) -> Map:
        if value is None:
            return Map(_constant(1.0, 3))
        field = _table(value, "constant and texture")
        if field.get("texture") is None:
            # Documents hold colours of U3M's colour space, sRGB.
            return Map(srgb_to_linear(_rgb(field.get("constant"), "constant")).astype(np.float32)[None, None])
        texture = _table(field["texture"], "a texture")
        pixels, size = self._image(texture.get("image"), color=True)
        factor: Values = srgb_to_linear(_rgb(texture.get("factor"), "factor")).astype(np.float32)
        return Map(np.clip(_blended(pixels, factor, texture.get("mode", "multiply")), 0, 1), size)

    def _normal(self, value: Any) -> Map:
        upright = Map(np.array([[[0, 0, 1]]], np.float32))
        texture = _table(value, "constant and texture").get("texture") if value is not None else None
        if texture is None:
            return upright
        texture = _table(texture, "a texture")
        pixels, size = self._image(texture.get("image"), color=False)
        scale = _number(texture.get("scale", 1.0), "scale")
        vectors = (2 * pixels - 1) * np.array([scale, scale, 1], np.float32)
        length = np.linalg.norm(vectors, axis=-1, keepdims=True)
        return Map(np.where(length > 1e-3, vectors / np.maximum(length, 1e-3), upright.values), size)

    def _image(self, value: Any, color: bool) -> tuple[Values, tuple[float, float]]:
        """Pixels [rows, columns, 3], row 0 at the lower edge, linear if `color`; and their millimetres."""
        image = _table(value, "an image")
        path = image.get("path")
        if not isinstance(path, str):
            raise InputError(f"image.path = {shown(path)} is no path of a picture.")
        width, height = (_length(image.get(side), f"image.{side}") for side in ("width", "height"))
        with speaking_of(f"the picture {shown(path)}"):
            pixels = self._picture(path, color)
        repeat = image.get("repeat") or {}
        mode = repeat.get("mode", "normal") if isinstance(repeat, dict) else repeat
        if not isinstance(mode, str) or mode not in _MIRRORED:
            raise InputError(f"image.repeat.mode = {shown(mode)} is unknown: use {', '.join(_MIRRORED)}.")
        for axis in _MIRRORED[mode]:
            # The repeat of what is mirrored is twice as long.
            pixels = np.concatenate([pixels, np.flip(pixels, axis)], axis)
            width, height = (width, 2 * height) if axis == 0 else (2 * width, height)
        return pixels, (width, height)

    def _picture(self, path: str, color: bool) -> Values:
        if (path, color) not in self._pictures:
            self._pictures[path, color] = _decoded(self._files[path], color)
        return self._pictures[path, color]


def _decoded(content: bytes, color: bool) -> Values:
    """Pixels [rows, columns, 3] of a PNG, JPEG or TIFF, row 0 at the lower edge."""
    try:
        # Pillow warns of what is refused by its size below.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(io.BytesIO(content), formats=_FORMATS) as opened:
                width, height = opened.size
                if max(width, height) > _MAX_SIDE or width * height > _MAX_PIXELS:
                    raise InputError(
                        "it has "
                        f"{width} × {height} pixels, and at most {_MAX_PIXELS >> 20} million can be used."
                    )
                opened.load()
                picture = _in_srgb(opened) if color else opened
                if picture.mode.startswith("I;16"):
                    values = np.asarray(picture, np.float32)[..., None].repeat(3, -1) / 65535
                else:
                    values = np.asarray(picture.convert("RGB"), np.float32) / 255
    except InputError:
        raise
    except Image.DecompressionBombError as error:
        raise InputError(
            f"it has more than the {_MAX_PIXELS >> 20} million pixels that can be used."
        ) from error
    except (OSError, ValueError, SyntaxError, MemoryError, EOFError, LookupError, TypeError) as error:
        raise InputError("it is no PNG, JPEG or TIFF that can be read.") from error
    found: Values = np.asarray(srgb_to_linear(values) if color else values, np.float32)
    while found.shape[0] * found.shape[1] > _MAX_TEXELS:
        found = _halved(found)
    return np.ascontiguousarray(np.flipud(found))


def _in_srgb(picture: Image.Image) -> Image.Image:
    """The picture in sRGB, where it has a profile that says what else it is in."""
    profile = picture.info.get("icc_profile")
    if not profile or picture.mode not in ("RGB", "RGBA"):
        return picture
    try:
        known = ImageCms.ImageCmsProfile(io.BytesIO(profile))
        return ImageCms.profileToProfile(picture, known, ImageCms.createProfile("sRGB")) or picture
    except (ImageCms.PyCMSError, OSError, ValueError, TypeError):
        return picture


def _halved(values: Values) -> Values:
    """Means of two texels each way; a last odd one is left out."""
    for axis in (0, 1):
        half = values.shape[axis] // 2
        if half:
            even, odd = (np.take(values, range(k, 2 * half, 2), axis) for k in (0, 1))
            values = np.asarray((even + odd) / 2, np.float32)
    return values


def _blended(texture: Values, factor: Values, mode: Any) -> Values:
    """What U3M's modes make of texture and factor (u3m_additional_spec_u3m.txt), linear."""
    a, b = texture, np.broadcast_to(factor, texture.shape)
    if mode == "add":
        # Of 1.0, whose example adds white, U3M 1.1 multiplies instead.
        return a if (factor >= 1).all() else a + b
    if mode == "divide":
        return np.divide(a, b, out=np.ones_like(a), where=b > 0)
    operations = {
        "subtract": lambda: a - b,
        "multiply": lambda: a * b,
        "max": lambda: np.maximum(a, b),
        "min": lambda: np.minimum(a, b),
        "overlay": lambda: np.where(a < 0.5, 2 * a * b, 1 - 2 * (1 - a) * (1 - b)),
    }
    if not isinstance(mode, str) or mode not in operations:
        known = ", ".join(("add", "divide", *operations))
        raise InputError(f"texture.mode = {shown(mode)} is unknown: use one of {known}.")
    return operations[mode]()


def _constant(value: float, channels: int = 1) -> Values:
    return np.full((1, 1, channels), value, np.float32)


def _table(value: Any, noun: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InputError(f"{shown(value)} cannot be used: write {noun} as an object.")
    return value


def _number(value: Any, field: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= _MAX_MM:
        raise InputError(f"{field} = {shown(value)} cannot be used: write a number.")
    return float(value)


def _length(value: Any, field: str) -> float:
    length = _number(value, field)
    if not _MIN_MM <= length <= _MAX_MM:
        raise InputError(f"{field} = {shown(value)} cannot be used: write millimetres above 0.")
    return length


def _rgb(value: Any, field: str) -> NDArray[np.float64]:
    fields = {"r": 1.0, "g": 1.0, "b": 1.0} if value is None else _table(value, "r, g and b")
    numbers = [_number(fields.get(name), f"{field}.{name}") for name in "rgb"]
    return np.clip(np.array(numbers), 0, 1)
