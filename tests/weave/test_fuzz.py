"""The fuzzer of scripts/fuzz_wif.py, for a short while; and that it would notice a fault."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "fuzz_wif.py"


@pytest.fixture(scope="module")
def fuzzer() -> ModuleType:
    specification = importlib.util.spec_from_file_location("fuzz_wif", SCRIPT)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_mutilated_files_are_read_or_refused(fuzzer: ModuleType, fixtures: Path) -> None:
    originals = fuzzer.originals_in(fixtures)
    assert len(originals) >= 3
    faults = {
        seed: fault
        for seed in range(300)
        if (fault := fuzzer.fault_of(fuzzer.mutated(seed, originals))) is not None
    }
    assert faults == {}


def test_the_fuzzer_notices_a_crash(
    fuzzer: ModuleType, fixtures: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(content: bytes) -> None:
        raise ZeroDivisionError(len(content))

    monkeypatch.setattr(fuzzer, "_read", crash)
    assert "ZeroDivisionError" in fuzzer.fault_of(b"[WIF]")


def test_originals_are_read_whole(fuzzer: ModuleType, fixtures: Path) -> None:
    assert [fuzzer.fault_of(content) for content in fuzzer.originals_in(fixtures)] == [None] * 3
