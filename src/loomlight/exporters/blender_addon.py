"""The zip of the Blender add-on, for "Install from Disk", with the material of a fabric ready in it.

The add-on is a program of its own, integrations/blender, under the GPL, as all that imports Blender is.
"""

from __future__ import annotations

import tempfile
import zipfile
from collections.abc import Iterator
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.images import png_bytes
from loomlight.exporters.blender import write_maps
from loomlight.exporters.folder import write_manifest
from loomlight.fabric.fabric import Fabric
from loomlight.weave.drawing import draw_drawdown
from loomlight.weave.named import named_weave, weave_names

_NAME = "loomlight_blender"
_PACKAGE = Path(str(files("loomlight")))
_CHECKOUT = _PACKAGE.parents[1]
# A wheel holds the add-on and the gallery in the first folders; in a source checkout they lie in the second.
_ADDON = (_PACKAGE / "exporters" / "blender_files", _CHECKOUT / "integrations" / "blender" / "addon")
_GALLERY = (_PACKAGE / "viewer" / "gallery", _CHECKOUT / "examples")
# Pixels a side of the picture of a named weave, and threads that it shows at most.
_WEAVE_PIXELS, _WEAVE_THREADS = 128, 16
# The first moment that a zip can name: the same fabric gives the same bytes.
_ZIP_TIME = (1980, 1, 1, 0, 0, 0)
# The version of the manifest in the sources, in whose place loomlight's own is written.
_OPEN_VERSION = b'version = "0.0.0"'


def write_addon(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Writes the add-on's zip, with the material of `fabric` ready in it, and returns what the manifest says.

    Raises:
        InputError: the installation lacks the add-on; or as `write_maps`.
    """
    sources = next((place for place in _ADDON if (place / "__init__.py").is_file()), None)
    if sources is None:
        raise InputError(
            "This installation of loomlight lacks its add-on for Blender: install it again, from a wheel."
        )
    archive = f"{_NAME}-{version('loomlight')}.zip"
    with tempfile.TemporaryDirectory(dir=folder) as temporary:
        ready = Path(temporary)
        facts = write_maps(ready, fabric, model, distance)
        write_manifest(ready, {"fabric": fabric.name, "model": model, "target": "blender"} | facts)
        with zipfile.ZipFile(folder / archive, "w") as packed:
            for name, content in (*_sources(sources), *_gallery(), *_weaves(), *_files(ready, "ready")):
                packed.writestr(zipfile.ZipInfo(name, _ZIP_TIME), content, zipfile.ZIP_DEFLATED)
    return {"files": [archive]}


def _files(folder: Path, name: str) -> Iterator[tuple[str, bytes]]:
    """Names in the zip and contents of all files below a folder."""
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            yield f"{name}/{file.relative_to(folder).as_posix()}", file.read_bytes()


def _sources(folder: Path) -> Iterator[tuple[str, bytes]]:
    """The add-on itself, its manifest with the version of this package, and its licence."""
    for file in sorted(folder.iterdir()):
        if file.suffix in (".py", ".toml") or file.name == "LICENSE":
            own = f'version = "{version("loomlight")}"'
            yield file.name, file.read_bytes().replace(_OPEN_VERSION, own.encode())


def _gallery() -> Iterator[tuple[str, bytes]]:
    """The fabrics that have a picture, and these."""
    for file in sorted({file.stem: file for folder in _GALLERY for file in folder.glob("*.toml")}.values()):
        picture = _GALLERY[0] / f"{file.stem}.webp"
        if picture.is_file():
            yield f"gallery/{file.name}", file.read_bytes()
            yield f"gallery/{picture.name}", picture.read_bytes()


def _weaves() -> Iterator[tuple[str, bytes]]:
    """The names of weaves, a line each, and their pictures by the numbers of lines, from 0."""
    names = weave_names()
    yield "weaves/names.txt", "\n".join(names).encode()
    for number, name in enumerate(names):
        yield f"weaves/{number}.png", _weave_picture(name)


def _weave_picture(name: str) -> bytes:
    """The corner of a weave's interlacement as PNG."""
    draft = named_weave(name)
    cell = _WEAVE_PIXELS // _WEAVE_THREADS
    repeats = -(-_WEAVE_THREADS // min(draft.drawdown.shape))
    drawn = draw_drawdown(draft, origin="bottom-left", cell_px=cell, repeats=repeats)
    return png_bytes(np.ascontiguousarray(drawn[-_WEAVE_PIXELS:, :_WEAVE_PIXELS]))
