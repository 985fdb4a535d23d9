"""A mesh in its cloths, for files of other programs: parts whose uv count repeats, and fitted materials."""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, count
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.picture_settings import GarmentSettings, Worn
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.gltf import png_bytes, wavy_sheet
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.surface_maps import without_maps
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart
from loomlight.mesh.clothing import Garment, placed, read_garment, split
from loomlight.mesh.draft_uv import tangents, with_draft_uv
from loomlight.realtime.materials import Material, fabric_for, material_of

Floats = NDArray[np.float64]
MODEL = "lobes"
# Cloth that covers more than this in the mean is written as opaque: programs draw transparent triangles
# without depth, so that the far side of a garment would show through pores that nobody sees.
_OPAQUE = 0.9
# Share of what passes through yarns that glTF is told of; see `half_passing`.
_PASSED = 0.5
# From a fabric to its material.
Fit = Callable[[Fabric], FittedMaterial]


@dataclass(frozen=True, eq=False)
class GarmentCloth:
    """A fabric that parts of a garment wear.

    Attributes:
        name: of the fabric, another one for each cloth of a garment.
        key: the same in lower-case letters, digits and hyphens, for files and paths.
        material: fitted to it.
    """

    name: str
    key: str
    material: FittedMaterial

    @property
    def is_opaque(self) -> bool:
        """Whether its holes are too few to be drawn."""
        return float(self.material.cover.mean()) > _OPAQUE

    @property
    def passed(self) -> Floats:
        """The colour of the light that passes through its yarns [rows, columns, 3], linear RGB."""
        return self.material.transmit * self.material.transmission[..., None]

    def reflecting(self) -> FittedMaterial:
        """The material for programs that let no light through yarns: the same reflection."""
        return _with_passed(self.material, np.zeros_like(self.passed))

    def half_passing(self) -> FittedMaterial:
        """The material with the same reflection, and half of what passes, by the smallest such factor.

        Programs that leave transmission out, as most do, show its base too bright by this factor. With all of
        it organza was 1.2 times as bright there and right in Babylon.js; with half it is within 6 % in all.
        """
        return _with_passed(self.material, _PASSED * self.passed)


@dataclass(frozen=True, eq=False)
class GarmentPart:
    """A part of a mesh.

    Attributes:
        name: another one for each part.
        mesh: triangles in metres, y up; uv [n, 2] count repeats of the cloth's textures, v up; [0, 2] of what
            no cloth covers.
        tangent: unit vectors along u [n, 3], to whose left v runs; [0, 3] without uv.
        cloth: number of its cloth; None of what no cloth covers.
    """

    name: str
    mesh: ClothMesh
    tangent: Floats
    cloth: int | None


@dataclass(frozen=True, eq=False)
class ClothedGarment:
    """The parts of a mesh and the cloths that they wear."""

    name: str
    parts: list[GarmentPart]
    cloths: list[GarmentCloth]

    def facts(self) -> dict[str, object]:
        """What a manifest says of parts and cloths."""
        return {
            "parts": {
                part.name: None if part.cloth is None else self.cloths[part.cloth].name for part in self.parts
            },
            "cloths": {
                cloth.name: {
                    "repeat_mm": [*cloth.material.size],
                    "texels": [*cloth.material.cover.shape[::-1]],
                    "relative_rms_error": round(cloth.material.error, 4),
                }
                for cloth in self.cloths
            },
        }


def _with_passed(material: FittedMaterial, passed: Floats) -> FittedMaterial:
    """The material with the same reflection, and light that passes in a colour whose peak is 1."""
    reflected = material.base * (1 - material.transmission)[..., None]
    factor = np.minimum(passed.max(axis=-1), 0.99)
    return replace(
        material,
        base=np.minimum(reflected / (1 - factor)[..., None], 1),
        transmission=factor,
        transmit=passed / np.maximum(factor, 1e-6)[..., None],
    )


def clothed_garment(fabric: Fabric, settings: GarmentSettings, fit: Fit) -> ClothedGarment:
    """The mesh of `settings` in its fabrics.

    Args:
        fabric: of the parts that `settings.cloths` does not name.
        fit: makes the material of a fabric.

    Raises:
        InputError: what `read_garment` raises, or a cloth that is no fabric.
    """
    assert settings.mesh is not None
    # 1. The fabrics, each once, however many parts wear it, and the parts of each.
    fabrics, number_of, turns = _fabrics(fabric, settings)
    garment = read_garment(
        settings.mesh,
        settings.metres_per_unit,
        0,
        number_of,
        unwrap=settings.unwrap,
        turns=turns,
    )
    # 2. A material for each that is worn.
    worn = sorted({number for _, number in garment.pieces})
    given = [fabrics[number].name for number in worn]
    names, keys = _distinct(given, str, "Cloth"), _distinct(given, file_name, "cloth")
    cloths = [
        GarmentCloth(name, key, fit(fabrics[number]))
        for number, name, key in zip(worn, names, keys, strict=True)
    ]
    # 3. Parts whose uv count repeats of its textures.
    parts = _covered_parts(garment, [worn.index(number) for _, number in garment.pieces], cloths, settings)
    parts += [(part, None) for part in garment.parts if not len(part.mesh.uv)]
    names = _distinct([part.piece or part.name or part.material for part, _ in parts], str, "part")
    made = [
        GarmentPart(name, part.mesh, np.zeros((0, 3)) if number is None else tangents(part.mesh), number)
        for name, (part, number) in zip(names, parts, strict=True)
    ]
    return ClothedGarment(Path(settings.mesh).stem, made, cloths)


def sheet(fabric: Fabric, fit: Fit) -> ClothedGarment:
    """A sheet of 10 cm with gentle waves, where there is no mesh; its uv begin at its lower left corner."""
    positions, normals, tangent, uv, faces = wavy_sheet()
    cloth = GarmentCloth(fabric.name or "Cloth", file_name(fabric.name) or "cloth", fit(fabric))
    side = 1000 * np.ptp(positions[:, 0])
    repeats = np.stack([uv[:, 0], 1 - uv[:, 1]], axis=1) * (side / np.array(cloth.material.size))
    mesh = ClothMesh(
        positions.astype(float), normals.astype(float), repeats, faces.reshape(-1, 3).astype(int), "sheet"
    )
    return ClothedGarment("sheet", [GarmentPart("sheet", mesh, tangent[:, :3].astype(float), 0)], [cloth])


def _fabrics(
    fabric: Fabric, settings: GarmentSettings
) -> tuple[list[Fabric], dict[str, int], dict[str, float]]:
    """All fabrics, that of all other parts first; numbers of those of named parts, and their turns."""
    fabrics, numbers = [fabric], dict[object, int]()
    number_of, turns = dict[str, int](), dict[str, float]()
    for name, given in settings.cloths.items():
        worn = given if isinstance(given, Worn) else Worn(given)
        # Fabrics are equal to themselves alone.
        key = os.fspath(worn.fabric) if isinstance(worn.fabric, str | os.PathLike) else id(worn.fabric)
        if key not in numbers:
            numbers[key] = len(fabrics)
            fabrics.append(fabric_of(worn.fabric))
        number_of[name], turns[name] = numbers[key], worn.turn
    return fabrics, number_of, turns


def fabric_of(material: Material | str | os.PathLike[str]) -> Fabric:
    """The fabric of a material or a path, without maps, which are not written, as a warning says.

    Raises:
        InputError: no such file, or no fabric.
    """
    return without_maps(fabric_for(material_of(material), MODEL), "What is written of a garment")


def _covered_parts(
    garment: Garment[int], cloth_of: list[int], cloths: list[GarmentCloth], settings: GarmentSettings
) -> list[tuple[MeshPart, int | None]]:
    """Parts with uv in repeats of the textures, in whose first repeats they begin, and their cloths."""
    found: list[tuple[MeshPart, int | None]] = []
    for (mesh, _), number, members, turn in zip(
        garment.pieces, cloth_of, garment.members, garment.turns, strict=True
    ):
        turned = settings.placement.changed(turn=settings.placement.turn + turn)
        laid, size = placed(mesh, turned)
        for part in split(laid, members):
            drafted = with_draft_uv(part.mesh, size)
            repeats = drafted.uv / cloths[number].material.size
            # Single precision tells little of what is far from 0; whole repeats show the same.
            begun = repeats - np.floor(repeats.min(axis=0))
            found.append((replace(part, mesh=replace(drafted, uv=begun)), number))
    return found


def write_pictures(folder: Path, key: str, textures: Mapping[str, NDArray[np.uint8]]) -> list[str]:
    """Writes textures/KEY_NAME.png and returns their paths relative to `folder`.

    Programs that copy textures into one folder, as Blender does with those of packages, must not mix them up.
    """
    (folder / "textures").mkdir(exist_ok=True)
    names = [f"textures/{key}_{name}.png" for name in textures]
    for name, pixels in zip(names, textures.values(), strict=True):
        (folder / name).write_bytes(png_bytes(pixels))
    return names


def _distinct(names: Sequence[str], form: Callable[[str], str], otherwise: str) -> list[str]:
    """Names of a form, with numbers where there are several of one."""
    found: list[str] = []
    for name in names:
        stem = form(name) or otherwise
        numbered = (f"{stem}-{number}" for number in count(2))
        found.append(next(each for each in chain([stem], numbered) if each not in found))
    return found


def file_name(name: str) -> str:
    """A name in lower-case letters, digits and hyphens."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    return re.sub(r"[^a-z0-9]+", "-", plain.lower()).strip("-")[:40].strip("-")
