"""An LLVM that Dr.Jit accepts but cannot use is refused before it ends the process."""

from __future__ import annotations

import pytest

from loomlight.core import llvm
from loomlight.core.errors import MissingDependencyError


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
    llvm.require_llvm()


def test_the_library_here_has_a_version() -> None:
    version = llvm.llvm_version()
    assert version is None or (len(version) == 3 and version[0] >= 8)
