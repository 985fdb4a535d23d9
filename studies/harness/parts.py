"""Parts of a long run, kept as they are made, so that an interrupted run goes on where it stopped."""

from __future__ import annotations

import json
import resource
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from loomlight.core.files import replacing

Made = TypeVar("Made")


def processor_seconds() -> float:
    """Of all threads of this process, and of its children that have ended."""
    used = [resource.getrusage(whose) for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


class Parts:
    """Values of JSON by name, in a file; without a file they are not kept.

    What the file holds counts if it is `of` the same: settings, sources and outputs of probes.
    """

    def __init__(self, path: Path | None = None, of: Any = None) -> None:
        self._path, self._of = path, of
        self._parts: dict[str, Any] = {}
        self._begun, self._earlier_seconds = processor_seconds(), 0.0
        content = self._read()
        if content.get("of") == as_json(of) and isinstance(content.get("parts"), dict):
            self._parts = content["parts"]
            self._earlier_seconds = float(content.get("processor_seconds", 0))

    def __len__(self) -> int:
        return len(self._parts)

    @property
    def processor_seconds(self) -> float:
        """Of this run and of those before that were interrupted."""
        return self._earlier_seconds + processor_seconds() - self._begun

    def kept(self, name: str, make: Callable[[], Made]) -> Made:
        """What an earlier run made of this name, or what `make` makes now, as JSON holds it."""
        if name not in self._parts:
            self._parts[name] = as_json(make())
            self._write()
        return self._parts[name]

    def forget(self) -> None:
        """Removes the file, as the record holds it all."""
        if self._path is not None:
            self._path.unlink(missing_ok=True)

    def _read(self) -> dict[str, Any]:
        try:
            content = json.loads(self._path.read_bytes()) if self._path is not None else {}
        except (OSError, ValueError, RecursionError):
            return {}
        return content if isinstance(content, dict) else {}

    def _write(self) -> None:
        if self._path is None:
            return
        self._path.parent.mkdir(parents=True, exist_ok=True)
        content = {"of": self._of, "processor_seconds": self.processor_seconds, "parts": self._parts}
        with replacing(self._path) as temporary:
            temporary.write_text(json.dumps(content), encoding="utf-8")


def as_json(value: Any) -> Any:
    """The value as it is read from JSON: arrays as lists, tuples as lists, keys as texts."""
    return json.loads(json.dumps(value, default=_plain))


def _plain(value: object) -> object:
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no value of JSON")
