"""Claims and markers: who has a shard, who has died of it, which outcomes count."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from loomlight.core.fleet import Outcome, Shard, ShardFolder
from tests.limits import HANG

SHARD = Shard("denim", "settings 1")
# Claims a shard, says so and waits for ever.
HOLDS = """
import sys
from pathlib import Path
from loomlight.core.fleet import Shard, ShardFolder
folder = ShardFolder(Path(sys.argv[1]), sys.argv[2])
with folder.claimed(Shard("denim", "settings 1"), wait=False) as is_mine:
    print(is_mine, flush=True)
    sys.stdin.read()
"""


def holder(folder: Path, run: str = "one") -> subprocess.Popen[str]:
    process = subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(folder), run],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "True\n"
    return process


def kill(process: subprocess.Popen[str]) -> None:
    process.kill()
    process.communicate()


def test_a_shard_is_claimed_once(tmp_path: Path) -> None:
    folder = ShardFolder(tmp_path / "work", "one")
    with folder.claimed(SHARD, wait=False) as first, folder.claimed(SHARD, wait=False) as second:
        assert (first, second) == (True, False)
    with folder.claimed(SHARD, wait=False) as again:
        assert again
    folder.remove_lock(SHARD)
    assert os.listdir(folder.path) == []


def test_the_claim_of_a_killed_process_is_taken_over(tmp_path: Path) -> None:
    folder = ShardFolder(tmp_path, "one")
    process = holder(tmp_path)
    with folder.claimed(SHARD, wait=False) as is_mine:
        assert not is_mine
    kill(process)
    assert (tmp_path / "denim.claim").exists()
    with folder.claimed(SHARD, wait=False) as is_mine:
        assert is_mine
        assert folder.outcome(SHARD) is None
    assert not (tmp_path / "denim.claim").exists()


def test_waiting_ends_when_the_owner_is_killed(tmp_path: Path) -> None:
    folder, taken = ShardFolder(tmp_path, "one"), threading.Event()
    process = holder(tmp_path)

    def wait() -> None:
        with folder.claimed(SHARD, wait=True) as is_mine:
            if is_mine:
                taken.set()

    waiting = threading.Thread(target=wait)
    waiting.start()
    assert not taken.is_set()
    kill(process)
    waiting.join(HANG)
    assert taken.is_set()


def test_a_shard_that_kills_its_processes_is_given_up_in_this_run_alone(tmp_path: Path) -> None:
    for _ in range(2):
        kill(holder(tmp_path))
    folder = ShardFolder(tmp_path, "one")
    with folder.claimed(SHARD, wait=False):
        outcome = folder.outcome(SHARD)
    assert outcome is not None
    assert outcome.fault == "denim: its process ended 2 times without an error: is there too little memory?"
    assert ShardFolder(tmp_path, "two").outcome(SHARD) is None


def test_results_are_kept_and_failures_are_of_one_run(tmp_path: Path) -> None:
    one, two = (ShardFolder(tmp_path, run) for run in ("one", "two"))
    whole = Outcome(b"\x00\n\xff", warnings=("It was mended.",))
    one.store(SHARD, whole)
    assert two.outcome(SHARD) == whole
    assert two.outcome(Shard("denim", "settings 2")) is None
    one.forget(SHARD)
    assert one.outcome(SHARD) is None
    one.store(SHARD, Outcome(fault="denim.toml does not exist."))
    assert one.outcome(SHARD) == Outcome(fault="denim.toml does not exist.")
    assert two.outcome(SHARD) is None


def test_a_damaged_marker_is_none(tmp_path: Path) -> None:
    folder = ShardFolder(tmp_path, "one")
    (tmp_path / "denim.done").write_bytes(b'{"identity": "settings 1"')
    assert folder.outcome(SHARD) is None


def test_keys_are_names_of_files() -> None:
    with pytest.raises(ValueError, match="no name"):
        Shard("../a", "")
