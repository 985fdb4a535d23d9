"""Measured isotropic BRDFs of fabrics and felts, as the networks that Sztrajman et al. 2021 fitted to them.

The file, `measured/nbrdf_fabrics.npz` of the folder of data from outside, holds 21: of the MERL database, of
RGL and of Nielsen et al. 2015, 675 weights each. They are fits, whose error is not stated.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from studies.harness.study import outside_data

Floats = NDArray[np.float64]
FILE = ("measured", "nbrdf_fabrics.npz")


@dataclass(frozen=True, eq=False)
class MeasuredBrdf:
    """Layers of a network: pairs of weights [in, out] and biases [out]."""

    layers: tuple[tuple[Floats, Floats], ...]

    def value(self, light: Floats, view: Floats) -> Floats:
        """f of unit vectors [n, 3] with z > 0: linear RGB [n, 3], 1/sr, without the cosine."""
        half = light + view
        half /= np.linalg.norm(half, axis=1, keepdims=True)
        sine = np.hypot(half[:, 0], half[:, 1])
        # The light in the frame of the half vector: turned about z by −φ_h, then about y by −θ_h.
        cosine_phi, sine_phi = (
            np.divide(half[:, axis], sine, where=sine > 1e-9, out=np.zeros(len(half))) for axis in (0, 1)
        )
        cosine_phi[sine <= 1e-9] = 1
        along = cosine_phi * light[:, 0] + sine_phi * light[:, 1]
        across = cosine_phi * light[:, 1] - sine_phi * light[:, 0]
        turned = half[:, 2] * along - sine * light[:, 2], across, sine * along + half[:, 2] * light[:, 2]
        values = np.stack([sine, np.zeros_like(sine), half[:, 2], *turned], axis=1)
        for weights, biases in self.layers[:-1]:
            values = np.maximum(values @ weights + biases, 0)
        weights, biases = self.layers[-1]
        found: Floats = np.expm1(values @ weights + biases)
        return found


def measured_brdfs(file: Path | None = None) -> dict[str, MeasuredBrdf]:
    """All of the file by "set/name", sorted."""
    with np.load(file or outside_data(*FILE), allow_pickle=False) as arrays:
        found = sorted({key.rsplit("/", 1)[0] for key in arrays.files})
        return {
            name: MeasuredBrdf(
                tuple(
                    (arrays[f"{name}/w{number}"].astype(float), arrays[f"{name}/b{number}"].astype(float))
                    for number in range(3)
                )
            )
            for name in found
        }
