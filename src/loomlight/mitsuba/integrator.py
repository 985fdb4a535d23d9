"""`footprint_path`: a path tracer that tells every BSDF how much of the cloth the pixel sees.

It estimates what Mitsuba's `path` estimates: next-event estimation and BSDF sampling, combined by the power
heuristic, Russian roulette. It adds two things:

- ``si.duv_dx`` and ``si.duv_dy`` hold the footprint in uv: from the camera's ray differentials (shrunk by
  1/sqrt(samples)) on the first surface, from a ray cone beyond.
- Holes: a surface whose BSDF has the flag ``Null`` lets shadow rays through by ``eval_null_transmission``,
  and a path that passes through one keeps the MIS weight of the vertex before it. Passing costs no depth.
  Where no BSDF lets through what would be seen (`lets_light_through` of cloth averaged over footprints),
  shadows are plain ones.

Where all lights are points or directions, paths end with the last light sample; pictures of direct light
then draw no directions at all.

Derivatives of BSDF and emitter parameters come from path replay (Vicini et al. 2021); the shadows of holes
and the positions of surfaces are held fixed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import channel_mean, maximum, minimum
from loomlight.core.frozen import gc_paused
from loomlight.mitsuba.bsdf_samples import set_samples_per_pixel
from loomlight.mitsuba.ray_cone import cone_partials, opening, pixel_cone

# A ray that passes through this many holes is ended; cloth folded upon itself has a dozen.
MOST_PASSES = 64
# Light that comes straight from an emitter behind less transmittance than this is dropped: a third of a step
# of 8-bit sRGB on white cloth.
_NO_LIGHT = 1e-4


def footprint_path_class() -> type:
    """The integrator's class in the current variant, for `mi.register_integrator`."""
    base: Any = mi.ad.integrators.common.RBIntegrator

    class FootprintPath(base):
        """Path tracer with pixel footprints and holes.

        Parameters:
            max_depth: longest path in segments, -1 (default) without a bound.
            rr_depth: depth at which Russian roulette begins, 5.
            hide_emitters: directly visible emitters do not show, false.
            footprint_samples: how many samples share a pixel; 0 (default) means those of the render call.
                A picture that is averaged from several renders names their sum here.
            pixel_centres: every camera ray goes through the middle of its pixel, false. For one sample a
                pixel of models that average over the footprint, which is the pixel itself then.
        """

        def __init__(self, props: Any) -> None:
            if "max_depth" not in props:
                props["max_depth"] = -1
            super().__init__(props)
            self.footprint_samples: int = props.get("footprint_samples", 0)
            # How many renders make up the picture, and which this is: `render` says so.
            self.passes, self.pass_number = 1, 0
            self.pixel_centres: bool = props.get("pixel_centres", False)
            # Whether nobody asks the film afterwards: it may be left out then.
            self.skip_film = False

        def to_string(self) -> str:
            depth = "unbounded" if self.max_depth == 0xFFFFFFFF else self.max_depth
            return (
                f"FootprintPath[max_depth = {depth}, rr_depth = {self.rr_depth}, "
                f"hide_emitters = {self.hide_emitters}, footprint_samples = {self.footprint_samples}, "
                f"pixel_centres = {self.pixel_centres}]"
            )

        def prepare(self, sensor: Any, seed: Any = 0, spp: int = 0, aovs: Any = ()) -> tuple[Any, int]:
            if self.passes == 1:
                prepared: tuple[Any, int] = super().prepare(sensor, seed, spp, list(aovs))
                return prepared
            sampler = sensor.sampler().clone()
            sampler.set_sample_count(spp * self.passes)
            sampler.set_samples_per_wavefront(spp)
            film = sensor.film()
            border = 2 * film.rfilter().border_size() if film.sample_border() else 0
            sampler.seed(seed, dr.prod(film.crop_size() + border) * spp)
            # Evaluated: what led there would be part of the kernel, which each pass would compile anew.
            sampler.schedule_state()
            dr.eval()
            for _ in range(self.pass_number):
                sampler.advance()
                sampler.schedule_state()
                dr.eval()
            film.prepare(list(aovs))
            return sampler, spp

        def sample_rays(self, scene: Any, sensor: Any, sampler: Any) -> tuple[Any, Any, Any]:
            set_samples_per_pixel(self._samples(sampler))
            of_pass = sampler.sample_count() // self.passes
            places = _CameraSampler(sampler, of_pass, self.pixel_centres)
            ray, weight, position = super().sample_rays(scene, sensor, places)
            ray.scale_differential(self._samples(sampler) ** -0.5)
            return ray, weight, position

        def render(
            self,
            scene: Any,
            sensor: Any = 0,
            seed: Any = 0,
            spp: int = 0,
            develop: bool = True,
            evaluate: bool = True,
        ) -> Any:
            camera = scene.sensors()[sensor] if isinstance(sensor, int) else sensor
            with gc_paused(), symbolic_mode(scene):
                if self.skip_film and develop and samples_are_pixels(camera, spp):
                    return self._pixels_of_samples(scene, camera, seed)
                return super().render(scene, camera, seed, spp, develop, evaluate)

        def _pixels_of_samples(self, scene: Any, camera: Any, seed: Any) -> Any:
            """A picture of one sample a pixel, as the film would develop it."""
            film = camera.film()
            with dr.suspend_grad():
                sampler, _ = self.prepare(camera, seed, 1, self.aov_names())
                ray, weight, _ = self.sample_rays(scene, camera, sampler)
                found, valid, _, _ = self.sample(
                    mode=dr.ADMode.Primal,
                    scene=scene,
                    sampler=sampler,
                    ray=ray,
                    δL=None,
                    state_in=None,
                    active=mi.Bool(True),
                )
                pixels: Any = found * weight
                if mi.has_flag(film.flags(), mi.FilmFlags.Alpha):
                    pixels = mi.Vector4f(*pixels, dr.select(valid, mi.Float(1), 0))
                width, height = (int(side) for side in film.crop_size())
                tensor: Any = mi.TensorXf
                return tensor(dr.ravel(pixels), (height, width, len(pixels)))

        def _samples(self, sampler: Any) -> int:
            return self.footprint_samples or sampler.sample_count()

        @dr.syntax
        def sample(
            self,
            mode: Any,
            scene: Any,
            sampler: Any,
            ray: Any,
            δL: Any,
            state_in: Any,
            active: Any,
            **_unused: Any,
        ) -> tuple[Any, Any, list[Any], Any]:
            primal = mode == dr.ADMode.Primal
            context = mi.BSDFContext()
            samples = self._samples(sampler)
            holes, porous_shadows = has_holes(scene), has_porous_shadows(scene)
            # Lights that no direction drawn by chance can meet leave nothing to find after the last bounce.
            met = has_hittable_emitters(scene)
            direct_only = not met and self.max_depth <= 2

            camera = ray
            width, spread = pixel_cone(ray)
            ray = mi.Ray3f(dr.detach(ray))
            active = mi.Bool(active)
            L = mi.Spectrum(0 if primal else state_in)
            δL = mi.Spectrum(δL if δL is not None else 0)
            β: Any = mi.Spectrum(1)
            η = mi.Float(1)
            depth = mi.UInt32(0)
            passes = mi.UInt32(0)
            scattered = mi.Bool(False)
            visible = mi.Bool(scene.environment() is not None and not self.hide_emitters)

            # The last vertex that scattered: both strategies that reach an emitter start there.
            vertex = mi.Point3f(ray.o)
            vertex_pdf = mi.Float(1)
            vertex_delta = mi.Bool(True)

            pi = scene.ray_intersect_preliminary(ray, coherent=True, reorder=False, active=active)
            if dr.hint(self.hide_emitters, mode="scalar"):
                pi = self._beyond_emitters(scene, ray, pi, active)

            # As a loop variable the camera's ray would be copied, and copies lose the differentials.
            while dr.hint(active, exclude=[camera], label=f"footprint_path ({mode.name})"):
                si = pi.compute_surface_interaction(ray, mi.RayFlags.All, active)
                valid = active & si.is_valid()
                bsdf = si.bsdf()

                # ---- Footprint
                width = dr.fma(spread, dr.select(valid, si.t, 0), width)
                si.compute_uv_partials(camera)
                if dr.hint(not direct_only, mode="scalar"):
                    duv_dx, duv_dy = cone_partials(si, ray.d, width)
                    si.duv_dx = dr.select(scattered, duv_dx, si.duv_dx)
                    si.duv_dy = dr.select(scattered, duv_dy, si.duv_dy)

                # ---- Emission
                Le: Any = mi.Spectrum(0)
                if dr.hint(met, mode="scalar"):
                    origin = dr.zeros(mi.Interaction3f)
                    origin.p = vertex
                    ds = mi.DirectionSample3f(scene, si, origin)
                    emitter_pdf = scene.pdf_emitter_direction(origin, ds, ~vertex_delta & active)
                    shown = active & (scattered | (not self.hide_emitters))
                    with dr.resume_grad(when=not primal):
                        emitted = ds.emitter.eval(si, shown)
                        Le = β * power_heuristic(vertex_pdf, emitter_pdf) * emitted

                # ---- A light
                bounces = valid & (depth + 1 < self.max_depth)
                lit = bounces & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Smooth)
                ds, arriving = scene.sample_emitter_direction(si, sampler.next_2d(), False, lit)
                lit &= ds.pdf != 0
                to_light = si.to_local(ds.d)
                if dr.hint(porous_shadows, mode="scalar"):
                    # Where no light arrives the cloth need not be asked what it does with it.
                    arriving *= self._transmittance(scene, si, ds.p, width, spread, not met, lit)
                    lit &= dr.max(arriving) > 0
                else:
                    # As to points and along directions, neighbours' rays go much the same way.
                    lit &= ~scene.ray_test(si.spawn_ray_to(ds.p), not met, lit)

                # ---- The next direction. Past the last bounce a path still passes through holes, because
                # the previous vertex's light samples did.
                enters = mi.Bool(bounces)
                if dr.hint(holes, mode="scalar"):
                    enters |= valid & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null)
                lobe, square = sampler.next_1d(), sampler.next_2d()
                if dr.hint(primal and direct_only, mode="scalar"):
                    value, through = _value_and_null_transmission(
                        bsdf, context, si, to_light, lit, holes, enters
                    )
                    bs, weight = _null_sample(si, through, lobe, enters)
                    pdf = mi.Float(0)
                elif dr.hint(primal, mode="scalar"):
                    value, pdf, bs, weight = _value_pdf_and_sample(
                        bsdf, context, si, to_light, lobe, square, enters
                    )
                    value = dr.select(lit, value, 0)
                else:
                    if dr.hint(direct_only, mode="scalar"):
                        through = bsdf.eval_null_transmission(si, enters)
                        bs, weight = _null_sample(si, through, lobe, enters)
                    else:
                        bs, weight = bsdf.sample(context, si, lobe, square, enters)
                    with dr.resume_grad():
                        value, pdf = bsdf.eval_pdf(context, si, to_light, lit)
                        attached = scene.eval_emitter_direction(si, ds, lit) / ds.pdf
                        arriving *= dr.relative_grad(dr.select(lit, attached, 0))

                with dr.resume_grad(when=not primal):
                    heuristic = dr.select(ds.delta, 1, power_heuristic(ds.pdf, dr.detach(pdf)))
                    Lr = dr.select(lit, β * heuristic * value * arriving, 0)

                # ---- Onwards
                passed = enters & mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null)
                delta = mi.has_flag(bs.sampled_type, mi.BSDFFlags.Delta)
                bounced = bounces & ~passed
                visible |= valid & ~passed
                L = (L + Le + Lr) if primal else (L - Le - Lr)

                ray_next = si.spawn_ray(si.to_world(bs.wo))
                active_next = bounced | (passed & (passes < MOST_PASSES))
                if dr.hint(not met, mode="scalar"):
                    active_next &= passed | (depth + 2 < self.max_depth)
                β *= weight
                η *= bs.eta
                β_max = dr.max(β)
                active_next &= β_max != 0
                survival = minimum(β_max * dr.square(η), 0.95)
                roulette = bounced & (depth >= self.rr_depth)
                β[roulette] *= dr.rcp(survival)
                active_next &= ~roulette | (sampler.next_1d() < survival)

                vertex = dr.select(bounced, si.p, vertex)
                vertex_pdf = dr.select(bounced, bs.pdf, vertex_pdf)
                vertex_delta = dr.select(bounced, delta, vertex_delta)
                spread += dr.select(bounced & ~delta, opening(bs.pdf, samples), 0)
                scattered |= bounced
                depth[bounced] += 1
                passes[passed] += 1

                if dr.hint(not primal, mode="scalar"):
                    with dr.resume_grad():
                        again = bsdf.eval(context, si, bs.wo, active_next & ~delta)
                        Lo = Le + Lr + dr.detach(L) * dr.relative_grad(again)
                        if dr.hint(mode == dr.ADMode.Backward, mode="scalar"):
                            dr.backward_from(δL * Lo)
                        else:
                            δL += dr.forward_to(Lo)

                # Straight on through holes rays are as alike as before.
                pi = scene.ray_intersect_preliminary(
                    ray_next, coherent=direct_only, reorder=False, active=active_next
                )
                ray = ray_next
                active = active_next

            return (L if primal else δL), visible, [], L

        @dr.syntax
        def _transmittance(
            self, scene: Any, si: Any, target: Any, width: Any, spread: Any, alike: bool, active: Any
        ) -> Any:
            """Share of the light [3] that gets from `target` to `si` through the holes between them.

            Args:
                alike: whether neighbours' rays go much the same way, as to points and along directions:
                    Embree then takes them together, which made pictures of direct light a sixth faster.
            """
            ray = si.spawn_ray_to(target)
            active = mi.Bool(active)
            width = mi.Float(width)
            passes = mi.UInt32(0)
            through = mi.Spectrum(1)
            # Few rays pass through more than one hole: without symbolic loops only these are kept.
            # Dr.Jit's stub leaves `compress` out.
            while dr.hint(  # type: ignore[call-arg]
                active, label="footprint_path (shadow)", compress=True
            ):
                pi = scene.ray_intersect_preliminary(ray, coherent=alike, reorder=False, active=active)
                blocked = active & pi.is_valid()
                other = pi.compute_surface_interaction(ray, mi.RayFlags.All, blocked)
                bsdf = other.bsdf()
                porous = blocked & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null) & (passes < MOST_PASSES)
                width = dr.fma(spread, dr.select(blocked, other.t, 0), width)
                other.duv_dx, other.duv_dy = cone_partials(other, ray.d, width)
                through[blocked] = through * bsdf.eval_null_transmission(other, porous)
                ray = other.spawn_ray_to(target)
                passes += 1
                active = porous & (dr.max(through) > _NO_LIGHT)
            return through

        def _beyond_emitters(self, scene: Any, ray: Any, pi: Any, active: Any) -> Any:
            """The first intersection that is no area emitter."""
            emitter = active & pi.is_valid() & (pi.shape.emitter() != None)  # noqa: E711 (Dr.Jit pointer)
            si = pi.compute_surface_interaction(ray, mi.RayFlags.Minimal, emitter)
            return dr.select(emitter, self.skip_area_emitters(scene, si.spawn_ray(ray.d), True, emitter), pi)

    return FootprintPath


def _null_sample(si: Any, through: Any, choice: Any, active: Any) -> tuple[Any, Any]:
    """A BSDF sample and its weight where only passing through holes leads to anything.

    Args:
        through: `eval_null_transmission`.
    """
    bs: Any = dr.zeros(mi.BSDFSample3f)
    bs.wo, bs.pdf, bs.eta = -si.wi, mi.Float(1), mi.Float(1)
    chance = channel_mean(through)
    passes = active & (choice < chance)
    bs.sampled_type = dr.select(passes, mi.UInt32(+mi.BSDFFlags.Null), 0)
    return bs, dr.select(passes, through * dr.rcp(maximum(chance, 1e-8)), 0)


# Mitsuba's own calls ask BSDFs written in Python for one thing after another, and each works out anew
# what the cloth looks like from here. Within one call both come of the same.


def _value_pdf_and_sample(
    bsdf: Any, context: Any, si: Any, to_light: Any, lobe: Any, square: Any, active: Any
) -> tuple[Any, Any, Any, Any]:
    """`eval_pdf_sample` of BSDFs, their own where they have one."""

    def asked(one: Any, *of_lanes: Any) -> Any:
        if one is None:  # A scene without any BSDF.
            return mi.Spectrum(0), mi.Float(0), dr.zeros(mi.BSDFSample3f), mi.Spectrum(0)
        return one.eval_pdf_sample(context, *of_lanes)

    found: tuple[Any, Any, Any, Any] = dr.dispatch(bsdf, asked, si, to_light, lobe, square, active)
    return found


def _value_and_null_transmission(
    bsdf: Any, context: Any, si: Any, to_light: Any, lit: Any, holes: bool, enters: Any
) -> tuple[Any, Any]:
    """`eval` where a light counts, and `eval_null_transmission` where a ray goes on, of BSDFs."""
    if not holes:
        return bsdf.eval(context, si, to_light, lit), mi.Spectrum(0)

    def asked(one: Any, si: Any, to_light: Any, lit: Any, enters: Any) -> Any:
        if one is None:
            return mi.Spectrum(0), mi.Spectrum(0)
        if hasattr(one, "eval_and_null_transmission"):
            return one.eval_and_null_transmission(context, si, to_light, lit, enters)
        return one.eval(context, si, to_light, lit), one.eval_null_transmission(si, enters)

    found: tuple[Any, Any] = dr.dispatch(bsdf, asked, si, to_light, lit, enters)
    return found


class _CameraSampler:
    """A sampler, as far as camera rays need one, of the samples of a pixel that one pass takes.

    Where rays go through pixel centres its first square sample, the place in the pixel, is the middle.
    """

    def __init__(self, sampler: Any, of_pass: int, centred: bool) -> None:
        self._sampler = sampler
        self._of_pass = of_pass
        self._centred = centred

    def sample_count(self) -> int:
        return self._of_pass

    def next_1d(self) -> Any:
        return self._sampler.next_1d()

    def next_2d(self) -> Any:
        drawn = self._sampler.next_2d()
        if not self._centred:
            return drawn
        self._centred = False
        return mi.Point2f(0.5)


def samples_are_pixels(camera: Any, spp: int) -> bool:
    """Whether a picture of so many samples a pixel (0: the sampler's) is nothing but its samples.

    The film would add them up one by one in whatever order, which takes a tenth of a picture of lobes.
    """
    film = camera.film()
    count = spp or camera.sampler().sample_count()
    # Films tell their format to readers alone.
    plain = re.search(r"pixel_format = rgba?\b", str(film)) is not None
    return bool(count == 1 and mi.is_rgb and plain and film.rfilter().is_box_filter())


def footprint_integrator(scene: Any) -> Any:
    """The scene's own integrator if it is a `footprint_path`, otherwise a new one."""
    own = scene.integrator()
    return own if type(own).__name__ == "FootprintPath" else mi.load_dict({"type": "footprint_path"})


@contextmanager
def bypass_film(integrator: Any) -> Iterator[None]:
    """While nobody asks the film for what an integrator has rendered; of `footprint_path` alone."""
    before = getattr(integrator, "skip_film", None)
    if before is None:
        yield
        return
    integrator.skip_film = True
    try:
        yield
    finally:
        integrator.skip_film = before


@contextmanager
def symbolic_mode(scene: Any) -> Iterator[None]:
    """Symbolic calls and loops, unless a surface must not be traced in them; see `Model.symbolic`."""
    symbolic = is_symbolic(scene)
    with (
        dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, symbolic and dr.flag(dr.JitFlag.SymbolicCalls)),
        dr.scoped_set_flag(dr.JitFlag.SymbolicLoops, symbolic and dr.flag(dr.JitFlag.SymbolicLoops)),
    ):
        yield


def is_symbolic(scene: Any) -> bool:
    """Whether Dr.Jit may trace every surface of the scene in symbolic calls."""
    return all(
        shape.bsdf() is None or getattr(shape.bsdf(), "symbolic_calls", True) for shape in scene.shapes()
    )


def has_hittable_emitters(scene: Any) -> bool:
    """Whether the scene has lights that a ray can meet: of an extent, or all around."""
    return any(not mi.has_flag(emitter.flags(), mi.EmitterFlags.Delta) for emitter in scene.emitters())


def has_holes(scene: Any) -> bool:
    """Whether any surface of the scene lets light pass straight through."""
    return any(
        shape.class_name() == "Instance" or (shape.bsdf() is not None and _lets_through(shape.bsdf()))
        for shape in scene.shapes()
    )


def has_porous_shadows(scene: Any) -> bool:
    """Whether any surface of the scene lets through enough light to be seen in its shadow."""
    return any(
        shape.class_name() == "Instance"
        or (
            shape.bsdf() is not None
            and _lets_through(shape.bsdf())
            and getattr(shape.bsdf(), "lets_light_through", True)
        )
        for shape in scene.shapes()
    )


def _lets_through(bsdf: Any) -> bool:
    return bool(mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null))


def power_heuristic(pdf: Any, other: Any) -> Any:
    """MIS weight of a sample drawn with density `pdf` that `other` could have drawn; 0 where both are 0."""
    squared, other_squared = dr.square(pdf), dr.square(other)
    weight = squared / (squared + other_squared)
    return dr.detach(dr.select(dr.isfinite(weight), weight, 0))
