"""Runs of the encoder without cached latents.

Covers: studies/papers/chen2024/cache.py
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from studies.papers.chen2024.cache import without_cached_latents


@pytest.mark.parametrize("before", ["/somewhere", None])
def test_the_cache_is_elsewhere_empty_and_given_back(
    before: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    if before is None:
        monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    else:
        monkeypatch.setenv("XDG_CACHE_HOME", before)
    with without_cached_latents():
        folder = Path(os.environ["XDG_CACHE_HOME"])
        assert folder.is_dir()
        assert str(folder) != before
        assert list(folder.iterdir()) == []
    assert not folder.exists()
    assert os.environ.get("XDG_CACHE_HOME") == before


def test_it_is_given_back_after_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", "/somewhere")
    with pytest.raises(ZeroDivisionError), without_cached_latents():
        raise ZeroDivisionError
    assert os.environ["XDG_CACHE_HOME"] == "/somewhere"
