"""Colours that cloth cannot show, and albedos, of which nothing is promised."""

import warnings

import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric.read import fabric_from_text

SEEN = 'weave = "plain"\ninterreflection = true\n'


def test_albedos_are_no_colours_that_cloth_shows() -> None:
    def red(field: str) -> float:
        fabric = fabric_from_text(SEEN + f"[warp]\n{field} = [0.5, 0.5, 0.5]\nspecular = 0\n")
        return float(fabric.appearance().warp.diffuse_reflect[0, 0])

    # A tenth of the light goes through by default.
    assert red("albedo") == pytest.approx(0.45)
    # Light is lost between yarns, so cloth that shows 0.5 is woven of brighter yarn.
    assert red("color") > 0.5
    with pytest.raises(InputError, match=r"warp\.color and warp\.albedo"):
        fabric_from_text('weave = "plain"\n[warp]\ncolor = "#ffffff"\nalbedo = "#ffffff"\n')


def test_a_colour_out_of_reach_is_told_with_its_difference() -> None:
    with pytest.warns(LoomlightWarning, match=r'warp\.color = "#000000".*CIEDE2000.*darker') as caught:
        fabric_from_text(SEEN + '[warp]\ncolor = "#000000"\nspecular = 0.8\n').appearance()
    assert len(caught) == 1
    with pytest.warns(LoomlightWarning, match=r"weft\.color.*lab\(60 100 0\)"):
        fabric_from_text(SEEN + '[weft]\ncolor = "lab(60 100 0)"\n').appearance()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fabric_from_text(SEEN + '[warp]\ncolor = "#a06040"\n[weft]\ncolor = "#808080"\n').appearance()
        # Nothing is promised of albedos.
        fabric_from_text(SEEN + '[warp]\nalbedo = "#000000"\n').appearance()
