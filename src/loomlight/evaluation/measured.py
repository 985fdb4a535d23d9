"""`compare --measured`: a fabric beside a measured BRDF: error and curves as a table, plots and a page."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.files import discarding_empty, replacing
from loomlight.core.provenance import provenance
from loomlight.evaluation.compare import prepared_folder
from loomlight.evaluation.isotropic import (
    CURVES,
    VIEWS,
    Angles,
    Floats,
    Pairs,
    mean_over_turns,
    rms,
    turned_value,
)
from loomlight.evaluation.report import Figure, Report, Section, report_html
from loomlight.evaluation.table import Table, write_json
from loomlight.fabric.fabric import Fabric
from loomlight.models.registry import btf_of
from loomlight.models.texture.queries import Btf
from loomlight.sources.kinds import kind_of_file
from loomlight.sources.load import load_source
from loomlight.sources.merl import MerlLibrary

PAIRS, TURNS = 4096, 12
_SCHEMA = 1
_EXPECTED = "give a MERL file (.binary) or one of RGL (.bsdf, with rgb)"
# Size of a plot, and margins around it, pixels.
_WIDTH, _HEIGHT, _LEFT, _BELOW, _ABOVE = 320, 240, 52, 34, 24
_COLOURS = ("#111", "#c0501c")
_TITLES = {"albedo": "albedo", "back": "f back to the light", "mirror": "f in the mirror's direction"}


@dataclass(frozen=True)
class MeasuredComparison:
    """A fabric beside a measured BRDF.

    Attributes:
        error: rms of ln(f·cos + 0.001) over pairs of light and view to 80°.
        curves: of "measured" and the fabric, by name: albedo 0 to 1, and f, 1/sr, back to the light and in
            the mirror's direction, a number a view.
        table: of both.
    """

    error: float
    curves: dict[str, dict[str, list[float]]]
    table: Table


def measured_btf(path: str | os.PathLike[str]) -> Btf:
    """What answers for the BRDF of a file.

    Raises:
        InputError: no such file, a damaged one, a folder, or one that holds no BRDF of all directions.
    """
    if Path(path).is_dir():
        raise InputError(f"{path} is a folder: {_EXPECTED}.")
    if kind_of_file(path, "fabric") not in ("merl", "material"):
        raise InputError(f"{path} is no measured BRDF: {_EXPECTED}.")
    source = load_source(path)
    if isinstance(source, MerlLibrary) and len(source.names) > 1:
        raise InputError(f"{path} holds {len(source.names)} BRDFs: {_EXPECTED}.")
    return btf_of(source, "latent")


def beside_measured(
    fabric: Fabric, btf: Btf, btf_name: str, *, pairs: int = PAIRS, turns: int = TURNS
) -> MeasuredComparison:
    """The error and the curves of a fabric beside a BRDF, both as means over turns about the normal.

    Args:
        btf_name: of the BRDF, for the table.
    """
    angles = Angles.drawn(pairs)

    def answered(all_turns: Pairs) -> Floats:
        light, view = (np.asarray(part, np.float32) for part in (all_turns.light, all_turns.view))
        points = np.zeros((len(light), 2), np.float32)
        return np.asarray(btf.values(points, light, view, (0,)), np.float64)

    measured = mean_over_turns(answered, angles.pairs, turns)
    own = turned_value(fabric, angles.pairs, turns)
    curves = {"measured": angles.curves(measured), fabric.name: angles.curves(own)}
    error = rms(own[:pairs], measured[:pairs])
    table = Table(
        f"Beside {btf_name}: rms error {error:.3f}",
        [f"{view:.0f}°" for view in VIEWS],
        note="Over the view's angle. The error is the rms of ln(f·cos + 0.001) over pairs to 80°.",
    )
    for name in CURVES:
        for label, of_label in curves.items():
            table.rows[f"{_TITLES[name]}, {label}"] = list(of_label[name])
    return MeasuredComparison(error, curves, table)


def compare_measured(
    fabric: Fabric,
    measured: str | os.PathLike[str],
    folder: str | os.PathLike[str],
    *,
    command: str = "loomlight.compare",
) -> MeasuredComparison:
    """Writes `folder`/index.html, table.json and pictures/curves.svg; the folder is made if it is missing.

    Raises:
        InputError: as `measured_btf`, or a folder that cannot be written.
    """
    btf = measured_btf(measured)
    with discarding_empty(folder):
        target = prepared_folder(folder)
        found = beside_measured(fabric, btf, Path(measured).name)
        with replacing(target / "pictures" / "curves.svg") as temporary:
            temporary.write_text(curves_svg(found.curves), encoding="utf-8")
        record = provenance(command, Path(__file__).parent)
        content = {
            "schema": _SCHEMA,
            "fabric": fabric.name,
            "fabric_file": fabric.to_toml(),
            "measured": Path(measured).name,
            **record,
            "views_deg": list(VIEWS),
            "rms": found.error,
            "curves": found.curves,
        }
        write_json(target / "table.json", content)
        facts = {
            "Measured": Path(measured).name,
            "Model": f"lobes, means over ten repeats and {TURNS} turns",
            "Made with": f"{record['command']}, sources {record['sources']}, {record['machine']}",
        }
        figure = Figure("curves over the view's angle", "pictures/curves.svg", None, "black: measured")
        report = Report(fabric.name, facts, {}, [found.table], [Section("Curves", "", [figure])])
        with replacing(target / "index.html") as temporary:
            temporary.write_text(report_html(report), encoding="utf-8")
    return found


# ------------------------------------------------------------------------------------------------------ plots


def curves_svg(curves: Mapping[str, Mapping[str, Sequence[float]]]) -> str:
    """Plots side by side as SVG; that of the mirror's direction is logarithmic."""
    plots = "".join(_plot(name, number * _WIDTH, curves) for number, name in enumerate(CURVES))
    legend = "".join(
        f'<text x="{_LEFT + 6 + 130 * number}" y="{_HEIGHT - 4}" fill="{colour}">{escape(label)}</text>'
        for number, (label, colour) in enumerate(zip(curves, _COLOURS, strict=True))
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH * len(CURVES)} {_HEIGHT}" '
        f'width="{_WIDTH * len(CURVES)}" height="{_HEIGHT}" font-family="sans-serif" font-size="11">'
        f'<rect width="100%" height="100%" fill="#fff"/>{plots}{legend}</svg>\n'
    )


def _plot(name: str, left: float, curves: Mapping[str, Mapping[str, Sequence[float]]]) -> str:
    """One plot: axes with the least and the largest number, and a line for each label."""
    is_logarithmic = name == "mirror"
    values = [max(each, 1e-6) for of_label in curves.values() for each in of_label[name]]
    low, high = (min(values), max(values)) if is_logarithmic else (0.0, max(values))
    scale = math.log if is_logarithmic else float
    span = max(scale(high) - scale(low), 1e-9)
    bottom, wide = _HEIGHT - _BELOW, _WIDTH - _LEFT - 12
    high_of = bottom - _ABOVE

    def place(angle: float, value: float) -> str:
        up = (scale(max(value, 1e-6 if is_logarithmic else 0.0)) - scale(low)) / span
        return f"{left + _LEFT + angle / VIEWS[-1] * wide:.1f},{bottom - up * high_of:.1f}"

    lines = "".join(
        f'<polyline fill="none" stroke="{colour}" stroke-width="2" points="'
        + " ".join(place(view, value) for view, value in zip(VIEWS, of_label[name], strict=True))
        + '"/>'
        for of_label, colour in zip(curves.values(), _COLOURS, strict=True)
    )
    title = _TITLES[name] + (", logarithmic" if is_logarithmic else "")
    x, right = left + _LEFT, left + _LEFT + wide
    return (
        f'<text x="{x}" y="15">{escape(title)}</text>'
        f'<path d="M{x} {_ABOVE}V{bottom}H{right}" fill="none" stroke="#999"/>{lines}'
        f'<text x="{x - 4}" y="{_ABOVE + 8}" text-anchor="end">{high:.3g}</text>'
        f'<text x="{x - 4}" y="{bottom}" text-anchor="end">{low:.3g}</text>'
        f'<text x="{x}" y="{bottom + 13}">0°</text>'
        f'<text x="{right}" y="{bottom + 13}" text-anchor="end">{VIEWS[-1]:.0f}°</text>'
    )
