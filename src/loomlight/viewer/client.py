"""The built page of the editor: shipped in wheels, built on first use from a source checkout."""

from __future__ import annotations

import json
import os
import shutil
import sys
import warnings
from importlib.resources import files
from pathlib import Path

from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.exporters.folder import replacing_folder, write_manifest
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.client_build import STATIC, BuildError, build, is_built, is_current, require_node
from loomlight.viewer.session import gallery_pictures, session

_PACKAGE = Path(str(files("loomlight.viewer")))
_NO_PAGE = (
    "This installation has no editor's page, as Node was missing when it was built: install Node from "
    "https://nodejs.org, then loomlight anew."
)


def client_folder() -> Path:
    """The folder of the built page; in a source checkout it is built where its sources are newer.

    Raises:
        MissingDependencyError: it is not built, and Node is missing, or the build fails.

    Warns:
        LoomlightWarning: it is older than its sources and cannot be built.
    """
    checkout = _checkout()
    if checkout is not None and not is_current(_PACKAGE, checkout):
        print("Building the editor's page, once ...", file=sys.stderr)
        try:
            build(_PACKAGE, checkout)
        except BuildError as error:
            if not is_built(_PACKAGE):
                raise MissingDependencyError(f"The editor's page is not built: {error}.") from error
            warnings.warn(
                f"The editor's page is older than its sources: {error}.", LoomlightWarning, stacklevel=2
            )
    if not is_built(_PACKAGE):
        raise MissingDependencyError(_NO_PAGE)
    return _PACKAGE / STATIC


def page_state() -> tuple[str, str | None]:
    """Whether the page is built, and how to get it; the second is None where nothing has to be done."""
    if is_built(_PACKAGE):
        return "built", None
    if _checkout() is None:
        return "missing", _NO_PAGE
    try:
        require_node()
    except BuildError as error:
        return "not built", f"for loomlight view. {error}."
    return "built when it is first shown", None


def _checkout() -> Path | None:
    """The checkout that this package lies in, which has the page's sources; None of an installation."""
    checkout = _PACKAGE.parents[2]
    return checkout if (checkout / "web" / "package.json").is_file() else None


# ------------------------------------------------------------------------------------ a folder without Python
# `export_site`: the editor as a folder that any web server serves, with no Python behind it.


_SERVED = 'content="api/session"'
_ALONE = 'content="session.json"'


def export_site(
    folder: str | os.PathLike[str], fabric: Fabric | str | os.PathLike[str] | None = None
) -> Path:
    """Writes the editor's page with a fabric into a folder, whole or not at all.

    Args:
        folder: new, empty, or of an earlier export.
        fabric: what the page shows first; see `fabric_of_path`. None for a fabric of the gallery.

    Returns:
        The folder.

    Raises:
        InputError: no such fabric, or a folder that cannot be written.
        MissingDependencyError: the page is not built and cannot be.
    """
    name = os.fspath(fabric) if isinstance(fabric, str | os.PathLike) else fabric
    with replacing_folder(folder) as temporary:
        first = session(name, has_python=False)
        copy_client(temporary, first)
        write_manifest(temporary, {"fabric": first["fabric"]["name"], "target": "site"})
    return Path(folder)


def copy_client(folder: Path, first: dict[str, object]) -> None:
    """Copies the built page into a folder, with the session `first` and the gallery's pictures beside it."""
    shutil.copytree(client_folder(), folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("widget.html"))
    (folder / "gallery").mkdir(exist_ok=True)
    for picture in gallery_pictures().glob("*.webp"):
        shutil.copyfile(picture, folder / "gallery" / picture.name)
    index = folder / "index.html"
    page = index.read_text(encoding="utf-8")
    if _SERVED not in page:
        raise ValueError("index.html names no session")
    index.write_text(page.replace(_SERVED, _ALONE), encoding="utf-8")
    (folder / "session.json").write_text(json.dumps(first, ensure_ascii=False), encoding="utf-8")
