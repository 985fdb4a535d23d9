"""What shaders are compared with Python at: a model in variants that take every branch of its shader.

Searches along rays, cells and texels have edges: rounding decides which side a query takes. How many may, a
case says; beside them the bar of `parity.py` holds.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from drjit.llvm.ad import UInt
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.core.footprint import Footprint
from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import REALTIME_MODELS, make_model, model_of_loom
from loomlight.realtime.words import Packed, pack_fabrics
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.fabrics import EVERYTHING
from tests.helpers.untrained import (
    IRREGULAR_TWILL,
    OPEN_TWILL,
    random_latent,
    random_neumip,
    small_clustered,
    with_samples,
)

EXAMPLES = Path(__file__).parents[2] / "examples"
Rows = dict[str, NDArray[Any]]

# Open cloth of slub yarns with neps, whose shades vary.
SLUBBY = (
    'weave = "twill 2/1"\nends_per_cm = 20\npicks_per_cm = 16\nyarn = "linen"\n[warp]\ngap = 0.2\n'
    '[weft]\ngap = 0.3\nshade = 0.1\nmelange = 0.2\nneps = 9\nnep_color = "#301008"\n'
    "[variation]\ncolour_noise = 0.3\n"
)
# Holes, sheen, coloured threads, twist, highlights that rise, and a repeat that is no power of two.
OPEN = (
    'weave = "twill 2/1"\nends_per_cm = 30\npicks_per_cm = 20\n[warp]\ngap = 0.3\ntwist_deg = 20\n'
    "specular_grazing = 3\n[weft]\ngap = 0.2\n[sheen]\nstrength = 0.4\nroughness = 0.3\n"
)


def _fabric_of(name: str) -> Fabric:
    """An example, "even" without irregular yarns."""
    fabric = load_fabric(EXAMPLES / f"{name.removeprefix('even ')}.toml")
    return edited_fabric(fabric, {"variation.irregularity": 0}) if name.startswith("even") else fabric


def layered_fabric(name: str) -> Fabric:
    """An example of layered cloth, with light between its yarns and under sheen."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)  # that it has layers
        fabric = load_fabric(EXAMPLES / "layered" / f"{name}.wif")
    return edited_fabric(fabric, {"interreflection": True, "sheen.strength": 0.3, "warp.gap": 0.3})


@dataclass(frozen=True)
class ShaderCase:
    """A variant of a model.

    Attributes:
        model: name of the model.
        make: the variant.
        flips: share of numbers that may miss the bar.
        further: rows beside those of `footprint_rows` that the shader or the model takes.
    """

    model: str
    make: Callable[[], Model]
    flips: float = 0.0
    further: Callable[[np.random.Generator, int], Rows] = field(default=lambda rng, count: {})


def _of(name: str, fabric: Callable[[], Fabric], **options: Any) -> Callable[[], Model]:
    return lambda: make_model(name, fabric(), **options)


def _of_earlier_file() -> Model:
    """A material baked when 8 groups of a family were the default."""
    return model_of_loom(make_model("lobes", fabric_from_text(OPEN), groups=8).to_loom())


def _seeds(samples: int) -> Callable[[np.random.Generator, int], Rows]:
    """Of the residual of `clustered`, and how many texels of it."""

    def rows(rng: np.random.Generator, count: int) -> Rows:
        seeds = rng.integers(1, 2**32, count, dtype=np.uint32)
        return {"seed": seeds, "number": np.full(count, samples, np.uint32)}

    return rows


def _clustered(rank: int, samples: int, fabric: Fabric) -> ShaderCase:
    # Of two texels and a box: each may fall on another side of an edge.
    flips = 4e-3 if samples else 1e-3
    return ShaderCase(
        "clustered", lambda: with_samples(small_clustered(rank, fabric), samples), flips, _seeds(samples)
    )


# Beside the flips of searches, points change their family where a hair covers half of them.
_SEARCHES = 3e-3
_LIT_TWICE = 3e-3
# Rounding of a position may move it across one of 4096 steps of a hash, which chooses the level.
_HASHED = 1e-3
# Kernels with layers take minutes to compile cold; `tests/realtime/test_shaders.py` has more drafts.
_LAYERED = "pattern-double-weave"
CASES: dict[str, ShaderCase] = {
    **{
        f"lobes, {name}": ShaderCase("lobes", _of("lobes", partial(_fabric_of, name)), _SEARCHES)
        for name in ("denim", "even denim", "damask", "silk-satin")
    },
    **{
        f"{model}, {_LAYERED}": ShaderCase(model, _of(model, partial(layered_fabric, _LAYERED)), _SEARCHES)
        for model in ("lobes", "point")
    },
    # Of threads of two colours more shows.
    "lobes, wool-houndstooth": ShaderCase(
        "lobes", _of("lobes", lambda: _fabric_of("wool-houndstooth")), 5e-3
    ),
    "lobes, earlier file": ShaderCase("lobes", _of_earlier_file, _SEARCHES),
    "lobes, slubby": ShaderCase("lobes", _of("lobes", lambda: fabric_from_text(SLUBBY)), _SEARCHES),
    "lobes, everything": ShaderCase("lobes", _of("lobes", lambda: fabric_from_text(EVERYTHING)), _LIT_TWICE),
    "point, slubby": ShaderCase("point", _of("point", lambda: fabric_from_text(SLUBBY)), _SEARCHES),
    "point, everything": ShaderCase("point", _of("point", lambda: fabric_from_text(EVERYTHING)), _LIT_TWICE),
    "clustered, base": _clustered(0, 0, OPEN_TWILL),
    "clustered, rank 1": _clustered(1, 0, OPEN_TWILL),
    "clustered, rank 3": _clustered(3, 0, OPEN_TWILL),
    "clustered, residual": _clustered(1, 2, OPEN_TWILL),
    "clustered, irregular": _clustered(1, 0, IRREGULAR_TWILL),
    "clustered, irregular residual": _clustered(1, 2, IRREGULAR_TWILL),
    # Of no query rays are searched for: none may miss the bar.
    "neural, denim": ShaderCase("neural", _of("neural", lambda: _fabric_of("denim"))),
    "neural, open": ShaderCase("neural", _of("neural", lambda: fabric_from_text(OPEN), refined=False)),
    "neumip, two faces": ShaderCase("neumip", random_neumip),
    "neumip, one face": ShaderCase("neumip", lambda: random_neumip(faces=1, offset=False)),
    "latent, 2x16": ShaderCase("latent", lambda: random_latent("2x16")),
    "latent, stochastic": ShaderCase("latent", lambda: random_latent(mips="stochastic"), _HASHED),
    "latent, 3x64": ShaderCase("latent", lambda: random_latent("3x64")),
    "latent, no frames": ShaderCase("latent", lambda: random_latent(frames=False, is_apart=True)),
    "latent, no features": ShaderCase("latent", lambda: random_latent(features=False)),
    "latent, stochastic of neither": ShaderCase(
        "latent",
        lambda: random_latent("2x32", "stochastic", frames=False, features=False, is_apart=True),
        _HASHED,
    ),
}


@cache
def model_of(case: str) -> Model:
    """The model of a case, made once."""
    return CASES[case].make()


def packed(model: Model, half: bool = False) -> Packed:
    """What shaders read of a model; texels in single precision, so that nothing is rounded."""
    looks = None
    if isinstance(model.source, Fabric) and REALTIME_MODELS[model.name].reads_yarns:
        looks = model.source.layout(), model.source.appearance()
    return pack_fabrics([looks], None, [model.shader_tables(half)])


def footprint_rows(count: int, extent: float, seed: int = 5) -> Rows:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere.

    Args:
        extent: largest coordinate of their centres, millimetres.
    """
    rng = np.random.default_rng(seed)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), count))
    angle, ratio = rng.uniform(0, 2 * np.pi, count), rng.uniform(0.1, 1, count)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    return {
        "centre": np.float32(rng.uniform(-extent, extent, (count, 2))),
        "dx": np.float32(np.stack([cosine, sine], axis=1)),
        "dy": np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1)),
        "light": clear_of_the_plane(rng, count),
        "view": clear_of_the_plane(rng, count),
    }


def case_rows(case: str, count: int) -> Rows:
    """Of a case, with what it takes further; centres up to three repeats of plain cloth away."""
    return footprint_rows(count, 5) | CASES[case].further(np.random.default_rng(6), count)


def footprint_of(rows: Rows) -> Footprint:
    """The footprints on a device."""
    return Footprint(*(pairs(rows[name]) for name in ("centre", "dx", "dy")))


def bsdf_of(model: Model, rows: Rows) -> Any:
    """What Python answers of the rows."""
    seeds = {"seed": UInt(rows["seed"])} if "seed" in rows else {}
    return model.at(vectors(rows["view"]), model.on_cloth(footprint_of(rows)), **seeds)
