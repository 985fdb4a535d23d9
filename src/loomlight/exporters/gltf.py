"""A fitted material as a glTF 2.0 file: textures of one repeat on a sample sheet, with true sizes."""

from __future__ import annotations

import io
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.standards import DIELECTRIC

Numbers = NDArray[np.float64]
# The sample sheet: side and height of its waves, metres, and vertices a side.
_SIDE, _WAVE, _VERTICES = 0.1, 0.004, 49
_FLOAT, _UINT32, _ARRAY, _ELEMENTS = 5126, 5125, 34962, 34963


def material_textures(material: FittedMaterial) -> dict[str, NDArray[np.uint8]]:
    """Textures by name [rows, columns, 3 or 4], 8 bits, row 0 at the upper edge, as glTF encodes them."""
    peak = peak_of(material.specular)
    alpha = material.alpha_y
    roughness = np.sqrt(alpha)
    strength = np.sqrt(np.clip((material.alpha_x - alpha) / np.maximum(1 - alpha, 1e-6), 0, 1))
    zero = np.zeros_like(roughness)
    one = np.ones_like(roughness)
    direction = 0.5 + 0.5 * material.direction
    maps = {
        "base_color": np.concatenate([linear_to_srgb(material.base), material.cover[..., None]], axis=-1),
        "normal": 0.5 + 0.5 * material.normal,
        "metallic_roughness": np.stack([zero, roughness, zero], axis=-1),
        "anisotropy": np.concatenate([direction, strength[..., None]], axis=-1),
        "specular_color": linear_to_srgb(material.specular / peak),
        "diffuse_transmission": np.stack([one, one, one, material.transmission], axis=-1),
        "diffuse_transmission_color": linear_to_srgb(material.transmit),
    }
    if not strength.any():
        del maps["anisotropy"]
    return {name: eight_bits(values) for name, values in maps.items()}


def eight_bits(values: Numbers) -> NDArray[np.uint8]:
    """A picture of values from 0 to 1 whose row 0 is at the lower edge, with row 0 at the upper one."""
    return np.rint(255 * np.clip(values[::-1], 0, 1)).astype(np.uint8)


def peak_of(specular: Numbers) -> float:
    """Largest specular albedo, by which the texture of specular colours is divided."""
    return max(float(specular.max()), 1e-6)


def write_textures(folder: Path, textures: dict[str, NDArray[np.uint8]]) -> list[str]:
    """Writes textures/NAME.png and returns their paths relative to `folder`."""
    (folder / "textures").mkdir()
    names = []
    for name, pixels in textures.items():
        names.append(f"textures/{name}.png")
        (folder / names[-1]).write_bytes(png_bytes(pixels))
    return names


def png_bytes(pixels: NDArray[np.uint8]) -> bytes:
    """A picture as the content of a PNG file."""
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, format="png")
    return stream.getvalue()


class Buffer:
    """The binary buffer of a file, with its views and accessors."""

    def __init__(self) -> None:
        self.content = b""
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def view(self, content: bytes, target: int | None = None) -> int:
        """Appends content and returns the number of its view."""
        self.content += bytes(-len(self.content) % 4)
        entry = {"buffer": 0, "byteOffset": len(self.content), "byteLength": len(content)}
        if target is not None:
            entry["target"] = target
        self.content += content
        self.views.append(entry)
        return len(self.views) - 1

    def accessor(self, values: NDArray[Any], kind: str) -> int:
        """Appends rows of vertices, or indices, and returns the number of their accessor."""
        is_index = values.dtype == np.uint32
        entry: dict[str, Any] = {
            "bufferView": self.view(values.tobytes(), _ELEMENTS if is_index else _ARRAY),
            "componentType": _UINT32 if is_index else _FLOAT,
            "count": values.size if is_index else len(values),
            "type": kind,
        }
        if kind == "VEC3":  # positions need bounds
            entry |= {"min": values.min(0).tolist(), "max": values.max(0).tolist()}
        self.accessors.append(entry)
        return len(self.accessors) - 1


def glb_of(name: str, material: FittedMaterial, textures: dict[str, NDArray[np.uint8]]) -> bytes:
    """A .glb file: a sheet of 10 cm with the material, textures within."""
    buffer = Buffer()
    positions, normals, tangents, uv, faces = wavy_sheet()
    attributes = {
        "POSITION": buffer.accessor(positions, "VEC3"),
        "NORMAL": buffer.accessor(normals, "VEC3"),
        "TANGENT": buffer.accessor(tangents, "VEC4"),
        "TEXCOORD_0": buffer.accessor(uv, "VEC2"),
    }
    indices = buffer.accessor(faces, "SCALAR")
    images = [
        {"name": key, "mimeType": "image/png", "bufferView": buffer.view(png_bytes(pixels))}
        for key, pixels in textures.items()
    ]
    width, height = material.size
    scale = [1000 * _SIDE / width, 1000 * _SIDE / height]
    described = material_entry(name, material, list(textures), scale)
    tree = {
        "asset": {"version": "2.0", "generator": "loomlight"},
        "extensionsUsed": sorted({*described["extensions"], "KHR_texture_transform"}),
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [
            {"primitives": [{"attributes": attributes, "indices": indices, "material": 0}], "name": "sheet"}
        ],
        "materials": [described],
        "textures": [{"source": k, "sampler": 0} for k in range(len(images))],
        "images": images,
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.content)}],
    }
    return container(tree, buffer.content)


def material_entry(
    name: str, material: FittedMaterial, names: list[str], scale: list[float] | None, first: int = 0
) -> dict[str, Any]:
    """The entry of a material.

    Args:
        names: of its textures, in their order.
        scale: repeats of the textures a unit of uv; None where uv count repeats.
        first: number of the first of its textures.
    """

    def texture(key: str) -> dict[str, Any]:
        entry: dict[str, Any] = {"index": first + names.index(key)}
        if scale is not None:
            entry["extensions"] = {"KHR_texture_transform": {"scale": scale}}
        return entry

    width, height = material.size
    rows, columns = material.cover.shape
    extensions: dict[str, Any] = {
        "KHR_materials_specular": {
            "specularFactor": material.weight,
            "specularColorFactor": [peak_of(material.specular) / DIELECTRIC] * 3,
            "specularColorTexture": texture("specular_color"),
        },
    }
    if "diffuse_transmission" in names:
        extensions["KHR_materials_diffuse_transmission"] = {
            "diffuseTransmissionFactor": 1.0,
            "diffuseTransmissionTexture": texture("diffuse_transmission"),
            "diffuseTransmissionColorTexture": texture("diffuse_transmission_color"),
        }
    if "anisotropy" in names:
        extensions["KHR_materials_anisotropy"] = {
            "anisotropyStrength": 1.0,
            "anisotropyTexture": texture("anisotropy"),
        }
    if material.sheen.max() > 0:
        extensions["KHR_materials_sheen"] = {
            "sheenColorFactor": material.sheen.tolist(),
            "sheenRoughnessFactor": material.sheen_roughness,
        }
    return {
        "name": name,
        "doubleSided": True,
        "alphaMode": "BLEND" if material.cover.min() < 0.995 else "OPAQUE",
        "pbrMetallicRoughness": {
            "baseColorTexture": texture("base_color"),
            "metallicFactor": 0.0,
            "roughnessFactor": 1.0,
            "metallicRoughnessTexture": texture("metallic_roughness"),
        },
        "normalTexture": texture("normal"),
        "extensions": extensions,
        "extras": {
            "repeat_mm": [width, height],
            "texel_mm": [width / columns, height / rows],
            "uv_scale": "repeats of the weave along the sheet of 100 mm" if scale else "uv count repeats",
        },
    }


def wavy_sheet() -> tuple[NDArray[Any], ...]:
    """Positions, normals, tangents, uv and faces of a sheet with gentle waves, y upwards as glTF has it."""
    v, u = np.meshgrid(np.linspace(0, 1, _VERTICES), np.linspace(0, 1, _VERTICES), indexing="ij")
    x, y = _SIDE * (u - 0.5), _SIDE * (0.5 - v)
    wave = 2 * np.pi / _SIDE
    z = _WAVE * np.sin(1.5 * wave * x) * np.cos(wave * y)
    slope_x = _WAVE * 1.5 * wave * np.cos(1.5 * wave * x) * np.cos(wave * y)
    slope_y = -_WAVE * wave * np.sin(1.5 * wave * x) * np.sin(wave * y)
    normals = np.stack([-slope_x, -slope_y, np.ones_like(x)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    tangents = np.stack([np.ones_like(x), np.zeros_like(x), slope_x], axis=-1)
    tangents /= np.linalg.norm(tangents, axis=-1, keepdims=True)
    tangents = np.concatenate([tangents, np.ones((*x.shape, 1))], axis=-1)
    corner = np.arange(_VERTICES * _VERTICES).reshape(_VERTICES, _VERTICES)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    faces = np.stack([a, b, c, a, c, d], axis=-1).ravel().astype(np.uint32)

    def rows(values: Numbers) -> NDArray[np.float32]:
        return values.reshape(-1, values.shape[-1]).astype(np.float32)

    return (
        rows(np.stack([x, y, z], axis=-1)),
        rows(normals),
        rows(tangents),
        rows(np.stack([u, v], axis=-1)),
        faces,
    )


def container(tree: dict[str, Any], content: bytes) -> bytes:
    """A .glb file of a document and its buffer (glTF 2.0, section 4.4)."""
    text = json.dumps(tree, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    content += bytes(-len(content) % 4)
    size = 12 + 8 + len(text) + 8 + len(content)
    header = struct.pack("<4sII", b"glTF", 2, size)
    return (
        header
        + struct.pack("<I4s", len(text), b"JSON")
        + text
        + struct.pack("<I4s", len(content), b"BIN\0")
        + content
    )
