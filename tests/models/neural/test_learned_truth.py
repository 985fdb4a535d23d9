"""Whether a network is older than the yarns that it stands for."""

from __future__ import annotations

import math

import pytest

from loomlight.core.llvm import llvm_float
from loomlight.models.neural import learned_truth
from loomlight.models.neural.learned_truth import ENTRY, moved_since, truth_numbers


@pytest.fixture(scope="module")
def numbers() -> list[float]:
    return truth_numbers(llvm_float())


def test_the_same_version_gives_the_same_numbers(numbers: list[float]) -> None:
    assert moved_since({ENTRY: truth_numbers(llvm_float())}, numbers) is None


def test_rounding_of_processors_ages_nothing(numbers: list[float]) -> None:
    rounded = [number * (1 + 1e-4 * (-1) ** place) for place, number in enumerate(numbers)]
    assert moved_since({ENTRY: rounded}, numbers) is None


def test_a_changed_component_is_said_with_its_size(numbers: list[float]) -> None:
    before = [1.1 * number if place == 0 else number for place, number in enumerate(numbers)]
    # Relative to the larger one.
    assert moved_since({ENTRY: before}, numbers) == pytest.approx(0.1 / 1.1, rel=1e-6)


def test_a_network_without_numbers_is_older_than_any_yarns(numbers: list[float]) -> None:
    assert moved_since({}, numbers) == math.inf
    assert moved_since({ENTRY: numbers[:-1]}, numbers) == math.inf


def test_yarns_a_hundredth_narrower_are_noticed(
    numbers: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    (weave, warp, weft, inclination), *others = learned_truth._CLOTHS
    monkeypatch.setattr(learned_truth, "_CLOTHS", ((weave, warp, weft + 0.01, inclination), *others))
    assert moved_since({ENTRY: numbers}, truth_numbers(llvm_float())) is not None
