"""`footprint_path`: a path tracer that hands every BSDF the footprint of the pixel.

It estimates what Mitsuba's `path` estimates: next-event estimation and BSDF sampling, combined by the power
heuristic, Russian roulette. It adds two things:

- ``si.duv_dx`` and ``si.duv_dy`` hold the footprint in uv: from the camera's ray differentials on the first
  surface, from a ray cone beyond. For BSDFs that filter it is a part of the film's filter, whatever the
  number of samples (`pixels.py`, where samples, their places and their footprints are).
- Holes: a surface whose BSDF has the flag ``Null`` lets shadow rays through by ``eval_null_transmission``,
  and a path that passes through one keeps the MIS weight of the vertex before it. Passing costs no depth.
  What the camera sees through holes of BSDFs that filter is blended in by their share (`CameraWalk`).
  Where no BSDF lets through what would be seen (`lets_light_through` of cloth averaged over footprints),
  shadows are plain ones.

Where all lights are points or directions, paths end with the last light sample; pictures of direct light
then draw no directions at all.

Derivatives of BSDF and emitter parameters come from path replay (Vicini et al. 2021); the shadows of holes
and the positions of surfaces are held fixed.

The file reads downwards: the integrator, from a render to the loop over a path's vertices, whose comments are
its table of contents; then the state of a path, the steps of a vertex, the camera's ray through holes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import InvariantDivider, channel_mean, maximum, minimum, opaque
from loomlight.core.frozen import gc_paused
from loomlight.mitsuba.bsdf import FILTERS, SceneTraits, sharing_pixels, symbolic_mode, variant_types
from loomlight.mitsuba.camera import Corner, Pinhole
from loomlight.mitsuba.denoising import camera_guides
from loomlight.mitsuba.layers import camera_layers
from loomlight.mitsuba.pixels import (
    FirstFootprint,
    PixelFilter,
    PixelSampler,
    SplattingSensor,
    cone_partials,
    film_border,
    film_width,
    has_pixel_sampler,
    means_of_pixels,
    opening,
    pixel_cone,
    samples_are_pixels,
    samples_of,
)


class _Render:
    """What a render knows of its scene and sensor before it traces.

    No dataclass: Dr.Jit would look for variables of loops in it, and in all BSDFs.

    Attributes:
        traits: of the scene, its BSDFs adapted.
        replays: paths are followed again, for derivatives.
        pixel_filter: the division of the film's filter; None where no surface filters, or it has none.
        offset: of rays from their samples' places, pixels [2]; None where that is the same.
    """

    def __init__(self, scene: Any, replays: bool = False) -> None:
        self.traits = SceneTraits.of(scene)
        self.replays = replays
        self.pixel_filter: PixelFilter | None = None
        self.offset: Vec2 | None = None

    def shared_by(self, samples: Float) -> Float:
        """Samples that share a footprint of BSDFs that filter.

        Where those are a part of the film's filter they are as large with more samples as ever, and each
        takes as many points as one would.
        """
        return samples if self.pixel_filter is None else 1


def footprint_path_class() -> type:
    """The integrator's class in the current variant: Mitsuba's base classes differ from one to another."""
    return _class_of(mi.variant())


@cache
def _class_of(_variant: str) -> type:
    base: Any = mi.ad.integrators.common.RBIntegrator

    class FootprintPath(base):
        """Path tracer with pixel footprints and holes.

        Parameters:
            max_depth: longest path in segments, -1 (default) without a bound.
            rr_depth: depth at which Russian roulette begins, 5.
            hide_emitters: directly visible emitters do not show, false.
            pixel_centres: every camera ray goes through the middle of its pixel, false. For one sample a
                pixel of models that average over the footprint, which has all of the filter's variance then.

        Attributes:
            picture_samples: samples a pixel of the picture that this render is a part of; 0: it is all.
            pass_number: of this render among those that make up the picture with one `PixelSampler`.
            skip_film: nobody asks the film afterwards: it may be left out then.
            apart: samples count in their own pixels alone; see `PixelFilter`.
            soft_terminator: shadows begin on the smooth surface that vertex normals stand for.
            corner: a close-up in a corner of the picture, or None.
            background: radiance that camera rays find where they meet nothing; None for the emitters' own.
        """

        def __init__(self, props: Any) -> None:
            if "max_depth" not in props:
                props["max_depth"] = -1
            super().__init__(props)
            self.pixel_centres: bool = props.get("pixel_centres", False)
            self.picture_samples = 0
            self.pass_number = 0
            self.skip_film = False
            self.apart, self.soft_terminator = False, False
            self.corner: Corner | None = None
            self.background: float | None = None
            self._render: _Render | None = None

        def to_string(self) -> str:
            depth = "unbounded" if self.max_depth == 0xFFFFFFFF else self.max_depth
            return (
                f"FootprintPath[max_depth = {depth}, rr_depth = {self.rr_depth}, "
                f"hide_emitters = {self.hide_emitters}, pixel_centres = {self.pixel_centres}]"
            )

        def render(
            self,
            scene: Any,
            sensor: Any = 0,
            seed: Any = 0,
            spp: int = 0,
            develop: bool = True,
            evaluate: bool = True,
        ) -> Any:
            with self._prepared(scene, sensor) as camera, dr.suspend_grad():
                # Camera rays, a sample each: where they start, and where on the film they count.
                film = camera.film()
                sampler, spp = self.prepare(camera, seed, spp, self.aov_names())
                ray, weight, position = self.sample_rays(scene, camera, sampler)
                # Light that comes along them.
                found, valid, aovs, _ = self.sample(
                    mode=dr.ADMode.Primal,
                    scene=scene,
                    sampler=sampler,
                    ray=ray,
                    δL=None,
                    state_in=None,
                    active=mi.Bool(True),
                )
                value, alpha = found * weight, dr.select(valid, mi.Float(1), 0)
                # The film is no part of the kernel, which so serves all sizes and filters.
                dr.eval(value, alpha, position)
                # A picture that is the means of its pixels' samples needs no film.
                if self.skip_film and samples_are_pixels(camera, spp):
                    has_alpha = mi.has_flag(film.flags(), mi.FilmFlags.Alpha)
                    return means_of_pixels([*value, alpha] if has_alpha else [*value], spp, film)
                # Any other is splatted.
                block = film.create_block()
                block.set_coalesce(block.coalesce() and spp >= 4)
                base._splat_to_block(block, film, position, value, mi.Float(1), alpha, aovs, ray.wavelengths)
                film.put_block(block)
                return film.develop()

        def render_forward(
            self, scene: Any, params: Any, sensor: Any = 0, seed: Any = 0, spp: int = 0
        ) -> Any:
            with self._prepared(scene, sensor, replays=True) as camera:
                return super().render_forward(scene, params, camera, seed, spp)

        def render_backward(
            self, scene: Any, params: Any, grad_in: Any, sensor: Any = 0, seed: Any = 0, spp: int = 0
        ) -> None:
            with self._prepared(scene, sensor, replays=True) as camera:
                super().render_backward(scene, params, grad_in, camera, seed, spp)

        @contextmanager
        def _prepared(self, scene: Any, sensor: Any, replays: bool = False) -> Iterator[Any]:
            """The sensor to render with: samples stay in their pixels where `PixelFilter` places them."""
            camera = scene.sensors()[sensor] if isinstance(sensor, int) else sensor
            # Derivatives of its place and of its field of view are Mitsuba's own.
            camera = camera if replays else Pinhole.of(camera, self.corner)
            render = _Render(scene, replays)
            if render.traits.filters or self.apart:
                render.pixel_filter = PixelFilter.of(camera.film(), self.pixel_centres, self.apart)
            self._render = render
            try:
                with gc_paused(), symbolic_mode(render.traits):
                    splits = render.pixel_filter
                    yield camera if splits is None else SplattingSensor(camera, splits)
            finally:
                # Left behind, its array would be one more input of a frozen function.
                self._render = None

        def guides(self, scene: Any, sensor: Any, seed: Any, spp: int, start: int = 0) -> Any:
            """What the camera sees, but for noise of light; see `camera_guides`.

            Args:
                spp: samples a pixel.
                start: number of the first of them, where others were taken before.

            Returns:
                a tensor [height, width, 6].
            """

            def look(render: _Render, first: FirstFootprint, ray: Any, number: Any) -> Any:
                shows = not self.hide_emitters
                return camera_guides(
                    scene, render.traits, first, ray, number, shows, MAX_PASSES, self.background
                )

            return self._seen(scene, sensor, seed, spp, start, look)

        def layers(self, scene: Any, sensor: Any, seed: Any, spp: int, start: int = 0) -> Any:
            """Albedo, normal, distance and roughness of what the camera sees; see `camera_layers`.

            Args:
                spp: samples a pixel.
                start: number of the first of them, where others were taken before.

            Returns:
                a tensor [height, width, 9].
            """

            def look(render: _Render, first: FirstFootprint, ray: Any, number: Any) -> Any:
                return camera_layers(scene, render.traits, first, ray, number, MAX_PASSES)

            return self._seen(scene, sensor, seed, spp, start, look)

        def _seen(self, scene: Any, sensor: Any, seed: Any, spp: int, start: int, look: Any) -> Any:
            """Means over pixels of what `look` finds along camera rays."""
            with self._prepared(scene, sensor) as camera, dr.suspend_grad():
                render = self._of(scene)
                sampler, spp = self.prepare(camera, seed, spp, [])
                ray, _, _ = self.sample_rays(scene, camera, sampler)
                samples = dr.opaque(mi.Float, spp)
                first = FirstFootprint.of(render.pixel_filter, render.offset, ray, samples)
                number = samples_of(camera.film(), spp)[1] + dr.opaque(mi.UInt32, start)
                with sharing_pixels(render.shared_by(samples)):
                    found = look(render, first, ray, number)
                return means_of_pixels(found, spp, camera.film())

        def prepare(self, sensor: Any, seed: Any = 0, spp: int = 0, aovs: Any = ()) -> tuple[Any, int]:
            # Path replay clones samplers and draws the very numbers again.
            replays = self._render is not None and self._render.replays
            if replays or not has_pixel_sampler(sensor):
                prepared: tuple[Any, int] = super().prepare(sensor, seed, spp, list(aovs))
                return prepared
            spp = spp or sensor.sampler().sample_count()
            pixel, number = samples_of(sensor.film(), spp)
            sensor.film().prepare(list(aovs))
            number += dr.opaque(mi.UInt32, self.pass_number * spp)
            return PixelSampler.of(pixel, number, seed, spp), spp

        def sample_rays(self, scene: Any, sensor: Any, sampler: Any) -> tuple[Any, Any, Any]:
            render, film = self._of(scene), sensor.film()
            # The pixel of each sample.
            pixel, _ = samples_of(film, sampler.sample_count())
            row, column = InvariantDivider(film_width(film), variant_types()).divide(pixel)
            corner, scale = (
                mi.Vector2f(opaque(mi.Float, edge))
                for edge in (film.crop_offset() - film_border(film), 1 / np.array(film.crop_size()))
            )
            # Where in it the ray goes, and how far past the sample's own place.
            place = sampler.next_2d()
            if render.pixel_filter is not None:
                places = render.pixel_filter.places(place, sampler.next_2d())
                render.offset = places.offset
                # Without symbolic loops it would be computed anew at each vertex.
                if not dr.flag(dr.JitFlag.SymbolicLoops):
                    dr.schedule(render.offset)
                place = 0.5 + places.sample + places.offset
            elif self.pixel_centres:
                place = mi.Point2f(0.5)
            pixel_corner = mi.Vector2f(mi.Float(column), mi.Float(row)) + corner
            position = pixel_corner + place
            # The ray, at a time while the shutter is open, through a point of the lens.
            time = sensor.shutter_open()
            if sensor.shutter_open_time() > 0:
                time += sampler.next_1d() * sensor.shutter_open_time()
            with dr.resume_grad():
                ray, weight = sensor.sample_ray_differential(
                    time=time,
                    sample1=0,
                    sample2=(position - mi.Vector2f(opaque(mi.Float, film.crop_offset()))) * scale,
                    sample3=sampler.next_2d() if sensor.needs_aperture_sample() else mi.Point2f(0),
                )
            # The sample counts at its own place.
            if film.rfilter().is_box_filter():
                return ray, weight, pixel_corner
            return ray, weight, position if render.offset is None else position - render.offset

        def _of(self, scene: Any) -> _Render:
            """The render that is going on."""
            return self._render or _Render(scene)

        def sample(
            self,
            mode: Any,
            scene: Any,
            sampler: mi.Sampler,
            ray: mi.Ray3f,
            δL: Any,
            state_in: Any,
            active: Any,
            **_unused: Any,
        ) -> tuple[Any, Any, list[Any], Any]:
            # Data, like all that another picture may have: kernels serve any number of samples.
            samples = dr.opaque(mi.Float, self.picture_samples or sampler.sample_count())
            with sharing_pixels(self._of(scene).shared_by(samples)):
                return self._traced(mode, scene, sampler, ray, δL, state_in, active, samples)

        @dr.syntax
        def _traced(
            self,
            mode: Any,
            scene: Any,
            sampler: mi.Sampler,
            ray: mi.Ray3f,
            δL: Any,
            state_in: Any,
            active: Any,
            samples: Any,
        ) -> tuple[Any, Any, list[Any], Any]:
            # What is traced at all: facts of the scene, which are no data of kernels; depths are.
            primal = mode == dr.ADMode.Primal
            max_depth = dr.opaque(mi.UInt32, self.max_depth)
            render = self._of(scene)
            hittable = render.traits.hittable_emitters
            direct_only = not hittable and self.max_depth <= 2
            # Path replay follows the very paths again: there holes are left to chance.
            blends = render.traits.filtered_holes and not render.replays
            least_share = least_share_of(samples, hittable)
            vertices = PathVertices(
                scene, render.traits, direct_only, blends, least_share, self.soft_terminator
            )

            # The path begins with the camera's ray and the pixel's footprint. Beyond the first scattering
            # each of so many samples stands for its part of the pixel.
            first = FirstFootprint.of(render.pixel_filter, render.offset, ray, samples)
            width, spread = (part * dr.rsqrt(samples) for part in pixel_cone(ray))
            path = PathState.begin(ray, active, width, spread)
            walk = CameraWalk.begin(path, least_share) if blends else None
            L = mi.Spectrum(0 if primal else state_in)
            δL = mi.Spectrum(δL if δL is not None else 0)
            passes = mi.UInt32(0)
            background = None if self.background is None else dr.opaque(mi.Float, self.background)
            visible = mi.Bool(scene.environment() is not None and not self.hide_emitters)

            # The first surface that it meets; emitters that do not show are passed.
            pi = scene.ray_intersect_preliminary(path.ray, coherent=True, reorder=False, active=path.active)
            if dr.hint(self.hide_emitters, mode="scalar"):
                pi = self._beyond_emitters(scene, path.ray, pi, path.active)

            # As a loop variable the camera's ray would be copied, and copies lose the differentials.
            while dr.hint(
                path.active, exclude=[first, samples, max_depth], label=f"footprint_path ({mode.name})"
            ):
                # 1. The vertex: the surface, and what the pixel covers of it.
                si = pi.compute_surface_interaction(path.ray, mi.RayFlags.All, path.active)
                valid = path.active & si.is_valid()
                path.width = dr.fma(path.spread, dr.select(valid, si.t, 0), path.width)
                vertices.set_footprint(si, path, first)

                # 2. Light that it emits, weighted against the light sample of the vertex before.
                β = path.β if walk is None else walk.throughput(path)
                shown = path.active & (path.scattered | (not self.hide_emitters))
                with dr.resume_grad(when=not primal):
                    Le = β * vertices.emission(si, path, shown, primal)
                if dr.hint(background is not None, mode="scalar"):
                    Le = dr.select(path.active & ~valid & ~path.scattered, β * background, Le)

                # 3. A light sample. Past the last bounce a path still passes through holes, because the
                # previous vertex's light samples did.
                bounces = valid & (path.depth + 1 < max_depth)
                light = vertices.sample_light(si, sampler, path, bounces)

                # 4. The BSDF, asked once: its value for that light, the next direction, and its hole.
                enters = vertices.enters(si, valid, bounces)
                scattering = vertices.scatter(si, sampler, light, enters, primal)
                bs = scattering.sample

                # 5. Light that it reflects of the sample.
                with dr.resume_grad(when=not primal):
                    Lr = reflected(light, scattering, β)
                L = (L + Le + Lr) if primal else (L - Le - Lr)

                # 6. The path beyond: scattered, or straight on through a hole; where nothing can be found any
                # more, or by Russian roulette, it ends.
                passed = enters & mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null)
                visible |= valid & ~passed
                may_pass = enters & (passes < MAX_PASSES)
                after = path.scattered_by(si, scattering, bounces & ~passed, passed & may_pass, samples)
                if dr.hint(not hittable, mode="scalar"):
                    after.active &= passed | (after.depth + 1 < max_depth)
                self._play_roulette(after, bounces & ~passed, sampler)

                # 7. Derivatives of this vertex, when paths are replayed.
                if dr.hint(not primal, mode="scalar"):
                    smooth = after.active & ~mi.has_flag(bs.sampled_type, mi.BSDFFlags.Delta)
                    δL = vertices.replay(mode, si, bs, smooth, (Le, Lr), L, δL)

                # 8. What goes on: the path, or the camera's own ray, which first sees all behind the holes.
                if walk is None:
                    path = after
                    passes[passed] += 1
                else:
                    crossing = HoleCrossing(
                        straight=si.spawn_ray(path.ray.d),
                        through=scattering.through,
                        passed=passed,
                        may_pass=may_pass,
                        blends=vertices.filters(si),
                    )
                    walk, path = walk.step(path, after, crossing, sampler.next_1d())
                    passes[passed | walk.on] += 1

                # 9. The surface that it meets next. Straight on through holes rays are as coherent as before.
                pi = scene.ray_intersect_preliminary(
                    path.ray, coherent=direct_only, reorder=False, active=path.active
                )

            return (L if primal else δL), visible, [], L

        def _play_roulette(self, path: PathState, bounced: Any, sampler: mi.Sampler) -> None:
            """Ends paths whose throughput is small, from `rr_depth` on."""
            # Unbiased estimates of a BSDF may be negative.
            β_max = dr.max(abs(path.β))
            path.active &= β_max != 0
            survival = minimum(β_max * dr.square(path.η), 0.95)
            plays = bounced & (path.depth > self.rr_depth)
            path.β[plays] *= dr.rcp(survival)
            path.active &= ~plays | (sampler.next_1d() < survival)

        def _beyond_emitters(self, scene: Any, ray: mi.Ray3f, pi: Any, active: Any) -> Any:
            """The first intersection that is no area emitter."""
            emitter = active & pi.is_valid() & (pi.shape.emitter() != None)  # noqa: E711 (Dr.Jit pointer)
            si = pi.compute_surface_interaction(ray, mi.RayFlags.Minimal, emitter)
            return dr.select(emitter, self.skip_area_emitters(scene, si.spawn_ray(ray.d), True, emitter), pi)

    return FootprintPath


def footprint_integrator(scene: Any) -> Any:
    """The scene's own integrator if it is a `footprint_path`, otherwise a new one."""
    own = scene.integrator()
    return own if is_footprint_path(own) else mi.load_dict({"type": "footprint_path"})


def is_footprint_path(integrator: Any) -> bool:
    """Whether an integrator is one of this module, which knows of settings and passes."""
    return isinstance(integrator, footprint_path_class())


@contextmanager
def with_settings(integrator: Any, **settings: Any) -> Iterator[None]:
    """While attributes of a `footprint_path` have other values; another integrator stays as it is."""
    if not is_footprint_path(integrator):
        yield
        return
    before = {name: getattr(integrator, name) for name in settings}
    try:
        for name, value in settings.items():
            setattr(integrator, name, value)
        yield
    finally:
        for name, value in before.items():
            setattr(integrator, name, value)


# ------------------------------------------------------------------------------------------------- path state
# Where a path is, and how scattering takes it on.


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


# ---------------------------------------------------------------------------------------------- path vertices
# The steps of a path vertex: footprint, emission, a light sample, scattering, and derivatives.


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


# ------------------------------------------------------------------------------------------------ camera walk
# Holes on the camera's own ray: what lies behind is blended in by its share, not met by chance.
#
# A path that enters a hole with probability h brings what lies behind at full strength: at few samples a
# pixel these are specks. Here the camera's ray goes straight on through surfaces with holes, and what it
# meets counts by the share of light that comes through. Beside it, the path that scatters is drawn as ever:
# it rides along until it scatters at one of the surfaces, waits there, and goes on when the ray has ended.
# Emission and light samples of surfaces on the camera's ray thus have no noise from holes; expectations are
# the same, since the path gets to each surface with the probability that is its share.


# What lies behind shows in a pixel in steps of at most this share of its radiance: of n samples those with
# less than n times as much are left to Russian roulette, which costs less. Light of emitters with an extent
# is noisy by itself: steps five times as high leave the variance of pictures of linen as it was.
_MAX_STEP, _MAX_STEP_IN_NOISE = 0.01, 0.05


def least_share_of(samples: Float, noisy: bool) -> Float:
    """Of light through holes: less is left to Russian roulette.

    Args:
        samples: of a pixel.
        noisy: lights have an extent.
    """
    return minimum((_MAX_STEP_IN_NOISE if noisy else _MAX_STEP) * samples, 1)


@dataclass
class HoleCrossing:
    """Transmission of the camera's ray by a surface.

    Attributes:
        straight: the ray beyond it.
        through: share of light that passes straight through [3].
        passed: the path drawn there does.
        may_pass: lanes whose ray may.
        blends: surfaces whose `through` counts; others let the ray through where the path passes.
    """

    straight: Any
    through: Color3
    passed: Mask
    may_pass: Mask
    blends: Mask


@dataclass
class CameraWalk:
    """The camera's ray on its way through surfaces with holes, and the path that waits for its end.

    Attributes:
        on: lanes whose ray goes on.
        share: of the light that comes through all surfaces so far [3], over the chance of having got here.
        rides: lanes whose path has not scattered yet: it is where the ray is.
        path: the path; unless it rides it goes on when the ray has ended.
        least_share: rays of smaller shares are left to Russian roulette.
    """

    on: Any
    share: Any
    rides: Any
    path: PathState
    least_share: Any

    @classmethod
    def begin(cls, path: PathState, least_share: Float) -> CameraWalk:
        """With the camera's rays; see `least_share_of`."""
        return cls(mi.Bool(path.active), mi.Spectrum(1), mi.Bool(True), dr.copy(path), least_share)

    def throughput(self, path: PathState) -> Color3:
        """Of what is met next: by the camera's ray, or by the path."""
        return dr.select(self.on, self.share, path.β)

    def step(
        self, before: PathState, after: PathState, at: HoleCrossing, number: Float
    ) -> tuple[CameraWalk, PathState]:
        """The ray beyond a surface, or the path where the ray ends.

        Args:
            before: at the surface.
            after: of the path that is drawn there.
            number: uniform in [0, 1).

        Returns:
            the walk, and what goes on.
        """
        # Whether the ray goes on: by chance where its share is small.
        chance = minimum(dr.max(self.share * at.through) / self.least_share, 1)
        # Where a path rides and passes, the ray passes too: its own chance is that of the rest.
        # An unbiased estimate of a share may be above 1, the chance of passing is not.
        drawn = dr.select(self.rides, minimum(channel_mean(at.through), 1), 0)
        chance = maximum(chance, drawn)
        rest = (chance - drawn) / maximum(1 - drawn, 1e-6)
        survives = (self.rides & at.passed) | (number < rest)
        on = self.on & at.may_pass & dr.select(at.blends, survives, at.passed)
        weight = dr.select(at.blends, at.through * dr.rcp(maximum(chance, 1e-8)), 1)
        # The path rides along or, once it has scattered, waits for the ray's end.
        path = dr.select(self.on & self.rides, after, self.path)
        following = dr.select(self.on, path, after)
        beyond = replace(before, ray=at.straight, active=on, β=after.β)
        walk = replace(self, on=on, share=self.share * weight, rides=self.rides & at.passed, path=path)
        return walk, dr.select(on, beyond, following)
