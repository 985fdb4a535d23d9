"""Packages that only some features need, imported when they are used, and the extras that bring them."""

from __future__ import annotations

import re
from importlib import import_module
from importlib.metadata import requires
from typing import Any

from loomlight.core.errors import MissingDependencyError

# What each extra is for, a phrase that follows "for"; README's table says the same.
EXTRAS = {
    "networks": ".looms of neumip and latent",
    "neural": "the model neural, the network",
    "materialx": "export to MaterialX and USD",
    "print": "drafts as PDF",
    "meshopt": "glTF meshes that meshopt compresses",
    "usd": "meshes in USD, read and written",
    "realtime": "frames on a graphics adapter, loomlight play",
    "viewer": "loomlight view, the live editor",
    "notebook": "the editor in a notebook",
    "fleet": "many fabrics on many machines",
    "data": "the data of studies/papers/chen2024",
    "train": "bake --model neumip and latent, and to train neural",
}
_NAME = re.compile(r"[\w.-]+")
_OF_EXTRA = re.compile(r"""extra == ['"]([\w.-]+)['"]""")


def required_packages() -> dict[str, list[str]]:
    """Packages that loomlight requires, by extra; those of the base are under "".

    Raises:
        PackageNotFoundError: loomlight is not installed, such as where its folder is on the path alone.
    """
    found: dict[str, list[str]] = {"": []}
    for line in requires("loomlight") or ():
        name, extra = _NAME.match(line), _OF_EXTRA.search(line)
        assert name is not None  # what metadata is made of
        found.setdefault(extra[1] if extra is not None else "", []).append(name[0])
    return found


def installing(extra: str) -> str:
    """The command that installs an extra."""
    return f"pip install 'loomlight[{extra}]'"


def import_extra(module: str, extra: str, feature: str) -> Any:
    """A module that is installed with an extra of loomlight's, such as zarr with `loomlight[data]`.

    Args:
        module: its name.
        extra: the extra's name in pyproject.toml; "" for a package that none brings.
        feature: what needs it, the subject of the message.

    Raises:
        MissingDependencyError: it is not installed; the sentence says how to install it.
    """
    package = module.partition(".")[0]
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        # A module that is there but lacks one of its own is a defect of the installation, not a choice.
        if error.name is None or error.name.partition(".")[0] != package:
            raise
        command = installing(extra) if extra else f"pip install {package}"
        raise MissingDependencyError(f"{feature} needs {package}: {command}.") from error
