"""The store of queries: what is read is what was computed, whatever happened to the program that wrote it.

Covers: studies/papers/chen2024/dataset_store.py
"""

import contextlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.errors import InputError, LoomlightWarning, MissingDependencyError
from loomlight.core.fleet import Executor
from studies.papers.chen2024 import dataset_store as store_module
from studies.papers.chen2024.dataset_store import (
    BYTES_A_QUERY,
    QueryStore,
    StoreSettings,
    make_store,
)
from studies.papers.chen2024.materials import paper_material
from studies.papers.chen2024.queries import material_queries, slice_means
from tests.limits import HANG

SETTINGS = StoreSettings(seed=3, queries=4096)
NUMBERS = (79, 80, 81)


def contents(folder: Path) -> dict[str, bytes]:
    """Every file of a store by its path, but for the root's provenance."""
    actual = {
        str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()
    }
    root = json.loads(actual.pop("zarr.json"))
    root["attributes"].pop("made_with")
    return actual | {"zarr.json": json.dumps(root).encode()}


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("stores") / "made.zarr"
    assert make_store(path, NUMBERS, SETTINGS, Float, "test") == NUMBERS
    return path


@pytest.fixture
def copied(made, tmp_path) -> Path:
    return Path(shutil.copytree(made, tmp_path / "copy.zarr"))


def test_what_is_read_is_what_was_computed(made):
    store = QueryStore(made)
    assert store.numbers == NUMBERS
    assert store.settings == SETTINGS
    material = store.material(80)
    queries = material_queries(80, SETTINGS.seed, SETTINGS.queries)
    for name in ("lights", "views", "pairs", "centres", "sizes"):
        np.testing.assert_array_equal(getattr(material.queries, name), getattr(queries, name))
    truth = slice_means(paper_material(80, SETTINGS.seed), queries, Float)
    # float16 keeps 11 bits; below its normal numbers it is exact to 3e-8.
    np.testing.assert_allclose(material.truth(), truth, rtol=2**-11, atol=3e-8)
    assert truth.max() > 0.1


@pytest.mark.slow
def test_several_processes_write_the_same_bytes(made, tmp_path):
    path = tmp_path / "shared.zarr"
    make_store(path, NUMBERS[1:], SETTINGS, Float, "test", executor=Executor(workers=2))
    names = [name for name in contents(made) if name.startswith(("material_0080", "material_0081"))]
    assert {name: contents(path)[name] for name in names} == {name: contents(made)[name] for name in names}
    assert [entry.name for entry in tmp_path.iterdir()] == ["shared.zarr"]


def test_half_precision_changes_means_by_less_than_the_grid_does(made):
    """The grid's least error is 0.03 % of the mean (docs/research/aggregation.md, b2 and b3 at 64 texels)."""
    queries = material_queries(81, SETTINGS.seed, SETTINGS.queries)
    truth = slice_means(paper_material(81, SETTINGS.seed), queries, Float).astype(np.float64)
    error = np.abs(QueryStore(made).material(81).truth() - truth)
    assert (error.mean(axis=(0, 1)) < 3e-4 * truth.mean(axis=(0, 1))).all()
    assert error.max() > 0


def test_components_are_one_shard(made):
    shards = [file for file in (made / "material_0080" / "components" / "c").rglob("*") if file.is_file()]
    assert len(shards) == 1


def test_what_the_store_says_of_itself(made):
    attributes = QueryStore(made).attributes
    assert attributes["version"] == 1
    assert attributes["ranges"]["height_scale"] == [0.2, 1.0]
    assert {"command", "sources", "machine"} <= attributes["made_with"].keys()
    parameters = json.loads((made / "material_0081" / "zarr.json").read_text())["attributes"]
    assert parameters["weave"] == "twill 3×3"
    assert parameters["warp"]["roughness"] == paper_material(81, 3).fields.warp.roughness


def test_materials_that_are_finished_are_left_alone(copied, monkeypatch):
    shutil.rmtree(copied / "material_0080")
    before = contents(copied)
    times = {file: file.stat().st_mtime_ns for file in copied.rglob("c/*") if file.is_file()}
    told: list[tuple[int, int]] = []
    make_store(copied, NUMBERS, SETTINGS, Float, "again", lambda done, total: told.append((done, total)))
    after = contents(copied)
    assert before.items() <= after.items()
    assert all(file.stat().st_mtime_ns == then for file, then in times.items())
    assert told == [(2, 3), (3, 3)]


@pytest.mark.slow
def test_killed_at_any_moment_and_run_again_the_bytes_are_the_same(made, tmp_path):
    path = tmp_path / "killed.zarr"
    code = (
        "import sys; from drjit.llvm.ad import Float;"
        "from studies.papers.chen2024.dataset_store import *;"
        f"make_store(sys.argv[1], {NUMBERS}, StoreSettings(3, 4096), Float, 'killed')"
    )
    # The first is killed once a material is there, the second at once when it begins to write one.
    for pattern in ("material_*", ".partial-0*"):
        process = subprocess.Popen([sys.executable, "-c", code, str(path)])
        while not list(path.glob(pattern)) and process.poll() is None:
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        there = QueryStore(path).numbers
        for number in there:
            QueryStore(path).material(number)
    make_store(path, NUMBERS, SETTINGS, Float, "test")
    assert contents(path) == contents(made)


@pytest.mark.slow
def test_with_two_workers_one_of_them_killed_the_bytes_are_the_same(made, tmp_path):
    """kill −9 of the worker that has claimed the first material, while the other works."""
    path = tmp_path / "crew.zarr"
    process = subprocess.Popen([sys.executable, "-c", _CREW, str(path)])
    killed = 0
    while not killed and process.poll() is None:
        for claim in tmp_path.glob(".loomlight-crew.zarr.parts/*.claim"):
            with contextlib.suppress(ValueError, OSError):  # it is being written, or done with
                killed = killed or json.loads(claim.read_text())["process"]
        time.sleep(0.002)
    assert killed not in (0, process.pid)
    os.kill(killed, signal.SIGKILL)
    assert process.wait(HANG) == 0
    assert contents(path) == contents(made)
    assert [entry.name for entry in tmp_path.iterdir()] == ["crew.zarr"]


_CREW = f"""
import sys
from drjit.llvm.ad import Float
from loomlight.core.fleet import Executor
from studies.papers.chen2024.dataset_store import StoreSettings, make_store
if __name__ == "__main__":
    make_store(sys.argv[1], {NUMBERS}, StoreSettings(3, 4096), Float, "crew", executor=Executor(workers=2))
"""


@pytest.mark.skipif(os.name != "posix", reason="limits of file sizes are POSIX")
def test_no_empty_store_is_left_on_a_full_disk(tmp_path):
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
        with pytest.raises(InputError, match="the disk is full"):
            make_store(tmp_path / "new.zarr", NUMBERS, SETTINGS, Float, "full")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(os.name != "posix", reason="limits of file sizes are POSIX")
def test_disk_full_is_one_sentence_and_what_is_finished_stays(copied):
    shutil.rmtree(copied / "material_0081")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        # A file that cannot grow fails as on a full disk, inside Zarr's own writer.
        resource.setrlimit(resource.RLIMIT_FSIZE, (4000, hard))
        with pytest.raises(InputError) as caught:
            make_store(copied, NUMBERS, SETTINGS, Float, "full")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    message = str(caught.value)
    assert "the disk is full" in message
    assert "79–80 (2 of 465) finished and usable" in message
    assert "\n" not in message
    assert not list(copied.glob(".partial*"))
    store = QueryStore(copied)
    assert store.numbers == (79, 80)
    store.material(80)
    assert make_store(copied, NUMBERS, SETTINGS, Float, "full") == NUMBERS


def test_too_little_space_is_told_before(made, tmp_path, monkeypatch):
    free = 10 * SETTINGS.queries * BYTES_A_QUERY
    monkeypatch.setattr(store_module.shutil, "disk_usage", lambda path: shutil._ntuple_diskusage(0, 0, free))
    monkeypatch.setattr(store_module, "_write_material", lambda *arguments: None)
    with pytest.warns(LoomlightWarning, match="11 materials take about"):
        make_store(tmp_path / "a.zarr", range(11), SETTINGS, Float, "test")


def test_other_settings_are_refused(made):
    for settings, name in (
        (StoreSettings(4, 4096), "seed = 3, not 4"),
        (StoreSettings(3, 4097), "4096, not 4097"),
    ):
        with pytest.raises(InputError, match=name):
            make_store(made, NUMBERS, settings, Float, "test")


DAMAGES = {
    "no folder": (lambda path: shutil.rmtree(path), "is no folder"),
    "an empty folder": (lambda path: [shutil.rmtree(path), path.mkdir()], "missing or damaged"),
    "a cut root": (lambda path: cut(path / "zarr.json"), "missing or damaged"),
    "another format": (lambda path: edited(path, "format", "other"), "no store of queries made by"),
    "a newer version": (lambda path: edited(path, "version", 2), "version 2 of its format"),
    "no seed": (lambda path: edited(path, "seed", None), '"seed" in its zarr.json'),
}


def cut(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def flip(file: Path) -> None:
    content = bytearray(file.read_bytes())
    content[len(content) // 3] ^= 0x10
    file.write_bytes(content)


def edited(path: Path, name: str, value: object) -> None:
    root = json.loads((path / "zarr.json").read_text())
    root["attributes"][name] = value
    (path / "zarr.json").write_text(json.dumps(root))


@pytest.mark.parametrize("damage", DAMAGES)
def test_foreign_and_damaged_stores_are_refused(copied, damage):
    change, sentence = DAMAGES[damage]
    change(copied)
    with pytest.raises(InputError, match=sentence) as caught:
        QueryStore(copied)
    assert "\n" not in str(caught.value)


MATERIAL_DAMAGES = {
    "a cut shard": lambda folder: cut(folder / "components" / "c" / "0" / "0" / "0"),
    "a flipped bit": lambda folder: flip(folder / "components" / "c" / "0" / "0" / "0"),
    "a flipped bit of directions": lambda folder: flip(folder / "lights" / "c" / "0" / "0"),
    "a missing array": lambda folder: shutil.rmtree(folder / "holes"),
    "cut metadata": lambda folder: cut(folder / "sizes" / "zarr.json"),
    "another material's views": lambda folder: [
        shutil.rmtree(folder / "sizes"),
        shutil.copytree(folder / "lights", folder / "sizes"),
    ],
}


@pytest.mark.parametrize("damage", MATERIAL_DAMAGES)
def test_damaged_materials_are_refused_and_the_others_read(copied, damage):
    MATERIAL_DAMAGES[damage](copied / "material_0080")
    store = QueryStore(copied)
    with pytest.raises(InputError, match="material_0080 is damaged") as caught:
        store.material(80)
    assert "\n" not in str(caught.value)
    store.material(79)


def test_a_material_that_is_missing_is_told_with_those_there(made):
    with pytest.raises(InputError, match=r"no material 82; it has materials 79–81 \(3 of 465\)"):
        QueryStore(made).material(82)


def test_foreign_folders_are_not_written_into(tmp_path):
    (tmp_path / "photo.png").write_bytes(b"")
    with pytest.raises(InputError, match="other files in it"):
        make_store(tmp_path, [0], SETTINGS, Float, "test")
    with pytest.raises(InputError, match="is a file"):
        make_store(tmp_path / "photo.png", [0], SETTINGS, Float, "test")
    assert [entry.name for entry in tmp_path.iterdir()] == ["photo.png"]


def test_two_programs_may_finish_the_same_material(copied, monkeypatch):
    """The slower one leaves what the faster one renamed into place."""
    finished = {number: contents(copied)[f"material_00{number}/components/c/0/0/0"] for number in NUMBERS}
    monkeypatch.setattr(store_module, "finished", lambda path: ())
    make_store(copied, [80], SETTINGS, Float, "test")
    assert contents(copied)["material_0080/components/c/0/0/0"] == finished[80]
    assert not list(copied.glob(".partial*"))


@pytest.mark.parametrize(
    ("settings", "number", "sentence"),
    [
        (StoreSettings(-1, 4096), 0, "seed -1"),
        (StoreSettings(0, 10), 0, "10 queries"),
        (StoreSettings(0, 10**9), 0, "1000000000 queries"),
        (StoreSettings(0, 4096), 465, "material 465 does not exist"),
    ],
)
def test_settings_out_of_range_are_refused(tmp_path, settings, number, sentence):
    with pytest.raises(InputError, match=sentence):
        make_store(tmp_path / "a.zarr", [number], settings, Float, "test")
    assert not (tmp_path / "a.zarr").exists()


def test_without_zarr_a_sentence_names_the_extra(made, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    for use in (
        lambda: QueryStore(made),
        lambda: make_store(tmp_path / "a.zarr", [0], SETTINGS, Float, "test"),
    ):
        with pytest.raises(
            MissingDependencyError, match=r"A stored data set needs zarr: pip install 'loomlight\[data\]'\.$"
        ):
            use()
    assert not (tmp_path / "a.zarr").exists()
