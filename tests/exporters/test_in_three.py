"""Exports in three.js, by its own loaders in a browser: sizes, colours and the way that twills lean.

Covers: exporters/garment_gltf.py, exporters/usd.py
Covers: exporters/engines.py
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.colour import srgb_to_linear
from loomlight.exporters import engines, export, garment_gltf, usd
from loomlight.exporters.fit import FittedMaterial
from studies.instruments.engine_page import EnginePage, engine_page, missing
from tests.helpers.standard_materials import plain_material
from tests.limits import HANG

# A browser that computes light without a card.
pytestmark = pytest.mark.slow
# Textures show 25 × 25 mm in four columns and rows, of which these are light: a quarter above the diagonal.
SIZE = 25.0
LIGHT, DARK = np.array([0.5, 0.4, 0.3]), np.array([0.1, 0.1, 0.1])
# Of 255: 8 bits, and light that three.js filters and takes below gloss.
CLOSE = 0.03


def stepped(fabric: Any = None, model: Any = None, *more: Any) -> FittedMaterial:
    """Light in the left half of the upper half, dark elsewhere; matt."""
    base = np.tile(DARK, (4, 4, 1))
    base[2:, :2] = LIGHT
    return plain_material(
        (SIZE, SIZE), (4, 4), base=base, transmission=0.0, weight=0.0, alpha_x=1.0, alpha_y=1.0
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Exports of a square of 100 mm, whose left half has mirrored uv."""
    made = tmp_path_factory.mktemp("three")
    corners = [(x, y) for x in (-0.05, 0.0, 0.05) for y in (-0.05, 0.05)]
    lines = [f"v {x} {y} 0" for x, y in corners]
    lines += [f"vt {abs(x) / 0.1} {y / 0.1 + 0.5}" for x, y in corners]
    lines += ["o left", "f 1/1 3/3 4/4 2/2", "o right", "f 3/3 5/5 6/6 4/4"]
    mesh = made / "square.obj"
    mesh.write_text("\n".join(lines) + "\n")
    with pytest.MonkeyPatch.context() as patch:
        for module in (garment_gltf, usd):
            patch.setattr(module, "fitted", stepped)
        patch.setattr(engines, "fit_material", stepped)
        patch.setattr(engines, "make_model", lambda model, fabric: None)
        export("plain", "gltf", made / "gltf", mesh=mesh)
        export("plain", "usdz", made / "square.usdz", mesh=mesh)
        export("plain", "threejs", made / "pack")
    return made


@pytest.fixture(scope="module")
def page(folder: Path) -> Iterator[EnginePage]:
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if missing():
        pytest.skip(missing())
    with engine_page(folder, HANG) as opened:
        yield opened


def quarters(picture: np.ndarray, row: int, column: int) -> np.ndarray:
    """Means of the quarters of a square of 25 mm, counted from the upper left one [2, 2, 3]."""
    part = picture[32 * row : 32 * (row + 1), 32 * column : 32 * (column + 1)]
    # Away from edges, which filters blur.
    return part.reshape(2, 16, 2, 16, 3)[:, 5:11, :, 5:11].mean(axis=(1, 3))


@pytest.mark.parametrize("file", ["gltf/cloth.glb", "square.usdz", "pack/material.js"])
def test_colours_sizes_and_directions_are_those_of_the_textures(page: EnginePage, file: str) -> None:
    """Four times 25 mm along the square; light in the upper left quarter of each."""
    names, picture = page.draw(file, half=0.05)
    if not file.endswith(".js"):
        assert set(names) == {"left", "right"}
    linear = srgb_to_linear(picture / 255)
    for row, column in ((0, 2), (3, 3), (1, 2)):
        found = quarters(linear, row, column)
        assert found[0, 0] == pytest.approx(LIGHT, abs=CLOSE)
        for other in (found[0, 1], found[1, 0], found[1, 1]):
            assert other == pytest.approx(DARK, abs=CLOSE)


@pytest.mark.parametrize("file", ["gltf/cloth.glb", "square.usdz"])
def test_mirrored_islands_are_turned_and_not_mirrored(page: EnginePage, file: str) -> None:
    """A half turn puts the light quarter to the lower right; a mirror would put it to the upper right."""
    _, picture = page.draw(file, half=0.05)
    for row, column in ((0, 0), (3, 1)):
        found = quarters(srgb_to_linear(picture / 255), row, column)
        assert found[1, 1] == pytest.approx(LIGHT, abs=CLOSE)
        assert found[0, 1] == pytest.approx(DARK, abs=CLOSE)
