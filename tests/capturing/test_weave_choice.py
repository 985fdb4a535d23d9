"""Weaves are compared by one yardstick, and said to be as sure as they are.

Covers: capturing/weave_choice.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from loomlight.capturing.captured import SURE, Captured, WeaveChoice
from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.photo import read_photo
from loomlight.capturing.photographer import Light, photograph, straight
from loomlight.capturing.thread_colours import ColourOrder
from loomlight.capturing.thread_grid import find_grid
from loomlight.capturing.weave_choice import (
    Hypothesis,
    Seen,
    chosen,
    hypotheses,
    light_of,
    likelihoods,
    reliability,
)
from loomlight.capturing.weave_match import WeaveFit, fit_structure, fit_weaves
from loomlight.capturing.yarn_fit import Fit, yarns_of_kind
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric import fabric_from_text
from loomlight.weave.named import named_weave
from tests.capturing.pictures import TWILL, WIDTH_MM, photographed_twill, save

VOTES = 100.0


def hypothesis(
    name: str, score: float, *, unsigned: float | None = None, within: float = 4e-3, cost: float = 2e-4
) -> Hypothesis:
    """A weave of which crossings say so much, and whose render leaves so much."""
    fit = WeaveFit(name, np.eye(2, dtype=bool), (0, 0), score, score if unsigned is None else unsigned)
    return Hypothesis(None, WeaveChoice(fit, 1.0, None, None), None, within, cost, VOTES, ())  # type: ignore[arg-type]


def test_a_repeat_that_is_seen_once_costs_the_threads_that_are_not_seen_again() -> None:
    """A herringbone of 32 ends in a picture of 24 says no more than the twill of its leg, where both fit."""
    ends = 14
    drawdown = named_weave("twill 2/1 z").drawdown
    up = np.tile(drawdown, (10, 5))[:, :ends]
    colour = np.where(up[..., None], 0.2, 0.8) * np.ones(3)
    crossings = Crossings(colour, up - 0.5, up - 0.5, (0, 0))
    herringbone = named_weave("herringbone 2/1 16").drawdown
    twill = fit_structure("", drawdown, [crossings])
    other = fit_structure("", herringbone, [crossings])
    places = np.log(herringbone.size) - np.log(drawdown.size)
    missing = np.log(2) * (2 * herringbone.shape[1] - ends)
    assert twill.score - other.score == pytest.approx(places + missing)


def test_what_is_seen_once_has_the_noise_of_what_is_seen_often() -> None:
    """Pixels of one repeat differ less about their mean than those of many: no merit of the weave."""
    once, often = likelihoods([hypothesis("a", 90.0, within=np.inf), hypothesis("b", 90.0)])
    assert once == pytest.approx(often)


def test_a_draft_made_of_the_crossings_does_not_win_by_them_alone() -> None:
    scores = likelihoods([hypothesis("", 290.0, cost=4e-3), hypothesis("satin 5/2", 120.0, cost=1e-3)])
    assert scores[1] > scores[0]
    # Where its render is the better one too, it is the likelier one.
    scores = likelihoods([hypothesis("", 290.0, cost=1e-3), hypothesis("satin 5/2", 120.0, cost=4e-3)])
    assert scores[0] > scores[1]


def test_little_evidence_makes_no_weave_sure() -> None:
    """The errors of seeds 69 and 71 had evidences of .13 to .21, right ones more than .6."""
    assert reliability(0.0) == 0
    assert reliability(0.13) < 0.5
    assert reliability(0.2) == pytest.approx(0.5)
    assert reliability(0.61) > 0.9


def test_a_render_that_is_far_off_takes_evidence_away() -> None:
    near, far = hypothesis("a", 90.0), hypothesis("a", 90.0, cost=4e-3)
    assert near.evidence == pytest.approx(0.9)
    assert far.evidence == pytest.approx(0.27)


@pytest.mark.parametrize(("confidence", "rivals", "pixels", "said"), [
    (0.6, ("weft rib 2/2", "basket 2/2"), 7.0, "and weft rib 2/2 or basket 2/2 looks nearly the same"),
    (0.6, (), 7.0, "Move nearer: a thread has 7 pixels here, and 10 tell weaves apart."),
    (0.6, (), 20.0, "is a guess, 60 % sure: check the draft"),
])  # fmt: skip
def test_a_guess_says_what_else_it_may_be_and_what_to_do(
    confidence: float, rivals: tuple[str, ...], pixels: float, said: str
) -> None:
    found = captured(confidence, rivals, pixels)
    assert len(found.doubts) == 1
    assert said in found.doubts[0]
    assert ("Move nearer" in found.doubts[0]) == (pixels < 10)


def test_a_weave_that_was_given_is_no_guess() -> None:
    found = replace(captured(0.3, ("basket 2/2",), 7.0), is_given=True)
    (doubt,) = found.doubts
    assert "explains the picture poorly" in doubt


def test_a_sure_weave_has_no_doubts() -> None:
    assert captured(SURE, ("basket 2/2",), 7.0).doubts == []


@pytest.mark.parametrize(("shade", "count"), [(0.95, 0), (0.6, 1)])
def test_a_shadow_is_told_of_and_a_wrinkle_is_not(shade: float, count: int) -> None:
    """Encoded values of .95 and .6 are about .89 and .33 of the light."""
    doubts = captured(SURE, (), 20.0, shade).doubts
    assert len(doubts) == count
    assert all("a shadow, a fold or a label" in sentence for sentence in doubts)


def captured(confidence: float, rivals: tuple[str, ...], pixels: float, shade: float = 1.0) -> Captured:
    """Of a plain weave, without a photograph; the left of its crossings is darker by a factor."""
    fit = WeaveFit("plain", named_weave("plain").drawdown, (0, 0), 90.0, 90.0)
    family = SimpleNamespace(per_px=1 / pixels)
    colours = np.full((1, 3), 0.5)
    order = ColourOrder(colours, np.zeros(1, np.intp), 0, True)
    shown = np.full((20, 20, 3), 0.5)
    shown[:, :8] *= shade
    crossings = Crossings(shown, shown[..., 0], shown[..., 0], (0, 0))
    return Captured(
        photo="a.jpg",
        linear=np.zeros((8, 8, 3), np.float32),
        width_mm=20.0,
        light=Light(),
        choice=WeaveChoice(fit, confidence, order, order, rivals),
        grid=SimpleNamespace(warp=family, weft=family),  # type: ignore[arg-type]
        crossings=crossings,
        fit=Fit(yarns_of_kind("cotton", (colours, colours)), 1e-4, colours),
    )


@pytest.mark.slow
@pytest.mark.parametrize("azimuth", [0.0, 90.0, 180.0, 270.0])
def test_the_side_of_a_window_is_found(azimuth: float, tmp_path: Path) -> None:
    """Also of one that is not quite at the middle of the side, and higher than it is taken to be."""
    fabric = fabric_from_text(TWILL)
    light = Light("window", azimuth + 12, 50.0)
    picture = photograph(fabric, straight((240, 240), 10.0, 0.02), light, 4)
    path = save(tmp_path / "photo.png", linear_to_srgb(np.clip(picture, 0, 1)))
    photo = read_photo(path, 10.0)
    grid = find_grid(photo.encoded)
    crossings = find_crossings(photo.encoded, grid)
    fit = fit_structure("twill 2/1 z", fabric.draft.drawdown, [crossings])
    assert light_of(Seen(photo, grid, crossings), fit, "window").azimuth == azimuth


@pytest.mark.slow
@pytest.mark.parametrize(
    ("weave", "kind"), [("plain", "cotton"), ("basket 2/2", "cotton"), ("basket 2/2", "worsted")]
)
def test_pairs_of_four_pixels_a_thread_are_told_from_single_threads_or_said_to_be_a_guess(
    weave: str, kind: str, tmp_path: Path
) -> None:
    """Threads of a plain weave are as wide here as pairs are, so that crossings look the same."""
    sett = 36.0 if weave == "basket 2/2" else 18.0
    fabric = fabric_from_text(
        f'weave = "{weave}"\nyarn = "{kind}"\nends_per_cm = {sett}\npicks_per_cm = {sett}\n'
        '[warp]\ncolor = "#3a5a86"\n[weft]\ncolor = "#cfc3a8"\n'
    )
    picture = photograph(fabric, straight((260, 260), 18.0, 0.02), Light(), 9)
    photo = read_photo(save(tmp_path / "photo.png", linear_to_srgb(picture)), 18.0)
    grid = find_grid(photo.encoded)
    face = Seen(photo, grid, find_crossings(photo.encoded, grid))
    fits = fit_weaves([face.crossings])
    assert fits[0].name == "plain"
    _, choice, _, _ = chosen(face, fits, Light(), lambda done, total: None)
    if kind == "cotton":
        assert choice.fit.name == weave
    else:
        # Highlights of worsted hide the groove of a pair.
        assert choice.confidence < SURE
        assert weave in (choice.fit.name, *choice.rivals)


@pytest.mark.slow
def test_weaves_are_rendered_on_larger_repeats_of_rivals_too(tmp_path: Path) -> None:
    """What plies add to a large repeat by chance a small one explains there as well."""
    photo = read_photo(photographed_twill(tmp_path / "photo.png"), WIDTH_MM)
    grid = find_grid(photo.encoded)
    face = Seen(photo, grid, find_crossings(photo.encoded, grid))
    small, large = (
        fit_structure(name, named_weave(name).drawdown, [face.crossings])
        for name in ("twill 2/1 z", "twill 2/1/1/2 z")
    )
    # Both are likely enough to be rendered.
    fits = [small, replace(large, score=small.score - 1)]
    found = hypotheses(face, fits, Light(), lambda done, total: None)
    twills = [each for each in found if each.fit is small]
    (rival,) = [each for each in found if each.fit is fits[1]]
    assert [each.within == rival.within for each in twills] == [False, True]
    # The weave in the end is the smaller repeat.
    seen, choice, _, _ = chosen(face, fits, Light(), lambda done, total: None)
    assert choice.fit.structure.shape == (3, 3)
    assert seen is face
