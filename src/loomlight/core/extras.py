"""Packages that only some features need, imported when they are used."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from loomlight.core.errors import MissingDependencyError


def import_extra(module: str, extra: str, feature: str) -> Any:
    """A module that is installed with an extra of loomlight's, such as zarr with `loomlight[data]`.

    Args:
        module: its name.
        extra: the extra's name in pyproject.toml.
        feature: what needs it, the subject of the message.

    Raises:
        MissingDependencyError: it is not installed; the sentence says how to install it.
    """
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        # A module that is there but lacks one of its own is a defect of the installation, not a choice.
        if error.name is None or error.name.partition(".")[0] != module.partition(".")[0]:
            raise
        command = f"pip install 'loomlight[{extra}]'"
        raise MissingDependencyError(f"{feature} needs {module}: {command}.") from error
