"""Every command and Python text of the pages works as it stands, beside a fresh copy of the examples."""

from __future__ import annotations

import glob
import re
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
import typer

from loomlight.capturing.photographer import Light, photograph, straight
from loomlight.cli.main import app, run
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import MODELS
from studies.instruments import towel
from tests.capturing.pictures import save

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
# Of research, the pages of models have commands too.
WITH_COMMANDS = [*PAGES, *sorted((ROOT / "docs/research/models").glob("*.md"))]
# What never ends, takes hours or needs other machines: its words are checked, and that its files exist.
NOT_RUN = {
    r"loomlight render .*'frames/": "frames of a simulation take minutes",
    r"loomlight export .*-o (denim-u3m|coat-u3m|denim-addon)": "fits that tests of exporters make too",
    r"loomlight render .*--mesh (shirt\.usd|garments/)": "garments that a package has, and a script writes",
    r"loomlight view(?!.*--export)": "a server runs until it is stopped",
    r"loomlight play(?!.* -o )": "a window waits for its user",
    r"loomlight play .* -o ": "software adapters take minutes",
    r"loomlight compare .*--measured": "a file of others that is not ours to give",
    r"loomlight compare .*neumip": "six models are baked or trained, and rendered, for minutes",
    r"loomlight bake .*(jersey|corduroy|leather|brushed-metal|glazed-ceramic|library|u3ma)": "minutes each",
    r"loomlight render (jersey|corduroy|leather|metal|ceramic|library).loom": "nothing baked it",
    r"loomlight bake .*--executor (slurm|joblib:ray|joblib:dask)": "it needs a cluster",
}
PYTHON_NOT_RUN = {
    r"loomlight render .*'frames/": "frames of a simulation take minutes",
    "shirt.usd": "a package has it",
    "rendercanvas": "a window waits for its user",
    "Renderer(": "software adapters take minutes",
}


def shell_lines(text: str) -> Iterator[str]:
    """The commands of a page, continued lines joined, remarks left out."""
    joined = re.sub(r" \\\n\s+", " ", text)
    for line in re.findall(r"^(?:    |\t)?((?:loomlight|python -m) .*)$", joined, re.MULTILINE):
        yield re.sub(r"(\s{2,}#?|\s#).*$", "", line).strip()


def commands(page: Path) -> list[str]:
    """The `loomlight` commands of a page; one with a word in capitals is a form, not a command."""
    lines = shell_lines(page.read_text(encoding="utf-8"))
    return [line for line in lines if line.startswith("loomlight ") and not re.search(r"\s[A-Z]{4,}\b", line)]


def python_texts(page: Path) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def arguments_of(command: str) -> list[str]:
    """The words of a command after its name, as a shell that expands `*` hands them over."""
    words: list[str] = []
    quoted = re.findall(r"'([^']*)'", command)
    for word in shlex.split(command)[1:]:
        words += sorted(glob.glob(word)) if "*" in word and word not in quoted else [word]
    return words


def smaller(arguments: list[str]) -> list[str]:
    """The same words with an eighth of the texels each way, where an option counts them, and short turns."""
    found = list(arguments)
    for place, word in enumerate(arguments[1:], 1):
        if arguments[place - 1] in ("--resolution", "--pixels-per-mm", "--dpi"):
            found[place] = re.sub(r"\d+", lambda count: str(max(1, int(count[0]) // 8)), word)
        if arguments[place - 1] == "--turntable":
            found[place] = "3"
    return found


def require_words(arguments: list[str]) -> None:
    """Raises unless the command line takes these words; nothing is run."""
    command, context = typer.main.get_command(app), None
    while hasattr(command, "resolve_command"):
        context = command.make_context("loomlight", arguments, parent=context)
        _, command, arguments = command.resolve_command(context, [*context._protected_args, *context.args])
    command.make_context("loomlight", arguments, parent=context)


# Fabrics that `examples/*.toml` stands for: one that is drawn, one that is seen through.
FABRICS = ("linen", "organza")


@pytest.fixture
def clone(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, less_work: None) -> Path:
    """A folder with what a fresh clone has beside the code, of fabrics what the page names and two more."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples", ignore=shutil.ignore_patterns("*.py"))
    text = page.read_text(encoding="utf-8")
    for file in (tmp_path / "examples").glob("*.toml"):
        if file.stem not in FABRICS and file.name not in text:
            file.unlink()
    monkeypatch.chdir(tmp_path)
    if "frames/*.obj" in text:
        towel.write(tmp_path / "frames", 48)
    if "capture photo.jpg" in text:
        cloth = fabric_from_text('weave = "twill 2/1"\nends_per_cm = 13\npicks_per_cm = 12\n')
        seen = photograph(cloth, straight((300, 300), 20.0), Light(), 4)
        save(tmp_path / "photo.jpg", linear_to_srgb(seen), quality=95)
    return tmp_path


@pytest.mark.slow
@pytest.mark.parametrize("page", WITH_COMMANDS, ids=lambda page: page.stem)
def test_every_command_works(page: Path, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for command in commands(page):
        arguments = arguments_of(command)
        if any(re.search(pattern, command) for pattern in NOT_RUN):
            require_words(arguments)
        else:
            assert run(smaller(arguments)) == 0, f"{command}\n{capsys.readouterr().err}"


@pytest.mark.slow
@pytest.mark.parametrize("page", WITH_COMMANDS, ids=lambda page: page.stem)
def test_every_python_text_works(page: Path, clone: Path) -> None:
    names: dict[str, object] = {}
    for text in python_texts(page):
        compile(text, page.name, "exec")
        if not any(word in text for word in PYTHON_NOT_RUN):
            exec(text, names)


def test_words_of_commands_are_checked() -> None:
    require_words(["render", "plain", "-o", "a.png", "--spp", "4"])
    for wrong in (["rendr", "plain"], ["render", "plain", "--ssp", "4"], ["weave", "shows"]):
        with pytest.raises(Exception, match=r"rendr|ssp|shows"):
            require_words(wrong)


def test_commands_are_found_in_pages() -> None:
    assert sum(len(commands(page)) for page in WITH_COMMANDS) > 40


def test_the_one_table_of_models_lists_the_registry() -> None:
    table = (ROOT / "docs" / "models.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| \[?`(\w+)`\]?\S* \| `(\w+)` \|", table, re.MULTILINE)
    assert dict(rows) == {name: entry.plugin for name, entry in MODELS.items()}
