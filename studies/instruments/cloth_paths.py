"""Path tracing of cloth: light that goes from yarn to yarn, with the scattering of the point model.

Every vertex of a path scatters like the point model without visibility; what the point model calls shadowed,
a path goes on from: it hits the yarn that stands there. Three conventions make the local scattering whole
where the point model, which meets only lights of the sky, leaves it open:

- directions below the horizon of the cloth but above that of the yarn are reflection, as the yarn's normal
  says;
- light that the yarn itself blocks (above the horizon of the cloth, below that of the yarn) scatters in the
  yarn once more, so that nothing but albedos takes light away;
- light that leaves through a hole goes on over the other face.

Rays march through the analytic heights of the face that they are over: every yarn casts and receives light.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm import Array2f, Array3f, Bool, Float, UInt32, UInt64
from numpy.typing import NDArray

from loomlight.scattering.appearance import Appearance
from loomlight.scattering.diffuse import sample_diffuse
from loomlight.scattering.fibre import pdf_specular, reflection, sample_specular, transmission
from loomlight.scattering.point import YarnPoint, YarnScattering, to_face_frame
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.visibility import Hit, first_hit

# Samples of a ray while it crosses the finest thread, and while it falls through the relief of the cloth.
STEPS_PER_THREAD, STEPS_PER_RELIEF = 24, 24
# Halvings of the step that hit, and most steps of a ray.
BISECTIONS, MAX_STEPS = 8, 4096
# Most vertices of a path; Russian roulette begins after a few.
MAX_BOUNCES, MIN_BOUNCES = 64, 6
# Rays start this share of the finest thread above the yarn.
_LIFT = 2e-3

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Radiance:
    """What a view sees of cloth under a white sky of radiance 1 on both sides, linear RGB [3], and errors.

    Attributes:
        reflected: light that came from the side of the view.
        transmitted: light that came from the other side.
        once: the part of both that scattered once, as the point model has it.
        error: standard error of the sum of reflected and transmitted.
        yarn: share of the view rays that meet yarn; radiances are means over these.
    """

    reflected: Floats
    transmitted: Floats
    once: Floats
    error: Floats
    yarn: float


@dataclass
class _Ray:
    """A ray over one face: origin and direction in the frame of that face, millimetres."""

    x: Float
    y: Float
    z: Float
    direction: Array3f
    back: Bool


def radiance(layout: ClothLayout, appearance: Appearance, view: Floats, paths: int, seed: int) -> Radiance:
    """Mean radiance of the cloth for a view, unit vector [3] above it, by so many paths."""
    model = YarnScattering(YarnGeometry(layout), appearance)
    rng = np.random.default_rng(seed)
    index = np.arange(paths)
    place = [
        Float(((index * share + offset) % 1 * side).astype(np.float32))
        for share, offset, side in zip(
            (0.7548776662466927, 0.5698402909980532), rng.random(2), layout.size, strict=True
        )
    ]
    eye = Array3f(*(Float(float(part)) + dr.zeros(Float, paths) for part in view))
    dr.make_opaque(eye)
    seen = to_face_frame(eye, eye.z < 0)
    hit = first_hit(model.surface, place[0], place[1], seen, eye.z < 0, quality=model.quality)
    dr.eval(hit)
    reflected, transmitted, once = _walk(model, hit, eye, seed)
    yarn = ~hit.hole.numpy()
    back, through, first = (
        np.stack([c.numpy() for c in value]).astype(np.float64)[:, yarn]
        for value in (reflected, transmitted, once)
    )
    both = back + through
    error = both.std(axis=1) / np.sqrt(both.shape[1])
    means = (part.mean(axis=1) for part in (back, through, first))
    reflection_mean, transmission_mean, once_mean = means
    return Radiance(reflection_mean, transmission_mean, once_mean, error, float(yarn.mean()))


def _walk(model: YarnScattering, start: Hit, eye: Array3f, seed: int) -> tuple[Array3f, Array3f, Array3f]:
    count, face = dr.width(start.x), Bool(eye.z < 0)
    rng = dr.llvm.PCG32(size=count, initstate=UInt64(seed))
    zero = dr.zeros(Array3f, count)

    def bounce(
        step: UInt32,
        x: Float,
        y: Float,
        z: Float,
        back: Bool,
        view: Array3f,
        weight: Array3f,
        alive: Bool,
        reflected: Array3f,
        transmitted: Array3f,
        once: Array3f,
        rng: Any,
    ) -> tuple[Any, ...]:
        point = model.at(x, y, back, Bool(False), ray=(view, z))
        direction, factor, far, stays = _scattered(model, point, view, rng)
        weight = dr.select(alive, weight * factor, 0)
        ray, met, escaped = _traced(model, point, direction, far, alive & ~stays)
        # Seen from the first face: the ray may have changed sides once more through a hole.
        same = ray.back == face
        light = dr.select(escaped, weight, 0)
        reflected += dr.select(same, light, 0)
        transmitted += dr.select(same, 0, light)
        once += dr.select(step == 0, light, 0)
        alive &= (met | stays) & (dr.max(weight) > 0)
        survival = dr.select(step < MIN_BOUNCES, Float(1), dr.minimum(dr.max(weight), 0.95))
        alive &= rng.next_float32() < survival
        weight = weight / dr.maximum(survival, 1e-6)
        moved = met & alive
        return (
            step + 1,
            dr.select(moved, ray.x, x), dr.select(moved, ray.y, y), dr.select(moved, ray.z, z),
            dr.select(moved, ray.back, back),
            dr.select(moved, -ray.direction, view), weight, alive & (step + 1 < MAX_BOUNCES),
            reflected, transmitted, once, rng,
        )  # fmt: skip

    state = (
        dr.zeros(UInt32, count), Float(start.x), Float(start.y), Float(start.height), face,
        to_face_frame(eye, face),
        dr.full(Array3f, 1, count), ~start.hole, Array3f(zero), Array3f(zero), Array3f(zero), rng,
    )  # fmt: skip
    result = dr.while_loop(state, lambda *s: s[7], bounce, label="paths between yarns")
    dr.eval(result[8:11])
    return result[8:11]


def _scattered(
    model: YarnScattering, point: YarnPoint, view: Array3f, rng: Any
) -> tuple[Array3f, Array3f, Bool, Bool]:
    """A direction in the frame of the face that it leaves over, its weight, whether that is the other face,
    and whether the yarn itself blocks it."""
    albedos = point.albedos
    blend, depth = Float(model.appearance.diffuse_blend), Float(model.appearance.optical_depth)
    highlight = dr.maximum(albedos.specular_reflect, albedos.specular_transmit)
    shares = [
        dr.sum(part) / 3 for part in (albedos.diffuse_reflect, albedos.diffuse_transmit, 0.5 * highlight)
    ]
    total = dr.maximum(shares[0] + shares[1] + shares[2], 1e-9)
    choice = rng.next_float32() * total
    u = Array2f(rng.next_float32(), rng.next_float32())
    reflects, transmits = choice < shares[0], (choice >= shares[0]) & (choice < shares[0] + shares[1])
    shines = ~reflects & ~transmits
    diffuse = sample_diffuse(point.normal, blend, u)
    specular = sample_specular(view, point.tangent, point.roughness, u)
    light = dr.select(shines, specular, dr.select(reflects, diffuse, -diffuse))
    cosine = dr.dot(light, point.normal)
    # The normal decides for the fibre layer; directions of either sign may lie below the cloth's horizon.
    far = transmits | (shines & (cosine <= 0))
    frame = (point.normal, point.tangent, point.roughness, depth)
    density = dr.maximum(pdf_specular(light, view, point.tangent, point.roughness), 1e-20)
    lobe = dr.select(
        cosine > 0,
        albedos.specular_reflect * reflection(light, view, *frame),
        albedos.specular_transmit * transmission(light, view, *frame),
    )
    weight = dr.select(
        shines,
        lobe / (density * dr.maximum(shares[2] / total, 1e-9)),
        dr.select(
            reflects,
            albedos.diffuse_reflect / dr.maximum(shares[0] / total, 1e-9),
            albedos.diffuse_transmit / dr.maximum(shares[1] / total, 1e-9),
        ),
    )
    other = model.surface.surface(point.x, point.y, ~point.back)
    facing = to_face_frame(light, far)
    outward = dr.dot(facing, dr.select(far, other.normal, point.normal))
    return facing, weight, far, outward <= 0


def _traced(
    model: YarnScattering, point: YarnPoint, direction: Array3f, far: Bool, active: Bool
) -> tuple[_Ray, Bool, Bool]:
    """The end of a ray from a yarn point: (where, whether it meets yarn, whether it leaves the cloth)."""
    surface = model.surface
    lowest, highest = surface.height_bounds
    fine = min(surface.finest)
    low, high = dr.opaque(Float, lowest - _LIFT * fine), dr.opaque(Float, highest + _LIFT * fine)
    cell = dr.opaque(Float, fine / STEPS_PER_THREAD)
    fall = dr.opaque(Float, max(highest - lowest, 1e-6) / STEPS_PER_RELIEF)
    back = point.back ^ far
    level = dr.select(far, surface.height(point.x, point.y, back)[0], point.height)
    across = dr.sqrt(dr.square(direction.x) + dr.square(direction.y))
    size = dr.minimum(cell / dr.maximum(across, 1e-6), fall / dr.maximum(abs(direction.z), 1e-6))

    def advance(
        x: Float,
        y: Float,
        z: Float,
        direction: Array3f,
        back: Bool,
        searching: Bool,
        met: Bool,
        count: UInt32,
    ) -> tuple[Any, ...]:
        nx, ny, nz = x + size * direction.x, y + size * direction.y, z + size * direction.z
        level, hole = surface.height(nx, ny, back)
        hit = searching & ~hole & (nz < level)
        # Below everything that stands on this face: over the other one from here on.
        through = searching & ~hit & (nz < low) & (direction.z < 0)
        out = searching & ~hit & (nz > high) & (direction.z >= 0)
        moves = searching & ~hit
        x, y = dr.select(moves, nx, x), dr.select(moves, ny, y)
        z = dr.select(moves, dr.select(through, -nz, nz), z)
        direction = to_face_frame(direction, through)
        back = back ^ through
        goes_on = moves & ~out & (count + 1 < MAX_STEPS)
        return x, y, z, direction, back, goes_on, met | hit, count + 1

    state = (
        Float(point.x), Float(point.y), level + dr.opaque(Float, _LIFT * fine), direction, Bool(back),
        Bool(active), Bool(False), UInt32(0),
    )  # fmt: skip
    x, y, z, direction, back, _, met, _ = dr.while_loop(
        state, lambda *s: s[5], advance, label="ray between yarns"
    )
    # From the last sample above the cloth towards the first below it.
    first, last = Float(0), Float(size)
    for _ in range(BISECTIONS):
        middle = 0.5 * (first + last)
        level, hole = surface.height(x + middle * direction.x, y + middle * direction.y, back)
        inside = ~hole & (z + middle * direction.z < level)
        first, last = dr.select(inside, first, middle), dr.select(inside, middle, last)
    moved = dr.select(met, last, 0)
    ray = _Ray(x + moved * direction.x, y + moved * direction.y, z + moved * direction.z, direction, back)
    return ray, met & active, ~met & active
