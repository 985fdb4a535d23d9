"""Help: whole sentences within 80 columns, and the models."""

from __future__ import annotations

import pytest

from loomlight.cli.main import run
from loomlight.core.settings import declared
from loomlight.models.registry import MODELS, model_class

GROUPS: list[list[str]] = [[], ["weave"]]


@pytest.fixture(autouse=True)
def columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


@pytest.mark.parametrize("group", GROUPS, ids=" ".join)
def test_no_sentence_is_cut(group: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*group, "--help"]) == 0
    text = capsys.readouterr().out
    assert "..." not in text.replace("[ARGS]...", "")
    assert max(map(len, text.splitlines())) <= 80
    listed = text.partition("Commands:")[2].split("\n  ")[1:]
    # A command begins a line; what goes on is indented further.
    entries = " ".join(line if line.startswith(" ") else f"\n{line}" for line in listed).split("\n")[1:]
    assert entries
    assert all(entry.strip().endswith(".") for entry in entries if entry), entries


@pytest.mark.parametrize("command", ["render", "bake", "compare"])
def test_models_are_listed_a_line_each(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run([command, "--help"]) == 0
    listed = capsys.readouterr().out.partition("Models:\n")[2].partition("\n\n")[0].splitlines()
    assert [line.split()[0] for line in listed] == list(MODELS)
    assert all(entry.summary in line for entry, line in zip(MODELS.values(), listed, strict=True))


def test_help_of_bake_lists_every_option_of_every_model(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["bake", "--help"]) == 0
    listed = capsys.readouterr().out.partition("for --set:\n")[2].partition("\n\n")[0]
    options = {f"{name}: {option}" for name in MODELS for option in declared(model_class(name).options_class)}
    assert {line[2:].split("  ")[0] for line in listed.splitlines() if line[2:3].strip()} == options
