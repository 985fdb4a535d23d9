"""Samplers of single lobes: directions follow their density. Those of whole models are in test_sampling.py.

Covers: scattering/directions.py, scattering/diffuse.py, scattering/fibre.py, scattering/sheen.py
Covers: scattering/lobe_mixture.py, models/networks.py
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.models.networks import LearnedProposal
from loomlight.scattering import fibre
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.directions import uniform_on_sphere
from loomlight.scattering.lobe_mixture import (
    OUTPUTS,
    TwoSidedLobes,
    lobe_mixture,
    mixture_density,
    sample_mixture,
)
from loomlight.scattering.sheen import sample_sheen, sheen_pdf
from tests.helpers.arrays import vectors
from tests.helpers.chi_square import COLUMNS, ROWS, cell_counts, cell_shares, p_value
from tests.helpers.lobes import (
    FIBRE_ROUGHNESSES,
    MIXTURE_VIEWS,
    MIXTURES,
    NORMALS,
    SHEENS,
    jittered_sphere,
    jittered_upper_half,
    view_at,
)
from tests.helpers.references import microflakes as flakes

require_llvm()

Rows = NDArray[np.float64]


@dataclass(frozen=True)
class Sampler:
    """Draws directions of one lobe.

    Attributes:
        draw: of uniform numbers, one and a pair, to directions on a device.
        density: of directions on a device, 1/sr.
        count: of directions to draw.
        grid: directions [n, 3] and the solid angle of each, dense where the density is; None is a Gauss rule
            in each cell.
        frame: in which cells are counted, its axes as rows: lobes along edges of cells are the worst case.
        has_pole_below: below the surface the density has a pole where light and view are opposite, which no
            rule integrates: all cells there are one.
    """

    draw: Callable[[Float, Array2f], Any]
    density: Callable[[Array3f], Float]
    count: int = 1 << 18
    grid: Callable[[], tuple[Rows, Rows | float]] | None = None
    frame: Rows | None = None
    has_pole_below: bool = False


def uniform_samplers() -> Iterator[tuple[str, Sampler]]:
    yield "uniform", Sampler(lambda _, u: uniform_on_sphere(u), lambda light: 0 * light.z + 1 / (4 * math.pi))


def diffuse_samplers() -> Iterator[tuple[str, Sampler]]:
    frame = flakes.frame_about(flakes.unit([0.2, 0.9, 0.4]))
    for number, normal in enumerate(NORMALS):
        for blend in (0.0, 0.3, 1.0):
            n, w = vectors(normal[None]), Float(blend)
            yield (
                f"diffuse-{number}-{blend}",
                Sampler(
                    lambda _, u, n=n, w=w: sample_diffuse(n, w, u),
                    lambda light, n=n, w=w: diffuse_pdf(light, n, w),
                    grid=jittered_sphere,
                    frame=frame,
                ),
            )


def fibre_samplers() -> Iterator[tuple[str, Sampler]]:
    along = np.array([1.0, 0, 0])
    views = {
        "across": (np.array([0.0, 0.3, np.sqrt(1 - 0.09)]), along),
        "oblique": (flakes.unit([0.6, -0.5, 0.4]), flakes.unit([0.8, 0.3, 0.2])),
        "grazing": (flakes.unit([0.7, 0.7, 0.01]), along),
        "nearly along the fibre": (flakes.unit([1, 0.004, 0.01]), along),
    }
    for name, (view, tangent) in views.items():
        for roughness in FIBRE_ROUGHNESSES:
            arguments = vectors(view[None]), vectors(tangent[None]), Float(roughness)
            yield (
                f"fibre-{name}-{roughness}",
                Sampler(
                    lambda _, u, a=arguments: fibre.sample_specular(*a, u),
                    lambda light, a=arguments: fibre.pdf_specular(light, *a),
                    # Edges of cells cut those of the grid: 2.5 counts of 300, a fiftieth of the variance.
                    grid=lambda v=view, t=tangent, r=roughness: flakes.light_grid(v, t, r, (1200, 1000)),
                    frame=flakes.frame_about(flakes.unit([0.3, 0.5, 0.8])),
                ),
            )


def sheen_samplers() -> Iterator[tuple[str, Sampler]]:
    for cosine, roughness in SHEENS:
        view = view_at(cosine)
        yield (
            f"sheen-{cosine}-{roughness}",
            Sampler(
                lambda _, u, v=view, r=roughness: sample_sheen(v, r, u),
                lambda light, v=view, r=roughness: sheen_pdf(light, v, r),
                grid=jittered_upper_half,
            ),
        )


def mixture_samplers() -> Iterator[tuple[str, Sampler]]:
    for name, outputs in MIXTURES.items():
        for number, view in enumerate(MIXTURE_VIEWS):
            mixture = lobe_mixture([Float(value) for value in outputs])
            eye = [Float(part) for part in view]
            yield (
                f"mixture-{name}-{number}",
                Sampler(
                    lambda choice, u, m=mixture, e=eye: Array3f(*sample_mixture(m, e, choice, [u.x, u.y])),
                    lambda light, m=mixture, e=eye: mixture_density(m, list(light), e),
                    count=40_000,
                    has_pole_below=True,
                ),
            )


def learned_samplers() -> Iterator[tuple[str, Sampler]]:
    """Proposals of random outputs of the sampler network, the first without sheen."""
    for seed in range(4):
        rng = np.random.default_rng(seed)
        outputs = rng.normal(scale=0.6, size=OUTPUTS)
        # Narrow lobes would need more points in the cells; mixtures have those.
        outputs[[0, 1, 9, 10]] = rng.uniform(0.2, 1.5, 4)
        view = np.array([*rng.uniform(-0.6, 0.6, 2), 0])
        view[2] = np.sqrt(1 - view @ view)
        lobes = TwoSidedLobes.of([Float(value) for value in outputs])
        sheen = (Float(0.1 * seed), 0.4) if seed else None
        proposal = LearnedProposal(Float(0), lobes, Array3f(*view.tolist()), sheen)
        yield (
            f"learned-{seed}",
            Sampler(
                lambda choice, u, p=proposal: _drawn_through_no_hole(p, choice, u), proposal.density, 100_000
            ),
        )


def _drawn_through_no_hole(proposal: LearnedProposal, choice: Float, u: Array2f) -> Array3f:
    light, is_null = proposal.draw(choice, u)
    assert not np.array(is_null).any()
    return light


KINDS = (
    uniform_samplers,
    diffuse_samplers,
    fibre_samplers,
    sheen_samplers,
    mixture_samplers,
    learned_samplers,
)


@cache
def samplers() -> dict[str, Sampler]:
    return {name: sampler for kind in KINDS for name, sampler in kind()}


QUICK = {"diffuse-1-0.3", "diffuse-2-1.0", "fibre-oblique-0.3", "fibre-grazing-0.1"}
QUICK |= {"fibre-nearly along the fibre-0.6", "sheen-0.1-1.0", "sheen-0.3-0.4", "uniform"}
QUICK |= {name for name in samplers() if name.startswith(("mixture", "learned"))}


def expected_shares(sampler: Sampler, shape: tuple[int, int]) -> Rows:
    """Of all directions, by cell."""

    def density(rows: Rows) -> Rows:
        found = np.array(sampler.density(vectors(rows)), np.float64)
        return np.broadcast_to(found, len(rows))

    if sampler.grid is None:
        return cell_shares(density)
    directions, solid_angle = sampler.grid()
    turned = directions if sampler.frame is None else directions @ sampler.frame.T
    return cell_counts(turned, shape, density(directions) * solid_angle)


@pytest.mark.quick(*sorted(QUICK))
@pytest.mark.parametrize("name", samplers())
def test_directions_follow_their_density(name: str) -> None:
    sampler, rng = samplers()[name], np.random.default_rng(7)
    shape = (ROWS, COLUMNS) if sampler.grid is None else (24, 36)
    u = rng.random((3, sampler.count), np.float32)
    drawn = sampler.draw(Float(u[0]), Array2f(u[1:])).numpy().T.astype(np.float64)
    np.testing.assert_allclose(np.linalg.norm(drawn, axis=1), 1, atol=1e-5)
    shares = expected_shares(sampler, shape)
    counts = cell_counts(drawn if sampler.frame is None else drawn @ sampler.frame.T, shape)
    if sampler.has_pole_below:
        below = shape[0] // 2 * shape[1]
        counts = np.append(counts[below:], counts[:below].sum())
        shares = np.append(shares[below:], 1 - shares[below:].sum())
    # The error of rules and grids.
    assert shares.sum() == pytest.approx(1, abs=2e-3)
    # 59 samplers: a false alarm in one of 170 runs, were the seeds not fixed.
    assert p_value(counts, shares / shares.sum() * sampler.count) > 1e-4
