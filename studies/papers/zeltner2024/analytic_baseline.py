"""A simple analytic BRDF with eight channels a texel, fitted to a material: the baseline of zeltner2024.

Base colour, roughness, metallicity, specular strength and the two slopes of a normal: Lambert's law and one
GGX lobe with Smith's shadowing and Schlick's Fresnel term, as in real-time renderers. The textures are fitted
by gradient descent to queries as the neural model learns from, with its loss, an L1 norm of logarithms.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, Vec3
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.texture.queries import draw_directions, draw_lights, footprint_values
from loomlight.sources.material import Material
from studies.instruments.cosine_bsdf import cosine_bsdf

CHANNELS = 8
_STEPS = 1500
_BATCH = 1 << 16
_RATE = 0.04
_MIN_ALPHA = 0.02
# Added before logarithms, 1/sr.
_FLOOR = 0.01
_SEED = 9


def analytic_value(channels: Sequence[Float], light: Vec3, view: Vec3) -> Color3:
    """f·cos of eight channels, 1/sr; 0 below the shading normal's or the macro surface's horizon.

    Args:
        channels: unbounded numbers: base colour (3), roughness, metallicity, specular strength, slopes (2).
    """
    base = mi.Color3f(*(_sigmoid(part) for part in channels[:3]))
    roughness, metallic, strength = (_sigmoid(part) for part in channels[3:6])
    normal = dr.normalize(mi.Vector3f(*(dr.tanh(-part) for part in channels[6:]), 1))
    cos_light = dr.maximum(dr.dot(normal, light), 0)
    cos_view = dr.maximum(dr.dot(normal, view), 1e-3)
    half = dr.normalize(light + view)
    cos_half = dr.clip(dr.dot(normal, half), 0, 1)
    squared = dr.square(dr.maximum(dr.square(roughness), _MIN_ALPHA))
    density = squared / (dr.pi * dr.square(dr.square(cos_half) * (squared - 1) + 1))
    shadowing = 0.5 / dr.maximum(
        cos_view * dr.sqrt(squared + (1 - squared) * dr.square(cos_light))
        + cos_light * dr.sqrt(squared + (1 - squared) * dr.square(cos_view)),
        1e-4,
    )
    normal_incidence = metallic * base + (1 - metallic) * 0.08 * strength
    grazing = (1 - dr.clip(dr.dot(light, half), 0, 1)) ** 5
    fresnel = normal_incidence + (1 - normal_incidence) * grazing
    value = base * (1 - metallic) * dr.inv_pi + fresnel * (density * shadowing)
    return dr.select((light.z > 0) & (view.z > 0), value * cos_light, 0)


def fitted_channels(source: Material, resolution: int, steps: int | None = None) -> NDArray[np.float32]:
    """The eight channels of each texel [rows, columns, 8] of a material, unbounded.

    Args:
        resolution: texels along a side, a power of two.
        steps: of the fit; 1500 by default.
    """
    choose_variant()
    btf = MaterialBtf(source)
    texels = btf.texels(resolution)
    columns, rows = texels.resolution
    textures: Any = dr.zeros(mi.Float, columns * rows * CHANNELS)
    optimiser: Any = mi.ad.Adam(lr=_RATE)
    optimiser["textures"] = textures
    count = _STEPS if steps is None else steps
    for step in range(count):
        rng = np.random.default_rng([_SEED, step])
        texel = rng.integers(columns * rows, size=_BATCH)
        place = np.stack([texel % columns + 0.5, texel // columns + 0.5], axis=1) / (columns, rows)
        views = draw_directions(rng, _BATCH)
        lights = draw_lights(rng, views)
        level = np.zeros(_BATCH, np.float32)
        truth = mi.Color3f(
            footprint_values(
                btf, texels, place.astype(np.float32), level, lights, views, (_SEED, step)
            ).T.copy()
        )
        first = mi.UInt32(texel.astype(np.uint32)) * CHANNELS
        channels = [dr.gather(mi.Float, optimiser["textures"], first + k) for k in range(CHANNELS)]
        value = analytic_value(channels, mi.Vector3f(lights.T.copy()), mi.Vector3f(views.T.copy()))
        error = dr.abs(dr.log(value + _FLOOR) - dr.log(truth + _FLOOR))
        # Each texel's gradient stands for itself: the mean over a batch would leave it next to nothing.
        dr.backward(dr.sum(error.x + error.y + error.z))
        optimiser.set_learning_rate(_RATE * (1 - 0.9 * step / count))
        optimiser.step()
    return np.array(optimiser["textures"], np.float32).reshape(rows, columns, CHANNELS)


def analytic_factory(source: Material, resolution: int, steps: int | None = None) -> BsdfFactory:
    """The BSDF of the fit; arguments as of `fitted_channels`."""
    texture_type: Any = mi.Texture2f
    channels = mi.TensorXf(fitted_channels(source, resolution, steps))
    texture = texture_type(channels, wrap_mode=dr.WrapMode.Repeat)

    def value(si: Any, wo: Any) -> Any:
        return analytic_value(texture.eval(si.uv), wo, si.wi)

    return lambda _size: cosine_bsdf(value)


def _sigmoid(value: Float) -> Float:
    return 0.5 + 0.5 * dr.tanh(0.5 * value)
