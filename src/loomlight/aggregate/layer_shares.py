"""What each layer of layered cloth has of the light that a view and a light show, as closed forms of both.

Seen along the normal, a layer behind shows as much as the gaps before it leave. From aside it is less or
more, and what shows lies in shadow: so one mean colour of warp and one of weft errs where thin layers differ.
Here rays over the repeat are counted by layer, and each count becomes a log-linear rate of a view v and a
light l,

    rate(v, l) = exp(c · (1, t(v), t(l), l_x v_x + l_y v_y)),        t of `DIRECTION_TERMS` terms

by maximum likelihood (Poisson regression). Rates of one family over their sum are the weights of its albedos.
"""

from __future__ import annotations

from typing import Any, Final
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.components import components, without_sheen_and_variation
from loomlight.core.backend import array_types, upload
from loomlight.core.llvm import llvm_float
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.point import YarnScattering, to_face_frame
from loomlight.yarn.layout import ClothLayout, Layer
from loomlight.yarn.stack import StackedGeometry
from loomlight.yarn.visibility import first_hit

# Pairs of a view and a light, each of either side, of a face. With half of them shares of one per cent are
# off by a tenth.
RAYS = 1 << 16
# Directions nearer to grazing than this are left out.
MIN_COSINE = 0.03
# Terms of one direction. Rows of rates are two halves of so many numbers: of the view, 1 first; of the light.
DIRECTION_TERMS = 7
RATE_HALF = DIRECTION_TERMS + 1
# Kinds of rates: diffuse light of the side of the view; that of the other side where no layer lies behind,
# and where one does; and the share of the views that meet yarn with a layer behind, whatever the light.
LIT, BARE, COVERED, BACKED, RATES = range(5)
# Logarithm of the rate of what never shows, and the highest.
NO_RATE, MAX_RATE = -30.0, 3.0
# A rate of fewer rays is constant; ridge, in rays.
_FEWEST, _RIDGE = 64, 1.0
_STEPS = 16
# Power of a uniform number that a sine is: views close to the normal, where people look, are the most.
_TILT = 2 / 3
# Pairs of directions over which rates are integrated, and the six dimensions of the recurrence of rays:
# powers of 1/φ₆, the root of x⁷ = x + 1 (Roberts 2018).
_QUADRATURE = 1 << 11
_STEP = np.array([1.1127756842787055**-power for power in range(1, 7)])

Numbers = NDArray[np.float64]
# By the first layer of a cloth, as long as that lives; with and without ties.
_kept: Final[WeakKeyDictionary[Layer, dict[tuple[Any, ...], Numbers]]] = WeakKeyDictionary()


def direction_terms(x: Any, y: Any, z: Any, sine: Any) -> tuple[Any, ...]:
    """sin θ, sin² θ, (1 − cos θ)², (1 − cos θ)⁴, x² − y², x y, (x² − y²)² of a unit vector in a face's frame.

    Args:
        x, y, z: numbers or arrays, z ≥ 0.
        sine: √(x² + y²).
    """
    squared, across = (1 - z) * (1 - z), x * x - y * y
    return sine, sine * sine, squared, squared * squared, across, x * y, across * across


def view_half(x: Any, y: Any, z: Any, sine: Any) -> tuple[Any, ...]:
    """Terms of rates that do not depend on the light."""
    return 1.0, *direction_terms(x, y, z, sine)


def light_half(x: Any, y: Any, z: Any, sine: Any, view_x: Any, view_y: Any) -> tuple[Any, ...]:
    """The others, of a light and a view in the frame of the face seen, z ≥ 0."""
    return *direction_terms(x, y, z, sine), x * view_x + y * view_y


def layer_rates(geometry: StackedGeometry, appearance: Appearance) -> Numbers:
    """Coefficients of the rates [stacks, layers, 2 faces, 2 families, `RATES`, 2 halves, `RATE_HALF`].

    A rate is that of a footprint which shows its stack alone. They do not depend on colours, and are kept for
    its layers as long as they live.
    """
    layout = geometry.layout
    scales = *map(repr, (geometry.height_scale, geometry.twist)), bool(layout.ties)
    key = appearance.diffuse_blend, *scales
    kept = _kept.setdefault(layout.layers[0], {})
    if key not in kept:
        kept[key] = _measured(geometry, appearance)
    return kept[key]


def _measured(geometry: StackedGeometry, appearance: Appearance) -> Numbers:
    layout, stacks = geometry.layout, len(geometry.ranks)
    count, layers = 2 * RAYS, len(layout.layers)
    places, views, lights = _rays(RAYS)
    # Each pair counts on both faces, by light of either side.
    back, beyond = np.divmod(np.arange(4 * RAYS), count)[0] == 1, np.arange(4 * RAYS) // RAYS % 2 == 1
    number = np.arange(4 * RAYS) % RAYS
    width, height = layout.size
    types = array_types(llvm_float())
    face = np.where(back, -1.0, 1.0)
    side = face * np.where(beyond, -1, 1)
    x, y = (
        upload(types.Float, (place[number] * length).astype(np.float32))
        for place, length in zip(places, (width, height), strict=True)
    )
    view, light = (
        types.Vector3(
            *(
                upload(types.Float, part.astype(np.float32))
                for part in (of[0][number], of[1][number], of[2][number] * sign)
            )
        )
        for of, sign in ((views, face), (lights, side))
    )
    model = without_sheen_and_variation(YarnScattering(geometry, appearance), between_yarns=False)
    is_back = types.Bool(view.z < 0)
    seen = to_face_frame(view, is_back)
    hit = first_hit(geometry, x, y, seen, is_back, True, model.quality)
    point = model.at(hit.x, hit.y, is_back, hit.hole, ray=(seen, hit.height))
    parts = components(model.appearance, point, light, view, model.visibility(point, light))
    # Rays that end beside yarn show the layer that they ended in.
    layer = geometry.surface(hit.x, hit.y, is_back).layer
    behind = types.Bool(False)
    for sheet in geometry.sheets(hit.x, hit.y, is_back):
        behind |= sheet.covered
    diffuse = (parts[0] + parts[1]).numpy().astype(np.float64)
    layer, is_warp, hole, behind = (part.numpy() for part in (layer, point.is_warp, point.hole, behind))
    stack = _stacks(layout, hit.x.numpy(), hit.y.numpy())
    shares = np.ones(1) if layout.stacking is None else layout.stacking.shares()

    terms = _matrix(tuple(part[number] for part in views), tuple(part[number] for part in lights))
    grid = _matrix(*_rays(_QUADRATURE)[1:])
    found = np.zeros((stacks, layers, 2, 2, RATES, 2 * RATE_HALF))
    found[..., 0] = NO_RATE
    kinds = (
        (LIT, ~beyond, diffuse),
        (BARE, beyond & ~behind, diffuse),
        (COVERED, beyond & behind, diffuse),
        (BACKED, ~beyond & behind, np.ones_like(diffuse)),
    )
    for number_of_stack in range(stacks):
        for number_of_layer in range(layers):
            here = (stack == number_of_stack) & (layer == number_of_layer) & ~hole
            for of_face in (0, 1):
                for family in (0, 1):
                    shown = here & (back == of_face) & (is_warp == (family == 0))
                    for kind, of_kind, weight in kinds:
                        counted = np.flatnonzero(shown & of_kind & (weight > 0))
                        only = RATE_HALF if kind == BACKED else 2 * RATE_HALF
                        rate = found[number_of_stack, number_of_layer, of_face, family, kind]
                        per_ray = 1 / (RAYS * max(float(shares[number_of_stack]), 1e-6))
                        rate[:only] = _fitted(terms[counted, :only], weight[counted], grid[:, :only], per_ray)
    return found.reshape(*found.shape[:-1], 2, RATE_HALF)


def _rays(count: int) -> tuple[Numbers, Numbers, Numbers]:
    """Places in repeats [2, n], and unit vectors of views and of lights [3, n], z > 0."""
    unit = (0.5 + np.arange(1, count + 1)[:, None] * _STEP) % 1
    directions = []
    for tilt, turn in ((2, 3), (4, 5)):
        sine = np.sqrt(1 - MIN_COSINE**2) * unit[:, tilt] ** _TILT
        z = np.sqrt(1 - sine * sine)
        angle = 2 * np.pi * unit[:, turn]
        directions.append(np.stack([sine * np.cos(angle), sine * np.sin(angle), z]))
    return unit[:, :2].T, directions[0], directions[1]


def _matrix(views: Any, lights: Any) -> Numbers:
    """Terms of both halves as columns [n, terms]."""
    view, light = ((x, y, z, np.sqrt(x * x + y * y)) for x, y, z in (views, lights))
    terms = *view_half(*view), *light_half(*light, *view[:2])
    return np.stack(np.broadcast_arrays(*terms), axis=1)


def _stacks(layout: ClothLayout, x: NDArray[np.float32], y: NDArray[np.float32]) -> NDArray[np.intp]:
    """The stack at draft coordinates, millimetres [n]."""
    if layout.stacking is None:
        return np.zeros(len(x), np.intp)
    crossing = [
        np.minimum(
            np.searchsorted(np.cumsum(family.spacing), place % family.spacing.sum()), family.spacing.size - 1
        )
        for place, family in ((y, layout.weft), (x, layout.warp))
    ]
    return layout.stacking.regions[crossing[0], crossing[1]].astype(np.intp)


def _fitted(terms: Numbers, weights: Numbers, grid: Numbers, per_ray: float) -> Numbers:
    """Coefficients [terms] of the rate of which rays are a sample, by maximum likelihood.

    Args:
        terms: of the rays that count [n, terms].
        weights: of them [n].
        grid: terms of pairs that all rays are as dense as [q, terms].
        per_ray: share of the footprint that a ray stands for.
    """
    found = np.zeros(grid.shape[1])
    total = float(weights.sum())
    found[0] = np.log(max(total * per_ray, np.exp(NO_RATE)))
    if len(terms) < _FEWEST:
        return found
    # Rays of mean weight count as one.
    unit = total / len(terms)
    sums = weights @ terms / unit
    scale = 1 / (per_ray * unit * len(grid))
    for _ in range(_STEPS):
        rates = np.exp(np.clip(grid @ found, NO_RATE, MAX_RATE)) * scale
        slope = sums - rates @ grid - _RIDGE * np.r_[0, found[1:]]
        curve = (grid * rates[:, None]).T @ grid + _RIDGE * np.eye(len(found))
        step = np.linalg.solve(curve, slope)
        found += step * min(1.0, 2 / max(float(np.abs(step).max()), 1e-9))
    return found
