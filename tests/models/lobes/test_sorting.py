"""Sums over rays by group as machine code, against numpy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.lane_code import Vectors
from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.lobes.groups import NORMAL_SHARE, SUMS, sums_of
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.models.lobes.sorting_code import CENTRE, DIRECTION, LIT_SUMS, ROW, lit_code, seen_code

# Of other processors: LLVM splits vectors that are too long.
WIDTHS = [vectors(), Vectors(4, 16), Vectors(8, 16)]
RAYS, GROUPS, OF_WARP = 256, 12, (8, 4)
BLEND = 0.7
COUNT = 2 * NODES * RAYS


def units(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors [3, n]."""
    found = rng.normal(size=(3, count))
    return (found / np.linalg.norm(found, axis=0)).astype(np.float32)


class Rays:
    """Rays that met anything, and the group of each by numpy; −1 where nothing counts."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.family = rng.choice([-1, 0, 1], COUNT, p=[0.1, 0.3, 0.6]).astype(np.float32)
        self.normal, self.tangent = units(rng, COUNT), units(rng, COUNT)
        self.free = rng.choice([0, 1], COUNT).astype(np.float32)
        self.centres = np.zeros((2, GROUPS, CENTRE), np.float32)
        self.centres[..., :6] = 0.6 * rng.normal(size=(2, GROUPS, 6))
        is_warp = np.arange(GROUPS) < np.array(OF_WARP)[:, None]
        self.centres[..., 6] = is_warp
        features = np.concatenate([np.float32(NORMAL_SHARE) * self.normal, self.tangent]).T
        self.group = np.full(COUNT, -1)
        for face, rays in enumerate(np.split(np.arange(COUNT), 2)):
            distance = np.square(features[rays, None] - self.centres[face, :, :6]).sum(axis=2)
            distance[is_warp[face] != self.family[rays, None]] = np.inf
            self.group[rays] = np.where(self.family[rays] < 0, -1, distance.argmin(axis=1))
        directions = np.zeros((NODES, DIRECTION), np.float32)
        directions[:, :3] = node_directions()
        self.shared = [self.centres, directions, np.array([GROUPS, BLEND], np.float32)]

    def met(self) -> list[NDArray[np.float32]]:
        return [self.family, *self.normal, *self.tangent]

    def sums(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Sums of values [n] by face, node and group."""
        block = np.arange(COUNT) // RAYS
        counts = self.group >= 0
        place = block[counts] * GROUPS + self.group[counts]
        return np.bincount(place, values[counts], 2 * NODES * GROUPS).reshape(2, NODES, GROUPS)


def added_up(code: MachineCode, asked: list[NDArray[np.float32]], rays: Rays) -> NDArray[np.float32]:
    found = np.full(COUNT, np.nan, np.float32)
    code.run(COUNT, asked, [found], rays.shared)
    return found.reshape(2, NODES, -1, ROW)[:, :, :GROUPS]


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_views_are_added_up_by_group(wide: Vectors) -> None:
    rays = Rays(1)
    found = added_up(MachineCode(seen_code(RAYS, wide)), rays.met(), rays)
    wanted = [np.ones(COUNT), *sums_of(rays.normal.astype(float), rays.tangent.astype(float))]
    assert len(wanted) == SUMS
    np.testing.assert_array_equal(found[..., 0], rays.sums(wanted[0]))
    for number, values in enumerate(wanted):
        # Sums of up to 256 numbers up to 1 in single precision.
        np.testing.assert_allclose(found[..., number], rays.sums(values), atol=1e-4)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_light_is_added_up_by_group(wide: Vectors) -> None:
    """That from the other side falls on the other face, whose normals are mirrored, at the same places."""
    rays = Rays(2)
    found = added_up(MachineCode(lit_code(RAYS, wide)), [*rays.met(), rays.free], rays)
    towards = np.tile(np.repeat(node_directions().T, RAYS, axis=1), 2)
    behind = np.roll(rays.free, COUNT // 2)
    facing = (rays.normal * towards).sum(axis=0)
    opposite = -(rays.normal * towards * [[1], [1], [-1]]).sum(axis=0)
    wanted = [np.ones(COUNT), rays.free, behind]
    for free, cosine in ((rays.free, facing), (behind, opposite)):
        wanted.append(free * (BLEND * np.maximum(cosine, 0) + (1 - BLEND) * towards[2]))
    assert len(wanted) == LIT_SUMS
    for number, values in enumerate(wanted):
        np.testing.assert_allclose(found[..., number], rays.sums(values), atol=1e-4)


def test_a_ray_counts_where_its_face_has_such_groups() -> None:
    """Groups of the other family are left out, however near; a face's own are taken."""
    rays = Rays(3)
    number = NODES * RAYS + 5
    for array, value in ((rays.family, 0.0), (rays.normal, rays.normal[:, number]), (rays.group, 7)):
        array[..., number] = value
    # A centre of the back's warp lies right there, and one of its weft far off.
    features = np.concatenate([NORMAL_SHARE * rays.normal[:, number], rays.tangent[:, number]])
    rays.centres[1, 0, :6] = features
    rays.centres[1, 7, :6] = features + 0.01
    found = added_up(MachineCode(seen_code(RAYS, vectors())), rays.met(), rays)
    alone = [part.copy() for part in rays.met()]
    alone[0][:] = -1
    alone[0][number] = 0
    only = added_up(MachineCode(seen_code(RAYS, vectors())), alone, rays)[..., 0]
    assert only.sum() == 1
    assert only[1, 0, 7] == 1
    assert found[1, 0, 7, 0] >= 1
    assert math.isclose(found[..., 0].sum(), (rays.family >= 0).sum())
