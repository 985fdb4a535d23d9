"""Materials that others have, to be fitted beside cloth: Lambert's, Mitsuba's principled one, OpenPBR."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import drjit as dr
import mitsuba as mi
import numpy as np
from drjit.llvm import Array3f, Float

from loomlight.evaluation.isotropic import Floats, Pairs
from loomlight.exporters.cycles import rough_over_lambert
from loomlight.scattering.sheen import sheen_with_transmittance


@dataclass(frozen=True)
class Fitted:
    """Numbers of a material between bounds, and what it answers.

    Attributes:
        low, high: bounds of the numbers [k].
        value: numbers [k] to f·cos [n, 3], 1/sr.
        colours: where linear RGB begins among the numbers.
        starts: of the numbers that are no colour, one or more.
    """

    low: Floats
    high: Floats
    value: Callable[[Floats], Floats]
    starts: list[Floats] = field(default_factory=list)


def lambert(pairs: Pairs) -> Fitted:
    """A colour alone."""
    cosine = pairs.light[:, 2:] / np.pi
    return Fitted(np.zeros(3), np.ones(3), lambda numbers: cosine * numbers, [np.zeros(0)])


# Of Mitsuba's principled BSDF, and where they start; after the colour.
PRINCIPLED = ("roughness", "specular", "spec_tint", "sheen", "sheen_tint", "flatness")


# With clear coat.
COAT = ("clearcoat", "clearcoat_gloss")


def principled(pairs: Pairs, coat: bool = False) -> Fitted:
    """Mitsuba's principled BSDF (Burley 2012) with sheen; needs a variant of Mitsuba."""
    names = (*PRINCIPLED, *(COAT if coat else ()))
    bsdf = mi.load_dict(
        {"type": "principled", "base_color": {"type": "rgb", "value": 0.5}} | dict.fromkeys(names, 0.5)
    )
    parameters = mi.traverse(bsdf)
    interaction = mi.SurfaceInteraction3f()
    interaction.wi = mi.Vector3f(np.ascontiguousarray(pairs.view.T, np.float32))
    light = mi.Vector3f(np.ascontiguousarray(pairs.light.T, np.float32))
    context = mi.BSDFContext()

    def value(numbers: Floats) -> Floats:
        parameters["base_color.value"] = mi.Color3f(*(float(part) for part in numbers[:3]))
        for name, number in zip(names, numbers[3:], strict=True):
            key = name if name in parameters else f"{name}.value"
            parameters[key] = float(number)
        parameters.update()
        return np.array(bsdf.eval(context, interaction, light), dtype=float).T

    low = np.array([0, 0, 0, 0.05, *np.zeros(len(names) - 1)])
    starts = [np.array([0.6, 0.3, 0.2, sheen, 0.5, 0.2, 0.1, 0.2][: len(names)]) for sheen in (0.1, 0.8)]
    return Fitted(low, np.ones(len(low)), value, starts)


def openpbr(pairs: Pairs) -> Fitted:
    """OpenPBR 1.1 without coat: base with rough diffuse, a dielectric's highlight, and fuzz.

    Numbers after the colour: base_diffuse_roughness; reflectance at normal incidence that specular_weight and
    specular_ior make, 0 to 0.5; specular_roughness; the hue of specular_color, from white to the base's; its
    strength, 0 to 1; fuzz_weight and fuzz_roughness. Slabs take from what is below as the view sees them: the
    highlight takes Schlick's reflectance at the view's cosine.
    """
    count = len(pairs)
    up = np.tile([0.0, 0.0, 1.0], (count, 1))
    cosine, cos_view = pairs.light[:, 2:], pairs.view[:, 2:]
    half = pairs.light + pairs.view
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    of_half, of_view = (
        (1 - each) ** 5 for each in ((pairs.view * half).sum(axis=1, keepdims=True), cos_view)
    )
    light, view = (Array3f(np.ascontiguousarray(part.T, np.float32)) for part in (pairs.light, pairs.view))

    def value(numbers: Floats) -> Floats:
        base, (rough, f0, gloss, hue, strength, fuzz, fuzz_rough) = numbers[:3], numbers[3:]
        colours = np.broadcast_to(base, (count, 3))
        diffuse = base / np.pi * cosine * rough_over_lambert(up, pairs.light, pairs.view, colours, rough)
        colour = strength * (1 - hue + hue * base / max(base.max(), 1e-6))
        distribution = _ggx(pairs, half, gloss * gloss)
        body = colour * (f0 + (1 - f0) * of_half) * distribution * cosine
        body = body + (1 - colour * (f0 + (1 - f0) * of_view)) * diffuse
        lobe, through = (
            part.numpy()[:, None]
            for part in sheen_with_transmittance(
                light, view, dr.opaque(Float, fuzz), dr.opaque(Float, fuzz_rough)
            )
        )
        found: Floats = through * body + lobe
        return found

    low = np.array([0, 0, 0, 0, 0, 0.05, 0, 0, 0, 0.05])
    high = np.array([1, 1, 1, 1, 0.5, 1, 1, 1, 1, 1])
    starts = [np.array([0.5, 0.04, 0.6, 0.2, 0.8, fuzz, 0.5]) for fuzz in (0.05, 0.5)]
    return Fitted(low, high, value, starts)


def _ggx(pairs: Pairs, half: Floats, alpha: float) -> Floats:
    """D G/(4 cos cos) of GGX with Smith's height-correlated masking [n, 1]."""
    light, view = pairs.light[:, 2:], pairs.view[:, 2:]
    squared = alpha * alpha
    distribution = squared / (np.pi * (half[:, 2:] ** 2 * (squared - 1) + 1) ** 2)
    of_view = light * np.sqrt(squared + (1 - squared) * view**2)
    of_light = view * np.sqrt(squared + (1 - squared) * light**2)
    found: Floats = distribution * 0.5 / (of_view + of_light)
    return found
