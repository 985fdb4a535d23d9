"""The fabric that a path stands for, wherever one is asked for."""

from __future__ import annotations

import os

from loomlight.assets.loom_file import is_loom, read_loom
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.load import load_fabric


def fabric_of_path(path: str | os.PathLike[str]) -> Fabric:
    """The fabric of a `.loom`, or of all that `load_fabric` takes: a fabric file, a draft, a weave's name.

    Raises:
        InputError: no such file, no fabric, or values that cannot be; the message names file and field.
    """
    return read_loom(path).fabric if is_loom(path) else load_fabric(path)
