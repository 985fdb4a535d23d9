"""Nodes of the hemisphere and interpolation between them."""

from __future__ import annotations

import math

import numpy as np
from drjit.llvm.ad import Array3f

from loomlight.models.lobes.hemisphere import NODES, node_directions, node_taps
from tests.helpers.directions import directions


def test_a_node_has_itself_alone() -> None:
    nodes = node_directions()
    assert nodes.shape == (NODES, 3)
    np.testing.assert_allclose(np.linalg.norm(nodes, axis=1), 1, atol=1e-12)
    # A node has itself alone, on both sides.
    for sign in (1, -1):
        taps = node_taps(Array3f(*np.ascontiguousarray((nodes * [1, 1, sign]).T, np.float32)))
        table = np.eye(NODES)
        weights = np.stack([part.numpy() for part in taps.weights._integers], axis=1)
        numbers = np.stack([part.numpy() for part in taps.nodes], axis=1)
        actual = np.einsum("nt,ntk->nk", weights / weights.sum(axis=1, keepdims=True), table[numbers])
        # At the zenith azimuths do not matter.
        low = nodes[:, 2] < 1 - 1e-9
        np.testing.assert_allclose(actual[low], table[low], atol=0.01)


def test_directions_lie_between_their_nodes() -> None:
    nodes = node_directions()
    queries = directions(np.random.default_rng(3), 2000, 0.05)
    taps = node_taps(Array3f(*np.ascontiguousarray(queries.T, np.float32)))
    units = np.stack([part.numpy() for part in taps.weights._integers], axis=1).astype(np.float64)
    numbers = np.stack([part.numpy() for part in taps.nodes], axis=1)
    mean = np.einsum("nt,ntk->nk", units / units.sum(axis=1, keepdims=True), nodes[numbers])
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    upright = queries * np.column_stack([np.ones((len(queries), 2)), np.sign(queries[:, 2])])
    # Interpolated nodes point close to where was asked: rings and azimuths are some 20° apart.
    assert ((mean * upright).sum(axis=1) > math.cos(math.radians(5))).all()
