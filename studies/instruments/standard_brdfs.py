"""Materials that others have, to be fitted beside cloth: Lambert's and Mitsuba's principled one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import mitsuba as mi
import numpy as np

from studies.instruments.turned_cloth import Floats, Pairs


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


def principled(pairs: Pairs) -> Fitted:
    """Mitsuba's principled BSDF (Burley 2012) with sheen; needs a variant of Mitsuba."""
    bsdf = mi.load_dict(
        {"type": "principled", "base_color": {"type": "rgb", "value": 0.5}} | dict.fromkeys(PRINCIPLED, 0.5)
    )
    parameters = mi.traverse(bsdf)
    interaction = mi.SurfaceInteraction3f()
    interaction.wi = mi.Vector3f(np.ascontiguousarray(pairs.view.T, np.float32))
    light = mi.Vector3f(np.ascontiguousarray(pairs.light.T, np.float32))
    context = mi.BSDFContext()

    def value(numbers: Floats) -> Floats:
        parameters["base_color.value"] = mi.Color3f(*(float(part) for part in numbers[:3]))
        for name, number in zip(PRINCIPLED, numbers[3:], strict=True):
            key = name if name in parameters else f"{name}.value"
            parameters[key] = float(number)
        parameters.update()
        return np.array(bsdf.eval(context, interaction, light), dtype=float).T

    low = np.array([0, 0, 0, 0.05, 0, 0, 0, 0, 0])
    starts = [np.array([0.6, 0.3, 0.2, sheen, 0.5, 0.2]) for sheen in (0.1, 0.8)]
    return Fitted(low, np.ones(9), value, starts)
