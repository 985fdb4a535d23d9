"""How the sources are laid out: a test for each file, short files and functions, signatures with types."""

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
FOLDERS = ("src", "papers", "tests", "benchmarks", "experiments", "tools")
MAX_LINES, MAX_LINES_OF_A_FUNCTION = 500, 100
# The budget of src: who adds takes elsewhere.
MAX_SOURCE_LINES = 53_000
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


def _does_something(file: Path) -> bool:
    """Whether a module holds code: constants, aliases of types and empty exceptions need no test."""
    return any(True for _ in _functions(_tree(file))) and file.name != "__init__.py"


def _covered() -> dict[str, list[str]]:
    """Tests by the sources that their "Covers:" lines name."""
    found: dict[str, list[str]] = {}
    for test in _files(ROOT / "tests"):
        if test != Path(__file__).resolve():
            for line in _COVERS.findall(test.read_text(encoding="utf-8")):
                for name in re.split(r",\s*", line.strip().rstrip(".")):
                    found.setdefault(name, []).append(str(test.relative_to(ROOT)))
    return found


def test_every_source_has_a_test() -> None:
    """tests/a/test_b.py for src/loomlight/a/b.py, or a test that names a/b.py in a line "Covers: a/b.py".

    Of papers likewise tests/papers/…, papers/….
    """
    covered = _covered()
    missing = []
    for folder, root in ((SOURCE, SOURCE), (ROOT / "papers", ROOT)):
        for file in filter(_does_something, _files(folder)):
            name = file.relative_to(root)
            mirrored = ROOT / "tests" / name.parent / f"test_{file.name}"
            if not mirrored.is_file() and str(name) not in covered:
                missing.append(str(name))
    assert missing == []


def test_covered_sources_exist() -> None:
    gone = {
        name: tests
        for name, tests in _covered().items()
        if not any((root / name).is_file() for root in (SOURCE, ROOT))
    }
    assert gone == {}


def test_files_are_short() -> None:
    lengths = {
        str(file.relative_to(ROOT)): len(file.read_text(encoding="utf-8").splitlines())
        for folder in FOLDERS
        for file in _files(ROOT / folder)
    }
    assert lengths
    long = {name: n for name, n in lengths.items() if n > MAX_LINES}
    assert long == {}


def _returns_a_class(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether a function makes a class of a plugin, which has to be defined anew for each variant."""
    classes = {node.name for node in function.body if isinstance(node, ast.ClassDef)}
    returned = {
        node.value.id
        for node in function.body
        if isinstance(node, ast.Return) and isinstance(node.value, ast.Name)
    }
    return bool(classes & returned)


def test_functions_are_short() -> None:
    long = {}
    for folder in FOLDERS:
        for file in _files(ROOT / folder):
            for function in _functions(_tree(file)):
                length = (function.end_lineno or function.lineno) - function.lineno + 1
                if length > MAX_LINES_OF_A_FUNCTION and not _returns_a_class(function):
                    long[f"{file.relative_to(ROOT)}:{function.name}"] = length
    assert long == {}


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


@pytest.mark.parametrize("folder", ["papers", "benchmarks", "experiments", "tools", "tools/fits"])
def test_scripts_are_packages(folder: str) -> None:
    assert (ROOT / folder / "__init__.py").is_file()


def test_no_modules_import_each_other_in_a_circle() -> None:
    """Imports for annotations alone, under TYPE_CHECKING, do not count."""
    graph = grimp.build_graph("loomlight", exclude_type_checking_imports=True, cache_dir=None)
    order = graphlib.TopologicalSorter(
        {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
    )
    order.prepare()


def test_the_table_of_folders_says_their_lines() -> None:
    """Within a twentieth, so that small changes need no new number."""
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    stated = {
        name: int(count) for name, count in re.findall(r"^\| `(\w+)` \| .* \| (\d+) \|", text, re.MULTILINE)
    }
    found = {
        name: sum(file.read_text(encoding="utf-8").count("\n") for file in _files(folder))
        for name in stated
        for folder in [ROOT / name if (ROOT / name).is_dir() else SOURCE / name]
    }
    assert {folder.name for folder in SOURCE.iterdir() if any(folder.glob("*.py"))} <= set(stated)
    off = {
        name: (count, found[name]) for name, count in stated.items() if abs(found[name] / count - 1) > 0.05
    }
    assert off == {}
    assert sum(file.read_text(encoding="utf-8").count("\n") for file in _files(SOURCE)) <= MAX_SOURCE_LINES
