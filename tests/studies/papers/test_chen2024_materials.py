"""The paper's 465 materials: how many of each weave, in which ranges, and the same whenever they are made.

Covers: studies/papers/chen2024/materials.py
"""

from collections import Counter

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.models.neural.weights import PARAMETER_RANGES
from studies.papers.chen2024.materials import MATERIALS, paper_material

# Ends and picks of one repeat that the paper names (its "5×10" is read as 5 ends by 10 picks).
REPEATS = {
    "plain": (2, 2),
    "twill 3×3": (3, 3),
    "twill 5×5": (5, 5),
    "twill 8×8": (8, 8),
    "satin 5×5": (5, 5),
    "satin 8×8": (8, 8),
    "satin 5×10": (5, 10),
}


def yarns(numbers, seed=0):
    """ψ, U, α and β of both families [n, 2, 4]."""
    rows = []
    for number in numbers:
        fabric = paper_material(number, seed)
        rows.append(
            [
                (table.twist_deg, table.inclination_deg, table.roughness, table.height_scale)
                for table in (fabric.fields.warp, fabric.fields.weft)
            ]
        )
    return np.asarray(rows)


ALL = yarns(range(465))


def test_so_many_materials_of_each_weave_as_in_the_paper():
    counts = Counter(material.weave.split()[0] for material in MATERIALS)
    assert counts == {"plain": 81, "twill": 192, "satin": 192}
    assert Counter(Counter(material.weave for material in MATERIALS).values()) == {81: 1, 64: 6}


def test_repeats_are_those_of_the_paper():
    for number in range(0, 465, 40):
        picks, ends = paper_material(number).layout().warp_on_top.shape
        assert (ends, picks) == REPEATS[MATERIALS[number].weave]


def test_a_fifth_of_the_spacing_is_open():
    layout = paper_material(200).layout()
    np.testing.assert_allclose(layout.warp.width / layout.warp.spacing, 0.8)
    np.testing.assert_allclose(layout.weft.width / layout.weft.spacing, 0.8)


def test_parameters_fill_the_ranges():
    ranges = PARAMETER_RANGES
    satin = np.asarray([material.weave.startswith("satin") for material in MATERIALS])
    columns = [ranges.twist_deg, None, ranges.roughness, ranges.height_scale]
    for column, bounds in enumerate(columns):
        if bounds is not None:
            values = ALL[..., column]
            assert values.min() >= bounds[0]
            assert values.max() <= bounds[1]
    assert ALL[~satin][..., 1].max() <= ranges.inclination_deg[1]
    assert ALL[..., 1].min() >= ranges.inclination_deg[0]
    assert ranges.inclination_deg[1] < ALL[satin][..., 1].max() <= ranges.satin_inclination_deg[1]
    # The paper's range of α and β spans at least 0.2 to 0.8.
    assert (ALL[..., 2:].min(axis=(0, 1)) < 0.25).all()
    assert (ALL[..., 2:].max(axis=(0, 1)) > 0.8).all()


def test_each_set_covers_its_cells():
    """The 9 or 16 sets of one shape have a warp in every cell of (log α, β), and a weft."""
    ranges = PARAMETER_RANGES
    low, high = np.log(ranges.roughness)
    for first, side in ((0, 3), (81, 4)):
        part = ALL[first : first + side * side]
        roughness = (np.log(part[..., 2]) - low) / (high - low)
        height = (part[..., 3] - ranges.height_scale[0]) / (ranges.height_scale[1] - ranges.height_scale[0])
        cells = np.floor(roughness * side) * side + np.floor(height * side)
        for family in (0, 1):
            assert len(set(cells[:, family])) == side * side
        # The families are drawn on their own: they share a cell now and then, never always.
        assert (cells[:, 0] != cells[:, 1]).any()


def test_materials_of_one_shape_share_twist_and_inclination():
    assert (ALL[81:97, :, :2] == ALL[81, :, :2]).all()
    assert (ALL[97, :, :2] != ALL[81, :, :2]).all()


def test_a_material_depends_on_its_number_and_the_seed_alone():
    np.testing.assert_array_equal(yarns([300, 7]), ALL[[300, 7]])
    assert (yarns([300], seed=1) != ALL[300]).all()


@pytest.mark.parametrize("number", [-1, 465])
def test_other_numbers_are_refused(number):
    with pytest.raises(InputError, match="0 to 464"):
        paper_material(number)
