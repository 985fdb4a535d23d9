"""Functions and commands in processes of their own."""

from __future__ import annotations

import operator
import os
import sys
from pathlib import Path

import pytest

from loomlight.core.errors import LoomlightError
from studies.instruments.processes import cost_of, in_own_process


def test_a_function_answers_from_its_own_process() -> None:
    assert in_own_process(operator.add, 1, 2) == 3
    assert in_own_process(os.getpid) != os.getpid()
    assert in_own_process(os.getenv, "OF_A_STUDY", environment={"OF_A_STUDY": "1"}) == "1"


def test_a_function_that_fails_says_why() -> None:
    with pytest.raises(LoomlightError, match=r"^int failed: ValueError: .*'x'"):
        in_own_process(int, "x")


def test_the_cost_of_a_command(tmp_path: Path) -> None:
    file = tmp_path / "shown"
    write = f"open({os.fspath(file)!r}, 'w'); bytearray(50_000_000).count(0)"
    cost = cost_of([sys.executable, "-c", write], shows=file)
    # Fifty megabytes are held; the file may be seen only when all is over.
    assert cost["peak_megabytes"] > 50
    assert cost["seconds"] >= cost.get("first_seconds", 0)
    with pytest.raises(LoomlightError, match="failed: no such luck"):
        cost_of([sys.executable, "-c", "import sys; print('no such luck'); sys.exit(1)"])
