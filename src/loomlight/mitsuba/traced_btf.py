"""BTFs of sources whose rays are paths: height fields, and Mitsuba scenes of one tile, which repeat.

Nine copies of a tile are traced, from whose sides rays go on in the middle. The reference plane is z = 0. A
path begins where its view ray meets the top of the geometry (or its bottom, seen from behind), and takes
light at each vertex from a distant source, smoothed over a small cone. The source has unit irradiance across
its direction, so a path's value is f·cos: that of kuznetsov2021 eq. 1 times the cosine of the light.
"""

from __future__ import annotations

import copy
import math
import warnings
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, Vec3
from loomlight.core.backend import upload, upload_vector
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, joined
from loomlight.mitsuba.meshes import check_scene_meshes, to_shape
from loomlight.mitsuba.variants import choose_variant, reason_of
from loomlight.models.texture.queries import Btf
from loomlight.sources.heightfield import Heightfield
from loomlight.sources.tile import TileScene

_Floats = NDArray[np.float32]
# Half the angle of the light's cone, radians: 2.9°.
LIGHT_CONE = 0.05
# Copies of the tile on each side of the one in the middle.
COPIES = 1
# How often a ray goes on, at most: at the lowest elevation it crosses a relief as deep as the tile is wide.
_MAX_WRAPS = 64
# Rays in one launch.
_BATCH = 1 << 19


@dataclass(frozen=True)
class Tile:
    """Geometry that repeats.

    Attributes:
        scene: `COPIES` copies on each side of the tile, which begins at x = y = 0.
        size_mm: width and height of the tile, millimetres.
        top, bottom: bounds of z, millimetres.
        overhang: how far geometry sticks out of its tile along x and y, millimetres.
        epsilon: distance of starts of rays from the surface, millimetres.
        bounces: vertices of a path, at most.
    """

    scene: Any
    size_mm: tuple[float, float]
    top: float
    bottom: float
    overhang: tuple[float, float]
    epsilon: float
    bounces: int


class PeriodicPaths(Btf):
    """Estimates of f·cos by paths through a tile that repeats without end."""

    def __init__(self, tile: Tile) -> None:
        self._tile = tile

    @property
    def extent(self) -> tuple[float, float]:
        """Of the tile, millimetres."""
        return self._tile.size_mm

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """Estimates of f·cos by a path each [n, 3]; see `Btf.values`."""
        found = np.empty((len(points), 3), np.float32)
        for number, part in enumerate(_batches(len(points))):
            x, y = (upload(mi.Float, row) for row in points[part].T)
            light, view = (upload_vector(mi.Vector3f, rows[part].T) for rows in (lights, views))
            key = np.random.SeedSequence([*seed, number]).generate_state(1)[0]
            sampler: Any = mi.load_dict({"type": "independent"})
            sampler.seed(int(key), dr.width(x))
            found[part] = np.array(self._traced(x, y, light, view, sampler)).T
        return found

    def holes(self, points: _Floats, views: _Floats) -> _Floats:
        """1 where the view ray passes straight through, else 0 [n]; see `Btf.holes`."""
        found = np.empty(len(points), np.float32)
        for part in _batches(len(points)):
            x, y = (upload(mi.Float, row) for row in points[part].T)
            view = upload_vector(mi.Vector3f, views[part].T)
            ray = self._view_ray(x, y, view)
            found[part] = ~np.array(self._tile.scene.ray_test(ray))
        return found

    def _view_ray(self, x: Float, y: Float, view: Vec3) -> Any:
        """The ray from the eye through a point of the reference plane, from where it enters the geometry."""
        tile = self._tile
        start = dr.select(view.z > 0, tile.top + tile.epsilon, tile.bottom - tile.epsilon)
        distance = start / view.z
        origin = mi.Point3f(x + view.x * distance, y + view.y * distance, start)
        return self._ray(origin, -view, mi.Bool(True))

    def _traced(self, x: Float, y: Float, light: Vec3, view: Vec3, sampler: Any) -> Any:
        """Radiance of paths towards `view`, under unit irradiance across `light`."""
        ray = self._view_ray(x, y, view)
        total, weight = mi.Color3f(0), mi.Color3f(1)
        active = mi.Bool(True)
        frame = mi.Frame3f(mi.Vector3f(light))
        context: Any = mi.BSDFContext()
        warp: Any = mi.warp
        # Bounces are launches of their own: virtual calls of a single kind of BSDF are cheap, loops are not.
        for bounce in range(self._tile.bounces):
            si = self._tile.scene.ray_intersect(ray, active)
            active &= si.is_valid()
            bsdf = si.bsdf(ray)
            towards = frame.to_world(
                warp.square_to_uniform_cone(sampler.next_2d(), mi.Float(math.cos(LIGHT_CONE)))
            )
            lit = active & (towards.z * light.z > 0) & ~self._shadowed(si, towards, active)
            value = bsdf.eval(context, si, si.to_local(towards), lit)
            total += dr.select(lit, weight * value, 0)
            if bounce + 1 < self._tile.bounces:
                sample, factor = bsdf.sample(context, si, sampler.next_1d(), sampler.next_2d(), active)
                active &= dr.max(factor) > 0
                weight *= dr.select(active, factor, 0)
                direction = si.to_world(sample.wo)
                ray = self._ray(self._lifted(si, direction), direction, active)
                # Paths of a source that is all there is end where they leave it.
                dr.eval(total, weight, ray, active, sampler)
        return total

    def _shadowed(self, si: mi.SurfaceInteraction3f, direction: Vec3, active: Mask) -> Mask:
        return self._tile.scene.ray_test(self._ray(self._lifted(si, direction), direction, active), active)

    def _ray(self, origin: Any, direction: Vec3, active: Mask) -> Any:
        """The ray from where it is in the copies of the tile in which it meets the geometry or leaves it."""
        tile, start = self._tile, self._wrapped(origin)
        searching = mi.Bool(active)

        def search(start: Any, searching: Mask, count: Any) -> tuple[Any, Mask, Any]:
            edge = self._distance_to_edge(start, direction)
            rises = direction.z > 0
            vertical = dr.select(rises, tile.top - start.z, start.z - tile.bottom)
            # Within the copies it leaves at top or bottom, or meets the geometry before.
            searching &= vertical > dr.abs(direction.z) * edge
            searching &= ~tile.scene.ray_test(mi.Ray3f(mi.Ray3f(start, direction), edge), searching)
            moved = self._wrapped(start + direction * edge)
            return dr.select(searching, moved, start), searching, count + 1

        start, searching, _ = dr.while_loop(
            (start, searching, mi.UInt32(0)),
            lambda start, searching, count: searching & (count < _MAX_WRAPS),
            search,
            label="tiles of a source that repeats",
        )
        return mi.Ray3f(start, direction)

    def _distance_to_edge(self, start: Any, direction: Vec3) -> Float:
        """Distance along a ray to where copies that are not there would stick into the others."""
        found = mi.Float(dr.inf)
        for place, step, side, outside in zip(
            (start.x, start.y),
            (direction.x, direction.y),
            self._tile.size_mm,
            self._tile.overhang,
            strict=True,
        ):
            edge = dr.select(step > 0, (1 + COPIES) * side - outside, outside - COPIES * side)
            found = dr.minimum(found, dr.select(dr.abs(step) > 1e-9, (edge - place) / step, dr.inf))
        return found

    def _lifted(self, si: mi.SurfaceInteraction3f, direction: Vec3) -> Any:
        """The start of a ray from a surface, on the side that it leaves to."""
        side = dr.sign(dr.dot(si.n, direction))
        return si.p + mi.Vector3f(si.n) * (side * self._tile.epsilon)

    def _wrapped(self, point: Any) -> Any:
        """The same point of the tile in the middle."""
        width, height = self._tile.size_mm
        return mi.Point3f(
            point.x - width * dr.floor(point.x / width),
            point.y - height * dr.floor(point.y / height),
            point.z,
        )


def _batches(count: int) -> list[slice]:
    return [slice(first, first + _BATCH) for first in range(0, count, _BATCH)]


# ---------------------------------------------------------------------------------------------- height fields

# Vertices of a path.
MAX_BOUNCES = 4
# Distance of starts of rays from the surface, in texels of the height map.
_RELIEF_EPSILON = 1e-2


class HeightfieldBtf(PeriodicPaths):
    """f·cos of paths over a mesh of a height field (kuznetsov2021 section 4); no ray passes through it.

    The reference plane lies at the mean height.
    """

    def __init__(self, source: Heightfield) -> None:
        choose_variant(None)
        relief = source.height_mm * (source.height - source.height.mean(dtype=np.float64))
        super().__init__(
            Tile(
                mi.load_dict({"type": "scene", "relief": _tiles(source, relief)}),
                source.size_mm,
                float(relief.max()),
                float(relief.min()),
                # Vertices lie in the middle of texels.
                (0.5 * source.size_mm[0] / relief.shape[1], 0.5 * source.size_mm[1] / relief.shape[0]),
                _RELIEF_EPSILON * min(source.size_mm) / max(source.height.shape),
                MAX_BOUNCES,
            )
        )


def _tiles(source: Heightfield, relief: NDArray[np.floating[Any]]) -> Any:
    """A mesh of all copies of the tile."""
    one = _mesh(source, relief)
    width, height = source.size_mm
    shifts = range(-COPIES, COPIES + 1)
    offsets = [np.array([column * width, row * height, 0]) for row in shifts for column in shifts]
    copies = [replace(one, positions=one.positions + offset) for offset in offsets]
    return to_shape(joined(copies), _bsdf(source))


def _mesh(source: Heightfield, relief: NDArray[np.floating[Any]]) -> ClothMesh:
    """The relief over one tile, a vertex a texel of the height map, and one more at the far sides."""
    rows, columns = relief.shape
    width, height = source.size_mm
    across, along = width / columns, height / rows
    slope_x = (np.roll(relief, -1, 1) - np.roll(relief, 1, 1)) / (2 * across)
    slope_y = (np.roll(relief, -1, 0) - np.roll(relief, 1, 0)) / (2 * along)
    normals = np.stack([-slope_x, -slope_y, np.ones_like(relief)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    z, normal = (
        np.pad(part, ((0, 1), (0, 1), (0, 0))[: part.ndim], mode="wrap") for part in (relief, normals)
    )
    v, u = np.meshgrid(
        (np.arange(rows + 1) + 0.5) / rows, (np.arange(columns + 1) + 0.5) / columns, indexing="ij"
    )
    positions = np.stack([u * width, v * height, z], axis=-1)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    right, up, far = corner + 1, corner + columns + 1, corner + columns + 2
    triangles = np.concatenate([np.stack([corner, right, far], 1), np.stack([corner, far, up], 1)])
    uv = np.stack([u, v], axis=-1).reshape(-1, 2)
    return ClothMesh(positions.reshape(-1, 3), normal.reshape(-1, 3), uv, triangles, "relief")


def _bsdf(source: Heightfield) -> dict[str, Any]:
    """Mitsuba's principled BSDF of the maps."""
    principled = {
        "type": "principled",
        "base_color": _texture(source.albedo),
        "roughness": _texture(source.roughness[..., None]),
        "metallic": _texture(source.metallic[..., None]),
        "specular": source.specular,
    }
    if source.normal is None:
        return principled
    return {"type": "normalmap", "normalmap": _texture(source.normal), "bsdf": principled}


def _texture(values: NDArray[np.float32]) -> dict[str, Any]:
    """A map [rows, columns, channels], numbers as they are."""
    return {
        "type": "bitmap",
        "data": mi.TensorXf(np.ascontiguousarray(values, np.float32)),
        "raw": True,
        "wrap_mode": "repeat",
    }


# ------------------------------------------------------------------------------------------------------ tiles

# Rays start so many times the shorter side of the tile away from surfaces: a hundredth of a fibre of 0.001 of
# that side.
_TILE_EPSILON = 1e-5
# Rays that say whether there are holes at all.
_TRIALS = 1 << 14
_SCENE = "loomlight-tile.xml"
_CURVES = ("bsplinecurve", "linearcurve")
# Of a curve that is not met: a millionth of a fibre.
_NO_RADIUS = 1e-9


class TileBtf(PeriodicPaths):
    """f·cos of paths through a tile.

    Geometry may stick out of its tile by up to half of it, as yarns do that cross its sides: each copy brings
    its own. BSDFs are shared by all copies.

    Attributes:
        faces: 2 for a tile of two sides.
        transmits: whether light from the other side counts.
        has_holes: whether rays pass straight through.
    """

    def __init__(self, source: TileScene) -> None:
        """
        Raises:
            InputError: a scene that Mitsuba cannot load, that emits light, has no shapes, or whose geometry
                sticks out of its tile by more than half of it.
        """
        choose_variant(None)
        scene = _loaded(source)
        box, (width, height) = scene.bbox(), source.size_mm
        if not scene.shapes():
            raise InputError(f"{source.name}: its scene has no shapes.")
        if scene.emitters():
            raise InputError(f"{source.name}: its scene holds an emitter; queries bring their own light.")
        low, high = (np.array(corner).ravel() for corner in (box.min, box.max))
        sides = np.array([width, height])
        # Of all copies.
        overhang = np.maximum(-COPIES * sides - low[:2], high[:2] - (1 + COPIES) * sides).clip(min=0)
        if (overhang > 0.5 * sides).any():
            raise InputError(
                f"{source.name}: its geometry sticks out of size_mm = {list(source.size_mm)} by "
                f"{overhang.max():.3g} mm; at most half of a side may."
            )
        epsilon = _TILE_EPSILON * min(width, height)
        outside = float(overhang[0]), float(overhang[1])
        super().__init__(
            Tile(scene, source.size_mm, float(high[2]), float(low[2]), outside, epsilon, source.bounces)
        )
        self.faces = 2 if source.two_sided else 1
        self.transmits = source.two_sided
        rng = np.random.default_rng(0)
        positions = rng.random((_TRIALS, 2), np.float32) * sides.astype(np.float32)
        upright = np.tile(np.array([0, 0, 1], np.float32), (_TRIALS, 1))
        self.has_holes = bool(self.holes(positions, upright).any())


def _loaded(source: TileScene) -> Any:
    root = ElementTree.fromstring(source.scene)
    curves = {
        node.get("value")
        for shape in root.findall("shape")
        if shape.get("type") in _CURVES
        for node in shape.findall("string")
    }
    with TemporaryDirectory(prefix="loomlight-") as name:
        folder = Path(name)
        for path, held in source.files.items():
            try:
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_bytes(_with_last_curve(held) if path in curves else held)
            except OSError as error:  # one file's name is another one's folder
                raise InputError(f"{source.name}: its file {path} cannot be written.") from error
        file = folder / _SCENE
        try:
            # Each mesh once, before there are copies of it; one that cannot be checked is refused.
            file.write_text(source.scene, encoding="utf-8")
            with warnings.catch_warnings():
                warnings.simplefilter("error", LoomlightWarning)
                check_scene_meshes(file)
            file.write_text(_repeated(root, source), encoding="utf-8")
            return mi.load_file(str(file), parallel=False, optimize=False)
        except (InputError, LoomlightWarning, RuntimeError) as error:
            said = reason_of(error).replace(f"{folder}/", "")
            raise InputError(f"{source.name}: Mitsuba cannot load its scene: {said}") from error


def _with_last_curve(held: bytes) -> bytes:
    """A file of curves and one that no ray meets.

    Mitsuba 3.9 finds the segment of a hit anew from its place among all, rounded. At the end of the last one
    that is a segment too many, and reads beyond all of them: a crash, which a further curve prevents.
    """
    points = [line.split() for line in held.decode("utf-8", "replace").splitlines()]
    first = [words for words in points if len(words) == 4][:4]
    last = "".join(f"{x} {y} {z} {_NO_RADIUS}\n" for x, y, z, _ in first)
    return held + b"\n\n" + last.encode()


def _repeated(root: ElementTree.Element, source: TileScene) -> str:
    """The scene with all copies of its shapes."""
    width, height = source.size_mm
    for number, shape in enumerate(list(root.findall("shape"))):
        if shape.get("type") == "shapegroup":
            continue
        root.remove(shape)
        for bsdf in shape.findall("bsdf"):
            # Before the shapes that refer to it.
            name = bsdf.get("id") or f"loomlight-bsdf-{number}"
            bsdf.set("id", name)
            shape.remove(bsdf)
            root.insert(0, bsdf)
            ElementTree.SubElement(shape, "ref", {"name": "bsdf", "id": name})
        for row in range(-COPIES, COPIES + 1):
            for column in range(-COPIES, COPIES + 1):
                root.append(_moved(shape, column * width, row * height, -source.reference_height_mm))
    return ElementTree.tostring(root, encoding="unicode")


def _moved(shape: ElementTree.Element, x: float, y: float, z: float) -> ElementTree.Element:
    moved = copy.deepcopy(shape)
    # All copies of a shape cannot have its name.
    moved.attrib.pop("id", None)
    to_world = next((node for node in moved.findall("transform") if node.get("name") == "to_world"), None)
    if to_world is None:
        to_world = ElementTree.SubElement(moved, "transform", {"name": "to_world"})
    ElementTree.SubElement(to_world, "translate", {"x": repr(x), "y": repr(y), "z": repr(z)})
    return moved
