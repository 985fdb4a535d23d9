"""What differs between two records of a study: figures by their place, the largest changes first."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from studies.harness.study import Figures

# Of the larger of two numbers: smaller changes are not named.
_TOLERANCE = 0.01
_MOST = 20


@dataclass(frozen=True)
class Change:
    """A figure that two records have otherwise.

    Attributes:
        place: names and numbers that lead to it, such as "rows.3.errors.lobes".
        before, now: what the records have there; None where one has nothing.
    """

    place: str
    before: Any
    now: Any

    @property
    def size(self) -> float:
        """The difference over the larger of two numbers; infinite where they are no numbers."""
        if not (_is_number(self.before) and _is_number(self.now)):
            return math.inf
        return abs(self.now - self.before) / max(abs(self.before), abs(self.now))

    def __str__(self) -> str:
        change = f"{self.place}: {_text(self.before)} → {_text(self.now)}"
        if not math.isfinite(self.size) or not self.before:
            return change
        return f"{change} ({100 * (self.now / self.before - 1):+.3g} %)"


def changes(before: Figures, now: Figures, tolerance: float = _TOLERANCE) -> list[Change]:
    """All figures that differ by more than `tolerance`, the largest changes first."""
    one, other = dict(_leaves(before)), dict(_leaves(now))
    found = [Change(place, one.get(place), other.get(place)) for place in {**one, **other}]
    differing = [each for each in found if each.before != each.now and each.size > tolerance]
    return sorted(differing, key=lambda each: -each.size)


def changes_text(before: Figures, now: Figures) -> str:
    """The largest changes, a line each, and how many there are."""
    found = changes(before, now)
    count = len(dict(_leaves(now)))
    if not found:
        return f"None of {count} figures differs by more than {100 * _TOLERANCE:g} %."
    lines = [str(change) for change in found[:_MOST]]
    more = [f"… and {len(found) - _MOST} more"] if len(found) > _MOST else []
    said = f"{len(found)} of {count} figures differ by more than {100 * _TOLERANCE:g} %:"
    return "\n".join([said, *lines, *more])


def _leaves(value: Any, place: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict | list):
        parts = value.items() if isinstance(value, dict) else enumerate(value)
        for name, part in parts:
            yield from _leaves(part, f"{place}.{name}" if place else str(name))
    else:
        yield place, value


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _text(value: Any) -> str:
    return "nothing" if value is None else f"{value:.4g}" if _is_number(value) else str(value)
