"""Figure 8: mixed latents are, at the ends, those that they are mixed of."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.evaluation.reproduce import Setting, latents
from loomlight.mitsuba import choose_variant

from ...models.woven.networks import network, written


def test_mixed_latents_are_the_encoded_ones_at_both_ends(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    choose_variant()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(latents, "_VALUES", (0.2, 0.8))
    monkeypatch.setattr(latents, "_PARAMETERS", latents._PARAMETERS[:1])
    steps: list[tuple[int, int]] = []
    setting = Setting(
        size=(24, 16),
        samples=4,
        weights=written(network("field", hidden=16), tmp_path / "narrow.safetensors"),
        progress=lambda done, total: steps.append((done, total)),
    )
    found = latents.interpolated(setting)
    tables = {table.title: table.rows["roughness"] for table in found.tables}
    # Half-precision latents are mixed once more.
    assert tables["FLIP of mixed against encoded"] == pytest.approx([0, 0], abs=2e-3)
    assert min(tables["FLIP of encoded against reference"]) > 0.01
    # The network has random weights, so that only the reference knows roughness.
    assert tables["FLIP between 0.2 and 0.8"][0] > 0.01
    assert set(found.pictures) == {
        f"roughness-{value}-{kind}" for value in ("0.2", "0.8") for kind in ("reference", "encoded", "mixed")
    }
    assert np.asarray(found.sheet).ndim == 3
    assert steps == [(1, 1)]
