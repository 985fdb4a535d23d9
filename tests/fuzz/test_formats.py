"""Every fuzzer for a short while: its files are read as they are, and mutilated ones make no fault."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import Any

import pytest

from tests.fuzz import btf, fabric_messages, loom, merl, meshes, photos, u3m, wif
from tests.fuzz.fuzzing import fuzz, outcome_of
from tests.marks import slow

# Fuzzers, their targets, and how many files take about a second.
TARGETS: dict[ModuleType, dict[str, int]] = {
    meshes: dict.fromkeys(
        ("obj", "ply-ascii", "ply-binary", "gltf", "gltf-motion", "glb", "draco", "usda", "usdc", "usdz"), 60
    ),
    wif: {"wif": 200, "dtx": 200, "pictures": 200, "bitmaps": 200, "artworks": 200},
    btf: {"ubo2003": 100, "ubo2014": 100},
    loom: {"material": 100, "tile": 100},
    fabric_messages: {"fabric": 100, "draft": 100},
    merl: {"merl": 10, "rgl": 100},
    u3m: {"u3m": 100, "u3ma": 60, "u3m-picture": 60},
    photos: {"photo": 20},
}
# Pixar's reader runs in a process of its own for each file.
FEW = {"usdc": 5, "usdz": 5}
NAMES = {module: module.__name__.rpartition(".")[2] for module in TARGETS}


@pytest.mark.parametrize("module", TARGETS, ids=NAMES.get)
def test_every_target_is_fed(module: ModuleType) -> None:
    assert {target.name for target in module.targets()} == set(TARGETS[module])


def _cases() -> Iterator[Any]:
    for module, counts in TARGETS.items():
        for name, count in counts.items():
            case = f"{NAMES[module]}-{name}"
            if module is merl or name in FEW:
                yield slow(module, name, count, id=case)
            else:
                yield pytest.param(module, name, count, id=case)
            if name in FEW:
                yield pytest.param(module, name, FEW[name], id=f"{case}-few")


@pytest.mark.parametrize(("module", "name", "count"), list(_cases()))
def test_mutilated_files_are_read_or_refused(module: ModuleType, name: str, count: int) -> None:
    (target,) = (target for target in module.targets() if target.name == name)
    for content in target.originals:
        outcome = outcome_of(target.subject, content)
        # The folder of data from outside has drafts that are to be refused; those kept here are asked below.
        expected = ("read", "refused") if module is wif else ("read",)
        assert outcome.kind.startswith(expected), outcome.message
    figures = fuzz(target, range(count), seconds=None, faults=None)
    assert (figures["files"], figures["faults"]) == (count, 0)


def test_originals_of_drafts_are_read_whole() -> None:
    kinds = [outcome_of(wif.read_twice, content).kind for content in wif.originals_in(wif.FIXTURES)]
    assert kinds == ["read"] * 3 + ["read with warnings"] * 3
