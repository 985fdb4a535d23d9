"""Every picture of the pages has a recipe, and one that shows what changed is called older."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from tools.generate.pictures import IMAGES, RECIPES, ROOT, TOLERANCE, ages, difference, words_of

PAGES = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]


def test_pictures_recipes_and_pages_are_the_same() -> None:
    shown = {name for page in PAGES for name in re.findall(r"images/([\w.-]+)\)", page.read_text("utf-8"))}
    kept = {file.name for file in IMAGES.iterdir() if file.suffix != ".json"}
    assert shown == kept == set(RECIPES)


@pytest.mark.parametrize("name", RECIPES)
def test_recipes_name_what_is_there(name: str) -> None:
    for command in RECIPES[name].commands:
        words = words_of(command, "/nowhere")
        if words[1] == "-m" and words[2] != "loomlight":
            module = ROOT / words[2].replace(".", "/")
            assert module.with_suffix(".py").is_file() or (module / "__main__.py").is_file()
        for word in shlex.split(command):
            if word.startswith("examples/") and "*" not in word:
                assert (ROOT / word).is_file()


def test_a_picture_is_older_where_what_it_shows_has_changed() -> None:
    sources = {"sources": [5.0]}
    probes = {"renders": {"denim drape": [1.0, 2.0]}, "shaders": sources, "page": sources}
    made = {name: {"stands on": {probe: probes[probe] for probe in RECIPES[name].shows}} for name in RECIPES}
    assert set(ages(made, probes).values()) == {"as shown today"}
    little = {**probes, "renders": {"denim drape": [1.0, 2.0 + TOLERANCE]}}  # of a mean of 1.5
    assert ages(made, little)["demo.jpg"] == "as shown today"
    much = {**probes, "renders": {"denim drape": [1.0, 2.0 + 2 * TOLERANCE]}, "page": {"sources": [6.0]}}
    said = ages(made, much)
    assert said["demo.jpg"] == "older: denim drape changed by 4 %"
    assert said["editor.png"] == "older: sources changed"
    assert said["realtime.png"] == "as shown today"
    assert ages({}, probes)["demo.jpg"].startswith("not known")


def test_a_probe_of_another_shape_differs_wholly() -> None:
    assert difference({"a": [1.0]}, {"a": [1.0, 2.0]}) == ("a", float("inf"))


def test_recipes_run_from_the_checkout(tmp_path: Path) -> None:
    assert words_of("loomlight swatches examples/*.toml -o {out}/a.png", str(tmp_path))[3:5] == [
        "swatches",
        "examples/chino.toml",
    ]
