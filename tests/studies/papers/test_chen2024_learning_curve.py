"""The study of the learning curve finds a law that is there, and refuses what it cannot fit.

Covers: studies/papers/chen2024/learning_curve.py
"""

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from studies.harness.study import Run
from studies.papers.chen2024.learning_curve import STUDY, CurveSettings, extrapolated, power_law
from studies.papers.chen2024.training.curve import CurvePoint

STEPS = [round(10 * 1.1**k) for k in range(80)]


def _law(noise: float, seed: int = 0) -> list[CurvePoint]:
    """2 · step^−0.2 times noise."""
    rng = np.random.default_rng(seed)
    return [CurvePoint(step, 1.0, 2 * step**-0.2 * float(np.exp(noise * rng.normal()))) for step in STEPS]


def test_a_law_is_found() -> None:
    fit = power_law(_law(0.0), 3_125_000)
    assert fit["exponent"] == pytest.approx(0.2)
    assert fit["nmae"] == pytest.approx(2 * 3_125_000**-0.2)
    assert fit["low"] == pytest.approx(fit["high"])


def test_the_interval_holds_what_it_says() -> None:
    """95 % of new points: of 400 curves 380 are expected, with a standard deviation of 4.4."""
    held = 0
    for seed in range(400):
        fit = power_law(_law(0.05, seed), 100_000)
        new = 2 * 100_000**-0.2 * float(np.exp(0.05 * np.random.default_rng([seed, 1]).normal()))
        held += fit["low"] < new < fit["high"]
    assert 380 - 5 * 4.4 < held < 380 + 4 * 4.4


def test_the_study_reads_the_curve_of_a_folder(tmp_path: Path) -> None:
    run, settings = Run(runs=tmp_path), CurveSettings(training="a", steps=10**6)
    with pytest.raises(InputError, match=r"make the training with python -m studies\.papers"):
        extrapolated(settings, run)
    (tmp_path / "a").mkdir()
    rows = "".join(f"{point.step},{point.loss},{point.nmae}\n" for point in _law(0.01))
    (tmp_path / "a" / "curve.csv").write_text("step,loss,nmae\n" + rows)
    figures = extrapolated(settings, run).figures
    assert figures["steps_done"] == STEPS[-1]
    curve, fits = STUDY.tables(figures)
    assert len(fits.rows) == len(figures["fits"]) == 3
    assert curve.rows[f"{STEPS[-1]} steps"][1] == figures["curve"][-1][2]
    for fit in figures["fits"].values():
        # Rows are 1 % off, and the shortest fit has 13 of them: its end is 3 % off at four deviations.
        assert fit["nmae"] == pytest.approx(2 * 1e6**-0.2, rel=0.1)
    (tmp_path / "a" / "curve.csv").write_text("step,loss,nmae\n10,1.0,0.5\n")
    with pytest.raises(InputError, match="1 rows, too few"):
        extrapolated(settings, run)
