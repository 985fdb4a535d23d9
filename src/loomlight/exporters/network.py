"""Export of `neural`: its decoder as ONNX, a fabric's latents, fibres and albedos as tensors, a program."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import BUNDLES
from loomlight.models.neural.encoded_fabric import mean_pitch
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import shipped_decoder
from loomlight.models.registry import make_model
from loomlight.scattering import sheen
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance, FamilyAppearance
from loomlight.scattering.interreflection import Scattered, scattered, solved_interior
from loomlight.scattering.openness import Openness
from loomlight.scattering.sheen_coefficients import REFLECTANCE, SCALE, SHEAR
from loomlight.yarn.geometry import YarnGeometry

_LANGUAGES = Path(__file__).parent / "languages"
_PAGE, _PROGRAM = _LANGUAGES / "network.md", _LANGUAGES / "colour.py"
_OF_FACES = ("front", "back")


def write_onnx(folder: Path, fabric: Fabric, model: str, _distance: float | None = None) -> dict[str, object]:
    """Writes decoder.onnx, tensors, colour.py and README.md, and returns what the manifest says.

    Raises:
        InputError: a repeat of more than 64 threads a side.
        MissingDependencyError: ONNX Runtime is missing, which encodes the fabric.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    made = make_model(model, fabric)
    if not isinstance(made, NeuralModel):
        raise InputError(f"{model} is no network.")
    encoded = made.encoded
    (folder / "decoder.onnx").write_bytes(shipped_decoder())
    hidden = made.weights.table.hidden
    correction = encoded.correction
    tensors: dict[str, NDArray[Any]] = {
        "correction": np.zeros((2 * BUNDLES, hidden + 1), np.float32) if correction is None else correction
    }
    for number, face in enumerate(_OF_FACES):
        tensors[f"{face}.latents"] = encoded.faces[number]
        tensors[f"{face}.fibres"] = encoded.fibres.face(bool(number))
        tensors[f"{face}.bundles"] = encoded.fibres.bundles(bool(number))
    content = save({name: np.ascontiguousarray(values) for name, values in tensors.items()})
    (folder / "latents.safetensors").write_bytes(content)
    (folder / "cloth.safetensors").write_bytes(save(_cloth_tensors(made)))
    shutil.copyfile(_PROGRAM, folder / _PROGRAM.name)
    layout, appearance = fabric.layout(), fabric.appearance()
    levels = [
        {"first": level.first, "columns": level.columns, "rows": level.rows, "per_thread": level.per_thread}
        for level in encoded.pyramid
    ]
    (folder / "README.md").write_text(
        _PAGE.read_text(encoding="utf-8").format(name=fabric.name, hidden=hidden, pitch=mean_pitch(layout)),
        encoding="utf-8",
    )
    return {
        "files": ["decoder.onnx", "latents.safetensors", "cloth.safetensors", _PROGRAM.name],
        "repeat_mm": list(map(float, layout.size)),
        "picks": encoded.picks,
        "ends": encoded.ends,
        "mean_pitch_mm": float(mean_pitch(layout)),
        "levels": levels,
        "diffuse_blend": appearance.diffuse_blend,
        "sheen_strength": appearance.sheen.strength,
        "multiply_adds": made.multiply_adds,
    }


def _cloth_tensors(model: NeuralModel) -> dict[str, NDArray[Any]]:
    """What makes colours of the network's components: albedos of threads, light between yarns, sheen."""
    layout, appearance = model.fabric.layout(), model.fabric.appearance()
    tensors: dict[str, NDArray[Any]] = {"warp_on_top": layout.warp_on_top.astype(np.uint8)}
    families = (("warp", appearance.warp), ("weft", appearance.weft))
    for (name, family), threads in zip(families, YarnGeometry(layout).families, strict=True):
        tensors[f"{name}.albedos"] = np.stack([getattr(family, albedo) for albedo in ALBEDO_NAMES], axis=1)
        edges = threads.centre[:, None] + threads.half_width[:, None] * [-1, 1]
        tensors[f"{name}.edges"] = edges
        tensors[f"{name}.cells"] = np.stack([threads.lower, threads.upper], axis=1)
    if appearance.openness is not None:
        tensors |= _between_yarns(appearance, appearance.openness)
    if appearance.sheen.strength > 0:
        powers = (3 * max(appearance.sheen.roughness, sheen.MIN) ** 0.25 - 2) ** np.arange(6)
        for name, rows in {"scale": SCALE, "shear": SHEAR, "reflectance": REFLECTANCE}.items():
            tensors[f"sheen.{name}"] = np.array(rows) @ powers
    return {
        name: np.ascontiguousarray(values, values.dtype if values.dtype == np.uint8 else np.float32)
        for name, values in tensors.items()
    }


def _between_yarns(appearance: Appearance, openness: Openness) -> dict[str, NDArray[Any]]:
    """Blocked shares of the sky by view, and the radiances between the yarns of both faces."""
    layers = openness.layers.tolist()
    warp, weft = map(_scattered, (appearance.warp, appearance.weft), layers)
    faces = solved_interior(warp, weft, openness.interior, openness.meets, openness.blocks)
    radiance = [
        [own.warp, own.weft, own.leaked, other.mean, other.leaked] for own, other in (faces, faces[::-1])
    ]
    return {
        "between.by_view": openness.by_view,
        "between.warp_seen": openness.warp_seen,
        "between.layers": openness.layers,
        "between.radiance": np.array(radiance),
    }


def _scattered(family: FamilyAppearance, layer: list[float]) -> Scattered:
    """R and T of the mean of a family's threads."""
    reflect, transmit, specular_reflect, specular_transmit = (
        getattr(family, name).mean(axis=0) for name in ALBEDO_NAMES
    )
    return scattered(reflect, transmit, specular_reflect, specular_transmit, layer)
