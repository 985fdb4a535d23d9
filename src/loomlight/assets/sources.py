"""Sources: what a model is a model of, and how a `.loom` holds it. One entry a kind.

Models, the material file and the renderer know a source by this protocol alone; a kind that is added here is
read and written by every `.loom`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

from numpy.typing import NDArray

from loomlight.assets.fabric_record import fabric_from_record, fabric_record
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.load import load_fabric

Tensors = Mapping[str, NDArray[Any]]


class Source(Protocol):
    """What a model is a model of: a fabric, or any other surface that repeats."""

    @property
    def name(self) -> str:
        """What to call it."""

    @property
    def repeat_mm(self) -> tuple[float, float]:
        """Width and height of one repeat, millimetres."""

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """Millimetres per unit of u and of v where nobody says so."""


@dataclass(frozen=True)
class SourceKind:
    """How sources of one kind are stored and read.

    Attributes:
        type: their class.
        record: the JSON that a `.loom` holds of a source, and the tensors beside it.
        from_record: the source of those and of the folder that the `.loom` lies in; raises InputError or
            pydantic's ValidationError.
        load: the source that a path (no `.loom`) or a name stands for; raises InputError.
    """

    type: type
    record: Callable[[Any], tuple[dict[str, Any], dict[str, NDArray[Any]]]]
    from_record: Callable[[Mapping[str, Any], Tensors, str], Any]
    load: Callable[[str | os.PathLike[str]], Any]


SOURCE_KINDS: dict[str, SourceKind] = {
    "fabric": SourceKind(Fabric, fabric_record, fabric_from_record, load_fabric),
}


def kind_of_source(source: Source) -> str:
    """The name of a source's kind.

    Raises:
        TypeError: it is of none.
    """
    for name, kind in SOURCE_KINDS.items():
        if isinstance(source, kind.type):
            return name
    raise TypeError(f"{type(source).__name__} is no kind of source")
