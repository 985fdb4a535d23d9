"""All studies by name, found in the text of the modules that declare them: a list loads no renderer.

A study of what whole processes cost must not have loaded more than it needs itself.
"""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError
from loomlight.core.sentences import closest
from studies.harness.study import REPOSITORY, Study

FOLDERS = ("papers", "accuracy", "speed", "look")


@dataclass(frozen=True)
class Declared:
    """Where a study is declared.

    Attributes:
        name, shows: of the study.
        module: that declares it.
    """

    name: str
    shows: str
    module: str


@cache
def catalogue() -> dict[str, Declared]:
    """Every study by name: those of papers first, each folder in the order of people, fig9 before fig10.

    Those of no folder come last.
    """
    found: dict[str, Declared] = {}
    root = REPOSITORY / "studies"
    for files in (*((root / folder).rglob("*.py") for folder in FOLDERS), root.glob("*.py")):
        for file in sorted(files):
            for each in _declared(file):
                if each.name in found:
                    raise ValueError(
                        f"{each.name} is declared in {found[each.name].module} and {each.module}"
                    )
                found[each.name] = each
    return {name: found[name] for name in sorted(found, key=_place)}


def _place(name: str) -> tuple[int, list[tuple[bool, int, str]]]:
    """What names are sorted by: their folder, then words and numbers."""
    words = re.findall(r"\d+|\D+", name)
    parts = [(word.isdigit(), int(word) if word.isdigit() else 0, word) for word in words]
    folder = name.split("/")[0]
    return FOLDERS.index(folder) if folder in FOLDERS else len(FOLDERS), parts


def find_study(name: str) -> Study[Any]:
    """The study of that name, whose module is loaded.

    Raises:
        InputError: there is none.
    """
    if name not in catalogue():
        raise InputError(f'"{name}" is no study: {closest(name, catalogue())}')
    module = importlib.import_module(catalogue()[name].module)
    for value in vars(module).values():
        for study in value if isinstance(value, tuple | list) else (value,):
            if isinstance(study, Study) and study.name == name:
                return study
    raise ValueError(f"{module.__name__} declares {name}, but no name of the module holds it")


def _declared(file: Path) -> Iterator[Declared]:
    module = ".".join(file.relative_to(REPOSITORY).with_suffix("").parts)
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Study":
            name, shows = (ast.literal_eval(argument) for argument in node.args[:2])
            yield Declared(name, shows, module)
