"""What clusters of visibility can take of the noise of points, by how visibility is described.

    python -m experiments.clustered_visibility [--texels 64] [--pairs 96]
        [--output experiments/results/clustered_visibility.json]

zhu2024's control variate at its best: f of every texel of a repeat is known without error, and so is its
mean; only visibility is replaced by the mean of the texel's cluster (eq. 8). Noise falls by
Var(f·v) / Var(f·(v − v̄)) over texels. v is the truth, 0 or 1 by the horizon of the yarns, or the paper's
anisotropic spherical Gaussian of a texel (4.2), min(1, c·max(z·i, 0)·exp(−λ(x·i)² − μ(y·i)²)), fitted by
least squares to the truth over 288 directions of equal solid angle. Clusters are those of k-means over these
directions. Lights and views are random above 14° of elevation, without parallax; ratios are harmonic means
over the pairs, as noise adds up over the pixels of a picture. Beside them the error of the fit, root mean
square, and what shading by the Gaussians has too much, as a mean over the pairs.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

import drjit as dr
import numpy as np
import torch
from numpy.typing import NDArray
from scipy.cluster.vq import kmeans2

from benchmarks.harness import Figures, run
from loomlight.aggregate.components import colours
from loomlight.core.backend import array_types
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import PointModel
from loomlight.scattering.yarn_point import YarnPoint
from loomlight.yarn.geometry import YarnGeometry
from papers.zhu2024.scenes import table_fabric

FABRICS = ("drape satin", "cylinder twill", "plain")
CLUSTERS = (8, 16, 64)
_RINGS, _SECTORS = 12, 24
_LOWEST_COSINE = 0.25
_STEPS, _RATE = 400, 0.05
_STARTS = 4

Array = NDArray[np.float64]


class Texels:
    """Yarn points at the texels of one repeat, seen from above."""

    def __init__(self, fabric: Fabric, texels: int) -> None:
        self._types = array_types(llvm_float())
        self._model = PointModel(YarnGeometry(fabric.layout()), fabric.appearance())
        line = (np.arange(texels) + 0.5) / texels
        width, height = fabric.repeat_mm
        y, x = (part.ravel() for part in np.meshgrid(line * height, line * width, indexing="ij"))
        self.count = texels**2
        place_x, place_y = (self._types.Float(part.astype(np.float32)) for part in (x, y))
        front = self._types.Bool(False)
        _, hole = self._model.surface.height(place_x, place_y, front)
        self.point: YarnPoint = self._model.at(place_x, place_y, front, hole)

    def visible(self, light: Array) -> Array:
        """1 where the light is seen [texels]."""
        lit = self._model.visibility(self.point, self._types.Vector3(*map(float, light)))
        return np.broadcast_to(np.float64(dr.select(lit, self._types.Float(1), 0).numpy()), (self.count,))

    def shading(self, light: Array, view: Array) -> Array:
        """f·cos without shadow, green [texels]."""
        towards_light, towards_view = (self._types.Vector3(*map(float, part)) for part in (light, view))
        always = self._types.Bool(True)
        found = colours(self._model.appearance, self.point, towards_light, towards_view, always)
        return np.broadcast_to(np.float64(found.y.numpy()), (self.count,))


def bins() -> Array:
    """Directions of equal solid angle over the hemisphere [bins, 3]."""
    z = np.repeat((np.arange(_RINGS) + 0.5) / _RINGS, _SECTORS)
    azimuth = np.tile(2 * np.pi * (np.arange(_SECTORS) + 0.5) / _SECTORS, _RINGS)
    radius = np.sqrt(1 - z * z)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)


class Gaussians:
    """An anisotropic spherical Gaussian a texel, fitted to visibility [texels, bins]."""

    def __init__(self, visible: Array) -> None:
        torch.manual_seed(0)
        seen = torch.from_numpy(visible.astype(np.float32))
        directions = torch.from_numpy(bins().astype(np.float32))
        # Axes begin at the mean of the visible directions.
        start = torch.zeros(len(seen), 6)
        self._axis = torch.nn.functional.normalize(seen @ directions + 1e-3 * directions.mean(0), dim=1)
        start[:, 2:4], start[:, 4] = -1.0, 0.7
        self._numbers = start.requires_grad_(True)
        self._moved = torch.zeros(len(seen), 3, requires_grad=True)
        parameters = [self._numbers, self._moved]
        descent = torch.optim.Adam(parameters, _RATE)
        for step in range(_STEPS):
            descent.param_groups[0]["lr"] = _RATE * (1 - step / _STEPS)
            descent.zero_grad()
            (self._at(directions) - seen).square().mean(1).sum().backward()
            descent.step()

    def _at(self, directions: torch.Tensor) -> torch.Tensor:
        z = torch.nn.functional.normalize(self._axis + self._moved, dim=1)
        turn = self._numbers[:, 0:1]
        side = torch.cross(z, torch.tensor([[0.0, 1.0, 0.0]]).expand_as(z), dim=1)
        side = torch.nn.functional.normalize(side, dim=1)
        other = torch.cross(z, side, dim=1)
        x = torch.cos(turn) * side + torch.sin(turn) * other
        y = torch.cos(turn) * other - torch.sin(turn) * side
        sharp = torch.exp(self._numbers[:, 2:4])
        across = (x @ directions.T).square() * sharp[:, :1] + (y @ directions.T).square() * sharp[:, 1:]
        height = torch.exp(self._numbers[:, 4:5])
        return torch.clamp(height * torch.relu(z @ directions.T) * torch.exp(-across), max=1.0)

    def at(self, directions: Array) -> Array:
        """Values for directions [n, 3]: [texels, n]."""
        with torch.no_grad():
            return self._at(torch.from_numpy(directions.astype(np.float32))).numpy().astype(np.float64)


def clusters_of(rows: Array, count: int) -> NDArray[np.intp]:
    """Cluster of each texel by its visibility from all bins: the best of some starts."""
    found = [kmeans2(rows, count, minit="++", seed=seed) for seed in range(_STARTS)]
    return min(found, key=lambda means: float(np.square(rows - means[0][means[1]]).sum()))[1]


def less_noise(shading: Array, visible: Array, labels: NDArray[np.intp]) -> float:
    """Var(f·v) over Var(f·(v − v̄)), v̄ the mean visibility of a cluster for this light."""
    counts = np.maximum(np.bincount(labels), 1)
    means = np.bincount(labels, visible) / counts
    left = float(np.var(shading * (visible - means[labels])))
    return float(np.var(shading * visible)) / max(left, 1e-12)


def row_of(fabric: Fabric, texels: int, pairs: int) -> Figures:
    """The figures of one fabric."""
    points = Texels(fabric, texels)
    truth = np.stack([points.visible(light) for light in bins()], axis=1)
    lobes = Gaussians(truth)
    fitted = lobes.at(bins())
    labels = {
        "truth": {count: clusters_of(truth, count) for count in CLUSTERS},
        "gaussians": {count: clusters_of(fitted, count) for count in CLUSTERS},
    }
    rng = np.random.default_rng(0)
    z = rng.uniform(_LOWEST_COSINE, 1, (2, pairs))
    azimuth = rng.uniform(0, 2 * np.pi, (2, pairs))
    radius = np.sqrt(1 - z * z)
    lights, views = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=2)
    inverse: dict[str, dict[int, list[float]]] = {k: {n: [] for n in CLUSTERS} for k in labels}
    shares: list[float] = []
    for light, view in zip(lights, views, strict=True):
        shading = points.shading(light, view)
        seen = {"truth": points.visible(light), "gaussians": lobes.at(light[None])[:, 0]}
        shares.append(float((shading * seen["gaussians"]).sum() / (shading * seen["truth"]).sum() - 1))
        for kind, found in labels.items():
            for count, label in found.items():
                inverse[kind][count].append(1 / less_noise(shading, seen[kind], label))
    return {
        "fabric": fabric.name,
        "rms_of_fit": float(np.sqrt(np.mean((fitted - truth) ** 2))),
        "brighter_by": float(np.mean(shares)),
        "brighter_by_rms": float(np.sqrt(np.mean(np.square(shares)))),
        "times_less_noise": {
            kind: {str(count): 1 / float(np.mean(values)) for count, values in of_kind.items()}
            for kind, of_kind in inverse.items()
        },
    }


def measure(options: Namespace) -> Figures:
    """All fabrics."""
    return {
        "texels": options.texels,
        "pairs": options.pairs,
        "rows": [row_of(table_fabric(name), options.texels, options.pairs) for name in FABRICS],
    }


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--texels", type=int, default=64, help="a side of the repeat")
    parser.add_argument("--pairs", type=int, default=96, help="random pairs of light and view")


if __name__ == "__main__":
    run(measure, _add_options)
