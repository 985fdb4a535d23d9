"""Constants of the Python modules for Slang: each is written once, where its formula stands.

Most are private to their modules; this is the only other reader.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from loomlight.aggregate import footprint_albedos
from loomlight.core import footprint as core_footprint
from loomlight.models.lobes import (
    accumulation,
    cloth_samples,
    clustering,
    coverage_lookup,
    coverage_pyramid,
    density,
    groups,
    hemisphere,
    packed_uint8,
    point_sampled,
    prefiltered,
    regimes,
    visibility_rays,
    visibility_tables,
)
from loomlight.models.lobes import bsdf as lobe_bsdf
from loomlight.models.lobes import proposal as lobe_proposal
from loomlight.models.lobes import tables as lobe_tables
from loomlight.realtime.clustered_tables import clustered_floats, clustered_uints
from loomlight.realtime.latent_tables import latent_floats, latent_uints
from loomlight.realtime.neumip_tables import neumip_floats, neumip_uints
from loomlight.realtime.neural_tables import neural_floats, neural_uints
from loomlight.realtime.openness_tables import openness_floats, openness_uints
from loomlight.scattering import detail, directions, fibre, sheen, sheen_coefficients, variation
from loomlight.yarn import max_heights, rays, runs, search, threads

_FLOATS: dict[str, float] = {
    "PLY_EDGE_SINE": detail.PLY_EDGE_SINE,
    "GROOVE_DEPTH": detail.GROOVE_DEPTH,
    "BUNDLE_FIBRES": detail.BUNDLE_FIBRES,
    "WAVE_LENGTH": detail.WAVE_LENGTH,
    "WAVE_SHARE": detail.WAVE_SHARE,
    "HAIR_CELL": detail.HAIR_CELL,
    "HAIR_SHORTEST": detail.HAIR_SHORTEST,
    "HAIR_LONGEST": detail.HAIR_LONGEST,
    "HAIR_HALF_WIDTH": detail.HAIR_HALF_WIDTH,
    "HAIR_CURL": detail.HAIR_CURL,
    "HAIR_EDGE_SINE": detail.HAIR_EDGE_SINE,
    "SLUB_DEPTH": detail.SLUB_DEPTH,
    "SLUB_MIDDLE": detail.SLUB_MIDDLE,
    "NOISE_VARIANCE": detail.NOISE_VARIANCE,
    "TILT_SCALE": detail.TILT_SCALE,
    "TURN_SCALE": detail.TURN_SCALE,
    "DIFFUSE_TURN_LOSS": detail.DIFFUSE_LOSS,
    "INVERSE_SECTION_SINE": 1 / math.sin(threads.SECTION_ANGLE),
    "INVERSE_CELL_MAX_LEVELS": 1 / runs.CELL_MAX_LEVELS,
    "OUTLINE_EPSILON": search._EPSILON,
    "NARROWEST_DIP": search._NARROWEST,
    "STEPS_PER_THREAD": search.DEFAULT_QUALITY.steps_per_thread,
    "STEPS_PER_RELIEF": search.DEFAULT_QUALITY.steps_per_relief,
    "SHADOW_SHARE": search.DEFAULT_QUALITY.shadow_share,
    "FLATTEST_SHARE": rays._FLATTEST,
    "SMALLEST_COSINE": fibre._SMALLEST_COSINE,
    "SMALLEST_SQUARED_SUM": fibre._SMALLEST_SQUARED_SUM,
    "SMALLEST_SQUARED_LENGTH": directions.SMALLEST_SQUARED_LENGTH,
    "SHEEN_SMALLEST": sheen._SMALLEST,
    "SHEEN_SMALLEST_SCALE": sheen._SMALLEST_SCALE,
    "SHEEN_LARGEST_SHEAR": sheen._LARGEST_SHEAR,
    "SHEEN_CEILING": sheen_coefficients.CEILING,
    "FIBRE_CELL_LENGTH": variation.FIBRE_CELL_LENGTH,
    "LARGEST_FIBRE_GAIN": variation._LARGEST_FIBRE_GAIN,
    "MIN_NODE_COSINE": hemisphere.MIN_COSINE,
    "TENT_VARIANCE": coverage_lookup.TENT_VARIANCE,
    "TAP_SIZE": coverage_lookup.TAP_SIZE,
    "MIN_TAP_SPACING": coverage_lookup.MIN_TAP_SPACING,
    "MIN_FOOTPRINT": coverage_lookup._MIN_SIZE,
    "GROUP_NARROWEST": density.NARROWEST,
    "GROUP_SMALLEST_STEEPNESS": density.SMALLEST_STEEPNESS,
    "GROUP_SMALLEST_COSINE": density.SMALLEST_COSINE,
    "GROUP_SPREAD_LOSS": density.SPREAD_LOSS,
    "GROUP_SMALLEST_PATH": density.SMALLEST_PATH,
    "SPECULAR_CORRELATION": prefiltered.SPECULAR_CORRELATION,
    "LARGEST_CORRELATION": prefiltered.LARGEST_CORRELATION,
    "DIFFUSE_LOSS": prefiltered.DIFFUSE_LOSS,
    "SMALLEST_GROUP_WEIGHT": lobe_bsdf.SMALLEST_WEIGHT,
    "BLEND_FROM": math.log2(regimes._BLEND_RANGE[0]),
    "BLEND_TO": math.log2(regimes._BLEND_RANGE[1]),
    "SMALLEST_FOOTPRINT": regimes._NEAREST,
    "MOST_POINTS": point_sampled.MOST_POINTS,
    "POINTS_PER_THREAD": point_sampled._POINTS_PER_THREAD,
    "FINEST_FOOTPRINT": math.log2(point_sampled._FINEST),
    "COARSEST_FOOTPRINT": math.log2(point_sampled._COARSEST),
    "COARSE_STEPS": point_sampled._COARSE.steps_per_thread,
    "COARSE_SHADOW_SHARE": point_sampled._COARSE.shadow_share,
    "COARSE_REFINEMENTS": point_sampled._COARSE.refinements,
    "ALBEDO_NOISE_UNITS": footprint_albedos._NOISE_UNITS,
    "ALBEDO_NOISE_FRACTION": footprint_albedos._NOISE_FRACTION,
    "HIDDEN_WEIGHT": footprint_albedos._HIDDEN,
    "MAX_RATIO_OF_ONE_TAP": core_footprint._MAX_RATIO_OF_ONE_TAP,
    "ONE_MINUS_EPSILON": 1 - 2.0**-24,
    "TURNED_SHARE": fibre._SHARE_TURNED[0],
    "TURNED_SHARE_SLOPE": fibre._SHARE_TURNED[1],
    "THROUGH_SHARE": fibre._SHARE_THROUGH[0],
    "THROUGH_SHARE_SLOPE": fibre._SHARE_THROUGH[1],
    "TYPICAL_DEPTH": fibre._TYPICAL_DEPTH,
    "LAYER_REFLECTS": lobe_proposal._LAYER_REFLECTS,
    "LAYER_TRANSMITS": lobe_proposal._LAYER_TRANSMITS,
    "COSINE_PROBABILITY": lobe_proposal._COSINE_PROBABILITY,
    "PROPOSAL_MIN_WEIGHT": lobe_proposal._MIN_WEIGHT,
    "SPREAD_WIDTH": lobe_proposal.SPREAD_WIDTH,
    "BAKE_STEPS_PER_THREAD": visibility_rays._QUALITY.steps_per_thread,
    "BAKE_STEPS_PER_RELIEF": visibility_rays._QUALITY.steps_per_relief,
    "BAKE_SHADOW_SHARE": visibility_rays._QUALITY.shadow_share,
    "NORMAL_WEIGHT": groups.NORMAL_WEIGHT,
    "MIN_VIEW_HITS": groups._MIN_VIEW_HITS,
    "SMOOTHING_RAYS": visibility_tables._NEIGHBOURS,
    "LEAST_DIFFUSE": visibility_tables._LEAST_DIFFUSE,
}
_VECTORS: dict[str, tuple[float, float]] = {
    "DIFFUSE_CORRELATION": prefiltered.DIFFUSE_CORRELATION,
    "TRANSMISSION_CORRELATION": prefiltered.TRANSMISSION_CORRELATION,
}
_VECTOR_ARRAYS: dict[str, Sequence[tuple[float, float]]] = {
    "TAP_OFFSETS": coverage_lookup.TAP_OFFSETS,
    "POINT_OFFSETS": point_sampled.POINT_OFFSETS,
}
_UINTS: dict[str, int] = {
    "BUNDLE_STREAM": detail.BUNDLE_STREAM,
    "WAVE_STREAM": detail.WAVE_STREAM,
    "TILT_STREAM": detail.TILT_STREAM,
    "SLUB_STREAM": detail.SLUB_STREAM,
    "HAIR_STREAM": detail.HAIR_STREAM,
    "HAIR_LAYERS": detail.HAIR_LAYERS,
    "MOST_SAMPLES": search.DEFAULT_QUALITY.steps,
    "REFINEMENTS": search.DEFAULT_QUALITY.refinements,
    "NEWTON_STEPS": rays._NEWTON_STEPS,
    "TILE_CELLS": max_heights.TILE_CELLS,
    "FIBRE_STREAM": variation._FIBRE_STREAM,
    "THREAD_STREAM": variation._THREAD_STREAM,
    "AZIMUTHS": hemisphere.AZIMUTHS,
    "RINGS": hemisphere.RINGS,
    "NODES": hemisphere.NODES,
    "ANISOTROPIC_TAPS": core_footprint.ANISOTROPIC_TAPS,
    "TAPS": len(coverage_lookup.TAP_OFFSETS),
    "WEIGHT_SUM": packed_uint8.WEIGHT_SUM,
    "MOMENTS": lobe_tables.MOMENTS,
    "BAKE_REFINEMENTS": visibility_rays._QUALITY.refinements,
    "VIEW_STEP": visibility_rays._VIEW_STEP,
    "MAX_GAP_RAYS": visibility_rays._MAX_GAP_RAYS,
    "SAMPLED_VIEWS": visibility_rays._SAMPLED_VIEWS,
    "TOP_DOWN_SAMPLES": cloth_samples.TOP_DOWN_SAMPLES,
    **{f"RECURRENCE_{i}": factor for i, factor in enumerate(cloth_samples._RECURRENCE, 1)},
    # A list of samples holds those of all views, or all top-down samples.
    "MOST_SAMPLES_OF_FACE": max(
        cloth_samples.TOP_DOWN_SAMPLES, hemisphere.NODES * visibility_rays._SAMPLED_VIEWS
    ),
    "CLUSTERED_SAMPLES": groups._CLUSTERED_SAMPLES,
    "MIN_VIEW_SAMPLES": groups._MIN_VIEW_SAMPLES,
    "GOLDEN_FRACTION": groups._GOLDEN,
    "AXIS_SQUARINGS": clustering._SQUARINGS,
    "BOUNDARY_STEPS": clustering._BOUNDARY_STEPS,
    "REFINING_STEPS": clustering._REFINING_STEPS,
    "VIEW_SUMS": accumulation.VIEW_SUMS,
    "LIGHT_SUMS": accumulation.LIGHT_SUMS,
    "TEXEL_JITTER_X": coverage_pyramid._ACROSS,
    "TEXEL_JITTER_Y": coverage_pyramid._ALONG,
    # Words of the bake's facts: of each family the views that hit it and the points that are clustered; gaps,
    # and rays through gaps; of each family the clusters that its points make; of each face the warp's groups.
    "FACT_SEEN": 0,
    "FACT_POINTS": 4,
    "FACT_GAPS": 8,
    "FACT_GAP_RAYS": 9,
    "FACT_DISTINCT": 10,
    "FACT_WARP_COUNT": 14,
}
_FLOAT_ARRAYS: dict[str, Sequence[float]] = {
    "PYRAMID_RADII": max_heights.PYRAMID_RADII,
    "RING_COSINES": [float(z) for z in hemisphere.node_directions()[: hemisphere.RINGS, 2]],
}
_POLYNOMIALS: dict[str, Sequence[Sequence[float]]] = {
    "sheen_scale": sheen_coefficients.SCALE,
    "sheen_shear": sheen_coefficients.SHEAR,
    "sheen_reflectance": sheen_coefficients.REFLECTANCE,
    # atan(x)/x in powers of x².
    "arc_tangent_quotient": [[coefficient] for coefficient in density._ARC_TANGENT],
}


def number_text(value: float) -> str:
    """A literal that any shading language reads as the float32 nearest to `value`."""
    text = f"{np.float32(value):.9g}"
    return text if any(mark in text for mark in ".en") else f"{text}.0"


def slang_constants() -> str:
    """Slang declarations of all constants, and the polynomials of the sheen."""
    floats = (
        _FLOATS | neural_floats() | neumip_floats() | latent_floats() | clustered_floats() | openness_floats()
    )
    uints = _UINTS | neural_uints() | neumip_uints() | latent_uints() | clustered_uints() | openness_uints()
    lines = [f"static const float {name} = {number_text(value)};" for name, value in floats.items()]
    lines += [f"static const uint {name} = {value}u;" for name, value in uints.items()]
    for name, numbers in _FLOAT_ARRAYS.items():
        texts = ", ".join(number_text(number) for number in numbers)
        lines.append(f"static const float {name}[{len(numbers)}] = {{ {texts} }};")
    for name, vector in _VECTORS.items():
        lines.append(f"static const float2 {name} = {_vector(vector)};")
    for name, vectors in _VECTOR_ARRAYS.items():
        items = ", ".join(_vector(vector) for vector in vectors)
        lines.append(f"static const float2 {name}[{len(vectors)}] = {{ {items} }};")
    for name, rows in _POLYNOMIALS.items():
        lines += ["", f"float {name}(float x, float y)", "{", "    var value = 0.0;"]
        for row in reversed(rows):
            lines.append(f"    value = value * x + ({_horner(row)});")
        lines += ["    return value;", "}"]
    return "\n".join(lines) + "\n"


def _vector(numbers: tuple[float, float]) -> str:
    return f"float2({number_text(numbers[0])}, {number_text(numbers[1])})"


def _horner(row: Sequence[float]) -> str:
    text = number_text(row[-1])
    for coefficient in reversed(row[:-1]):
        text = f"({text}) * y + {number_text(coefficient)}"
    return text
