"""Wheel and source archive are built and installed, alone and with each extra.

Every command works, or says in one sentence which extra it needs.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.errors import MissingDependencyError

from .environments import NO_SLANGC, UnreachableError, installations, matrix


@pytest.mark.slow
def test_commands_work_or_name_the_extra_in_every_installation(tmp_path: Path) -> None:
    found = []
    try:
        for environment in installations(tmp_path):
            found.append(environment)
    except UnreachableError as reason:
        pytest.skip(f"packages cannot be installed here: {reason}")
    except MissingDependencyError as reason:  # of the editor's page, by Node
        pytest.skip(str(reason))
    print(matrix(found))
    assert {each.name: each.faults for each in found if each.faults} == {}
    assert found[-1].name == NO_SLANGC
