"""White balance: light of a colour temperature becomes white."""

import numpy as np
import pytest

from loomlight.core.colour import chromaticity, linear_of_xyz_ratio, white_balance, xyz_white
from loomlight.core.errors import InputError


def test_chromaticities_are_those_of_the_illuminants() -> None:
    # D65 (6504 K), D50 (5003 K) and A (2856 K) of CIE 15:2018; the fits are good to a few thousandths.
    assert chromaticity(6504) == pytest.approx((0.3127, 0.3290), abs=3e-4)
    assert chromaticity(5003) == pytest.approx((0.3457, 0.3585), abs=3e-4)
    assert chromaticity(2856) == pytest.approx((0.4476, 0.4074), abs=1e-3)


@pytest.mark.parametrize("kelvin", [2700, 4000, 5000, 6500, 9000])
def test_a_grey_card_is_grey_under_that_light(kelvin: float) -> None:
    x, y = chromaticity(kelvin)
    light = linear_of_xyz_ratio(np.array([x / y, 1, (1 - x - y) / y]) / xyz_white())
    red, green, blue = 0.18 * light * white_balance(kelvin)
    assert red == pytest.approx(green) == pytest.approx(blue)
    assert red > 0


def test_daylight_changes_nothing_and_limits_are_told() -> None:
    assert white_balance(6500) == pytest.approx([1, 1, 1], abs=0.01)
    for kelvin in (1000, 30000, float("nan")):
        with pytest.raises(InputError, match="white_balance"):
            white_balance(kelvin)
