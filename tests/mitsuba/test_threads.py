"""Several threads of one process: each finds BSDFs whole, and pictures are taken in turns.

Covers: mitsuba/variants.py
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest
from PIL import ExifTags, Image

import loomlight
from loomlight.mitsuba.bsdf import GivenModel, made_class
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.models.bake import bake


def test_a_bsdf_is_whole_when_mitsuba_first_knows_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """From then on renders of other threads trace it, whichever scene it belongs to."""
    known: set[str] = set()

    class Watched(mi.BSDF):
        def __init__(self, props: Any) -> None:
            known.update(vars(self))
            super().__init__(props)

    monkeypatch.setattr(mi, "BSDF", Watched)
    bsdf = made_class()(mi.Properties(), "point", GivenModel(bake("plain", "point"), (10.0, 10.0)))
    assert known
    assert set(vars(bsdf)) == known


@pytest.mark.slow
def test_threads_render_in_turns() -> None:
    """Without turns one in some ten runs crashes within Dr.Jit."""
    weaves = ("plain", "twill 2/2", "satin 5")

    def picture(weave: str) -> np.ndarray:
        return loomlight.render(weave, "sphere", size=(24, 16), spp=1, denoise="off", inset=False)

    alone = [picture(weave) for weave in weaves]
    with ThreadPoolExecutor(len(weaves)) as threads:
        together = list(threads.map(picture, weaves))
    for one, other in zip(alone, together, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-3, atol=1e-5)  # threads add up in any order


def test_albedo_maps_are_turned_as_their_file_says(tmp_path: Path) -> None:
    exif = Image.Exif()
    exif[ExifTags.Base.Orientation] = 3
    pixels = np.zeros((2, 2, 3), np.uint8)
    pixels[0] = 255  # stored above, shown below
    Image.fromarray(pixels).save(tmp_path / "print.png", exif=exif)
    Image.fromarray(pixels[::-1]).save(tmp_path / "upright.png")
    shown = [
        make_bsdf(bake("plain", "point"), (10.0, 10.0), {"type": "bitmap", "filename": str(tmp_path / name)})
        for name in ("print.png", "upright.png")
    ]
    si = mi.SurfaceInteraction3f()
    found = []
    for v in (0.25, 0.75):
        si.uv = mi.Point2f(0.5, v)
        turned, upright = (bsdf.albedo.eval(si, True)[0][0] for bsdf in shown)
        assert turned == upright
        found.append(turned)
    assert sorted(found) == [0, 1]
