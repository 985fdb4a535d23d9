"""How the sources are laid out: tests name sources that exist, signatures have types, imports no circles."""

from __future__ import annotations

import ast
import graphlib
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import grimp
import pytest

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "loomlight"
# Of the parameters that have an annotation, at most this share may say `Any` in it.
MAX_ANY = 0.07


_COVERS = re.compile(r"^(?:# )?Covers: (.+)$", re.MULTILINE)


@cache
def _tree(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"))


def _files(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


def _functions(tree: ast.AST) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield node


def _covered() -> dict[str, list[str]]:
    """Tests by the sources that their "Covers:" lines name."""
    found: dict[str, list[str]] = {}
    for test in _files(ROOT / "tests"):
        if test != Path(__file__).resolve():
            for line in _COVERS.findall(test.read_text(encoding="utf-8")):
                for name in re.split(r",\s*", line.strip().rstrip(".")):
                    found.setdefault(name, []).append(str(test.relative_to(ROOT)))
    return found


def test_covered_sources_exist() -> None:
    gone = {
        name: tests
        for name, tests in _covered().items()
        if not any((root / name).is_file() for root in (SOURCE, ROOT))
    }
    assert gone == {}


def _annotations(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.expr]:
    given = function.args
    everything = [*given.posonlyargs, *given.args, *given.kwonlyargs, given.vararg, given.kwarg]
    for argument in everything:
        if argument is not None and argument.annotation is not None:
            yield argument.annotation


def test_few_parameters_are_anything() -> None:
    """`Any` in an annotation says nothing; core/arrays.py names what Dr.Jit's arrays stand for."""
    says_any = [
        any(isinstance(part, ast.Name) and part.id == "Any" for part in ast.walk(annotation))
        for file in _files(SOURCE)
        for function in _functions(_tree(file))
        for annotation in _annotations(function)
    ]
    share = sum(says_any) / len(says_any)
    assert share <= MAX_ANY, f"{sum(says_any)} of {len(says_any)} annotated parameters say Any: {share:.3f}"


@pytest.mark.parametrize("folder", ["studies", "studies/papers", "tools", "tools/fits", "tests", "examples"])
def test_scripts_are_packages(folder: str) -> None:
    assert (ROOT / folder / "__init__.py").is_file()


def test_no_modules_import_each_other_in_a_circle() -> None:
    """Imports for annotations alone, under TYPE_CHECKING, do not count."""
    graph = grimp.build_graph("loomlight", exclude_type_checking_imports=True, cache_dir=None)
    order = graphlib.TopologicalSorter(
        {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
    )
    order.prepare()
