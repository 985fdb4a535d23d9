"""Height field files of the five materials are read back as what was written, and repeat.

Covers: studies/papers/kuznetsov2021/materials.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from examples.makers.heightfields import main
from loomlight.sources.heightfield import load_heightfield
from studies.papers.kuznetsov2021.materials import RECIPES, paper_heightfield


def test_files_hold_the_materials(tmp_path: Path) -> None:
    main(tmp_path, 32)
    for name in RECIPES:
        stem = name.replace(" ", "-")
        made, kept = load_heightfield(tmp_path / stem / f"{stem}.toml"), paper_heightfield(name, 32)
        assert (made.name, made.size_mm, made.height_mm) == (name, kept.size_mm, kept.height_mm)
        # Half a step of 16 and of 8 bits; sRGB's steepest slope is 12.92.
        np.testing.assert_allclose(made.height, kept.height, atol=0.6 / 65535)
        np.testing.assert_allclose(made.albedo, kept.albedo, atol=0.01)
        np.testing.assert_allclose(
            made.roughness, np.broadcast_to(kept.roughness, made.roughness.shape), atol=0.6 / 255
        )


@pytest.mark.parametrize("name", list(RECIPES))
def test_maps_use_their_range_and_repeat(name: str) -> None:
    source = paper_heightfield(name, 64)
    assert (source.height.min(), source.height.max()) == (0, 1)
    assert source.albedo.min() >= 0
    assert source.albedo.max() <= 1
    for axis in (0, 1):
        steps = np.abs(np.diff(source.height, axis=axis, append=source.height.take([0], axis)))
        seam = np.take(steps, -1, axis).mean()
        # No seam: the step across the sides is like the steps within; walls of rock and foam make it vary.
        assert seam < 4 * steps.mean()
