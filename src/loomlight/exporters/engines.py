"""Packs of textures as engines want them: Unreal, Unity, Godot and three.js, each with its settings.

A pack has two texel densities, of sides that are powers of two: `near` for close views, `far` for one
distance. Each is a fit of its own: what far texels average away is in their roughness.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.llvm import require_llvm
from loomlight.exporters.fit import FittedMaterial, fit_material
from loomlight.exporters.garment import GarmentCloth, file_name
from loomlight.exporters.gltf import eight_bits, material_textures, peak_of, png_bytes
from loomlight.exporters.materials import PIXEL
from loomlight.exporters.metal_rough import ENGINES_RISE, MetalRough, metal_rough
from loomlight.exporters.standards import DIELECTRIC
from loomlight.exporters.texels import TextureSize, texture_grid
from loomlight.fabric.fabric import Fabric
from loomlight.models.registry import make_model

Picture = NDArray[np.uint8]
# What `far` textures are made for where nobody says, metres.
FAR_METRES = 1.0
_FILES = Path(__file__).parent / "engine_files"
# Sides of textures.
_MIN_SIDE, _MAX_SIDE = 16, 4096
# What Unreal's and Godot's `specular` of 0.5 stands for, and how it grows: F0 is 0.08 s, or 0.16 s².
_UNREAL_SPECULAR, _GODOT_SPECULAR = 0.08, 0.16
# Godot's α across over α along the direction in which highlights are wide is 1 − 0.9 times its anisotropy.
_GODOT_ANISOTROPY = 0.9


@dataclass(frozen=True, eq=False)
class Density:
    """A fit of one texel density.

    Attributes:
        label: near or far.
        metres: the distance that it is made for; None of close views.
        cloth: the fabric and the fit.
        simple: the same as every engine knows it.
        opaque: whether holes are left out, in both densities of a pack alike.
    """

    label: str
    metres: float | None
    cloth: GarmentCloth
    simple: MetalRough
    opaque: bool

    @property
    def texels(self) -> tuple[int, int]:
        """Columns and rows."""
        rows, columns = self.cloth.material.cover.shape
        return columns, rows

    @property
    def texel_mm(self) -> tuple[float, float]:
        """Width and height of a texel."""
        (width, height), (columns, rows) = self.cloth.material.size, self.texels
        return width / columns, height / rows

    @property
    def words(self) -> dict[str, object]:
        """What instructions say of it, by names that begin with its label."""
        (width, height), (columns, rows) = self.cloth.material.size, self.texels
        said = {
            "texels": f"{columns} × {rows}",
            "mm": "{:.3g} × {:.3g}".format(*self.texel_mm),
            "size": f"{width:.4g} × {height:.4g}",
            "width": f"{width:.6g}",
            "height": f"{height:.6g}",
            "across": f"{1000 / width:.4f}",
            "up": f"{1000 / height:.4f}",
        }
        return {f"{self.label}_{key}": value for key, value in said.items()}

    @cached_property
    def standard(self) -> dict[str, Picture]:
        """Textures of the fit as glTF and three.js read them, by what they hold."""
        return material_textures(self.cloth.reflecting())

    def orm(self) -> Picture:
        """Occlusion, roughness and metal, as glTF and Unreal pack them."""
        rough = self.simple.roughness
        return eight_bits(np.stack([np.ones_like(rough), rough, np.zeros_like(rough)], axis=-1))


@dataclass(frozen=True, eq=False)
class Pack:
    """What is written for an engine.

    Attributes:
        name: of the fabric, without quotes and backslashes.
        key: the same for files, in lower-case letters, digits and hyphens.
        densities: near and far.
    """

    name: str
    key: str
    densities: tuple[Density, Density]

    @property
    def switch_metres(self) -> float:
        """Up to where `near` is the better one: halfway, by ratio, between the distances of both.

        That of `near` is where its texels are pixels of a picture of 1080 rows.
        """
        near = max(self.densities[0].texel_mm) / 1000 / PIXEL
        return math.sqrt(near * (self.densities[1].metres or FAR_METRES))

    @property
    def words(self) -> dict[str, object]:
        """What instructions say of it."""
        near, far = self.densities
        reflectance = near.simple.reflectance
        grey = round(255 * float(linear_to_srgb(np.array(reflectance))))
        return {
            **near.words,
            **far.words,
            "name": self.name,
            "key": self.key,
            "title": self.title,
            "far_metres": f"{far.metres:g}",
            "switch": f"{self.switch_metres:.2g}",
            "reflectance": f"{100 * reflectance:.1f}",
            "grey": f"#{grey:02x}{grey:02x}{grey:02x}",
            "unreal_specular": f"{reflectance / _UNREAL_SPECULAR:.3f}",
            "godot_specular": f"{math.sqrt(reflectance / _GODOT_SPECULAR):.3f}",
            "holes": "no visible holes" if near.opaque else "holes, in the alpha of its colour",
        }

    @property
    def title(self) -> str:
        """The name as names of assets are written: HarrisTweed."""
        return "".join(word[:1].upper() + word[1:] for word in self.key.split("-"))


def _pack(fabric: Fabric, model: str, distance: float | None) -> Pack:
    """The fits of both densities.

    Args:
        distance: of `far`, metres; None is 1.

    Raises:
        InputError: the model does not take the fabric, or the textures are too large.
    """
    require_llvm()
    baked, metres = make_model(model, fabric), FAR_METRES if distance is None else distance
    # Names stand in texts of several languages.
    name = " ".join(re.sub(r'["\\{}]', " ", fabric.name).split()) or "Cloth"
    key = file_name(fabric.name) or "cloth"
    found: list[Density] = []
    for label, at in (("near", None), ("far", metres)):
        size = texture_grid(fabric, None if at is None else 1000 * at * PIXEL)
        rounded = TextureSize(power_of_two(size.columns), power_of_two(size.rows), size.repeats)
        fit = fit_material(fabric, baked, rounded)
        cloth = GarmentCloth(name, key, fit)
        opaque = found[0].opaque if found else cloth.is_opaque
        found.append(Density(label, at, cloth, metal_rough(fit, ENGINES_RISE), opaque))
    return Pack(name, key, (found[0], found[1]))


def power_of_two(side: int) -> int:
    """The nearest power of two, by ratio, from 16 to 4096."""
    nearest = int(2 ** round(math.log2(max(side, 1))))
    return min(max(nearest, _MIN_SIDE), _MAX_SIDE)


def _write_textures(
    folder: Path, pack: Pack, textures_of: Callable[[Density], Mapping[str, Picture]]
) -> list[str]:
    """Writes LABEL/NAME.png of each density into new folders, and returns these paths.

    Args:
        textures_of: the textures of a density by their names.
    """
    names = []
    for each in pack.densities:
        (folder / each.label).mkdir(parents=True)
        for name, pixels in textures_of(each).items():
            path = f"{each.label}/{name}.png"
            (folder / path).write_bytes(png_bytes(pixels))
            names.append(path)
    return names


def _fill(template: str, words: Mapping[str, object]) -> str:
    """The text of a file of `engine_files`, with {{words}} filled in."""
    text = (_FILES / template).read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: str(words[found[1]]), text)


def _facts(pack: Pack, names: list[str]) -> dict[str, object]:
    return {
        "files": names,
        "densities": {
            each.label: {
                "distance_m": each.metres,
                "repeat_mm": [*each.cloth.material.size],
                "texels": [*each.texels],
                "texel_mm": [*each.texel_mm],
                "relative_rms_error": round(each.cloth.material.error, 4),
                "brightness": round(each.cloth.material.brightness, 4),
            }
            for each in pack.densities
        },
    }


def _write(folder: Path, name: str, template: str, words: Mapping[str, object]) -> str:
    (folder / name).write_text(_fill(template, words), encoding="utf-8")
    return name


# ---------------------------------------------------------------------------------------------------- Unreal


def write_unreal(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Textures with Y-down normals and ORM, and a script for the editor's Python; returns facts.

    Raises:
        InputError: what a fit raises.
    """
    pack = _pack(fabric, model, distance)

    def textures(density: Density) -> dict[str, Picture]:
        stem = f"T_{pack.title}_{density.label.capitalize()}"
        return {
            f"{stem}_BC": density.simple.base_color(density.opaque),
            f"{stem}_N": density.simple.normal_map(y_down=True),
            f"{stem}_ORM": density.orm(),
        }

    names = _write_textures(folder, pack, textures)
    words = pack.words | {"masked": not pack.densities[0].opaque}
    names.append(_write(folder, "import_into_unreal.py", "import_into_unreal.py.in", words))
    names.append(_write(folder, "README.md", "unreal.md", words))
    return _facts(pack, names)


# ----------------------------------------------------------------------------------------------------- Unity


def write_unity(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Textures with Y-up normals and mask maps, and how they are imported; returns facts.

    Raises:
        InputError: what a fit raises.
    """
    pack = _pack(fabric, model, distance)

    def textures(density: Density) -> dict[str, Picture]:
        stem = f"{pack.title}_{density.label.capitalize()}"
        rough = density.simple.roughness
        zero, one = np.zeros_like(rough), np.ones_like(rough)
        return {
            f"{stem}_BaseMap": density.simple.base_color(density.opaque),
            f"{stem}_Normal": density.simple.normal_map(),
            f"{stem}_MaskMap": eight_bits(np.stack([zero, one, zero, 1 - rough], axis=-1)),
        }

    names = _write_textures(folder, pack, textures)
    names += [_write(folder, f"{name}.meta", "unity.meta.in", _unity_import(pack, name)) for name in names]
    names.append(_write(folder, "README.md", "unity.md", pack.words))
    return _facts(pack, names)


def _unity_import(pack: Pack, name: str) -> dict[str, object]:
    """How Unity is to import a texture, whose path in the pack is `name`."""
    density = next(each for each in pack.densities if name.startswith(f"{each.label}/"))
    is_colour = name.endswith("_BaseMap.png")
    return {
        # Any number will do that no other asset has; the same pack keeps its own.
        "guid": hashlib.md5(f"loomlight {pack.name} {name}".encode(), usedforsecurity=False).hexdigest(),
        "srgb": int(is_colour),
        "type": int(name.endswith("_Normal.png")),
        "transparent": int(is_colour and not density.opaque),
        "max_size": max(density.texels),
    }


# ----------------------------------------------------------------------------------------------------- Godot


def write_godot(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Textures with Y-up normals, how they are imported, a StandardMaterial3D of each density; returns facts.

    Raises:
        InputError: what a fit raises.
    """
    pack = _pack(fabric, model, distance)

    def textures(density: Density) -> dict[str, Picture]:
        found = {
            "albedo": density.simple.base_color(density.opaque),
            "normal": density.simple.normal_map(),
            "orm": density.orm(),
        }
        flow = _godot_flow(density.cloth.material)
        if flow[..., 3].any():
            found["flow"] = flow
        passed = density.cloth.passed
        if passed.max() > 0:
            found["backlight"] = eight_bits(linear_to_srgb(passed))
        return {f"{pack.key}_{density.label}_{name}": pixels for name, pixels in found.items()}

    names = _write_textures(folder, pack, textures)
    names += [_write(folder, f"{name}.import", "godot.import.in", _godot_import(name)) for name in names]
    for each in pack.densities:
        stem, path = f"{each.label}/{pack.key}_{each.label}_", f"{pack.key}_{each.label}.tres"
        own = [re.sub(rf"{stem}|\.png$", "", name) for name in names if re.match(rf"{stem}\w+\.png$", name)]
        (folder / path).write_text(_godot_material(pack, each, own), encoding="utf-8")
        names.append(path)
    names.append(_write(folder, "README.md", "godot.md", pack.words))
    return _facts(pack, names)


def _godot_flow(material: FittedMaterial) -> Picture:
    """In which direction highlights are wide, coded as normals are, and in alpha how much: 0 to 1."""
    ratio = material.alpha_y / np.maximum(material.alpha_x, 1e-6)
    anisotropy = np.clip((1 - ratio) / _GODOT_ANISOTROPY, 0, 1)[..., None]
    return eight_bits(
        np.concatenate([0.5 + 0.5 * material.direction, np.zeros_like(anisotropy), anisotropy], axis=-1)
    )


def _godot_import(name: str) -> dict[str, object]:
    """How Godot is to import a texture: by itself it makes no smaller copies of it for views from afar."""
    return {
        "normal_map": 1 if name.endswith("_normal.png") else 2,  # yes or no, without asking
        "has_holes": str(name.endswith("_albedo.png")).lower(),
    }


def _godot_material(pack: Pack, density: Density, textures: list[str]) -> str:
    """A resource of Godot 4 whose pictures lie beside it, for uv in metres."""
    lines = [f'[gd_resource type="StandardMaterial3D" load_steps={len(textures) + 1} format=3]', ""]
    for name in textures:
        path = f"{density.label}/{pack.key}_{density.label}_{name}.png"
        lines.append(f'[ext_resource type="Texture2D" path="{path}" id="{name}"]')
    words, label = pack.words, density.label
    lines += [
        "",
        "[resource]",
        f'resource_name = "{pack.name} {density.label}"',
        f"transparency = {0 if density.opaque else 4}",  # opaque, or with depth written first
        "cull_mode = 2",  # both sides
        'albedo_texture = ExtResource("albedo")',
        "metallic = 0.0",
        f"metallic_specular = {words['godot_specular']}",
        "roughness = 1.0",
        'roughness_texture = ExtResource("orm")',
        "roughness_texture_channel = 1",  # green
        "normal_enabled = true",
        'normal_texture = ExtResource("normal")',
        "texture_filter = 5",  # linear, anisotropic mipmaps
        f"uv1_scale = Vector3({words[f'{label}_across']}, {words[f'{label}_up']}, 1)",
    ]
    if "flow" in textures:
        lines += ["anisotropy_enabled = true", "anisotropy = 1.0", 'anisotropy_flowmap = ExtResource("flow")']
    if "backlight" in textures:
        lines += ["backlight_enabled = true", 'backlight_texture = ExtResource("backlight")']
    return "\n".join([*lines, ""])


# -------------------------------------------------------------------------------------------------- three.js


def write_threejs(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Textures, and a module that builds a MeshPhysicalMaterial of them; returns facts.

    Raises:
        InputError: what a fit raises.
    """
    pack = _pack(fabric, model, distance)

    def textures(density: Density) -> dict[str, Picture]:
        made = density.standard
        return {
            "base_color": made["base_color"][..., :3] if density.opaque else made["base_color"],
            "normal": made["normal"],
            "roughness": made["metallic_roughness"],
        } | ({"anisotropy": made["anisotropy"]} if "anisotropy" in made else {})

    names = _write_textures(folder, pack, textures)
    numbers = ",\n".join(_three_numbers(each) for each in pack.densities)
    words = pack.words | {"cloths": numbers, "quoted": json.dumps(pack.name)}
    names.append(_write(folder, "material.js", "material.js.in", words))
    names.append(_write(folder, "README.md", "threejs.md", words))
    return _facts(pack, names)


def _three_numbers(density: Density) -> str:
    """What material.js knows of a density."""
    fit: FittedMaterial = density.cloth.material
    has_anisotropy = "anisotropy" in density.standard
    peak = peak_of(fit.specular) / DIELECTRIC
    return (
        f"  {density.label}: {{ widthMm: {density.words[f'{density.label}_width']}, "
        f"heightMm: {density.words[f'{density.label}_height']}, opaque: {str(density.opaque).lower()}, "
        f"anisotropy: {str(has_anisotropy).lower()}, specular: {fit.weight:.5f}, "
        f"specularColor: {peak:.5f}, sheen: {float(fit.sheen.max()):.5f}, "
        f"sheenRoughness: {fit.sheen_roughness:.5f} }}"
    )


# From a name of `export --to` to what writes it and what it is.
ENGINES: dict[str, tuple[Callable[[Path, Fabric, str, float | None], dict[str, object]], str]] = {
    "unreal": (write_unreal, "textures for Unreal: ORM, Y-down normals, an import script"),
    "unity": (write_unity, "textures for Unity: mask maps, with their import settings"),
    "godot": (write_godot, "textures for Godot 4, and a StandardMaterial3D of each density"),
    "threejs": (write_threejs, "textures for three.js, and a module that makes its material"),
}
