"""How much of the base to use: the control variate's best coefficient, by view.

The base looks at texels that a mean offset shifts, so at grazing views it says little about what rays
meet. Its best coefficient is β = Cov(m, b)/Var(b), of the texel model m and the base b over places and
lights; with β below it, the residual only grows.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.models.clustered.base import DeviceTables
from loomlight.models.clustered.square_map import bin_centres
from loomlight.models.clustered.visibility_tables import VIEW_BINS

_PLACES = 512
_LIGHTS = 8


def trust_by_view(tables: DeviceTables, float_type: FloatType) -> NDArray[np.float32]:
    """β, 0 to 1 [2 faces, view bins]."""
    types = array_types(float_type)
    views = bin_centres(VIEW_BINS)
    rng = np.random.default_rng(0)
    lanes = len(views) * _PLACES
    lane = dr.arange(types.UInt32, lanes)
    bin_of = lane // _PLACES
    flat = types.Float(np.ascontiguousarray(views, np.float32).ravel())
    view = types.Vector3(*(dr.gather(types.Float, flat, bin_of * 3 + axis) for axis in range(3)))
    x, y = (types.Float(rng.random(lanes, np.float32)) * extent for extent in tables.size)
    found = []
    for face in (False, True):
        back = dr.full(types.Bool, face, lanes)
        base = tables.seen_from(view, back)
        point = tables.texels.meet(types.Vector2(x, y), view, back)
        texel = tables.texels.texel_at(x + base.offset.x, y + base.offset.y)
        dr.eval(point, texel)
        covariance, variance = (np.zeros(len(views)) for _ in range(2))
        for number in range(_LIGHTS):
            height = (number + 0.5) / _LIGHTS
            turn = dr.opaque(types.Float, 2.399963 * number)
            radius = dr.opaque(types.Float, float(np.sqrt(1 - height**2)))
            sine, cosine = dr.sincos(turn)
            light = types.Vector3(radius * cosine, radius * sine, dr.opaque(types.Float, height))
            lit = tables.texels.lobes(point, light, view)[2].numpy().reshape(len(views), _PLACES)
            of_base = base.at_texel(texel, base.light_taps(light)).light_visibility
            known = of_base.numpy().reshape(len(views), _PLACES)
            known = known - known.mean(axis=1, keepdims=True)
            covariance += (lit * known).mean(axis=1)
            variance += np.square(known).mean(axis=1)
        found.append(np.clip(covariance / np.maximum(variance, 1e-9), 0, 1))
    return np.stack(found).astype(np.float32)
