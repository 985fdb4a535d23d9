"""Builds the editor's page into the wheel and the source archive; where Node is missing, says so and goes on.

`LOOMLIGHT_REQUIRE_PAGE=1` makes that an error, as a release should.
"""

from __future__ import annotations

import importlib.util
import os
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class PageHook(BuildHookInterface):  # type: ignore[type-arg]
    """Runs `loomlight.viewer.client_build`, which imports nothing but the standard library."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Builds the page where its sources are newer; an editable installation does so on first use."""
        if version == "editable":
            return
        checkout = Path(self.root)
        package = checkout / "src" / "loomlight" / "viewer"
        builder = _load(package / "client_build.py")
        if builder.is_current(package, checkout):
            return
        try:
            builder.build(package, checkout)
        except builder.BuildError as error:
            if os.environ.get("LOOMLIGHT_REQUIRE_PAGE") == "1":
                raise
            kept = "an older one is packed" if builder.is_built(package) else "`loomlight view` will not work"
            self.app.display_warning(f"The editor's page is not built: {error}; {kept}.")


def _load(file: Path) -> Any:
    specification = importlib.util.spec_from_file_location("client_build", file)
    if specification is None or specification.loader is None:
        raise ImportError(f"{file} cannot be imported")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module
