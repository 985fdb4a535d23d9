"""The Slang compiler as a function, and the libraries for engines that it writes.

Wheels and source archives hold the code of all libraries. In a checkout, which has the Slang sources alone, a
library is compiled when it is first asked for, into the user's cache. The build of a wheel loads this file
by its path, before numpy is there: it imports the standard library, `core.errors` and `core.files` alone.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from loomlight.core.errors import LoomlightError, MissingDependencyError
from loomlight.core.files import cache_folder, replacing

SHADERS = Path(__file__).parent / "shaders"
# Code of all libraries, which wheels have and git ignores, and the digest of the sources that it is made of.
LIBRARIES = SHADERS / "libraries"
_DIGEST = "sources.sha256"
# The wheel of slangtorch has the compilers of Linux and Windows.
NO_COMPILER = (
    "Compiling shaders needs slangc: pip install --no-deps slangtorch (for a Mac see shader-slang.org), or "
    "put it on the PATH, or name it in LOOMLIGHT_SLANGC."
)
_SECONDS = 300.0
# Line numbers would name files of the machine that built it.
_OPTIONS = ("-line-directive-mode", "none")
# Compilers that run at a time.
PROCESSES = 2
# Instructions of SPIR-V that name things for debuggers: OpSourceContinued to OpMemberName, OpString, OpLine.
_DEBUG_OPCODES = (2, 3, 4, 5, 6, 7, 8, 317, 330)


class ShaderError(LoomlightError):
    """The Slang compiler refused a source; the message is the compiler's."""


@dataclass(frozen=True)
class Target:
    """A shading language.

    Attributes:
        suffix: of its files.
        options: of slangc.
    """

    suffix: str
    options: tuple[str, ...] = ()


# Of shaders that know layers of cloth, where their host says that there are any (`planes.slang`).
LAYERED = ("-DLAYERED",)
# By slangc's names of them.
TARGETS = {
    "wgsl": Target("wgsl"),
    "hlsl": Target("hlsl", ("-profile", "sm_6_0")),
    "glsl": Target("glsl", ("-profile", "glsl_450")),
    # Drivers optimise; the optimiser and validator that slangc would load are not in its wheel. Whether it
    # knows layers is a constant in the text of other languages, here one that hosts and exports may set.
    "spirv": Target("spv", ("-profile", "spirv_1_3", "-O0", "-skip-spirv-validation", *LAYERED)),
    "metal": Target("metal"),
    "cuda": Target("cu"),
}


def find_slangc() -> Path | None:
    """The compiler: `LOOMLIGHT_SLANGC`, the one in the wheel of slangtorch, or one on the path."""
    named = os.environ.get("LOOMLIGHT_SLANGC")
    if named:
        return Path(named)
    spec = find_spec("slangtorch")  # found without importing it, which would import torch
    if spec is not None and spec.origin is not None:
        bundled = Path(spec.origin).parent / "bin" / ("slangc.exe" if os.name == "nt" else "slangc")
        if bundled.is_file():
            if not os.access(bundled, os.X_OK):
                bundled.chmod(0o755)
            return bundled
    on_path = shutil.which("slangc")
    return None if on_path is None else Path(on_path)


def compile_shader(
    source: Path, target: str, entries: Sequence[str], options: Sequence[str] = (), seconds: float = _SECONDS
) -> bytes:
    """Code of entry points of a Slang file, which may import the modules of the package.

    Args:
        target: a name of `TARGETS`.
        entries: names of functions with a `[shader(…)]` attribute.
        options: further options of slangc.

    Raises:
        MissingDependencyError: there is no compiler.
        ShaderError: the source does not compile, or not within `seconds`.
    """
    arguments = [str(source), "-target", target, "-I", str(SHADERS), "-o", "-", *options]
    for entry in entries:
        arguments += ["-entry", entry]
    # Text is written to standard output as it is; SPIR-V is not, when that is a terminal.
    try:
        done = _run(arguments, seconds)
    except subprocess.TimeoutExpired as error:
        raise ShaderError(f"{source.name}: slangc took longer than {seconds:g} s for {target}.") from error
    if done.returncode != 0:
        raise ShaderError(f"{source.name} does not compile to {target}: {_first_error(done.stderr)}")
    return done.stdout


def _run(arguments: Sequence[str], seconds: float) -> subprocess.CompletedProcess[bytes]:
    slangc = find_slangc()
    if slangc is None:
        raise MissingDependencyError(NO_COMPILER)
    try:
        return subprocess.run([str(slangc), *arguments], capture_output=True, timeout=seconds, check=False)
    except OSError as error:
        raise MissingDependencyError(f"{slangc} cannot be run: {error.strerror}.") from error


def _first_error(output: bytes) -> str:
    lines = output.decode(errors="replace").strip().splitlines()
    first = next((i for i, line in enumerate(lines) if "error" in line), 0)
    return "\n".join(lines[first : first + 12]) or "slangc said nothing."


def compile_entries(module: str, language: str, entries: Sequence[str], options: Sequence[str] = ()) -> bytes:
    """Code of entry points of a module of the package, as it is stored.

    CUDA includes a header of Slang's distribution; SPIR-V has no names for debuggers.

    Args:
        module: name of a file of `shaders`, without suffix.
        language: a name of `TARGETS`.
    """
    used = (*_OPTIONS, *TARGETS[language].options, *options)
    code = compile_shader(SHADERS / f"{module}.slang", language, entries, used)
    if language == "cuda":
        return b"#include <slang-cuda-prelude.h>\n" + code.removeprefix(_cuda_prelude())
    return without_debug_names(code) if language == "spirv" else code


@cache
def _cuda_prelude() -> bytes:
    """Text that slangc writes before every CUDA source: a header that Slang's distribution has as a file."""
    with tempfile.TemporaryDirectory() as folder:
        empty = Path(folder) / "empty.slang"
        empty.write_text('[shader("compute")] [numthreads(1, 1, 1)] void empty() {}', encoding="utf-8")
        text = compile_shader(empty, "cuda", ["empty"], _OPTIONS)
    return text[: text.index(b'extern "C"')]


def without_debug_names(module: bytes) -> bytes:
    """A SPIR-V module without names and sources for debuggers, which are a third of it."""
    words = memoryview(module).cast("I")
    kept, at = [words[:5]], 5  # behind the header
    while at < len(words):
        length = words[at] >> 16
        if words[at] & 0xFFFF not in _DEBUG_OPCODES:
            kept.append(words[at : at + length])
        at += length
    return b"".join(kept)


def digest_of(contents: Mapping[str, bytes]) -> str:
    """SHA-256 of texts by their names."""
    found = sha256()
    for name in sorted(contents):
        found.update(f"{name} {len(contents[name])}\n".encode() + contents[name])
    return found.hexdigest()


def slang_sources() -> dict[str, bytes]:
    """All Slang files by name."""
    return {path.name: path.read_bytes() for path in SHADERS.glob("*.slang")}


def library_models() -> list[str]:
    """Models that have a library: its kernel `MODEL_queries` is in `cloth_MODEL.slang`."""
    return sorted(path.stem.removeprefix("cloth_") for path in SHADERS.glob("cloth_*.slang"))


def library_code(language: str, model: str) -> bytes:
    """Code of the kernel of a library: from the package, the user's cache, or the compiler.

    Args:
        language: a name of `TARGETS`.
        model: a name of `library_models`.

    Raises:
        MissingDependencyError: it would have to be compiled, and there is no compiler.
        ShaderError: the source does not compile.
    """
    place = _place(language, model)
    if has_libraries():
        return (LIBRARIES / place).read_bytes()
    version = _run(["-version"], _SECONDS)
    recipe = [repr(TARGETS[language]), repr(_OPTIONS), version.stdout.decode() + version.stderr.decode()]
    key = digest_of({**slang_sources(), "recipe": "\n".join(recipe).encode()})
    cached = cache_folder("shaders") / key[:16] / place
    with suppress(OSError):
        return cached.read_bytes()
    code = _compiled_library(language, model)
    with suppress(OSError, LoomlightError):  # a cache that cannot be written costs time alone
        cached.parent.mkdir(parents=True, exist_ok=True)
        with replacing(cached) as temporary:
            temporary.write_bytes(code)
    return code


def has_libraries() -> bool:
    """True if the package holds the code of all libraries, made of the Slang sources that it has."""
    try:
        return (LIBRARIES / _DIGEST).read_text(encoding="utf-8") == digest_of(slang_sources())
    except OSError:
        return False


def write_libraries() -> None:
    """Compiles all libraries into the package, whole or not at all: what a wheel carries.

    Raises:
        MissingDependencyError: there is no compiler.
        ShaderError: a source does not compile.
    """
    wanted = [(language, model) for language in TARGETS for model in library_models()]
    with tempfile.TemporaryDirectory(prefix=".loomlight-", dir=SHADERS) as folder:
        made = Path(folder) / LIBRARIES.name
        with ThreadPoolExecutor(PROCESSES) as pool:
            codes = pool.map(lambda one: _compiled_library(*one), wanted)
            for (language, model), code in zip(wanted, codes, strict=True):
                file = made / _place(language, model)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(code)
        (made / _DIGEST).write_text(digest_of(slang_sources()), encoding="utf-8")
        if LIBRARIES.exists():
            LIBRARIES.rename(Path(folder) / "earlier")
        made.rename(LIBRARIES)


def _place(language: str, model: str) -> Path:
    return Path(language) / f"{model}_queries.{TARGETS[language].suffix}"


def _compiled_library(language: str, model: str) -> bytes:
    return compile_entries(f"cloth_{model}", language, [f"{model}_queries"])
