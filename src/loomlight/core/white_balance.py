"""White balance: the gains by which light of a colour temperature becomes white.

Light of the sky has the chromaticities of CIE daylight from 4000 K on (CIE 15:2018), light of lamps those of
a black body below (Kim et al. 2002). At 6500 K gains are 1 to within 1 %: colours are relative to D65.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour_difference import linear_of_xyz_ratio, xyz_white
from loomlight.core.errors import InputError

COOLEST, WARMEST = 1667.0, 25000.0
_DAYLIGHT_FROM = 4000.0


def chromaticity(kelvin: float) -> tuple[float, float]:
    """CIE 1931 x, y of light of a colour temperature, kelvin, 1667 to 25000."""
    inverse = 1e3 / kelvin
    if kelvin < _DAYLIGHT_FROM:
        x = np.polyval([-0.2661239, -0.2343589, 0.8776956, 0.179910], inverse)
        low = [-1.1063814, -1.34811020, 2.18555832, -0.20219683]
        high = [-0.9549476, -1.37418593, 2.09137015, -0.16748867]
        return float(x), float(np.polyval(low if kelvin <= 2222 else high, x))
    if kelvin <= 7000:
        x = np.polyval([-4.6070, 2.9678, 0.09911, 0.244063], inverse)
    else:
        x = np.polyval([-2.0064, 1.9018, 0.24748, 0.237040], inverse)
    return float(x), float(np.polyval([-3.0, 2.870, -0.275], x))


def white_balance(kelvin: float) -> NDArray[np.float64]:
    """Gains of linear RGB [3] under which light of that colour temperature is white; luminance is kept.

    Raises:
        InputError: a temperature outside 1667 to 25000 K.
    """
    if not COOLEST <= kelvin <= WARMEST:
        raise InputError(
            f"white_balance = {kelvin:g} is out of range: colour temperatures lie between {COOLEST:.0f} and "
            f"{WARMEST:.0f} K; 6500 is daylight and changes nothing."
        )
    x, y = chromaticity(kelvin)
    light = linear_of_xyz_ratio(np.array([x / y, 1.0, (1 - x - y) / y]) / xyz_white())
    # Candlelight lies outside the gamut, where a channel would get no finite gain.
    gains = 1 / np.maximum(light, 0.02)
    return np.asarray(gains / (gains @ np.array([0.2126, 0.7152, 0.0722])))
