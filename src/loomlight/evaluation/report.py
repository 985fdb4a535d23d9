"""The page that `compare` writes: static, its own style and script inside, pictures in a folder beside it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from string import Template

from loomlight.evaluation.table import Cell, Table

# Tables whose smallest figure of a column is the best one.
_LOWER_IS_BETTER = ("FLIP", "MSE", "nMAE")


@dataclass(frozen=True)
class Figure:
    """A picture.

    Attributes:
        name: of its row.
        picture, flip: paths beside the page; the reference has no difference map.
        caption: its figures.
    """

    name: str
    picture: str
    flip: str | None
    caption: str


@dataclass(frozen=True)
class Section:
    """A scene: pictures shown side by side."""

    title: str
    subtitle: str
    figures: list[Figure]


@dataclass(frozen=True)
class Report:
    """The content of the page.

    Attributes:
        title: the fabric's name.
        facts: about the comparison, by label.
        refused: the reason, by the name of each model that does not take the fabric.
    """

    title: str
    facts: dict[str, str]
    refused: dict[str, str]
    tables: list[Table]
    sections: list[Section]


def report_html(report: Report) -> str:
    """The page's HTML; names are escaped."""
    here = files("loomlight.evaluation")
    page, style, script = (
        here.joinpath(f"report.{kind}").read_text(encoding="utf-8") for kind in ("html.in", "css", "js")
    )
    facts = "".join(
        f"<dt>{escape(label)}</dt><dd>{escape(text)}</dd>" for label, text in report.facts.items()
    )
    refused = "".join(
        f'<p class="refused"><b>{escape(name)}</b> does not take this fabric: {escape(why)}</p>'
        for name, why in report.refused.items()
    )
    first, *others = map(_table, report.tables)
    return Template(page).substitute(
        title=escape(report.title),
        style=style,
        script=script,
        facts=facts,
        refused=refused,
        first=first,
        sections="\n".join(map(_section, report.sections)),
        others="".join(f"{table}\n" for table in others),
    )


def _section(section: Section) -> str:
    figures = "\n".join(_figure(figure) for figure in section.figures)
    return (
        f"<h2>{escape(section.title)} <small>{escape(section.subtitle)}</small></h2>\n"
        f'<div class="row">\n{figures}\n</div>'
    )


def _figure(figure: Figure) -> str:
    flip = "" if figure.flip is None else f' data-flip="{figure.flip}" data-picture="{figure.picture}"'
    return (
        f'<figure><div class="view"><img src="{figure.picture}"{flip} alt="{escape(figure.name)}" '
        f'draggable="false"></div><figcaption><b>{escape(figure.name)}</b> '
        f"<span>{escape(figure.caption)}</span></figcaption></figure>"
    )


def _table(table: Table) -> str:
    headings = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    best = _best(table)
    lines = []
    for name, cells in table.rows.items():
        shown = "".join(
            f"<td{' class=best' if cell is not None and cell == low else ''}>{escape(table.shown(cell))}</td>"
            for cell, low in zip(cells, best, strict=True)
        )
        lines.append(f"<tr><th>{escape(name)}</th>{shown}</tr>")
    body = f"<thead><tr><th></th>{headings}</tr></thead><tbody>{''.join(lines)}</tbody>"
    return f'<h2>{escape(table.title)}</h2>\n<p class="note">{escape(table.note)}</p>\n' + (
        f'<div class="scroll"><table>{body}</table></div>' if table.rows else ""
    )


def _best(table: Table) -> list[Cell]:
    """The lowest number of each column, if low is better and there are at least two rows."""
    columns = list(zip(*table.rows.values(), strict=True))
    if not any(word in table.title for word in _LOWER_IS_BETTER) or len(table.rows) < 2:
        return [None] * len(columns)
    best: list[Cell] = []
    for cells in columns:
        numbers = [cell for cell in cells if isinstance(cell, float) and math.isfinite(cell) and cell >= 0]
        best.append(min(numbers) if len(numbers) == len(cells) else None)
    return best
