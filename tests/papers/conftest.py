"""Every test here renders with the default variant."""

from __future__ import annotations

import pytest

from loomlight.mitsuba import choose_variant


@pytest.fixture(autouse=True, scope="session")
def _variant() -> None:
    choose_variant("llvm_ad_rgb")
