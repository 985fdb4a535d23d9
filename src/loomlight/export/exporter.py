"""`export`: a fabric for other programs, as shader code, a network, or a standard material with textures."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from loomlight.assets.load import fabric_of_path
from loomlight.core.errors import InputError
from loomlight.export.folder import replacing_folder, write_manifest
from loomlight.export.materials import write_gltf, write_materialx
from loomlight.export.network import write_onnx
from loomlight.export.shaders import write_shaders
from loomlight.fabric.fabric import Fabric

# Writes files of a fabric and a model into a folder; returns what the manifest says of them.
# The last argument is the distance in metres, None for close views, where a target has one.
Writer = Callable[[Path, Fabric, str, float | None], dict[str, object]]


@dataclass(frozen=True)
class ExportTarget:
    """What a fabric can be exported to.

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
    return lambda folder, fabric, model, _: write_shaders(folder, fabric, model, language)


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
    name: ExportTarget(summary, ("lobes", "point"), _shader(name)) for name, summary in _LANGUAGES.items()
} | {
    "onnx": ExportTarget("the network's decoder, and latents", ("woven",), write_onnx),
    "gltf": ExportTarget("a glTF file with textures, for any viewer", ("lobes",), write_gltf, True),
    "materialx": ExportTarget("MaterialX with OpenPBR, and textures", ("lobes",), write_materialx, True),
}


def export(
    fabric: Fabric | str | os.PathLike[str],
    to: str,
    folder: str | os.PathLike[str],
    model: str | None = None,
    distance: float | None = None,
) -> Path:
    """Writes a fabric for another program into a folder, which is new, empty, or holds an earlier export.

    Args:
        fabric: a fabric, or an argument of `fabric_of_path`.
        to: a name of `TARGETS`.
        model: by default the first that the target takes.
        distance: metres from which textures are seen, 0.01 to 1000; None for close views. Shader code and
            networks serve every distance.

    Returns:
        The folder.

    Raises:
        InputError: an unknown target, a model that it does not take, or a folder that cannot be written.
        MissingDependencyError: a package that the target needs is missing.
    """
    if to not in TARGETS:
        raise InputError(f'--to "{to}" is unknown: use one of {", ".join(TARGETS)}.')
    target = TARGETS[to]
    chosen = target.models[0] if model is None else model
    if chosen not in target.models:
        raise InputError(f'--to {to} does not take the model "{chosen}": use {" or ".join(target.models)}.')
    if distance is not None and not target.has_distance:
        raise InputError(f"--to {to} serves every distance: leave out --distance.")
    if distance is not None and not 0.01 <= distance <= 1000:
        raise InputError(f"--distance {distance:g} is out of range: write metres from 0.01 to 1000.")
    with replacing_folder(folder) as temporary:
        cloth = fabric if isinstance(fabric, Fabric) else fabric_of_path(fabric)
        facts: dict[str, object] = {"fabric": cloth.name, "model": chosen, "target": to}
        write_manifest(temporary, facts | target.write(temporary, cloth, chosen, distance))
    return Path(folder)
