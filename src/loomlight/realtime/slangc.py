"""The Slang compiler as a function. Users need none: what it emits is part of the package."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from loomlight.core.errors import LoomlightError, MissingDependencyError

SHADERS = Path(__file__).parent / "shaders"
_SECONDS = 300.0


class ShaderError(LoomlightError):
    """The Slang compiler refused a source; the message is the compiler's."""


def find_slangc() -> Path | None:
    """The compiler: `LOOMLIGHT_SLANGC`, the one in the wheel of slangtorch, or one on the path."""
    named = os.environ.get("LOOMLIGHT_SLANGC")
    if named:
        return Path(named)
    spec = find_spec("slangtorch")  # found without importing it, which would import torch
    if spec is not None and spec.origin is not None:
        bundled = Path(spec.origin).parent / "bin" / "slangc"
        if bundled.is_file():
            if not os.access(bundled, os.X_OK):
                bundled.chmod(0o755)
            return bundled
    on_path = shutil.which("slangc")
    return None if on_path is None else Path(on_path)


def compile_shader(
    source: Path, target: str, entries: Sequence[str], options: Sequence[str] = (), seconds: float = _SECONDS
) -> bytes:
    """What slangc emits for entry points of a Slang file, which may import the modules of the package.

    Args:
        target: wgsl, hlsl, glsl, spirv, metal or cuda.
        entries: names of functions with a `[shader(…)]` attribute.
        options: further options of slangc.

    Raises:
        MissingDependencyError: there is no compiler.
        ShaderError: the source does not compile, or not within `seconds`.
    """
    slangc = find_slangc()
    if slangc is None:
        raise MissingDependencyError(
            "Compiling shaders needs slangc: pip install --no-deps slangtorch, or set LOOMLIGHT_SLANGC."
        )
    command = [str(slangc), str(source), "-target", target, "-I", str(SHADERS), "-o", "-", *options]
    for entry in entries:
        command += ["-entry", entry]
    # Text is written to standard output as it is; SPIR-V is not, when that is a terminal.
    try:
        done = subprocess.run(command, capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired as error:
        raise ShaderError(f"{source.name}: slangc took longer than {seconds:g} s for {target}.") from error
    except OSError as error:
        raise MissingDependencyError(f"{slangc} cannot be run: {error.strerror}.") from error
    if done.returncode != 0:
        raise ShaderError(f"{source.name} does not compile to {target}: {_first_error(done.stderr)}")
    return done.stdout


def _first_error(output: bytes) -> str:
    lines = output.decode(errors="replace").strip().splitlines()
    first = next((i for i, line in enumerate(lines) if "error" in line), 0)
    return "\n".join(lines[first : first + 12]) or "slangc said nothing."
