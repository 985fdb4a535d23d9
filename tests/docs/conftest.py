"""Pages and examples with less work: their words stay the same, and are checked in less time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from loomlight.exporters import blender, engines, u3m
from loomlight.mitsuba.pictures import RenderJob
from tests.helpers.standard_materials import few_queries

FEW_SAMPLES = 4
# Textures of a few texels: how good they are, tests/exporters ask.
FEWER = {
    u3m: {"_MIN_SIDE": 16, "DEFAULT_DPI": 60},
    engines: {"_MAX_SIDE": 128},
    blender: {"MAX_TEXELS": 256, "DENSITIES": {"near": (None, 8), "mid": (1.0, 16), "far": (8.0, 16)}},
}


@pytest.fixture
def less_work(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Pictures have a quarter of the pixels and a few samples of each, fits and textures are small."""
    begin = RenderJob.__post_init__

    def begin_smaller(job: RenderJob) -> None:
        few = replace(job.settings, spp=min(job.settings.spp, FEW_SAMPLES))
        object.__setattr__(job, "settings", few)
        begin(job)
        job._size = job._size[0] // 2, job._size[1] // 2

    monkeypatch.setattr(RenderJob, "__post_init__", begin_smaller)
    for module, values in FEWER.items():
        for name, value in values.items():
            monkeypatch.setattr(module, name, value)
    with few_queries():
        yield
