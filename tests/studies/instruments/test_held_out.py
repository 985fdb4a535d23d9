"""The held-out fabrics are what the protocol asks for, and the same ones every time."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.aggregate.queries import admits_transmission
from loomlight.core.errors import InputError
from loomlight.evaluation.query_benchmark import HeldOut
from loomlight.models.neural.weights import PARAMETER_RANGES
from studies.instruments.held_out import held_out_fabrics
from studies.papers.chen2024.training.weaves import HELD_OUT_WEAVES, PAPER_WEAVES, paper_draft


@pytest.fixture(scope="module")
def fabrics() -> list[HeldOut]:
    return held_out_fabrics()


def smoother(cloth: HeldOut) -> float:
    appearance = cloth.fabric.appearance()
    return min(appearance.warp.roughness, appearance.weft.roughness)


def repeats(weave: np.ndarray, drawdown: np.ndarray) -> bool:
    """Whether a drawdown is whole repeats of a weave."""
    across, along = (-(-size // part) for size, part in zip(drawdown.shape, weave.shape, strict=True))
    tiled = np.tile(weave, (across, along))
    return tiled.shape == drawdown.shape and bool((tiled == drawdown).all())


def test_how_many_of_each_kind(fabrics: list[HeldOut]) -> None:
    assert len(fabrics) == 24
    assert len({cloth.name for cloth in fabrics}) == 24
    assert sum(cloth.unseen_weave for cloth in fabrics) >= 8
    assert sum(admits_transmission(cloth.fabric.appearance()) for cloth in fabrics) == 12
    assert sum(cloth.coloured for cloth in fabrics) == 6
    classes = np.searchsorted([0.15, 0.4], [smoother(cloth) for cloth in fabrics])
    assert np.bincount(classes, minlength=3).min() >= 5


def test_unseen_weaves_are_unlike_the_papers(fabrics: list[HeldOut]) -> None:
    known = [paper_draft(name).drawdown for name in PAPER_WEAVES]
    for cloth in fabrics:
        assert any(repeats(weave, cloth.fabric.draft.drawdown) for weave in known) != cloth.unseen_weave
    names = {cloth.name.split(" ", 1)[1] for cloth in fabrics}
    assert {"twill 4/4", "basket 2/2"} <= names
    assert set(PAPER_WEAVES) <= names
    # What training leaves out is what is judged here.
    assert set(HELD_OUT_WEAVES) == names - set(PAPER_WEAVES)
    assert any("herringbone" in name for name in names)
    assert any(cloth.fabric.draft.ends > 32 and cloth.unseen_weave for cloth in fabrics)


def test_parameters_lie_in_the_box_and_colours_differ(fabrics: list[HeldOut]) -> None:
    box = PARAMETER_RANGES
    for cloth in fabrics:
        layout, appearance = cloth.fabric.layout(), cloth.fabric.appearance()
        for lies, scatters in ((layout.warp, appearance.warp), (layout.weft, appearance.weft)):
            assert box.roughness[0] <= scatters.roughness <= box.roughness[1]
            assert box.height_scale[0] <= lies.height_scale <= box.height_scale[1]
            assert box.twist_deg[0] <= np.degrees(lies.twist) <= box.twist_deg[1]
            np.testing.assert_allclose(1 - lies.width / lies.spacing, box.gap[0])
        rows = [*appearance.warp.diffuse_reflect, *appearance.weft.diffuse_reflect]
        assert (len({tuple(row) for row in rows}) > 2) == cloth.coloured, cloth.name
        assert appearance.sheen.strength == 0


def test_a_few_are_the_first_of_all(fabrics: list[HeldOut]) -> None:
    few = held_out_fabrics(4)
    assert [cloth.name for cloth in few] == [cloth.name for cloth in fabrics[:4]]
    for one, other in zip(few, fabrics, strict=False):
        assert one.fabric.to_toml() == other.fabric.to_toml()
    assert {cloth.unseen_weave for cloth in few} == {True, False}
    with pytest.raises(InputError, match="from 1 to 24"):
        held_out_fabrics(25)
