"""Which process a name is of, and whether it has ended."""

from __future__ import annotations

import subprocess
import sys

from loomlight.core.files import has_ended, process_identity


def test_a_process_has_ended_when_it_has() -> None:
    code = (
        "import sys; from loomlight.core.files import *;"
        "print(process_identity(), flush=True); sys.stdin.read()"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    name = process.stdout.readline().strip()
    assert not has_ended(name)
    assert not has_ended(process_identity())
    process.kill()
    process.communicate()
    assert has_ended(name)


def test_another_process_of_that_number_is_another() -> None:
    machine, number, begun = process_identity().split(".")
    assert has_ended(f"{machine}.{number}.{int(begun) + 1}")


def test_of_other_machines_nothing_is_known() -> None:
    _, number, begun = process_identity().split(".")
    assert not has_ended(f"0123456789ab.{number}.{int(begun) + 1}")
    assert not has_ended("what a person wrote")
