"""Writes the tables of settings and of models' options into the pages, from where they are declared.

`python -m tools.generate.settings` writes them; a test fails where that is due. A header finds its table.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

from loomlight.cli.options import options_of_settings
from loomlight.core.picture_settings import (
    GarmentSettings,
    MapSettings,
    PlaySettings,
    RenderSettings,
    SwatchSettings,
)
from loomlight.core.settings import Setting, Settings, declared, default_text, range_text
from loomlight.models.registry import MODELS, model_class

ROOT = Path(__file__).resolve().parents[2]
Rows = Iterator[list[str]]


def settings_rows(settings: type[Settings]) -> Rows:
    """Option, keyword, range, default and meaning of each setting."""
    for option in options_of_settings(settings):
        flags = ", ".join(f"`{flag}`" for flag in option.flag.split("/"))
        yield [flags, f"`{'.'.join(option.path)}`", *_facts(option.setting), option.setting.help]


def option_rows() -> Rows:
    """BSDF, option, meaning, range and default of each option of all models."""
    for name, entry in MODELS.items():
        for option, each in declared(model_class(name).options_class).items():
            yield [f"`{entry.plugin}`", f"`{option}`", each.help, *_facts(each)]


# Pages, and the headers of their tables with what makes the rows.
TABLES: dict[str, dict[str, Callable[[], Rows]]] = {
    "docs/rendering.md": {
        "| option of `render` |": lambda: settings_rows(RenderSettings),
        "| option of `swatches` |": lambda: settings_rows(SwatchSettings),
    },
    "docs/maps.md": {"| option of `bake-maps` |": lambda: settings_rows(MapSettings)},
    "docs/realtime.md": {"| option of `play` |": lambda: settings_rows(PlaySettings)},
    "docs/engines.md": {"| option of `export` |": lambda: settings_rows(GarmentSettings)},
    "docs/mitsuba-parameters.md": {"| BSDF | option |": option_rows},
}


def with_tables(page: str, text: str) -> str:
    """The text of a page with its tables as they should be."""
    for header, rows in TABLES[page].items():
        found = re.search(rf"^{re.escape(header)}.*\n\|[-| ]+\n((?:\|.*\n)*)", text, re.MULTILINE)
        if found is None:
            raise ValueError(f"{page} has no table that begins with {header}")
        lines = "".join(f"| {' | '.join(row)} |\n" for row in rows())
        text = text[: found.start(1)] + lines + text[found.end(1) :]
    return text


def main() -> None:
    for page in TABLES:
        path = ROOT / page
        path.write_text(with_tables(page, path.read_text(encoding="utf-8")), encoding="utf-8")


def _facts(each: Setting) -> tuple[str, str]:
    return range_text(each), default_text(each)


if __name__ == "__main__":
    main()
