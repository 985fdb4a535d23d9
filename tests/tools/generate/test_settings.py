"""Tables of settings in the pages are those that are declared."""

from __future__ import annotations

import pytest

from tools.generate.settings import ROOT, TABLES, with_tables


@pytest.mark.parametrize("page", TABLES)
def test_tables_of_pages_are_written_from_the_declarations(page: str) -> None:
    """If not, run `python -m tools.generate.settings`."""
    text = (ROOT / page).read_text(encoding="utf-8")
    assert with_tables(page, text) == text
