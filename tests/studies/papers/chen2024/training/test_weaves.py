"""What is drawn for training lies inside the ranges, and is never a held-out weave.

Covers: studies/papers/chen2024/training/random_fabrics.py
"""

import numpy as np
import pytest

from loomlight.models.neural.weights import LAYOUT_RANGES, PARAMETER_RANGES
from loomlight.weave.named import named_weave
from studies.papers.chen2024.training.random_fabrics import random_fabric
from studies.papers.chen2024.training.weaves import (
    HELD_OUT_WEAVES,
    PAPER_WEAVES,
    _class_of,
    paper_draft,
    training_draft,
)


def test_paper_weaves_have_the_repeats_the_paper_names() -> None:
    shapes = {name: paper_draft(name).drawdown.shape[::-1] for name in PAPER_WEAVES}
    assert shapes == {
        "plain": (2, 2),
        "twill 3×3": (3, 3),
        "twill 5×5": (5, 5),
        "twill 8×8": (8, 8),
        "satin 5×5": (5, 5),
        "satin 8×8": (8, 8),
        "satin 5×10": (5, 10),
    }


def test_copies_of_a_weave_are_one_class() -> None:
    twill = named_weave("twill 3/1 s").drawdown
    assert _class_of(named_weave("twill 3/1 z").drawdown) == _class_of(twill)
    assert _class_of(np.roll(~twill, 3, 0)) == _class_of(twill)
    assert _class_of(~twill.T) == _class_of(twill)
    assert _class_of(named_weave("twill 2/2").drawdown) != _class_of(twill)


@pytest.mark.slow
def test_held_out_weaves_are_never_drawn() -> None:
    held = {_class_of(named_weave(name).drawdown) for name in HELD_OUT_WEAVES if name != "diamond figure 48"}
    rng = np.random.default_rng(5)
    drawn = [training_draft(rng, "all").drawdown for _ in range(150)]
    assert not held & {_class_of(drawdown) for drawdown in drawn}
    # Half are others than the paper's, and of those hardly two are alike.
    assert len({drawdown.tobytes() for drawdown in drawn}) > 50


def test_random_fabrics_fill_the_ranges() -> None:
    rng = np.random.default_rng(1)
    fabrics = [random_fabric(rng, paper_draft("satin 5×5")) for _ in range(300)]
    roughness = np.array([fabric.appearance().warp.roughness for fabric in fabrics])
    scale = np.array([fabric.layout().weft.height_scale for fabric in fabrics])
    for values, (low, high) in (
        (roughness, PARAMETER_RANGES.roughness),
        (scale, PARAMETER_RANGES.height_scale),
    ):
        assert values.min() >= low
        assert values.max() <= high
        # Of 300 uniform numbers the extremes lie within 3 % of the ends but in e^-9 of cases.
        assert values.min() < low + 0.03 * (high - low)
        assert values.max() > high - 0.04 * (high - low)


def test_layouts_vary_and_leave_the_yarns_as_they_are() -> None:
    draft = paper_draft("plain")
    kept, varied = (
        [random_fabric(np.random.default_rng(k), draft, ranges=ranges) for k in range(200)]
        for ranges in (PARAMETER_RANGES, LAYOUT_RANGES)
    )
    for one, other in zip(kept, varied, strict=True):
        assert one.appearance().warp.roughness == other.appearance().warp.roughness
        assert one.layout().weft.inclination == other.layout().weft.inclination
    families = [(fabric.layout().warp, fabric.layout().weft) for fabric in varied]
    gaps = np.array([[1 - family.width[0] / family.spacing[0] for family in pair] for pair in families])
    assert gaps.min() >= 0
    assert gaps.max() <= 0.7
    # The square of a uniform number: a quarter lies below a sixteenth, within 4 deviations of 400 draws.
    assert abs((gaps < 0.7 / 16).mean() - 0.25) < 4 * np.sqrt(0.25 * 0.75 / gaps.size)
    assert np.abs(np.corrcoef(gaps.T)[0, 1]) < 0.3  # families are drawn apart
    ratios = np.array([weft.spacing[0] / warp.spacing[0] for warp, weft in families])
    assert 0.4 <= ratios.min() < 0.45
    assert 2.2 < ratios.max() <= 2.5
    assert {fabric.layout().size[0] / fabric.layout().size[1] for fabric in kept} == {1.0}
