"""Openness of cloth: the share of the sky that yarn points see, by rays over one repeat.

The diffuse term of a point under a sky of radiance 1 returns D = ∫ V(l) (w⟨l·n_p⟩ + (1 − w)⟨l·n_s⟩)/π dl of
its albedo; the rest of its directions, 1 − D, meets other yarn. Light between yarns follows from D
(`interreflection.py`). It depends on the geometry and on w alone, not on colours, and is kept in two forms:
of a point, as a quadratic of its height and of its normal's slope, which leaves a deviation of 0.03 of 0.2;
and as the mean over the points that a view meets, by family.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, upload
from loomlight.core.llvm import llvm_float
from loomlight.core.tables import Tables, derived, setting, table
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.fibre import mean_layer_shares, reflection, transmission
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.rays import SearchQuality, Surface
from loomlight.yarn.visibility import first_hit, unoccluded

# View rays of each face: over the hemisphere, and of the instrument that measures colours. With half of them
# means of plain weave are 2 % off, with these 1 %.
OBLIQUE_RAYS, FACING_RAYS = 6144, 2048
# Lights of each view ray and side.
LIGHTS = 16
# Textile colours are measured at 8° from the normal under diffuse light (d/8°, CIE 15:2018).
FACING_COSINE = float(np.cos(np.radians(8)))
# Grazing views are left out: yarn that only they see decides nothing.
MIN_VIEW_COSINE = 0.03
# Shares are kept above this: a family that hardly any view sees says nothing of its openness.
MIN_SHARE = 0.05
QUALITY = SearchQuality(steps_per_thread=4, steps_per_relief=4, shadow_share=1.3, refinements=1)
# Samples of a ray that looks for the yarn that blocks it, while it crosses a thread or the relief; how
# far above the yarn it starts, in threads; and most samples.
MET_STEPS, _LIFT, MAX_MET_STEPS = 16, 2e-3, 2048
# Layouts whose openness is kept.
_MAX_KEPT = 64
# Numbers of `view_terms` and of `point_terms`.
VIEW_TERMS, POINT_TERMS = 5, 6


class Openness(Tables):
    """Share of the sky that a cloth's yarns see, on each face (front, back), of each family (warp, weft).

    D is of one point or of means over points. Sides are those of the light: that of the view, and the other
    one. Shaders have the tables with words as one block, in this order.
    """

    by_view: NDArray[np.float64] = table(
        "coefficients over `view_terms` of 1 − D on the view's side, of 1 − D on the other side, and of the "
        "share of the blocked directions of the first that meet warp",
        ("2 faces", "2 families", 3, f"{VIEW_TERMS} terms"),
        words="words",
    )
    by_point: NDArray[np.float64] = table(
        "the same over `point_terms`", ("2 faces", "2 families", 3, f"{POINT_TERMS} terms"), words="words"
    )
    warp_seen: NDArray[np.float64] = table(
        "coefficients over `view_terms` of the share of seen yarn that is warp",
        ("2 faces", f"{VIEW_TERMS} terms"),
        words="words",
    )
    relief: float = setting("height that 1 stands for in `point_terms`, millimetres", "mm", 0.0)
    interior: NDArray[np.float64] = table(
        "mean D of the yarn that blocks light", ("2 faces", "2 families"), words="words"
    )
    meets: NDArray[np.float64] = table(
        "share of a family's blocked directions that meet a family, summing to 1",
        ("2 faces", "2 from", "2 to"),
        words="words",
    )
    blocks: NDArray[np.float64] = table(
        "share of the blocked light that a family blocks; sums to 1 over families",
        ("2 faces", "2 families"),
        words="words",
    )

    @derived("one over the height that 1 stands for in `point_terms`, 1/mm", (1,), words="words")
    def per_relief(self) -> NDArray[np.float64]:
        """1 / relief."""
        return np.array([1 / self.relief])

    layers: NDArray[np.float64] = table(
        "what a fibre layer of albedo 1 sends back and lets through; see `fibre.mean_layer_shares`",
        ("2 families", "2 of back and through"),
        words="words",
    )
    facing: NDArray[np.float64] = table("mean D over all yarn of the front from 8°", ("2 sides",))
    facing_layer: NDArray[np.float64] = table(
        "mean value of the fibre layer at albedo 1 there under the same sky, with the roughness of either "
        "family for both",
        ("2 families", "2 sides"),
    )


_kept: OrderedDict[tuple[Any, ...], Openness] = OrderedDict()


def openness_of(
    layout: ClothLayout, diffuse_blend: float, roughness: tuple[float, float], optical_depth: float
) -> Openness:
    """The openness of a cloth, baked at the first call for a layout and these numbers: 0.1 s.

    Args:
        diffuse_blend: w of the diffuse term.
        roughness: α of warp and weft; it and `optical_depth` matter to the fibre layers alone.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    if layout.layers:
        # Light is between the yarns of one layer; the front one stands for all.
        layout = layout.layers[0].layout
    key = (*_layout_key(layout), diffuse_blend, *roughness, optical_depth)
    if key in _kept:
        _kept.move_to_end(key)
        return _kept[key]
    geometry = YarnGeometry(layout)
    met = ray_shares(geometry, diffuse_blend, roughness, optical_depth)
    layers = [mean_layer_shares(alpha, optical_depth) for alpha in roughness]
    found = openness_of_rays(met, geometry.height_bounds[1], np.array(layers, np.float64))
    _kept[key] = found
    if len(_kept) > _MAX_KEPT:
        _kept.popitem(last=False)
    return found


def _layout_key(layout: ClothLayout) -> tuple[Any, ...]:
    families = (
        (f.spacing.tobytes(), f.width.tobytes(), f.inclination, f.twist, f.height_scale)
        for f in (layout.warp, layout.weft)
    )
    return (layout.warp_on_top.shape, layout.warp_on_top.tobytes(), *families)


def view_terms(x: Float, y: Float, z: Float, sine: Float) -> tuple[Float, ...]:
    """1, sin θ, (1 − cos θ)², (1 − cos θ)⁴, x² − y² of a unit view [3] in the frame of the face that it sees.

    Args:
        x, y, z: numbers or arrays.
        sine: √(x² + y²).
    """
    squared = (1 - z) * (1 - z)
    return 1.0, sine, squared, squared * squared, x * x - y * y


def point_terms(cosine: Float, height: Float) -> tuple[Float, ...]:
    """1, c, h, c², c h, h² of the cosine c of a yarn's and the cloth's normal and the height h in reliefs."""
    return 1.0, cosine, height, cosine * cosine, cosine * height, height * height


@dataclass(frozen=True, eq=False)
class RayShares:
    """Hits of the view rays of both faces, front first, and the share of the sky that is seen there.

    Attributes:
        is_warp, is_yarn: of the yarn that a ray meets, and whether it meets any [n].
        is_blocked, meets_warp: whether yarn blocks one diffuse direction there, and whether that is warp [n].
        normal_cosines: between the yarns' normals and the cloth's [n].
        heights: of the yarn points on their face [n], millimetres.
        halves: D by every other light of the side of the view [2, n].
        far: D of the other side [n].
        layers: value of the fibre layer at albedo 1 [family, side, n].
    """

    is_warp: NDArray[np.bool_]
    is_yarn: NDArray[np.bool_]
    is_blocked: NDArray[np.bool_]
    meets_warp: NDArray[np.bool_]
    normal_cosines: NDArray[np.float64]
    heights: NDArray[np.float64]
    halves: NDArray[np.float64]
    far: NDArray[np.float64]
    layers: NDArray[np.float64]


def view_rays() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """View rays of a face, evenly spread by additive recurrences (Roberts 2018).

    Returns:
        where they cross the plane z = 0, in repeats [2, n]; unit vectors [3, n] in the frame of the face.
    """
    number = np.arange(OBLIQUE_RAYS + FACING_RAYS)
    across, along, tilt, turn = (
        (number * share + 0.5) % 1
        for share in (0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101)
    )
    cosine = np.where(number < OBLIQUE_RAYS, 1 - (1 - MIN_VIEW_COSINE) * tilt, FACING_COSINE)
    sine = np.sqrt(1 - cosine**2)
    views = np.stack([sine * np.cos(2 * np.pi * turn), sine * np.sin(2 * np.pi * turn), cosine])
    return np.stack([across, along]), views


def ray_shares(
    geometry: YarnGeometry, blend: float, roughness: tuple[float, float], optical_depth: float
) -> RayShares:
    """Hits of the rays of `openness_of`; other arguments are its own."""
    rays = _Rays(geometry, array_types(llvm_float()))
    shares, layers = rays.shares(blend, roughness, optical_depth)
    is_blocked, meets_warp = rays.first_blocks(blend)
    return RayShares(
        rays.is_warp.numpy(),
        ~rays.hole.numpy(),
        is_blocked,
        meets_warp,
        rays.near[1].z.numpy().astype(np.float64),
        rays.near[0].numpy().astype(np.float64),
        np.stack([shares[0, :, half::2].mean(axis=1) for half in (0, 1)]),
        shares[1].mean(axis=1),
        layers.mean(axis=3),
    )


def openness_of_rays(met: RayShares, highest: float, layers: NDArray[np.float64]) -> Openness:
    """The openness of cloth.

    Args:
        highest: of its yarn, millimetres above the middle.
        layers: see `Openness`.
    """
    # The terms of view and point that shares are fitted by.
    x, y, z = np.tile(view_rays()[1], 2)
    faces = np.repeat([0, 1], z.size // 2)
    relief = max(highest, 1e-6)
    of_view = _matrix(view_terms(x, y, z, np.sqrt(x * x + y * y)))
    of_point = _matrix(point_terms(met.normal_cosines, met.heights / relief))
    is_warp, yarn = met.is_warp, met.is_yarn
    is_oblique = z != FACING_COSINE
    by_view, by_point = np.zeros((2, 2, 3, VIEW_TERMS)), np.zeros((2, 2, 3, POINT_TERMS))
    interior, blocks = np.zeros((2, 2)), np.zeros((2, 2))
    meets = np.zeros((2, 2, 2))
    means = np.stack([met.halves.mean(axis=0), met.far])
    meets_warp = met.meets_warp
    # Each family on each face: shares by view and by point, families that its light meets, its interior.
    for face in (0, 1):
        for family, of_family in enumerate((is_warp, ~is_warp)):
            seen = yarn & of_family & (faces == face)
            meeting = seen & met.is_blocked
            for fitted, terms in ((by_view, of_view), (by_point, of_point)):
                fitted[face, family, :2] = _fitted(terms[seen], 1 - means[:, seen])
                fitted[face, family, 2:] = _fitted(terms[meeting], meets_warp[None, meeting])
            seen, meeting = seen & is_oblique, meeting & is_oblique
            share = float((z[meeting] * meets_warp[meeting]).sum()) / max(float(z[meeting].sum()), 1e-9)
            meets[face, family] = share, 1 - share
            # Two halves of the lights: their errors are independent, so the mean of the product is unbiased.
            first, second = met.halves[:, seen]
            # Yarn that blocks light is met in proportion to how much of its own sky is blocked.
            blocked = z[seen] * (1 - first)
            blocks[face, family] = max(float(blocked.sum()), 0)
            interior[face, family] = (blocked * second).sum() / max(float(blocked.sum()), 1e-9)
    blocks /= np.maximum(blocks.sum(axis=1, keepdims=True), 1e-9)
    # What instruments see that look straight down, and which family a view meets.
    facing = yarn & ~is_oblique & (faces == 0)
    warp_seen = [
        _fitted(of_view[seen], is_warp[None, seen])[0] for seen in (yarn & (faces == f) for f in (0, 1))
    ]
    return Openness(
        by_view=by_view,
        by_point=by_point,
        warp_seen=np.stack(warp_seen),
        relief=relief,
        interior=np.clip(interior, MIN_SHARE, 1),
        meets=meets,
        blocks=blocks,
        layers=layers,
        facing=means[:, facing].mean(axis=1),
        facing_layer=met.layers[:, :, facing].mean(axis=2),
    )


def _matrix(terms: tuple[Any, ...]) -> NDArray[np.float64]:
    """Terms as columns [n, terms]."""
    return np.stack(np.broadcast_arrays(*terms), axis=1)


def _fitted(terms: NDArray[np.float64], shares: NDArray[Any]) -> NDArray[np.float64]:
    """Coefficients [k, terms] of shares [k, n] by least squares; of a family hardly seen, the mean."""
    count = terms.shape[1]
    if len(terms) < 8 * count:
        flat = np.zeros((len(shares), count))
        flat[:, 0] = shares.mean(axis=1) if len(terms) else 0.5
        return flat
    found = np.linalg.lstsq(terms, shares.T.astype(np.float64), rcond=None)[0].T
    return np.asarray(found, np.float64)


class _Rays:
    """View rays of both faces and their lights.

    Attributes:
        views: unit vectors [3, n] in the frame of their face.
        face: 0 for the front, 1 for the back [n].
        hole, is_warp: whether a ray meets no yarn, and whether warp [n].
        near: height, millimetres, and normal of the yarn that it meets.
    """

    def __init__(self, surface: Surface, types: ArrayTypes) -> None:
        self._surface, self._types = surface, types
        (across, along), views = view_rays()
        self.views = np.tile(views, 2)
        self.face = np.repeat([0, 1], len(across))
        width, height = surface.size
        view = types.Vector3(*(upload(types.Float, part) for part in self.views))
        back = types.Bool(upload(types.UInt32, self.face) == 1)
        x, y = (upload(types.Float, np.tile(part, 2)) for part in (across * width, along * height))
        hit = first_hit(surface, x, y, view, back, quality=QUALITY)
        point = surface.surface(hit.x, hit.y, back, (view, hit.height))
        far = surface.surface(point.x, point.y, ~back)
        self._view, self._back, self.hole = view, back, hit.hole
        self._x, self._y = point.x, point.y
        self.near, self._far = (point.height, point.normal), (far.height, far.normal)
        self._tangent, self.is_warp = point.tangent, point.is_warp
        dr.eval(self._x, self._y, self.hole, self.near, self._far, self._tangent, self.is_warp, view, back)

    def first_blocks(self, blend: float) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Whether yarn blocks one diffuse direction of every ray [n], and whether that yarn is warp.

        Directions are those of the diffuse term, with the ones below the cloth's horizon that steep yarn
        sends to what lies beside it.
        """
        types, surface = self._types, self._surface
        number = dr.arange(types.UInt32, self.views.shape[1])
        u = [types.Float(number) * share for share in (0.7548776662, 0.5698402910)]
        u = types.Vector2(*(part - dr.floor(part) for part in u))
        normal = self.near[1]
        direction = sample_diffuse(normal, dr.opaque(types.Float, blend), u)
        own = ~self.hole & (dr.dot(direction, normal) <= 0)
        met, is_warp = _met(
            surface, types, (self._x, self._y, self.near[0]), direction, self._back, ~self.hole & ~own
        )
        is_warp = dr.select(own, self.is_warp, is_warp)
        met |= own
        dr.eval(met, is_warp)
        return met.numpy(), is_warp.numpy()

    def shares(
        self, blend: float, roughness: tuple[float, float], optical_depth: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """D of every ray and light [side, n, lights], and the layer's value with either family's roughness.

        Returns:
            the first; the second as [family, side, n, lights].
        """
        types = self._types
        rays = self.views.shape[1]
        number = dr.arange(types.UInt32, rays * LIGHTS)
        ray, light = number // LIGHTS, number % LIGHTS
        # Cosine-weighted, a stratum each, turned from ray to ray.
        squared = (types.Float(light) + 0.5) / LIGHTS
        turn = types.Float(light) * 0.6180339887 + types.Float(ray) * 0.7548776662
        sine, cosine = dr.sincos(dr.two_pi * (turn - dr.floor(turn)))
        radius = dr.sqrt(squared)
        up = types.Vector3(radius * cosine, radius * sine, dr.sqrt(1 - squared))
        values = []
        depth = dr.opaque(types.Float, optical_depth)
        alphas = [dr.opaque(types.Float, alpha) for alpha in roughness]
        weight = dr.opaque(types.Float, blend)
        back = dr.gather(types.Bool, self._back, ray)
        x, y = (dr.gather(types.Float, part, ray) for part in (self._x, self._y))
        view, tangent, normal = (
            dr.gather(types.Vector3, part, ray) for part in (self._view, self._tangent, self.near[1])
        )
        yarn = ~dr.gather(types.Bool, self.hole, ray)
        per_cosine = dr.pi * dr.rcp(up.z)
        for side, (height, facing) in enumerate((self.near, self._far)):
            height, facing = dr.gather(types.Float, height, ray), dr.gather(types.Vector3, facing, ray)
            searched = yarn & (dr.dot(facing, up) > 0)
            free = unoccluded(
                self._surface, x, y, height, up, back if side == 0 else ~back, searched, QUALITY
            )
            # The diffuse term of the far side is that of the opposite direction about the yarn's own normal.
            towards = up if side == 0 else types.Vector3(up.x, up.y, -up.z)
            diffuse = diffuse_pdf(towards if side == 0 else -towards, normal, weight)
            lobe = reflection if side == 0 else transmission
            values += [diffuse, *(lobe(towards, view, normal, tangent, alpha, depth) for alpha in alphas)]
            values[-3:] = [dr.select(free, value * per_cosine, 0) for value in values[-3:]]
        dr.eval(values)
        found = np.stack([value.numpy() for value in values]).astype(np.float64).reshape(2, 3, rays, LIGHTS)
        return found[:, 0], np.moveaxis(found[:, 1:], 0, 1)


def _met(
    surface: Surface,
    types: ArrayTypes,
    place: tuple[Float, Float, Float],
    direction: Vec3,
    back: Mask,
    active: Mask,
) -> tuple[Any, Any]:
    """Whether rays from yarn points, rising or falling, meet yarn of their face, and whether that is warp.

    Args:
        place: draft coordinates and height of the points, millimetres.
    """
    low, high = (dr.opaque(types.Float, height) for height in surface.height_bounds)
    fine = min(surface.finest)
    lift = dr.opaque(types.Float, _LIFT * fine)
    across = dr.sqrt(dr.square(direction.x) + dr.square(direction.y))
    cell = dr.opaque(types.Float, fine / MET_STEPS)
    fall = dr.opaque(types.Float, max(surface.height_bounds[1] - surface.height_bounds[0], 1e-6) / MET_STEPS)
    step = direction * minimum(cell / maximum(across, 1e-6), fall / maximum(abs(direction.z), 1e-6))
    x, y, height = place

    def advance(at: Float, searching: Mask, met: Mask, count: UInt) -> tuple[Any, ...]:
        at = at + step
        level, hole = surface.height(at.x, at.y, back)
        hit = searching & ~hole & (at.z < level)
        inside = (at.z <= high) & (at.z >= low - (high - low)) & (count < MAX_MET_STEPS)
        return at, searching & ~hit & inside, met | hit, count + 1

    start = types.Vector3(x, y, height + lift), types.Bool(active), types.Bool(False), types.UInt32(0)
    end, _, met, _ = dr.while_loop(start, lambda *state: state[1], advance, label="cloth: blocks")
    # A lane stays at its last sample only in symbolic loops; in every mode what it met is kept with it.
    return met, surface.surface(end.x, end.y, back).is_warp
