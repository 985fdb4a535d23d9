"""Scenes that show a piece of cloth: built in, around a user's mesh, or a user's own scene file."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Unpack

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.camera_settings import CameraKeywords, CameraSettings
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.core.picture_settings import Placement
from loomlight.core.sentences import shown
from loomlight.core.studio import PAPER, STUDIO_AZIMUTH, STUDIO_ELEVATION, paper_radiance, studio_radiance
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.facts import cloth_facts
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, joined, warn_of_extent, warn_of_scale
from loomlight.mesh.clothing import Garment, placed, read_garment
from loomlight.mesh.edges import EDGES, Edges
from loomlight.mesh.file_camera import FileCamera
from loomlight.mesh.garments import garment_parts
from loomlight.mesh.picture_places import FILE_UV, picture_uv
from loomlight.mesh.reading import read_cameras
from loomlight.mitsuba.bsdf import surface_bsdf
from loomlight.mitsuba.camera import (
    View,
    chosen_view,
    look_at,
    perspective,
    require_size,
    require_zoom,
    size_of_file,
    view_of_file,
)
from loomlight.mitsuba.lights import direction_of, environment_dict, light_dicts
from loomlight.mitsuba.meshes import (
    add_attributes,
    check_scene_meshes,
    from_shape,
    set_uv,
    to_shape,
)
from loomlight.mitsuba.painting import attribute_name
from loomlight.mitsuba.path import footprint_integrator
from loomlight.mitsuba.shapes import (
    CYLINDER_RADIUS,
    SPHERE_RADIUS,
    backdrop,
    ball,
    cylinder,
    drape,
    flat,
    ground,
    sphere,
)
from loomlight.mitsuba.variants import reason_of

# The BSDF of a user's scene file that is replaced by the fabric.
FABRIC_ID = "fabric"
# Shapes of built-in scenes, among their parameters: pieces are cloth, cloth1, … .
CLOTH_NAME, UNCOVERED_NAME = "cloth", "uncovered"
_UNCOVERED: dict[str, object] = {
    "type": "twosided",
    "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.32}},
}
DEFAULT_DEPTH = 8
# Where Russian roulette begins. CPUs take paths in packets, as long as the longest: with Mitsuba's 5, two
# fifths of denim's time in daylight went to a half per cent of its light, at the same variance.
ROULETTE_DEPTH = 2
DEFAULT_SIZE = (640, 480)
# Half the extent of a mesh, metres: beyond, threads are lost in the rounding of coordinates.
MIN_RADIUS, MAX_RADIUS = 1e-5, 1e4

# Of cloth of which it is not known, metres.
_THICKNESS = 5e-4
# Paper goes on so many times farther where a camera may see its horizon, to a hundredth of a degree below it.
_TO_HORIZON = 100
# Of a unit vector across cloth that is seen from its edge.
_EDGE_ON = 1e-9
# Of the ball behind the paper of scenes that show none, metres.
_UNSEEN = 2.0

# From (mm per unit of u, mm per unit of v) to a BSDF, or to the dictionary of one.
BsdfFactory = Callable[[tuple[float, float]], Any]
# From meshes of the scene to the outermost places [n, 3] where they will be.
Swept = Callable[[Sequence[ClothMesh]], NDArray[np.float64]]


class SceneOptions(CameraKeywords, total=False):
    """The keyword arguments of `build_scene`."""

    mesh: str | os.PathLike[str] | None
    metres_per_unit: float
    environment: str | os.PathLike[str] | None
    environment_turn: float
    light: str | None
    light_from: tuple[float, float] | None
    zoom: float
    size: tuple[int, int] | None
    max_depth: int | None
    placement: Placement
    edge: str | None
    unwrap: bool | None
    save_mesh: str | os.PathLike[str] | None


@dataclass(frozen=True)
class ClothScene:
    """A scene that is ready to render.

    Attributes:
        scene: the Mitsuba scene; its first sensor frames the cloth.
        integrator: the `footprint_path` to render it with.
        uv_size_mm: millimetres of cloth per unit of u and of v, of the first piece of cloth.
        point: where the camera comes closer to, world coordinates.
        view: where the camera stands, at the zoom of the scene.
        framed: what the camera frames [n, 3]; None where it stands in a place of its own.
        dressed: the cloth of a built-in scene or of a mesh; None of scene files.
    """

    scene: mi.Scene
    # Of a class that is made anew for each variant, and so has no type.
    integrator: Any
    uv_size_mm: tuple[float, float]
    point: NDArray[np.float64]
    view: View
    framed: NDArray[np.float64] | None = None
    dressed: Dressed | None = None

    def pixel_mm(self, metres_per_unit: float = 1.0) -> float:
        """Side of what a pixel in the middle shows of cloth that faces the camera at `point`, millimetres.

        Args:
            metres_per_unit: of the scene's coordinates.
        """
        sensor = self.scene.sensors()[0]
        step = 1 / int(sensor.film().crop_size()[0])
        middle, beside = (
            sensor.sample_ray(0, 0, mi.Point2f(0.5 + part, 0.5), mi.Point2f(0.5))[0] for part in (0, step)
        )
        axis = np.array(middle.d, np.float64).ravel()
        # Where both rays meet the plane through the point that faces the camera.
        places = []
        for ray in (middle, beside):
            origin, towards = (np.array(part, np.float64).ravel() for part in (ray.o, ray.d))
            places.append(origin + towards * (((self.point - origin) @ axis) / (towards @ axis)))
        return float(1e3 * metres_per_unit * np.linalg.norm(places[1] - places[0]))

    def look_from(self, view: View) -> None:
        """Moves the camera, which keeps the size of its picture.

        Kernels of all places are the same: the place is no constant of theirs, as it is in a new scene.
        """
        params = mi.traverse(self.scene.sensors()[0])
        params["to_world"] = mi.Transform4f(look_at(view))
        if view.field_of_view != self.view.field_of_view:
            width, height = params["film.size"]
            params["x_fov"] = mi.Float(view.across((int(width), int(height))))
        params.update()


@dataclass(frozen=True, eq=False)
class Dressed:
    """The triangles of a scene before its cloth has edges.

    Attributes:
        pieces: by the names of their shapes, among the scene's parameters.
        edges: of all pieces, in this order.
    """

    pieces: dict[str, ClothMesh]
    edges: Edges

    def at_rest(self) -> dict[str, ClothMesh]:
        """The pieces with their edges, by name."""
        return self.moved([*self.pieces.values()])

    def moved(self, pieces: list[ClothMesh]) -> dict[str, ClothMesh]:
        """The same, of pieces whose vertices have moved."""
        return dict(zip(self.pieces, self.edges.on(pieces), strict=True))


@dataclass(frozen=True)
class _Setup:
    """The parts of a built-in scene; `light_from` as in `build_scene`.

    Paper stands on the ground, or a gap behind the plane z = 0, metres.
    """

    cloth: Callable[[], ClothMesh]
    towards_camera: tuple[float, float, float]
    light_from: tuple[float, float]
    ground: bool = False
    gap: float = 0.0
    edge: str = "raw"

    def lamp(self, settings: CameraSettings, view: View) -> tuple[float, float]:
        """Azimuth and elevation of the lamp.

        It stays beside a camera that walks around what stands on the floor, and on the upper side of a
        backdrop, which is moved to the other side of the cloth for cameras behind it.
        """
        azimuth, elevation = self.light_from
        if settings.view is None and settings.camera is None:
            return azimuth, elevation
        x, _, z = self.towards_camera
        front = float(np.degrees(np.arctan2(x, z)))
        walked = view.azimuth - front if self.ground else 180.0 * (_backdrop_side(view) < 0)
        return (azimuth + walked + 180) % 360 - 180, elevation


# As catalogues show cloth: on light paper, in a studio whose light is neutral. A flat piece, a ball and a
# roll lie on it, seen from above; the paper is some millimetres behind, so that it cuts none. Light comes
# over the drape some 70 degrees off the camera, over what lies flat 50: more would leave white cloth grey.
_FRONT = (0, 0, 1)
_SETUPS = {
    "flat": _Setup(flat, _FRONT, (-37, 33), gap=0.004, edge="pinked"),
    "sphere": _Setup(sphere, _FRONT, (-45, 35), gap=0.001 + SPHERE_RADIUS),
    "cylinder": _Setup(cylinder, _FRONT, (-25, 42), gap=0.001 + CYLINDER_RADIUS),
    "drape": _Setup(drape, (0.35, 0.55, 1), (STUDIO_AZIMUTH, STUDIO_ELEVATION), ground=True, edge="hem"),
}
_MESH = replace(_SETUPS["drape"], towards_camera=(0.3, 0.35, 1))

SCENES = tuple(_SETUPS)


def build_scene(
    name: str | os.PathLike[str],
    bsdf: BsdfFactory | dict[str, Any],
    *,
    mesh: str | os.PathLike[str] | None = None,
    metres_per_unit: float = 1.0,
    environment: str | os.PathLike[str] | None = None,
    environment_turn: float = 0.0,
    light: str | None = None,
    light_from: tuple[float, float] | None = None,
    zoom: float = 1.0,
    size: tuple[int, int] | None = None,
    max_depth: int | None = None,
    placement: Placement = Placement(),  # noqa: B008 (frozen)
    edge: str | None = "raw",
    unwrap: bool | None = None,
    save_mesh: str | os.PathLike[str] | None = None,
    others: Mapping[str, BsdfFactory] | None = None,
    turns: Mapping[str, float] | None = None,
    time: float | None = None,
    swept: Swept | None = None,
    **camera: Unpack[CameraKeywords],
) -> ClothScene:
    """A scene that shows the cloth `bsdf`; a Mitsuba variant must be set.

    Args:
        name: flat (0.1 m), sphere (radius 0.1 m), cylinder (radius 0.04 m), drape (0.6 m), or the path of a
            Mitsuba scene, FILE.xml, in which every mesh whose BSDF has the id "fabric" is given the cloth.
        bsdf: a function from (mm per unit of u, mm per unit of v) of a piece of cloth to its BSDF, or the
            dictionary of it, such as `material_bsdf` gives; or the dictionary itself.
        mesh, metres_per_unit, environment, environment_turn, light, zoom, placement, unwrap, save_mesh: of
            `RenderSettings`.
        light_from: where the light comes from, degrees: azimuth (0 from +z, where the camera of `flat`
            stands, 90 from +x, its right) and elevation (90 from +y); by default as designed.
        size: width and height in pixels; 640 × 480 by default, a scene file's own otherwise.
        max_depth: longest path, in segments; 8 by default, a scene file's own otherwise.
        edge: "hem" folds the cloth's open edges over, "pinked" cuts them in teeth, "raw" leaves them as the
            mesh has them; None is what suits the scene. Scene files have their own.
        others: further cloths: of a scene file by the id of the BSDF that each replaces, of a mesh by the
            name of a part or of its material.
        turns: degrees by which these are turned, by the same names.
        camera: fields of `CameraSettings`.
        time: of a mesh file that moves, seconds from its start; None is as it rests.
        swept: gives places [n, 3] where meshes will be, which move; the camera shows all of them.

    Raises:
        InputError: an unknown scene or light, a value out of range, or a file that cannot be used.
    """
    _require_values(zoom, size, metres_per_unit, max_depth, edge)
    seen = CameraSettings.of(camera)
    factory = bsdf if callable(bsdf) else _always(bsdf)
    # 1. A scene file has all but the cloth, and takes none of what describes a built-in scene.
    if Path(name).suffix.lower() == ".xml":
        given: dict[str, object] = {
            "mesh": mesh,
            "environment": environment,
            "light": light,
            "light_from": light_from,
        }
        given |= seen.chosen() | {"edge": None if edge == "raw" else edge}
        given |= {"unwrap": unwrap, "save_mesh": save_mesh}
        for field, value in given.items():
            if value is not None:
                raise InputError(
                    f"{field} = {value} does not go with the scene file {name}, which has its own."
                )
        cloths = {FABRIC_ID: factory, **(others or {})}
        own = turns or {}
        laid = {each: placement.changed(turn=placement.turn + own.get(each, 0.0)) for each in cloths}
        return _from_file(Path(name), cloths, laid, metres_per_unit, zoom, size, max_depth)
    if str(name) not in _SETUPS:
        raise InputError(
            f'scene = "{name}" is unknown: use {", ".join(SCENES)}, or the path of an .xml file.'
        )
    for field, value in {"light": light, "light_from": light_from}.items():
        if environment is not None and value is not None:
            raise InputError(f"{field} = {value} does not go with an environment, which is all the light.")
    if others and mesh is None:
        raise InputError(f"The cloth {next(iter(others))} needs a mesh with parts, and {name} has none.")
    # 2. The cloth: the scene's own piece, or a mesh in parts; laid, with its edges, and measured.
    setup = _SETUPS[str(name)]
    if mesh is None:
        worn = Garment([(_upright(setup.cloth()), factory)], None)
    else:
        setup = _MESH
        worn = read_garment(
            mesh,
            metres_per_unit,
            factory,
            others or {},
            unwrap=unwrap,
            turns=turns,
            save=save_mesh,
            time=time,
        )
    size, edge = size or default_size(mesh, seen.camera), edge or setup.edge
    dressed, bsdfs, uv_size_mm = _dressed(worn, placement, edge)
    meshes = dressed.at_rest()
    cloth = joined([replace(mesh, uv=np.zeros((0, 2))) for mesh in meshes.values()])
    cloth = _extended(cloth, [*dressed.pieces.values()], swept)
    shapes = {
        name: to_shape(mesh, bsdf, _pictures(mesh, bsdf, [*meshes.values()]))
        for (name, mesh), bsdf in zip(meshes.items(), bsdfs, strict=True)
    }
    centre, radius = _bounds(cloth)
    _require_extent(cloth.name, radius)
    # 3. The camera frames all of it, or what it is told to, and comes closer below.
    view, point, framed = _seen(
        seen,
        name if mesh is None else mesh,
        cloth,
        worn.parts,
        setup,
        size,
        metres_per_unit,
        setup.ground,
        swept,
        time,
    )
    farther, view = view.closer(min(zoom, 1.0), point), view.closer(zoom, point)
    paths = {"max_depth": max_depth or DEFAULT_DEPTH, "rr_depth": ROULETTE_DEPTH}
    integrator = mi.load_dict({"type": "footprint_path", **paths})
    parts: dict[str, Any] = {**empty_scene(), "integrator": integrator, **shapes}
    lies = setup.edge == edge == "pinked"
    gap = 1e-3 * float(np.clip(placement.scale, 1, 4)) if lies else setup.gap
    paper = _Paper.under(cloth, radius, view) if setup.ground else _Paper.behind(gap, view)
    # 4. The light. Photographers take their lamps along when they walk around; the sun stays.
    if environment is not None:
        parts["environment"] = environment_dict(environment, environment_turn)
    else:
        kind = "studio" if light is None else light
        if light_from is None:
            light_from = setup.light_from if kind == "sunsky" else setup.lamp(seen, view)
        towards = direction_of(*light_from)
        if not setup.ground:
            paper = paper.unless_before(towards)
        parts |= light_dicts(kind, centre, radius, towards, paper=not paper.is_there)
        if seen.chosen() or paper.stands_aside:
            integrator.background = paper.radiance(kind, towards)
    # 5. What stands around: paper below or behind, as far as a camera farther away sees, and the ball.
    distance = float(np.linalg.norm(farther.origin - centre)) * (_TO_HORIZON if seen.chosen() else 1)
    if setup.ground and paper.is_there:
        parts["ground"] = ground(centre, radius, float(cloth.positions[:, 1].min()), distance)
    if mesh is None and paper.is_there:
        parts["ball"] = ball(0.0 if setup.ground else paper.side * _UNSEEN)
    if not setup.ground and paper.is_there:
        parts["backdrop"] = backdrop(centre, radius, paper.side * -gap, distance)
    # 6. The scene, seen from as near as asked for.
    parts["sensor"] = perspective(view, size)
    return ClothScene(_loaded(parts), integrator, uv_size_mm, point, view, framed, dressed)


def _seen(
    settings: CameraSettings,
    name: str | os.PathLike[str],
    cloth: ClothMesh,
    parts: Sequence[MeshPart],
    setup: _Setup,
    size: tuple[int, int],
    metres_per_unit: float,
    over_floor: bool,
    swept: Swept | None = None,
    time: float | None = None,
) -> tuple[View, NDArray[np.float64], NDArray[np.float64] | None]:
    """The view at zoom 1, the point that zoom comes closer to, and what the camera frames; see `ClothScene`.

    Args:
        name: of the scene or of the mesh file, which has `parts`.
        over_floor: the picture shows a floor behind the cloth.
        swept, time: as `build_scene` takes them.

    Raises:
        InputError: no such part, or no such camera of the file.
    """
    if settings.camera is not None:
        view = view_of_file(file_camera(name, settings.camera, time), metres_per_unit, size)
        point = _facing_point(cloth, view)
        ahead = -float((point - view.origin) @ view.backward)
        if ahead > 0:
            view = replace(view, target=view.origin - ahead * view.backward)
        return view, point, None
    looked_at = cloth
    if settings.look_at is not None:
        part = _part_of(parts, settings.look_at, name)
        looked_at = _extended(part, [part], swept)
    points, towards = looked_at.positions, np.array(setup.towards_camera, float)
    view = chosen_view(settings, points, towards, size, over_floor)
    point = _facing_point(looked_at, view, settings.target)
    stands = settings.target is not None or settings.distance is not None
    return view, point, None if stands else points


def built_in_view(
    settings: CameraSettings,
    name: str,
    mesh: str | os.PathLike[str] | None,
    cloth: ClothMesh,
    size: tuple[int, int],
    metres_per_unit: float,
    unwrap: bool | None = None,
) -> tuple[View, NDArray[np.float64]]:
    """Where a camera sees `built_in_cloth` from, before nothing, and the direction to the light that it has.

    Raises:
        InputError: no such part or camera of the mesh.
    """
    setup = _SETUPS[name] if mesh is None else _MESH
    parts: list[MeshPart] = []
    if mesh is not None and settings.look_at is not None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", LoomlightWarning)  # which `built_in_cloth` has given
            parts = garment_parts(mesh, metres_per_unit, unwrap)
    view, _, _ = _seen(
        settings, name if mesh is None else mesh, cloth, parts, setup, size, metres_per_unit, False
    )
    return view, direction_of(*setup.lamp(settings, view))


def _part_of(parts: Sequence[MeshPart], part: str, name: str | os.PathLike[str]) -> ClothMesh:
    if not parts:
        raise InputError(f"look_at = {shown(part)} needs a mesh with parts, and the scene {name} has none.")
    chosen = [each.mesh for each in parts if part in each.names]
    if not chosen:
        known = list(dict.fromkeys(word for each in parts for word in each.names))
        advice = f"it has {_listed(known)}" if known else "its parts have no names"
        raise InputError(f"{name} has no part and no material {shown(part)} to look at: {advice}.")
    return joined([replace(each, uv=np.zeros((0, 2))) for each in chosen])


def default_size(mesh: str | os.PathLike[str] | None, camera: str | None) -> tuple[int, int]:
    """Width and height of a picture for which none are chosen, pixels: the shape that a file's camera has."""
    own = None if mesh is None or camera is None else size_of_file(file_camera(mesh, camera), DEFAULT_SIZE[0])
    return own or DEFAULT_SIZE


def file_camera(name: str | os.PathLike[str], camera: str, time: float | None = None) -> FileCamera:
    """The camera of this name of a mesh file, at a time as `build_scene` takes it.

    Raises:
        InputError: no mesh file, or one without this camera; one without perspective.
    """
    if str(name) in _SETUPS:
        raise InputError(f"camera = {shown(camera)} needs a mesh file with cameras, and {name} is none.")
    cameras = read_cameras(name, time)
    found = next((each for each in cameras if each.name == camera), None)
    if found is None:
        known = [each.name for each in cameras if each.name]
        advice = f"it has {_listed(known)}" if known else f"it has none{' with a name' if cameras else ''}"
        raise InputError(f"{name} has no camera {shown(camera)}: {advice}.")
    if found.orthographic:
        raise InputError(
            f"{name}: the camera {shown(camera)} is orthographic, and pixels of cloth need perspective: make "
            "it a perspective camera, or use --view with --focal-length 1000."
        )
    return found


def _listed(names: list[str]) -> str:
    """At most eight names."""
    more = f" and {len(names) - 8} others" if len(names) > 8 else ""
    return f"{', '.join(name[:40] for name in names[:8])}{more}"


def _backdrop_side(view: View) -> float:
    """-1 where a backdrop stands before the front of the cloth, for cameras behind it; else 1."""
    return -1.0 if view.backward[2] < -_EDGE_ON else 1.0


@dataclass(frozen=True)
class _Paper:
    """The sheet of paper that cloth stands on or lies on.

    Attributes:
        normal: unit vector towards the cloth.
        is_there: the camera stands on its upper side; it is left out of pictures from below.
        stands_aside: it is left out too, as it would stand before the light.
    """

    normal: NDArray[np.float64]
    is_there: bool
    stands_aside: bool = False

    @classmethod
    def under(cls, cloth: ClothMesh, radius: float, view: View) -> _Paper:
        """A floor."""
        return cls(
            np.array([0.0, 1.0, 0.0]), bool(view.origin[1] > cloth.positions[:, 1].min() - 1e-3 * radius)
        )

    @classmethod
    def behind(cls, gap: float, view: View) -> _Paper:
        """A backdrop so many metres from the plane z = 0, on the far side of the cloth."""
        side = _backdrop_side(view)
        return cls(np.array([0.0, 0.0, side]), bool(side * view.origin[2] > -gap))

    def unless_before(self, towards: NDArray[np.float64]) -> _Paper:
        """A backdrop, which stands aside where light from that direction comes through the cloth."""
        is_before = bool(towards @ self.normal < 0)
        return replace(self, is_there=self.is_there and not is_before, stands_aside=is_before)

    @property
    def side(self) -> float:
        """Of a backdrop; see `_backdrop_side`."""
        return float(self.normal[2])

    def radiance(self, light: str, towards: NDArray[np.float64]) -> float | None:
        """Of what is seen past the paper's horizon: the paper goes on; None where the light has a sky.

        Where it stands aside, the studio is as dark all around as its dome is at the horizon.
        """
        if light == "studio" and self.stands_aside:
            horizon = studio_radiance(towards)
            return float(np.median(horizon[horizon.shape[0] // 2 - 1]))
        if light == "studio":
            return paper_radiance(studio_radiance(towards, paper=not self.is_there), self.normal)
        if light == "directional":
            return PAPER * max(float(towards @ self.normal), 0.0)
        return None


def _dressed(
    worn: Garment[BsdfFactory], placement: Placement, edge: str
) -> tuple[Dressed, list[Any], tuple[float, float]]:
    """The cloth, BSDFs of its pieces, and millimetres per unit of u and of v of the first."""
    laid = [
        (*placed(piece, placement.changed(turn=placement.turn + turn)), own)
        for (piece, own), turn in zip(worn.pieces, worn.turns, strict=True)
    ]
    bsdfs = [loaded_bsdf(own(millimetres)) for _, millimetres, own in laid]
    meshes = [piece for piece, _, _ in laid]
    names = [f"{CLOTH_NAME}{number or ''}" for number in range(len(laid))]
    thickness = [_thickness(bsdf) for bsdf in bsdfs]
    if worn.uncovered is not None:
        meshes.append(replace(worn.uncovered, uv=np.zeros((len(worn.uncovered.positions), 2))))
        names, bsdfs, thickness = [*names, UNCOVERED_NAME], [*bsdfs, _UNCOVERED], [*thickness, 0]
    edges = Edges.of(meshes, edge, thickness, placement.scale)
    return Dressed(dict(zip(names, meshes, strict=True)), edges), bsdfs, laid[0][1]


def _upright(cloth: ClothMesh) -> ClothMesh:
    """A built-in piece, on whose uv, which run upwards, pictures stand upright."""
    return replace(cloth, attributes={FILE_UV: cloth.uv * [1, -1] + [0, 1]})


def _pictures(mesh: ClothMesh, bsdf: Any, whole: list[ClothMesh]) -> dict[str, NDArray[np.float64]]:
    """Attributes by name that say where the maps of its cloth lie on a mesh."""
    places = () if bsdf is _UNCOVERED else surface_bsdf(bsdf).picture_places
    return {
        attribute_name(number): picture_uv(mesh, place, whole)
        for number, place in enumerate(places)
        if not place.is_on_cloth
    }


def _extended(mesh: ClothMesh, moving: Sequence[ClothMesh], swept: Swept | None) -> ClothMesh:
    """The mesh with further vertices where what moves will be."""
    if swept is None:
        return mesh
    return replace(mesh, positions=np.concatenate([mesh.positions, swept(moving)]))


def _thickness(bsdf: Any) -> float:
    """Metres of a cloth."""
    source = surface_bsdf(bsdf).source
    return cloth_facts(source).thickness_mm / 1000 if isinstance(source, Fabric) else _THICKNESS


def _require_extent(name: str, radius: float) -> None:
    if not MIN_RADIUS <= radius <= MAX_RADIUS:
        raise InputError(
            f"{name} is {2 * radius:.3g} m across, and no cloth is: give the length of one of its "
            "units as metres_per_unit."
        )


def _require_values(
    zoom: float, size: tuple[int, int] | None, metres_per_unit: float, max_depth: int | None, edge: str | None
) -> None:
    require_zoom(zoom)
    if size is not None:
        require_size(size)
    if not metres_per_unit > 0:
        raise InputError(f"metres_per_unit = {metres_per_unit:g} is out of range: it is a length above 0.")
    if max_depth is not None and max_depth < 1:
        raise InputError(f"max_depth = {max_depth} is out of range: a path has at least 1 segment.")
    if edge not in (None, *EDGES):
        raise InputError(f'edge = "{edge}" is unknown: use {", ".join(EDGES)}.')


def built_in_cloth(
    name: str,
    mesh: str | os.PathLike[str] | None = None,
    metres_per_unit: float = 1.0,
    unwrap: bool | None = None,
) -> tuple[ClothMesh, NDArray[np.float64], NDArray[np.float64], bool]:
    """The cloth of a built-in scene, or a mesh instead, in metres; directions to its camera and its light;
    whether paper is below it.

    Args:
        metres_per_unit, unwrap: of the mesh; see `garment_parts`.

    Raises:
        InputError: an unknown scene, or a mesh that cannot be read.
    """
    if name not in _SETUPS:
        raise InputError(f'scene = "{name}" is unknown: use {", ".join(SCENES)}.')
    setup = _SETUPS[name] if mesh is None else _MESH
    if mesh is None:
        cloth = setup.cloth()
    else:
        parts = garment_parts(mesh, metres_per_unit, unwrap)
        cloth = joined([part.mesh for part in parts if len(part.mesh.uv)])
    return cloth, np.array(setup.towards_camera, float), direction_of(*setup.light_from), setup.ground


def empty_scene() -> dict[str, Any]:
    """The dictionary of a scene without anything in it, whose meshes have no cracks between their triangles.

    Embree's quick tests let a ray in some 100 000 slip through an edge: a black pixel in the midst of cloth.
    """
    # The property is Embree's, which traces on the CPU alone.
    robust = {} if str(mi.variant()).startswith("cuda") else {"embree_use_robust_intersections": True}
    return {"type": "scene", **robust}


def _always(bsdf: dict[str, Any]) -> BsdfFactory:
    return lambda _millimetres: bsdf


def loaded_bsdf(bsdf: mi.BSDF) -> Any:
    """A BSDF, made of its dictionary where it is one.

    Raises:
        InputError: a dictionary that makes no BSDF.
    """
    return _loaded(bsdf) if isinstance(bsdf, dict) else bsdf


def _loaded(parts: dict[str, Any]) -> Any:
    try:
        return mi.load_dict(parts)
    except RuntimeError as error:
        raise InputError(f"The scene cannot be built: {reason_of(error)}") from error


def _bounds(cloth: ClothMesh) -> tuple[NDArray[np.float64], float]:
    low, high = cloth.positions.min(axis=0), cloth.positions.max(axis=0)
    return (low + high) / 2, float(np.linalg.norm(high - low)) / 2


def _facing_point(
    cloth: ClothMesh, view: View, otherwise: tuple[float, float, float] | None = None
) -> NDArray[np.float64]:
    """Where the camera's axis meets the cloth first; otherwise a point, or the vertex nearest to the axis."""
    axis = view.target - view.origin
    axis /= np.linalg.norm(axis)
    a, b, c = (cloth.positions[cloth.triangles[:, corner]] for corner in range(3))
    normal = np.cross(b - a, c - a)
    slope = normal @ axis
    with np.errstate(divide="ignore", invalid="ignore"):
        along = np.sum(normal * (a - view.origin), axis=1) / slope
        hits = view.origin + along[:, None] * axis
        inside = along > 0
        for start, end in ((a, b), (b, c), (c, a)):
            inside &= np.sum(np.cross(end - start, hits - start) * normal, axis=1) >= 0
    if inside.any():
        return hits[np.argmin(np.where(inside, along, np.inf))]
    if otherwise is not None:
        return np.array(otherwise, float)
    offset = cloth.positions - view.origin
    away = np.linalg.norm(offset - (offset @ axis)[:, None] * axis, axis=1)
    return cloth.positions[np.argmin(away)]


def _from_file(
    file: Path,
    factories: Mapping[str, BsdfFactory],
    placements: Mapping[str, Placement],
    metres_per_unit: float,
    zoom: float,
    size: tuple[int, int] | None,
    max_depth: int | None,
) -> ClothScene:
    require_file(file)
    check_scene_meshes(file)
    try:
        # Optimised, BSDFs that look alike would be one, and the names of the others lost.
        scene = mi.load_file(str(file), optimize=False)
    except Exception as error:  # parsers and plugins raise what they do
        raise InputError(f"{file} cannot be loaded: {reason_of(error)}") from error
    shapes = [shape for shape in scene.shapes() if shape.bsdf() is not None]
    found = {shape.bsdf().id() for shape in shapes}
    for name in factories:
        if name not in found:
            raise InputError(f'{file} has no shape whose BSDF has the id "{name}"; give one that id.')
    if not scene.sensors():
        raise InputError(f"{file} has no sensor.")
    meshes, clothed = [], []
    uv_sizes = []
    for shape in shapes:
        if shape.bsdf().id() not in factories:
            continue
        if not shape.is_mesh():
            raise InputError(f"{file}: the shape {shape.id()} is no mesh; only meshes can be woven.")
        mesh = from_shape(shape, f"{file}: {shape.id()}").scaled(metres_per_unit)
        warn_of_scale(mesh)
        laid, uv_size_mm = placed(mesh, placements[shape.bsdf().id()])
        if laid is not mesh and not set_uv(shape, laid.uv):
            raise InputError(
                f"{file}: the uv of the shape {shape.id()} are fixed; make it an obj or ply mesh."
            )
        shape.set_bsdf(loaded_bsdf(factories[shape.bsdf().id()](uv_size_mm)))
        meshes.append(mesh)
        clothed.append(shape)
        uv_sizes.append(uv_size_mm)
    for shape, mesh in zip(clothed, meshes, strict=True):
        on_uv = replace(mesh, attributes={FILE_UV: mesh.uv})
        add_attributes(shape, _pictures(on_uv, shape.bsdf(), meshes))
    warn_of_extent(joined(meshes), metres_per_unit)
    point, view = _move_camera(scene, joined(meshes).scaled(1 / metres_per_unit), zoom, size)
    integrator = footprint_integrator(scene)
    if max_depth is not None:
        integrator.max_depth = max_depth
    return ClothScene(scene, integrator, uv_sizes[0], point, view)


def _move_camera(
    scene: mi.Scene, cloth: ClothMesh, zoom: float, size: tuple[int, int] | None
) -> tuple[NDArray[np.float64], View]:
    """Brings the first sensor closer along its own axis and gives its film another size."""
    params = mi.traverse(scene.sensors()[0])
    matrix = np.array(params["to_world"].matrix, dtype=np.float64).reshape(4, 4)
    origin = matrix[:3, 3]
    view = View(origin, origin + matrix[:3, 2])
    point = _facing_point(cloth, view)
    if zoom != 1:
        view = view.closer(zoom, point)
        matrix[:3, 3] = view.origin
        params["to_world"] = mi.Transform4f(matrix.tolist())
    if size is not None:
        params["film.size"] = list(size)
        params["film.crop_size"] = list(size)
    params.update()
    return point, view
