"""Models by name, and what answers queries for their trainings, each imported when it is first asked for.

This is the one list of both; what needs a renderer is named here too, and imports it when it is used.

An entry here is all that a model needs to become a name of the command line, a material file, a BSDF of
Mitsuba and a row of the query benchmark; it must pass the tests of models in tests/contract.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.core.sentences import closest, shown, speaking_of
from loomlight.core.settings import declared, require_names
from loomlight.core.tables import Tables
from loomlight.models.interface import Model
from loomlight.models.options import Options, is_source
from loomlight.sources.kinds import Source, kind_of_source
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import FIRST_USABLE_SCHEMA, LoomFile, read_loom

if TYPE_CHECKING:
    from loomlight.models.texture.queries import Btf


@dataclass(frozen=True)
class Shaders:
    """What `realtime` and `export` know of a model's shaders.

    Attributes:
        kernel: entry point that shades the pixels of a frame; `cloth_NAME` is the library for engines.
        computes: what the library's `cloth_value` computes, a phrase.
        cost: of it, counted by studies/speed/realtime.py: denim, one light.
        tables: module and class, "module:Class", of the `Tables` that declare its record; "" for none.
        buffers: that the library reads, of `realtime.records.BUFFERS`.
        reads_yarns: whether shaders read yarns and colours of a fabric.
        bakes_on_adapter: whether kernels can bake its tables.
        second: a further function of the library, if there is one: `cloth_estimate` takes a seed too,
            `cloth_auxiliary` a part in place of the light.
    """

    kernel: str
    computes: str
    cost: str
    tables: str = ""
    buffers: tuple[str, ...] = ("fabrics", "families", "words")
    reads_yarns: bool = True
    bakes_on_adapter: bool = False
    second: str | None = None

    def declared_tables(self) -> type[Tables] | None:
        """The class that declares what shaders read; None for a model without tables."""
        if not self.tables:
            return None
        module, _, name = self.tables.partition(":")
        found: type[Tables] = getattr(import_module(module), name)
        return found


@dataclass(frozen=True)
class ModelEntry:
    """Where a model is found, and what shades it in real time.

    Attributes:
        module, class_name: its class.
        plugin: name of its BSDF in Mitsuba.
        summary: what it is, for a list of models.
        extra: of a model that evaluates a network, by kernels of llvmlite: what brings that.
        baking_extra: what brings all that baking it needs, where that is more.
        shaders: None for a model without.
    """

    module: str
    class_name: str
    plugin: str
    summary: str = ""
    extra: str = ""
    baking_extra: str = ""
    shaders: Shaders | None = None


_FOOTPRINT = "the mean over the footprint of a pixel: one call a pixel and light"
_GUIDES = (
    "`cloth_auxiliary`, without the light and with a `part` as its last argument, gives what guides a "
    "denoiser: part 1 the mean albedo and, fourth, the roughness α, 2 the normal"
)
_NETWORKS = ("fabrics", "words", "packed_numbers")
MODELS: dict[str, ModelEntry] = {
    "lobes": ModelEntry(
        "loomlight.models.lobes.model",
        "LobesModel",
        "woven_lobes",
        "prefiltered: each sample averages over its pixel; the default",
        shaders=Shaders(
            "shade_lobes",
            f"{_FOOTPRINT}; {_GUIDES}",
            "About 7,000 floating-point operations a pixel and light far away and close by, 19,000 where a "
            "pixel is about half a thread. Far away 60 frames a second of 1920 × 1080 take 0.7 TFLOP/s; the "
            "tables stay in the caches.",
            "loomlight.models.lobes.tables:LobeTables",
            bakes_on_adapter=True,
            second="cloth_auxiliary",
        ),
    ),
    "point": ModelEntry(
        "loomlight.models.point",
        "PointModel",
        "woven_point",
        "single yarn points: exact, but noisy where threads are small",
        shaders=Shaders(
            "shade_points",
            f"one point of the cloth, `centre`; average several centres a pixel; {_GUIDES}",
            "About 3,000 floating-point operations for each point of a pixel and light.",
            second="cloth_auxiliary",
        ),
    ),
    "samples": ModelEntry(
        "loomlight.models.point",
        "SampledModel",
        "woven_samples",
        "means of 32 points of the pixel each: slow, to compare with",
    ),
    "neural": ModelEntry(
        "loomlight.models.neural.model",
        "NeuralModel",
        "woven_neural",
        "the network of Chen et al. 2024, for repeats of up to 64 threads",
        extra="neural",
        shaders=Shaders(
            "shade_neural",
            _FOOTPRINT,
            "About 170,000 floating-point operations a pixel, 34,000 for each further light of a pixel where "
            "the part that depends on the view alone is kept.",
            "loomlight.models.neural.encoded_fabric:EncodedFabric",
            ("fabrics", "families", "words", "packed_numbers"),
        ),
    ),
    "clustered": ModelEntry(
        "loomlight.models.clustered.model",
        "ClusteredModel",
        "woven_clustered",
        "maps of texels by clustered control variates (Zhu et al. 2024)",
        shaders=Shaders(
            "shade_clustered",
            "the base over the footprint of a pixel, without noise; `cloth_estimate`, with another `seed` "
            "for every pixel and frame as its last argument, adds texels to it: the mean is that of the "
            "surface",
            "For the base of a pixel and light 1,600 to 3,600 floating-point operations, more where a pixel "
            "shows more clusters; with two texels 2,400 to 4,400.",
            "loomlight.models.clustered.tables:ClusterTables",
            second="cloth_estimate",
        ),
    ),
    "neumip": ModelEntry(
        "loomlight.models.texture.neumip",
        "NeumipModel",
        "neumip",
        "a network trained for one source (NeuMIP, Kuznetsov et al. 2021)",
        extra="networks",
        baking_extra="train",
        shaders=Shaders(
            "shade_neumip",
            _FOOTPRINT,
            "About 13,000 floating-point operations a pixel and light for a source with holes that light "
            "passes through, 9,000 for an opaque one; a further light of a pixel repeats 4,000.",
            "loomlight.models.texture.tables:NeumipTables",
            _NETWORKS,
        ),
    ),
    "latent": ModelEntry(
        "loomlight.models.texture.latent",
        "LatentModel",
        "latent",
        "network and sampler trained for one source (Zeltner et al. 2024)",
        extra="networks",
        baking_extra="train",
        shaders=Shaders(
            "shade_latent",
            f"{_FOOTPRINT}; {_GUIDES}",
            "About 5,000 floating-point operations a pixel and light with the decoder 2x32, 2,300 with 2x16, "
            "24,000 with 3x64.",
            "loomlight.models.texture.tables:LatentTables",
            _NETWORKS,
            reads_yarns=False,
            second="cloth_auxiliary",
        ),
    ),
}


@dataclass(frozen=True)
class BtfEntry:
    """Where what answers queries of a kind of source is found.

    Attributes:
        module, class_name: its class, a `Btf` (`models/texture/queries.py`) that is made of a source.
        models: that are trained for such sources; `latent` takes an `EncodedBtf`.
    """

    module: str
    class_name: str
    models: tuple[str, ...]


# By kind of source, a name of `SOURCE_KINDS`.
BTFS: dict[str, BtfEntry] = {
    "fabric": BtfEntry("loomlight.models.texture.btfs", "FabricBtf", ("neumip", "latent")),
    "heightfield": BtfEntry("loomlight.mitsuba.traced_btf", "HeightfieldBtf", ("neumip",)),
    "tile": BtfEntry("loomlight.mitsuba.traced_btf", "TileBtf", ("neumip",)),
    "btf": BtfEntry("loomlight.models.texture.btfs", "PictureBtf", ("neumip",)),
    "material": BtfEntry("loomlight.mitsuba.material_btf", "MaterialBtf", ("latent",)),
    "u3m": BtfEntry("loomlight.models.standard.btf", "U3mBtf", ("latent",)),
    "merl": BtfEntry("loomlight.models.texture.btfs", "MerlBtf", ("latent",)),
}
# Models of one kind of source, which show it as it is, without baking: module and class.
OWN_MODELS = {"u3m": ("loomlight.models.standard.model", "StandardModel")}
# Compiles the kernels of networks.
_KERNELS = "llvmlite"
DEFAULT_MODEL = "lobes"
# What pictures of other models are judged by.
REFERENCE_MODEL = "point"
# Of the models that shaders shade with, in real time and in exported libraries.
REALTIME_MODELS = {name: entry.shaders for name, entry in MODELS.items() if entry.shaders is not None}


def model_names() -> tuple[str, ...]:
    """Names of all models."""
    return tuple(MODELS)


def require_model_name(name: str) -> None:
    """Raises InputError unless there is a model of that name; the message names one like it."""
    if name not in MODELS:
        raise InputError(f"model {shown(name)} does not exist: {closest(name, MODELS)}")


def is_installed(name: str) -> bool:
    """Whether what `model_class` needs of the model `name` is there."""
    return not MODELS[name].extra or find_spec(_KERNELS) is not None


def model_class(name: str, to_bake: bool = False) -> type[Model]:
    """The class of the model `name`.

    Args:
        to_bake: whether the model is baked: the sentence then names the extra that baking needs.

    Raises:
        InputError: there is none of that name.
        MissingDependencyError: it has a network, and llvmlite is not installed.
    """
    require_model_name(name)
    entry = MODELS[name]
    if entry.extra:
        extra = entry.baking_extra if to_bake and entry.baking_extra else entry.extra
        import_extra(_KERNELS, extra, f"{'Baking the' if to_bake else 'The'} model {name}")
    found: type[Model] = getattr(import_module(entry.module), entry.class_name)
    return found


def options_of(name: str, given: Options | Mapping[str, Any] | None = None, **values: object) -> Options:
    """The options of the model `name`, of values by name or made already; without any, the defaults.

    Args:
        values: some of them, in the place of those that are given.

    Raises:
        InputError: no such model, or an option or value that it does not have; the message names it.
    """
    kind = model_class(name).options_class
    if not isinstance(given, Options):
        return kind.of({**(given or {}), **values})
    if not isinstance(given, kind):
        raise InputError(f"{type(given).__name__} is no choice of the model {name}: give {kind.__name__}.")
    return given.changed(**values)


def parse_options(name: str, texts: Iterable[str]) -> Options:
    """The options of the model `name`, of texts "option=value".

    Raises:
        InputError: no such model or option, or a value that the option does not take.
    """
    model = model_class(name)
    kind = model.options_class
    values: dict[str, Any] = {}
    for text in texts:
        option, equals, value = text.partition("=")
        if not equals:
            raise InputError(f'{shown(text)} is no option: write its name, "=" and its value.')
        require_names(kind, [option])
        found = declared(kind)[option]
        values[option] = load_source(value, model.source_kind) if is_source(found) else found.value_of(value)
    return kind.of(values)


def make_model(name: str, source: Source, options: Options | None = None, **values: Any) -> Model:
    """The model `name`, baked for a source.

    Args:
        options: by default those of the model.
        values: some of them by name.

    Raises:
        InputError: there is none of that name, or it cannot handle this source or option.
    """
    return model_class(name, to_bake=True).for_source(source, options_of(name, options, **values))


def own_model(source: Source) -> Model | None:
    """The model that shows a source as it is; None for one that has to be baked."""
    entry = OWN_MODELS.get(kind_of_source(source))
    if entry is None:
        return None
    found: type[Model] = getattr(import_module(entry[0]), entry[1])
    return found.for_source(source)


def btf_of(source: Source, model: str) -> Btf:
    """What answers the queries that a model is trained with.

    Raises:
        InputError: a kind of source that the model is not trained for, or a source that cannot be used.
    """
    kind = kind_of_source(source)
    if kind not in BTFS or model not in BTFS[kind].models:
        taken = ", ".join(name for name, entry in BTFS.items() if model in entry.models)
        raise InputError(
            f"{source.name} is a {kind}, of which {model} can take no queries: it takes those of {taken}."
        )
    found: Btf = getattr(import_module(BTFS[kind].module), BTFS[kind].class_name)(source)
    return found


def untrained(name: str, source: str = "SOURCE") -> InputError:
    """What is raised where the model `name` would have to be trained, and nobody has asked for minutes of it.

    Args:
        source: the path of what it would be trained for.
    """
    return InputError(
        f"{name} is trained for one source, which takes minutes: bake it with "
        f"`loomlight bake {source} --model {name} -o x.loom`, and give that file."
    )


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
