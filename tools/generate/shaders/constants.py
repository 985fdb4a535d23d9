"""Constants of the Python modules for Slang: each is written once, where its formula stands.

Public numbers of the modules below are constants of the shaders by the same names, with the module's prefix:
a new one needs no line here. A `SearchQuality` is a constant a field.
"""

from __future__ import annotations

import ast
import inspect
import math
from collections.abc import Iterator, Sequence
from types import ModuleType
from typing import TypeAlias, TypeGuard

import numpy as np

from loomlight.aggregate import footprint_albedos, layer_shares, layered_albedos
from loomlight.core import footprint as core_footprint
from loomlight.models import between_yarns, random_numbers
from loomlight.models.clustered import bsdf as cluster_bsdf
from loomlight.models.clustered import gaussians as cluster_gaussians
from loomlight.models.clustered import parallax as cluster_parallax
from loomlight.models.clustered import square_map
from loomlight.models.clustered import tables as cluster_tables
from loomlight.models.lobes import bsdf as lobe_bsdf
from loomlight.models.lobes import coverage, groups, hemisphere, point_sampled, prefiltered, visibility
from loomlight.models.lobes import rays as lobe_rays
from loomlight.models.lobes import tables as lobe_tables
from loomlight.models.neural import architecture, codings, encoded_fabric
from loomlight.models.neural import proposal as neural_proposal
from loomlight.models.texture import latent, neumip
from loomlight.models.texture import model as textured_model
from loomlight.realtime import bake, scene, words
from loomlight.scattering import (
    detail,
    directions,
    fibre,
    grazing,
    hairs,
    irregularity,
    lobe_mixture,
    openness,
    sheen,
    sheen_coefficients,
    variation,
)
from loomlight.yarn import flanks, max_heights, rays, threads
from tools.generate.shaders.neural_constants import neural_constants

Value: TypeAlias = float | str | Sequence["Value"]

# Modules by the prefix of their constants.
MODULES: dict[str, tuple[ModuleType, ...]] = {
    "": (
        bake,
        between_yarns,
        core_footprint,
        coverage,
        detail,
        directions,
        fibre,
        flanks,
        max_heights,
        groups,
        hairs,
        hemisphere,
        lobe_bsdf,
        lobe_rays,
        lobe_tables,
        point_sampled,
        prefiltered,
        random_numbers,
        rays,
        scene,
        threads,
        variation,
        visibility,
        words,
    ),
    "ALBEDO_": (footprint_albedos,),
    "GRAZING_": (grazing,),
    "CLUSTERED_": (cluster_bsdf, cluster_gaussians, cluster_parallax, cluster_tables, square_map),
    "IRREGULAR_": (irregularity,),
    "LATENT_": (latent,),
    "LAYERS_": (layer_shares, layered_albedos),
    "MIXTURE_": (lobe_mixture,),
    "NEUMIP_": (neumip,),
    "NEURAL_": (architecture, codings, encoded_fabric, neural_proposal),
    "OPENNESS_": (openness,),
    "SHEEN_": (sheen,),
}
# What shaders compute with in the place of these numbers, and numbers of both sides' arrays.
_DERIVED: dict[str, Value] = {
    "INVERSE_SECTION_SINE": 1 / math.sin(threads.SECTION_ANGLE),
    "INVERSE_CELL_MAX_LEVELS": 1 / threads.CELL_MAX_LEVELS,
    "BLEND_FROM": math.log2(point_sampled.BLEND_RANGE[0]),
    "BLEND_TO": math.log2(point_sampled.BLEND_RANGE[1]),
    "LOG_FINEST_FOOTPRINT": math.log2(point_sampled.FINEST_FOOTPRINT),
    "LOG_COARSEST_FOOTPRINT": math.log2(point_sampled.COARSEST_FOOTPRINT),
    "ONE_MINUS_EPSILON": 1 - 2.0**-24,
    "SHEEN_CEILING": sheen_coefficients.CEILING,
    "TAPS": len(coverage.TAP_OFFSETS),
    **{f"RECURRENCE_{i}": factor for i, factor in enumerate(lobe_rays.RECURRENCE, 1)},
    **{f"LATTICE_SHIFT_{axis}": shift for axis, shift in zip("XY", lobe_rays.LATTICE_SHIFT, strict=True)},
    # A list of samples holds those of all views, or all top-down samples.
    "MAX_SAMPLES_OF_FACE": max(lobe_rays.TOP_DOWN_SAMPLES, hemisphere.NODES * lobe_rays.SAMPLED_VIEWS),
    # Words of the bake's facts: of each family the views that hit it and the points that are clustered; gaps,
    # and rays through gaps; of each family the clusters that its points make; of each face the warp's groups.
    "FACT_SEEN": 0,
    "FACT_POINTS": 4,
    "FACT_GAPS": 8,
    "FACT_GAP_RAYS": 9,
    "FACT_DISTINCT": 10,
    "FACT_WARP_COUNT": 14,
    "LATENT_MIN_SIZE": textured_model.MIN_SIZE,
    "LATENT_SAMPLER_HIDDEN": latent.SAMPLER_WIDTHS[1],
    "LATENT_SAMPLER_OUTPUTS": latent.SAMPLER_WIDTHS[-1],
    "LATENT_ALBEDO_HIDDEN": latent.ALBEDO_WIDTHS[1],
    "LATENT_AUXILIARY_HIDDEN": latent.AUXILIARY_WIDTHS[1],
    "NEUMIP_HOLE_HIDDEN": neumip.OPACITY_WIDTHS[1],
    "NEUMIP_MIN_SIZE": textured_model.MIN_SIZE,
    "NEUMIP_SCALE": 1 / neumip.EXPOSURE,
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
    "arc_tangent_quotient": [[coefficient] for coefficient in prefiltered.GROUP_ARC_TANGENT],
}


def prefixed_numbers(module: ModuleType) -> Iterator[tuple[str, Value]]:
    """Names and values of the numbers, and tuples of them, that a module assigns to public names.

    Names that it imports are another module's.
    """
    prefix = next((prefix for prefix, modules in MODULES.items() if module in modules), "")
    for node in ast.parse(inspect.getsource(module)).body:
        targets = node.targets if isinstance(node, ast.Assign) else []
        for part in (part for target in targets for part in ast.walk(target)):
            if isinstance(part, ast.Name) and part.id.isupper() and not part.id.startswith("_"):
                for name, value in _numbers_in(part.id, getattr(module, part.id)):
                    yield prefix + name, value


def _numbers_in(name: str, value: object) -> Iterator[tuple[str, Value]]:
    if isinstance(value, rays.SearchQuality):
        kind = name.removesuffix("QUALITY")
        for field in ("steps_per_thread", "steps_per_relief", "shadow_share"):
            yield kind + field.upper(), float(getattr(value, field))
        for field in ("refinements", "steps"):
            yield kind + field.upper(), int(getattr(value, field))
    elif _is_numbers(value):
        yield name, value


def _is_numbers(value: object) -> TypeGuard[Value]:
    if isinstance(value, tuple):
        return all(map(_is_numbers, value))
    return isinstance(value, int | float)


def shader_constants() -> dict[str, Value]:
    """All constants but arrays of numbers, by their names in Slang.

    Raises:
        ValueError: two modules have a constant of one name.
    """
    constants: dict[str, Value] = {}
    for module in (module for modules in MODULES.values() for module in modules):
        for name, value in prefixed_numbers(module):
            if name in constants:
                raise ValueError(f"{module.__name__} has the second constant {name}")
            if isinstance(value, int | float) or _is_pair(value) or all(map(_is_pair, value)):
                constants[name] = value
    return constants | _DERIVED | neural_constants() | first_words()


def first_words() -> dict[str, int]:
    """Where each table of a cloth's openness begins in its block."""
    counts = openness.Openness.word_counts({})
    sizes = [*counts.values()]
    return {f"OPENNESS_{name.upper()}": sum(sizes[:number]) for number, name in enumerate(counts)}


def _is_pair(value: Value) -> bool:
    return isinstance(value, Sequence) and len(value) == 2 and all(isinstance(part, float) for part in value)


def number_text(value: float) -> str:
    """A literal that any shading language reads as the float32 nearest to `value`."""
    text = f"{np.float32(value):.9g}"
    return text if any(mark in text for mark in ".en") else f"{text}.0"


def slang_constants() -> str:
    """Slang declarations of all constants, and the polynomials of the sheen."""
    lines = [_declaration(name, value) for name, value in shader_constants().items()]
    for name, numbers in _FLOAT_ARRAYS.items():
        texts = ", ".join(number_text(number) for number in numbers)
        lines.append(f"static const float {name}[{len(numbers)}] = {{ {texts} }};")
    for name, rows in _POLYNOMIALS.items():
        lines += ["", f"float {name}(float x, float y)", "{", "    var value = 0.0;"]
        for row in reversed(rows):
            lines.append(f"    value = value * x + ({_horner(row)});")
        lines += ["    return value;", "}"]
    return "\n".join(lines) + "\n"


def _declaration(name: str, value: Value) -> str:
    if isinstance(value, int):
        return f"static const uint {name} = {value}u;"
    if isinstance(value, float):
        return f"static const float {name} = {number_text(value)};"
    if _is_pair(value):
        return f"static const float2 {name} = {_vector(value)};"
    return f"static const float2 {name}[{len(value)}] = {{ {', '.join(map(_vector, value))} }};"


def _vector(pair: Value) -> str:
    assert isinstance(pair, tuple)  # of two numbers
    return f"float2({', '.join(map(number_text, pair))})"


def _horner(row: Sequence[float]) -> str:
    text = number_text(row[-1])
    for coefficient in reversed(row[:-1]):
        text = f"({text}) * y + {number_text(coefficient)}"
    return text
