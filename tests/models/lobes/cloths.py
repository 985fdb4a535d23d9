"""Fabrics that stress different parts of the lobes model, their models, and the prefiltered regime alone."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cache

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.frozen import FrozenArg
from loomlight.core.llvm import require_llvm
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.fabric import make_fabric
from loomlight.fabric.fields import FabricFile
from loomlight.models.lobes.coverage import CoveragePyramid, build_pyramid, count_cells
from loomlight.models.lobes.groups import Groups, NearestGroup, find_groups
from loomlight.models.lobes.model import LobesModel, LobesOptions
from loomlight.models.lobes.rays import launch_views, top_down_samples, upload_cloth, view_samples
from loomlight.models.separable import Components
from loomlight.weave.draft import Draft, Threads
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import directions
from tests.helpers.fabrics import STRESSING

from .reference import LobesReference

require_llvm()


@dataclass(frozen=True, eq=False)
class FootprintQueries:
    """n queries of footprints.

    Attributes:
        lights, views: unit vectors [n, 3].
        centres: [n, 2], millimetres.
        sizes: sides of the squares of the same variances [n], millimetres.
        shapes: both edges of each in units of that, squares along the threads if not given [n, 2, 2].
    """

    lights: NDArray[np.float64]
    views: NDArray[np.float64]
    centres: NDArray[np.float64]
    sizes: NDArray[np.float64]
    shapes: NDArray[np.float64] | None = None

    @property
    def edges(self) -> NDArray[np.float64]:
        """Both edges of each footprint [n, 2, 2], millimetres."""
        shapes = np.eye(2)[None] if self.shapes is None else self.shapes
        return self.sizes[:, None, None] * shapes

    @property
    def light(self) -> Array3f:
        """The lights on a device."""
        return vectors(self.lights)

    @property
    def view(self) -> Array3f:
        """The views on a device."""
        return vectors(self.views)

    @property
    def footprint(self) -> Footprint:
        """The footprints on a device."""
        parts = self.centres, self.edges[:, 0], self.edges[:, 1]
        return Footprint(*(pairs(part) for part in parts))


@cache
def cloth(name: str) -> Fabric:
    """A fabric of `STRESSING`."""
    return fabric_from_text(STRESSING[name])


def random_cloth(ends: int, picks: int, uneven: bool = False) -> Fabric:
    """A fabric of a random draft; ends of two sizes if uneven."""
    drawdown = np.random.default_rng(0).random((picks, ends)) < 0.5
    warp = Threads(spacing_mm=np.where(np.arange(ends) % 3, 0.4, 0.6)) if uneven else Threads()
    return make_fabric(FabricFile(), Draft(drawdown, warp), "random", ".")


@cache
def model_of(name: str, groups: int = 8) -> LobesModel:
    """Its model."""
    return LobesModel.for_source(cloth(name), LobesOptions(groups=groups))


def geometry_of(name: str) -> YarnGeometry:
    """Its yarns."""
    return YarnGeometry(cloth(name).layout())


def reference_of(model: LobesModel) -> LobesReference:
    """The reference in NumPy of the same tables."""
    appearance = model.fabric.appearance()
    return LobesReference(
        model.tables,
        model.fabric.layout().size,
        (appearance.warp.roughness, appearance.weft.roughness),
        appearance.optical_depth,
        appearance.diffuse_blend,
    )


def random_queries(fabric: Fabric, smallest: float, count: int, seed: int) -> FootprintQueries:
    """Queries anywhere, from half of `smallest` to three repeats wide, askew and up to thrice as long."""
    rng = np.random.default_rng(seed)
    extent = np.asarray(fabric.repeat_mm)
    sizes = np.exp(rng.uniform(np.log(0.5 * smallest), np.log(3 * extent.max()), count))
    centres = rng.uniform(-1, 2, (count, 2)) * extent
    lights, views = (directions(rng, count, lowest=0.02) for _ in range(2))
    return FootprintQueries(lights, views, centres, sizes, askew(rng, count))


def askew(rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Edges of random parallelograms, up to thrice as long as wide, in units of their size [count, 2, 2]."""
    angle = rng.uniform(0, 2 * np.pi, count)
    between = np.radians(rng.uniform(60, 120, count))
    lengths = np.stack([rng.uniform(1, 3, count), np.ones(count)], axis=1)
    angles = np.stack([angle, angle + between], axis=1)
    edges = lengths[..., None] * np.stack([np.cos(angles), np.sin(angles)], axis=2)
    return edges / np.sqrt(0.5 * (edges**2).sum(axis=(1, 2)))[:, None, None]


def prefiltered_parts(model: LobesModel, queries: FootprintQueries) -> dict[str, NDArray[np.float32]]:
    """The prefiltered regime alone, at every size: components and hole by name [n]."""
    at = model.at(queries.view, queries.footprint)
    hole, (answer,) = at.prefiltered([queries.light], None, Bool(True))
    parts = {part.name: getattr(answer.components, part.name) for part in fields(Components)}
    dr.eval(parts, hole)
    return {name: values.numpy() for name, values in {**parts, "hole": hole}.items()}


def groups_of(geometry: YarnGeometry, per_family: int) -> Groups:
    """The groups that tables are made of."""
    cloth = upload_cloth(geometry, Float)
    return find_groups(top_down_samples(cloth), view_samples(launch_views(cloth, per_family)), per_family)


def pyramid_of(geometry: YarnGeometry, per_family: int) -> tuple[Groups, CoveragePyramid]:
    """The groups that tables are made of, and their pyramid."""
    groups = groups_of(geometry, per_family)
    nearest = FrozenArg(NearestGroup(groups, array_types(Float)))
    return groups, build_pyramid(count_cells(upload_cloth(geometry, Float), nearest, per_family))
