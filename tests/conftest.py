"""What all tests share: a cache of their own, and short trainings."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from loomlight.models.latent.settings import QUALITIES as LATENT_QUALITIES
from loomlight.models.neumip.settings import QUALITIES

# Before torch is loaded: MKL's sums otherwise depend on where arrays lie, and trainings repeat bit for bit.
os.environ.setdefault("MKL_CBWR", "AUTO,STRICT")

# Mesa's software driver takes most of the time of shader tests to compile them. What it compiled stays where
# it does for any program, so that all workers, subprocesses and later runs share it.
os.environ.setdefault(
    "MESA_SHADER_CACHE_DIR", os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
)

# Seconds that an example takes say how busy a machine is, not what is wrong.
settings.register_profile("busy machines", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("busy machines")


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Nothing is read from the user's cache, and nothing is left there."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(scope="session", autouse=True)
def short_training() -> Iterator[None]:
    """Trainings of `neumip` and `latent` take a second instead of minutes: enough to know what it is of."""
    short = replace(
        QUALITIES["preview"], resolution=16, queries=100, samples=4, steps=120, batch=1 << 11, rate=5e-3
    )
    latent = replace(
        LATENT_QUALITIES["preview"],
        resolution=8,
        queries=1 << 13,
        samples=2,
        steps=60,
        batch=1 << 10,
        sampler_steps=30,
        sampler_batch=128,
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(QUALITIES, "preview", short)
        patch.setitem(LATENT_QUALITIES, "preview", latent)
        yield
