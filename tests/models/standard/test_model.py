"""The principled material over footprints: against Mitsuba's and NumPy's, its samples, maps, and faces.

Covers: models/standard/maps.py
"""

from __future__ import annotations

import math
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float

from loomlight.core.errors import LoomlightWarning
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.exporters.standards import StandardMaterial, evaluate_principled
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.standard.maps import FaceMaps, averaged
from loomlight.models.standard.model import StandardModel
from loomlight.sources.u3m import U3mMaterial
from tests.helpers.arrays import numbers, vectors
from tests.helpers.chi_square import cell_counts, cell_shares, p_value
from tests.helpers.directions import directions
from tests.helpers.u3m import image, material, png, visual

require_llvm()
CLOTH = visual(
    basecolor=(0.8, 0.5, 0.3), roughness=0.5, anisotropy_value=0.7, anisotropy_rotation=0.1,
    specular_value=0.8, sheen_value=0.2, transmission=0.25, alpha=0.9,
)  # fmt: skip


def footprint(place: Any, side: float, count: int) -> Footprint:
    side_of, zero = dr.full(Float, side, count), dr.zeros(Float, count)
    centre = Array2f(*(np.broadcast_to(part, count).astype(np.float32) for part in place))
    return Footprint(centre, Array2f(side_of, zero), Array2f(zero, side_of))


def value(
    made: U3mMaterial, light: Any, view: Any, place: Any = (0.0, 0.0), side: float = 1e-3
) -> np.ndarray:
    """f·cos [n, 3]."""
    at = StandardModel(made).at(vectors(view), footprint(place, side, len(view)))
    return np.array(at.value(vectors(light))).T


def pairs(count: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(2)
    light, view = directions(rng, count), directions(rng, count)
    # Neither formula is of use along the horizon.
    steep = (np.abs(light[:, 2]) > 0.05) & (np.abs(view[:, 2]) > 0.05)
    return light[steep], view[steep]


def test_it_is_the_material_that_exports_are_fitted_by() -> None:
    """NumPy's twin in double precision: single precision differs by 1e-4 of a value."""
    light, view = pairs(2000)
    view[:, 2] = np.abs(view[:, 2])
    angle = 2 * np.pi * 0.1
    base = np.array([0.8, 0.5, 0.3])
    linear = np.where(base <= 0.04045, base / 12.92, ((base + 0.055) / 1.055) ** 2.4)
    aspect = math.sqrt(1 - 0.9 * 0.7)

    def over(each: Any) -> np.ndarray:
        return np.broadcast_to(np.asarray(each, float), (len(view), *np.shape(each)))

    twin = StandardMaterial(
        base=over(linear),
        transmission=over(0.25),
        transmit=over(linear),
        specular=over([0.064] * 3),
        weight=1.0,
        alpha_x=over(0.25 / aspect),
        alpha_y=over(0.25 * aspect),
        normal=over([0, 0, 1]),
        axis_x=over([math.cos(angle), math.sin(angle), 0]),
        axis_y=over([-math.sin(angle), math.cos(angle), 0]),
        sheen=np.full(3, 0.2),
        sheen_roughness=0.5,
    )
    expected = 0.9 * evaluate_principled(twin, light, view)
    np.testing.assert_allclose(value(material(CLOTH), light, view), expected, rtol=2e-4, atol=1e-5)


@pytest.mark.parametrize(
    "fields",
    [
        {"roughness": 0.6, "specular_value": 0.5},
        {"roughness": 0.4, "specular_value": 1.0, "anisotropy_value": 0.8},
        {"roughness": 0.5, "metalness": 1.0},
        {"roughness": 0.7, "sheen_value": 0.6, "sheen_tint": 0.5, "specular_value": 0.2},
    ],
    ids=["dielectric", "anisotropic", "metal", "sheen"],
)
def test_mitsuba_shades_the_same_material_alike(fields: dict[str, float]) -> None:
    """Its `principled` has Fresnel's equations for Schlick's polynomial, and masks and shadows apart.

    Of the brightest highlights that makes up to a fifth, in the mean of all directions little.
    """
    choose_variant(None)
    rng = np.random.default_rng(3)
    light, view = directions(rng, 2000), directions(rng, 2000)
    light[:, 2], view[:, 2] = np.abs(light[:, 2]), np.abs(view[:, 2])
    steep = (light[:, 2] > 0.3) & (view[:, 2] > 0.3)
    light, view = light[steep], view[steep]
    names = {
        "roughness": "roughness", "specular_value": "specular", "anisotropy_value": "anisotropic",
        "metalness": "metallic", "sheen_value": "sheen", "sheen_tint": "sheen_tint",
    }  # fmt: skip
    theirs = {names[name]: number for name, number in fields.items()}
    color = {"type": "rgb", "value": [0.5, 0.3, 0.2]}
    bsdf = mi.load_dict({"type": "principled", "base_color": color, **theirs})
    si = dr.zeros(mi.SurfaceInteraction3f, len(view))
    si.wi = mi.Vector3f(view.T.astype(np.float32))
    expected = np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(light.T.astype(np.float32)))).T
    encoded = tuple(1.055 * part ** (1 / 2.4) - 0.055 for part in (0.5, 0.3, 0.2))
    actual = value(material(visual(basecolor=encoded, **fields)), light, view)
    np.testing.assert_allclose(actual, expected, rtol=0.2, atol=0.01)
    assert actual.mean() == pytest.approx(expected.mean(), rel=0.03)


@pytest.mark.parametrize("polar", [10.0, 65.0, 150.0])
def test_samples_follow_their_density(polar: float) -> None:
    count = 20_000
    angle = math.radians(polar)
    view = np.tile([math.sin(angle) * 0.8, math.sin(angle) * 0.6, math.cos(angle)], (count, 1))
    model = StandardModel(material(CLOTH))
    at = model.at(vectors(view), footprint((0, 0), 1e-3, count))
    drawn = at.sample(*numbers(np.random.default_rng(4), count))
    passes = drawn.is_null.numpy()
    # A tenth of the light passes straight on: four standard deviations.
    assert passes.mean() == pytest.approx(0.1, abs=4 * math.sqrt(0.09 / count))
    np.testing.assert_allclose(drawn.light.numpy()[:, passes], -view.T[:, passes], atol=1e-6)
    again = at.value(drawn.light).numpy() / np.maximum(at.pdf(drawn.light).numpy(), 1e-30)
    np.testing.assert_allclose(drawn.weight.numpy()[:, ~passes], again[:, ~passes], rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(drawn.weight.numpy()[:, passes], 1, rtol=1e-5)

    def density(lights: np.ndarray) -> np.ndarray:
        some = model.at(vectors(np.tile(view[0], (len(lights), 1))), footprint((0, 0), 1e-3, len(lights)))
        return some.pdf(vectors(lights)).numpy().astype(np.float64)

    shares = cell_shares(density)
    # Of the rule, and of gloss that falls below the horizon, which no view has.
    assert shares.sum() == pytest.approx(0.9, abs=5e-3)
    counts = cell_counts(drawn.light.numpy().T[~passes].astype(np.float64))
    # So unlikely is one seed in a thousand.
    assert p_value(counts, shares * count) > 1e-3


STRIPES = np.zeros((4, 6, 3), np.uint8)
STRIPES[:, :2] = [255, 0, 0]
STRIPES[0] = [0, 255, 0]


def striped(back: bool = False) -> U3mMaterial:
    """Two columns of six are red at the left, the upper row of four is green; 12 × 8 mm."""
    white = {"r": 1, "g": 1, "b": 1}
    texture = {"mode": "multiply", "factor": white, "image": image("a.png")}
    face = visual(basecolor={"constant": white, "texture": texture}, specular_value=0, roughness=1)
    plain_face = visual(basecolor=(0, 0, 1), specular_value=0, roughness=1)
    return material(plain_face if back else face, face if back else None, a=png(STRIPES))


UP, DOWN = np.array([[0.0, 0, 1]]), np.array([[0.0, 0, -1]])


def test_maps_lie_in_millimetres_and_repeat() -> None:
    for x, y, channel in (
        (1, 1, 0),
        (3, 5, 0),
        (5, 7, 1),
        (13, 1, 0),
        (-11, -7, 0),
        (24 + 1, 8 * 100 + 7, 1),
    ):
        found = value(striped(), UP, UP, (x, y))[0]
        assert found.argmax() == channel, (x, y)
    assert value(striped(), UP, UP, (7, 3)).max() < 0.02


def test_the_back_is_seen_from_behind() -> None:
    """Its left is where the front's right is: what is red at 1 mm from behind lies at −1 mm."""
    made = striped(back=True)
    assert value(made, DOWN, DOWN, (-1, 1))[0].argmax() == 0
    assert value(made, DOWN, DOWN, (1, 1)).max() < 0.02
    assert value(made, UP, UP, (1, 1))[0].argmax() == 2


def test_highlights_of_the_back_are_turned_with_it() -> None:
    """Wide along a direction of its own frame, whose x runs against the front's."""
    face = visual(roughness=0.4, anisotropy_value=1.0, anisotropy_rotation=0.125, basecolor=(0, 0, 0))
    plain_face = visual(roughness=0.4, basecolor=(0, 0, 0))
    step = math.sin(0.5) / math.sqrt(2)
    lights = np.array([[step, step, math.cos(0.5)], [-step, step, math.cos(0.5)]])
    front = value(material(face, plain_face), lights, np.repeat(UP, 2, 0))[:, 0]
    back = value(material(plain_face, face), lights * [1, 1, -1], np.repeat(DOWN, 2, 0))[:, 0]
    assert front[0] > 3 * front[1]
    assert back == pytest.approx(front[::-1], rel=1e-3)


def test_far_away_it_is_the_mean() -> None:
    """A footprint over the whole picture reads the one texel of the coarsest level."""
    found = value(striped(), UP, UP, (3, 3), side=40.0)[0]
    # 1/4 · 1 green, 3/4 · 1/3 red; Burley's diffuse is 1/π at normal incidence.
    assert found * math.pi == pytest.approx([0.25, 0.25, 0], abs=0.02)


def test_normals_that_differ_widen_highlights() -> None:
    rng = np.random.default_rng(5)
    slopes = 0.3 * rng.normal(size=(64, 64, 2))
    normal = np.concatenate([slopes, np.ones((64, 64, 1))], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    texture = {"scale": 1, "image": image("n.png", width=8.0)}
    bumpy = material(
        visual(
            roughness=0.3,
            basecolor=(0, 0, 0),
            normal={"constant": {"x": 0, "y": 0, "z": 1}, "texture": texture},
        ),
        n=png(np.rint(127.5 + 127.5 * normal)),
    )
    angles = np.linspace(-1.2, 1.2, 41)
    light = np.stack([np.sin(angles), 0 * angles, np.cos(angles)], axis=-1)
    view = np.repeat(UP, len(angles), 0)
    far = value(bumpy, light, view, (3, 3), side=40.0)[:, 0]
    places = 8 * rng.uniform(size=(2, 4000))
    each = value(bumpy, np.repeat(light, 4000, 0), np.repeat(view, 4000, 0), np.tile(places, 41))[:, 0]
    near = each.reshape(41, 4000).mean(1)
    plain = value(material(visual(roughness=0.3, basecolor=(0, 0, 0))), light, view)[:, 0]
    # The mean of many highlights: without widening the peak would be four times as high.
    assert plain.max() > 2.5 * near.max()
    assert far == pytest.approx(near, rel=0.3, abs=float(0.08 * near.max()))


def test_maps_of_other_sizes_share_a_grid() -> None:
    """Roughness repeats three times along the colour, and is half as fine."""
    rough = np.zeros((2, 1, 3), np.uint8)
    rough[0] = 255
    texture = {"factor": 1, "offset": 0, "image": image("r.png", width=4.0, height=8.0)}
    white = {"r": 1, "g": 1, "b": 1}
    colour = {"mode": "multiply", "factor": white, "image": image("a.png")}
    made = material(
        visual(
            basecolor={"constant": white, "texture": colour}, roughness={"constant": 0.5, "texture": texture}
        ),
        a=png(STRIPES),
        r=png(rough),
    )
    maps = FaceMaps.of(made.faces[0])
    assert maps.levels[0].shape[:2] == (4, 6)
    assert maps.levels[0][..., 7].mean() == pytest.approx(0.5)
    # The upper half, which comes last.
    assert (maps.levels[0][2:, :, 7].mean(1) > maps.levels[0][:2, :, 7].mean(1)).all()


def test_means_of_parts_of_texels_keep_the_mean() -> None:
    values = np.random.default_rng(6).uniform(size=(7, 5, 2)).astype(np.float32)
    for count in (1, 2, 3, 4, 7):
        assert averaged(values, count, 0).mean(0) == pytest.approx(values.mean(0), abs=1e-6)
    assert averaged(values, 7, 0) == pytest.approx(values, abs=1e-6)


def test_a_mirrored_map_doubles_the_repeat_of_its_face() -> None:
    texture = {"factor": 1, "offset": 0, "image": image("a.png", mode="mirror_y")}
    white = {"r": 1, "g": 1, "b": 1}
    colour = {"mode": "multiply", "factor": white, "image": image("a.png")}
    face = visual(basecolor={"constant": white, "texture": colour}, alpha={"constant": 1, "texture": texture})
    maps = FaceMaps.of(material(face, a=png(STRIPES)).faces[0])
    assert maps.size_mm == (12.0, 16.0)
    assert maps.levels[0].shape[:2] == (8, 6)


def test_maps_that_do_not_fit_are_said() -> None:
    texture = {"factor": 1, "offset": 0, "image": image("a.png", width=5.0)}
    white = {"r": 1, "g": 1, "b": 1}
    colour = {"mode": "multiply", "factor": white, "image": image("a.png")}
    face = visual(basecolor={"constant": white, "texture": colour}, alpha={"constant": 1, "texture": texture})
    with pytest.warns(LoomlightWarning, match="Its map alpha repeats every 5 × 8 mm"):
        FaceMaps.of(material(face, a=png(STRIPES)).faces[0])
