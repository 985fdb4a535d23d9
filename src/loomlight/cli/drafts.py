"""The draft that an argument of the command line stands for."""

from __future__ import annotations

from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft


def draft_from(argument: str) -> Draft:
    """The draft of a .wif file, a picture of a drawdown, a fabric file, or a weave's name.

    Raises:
        InputError: nothing of these.
    """
    from loomlight.weave.load import DRAFT_SUFFIXES, load_draft
    from loomlight.weave.named import named_weave

    path = Path(argument)
    suffix = path.suffix.lower()
    if suffix == ".toml":
        from loomlight.fabric.load import load_fabric

        return load_fabric(path).draft
    if suffix in DRAFT_SUFFIXES:
        return load_draft(path)
    if suffix or path.is_absolute():
        raise InputError(f"{path} is no draft: give a .wif file, a picture, a fabric file or a weave's name.")
    return named_weave(argument)
