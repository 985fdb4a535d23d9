"""A record of which pictures a command has made, so that it goes on where it stopped."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from loomlight.core.files import replacing

_KEY, _VERSION = "loomlight_pictures", 1


class PictureRecord:
    """Pictures beside a file, by name: what each was made of, and a hash of its bytes.

    A picture counts as made if the file still holds these bytes; a record that cannot be read holds none.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._made: dict[str, tuple[str, str]] = {}
        try:
            found: Any = json.loads(path.read_bytes())
            if isinstance(found, Mapping) and found.get(_KEY) == _VERSION:
                pictures = found["pictures"]
                self._made = {str(name): (str(of), str(content)) for name, (of, content) in pictures.items()}
        except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
            pass

    def holds(self, picture: Path, of: str) -> bool:
        """Whether a picture is whole and was made of what the hash `of` stands for."""
        made = self._made.get(picture.name)
        if made is None or made[0] != of:
            return False
        try:
            return _hash(picture) == made[1]
        except OSError:
            return False

    def add(self, picture: Path, of: str) -> None:
        """Notes that a picture was made of what the hash `of` stands for.

        Raises:
            InputError: the record cannot be written.
        """
        self._made[picture.name] = of, _hash(picture)
        with replacing(self.path) as temporary:
            temporary.write_text(json.dumps({_KEY: _VERSION, "pictures": self._made}), encoding="utf-8")


def _hash(picture: Path) -> str:
    return hashlib.sha256(picture.read_bytes()).hexdigest()
