"""Edits of fabrics in buffers of an adapter: what is written, what is baked, what the tables then are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from loomlight.realtime.bake import DISPATCHES, plan_bake
from loomlight.realtime.device import default_adapter
from loomlight.realtime.fabric_buffers import FabricBuffers, Look
from tests.realtime.queries import appearance
from tests.yarn.layouts import PLAIN, TWILL, even_layout

GROUPS = 4


def contents(buffers: FabricBuffers) -> dict[str, bytes]:
    adapter = default_adapter()
    return {
        name: adapter.read(buffer, np.uint8, buffer.size).tobytes()
        for name, buffer in buffers.buffers.items()
    }


def bakes_of(look: Look) -> int:
    """Kernels of a whole bake: those of a level once for each level but the first and for each face."""
    levels = len(plan_bake(look[0], GROUPS).levels)
    return sum({"": 1, "face": 2, "level": 2 * (levels - 1)}[dispatch.each] for dispatch in DISPATCHES)


class Counted:
    """Two fabrics, and what the last edit of the first cost."""

    def __init__(self, looks: list[Look]) -> None:
        self.looks = looks
        self.buffers = FabricBuffers(default_adapter(), looks, groups=GROUPS)

    def edit(self, look: Look) -> tuple[int, int]:
        """Writes and kernels of an edit."""
        before = self.buffers.writes, self.buffers.dispatches
        self.looks[0] = look
        self.buffers.set_fabric(0, look)
        return self.buffers.writes - before[0], self.buffers.dispatches - before[1]


@pytest.fixture(scope="module")
def edited() -> Counted:
    rng = np.random.default_rng(7)
    layouts = even_layout(TWILL), even_layout(PLAIN)
    return Counted([(layout, appearance(rng, layout, True, False)) for layout in layouts])


def test_a_colour_rewrites_albedos_and_nothing_else(edited: Counted) -> None:
    layout, look = edited.looks[0]
    warp = replace(look.warp, diffuse_reflect=look.warp.diffuse_reflect * 0.5)
    before = contents(edited.buffers)
    # The threads' albedos and their mean over footprints lie side by side.
    assert edited.edit((layout, replace(look, warp=warp))) == (1, 0)
    after = contents(edited.buffers)
    assert after["fabrics"] == before["fabrics"]
    assert after["families"] == before["families"]
    changed = np.frombuffer(after["words"], np.uint32) != np.frombuffer(before["words"], np.uint32)
    assert np.count_nonzero(changed) == 6


def test_a_roughness_rewrites_one_number(edited: Counted) -> None:
    layout, look = edited.looks[0]
    assert edited.edit((layout, replace(look, warp=replace(look.warp, roughness=0.55)))) == (1, 0)


def test_no_change_writes_nothing(edited: Counted) -> None:
    assert edited.edit(edited.looks[0]) == (0, 0)


def test_a_height_bakes_one_fabric(edited: Counted) -> None:
    layout, look = edited.looks[0]
    taller = replace(layout, warp=replace(layout.warp, height_scale=0.9))
    writes, kernels = edited.edit((taller, look))
    assert kernels == bakes_of((taller, look))
    assert writes <= 8


def test_tables_that_grow_keep_what_is_baked(edited: Counted) -> None:
    """Colours that differ by thread need larger tables: those of lobes are copied, not baked."""
    layout, look = edited.looks[0]
    varied = appearance(np.random.default_rng(8), layout, True, True)
    writes, kernels = edited.edit((layout, replace(varied, diffuse_blend=look.diffuse_blend)))
    assert (writes, kernels) == (4, 0)


def test_a_weave_bakes_one_fabric_and_all_edits_leave_the_buffers_of_a_new_start(edited: Counted) -> None:
    weave = even_layout(PLAIN, spacing=0.3)
    look = weave, appearance(np.random.default_rng(9), weave, True, False)
    assert edited.edit(look) == (4 + 2, bakes_of(look))
    fresh = FabricBuffers(default_adapter(), edited.looks, groups=GROUPS)
    found, expected = contents(edited.buffers), contents(fresh)
    assert {name: found[name] == expected[name] for name in expected} == dict.fromkeys(expected, True)
