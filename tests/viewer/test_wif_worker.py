"""Drafts that came over the network are read by a process of limited time and memory."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from loomlight.core.errors import InputError
from loomlight.viewer import wif_worker
from loomlight.viewer.wif_worker import read_uploaded_draft, safe_name

WIF = (Path(__file__).resolve().parents[2] / "examples" / "undulating-twill.wif").read_bytes()


def read(content: bytes, name: str, **limits: Any) -> dict[str, Any]:
    # In a thread of its own: Playwright leaves its loop running in that of the tests.
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: asyncio.run(read_uploaded_draft(content, name, **limits))).result()


def test_draft_is_read() -> None:
    draft = read(WIF, "twill.wif")
    assert (draft["ends"], draft["picks"], draft["name"]) == (144, 96, "Undulating twill")
    assert draft["warnings"] == []


def test_broken_file_is_named_without_the_folder_that_it_lay_in() -> None:
    with pytest.raises(InputError, match=r"^broken\.wif.*weaving information file"):
        read(b"\0\1\2", "../somewhere/broken.wif")


def test_time_is_limited() -> None:
    with pytest.raises(InputError, match=r"given up after 0\.01 s"):
        read(WIF, "twill.wif", seconds=0.01)


def test_memory_is_limited() -> None:
    # A draft of 16384 threads both ways takes 256 MiB for its drawdown alone.
    lines = ["[WIF]", "Version=1.1", "[WEAVING]", "Shafts=2", "Treadles=2", "[THREADING]"]
    lines += [f"{number}={1 + number % 2}" for number in range(1, 16385)]
    lines += ["[TIEUP]", "1=1", "2=2", "[TREADLING]"]
    lines += [f"{number}={1 + number % 2}" for number in range(1, 16385)]
    # The interpreter and its libraries start within this, and a draft of 144 ends is read, but not this one.
    with pytest.raises(InputError, match=r"^large\.wif .*memory"):
        read("\n".join(lines).encode(), "large.wif", memory_bytes=400 << 20)


def test_names_are_made_safe() -> None:
    assert safe_name("../../etc/passwd") == "passwd"
    assert safe_name("a\\b\\twill.wif") == "twill.wif"
    assert safe_name("x" * 1000 + ".wif") == "x" * 120 + ".wif"
    assert safe_name("\x1b[31m.wif") == "_31m.wif"
    assert safe_name("..") == "draft"
    assert wif_worker.MAX_UPLOAD < 200 << 20
