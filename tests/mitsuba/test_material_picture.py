"""`render`: the same picture from a name, a file and a fabric, and from the command line."""

from __future__ import annotations

import re
import warnings
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import OpenEXR
import pytest

import loomlight
from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import Placement, RenderSettings
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import material_bsdf
from loomlight.mitsuba.pictures import RenderJob, shown_material
from tests.helpers.pictures import png_head

SMALL = {"size": (12, 8), "spp": 2, "seed": 3, "model": "point"}


def test_a_name_a_file_and_a_fabric_give_the_picture_of_the_command_line(tmp_path: Path) -> None:
    file = tmp_path / "cloth.toml"
    file.write_text('weave = "twill 3/1"')
    picture = loomlight.render("twill 3/1", "sphere", light_from=(20, 30), **SMALL)
    assert picture.shape == (8, 12, 3)
    assert picture.std() > 0
    for fabric in (file, loomlight.load_fabric(file)):
        again = loomlight.render(fabric, "sphere", light_from=(20, 30), **SMALL)
        np.testing.assert_allclose(again, picture, rtol=1e-5, atol=1e-7)
    options = ["--size", "12x8", "--spp", "2", "--seed", "3", "--light-from", "20,30", "--model", "point"]
    written = tmp_path / "a.exr"
    assert run(["render", str(file), "-o", str(written), "--scene", "sphere", *options]) == 0
    pixels = OpenEXR.File(str(written)).channels()["RGB"].pixels
    np.testing.assert_allclose(pixels, picture, rtol=1e-5, atol=1e-7)


def hidden(caught: list[warnings.WarningMessage]) -> list[str]:
    return [str(each.message) for each in caught if "yarns a pixel" in str(each.message)]


def test_a_weave_that_pixels_cannot_show_is_told_once() -> None:
    """100 mm over 12 pixels of the flat scene, 14 ends a centimetre; the zoom that it names is silent."""
    settings = RenderSettings(**{**SMALL, "size": (12, 12)})
    cloth = fabric_from_text('name = "Check"\nweave = "twill 2/2"\nends_per_cm = 14\npicks_per_cm = 11')

    def told(scene: str, **changes: Any) -> list[str]:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            chosen = settings.changed(scene=scene, **changes)
            RenderJob(shown_material(cloth, chosen), chosen).scene_and_inset()
        return hidden(caught)

    (sentence,) = told("flat")
    found = re.fullmatch(
        r"Check: 14 ends/cm are (\d+) yarns a pixel here, too many .*: --zoom (\d+) shows them\.",
        sentence,
    )
    assert found is not None
    # With teeth of 3 mm on either side, in a frame that is a little wider.
    assert int(found[1]) == pytest.approx(1.04 * 106 / 12 * 1.4, abs=0.6)
    assert told("flat", zoom=float(found[2])) == []
    assert told("flat", placement=Placement(scale=12)) == []
    assert told("drape", size=(160, 160), inset=False) != []
    assert told("drape", size=(160, 160), inset=True) == []


@pytest.mark.parametrize("exposure", [float("nan"), 31, -1e9])
def test_exposures_are_checked(exposure: float) -> None:
    with pytest.raises(InputError, match="exposure"):
        loomlight.render("plain", exposure=exposure, **SMALL)


def test_a_texture_of_billions_of_pixels_is_refused_before_it_is_read(tmp_path: Path) -> None:
    """Mitsuba would take 43 GB for it."""
    huge = png_head(tmp_path / "huge.png", 60_000, 60_000)
    with pytest.raises(InputError, match=r"huge\.png has 60000 x 60000 pixels; at most 16384 a side"):
        material_bsdf("plain", "point", albedo={"type": "bitmap", "filename": str(huge)})((100, 100))
    with pytest.raises(InputError, match=r"none\.png does not exist"):
        material_bsdf("plain", "point", albedo={"type": "bitmap", "filename": str(tmp_path / "none.png")})(
            (1, 1)
        )


@pytest.mark.slow
def test_the_picture_comes_coarse_then_refined_with_a_close_up() -> None:
    """On the whole drape, by default; all pictures are whole and of the same light."""
    seen: list[np.ndarray] = []
    times: list[tuple[int, int]] = []
    size = (344, 258)
    options = {"size": size, "spp": 1, "seed": 3, "model": "point", "max_depth": 2, "denoise": "off"}
    picture = loomlight.render(
        "twill 3/1", partial=seen.append, progress=lambda *numbers: times.append(numbers), **options
    )
    assert times[0][0] < 100 < times[0][1]
    assert times[-1][0] == times[-1][1]
    coarse = seen[0]
    assert coarse.shape == picture.shape == (258, 344, 3)
    side, margin = int(0.37 * 258), round(0.025 * 258)
    corner = slice(margin + 2, margin + 2 + side)
    without = loomlight.render("twill 3/1", inset=False, **options)
    # The close-up shows cloth where the whole picture shows the ground; elsewhere the two are the same.
    assert np.abs(picture[corner, corner] - without[corner, corner]).mean() > 0.1
    np.testing.assert_allclose(picture[200:], without[200:], rtol=1e-4, atol=1e-5)
    for shown in (coarse, picture):
        np.testing.assert_allclose(shown.mean(), picture.mean(), rtol=0.05)
    cloth = loomlight.load_fabric("twill 3/1")
    np.testing.assert_allclose(loomlight.render(cloth, **options), picture, rtol=1e-4, atol=1e-5)
    closer = loomlight.render(cloth, zoom=1.01, **options)
    assert np.abs(closer[corner, corner] - picture[corner, corner]).mean() > 0.1


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"seed": -1}, "seed = -1 is wrong: give a whole number from 0 to 4294967295"),
        ({"seed": 1.5}, "seed = 1.5 is wrong"),
        ({"cloths": None}, "cloths = None is wrong: give a dictionary"),
        ({"colors": ["#fff"]}, "colors = .* is wrong: give a dictionary"),
    ],
)
def test_settings_of_another_kind_are_refused(settings: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        RenderSettings(**settings)


def test_a_shift_beyond_single_precision_is_refused() -> None:
    with pytest.raises(InputError, match=r"shift = .* is wrong: give 2 numbers from -1000000 to 1000000"):
        Placement(shift=(1e300, 0))


def test_a_name_is_no_source() -> None:
    bsdf = mi.load_dict({"type": "woven_point", "weave": "plain"})
    with pytest.raises(InputError, match="hand over the fabric"):
        bsdf.set_source("twill 2/2")
