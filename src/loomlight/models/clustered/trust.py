"""Coefficients of the base and of the texel model as control variates: the best ones, by view.

The base looks at texels that a mean offset shifts, so at grazing views it says little about what rays
meet; the texel model errs where shadows have fine edges. The best coefficient of a control variate g
of f is β = Cov(f, g)/Var(g), over places and lights: with β below it, the residual only grows.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.components import components
from loomlight.core.arrays import Float, FloatType, Mask, Vec3
from loomlight.core.backend import array_types
from loomlight.models.clustered.base import DeviceTables
from loomlight.models.clustered.square_map import bin_centres
from loomlight.models.clustered.visibility_tables import VIEW_BINS
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.yarn_point import to_face_frame

_PLACES = 512
_LIGHTS = 8


def trust_by_view(
    tables: DeviceTables, model: YarnScattering, float_type: FloatType
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """β of the base and of the texel model, each 0 to 1, for the point model.

    Returns:
        Of the base and of the texel model, for the diffuse and the specular term [2 faces, view bins, 2].
    """
    types = array_types(float_type)
    views = bin_centres(VIEW_BINS)
    rng = np.random.default_rng(0)
    lanes = len(views) * _PLACES
    lane = dr.arange(types.UInt32, lanes)
    bin_of = lane // _PLACES
    flat = types.Float(np.ascontiguousarray(views, np.float32).ravel())
    view = types.Vector3(*(dr.gather(types.Float, flat, bin_of * 3 + axis) for axis in range(3)))
    x, y = (types.Float(rng.random(lanes, np.float32)) * extent for extent in tables.size)

    def by_view(part: Float) -> NDArray[np.float64]:
        found = part.numpy().astype(np.float64).reshape(len(views), _PLACES)
        return found - found.mean(axis=1, keepdims=True)

    of_base, of_texels = [], []
    for face in (False, True):
        back: Mask = dr.full(types.Bool, face, lanes)
        base = tables.seen_from(view, back)
        near = tables.texels.meet(types.Vector2(x, y), view, back)
        texel = tables.texels.texel_at(x + base.offset.x, y + base.offset.y)
        seen = to_face_frame(view, back)
        point = model.locate(x, y, seen)
        dr.eval(near, texel, point)
        covariance, variance = (np.zeros((4, len(views))) for _ in range(2))
        for light in _lights(view):
            diffuse, specular, _ = tables.texels.lobes(near, light, view)
            known = base.at_texel(texel, base.light_taps(light))
            outside = to_face_frame(light, back)
            exact = components(model.appearance, point, outside, seen, model.visibility(point, outside, True))
            dr.eval(diffuse, specular, known, exact)
            wanted = by_view(exact[0] + exact[1]), by_view(exact[2] + exact[3])
            guesses = (
                known.diffuse_warp + known.diffuse_weft,
                known.specular_warp + known.specular_weft,
                diffuse,
                specular,
            )
            for number, guess in enumerate(guesses):
                guessed = by_view(guess)
                covariance[number] += (wanted[number % 2] * guessed).mean(axis=1)
                variance[number] += np.square(guessed).mean(axis=1)
        trust = np.clip(covariance / np.maximum(variance, 1e-12), 0, 1).astype(np.float32)
        of_base.append(trust[:2].T)
        of_texels.append(trust[2:].T)
    return np.stack(of_base), np.stack(of_texels)


def _lights(view: Vec3) -> list[Vec3]:
    """Directions evenly over the hemisphere."""
    types = array_types(view.x)
    found = []
    for number in range(_LIGHTS):
        height = (number + 0.5) / _LIGHTS
        radius = (1 - height**2) ** 0.5
        turn = 2.399963 * number
        parts = (radius * np.cos(turn), radius * np.sin(turn), height)
        found.append(types.Vector3(*(dr.opaque(types.Float, float(part)) for part in parts)))
    return found
