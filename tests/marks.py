"""Marks of single cases of parametrised tests."""

from __future__ import annotations

from collections.abc import Container, Iterable
from typing import Any

import pytest


def slow(*values: Any, id: str | None = None) -> Any:
    """A case that `make test` leaves out."""
    return pytest.param(*values, id=id, marks=pytest.mark.slow)


def slow_among(names: Iterable[str], chosen: Container[str]) -> list[Any]:
    """Cases of one name each, of which the chosen ones are slow."""
    return [slow(name) if name in chosen else name for name in names]
