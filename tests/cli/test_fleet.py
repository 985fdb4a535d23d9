"""Catalogues on clusters of one machine: Slurm through submitit, Dask through joblib; kills and a full disk.

Covers: core/fleet.py, models/bake.py
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from loomlight.cli.main import run
from tests.helpers.clusters import one_node_slurm, require_slurm
from tests.limits import HANG

pytestmark = pytest.mark.slow
NAMES = [f"fabric{number}" for number in range(6)]


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Six fabrics, in the folder in which the test works."""
    monkeypatch.chdir(tmp_path)
    for number, name in enumerate(NAMES):
        Path(f"{name}.toml").write_text(f'weave = "plain"\nends_per_cm = {20 + number}\n')
    return [f"{name}.toml" for name in NAMES]


def baking(sources: list[str], *options: str, output: str = "baked") -> list[str]:
    return ["bake", *sources, "--model", "lobes", "-o", output, *options]


def started(arguments: list[str]) -> subprocess.Popen[bytes]:
    return subprocess.Popen([sys.executable, "-m", "loomlight", *arguments], start_new_session=True)


def require_whole(folder: Path, before: dict[str, int] | None = None) -> None:
    """Every fabric is there, with a marker and without a claim; those from before are untouched."""
    assert sorted(path.name for path in folder.glob("*")) == [
        ".loomlight-bake",
        *(f"{name}.loom" for name in NAMES),
    ]
    work = folder / ".loomlight-bake"
    markers = sorted(path.name for path in work.iterdir() if path.is_file())
    assert markers == [f"{name}.done" for name in NAMES]
    for name, written in (before or {}).items():
        assert (folder / name).stat().st_mtime_ns == written, f"{name} was baked twice"


def finished(folder: Path) -> dict[str, int]:
    """When each fabric that has a marker was written."""
    markers = (folder / ".loomlight-bake").glob("*.done")
    # A marker without a file says what failed.
    files = [file for marker in markers if (file := folder / f"{marker.stem}.loom").exists()]
    return {file.name: file.stat().st_mtime_ns for file in files}


def until_some_are_finished(folder: Path, process: subprocess.Popen[bytes]) -> None:
    end = time.monotonic() + HANG
    while not finished(folder):
        assert process.poll() is None
        assert time.monotonic() < end
        time.sleep(0.02)


def test_a_killed_parent_leaves_nothing_behind_that_hinders(sources: list[str]) -> None:
    folder = Path("baked")
    process = started(baking(sources, "--workers", "2"))
    until_some_are_finished(folder, process)
    process.kill()
    process.wait()
    before = finished(folder)
    # Workers end with their parent; until then the second run waits for what they claim.
    assert run(baking(sources, "--workers", "2")) == 0
    require_whole(folder, before)


def test_two_runs_beside_each_other_share_the_work(sources: list[str]) -> None:
    first, second = (started(baking(sources, "--workers", "1")) for _ in range(2))
    assert (first.wait(HANG), second.wait(HANG)) == (0, 0)
    require_whole(Path("baked"))


@contextmanager
def small_disk(folder: Path, kilobytes: int) -> Iterator[None]:
    folder.mkdir()
    size = f"size={kilobytes}k"
    if os.geteuid() or subprocess.run(["mount", "-t", "tmpfs", "-o", size, "none", str(folder)]).returncode:
        pytest.skip("a small file system needs the right to mount one")
    try:
        yield
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=True)


def test_a_full_disk_is_said_and_the_same_command_goes_on(
    sources: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    folder = Path("baked")
    with small_disk(folder, 400):
        ballast = folder / "ballast"
        ballast.write_bytes(bytes(250_000))
        assert run(baking(sources)) == 2
        assert "No space left" in capfd.readouterr().err
        assert not [path for path in folder.iterdir() if path.suffix == ".tmp"]
        ballast.unlink()
        before = finished(folder)
        subprocess.run(["mount", "-o", "remount,size=20m", str(folder)], check=True)
        assert run(baking(sources)) == 0
        require_whole(folder, before)


def test_slurm_bakes_a_catalogue_and_a_killed_job_is_made_good(
    sources: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_slurm()
    pytest.importorskip("submitit")
    folder = Path("baked")
    with one_node_slurm(tmp_path / "slurm") as variables:
        for name, value in variables.items():
            monkeypatch.setenv(name, value)
        options = ["--workers", "2", "--executor", "slurm", "--slurm", "timeout_min=10"]
        process = started(baking(sources, *options))
        until_some_are_finished(folder, process)
        for claim in (folder / ".loomlight-bake").glob("*.claim"):
            owner = json.loads(claim.read_text() or "{}")
            if owner:
                os.kill(owner["process"], signal.SIGKILL)
                break
        process.wait(HANG)
        before = finished(folder)
        assert run(baking(sources, *options)) == 0
    shutil.rmtree(folder / ".loomlight-bake" / "jobs")
    require_whole(folder, before)


def test_dask_bakes_a_catalogue_and_draws_swatches(
    sources: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        monkeypatch.setenv("DASK_SCHEDULER_ADDRESS", cluster.scheduler_address)
        options = ["--workers", "2", "--executor", "joblib:dask"]
        assert run(baking(sources, *options)) == 0
        require_whole(Path("baked"))
        sheet = [
            "swatches",
            *sources[:2],
            "-o",
            "sheet.png",
            "--size",
            "32",
            "--spp",
            "1",
            "--model",
            "point",
        ]
        assert run([*sheet, *options]) == 0
        assert Path("sheet.png").stat().st_size > 0
