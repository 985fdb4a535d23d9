"""`export_site`: the editor as a folder that any web server serves, with no Python behind it."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

from loomlight.export.folder import replacing_folder, write_manifest
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.client import client_folder
from loomlight.viewer.session import gallery_pictures, session

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
