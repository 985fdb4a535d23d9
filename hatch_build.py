"""Builds the editor's page and the shader libraries into the wheel and the source archive.

Where Node or slangc is missing, it says so on the terminal, as pip hides what a build prints, and goes on:
all but `loomlight view`, or shader code, works, and `loomlight doctor` says so.
`LOOMLIGHT_REQUIRE_PAGE=1` and `LOOMLIGHT_REQUIRE_SHADERS=1` make that an error, as a release should.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


# hatchling's hooks are generic in a configuration that this one does not read.
class GeneratedFilesHook(BuildHookInterface):  # type: ignore[type-arg]
    """Runs `viewer/client_build.py` and `realtime/slangc.py`, which import the standard library alone, and of
    this package nothing but errors and files."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Builds what is older than its sources; an editable installation does so on first use."""
        if version == "editable":
            return
        sources = Path(self.root) / "src"
        sys.path.insert(0, str(sources))
        try:
            self._build_page(sources / "loomlight" / "viewer")
            self._compile_libraries(sources / "loomlight" / "realtime")
        finally:
            sys.path.remove(str(sources))

    def _build_page(self, package: Path) -> None:
        builder = _load(package / "client_build.py")
        checkout = Path(self.root)
        if builder.is_current(package, checkout):
            return
        try:
            builder.build(package, checkout)
        except builder.BuildError as error:
            kept = "an older one is packed" if builder.is_built(package) else "`loomlight view` will not work"
            self._warn("PAGE", f"The editor's page is not built: {error}; {kept}.", error)

    def _compile_libraries(self, package: Path) -> None:
        compiler = _load(package / "slangc.py")
        if compiler.has_libraries():
            return
        try:
            compiler.write_libraries()
        except compiler.LoomlightError as error:
            lost = "`loomlight export` to wgsl, hlsl, glsl, spirv, metal and cuda will need slangc"
            self._warn("SHADERS", f"The shader libraries are not compiled: {lost}. {error}", error)

    def _warn(self, requirement: str, message: str, error: Exception) -> None:
        """Shows a warning; raises `error` where LOOMLIGHT_REQUIRE_… is 1."""
        if os.environ.get(f"LOOMLIGHT_REQUIRE_{requirement}") == "1":
            raise error
        self.app.display_warning(message)
        if not sys.stderr.isatty():
            _tell_terminal(f"loomlight: warning: {message}")


def _tell_terminal(message: str) -> None:
    """Writes a line to the terminal that the build was started from; where there is none, nothing."""
    try:
        with open("CONOUT$" if os.name == "nt" else "/dev/tty", "w", encoding="utf-8") as terminal:
            terminal.write(f"\n{message}\n")
    except OSError:
        return


def _load(file: Path) -> Any:
    specification = importlib.util.spec_from_file_location(file.stem, file)
    if specification is None or specification.loader is None:
        raise ImportError(f"{file} cannot be imported")
    module = importlib.util.module_from_spec(specification)
    sys.modules[file.stem] = module  # dataclasses look their module up
    specification.loader.exec_module(module)
    return module
