"""Options, keywords and tables of pages follow from the declarations of settings.

Covers: core/picture_settings.py, cli/options.py
"""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any, get_type_hints

import pytest
import typer
from typer.testing import CliRunner

from loomlight.cli.main import app
from loomlight.cli.options import Given, options_of_settings, takes
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import (
    GarmentKeywords,
    GarmentSettings,
    MapKeywords,
    MapSettings,
    Placement,
    PlayKeywords,
    PlaySettings,
    RenderKeywords,
    RenderSettings,
    SwatchKeywords,
    SwatchSettings,
    Worn,
)
from loomlight.core.settings import Settings, declared, default_text
from loomlight.mesh.edges import EDGES
from loomlight.mitsuba.camera import MAX_ZOOM
from loomlight.mitsuba.lights import LIGHTS
from loomlight.mitsuba.variants import SUPPORTED_VARIANTS

ROOT = Path(__file__).parents[2]
COMMANDS: dict[str, tuple[type[Settings], Any]] = {
    "render": (RenderSettings, RenderKeywords),
    "swatches": (SwatchSettings, SwatchKeywords),
    "play": (PlaySettings, PlayKeywords),
    "bake-maps": (MapSettings, MapKeywords),
    "export": (GarmentSettings, GarmentKeywords),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_keywords_are_the_fields_and_their_types(command: str) -> None:
    settings, keywords = COMMANDS[command]
    fields = get_type_hints(settings)
    names = [each.name for each in dataclasses.fields(settings)]  # type: ignore[arg-type]  # a dataclass
    expected = {name: fields[name] for name in names if (command, name) != ("render", "scene")}
    assert get_type_hints(keywords) == expected


@pytest.mark.parametrize("command", COMMANDS)
def test_every_setting_is_an_option_with_its_sentence_and_default(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    shown = CliRunner().invoke(app, [command, "--help"]).output
    text = " ".join(shown.split())
    for option in options_of_settings(COMMANDS[command][0]):
        assert option.flag.split("/")[0] in text
        assert " ".join(option.setting.help.split()) in text
        assert default_text(option.setting, "[default: {}]") in text


def test_what_is_given_is_handed_over_and_nothing_else() -> None:
    found: list[tuple[str, Given, bool]] = []
    small = typer.Typer()

    @small.command()
    @takes(RenderSettings)
    def render(fabric: str, given: Given, fast: bool = False) -> None:
        found.append((fabric, given, fast))

    words = [
        "plain",
        "--size",
        "12x8",
        "--light-from",
        "20,30",
        "--no-inset",
        "--scale",
        "2",
        "--shift",
        "1,-2",
    ]
    words += ["--color", "warp=#ff0000,weft=2 #111111, 3 #222222", "--mesh", "a.obj"]
    words += ["--cloth", "hem=satin,sleeve=plain,turn=45", "--cloth", "turn=twill"]
    result = CliRunner().invoke(small, [*words, "--fast"])
    assert result.exception is None
    expected: Given = {
        "mesh": Path("a.obj"),
        "size": (12, 8),
        "light_from": (20.0, 30.0),
        "inset": False,
        "colors": {"warp": "#ff0000", "weft": "2 #111111, 3 #222222"},
        "cloths": {"hem": "satin", "sleeve": Worn("plain", 45.0), "turn": "twill"},
        "placement": Placement(scale=2.0, shift=(1.0, -2.0)),
    }
    assert found == [("plain", expected, True)]
    assert RenderSettings(**expected).spp == RenderSettings().spp


def test_choices_are_those_of_the_code() -> None:
    settings = declared(RenderSettings)
    assert settings["light"].choices == LIGHTS
    assert settings["edge"].choices == EDGES
    assert settings["variant"].choices == SUPPORTED_VARIANTS
    assert settings["zoom"].high == MAX_ZOOM


def test_values_are_completed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("_LOOMLIGHT_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", "loomlight render plain --edge p")
    monkeypatch.setenv("COMP_CWORD", "4")
    shown = CliRunner().invoke(app, [], prog_name="loomlight")
    assert shown.output.split() == ["pinked"]


@pytest.mark.parametrize("turn", ["north", "1,2", "inf"])
def test_a_turn_of_a_cloth_is_a_number(turn: str) -> None:
    @takes(RenderSettings)
    def small(given: Given) -> None: ...

    app = typer.Typer()
    app.command()(small)
    result = CliRunner().invoke(app, ["--cloth", f"hem=satin,turn={turn}"])
    assert isinstance(result.exception, InputError)
    assert "--cloth" in str(result.exception)
