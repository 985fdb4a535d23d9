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

The file reads downwards, from a render to the loop over a path's vertices, whose comments are its table of
contents. Steps of a vertex are in `path_vertices.py`, the camera's ray through holes in `camera_walk.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.core.arrays import Float, Vec2
from loomlight.core.backend import InvariantDivider, minimum, opaque
from loomlight.core.frozen import gc_paused
from loomlight.mitsuba.bsdf import SceneTraits, sharing_pixels, symbolic_mode, variant_types
from loomlight.mitsuba.camera import Corner, Pinhole
from loomlight.mitsuba.camera_walk import CameraWalk, HoleCrossing, least_share_of
from loomlight.mitsuba.denoising import camera_guides
from loomlight.mitsuba.layers import camera_layers
from loomlight.mitsuba.path_vertices import MAX_PASSES, PathState, PathVertices, reflected
from loomlight.mitsuba.pixels import (
    FirstFootprint,
    PixelFilter,
    PixelSampler,
    SplattingSensor,
    film_border,
    film_width,
    has_pixel_sampler,
    means_of_pixels,
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
