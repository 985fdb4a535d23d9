"""Models by name, each imported when it is first asked for."""

from __future__ import annotations

import os
from importlib import import_module

from loomlight.assets.loom_file import LoomFile, read_loom
from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.reading import speaking_of
from loomlight.fabric.sentences import closest, shown
from loomlight.models.interface import Model

# Module and class; a model that is listed here must pass tests/models/test_contract.py.
_HOMES = {
    "lobes": ("loomlight.models.lobes.model", "LobesModel"),
    "point": ("loomlight.models.point", "PointFootprint"),
    "samples": ("loomlight.models.samples", "FootprintSamples"),
    "woven": ("loomlight.models.woven.model", "WovenModel"),
}


def model_names() -> tuple[str, ...]:
    """Names of all models."""
    return tuple(_HOMES)


def require_model_name(name: str) -> None:
    """Returns if there is a model of that name.

    Raises:
        InputError: there is none; the message names one like it.
    """
    if name not in _HOMES:
        raise InputError(f"model {shown(name)} does not exist: {closest(name, _HOMES)}")


def model_class(name: str) -> type[Model]:
    """The class of the model `name`.

    Raises:
        InputError: there is none of that name.
    """
    require_model_name(name)
    module, class_name = _HOMES[name]
    found: type[Model] = getattr(import_module(module), class_name)
    return found


def make_model(name: str, fabric: Fabric) -> Model:
    """The model `name`, baked for a fabric.

    Raises:
        InputError: there is none of that name, or it cannot handle this fabric.
    """
    return model_class(name).for_fabric(fabric)


def model_of_loom(loom: LoomFile) -> Model:
    """The model that a `.loom` file holds, without baking.

    Raises:
        InputError: a model that does not exist here, or contents that are not what it needs.
    """
    if loom.model not in _HOMES:
        raise InputError(
            f"{loom.source}: its model {shown(loom.model)} does not exist here: install a newer loomlight, "
            f"or bake it again with one of {', '.join(_HOMES)}."
        )
    with speaking_of(loom.source):
        return model_class(loom.model).from_loom(loom)


def model_from_loom(path: str | os.PathLike[str]) -> Model:
    """The model in the `.loom` file at `path`, without baking.

    Raises:
        InputError: no such file, no `.loom`, or one that this installation cannot use.
    """
    return model_of_loom(read_loom(path))
