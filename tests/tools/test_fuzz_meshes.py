"""The fuzzer of meshes: its files are meshes, and some mutations of each make no fault."""

from __future__ import annotations

import pytest

from tools.fuzz_meshes import targets
from tools.fuzzing import Target, fuzz, outcome_of


@pytest.mark.parametrize("target", targets(), ids=lambda target: target.name)
def test_mutilated_meshes_make_no_fault(target: Target) -> None:
    for content in target.originals:
        assert outcome_of(target.subject, content).kind.startswith("read")
    figures = fuzz(target, range(60), seconds=None, faults=None)
    assert (figures["files"], figures["faults"]) == (60, 0)
