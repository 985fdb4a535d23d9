"""The sheen's closed form, as it ships and as it is fitted, against the published tables."""

from __future__ import annotations

import os
from pathlib import Path

import drjit.llvm.ad as jit
import numpy as np
import pytest

from loomlight.scattering import sheen_coefficients
from loomlight.scattering.sheen import sheen_lobe
from tools.fits import sheen as fit


def published() -> np.ndarray:
    """(a, b, R) by [cos θ_view, roughness]."""
    folder = os.environ.get("LOOMLIGHT_DATA")
    if folder is None:
        pytest.skip("LOOMLIGHT_DATA does not name the folder with the published sheen tables")
    table = np.load(Path(folder) / "validation/ltc_table_sheen_volume.npy")
    reflectance = np.load(Path(folder) / "validation/reflectance_sheen_volume.npy")
    np.testing.assert_array_equal(table[..., 2], reflectance)
    return table


def at_nodes() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    axis = np.linspace(0, 1, 32)
    cos_view, roughness = (grid.ravel().astype(np.float32) for grid in np.meshgrid(axis, axis, indexing="ij"))
    return tuple(v.numpy().reshape(32, 32) for v in sheen_lobe(jit.Float(cos_view), jit.Float(roughness)))


def test_table_rows_are_cosines() -> None:
    """A lobe seen from straight above has no azimuth, so b must vanish in the row of cos θ = 1."""
    table = published()
    assert np.abs(table[31, :, 1]).max() < 0.005
    # So does it for isotropic flakes, in the last column; but those return most at grazing angles.
    assert np.all(np.diff(table[1:, 31, 2]) < 0)


def test_reflectance_is_the_published_one() -> None:
    error = np.abs(at_nodes()[2] - published()[..., 2])
    # The bar is 0.01, at every entry; the fit says 0.005.
    assert error.max() < 0.006
    assert error.mean() < 0.002


def test_reflectance_between_entries_is_the_published_one() -> None:
    """Bilinear reading, as published, at the centres of the cells in which it describes a smooth function.

    It does not in the first row of cells, whose lower entries were computed at cos θ = 0.01 and are read at
    0, nor where cosine and roughness are both below 4/31 and R rises by up to 0.3 within a cell.
    """
    reflectance = published()[..., 2]
    corners = np.stack([reflectance[i : i + 31, j : j + 31] for i in (0, 1) for j in (0, 1)])
    centre = ((np.arange(31) + 0.5) / 31).astype(np.float32)
    cos_view, roughness = (grid.ravel() for grid in np.meshgrid(centre, centre, indexing="ij"))
    mine = sheen_lobe(jit.Float(cos_view), jit.Float(roughness))[2].numpy().reshape(31, 31)
    regular = np.ones((31, 31), dtype=bool)
    regular[0] = regular[:4, :4] = False
    assert np.abs(mine - corners.mean(0))[regular].max() < 0.01


def test_lobe_is_close_to_the_published_one() -> None:
    table = published()
    a, b, reflectance = at_nodes()
    # Squeezed towards the horizon, where lobes of small a have their peak.
    z, azimuth = np.meshgrid(
        ((np.arange(96) + 0.5) / 96) ** 2, (np.arange(64) + 0.5) * np.pi / 64, indexing="ij"
    )
    solid_angle = 2 * np.sqrt(z) / 96 * 2 * np.pi / 64
    x, y = np.sqrt(1 - z**2) * np.cos(azimuth), np.sqrt(1 - z**2) * np.sin(azimuth)

    def lobe(scale: float, shear: float) -> np.ndarray:
        return scale**2 * z / np.pi / ((scale * x + shear * z) ** 2 + (scale * y) ** 2 + z**2) ** 2

    errors = []
    for i, j in np.argwhere(table[..., 0] > 0):
        theirs = table[i, j, 2] * lobe(*table[i, j, :2])
        errors.append(np.sum(np.abs(reflectance[i, j] * lobe(a[i, j], b[i, j]) - theirs) * solid_angle))
    # Of all incident light; what tools/fits/sheen.py reports, a little rounded up.
    assert np.mean(errors) < 0.003
    assert np.max(errors) < 0.03


def test_the_fit_evaluates_what_the_model_does() -> None:
    cos_view, roughness = (grid.ravel() for grid in fit.nodes())
    coefficients = {name: np.asarray(getattr(sheen_coefficients, name)) for name in fit.DEGREES}
    lobe = sheen_lobe(jit.Float(cos_view.astype(np.float32)), jit.Float(roughness.astype(np.float32)))
    for mine, theirs in zip(fit.evaluate(coefficients, cos_view, roughness), lobe, strict=True):
        # float32 sums of 36 terms of up to 50.
        np.testing.assert_allclose(mine, theirs.numpy(), atol=2e-5)


def test_a_polynomial_is_found_again() -> None:
    """Of tables that are such a polynomial, the fit returns its coefficients but for the small ridge."""
    cos_view, roughness = (grid.ravel() for grid in fit.nodes())
    terms = fit.basis(cos_view, roughness, (2, 2))
    target = terms @ np.linspace(-1, 1, 9)
    actual = fit.fit_linear(terms, target, np.ones(len(target)))
    np.testing.assert_allclose(terms @ actual, target, atol=1e-4)
