"""Light between yarns: equations against sums of bounces, cloth against paths, colours against themselves.

Covers: scattering/interreflection.py, scattering/openness.py, scattering/appearance.py
Covers: models/between_yarns.py, fabric/colour.py, scattering/point.py
Covers: scattering/albedo.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.llvm import require_llvm
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.colour import colour_for, shown_colour
from loomlight.models.registry import make_model
from loomlight.scattering.interreflection import Scattered, solved_interior
from loomlight.scattering.openness import Openness
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.accuracy.interreflection import direction, fabric_text, sky_value
from studies.accuracy.interreflection_furnace import returned
from studies.instruments.cloth_paths import radiance
from tests.marks import slow

require_llvm()
COLOURS = ("#c03030", "#3050c0")


def cloth(weave: str = "satin 5", colours: tuple[str, str] = COLOURS) -> Fabric:
    return fabric_from_text(fabric_text(weave, colours))


def openness_of(fabric: Fabric) -> Openness:
    openness = fabric.appearance().openness
    assert openness is not None
    return openness


def test_the_solution_is_the_sum_of_all_bounces() -> None:
    """Light of the front's sky is sent on until nothing is left; light that crosses only adds."""
    rng = np.random.default_rng(2)
    opens, meets = rng.uniform(0.2, 0.9, (2, 2)), rng.random((2, 2, 2))
    meets /= meets.sum(axis=2, keepdims=True)
    blocks = rng.random((2, 2))
    blocks /= blocks.sum(axis=1, keepdims=True)
    back = rng.uniform(0.1, 0.6, 2)
    total, sent = np.zeros(2), opens[0] * back
    for _ in range(400):
        total += sent
        sent = (1 - opens[0]) * back * (meets[0] @ sent)
    opaque = solved_interior(Scattered(back[0], 0.0), Scattered(back[1], 0.0), opens, meets, blocks)[0]
    np.testing.assert_allclose([opaque.warp, opaque.weft], total, rtol=1e-9)
    assert opaque.leaked == 0
    front, behind = solved_interior(Scattered(back[0], 0.2), Scattered(back[1], 0.1), opens, meets, blocks)
    assert front.warp > opaque.warp
    assert front.weft > opaque.weft
    assert 0 < behind.leaked < 1


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_yarn_that_loses_nothing_makes_no_light(share: float) -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        opens, meets = rng.uniform(0.05, 1, (2, 2)), rng.random((2, 2, 2))
        meets /= meets.sum(axis=2, keepdims=True)
        blocks = rng.random((2, 2))
        blocks /= blocks.sum(axis=1, keepdims=True)
        yarn = Scattered(1 - share, share)
        front, behind = solved_interior(yarn, yarn, opens, meets, blocks)
        # Radiance 1 of either sky is never exceeded, as in an integrating sphere.
        for near, far in ((front, behind), (behind, front)):
            assert max(near.warp, near.weft, far.leaked) <= 1 + 1e-9


def test_openness_is_shares() -> None:
    openness = openness_of(cloth())
    np.testing.assert_allclose(openness.meets.sum(axis=2), 1)
    np.testing.assert_allclose(openness.blocks.sum(axis=1), 1)
    assert ((openness.interior > 0) & (openness.interior < 1)).all()
    # The long floats of a satin's warp lie open; the weft below them does not.
    assert openness.interior[0, 0] > openness.interior[0, 1]


@pytest.mark.slow
@pytest.mark.parametrize("angle", [slow(8), 55])
def test_cloth_shines_as_paths_through_it_say(angle: float) -> None:
    fabric, view = cloth(), direction(angle, 25)
    truth = radiance(fabric.layout(), fabric.appearance(), view, 1 << 13, 4)
    expected = truth.reflected + truth.transmitted
    point, lobes = (sky_value(make_model(name, fabric), view, 1 << 15, 5) for name in ("point", "lobes"))
    # Four standard errors of the paths, and 4 % for the closed form: docs/research/figures-light.md.
    bar = 4 * truth.error + 0.04 * expected
    assert (abs(point - expected) < bar).all()
    assert (abs(lobes - expected) < bar).all()
    # What is tested is there: a part of the brightest channel is of light that scattered more than once.
    assert truth.once[0] < expected[0] - 4 * truth.error[0]


def test_colours_are_those_that_cloth_shows() -> None:
    fabric = cloth()
    authored = np.array([[0.5, 0.05, 0.03], [0.03, 0.08, 0.5], [0.6, 0.6, 0.6]])
    of_yarn = (0.4, 0.1, openness_of(fabric), 0, 0.3, 2.0)
    found = colour_for(authored, *of_yarn)
    # Twenty halvings leave 1e-6 of the colour that albedos are made of.
    np.testing.assert_allclose(shown_colour(found, *of_yarn), authored, atol=2e-6)
    brighter = colour_for(np.ones((1, 3)), *of_yarn)
    np.testing.assert_allclose(brighter, 1, atol=2e-6)


@pytest.mark.quick("0.4-0.95")
@pytest.mark.parametrize(("specular", "least"), [(0.0, 0.985), (0.4, 0.95), (1.0, 0.88)])
def test_white_cloth_is_white_and_makes_no_light(specular: float, least: float) -> None:
    """The brightest that a fabric file admits, seen from above and at 75°."""
    yarn = f'albedo = "#fff"\nspecular = {specular}\n'
    fabric = fabric_from_text(f'weave = "satin 5"\ninterreflection = true\n[warp]\n{yarn}[weft]\n{yarn}')
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
    above, grazing = (
        returned(model, fabric.repeat_mm, direction(angle, 25), 6, 1 << 15) for angle in (0, 75)
    )
    # 0.01: four standard errors of 2^15 samples, and the fit of openness (docs/research/figures-light.md).
    assert least < above < 1.01
    assert grazing < 1.02


def test_it_is_on_unless_a_file_leaves_it_out() -> None:
    assert fabric_from_text("plain").appearance().openness is not None
    assert fabric_from_text('weave = "plain"\ninterreflection = false').appearance().openness is None
