"""Reflectance of a material for training: Mitsuba's BSDF in batches, its textures as inputs of an encoder.

The BSDF is evaluated on made surface interactions of a plane, whose uv is the position: dp/du and dp/dv are
unit vectors along x and y, so that heights of a bump map are in units of uv. Textures are evaluated by
Mitsuba itself, each at the centres of texels, with its own transform.

A normal map and a bump map become slopes. Filtered slopes lose the roughness that their spread makes, so that
the inputs hold their first and second moments, which filter linearly (LEAN mapping, Olano & Baker 2010).
"""

from __future__ import annotations

import math
import tempfile
import warnings
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mitsuba.variants import choose_variant, reason_of
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA
from loomlight.models.texture.queries import FOUR_POINTS, EncodedBtf, Texels
from loomlight.sources.material import Material

_Floats = NDArray[np.float32]
# Evaluations in one launch.
_BATCH = 1 << 20
# Slopes are 1 at 45°; inputs of steeper ones are clipped here.
_STEEPEST = 2.0
# Texels of a finer texture that are averaged along a side of a texel.
_MAX_TAPS = 8


@dataclass(frozen=True, eq=False)
class _Input:
    """A texture of the BSDF, as inputs of the encoder."""

    name: str
    values: _Floats  # [height, width, channels]
    channels: tuple[str, ...]


def material_bsdf_of(source: Material) -> Any:
    """The Mitsuba BSDF of a material; a variant must be set.

    Raises:
        InputError: Mitsuba refuses it, or all of its light is in delta lobes.
    """
    with tempfile.TemporaryDirectory() as folder:
        root = source.write_files(folder)
        bsdf = _loaded(root, source.name)
    flags: Any = mi.BSDFFlags
    if not mi.has_flag(bsdf.flags(), flags.Smooth):
        raise InputError(
            f"{source.name} has delta lobes only (perfect mirror or glass), of which there is nothing to "
            "learn: give it a roughness above 0."
        )
    return bsdf


class MaterialBtf(EncodedBtf):
    """f·cos of a material; points are in repeats of uv.

    Attributes:
        faces: 2 where the BSDF reflects light on its back too.
    """

    def __init__(self, source: Material) -> None:
        """
        Raises:
            InputError: as `material_bsdf_of`.
        """
        choose_variant(None)
        self._source, self._bsdf = source, material_bsdf_of(source)
        _warn_of_losses(source, self._bsdf)
        # Flags of the back stand for refraction too, which is left out.
        self.faces = 2 if ElementTree.fromstring(source.xml).get("type") == "twosided" else 1
        self._context: Any = mi.BSDFContext()

    @property
    def extent(self) -> tuple[float, float]:
        """1: points are in repeats."""
        return 1.0, 1.0

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos [n, 3] at points of uv [n, 2]; exact, so the seed is not used."""
        del seed
        found = np.empty((len(points), 3), np.float32)
        for first in range(0, len(points), _BATCH):
            part = slice(first, first + _BATCH)
            si = _interaction(points[part], views[part])
            light = mi.Vector3f(np.ascontiguousarray(lights[part].T))
            found[part] = np.array(self._bsdf.eval(self._context, si, light, mi.Bool(True))).T
        # Lobes at grazing angles may be 0/0.
        return np.nan_to_num(found, nan=0.0, posinf=0.0, neginf=0.0)

    def texels(self, resolution: int) -> MaterialTexels:
        """The texels of the textures, no finer than those are; see `EncodedBtf.texels`.

        Raises:
            InputError: a normal or bump map of a kind of texture that holds none.
        """
        return MaterialTexels(self._source, self.faces, resolution)


class MaterialTexels(Texels):
    """Texels of a material's textures."""

    turns = FOUR_POINTS

    def __init__(self, source: Material, faces: int, resolution: int) -> None:
        with tempfile.TemporaryDirectory() as folder:
            textures = _textures(source.write_files(folder), source.name)
        self.resolution = _resolution(textures, resolution)
        texel = 1 / np.array(self.resolution, np.float32)
        self.sigma = np.asarray(texel / SIZE_OF_SIGMA, np.float32)
        inputs = [_input(name, texture, self.resolution) for name, texture in textures.items()]
        width, height = self.resolution
        # A BSDF without textures is one material: its only input says nothing.
        inputs = inputs or [_Input("constant", np.ones((height, width, 1), np.float32), ("",))]
        self.inputs = tuple(f"{part.name}{channel}" for part in inputs for channel in part.channels)
        flat = [np.zeros((height, width, 2), np.float32)]
        # The first two moments of a normal or bump map.
        maps = [part.values[..., :2] for part in inputs if part.channels[:2] == (".x", ".y")]
        self._slopes = np.stack([*flat, *maps])[None].repeat(faces, axis=0)
        self._inputs = np.concatenate([part.values for part in inputs], axis=-1)

    @property
    def slopes(self) -> _Floats:
        """Of the flat surface and of its normal and bump maps; see `Texels.slopes`."""
        return self._slopes

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Filtered inputs [height, width, K] of a level; see `Texels.encoder_inputs`."""
        del face
        inputs = self._inputs
        for _ in range(level):
            for axis in (0, 1):
                if inputs.shape[axis] > 1:
                    even, odd = (np.take(inputs, range(k, inputs.shape[axis], 2), axis) for k in (0, 1))
                    inputs = (even + odd) / 2
        return np.ascontiguousarray(inputs, np.float32)


def _loaded(element: ElementTree.Element, name: str) -> Any:
    """The object of an element of a scene file."""
    element.set("version", element.get("version", "3.0.0"))
    try:
        return mi.load_string(ElementTree.tostring(element, encoding="unicode"))
    except Exception as error:  # Mitsuba raises bare RuntimeErrors
        raise InputError(f"{name} cannot be used: {reason_of(error)}") from error


def _warn_of_losses(source: Material, bsdf: mi.BSDF) -> None:
    """Says once what of a BSDF is left out."""
    flags: Any = mi.BSDFFlags
    lost = {"mirror reflection": flags.DeltaReflection, "transmission": flags.Transmission}
    found = [name for name, flag in lost.items() if mi.has_flag(bsdf.flags(), flag)]
    if found:
        warnings.warn(
            f"{source.name}: its {' and '.join(found)} is left out, as the model learns reflection by smooth "
            "lobes.",
            LoomlightWarning,
            stacklevel=3,
        )


def _interaction(positions: _Floats, views: _Floats | None = None) -> Any:
    """Surface interactions at points of uv [n, 2], seen from `views` [n, 3], from above by default."""
    si: Any = dr.zeros(mi.SurfaceInteraction3f, len(positions))
    si.t = mi.Float(1)
    si.uv = mi.Point2f(np.ascontiguousarray(positions.T, np.float32))
    si.p = mi.Point3f(si.uv.x, si.uv.y, 0)
    si.n = mi.Normal3f(0, 0, 1)
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    si.wi = mi.Vector3f(0, 0, 1) if views is None else mi.Vector3f(np.ascontiguousarray(views.T))
    return si


@dataclass(frozen=True, eq=False)
class _Texture:
    """A texture, what it is to its BSDF, and texels a side of uv."""

    texture: mi.Texture
    role: str
    scale: float
    texels: tuple[float, float]


def _textures(root: ElementTree.Element, material: str) -> dict[str, _Texture]:
    """Textures that are parameters of a BSDF, by the path of their parameter."""
    found: dict[str, _Texture] = {}

    def visit(bsdf: ElementTree.Element, path: str) -> None:
        nested = 0
        for child in bsdf:
            name = child.get("name") or f"{child.get('type')}{nested}"
            if child.tag == "bsdf":
                nested += 1
                visit(child, f"{path}{name}.")
            elif child.tag == "texture":
                kind = bsdf.get("type", "")
                role = {"normalmap": "normal", "bumpmap": "bump"}.get(kind, "")
                scale = next((float(v.get("value", 1)) for v in bsdf if v.get("name") == "scale"), 1.0)
                texture = _loaded(child, f"{material}, {path}{name}")
                found[f"{path}{name}"] = _Texture(texture, role, scale, _texels(texture))
                _require_slopes(found[f"{path}{name}"], f"{material}, {path}{name}", child.get("type", ""))

    visit(root, "")
    return found


def _require_slopes(texture: _Texture, what: str, kind: str) -> None:
    """Raises InputError if a texture is a normal or bump map, and of a kind that Mitsuba takes none from."""
    if not texture.role:
        return
    try:
        _evaluated(texture, np.zeros((1, 2), np.float32))
    except RuntimeError as error:  # procedural textures give colours alone
        raise InputError(
            f"{what}: a texture of type {kind} holds no {texture.role} map; give a bitmap."
        ) from error


def _texels(texture: mi.Texture) -> tuple[float, float]:
    """Texels of a texture along a unit of u and of v; those of procedural ones are infinitely small."""
    size = texture.resolution()
    if tuple(size) == (1, 1) and texture.is_spatially_varying():
        return math.inf, math.inf
    params = mi.traverse(texture)
    across = np.eye(3)
    if "to_uv" in params:
        across = np.array(params["to_uv"].matrix, np.float64).reshape(3, 3)
    columns = math.hypot(across[0, 0], across[1, 0]) * size[0]
    rows = math.hypot(across[0, 1], across[1, 1]) * size[1]
    return max(columns, 1.0), max(rows, 1.0)


def _resolution(textures: dict[str, _Texture], most: int) -> tuple[int, int]:
    """Texels of the finest texture, rounded up to powers of two, and no more than `most`."""
    sides = []
    for axis in (0, 1):
        finest = max((texture.texels[axis] for texture in textures.values()), default=1.0)
        sides.append(1 << math.ceil(math.log2(min(finest, most)) - 1e-6))
    return sides[0], sides[1]


def _input(name: str, texture: _Texture, resolution: tuple[int, int]) -> _Input:
    """A texture's values over all texels: means of what lies in each."""
    width, height = resolution
    taps = [
        max(1, math.ceil(min(_MAX_TAPS, n / side)))
        for n, side in zip(texture.texels, resolution, strict=True)
    ]
    v, u = np.meshgrid(
        (np.arange(height * taps[1]) + 0.5) / (height * taps[1]),
        (np.arange(width * taps[0]) + 0.5) / (width * taps[0]),
        indexing="ij",
    )
    positions = np.stack([u.ravel(), v.ravel()], 1).astype(np.float32)
    fine, channels = _evaluated(texture, positions)
    grid = fine.reshape(height, taps[1], width, taps[0], -1)
    return _Input(name, grid.mean(axis=(1, 3), dtype=np.float64).astype(np.float32), channels)


def _evaluated(texture: _Texture, positions: _Floats) -> tuple[_Floats, tuple[str, ...]]:
    """Inputs [n, channels] at points of uv, about −1 to 1, and their names."""
    parts = []
    for first in range(0, len(positions), _BATCH):
        si = _interaction(positions[first : first + _BATCH])
        if texture.role == "bump":
            gradient = texture.scale * np.array(texture.texture.eval_1_grad(si)).T
            parts.append(gradient)
        else:
            value: Any = texture.texture.eval_3(si) if texture.role else texture.texture.eval(si)
            parts.append(np.broadcast_to(np.array(value).T, (len(positions[first : first + _BATCH]), 3)))
    values = np.concatenate(parts).astype(np.float32)
    if not texture.role:
        values = 2 * values - 1
        if np.array_equal(values, values[:, :1].repeat(3, axis=1)):
            return values[:, :1], ("",)
        return values, (".r", ".g", ".b")
    if texture.role == "normal":
        normal = 2 * values - 1
        values = (-normal[:, :2] / np.maximum(normal[:, 2:], 0.1)).astype(np.float32)
    slope = values.clip(-_STEEPEST, _STEEPEST)
    x, y = slope.T
    moments = np.stack([x, y, x * x, y * y, x * y], axis=1)
    return moments.astype(np.float32), (".x", ".y", ".xx", ".yy", ".xy")
