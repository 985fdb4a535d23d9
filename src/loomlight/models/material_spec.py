"""A source and the model that stands for it, resolved once from whatever a user names."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric
from loomlight.fabric.surface_maps import with_maps
from loomlight.models.interface import Model
from loomlight.models.options import Options
from loomlight.models.registry import (
    DEFAULT_MODEL,
    make_model,
    model_class,
    model_of_loom,
    options_of,
    own_model,
    require_model_name,
    untrained,
)
from loomlight.sources.kinds import Source
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, is_loom, read_loom


@dataclass(frozen=True, eq=False)
class MaterialSpec:
    """A material before anything is baked; see `resolve`.

    Attributes:
        source: a fabric or another source.
        model_name: the name of the model.
        options: of the model; None for the defaults.
        held: the model itself where nothing is to be baked: one that is made already, or a `.loom`.
        replaces: the model that a `.loom` holds, where another one is meant; else empty.
    """

    source: Source
    model_name: str
    options: Options | None = None
    held: Model | LoomFile | None = None
    replaces: str = ""

    def model(self) -> Model:
        """The model: the one that is made already, or a new one, read or baked.

        Raises:
            InputError: a source or option that the model does not take, a `.loom` that it cannot use, or a
                model that would have to be trained first.
        """
        if isinstance(self.held, LoomFile):
            return model_of_loom(self.held)
        self.require_trained()
        return self.held or make_model(self.model_name, self.source, self.options)

    def require_trained(self) -> None:
        """Raises InputError if the model would have to be trained, for minutes that nobody has asked for."""
        if self.held is None and model_class(self.model_name).trains:
            raise untrained(self.model_name)

    def by(self, model_name: str) -> MaterialSpec:
        """The same source by another model, with the default options."""
        return MaterialSpec(self.source, model_name)

    def recoloured(self, colors: Mapping[str, Any]) -> MaterialSpec:
        """The material in other colours, "warp" and "weft", each as a fabric file's `color`.

        Raises:
            InputError: no fabric, a family that is neither warp nor weft, or what is no colour.
        """
        if not isinstance(self.source, Fabric):
            raise InputError(f"Colours of yarns go with fabrics, and {self.source.name} is none.")
        for family in colors:
            if family not in ("warp", "weft"):
                raise InputError(f'There are no yarns "{family}": colours are of warp or of weft.')
        fabric = edited_fabric(self.source, {f"{family}.color": value for family, value in colors.items()})
        held = None if self.held is None else self.model().with_source(fabric)
        return replace(self, source=fabric, held=held)

    def mapped(self, maps: Mapping[str, Any]) -> MaterialSpec:
        """The material with maps over the surface; see `with_maps`.

        Raises:
            InputError: no fabric, or a map that cannot be.
        """
        if not isinstance(self.source, Fabric):
            raise InputError(f"Maps go with fabrics, and {self.source.name} is none.")
        return replace(self, source=with_maps(self.source, maps), held=None)


# Whatever `resolve` takes: what users name a material by.
Material = MaterialSpec | Model | Source | str | os.PathLike[str]


def resolve(
    material: Material, model_name: str | None = None, options: Options | Mapping[str, Any] | None = None
) -> MaterialSpec:
    """The source and the model that a user means.

    Args:
        material: a fabric or another source; a model; or a path: a `.loom`, a fabric file, a draft, what
            else the model's sources are read from, or a weave's name.
        model_name: by default the one that a model or a `.loom` is, else `DEFAULT_MODEL`. Another than that
            is baked from their source.
        options: of the model, by name or made already; with any, it is baked even where a `.loom` holds it.

    Raises:
        InputError: no such model or option, or a material that cannot be read.
    """
    if model_name is not None:
        require_model_name(model_name)
    if isinstance(material, MaterialSpec):
        return material if model_name is None and not options else _spec(material.source, model_name, options)
    if isinstance(material, Model):
        if model_name in (None, material.name) and not options:
            return MaterialSpec(material.source, material.name, held=material)
        return _spec(material.source, model_name or material.name, options)
    if not isinstance(material, str | os.PathLike):
        return _spec(material, model_name, options)
    if is_loom(material):
        loom = read_loom(material)
        if model_name in (None, loom.model) and not options:
            return MaterialSpec(loom.source, loom.model, held=loom)
        spec = _spec(loom.source, model_name or loom.model, options)
        return replace(spec, replaces="" if spec.model_name == loom.model else loom.model)
    source = load_source(material, model_class(model_name or DEFAULT_MODEL).source_kind)
    return _spec(source, model_name, options)


def _spec(
    source: Source, model_name: str | None, options: Options | Mapping[str, Any] | None
) -> MaterialSpec:
    if model_name is None and not options and (shown := own_model(source)) is not None:
        return MaterialSpec(source, shown.name, held=shown)
    name = model_name or DEFAULT_MODEL
    return MaterialSpec(source, name, options_of(name, options))
