"""Runs of the encoder without cached latents, for measuring."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

from loomlight.models.neural.encoding import clear_encodings


@contextmanager
def without_cached_latents() -> Iterator[None]:
    """Replaces the cache of latents by an empty temporary folder."""
    before = os.environ.get("XDG_CACHE_HOME")
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_CACHE_HOME"] = folder
        clear_encodings()
        try:
            yield
        finally:
            if before is None:
                del os.environ["XDG_CACHE_HOME"]
            else:
                os.environ["XDG_CACHE_HOME"] = before
