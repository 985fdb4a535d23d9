"""Maps over a surface: what they may change, and the variants and shares that pictures make."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.colour import TRACE, absorption, faded
from loomlight.fabric.fields import MapTable
from loomlight.fabric.read import edited_fabric, fabric_from_fields
from loomlight.fabric.resolve import NEP_COLOUR
from loomlight.fabric.surface_maps import Painting, painting_of, print_on_uv, with_maps, without_maps


def picture(folder: Path, rows: object, mode: str = "L") -> str:
    path = folder / f"{mode}{abs(hash(str(rows)))}.png"
    Image.fromarray(np.array(rows, np.uint8), mode).save(path)
    return str(path)


def painted(text: str, maps: dict[str, object], folder: Path) -> Painting:
    found = painting_of(with_maps(fabric_from_text(f'weave = "twill 3/1"\n{text}', folder), maps))
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("[maps]\nglitter = 'a.png'", "maps.glitter is nothing that a picture can change"),
        ("[maps]\nplies = 'a.png'", "maps.plies is nothing that a picture can change"),
        (
            "[maps]\nwear = 1",
            'maps.wear = 1 cannot be used: write the path of a picture, "FILE.png", or a table.',
        ),
        ("[maps.wear]\nlow = 1", 'maps.wear names no picture: write picture = "FILE.png".'),
        ("[maps.wear]\npicture = 'a.png'\nmode = 'ad'", 'maps.wear.mode = "ad" does not exist'),
        (
            "[maps.wear]\npicture = 'a.png'\nwide = 1",
            '"wide" is no field that a map has: ',
        ),
        ("[maps.wear]\npicture = 'a.png'\nat_mm = [0, 1]", "write width_mm too"),
        ("[maps.wear]\npicture = 'a.png'\nuv = 'uv1'\nside = 'front'", "both say where the picture lies"),
        ("[maps.wear]\npicture = 'a.png'\nfabrics = ['a']", "goes with the map fabric alone"),
        ("[maps.fabric]\npicture = 'a.png'", 'write fabrics = ["FILE.toml"]'),
        ("[maps.color]\npicture = 'a.png'\nlow = 0.1", "maps.color.low goes with maps of numbers"),
    ],
)
def test_what_is_no_map_is_refused_in_a_sentence(text: str, expected: str) -> None:
    with pytest.raises(InputError) as fault:
        fabric_from_text(f'weave = "plain"\n{text}')
    assert expected in str(fault.value)


def test_pictures_that_cannot_be_read_name_their_map(tmp_path: Path) -> None:
    fabric = fabric_from_text('weave = "plain"\nmaps.wear = "none.png"', tmp_path)
    with pytest.raises(InputError, match=r'maps\.wear\.picture = "none\.png": .*none\.png'):
        painting_of(fabric)


def test_a_picture_of_few_greys_makes_a_variant_of_each(tmp_path: Path) -> None:
    maps = {"wear": picture(tmp_path, [[0, 51], [51, 255]])}
    found = painted("", maps, tmp_path)
    assert [variant.resolved.wear for variant in found.variants] == pytest.approx([0, 0.2, 1])
    np.testing.assert_allclose(found.axes[0].shares[..., 1], [[0, 1], [1, 0]], atol=1e-9)


def test_shares_of_many_greys_give_back_the_number(tmp_path: Path) -> None:
    """Mixtures of variants have the mean of what the picture says, at each of its texels."""
    ramp = np.linspace(30, 200, 64).round().reshape(8, 8)
    found = painted(
        "", {"warp.roughness": {"picture": picture(tmp_path, ramp), "low": 0.1, "high": 0.9}}, tmp_path
    )
    levels = np.array([variant.resolved.warp.roughness for variant in found.variants])
    np.testing.assert_allclose(found.axes[0].shares @ levels, 0.1 + 0.8 * ramp / 255, atol=1e-6)
    assert {variant.resolved.weft.roughness for variant in found.variants} == {0.3}


def test_transparent_places_keep_the_fabrics_own_number(tmp_path: Path) -> None:
    rows = [[[255, 255, 255, 255], [255, 255, 255, 0]]]
    found = painted("gap = 0.2", {"gap": {"picture": picture(tmp_path, rows, "RGBA"), "high": 0.5}}, tmp_path)
    own, white = (
        variant.layout().warp.width[0] / variant.layout().warp.spacing[0] for variant in found.variants
    )
    assert (own, white) == pytest.approx((0.8, 0.5))
    np.testing.assert_allclose(found.axes[0].shares, [[[0, 1], [1, 0]]], atol=1e-9)


def test_numbers_are_multiplied_within_their_range(tmp_path: Path) -> None:
    given = {"picture": picture(tmp_path, [[0, 255]]), "mode": "multiply", "low": 0.5, "high": 9}
    found = painted("warp.roughness = 0.4\nweft.roughness = 0.1", {"roughness": given}, tmp_path)
    roughness = [(each.resolved.warp.roughness, each.resolved.weft.roughness) for each in found.variants]
    np.testing.assert_allclose(roughness, [(0.2, 0.05), (1.0, 0.9)])


def test_a_number_beyond_its_range_is_refused(tmp_path: Path) -> None:
    given = {"picture": picture(tmp_path, [[0, 255]]), "high": 2}
    with pytest.raises(InputError, match=r"places of warp\.roughness = 2, and 0\.01 to 1 can be"):
        painted("", {"roughness": {**given, "low": 0.1}}, tmp_path)


def test_widths_take_the_place_of_gaps(tmp_path: Path) -> None:
    found = painted(
        "warp.width_mm = 0.2", {"warp.gap": {"picture": picture(tmp_path, [[255]]), "high": 0.5}}, tmp_path
    )
    (only,) = found.variants
    assert only.layout().warp.width[0] == pytest.approx(0.5 * only.layout().warp.spacing[0])


def test_maps_together_make_all_combinations(tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text('weave = "plain"')
    halves = picture(tmp_path, [[0, 255]])
    maps = {"wear": halves, "fabric": {"picture": halves, "fabrics": [str(tmp_path / "other.toml")]}}
    found = painted("", maps, tmp_path)
    facts = [(each.draft.ends, each.resolved.wear) for each in found.variants]
    assert facts == [(4, 0), (2, 0), (4, 1), (2, 1)]
    ramp = picture(tmp_path, [list(range(0, 250, 25))])
    with pytest.raises(InputError, match="together make 64 variants"):
        painted("", {"wear": ramp, "gap": ramp, "roughness": {"picture": ramp, "low": 0.1}}, tmp_path)


@pytest.mark.parametrize("interreflection", ["true", "false"])
def test_a_print_that_replaces_is_dyed_cloth(interreflection: str, tmp_path: Path) -> None:
    """Albedos of undyed yarns times the tint are those of yarns of the picture's colour."""
    text = f"interreflection = {interreflection}\nwarp.color = '#203060'\nweft.color = '#102030'"
    given = {"picture": picture(tmp_path, [[[180, 90, 40]]], "RGB"), "mode": "replace"}
    found = painted(text, {"color": given}, tmp_path)
    dyed = edited_fabric(found.variants[0], {f"{name}.albedo": None for name in ("warp", "weft")})
    dyed = edited_fabric(dyed, {f"{name}.color": "#b45a28" for name in ("warp", "weft")}).appearance()
    white = found.variants[0].appearance()
    for tint in found.tints:
        own, wanted = (getattr(each, tint.family).diffuse_reflect[0] for each in (white, dyed))
        # The curve is interpolated between 129 greys.
        np.testing.assert_allclose(own * tint.picture[0, 0], wanted, rtol=0.01, atol=2e-4)


def test_windows_show_what_multiplies_on_the_meshs_uv(tmp_path: Path) -> None:
    fabric = with_maps(
        fabric_from_text('weave = "plain"'), {"color": picture(tmp_path, [[[255, 0, 0]]], "RGB")}
    )
    shown = print_on_uv(fabric)
    assert shown is not None
    np.testing.assert_allclose(shown[0, 0], [1, 0, 0])
    for place in ({"side": "front"}, {"width_mm": 10}, {"uv": "uv1"}, {"mode": "replace"}):
        maps = {"color": {"picture": picture(tmp_path, [[[255, 0, 0]]], "RGB")} | place}
        assert print_on_uv(with_maps(fabric_from_text('weave = "plain"'), maps)) is None


def test_what_cannot_show_maps_says_so(tmp_path: Path) -> None:
    fabric = with_maps(fabric_from_text('weave = "plain"'), {"wear": picture(tmp_path, [[9]])})
    with pytest.warns(LoomlightWarning, match="without its maps of wear"):
        assert not without_maps(fabric, "A window").fields.maps


def test_files_keep_maps_relative_to_where_they_are_written(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    text = (
        'weave = "plain"\n[maps.warp]\nroughness = { picture = "p.png", low = 0.1 }\n'
        '[maps.fabric]\npicture = "q.png"\nfabrics = ["x.toml"]'
    )
    fabric = fabric_from_text(text, tmp_path)
    again = fabric_from_text(fabric.to_toml(tmp_path / "a"), tmp_path / "a")
    maps = again.fields.maps
    assert (maps["warp.roughness"].picture, maps["fabric"].fabrics) == ("../p.png", ["../x.toml"])
    assert fabric_from_text(fabric.to_toml(), tmp_path).fields == fabric.fields


def test_dye_fades_in_even_steps_and_a_trace_stays() -> None:
    colours = np.array([[0.02, 0.04, 0.2], [0.5, 0.5, 0.5]])
    undyed = absorption(parse_colour(NEP_COLOUR, ""))
    dye = absorption(colours) - undyed
    np.testing.assert_allclose(absorption(faded(colours, 1.0)) - undyed, TRACE * dye)
    steps = np.diff([faded(colours, share)[0].mean() for share in np.linspace(0, 1, 5)])
    assert (steps > 0).all()
    # K/S alone in proportion would put nearly all of it into the last step.
    assert steps.max() < 3 * steps.min()
    np.testing.assert_array_equal(faded(colours, 0.0), colours)


def test_the_family_on_the_face_is_rubbed_first() -> None:
    def worn(weave: str) -> tuple[float, float]:
        fabric: Fabric = fabric_from_text(f'weave = "{weave}"\nwear = 0.6')
        return fabric.resolved.warp.worn, fabric.resolved.weft.worn

    assert worn("twill 3/1") == pytest.approx((0.6, 0.2))
    assert worn("twill 1/3") == pytest.approx((0.2, 0.6))
    assert worn("plain") == pytest.approx((0.6, 0.6))


_NAMES = ["color", "wear", "gap", "warp.roughness", "fabric", "sheen.strength", "plies", "x", ""]
_ODD = st.one_of(
    st.sampled_from([None, True, 3, float("nan"), -1.5, [], [0, 1], ["a.toml"], "front", "multiply"]),
    st.text(max_size=8),
)
_TABLES = st.dictionaries(st.sampled_from([*MapTable.model_fields, "odd"]), _ODD, max_size=4)


@settings(max_examples=150, deadline=None)
@given(st.dictionaries(st.sampled_from(_NAMES), st.one_of(_ODD, _TABLES), max_size=3))
def test_odd_maps_are_read_or_refused_in_a_sentence(maps: dict[str, Any]) -> None:
    sentence = "It is read."
    try:
        fabric_from_fields({"weave": "plain", "maps": maps})
    except InputError as fault:
        sentence = str(fault)
    assert sentence.endswith((".", "?"))
    assert "\n" not in sentence
