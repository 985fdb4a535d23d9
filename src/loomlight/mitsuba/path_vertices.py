"""The steps of a path vertex: footprint, emission, a light sample, scattering, and derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import channel_mean, maximum, minimum
from loomlight.mitsuba.bsdf_samples import FILTERS
from loomlight.mitsuba.path_state import PathState
from loomlight.mitsuba.pixel_filter import PixelFilter
from loomlight.mitsuba.ray_cone import cone_partials
from loomlight.mitsuba.scene_traits import SceneTraits

# A ray that passes through this many holes is ended; cloth folded upon itself has a dozen.
MAX_PASSES = 64
# Less light of points and directions is left to Russian roulette: their shadows have no other noise.
_LEAST_SHARE = 1e-4


@dataclass
class LightSample:
    """A direction to an emitter, drawn by the scene.

    Attributes:
        direction: Mitsuba's DirectionSample3f.
        to_light: the same in the local frame [3].
        arriving: radiance over density, times the transmittance on the way.
        lit: lanes where light arrives.
    """

    direction: Any
    to_light: Vec3
    arriving: Color3
    lit: Mask


@dataclass
class Scattering:
    """A BSDF's response to a light sample, and the next direction of the path.

    Attributes:
        value: f·cos towards the light.
        pdf: density of drawing the light's direction by the BSDF.
        sample: Mitsuba's BSDFSample3f.
        weight: f·cos over density of the sample.
        through: share of light that passes straight through [3]; 0 unless asked for.
    """

    value: Color3
    pdf: Float
    sample: Any
    weight: Color3
    through: Color3


@dataclass
class FirstFootprint:
    """Footprints of the camera's own rays, before they scatter.

    Not a pytree: as a variable of a loop the camera's ray would be copied, and copies lose the differentials.

    Attributes:
        camera: rays with the differentials of a whole pixel.
        offset: of rays from where filtered texture is read, pixels [2]; None where that is the same.
        filtered_side: side of the footprints of BSDFs that average over them, pixels.
        side: of those of others.
    """

    camera: Any
    offset: Vec2 | None
    filtered_side: float
    side: Float

    @classmethod
    def of(
        cls, pixel_filter: PixelFilter | None, offset: Vec2 | None, camera: Any, samples: Float
    ) -> FirstFootprint:
        """Footprints of rays at `offset` from their samples' places, of `samples` samples a pixel."""
        side = dr.rsqrt(samples)
        if pixel_filter is None:
            return cls(camera, None, side, side)
        return cls(camera, offset, pixel_filter.footprint_side, side)

    def set_on(self, si: Any, filters: Mask) -> None:
        """Sets the footprint in uv at `si`, and moves its uv where BSDFs filter."""
        si.compute_uv_partials(self.camera)
        if self.offset is not None:
            step = self.offset.x * si.duv_dx + self.offset.y * si.duv_dy
            si.uv -= dr.select(filters, step, 0)
        side = dr.select(filters, mi.Float(self.filtered_side), self.side)
        si.duv_dx *= side
        si.duv_dy *= side


class PathVertices:
    """Steps that every vertex of a path takes in one scene."""

    def __init__(
        self, scene: Any, traits: SceneTraits, direct_only: bool, blends: bool, least_share: Float, soft: bool
    ) -> None:
        """
        Args:
            soft: shadow rays begin on the smooth surface; see `above_triangle`.
            direct_only: paths end with the first light sample, and no drawn direction can hit an emitter.
            blends: `Scattering.through` is asked for.
            least_share: of noisy light through holes; less is left to Russian roulette.
        """
        self._scene = scene
        self._traits, self._soft_terminator = traits, soft
        self._direct_only = direct_only
        self._blends = blends
        self._least_share = least_share if traits.hittable_emitters else mi.Float(_LEAST_SHARE)
        self._context = mi.BSDFContext()

    def filters(self, si: mi.SurfaceInteraction3f) -> Mask:
        """Lanes whose BSDF averages over footprints."""
        if not self._traits.filters:
            return mi.Bool(False)
        return (si.bsdf().flags() & FILTERS) != 0

    def set_footprint(self, si: mi.SurfaceInteraction3f, path: PathState, first: FirstFootprint) -> None:
        """Sets the footprint in uv: of the camera's differentials, of a ray cone after the path scattered."""
        first.set_on(si, self.filters(si) & ~path.scattered)
        if not self._direct_only:
            duv_dx, duv_dy = cone_partials(si, path.ray.d, path.width)
            si.duv_dx = dr.select(path.scattered, duv_dx, si.duv_dx)
            si.duv_dy = dr.select(path.scattered, duv_dy, si.duv_dy)

    def emission(self, si: mi.SurfaceInteraction3f, path: PathState, shown: Mask, primal: bool) -> Color3:
        """Emission of what the path has hit, weighted against light samples of the vertex before.

        Args:
            shown: lanes whose emitters show.
        """
        if not self._traits.hittable_emitters:
            return mi.Spectrum(0)
        origin = dr.zeros(mi.Interaction3f)
        origin.p = path.vertex
        ds = mi.DirectionSample3f(self._scene, si, origin)
        emitter_pdf = self._scene.pdf_emitter_direction(origin, ds, ~path.vertex_delta & path.active)
        with dr.resume_grad(when=not primal):
            return power_heuristic(path.vertex_pdf, emitter_pdf) * ds.emitter.eval(si, shown)

    def sample_light(
        self, si: mi.SurfaceInteraction3f, sampler: mi.Sampler, path: PathState, active: Mask
    ) -> LightSample:
        """A light sample, and what of it arrives."""
        lit = active & mi.has_flag(si.bsdf().flags(), mi.BSDFFlags.Smooth)
        ds, arriving = self._scene.sample_emitter_direction(si, sampler.next_2d(), False, lit)
        lit &= ds.pdf != 0
        origin = above_triangle(si, ds.d, lit) if self._soft_terminator else si
        # Rays to points and along directions are coherent: Embree then takes them together, which makes
        # pictures of direct light a sixth faster.
        coherent = not self._traits.hittable_emitters
        if self._traits.porous_shadows:
            # Where no light arrives the BSDF need not be evaluated.
            arriving *= _transmittance(
                self._scene, origin, ds.p, path, coherent, sampler.next_1d(), self._least_share, lit
            )
            lit &= dr.max(arriving) > 0
        else:
            lit &= ~self._scene.ray_test(origin.spawn_ray_to(ds.p), coherent, lit)
        return LightSample(ds, si.to_local(ds.d), arriving, lit)

    def enters(self, si: mi.SurfaceInteraction3f, valid: Mask, bounces: Mask) -> Mask:
        """Lanes whose BSDF is sampled: those that bounce, and those that may pass through a hole."""
        entering = mi.Bool(bounces)
        if self._traits.holes:
            entering |= valid & mi.has_flag(si.bsdf().flags(), mi.BSDFFlags.Null)
        return entering

    def scatter(
        self, si: mi.SurfaceInteraction3f, sampler: mi.Sampler, light: LightSample, enters: Mask, primal: bool
    ) -> Scattering:
        """The value for a light and a sampled direction, with derivatives unless `primal`."""
        bsdf, lobe, square = si.bsdf(), sampler.next_1d(), sampler.next_2d()
        if not primal:
            return self._scatter_with_gradients(bsdf, si, lobe, square, light, enters)
        if self._direct_only:
            value, through = self._value_and_null_transmission(bsdf, si, light, enters)
            return Scattering(value, mi.Float(0), *_null_sample(si, through, lobe, enters), through)
        value, pdf, sample, weight, through = self._value_pdf_and_sample(
            bsdf, si, light, lobe, square, enters
        )
        return Scattering(dr.select(light.lit, value, 0), pdf, sample, weight, through)

    def _scatter_with_gradients(
        self,
        bsdf: Any,
        si: mi.SurfaceInteraction3f,
        lobe: Float,
        square: Any,
        light: LightSample,
        enters: Mask,
    ) -> Scattering:
        """Derivatives of value, density and of the light that arrives; the sample has none."""
        if self._direct_only:
            through = bsdf.eval_null_transmission(si, enters)
            sample, weight = _null_sample(si, through, lobe, enters)
        else:
            sample, weight = bsdf.sample(self._context, si, lobe, square, enters)
        with dr.resume_grad():
            value, pdf = bsdf.eval_pdf(self._context, si, light.to_light, light.lit)
            attached = (
                self._scene.eval_emitter_direction(si, light.direction, light.lit) / light.direction.pdf
            )
            light.arriving *= dr.relative_grad(dr.select(light.lit, attached, 0))
        return Scattering(value, pdf, sample, weight, mi.Spectrum(0))

    def replay(
        self,
        mode: Any,
        si: mi.SurfaceInteraction3f,
        sample: Any,
        active: Mask,
        parts: Sequence[Color3],
        later: Color3,
        δL: Color3,
    ) -> Color3:
        """Derivatives of one vertex (Vicini et al. 2021): δL of forward mode; backward mode adds gradients.

        Args:
            parts: emission and reflected light of this vertex, with derivatives.
            later: what the rest of the path brings.
        """
        with dr.resume_grad():
            again = si.bsdf().eval(self._context, si, sample.wo, active)
            Lo = sum(parts) + dr.detach(later) * dr.relative_grad(again)
            if mode == dr.ADMode.Backward:
                dr.backward_from(δL * Lo)
                return δL
            return δL + dr.forward_to(Lo)

    def _value_pdf_and_sample(
        self,
        bsdf: Any,
        si: mi.SurfaceInteraction3f,
        light: LightSample,
        lobe: Float,
        square: Any,
        active: Mask,
    ) -> tuple[Any, Any, Any, Any, Any]:
        """All that a vertex needs of its BSDF."""

        def call(one: Any, *asked: Any) -> Any:
            answer = self._traits.surface(one).eval_pdf_sample_and_null_transmission(self._context, *asked)
            # Left out where nobody looks at it, so that it is not computed.
            return answer if self._blends else (*answer[:-1], mi.Spectrum(0))

        results: tuple[Any, Any, Any, Any, Any] = dr.dispatch(
            bsdf, call, si, light.to_light, lobe, square, active
        )
        return results

    def _value_and_null_transmission(
        self, bsdf: Any, si: mi.SurfaceInteraction3f, light: LightSample, enters: Mask
    ) -> tuple[Any, Any]:
        """`eval` where a light counts, and `eval_null_transmission` where a ray goes on, of BSDFs."""
        if not self._traits.holes:
            return bsdf.eval(self._context, si, light.to_light, light.lit), mi.Spectrum(0)

        def call(one: Any, *asked: Any) -> Any:
            return self._traits.surface(one).eval_and_null_transmission(self._context, *asked)

        results: tuple[Any, Any] = dr.dispatch(bsdf, call, si, light.to_light, light.lit, enters)
        return results


def above_triangle(si: Any, towards: Vec3, active: Mask) -> Any:
    """`si` moved from a flat triangle to the smooth surface that its vertex normals stand for.

    Shadows that neighbouring triangles cast end where the shading does. Source: Hanika, "Hacking the shadow
    terminator", Ray Tracing Gems II (2021), chapter 4.

    Args:
        towards: the light; the surface bulges to its side.
    """
    mesh = mi.MeshPtr(si.shape)
    smooth = active & si.shape.is_mesh() & mesh.has_vertex_normals()
    corners = mesh.face_indices(si.prim_index, smooth)
    a, b, c = (mesh.vertex_position(corner, smooth) - si.p for corner in corners)
    area, moved = dr.cross(b - a, c - a), mi.Vector3f(0)
    for corner, place, one, other in zip(corners, (a, b, c), (b, c, a), (c, a, b), strict=True):
        normal = dr.mulsign(mesh.vertex_normal(corner, smooth), dr.dot(si.sh_frame.n, towards))
        weight = dr.dot(dr.cross(one, other), area) * dr.rcp(dr.squared_norm(area))
        moved += weight * maximum(dr.dot(place, normal), 0) * normal
    found = mi.SurfaceInteraction3f(si)
    found.p = si.p + dr.select(smooth & dr.isfinite(dr.squared_norm(moved)), moved, 0)
    return found


def reflected(light: LightSample, scattering: Scattering, throughput: Color3) -> Color3:
    """Light that one vertex reflects of a light sample, weighted against sampled directions."""
    ds = light.direction
    heuristic = dr.select(ds.delta, 1, power_heuristic(ds.pdf, dr.detach(scattering.pdf)))
    return dr.select(light.lit, throughput * heuristic * scattering.value * light.arriving, 0)


@dr.syntax
def _transmittance(
    scene: Any,
    si: mi.SurfaceInteraction3f,
    target: Vec3,
    path: PathState,
    coherent: bool,
    number: Float,
    least_share: Float,
    active: Mask,
) -> Color3:
    """Share of the light [3] that gets from `target` to `si` through the holes between them.

    Args:
        path: at `si`.
        coherent: neighbours' rays go much the same way.
        number: uniform in [0, 1), for Russian roulette.
        least_share: smaller shares are left to it.
    """
    ray = si.spawn_ray_to(target)
    active = mi.Bool(active)
    width, spread, number = mi.Float(path.width), path.spread, mi.Float(number)
    passes = mi.UInt32(0)
    through = mi.Spectrum(1)
    # Few rays pass through more than one hole: without symbolic loops only these are kept.
    # Dr.Jit's stub leaves `compress` out.
    while dr.hint(  # type: ignore[call-arg]
        active, label="footprint_path (shadow)", compress=True
    ):
        pi = scene.ray_intersect_preliminary(ray, coherent=coherent, reorder=False, active=active)
        blocked = active & pi.is_valid()
        other = pi.compute_surface_interaction(ray, mi.RayFlags.All, blocked)
        bsdf = other.bsdf()
        porous = blocked & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null) & (passes < MAX_PASSES)
        width = dr.fma(spread, dr.select(blocked, other.t, 0), width)
        other.duv_dx, other.duv_dy = cone_partials(other, ray.d, width)
        through[blocked] = through * bsdf.eval_null_transmission(other, porous)
        chance = minimum(dr.max(through) * dr.rcp(least_share), 1)
        active = porous & (number < chance)
        through[blocked] = dr.select(active, through * dr.rcp(chance), 0)
        number *= dr.rcp(maximum(chance, 1e-8))
        ray = other.spawn_ray_to(target)
        passes += 1
    return through


def _null_sample(si: mi.SurfaceInteraction3f, through: Any, choice: Any, active: Any) -> tuple[Any, Any]:
    """A BSDF sample and its weight where only passing through holes leads to anything.

    Args:
        through: `eval_null_transmission`.
    """
    bs: Any = dr.zeros(mi.BSDFSample3f)
    bs.wo, bs.pdf, bs.eta = -si.wi, mi.Float(1), mi.Float(1)
    chance = minimum(channel_mean(through), 1)
    passes = active & (choice < chance)
    bs.sampled_type = dr.select(passes, mi.UInt32(+mi.BSDFFlags.Null), 0)
    return bs, dr.select(passes, through * dr.rcp(maximum(chance, 1e-8)), 0)


def power_heuristic(pdf: Any, other: Any) -> Any:
    """MIS weight of a sample drawn with density `pdf` that `other` could have drawn; 0 where both are 0."""
    squared, other_squared = dr.square(pdf), dr.square(other)
    weight = squared / (squared + other_squared)
    return dr.detach(dr.select(dr.isfinite(weight), weight, 0))
