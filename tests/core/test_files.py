"""Files appear whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from loomlight.core.files import discarding_empty, replacing, replacing_all


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_file_appears_when_the_block_ends(tmp_path: Path) -> None:
    target = tmp_path / "cloth.png"
    with replacing(target) as temporary:
        temporary.write_bytes(b"whole")
        assert not target.exists()
        assert temporary.suffix == ".png"
    assert target.read_bytes() == b"whole"
    assert names_in(tmp_path) == ["cloth.png"]


def write_half_and_fail(target: Path, failure: BaseException) -> None:
    with replacing(target) as temporary:
        temporary.write_bytes(b"half")
        raise failure


def test_a_failure_leaves_what_was_there(tmp_path: Path) -> None:
    target = tmp_path / "cloth.png"
    target.write_bytes(b"before")
    with pytest.raises(ZeroDivisionError):
        write_half_and_fail(target, ZeroDivisionError())
    assert target.read_bytes() == b"before"
    assert names_in(tmp_path) == ["cloth.png"]


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EDQUOT, errno.EIO])
def test_a_full_disk_leaves_nothing_half_written(tmp_path: Path, code: int) -> None:
    target = tmp_path / "cloth.png"
    with pytest.raises(InputError) as caught:
        write_half_and_fail(target, OSError(code, os.strerror(code)))
    assert names_in(tmp_path) == []
    assert str(target) in str(caught.value)
    assert os.strerror(code) in str(caught.value)


def test_a_disk_that_is_really_full(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    target = tmp_path / "cloth.png"
    with (
        pytest.raises(InputError, match="No space left"),
        replacing(target),
        open("/dev/full", "wb", buffering=0) as full,
    ):
        full.write(b"x")
    assert names_in(tmp_path) == []


def test_an_interruption_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        write_half_and_fail(tmp_path / "cloth.png", KeyboardInterrupt())
    assert names_in(tmp_path) == []


def test_no_folder(tmp_path: Path) -> None:
    with (
        pytest.raises(InputError, match="does not exist; make it first"),
        replacing(tmp_path / "a" / "b.png"),
    ):
        pytest.fail("the block must not run")


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is a folder"), replacing(tmp_path):
        pytest.fail("the block must not run")


def test_the_file_follows_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        with replacing(tmp_path / "cloth.png"):
            pass
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "cloth.png").stat().st_mode) == 0o640


def test_files_that_belong_together_appear_together(tmp_path: Path) -> None:
    names = ["a.png", "b.png", "c.png"]
    with replacing_all([tmp_path / name for name in names]) as temporaries:
        for number, temporary in enumerate(temporaries):
            temporary.write_text(str(number))
        assert not set(names) & set(names_in(tmp_path))
    assert [(tmp_path / name).read_text() for name in names] == ["0", "1", "2"]
    assert names_in(tmp_path) == names


def write_one_of_two(folder: Path, failure: BaseException) -> None:
    with replacing_all([folder / "a.png", folder / "b.png"]) as temporaries:
        temporaries[0].write_text("whole")
        raise failure


@pytest.mark.parametrize("failure", [OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)), KeyboardInterrupt()])
def test_of_files_that_belong_together_none_appears_alone(tmp_path: Path, failure: BaseException) -> None:
    (tmp_path / "a.png").write_text("before")
    expected = InputError if isinstance(failure, OSError) else KeyboardInterrupt
    with pytest.raises(expected):
        write_one_of_two(tmp_path, failure)
    assert names_in(tmp_path) == ["a.png"]
    assert (tmp_path / "a.png").read_text() == "before"


def make_folders_and_fail(folder: Path, file: str | None) -> None:
    with discarding_empty(folder):
        (folder / "pictures").mkdir(parents=True, exist_ok=True)
        if file is not None:
            (folder / file).write_text("one")
        raise ZeroDivisionError


def test_an_empty_folder_goes_with_the_error(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        make_folders_and_fail(tmp_path / "new", None)
    assert names_in(tmp_path) == []
    with pytest.raises(ZeroDivisionError):
        make_folders_and_fail(tmp_path / "new", "one.txt")
    assert names_in(tmp_path / "new") == ["one.txt"]
    (tmp_path / "there").mkdir()
    with pytest.raises(ZeroDivisionError):
        make_folders_and_fail(tmp_path / "there", None)
    assert (tmp_path / "there").is_dir()
