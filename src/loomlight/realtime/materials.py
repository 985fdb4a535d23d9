"""Materials as frames and exported libraries shade them, by the models of `REALTIME_MODELS`.

A material is a fabric, or a model that is made already, such as the one that a `.loom` holds: its source
need not be a fabric. `tables_for` gives what shaders need of a material beside its yarns.
"""

from __future__ import annotations

import os
from typing import Any, TypeAlias, cast

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model, ShaderTables
from loomlight.models.registry import (
    DEFAULT_MODEL,
    OWN_MODELS,
    REALTIME_MODELS,
    is_installed,
    make_model,
    model_class,
    model_of_loom,
    own_model,
    untrained,
)
from loomlight.sources.kinds import Source, kind_of_file
from loomlight.sources.load import fabric_of_path, load_source
from loomlight.sources.loom_file import is_loom, read_loom

Material: TypeAlias = Fabric | Model


def require_realtime_model(name: str) -> None:
    """Raises InputError unless there is a model of that name here."""
    if name not in REALTIME_MODELS:
        raise InputError(f'model = "{name}" is unknown here: use {" or ".join(REALTIME_MODELS)}.')


def material_of(material: Material | str | os.PathLike[str]) -> Material:
    """The material of a path: the model of a `.loom`, where there is one of it here, else the fabric.

    Of a source that has a model of its own, such as a U3M, it is that model.

    Raises:
        InputError: no such file, or none of these.
    """
    if isinstance(material, Fabric | Model):
        return material
    if is_loom(material):
        loom = read_loom(material)
        if loom.model in REALTIME_MODELS:
            return model_of_loom(loom)
    elif kind_of_file(material, "fabric") in OWN_MODELS:
        return cast(Model, own_model(load_source(material)))
    return fabric_of_path(material)


def default_model_of(material: Material) -> str:
    """The name of the model that a material is, where there is one of it here, else the default one."""
    is_here = isinstance(material, Model) and material.name in REALTIME_MODELS
    return material.name if is_here else DEFAULT_MODEL


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


def model_for(material: Material, name: str) -> Model:
    """The model `name` of a material's source, baked unless the material is that model already.

    Raises:
        InputError: a material that the model does not take, or for which it would have to be trained.
    """
    if isinstance(material, Model) and material.name == name:
        return material
    if model_class(name).trains:
        raise untrained(name)
    return make_model(name, source_of(material))


def tables_for(material: Material, name: str) -> ShaderTables | None:
    """What the model `name` reads beside a material's yarns; some models are baked for seconds.

    Raises:
        InputError: a material that the model does not take, or for which it would have to be trained.
    """
    return model_for(material, name).shader_tables() if REALTIME_MODELS[name].tables else None


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
