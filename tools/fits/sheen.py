"""Fits the closed form of the sheen lobe to the published tables and writes its coefficients.

    LOOMLIGHT_DATA=<folder with validation/*.npy> python -m tools.fits.sheen [--check]

The tables are those of Zeltner, Burley and Chiang 2022, "Practical Multiple-Scattering Sheen Using Linearly
Transformed Cosines": `ltc_table_sheen_volume.npy` holds (a, b, R) and `reflectance_sheen_volume.npy` R.
Rows are cos θ_view and columns the sheen roughness, both from 0 to 1 in 32 steps, with 0.01 in the place of
0. (R is 0.75 in row 0 and 0.32 in row 31 at roughness 1: a layer of fibres returns most at grazing angles.)

`--check` writes nothing and prints the errors of the committed coefficients.
"""

from __future__ import annotations

import argparse

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from loomlight.scattering import sheen_coefficients
from studies.harness.study import REPOSITORY, outside_data

Array = NDArray[np.float64]

TARGET = REPOSITORY / "src/loomlight/scattering/sheen_coefficients.py"
# R never exceeds 0.75; the logistic's ceiling lies a little above.
CEILING = 0.8
DEGREES = {"REFLECTANCE": (4, 5), "SCALE": (5, 5), "SHEAR": (4, 5)}
# Keeps the coefficients where the tables say nothing (R ≈ 0) from growing.
RIDGE = 1e-5


def nodes() -> tuple[Array, Array]:
    """Cosine and roughness of every entry, [32, 32] each."""
    axis = np.maximum(np.linspace(0, 1, 32), 0.01)
    cos_view, roughness = np.meshgrid(axis, axis, indexing="ij")
    return cos_view, roughness


def basis(cos_view: Array, roughness: Array, degrees: tuple[int, int]) -> Array:
    """Products of powers of x = 2 cos^½ − 1 and y = 3 roughness^¼ − 2, [..., terms]; y varies fastest."""
    x = 2 * np.sqrt(cos_view) - 1
    y = 3 * roughness**0.25 - 2
    powers = [x**i * y**j for i in range(degrees[0] + 1) for j in range(degrees[1] + 1)]
    return np.stack(powers, -1)


def logistic(value: Array) -> Array:
    """1/(1 + e^−x)."""
    return 1 / (1 + np.exp(-np.clip(value, -60, 60)))


def fit_linear(terms: Array, target: Array, weight: Array) -> Array:
    """Weighted least squares with a small ridge."""
    rows = terms * weight[:, None]
    ridge = RIDGE * np.sqrt(np.mean(rows**2) * len(rows)) * np.eye(rows.shape[1])
    stacked = np.concatenate([rows, ridge])
    return np.linalg.lstsq(stacked, np.concatenate([weight * target, np.zeros(len(ridge))]), rcond=None)[0]


def fit_reflectance(terms: Array, target: Array) -> Array:
    """Coefficients whose logistic has the least maximum error: iteratively reweighted least squares."""
    scaled = np.clip(target / CEILING, 1e-5, 1)
    start = np.log(scaled / (1 - scaled))
    coefficients = fit_linear(terms, start, scaled + 0.01)
    weight = np.ones(len(target))
    best, smallest = coefficients, np.inf
    ridge = RIDGE * np.eye(terms.shape[1])
    for _ in range(20):

        def residual(c: Array, weight: Array = weight) -> Array:
            return np.concatenate([weight * (CEILING * logistic(terms @ c) - target), ridge @ c])

        def slope(c: Array, weight: Array = weight) -> Array:
            value = logistic(terms @ c)
            return np.concatenate([(weight * CEILING * value * (1 - value))[:, None] * terms, ridge])

        coefficients = least_squares(residual, coefficients, slope, max_nfev=60, x_scale="jac").x
        error = np.abs(CEILING * logistic(terms @ coefficients) - target)
        if error.max() < smallest:
            best, smallest = coefficients, error.max()
        weight *= 0.3 + error / error.max()
        weight /= weight.mean()
    return best


def filled(values: Array, known: NDArray[np.bool_]) -> Array:
    """Unknown entries take the value of the nearest known one of higher roughness.

    Where R < 3e-6 the published fit left a = b = 0; a polynomial without a target there would run away.
    """
    first_known = np.argmax(known, axis=1)[:, None]
    source = np.maximum(np.arange(values.shape[1]), first_known)
    return np.take_along_axis(values, source, axis=1)


def fit(table: Array) -> dict[str, Array]:
    """Coefficients of the three polynomials, each [degree of x + 1, degree of y + 1]."""
    cos_view, roughness = (axis.ravel() for axis in nodes())
    reflectance = table[..., 2].ravel()
    terms = {name: basis(cos_view, roughness, degrees) for name, degrees in DEGREES.items()}
    scale, shear = (filled(table[..., k], table[..., 0] > 0).ravel() for k in (0, 1))
    # What an error in a or b does to the picture is proportional to R; relative to a, since a scales the
    # lobe; b vanishes with the lobe's symmetry at normal incidence, so 1 − cos is taken out of it.
    weight = np.sqrt(reflectance + 1e-4)
    side = 1 - cos_view
    coefficients = {
        "REFLECTANCE": fit_reflectance(terms["REFLECTANCE"], reflectance),
        "SCALE": fit_linear(terms["SCALE"], scale, weight / scale),
        "SHEAR": fit_linear(terms["SHEAR"] * side[:, None], shear, weight),
    }
    return {name: value.reshape(np.add(DEGREES[name], 1)) for name, value in coefficients.items()}


def evaluate(coefficients: dict[str, Array], cos_view: Array, roughness: Array) -> tuple[Array, Array, Array]:
    """(a, b, R) of the closed form, in float64; the Dr.Jit version is `scattering.sheen.sheen_lobe`."""
    value = {
        name: basis(cos_view, roughness, DEGREES[name]) @ np.asarray(coefficients[name]).ravel()
        for name in DEGREES
    }
    return (
        np.clip(value["SCALE"], 0.01, 1),
        np.clip((1 - cos_view) * value["SHEAR"], -0.25, 0),
        CEILING * logistic(value["REFLECTANCE"]),
    )


def lobe(scale: Array, shear: Array, directions: Array) -> Array:
    """The linearly transformed cosine [n, directions], 1/sr, per unit R."""
    x, y, z = directions
    a, b = scale[:, None], shear[:, None]
    squared = (a * x + b * z) ** 2 + (a * y) ** 2 + z**2
    return a**2 * z / (np.pi * squared**2)


def lobe_errors(coefficients: dict[str, Array], table: Array) -> Array:
    """∫|lobe − published lobe| over the hemisphere at the nodes [32, 32], each with its own R."""
    # Midpoints in cos and azimuth; squeezed towards the horizon, where wide lobes have their peak.
    edge = ((np.arange(96) + 0.5) / 96) ** 2
    z, azimuth = np.meshgrid(edge, (np.arange(64) + 0.5) * np.pi / 64, indexing="ij")
    solid_angle = (2 * np.sqrt(z) / 96 * 2 * np.pi / 64).ravel()
    radius = np.sqrt(1 - z**2)
    directions = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z]).reshape(3, -1)
    cos_view, roughness = (axis.ravel() for axis in nodes())
    a, b, reflectance = evaluate(coefficients, cos_view, roughness)
    published = table.reshape(-1, 3)
    mine = reflectance[:, None] * lobe(a, b, directions)
    theirs = published[:, 2:] * lobe(np.maximum(published[:, 0], 1e-3), published[:, 1], directions)
    error = np.abs(mine - theirs) @ solid_angle
    return np.where(published[:, 0] > 0, error, reflectance).reshape(32, 32)


def report(coefficients: dict[str, Array], table: Array) -> str:
    """Errors of the closed form at the nodes and between them, as text."""
    cos_view, roughness = nodes()
    a, b, reflectance = evaluate(coefficients, cos_view, roughness)
    error = np.abs(reflectance - table[..., 2])
    known = table[..., 0] > 0
    strong = known & (table[..., 2] > 0.05)
    lobes = lobe_errors(coefficients, table)
    relative = np.abs(a / np.where(known, table[..., 0], 1) - 1)
    lines = [
        f"R: largest error {error.max():.4f}, mean {error.mean():.4f}, over all 1024 entries",
        f"a where R > 0.05: largest relative error {relative[strong].max():.3f}",
        f"b where R > 0.05: largest error {np.abs(b - table[..., 1])[strong].max():.3f}",
        f"lobe, integral of |difference|: mean {lobes.mean():.4f}, 99 % {np.quantile(lobes, 0.99):.4f}, "
        f"largest {lobes.max():.4f}",
    ]
    between = between_nodes(coefficients, table)
    corner, rest = between[1:4, :4].copy(), between.copy()
    rest[0] = rest[1:4, :4] = 0
    lines += [
        "R at the centres of cells against bilinear reading:",
        f"  first row (entries for 0.01 read at 0): largest error {between[0].max():.4f}",
        f"  cos and roughness < 4/31, where R rises by up to 0.3 a cell: largest error {corner.max():.4f}",
        f"  the other 918 of 961 cells: largest error {rest.max():.4f}",
    ]
    return "\n".join(lines)


def between_nodes(coefficients: dict[str, Array], table: Array) -> Array:
    """Error of R at the centres of the 31 × 31 cells against bilinear reading."""
    centre = (np.arange(31) + 0.5) / 31
    cos_view, roughness = np.meshgrid(centre, centre, indexing="ij")
    corners = np.stack([table[i : i + 31, j : j + 31, 2] for i in (0, 1) for j in (0, 1)])
    return np.abs(evaluate(coefficients, cos_view, roughness)[2] - corners.mean(0))


def source(coefficients: dict[str, Array]) -> str:
    """The Python module of the coefficients."""
    lines = [
        '"""Coefficients of the sheen lobe, written by `tools/fits/sheen.py`; see there for the data.',
        "",
        "Rows are powers of 2 cos^½ − 1, columns powers of 3 roughness^¼ − 2, both rising.",
        '"""',
        "",
        "# fmt: off",
        f"CEILING = {CEILING}",
    ]
    for name, rows in coefficients.items():
        lines += ["", f"{name} = ("]
        lines += ["    (" + ", ".join(f"{value:.7g}" for value in row) + ")," for row in rows]
        lines += [")"]
    return "\n".join([*lines, "# fmt: on", ""])


def main() -> None:
    """Fits and writes, or checks; prints the errors."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true", help="only print the errors of what is committed")
    arguments = parser.parse_args()
    table = np.load(outside_data("validation", "ltc_table_sheen_volume.npy"))
    if arguments.check:
        coefficients = {name: np.asarray(getattr(sheen_coefficients, name)) for name in DEGREES}
    else:
        coefficients = fit(table)
        TARGET.write_text(source(coefficients))
    print(report(coefficients, table))


if __name__ == "__main__":
    main()
