"""Where results go is checked before the work begins."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.cli.terminal import done
from loomlight.core.errors import InputError
from loomlight.core.outputs import check_output


def test_a_file_that_can_be_written_passes(tmp_path: Path) -> None:
    check_output(tmp_path / "picture.PNG", (".exr", ".png"))
    (tmp_path / "there.png").touch()
    check_output(tmp_path / "there.png", (".png",))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["there.png"]


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("picture", "must end in .exr or .png"),
        ("picture.jpg", "must end in .exr or .png"),
        ("folder.png", "is a folder"),
        ("none/picture.png", "does not exist"),
        ("x" * 5000 + ".png", "no path of a file"),
    ],
)
def test_what_cannot_be_written_is_refused(tmp_path: Path, name: str, says: str) -> None:
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(InputError, match=says) as caught:
        check_output(tmp_path / name, (".exr", ".png"))
    assert "\n" not in str(caught.value)


def test_what_was_written_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    done(Path("a.png"))
    assert capsys.readouterr().out == "a.png\n"
