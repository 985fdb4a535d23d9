"""The film's filter: what samples and footprints make of it together.

Covers: mitsuba/path.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.backend import clip
from loomlight.mitsuba import render
from loomlight.mitsuba.bsdf import FILTERS as FILTERS_FLAG
from loomlight.mitsuba.pixels import PixelFilter

FILTERS = {
    "box": {"type": "box"},
    "tent": {"type": "tent"},
    "gaussian": {"type": "gaussian"},
    "wide": {"type": "gaussian", "stddev": 0.8},
}
# Columns and rows of the pictures below; what they show does not change from row to row.
SIDE, ROWS = 16, 128


def film(rfilter: dict[str, Any], size: int = 8) -> Any:
    return mi.load_dict({"type": "hdrfilm", "width": size, "height": size, "rfilter": rfilter})


def share_below(of_film: Any, places: np.ndarray) -> np.ndarray:
    """The share of a film's filter, or of its splat, that lies below places."""
    density = np.array([of_film.rfilter().eval(float(place)) for place in places])
    share = np.concatenate([[0], np.cumsum(density[1:] + density[:-1])])
    return np.array(share / share[-1])


@pytest.mark.parametrize("name", FILTERS)
def test_splats_places_and_offsets_make_up_the_filter(name: str) -> None:
    of_film = film(FILTERS[name])
    found = PixelFilter.of(of_film, centred=False)
    assert found is not None
    rng = np.random.default_rng(1)
    count = 200_000
    u, v = (mi.Point2f(rng.random((2, count), np.float32)) for _ in range(2))
    places = found.places(u, v)
    rays, samples = np.array(places.sample + places.offset), np.array(places.sample)
    if found.splat_deviation is not None:
        # Samples spread evenly over the film, splatted: as good as their places being drawn from the splat.
        splatted = rng.normal(scale=found.splat_deviation, size=(2, count))
        rays, samples = np.array(places.offset) + splatted, splatted
    edges = np.linspace(-found.radius, found.radius, 401)
    share = share_below(of_film, edges)
    middle = 0.5 * (edges[1:] + edges[:-1])
    variance = (np.diff(share) * middle**2).sum()
    np.testing.assert_allclose(found.variance, variance, rtol=0.01)
    for axis in range(2):
        drawn = np.searchsorted(np.sort(rays[axis]), edges) / count
        # Kolmogorov's bound of 200 000 numbers is 0.004; the splat is not lowered by 3e-4 of its peak.
        np.testing.assert_allclose(drawn, share, atol=5e-3)
        total = samples[axis].var() + found.footprint_side**2 / 12
        np.testing.assert_allclose(total, found.variance, rtol=0.01)


def test_centred_footprints_have_all_of_the_variance() -> None:
    for rfilter in FILTERS.values():
        found = PixelFilter.of(film(rfilter), centred=True)
        assert found is not None
        np.testing.assert_allclose(found.footprint_side**2 / 12, found.variance, rtol=1e-6)
        assert found.splat_deviation is None


def test_filters_with_negative_lobes_are_not_divided() -> None:
    assert PixelFilter.of(film({"type": "mitchell"}), centred=False) is None
    assert PixelFilter.of(film({"type": "lanczos"}), centred=False) is None


def step_probe() -> type:
    class StepProbe(mi.BSDF):
        """Black for u below 1/2 and white above, averaged over its footprint if it `filters`."""

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.filters = props.get("filters", True)
            flags = mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [flags]
            self.m_flags = flags | (FILTERS_FLAG if self.filters else 0)

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            return dr.zeros(mi.BSDFSample3f), mi.Spectrum(0)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            side = dr.abs(si.duv_dx.x) if self.filters else 1e-6
            return mi.Spectrum(clip((si.uv.x - 0.5) / side + 0.5, 0, 1))

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return mi.Float(0)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval(ctx, si, wo, active), mi.Float(0)

        def to_string(self) -> str:
            return "StepProbe"

    return StepProbe


def column_means(
    bsdf: dict[str, Any], rfilter: dict[str, Any], shift: float, spp: int, **others: Any
) -> np.ndarray:
    """Means over rows and over as many pictures as have 1 024 samples a column, at least one [width]."""
    pictures = [
        plate(bsdf, rfilter, shift, spp, seed, **others) for seed in range(max(1024 // (spp * ROWS), 1))
    ]
    return np.mean(pictures, axis=(0, 1))


def plate(
    bsdf: dict[str, Any], rfilter: dict[str, Any], shift: float, spp: int, seed: int, **others: Any
) -> np.ndarray:
    """A plate twice as wide as the picture, its middle `shift` pixels to the right; grey [height, width].

    Args:
        others: shapes of the scene.
    """
    place = mi.ScalarTransform4f
    scene = mi.load_dict(
        {
            "type": "scene",
            **others,
            "plate": {
                "type": "rectangle",
                "to_world": place().translate([2 / SIDE * shift, 0, 0]).scale([2, 9, 1]),
                "bsdf": bsdf,
            },
            "light": {"type": "directional", "direction": [0, 0, -1]},
            "sensor": {
                "type": "orthographic",
                "to_world": place().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0]),
                "film": {"type": "hdrfilm", "width": SIDE, "height": ROWS, "rfilter": rfilter},
                "sampler": {"type": "multijitter"},
            },
        }
    )
    return render(scene, spp=spp, seed=seed)[..., :3].mean(axis=2)


def edge_of(rfilter: dict[str, Any], shift: float) -> np.ndarray:
    """What the film's filter makes of a step in the middle of a picture, `shift` pixels to the right."""
    places = np.linspace(-4, 4, 8001)
    share = share_below(film(rfilter), places)
    columns = np.arange(SIDE) + 0.5 - SIDE / 2 - shift
    return np.interp(columns, places, share)


@pytest.fixture(autouse=True, scope="module")
def _probe() -> None:
    mi.register_bsdf("step_probe", step_probe())


@pytest.mark.quick("gaussian-1")
@pytest.mark.parametrize("spp", [1, 4, 64])
@pytest.mark.parametrize("name", FILTERS)
def test_edges_of_filtered_texture_are_those_of_the_filter(name: str, spp: int) -> None:
    """Whatever the number of samples: within 3 % of the step, 1 % of a box's."""
    bound = 0.01 if name == "box" else 0.03
    for shift in (0.0, 0.3, 0.7):
        # 1 024 samples a column: what a third of the variance leaves of noise is a few tenths of a percent.
        found = column_means({"type": "step_probe"}, FILTERS[name], shift, spp)
        np.testing.assert_allclose(found, edge_of(FILTERS[name], shift), atol=bound)


@pytest.mark.parametrize("name", FILTERS)
def test_edges_of_other_texture_are_those_of_the_filter_too(name: str) -> None:
    """Beside cloth that filters, in pictures that therefore draw from the filter."""
    cloth = {"type": "rectangle", "to_world": mi.ScalarTransform4f().translate([0, 0, -9])}
    other = {"unseen": cloth | {"bsdf": {"type": "step_probe"}}}
    found = column_means({"type": "step_probe", "filters": False}, FILTERS[name], 0.3, 16, **other)
    # 2 048 samples a column, stratified: noise of half a percent at most.
    np.testing.assert_allclose(found, edge_of(FILTERS[name], 0.3), atol=0.02)


@pytest.mark.quick("gaussian-1")
@pytest.mark.parametrize("spp", [1, 16])
@pytest.mark.parametrize("name", FILTERS)
def test_silhouettes_are_those_of_the_filter(name: str, spp: int) -> None:
    # The end of the white half of a plate lies in the middle of the picture.
    found = column_means({"type": "step_probe"}, FILTERS[name], 0.3 - SIDE, spp)
    # As above; 1 024 samples that are not stratified within pixels have noise of 1.5 %.
    np.testing.assert_allclose(1 - found, edge_of(FILTERS[name], 0.3), atol=0.06 if spp == 1 else 0.02)


def test_texture_leaves_no_noise_under_a_box_filter() -> None:
    first, other = (plate({"type": "step_probe"}, FILTERS["box"], 0.3, 4, seed) for seed in (1, 2))
    np.testing.assert_allclose(first, other, atol=1e-3)
