"""Measured BTFs as sources: pictures of a flat sample under many lights and views.

A BTF file's description is TOML:

    btf = "carpet01_resampled_W400xH400_L151xV151.btf"    # UBO 2014, or a ZIP of UBO 2003
    size_mm = [100.0, 100.0]     # of what the pictures show, which is repeated
    cosine_included = true       # the default: pixels are radiance under a lamp, not over its cosine
    gain = 1.0                   # pixels are multiplied by it; 1 is a white diffuser

Measurements are large and often not free to pass on: a `.loom` names the file and its SHA-256 instead of
holding it. Only baking again needs the file, beside the `.loom`.
"""

from __future__ import annotations

import hashlib
import lzma
import math
import os
import re
import struct
import warnings
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path, PurePath
from typing import Annotated, Any, BinaryIO, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from pydantic import BaseModel, ConfigDict, Field

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.sentences import shown, speaking_of
from loomlight.sources.toml_source import Lengths, SizedSource, SourceFields, has_field, read_fields

_FIELD = "btf"

_Gain = Annotated[float, Field(gt=0, le=1e6)]


class _Record(BaseModel):
    """The header of a measured BTF in a `.loom` file."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    file: str
    sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    size_mm: Lengths
    cosine_included: bool
    gain: _Gain


class _File(SourceFields):
    """The fields of a BTF's description."""

    noun = "a BTF"
    expected: ClassVar[Mapping[str, str]] = {
        "btf": "the name of a .btf or .zip in quotes",
        "size_mm": "two lengths above 0, such as [100.0, 100.0]",
        "cosine_included": "true or false",
        "gain": "a number above 0, such as 1.0",
    }

    btf: str
    size_mm: Lengths
    cosine_included: bool = True
    gain: _Gain = 1.0


@dataclass(frozen=True, eq=False)
class MeasuredBtf(SizedSource):
    """Pictures of a sample, in a file of their own.

    Attributes:
        name: in messages.
        path: of the file.
        sha256: of the file, hexadecimal.
        size_mm: width and height of what the pictures show, millimetres.
        cosine_included: whether pixels hold the cosine of the light.
        gain: that pixels are multiplied by.
    """

    name: str
    path: Path
    sha256: str
    size_mm: tuple[float, float]
    cosine_included: bool
    gain: float

    def pictures(self) -> BtfPictures:
        """The pictures.

        Raises:
            InputError: the file is missing, damaged, or another one than was described.
        """
        require_file(self.path)
        if _sha256(self.path) != self.sha256:
            raise InputError(f"{self.path} is another file than the one that {self.name} was made from.")
        return read_btf(self.path)


def is_btf_description(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a TOML file that names a BTF."""
    return has_field(path, _FIELD)


def load_measured_btf(path: str | os.PathLike[str]) -> MeasuredBtf:
    """The measured BTF of a description; its pictures are read when they are asked for.

    Raises:
        InputError: no such file, an unknown field, or a value that cannot be; it is named.
    """
    file = Path(path)
    with speaking_of(str(file)):
        fields = read_fields(file, _File)
        held = file.parent / fields.btf
        with speaking_of(f"btf = {shown(fields.btf)}"):
            require_file(held)
        width, height = fields.size_mm
        return MeasuredBtf(
            fields.name or file.stem,
            held,
            _sha256(held),
            (width, height),
            fields.cosine_included,
            fields.gain,
        )


def _sha256(path: Path) -> str:
    try:
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.") from error


def measured_btf_record(source: MeasuredBtf) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a measured BTF, as JSON; it has no tensors."""
    record = _Record(
        name=source.name,
        file=source.path.name,
        sha256=source.sha256,
        size_mm=list(source.size_mm),
        cosine_included=source.cosine_included,
        gain=source.gain,
    )
    return record.model_dump(), {}


def measured_btf_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> MeasuredBtf:
    """The measured BTF of a record, whose file lies in `folder` if it is anywhere.

    Raises:
        ValidationError: another record than `measured_btf_record` makes.
    """
    del tensors
    header = _Record.model_validate(record)
    width, height = header.size_mm
    file = Path(folder) / PurePath(header.file).name
    return MeasuredBtf(header.name, file, header.sha256, (width, height), header.cosine_included, header.gain)


# ------------------------------------------------------------------------------------- files of measured BTFs
# Files of measured BTFs: UBO 2003, a ZIP of pictures, and UBO 2014, a factored matrix.
#
# - UBO 2003 (Sattler et al. 2003): JPEG pictures named "tl015 pl090 tv030 pv180.jpg", which give polar angle
#   and azimuth of light and view in degrees; one for each pair of a light and a view.
# - UBO 2014 (Weinmann et al. 2014): a "full matrix factorization". A header, directions of views and lights,
#   and for each of three channels U [views · lights, k] and S·V [pixels, k], whose product is the channel.
#   Channels are RGB, or the logarithm of luminance and two shares of it (colour model 11).
#   The first row of pixels is the lowest, as btf-extractor shows them.
#
# All lengths are read before anything is allocated, so that a truncated file is refused, and costs nothing.


_NAME = re.compile(r"tl(\d{3}) pl(\d{3}) tv(\d{3}) pv(\d{3})\.jpe?g$", re.IGNORECASE)
_MAGIC = b"!DFMF08FC"
# Size, version, three texts, pixels per millimetre, and a colour.
_COMMON = struct.Struct("<II80s80s80sf3f")
# Bytes of a JPEG in a ZIP.
_MAX_PICTURE = 1 << 26
# What zipfile and its decompressors raise of damaged files.
_ZIP_FAULTS = (
    zipfile.BadZipFile, zlib.error, lzma.LZMAError, struct.error, EOFError, OSError, NotImplementedError,
    RuntimeError, ValueError, OverflowError, KeyError, IndexError,
)  # fmt: skip
_MAX_DIRECTIONS, _MAX_SIDE, _MAX_TEXT = 4096, 8192, 1 << 24
_RGB, _LOG_YUV = 0, 11
_LOG_EPSILON = 1e-5
_TO_RGB = np.array([[1, 0, 1.13983], [1, -0.39465, -0.5806], [1, 2.03211, 0]], np.float32)
_SCALARS = {2: np.float16, 4: np.float32, 8: np.float64}


class BtfPictures(Protocol):
    """Pictures of a surface under all pairs of some lights and views.

    Attributes:
        lights, views: unit vectors [n, 3].
        width, height: of a picture, pixels.
    """

    lights: NDArray[np.float32]
    views: NDArray[np.float32]
    width: int
    height: int

    def pixels(
        self,
        lights: NDArray[np.intp],
        views: NDArray[np.intp],
        columns: NDArray[np.intp],
        rows: NDArray[np.intp],
    ) -> NDArray[np.float32]:
        """Linear RGB [n, 3] of single pixels by numbers of light and view; row 0 is at the top."""


def read_btf(path: str | os.PathLike[str]) -> BtfPictures:
    """The pictures of a file of either format.

    Raises:
        InputError: no such file, neither of the formats, or a file that is truncated or damaged.
    """
    require_file(path)
    file = Path(path)
    with file.open("rb") as stream:
        start = stream.read(len(_MAGIC))
    if start == _MAGIC:
        return Ubo2014(file)
    if start.startswith(b"PK"):
        return Ubo2003(file)
    raise InputError(f"{file} is no BTF: it is neither a ZIP of UBO 2003 nor a .btf of UBO 2014.")


class Ubo2003:
    """A ZIP of pictures; all are held in memory, 8 bits a channel. See `BtfPictures`."""

    def __init__(self, file: Path) -> None:
        """
        Raises:
            InputError: a ZIP that is damaged or has no such pictures, or pictures of different sizes.
        """
        try:
            with zipfile.ZipFile(file) as archive:
                found = {name: _NAME.search(name) for name in archive.namelist()}
                angles = {name: tuple(map(int, match.groups())) for name, match in found.items() if match}
                if not angles:
                    raise InputError(
                        f'{file} is no BTF: it has no picture named as "tl015 pl090 tv030 pv180.jpg".'
                    )
                if len(set(angles.values())) < len(angles):
                    raise InputError(f"{file} is damaged: it has two pictures of the same directions.")
                pictures: list[NDArray[np.uint8]] = []
                for name in angles:
                    held = archive.getinfo(name)
                    if held.compress_size > file.stat().st_size or held.file_size > _MAX_PICTURE:
                        raise InputError(f'{file} is damaged: its picture "{name}" is too large.')
                    pictures.append(_decoded(file, name, archive.read(name)))
                    if pictures[-1].shape != pictures[0].shape:
                        raise InputError(f"{file} is damaged: its pictures are of different sizes.")
        except _ZIP_FAULTS as error:
            raise InputError(f"{file} is damaged: {' '.join(str(error).split())[:100]}.") from error
        self.height, self.width = pictures[0].shape[:2]
        degrees = np.array(list(angles.values()), np.float64)
        (lights, of_light), (views, of_view) = (
            np.unique(degrees[:, k : k + 2], axis=0, return_inverse=True) for k in (0, 2)
        )
        if len(lights) * len(views) != len(pictures):
            raise InputError(
                f"{file} is truncated or damaged: {len(lights)} lights and {len(views)} views make "
                f"{len(lights) * len(views)} pictures, and it has {len(pictures)}."
            )
        self.lights, self.views = (_directions(part[:, 0], part[:, 1], file) for part in (lights, views))
        self._number = np.empty((len(views), len(lights)), np.intp)
        self._number[of_view.ravel(), of_light.ravel()] = np.arange(len(pictures))
        self._pictures = np.stack(pictures)
        self._linear = np.asarray(srgb_to_linear(np.arange(256) / 255), np.float32)

    def pixels(
        self,
        lights: NDArray[np.intp],
        views: NDArray[np.intp],
        columns: NDArray[np.intp],
        rows: NDArray[np.intp],
    ) -> NDArray[np.float32]:
        """See `BtfPictures.pixels`."""
        return self._linear[self._pictures[self._number[views, lights], rows, columns]]


def _decoded(file: Path, name: str, held: bytes) -> NDArray[np.uint8]:
    try:
        # Pillow warns of a size; the size is checked here.
        with warnings.catch_warnings(action="ignore"), Image.open(BytesIO(held)) as picture:
            if not 1 <= max(picture.size) <= _MAX_SIDE:
                raise InputError(
                    f'{file} is damaged: its picture "{name}" has {max(picture.size)} pixels a side.'
                )
            return np.asarray(picture.convert("RGB"))
    except (Image.DecompressionBombError, *_ZIP_FAULTS, SyntaxError) as error:
        raise InputError(f'{file} is damaged: its picture "{name}" cannot be read.') from error


def _directions(polar: NDArray[np.float64], azimuth: NDArray[np.float64], file: Path) -> NDArray[np.float32]:
    """Unit vectors [n, 3] of angles in degrees."""
    if not ((polar >= 0) & (polar <= 90)).all() or not ((azimuth >= 0) & (azimuth <= 360)).all():
        raise InputError(f"{file} is damaged: it has a direction that is not above the surface.")
    polar, azimuth = np.radians(polar), np.radians(azimuth)
    sine = np.sin(polar)
    vectors = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), np.cos(polar)], axis=1)
    return vectors.astype(np.float32)


@dataclass(frozen=True)
class _Channel:
    """Where the factors of a channel lie."""

    components: int
    scalar: int
    left: int
    right: int


class Ubo2014:
    """A factored matrix, mapped and not read. See `BtfPictures`.

    Attributes:
        pixels_per_mm: as the header says; 0 if it says nothing.
    """

    def __init__(self, file: Path) -> None:
        """
        Raises:
            InputError: a file that is truncated, of another kind, or whose parts do not fit together.
        """
        self._file = file
        self._end = file.stat().st_size
        with file.open("rb") as stream:
            try:
                self._read(stream)
            except struct.error as error:
                raise InputError(f"{file} is truncated: it ends after {self._end} bytes.") from error

    def _read(self, stream: BinaryIO) -> None:
        stream.seek(len(_MAGIC))
        has_rotations = stream.read(1) == b"R"
        start = len(_MAGIC) + has_rotations
        stream.seek(start)
        common = self._unpack(stream, _COMMON)
        size, version, self.pixels_per_mm = int(common[0]), int(common[1]), float(common[5])
        if version > 1:
            self._number(stream)  # a flag for cosines, which no reader uses
        if version > 2:
            self._skip(stream, self._number(stream, _MAX_TEXT))
        if version > 3:
            if self._number(stream) != 3:
                self._refuse("it has other channels than red, green and blue")
            for _ in range(3):
                self._skip(stream, self._number(stream, _MAX_TEXT))
        if stream.tell() - start != size:
            self._refuse("the length of its header is wrong")
        views, lights = self._angles(stream)
        self.width, self.height = (self._number(stream, _MAX_SIDE) for _ in range(2))
        if not self.width or not self.height:
            self._refuse("its pictures have no pixels")
        if has_rotations:
            self._skip(stream, 36 * self._number(stream, _MAX_DIRECTIONS))
        self._number(stream)  # components, again in each channel
        model = self._number(stream)
        if model not in (_RGB, _LOG_YUV):
            self._refuse(f"its colour model is {model}, and 0 and 11 are known")
        self._is_yuv = model == _LOG_YUV
        self._skip(stream, 12 * 4)  # mean and transform of colours
        rows, columns = len(views) * len(lights), self.width * self.height
        self._channels = [self._channel(stream, rows, columns) for _ in range(3)]
        self.lights, self.views = lights, views
        self._factors = [
            tuple(
                np.memmap(self._file, _SCALARS[c.scalar], "r", place, (count, c.components))
                for place, count in ((c.left, rows), (c.right, columns))
            )
            for c in self._channels
        ]

    def _angles(self, stream: BinaryIO) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Unit vectors of all views, and of the lights of each [n, 3]."""
        count, views, lights = self._number(stream, _MAX_DIRECTIONS), [], None
        for _ in range(count):
            views.append(self._unpack(stream, struct.Struct("<2f")))
            held = self._number(stream, _MAX_DIRECTIONS)
            found = self._unpack(stream, struct.Struct(f"<{2 * held}f"))
            if lights is not None and found != lights:
                self._refuse("its views have different lights")
            lights = found
        if not views or not lights:
            self._refuse("it has no directions")
        pairs = (np.array(views, np.float64), np.array(lights, np.float64).reshape(-1, 2))
        if not all(np.isfinite(part).all() for part in pairs):
            self._refuse("it has a direction that is no finite number")
        of_views, of_lights = (
            _directions(degrees[:, 0], degrees[:, 1], self._file)
            for degrees in (np.degrees(_azimuths(part)) for part in pairs)
        )
        return of_views, of_lights

    def _channel(self, stream: BinaryIO, rows: int, columns: int) -> _Channel:
        scalar = int(self._unpack(stream, struct.Struct("<B"))[0])
        if scalar not in _SCALARS:
            self._refuse(f"its numbers have {scalar} bytes, and 2, 4 and 8 are known")
        components = self._number(stream)
        if not components or (self._number(stream), self._number(stream)) != (rows, columns):
            self._refuse("its factors have other sizes than its pictures")
        self._skip(stream, components * scalar)  # singular values, which are in the right factor
        left = stream.tell()
        self._skip(stream, rows * components * scalar)
        right = stream.tell()
        self._skip(stream, columns * components * scalar)
        return _Channel(components, scalar, left, right)

    def _unpack(self, stream: BinaryIO, form: struct.Struct) -> tuple[float, ...]:
        return form.unpack(stream.read(form.size))

    def _number(self, stream: BinaryIO, most: int = 2**31) -> int:
        value = int(self._unpack(stream, struct.Struct("<I"))[0])
        if value > most:
            self._refuse(f"it holds the number {value}, where at most {most} can be")
        return value

    def _skip(self, stream: BinaryIO, count: int) -> None:
        if stream.tell() + count > self._end:
            raise InputError(f"{self._file} is truncated: it ends after {self._end} bytes.")
        stream.seek(count, os.SEEK_CUR)

    def _refuse(self, why: str) -> None:
        raise InputError(f"{self._file} is no .btf of UBO 2014, or is damaged: {why}.")

    def pixels(
        self,
        lights: NDArray[np.intp],
        views: NDArray[np.intp],
        columns: NDArray[np.intp],
        rows: NDArray[np.intp],
    ) -> NDArray[np.float32]:
        """See `BtfPictures.pixels`."""
        picture, place = views * len(self.lights) + lights, (self.height - 1 - rows) * self.width + columns
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            channels = [
                np.einsum("nk,nk->n", left[picture].astype(np.float32), right[place].astype(np.float32))
                for left, right in self._factors
            ]
            values = np.stack(channels, axis=1)
            if self._is_yuv:
                luminance = np.exp(values[:, :1]) - _LOG_EPSILON
                chroma = values[:, 1:] * luminance + _LOG_EPSILON
                values = np.concatenate([luminance, chroma], axis=1) @ _TO_RGB.T
        if not np.isfinite(values).all():
            self._refuse("it has pixels that are no finite numbers")
        return np.maximum(values, 0).astype(np.float32)


def _azimuths(angles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Polar angles and azimuths [n, 2], radians; azimuths from 0 to 2π, rounding at the horizon undone."""
    polar = np.where(np.abs(angles[:, 0] - math.pi / 2) < 1e-5, math.pi / 2, angles[:, 0])
    return np.stack([polar, angles[:, 1] % (2 * math.pi)], axis=1)
