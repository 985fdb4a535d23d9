"""Where a path is, and what each vertex does: footprint, emission, light sample, scattering, derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Color3, Float, Mask, Vec3
from loomlight.core.backend import channel_mean, maximum, minimum
from loomlight.mitsuba.bsdf import FILTERS, SceneTraits
from loomlight.mitsuba.pixels import FirstFootprint, cone_partials, opening


@dataclass
class PathState:
    """Where a path is, and how it got there.

    Attributes:
        ray: from the last surface.
        active: lanes that go on.
        β: throughput.
        η: product of the relative indices of refraction.
        depth: segments, without passing through holes.
        scattered: it has scattered.
        width, spread: of the ray cone at the ray's origin.
        vertex, vertex_pdf, vertex_delta: where the path scattered last, the density of its direction, and
            whether that was a delta: both strategies that reach an emitter start there.
    """

    ray: mi.Ray3f
    active: Any
    β: Any
    η: Any
    depth: Any
    scattered: Any
    width: Any
    spread: Any
    vertex: Any
    vertex_pdf: Any
    vertex_delta: Any

    @classmethod
    def begin(cls, ray: mi.Ray3f, active: Mask, width: Float, spread: Float) -> PathState:
        """The camera's rays."""
        return cls(
            ray=mi.Ray3f(dr.detach(ray)),
            active=mi.Bool(active),
            β=mi.Spectrum(1),
            η=mi.Float(1),
            depth=mi.UInt32(0),
            scattered=mi.Bool(False),
            width=mi.Float(width),
            spread=mi.Float(spread),
            vertex=mi.Point3f(ray.o),
            vertex_pdf=mi.Float(1),
            vertex_delta=mi.Bool(True),
        )

    def scattered_by(
        self, si: mi.SurfaceInteraction3f, scattering: Any, bounced: Mask, passed: Mask, samples: Float
    ) -> PathState:
        """The path beyond a surface.

        Args:
            scattering: what its BSDF drew.
            bounced: lanes that scatter there.
            passed: lanes that pass straight through a hole.
            samples: of a pixel.
        """
        bs = scattering.sample
        delta = mi.has_flag(bs.sampled_type, mi.BSDFFlags.Delta)
        return PathState(
            ray=si.spawn_ray(si.to_world(bs.wo)),
            active=bounced | passed,
            β=self.β * scattering.weight,
            η=self.η * bs.eta,
            depth=self.depth + dr.select(bounced, mi.UInt32(1), 0),
            scattered=self.scattered | bounced,
            width=self.width,
            spread=self.spread + dr.select(bounced & ~delta, opening(bs.pdf, samples), 0),
            vertex=dr.select(bounced, si.p, self.vertex),
            vertex_pdf=dr.select(bounced, bs.pdf, self.vertex_pdf),
            vertex_delta=dr.select(bounced, delta, self.vertex_delta),
        )


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
        lobe, square = sampler.next_1d(), sampler.next_2d()
        if not primal:
            return self._scatter_with_gradients(si.bsdf(), si, lobe, square, light, enters)
        if not self._direct_only:
            value, pdf, sample, weight, through = self._traits.eval_pdf_sample_and_null_transmission(
                self._context, si, light.to_light, lobe, square, enters, self._blends
            )
            return Scattering(dr.select(light.lit, value, 0), pdf, sample, weight, through)
        # No direction but straight on leads to anything.
        if self._traits.holes:
            value, through = self._traits.eval_and_null_transmission(
                self._context, si, light.to_light, light.lit, enters
            )
        else:
            value = si.bsdf().eval(self._context, si, light.to_light, light.lit)
            through = mi.Spectrum(0)
        return Scattering(value, mi.Float(0), *_null_sample(si, through, lobe, enters), through)

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
        # The next surface on the way, with its footprint.
        pi = scene.ray_intersect_preliminary(ray, coherent=coherent, reorder=False, active=active)
        blocked = active & pi.is_valid()
        other = pi.compute_surface_interaction(ray, mi.RayFlags.All, blocked)
        bsdf = other.bsdf()
        porous = blocked & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null) & (passes < MAX_PASSES)
        width = dr.fma(spread, dr.select(blocked, other.t, 0), width)
        other.duv_dx, other.duv_dy = cone_partials(other, ray.d, width)
        # What its holes let through; small shares end by Russian roulette, with one number for all surfaces.
        through[blocked] = through * bsdf.eval_null_transmission(other, porous)
        chance = minimum(dr.max(through) * dr.rcp(least_share), 1)
        active = porous & (number < chance)
        through[blocked] = dr.select(active, through * dr.rcp(chance), 0)
        number *= dr.rcp(maximum(chance, 1e-8))
        # On to the light from there.
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
