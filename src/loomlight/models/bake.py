"""Baking: a source and all that a model needs of it, as one `.loom` file."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from loomlight.assets.load import load_source
from loomlight.assets.loom_file import write_loom
from loomlight.assets.sources import Source
from loomlight.core.llvm import require_llvm
from loomlight.models.registry import make_model, model_class


def bake(
    source: Source | str | os.PathLike[str],
    model: str,
    path: str | os.PathLike[str],
    *,
    report: Callable[[int, int], None] | None = None,
    **options: Any,
) -> None:
    """Writes the material of a source by a model, whole or not at all; `model_from_loom` reads it.

    Args:
        source: a fabric or another source; or the path of one, a `.loom` whose source it is, or a weave's
            name.
        model: "point", "neural", …: see `loomlight.models.registry.model_names`.
        path: the `.loom` file.
        report: called with (done, in all) by models that are trained.
        options: of the model; see `Model.options`.

    Raises:
        InputError: no such model, a source that cannot be read or that the model does not take, or a place
            that cannot be written to.
        MissingDependencyError: LLVM is missing.
    """
    chosen = model_class(model)
    held = load_source(source, chosen.source_kind) if isinstance(source, str | os.PathLike) else source
    require_llvm()
    if chosen.trains:
        options["report"] = report
    write_loom(path, make_model(model, held, **options).to_loom())
