"""`export`: a fabric for other programs, as shader code, a network, or a standard material with textures."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.exporters.blender import write_maps
from loomlight.exporters.blender_addon import write_addon
from loomlight.exporters.folder import replacing_folder, write_manifest
from loomlight.exporters.materials import write_gltf, write_materialx
from loomlight.exporters.shaders import write_shaders
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
# The last argument is the distance in metres, None for close views, where a target has one.
Writer = Callable[[Path, Material, str, float | None], dict[str, object]]


@dataclass(frozen=True)
class ExportTarget:
    """A target of exports.

    Attributes:
        summary: one line.
        models: that can be exported, the default first.
        write: the function that writes the files.
        has_distance: whether it is made for a distance.
    """

    summary: str
    models: tuple[str, ...]
    write: Writer
    has_distance: bool = False


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
        "a glTF file with textures, for any viewer", ("lobes",), _of_fabric(write_gltf), True
    ),
    "materialx": ExportTarget(
        "MaterialX with OpenPBR, and textures", ("lobes",), _of_fabric(write_materialx), True
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
) -> Path:
    """Writes a fabric for another program into a folder, which is new, empty, or holds an earlier export.

    Args:
        fabric: a fabric, a model that is made already, or a path: a fabric file, a draft, a `.loom`, the name
            of a weave.
        to: a name of `TARGETS`.
        model: by default the one that a `.loom` holds where the target takes it, else the first that it
            takes.
        distance: metres from which textures are seen, 0.01 to 1000; None for close views. Shader code and
            networks serve every distance.

    Returns:
        The folder.

    Raises:
        InputError: an unknown target, a model that it does not take or that does not take the material, or a
            folder that cannot be written.
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
    with replacing_folder(folder) as temporary:
        material = material_of(fabric)
        if isinstance(material, Fabric):
            material = without_maps(material, f"What is written for {to}")
        own = default_model_of(material)
        chosen = model or (own if own in target.models else target.models[0])
        facts: dict[str, object] = {"fabric": source_of(material).name, "model": chosen, "target": to}
        write_manifest(temporary, facts | target.write(temporary, material, chosen, distance))
    return Path(folder)
