"""Baking: a fabric and all that a model needs of it, as one `.loom` file."""

from __future__ import annotations

import os

from loomlight.assets.fabrics import fabric_of_path
from loomlight.assets.loom_file import write_loom
from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.models.registry import make_model, require_model_name


def bake(fabric: Fabric | str | os.PathLike[str], model: str, path: str | os.PathLike[str]) -> None:
    """Writes the material of a fabric by a model, whole or not at all; `model_from_loom` reads it.

    Args:
        fabric: a fabric, or the path of a fabric file, a draft or a `.loom`, or a weave's name.
        model: "point", "woven", …: see `loomlight.models.registry.model_names`.
        path: the `.loom` file.

    Raises:
        InputError: no such model, a fabric that cannot be read or that the model does not take, or a place
            that cannot be written to.
        MissingDependencyError: LLVM is missing.
    """
    require_model_name(model)
    cloth = fabric if isinstance(fabric, Fabric) else fabric_of_path(fabric)
    require_llvm()
    write_loom(path, make_model(model, cloth).to_loom())
