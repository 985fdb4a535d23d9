"""Weaves are told from crossings, in any place; and colours in order.

Covers: capturing/crossings.py, capturing/thread_colours.py, capturing/lighting.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.lighting import light_over
from loomlight.capturing.thread_colours import colour_orders
from loomlight.capturing.thread_grid import ThreadGrid, find_grid
from loomlight.capturing.weave_match import (
    WeaveFit,
    candidates,
    complement_of,
    fit_drafts,
    fit_structure,
    fit_weaves,
)
from loomlight.core.colour import delta_e_2000, lab_of_linear, linear_to_srgb, srgb_to_linear
from loomlight.weave.named import named_weave
from tests.capturing.pictures import BLUE, CREAM, RED, knitted, woven


def seen(picture: np.ndarray) -> tuple[ThreadGrid, Crossings]:
    """Threads and crossings of a picture."""
    grid = find_grid(picture)
    return grid, find_crossings(picture, grid)


@pytest.mark.parametrize("weave", ["plain", "twill 2/1 s", "twill 1/3 z", "satin 5/2", "basket 2/2"])
def test_the_weave_is_found(weave: str) -> None:
    _, crossings = seen(woven(named_weave(weave).drawdown))
    best = fit_weaves([crossings])[0]
    assert best.name == weave
    # In its place: what is on top has then the colour that it was drawn with, darker towards its sides.
    up = best.table(crossings.shape)
    assert crossings.colour[up].mean(axis=0) == pytest.approx(BLUE, abs=0.08)
    assert crossings.colour[~up].mean(axis=0) == pytest.approx(CREAM, abs=0.12)


@pytest.mark.parametrize("weave", ["plain", "twill 2/1 s", "satin 5/2"])
def test_shading_alone_tells_a_weave(weave: str) -> None:
    """Of threads of one colour."""
    _, crossings = seen(woven(named_weave(weave).drawdown, weft=[BLUE]))
    assert fit_weaves([crossings])[0].name == weave


def test_the_back_adds_to_what_the_face_says() -> None:
    drawdown = named_weave("twill 3/1 z").drawdown
    _, face = seen(woven(drawdown))
    _, back = seen(woven(~drawdown[:, ::-1]))
    alone, both = (fit_structure("twill 3/1 z", drawdown, views).score for views in ([face], [face, back]))
    assert both > 1.5 * alone
    assert fit_weaves([face, back])[0].name == "twill 3/1 z"


def test_the_complement_is_the_same_cloth_with_families_changed() -> None:
    _, crossings = seen(woven(named_weave("twill 2/1 z").drawdown))
    fits = fit_weaves([crossings])
    other = complement_of(fits[0], fits, crossings)
    assert other is not None
    assert other.name == "twill 1/2 z"
    assert np.array_equal(other.table(crossings.shape), ~fits[0].table(crossings.shape))


def test_the_complement_of_a_weave_that_is_its_own_is_likely_as_in_its_place() -> None:
    """Colours say of both the same, and shading the opposite."""
    _, crossings = seen(woven(named_weave("twill 2/2 z").drawdown))
    fits = fit_weaves([crossings])
    other = complement_of(fits[0], fits, crossings)
    assert other is not None
    assert other.name == fits[0].name == "twill 2/2 z"
    assert np.array_equal(other.table(crossings.shape), ~fits[0].table(crossings.shape))
    assert other.score < fits[0].score - crossings.votes


def test_no_weave_is_tried_twice() -> None:
    """In other places, or by other names, one structure is the same."""
    seen_before: set[tuple[tuple[int, int], bytes]] = set()
    for name, _, shape in candidates():
        drawdown = named_weave(name).drawdown
        places = [(down, right) for down in range(shape[0]) for right in range(shape[1])]
        key = shape, min(np.roll(drawdown, place, (0, 1)).tobytes() for place in places)
        assert key not in seen_before, name
        seen_before.add(key)


def test_a_knit_has_no_weave() -> None:
    picture = knitted()
    _, crossings = seen(picture)
    best = fit_weaves([crossings])[0]
    woven_best = fit_weaves([seen(woven(named_weave("plain").drawdown))[1]])[0]
    assert best.score / crossings.votes < 0.2 * woven_best.score / crossings.votes


def fitted(crossings: Crossings, weave: str) -> WeaveFit:
    """The weave in its best place."""
    return fit_structure(weave, named_weave(weave).drawdown, [crossings])


def test_stripes_are_runs_of_threads() -> None:
    _, crossings = seen(woven(named_weave("plain").drawdown, warp=[BLUE] * 3 + [RED], weft=[CREAM]))
    up = fitted(crossings, "plain").table(crossings.shape)
    warp, weft = colour_orders(crossings, up)
    assert (len(warp.order), len(weft.order), len(warp.colours), warp.repeats) == (4, 1, 2, True)
    assert sorted(np.bincount(warp.order).tolist()) == [1, 3]
    # Crossings darken towards their sides: a shade of the same colour.
    off = delta_e_2000(lab_of_linear(weft.colours[0]), lab_of_linear(srgb_to_linear(CREAM)))
    assert float(off) < 6


def test_threads_of_one_dye_are_one_colour() -> None:
    shades = [tuple(part * shade for part in BLUE) for shade in (0.97, 1.0, 1.03, 0.99)]
    _, crossings = seen(woven(named_weave("plain").drawdown, warp=shades))  # type: ignore[arg-type]
    warp, _ = colour_orders(crossings, fitted(crossings, "plain").table(crossings.shape))
    assert len(warp.colours) == 1


@pytest.mark.parametrize(("factor", "colours"), [(1.5, 1), (3.0, 2)])
def test_shades_without_order_are_unevenness_and_colours_are_not(factor: float, colours: int) -> None:
    """A yarn of two shades, CIEDE2000 9 and 24 apart, in an order that does not repeat."""
    up = np.indices((24, 24)).sum(axis=0) % 2 == 0
    light = np.random.default_rng(3).integers(0, 2, 24) == 1
    assert light.any()
    assert not light.all()
    shown = np.where(up[..., None], np.where(light, factor, 1.0)[None, :, None] * 0.2, 0.6) * np.ones(3)
    shown = linear_to_srgb(shown)
    crossings = Crossings(shown, shown[..., 0], shown[..., 0], (0, 0))
    warp, weft = colour_orders(crossings, up)
    assert len(warp.colours) == colours
    assert warp.repeats == (colours == 1)
    assert len(weft.colours) == 1


def test_light_that_falls_off_is_found_beside_colours() -> None:
    """Wide stripes are no light."""
    stripes = [BLUE] * 10 + [CREAM] * 10
    picture = woven(named_weave("twill 2/2").drawdown, warp=stripes, weft=stripes, light=0.2)
    grid, crossings = seen(picture)
    up = fitted(crossings, "twill 2/2").table(crossings.shape)
    light = light_over("a.png", picture.shape[:2], grid, crossings, up, colour_orders(crossings, up))
    # The drawing is encoded: 0.8 of it is about 0.8 to the power of 2.2 of the light.
    ratio = light[:, 0].mean() / light[:, -1].mean()
    assert ratio == pytest.approx(0.8**2.2, rel=0.05)


def test_a_weave_without_a_name_is_found_by_its_repeat() -> None:
    """And one that has a name, but is no candidate, by that."""
    drawn = np.array(
        [[1, 1, 0, 0, 1], [0, 1, 1, 0, 1], [0, 0, 1, 1, 0], [1, 0, 1, 0, 0], [1, 0, 0, 1, 1]], bool
    )
    for drawdown, name in ((drawn, ""), (named_weave("twill 6/3 z").drawdown, "twill 6/3 z")):
        _, crossings = seen(woven(drawdown, size=(360, 400)))
        named = fit_weaves([crossings])
        free = fit_drafts([crossings], named)
        best = max(free, key=lambda fit: fit.unsigned)
        assert best.unsigned > named[0].unsigned
        up = best.table(crossings.shape)
        assert (best.name in (name, "twill 3/6 z")) if name else best.name == ""
        # The colours that it parts are those that were drawn, of the one family or the other.
        means = {round(float(crossings.colour[part].mean()), 1) for part in (up, ~up)}
        assert len(means) == 2


def test_a_candidate_is_no_weave_without_a_name() -> None:
    _, crossings = seen(woven(named_weave("twill 2/1 z").drawdown))
    assert fit_drafts([crossings], fit_weaves([crossings])) == []


def test_stripes_that_bind_no_pick_are_no_draft() -> None:
    """Picks that all ends pass on one side would fall out of the cloth."""
    rng = np.random.default_rng(4)
    rows = np.arange(24)[:, None] % 2 == 0
    colour = np.where(rows[..., None], 0.8, 0.2) + 0.01 * rng.standard_normal((24, 20, 3))
    shading = 0.01 * rng.standard_normal((2, 24, 20))
    crossings = Crossings(colour, shading[0], shading[1], (0, 0))
    assert fit_drafts([crossings], fit_weaves([crossings])) == []
