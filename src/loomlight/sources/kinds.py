"""Sources: the surfaces that models represent, such as fabrics, and their storage in a `.loom`.

Models, the material file and the renderer use a source by this protocol alone; a kind that is registered here
is read and written by every `.loom`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import load_fabric
from loomlight.sources.btf import (
    MeasuredBtf,
    is_btf_description,
    load_measured_btf,
    measured_btf_from_record,
    measured_btf_record,
)
from loomlight.sources.fabric import fabric_from_record, fabric_record
from loomlight.sources.heightfield import (
    Heightfield,
    heightfield_from_record,
    heightfield_record,
    is_heightfield_file,
    load_heightfield,
)
from loomlight.sources.material import (
    Material,
    is_material_file,
    load_material,
    material_from_record,
    material_record,
)
from loomlight.sources.merl import MerlLibrary, is_merl_file, load_merl, merl_from_record, merl_record
from loomlight.sources.tile import TileScene, is_tile_file, load_tile, tile_from_record, tile_record
from loomlight.sources.u3m import U3mMaterial, load_u3m, u3m_from_record, u3m_record
from loomlight.sources.u3m_file import is_u3m_file

Tensors = Mapping[str, NDArray[Any]]


class Source(Protocol):
    """A surface that a model represents: a fabric, or any other surface that repeats."""

    @property
    def name(self) -> str:
        """Name in messages and reports."""

    @property
    def repeat_mm(self) -> tuple[float, float]:
        """Width and height of one repeat, millimetres."""

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """Default millimetres per unit of u and of v."""


@dataclass(frozen=True)
class SourceKind:
    """Functions that store and read sources of one kind.

    Attributes:
        type: their class.
        record: a source to its JSON in a `.loom`, and its tensors.
        from_record: those and the folder of the `.loom` to a source; raises InputError or pydantic's
            ValidationError.
        load: a path (no `.loom`) or a name to a source; raises InputError.
        recognises: whether a file says itself that it is of this kind.
    """

    type: type
    record: Callable[[Any], tuple[dict[str, Any], dict[str, NDArray[Any]]]]
    from_record: Callable[[Mapping[str, Any], Tensors, str], Any]
    load: Callable[[str | os.PathLike[str]], Any]
    recognises: Callable[[str | os.PathLike[str]], bool] = lambda path: False


SOURCE_KINDS: dict[str, SourceKind] = {
    "fabric": SourceKind(Fabric, fabric_record, fabric_from_record, load_fabric),
    "heightfield": SourceKind(
        Heightfield, heightfield_record, heightfield_from_record, load_heightfield, is_heightfield_file
    ),
    "material": SourceKind(Material, material_record, material_from_record, load_material, is_material_file),
    "merl": SourceKind(MerlLibrary, merl_record, merl_from_record, load_merl, is_merl_file),
    "tile": SourceKind(TileScene, tile_record, tile_from_record, load_tile, is_tile_file),
    "u3m": SourceKind(U3mMaterial, u3m_record, u3m_from_record, load_u3m, is_u3m_file),
    "btf": SourceKind(
        MeasuredBtf, measured_btf_record, measured_btf_from_record, load_measured_btf, is_btf_description
    ),
}


def kind_of_file(path: str | os.PathLike[str], default: str) -> str:
    """The name of the kind that a file says it is of, else `default`."""
    return next((name for name, kind in SOURCE_KINDS.items() if kind.recognises(path)), default)


def kind_of_source(source: Source) -> str:
    """The name of a source's kind.

    Raises:
        TypeError: it is of none.
    """
    for name, kind in SOURCE_KINDS.items():
        if isinstance(source, kind.type):
            return name
    raise TypeError(f"{type(source).__name__} is no kind of source")
