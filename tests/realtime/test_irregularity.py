"""Irregular yarns in Slang against Dr.Jit: means over boxes, shares, and where thick and thin yarns lie.

The bar is that of `parity.py`; whole queries of models are in tests/contract.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from drjit.llvm.ad import Bool, Float

from loomlight.core.footprint import Footprint
from loomlight.realtime.words import pack_fabrics
from loomlight.scattering.irregularity import BLOCK, IrregularYarns
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import pairs
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.layouts import TWILL, even_layout, random_layout
from tests.helpers.parity import FOOTPRINT, appearance, irregular
from tests.helpers.slang import mapped

COUNT = 20_000
LAYOUT = random_layout(np.random.default_rng(1), uneven=True)


def generator() -> np.random.Generator:
    return np.random.default_rng(60)


def test_means_over_footprints() -> None:
    """Of a hundredth of a millimetre to ten blocks of threads, many of which lie in two blocks."""
    rng = generator()
    looks = irregular(appearance(rng, LAYOUT, False, False))
    spacing = float(np.mean([LAYOUT.warp.spacing.mean(), LAYOUT.weft.spacing.mean()]))
    side = np.exp(rng.uniform(np.log(0.01), np.log(10 * BLOCK * spacing), COUNT))
    dx = np.float32(np.stack([side, rng.uniform(-0.2, 0.2, COUNT) * side], axis=1))
    dy = np.float32(dx[:, ::-1] * rng.uniform(0.1, 1, (COUNT, 1)))
    centre = np.float32(rng.uniform(-3 * BLOCK * spacing, 3 * BLOCK * spacing, (COUNT, 2)))
    view = clear_of_the_plane(rng, COUNT)
    body = FOOTPRINT + "let a = yarns_over(fabric, p, back);"
    results = (
        "a.warp.x; a.warp.y; a.warp.z; a.warp.w; a.weft.x; a.weft.y; a.weft.z; a.weft.w;"
        "a.shares.x; a.shares.y; a.shares.z"
    )
    rows = {"x": centre[:, 0], "y": centre[:, 1], "dx": dx, "dy": dy, "view": view}
    found = mapped("irregularity footprint", body, results, rows, (LAYOUT, looks))
    process = IrregularYarns(YarnGeometry(LAYOUT), looks)
    yarns = process.over(Footprint(pairs(centre), pairs(dx), pairs(dy)), Bool(view[:, 2] < 0))
    expected = [part for yarn in (yarns.warp, yarns.weft) for part in vars(yarn).values()]
    for column, values in enumerate([*expected, *yarns.shares]):
        assert np.ptp(found[:, column]) > 0.1, column
        # Differences of sums in single precision, to 1e-6 of 10, over a sixteenth of a thread.
        assert np.abs(found[:, column] - np.array(values)).max() <= 1e-4, column


def test_places_of_thick_and_thin_yarns() -> None:
    rng = generator()
    for layout in (LAYOUT, even_layout(TWILL)):
        looks = irregular(appearance(rng, layout, False, False))
        width, height = layout.size
        centre = np.float32(rng.uniform(-30, 30, (COUNT, 2)) * (width, height))
        # From a point to beyond a thread.
        size = np.float32(rng.choice([0, 0.2, 0.5, 1.2], COUNT) * layout.warp.spacing.mean())
        body = "let place = irregular_place(fabric, centre, size);"
        rows = {"centre": centre, "size": size}
        found = mapped("irregularity", body, "place.x; place.y", rows, (layout, looks))
        process = IrregularYarns(YarnGeometry(layout), looks)
        expected = np.array(process.place(pairs(centre), Float(size))).T
        moved = np.abs(expected - centre)
        assert moved.max() > 0.02 * layout.warp.spacing.mean()
        # At the edge of a cell, rounding decides between two threads: both lead to the same place.
        assert np.abs(found - expected).max() <= 1e-4 * layout.warp.spacing.mean()


def test_families_that_vary_alike_share_a_table() -> None:
    rng = generator()
    layout = even_layout(TWILL)
    plain = appearance(rng, layout, False, False)
    # Thick yarn is lighter in proportion to its albedo.
    plain = replace(plain, weft=plain.warp)
    alone, alike, apart = (
        pack_fabrics([(layout, looks)])
        for looks in (
            plain,
            irregular(plain, alike=True),
            irregular(plain),
        )
    )
    table = apart.words.size - alike.words.size
    assert alike.words.size - alone.words.size == table > 700_000
    tables = [[int(place) for place in packed.families["irregular_table"]] for packed in (alike, apart)]
    assert tables[0][0] == tables[0][1]
    assert tables[1][1] - tables[1][0] == table
