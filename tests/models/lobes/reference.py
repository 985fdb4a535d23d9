"""The prefiltered regime in plain NumPy, one query at a time: to read, to port, and to test the rest against.

The point-sampled regime and the blend to it are left out. All vectors are of one query, [3] or [2]; arrays of
groups are [G], in the order of their bytes: the warp's first, each family padded to packs of four.
Everything is float64.

For a view v, a light l, their half vector h and a footprint, with bytes interpolated between `Nodes`:

    weight of a group     w = coverage·(root of projected area)²·unit
    hole                  the same for holes, at most 1
    ratio                 r = 1 + Σ_k a_k(v)·b_k(l), 0 to `MAX_JOINT_RATIO`, of each family
    diffuse               r·(1 − hole)·Σ w·irradiance / Σ w
    specular              r·(1 − hole)·Σ w·f(h, l, v)·V_l / Σ w        V: `light_visibility`; f: `layer_value`
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.models.lobes.bsdf import PROPOSAL_SPREAD_WIDTH, LobeWeights
from loomlight.models.lobes.coverage import MIN_TAP_SPACING, TAP_OFFSETS, TAP_SIZE, TENT_VARIANCE
from loomlight.models.lobes.hemisphere import AZIMUTHS, MIN_NODE_COSINE, RINGS, WEIGHT_SUM
from loomlight.models.lobes.prefiltered import (
    GROUP_MIN_COSINE,
    GROUP_MIN_PATH,
    GROUP_MIN_STEEPNESS,
    GROUP_NARROWEST,
    GROUP_SPREAD_LOSS,
)
from loomlight.models.lobes.tables import LobeTables
from loomlight.models.lobes.visibility import FACTOR_UNIT, JOINT_AZIMUTHS, JOINT_TERMS, MAX_JOINT_RATIO
from loomlight.models.separable import Components

Numbers = NDArray[np.float64]
"""Float64 of any shape: of groups [G], or a vector [2] or [3]."""

_PER_BYTE = 1 / 255


@dataclass(frozen=True, eq=False)
class Nodes:
    """Rows of a table to interpolate between.

    Attributes:
        indices: of the rows [n].
        weights: of each [n]; sum 1.
    """

    indices: NDArray[np.int64]
    weights: Numbers

    def of(self, table: NDArray[np.integer]) -> Numbers:
        """Interpolated bytes of a table [rows, k]: [k], 0 to 255. Weights are rounded to whole units."""
        units = np.floor(self.weights * WEIGHT_SUM + 0.5)
        return np.asarray(units @ table[self.indices] / units.sum())


@dataclass(frozen=True, eq=False)
class Parallelogram:
    """A footprint on the cloth, millimetres.

    Attributes:
        centre: its middle [2].
        along_x, along_y: its edges [2].
    """

    centre: Numbers
    along_x: Numbers
    along_y: Numbers

    @property
    def side(self) -> float:
        """Side of the square whose variances have the same sum."""
        return math.sqrt(0.5 * float(self.along_x @ self.along_x + self.along_y @ self.along_y))


@dataclass(frozen=True, eq=False)
class GroupMoments:
    """The moments of the groups of one face.

    Attributes:
        normal, tangent: means [G, 3], shorter than 1.
        covariance: of the fibre direction [G, 3, 3].
        unit: factor of (coverage byte)·(projected area byte)² [G].
        roughness: α of each group's family [G].
    """

    normal: Numbers
    tangent: Numbers
    covariance: Numbers
    unit: Numbers
    roughness: Numbers


@dataclass(frozen=True, eq=False)
class Weights:
    """Visible fractions of a footprint from one view.

    Attributes:
        groups: w of each group [G], not normalized.
        hole: fraction of the view rays that pass through holes.
    """

    groups: Numbers
    hole: float


class LobesReference:
    """The groups' estimate of one fabric."""

    def __init__(
        self,
        tables: LobeTables,
        repeat: tuple[float, float],
        roughness: tuple[float, float],
        optical_depth: float,
        diffuse_blend: float = 0.5,
    ) -> None:
        """The estimate from baked tables.

        Args:
            repeat: width and height of the repeat, millimetres.
            roughness: α of (warp, weft).
            optical_depth: Tρ of the fibre layer.
            diffuse_blend: w of the diffuse term; the density alone needs it.
        """
        self.tables = tables
        self.repeat = repeat
        self.optical_depth = optical_depth
        self.diffuse_blend = diffuse_blend
        # Of each face [2, G].
        self.is_warp = np.arange(4 * tables.packs) < 4 * tables.warp_packs[:, None]
        self.roughness = np.where(self.is_warp, *roughness)

    def components_and_hole(
        self, light: Numbers, view: Numbers, footprint: Parallelogram
    ) -> tuple[Components, float]:
        """Components, 1/sr, and the hole: floats.

        Args:
            light, view: unit vectors [3]; z < 0 on the back.
            footprint: what a pixel sees of the cloth.
        """
        back, light, view = on_seen_face(light, view)
        is_transmission = bool(light[2] < 0)
        groups = self.groups(back)
        weights = self.weights(view, footprint, back)

        nodes, side = direction_nodes(light), (int(back), int(is_transmission))
        irradiance = nodes.of(self.tables.irradiance[side]) * _PER_BYTE
        light_visibility = nodes.of(self.tables.light_visibility[side]) * _PER_BYTE
        is_warp = self.is_warp[int(back)]
        ratio = np.where(is_warp, *self.joint_ratios(light, view, back))

        diffuse = weights.groups * irradiance / math.pi * ratio
        specular = (
            weights.groups
            * light_visibility
            * ratio
            * layer_value(half_vector(light, view), light, view, groups, self.optical_depth)
        )
        total = max(weights.groups.sum(), 1e-12) / (1 - weights.hole) if weights.hole < 1 else math.inf
        components = Components(
            diffuse_warp=float(diffuse[is_warp].sum() / total),
            diffuse_weft=float(diffuse[~is_warp].sum() / total),
            specular_warp=float(specular[is_warp].sum() / total),
            specular_weft=float(specular[~is_warp].sum() / total),
            light_visibility=min(
                float((weights.groups * light_visibility * ratio).sum() / total), 1 - weights.hole
            ),
        )
        return components, weights.hole

    def group_density(
        self,
        light: Numbers,
        view: Numbers,
        footprint: Parallelogram,
        lobe_weights: tuple[LobeWeights, LobeWeights],
    ) -> float:
        """Density of the mixture over groups, 1/sr, without the cosine and sheen lobes.

        Args:
            light, view, footprint: as in `components_and_hole`.
            lobe_weights: of (warp, weft); floats.
        """
        back, light, view = on_seen_face(light, view)
        groups = self.groups(back)
        weights = self.weights(view, footprint, back)
        specular, reflect, transmit = (
            np.where(self.is_warp[int(back)], *(getattr(family, name) for family in lobe_weights))
            for name in ("specular", "reflect", "transmit")
        )
        # The group as one fibre: along its mean direction, wider by its spread.
        normal, tangent = _unit(groups.normal), _unit(groups.tangent)
        spread = np.sqrt(0.5 * np.trace(groups.covariance, axis1=1, axis2=2))
        width = np.minimum(groups.roughness + PROPOSAL_SPREAD_WIDTH * spread, 1)
        along = tangent @ half_vector(light, view)
        area = np.sqrt(1 - (1 - width**2) * (tangent @ view) ** 2)
        lobe = fibre_density(along, width) / (4 * area)
        blend = self.diffuse_blend

        def diffuse(direction: Numbers) -> Numbers:
            about_yarn, about_cloth = np.maximum(normal @ direction, 0), max(direction[2], 0)
            return np.asarray((blend * about_yarn + (1 - blend) * about_cloth) / math.pi)

        density = specular * lobe + reflect * diffuse(light) + transmit * diffuse(-light)
        total = specular + reflect + transmit
        return float((weights.groups * density).sum() / (weights.groups * total).sum())

    def weights(self, view: Numbers, footprint: Parallelogram, back: bool) -> Weights:
        """Visible fractions of groups and holes in a footprint; the view [3] is in the frame of its face."""
        face, count = int(back), 4 * self.tables.packs
        coverage = self.coverage_nodes(footprint).of(self.tables.coverage[face])
        nodes = direction_nodes(view)
        # Holes are the first byte of the last pack.
        root_area = nodes.of(self.tables.projected_area[face])
        unit = np.append(self.groups(back).unit, self.tables.hole_weight[face])
        weights = coverage[: count + 1] * root_area[: count + 1] ** 2 * unit
        return Weights(weights[:count], min(float(weights[count]), 1.0))

    def joint_ratios(self, light: Numbers, view: Numbers, back: bool) -> Numbers:
        """Joint over independent means of (warp, weft); directions of the face seen."""
        of_view, of_light = (
            direction_nodes(direction, JOINT_AZIMUTHS).of(table).reshape(2, JOINT_TERMS) / FACTOR_UNIT
            for direction, table in zip(
                (view, light), self.tables.joint[int(back), int(light[2] < 0)], strict=True
            )
        )
        return np.clip(1 + (of_view * of_light).sum(axis=-1), 0, MAX_JOINT_RATIO)

    def groups(self, back: bool) -> GroupMoments:
        """The groups of a face, from the twelve numbers of each."""
        moments = self.tables.moments[int(back)].astype(np.float64)
        normal, unit, tangent = moments[:, :3], moments[:, 3], moments[:, 4:7]
        xx, yy, xy, xz, yz = moments[:, 7:].T
        # Fibre directions are unit vectors: |mean|² and the trace of their covariance add up to 1.
        zz = 1 - (tangent**2).sum(axis=1) - xx - yy
        covariance = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
        return GroupMoments(normal, tangent, covariance, unit, self.roughness[int(back)])

    def coverage_nodes(self, footprint: Parallelogram) -> Nodes:
        """Nine taps of equal weight, three along each edge of a footprint.

        Level m stores means over squares of side s_m = s_0·2^m. Taps have `TAP_SIZE` of the footprint's side
        at most, and half of it at least.
        """
        top = len(self.tables.levels) - 1
        relative = footprint.side / self.tables.base_size
        level = min(int(math.log2(max(TAP_SIZE * relative, 1.0))), top)
        # Taps nearly as large as the footprint are closer to its centre.
        spacing = math.sqrt(min(max(TENT_VARIANCE * (1 - relative**-2), 0.0), 1.0))
        spacing = min(max(spacing, MIN_TAP_SPACING / relative), 1.0)
        indices = []
        for s, t in TAP_OFFSETS:
            x, y = footprint.centre + spacing * (s * footprint.along_x + t * footprint.along_y)
            indices.append(self._node(level, x, y))
        return Nodes(np.array(indices), np.full(len(TAP_OFFSETS), 1 / len(TAP_OFFSETS)))

    def _node(self, level: int, x: float, y: float) -> int:
        """The node of a level nearest to a position, millimetres; nodes are at the centres of their cells."""
        first, columns, rows = (int(number) for number in self.tables.levels[level])
        column = min(int(x / self.repeat[0] % 1.0 * columns), columns - 1)
        row = min(int(y / self.repeat[1] % 1.0 * rows), rows - 1)
        return first + row * columns + column


def on_seen_face(light: Numbers, view: Numbers) -> tuple[bool, Numbers, Numbers]:
    """Whether the back is seen, and both directions in the frame of the face that is."""
    back = bool(view[2] < 0)
    flip = np.array([1, 1, -1.0 if back else 1.0])
    return back, light * flip, view * flip


def direction_nodes(direction: Numbers, azimuths: int = AZIMUTHS) -> Nodes:
    """Four nodes around a direction, by azimuth and |z|.

    Nodes stand azimuth by azimuth; rings are even in (1 − z)^¾, the last at z = `MIN_NODE_COSINE`.
    """
    ring = (RINGS - 1) * min(max(1 - abs(float(direction[2])), 0.0) / (1 - MIN_NODE_COSINE), 1.0) ** 0.75
    inner = min(int(ring), RINGS - 2)
    out = ring - inner
    turns = math.atan2(direction[1], direction[0]) / (2 * math.pi) * azimuths
    column = math.floor(turns)
    fraction = turns - column
    columns = np.array([column, column + 1]) % azimuths
    indices = columns[:, None] * RINGS + np.array([inner, inner + 1])
    return Nodes(indices.ravel(), np.outer([1 - fraction, fraction], [1 - out, out]).ravel())


def half_vector(light: Numbers, view: Numbers) -> Numbers:
    """Unit half vector [3]."""
    total = light + view
    return total / math.sqrt(max(float(total @ total), 1e-12))


def fibre_density(along: Numbers, roughness: Numbers) -> Numbers:
    """D of x = h·t: 1/(πα(1 + k x²)²), k = 1/α² − 1 (chen2024 eq. 2), 1/sr."""
    return np.asarray(1 / (math.pi * roughness * (1 + (1 / roughness**2 - 1) * along**2) ** 2))


def mean_density(half: Numbers, groups: GroupMoments) -> Numbers:
    """D̄: the mean of `fibre_density` over x uniform in m − w to m + w, 1/sr [G].

    m and w = √3·deviation are those of h·t over the group.
    """
    roughness = groups.roughness
    mean = groups.tangent @ half
    deviation = np.sqrt(np.maximum(_variance(groups, half), 0))
    width = np.maximum(math.sqrt(3) * deviation, GROUP_NARROWEST * roughness + 1e-4)
    steepness = np.maximum(np.sqrt(1 - roughness**2) / roughness, GROUP_MIN_STEEPNESS)
    first, last = steepness * (mean - width), steepness * (mean + width)
    product, span = first * last, last - first
    rational = (1 - product) / ((1 + first**2) * (1 + last**2))
    # arctan(last) − arctan(first) in one.
    angle = np.arctan2(span, 1 + product)
    return np.asarray((rational + angle / span) / (2 * math.pi * roughness))


def mean_area(direction: Numbers, groups: GroupMoments) -> Numbers:
    """Root of the mean σ² = 1 − (1 − α²)(ω·t)² over the group [G]."""
    along = (groups.tangent @ direction) ** 2 + np.maximum(_variance(groups, direction), 0)
    squared = groups.roughness**2
    return np.sqrt(np.maximum(1 - (1 - squared) * along, squared))


def layer_value(
    half: Numbers, light: Numbers, view: Numbers, groups: GroupMoments, optical_depth: float
) -> Numbers:
    """f·cos of each group's fibre layer at albedo 1, without shadows [G], 1/sr (chen2024 eq. 1–2).

    Reflection D G_r/(4 cos_v), or, where light comes from the other side, transmission D G_t/(4 cos_v).
    """
    is_transmission = light[2] < 0
    cos_light = np.maximum(groups.normal @ (-light if is_transmission else light), GROUP_MIN_COSINE)
    cos_view = np.maximum(groups.normal @ view, GROUP_MIN_COSINE)
    slope_light = mean_area(light, groups) / cos_light
    slope_view = mean_area(view, groups) / cos_view
    # The layer's mean of e^{−s} along the path, e^{−Tρ min(Λ_l, Λ_v)}·(1 − e^{−Tρ|Δ|})/|Δ| in transmission.
    path = np.abs(slope_light - slope_view) if is_transmission else slope_light + slope_view
    path = np.maximum(path, GROUP_MIN_PATH)
    unscattered = np.exp(-optical_depth * np.minimum(slope_light, slope_view)) if is_transmission else 1.0
    attenuation = unscattered * -np.expm1(-optical_depth * path) / path
    loss = 0 if is_transmission else GROUP_SPREAD_LOSS * (1 - (groups.normal**2).sum(axis=1))
    return np.asarray(mean_density(half, groups) * attenuation * (1 - loss) / (4 * cos_view))


def _variance(groups: GroupMoments, direction: Numbers) -> Numbers:
    """Variance of direction·t over each group [G]."""
    return np.asarray(np.einsum("gij,i,j->g", groups.covariance, direction, direction))


def _unit(vectors: Numbers) -> Numbers:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
