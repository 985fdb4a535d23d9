"""Export of `neural`: its decoder as ONNX, with the latents and fibres of a fabric as tensors."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import BUNDLES
from loomlight.models.neural.footprint_coding import mean_pitch
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import shipped_decoder
from loomlight.models.registry import make_model

_PAGE = Path(__file__).parent / "languages" / "network.md"
_OF_FACES = ("front", "back")


def write_onnx(folder: Path, fabric: Fabric, model: str, _distance: float | None = None) -> dict[str, object]:
    """Writes decoder.onnx, latents.safetensors and README.md, and returns what the manifest says.

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
    layout = fabric.layout()
    levels = [
        {"first": level.first, "columns": level.columns, "rows": level.rows, "per_thread": level.per_thread}
        for level in encoded.levels
    ]
    (folder / "README.md").write_text(
        _PAGE.read_text(encoding="utf-8").format(name=fabric.name, hidden=hidden, pitch=mean_pitch(layout)),
        encoding="utf-8",
    )
    return {
        "files": ["decoder.onnx", "latents.safetensors"],
        "picks": encoded.picks,
        "ends": encoded.ends,
        "mean_pitch_mm": float(mean_pitch(layout)),
        "levels": levels,
        "multiply_adds": made.multiply_adds,
    }
