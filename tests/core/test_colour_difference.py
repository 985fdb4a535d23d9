"""CIEDE2000 and L*a*b* against published values."""

import numpy as np
import pytest

from loomlight.core.colour import delta_e_2000, lab_of_linear, linear_of_lab

# Pairs of the table in Sharma, Wu and Dalal 2005: hues on both sides of 0°, greys, the blue region.
PAIRS = [
    ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
    ((50.0, -1.3802, -84.2814), (50.0, 0.0, -82.7485), 1.0000),
    ((50.0, 0.0, 0.0), (50.0, -1.0, 2.0), 2.3669),
    ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0009), 7.1792),
    ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
    ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
    ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
]


@pytest.mark.parametrize(("first", "second", "published"), PAIRS)
def test_differences_are_the_published_ones(
    first: tuple[float, ...], second: tuple[float, ...], published: float
) -> None:
    assert delta_e_2000(first, second) == pytest.approx(published, abs=1e-4)  # four digits are printed
    assert delta_e_2000(second, first) == pytest.approx(published, abs=1e-4)


def test_white_is_neutral_and_lab_is_undone() -> None:
    assert lab_of_linear([1, 1, 1]) == pytest.approx([100, 0, 0], abs=1e-9)
    colours = np.random.default_rng(1).random((64, 3))
    assert linear_of_lab(lab_of_linear(colours)) == pytest.approx(colours, abs=1e-12)
