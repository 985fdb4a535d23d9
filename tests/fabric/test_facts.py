"""Cover, weight and thickness of cloth, against cloths whose numbers are known."""

from __future__ import annotations

import math

import pytest

from loomlight.cli.main import run
from loomlight.fabric.facts import cloth_facts, facts_text, three_digits
from loomlight.fabric.read import fabric_from_text
from loomlight.weave.textile import yarn_diameter_mm

# Measured in Fibres and Textiles 1/2018: one pair of yarns, 36.9 tex in the warp and 28.27 in the weft.
MEASURED_MM = {
    "plain": 0.48,
    "twill 2/2": 0.53,
    "twill 3/1": 0.50,
    "basket 2/2": 0.60,
    "weft rib 2/2": 0.46,
}


STRIPED = 'weave = "twill 3/1"\nends_per_cm = 28\nwarp.color = "5 #223355, 2 #ffffff"\n'


def pair_of_yarns(weave: str) -> str:
    """The sett is not published: one of shirtings of such yarns."""
    counts = '[warp]\ncount = "36.9 tex"\n[weft]\ncount = "28.27 tex"\n'
    return f'weave = "{weave}"\nends_per_cm = 22\npicks_per_cm = 20\n{counts}'


def test_plain_cloth_by_hand() -> None:
    facts = cloth_facts(fabric_from_text(pair_of_yarns("plain")))
    thick, thin = yarn_diameter_mm("36.9 tex"), yarn_diameter_mm("28.27 tex")
    height = (thick + thin) / 2
    # Every crossing is a change of face.
    warp_crimp, weft_crimp = 9 / 16 * (height / 0.5) ** 2, 9 / 16 * (height / (1 / 2.2)) ** 2
    assert facts.warp.crimp == pytest.approx(warp_crimp)
    assert facts.weft.crimp == pytest.approx(weft_crimp)
    assert facts.weight == pytest.approx(2.2 * 36.9 * (1 + warp_crimp) + 2 * 28.27 * (1 + weft_crimp))
    assert facts.warp.cover == pytest.approx(2.2 * thick)
    assert facts.cover == pytest.approx(1 - (1 - 2.2 * thick) * (1 - 2 * thin))


def test_yarn_crimps_less_where_it_floats() -> None:
    plain, twill, basket = (
        cloth_facts(fabric_from_text(pair_of_yarns(weave))) for weave in ("plain", "twill 2/2", "basket 2/2")
    )
    # Half as many changes a thread.
    assert twill.warp.crimp == pytest.approx(plain.warp.crimp / 2)
    assert basket.weft.crimp == pytest.approx(plain.weft.crimp / 2)


def test_the_tex_of_a_width_is_that_of_the_count_that_gives_it() -> None:
    width = yarn_diameter_mm("30 tex")
    given = fabric_from_text(f'weave = "plain"\n[warp]\nwidth_mm = {width}\n[weft]\ncount = "30 tex"\n')
    facts = cloth_facts(given)
    assert facts.warp.tex == pytest.approx(30)
    assert not facts.counted
    assert facts.weft.tex == 30


@pytest.mark.parametrize(("weave", "measured"), MEASURED_MM.items())
def test_thickness_of_measured_cloth(weave: str, measured: float) -> None:
    """Round yarns at rest have one thickness in every weave, which is 4 to 27 % less (docs/drafts.md)."""
    facts = cloth_facts(fabric_from_text(pair_of_yarns(weave)))
    assert facts.thickness_mm < measured
    assert math.isclose(facts.thickness_mm, measured, rel_tol=0.3), facts


def test_denim_weighs_what_its_file_says(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["weave", "info", "examples/denim.toml"]) == 0
    text = capsys.readouterr().out
    assert "longest floats" in text
    weight = float(text.split("weight: about ")[1].split()[0])
    # "of 12 oz": ounces a square yard, of 33.9 g/m² each.
    assert 11 < weight / 33.9 < 13


def test_a_weave_without_cloth_has_no_weight(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["weave", "info", "twill 2/2"]) == 0
    assert "weight" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("value", "text"), [(2056.2, "2060"), (82.06, "82.1"), (0.4333, "0.433"), (12.0, "12")]
)
def test_numbers_have_three_digits_and_no_exponent(value: float, text: str) -> None:
    assert three_digits(value) == text


def test_sett_and_repeat_are_those_of_the_fabric() -> None:
    """Twenty-eight ends: seven of the order of colours by four of the weave."""
    text = facts_text(fabric_from_text(STRIPED))
    assert "sett: 28 ends/cm (71.1 epi), 28 picks/cm (71.1 ppi)\n" in text
    assert "repeat: 28 ends and 4 picks, 10 × 1.43 mm, of which the weave is 4 and 4\n" in text
    plain = facts_text(fabric_from_text('weave = "plain"\nends_per_cm = 28'))
    assert "repeat: 2 ends and 2 picks, 0.714 × 0.714 mm\n" in plain
