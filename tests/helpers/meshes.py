"""Mesh files of a quad in every format, and a garment of three parts."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

Rows = NDArray[Any]

# 2 × 3 in the plane z = 0; u runs along x from 0 to 1, v (upwards) along y from 0 to 0.5.
CORNERS = np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]], dtype=float)
UV_UP = np.array([[0, 0], [1, 0], [1, 0.5], [0, 0.5]])
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]])


def obj_text(corners: Rows = CORNERS, uv: Rows | None = UV_UP, extra: str = "") -> str:
    """The quad as OBJ; without uv if there are none."""
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    lines += [] if uv is None else [f"vt {u} {v}" for u, v in uv]
    corner = "{0}" if uv is None else "{0}/{0}"
    lines += ["f " + " ".join(corner.format(i + 1) for i in triangle) for triangle in TRIANGLES]
    return "\n".join(lines) + "\n" + extra


def write_obj(folder: Path, corners: Rows = CORNERS, uv: Rows = UV_UP) -> Path:
    """quad.obj in the folder."""
    file = folder / "quad.obj"
    file.write_text(obj_text(corners, uv))
    return file


def write_ply(folder: Path, corners: Rows = CORNERS, uv: Rows = UV_UP) -> Path:
    """quad.ply in the folder, binary."""
    file = folder / "quad.ply"
    header = ["ply", "format binary_little_endian 1.0", "element vertex 4"]
    header += [f"property float {name}" for name in ("x", "y", "z", "u", "v")]
    header += ["element face 2", "property list uchar int vertex_indices", "end_header", ""]
    body = np.concatenate([corners, uv], axis=1).astype("<f4").tobytes()
    body += b"".join(struct.pack("<B3i", 3, *triangle) for triangle in TRIANGLES)
    file.write_bytes("\n".join(header).encode() + body)
    return file


def write_gltf(
    folder: Path,
    corners: Rows = CORNERS,
    uv: Rows = UV_UP,
    name: str = "quad.glb",
    transforms: tuple[Rows, ...] = (np.eye(4),),
) -> Path:
    """The quad in a .glb or .gltf, once for each transform."""
    scene = trimesh.Scene()
    for transform in transforms:
        # trimesh holds v upwards and writes it downwards, as glTF wants it.
        visual = trimesh.visual.TextureVisuals(uv=uv)
        part = trimesh.Trimesh(corners, TRIANGLES, visual=visual, process=False)
        scene.add_geometry(part, transform=transform)
    file = folder / name
    scene.export(file)
    return file


def coat(folder: Path) -> Path:
    """Two panels of 0.4 m, the second with uv four times as dense, and a button without uv."""
    square = ((0, 0), (1, 0), (1, 1), (0, 1))
    lines, first = [], 1
    for number, (name, material, density) in enumerate(
        [("front", "shell", 1.0), ("back", "lining", 4.0), ("button", "horn", None)]
    ):
        lines += [f"o {name}", f"usemtl {material}"]
        lines += [f"v {0.5 * number + 0.4 * x} {0.4 * y} 0" for x, y in square]
        lines += [f"vt {density * x} {density * y}" for x, y in square if density is not None]
        corners = [str(first + k) if density is None else f"{first + k}/{first + k}" for k in range(4)]
        lines.append("f " + " ".join(corners))
        first += 4
    file = folder / "coat.obj"
    file.write_text("\n".join(lines) + "\n")
    return file
