"""The models that frames and exported libraries shade with, by name. This is the one list of them.

A material is a fabric, or a model that is made already, such as the one that a `.loom` holds: its source
need not be a fabric. `prepared_for` gives what shaders need of a material beside its yarns, and `pack_model`
writes that into tables and into the record of the fabric.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any, TypeAlias

import numpy as np

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.clustered.model import ClusteredModel
from loomlight.models.interface import Model
from loomlight.models.lobes.model import DEFAULT_GROUPS, LobesModel, tables_of
from loomlight.models.lobes.tables import LobeTables
from loomlight.models.registry import is_installed, make_model, model_class, model_of_loom, untrained
from loomlight.realtime.bake import BakePlan
from loomlight.realtime.clustered_tables import pack_clustered
from loomlight.realtime.lobes_tables import pack_lobes, reserve_lobes
from loomlight.realtime.word_table import Tables
from loomlight.sources.kinds import Source
from loomlight.sources.load import fabric_of_path
from loomlight.sources.loom_file import is_loom, read_loom
from loomlight.yarn.layout import ClothLayout

Material: TypeAlias = Fabric | Model
Prepared: TypeAlias = LobeTables | BakePlan | Model | None
"""Data of a model that its shaders read beside a fabric's yarns."""
Packer: TypeAlias = Callable[[np.void, Any, ClothLayout | None, Tables], None]

# Of models without a network; the others need llvmlite, and are imported with their models.
_PACKERS: dict[type, Packer] = {
    LobeTables: pack_lobes,
    BakePlan: reserve_lobes,
    ClusteredModel: pack_clustered,
}
_TABLES = ("fabrics", "families", "words")
_NETWORKS = ("fabrics", "words", "packed_numbers")
_FOOTPRINT = "the mean over the footprint of a pixel: one call a pixel and light"


@dataclass(frozen=True)
class RealtimeModel:
    """Kernel, buffers and cost of a model's shaders.

    Attributes:
        kernel: entry point that shades the pixels of a frame; `cloth_NAME` is the library for engines.
        buffers: that the library reads, of `layout.BUFFERS`.
        computes: what the library's `cloth_value` computes, a phrase.
        cost: of it, counted by benchmarks/realtime.py: denim, one light.
        prepare: what the model needs of a material; None for nothing.
        reads_yarns: whether its shaders read yarns and colours of a fabric.
        bakes_on_adapter: whether kernels can bake its tables.
        has_estimate: whether the library has `cloth_estimate` beside `cloth_value`, which takes a seed too.
    """

    kernel: str
    buffers: tuple[str, ...]
    computes: str
    cost: str
    prepare: Callable[[Material], Prepared]
    reads_yarns: bool = True
    bakes_on_adapter: bool = False
    has_estimate: bool = False


def _lobe_tables(material: Material) -> LobeTables:
    if isinstance(material, LobesModel):
        return material.tables
    return tables_of(fabric_for(material, LobesModel.name), DEFAULT_GROUPS)


def _made(name: str) -> Callable[[Material], Any]:
    """The model itself, made for the source unless it is that model already."""

    def made(material: Material) -> Model:
        if isinstance(material, Model) and material.name == name:
            return material
        source = source_of(material)
        if model_class(name).trains:
            raise untrained(name)
        return make_model(name, source)

    return made


REALTIME_MODELS: dict[str, RealtimeModel] = {
    "lobes": RealtimeModel(
        "shade_lobes",
        _TABLES,
        _FOOTPRINT,
        "About 7,000 floating-point operations a pixel and light far away and close by, 19,000 where a pixel "
        "is about half a thread. Far away 60 frames a second of 1920 × 1080 take 0.7 TFLOP/s; the tables "
        "stay in the caches.",
        _lobe_tables,
        bakes_on_adapter=True,
    ),
    "point": RealtimeModel(
        "shade_points",
        _TABLES,
        "one point of the cloth, `centre`; average several centres a pixel",
        "About 3,000 floating-point operations for each point of a pixel and light.",
        lambda material: None,
    ),
    "neural": RealtimeModel(
        "shade_neural",
        (*_TABLES, "packed_numbers"),
        _FOOTPRINT,
        "About 170,000 floating-point operations a pixel, 34,000 for each further light of a pixel where the "
        "part that depends on the view alone is kept.",
        _made("neural"),
    ),
    "clustered": RealtimeModel(
        "shade_clustered",
        _TABLES,
        "the base over the footprint of a pixel, without noise; `cloth_estimate`, with another `seed` for "
        "every pixel and frame as its last argument, adds texels to it: the mean is that of the surface",
        "For the base of a pixel and light 1,600 to 3,600 floating-point operations, more where a pixel "
        "shows more clusters; with two texels 2,400 to 4,400.",
        _made("clustered"),
        has_estimate=True,
    ),
    "neumip": RealtimeModel(
        "shade_neumip",
        _NETWORKS,
        _FOOTPRINT,
        "About 13,000 floating-point operations a pixel and light for a source with holes that light passes "
        "through, 9,000 for an opaque one; a further light of a pixel repeats 4,000.",
        _made("neumip"),
    ),
    "latent": RealtimeModel(
        "shade_latent",
        _NETWORKS,
        _FOOTPRINT,
        "About 5,000 floating-point operations a pixel and light with the decoder 2x32, 2,300 with 2x16, "
        "24,000 with 3x64.",
        _made("latent"),
        reads_yarns=False,
    ),
}


def require_realtime_model(name: str) -> None:
    """Raises InputError unless there is a model of that name here."""
    if name not in REALTIME_MODELS:
        raise InputError(f'model = "{name}" is unknown here: use {" or ".join(REALTIME_MODELS)}.')


def material_of(material: Material | str | os.PathLike[str]) -> Material:
    """The material of a path: the model of a `.loom`, where there is one of it here, else the fabric.

    Raises:
        InputError: no such file, or neither.
    """
    if isinstance(material, Fabric | Model):
        return material
    if is_loom(material):
        loom = read_loom(material)
        if loom.model in REALTIME_MODELS:
            return model_of_loom(loom)
    return fabric_of_path(material)


def default_model_of(material: Material) -> str:
    """The name of the model that a material is, where there is one of it here, else lobes."""
    is_here = isinstance(material, Model) and material.name in REALTIME_MODELS
    return material.name if is_here else LobesModel.name


def models_of(material: Material) -> tuple[str, ...]:
    """Names of the models here that a material can be shaded with, its own first."""
    own = default_model_of(material)
    if yarns_of(material) is None:
        return (own,)
    others = [name for name in REALTIME_MODELS if name != own and is_installed(name)]
    return own, *(name for name in others if not model_class(name).trains)


def yarns_of(material: Material) -> Fabric | None:
    """The fabric of a material; None of another source."""
    source = source_of(material)
    return source if isinstance(source, Fabric) else None


def look_of(material: Material, name: str) -> tuple[Any, Any] | None:
    """Yarns and appearance for `pack_fabrics`, as the model `name` reads them.

    Raises:
        InputError: it needs yarns, and the material has none.
    """
    if not REALTIME_MODELS[name].reads_yarns:
        return None
    fabric = yarns_of(material)
    if fabric is None:
        if isinstance(material, Model) and material.name == name:
            return None
        fabric = fabric_for(material, name)
    return fabric.layout(), fabric.appearance()


def prepared_for(material: Material, name: str) -> Prepared:
    """Data that the model `name` reads beside a material's yarns; some bake it for seconds.

    Raises:
        InputError: a material that the model does not take, or for which it would have to be trained.
    """
    return REALTIME_MODELS[name].prepare(material)


def pack_model(record: np.void, prepared: Prepared, layout: ClothLayout | None, tables: Tables) -> None:
    """Appends what a model needs to tables, and writes where into the record of the fabric.

    Args:
        layout: of the yarns; None for a source that is no fabric.
    """
    if prepared is None:
        return
    pack = _PACKERS.get(type(prepared))
    if pack is None:
        assert isinstance(prepared, Model)
        module = import_module(f"loomlight.realtime.{prepared.name}_tables")
        pack = getattr(module, f"pack_{prepared.name}")
    pack(record, prepared, layout, tables)


def source_of(material: Material) -> Source:
    """The source of a material: the fabric, or the one that the model was made of."""
    return material.source if isinstance(material, Model) else material


def fabric_for(material: Material, name: str) -> Fabric:
    """The fabric of a material.

    Raises:
        InputError: the source is none.
    """
    fabric = yarns_of(material)
    if fabric is None:
        raise InputError(f'"{source_of(material).name}" is no fabric: {name} shows fabrics alone.')
    return fabric
