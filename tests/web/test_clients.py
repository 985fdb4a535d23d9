"""The clients' own checks: their types, and the tests that run without a browser."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.limits import HANG

WEB = Path(__file__).parents[2] / "web"


@pytest.mark.parametrize("arguments", [("tsc", "--noEmit", "--project", "tsconfig.json"), ("vitest", "run")])
def test_types_and_tests_of_the_clients(arguments: tuple[str, ...]) -> None:
    program = WEB / "node_modules" / ".bin" / arguments[0]
    if shutil.which("node") is None or not program.exists():
        pytest.skip("the packages of web/ are not installed: npm install in web/")
    done = subprocess.run(
        [program, *arguments[1:]], cwd=WEB, capture_output=True, text=True, timeout=HANG, check=False
    )
    assert done.returncode == 0, (done.stdout + done.stderr)[-4000:]
