"""Plots of curves, drawn by Matplotlib."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from studies.harness.study import Pixels


@dataclass(frozen=True)
class Curve:
    """Points of one line, and what stands beside each."""

    x: Sequence[float]
    y: Sequence[float]
    texts: Sequence[str] = ()


def curves_plot(title: str, x_label: str, y_label: str, curves: Mapping[str, Curve]) -> Pixels:
    """Curves by their names in a plot with logarithmic axes, sRGB [height, width, 3]."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.ticker import ScalarFormatter

    figure = Figure(figsize=(9, 5.4), dpi=100, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots()
    for name, curve in curves.items():
        axes.loglog(curve.x, curve.y, "o-", label=name)
        for x, y, text in zip(curve.x, curve.y, curve.texts, strict=bool(curve.texts)):
            axes.annotate(text, (x, y), xytext=(5, 5), textcoords="offset points", fontsize=8)
    axes.set(title=title, xlabel=x_label, ylabel=y_label)
    for axis in (axes.xaxis, axes.yaxis):
        for formatter in (axis.set_major_formatter, axis.set_minor_formatter):
            plain = ScalarFormatter()
            plain.set_scientific(False)
            formatter(plain)
    axes.grid(True, which="both", alpha=0.25)
    axes.legend()
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
