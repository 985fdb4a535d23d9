"""The fuzzer of drafts for a short while; and that it would notice a fault."""

import pytest

from tools import fuzz_wif as fuzzer


def test_mutilated_files_are_read_or_refused() -> None:
    originals = fuzzer.originals_in(fuzzer.FIXTURES)
    assert len(originals) >= 6
    faults = {
        seed: fault
        for seed in range(300)
        if (fault := fuzzer.fault_of(fuzzer.mutated(seed, originals))) is not None
    }
    assert faults == {}


def test_the_fuzzer_notices_a_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    def crash(content: bytes) -> None:
        raise ZeroDivisionError(len(content))

    monkeypatch.setattr(fuzzer, "_read", crash)
    assert "ZeroDivisionError" in (fuzzer.fault_of(b"[WIF]") or "")


def test_originals_are_read_whole() -> None:
    kinds = [fuzzer.outcome_of(content).kind for content in fuzzer.originals_in(fuzzer.FIXTURES)]
    assert kinds == ["read"] * 3 + ["read with warnings"] * 3


def test_the_record_counts_outcomes() -> None:
    figures = fuzzer.fuzz(fuzzer.originals_in(fuzzer.FIXTURES), range(40))
    assert sum(figures["outcomes"].values()) == figures["files"] == 40
    assert 0 < figures["slowest_cpu_seconds"] < fuzzer.SLOWEST_S
    assert figures["missed"] == []
