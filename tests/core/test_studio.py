"""The studio: how bright cards are that face its lights, by an integral of its picture."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.studio import BACK_SHARE, FILL_SHARE, studio_radiance


def unit(azimuth: float, elevation: float) -> np.ndarray:
    """0 at +z, 90 at +x; degrees."""
    around, above = np.radians([azimuth, elevation])
    return np.array([np.sin(around) * np.cos(above), np.sin(above), np.cos(around) * np.cos(above)])


def card(radiance: np.ndarray, normal: np.ndarray) -> float:
    """Radiance of a white card: the irradiance over π, by the middles of pixels."""
    rows, columns = radiance.shape[:2]
    polar, around = (np.arange(rows) + 0.5) * np.pi / rows, (np.arange(columns) + 0.5) * 2 * np.pi / columns
    sine = np.sin(polar)[:, None]
    # Rows from +y down, columns from −z over +x.
    x, y, z = sine * np.sin(around), np.cos(polar)[:, None], -sine * np.cos(around)
    cosine = np.clip(normal[0] * x + normal[1] * y + normal[2] * z, 0, None)
    return float((radiance[..., 0] * cosine * sine).sum() * np.pi / rows**2)


@pytest.mark.parametrize("place", [(-56, 33), (120, 0), (0, 90), (10, 60)])
def test_a_white_card_that_faces_the_key_shows_a_radiance_of_one(place: tuple[float, float]) -> None:
    with_paper = studio_radiance(unit(*place), paper=True)
    assert card(with_paper, unit(*place)) == pytest.approx(1, rel=1e-5)
    radiance = studio_radiance(unit(*place))
    assert card(radiance, unit(*place)) == pytest.approx(1, rel=1e-5)  # rounding of float32
    assert (radiance == radiance[..., :1]).all()
    assert not radiance[radiance.shape[0] // 2 :].any()


def test_light_has_a_direction_and_shadows_are_legible() -> None:
    """A card that turns away from the key keeps the dome alone; the opposite one has the back light too."""
    azimuth, elevation = -56.0, 33.0
    radiance = studio_radiance(unit(azimuth, elevation))
    shadow = card(radiance, unit(azimuth + 90, 0))
    assert 0.4 * FILL_SHARE < shadow < FILL_SHARE
    back = card(radiance, unit(azimuth + 180, elevation))
    # The dome is the same all around.
    assert back == pytest.approx(BACK_SHARE + FILL_SHARE, abs=1e-3)


def test_paper_below_throws_light_into_shadows() -> None:
    """As half of a paper of albedo 0.6 would: 0.3 of what a white card shows that lies flat."""
    radiance = studio_radiance(unit(-56, 33), paper=True)
    below = card(radiance, unit(0, -90))
    assert below == pytest.approx(0.5 * 0.6 * card(radiance, unit(0, 90)), rel=1e-3)
    assert card(radiance, unit(34, 0)) > 2 * card(studio_radiance(unit(-56, 33)), unit(34, 0))
