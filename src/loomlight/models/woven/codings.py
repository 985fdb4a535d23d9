"""What the decoder makes of places and directions before and after its layers.

One set of formulas for Dr.Jit and for machine code: `arrays` is the module drjit, or a `Code` that is being
written.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from loomlight.models.woven.architecture import (
    BINS,
    BLOB_REACH,
    BUNDLE_PLACES,
    BUNDLE_UNIT,
    BUNDLES,
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_BINS,
    INCLINATION_CROWDING,
    INCLINATION_REACH,
    LARGEST_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    SLOPE,
    TRANSMISSION_GAIN,
)

# Of components, the first are diffuse.
DIFFUSE = 2


@dataclass
class Direction:
    """A unit vector in the frame of the face that is seen."""

    x: Any
    y: Any
    z: Any


@dataclass
class Fibre:
    """Fibres of one family on a yarn's crown.

    Attributes:
        x, y: their direction, a unit vector.
        roughness: α.
    """

    x: Any
    y: Any
    roughness: Any

    def cosine(self, x: Any, y: Any) -> Any:
        """Cosine with a unit vector, or a sum of cosines with a sum of them."""
        return self.x * x + self.y * y


def one_blob(place: Sequence[Any], arrays: Any) -> list[Any]:
    """One-blob coding of x, y and size, `BINS` numbers each; see `network.one_blob`."""
    coded = []
    for number, value in enumerate(place):
        for bin_ in range(BINS):
            offset = value - (bin_ + 0.5) / BINS
            if number < 2:
                offset -= arrays.round(offset)
            distance = offset * (BINS / BLOB_REACH)
            coded.append(_bump(distance, arrays))
    return coded


def fibre_features(light: Any, view: Any, fibres: Sequence[Fibre], arrays: Any) -> list[Any]:
    """What lights bring of `network.fibre_features`: `LIGHT_FEATURES` numbers."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    height = arrays.fma(z, z, OPPOSITE)
    inverse_square = arrays.rcp(arrays.fma(x, x, arrays.fma(y, y, height)))
    cosines, bins, densities = [], [], []
    for fibre in fibres:
        cosines.append(fibre.cosine(light.x, light.y))
        cosine = fibre.cosine(x, y)
        square = arrays.square(cosine)
        reach = arrays.fma(INCLINATION_CROWDING, arrays.sqrt(square + height), arrays.abs(cosine))
        place = (0.5 * (1 + INCLINATION_CROWDING)) * cosine * arrays.rcp(reach)
        place = (place + 0.5) * (INCLINATION_BINS / INCLINATION_REACH)
        for bin_ in range(INCLINATION_BINS):
            bins.append(_bump(place - (bin_ + 0.5) / INCLINATION_REACH, arrays))
        squared = arrays.square(fibre.roughness)
        q = arrays.fma(square * inverse_square, 1 - squared, squared)
        density = (DENSITY_GAIN / math.pi) * squared * fibre.roughness * arrays.rcp(arrays.square(q))
        densities.append(DENSITY_SCALE * arrays.log(1 + density))
    return [*cosines, *bins, *densities]


def _bump(distance: Any, arrays: Any) -> Any:
    return arrays.square(arrays.maximum(arrays.fma(-distance, distance, 1), 0))


def mixed_bundles(
    shares: Sequence[Any], light: Any, view: Any, bundles: Sequence[Any], back: Any, arrays: Any
) -> list[Any]:
    """`network.mixed_bundles`: the specular components of both families.

    Args:
        shares: what is put out for the bundles of the face that is seen [2 · `BUNDLES`].
        light, view: in the frame of that face.
        bundles: of the front, b and a for both families [2][`BUNDLES`][4]; see `Fibres.bundles`.
        back: whether the back is seen.
    """
    across, along, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared_norm = arrays.fma(across, across, arrays.fma(along, along, arrays.square(z)))
    inverse = arrays.rcp(squared_norm + OPPOSITE)
    mixed = []
    for family, of_front in enumerate(bundles):
        # Those of the back are mirrored across the yarn, and so is their order of places.
        x = across if family else arrays.select(back, -across, across)
        y = arrays.select(back, -along, along) if family else along
        kept = shares[family * BUNDLES : (family + 1) * BUNDLES]
        fractions = []
        for number, (along_x, along_y, along_z, width) in enumerate(of_front):
            cosine = arrays.fma(along_x, x, arrays.fma(along_y, y, along_z * z))
            root = arrays.fma(arrays.square(cosine), inverse, width)
            behind = _mirrored(number)
            share = kept[number] if behind == number else arrays.select(back, kept[behind], kept[number])
            fractions.append((arrays.maximum(share, share * SLOPE), arrays.square(root)))
        mixed.append(BUNDLE_UNIT * _sum_of_fractions(fractions, arrays))
    return mixed


def _sum_of_fractions(fractions: Sequence[tuple[Any, Any]], arrays: Any) -> Any:
    """Two at a time, with one division for both."""
    total: Any = 0
    for (share, square), (other, others) in zip(fractions[::2], fractions[1::2], strict=False):
        above = arrays.fma(share, others, other * square)
        total = arrays.fma(above, arrays.rcp(square * others), total)
    if len(fractions) % 2:
        share, square = fractions[-1]
        total = arrays.fma(share, arrays.rcp(square), total)
    return total


def _mirrored(bundle: int) -> int:
    """The number on the back of a bundle of the front."""
    slope, place = divmod(bundle, BUNDLE_PLACES)
    return bundle if bundle == BUNDLES - 1 else slope * BUNDLE_PLACES + BUNDLE_PLACES - 1 - place


def unmapped(
    output: Sequence[Any], specular: Sequence[Any] | None, height: Any, linear_diffuse: bool, arrays: Any
) -> list[Any]:
    """The four components, 1/sr, ≥ 0: `losses.unmapped`.

    Args:
        output: what the network puts out of them; of diffuse ones alone where bundles are mixed.
        specular: components as bundles mix them.
        height: z of the light, in the frame of the face that is seen.
        linear_diffuse: whether diffuse components are put out as they are.
    """
    scale = arrays.select(height > 0, 1 / REFLECTION_GAIN, 1 / TRANSMISSION_GAIN)
    found = []
    for number, value in enumerate(output):
        if linear_diffuse and number < DIFFUSE:
            found.append(arrays.maximum(value, 0))
        else:
            found.append((arrays.exp(arrays.clip(value, 0, LARGEST_OUTPUT)) - 1) * scale)
    # As bright as a logarithm of `LARGEST_OUTPUT` is.
    most = math.expm1(LARGEST_OUTPUT) * scale
    return [*found, *(arrays.clip(component, 0, most) for component in specular or ())]
