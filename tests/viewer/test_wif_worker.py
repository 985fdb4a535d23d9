"""Drafts that came over the network are read by a process of limited time and memory, which stays for others.

Covers: viewer/wif_worker.py, viewer/limited_reader.py
"""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from loomlight.core.errors import InputError
from loomlight.viewer.limited_reader import MAX_UPLOAD, DraftReader, safe_name

WIF = (Path(__file__).resolve().parents[2] / "examples" / "undulating-twill.wif").read_bytes()


def read(content: bytes, name: str, **limits: Any) -> dict[str, Any]:
    with closing(DraftReader(**limits)) as reader:
        return dict(json.loads(reader.read(content, name)))


def draft_of(threads: int) -> bytes:
    lines = ["[WIF]", "Version=1.1", "[WEAVING]", "Shafts=2", "Treadles=2", "[THREADING]"]
    lines += [f"{number}={1 + number % 2}" for number in range(1, threads + 1)]
    lines += ["[TIEUP]", "1=1", "2=2", "[TREADLING]"]
    lines += [f"{number}={1 + number % 2}" for number in range(1, threads + 1)]
    return "\n".join(lines).encode()


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
    # The interpreter and its libraries start within this, and a draft of 144 ends is read, but not this one.
    with pytest.raises(InputError, match=r"^large\.wif .*memory"):
        read(draft_of(16384), "large.wif", memory_bytes=400 << 20)


def test_names_are_made_safe() -> None:
    assert safe_name("../../etc/passwd") == "passwd"
    assert safe_name("a\\b\\twill.wif") == "twill.wif"
    assert safe_name("x" * 1000 + ".wif") == "x" * 120 + ".wif"
    assert safe_name("\x1b[31m.wif") == "_31m.wif"
    assert safe_name("..") == "draft"
    assert MAX_UPLOAD < 200 << 20


@pytest.fixture
def reader() -> Iterator[DraftReader]:
    with closing(DraftReader()) as made:
        yield made


def process_of(reader: DraftReader) -> int:
    assert reader._process is not None
    return reader._process.pid


def test_one_process_reads_drafts_one_after_another(reader: DraftReader) -> None:
    json.loads(reader.read(WIF, "a.wif"))
    first = process_of(reader)
    with pytest.raises(InputError, match=r"^b\.wif"):
        reader.read(b"nothing", "b.wif")
    assert json.loads(reader.read(draft_of(641), "c.wif"))["ends"] == 641
    assert process_of(reader) == first


def test_a_process_that_ended_is_replaced(reader: DraftReader) -> None:
    reader.read(WIF, "a.wif")
    first = process_of(reader)
    os.kill(first, signal.SIGKILL)
    os.waitid(os.P_PID, first, os.WEXITED | os.WNOWAIT)
    assert json.loads(reader.read(WIF, "a.wif"))["ends"] == 144
    assert process_of(reader) != first


def test_a_process_is_replaced_after_many_drafts(
    reader: DraftReader, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("loomlight.viewer.limited_reader._MAX_SERVED", 2)
    reader.read(WIF, "a.wif")
    first = process_of(reader)
    reader.read(WIF, "a.wif")
    reader.read(WIF, "a.wif")
    assert process_of(reader) != first


def test_nothing_is_left_of_a_closed_reader() -> None:
    made = DraftReader()
    made.read(WIF, "a.wif")
    assert made._process is not None
    process, folder = made._process, Path(str(made._process.args[3]))
    assert folder.is_dir()
    made.close()
    assert process.returncode is not None
    assert not folder.exists()
