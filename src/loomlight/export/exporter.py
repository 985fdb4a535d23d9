"""`export`: a fabric for programs of other makers, as shader code, a network, or textures of a standard material."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from loomlight.assets.load import fabric_of_path
from loomlight.core.errors import InputError
from loomlight.export.folder import replacing_folder, write_manifest
from loomlight.export.shaders import write_shaders
from loomlight.fabric.fabric import Fabric

# Writes files of a fabric and a model into a folder; returns what the manifest says of them.
Writer = Callable[[Path, Fabric, str], dict[str, object]]


@dataclass(frozen=True)
class ExportTarget:
    """What a fabric can be exported to.

    Attributes:
        summary: one line.
        models: that can be exported, the default first.
        write: the function that writes the files.
    """

    summary: str
    models: tuple[str, ...]
    write: Writer


def _shader(language: str) -> Writer:
    return lambda folder, fabric, model: write_shaders(folder, fabric, model, language)


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
}


def export(
    fabric: Fabric | str | os.PathLike[str],
    to: str,
    folder: str | os.PathLike[str],
    model: str | None = None,
) -> Path:
    """Writes a fabric for another program into a folder, which is new, empty, or holds an earlier export.

    Args:
        fabric: a fabric, or an argument of `fabric_of_path`.
        to: a name of `TARGETS`.
        model: by default the first that the target takes.

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
    with replacing_folder(folder) as temporary:
        cloth = fabric if isinstance(fabric, Fabric) else fabric_of_path(fabric)
        facts: dict[str, object] = {"fabric": cloth.name, "model": chosen, "target": to}
        write_manifest(temporary, facts | target.write(temporary, cloth, chosen))
    return Path(folder)
