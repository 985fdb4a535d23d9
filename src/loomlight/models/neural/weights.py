"""The weights file of the universal network, its exported encoder, and the fabrics it is trained for.

The weights file holds tensors, the network's shape, how it was trained, and a checksum.

It is one safetensors file. The metadata has one entry, `neural`, whose JSON is

    {"checksum": SHA-256 of the rest, "network": {"schema", "shape", "linear_diffuse", "trained", "recipe",
                                                  "provenance"}}

Tensors have the names of the torch module's (`training/network.py`) and lie in half precision; reading needs
no torch. The encoder is an ONNX model of the same name with the suffix .onnx, exported by torch
(`training/export.py`). Two metadata entries end it: `weights`, the checksum of the weights that it was
exported from, and `checksum`, SHA-256 of all bytes before them.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import as_file, files
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError
from safetensors import SafetensorError, safe_open

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.resolve import Structure, structure_of
from loomlight.fabric.yarns import GAP
from loomlight.models.neural.architecture import BINS, LIGHT_FEATURES, VIEW_FEATURES, NetworkTable
from loomlight.sources.loom_file import checksum

# 2: roughness enters the encoder as its logarithm. 3: directions along the fibres are inputs. 4: the lobe
# basis.
SCHEMA = 4
ENTRY = "neural"


class Header(BaseModel):
    """What a weights file says of its network."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    schema_version: int = Field(alias="schema")
    shape: NetworkTable
    linear_diffuse: bool
    trained: bool
    recipe: dict[str, Any]
    provenance: dict[str, Any]


@dataclass(frozen=True, eq=False)
class Weights:
    """A network ready for inference.

    Attributes:
        table: its shape.
        tensors: weights by name, float32.
        linear_diffuse: diffuse outputs are linear, as published, else logarithmic.
        trained: false for random weights.
        recipe: the configuration that it was trained with.
        provenance: when and on what it was trained.
        sha256: of the whole content, hexadecimal; identifies the network in materials.
        source: name of the file in messages.
        encoder: the exported encoder, an ONNX model.
    """

    table: NetworkTable
    tensors: Mapping[str, NDArray[np.float32]]
    linear_diffuse: bool
    trained: bool
    recipe: Mapping[str, Any]
    provenance: Mapping[str, Any]
    sha256: str
    source: str
    encoder: bytes = b""

    def layers(self, name: str) -> int:
        """Number of layers in the list `name`."""
        count = 0
        while f"{name}.{count}.weight" in self.tensors:
            count += 1
        return count

    def tensor(self, name: str) -> NDArray[np.float32]:
        """The tensor `name`.

        Raises:
            InputError: there is none.
        """
        if name not in self.tensors:
            raise InputError(f"{self.source}: the tensor {name} is missing: {_REMEDY}.")
        return self.tensors[name]


_REMEDY = "`python -m studies.papers.chen2024.training`, in a checkout, writes a weights file"


def encoder_path(weights_path: str | os.PathLike[str]) -> Path:
    """The file of the encoder beside a weights file."""
    return Path(weights_path).with_suffix(".onnx")


def read_weights(path: str | os.PathLike[str]) -> Weights:
    """The network in a weights file and the exported encoder beside it.

    Raises:
        InputError: see `read_weights_alone`; no encoder beside it, one of other weights, or one that is
            damaged.
    """
    weights = read_weights_alone(path)
    return replace(weights, encoder=_read_encoder(path, weights.sha256))


def _read_encoder(weights_path: str | os.PathLike[str], sha256: str) -> bytes:
    path = encoder_path(weights_path)
    remedy = f"`python -m studies.papers.chen2024.training.export {weights_path}` writes it"
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{weights_path}: its encoder {path.name} is not beside it: {remedy}.") from error
    model = data[: -len(encoder_metadata(b"", sha256))]
    metadata = data[len(model) :]
    if metadata == encoder_metadata(model, sha256):
        return data
    if metadata.endswith(_metadata_entry("checksum", hashlib.sha256(model).hexdigest())):
        raise InputError(f"{path}: it was exported from other weights than {weights_path}: {remedy} again.")
    raise InputError(f"{path}: it is no exported encoder, or damaged: {remedy} again.")


def encoder_metadata(model: bytes, sha256: str) -> bytes:
    """The metadata entries that end the file of an encoder."""
    entries = {"weights": sha256, "checksum": hashlib.sha256(model).hexdigest()}
    return b"".join(_metadata_entry(key, value) for key, value in entries.items())


def _metadata_entry(key: str, value: str) -> bytes:
    """An entry of `metadata_props` as protobuf, which may be appended to an ONNX model as it is.

    Field 14 of ModelProto, of the fields 1, key, and 2, value; all are shorter than 128 bytes.
    """
    entry = b"".join(bytes([tag, len(text)]) + text.encode() for tag, text in ((0x0A, key), (0x12, value)))
    return bytes([0x72, len(entry)]) + entry


def read_weights_alone(path: str | os.PathLike[str]) -> Weights:
    """The network in a weights file without the encoder beside it, which is to be exported.

    Raises:
        InputError: no such file, no weights file, one of another version, or one that is damaged or whose
            decoder is not the one that its header describes.
    """
    require_file(path)
    source = str(path)
    try:
        with safe_open(source, framework="numpy") as file:
            entry = (file.metadata() or {}).get(ENTRY)
            kept = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118 (no mapping)
    except (SafetensorError, OSError, ValueError, OverflowError, MemoryError, TypeError) as error:
        raise InputError(f"{source}: it is no weights file, or damaged: {_REMEDY}.") from error
    if entry is None:
        raise InputError(f"{source}: it is a safetensors file without the entry {ENTRY}: {_REMEDY}.")
    content = _content(source, entry)
    schema = content["network"].get("schema")
    if schema != SCHEMA:
        advice = "install a newer loomlight" if isinstance(schema, int) and schema > SCHEMA else "train again"
        raise InputError(f"{source}: its schema is {schema!r}, and this loomlight reads {SCHEMA}: {advice}.")
    found = checksum(content["network"], kept)
    if content.get("checksum") != found:
        raise InputError(f"{source}: its content does not fit its checksum, so it is damaged: {_REMEDY}.")
    try:
        header = Header.model_validate(content["network"])
    except (ValidationError, RecursionError) as error:
        raise InputError(f"{source}: its header does not describe a network: {_REMEDY}.") from error
    for name, shape in decoder_shapes(header.shape).items():
        if name not in kept or kept[name].shape != shape:
            raise InputError(f"{source}: its tensors are not those of the network in its header: {_REMEDY}.")
    return Weights(
        table=header.shape,
        tensors={name: values.astype(np.float32) for name, values in kept.items()},
        linear_diffuse=header.linear_diffuse,
        trained=header.trained,
        recipe=header.recipe,
        provenance=header.provenance,
        sha256=found,
        source=source,
    )


def decoder_shapes(table: NetworkTable) -> dict[str, tuple[int, ...]]:
    """Shapes of the decoder's weights [outputs, inputs] and biases [outputs]; see `network.Decoder`."""
    hidden = table.hidden
    spatial = table.latent_size + (3 * BINS if table.position == "one_blob" else 3)
    fused = hidden if table.fusion else spatial
    directions = 5 + (LIGHT_FEATURES + VIEW_FEATURES if table.fibres else 0)
    widths = {
        "angular": [fused + directions, *[hidden] * (4 if table.fusion else 6), table.outputs],
        "hole": [fused + 2, 16, 1],
    }
    if table.fusion:
        widths["fusion"] = [spatial, hidden, hidden]
    shapes: dict[str, tuple[int, ...]] = {}
    for part, sizes in widths.items():
        for number, (before, after) in enumerate(pairwise(sizes)):
            shapes[f"decoder.{part}.{number}.weight"] = after, before
            shapes[f"decoder.{part}.{number}.bias"] = (after,)
    return shapes


@cache
def shipped_weights() -> Weights:
    """The network that comes with the package."""
    with as_file(files("loomlight.models.neural") / "weights" / "neural.safetensors") as path:
        return read_weights(path)


@cache
def shipped_decoder() -> bytes:
    """The decoder of `shipped_weights` as ONNX, written by `studies/papers/chen2024/training/decoder.py`."""
    return (files("loomlight.models.neural") / "weights" / "neural_decoder.onnx").read_bytes()


def _content(source: str, entry: str) -> dict[str, Any]:
    try:
        content = json.loads(entry)
    except (ValueError, RecursionError):
        content = None
    if not isinstance(content, dict) or not isinstance(content.get("network"), dict):
        raise InputError(f"{source}: its header is damaged: {_REMEDY}.")
    return content


# ------------------------------------------------------------------------------------------- parameter ranges
# Ranges of parameters: the fabrics that the universal network is trained for and evaluated on.
#
# chen2024's Table 2, which gives the distributions, is missing from its text. The ranges here cover the
# usual suggestions (plain 22°/16°, twill 24° with a twist of 30°, satin 60°/35°) and α and β of at least
# 0.2 to 0.8. Gap, blend of the diffuse term and optical depth are the paper's, one value each, and both
# families are set alike. Cloth is not: denim has hardly a gap between its ends and wide ones between its
# picks, organza is half holes, a satin has two ends a pick. `LAYOUT_RANGES` are the same with such layouts.
# `TRAINING_RANGES` are wider, as a network errs most at the ends of its ranges: silk, smooth and dense,
# shows it.


# Relative to a range: of values that a file gives in other units, or that are computed.
_ROUNDING = 1e-3


@dataclass(frozen=True)
class ParameterRanges:
    """Ranges of the parameters of each yarn family, drawn independently: uniformly, α in its logarithm.

    Attributes:
        inclination_deg: U of plain weaves and twills, degrees.
        satin_inclination_deg: U of satins, degrees.
        twist_deg: ψ, degrees.
        roughness: α.
        height_scale: β.
        gap: fraction of the spacing left open, of each family, below 0.02 as 0.02; small ones more often.
        sett_ratio: ends per pick of the same length; drawn in its logarithm.
        diffuse_blend: w.
        optical_depth: Tρ.
    """

    inclination_deg: tuple[float, float] = (10.0, 40.0)
    satin_inclination_deg: tuple[float, float] = (10.0, 60.0)
    twist_deg: tuple[float, float] = (-45.0, 45.0)
    roughness: tuple[float, float] = (0.1, 1.0)
    height_scale: tuple[float, float] = (0.2, 1.0)
    gap: tuple[float, float] = (GAP, GAP)
    sett_ratio: tuple[float, float] = (1.0, 1.0)
    diffuse_blend: float = 0.5
    optical_depth: float = 2.0


PARAMETER_RANGES = ParameterRanges()
LAYOUT_RANGES = replace(PARAMETER_RANGES, gap=(0.0, 0.7), sett_ratio=(0.4, 2.5))
TRAINING_RANGES = replace(
    LAYOUT_RANGES,
    inclination_deg=(5.0, 40.0),
    satin_inclination_deg=(5.0, 60.0),
    roughness=(0.07, 1.0),
    sett_ratio=(1 / 3, 3.0),
)


def trained_ranges(weights: Weights) -> ParameterRanges:
    """The ranges that the network was trained for."""
    varied = weights.recipe.get("data", {}).get("layouts") == "varied"
    return TRAINING_RANGES if varied else PARAMETER_RANGES


def warn_outside_ranges(fabric: Fabric, ranges: ParameterRanges) -> None:
    """Warns of a fabric outside the ranges that the network was trained for, and names the fields."""
    layout, appearance = fabric.layout(), fabric.appearance()
    satin = structure_of(fabric.draft.drawdown) is Structure.SATIN
    fields: list[tuple[str, float, tuple[float, float]]] = [
        ("diffuse_blend", appearance.diffuse_blend, (ranges.diffuse_blend,) * 2),
        ("optical_depth", appearance.optical_depth, (ranges.optical_depth,) * 2),
    ]
    for family in ("warp", "weft"):
        yarn, lobes = getattr(layout, family), getattr(appearance, family)
        gaps = 1 - yarn.width / yarn.spacing
        fields += [
            (f"{family}.roughness", lobes.roughness, ranges.roughness),
            (f"{family}.height_scale", yarn.height_scale, ranges.height_scale),
            (
                f"{family}.inclination_deg",
                math.degrees(yarn.inclination),
                ranges.satin_inclination_deg if satin else ranges.inclination_deg,
            ),
            (f"{family}.twist_deg", math.degrees(yarn.twist), ranges.twist_deg),
            (f"{family}.gap", _farthest(gaps, ranges.gap), ranges.gap),
        ]
    ratio = float(np.mean(layout.weft.spacing) / np.mean(layout.warp.spacing))
    fields.append(("ends per pick", ratio, ranges.sett_ratio))
    outside = [
        f"{name} = {value:.4g} ({low:g}{f' to {high:g}' if high > low else ''})"
        for name, value, (low, high) in fields
        if not low - _ROUNDING <= value <= high + _ROUNDING
    ]
    if outside:
        warnings.warn(
            f"{fabric.name}: {', '.join(outside)}: the model neural was trained on what stands in brackets, "
            "so it may be off here.",
            LoomlightWarning,
            stacklevel=3,
        )


def _farthest(values: NDArray[np.float64], bounds: tuple[float, float]) -> float:
    """The value that lies farthest outside, or deepest inside."""
    return float(values[np.abs(values - np.mean(bounds)).argmax()])
