"""Models by name, each imported when it is first asked for. This is the one list of them.

An entry here is all that a model needs to become a name of the command line, a material file, a BSDF of
Mitsuba and a row of the query benchmark; it must pass tests/models/test_contract.py.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from loomlight.assets.loom_file import FIRST_USABLE_SCHEMA, LoomFile, read_loom
from loomlight.assets.sources import Source
from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.fabric.reading import speaking_of
from loomlight.fabric.sentences import closest, shown
from loomlight.models.interface import Model


@dataclass(frozen=True)
class ModelEntry:
    """Where a model is found.

    Attributes:
        module, class_name: its class.
        plugin: name of its BSDF in Mitsuba.
        summary: what it is, for a list of models.
        has_network: it evaluates a network, by kernels that LLVM compiles.
    """

    module: str
    class_name: str
    plugin: str
    summary: str = ""
    has_network: bool = False


MODELS: dict[str, ModelEntry] = {
    "lobes": ModelEntry(
        "loomlight.models.lobes.model",
        "LobesModel",
        "woven_lobes",
        "prefiltered: each sample averages over its pixel; the default",
    ),
    "point": ModelEntry(
        "loomlight.models.point",
        "PointModel",
        "woven_point",
        "single yarn points: exact, but noisy where threads are small",
    ),
    "samples": ModelEntry(
        "loomlight.models.samples",
        "SampledModel",
        "woven_samples",
        "means of 32 points of the pixel each: slow, to compare with",
    ),
    "neural": ModelEntry(
        "loomlight.models.neural.model",
        "NeuralModel",
        "woven_neural",
        "the network of Chen et al. 2024, for repeats of up to 64 threads",
        has_network=True,
    ),
    "clustered": ModelEntry(
        "loomlight.models.clustered.model",
        "ClusteredModel",
        "woven_clustered",
        "maps of texels by clustered control variates (Zhu et al. 2024)",
    ),
    "neumip": ModelEntry(
        "loomlight.models.neumip.model",
        "NeumipModel",
        "neumip",
        "a network trained for one source (NeuMIP, Kuznetsov et al. 2021)",
        has_network=True,
    ),
    "latent": ModelEntry(
        "loomlight.models.latent.model",
        "LatentModel",
        "latent",
        "network and sampler trained for one source (Zeltner et al. 2024)",
        has_network=True,
    ),
}
DEFAULT_MODEL = "lobes"
# What pictures of other models are judged by.
REFERENCE_MODEL = "point"


def model_names() -> tuple[str, ...]:
    """Names of all models."""
    return tuple(MODELS)


def require_model_name(name: str) -> None:
    """Raises InputError unless there is a model of that name; the message names one like it."""
    if name not in MODELS:
        raise InputError(f"model {shown(name)} does not exist: {closest(name, MODELS)}")


def model_class(name: str) -> type[Model]:
    """The class of the model `name`.

    Raises:
        InputError: there is none of that name.
        MissingDependencyError: it has a network, and llvmlite is not installed.
    """
    require_model_name(name)
    entry = MODELS[name]
    if entry.has_network:
        import_extra("llvmlite", "networks", f"The model {name}")
    found: type[Model] = getattr(import_module(entry.module), entry.class_name)
    return found


def make_model(name: str, source: Source, **options: Any) -> Model:
    """The model `name`, baked for a source.

    Args:
        options: see the model's `options`.

    Raises:
        InputError: there is none of that name, or it cannot handle this source or option.
    """
    return model_class(name).for_source(source, **options)


def model_of_loom(loom: LoomFile) -> Model:
    """The model that a `.loom` file holds, without baking.

    Raises:
        InputError: a model that does not exist here, or contents that are not what it needs.
    """
    if loom.model not in MODELS:
        raise InputError(
            f"{loom.file}: its model {shown(loom.model)} does not exist here: install a newer loomlight, "
            f"or bake it again with one of {', '.join(MODELS)}."
        )
    if loom.schema < FIRST_USABLE_SCHEMA:
        raise InputError(
            f"{loom.file} was baked by an older loomlight: bake it again, with "
            f"`loomlight bake {loom.file} --model {loom.model} -o {loom.file}`."
        )
    with speaking_of(loom.file):
        return model_class(loom.model).from_loom(loom)


def model_from_loom(path: str | os.PathLike[str]) -> Model:
    """The model in the `.loom` file at `path`, without baking.

    Raises:
        InputError: no such file, no `.loom`, or one that this installation cannot use.
    """
    return model_of_loom(read_loom(path))
