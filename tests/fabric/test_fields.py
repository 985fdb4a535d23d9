"""Fields of a fabric file arrive in the layout and the appearance, in their units.

Covers: fabric/colour.py, fabric/resolve.py, fabric/fabric.py, fabric/fields.py
Covers: fabric/read.py, fabric/resolve.py, fabric/fields.py
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.resolve import ROUGHNESS
from loomlight.scattering.albedo import LayerBound, layer_albedo_bound
from loomlight.scattering.fibre import cloth_layer_bound
from loomlight.weave.wif_writer import write_wif


def test_a_name_alone_is_a_fabric() -> None:
    fabric = fabric_from_text("twill 3/1")
    assert fabric.draft.drawdown.shape == (4, 4)
    assert fabric.repeat_mm == pytest.approx((2.0, 2.0))  # 20 threads/cm
    assert fabric.layout().warp.width == pytest.approx(np.full(4, 0.4))  # gap 0.2
    assert fabric.name == "twill 3/1"


@given(ends=st.floats(0.1, 1000), picks=st.floats(0.1, 1000))
def test_threads_per_cm_are_spacing(ends: float, picks: float) -> None:
    fabric = fabric_from_text(f'weave = "plain"\nends_per_cm = {ends!r}\npicks_per_cm = {picks!r}')
    assert fabric.repeat_mm == pytest.approx((20 / ends, 20 / picks))


def test_threads_per_inch() -> None:
    fabric = fabric_from_text('weave = "plain"\nepi = 50.8\nppi = 25.4')
    assert fabric.repeat_mm == pytest.approx((1.0, 2.0))


def test_one_density_serves_both_ways() -> None:
    assert fabric_from_text('weave = "plain"\npicks_per_cm = 10').repeat_mm == pytest.approx((2.0, 2.0))


def test_gap_and_its_overrides() -> None:
    fabric = fabric_from_text('weave = "plain"\nends_per_cm = 10\ngap = 0.5\n[weft]\ngap = 0.1')
    assert fabric.layout().warp.width == pytest.approx(np.full(2, 0.5))
    assert fabric.layout().weft.width == pytest.approx(np.full(2, 0.9))
    fabric = fabric_from_text('weave = "plain"\nends_per_cm = 10\ngap = 0.5\n[warp]\nwidth_mm = 0.3')
    assert fabric.layout().warp.width == pytest.approx(np.full(2, 0.3))


def test_angles_are_degrees() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\ninclination_deg = 30\ntwist_deg = -45')
    assert fabric.layout().warp.inclination == pytest.approx(math.pi / 6)
    assert fabric.layout().warp.twist == pytest.approx(-math.pi / 4)


def test_scattering_reaches_the_appearance() -> None:
    appearance = fabric_from_text(
        'weave = "plain"\ndiffuse_blend = 0.25\noptical_depth = 3\n[warp]\nroughness = 0.7\n'
        "[sheen]\nstrength = 0.3\n[variation]\nfibre_noise = 0.2\ncolour_noise = 0.1\nseed = 4294967295"
    ).appearance()
    assert (appearance.diffuse_blend, appearance.optical_depth) == (0.25, 3)
    assert appearance.warp.roughness == 0.7
    assert (appearance.sheen.strength, appearance.sheen.roughness) == (0.3, 0.4)
    variation = appearance.variation
    assert (variation.fibre_noise, variation.colour_noise, variation.seed) == (0.2, 0.1, 2**32 - 1)


def test_hex_colours_become_linear() -> None:
    text = 'weave = "plain"\n[warp]\ncolor = "#804020"\n[weft]\ncolor = [0.1, 0.2, 0.3]'
    draft = fabric_from_text(text).draft
    linear = srgb_to_linear(np.array([0x80, 0x40, 0x20]) / 255)
    np.testing.assert_allclose(draft.warp.colors, np.tile(linear, (2, 1)))
    np.testing.assert_allclose(draft.weft.colors, np.tile([0.1, 0.2, 0.3], (2, 1)))


def test_a_list_of_colours_is_in_thread_order_and_lengthens_the_repeat() -> None:
    fabric = fabric_from_text('weave = "twill 2/2"\n[warp]\ncolor = ["#f00", "#0f0", "#00f"]')
    assert (fabric.draft.ends, fabric.draft.picks) == (12, 4)
    np.testing.assert_array_equal(fabric.draft.warp.colors, np.tile(np.eye(3), (4, 1)))
    assert fabric.appearance().warp.diffuse_reflect.shape == (12, 3)
    assert fabric.appearance().weft.diffuse_reflect.shape == (4, 3)
    np.testing.assert_array_equal(fabric.draft.drawdown[:, :4], fabric.draft.drawdown[:, 8:])


def test_a_list_of_colours_follows_the_order_of_a_colour_effect() -> None:
    fabric = fabric_from_text('weave = "houndstooth 4"\n[warp]\ncolor = ["#f00", "#00f"]')
    assert fabric.draft.ends == 8
    np.testing.assert_array_equal(fabric.draft.warp.colors, np.repeat(np.eye(3)[[0, 2]], 4, axis=0))


def test_a_longer_list_is_in_thread_order() -> None:
    fabric = fabric_from_text('weave = "houndstooth 4"\n[weft]\ncolor = ["#f00", "#00f", "#0f0", "#fff"]')
    assert fabric.draft.picks == 8
    assert fabric.draft.weft.colors is not None
    np.testing.assert_array_equal(fabric.draft.weft.colors[1:3], np.eye(3)[[2, 1]])


def test_a_family_of_one_colour_has_no_order() -> None:
    fabric = fabric_from_text('weave = "denim"\n[weft]\ncolor = ["#f00", "#00f"]')
    np.testing.assert_array_equal(fabric.draft.weft.colors, np.tile(np.eye(3)[[0, 2]], (2, 1)))


def test_a_list_shorter_than_the_order_is_refused(tmp_path: Path) -> None:
    draft = fabric_from_text('weave = "plain"\n[warp]\ncolor = ["#f00", "#0f0", "#00f"]').draft
    write_wif(draft, tmp_path / "three.wif")
    (tmp_path / "two.toml").write_text('draft = "three.wif"\n[warp]\ncolor = ["#111", "#eee"]')
    with pytest.raises(InputError, match=r"warp.color has 2 colours.*uses 3"):
        load_fabric(tmp_path / "two.toml")


@pytest.mark.parametrize(
    ("weave", "warp", "weft"),
    [
        ("plain", (22, 0), (16, 0)),
        ("basket 2/2", (22, 0), (16, 0)),
        ("warp rib 2/2", (22, 0), (16, 0)),
        ("twill 3/1", (24, -30), (24, -30)),
        ("twill 2/2", (24, -30), (24, -30)),
        ("herringbone", (24, -30), (24, -30)),
        ("satin 5/2", (60, 0), (35, 0)),
        ("satin 8/3", (60, 0), (35, 0)),
        ("satin 16/5", (60, 0), (35, 0)),
        ("sateen 8/3", (35, 0), (60, 0)),
    ],
)
def test_bends_follow_the_structure(weave: str, warp: tuple[float, float], weft: tuple[float, float]) -> None:
    layout = fabric_from_text(weave).layout()
    for family, expected in ((layout.warp, warp), (layout.weft, weft)):
        actual = (math.degrees(family.inclination), math.degrees(family.twist))
        assert actual == pytest.approx(expected)


@pytest.mark.filterwarnings("ignore:.*out of reach")
@settings(max_examples=60)
@given(
    color=st.tuples(*[st.integers(0, 255)] * 3),
    specular=st.floats(0, 1),
    translucency=st.floats(0, 1),
    tint=st.none() | st.tuples(*[st.integers(0, 255)] * 3),
)
def test_no_file_creates_energy(
    color: tuple[int, int, int],
    specular: float,
    translucency: float,
    tint: tuple[int, int, int] | None,
) -> None:
    text = f'weave = "plain"\n[warp]\ncolor = "#{bytes(color).hex()}"\nspecular = {specular!r}\n'
    text += f"translucency = {translucency!r}\n"
    text += "" if tint is None else f'specular_tint = "#{bytes(tint).hex()}"\n'
    bounds = {"true": cloth_layer_bound(ROUGHNESS, 2.0), "false": LayerBound(layer_albedo_bound(2.0))}
    for light, bound in bounds.items():
        family = fabric_from_text(f"interreflection = {light}\n{text}").appearance().warp
        sent = family.diffuse_reflect + family.diffuse_transmit
        assert (sent + bound.taken(family.specular_reflect, family.specular_transmit)).max() <= 1 + 1e-9
        assert min(sent.min(), family.specular_reflect.min(), family.specular_transmit.min()) >= 0


def test_explicit_albedos_are_used_as_they_are() -> None:
    text = 'weave = "plain"\n[warp]\ndiffuse_reflect = [0.1, 0.2, 0.3]\nspecular_transmit = [0.4, 0.3, 0.2]'
    family = fabric_from_text(text).appearance().warp
    np.testing.assert_allclose(family.diffuse_reflect, np.tile([0.1, 0.2, 0.3], (2, 1)))
    np.testing.assert_allclose(family.specular_transmit, np.tile([0.4, 0.3, 0.2], (2, 1)))


def test_explicit_albedos_cannot_create_energy() -> None:
    text = 'weave = "plain"\n[weft]\ndiffuse_reflect = [0.7, 0.7, 0.7]\nspecular_reflect = [0.1, 0.1, 0.9]'
    with pytest.raises(InputError, match="weft"):
        fabric_from_text(text)


def test_switches_survive_writing() -> None:
    """TOML writes true, not True."""
    fabric = fabric_from_text('weave = "satin 5"\ninterreflection = false')
    assert "interreflection = false" in fabric.to_toml()
    assert fabric_from_text(fabric.to_toml()).fields == fabric.fields


def test_colours_are_written_as_runs_of_threads() -> None:
    short = fabric_from_text('weave = "plain"\nwarp.color = "3 #223355, 1 x #eeeeee, lab(52, -10, 30)"')
    long = fabric_from_text(
        'weave = "plain"\nwarp.color = ["#223355", "#223355", "#223355", "#eeeeee", "lab(52 -10 30)"]'
    )
    assert short.draft.warp.colors is not None
    np.testing.assert_array_equal(short.draft.warp.colors, long.draft.warp.colors)
    # The file says what it said.
    assert '"3 #223355, 1 x #eeeeee' in short.to_toml()


@pytest.mark.parametrize(
    ("colour", "says"),
    [
        ('"0 #fff, 2 #000"', "a run of 0 threads"),
        ('"9000 #fff, 9000 #000"', "more than 16384 threads"),
        ('"3 #ffff, 2 #000"', '"#ffff" is no colour'),
        ('"3 #fff, blue"', "is no colour"),
    ],
)
def test_runs_that_are_none_end_in_one_sentence(colour: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as caught:
        fabric_from_text(f'weave = "plain"\nwarp.color = {colour}')
    assert "warp.color" in str(caught.value)
