"""The decoder in torch: the readable reference of the one in Dr.Jit."""

from __future__ import annotations

import numpy as np
import torch
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.encoded_fabric import EncodedFabric, footprints_in_threads, taps
from studies.papers.chen2024.training.batches import coordinate_rows
from studies.papers.chen2024.training.losses import unmapped
from studies.papers.chen2024.training.network import ClothNetwork
from tests.helpers.neural_networks import linear_diffuse


def responses(
    made: ClothNetwork,
    encoded: EncodedFabric,
    fabric: Fabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    centres: NDArray[np.float64],
    sides: NDArray[np.float64],
) -> NDArray[np.float32]:
    """Components, 1/sr, and hole [n, 5] of square footprints, millimetres; views of either side."""
    footprints = footprints_in_threads(fabric.layout(), centres, sides)
    front, back = (face.astype(np.float32) for face in encoded.faces)
    behind = views[:, 2:] < 0
    if made.table.latent == "field":
        texels, weights = taps(encoded.pyramid, *footprints.T)
        latents = [np.einsum("nk,nkc->nc", weights, face[texels]) for face in (front, back)]
    else:
        latents = [front, back]
    latent = np.where(behind, latents[1], latents[0])
    place = coordinate_rows(made.table, encoded.picks, encoded.ends, footprints)
    turn = np.where(behind, [1, 1, -1], 1).astype(np.float32)
    fibres = np.where(behind[..., None], encoded.fibres.face(True), encoded.fibres.face(False))
    light = torch.tensor(lights * turn)
    bundles = np.where(behind[..., None, None], encoded.fibres.bundles(True), encoded.fibres.bundles(False))
    given = [latent, place, lights * turn, views * turn, fibres, bundles]
    if encoded.correction is not None:
        given.append(encoded.correction)
    with torch.no_grad():
        output, hole = made.decoder(*map(torch.tensor, given))
        components = unmapped(output, light, linear_diffuse(made))
    return np.concatenate([components.numpy(), hole.clamp(0, 1).numpy()[:, None]], 1)
