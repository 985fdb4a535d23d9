"""Images: PNG and JPEG through Pillow, EXR through OpenEXR, HDR; neither a renderer nor LLVM is needed."""

from __future__ import annotations

import io
import os
import re
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import OpenEXR
from numpy.typing import ArrayLike, NDArray
from PIL import ExifTags, Image, ImageOps, UnidentifiedImageError
from PIL.PngImagePlugin import PngInfo

from loomlight.core.colour import linear_to_srgb, srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.files import PIXEL_SUFFIXES, WRITTEN_SUFFIXES, replacing, require_file

_Kind = TypeVar("_Kind", bound=np.generic)

PICTURE_SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".gif")
_JPEG_QUALITY = 93
# Pixels a side of a picture that is read.
MAX_PICTURE_SIDE = 16384
# Pixels converted at once: 100 MB of float64.
_PIXELS_AT_ONCE = 1 << 20
# Pillow's modes of grey of more than 8 bits: whole numbers of 16 or 32, and floats.
_WIDE_MODES = ("I;16", "I;16B", "I;16L", "I;16N", "I", "F")
_MAX_16_BITS = 65535
# Of the streams of output, which all threads share.
_SILENCE = threading.Lock()
_EXR_CHANNELS = {1: "Y", 3: "RGB", 4: "RGBA"}
_LAYER_CHANNELS = {"albedo": "RGB", "normal": "XYZ", "depth": "Z", "roughness": "Y"}


def write_image(path: str | os.PathLike[str], linear: ArrayLike) -> None:
    """Writes linear values [height, width, 1 | 3 | 4]: .exr as float32, as they are; others as 8-bit sRGB.

    Values of uint8 are no linear ones but sRGB already, as drawings and other programs' pictures have them.

    Raises:
        InputError: a suffix that is none of `WRITTEN_SUFFIXES`, or a path that cannot be written.
    """
    values = np.asarray(linear)
    is_encoded = values.dtype == np.uint8
    pixels = np.asarray(srgb_to_linear(values / 255) if is_encoded else values, dtype=np.float32)
    if Path(path).suffix.lower() == ".exr":
        _write_exr(path, {_EXR_CHANNELS[pixels.shape[2]]: pixels})
    else:
        require_pixel_suffix(path, WRITTEN_SUFFIXES)
        write_pixels(path, _without_single_channel(encoded(pixels)))


def write_channels(path: str | os.PathLike[str], channels: dict[str, NDArray[np.float32]]) -> None:
    """Writes named float32 planes [height, width] as one EXR file.

    Raises:
        InputError: a path that cannot be written.
    """
    _write_exr(path, channels)


def write_layers(
    path: str | os.PathLike[str], picture: ArrayLike, layers: Mapping[str, NDArray[np.float32]]
) -> None:
    """Writes linear RGB [height, width, 3] and layers as one EXR file of float32.

    Channels of a layer are named as others name them: albedo.R, normal.X, depth.Z.

    Raises:
        InputError: a path that cannot be written.
    """
    planes = {
        f"{name}.{channel}": plane
        for name, layer in layers.items()
        for channel, plane in zip(_LAYER_CHANNELS[name], np.moveaxis(layer, 2, 0), strict=True)
    }
    write_channels(path, {"RGB": np.asarray(picture, np.float32), **planes})


def _write_exr(path: str | os.PathLike[str], channels: dict[str, NDArray[np.float32]]) -> None:
    planes = {name: np.ascontiguousarray(_without_single_channel(value)) for name, value in channels.items()}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with replacing(path) as temporary:
        try:
            OpenEXR.File(header, planes).write(str(temporary))
        except RuntimeError as error:  # a full disk is no OSError to OpenEXR
            raise InputError(f"{path} cannot be written: is the disk full?") from error


def _without_single_channel(pixels: NDArray[_Kind]) -> NDArray[_Kind]:
    """[height, width] of [height, width, 1]; a side of one pixel stays a side."""
    return pixels[..., 0] if pixels.ndim == 3 and pixels.shape[2] == 1 else pixels


def write_pixels(path: str | os.PathLike[str], pixels: NDArray[np.uint8]) -> None:
    """Writes 8-bit pixels [height, width] or [height, width, 3] as they are, a .png, or a .jpg.

    Raises:
        InputError: another suffix, or a path that cannot be written.
    """
    require_pixel_suffix(path, PIXEL_SUFFIXES)
    with replacing(path) as temporary:
        if Path(path).suffix.lower() == ".png":
            save_png(temporary, pixels)
        else:
            # Chroma of every pixel: threads of two colours are a pixel wide.
            Image.fromarray(pixels).save(temporary, format="JPEG", quality=_JPEG_QUALITY, subsampling=0)


def require_pixel_suffix(path: str | os.PathLike[str], suffixes: Sequence[str]) -> None:
    """Raises InputError unless a picture's path has one of some suffixes."""
    suffix = Path(path).suffix.lower()
    if suffix not in suffixes:
        allowed = " or ".join(suffixes)
        raise InputError(f"{path}: pictures are written as {allowed}, not {suffix or 'without a suffix'}.")


def save_png(
    path: Path,
    pixels: NDArray[Any],
    size_mm: tuple[float, float] | None = None,
    notes: Mapping[str, str] | None = None,
) -> None:
    """Writes unsigned pixels in place: of 8 bits [height, width] or [height, width, 3]; of 16 without colour.

    Args:
        size_mm: width and height of what they show, millimetres, for the header: pixels an inch, and a text
            "size_mm".
        notes: further texts for the header, by their keys.
    """
    header: dict[str, Any] = {}
    if size_mm is not None:
        text = PngInfo()
        text.add_text("size_mm", f"{size_mm[0]:.9g} x {size_mm[1]:.9g}")
        for key, note in (notes or {}).items():
            text.add_text(key, note)
        per_inch = (25.4 * n / side for n, side in zip(pixels.shape[1::-1], size_mm, strict=True))
        header = {"pnginfo": text, "dpi": tuple(per_inch)}
    Image.fromarray(pixels).save(path, format="PNG", **header)


def write_animation(
    path: str | os.PathLike[str], pictures: Sequence[NDArray[np.uint8]], seconds: float
) -> None:
    """Writes 8-bit pictures [height, width, 3] as an endless .gif or .webp that takes `seconds` once round.

    Raises:
        InputError: a path that cannot be written.
    """
    frames = [Image.fromarray(pixels) for pixels in pictures]
    with replacing(path) as temporary:
        frames[0].save(
            temporary,
            format=Path(path).suffix[1:].upper(),
            save_all=True,
            append_images=frames[1:],
            duration=max(round(1000 * seconds / len(frames)), 20),
            loop=0,
        )


def encoded(linear: ArrayLike) -> NDArray[np.uint8]:
    """Linear RGB [height, width, 3] as 8-bit sRGB, clipped."""
    pixels = np.nan_to_num(np.asarray(linear, dtype=np.float32)[..., :3])
    return np.rint(linear_to_srgb(pixels) * 255).astype(np.uint8)


def read_linear(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of an .exr or .hdr as it is, or of a PNG, JPEG …, decoded, on black.

    Raises:
        InputError: no such file, no picture, or values that are not finite.
    """
    require_file(path)
    suffix = Path(path).suffix.lower()
    if suffix == ".exr":
        linear = _read_exr(path)
    elif suffix == ".hdr":
        linear = read_rgbe(path)
    else:
        linear = srgb_to_linear(read_picture(path, background=0)).astype(np.float32)
    if not np.isfinite(linear).all():
        raise InputError(f"{path} holds pixels that are no finite numbers; replace them in a picture editor.")
    return linear


@contextmanager
def opened_exr(path: str | os.PathLike[str]) -> Iterator[OpenEXR.File]:
    """An .exr that is read; its parts have at most 16384 pixels a side.

    Raises:
        InputError: it has more.
        RuntimeError, ValueError, TypeError: what OpenEXR raises of a damaged one.
    """
    with _silenced(), OpenEXR.File(str(path), header_only=True) as head:
        windows = [part.header["dataWindow"] for part in head.parts]
    for first, last in windows:
        width, height = (int(b) - int(a) + 1 for a, b in zip(first, last, strict=True))
        _require_size(path, width, height)
    with _silenced():
        opened = OpenEXR.File(str(path), separate_channels=True)
    with opened as file:
        yield file


@contextmanager
def _silenced() -> Iterator[None]:
    """Leaves out what OpenEXR prints of damage, beside the error that it raises."""
    with _SILENCE, redirect_stdout(io.StringIO()), Path(os.devnull).open("w") as nowhere:
        kept = os.dup(2)
        os.dup2(nowhere.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)


def _read_exr(path: str | os.PathLike[str], any_channel: bool = False) -> NDArray[np.float32]:
    """Channels R, G, B of an .exr [height, width, 3], else Y three times; else any one where that will do."""
    require_file(path)
    try:
        with opened_exr(path) as file:
            planes = {name: np.array(channel.pixels) for name, channel in file.channels().items()}
    except (RuntimeError, ValueError, TypeError) as error:
        raise InputError(f"{path} is no EXR file that can be read.") from error
    names = tuple("RGB" if set("RGB") <= set(planes) else "YYY")
    if any_channel and names[0] not in planes:
        names = (sorted(planes)[0],)
    if names[0] not in planes:
        raise InputError(f"{path} has neither channels R, G, B nor Y; it has {', '.join(sorted(planes))}.")
    return np.stack([planes[name] for name in names], axis=-1).astype(np.float32)


def picture_size(path: str | os.PathLike[str]) -> tuple[int, int]:
    """Width and height in pixels of a PNG, JPEG, TIFF, BMP or GIF as stored, from the head of the file alone.

    Raises:
        InputError: no such file, or no picture.
    """
    with _opened(path) as picture:
        return picture.size


def require_picture_size(path: str | os.PathLike[str]) -> None:
    """Raises InputError if a picture has more than 16384 pixels a side; reads its head alone."""
    _require_size(path, *picture_size(path))


def _require_size(path: str | os.PathLike[str], width: int, height: int) -> None:
    if max(width, height) > MAX_PICTURE_SIDE:
        raise InputError(
            f"{path} has {width} x {height} pixels; at most {MAX_PICTURE_SIDE} a side can be read."
        )


def read_picture(path: str | os.PathLike[str], background: float = 1) -> NDArray[np.float64]:
    """sRGB-encoded values [height, width, 3] in [0, 1] of a PNG, JPEG, TIFF, BMP or GIF, upright.

    Args:
        background: what is seen through transparent pixels: 1 is white, 0 black.

    Raises:
        InputError: no such file, no picture, more than 16384 pixels a side, or numbers beyond 16 bits or
            floats beyond 0 to 1.
    """
    return np.concatenate(list(read_picture_rows(path, background)))


def read_map(path: str | os.PathLike[str], channels: int) -> NDArray[np.float32]:
    """Numbers of a picture as they are stored [height, width, channels], such as a height map.

    Of 8 and 16 bits, 0 to 1; of .exr and of TIFF's floats, any. Colours are averaged for `channels` = 1, and
    grey is repeated for 3.

    Raises:
        InputError: no such file, no picture, or more than 16384 pixels a side.
    """
    if Path(path).suffix.lower() == ".exr":
        pixels: NDArray[np.floating] = _read_exr(path, any_channel=True)
    else:
        with _opened(path) as picture:
            _require_size(path, *picture.size)
            upright = _upright(picture)
            if upright.mode in _WIDE_MODES:
                pixels = _wide_grey(upright, path)[..., None]
            else:
                kept = "L" if upright.mode in ("1", "L", "LA") else "RGB"
                pixels = np.asarray(upright.convert(kept), np.float32) / 255
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    if pixels.shape[2] >= 3:
        pixels = pixels[..., :3] if channels == 3 else pixels[..., :3].mean(axis=2, keepdims=True)
    else:
        pixels = np.repeat(pixels[..., :1], channels, axis=2)
    return np.ascontiguousarray(pixels, np.float32)


def read_picture_rows(path: str | os.PathLike[str], background: float = 1) -> Iterator[NDArray[np.float64]]:
    """The same in parts of some rows [rows, width, 3], from the top, for pictures of many pixels.

    Raises:
        InputError: as `read_picture`.
    """
    with _opened(path) as picture:
        width, height = picture.size
        _require_size(path, width, height)
        upright = _upright(picture)
        width, height = upright.size
        step = max(1, _PIXELS_AT_ONCE // width)
        for top in range(0, height, step):
            part = upright.crop((0, top, width, min(top + step, height)))
            if part.mode in _WIDE_MODES:
                yield _between_0_and_1(_wide_grey(part, path), path)[..., None].repeat(3, axis=2)
                continue
            pixels = np.asarray(part.convert("RGBA"))
            colours, opacity = pixels[..., :3] / 255, pixels[..., 3:]
            # A drawdown of 4096 by 4096 threads would wait seconds for what changes nothing.
            opaque = (opacity == 255).all()
            yield colours if opaque else colours * (opacity / 255) + background * (1 - opacity / 255)


def is_turned(path: str | os.PathLike[str]) -> bool:
    """Whether a picture's file says that its rows are not shown from the top (EXIF orientation)."""
    with _opened(path) as picture:
        return picture.getexif().get(ExifTags.Base.Orientation, 1) != 1


def _upright(picture: Image.Image) -> Image.Image:
    """The picture as viewers show it. Pillow turns TIFF when it loads it, and nothing else by itself."""
    picture.load()
    return ImageOps.exif_transpose(picture)


def _wide_grey(picture: Image.Image, path: str | os.PathLike[str]) -> NDArray[np.float64]:
    """Grey values [height, width] of more than 8 bits, which Pillow's conversions would clip to 8.

    Whole numbers of 16 bits become 0 to 1; floats stay as they are.

    Raises:
        InputError: whole numbers that 16 bits do not hold.
    """
    values = np.asarray(picture, np.float64)
    if picture.mode == "F":
        return values
    if values.min() < 0 or values.max() > _MAX_16_BITS:
        raise InputError(f"{path} holds whole numbers of 32 bits; save it with 8 or 16 bits a channel.")
    return values / _MAX_16_BITS


def _between_0_and_1(values: NDArray[np.float64], path: str | os.PathLike[str]) -> NDArray[np.float64]:
    if not ((values >= 0) & (values <= 1)).all():  # nor is NaN
        raise InputError(
            f"{path} holds floats that are not between 0 and 1; save it with 8 or 16 bits a channel."
        )
    return values


@contextmanager
def _opened(path: str | os.PathLike[str]) -> Iterator[Image.Image]:
    """A picture that Pillow has opened; its faults become InputErrors."""
    require_file(path)
    try:
        # By an open file: of a name, Pillow maps TIFF into memory, and garbles what is to be turned.
        with _without_pillow_limit(), Path(path).open("rb") as file, Image.open(file) as picture:
            yield picture
    except PermissionError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}.") from error
    except MemoryError as error:
        raise InputError(f"{path} has more pixels than there is memory for.") from error
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError) as error:
        raise InputError(
            f"{path} is no picture that can be read (PNG, JPEG, WebP, TIFF, BMP and GIF can)."
        ) from error


@contextmanager
def _without_pillow_limit() -> Iterator[None]:
    """Lifts Pillow's bound on pixels, whose message names no size; ours does. Silences its warnings."""
    bound = Image.MAX_IMAGE_PIXELS
    Image.MAX_IMAGE_PIXELS = None
    try:
        with warnings.catch_warnings():
            # Of damaged tags that matter to no pixel; those that do end in an error.
            warnings.filterwarnings("ignore", module="PIL")
            yield
    finally:
        Image.MAX_IMAGE_PIXELS = bound


# ------------------------------------------------------------------------------------------ radiance pictures
# Radiance pictures (.hdr): three mantissas with one exponent a pixel (Ward 1991), often run-length coded.
#
# Their components are RGB, or CIE XYZ where the line FORMAT says "xyze".


_SIZE = re.compile(rb"-Y (\d+) \+X (\d+)\n")
_FORMAT = re.compile(rb"^FORMAT=(\S+)", re.MULTILINE)
_RGB, _XYZ = b"32-bit_rle_rgbe", b"32-bit_rle_xyze"
# Chromaticities x, y of Radiance's primaries; its white is that of equal energy, so that X = Y = Z is grey
# (Ward, Radiance file formats, "color.h").
_PRIMARIES = np.array([[0.640, 0.330], [0.290, 0.600], [0.150, 0.060]])
# Widths between these are run-length coded, row by row.
_MIN_CODED, _MAX_CODED = 8, 32767


def read_rgbe(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a Radiance picture.

    Raises:
        InputError: no Radiance picture, one that ends early, or one of a FORMAT that is neither RGB nor XYZ.
    """
    data = Path(path).read_bytes()
    size = _SIZE.search(data, 0, 4096)
    if not data.startswith(b"#?") or size is None:
        raise InputError(f"{path} is no Radiance picture (.hdr) with rows from the top.")
    height, width = int(size[1]), int(size[2])
    # A row takes at least four bytes, so a damaged size cannot ask for much more than the file has.
    if width == 0 or height == 0 or height > len(data):
        raise InputError(f"{path} has {width} x {height} pixels, which its data do not hold.")
    pixels = np.zeros((height, width, 4), np.uint8)
    try:
        _read_rows(data, size.end(), pixels)
    except (IndexError, ValueError) as error:
        raise InputError(f"{path} is damaged: its data end early.") from error
    # A pixel is mantissa · 2^(exponent − 136); an exponent of 0 is black.
    scale = np.where(pixels[..., 3:] > 0, np.exp2(np.float32(pixels[..., 3:]) - 136), 0)
    values = (pixels[..., :3] * scale).astype(np.float32)
    form = _FORMAT.search(data, 0, size.start())
    if form is None or form[1] == _RGB:
        return values
    if form[1] == _XYZ:
        return values @ np.linalg.inv(_rgb_to_xyz()).T.astype(np.float32)
    shown = form[1][:40].decode("ascii", "replace")
    raise InputError(f"{path} has FORMAT={shown}; {_RGB.decode()} and {_XYZ.decode()} are read.")


def _rgb_to_xyz() -> NDArray[np.float64]:
    """The matrix [3, 3] of Radiance's primaries, scaled so that RGB of 1, 1, 1 is XYZ of 1, 1, 1."""
    columns = np.column_stack([_PRIMARIES, 1 - _PRIMARIES.sum(axis=1)]).T
    return columns * np.linalg.solve(columns, np.ones(3))


def _read_rows(data: bytes, at: int, pixels: NDArray[np.uint8]) -> None:
    width = pixels.shape[1]
    for row in pixels:
        coded = _MIN_CODED <= width <= _MAX_CODED and data[at : at + 2] == b"\x02\x02"
        if not coded:
            row[:] = np.frombuffer(data, np.uint8, 4 * width, at).reshape(width, 4)
            at += 4 * width
            continue
        at += 4
        for channel in range(4):
            at = _read_runs(data, at, row[:, channel])


def _read_runs(data: bytes, at: int, values: NDArray[np.uint8]) -> int:
    """Fills one channel of a row; where its code ends."""
    place = 0
    while place < len(values):
        count = data[at]
        if count > 128:  # so many times one value
            count -= 128
            values[place : place + count] = data[at + 1]
            at += 2
        else:
            values[place : place + count] = np.frombuffer(data, np.uint8, count, at + 1)
            at += 1 + count
        if count == 0:
            raise ValueError("a run of no pixels")
        place += count
    return at


# -------------------------------------------------------------------------------------- pictures in notebooks
# Pictures that show themselves in notebooks.


_Drawn = TypeVar("_Drawn")
# How a value of a type is drawn, [height, width, 3]: drawings stand above what they draw.
_DRAWINGS: dict[type, Callable[[Any], NDArray[np.uint8]]] = {}


class Picture(np.ndarray[Any, np.dtype[np.float32]]):
    """Linear RGB [height, width, 3], float32: a NumPy array that notebooks display.

    Attributes:
        layers: what else the camera saw, by the names of the setting `aov`: [height, width, 3], of depth
            and roughness [height, width, 1].
    """

    layers: dict[str, NDArray[np.float32]]

    def __array_finalize__(self, _: object) -> None:
        """Without layers at first, as what is computed from a picture."""
        self.layers = {}

    def _repr_png_(self) -> bytes | None:
        """The picture in sRGB as PNG; None of what is sliced out of one and is no picture any more."""
        is_picture = self.ndim == 3 and self.shape[2] == 3 and self.size > 0
        return png_bytes(encoded(self)) if is_picture else None


def write_picture(path: str | os.PathLike[str], picture: Picture) -> None:
    """Writes a picture, with its layers if it has any; see `write_image` and `write_layers`.

    Raises:
        InputError: a suffix that is none of `WRITTEN_SUFFIXES`, or a path that cannot be written.
    """
    if picture.layers:
        write_layers(path, picture, picture.layers)
    else:
        write_image(path, picture)


def draw_by(kind: type[_Drawn], drawing: Callable[[_Drawn], NDArray[np.uint8]]) -> None:
    """Lets values of a type show themselves in notebooks by a drawing, sRGB pixels [height, width, 3]."""
    _DRAWINGS[kind] = drawing


def drawn_png(value: object) -> bytes | None:
    """The drawing of a value as PNG; None of a type that nothing draws."""
    drawing = _DRAWINGS.get(type(value))
    return None if drawing is None else png_bytes(drawing(value))


def png_bytes(pixels: NDArray[np.uint8]) -> bytes:
    """8-bit pixels [height, width] or [height, width, 3] as the content of a PNG file."""
    content = io.BytesIO()
    Image.fromarray(pixels).save(content, format="PNG")
    return content.getvalue()
