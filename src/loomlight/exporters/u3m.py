"""A fabric as U3M 1.1, which CLO, Browzwear, KeyShot and Vizoo read: both faces, and what it weighs.

Maps are of whole repeats. They show a face as seen from its own side: the back is the cloth turned over about
its upright axis. Heights of displacement are millimetres; the rotation of anisotropy counts turns from x
towards y.
"""

from __future__ import annotations

import hashlib
import io
import json
import re
import uuid
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError
from loomlight.exporters.fit import TEXEL_FIELDS, FittedMaterial, fit_texels
from loomlight.exporters.gltf import eight_bits
from loomlight.exporters.materials import facts
from loomlight.exporters.standards import (
    PRINCIPLED_RATIO,
    PRINCIPLED_SPECULAR,
    Numbers,
    StandardMaterial,
    evaluate_principled,
)
from loomlight.exporters.texels import TexelGrid, tile_repeats
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.facts import cloth_facts
from loomlight.models.registry import make_model
from loomlight.realtime.materials import Material, fabric_for, source_of
from loomlight.sources.u3m import U3mMaterial
from loomlight.sources.u3m_file import U3mFile, write_u3m_folder, write_u3ma

DEFAULT_DPI, MIN_DPI, MAX_DPI = 300.0, 30.0, 2400.0
_INCH_MM = 25.4
# Texels a side: fewer would not hold the chosen resolution, as a repeat is a whole number of them.
_MIN_SIDE, _MAX_SIDE = 256, 8192
# Of all texels, which take 200 bytes each while they are made.
_MAX_TEXELS = 1 << 23
_PREVIEW = 256
# Names of U3M for the fibre of each kind of yarn.
_FIBRES = {
    "cotton": "Cotton",
    "combed cotton": "Cotton",
    "open-end cotton": "Cotton",
    "mercerised cotton": "Cotton",
    "linen": "Linen",
    "wool": "Wool",
    "woollen": "Wool",
    "worsted": "Wool",
    "silk": "Silk",
    "dupion silk": "Silk",
    "filament polyester": "Polyester",
    "viscose": "Rayon",
}


def u3m_of(fabric: Fabric, model: str, dpi: float) -> tuple[U3mFile, dict[str, object]]:
    """A fabric's U3M, and what the manifest says of it.

    Args:
        model: whose look is fitted.
        dpi: texels an inch, 30 to 2400.

    Raises:
        InputError: a resolution out of range, too many texels, or the model does not take the fabric.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    columns, rows, repeats = u3m_grid(fabric, dpi)
    shown = make_model(model, fabric)
    name = file_name(fabric.name)
    files: dict[str, bytes] = {}
    faces: dict[str, Any] = {}
    said: dict[str, object] = {}
    for face in ("front", "back"):
        grid = TexelGrid(fabric, columns, rows, repeats, back=face == "back")
        material = fit_texels(fabric, shown, grid, "principled")
        maps = _Maps(f"textures/{name}_{face}_", material, turned=face == "back")
        faces[face] = _visual(maps, material)
        files |= maps.files
        said[face] = facts(material)
    document = _document(fabric, faces)
    # Of the same content, the same material: programs find it again by its id.
    content = hashlib.sha256(json.dumps(document, sort_keys=True).encode())
    for each in files.values():
        content.update(each)
    now = datetime.now(UTC).isoformat(timespec="seconds")
    identity = f"{{{uuid.UUID(bytes=content.digest()[:16], version=4)}}}"
    document["material"] |= {"id": identity, "created": now, "modified": now}
    return U3mFile(name, document, files), said


def u3m_grid(fabric: Fabric, dpi: float) -> tuple[int, int, tuple[int, int]]:
    """Columns and rows of texels, and the repeats across and up that they hold.

    Raises:
        InputError: a resolution out of range, or too many texels.
    """
    if not MIN_DPI <= dpi <= MAX_DPI:
        raise InputError(f"--dpi {dpi:g} is out of range: write texels an inch, {MIN_DPI:g} to {MAX_DPI:g}.")
    texels = [side * dpi / _INCH_MM for side in fabric.layout().size]
    least = tile_repeats(fabric, _INCH_MM / dpi)
    counts = [max(few, int(np.ceil(_MIN_SIDE / each))) for few, each in zip(least, texels, strict=True)]
    columns, rows = (max(1, round(each * count)) for each, count in zip(texels, counts, strict=True))
    if max(columns, rows) > _MAX_SIDE or columns * rows > _MAX_TEXELS:
        factor = max(max(columns, rows) / _MAX_SIDE, (columns * rows / _MAX_TEXELS) ** 0.5)
        raise InputError(
            f"A whole repeat at {dpi:g} dpi has {columns} × {rows} texels, more than {_MAX_SIDE} a side or "
            f"{_MAX_TEXELS >> 20} million: write --dpi {max(1, int(dpi / factor))} or less."
        )
    return columns, rows, (counts[0], counts[1])


def file_name(name: str) -> str:
    """The name of a fabric as that of a file on any system."""
    return re.sub(r"[^0-9A-Za-z_-]+", "-", name).strip("-")[:60] or "cloth"


# ------------------------------------------------------------------------------------------------------- maps


class _Maps:
    """Pictures of one face, as files and as U3M's fields that name them."""

    def __init__(self, prefix: str, material: FittedMaterial, turned: bool) -> None:
        self.files: dict[str, bytes] = {}
        self._prefix, self.turned, self._size = prefix, turned, material.size

    def color(self, name: str, linear: Numbers) -> dict[str, Any]:
        """`texture_and_color` of linear RGB [rows, columns, 3]."""
        image = self._image(name, linear_to_srgb(np.clip(linear, 0, 1)))
        return {
            "constant": _rgb(linear_to_srgb(np.clip(linear.mean((0, 1)), 0, 1))),
            "texture": {"mode": "multiply", "factor": _rgb(np.ones(3)), "image": image},
        }

    def number(self, name: str, values: Numbers, low: float = 0.0, high: float = 1.0) -> dict[str, Any]:
        """`texture_and_number` of values [rows, columns]; a constant where all are alike."""
        constant = round(float(values.mean()), 6)
        span = high - low
        if span <= 0 or np.ptp(values) < span / 510:
            return {"constant": constant, "texture": None}
        pixels = np.repeat(((values - low) / span)[..., None], 3, axis=-1)
        image = self._image(name, pixels)
        return {"constant": constant, "texture": {"factor": span, "offset": low, "image": image}}

    def normal(self, name: str, normal: Numbers) -> dict[str, Any]:
        """`texture_and_normal` of unit vectors [rows, columns, 3]."""
        image = self._image(name, 0.5 + 0.5 * normal * ([-1, 1, 1] if self.turned else [1, 1, 1]))
        return {"constant": {"x": 0, "y": 0, "z": 1}, "texture": {"scale": 1, "image": image}}

    def preview(self, material: FittedMaterial) -> dict[str, Any]:
        """`preview_image`: the cloth from above, under a light from the upper left."""
        side = min(_PREVIEW, *material.cover.shape)
        path = self._add("preview", _lit(material, side, 0.45 if self.turned else -0.45))
        rows, columns = material.cover.shape
        width, height = (
            length * side / texels for length, texels in zip(self._size, (columns, rows), strict=True)
        )
        return {"path": path, "width": width, "height": height, "dpi": _dpi(side, side, width, height)}

    def _image(self, name: str, values: Numbers) -> dict[str, Any]:
        rows, columns = values.shape[:2]
        width, height = self._size
        return {
            "path": self._add(name, values),
            "width": width,
            "height": height,
            "dpi": _dpi(columns, rows, width, height),
            "repeat": {"mode": "normal", "rotation": 0},
        }

    def _add(self, name: str, values: Numbers) -> str:
        path = f"{self._prefix}{name}.png"
        self.files[path] = png_of(eight_bits(values[:, ::-1] if self.turned else values), self._size)
        return path


def png_of(pixels: NDArray[np.uint8], size: tuple[float, float]) -> bytes:
    """A PNG of 8-bit RGB, with its resolution."""
    stream = io.BytesIO()
    rows, columns = pixels.shape[:2]
    dpi = _dpi(columns, rows, *size)
    Image.fromarray(pixels).save(stream, format="png", dpi=(dpi["x"], dpi["y"]))
    return stream.getvalue()


def _dpi(columns: int, rows: int, width: float, height: float) -> dict[str, float]:
    return {"x": _INCH_MM * columns / width, "y": _INCH_MM * rows / height}


def _rgb(color: Numbers) -> dict[str, float]:
    return {name: round(float(np.clip(value, 0, 1)), 6) for name, value in zip("rgb", color, strict=True)}


def _lit(material: FittedMaterial, side: int, light_x: float) -> Numbers:
    """sRGB values [side, side, 3] of a corner of the cloth, on white, half lit by the sky."""
    flat = {
        name: getattr(material, name)[:side, :side].reshape(side * side, *getattr(material, name).shape[2:])
        for name in TEXEL_FIELDS
    }
    part = StandardMaterial(
        **flat, weight=material.weight, sheen=material.sheen, sheen_roughness=material.sheen_roughness
    )
    light = np.array([light_x, 0.45, 0.77]) / np.linalg.norm([light_x, 0.45, 0.77])
    count = side * side
    direct = evaluate_principled(part, np.tile(light, (count, 1)), np.tile([0.0, 0, 1], (count, 1)))
    linear = 0.5 * np.pi / light[2] * direct + 0.4 * flat["base"]
    cover = material.cover[:side, :side, None]
    return np.asarray(linear_to_srgb(np.clip(cover * linear.reshape(side, side, 3) + 1 - cover, 0, 1)))


# --------------------------------------------------------------------------------------------------- document


def _visual(maps: _Maps, material: FittedMaterial) -> dict[str, Any]:
    """`visualisation` of a face; what cloth has not stands at U3M's defaults."""
    ratio = material.alpha_y / material.alpha_x
    x, y = (material.direction[..., axis] for axis in (0, 1))
    # Directions have no sign: half a turn holds all.
    turn = (np.arctan2(y, -x if maps.turned else x) / (2 * np.pi)) % 0.5
    low, high = float(material.height.min()), float(material.height.max())
    f0 = float(material.specular.mean())
    root = f0**0.5
    return {
        "shader": "principled",
        "basecolor": maps.color("base", material.base),
        "alpha": maps.number("alpha", material.cover),
        "normal": maps.normal("normal", material.normal),
        "displacement": maps.number("displacement", material.height, low, high),
        "roughness": maps.number("roughness", (material.alpha_x * material.alpha_y) ** 0.25),
        "anisotropy_value": maps.number("anisotropy", np.clip((1 - ratio) / (1 - PRINCIPLED_RATIO), 0, 1)),
        "anisotropy_rotation": maps.number("rotation", turn),
        "metalness": _constant(0),
        "specular_value": maps.number("specular", material.specular[..., 0] / PRINCIPLED_SPECULAR),
        "specular_tint": _constant(0),
        "ior": _constant(round((1 + root) / (1 - root), 4)),
        "sheen_value": _constant(round(float(material.sheen.max()), 4)),
        "sheen_tint": _constant(0),
        "transmission": maps.number("transmission", material.transmission),
        "clearcoat_value": _constant(0),
        "clearcoat_normal": {"constant": {"x": 0, "y": 0, "z": 1}, "texture": None},
        "clearcoat_roughness": _constant(0),
        "subsurface_value": _constant(0),
        "subsurface_radius": _constant(0),
        "subsurface_color": {"constant": _rgb(np.ones(3)), "texture": None},
        "preview": maps.preview(material),
    }


def _constant(value: float) -> dict[str, Any]:
    return {"constant": value, "texture": None}


def _document(fabric: Fabric, faces: dict[str, Any]) -> dict[str, Any]:
    width, height = fabric.repeat_mm
    return {
        "schema": "1.1",
        "custom": None,
        "material": {
            "name": fabric.name or "cloth",
            "description": f"Woven cloth by loomlight; one repeat is {width:.4g} x {height:.4g} mm.",
            "front": faces["front"],
            "back": faces["back"],
            "side": None,
            "physics": _physics(fabric),
            "metadata": None,
        },
    }


def _physics(fabric: Fabric) -> dict[str, Any]:
    """Weight and thickness as `loomlight weave info` says them, and what the cloth consists of."""
    found = cloth_facts(fabric)
    return {
        "thickness": float(f"{found.thickness_mm:.3g}"),
        "weight": float(f"{found.weight:.3g}"),
        "devices": {"fab": "null"},
        "composition": {"parts": composition(fabric)},
        "material_type": {"type": "Woven", "name": None},
        "construction": {"type": construction(fabric.named_draft.drawdown), "name": None},
    }


def composition(fabric: Fabric) -> list[dict[str, Any]]:
    """Shares of the cloth's mass by fibre, the largest first; they add up to 1."""
    found = cloth_facts(fabric)
    masses: dict[str, float] = {}
    for name in ("warp", "weft"):
        family = getattr(found, name)
        yarn = getattr(fabric.fields, name).yarn or fabric.fields.yarn
        fibre = _FIBRES.get(yarn or "", "unknown")
        masses[fibre] = masses.get(fibre, 0.0) + family.per_cm * family.tex * (1 + family.crimp)
    order = sorted(masses, key=lambda fibre: -masses[fibre])
    shares = [round(masses[fibre] / sum(masses.values()), 3) for fibre in order]
    shares[0] = round(1 - sum(shares[1:]), 3)
    return [{"ratio": share, "type": fibre, "name": None} for fibre, share in zip(order, shares, strict=True)]


def construction(drawdown: NDArray[np.bool_]) -> str:
    """U3M's name of a weave [picks, ends]: plain, a twill with its hand, a satin, else "unknown"."""
    ends = drawdown.shape[1]
    # Each pick is the one before, so many ends further.
    moves = [
        move
        for move in range(1, ends)
        if (np.roll(drawdown, move, axis=1) == np.roll(drawdown, -1, axis=0)).all()
    ]
    if not moves:
        return "unknown"
    if ends == 2:
        return "Plain weave"
    if moves[0] in (1, ends - 1):
        return f"Twill - {'right hand (Z)' if moves[0] == 1 else 'left hand (S)'}"
    return "Satin" if drawdown[0].sum() in (1, ends - 1) else "unknown"


# ------------------------------------------------------------------------------------------------------ write


def write_u3m(folder: Path, material: Material, model: str, dpi: float | None) -> dict[str, object]:
    """Writes NAME.u3m and its pictures into a folder, and returns what the manifest says."""
    made, said = _made(material, model, dpi)
    return {"files": write_u3m_folder(folder, made)} | said


def write_u3m_archive(path: Path, material: Material, model: str, dpi: float | None) -> dict[str, object]:
    """Writes a `.u3ma`, and returns what a manifest would say."""
    made, said = _made(material, model, dpi)
    write_u3ma(path, made)
    return said


def _made(material: Material, model: str, dpi: float | None) -> tuple[U3mFile, dict[str, object]]:
    """The U3M of a fabric; one that was read stays as it is, with all that others wrote into it."""
    source = source_of(material)
    if not isinstance(source, U3mMaterial):
        return u3m_of(fabric_for(material, model), model, DEFAULT_DPI if dpi is None else dpi)
    if dpi is not None:
        raise InputError(f"{source.name} is a U3M, whose pictures stay as they are: leave out --dpi.")
    return source.file, {}
