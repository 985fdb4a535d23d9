"""The analytic library: its range, its energy, and that its files are MERL's.

Covers: studies/papers/zeltner2024/analytic_brdfs.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.sources.merl import load_merl
from studies.papers.zeltner2024.analytic_brdfs import (
    analytic_brdf,
    analytic_library,
    analytic_parameters,
    write_analytic_library,
)


def test_parameters_cover_the_range_and_names_say_what_they_are() -> None:
    chosen = analytic_parameters(100)
    alphas = [each.alpha for each in chosen]
    assert min(alphas) < 0.035
    assert max(alphas) > 0.95
    assert len({each.name for each in chosen}) == 100
    assert all(each.name.startswith("analytic-") for each in chosen)


def test_no_brdf_reflects_more_than_arrives() -> None:
    rng = np.random.default_rng(3)
    u, azimuth = rng.random(20000), 2 * np.pi * rng.random(20000)
    light = np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], 1)
    view = np.tile([0.6, 0.0, 0.8], (len(light), 1))
    for each in analytic_parameters(12):
        if each.alpha > 0.2:
            # Cosine-distributed lights: the mean of π f is the albedo. A plastic's sum of both lobes may
            # exceed 1 by its Fresnel term, as nothing is taken from the diffuse one.
            albedo = np.pi * analytic_brdf(each, light.astype(np.float32), view.astype(np.float32)).mean(0)
            assert albedo.max() < 1.1


@pytest.mark.slow
def test_files_are_those_of_the_library(tmp_path: Path) -> None:
    write_analytic_library(tmp_path, 2)
    read, made = load_merl(tmp_path), analytic_library(2)
    assert read.names == made.names
    assert read.values is not None
    assert made.values is not None
    np.testing.assert_allclose(read.values, made.values, rtol=2e-3, atol=1e-6)
