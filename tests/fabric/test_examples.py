"""The example fabrics are fabrics, and the reference of the fabric file names every field."""

from __future__ import annotations

import dataclasses
import warnings
from pathlib import Path

import numpy as np
import pytest
from pydantic import BaseModel

from examples.makers.undulating_twill import undulating_twill
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.facts import cloth_facts
from loomlight.fabric.fields import FabricFile
from loomlight.weave.loom import plan_drawdown
from loomlight.weave.textile import longest_floats
from loomlight.weave.wif_writer import write_wif

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 12


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_is_a_fabric(path: Path) -> None:
    fabric = load_fabric(path)
    assert fabric.fields.name
    assert fabric.fields.description
    assert fabric_from_text(fabric.to_toml()).repeat_mm == fabric.repeat_mm


def test_a_draft_is_among_the_examples(tmp_path: Path) -> None:
    """With threading, tie-up, treadling and colours, as its tool writes it, and read without a warning."""
    path = ROOT / "examples" / "undulating-twill.wif"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        draft = load_fabric(path).draft
    assert draft.loom is not None
    assert draft.loom.shafts == 24
    np.testing.assert_array_equal(plan_drawdown(draft.loom), draft.drawdown)
    assert draft.warp.colors is not None
    assert len(np.unique(draft.warp.colors, axis=0)) == 3
    # What a weaver would wear: threads that catch on nothing.
    assert max(dataclasses.astuple(longest_floats(draft))) <= 6
    write_wif(undulating_twill(), tmp_path / "again.wif")
    assert (tmp_path / "again.wif").read_bytes() == path.read_bytes()


def test_one_example_is_large() -> None:
    assert max(load_fabric(path).draft.ends for path in EXAMPLES) >= 300


def field_names(model: type[BaseModel]) -> set[str]:
    names = set()
    for name, field in model.model_fields.items():
        table = field.annotation
        names |= field_names(table) if isinstance(table, type) and issubclass(table, BaseModel) else {name}
    return names


def test_the_reference_names_every_field() -> None:
    text = (ROOT / "docs" / "fabric-files.md").read_text()
    missing = {name for name in field_names(FabricFile) if f"`{name}`" not in text}
    assert missing == set()


def test_the_whole_file_of_the_reference_is_a_fabric() -> None:
    text = (ROOT / "docs" / "fabric-files.md").read_text()
    block = text.split("## A whole one")[1]
    lines = [line.removeprefix("    ") for line in block.splitlines() if line.startswith("    ") or not line]
    assert fabric_from_text("\n".join(lines)).name == "Selvedge denim"


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_is_woven_as_people_weave(path: Path) -> None:
    """Of a kind of yarn and a count each way, and colours that such cloth can show: without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fabric = load_fabric(path)
        fabric.appearance()
    for table in (fabric.fields.warp, fabric.fields.weft):
        assert table.yarn or fabric.fields.yarn
        assert table.count
    facts = cloth_facts(fabric)
    # From organza to heavy denim.
    assert 25 < facts.weight < 420
