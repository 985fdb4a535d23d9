"""Every test here renders with the default variant."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.arrays import Float, Mask
from loomlight.mitsuba import choose_variant
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Run


@pytest.fixture(autouse=True, scope="session")
def _variant() -> None:
    choose_variant("llvm_ad_rgb")


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """A run whose trainings go into a folder of its own."""
    return Run(runs=tmp_path)


@pytest.fixture
def height_field_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Rays are shaded where they end, as on a mesh of the height field, not on the tubes of yarns."""
    surface = YarnGeometry.surface

    def of_field(self: YarnGeometry, x: Float, y: Float, back: Mask, ray: object = None) -> SurfacePoint:
        return surface(self, x, y, back)

    monkeypatch.setattr(YarnGeometry, "surface", of_field)
