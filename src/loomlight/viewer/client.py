"""The built page of the editor: shipped in wheels, built on first use from a source checkout."""

from __future__ import annotations

import sys
import warnings
from importlib.resources import files
from pathlib import Path

from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.viewer.client_build import STATIC, BuildError, build, is_built, is_current, require_node

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
