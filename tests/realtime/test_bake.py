"""Tables of `lobes` baked by compute kernels, against those that Python bakes of the same fabric.

Covers: realtime/bake.py
"""

from __future__ import annotations

import json
import re
from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.fabric import load_fabric
from loomlight.models.interface import ShaderTables
from loomlight.models.lobes.tables import LobeTables, bake_tables, given_numbers
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.bake import (
    BUFFER_BYTES,
    DISPATCHES,
    OPENNESS_KERNEL,
    SCRATCH,
    BakePlan,
    FabricBuffers,
    declarations_of,
    manifest,
    plan_bake,
)
from loomlight.realtime.device import default_adapter
from loomlight.realtime.slangc import SHADERS
from loomlight.realtime.words import Packed, pack_fabrics
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.layouts import even_layout
from tests.helpers.parity import appearance, places, share_beyond
from tests.helpers.shader_cases import EXAMPLES
from tests.helpers.slang import mapped

GROUPS = 8
COUNT = 20_000
# WebGPU's default limits.
MAX_BYTES, MAX_BUFFERS, MAX_WORKGROUPS = 128 << 20, 8, 65535
# Of bytes: one that rounding decides differs by 1, a ray that grazes a yarn may take the
# other side, and moves a sum over some thirty rays of its node. Most are shadow rays that start from flanks.
MAX_FLIPS = 5e-3
# A query reads some three hundred bytes, and its bar of a thousandth is a quarter of a byte's step.
MAX_QUERIES_BEYOND = 8e-3
SATIN_OF_8 = np.array([[(3 * pick + end) % 8 != 0 for end in range(8)] for pick in range(8)])


class Baked(NamedTuple):
    layout: ClothLayout
    appearance: Appearance
    by_kernels: Packed
    by_python: Packed
    plan: BakePlan


@pytest.fixture(scope="module")
def baked() -> Baked:
    layout = even_layout(SATIN_OF_8)
    look = appearance(np.random.default_rng(5), layout, False, False)
    buffers = FabricBuffers(default_adapter(), [(layout, look)], groups=GROUPS)
    tables = bake_tables(YarnGeometry(layout), look.diffuse_blend, GROUPS, llvm_float())
    shown = ShaderTables(tables, given_numbers(layout, tables.base_size))
    by_python = pack_fabrics([(layout, look)], None, [shown])
    return Baked(layout, look, read(buffers, by_python), by_python, plan_bake(layout, GROUPS))


def read(buffers: FabricBuffers, like: Packed) -> Packed:
    adapter, kind = default_adapter(), like.fabrics.dtype
    records = adapter.read(buffers.buffers["fabrics"], np.uint8, like.fabrics.nbytes).view(kind)
    words = adapter.read(buffers.buffers["words"], np.uint32, like.words.size)
    return Packed(records, like.families, words, like.packed_numbers)


def table(packed: Packed, plan: BakePlan, name: str) -> NDArray[np.uint32]:
    first = int(packed.fabrics["lobes"][name][0])
    return packed.words[first : first + LobeTables.word_counts(plan.sizes)[name]]


@pytest.mark.parametrize(
    "name", ["coverage", "coverage_holes", "projected_area", "light_visibility", "irradiance"]
)
def test_bytes_are_those_of_python(baked: Baked, name: str) -> None:
    found, expected = (
        table(packed, baked.plan, name).view(np.uint8).astype(int)
        for packed in (baked.by_kernels, baked.by_python)
    )
    assert expected.max() > 200
    assert np.mean(np.abs(found - expected) > 0) <= MAX_FLIPS
    # One ray of a group that some ten shadow rays of a node start from, and eight of those around.
    assert np.abs(found - expected).max() <= 255 / 18


def test_moments_and_weights_are_those_of_python(baked: Baked) -> None:
    found, expected = (
        table(packed, baked.plan, "moments").view(np.float32).reshape(-1, 12)
        for packed in (baked.by_kernels, baked.by_python)
    )
    weight = 3
    np.testing.assert_allclose(found[:, weight], expected[:, weight], rtol=2e-3)
    # Moments of some thousand rays, of which one may be another.
    np.testing.assert_allclose(np.delete(found, weight, 1), np.delete(expected, weight, 1), atol=5e-4)


def test_records_are_those_of_python(baked: Baked) -> None:
    found, expected = (packed.fabrics["lobes"][0] for packed in (baked.by_kernels, baked.by_python))
    for name in found.dtype.names or ():
        assert found[name] == pytest.approx(expected[name], rel=1e-5), name


@pytest.mark.slow
def test_queries_on_both_sets_of_tables_agree(baked: Baked) -> None:
    rng = np.random.default_rng(29)
    at = places(rng, baked.layout, COUNT)
    side = np.exp(rng.uniform(np.log(0.1), np.log(20), COUNT))
    turn = rng.uniform(0, 2 * np.pi, COUNT)
    arguments = {
        "x": at.x,
        "y": at.y,
        "light": clear_of_the_plane(rng, COUNT),
        "view": clear_of_the_plane(rng, COUNT),
        "dx": np.float32(np.stack([side * np.cos(turn), side * np.sin(turn)], axis=1)),
        "dy": np.float32(np.stack([-side * np.sin(turn), side * np.cos(turn)], axis=1)),
    }
    body = (
        "Footprint p; p.centre = float2(x, y); p.dx = dx; p.dy = dy; let back = view.z < 0.0;"
        "let c = prefiltered_components(fabric, p, to_face_frame(light, back),"
        "to_face_frame(view, back), back);"
    )
    results = "c.diffuse_warp; c.diffuse_weft; c.specular_warp; c.specular_weft; c.hole"
    found, expected = (
        mapped("prefiltered footprint point", body, results, arguments, packed)
        for packed in (baked.by_kernels, baked.by_python)
    )
    assert expected[:, :4].max(axis=0).min() > 0.05
    for column in range(5):
        assert share_beyond(found[:, column], expected[:, column]) <= MAX_QUERIES_BEYOND


def test_drafts_of_hundreds_of_threads_keep_default_limits() -> None:
    rng = np.random.default_rng(2)
    for shape in ((600, 600), (1200, 200)):
        plan = plan_bake(even_layout(rng.random(shape) < 0.5), GROUPS)
        sizes = {name: plan.value_of(size) for name, size in BUFFER_BYTES.items()}
        sizes["scratch"] = 4 * sum(plan.value_of(size) for size in SCRATCH.values())
        sizes["tables"] = 4 * sum(LobeTables.word_counts(plan.sizes).values())
        assert max(sizes.values()) <= MAX_BYTES, sizes
        columns, rows = (int(count) for count in plan.levels[0, 1:])
        for dispatch in DISPATCHES:
            threads = plan.value_of(dispatch.threads, {"level_columns": columns, "level_rows": rows})
            assert threads / dispatch.group / 32768 < MAX_WORKGROUPS


def test_kernels_bind_few_buffers() -> None:
    counts = {one.entry: len(declarations_of(one.module, one.entry)) for one in DISPATCHES}
    assert min(counts.values()) >= 2
    assert max(counts.values()) <= MAX_BUFFERS


def test_every_kernel_is_in_the_sequence() -> None:
    kernel = re.compile(r'\[shader\("compute"\)\].*?void (\w+)\(', re.DOTALL)
    written = {
        (path.stem, entry)
        for path in SHADERS.glob("bake_*.slang")
        for entry in kernel.findall(path.read_text(encoding="utf-8"))
    }
    # Openness is no table of lobes: a kernel of its own finds it.
    written.remove((OPENNESS_KERNEL, OPENNESS_KERNEL))
    assert written == {(dispatch.module, dispatch.entry) for dispatch in DISPATCHES}


def test_the_manifest_is_in_step() -> None:
    text = (SHADERS / "bake.json").read_text(encoding="utf-8")
    assert text == manifest()
    assert [one["entry"] for one in json.loads(text)["dispatches"]] == [one.entry for one in DISPATCHES]


@pytest.mark.slow
def test_a_frame_of_tables_baked_on_the_adapter_is_that_of_python() -> None:
    cloth = Cloth(rectangle(0.5, 0.5), load_fabric(EXAMPLES / "silk-satin.toml"))
    light = [DirectionalLight((0.5, 0.3, 0.8), (1, 1, 1))]
    camera = Camera((0, -0.4, 0.5))
    frames = [
        Renderer([cloth], (16, 16), "lobes", bake=place).render(camera, light, passes=1).linear
        for place in ("cpu", "gpu")
    ]
    assert frames[0].max() > 0.1
    assert share_beyond(frames[1], frames[0]) <= 1e-3
