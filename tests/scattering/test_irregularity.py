"""Irregular yarns: the process has the statistics asked for, and footprints show its exact means.

Covers: scattering/irregularity.py
"""

from __future__ import annotations

import dataclasses
import math
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Array2f, Bool, Float

from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.scattering import irregularity
from loomlight.scattering.appearance import Appearance, Irregularity
from loomlight.scattering.irregularity import BLOCK, ROWS, SAMPLES, STEP, IrregularYarns, toned
from loomlight.yarn.geometry import YarnGeometry

require_llvm()

FLAX = Irregularity(
    mass_cv=0.25,
    fibre_length=60,
    thick_places=10,
    thick_length=25,
    shade=0.4,
    melange=0.2,
    neps=8,
    nep_albedo=(0.7, 0.1, 0.05),
)
COTTON = Irregularity(mass_cv=0.15, fibre_length=28, shade=0.3)
TEXT = """
weave = "plain"
ends_per_cm = 15
picks_per_cm = 14
gap = {gap}
[variation]
colour_noise = 0.1
seed = 3
"""


def appearance_of(
    warp: Irregularity, weft: Irregularity, gap: float = 0.2
) -> tuple[YarnGeometry, Appearance]:
    fabric = fabric_from_text(TEXT.format(gap=gap))
    appearance = fabric.appearance()
    return YarnGeometry(fabric.layout()), dataclasses.replace(
        appearance,
        warp=dataclasses.replace(appearance.warp, irregularity=warp),
        weft=dataclasses.replace(appearance.weft, irregularity=weft),
    )


@cache
def yarns(gap: float = 0.2) -> IrregularYarns:
    return IrregularYarns(*appearance_of(FLAX, COTTON, gap))


def grid(count: int, width: float, length: float) -> tuple[Array2f, Array2f]:
    """Centres of boxes side by side, `count` across and along, and their size: millimetres."""
    column, row = np.meshgrid(np.arange(count) + 0.5, np.arange(count) + 0.5)
    centres = Array2f(
        Float((column.ravel() * width).astype(np.float32)), Float((row.ravel() * length).astype(np.float32))
    )
    return centres, Array2f(Float(width), Float(length))


@pytest.mark.parametrize("yarn", [FLAX, COTTON, Irregularity(mass_cv=0.02, fibre_length=1500)])
def test_lengths_of_8_mm_vary_as_asked(yarn: Irregularity) -> None:
    mass = irregularity.waves(irregularity.mass_spectrum(yarn), stream=1)
    cuts = mass.reshape(ROWS, -1, round(irregularity.CUT_LENGTH / STEP)).mean(axis=-1)
    # Samples are means of steps of 2 mm here, and points of waves in the spectrum: 1 % at 8 mm.
    assert cuts.std() == pytest.approx(yarn.mass_cv, rel=0.02)


def test_drafting_waves_are_longer_than_fibres() -> None:
    spectrum, f = irregularity.mass_spectrum(COTTON), irregularity.frequencies()
    # Uster's spectrograms show variance by the logarithm of the wavelength.
    peak = 1 / f[np.argmax(spectrum * f)]
    assert 2.5 * COTTON.fibre_length <= peak <= 3 * COTTON.fibre_length


def test_thick_places_are_as_frequent_and_as_large_as_asked() -> None:
    found = irregularity.places(10, 30, stream=5)
    metres = ROWS * SAMPLES * STEP / 1000
    # A bump has the mean height 1 and half its length's area: 10 × 0.03 × 0.5 a metre; 2600 bumps.
    assert found.sum() * STEP / 1000 / metres == pytest.approx(10 * 0.03 * 0.5, rel=0.06)
    # Few lie over each other.
    assert 1.3 < np.quantile(found[found > 0], 0.999) < 3


@pytest.mark.parametrize("name", ["thickness_of", "tone_of", "nep_of", "cover_of"])
def test_every_ring_has_mean_0(name: str) -> None:
    if name == "cover_of":
        rows = irregularity.cover_of(irregularity.thickness_of(FLAX), 0.8)
    else:
        more = (irregularity.thickness_of(FLAX), 1.5, 0.1) if name == "tone_of" else ()
        rows = getattr(irregularity, name)(FLAX, *more)
    assert np.abs(rows.mean(axis=1)).max() < 1e-12
    assert rows.std() > 0.01


def test_no_yarn_is_wider_than_its_cell() -> None:
    thickness = irregularity.thickness_of(FLAX)
    for cover in (0.5, 0.9, 1.0):
        covered = cover * (1 + irregularity.cover_of(thickness, cover))
        # Rings are moved to the mean 0, by less than a hundredth.
        assert covered.min() > 0
        assert covered.max() < 1.03
    assert np.abs(irregularity.cover_of(thickness, 1.0)).max() < 1e-6 + 0.03


def test_means_over_boxes_are_those_of_the_process() -> None:
    """Boxes within one block, over its edges, and narrower than a thread, step by step."""
    found = yarns()
    process = found.on(irregularity.array_types(Float))
    family = process._families[0]
    rng = np.random.default_rng(1)
    place, width = rng.uniform(-200, 300, 300), rng.uniform(0.1, BLOCK - 1, 300)
    along, length = rng.uniform(-900, 900, 300), rng.uniform(2, 90, 300)
    got = family.over(*(Float(part.astype(np.float32)) for part in (place, width, along, length)))
    table = found.tables[0]
    closed = np.concatenate([table.integrals, np.zeros_like(table.integrals[:, :1])], axis=1)
    steps = np.diff(np.diff(closed.astype(np.float64), axis=0), axis=1) * table.units
    key = np.uint32(family.key.numpy()[0])
    for number in range(300):
        first, last = place[number] - width[number] / 2, place[number] + width[number] / 2
        total = np.zeros(4)
        for thread in range(math.floor(first), math.floor(last) + 1):
            bits = int(
                irregularity._scrambled(np.array([(thread // BLOCK) & 0xFFFFFFFF], np.uint32) + key)[0]
            )
            row = steps[bits % ROWS + thread % BLOCK]
            begin = (along[number] - length[number] / 2) / STEP + (bits >> 22)
            end = begin + length[number] / STEP
            columns = np.arange(math.floor(begin), math.floor(end) + 1)
            shares = np.minimum(end, columns + 1) - np.maximum(begin, columns)
            share = min(last, thread + 1) - max(first, thread)
            total += max(share, 0) * (shares[:, None] * row[columns % SAMPLES]).sum(axis=0)
        expected = total / (width[number] * length[number] / STEP)
        actual = [getattr(got, name).numpy()[number] for name in ("thickness", "cover", "tone", "nep")]
        # Positions of 900 mm have steps of 3e-5 of a millimetre.
        np.testing.assert_allclose(actual, expected, atol=1e-4)


@pytest.mark.parametrize("threads", [1, 3, 10])
def test_variances_of_footprints_are_those_of_the_process(threads: int) -> None:
    """Of threads that vary independently, means vary as the root of their number."""
    found, spacing = yarns(), 10 / 15
    centres, size = grid(400, threads * spacing, threads * spacing)
    over = found.over(box_footprint(Box(centres, size)), Bool(False))
    per_gain = round(irregularity.depth_per_gain(appearance_of(FLAX, COTTON)[1].warp), 1)
    tone = irregularity.tone_of(FLAX, irregularity.thickness_of(FLAX), per_gain, 0.1)
    power = np.abs(np.fft.rfft(tone, axis=1)) ** 2
    filtered = np.sinc(np.fft.rfftfreq(SAMPLES, STEP) * max(threads * spacing, STEP)) ** 2
    twice = np.full(len(filtered), 2.0)
    twice[[0, -1]] = 1
    variance = (power.mean(axis=0) * filtered * twice).sum() / SAMPLES**2 / threads
    # The table's threads are 128 of all, and its steps are constant within 2 mm.
    assert over.warp.tone.numpy().std() == pytest.approx(math.sqrt(variance), rel=0.1)


def test_cloth_shows_what_even_cloth_does_on_average() -> None:
    found = yarns()
    centres, size = grid(500, 2.0, 2.0)
    over = found.over(box_footprint(Box(centres, size)), Bool(False))
    # A square metre of 1500 by 1400 threads.
    for share in over.shares:
        assert np.mean(share.numpy()) == pytest.approx(1, abs=0.01)
        assert np.std(share.numpy()) > 0.01
    for yarn in (over.warp, over.weft):
        assert np.mean(yarn.tone.numpy()) == pytest.approx(0, abs=0.01)


def test_nothing_repeats_over_a_metre() -> None:
    found, spacing = yarns(), 10 / 15
    count = 1024
    centres, size = grid(count, spacing, spacing)
    # Tone of the warp alone: the weft has its own process.
    tone = found.over(box_footprint(Box(centres, size)), Bool(False)).warp.tone.numpy().reshape(count, count)
    tone = tone - tone.mean()
    padded = np.fft.rfft2(tone, (2 * count, 2 * count))
    correlation = np.fft.irfft2(np.abs(padded) ** 2) / (tone**2).sum()
    # Waves run on along a thread: what is looked for is another thread that is the same.
    correlation[:, 0] = 0
    assert np.abs(correlation).max() < 0.1


def test_tones_keep_the_mean_and_the_energy_bound() -> None:
    rng = np.random.default_rng(2)
    count = 4096
    half = rng.uniform(0, irregularity.LARGEST_TONE, count)
    tone = np.concatenate([half, -half])
    yarn = irregularity.Yarn(Float(0), Float(0), Float(tone.astype(np.float32)), Float(0))
    types = irregularity.array_types(Float)
    for reflect, transmit, specular in (
        (0.05, 0.01, 0.2),
        (0.4, 0.2, 0.3),
        (0.6, 0.1, 0.28),
        (0.02, 0.0, 0.9),
    ):
        albedos = tuple(types.Color3(value) for value in (reflect, transmit, specular, specular / 2))
        got = toned(albedos, yarn, Float(1.0), None)
        assert np.mean(got[0].numpy()) == pytest.approx(reflect, rel=1e-3)
        total = got[0] + got[1] + got[2]
        assert total.numpy().max() <= 1 + 1e-5
        assert got[0].numpy().min() >= 0
        assert got[0].numpy().std() > 0


def test_wide_yarns_take_room_of_gaps_and_do_not_fold() -> None:
    found, spacing = yarns(), 10 / 15
    count = 20_000
    x = np.linspace(0, 40 * spacing, count).astype(np.float32)
    place = found.place(Array2f(Float(x), Float(11.0)))
    moved = place.x.numpy()
    assert (np.diff(moved) > -1e-4).all()
    assert 0.005 < (moved - x).std() / spacing < 0.2
    # In the middle of a thread nothing moves.
    middle = (np.arange(40) + 0.5) * spacing
    still = found.place(Array2f(Float(middle.astype(np.float32)), Float(11.0))).x.numpy()
    np.testing.assert_allclose(still, middle, atol=1e-4)


def test_far_footprints_do_not_move() -> None:
    centre = Array2f(Float([3.1, 7.7]), Float([1.3, 2.2]))
    moved = yarns().place(centre, Float(2.0))
    assert dr.all(moved == centre, axis=None)


def test_even_yarns_have_no_process() -> None:
    even = IrregularYarns(*appearance_of(Irregularity(), Irregularity()))
    assert not even.is_on
    centre = Array2f(Float([3.0]), Float([1.0]))
    assert even.place(centre) is centre
