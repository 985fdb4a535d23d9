"""An LLVM that Dr.Jit accepts but cannot use is refused before it ends the process."""

from __future__ import annotations

import pytest

from loomlight.core import llvm
from loomlight.core.errors import MissingDependencyError


def test_an_old_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: (14, 0, 6))
    with pytest.raises(MissingDependencyError, match=r"LLVM 14\.0\.6 was found, but 17 or newer"):
        llvm.require_llvm()


def test_no_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: None)
    with pytest.raises(MissingDependencyError, match=r"none was found.*libllvm19"):
        llvm.require_llvm()


def test_a_new_library_will_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(llvm, "llvm_version", lambda: (17, 0, 0))
    llvm.require_llvm()


def test_the_library_here_has_a_version() -> None:
    version = llvm.llvm_version()
    assert version is None or (len(version) == 3 and version[0] >= 8)
