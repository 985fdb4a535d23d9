"""The built page of the editor: shipped in wheels, built on first use from a source checkout."""

from __future__ import annotations

import sys
import warnings
from importlib.resources import files
from pathlib import Path

from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.viewer.client_build import STATIC, BuildError, build, is_built, is_current

_PACKAGE = Path(str(files("loomlight.viewer")))


def client_folder() -> Path:
    """The folder of the built page; in a source checkout it is built where its sources are newer.

    Raises:
        MissingDependencyError: it is not built, and Node is missing, or the build fails.

    Warns:
        LoomlightWarning: it is older than its sources and cannot be built.
    """
    checkout = _PACKAGE.parents[2]
    if (checkout / "web" / "package.json").is_file() and not is_current(_PACKAGE, checkout):
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
        raise MissingDependencyError(
            "This installation has no editor's page: install a wheel of loomlight anew."
        )
    return _PACKAGE / STATIC
