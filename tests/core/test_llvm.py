"""An LLVM that Dr.Jit accepts but cannot use is refused before it ends the process."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from loomlight.core import llvm
from loomlight.core.errors import InputError, MissingDependencyError


def test_an_old_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: (14, 0, 6))
    with pytest.raises(MissingDependencyError, match=r"LLVM 14\.0\.6 was found, but 17 or newer"):
        llvm.require_llvm()


@pytest.mark.parametrize(
    ("system", "release", "remedy"),
    [
        ("Linux", {"ID": "debian"}, "apt-get install libllvm19"),
        ("Linux", {"ID": "linuxmint", "ID_LIKE": "ubuntu debian"}, "apt-get install libllvm19"),
        ("Linux", {"ID": "rocky", "ID_LIKE": "rhel centos fedora"}, "dnf install llvm-libs"),
        ("Linux", {"ID": "void"}, "your distribution's package"),
        ("Linux", None, "your distribution's package"),
        ("Darwin", None, "brew install llvm.*libLLVM.dylib"),
        ("Windows", None, "winget install LLVM.LLVM.*LLVM-C.dll"),
    ],
)
def test_no_library_is_refused_with_the_remedy_of_the_system(
    monkeypatch: pytest.MonkeyPatch, system: str, release: dict[str, str] | None, remedy: str
) -> None:
    def os_release() -> dict[str, str]:
        if release is None:
            raise OSError
        return release

    monkeypatch.setattr("platform.system", lambda: system)
    monkeypatch.setattr("platform.freedesktop_os_release", os_release)
    monkeypatch.setattr(llvm, "llvm_version", lambda: None)
    with pytest.raises(MissingDependencyError, match=f"none was found.*{remedy}"):
        llvm.require_llvm()


def test_a_new_library_will_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: (17, 0, 0))
    monkeypatch.setattr(llvm, "compile_quickly", lambda: True)
    llvm.require_llvm()


def test_the_library_here_has_a_version() -> None:
    version = llvm.llvm_version()
    assert version is None or (len(version) == 3 and version[0] >= 8)


def test_an_unknown_way_to_compile_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: (19, 0, 0))
    monkeypatch.setenv("LOOMLIGHT_COMPILE", "fast")
    with pytest.raises(InputError, match='"fast" is no way to compile: use quick or full'):
        llvm.require_llvm()


# A loop, a gather and a sum, of which optimising passes would change the order.
_KERNEL = """
import drjit as dr
from loomlight.core.llvm import llvm_float
Float = llvm_float()
UInt32 = dr.uint32_array_t(Float)
table = dr.linspace(Float, 0, 3, 64)
x, i = dr.linspace(Float, 0.1, 7, 1000), UInt32(0)
while_loop = dr.while_loop((x, i, table), lambda x, i, table: i < 9,
    lambda x, i, table: (x * 0.7 + dr.gather(Float, table, UInt32(x)) * dr.sin(x), i + 1, table))
print(while_loop[0].numpy().tobytes().hex())
"""


@pytest.mark.skipif(
    not llvm.compile_quickly(), reason="kernels are compiled quickly on Linux with LLVM 19 to 22"
)
def test_kernels_compiled_quickly_are_other_code_of_the_same_results(tmp_path: Path) -> None:
    def run(way: str) -> tuple[str, dict[str, bytes]]:
        """What it prints, and its machine code."""
        folder = tmp_path / f"kernels {way}"
        folder.mkdir()
        variables = os.environ | {"LOOMLIGHT_COMPILE": way, "DRJIT_CACHE_DIR": str(folder)}
        done = subprocess.run([sys.executable, "-c", _KERNEL], env=variables, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout, {file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}

    printed, optimised = run("full")
    printed_quickly, quick = run("quick")
    assert printed_quickly == printed
    assert quick.keys() == optimised.keys() != set()
    assert quick != optimised
