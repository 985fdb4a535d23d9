"""The fuzzers of drafts and measured data for a short while."""

import pytest

from tools import fuzz_btf, fuzz_loom, fuzz_merl
from tools import fuzz_wif as fuzzer
from tools.fuzzing import fuzz, outcome_of


@pytest.mark.parametrize("name", ["wif", "pictures"])
def test_mutilated_drafts_are_read_or_refused(name: str) -> None:
    (target,) = (target for target in fuzzer.targets() if target.name == name)
    figures = fuzz(target, range(200), None, None)
    assert (figures["files"], figures["faults"]) == (200, 0)


@pytest.mark.quick("tools.fuzz_btf", "tools.fuzz_loom")
@pytest.mark.parametrize("module", [fuzz_btf, fuzz_loom, fuzz_merl])
def test_mutilated_measured_data_are_read_or_refused(module: object) -> None:
    for target in module.targets():  # type: ignore[attr-defined]
        assert fuzz(target, range(10 if target.name == "merl" else 100), None, None)["faults"] == 0


def test_originals_are_read_whole() -> None:
    originals = fuzzer.originals_in(fuzzer.FIXTURES)
    kinds = [outcome_of(fuzzer.read_twice, content).kind for content in originals]
    assert kinds == ["read"] * 3 + ["read with warnings"] * 3
