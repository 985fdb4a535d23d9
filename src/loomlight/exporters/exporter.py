"""`export`: a fabric for other programs, as shader code, a network, or a standard material with textures."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

from loomlight.core.errors import InputError
from loomlight.core.files import replacing
from loomlight.core.picture_settings import GarmentKeywords, GarmentSettings, Worn
from loomlight.exporters.blender import write_maps
from loomlight.exporters.blender_addon import write_addon
from loomlight.exporters.engines import ENGINES
from loomlight.exporters.folder import check_file, replacing_folder, write_manifest
from loomlight.exporters.garment_gltf import write_garment_gltf
from loomlight.exporters.materials import write_gltf, write_materialx
from loomlight.exporters.shaders import write_shaders
from loomlight.exporters.u3m import file_name, write_u3m, write_u3m_archive
from loomlight.exporters.usd import write_usd, write_usdz
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.surface_maps import without_maps
from loomlight.models.registry import REALTIME_MODELS, model_class
from loomlight.realtime.materials import (
    Material,
    default_model_of,
    fabric_for,
    material_of,
    source_of,
)

# Writes files of a material and a model into a folder; returns what the manifest says of them.
# The last argument is the distance in metres, None for close views, where a target has one; of targets with a
# resolution it is that in texels an inch, None for the usual one.
Writer = Callable[[Path, Material, str, float | None], dict[str, object]]
# The same of a mesh that the fabric clothes, and others.
GarmentWriter = Callable[[Path, Fabric, str, float | None, GarmentSettings], dict[str, object]]


@dataclass(frozen=True)
class ExportTarget:
    """A target of exports.

    Attributes:
        summary: one line.
        models: that can be exported, the default first.
        write: the function that writes the files.
        has_distance: whether it is made for a distance.
        has_dpi: whether its textures have texels of a size in millimetres.
        suffix: of the one file that it is; "" for a folder.
        write_garment: the function that writes a mesh in its cloths; None where it takes none.
        holds_cloths: whether all fabrics of a garment are written without its mesh, a material each.
    """

    summary: str
    models: tuple[str, ...]
    write: Writer
    has_distance: bool = False
    has_dpi: bool = False
    suffix: str = ""
    write_garment: GarmentWriter | None = None
    holds_cloths: bool = False


def _shader(language: str) -> Writer:
    return lambda folder, material, model, _: write_shaders(folder, material, model, language)


def _of_fabric(write: Callable[[Path, Fabric, str, float | None], dict[str, object]]) -> Writer:
    """A writer that takes fabrics alone."""
    return lambda folder, material, model, distance: write(
        folder, fabric_for(material, model), model, distance
    )


def _write_onnx(folder: Path, material: Material, model: str, distance: float | None) -> dict[str, object]:
    model_class(model)  # says what is missing
    if model == "latent":
        from loomlight.exporters.networks import write_latent_onnx

        return write_latent_onnx(folder, material, model, distance)
    from loomlight.exporters.networks import write_onnx

    return _of_fabric(write_onnx)(folder, material, model, distance)


_LANGUAGES = {
    "slang": "Slang modules, for every API",
    "wgsl": "WebGPU; with a sample that draws",
    "hlsl": "Direct3D 12",
    "glsl": "Vulkan and OpenGL 4.5",
    "spirv": "Vulkan, a compiled kernel",
    "metal": "Metal",
    "cuda": "CUDA C++",
}
TARGETS: dict[str, ExportTarget] = {
    name: ExportTarget(summary, tuple(REALTIME_MODELS), _shader(name)) for name, summary in _LANGUAGES.items()
} | {
    "onnx": ExportTarget("the network's decoder, and latents", ("neural", "latent"), _write_onnx),
    "gltf": ExportTarget(
        "a glTF file with textures, for any viewer",
        ("lobes",),
        _of_fabric(write_gltf),
        True,
        write_garment=write_garment_gltf,
    ),
    "materialx": ExportTarget(
        "MaterialX with OpenPBR, and textures", ("lobes",), _of_fabric(write_materialx), True
    ),
    "usd": ExportTarget(
        "a USD stage with OpenPBR and UsdPreviewSurface",
        ("lobes",),
        _of_fabric(write_usd),
        True,
        write_garment=write_usd,
    ),
    "usdz": ExportTarget(
        "the same in one file",
        ("lobes",),
        _of_fabric(write_usdz),
        True,
        suffix=".usdz",
        write_garment=write_usdz,
    ),
    **{
        name: ExportTarget(summary, ("lobes",), _of_fabric(write), True)
        for name, (write, summary) in ENGINES.items()
    },
    "u3m": ExportTarget(
        "U3M of both faces, for apparel programs", ("lobes",), write_u3m, has_dpi=True, holds_cloths=True
    ),
    "u3ma": ExportTarget(
        "the same in one file",
        ("lobes",),
        write_u3m_archive,
        has_dpi=True,
        suffix=".u3ma",
        holds_cloths=True,
    ),
    "blender": ExportTarget(
        "maps in three densities, for the Blender add-on", ("lobes",), _of_fabric(write_maps)
    ),
    "blender-addon": ExportTarget(
        "the Blender add-on, with the fabric ready in it", ("lobes",), _of_fabric(write_addon)
    ),
}


def export(
    fabric: Material | str | os.PathLike[str],
    to: str,
    folder: str | os.PathLike[str],
    model: str | None = None,
    distance: float | None = None,
    dpi: float | None = None,
    settings: GarmentSettings | None = None,
    **changes: Unpack[GarmentKeywords],
) -> Path:
    """Writes a fabric for another program into a folder, which is new, empty, or holds an earlier export.

    A target that is one file (`u3ma`) is written to that file, and those of several cloths into a folder.

    Args:
        fabric: a fabric, a model that is made already, or a path: a fabric file, a draft, a `.loom`, the name
            of a weave.
        to: a name of `TARGETS`.
        model: by default the one that a `.loom` holds where the target takes it, else the first that it
            takes.
        distance: metres from which textures are seen, 0.01 to 1000; None for close views. Shader code and
            networks serve every distance.
        dpi: texels an inch of U3M's maps, 30 to 2400; None for 300.
        settings: of a mesh that is written in the fabric, and in others; by default there is none. U3M has no
            mesh: of `cloths` each is a material of its name, beside that of `fabric`.
        changes: these settings by name, such as `mesh="coat.glb", cloths={"lining": lining}`.

    Returns:
        The folder, or the file.

    Raises:
        InputError: an unknown target, a model that it does not take or that does not take the material, a
            mesh that it does not take or that cannot be read, or a folder that cannot be written.
        MissingDependencyError: a package that the target needs is missing.
    """
    if to not in TARGETS:
        raise InputError(f'--to "{to}" is unknown: use one of {", ".join(TARGETS)}.')
    target = TARGETS[to]
    if model is not None and model not in target.models:
        raise InputError(f'--to {to} does not take the model "{model}": use {" or ".join(target.models)}.')
    if distance is not None and not target.has_distance:
        raise InputError(f"--to {to} serves every distance: leave out --distance.")
    if distance is not None and not 0.01 <= distance <= 1000:
        raise InputError(f"--distance {distance:g} is out of range: write metres from 0.01 to 1000.")
    if dpi is not None and not target.has_dpi:
        raise InputError(f"--to {to} has no textures of a resolution in millimetres: leave out --dpi.")
    garment = (settings or GarmentSettings()).changed(**changes)
    _require_garment(to, target, garment)
    given = dpi if target.has_dpi else distance

    def write(place: Path) -> dict[str, object]:
        """Writes all files, and returns what the manifest says."""
        material, chosen = _taken(fabric, to, model)
        facts: dict[str, object] = {"fabric": source_of(material).name, "model": chosen, "target": to}
        if garment.mesh is not None and target.write_garment is not None:
            return facts | target.write_garment(place, fabric_for(material, chosen), chosen, given, garment)
        return facts | target.write(place, material, chosen, given)

    if garment.mesh is None and garment.cloths:
        cloths = {name: _fabric_of(name, worn) for name, worn in garment.cloths.items()}
        with replacing_folder(folder) as temporary:
            found = _write_each(temporary, {"": fabric} | cloths, to, model, given)
            write_manifest(temporary, {"target": to, "materials": found})
        return Path(folder)
    if target.suffix:
        check_file(folder, target.suffix)
        with replacing(folder) as file:
            write(file)
        return Path(folder)
    with replacing_folder(folder) as temporary:
        write_manifest(temporary, write(temporary))
    return Path(folder)


def _require_garment(to: str, target: ExportTarget, garment: GarmentSettings) -> None:
    """Raises InputError unless the target takes the mesh, and settings of a mesh have one."""
    if garment.mesh is not None and target.write_garment is None:
        able = [name for name, each in TARGETS.items() if each.write_garment is not None]
        raise InputError(f"--to {to} writes no meshes: leave out --mesh, or use {' or '.join(able)}.")
    if garment.mesh is None:
        for name in garment.chosen():
            if name == "cloths" and target.holds_cloths:
                continue
            raise InputError(f"{name} is of a mesh, and there is none: give one, by --mesh.")


def _fabric_of(name: str, worn: Any) -> Any:
    """The fabric of a cloth without a mesh, which has no turn."""
    if isinstance(worn, Worn) and worn.turn:
        raise InputError(f"--cloth {name}: turn is of a mesh, and there is none: leave out turn.")
    return worn.fabric if isinstance(worn, Worn) else worn


def _write_each(
    folder: Path, cloths: Mapping[str, Any], to: str, model: str | None, given: float | None
) -> dict[str, object]:
    """Writes a material for each cloth, a file or a folder of its name; returns what the manifest says.

    The first has the name of its fabric, the others those of the garment's parts.
    """
    target = TARGETS[to]
    # Faults of any come before the work of the first.
    taken: dict[str, tuple[Material, str]] = {}
    for part, fabric in cloths.items():
        material, chosen = _taken(fabric, to, model)
        name = file_name(part or source_of(material).name)
        if name in taken:
            raise InputError(
                f'Two cloths would be written as "{name}": give the part another name by --cloth.'
            )
        taken[name] = material, chosen
    found: dict[str, object] = {}
    for name, (material, chosen) in taken.items():
        place = folder / f"{name}{target.suffix}"
        if not target.suffix:
            place.mkdir()
        said = target.write(place, material, chosen, given)
        found[name] = {"fabric": source_of(material).name, "model": chosen} | said
    return found


def _taken(fabric: Material | str | os.PathLike[str], to: str, model: str | None) -> tuple[Material, str]:
    """The material that a target is written of, and the model."""
    material = material_of(fabric)
    if isinstance(material, Fabric):
        material = without_maps(material, f"What is written for {to}")
    own, models = default_model_of(material), TARGETS[to].models
    return material, model or (own if own in models else models[0])
