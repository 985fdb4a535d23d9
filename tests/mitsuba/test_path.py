"""The integrator against Mitsuba's own, and the footprints that it hands to BSDFs.

Covers: mitsuba/pixels.py, mitsuba/path.py, mitsuba/path_vertices.py, mitsuba/camera_walk.py, mitsuba/bsdf.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import camera_walk
from loomlight.mitsuba.bsdf import SceneTraits
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.models.point import PointModel
from tests.marks import slow

DIFFUSE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.7}}
ROUGH = {"type": "twosided", "inner": {"type": "roughconductor", "alpha": 0.15}}
MASK = {"type": "mask", "opacity": 0.4, "inner": DIFFUSE}
GLASS_SHEET = {"type": "thindielectric"}

# By name; those of which the lights' own sampling is compiled longest are slow.
EMITTERS = ["area", "directional", slow("envmap"), slow("point"), slow("sunsky")]


def emitters() -> dict[str, dict[str, Any]]:
    place = mi.ScalarTransform4f
    lamp = place().translate([0, 2, 0]).rotate([1, 0, 0], 90)
    picture = np.linspace(0.1, 2, 8 * 16 * 3, dtype=np.float32).reshape(8, 16, 3)
    return {
        "envmap": {"type": "envmap", "bitmap": mi.Bitmap(picture)},
        "area": {"type": "rectangle", "to_world": lamp, "emitter": {"type": "area", "radiance": 3.0}},
        "point": {"type": "point", "position": [1, 2, 0], "intensity": 4.0},
        "directional": {"type": "directional", "direction": [-0.3, -1, 0.2], "irradiance": 1.0},
        "sunsky": {"type": "sunsky", "to_world": place().rotate([1, 0, 0], -90)},
    }


def table(bsdf: dict[str, Any], emitter: dict[str, Any] | None, size: int = 16) -> Any:
    """A sheet of `bsdf` hovers over a floor."""
    place = mi.ScalarTransform4f
    flat = place().rotate([1, 0, 0], -90)
    scene = {
        "type": "scene",
        "sensor": {
            "type": "perspective",
            "fov": 50,
            "to_world": place().look_at([0, 3, 4], [0, 0.4, 0], [0, 1, 0]),
            "film": {
                "type": "hdrfilm",
                "pixel_format": "rgba",
                "width": size,
                "height": size,
                "rfilter": {"type": "box"},
            },
        },
        "floor": {"type": "rectangle", "to_world": flat.scale(2), "bsdf": {"type": "diffuse"}},
        "sheet": {
            "type": "rectangle",
            "to_world": place().translate([0, 0.8, 0]) @ flat @ place().scale(0.8),
            "bsdf": bsdf,
        },
    }
    if emitter is not None:
        scene["emitter"] = emitter
    return mi.load_dict(scene)


def renders(scene: Any, integrator: dict[str, Any], first_seed: int, count: int = 12) -> np.ndarray:
    tracer = mi.load_dict(integrator)
    return np.stack(
        [
            np.array(mi.render(scene, integrator=tracer, spp=16, seed=first_seed + i), dtype=np.float64)
            for i in range(count)
        ]
    )


def assert_same_expectation(ours: np.ndarray, theirs: np.ndarray) -> None:
    """Welch's z of the whole picture, and of pixels with a bound for their number (two-sided, 1e-4)."""
    means = [picture[..., :3].mean(axis=(1, 2, 3)) for picture in (ours, theirs)]
    spread = np.sqrt(sum(mean.var(ddof=1) / len(mean) for mean in means))
    assert abs(means[0].mean() - means[1].mean()) < 4 * spread + 1e-6
    grey = [picture[..., :3].mean(axis=-1) for picture in (ours, theirs)]
    error = np.sqrt(sum(pixel.var(axis=0, ddof=1) / len(pixel) for pixel in grey))
    z = (grey[0].mean(axis=0) - grey[1].mean(axis=0)) / np.maximum(error, 1e-6)
    # Twelve renders a side make z a little heavier-tailed than normal; a bias of one error would give 1.4.
    assert np.sqrt(np.mean(z**2)) < 1.25


@pytest.mark.quick("rough-area")
@pytest.mark.parametrize("emitter", EMITTERS)
@pytest.mark.parametrize("bsdf", [DIFFUSE, ROUGH], ids=["diffuse", "rough"])
def test_agrees_with_path_without_holes(bsdf: dict[str, Any], emitter: str) -> None:
    scene = table(bsdf, emitters()[emitter])
    ours = renders(scene, {"type": "footprint_path", "max_depth": 6}, 0)
    theirs = renders(scene, {"type": "path", "max_depth": 6}, 100)
    assert_same_expectation(ours, theirs)


@pytest.mark.quick("sheet-area")
@pytest.mark.parametrize("emitter", EMITTERS)
@pytest.mark.parametrize("bsdf", [MASK, GLASS_SHEET], ids=["mask", "sheet"])
def test_agrees_with_volpath_through_holes(bsdf: dict[str, Any], emitter: str) -> None:
    scene = table(bsdf, emitters()[emitter])
    ours = renders(scene, {"type": "footprint_path", "max_depth": -1}, 0)
    theirs = renders(scene, {"type": "volpath", "max_depth": -1}, 100)
    assert_same_expectation(ours, theirs)


def test_a_sheet_without_any_cloth_changes_nothing() -> None:
    # At depth 2 the floor is the last bounce: a path that ended at the sheet would lose the share of the
    # lamp's light that MIS leaves to the BSDF's samples.
    lamp = emitters()["area"]
    empty = table({"type": "mask", "opacity": 0.0, "inner": DIFFUSE}, lamp)
    ours = renders(empty, {"type": "footprint_path", "max_depth": 2}, 0)
    gone = table(DIFFUSE, lamp)
    params = mi.traverse(gone)
    params["sheet.to_world"] = mi.Transform4f().translate([0, -50, 0])
    params.update()
    theirs = renders(gone, {"type": "path", "max_depth": 2}, 100)
    assert_same_expectation(ours, theirs)


def test_alpha_is_zero_where_nothing_is() -> None:
    scene = table(DIFFUSE, emitters()["point"])
    alpha = renders(scene, {"type": "footprint_path"}, 0, count=1)[0, ..., 3]
    assert alpha[0, 0] == 0
    assert alpha[8, 8] == 1
    behind = table(DIFFUSE, emitters()["envmap"])
    assert renders(behind, {"type": "footprint_path"}, 0, count=1)[0, ..., 3].min() == 1


def test_hidden_emitters_do_not_show() -> None:
    for name in ("envmap", "area"):
        scene = table(DIFFUSE, emitters()[name])
        ours = renders(scene, {"type": "footprint_path", "hide_emitters": True, "max_depth": 4}, 0)
        theirs = renders(scene, {"type": "path", "hide_emitters": True, "max_depth": 4}, 100)
        assert_same_expectation(ours, theirs)
        np.testing.assert_allclose(ours[..., 3].mean(axis=0), theirs[..., 3].mean(axis=0), atol=0.15)


def test_works_in_xml() -> None:
    scene = mi.load_string(
        """<scene version="3.0.0">
             <integrator type="footprint_path"><integer name="max_depth" value="3"/></integrator>
             <sensor type="perspective"><film type="hdrfilm">
               <integer name="width" value="4"/><integer name="height" value="4"/></film></sensor>
             <emitter type="constant"/>
           </scene>"""
    )
    np.testing.assert_allclose(np.array(mi.render(scene, spp=1)), 1, rtol=1e-6)
    assert "max_depth = 3" in str(scene.integrator())


def footprint_probe() -> type:
    class FootprintProbe(mi.BSDF):
        """Sends back the area of the footprint in uv, whatever the directions; scatters nothing further."""

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.m_flags = mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [self.m_flags]

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            return dr.zeros(mi.BSDFSample3f), mi.Spectrum(0)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return mi.Spectrum(dr.abs(dr.det(mi.Matrix2f(si.duv_dx, si.duv_dy))))

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return mi.Float(1)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval(ctx, si, wo, active), mi.Float(1)

        def to_string(self) -> str:
            return "FootprintProbe"

    return FootprintProbe


def test_bsdfs_are_asked_for_light_and_next_direction_at_once() -> None:
    asked: list[str] = []
    base: Any = footprint_probe()

    class CountingProbe(base):
        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            asked.append("eval_pdf")
            return super().eval_pdf(ctx, si, wo, active)

        def eval_pdf_sample(
            self, ctx: Any, si: Any, wo: Any, sample1: Any, sample2: Any, active: Any = True
        ) -> Any:
            asked.append("eval_pdf_sample")
            return mi.Spectrum(0.5), mi.Float(0), *self.sample(ctx, si, sample1, sample2, active)

    mi.register_bsdf("counting_probe", lambda props: CountingProbe(props))
    scene = mi.load_dict(
        {
            "type": "scene",
            "sensor": {
                "type": "perspective",
                "to_world": mi.ScalarTransform4f().translate([0, 0, 2]).rotate([0, 1, 0], 180),
                "film": {"type": "hdrfilm", "width": 4, "height": 4, "rfilter": {"type": "box"}},
            },
            "plate": {"type": "rectangle", "bsdf": {"type": "counting_probe"}},
            "light": {"type": "constant", "radiance": 1.0},
        }
    )
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    picture = np.array(mi.render(scene, integrator=integrator, spp=16))
    # With a density of 0 lights count in full, and all 4π directions are drawn alike: no noise, but rounding.
    np.testing.assert_allclose(picture.mean(), 0.5 * 4 * np.pi, rtol=1e-4)
    assert set(asked) == {"eval_pdf_sample"}


def probe_scene(
    distance: float, tilt: float = 0.0, mirror: bool = False, bsdf: Any = None, rfilter: str = "box"
) -> Any:
    """A camera looks along −z at a 2 × 2 plate `distance` away, or at it by way of a mirror."""
    probe = footprint_probe()
    mi.register_bsdf("footprint_probe", lambda props: probe(props))
    place = mi.ScalarTransform4f
    plate = place().translate([0, 0, -distance]).rotate([0, 1, 0], tilt)
    if mirror:
        # The ray turns by 90° at (0, 0, −1) and goes on along +x.
        plate = place().translate([distance - 1, 0, -1]).rotate([0, 1, 0], -90)
    scene = {
        "type": "scene",
        "sensor": {
            "type": "perspective",
            "fov": 2,
            "near_clip": 1e-3,
            "to_world": place().look_at([0, 0, 0], [0, 0, -1], [0, 1, 0]),
            "film": {"type": "hdrfilm", "width": 8, "height": 8, "rfilter": {"type": rfilter}},
        },
        "plate": {"type": "rectangle", "to_world": plate, "bsdf": bsdf or {"type": "footprint_probe"}},
        "light": {"type": "directional", "direction": [0.6, 0, -0.8], "irradiance": 1.0},
    }
    if mirror:
        scene["mirror"] = {
            "type": "rectangle",
            "to_world": place().translate([0, 0, -1]).rotate([0, 1, 0], 45),
            "bsdf": {"type": "conductor", "specular_reflectance": 1.0, "material": "none"},
        }
    return mi.load_dict(scene)


def pixel_area(distance: float, spp: int) -> float:
    """Area in uv of one of 8 pixels across 2°, on a plate 2 wide, shared by `spp` samples."""
    side = 2 * distance * np.tan(np.radians(1)) / 8 / 2
    return side**2 / spp


@pytest.mark.parametrize(("tilt", "spp"), [(0, 1), (0, 16), (60, 4)])
def test_primary_footprint_is_the_pixel(tilt: float, spp: int) -> None:
    picture = np.array(
        mi.render(probe_scene(5.0, tilt), integrator=mi.load_dict({"type": "footprint_path"}), spp=spp)
    )
    expected = pixel_area(5.0, spp) / np.cos(np.radians(tilt))
    # Perspective varies by 2·tan(1°)·tan(tilt) over the picture.
    np.testing.assert_allclose(picture[3:5, 3:5].mean(), expected, rtol=0.03)


def test_cone_after_a_mirror_goes_on_as_if_straight() -> None:
    picture = np.array(
        mi.render(probe_scene(5.0, mirror=True), integrator=mi.load_dict({"type": "footprint_path"}), spp=4)
    )
    np.testing.assert_allclose(picture[3:5, 3:5].mean(), pixel_area(5.0, 4), rtol=0.03)


def test_footprint_passes_through_holes_unchanged() -> None:
    scene = probe_scene(5.0)
    pane = {
        "type": "rectangle",
        "to_world": mi.ScalarTransform4f().translate([0, 0, -2]).rotate([0, 1, 0], 30),
        "bsdf": {"type": "null"},
    }
    with_pane = mi.load_dict(
        {
            "type": "scene",
            "a": scene.sensors()[0],
            "b": scene.shapes()[0],
            "c": pane,
            "d": scene.emitters()[0],
        }
    )
    tracer = mi.load_dict({"type": "footprint_path"})
    np.testing.assert_allclose(
        np.array(mi.render(with_pane, integrator=tracer, spp=4))[3:5, 3:5].mean(),
        pixel_area(5.0, 4),
        rtol=0.03,
    )


def test_gradient_of_a_colour_is_what_finite_differences_say() -> None:
    scene = table(
        {
            "type": "mask",
            "opacity": 0.4,
            "inner": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}},
        },
        emitters()["area"],
    )
    tracer = mi.load_dict({"type": "footprint_path", "max_depth": 4})
    params = mi.traverse(scene)
    key = next(key for key in params.keys() if key.startswith("sheet") and "reflectance" in key)  # noqa: SIM118

    def brightness(value: float) -> float:
        params[key] = mi.Color3f(value)
        params.update()
        return float(np.array(mi.render(scene, integrator=tracer, spp=64, seed=7)).mean())

    step = 0.05
    difference = (brightness(0.5 + step) - brightness(0.5 - step)) / (2 * step)
    value = mi.Color3f(0.5)
    dr.enable_grad(value)
    params[key] = value
    params.update()
    dr.backward(dr.mean(mi.render(scene, params, integrator=tracer, spp=64, seed=7), axis=None))
    # The same random numbers on both sides; what is left is curvature and Russian roulette's choices.
    np.testing.assert_allclose(np.array(dr.grad(params[key])).sum(), difference, rtol=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("gap", [0.02, 0.03, 0.05])
def test_the_shadow_of_dense_cloth_misses_less_than_a_thousandth(gap: float) -> None:
    """The floor under a sheet of cloth that covers all of it, in light from straight above."""
    fabric = fabric_from_text(f'weave = "satin 8/3"\ngap = {gap}')
    light = {"type": "directional", "direction": [0, -1, 0], "irradiance": 1.0}
    lit, shaded = (
        table(bsdf, light) for bsdf in ({"type": "null"}, material_bsdf(fabric, "lobes")((2000.0, 2000.0)))
    )
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    assert SceneTraits.of(shaded).porous_shadows == (gap > 0.03)
    assert SceneTraits.of(shaded).holes
    under, bare = (
        # Pixels of the floor right under the sheet, seen beneath its edge.
        np.array(mi.render(scene, integrator=integrator, spp=16))[..., :3]
        for scene in (shaded, lit)
    )
    dark = (under.sum(axis=2) < 0.05 * bare.sum(axis=2)) & (bare.sum(axis=2) > 0)
    assert dark.any()
    missing = gap**2 - (under[dark] / bare[dark])
    assert missing.max() < 1e-3


@pytest.mark.slow
def test_roulette_of_light_through_holes_changes_no_expectation(monkeypatch: pytest.MonkeyPatch) -> None:
    """The floor under a sheet of which 2 % are holes, below a lamp: at one sample 5 % are the least share."""
    flat = mi.ScalarTransform4f().translate([0, 3, 0]).rotate([1, 0, 0], 90).scale(0.1)
    lamp = {"type": "rectangle", "to_world": flat, "emitter": {"type": "area", "radiance": 1e3}}
    cloth = material_bsdf(fabric_from_text('weave = "plain"\ngap = 0.15'), "lobes")((200.0, 200.0))
    scene = table(cloth, lamp)
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})

    def pictures() -> np.ndarray:
        each = [np.array(mi.render(scene, integrator=integrator, spp=1, seed=seed)) for seed in range(64)]
        return np.array(each, np.float64)[..., :3].mean(axis=-1)

    gambled = pictures()
    monkeypatch.setattr(camera_walk, "_MAX_STEP_IN_NOISE", 1e-6)
    whole = pictures()
    noise, least_noise = (each.std(axis=0, ddof=1) for each in (gambled, whole))
    shadow = noise > 1.5 * least_noise
    assert shadow.sum() > 8
    # A pixel's deviations are independent; the mean of the shadow to four standard errors, some 10 %.
    error = np.sqrt((noise[shadow] ** 2 + least_noise[shadow] ** 2).sum() / 64) / shadow.sum()
    assert abs((gambled - whole).mean(axis=0)[shadow].mean()) < 4 * error
    assert error < 0.05 * whole.mean(axis=0)[shadow].mean()


@pytest.mark.slow
def test_cloth_that_is_woven_anew_casts_its_own_shadow() -> None:
    texts = ('weave = "plain"\ngap = 0.02', 'weave = "plain"\ngap = 0.5')
    dense, open_ = (fabric_from_text(text) for text in texts)
    light = {"type": "directional", "direction": [0, -1, 0], "irradiance": 1.0}
    scene = table(material_bsdf(dense, "lobes")((2000.0, 2000.0)), light)
    (bsdf,) = (shape.bsdf() for shape in scene.shapes() if hasattr(shape.bsdf(), "set_source"))
    picture = LivePicture(scene, integrator=mi.load_dict({"type": "footprint_path", "max_depth": 2}))
    before = picture.take()
    bsdf.set_source(open_)
    after = picture.take()
    assert SceneTraits.of(scene).porous_shadows
    anew = table(material_bsdf(open_, "lobes")((2000.0, 2000.0)), light)
    wanted = LivePicture(anew, integrator=mi.load_dict({"type": "footprint_path", "max_depth": 2})).take()
    assert not np.allclose(before, wanted, atol=1e-3)
    np.testing.assert_allclose(after, wanted, atol=1e-5)


def test_nested_cloth_knows_how_many_samples_share_a_pixel_of_its_own_render_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A filter with negative lobes has no part for footprints: so many samples are its mean."""
    asked: list[Any] = []
    at = PointModel.at

    def recorded(model: PointModel, view: Any, footprint: Any, *rest: Any) -> Any:
        asked.append(footprint.samples)
        return at(model, view, footprint, *rest)

    monkeypatch.setattr(PointModel, "at", recorded)
    cloth = {"type": "mask", "opacity": 0.5, "inner": {"type": "woven_point"}}
    scene = probe_scene(5.0, bsdf=cloth, rfilter="mitchell")
    for integrator, spp, told in (("footprint_path", 4, 4), ("path", 4, 1), ("footprint_path", 9, 9)):
        asked.clear()
        np.array(mi.render(scene, integrator=mi.load_dict({"type": integrator}), spp=spp))
        assert {float(np.array(samples).item()) for samples in asked} == {told}
