"""The clients' own checks: their types, and the tests that run without a browser."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.limits import HANG
from tests.marks import slow

WEB = Path(__file__).parents[2] / "web"
# Half of the time.
LONG = ("editor/test/never_dead.test.ts", "fabric/test/edit.test.ts")


@pytest.mark.parametrize(
    "arguments",
    [
        ("tsc", "--noEmit", "--project", "tsconfig.json"),
        ("vitest", "run", *(f"--exclude={file}" for file in LONG)),
        slow(("vitest", "run", *LONG)),
    ],
    ids=["types", "tests", "long tests"],
)
def test_types_and_tests_of_the_clients(arguments: tuple[str, ...]) -> None:
    program = WEB / "node_modules" / ".bin" / arguments[0]
    if shutil.which("node") is None or not program.exists():
        pytest.skip("the packages of web/ are not installed: npm install in web/")
    done = subprocess.run(
        [program, *arguments[1:]], cwd=WEB, capture_output=True, text=True, timeout=HANG, check=False
    )
    assert done.returncode == 0, (done.stdout + done.stderr)[-4000:]
