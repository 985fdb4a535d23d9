"""What records stand on, in a few numbers: outputs of models, pictures and meshes for a few inputs.

A record keeps the outputs of the probes that its study names. If probes give other numbers later, the record
is older than what it stands on; a comment or a faster loop ages nothing. Numbers are compared rather than
hashes of them, as processors round differently.

    python -m studies.harness.probes lobes picture      prints their outputs as JSON
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

REPOSITORY = Path(__file__).resolve().parents[2]
Numbers = NDArray[np.float64]
# Groups of queries, whose means are the numbers of a model, and queries of a group.
_GROUPS, _QUERIES = 12, 32
# Processors that fuse multiply-adds differently are within a ten thousandth.
_TOLERANCE = 1e-3
# Of counted operations: a few that are added are not felt.
_COST_TOLERANCE = 0.03
# Of the fabrics the first alone: some models bake for long.
_DENSE = slice(1)
_FABRIC = """
weave = "twill 2/2"
ends_per_cm = 24
picks_per_cm = 20
[warp]
color = "#2f4a7c"
yarn = "{yarn}"
[weft]
color = ["#d8cfc0", "#8a2f2f"]
roughness = 0.25
gap = {gap}
"""


@dataclass(frozen=True)
class Probe:
    """What a study may stand on.

    Attributes:
        says: what its numbers are.
        outputs: computes them.
        tolerance: relative differences above it are changes.
    """

    says: str
    outputs: Callable[[], Numbers]
    tolerance: float = _TOLERANCE


# --------------------------------------------------------------------------------------------------- models


def _fabrics() -> list[Any]:
    from loomlight.fabric import fabric_from_text

    # One dense of filament, one open and irregular.
    return [
        fabric_from_text(_FABRIC.format(yarn=yarn, gap=gap))
        for yarn, gap in (("cotton", 0.0), ("linen", 0.4))
    ]


def _asked(types: Any) -> tuple[Any, Any, Any]:
    """Lights above and below, views, and footprints from a twentieth of a thread to a hundred threads."""
    from loomlight.core.footprint import Footprint

    count = _GROUPS * _QUERIES
    rng = np.random.default_rng(62)

    def vectors(sides: Numbers) -> Any:
        z = np.sqrt(rng.uniform(0.04, 1, count))
        turn, across = rng.uniform(0, 2 * np.pi, count), np.sqrt(1 - z * z)
        rows = (across * np.cos(turn), across * np.sin(turn), sides * z)
        return types.Vector3(*(row.astype(np.float32) for row in rows))

    light = vectors(np.where(np.arange(count) % 4 == 3, -1.0, 1.0))
    view = vectors(np.ones(count))
    centre = types.Vector2(*(part.astype(np.float32) for part in rng.uniform(0, 60, (2, count))))
    # Groups differ by size.
    side = types.Float(
        np.repeat(0.02 * 2000 ** (np.arange(_GROUPS) / (_GROUPS - 1)), _QUERIES).astype(np.float32)
    )
    zero = types.Float(np.zeros(count, np.float32))
    return light, view, Footprint(centre, types.Vector2(side, zero), types.Vector2(zero, side))


def _answers(models: Iterable[Any]) -> Numbers:
    from loomlight.core.backend import array_types
    from loomlight.core.llvm import llvm_float

    types = array_types(llvm_float())
    light, view, footprint = _asked(types)
    found = []
    for model in models:
        model.upload(types)
        values = np.array(model.at(view, model.on_cloth(footprint)).value(light), np.float64)
        found.append(values.mean(axis=0).reshape(_GROUPS, _QUERIES).mean(axis=1))
    return np.concatenate(found)


def _of_model(name: str, fabrics: slice = slice(None), **options: Any) -> Numbers:
    from loomlight.models.registry import make_model

    return _answers(make_model(name, fabric, **options) for fabric in _fabrics()[fabrics])


def _of_random_network(name: str) -> Numbers:
    from studies.instruments.random_networks import random_latent, random_neumip

    fabric = _fabrics()[1]
    return _answers([random_neumip(fabric) if name == "neumip" else random_latent(fabric, "2x32")])


def _cost(name: str, fabrics: slice = slice(None), **options: Any) -> Numbers:
    """Floating-point operations of the kernels that answer queries."""
    import drjit as dr

    from loomlight.core.backend import array_types
    from loomlight.core.llvm import llvm_float
    from loomlight.models.registry import make_model
    from studies.instruments.machine import operations_of
    from studies.instruments.timing import launched_kernels

    types = array_types(llvm_float())
    light, view, footprint = _asked(types)

    def answer(model: Any) -> None:
        dr.eval(model.at(view, model.on_cloth(footprint)).value(light))

    found = []
    for fabric in _fabrics()[fabrics]:
        model = make_model(name, fabric, **options)
        model.upload(types)
        kernels = launched_kernels(partial(answer, model))
        found.append(sum(operations_of(kernel["ir"].read()) for kernel in kernels))
    return np.array(found, np.float64)


# ------------------------------------------------------------------------------------------ pictures and rest


def _picture() -> Numbers:
    """Mean luminance of eighths of a small picture of the drape."""
    from loomlight.mitsuba.pictures import render

    picture = np.asarray(render(_fabrics()[0], size=(64, 48), spp=16, inset=False), np.float64)
    return (
        np.concatenate([part.mean(axis=(1, 2)) for part in np.array_split(picture[..., :3], 8)])
        .reshape(-1, 6)
        .mean(axis=1)
    )


def _mesh() -> Numbers:
    """Sizes and strains of a dress without uv, cut and laid flat."""
    from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cleaned
    from loomlight.mesh.unwrap import cut_pieces

    rows, columns = np.meshgrid(np.arange(24), np.arange(32), indexing="ij")
    turn, height = 2 * np.pi * columns / 32, rows / 23
    radius = 0.16 + 0.2 * (height - 0.6) ** 2
    positions = np.stack([1.3 * radius * np.cos(turn), height, radius * np.sin(turn)], axis=-1).reshape(-1, 3)
    first = (rows[:-1] * 32 + columns[:-1]).ravel()
    beside = (rows[:-1] * 32 + (columns[:-1] + 1) % 32).ravel()
    triangles = np.concatenate(
        [np.stack([first, first + 32, beside], axis=1), np.stack([beside, first + 32, beside + 32], axis=1)]
    )
    dress = cleaned(ClothMesh(positions, np.zeros((0, 3)), np.zeros((0, 2)), triangles, "dress"))
    found = cut_pieces([MeshPart("", "", dress)])
    return np.array([*np.ptp(found.uv, axis=0), found.count, found.stretch, found.worst, 1 + found.angle])


def _shaders() -> Numbers:
    """Hashes of what slangc made for adapters."""
    folder = REPOSITORY / "src/loomlight/realtime/shaders/wgsl"
    return np.array([_hash(file.read_bytes()) for file in sorted(folder.glob("*.wgsl"))])


def _network() -> Numbers:
    """The hash of the network of `neural`."""
    from loomlight.models.neural.weights import shipped_weights

    return np.array([_hash(shipped_weights().sha256.encode())])


def _truth() -> Numbers:
    """What the network of `neural` learns from, as yarns are today."""
    from loomlight.core.llvm import llvm_float
    from loomlight.models.neural.learned_truth import truth_numbers

    return np.array(truth_numbers(llvm_float()), np.float64)


def _hash(content: bytes) -> float:
    """Below 65 536: records keep five digits of a number."""
    return float(int(hashlib.sha256(content).hexdigest()[:4], 16))


PROBES: dict[str, Probe] = {
    **{name: Probe(f"values of `{name}`", partial(_of_model, name)) for name in ("point", "lobes", "neural")},
    "clustered": Probe("values of `clustered`", partial(_of_model, "clustered", _DENSE, texels=64)),
    "samples": Probe("values of `samples` with 16 points", partial(_of_model, "samples", points=16)),
    **{
        name: Probe(f"values of `{name}` with random networks", partial(_of_random_network, name))
        for name in ("neumip", "latent")
    },
    **{
        f"{name} cost": Probe(f"operations of a query of `{name}`", partial(_cost, name), _COST_TOLERANCE)
        for name in ("point", "lobes")
    },
    "clustered cost": Probe(
        "operations of a query of `clustered`",
        partial(_cost, "clustered", _DENSE, texels=64),
        _COST_TOLERANCE,
    ),
    "picture": Probe("a picture of the drape", _picture),
    "mesh": Probe("a garment laid flat", _mesh),
    "shaders": Probe("shaders as slangc makes them", _shaders, 0),
    "truth": Probe("means over footprints that networks are trained on", _truth),
    "network": Probe("the network of `neural`", _network, 0),
}


def probed(names: Iterable[str]) -> dict[str, list[float]]:
    """Outputs of probes by name; a process of its own computes them, as a study's may have to load little."""
    asked = sorted(set(names))
    if not asked:
        return {}
    command = [sys.executable, "-m", __name__, *asked]
    answer = subprocess.run(command, cwd=REPOSITORY, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise RuntimeError(f"probes failed:\n{answer.stderr[-2000:]}")
    return dict(json.loads(answer.stdout))


def moved(name: str, before: list[float], now: list[float]) -> float | None:
    """By how much outputs of a probe have changed at most, relatively; None if they have not.

    Infinity is a change without a measure: of hashes, or of the probe itself.
    """
    if name not in PROBES or len(before) != len(now):
        return float("inf")
    one, other = np.array(before, np.float64), np.array(now, np.float64)
    # What is small beside the rest is noise of rounding.
    whole = np.maximum(np.maximum(np.abs(one), np.abs(other)), 1e-2 * max(np.abs(other).max(), 1e-30))
    most = float((np.abs(one - other) / whole).max())
    if most <= PROBES[name].tolerance:
        return None
    return most if PROBES[name].tolerance else float("inf")


def main(names: list[str]) -> None:
    """Prints the outputs of probes as JSON, of four digits; hashes have all of theirs."""
    found: Mapping[str, list[float]] = {
        name: [
            float(f"{number:.8g}" if number > 1e5 else f"{number:.5g}") for number in PROBES[name].outputs()
        ]
        for name in names
    }
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1:])
