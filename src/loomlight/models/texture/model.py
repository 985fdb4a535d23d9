"""Models of textures and networks that are trained for one source: what all of them share.

Textures are pyramids of neural texels (`pyramid.py`), networks small dense ones (`models/networks.py`).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, ClassVar, Generic, NoReturn, Protocol, TypeVar, final

import drjit as dr
import numpy as np
from numpy.typing import DTypeLike, NDArray

from loomlight.core.arrays import Color3, Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum
from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.core.files import cache_folder
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.networks import Layers
from loomlight.models.options import TrainingOptions
from loomlight.models.registry import untrained
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.settings import TrainingSettings
from loomlight.scattering.point import Tint, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile

# Texels a side that a file may have.
_MAX_TEXELS = 4096
# Smallest side of a footprint in texels: log2(0) has no value.
MIN_SIZE = 1e-9


class TexturedWeights(Protocol):
    """Numbers of a trained source.

    Attributes:
        shape: of the textures.
        reflectance: mean albedo of each face [faces, 3].
    """

    @property
    def shape(self) -> PyramidShape: ...
    @property
    def reflectance(self) -> NDArray[np.float32]: ...


WeightsT = TypeVar("WeightsT", bound=TexturedWeights)
DeviceT = TypeVar("DeviceT")


class TexturedBsdf(FootprintBsdf):
    """The BSDF of footprints for one view: their place in the textures, and the face that is seen."""

    def __init__(self, model: Any, view: Vec3, footprint: Footprint) -> None:
        super().__init__(view, footprint)
        self._model, self._weights = model, model.weights
        self._types = array_types(view.x)
        self._device = model.device_weights(self._types.Float)
        self._back = self._types.Bool(view.z < 0)
        self._facing = to_face_frame(view, self._back)

    @property
    def hole(self) -> Float:
        """0 in every lane: holes are part of the values, as black."""
        return dr.select(self._back, self._types.Float(0), 0)

    @property
    def diffuse_reflectance(self) -> Color3:
        """Mean albedo of the face that is seen, over all directions."""
        reflectance = self._weights.reflectance
        front, back = (self._types.Color3(*map(float, row)) for row in (reflectance[0], reflectance[-1]))
        return dr.select(self._back, back, front)

    @final
    def _place(self) -> tuple[Float, Float, Float, UInt]:
        """Position in repeats, log2 of the footprint's size over that of the finest level, and face."""
        types, shape = self._types, self._weights.shape
        face = dr.select(self._back, types.UInt32(shape.faces - 1), types.UInt32(0))
        u = self.footprint.centre.x * (1 / shape.width_mm)
        v = self.footprint.centre.y * (1 / shape.height_mm)
        side = maximum(self.footprint.square_side * (1 / shape.footprint_mm), MIN_SIZE)
        return u, v, dr.log2(side), face


class TexturedModel(Model, Generic[WeightsT, DeviceT]):
    """Textures and networks that are trained for one source.

    Attributes:
        bsdf: the class of its BSDFs.
        device: the class of `weights` on one backend.
        weights: what was trained.
        multiply_adds: of one query.
        bytes_fetched: by one query.
    """

    filters: ClassVar[bool] = True
    conserves_energy: ClassVar[bool] = False
    symbolic: ClassVar[bool] = False
    trains: ClassVar[bool] = True
    bsdf: ClassVar[type[TexturedBsdf]]
    device: ClassVar[Callable[..., Any]]
    multiply_adds: int
    bytes_fetched: int

    def __init__(self, source: Source, weights: WeightsT) -> None:
        self.source, self.weights = source, weights
        self._devices: dict[type, DeviceT] = {}

    @final
    def device_weights(self, float_type: FloatType) -> DeviceT:
        """Textures and networks on one backend, uploaded once."""
        if float_type not in self._devices:
            self._devices[float_type] = type(self).device(self.weights, float_type)
        return self._devices[float_type]

    def with_source(self, source: Source) -> NoReturn:
        """Refused: another source would have to be trained for.

        Raises:
            InputError: always.
        """
        raise untrained(self.name)

    def upload(self, types: ArrayTypes) -> None:
        """Puts textures and networks on a backend."""
        self.device_weights(types.Float)

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> TexturedBsdf:
        """The BSDF of footprints for one view each; it keeps no albedos apart, so `tint` is ignored."""
        del tint, active
        return self.bsdf(self, view, footprint)

    def facts(self) -> dict[str, str]:
        """The source, and the size of textures."""
        shape = self.weights.shape
        return {
            **super().facts(),
            "textures": f"{shape.columns} × {shape.rows} texels, {shape.levels} levels",
        }


def run_training(
    model: str,
    source: Source,
    settings: TrainingSettings,
    options: TrainingOptions,
    report: Report | None,
    **others: Any,
) -> Any:
    """The weights that the training of a model gives; one that was stopped goes on.

    Args:
        options: without a folder, queries and checkpoints stay in the cache until the end.
        others: arguments of the model's own training.

    Raises:
        InputError: a source of which no queries can be taken, or a device that is missing.
        MissingDependencyError: PyTorch is missing.
    """
    # On shared cores threads that spin while they wait make small batches many times slower.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    import_extra("torch", "train", f"Training {model}")
    # By name: only trainings need torch.
    import_module("loomlight.training.loop").require_device(options.device)
    train = getattr(import_module(f"loomlight.models.texture.{model}_training"), f"train_{model}")
    if options.folder is not None:
        return train(source, settings, Path(options.folder), report, options.device, **others)
    place = cache_folder(model) / settings.identity(source)[:16]
    weights = train(source, settings, place, report, options.device, **others)
    # A temporary folder copes at its end with files of other processes.
    with TemporaryDirectory(dir=place.parent) as temporary:
        place.rename(Path(temporary) / place.name)
    return weights


def tensors_of_layers(networks: Mapping[str, Layers]) -> dict[str, NDArray[np.float32]]:
    """Weights and biases of networks by the names that they have in a file."""
    return {
        f"{name}.{number}.{part}": values
        for name, layers in networks.items()
        for number, layer in enumerate(layers)
        for part, values in zip(("weight", "bias"), layer, strict=True)
    }


def layers_of_loom(loom: LoomFile, name: str, widths: Iterable[int], kind: DTypeLike = np.float32) -> Layers:
    """Weights and biases of a network in a file.

    Args:
        widths: of its layers, inputs first.

    Raises:
        InputError: tensors that are missing or of another shape.
    """
    return [
        (
            loom.tensor(f"{name}.{number}.weight", (outputs, inputs), kind),
            loom.tensor(f"{name}.{number}.bias", (outputs,), kind),
        )
        for number, (inputs, outputs) in enumerate(pairwise(widths))
    ]


def shape_of_loom(loom: LoomFile) -> PyramidShape:
    """The shape of the textures in a file: counts are powers of two.

    Raises:
        InputError: other counts.
    """
    counts = []
    limits = {"columns": _MAX_TEXELS, "rows": _MAX_TEXELS, "faces": 2, "footprint_texels": _MAX_TEXELS}
    for name, most in limits.items():
        # A texel's own, of files that say nothing.
        value = loom.setting(name, int) if name in loom.settings or name != "footprint_texels" else 1
        if not 1 <= value <= most or value & (value - 1):
            raise InputError(f"{loom.file}: {name} = {value} is wrong: it is a power of two up to {most}.")
        counts.append(value)
    columns, rows, faces, footprint = counts
    return PyramidShape(columns, rows, *loom.source.repeat_mm, faces, footprint_texels=footprint)
