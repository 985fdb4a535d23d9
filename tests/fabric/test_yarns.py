"""Kinds of yarn give defaults that fields of the file override, and yarns of a count their fibre's width.

Covers: fabric/yarns.py
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from loomlight.fabric import fabric_from_text
from loomlight.fabric.facts import cloth_facts
from loomlight.fabric.fields import YARNS
from loomlight.fabric.yarns import PRESETS
from loomlight.scattering.appearance import Irregularity
from loomlight.weave.textile import yarn_diameter_mm

ROOT = Path(__file__).parents[2]


def test_a_file_without_yarns_shows_no_detail() -> None:
    appearance = fabric_from_text("twill 2/2").appearance()
    assert not appearance.warp.detail.is_on
    assert not appearance.weft.detail.is_on


@pytest.mark.parametrize("name", YARNS)
def test_a_kind_of_yarn_is_what_its_fields_say(name: str) -> None:
    """The same fields written out make the same fabric."""
    by_name = fabric_from_text(f'weave = "twill 2/2"\nyarn = "{name}"')
    fields = PRESETS[name].fields.model_dump(exclude_none=True)
    lines = "".join(f"{field} = {value}\n" for field, value in fields.items())
    head = f'weave = "twill 2/2"\ngap = {PRESETS[name].gap}\n'
    written = fabric_from_text(f"{head}[warp]\n{lines}[weft]\n{lines}")
    for family in ("warp", "weft"):
        named, other = (getattr(fabric.appearance(), family) for fabric in (by_name, written))
        assert named.detail == other.detail
        assert named.detail.is_on
        assert named.roughness == other.roughness == fields["roughness"]
        assert (named.specular_reflect == other.specular_reflect).all()
        named, other = (getattr(fabric.layout(), family) for fabric in (by_name, written))
        assert named.twist == other.twist
        assert (named.width == other.width).all()


def _irregularity(text: str) -> Irregularity:
    return fabric_from_text(f'weave = "plain"\n{text}').appearance().warp.irregularity


def test_a_yarn_without_a_name_is_even() -> None:
    assert _irregularity("warp.slub = 0.5\nvariation.irregularity = 2") == Irregularity()


def test_each_number_of_uneven_yarns_has_its_field() -> None:
    """Another default than that of the dataclass for each, and neps in the colour that cloth shows."""
    given = _irregularity(
        "[warp]\nmass_cv = 0.2\nfibre_length_mm = 60\nthick_places = 7\nthick_length_mm = 45\n"
        "thick_size = 1.5\nshade = 0.3\nmelange = 0.4\nneps = 9\nnep_length_mm = 6\n"
        "nep_color = [0.3, 0.1, 0.05]"
    )
    expected = Irregularity(0.2, 60, 7, 45, 1.5, 0.3, 0.4, 9, 6, given.nep_albedo)
    assert given == expected
    red, green, blue = given.nep_albedo
    assert red > green > blue > 0


@pytest.mark.parametrize("head", ["", "interreflection = false\n"])
def test_a_nep_has_the_albedo_of_opaque_yarn_of_its_colour(head: str) -> None:
    yarn = "[warp]\nspecular = 0.2\ntranslucency = {}\ncolor = '#b0392b'\nnep_color = '#b0392b'\nneps = 3\n"
    with_neps, opaque = (
        fabric_from_text(f'{head}weave = "plain"\n{yarn.format(share)}').appearance().warp
        for share in (0.3, 0)
    )
    assert with_neps.irregularity.nep_albedo == pytest.approx(tuple(opaque.diffuse_reflect[0]), abs=1e-9)


@pytest.mark.parametrize("name", YARNS)
def test_no_irregularity_is_even_cloth(name: str) -> None:
    fabric = fabric_from_text(f'weave = "plain"\nyarn = "{name}"\nvariation.irregularity = 0')
    assert not fabric.appearance().is_irregular
    assert fabric.appearance().warp.irregularity == Irregularity()


def test_irregularity_scales_amounts_and_leaves_lengths() -> None:
    usual, twice = (
        _irregularity(f'yarn = "dupion silk"\nwarp.neps = 3\nvariation.irregularity = {amount}')
        for amount in (1, 2)
    )
    assert twice == replace(
        usual,
        mass_cv=2 * usual.mass_cv,
        thick_places=2 * usual.thick_places,
        shade=2 * usual.shade,
        neps=2 * usual.neps,
    )


def test_kinds_are_as_even_as_mills_spin_them() -> None:
    """Uster statistics: filament before combed, combed before carded, carded before woollen and flax."""
    cv = {name: PRESETS[name].fields.mass_cv or 0.0 for name in YARNS}
    order = ("filament polyester", "silk", "combed cotton", "cotton", "woollen", "linen")
    found = [cv[name] for name in order]
    assert found == sorted(found)
    assert len(set(found)) == len(found)


def test_fields_of_the_file_come_first() -> None:
    text = 'weave = "plain"\nyarn = "wool"\n[warp]\nroughness = 0.3\nplies = 3\n[weft]\nyarn = "Silk"\n'
    fabric = fabric_from_text(text)
    warp, weft = fabric.appearance().warp, fabric.appearance().weft
    assert (warp.roughness, warp.detail.plies) == (0.3, 3)
    assert warp.detail.hairiness == PRESETS["wool"].fields.hairiness
    assert weft.roughness == PRESETS["silk"].fields.roughness
    assert weft.detail.hairiness == 0
    # What is written again says no more than the file did.
    assert "hairiness" not in fabric.to_toml()
    assert 'yarn = "wool"' in fabric.to_toml()


def test_angles_and_widths_reach_the_detail() -> None:
    warp = "[warp]\ntwist_deg = -10\nplies = 2\nfibre_tilt_deg = 6\n"
    detail = (
        fabric_from_text(f'weave = "plain"\nends_per_cm = 10\ngap = 0.25\n{warp}').appearance().warp.detail
    )
    assert detail.twist == pytest.approx(math.radians(-10))
    assert detail.ply_twist == pytest.approx(math.radians(24))
    assert detail.fibre_tilt == pytest.approx(math.radians(6))
    assert detail.width == pytest.approx(0.75)


def test_wool_of_a_count_is_wider_than_cotton() -> None:
    cotton, wool = (
        _warp_width(f'ends_per_cm = 50\n[warp]\nyarn = "{name}"\ncount = "30 tex"')
        for name in ("cotton", "wool")
    )
    assert cotton == pytest.approx(yarn_diameter_mm("30 tex"))
    assert wool == pytest.approx(cotton * math.sqrt(1.52 * 0.6 / (1.31 * 0.45)))


def _warp_width(text: str) -> float:
    return float(fabric_from_text(f'weave = "plain"\n{text}').layout().warp.width[0])


@pytest.mark.parametrize(
    ("text", "width_mm"),
    [
        ("", 0.4),  # no kind, no gap
        ('yarn = "wool"', 0.5),
        ('yarn = "silk"', 0.47),
        ('yarn = "wool"\ngap = 0.3', 0.35),
        ('yarn = "wool"\n[warp]\nyarn = "filament polyester"', 0.46),
        ('yarn = "wool"\n[warp]\ngap = 0.25', 0.375),
        ('yarn = "wool"\n[warp]\nwidth_mm = 0.3', 0.3),
    ],
)
def test_yarns_fill_as_their_kind_does(text: str, width_mm: float) -> None:
    """At 20 threads a centimetre, 0.5 mm each."""
    assert _warp_width(text) == pytest.approx(width_mm)


@pytest.mark.parametrize(
    ("ends_per_cm", "width_over_diameter"),
    # 0.52 mm of Nm 8: as wide as it spreads, as the gap of wool lets it, and round where there is no room.
    [(9, 1.6), (14, 10 / 14 / 0.5196), (22, 1)],
)
def test_a_yarn_of_a_count_spreads_where_there_is_room(
    ends_per_cm: float, width_over_diameter: float
) -> None:
    text = f'ends_per_cm = {ends_per_cm}\n[warp]\nyarn = "wool"\ncount = "Nm 8"\n[weft]\ncount = "Nm 8"'
    diameter = yarn_diameter_mm("Nm 8", density=1.31, packing=0.45)
    assert diameter == pytest.approx(0.5196, abs=5e-5)
    assert _warp_width(text) == pytest.approx(width_over_diameter * diameter, rel=1e-4)
    # The weft, of no kind, stays round.
    weft = fabric_from_text(f'weave = "plain"\n{text}').layout().weft.width[0]
    assert weft == pytest.approx(yarn_diameter_mm("Nm 8"))


def test_a_spread_yarn_is_as_flat_as_the_ellipse_of_its_area() -> None:
    both = "".join(f'[{family}]\ncount = "Nm 8"\n' for family in ("warp", "weft"))
    fabric = fabric_from_text(f'weave = "plain"\nends_per_cm = 9\nyarn = "wool"\n{both}')
    assert cloth_facts(fabric).thickness_mm == pytest.approx(2 * 0.5196 / 1.6, rel=1e-4)


def test_a_count_beside_a_gap_weighs() -> None:
    counts = '[warp]\ncount = "40 tex"\n{}[weft]\ncount = "40 tex"\n{}'
    head = 'weave = "plain"\nends_per_cm = 20\npicks_per_cm = 18\n'
    round_, pressed = (fabric_from_text(head + counts.format(gap, gap)) for gap in ("", "gap = 0.1\n"))
    assert pressed.layout().warp.width[0] == pytest.approx(0.45)
    before, after = cloth_facts(round_), cloth_facts(pressed)
    assert after.counted
    assert after.warp.tex == before.warp.tex == 40
    # Straight yarns would weigh 152 g/m²; flat ones crimp less than round ones.
    assert 152 < after.weight < before.weight
    # The ellipse of the same area.
    diameter = yarn_diameter_mm("40 tex")
    weft_mm = diameter**2 / (10 / 18 * 0.9)
    assert after.thickness_mm == pytest.approx((diameter**2 / 0.45 + weft_mm) / 2 + diameter**2 / 0.45)


def test_the_page_of_yarns_lists_their_fields() -> None:
    page = (ROOT / "docs" / "yarns.md").read_text(encoding="utf-8")
    rows = {line.split("|")[1].strip(): line for line in page.splitlines() if line.startswith('| "')}
    for name, yarn in PRESETS.items():
        cells = [cell.strip() for cell in rows[f'"{name}"'].split("|")[2:-1]]
        fields = yarn.fields
        plies = f"{fields.plies} at {fields.ply_twist_deg:g}°" if fields.plies else "1"
        numbers = [fields.specular, fields.roughness, fields.translucency, fields.twist_deg]
        expected = [f"{number:g}" for number in numbers]
        expected += [
            plies,
            *(f"{value or 0:g}" for value in (fields.fibre_tilt_deg, fields.slub, fields.hairiness)),
        ]
        widths = [f"{yarn.gap:g}", f"{yarn.spread:g}"]
        assert cells == [*expected, f"{yarn.density:.2f} × {yarn.packing:g}", *widths], name


def test_the_page_of_uneven_yarns_lists_their_fields() -> None:
    page = (ROOT / "docs" / "uneven-yarns.md").read_text(encoding="utf-8")
    rows = {line.split("|")[1].strip(): line for line in page.splitlines() if line.startswith('| "')}
    for name, yarn in PRESETS.items():
        fields = yarn.fields
        thick = f"{fields.thick_places or 0:g}"
        if fields.thick_places:
            thick += f" of {fields.thick_length_mm:g} mm × {fields.thick_size:g}"
        expected = [f"{fields.mass_cv:g}", f"{fields.fibre_length_mm:g}", thick]
        expected += [f"{value or 0:g}" for value in (fields.shade, fields.melange)]
        assert [cell.strip() for cell in rows[f'"{name}"'].split("|")[2:-1]] == expected, name
