"""Shaders in WGSL have few branches in loops, so that browsers in software compile them in seconds.

SwiftShader, which Chromium has where there is no graphics device, walks all ways through a loop. `select` and
`&` are values to it, `?:` and `&&` are branches: see `numbers.slang`.
"""

from __future__ import annotations

import pytest

from loomlight.realtime.slangc import SHADERS
from tests.realtime.control_flow import diamonds_in_loops

WGSL = SHADERS / "wgsl"
# Diamonds in the loop that has most, of each file, rounded up. Chromium compiles `shade_lobes` in 11 s so,
# `bake_openness` in 3 and `cast_shadows` in 2; with `?:`, `cast_shadows` had 163 and took more than 140 s.
# Some eight are of layers, which scenes without any leave out (`planes.slang`).
BOUNDS = {
    "add_background": 3,
    "bake_coverage": 2,
    "bake_groups": 15,
    "bake_openness": 30,
    "bake_points": 4,
    "bake_rays": 21,
    "bake_tables": 3,
    "cast_shadows": 28,
    "first_layer": 0,
    "next_layer": 3,
    "raster_fragment": 0,
    "raster_vertex": 0,
    "shade_clustered": 14,
    "shade_latent": 7,
    "shade_lobes": 68,
    "shade_neumip": 7,
    "shade_neural": 15,
    "shade_points": 50,
    "tone_map": 0,
}
LOOP = """
fn inner_0(x : f32) -> f32 { if(x > 0.0f) { return 1.0f; } return select(x, 2.0f, x < 1.0f); }
fn main() {
  if(a) { b = 1; } else { b = 2; }
  for(;;) {
    if(i < 4) { } else { break; }
    BODY
    i = i + 1;
  }
}
"""


def test_every_shader_has_a_bound() -> None:
    assert set(BOUNDS) == {path.stem for path in WGSL.iterdir()}


@pytest.mark.parametrize("name", BOUNDS)
def test_loops_have_few_diamonds(name: str) -> None:
    """Where a bound does not hold, see whether a `?:` or `&&` with cheap sides can be a `select` or `&`."""
    assert diamonds_in_loops((WGSL / f"{name}.wgsl").read_text(encoding="utf-8")) <= BOUNDS[name]


@pytest.mark.parametrize(
    ("body", "ways"),
    [
        ("x = select(1, 2, c);", 2),  # the end of the loop, and its next turn
        ("if(c) { x = 1; }", 3),
        ("if(c) { x = 1; } else if(d) { x = 2; } else { x = 3; }", 4),
        ("if(c) { x = 1; } if(d) { x = 2; }", 5),
        ("if(c) { continue; } if(d) { return; }", 4),
        ("x = inner_0(x) + inner_0(y);", 5),
        ("for(;;) { if(c) { break; } if(d) { return; } }", 3),
    ],
)
def test_ways_through_a_loop_are_counted(body: str, ways: int) -> None:
    assert 2 ** diamonds_in_loops(LOOP.replace("BODY", body)) == pytest.approx(ways)
