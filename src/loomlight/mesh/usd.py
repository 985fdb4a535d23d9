"""USD meshes by usd-core (extra `usd`): positions in metres and y up, composed, posed and skinned at a time.

A time code is the file's own clock; times are seconds from its start. At rest a file shows its first frame.
Names of parts are those of face subsets and of prims. uv follow `reading.py`: v, which runs up in USD, is
turned over.
"""

from __future__ import annotations

import re
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import (
    MAX_PARTS,
    MAX_TRIANGLES,
    ClothMesh,
    MeshPart,
    check_indices,
    distinct_rows,
    placed,
    triangulate,
    vertex_normals,
)
from loomlight.mesh.file_camera import FileCamera, rigid
from loomlight.mesh.frames import times_of_frames
from loomlight.mesh.subdivision import Polygons

Number = TypeVar("Number", np.float64, np.int64)
SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")
# Primvars that are uv by their name, the first that there is, before others of USD's own type for uv.
_UV_NAMES = ("st", "uv", "UVMap", "map1", "st0", "st_0", "Texture_uv")
_LIKE_UV = re.compile(r"(st|uv|map|tex)", re.IGNORECASE)
# Corners of a mesh that is subdivided, and of one that is subdivided twice after the first time.
_MAX_SUBDIVIDED = 100_000
# Point instancers may show others, which may show others.
_MAX_DEPTH = 8
_IN_SOURCES = re.compile(r"^.* in file \S+ : ", re.DOTALL)
# (x, y, z) with z up is (x, z, -y) with y up.
_Z_TO_Y = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
# Attributes that move what is shown, beside operations of transforms.
_MOVING = (
    "points", "visibility", "faceVertexCounts", "faceVertexIndices", "positions", "orientations", "scales",
    "protoIndices", "invisibleIds", "translations", "rotations", "blendShapeWeights",
)  # fmt: skip


def read_usd(file: Path, time: float | None = None) -> list[MeshPart]:
    """A part for each face subset of each mesh, and one for the faces that no subset names.

    Raises:
        InputError: a damaged file, one that shows no mesh, or one that names files outside its folder.
        MissingDependencyError: usd-core is not installed.
    """
    with _opened(file) as scene:
        return _Reader(scene, scene.time_code(time)).parts()


def usd_frames(file: Path) -> list[float]:
    """Seconds of each frame, by the file's frames a second; [] where no mesh moves.

    Raises:
        InputError: what `read_usd` raises, or too many frames.
    """
    with _opened(file) as scene:
        samples = scene.samples
        if len(samples) < 2:
            return []
        start, end = scene.code_range()
        stage = scene.stage
        rate = stage.GetTimeCodesPerSecond()
        per_second = rate if rate >= 10 else 24.0
        if stage.HasAuthoredMetadata("framesPerSecond"):
            per_second = stage.GetFramesPerSecond()
        return times_of_frames((end - start) / rate if rate > 0 else np.nan, per_second, file)


def usd_cameras(file: Path, time: float | None = None) -> list[FileCamera]:
    """The cameras of a file, in its order.

    Raises:
        InputError: what `read_usd` raises, or a camera whose numbers make no picture.
    """
    with _opened(file) as scene:
        from pxr import UsdGeom

        code = scene.time_code(time)
        return [_camera(scene, prim, code) for prim in scene.prims() if prim.IsA(UsdGeom.Camera)]


# ----------------------------------------------------------------------------------------------------- stages
# Stages: opened without a word on the terminal, of files in one folder alone; their clock and their frame.


@dataclass(eq=False)
class _Scene:
    """An opened stage.

    Attributes:
        to_metres: [4, 4], from the stage's space to metres with y up.
        missing: assets that it names and that are not there.
    """

    file: Path
    stage: Any
    to_metres: NDArray[np.float64]
    missing: list[str]
    _samples: list[float] | None = None

    def damaged(self, what: str) -> InputError:
        """The error that says what is wrong with the file."""
        return InputError(f"{self.file} is damaged: {what}; export it anew.")

    def rows(self, attribute: Any, code: Any, width: int) -> NDArray[np.float64]:
        """The value [n, width] of an attribute; [0, width] where it has none."""
        return self._numbers(attribute.GetPath(), attribute.Get(code), np.float64, width)

    def whole(self, attribute: Any, code: Any) -> NDArray[np.int64]:
        """The whole numbers [n] of an attribute or of the indices of a primvar; [0] where it has none."""
        return self._numbers(attribute.GetPath(), attribute.Get(code), np.int64, 1)[:, 0]

    def _numbers(self, name: object, value: Any, kind: type[Number], width: int) -> NDArray[Number]:
        try:
            count = 0 if value is None else len(value)
            found = np.array(value, dtype=kind).reshape(count, -1) if count else np.zeros((0, width), kind)
        except (TypeError, ValueError, OverflowError) as error:
            if "to_python" in str(error):
                raise
            raise self.damaged(f'"{name}" is no list of numbers') from error
        if found.shape[1] < width:
            raise self.damaged(f'"{name}" has {found.shape[1]} numbers a row, and {width} are needed')
        return found[:, :width]

    def prims(self) -> Iterable[Any]:
        """Active and loaded prims, those of instances included."""
        from pxr import Usd

        return Usd.PrimRange.Stage(self.stage, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate))

    @property
    def samples(self) -> list[float]:
        """Time codes at which something that is shown has a value, of what has several."""
        if self._samples is None:
            self._samples = _samples(self)
        return self._samples

    @property
    def _states_range(self) -> bool:
        stage = self.stage
        return bool(stage.HasAuthoredTimeCodeRange() and stage.GetStartTimeCode() < stage.GetEndTimeCode())

    def code_range(self) -> tuple[float, float]:
        """First and last time code: those that the file states, else those of its samples."""
        if self._states_range:
            return self.stage.GetStartTimeCode(), self.stage.GetEndTimeCode()
        return (self.samples[0], self.samples[-1]) if self.samples else (0.0, 0.0)

    def time_code(self, time: float | None) -> Any:
        """The time code of `time` seconds after the start; of None that of rest."""
        from pxr import Usd

        if time is None:
            if self._states_range:
                return Usd.TimeCode(self.stage.GetStartTimeCode())
            return Usd.TimeCode.EarliestTime()
        start, _ = self.code_range()
        return Usd.TimeCode(start + time * self.stage.GetTimeCodesPerSecond())


@contextmanager
def _opened(file: Path) -> Iterator[_Scene]:
    """The stage of a file, without USD's own messages on the terminal."""
    from pxr import Sdf, Tf, Usd, UsdGeom, UsdUtils

    silencer = UsdUtils.CoalescingDiagnosticDelegate()
    try:
        root = Sdf.Layer.FindOrOpen(str(file.resolve()))
        if root is None:
            raise InputError(f"{file} is damaged or no USD file.")
        missing = _check_assets(root, file)
        stage = Usd.Stage.Open(root)
        _check_layers(stage, file)
        unit = UsdGeom.GetStageMetersPerUnit(stage)
        if not 1e-9 <= unit <= 1e9:
            raise InputError(f'{file}: its "metersPerUnit" is {unit:g}: it should be 1e-9 to 1e9.')
        to_metres = np.diag([unit, unit, unit, 1.0])
        if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z:
            to_metres = to_metres @ _Z_TO_Y
        yield _Scene(file, stage, to_metres, missing)
        _check_layers(stage, file)  # those of value clips, which are opened when they are read
    except UnicodeDecodeError as error:  # of a name or a token
        raise InputError(f"{file} is damaged: it holds text that is not UTF-8.") from error
    except Tf.ErrorException as error:
        raise InputError(f"{file} is damaged or no USD file ({_reason(error, file)}).") from error
    except TypeError as error:
        if "to_python" not in str(error):
            raise
        raise InputError(f"{file} is damaged: an attribute is of a type that nobody knows.") from error
    finally:
        del silencer


def _reason(error: Exception, file: Path) -> str:
    """What USD says of an error, without the places in its own sources."""
    try:
        said = _IN_SOURCES.sub("", str(error)).replace("pxrInternal", " pxrInternal")
    except UnicodeDecodeError:  # it repeats bytes of the file
        return "it holds text that is not UTF-8"
    said = said.replace(f"{file.resolve()}:", "line ")
    return " ".join(word for word in said.split() if not word.startswith("pxrInternal")).strip("'")[:120]


def _check_assets(root: Any, file: Path) -> list[str]:
    """Names of missing layers that a file is composed of; those outside its folder are refused."""
    from pxr import Ar, Sdf

    folder = file.resolve().parent
    missing: dict[str, None] = {}
    waiting, seen = [root], {root.identifier}
    while waiting:
        layer = waiting.pop()
        for name in layer.GetCompositionAssetDependencies():
            if not name:
                continue
            shown = " ".join(name[:80].split())
            if "://" in name:
                raise InputError(f'{file} names "{shown}", and nothing is fetched: export one file.')
            path = layer.ComputeAbsolutePath(Sdf.Layer.SplitIdentifier(name)[0])
            outer = Ar.SplitPackageRelativePathOuter(path)[0] if Ar.IsPackageRelativePath(path) else path
            try:
                lies_within = (folder / outer).resolve().is_relative_to(folder)
                is_there = (folder / outer).is_file()
            except (OSError, ValueError):  # too long a name, a NUL
                lies_within, is_there = True, False
            if not lies_within:
                raise _outside(file, shown)
            found = Sdf.Layer.FindOrOpen(path) if is_there else None
            if found is None:
                missing[shown] = None
            elif found.identifier not in seen:
                seen.add(found.identifier)
                waiting.append(found)
    return list(missing)


def _check_layers(stage: Any, file: Path) -> None:
    """Refuses a stage that is composed of layers outside the file's folder."""
    folder = file.resolve().parent
    for layer in stage.GetUsedLayers():
        path = layer.realPath.partition("[")[0]
        if path and not Path(path).resolve().is_relative_to(folder):
            raise _outside(file, " ".join(path[-80:].split()))


def _outside(file: Path, shown: str) -> InputError:
    return InputError(
        f'{file} names the file "{shown}", which lies outside its folder {file.parent}: put it beside the '
        "mesh, or flatten the stage into one file."
    )


def _samples(scene: _Scene) -> list[float]:
    from pxr import UsdGeom, UsdSkel

    codes: set[float] = set()
    seen = set()
    for prim in scene.prims():
        if (
            not prim.IsA(UsdGeom.Mesh)
            and not prim.IsA(UsdGeom.PointInstancer)
            and not prim.IsA(UsdSkel.Animation)
        ):
            continue
        while prim and prim.GetPath() not in seen:
            seen.add(prim.GetPath())
            for attribute in prim.GetAuthoredAttributes():
                name = attribute.GetName()
                if (name in _MOVING or name.startswith("xformOp:")) and attribute.ValueMightBeTimeVarying():
                    codes.update(attribute.GetTimeSamples())
            prim = prim.GetParent()
    return sorted(codes)


# ----------------------------------------------------------------------------------------------------- meshes
# Meshes as their prims hold them, and where they are shown.


@dataclass(frozen=True, eq=False)
class _Piece:
    """Faces of a mesh that are a part: those of a subset, or those that no subset names.

    Attributes:
        subset: the name of its prim below the mesh; "" of the faces that no subset names.
    """

    subset: str
    mesh: ClothMesh


@dataclass(frozen=True, eq=False)
class _Skin:
    """What moves the points of a mesh.

    Attributes:
        mesh: the query of what it hangs on.
        skeleton: the query of joints, which instances share.
        prim: the skeleton, where this instance of it stands.
    """

    mesh: Any
    skeleton: Any
    prim: Any


@dataclass(eq=False)
class _Reader:
    """What a scene shows at a time code."""

    scene: _Scene
    code: Any
    _shapes: dict[str, list[_Piece]] = field(default_factory=dict)
    _skins: dict[str, _Skin] = field(default_factory=dict)

    def parts(self) -> list[MeshPart]:
        from pxr import UsdGeom

        scene = self.scene
        self._places = UsdGeom.XformCache(self.code)
        self._rest = scene.time_code(None)
        self._find_skins()
        made: list[MeshPart] = []
        total = 0
        for prim, matrix in self._shown(scene.stage.GetPseudoRoot(), 0):
            pieces = self._pieces(prim)
            total += sum(len(piece.mesh.triangles) for piece in pieces)
            if total > MAX_TRIANGLES:
                raise InputError(
                    f"{scene.file} shows more than {MAX_TRIANGLES} triangles, copies included: export fewer."
                )
            if len(made) + len(pieces) > MAX_PARTS:
                raise InputError(
                    f"{scene.file} shows more than {MAX_PARTS} parts, copies included: join some."
                )
            made += [
                MeshPart(
                    piece.subset or prim.GetName(), _material(prim, piece.subset), placed(piece.mesh, matrix)
                )
                for piece in pieces
            ]
        if scene.missing:
            names_missing = ", ".join(f'"{name}"' for name in scene.missing[:3])
            more = " and others" if len(scene.missing) > 3 else ""
            sentence = (
                f"{scene.file} names {names_missing}{more}, which cannot be read in {scene.file.parent}"
            )
            if not made:
                raise InputError(
                    f"{sentence}, and holds no mesh itself: copy them there, or export one file."
                )
            warnings.warn(f"{sentence}: what they hold is left out.", LoomlightWarning, stacklevel=4)
        if not made:
            raise InputError(f"{scene.file} holds no triangles: {self._why_nothing()}.")
        return made

    def _why_nothing(self) -> str:
        from pxr import UsdGeom

        kinds = Counter(prim.GetTypeName() for prim in self.scene.prims() if prim.IsA(UsdGeom.Gprim))
        if kinds["Mesh"]:
            return "its meshes are hidden, empty, or no more than guides"
        if kinds:
            return f"it shows {', '.join(sorted(kinds)[:4])} alone, and meshes are read"
        return "it shows no mesh"

    def _shown(self, root: Any, depth: int) -> Iterator[tuple[Any, NDArray[np.float64]]]:
        """Visible meshes below a prim, that prim included, and the matrix of each, in metres."""
        from pxr import Usd, UsdGeom

        # Prototypes of point instancers may be classes, which stand for nothing by themselves.
        kinds = (
            Usd.PrimDefaultPredicate
            if depth == 0
            else Usd.PrimIsActive & Usd.PrimIsLoaded & Usd.PrimIsDefined
        )
        walk = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies(kinds)))
        for prim in walk:
            if prim.IsA(UsdGeom.PointInstancer):
                walk.PruneChildren()
                if self._is_visible(prim):
                    yield from self._instances(prim, depth)
            elif prim.IsA(UsdGeom.Mesh) and self._is_visible(prim):
                yield prim, self.scene.to_metres @ self._matrix(self._place_of(prim), prim)

    def _is_visible(self, prim: Any) -> bool:
        from pxr import UsdGeom

        image = UsdGeom.Imageable(prim)
        return image.ComputeVisibility(self.code) != UsdGeom.Tokens.invisible and image.ComputePurpose() in (
            UsdGeom.Tokens.default_,
            UsdGeom.Tokens.render,
        )

    def _place_of(self, prim: Any) -> Any:
        """The matrix of a prim; a skinned mesh stands where its skeleton does."""
        skin = self._skins.get(str(prim.GetPath()))
        if skin is not None and skin.mesh.HasJointInfluences():
            prim = skin.prim
        return self._places.GetLocalToWorldTransform(prim)

    def _matrix(self, found: Any, prim: Any) -> NDArray[np.float64]:
        """A matrix of USD's, of rows, as one of columns."""
        matrix = np.array(found, dtype=np.float64).T
        if not np.isfinite(matrix).all():
            raise self.scene.damaged(f'a number of the transform of "{prim.GetPath()}" is not finite')
        return matrix

    def _instances(self, prim: Any, depth: int) -> Iterator[tuple[Any, NDArray[np.float64]]]:
        from pxr import UsdGeom

        scene, instancer = self.scene, UsdGeom.PointInstancer(prim)
        if depth >= _MAX_DEPTH:
            raise InputError(f"{scene.file} has point instancers more than {_MAX_DEPTH} deep in each other.")
        targets = instancer.GetPrototypesRel().GetForwardedTargets()
        chosen = scene.whole(instancer.GetProtoIndicesAttr(), self.code)
        if len(chosen) and not 0 <= chosen.min() <= chosen.max() < len(targets):
            raise scene.damaged(f'"{prim.GetPath()}" names prototype {chosen.max()} of {len(targets)}')
        mask = np.array(instancer.ComputeMaskAtTime(self.code), dtype=bool)
        matrices = np.array(
            instancer.ComputeInstanceTransformsAtTime(
                self.code, self.code, instancer.IncludeProtoXform, instancer.IgnoreMask
            ),
            dtype=np.float64,
        ).reshape(-1, 4, 4)
        if len(matrices) != len(chosen):
            raise scene.damaged(f'the lists of "{prim.GetPath()}" differ in length')
        if len(mask) == len(chosen):
            chosen, matrices = chosen[mask], matrices[mask]
        above = scene.to_metres @ self._matrix(self._places.GetLocalToWorldTransform(prim), prim)
        back = np.linalg.inv(scene.to_metres)
        for number in np.unique(chosen):
            prototype = scene.stage.GetPrimAtPath(targets[number])
            if not prototype:
                raise scene.damaged(f'"{prim.GetPath()}" names "{targets[number]}", which is not there')
            world = self._matrix(self._places.GetLocalToWorldTransform(prototype), prototype)
            if abs(np.linalg.det(world[:3, :3])) < 1e-30:
                continue  # a prototype without a size
            # Without its own transform, which is part of those of the instances.
            own = np.linalg.inv(world) @ back
            for mesh, matrix in list(self._shown(prototype, depth + 1)):
                for instance in matrices[chosen == number]:
                    yield mesh, above @ self._matrix(instance, prim) @ own @ matrix

    def _pieces(self, prim: Any) -> list[_Piece]:
        source = prim.GetPrimInPrototype() if prim.IsInstanceProxy() else prim
        key = str(source.GetPath())
        if str(prim.GetPath()) in self._skins:
            key = str(prim.GetPath())
        if key not in self._shapes:
            self._shapes[key] = self._made(prim)
        return self._shapes[key]

    def _made(self, prim: Any) -> list[_Piece]:
        """The pieces of a mesh in its own space."""
        from pxr import UsdGeom

        scene, mesh = self.scene, UsdGeom.Mesh(prim)
        points = self._points(mesh, self.code)
        counts = scene.whole(mesh.GetFaceVertexCountsAttr(), self.code)
        corners = scene.whole(mesh.GetFaceVertexIndicesAttr(), self.code)
        if not len(points) or not len(corners):
            return []
        name = f'the mesh "{prim.GetPath()}"'
        if (counts < 0).any() or counts.sum() != len(corners):
            raise scene.damaged(
                f"the faces of {name} have {counts.sum()} corners, and {len(corners)} are listed"
            )
        check_indices(corners, len(points), f"{scene.file}, {name},")
        face = np.repeat(np.arange(len(counts)), counts)
        values = _Values(scene, corners, face, len(counts), len(points), self.code, self._rest)
        uv, others = _coordinates(mesh, values)
        normals = None if str(prim.GetPath()) in self._skins else _normals(mesh, values)
        # How faces are cut, and which corners are a vertex, is decided at rest: frames must not differ in it.
        rest = self._points(mesh, self._rest)
        rest = rest if len(rest) == len(points) else points
        origin = np.arange(len(counts))
        if levels := self._levels(mesh, counts, normals):
            polygons = Polygons(corners, counts, len(points), *self._creases(mesh))
            normals = None
            for _ in range(levels):
                points, rest = polygons.moved(points), polygons.moved(rest)
                uv = None if uv is None else uv.finer(polygons)
                others = {name: each.finer(polygons) for name, each in others.items()}
                origin = origin[polygons.face]
                polygons = polygons.finer()
            corners, counts = polygons.corners, polygons.counts
        cut = triangulate(rest, corners, counts)
        face = origin[np.repeat(np.arange(len(counts)), counts)[cut[:, 0]]]
        solid = ~np.isin(face, scene.whole(mesh.GetHoleIndicesAttr(), self.code))
        cut, face = cut[solid], face[solid]
        if mesh.GetOrientationAttr().Get(self.code) == UsdGeom.Tokens.leftHanded:
            cut = cut[:, ::-1]
        smooth = vertex_normals(points, corners[cut]) if normals is None else None
        columns = {id(each): each.row for each in (uv, normals, *others.values()) if each is not None}
        keys = np.stack([corners, *columns.values()], axis=1)
        pieces = []
        for subset, chosen in self._subsets(mesh, values.faces, face):
            used = cut[chosen].ravel()
            at, inverse = distinct_rows(keys[used])
            corner = used[at]
            vertex = corners[corner]
            if smooth is not None:
                own = smooth[vertex]
            elif normals is not None:
                own = normals.at(corner)
            pieces.append(
                _Piece(
                    subset,
                    ClothMesh(
                        positions=points[vertex],
                        normals=own,
                        uv=uv.at(corner) if uv is not None else np.zeros((0, 2)),
                        triangles=inverse.reshape(-1, 3),
                        name=str(scene.file),
                        attributes={name: each.at(corner) for name, each in others.items()},
                    ),
                )
            )
        return pieces

    def _levels(self, mesh: Any, counts: NDArray[np.int64], normals: _OfCorners | None) -> int:
        """How often a mesh is subdivided: twice where it is coarse.

        Programs write triangles of simulations, and polygons with normals, as USD's default scheme too, which
        was never meant.
        """
        from pxr import UsdGeom

        attribute = mesh.GetSubdivisionSchemeAttr()
        scheme = attribute.Get() if attribute.HasAuthoredValue() else UsdGeom.Tokens.none
        if scheme == UsdGeom.Tokens.loop:
            warnings.warn(
                f'{self.scene.file}: of "{mesh.GetPath()}", a surface of the scheme "loop", the control mesh '
                "is shown: subdivide it before it is exported.",
                LoomlightWarning,
                stacklevel=2,
            )
        if scheme != UsdGeom.Tokens.catmullClark or normals is not None:
            return 0
        if counts.min() < 3 or (counts == 3).mean() > 0.5:
            return 0
        return 2 if 4 * counts.sum() <= _MAX_SUBDIVIDED else int(counts.sum() <= _MAX_SUBDIVIDED)

    def _creases(self, mesh: Any) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
        """Both vertices of each sharp edge, and for how many levels it is sharp."""
        scene = self.scene
        index = scene.whole(mesh.GetCreaseIndicesAttr(), self.code)
        lengths = scene.whole(mesh.GetCreaseLengthsAttr(), self.code)
        sharpness = scene.rows(mesh.GetCreaseSharpnessesAttr(), self.code, 1)[:, 0]
        last = np.cumsum(lengths) - 1
        if (lengths < 2).any() or lengths.sum() != len(index):
            raise scene.damaged(f'the creases of "{mesh.GetPath()}" do not fit their lengths')
        begins = ~np.isin(np.arange(len(index)), last)
        edges = np.stack([index[begins], index[np.flatnonzero(begins) + 1]], axis=1)
        if len(sharpness) == len(lengths):
            sharpness = np.repeat(sharpness, lengths - 1)
        if len(sharpness) != len(edges) or (index < 0).any():
            raise scene.damaged(f'the creases of "{mesh.GetPath()}" do not fit their sharpnesses')
        return edges, sharpness

    def _points(self, mesh: Any, code: Any) -> NDArray[np.float64]:
        points = self.scene.rows(mesh.GetPointsAttr(), code, 3)
        skin = self._skins.get(str(mesh.GetPath()))
        return points if skin is None or not len(points) else _skinned(self.scene, points, skin, code)

    def _subsets(
        self, mesh: Any, faces: int, face: NDArray[np.int64]
    ) -> Iterator[tuple[str, NDArray[np.bool_]]]:
        """Names of face subsets and which triangles each has; last those that none has."""
        from pxr import UsdGeom

        free = np.ones(faces, bool)
        subsets = [
            s for s in UsdGeom.Subset.GetAllGeomSubsets(mesh) if s.GetElementTypeAttr().Get() == "face"
        ]
        # Subsets of materials go before others, which may overlap them.
        for subset in sorted(subsets, key=lambda s: s.GetFamilyNameAttr().Get() != "materialBind"):
            index = self.scene.whole(subset.GetIndicesAttr(), self.code)
            if len(index) and not 0 <= index.min() <= index.max() < faces:
                raise self.scene.damaged(
                    f'the subset "{subset.GetPath()}" names face {index.max()} of {faces}'
                )
            own = np.zeros(faces, bool)
            own[index] = True
            own &= free
            free &= ~own
            if own[face].any():
                yield subset.GetPrim().GetName(), own[face]
        if free[face].any():
            yield "", free[face]

    def _find_skins(self) -> None:
        from pxr import Usd, UsdSkel

        predicate = Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)
        for prim in self.scene.prims():
            if not prim.IsA(UsdSkel.Root):
                continue
            cache, root = UsdSkel.Cache(), UsdSkel.Root(prim)
            cache.Populate(root, predicate)
            for binding in cache.ComputeSkelBindings(root, predicate):
                skeleton = cache.GetSkelQuery(binding.GetSkeleton())
                for target in binding.GetSkinningTargets():
                    if skeleton and (target.HasJointInfluences() or target.HasBlendShapes()):
                        self._skins[str(target.GetPrim().GetPath())] = _Skin(
                            target, skeleton, binding.GetSkeleton().GetPrim()
                        )


def _material(prim: Any, subset: str) -> str:
    """The name of the material that is bound to a mesh or to one of its subsets."""
    from pxr import UsdShade

    bound = prim.GetChild(subset) if subset else prim
    material, _ = UsdShade.MaterialBindingAPI(bound).ComputeBoundMaterial()
    return material.GetPrim().GetName() if material else ""


# --------------------------------------------------------------------------------------------------- primvars
# Numbers of corners, whichever way they are spread over a mesh.


@dataclass(frozen=True, eq=False)
class _OfCorners:
    """Numbers of a mesh's corners.

    Attributes:
        index: of each corner, its row of `values`.
        row: of each corner, a number that corners of the same numbers at rest share.
        rest: values at rest, and of each corner its row of these.
    """

    index: NDArray[np.int64]
    values: NDArray[np.float64]
    row: NDArray[np.int64]
    rest: tuple[NDArray[np.int64], NDArray[np.float64]]

    def at(self, corner: NDArray[np.int64]) -> NDArray[np.float64]:
        return self.values[self.index[corner]]

    def finer(self, polygons: Polygons) -> _OfCorners:
        """The numbers of the corners of the next level of a subdivision."""
        index, rest = self.rest
        fine = polygons.spread(rest[index])
        every = np.arange(len(fine))
        return _OfCorners(every, polygons.spread(self.values[self.index]), _equal(fine), (every, fine))


def _equal(rows: NDArray[np.float64]) -> NDArray[np.int64]:
    """Of each row, which of the distinct ones it is."""
    columns = [np.unique(column, return_inverse=True)[1] for column in rows.T]
    return distinct_rows(np.stack(columns, axis=1))[1]


@dataclass(frozen=True, eq=False)
class _Source:
    """An attribute whose values are spread over a mesh.

    Attributes:
        kind: its interpolation.
        primvar: that it is, which may have indices; None of the normals of a mesh.
    """

    attribute: Any
    kind: str
    primvar: Any = None


@dataclass(frozen=True, eq=False)
class _Values:
    """Spreads values over the corners of a mesh."""

    scene: _Scene
    corners: NDArray[np.int64]
    face: NDArray[np.int64]
    faces: int
    points: int
    code: Any
    rest: Any

    def spread(self, source: _Source, width: int) -> _OfCorners | None:
        """The numbers of a source; None where it has none.

        Raises:
            InputError: fewer values or indices than its interpolation takes, or an index out of range.
        """
        now = self._indexed(source, width, self.code)
        if now is None:
            return None
        index, values = now
        before = self._indexed(source, width, self.rest)
        fixed, rows = now if before is None or len(before[1]) != len(values) else before
        # Values may be listed once for each corner, though corners of neighbours have the same.
        row = _equal(rows)[fixed] if source.kind == "faceVarying" else index
        return _OfCorners(index, values, row, (fixed, rows))

    def _indexed(
        self, source: _Source, width: int, code: Any
    ) -> tuple[NDArray[np.int64], NDArray[np.float64]] | None:
        values = self.scene.rows(source.attribute, code, width)
        if not len(values):
            return None
        place, needed = {
            "vertex": (self.corners, self.points),
            "varying": (self.corners, self.points),
            "uniform": (self.face, self.faces),
            "faceVarying": (np.arange(len(self.corners)), len(self.corners)),
        }.get(source.kind, (np.zeros(len(self.corners), np.int64), 1))
        indices = None
        if source.primvar is not None and source.primvar.IsIndexed():
            indices = self.scene.whole(source.primvar.GetIndicesAttr(), code)
        count, name = len(values if indices is None else indices), source.attribute.GetPath()
        if count < needed:
            raise self.scene.damaged(f'"{name}" ({source.kind}) has {count} values, and {needed} are needed')
        if indices is not None:
            if not 0 <= indices.min() <= indices.max() < len(values):
                raise self.scene.damaged(f'"{name}" names value {indices.max()} of {len(values)}')
            place = indices[place]
        return place, values


def _coordinates(mesh: Any, values: _Values) -> tuple[_OfCorners | None, Mapping[str, _OfCorners]]:
    """uv of a mesh; its further primvars of two numbers by their name, and as "uv1", "uv2" … in order."""
    from pxr import UsdGeom

    spread: dict[str, _OfCorners] = {}
    likely: list[str] = []
    for primvar in UsdGeom.PrimvarsAPI(mesh).FindPrimvarsWithInheritance():
        name, kind = primvar.GetPrimvarName(), primvar.GetTypeName()
        is_uv = str(kind.role) == "TextureCoordinate"
        is_pair = is_uv or str(kind.cppTypeName).startswith("VtArray<GfVec2")
        if not is_pair or primvar.GetInterpolation() == UsdGeom.Tokens.constant:
            continue
        made = values.spread(_source_of(primvar), 2)
        if made is not None:
            at, rest = made.rest
            spread[name] = replace(made, values=_turned(made.values), rest=(at, _turned(rest)))
            likely += [name] if is_uv or _LIKE_UV.match(name) else []
    order = [name for name in dict.fromkeys([*_read_by_material(mesh), *_UV_NAMES]) if name in spread]
    order += [name for name in likely if name not in order]
    others = {f"uv{number}": spread[name] for number, name in enumerate(order[1:], 1)}
    others |= {name: each for name, each in spread.items() if name not in order[:1]}
    return (spread[order[0]] if order else None), others


def _read_by_material(mesh: Any) -> list[str]:
    """The primvars that the material of a mesh reads uv from, or that of its first subset."""
    from pxr import Usd, UsdGeom, UsdShade

    bound = [mesh.GetPrim(), *(subset.GetPrim() for subset in UsdGeom.Subset.GetAllGeomSubsets(mesh)[:1])]
    names = []
    for prim in bound:
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        for below in Usd.PrimRange(material.GetPrim()) if material else ():
            shader = UsdShade.Shader(below)
            if shader and shader.GetIdAttr().Get() == "UsdPrimvarReader_float2":
                given = shader.GetInput("varname")
                sources = given.GetValueProducingAttributes() if given else ()
                names += [str(source.Get()) for source in sources]
    return names


def _turned(uv: NDArray[np.float64]) -> NDArray[np.float64]:
    return uv * [1, -1] + [0, 1]


def _source_of(primvar: Any) -> _Source:
    return _Source(primvar.GetAttr(), primvar.GetInterpolation(), primvar)


def _normals(mesh: Any, values: _Values) -> _OfCorners | None:
    from pxr import UsdGeom

    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("normals")
    if primvar and primvar.HasValue():
        return values.spread(_source_of(primvar), 3)
    return values.spread(_Source(mesh.GetNormalsAttr(), mesh.GetNormalsInterpolation()), 3)


# --------------------------------------------------------------------------------------------------- skinning
# Points moved by blend shapes and by the joints of a skeleton.


def _skinned(scene: _Scene, points: NDArray[np.float64], hung: _Skin, code: Any) -> NDArray[np.float64]:
    """Points after blend shapes, and by linear blend skinning in the skeleton's space if it has joints."""
    from pxr import Vt

    skin, skeleton = hung.mesh, hung.skeleton
    prim = skin.GetPrim()
    if skin.HasBlendShapes():
        points = points + _blend_shapes(scene, points, skin, skeleton, code)
    if not skin.HasJointInfluences():
        return points
    found = skin.ComputeJointInfluences(code)
    matrices = skeleton.ComputeSkinningTransforms(code)
    mapper = skin.GetJointMapper()
    if matrices and mapper and not mapper.IsIdentity():
        matrices = mapper.RemapTransforms(matrices, Vt.Matrix4dArray())
    if not found or not matrices:
        raise scene.damaged(f'joints of "{prim.GetPath()}" or of its skeleton cannot be read')
    joints, weights = np.array(found[0], dtype=np.int64), np.array(found[1], dtype=np.float64)
    width = max(1, skin.GetNumInfluencesPerComponent())
    turns = np.array(matrices, dtype=np.float64).reshape(-1, 4, 4)
    if len(joints) != len(weights) or len(joints) % width or not np.isfinite(turns).all():
        raise scene.damaged(f'joints and weights of "{prim.GetPath()}" do not fit')
    if len(joints) and not 0 <= joints.min() <= joints.max() < len(turns):
        raise scene.damaged(f'a vertex of "{prim.GetPath()}" hangs on joint {joints.max()} of {len(turns)}')
    joints, weights = joints.reshape(-1, width), weights.reshape(-1, width)
    if len(joints) == 1:  # the whole mesh hangs on the same joints
        joints = np.broadcast_to(joints, (len(points), width))
        weights = np.broadcast_to(weights, (len(points), width))
    if len(joints) != len(points):
        raise scene.damaged(f'"{prim.GetPath()}" has {len(points)} points and joints for {len(joints)}')
    bound = np.array(skin.GetGeomBindTransform(code), dtype=np.float64)
    start = np.concatenate([points, np.ones((len(points), 1))], axis=1) @ bound
    total = weights.sum(axis=1, keepdims=True)
    weights = np.divide(weights, total, out=np.zeros(weights.shape), where=total != 0)
    moved = np.zeros((len(points), 3))
    for column in range(width):
        moved += weights[:, column, None] * np.einsum("ni,nij->nj", start, turns[joints[:, column]])[:, :3]
    return np.where(total != 0, moved, start[:, :3])


def _blend_shapes(
    scene: _Scene, points: NDArray[np.float64], skin: Any, skeleton: Any, code: Any
) -> NDArray[np.float64]:
    """Displacements of all points by the blend shapes that an animation weighs."""
    from pxr import UsdSkel

    moved = np.zeros_like(points)
    animation = skeleton.GetAnimQuery()
    given = animation.ComputeBlendShapeWeights(code) if animation else None
    mapper = skin.GetBlendShapeMapper()
    weights = mapper.Remap(given) if given and mapper else None
    if not weights:
        return moved
    shapes = UsdSkel.BlendShapeQuery(UsdSkel.BindingAPI(skin.GetPrim()))
    amounts, of_shape, of_sub = shapes.ComputeSubShapeWeights(weights)
    where, offsets = shapes.ComputeBlendShapePointIndices(), shapes.ComputeSubShapePointOffsets()
    for amount, shape, sub in zip(amounts, of_shape, of_sub, strict=True):
        fits = sub < len(offsets) and shape < len(where)
        rows = np.array(offsets[sub] if fits else [], dtype=np.float64).reshape(-1, 3)
        index = np.array(where[shape] if fits else [], dtype=np.int64)
        index = index if len(index) else np.arange(len(rows))
        if len(index) != len(rows) or (len(index) and not 0 <= index.min() <= index.max() < len(points)):
            raise scene.damaged(f'a blend shape of "{skin.GetPrim().GetPath()}" does not fit its points')
        np.add.at(moved, index, amount * rows)
    return moved


# ---------------------------------------------------------------------------------------------------- cameras


def _camera(scene: _Scene, prim: Any, code: Any) -> FileCamera:
    from pxr import Gf, UsdGeom

    camera = UsdGeom.Camera(prim).GetCamera(code)
    sizes = np.array([camera.focalLength, camera.horizontalAperture, camera.verticalAperture])
    matrix = (
        scene.to_metres
        @ np.array(UsdGeom.XformCache(code).GetLocalToWorldTransform(prim), dtype=np.float64).T
    )
    if not np.isfinite(matrix).all() or not (np.isfinite(sizes) & (sizes > 0)).all():
        raise InputError(
            f'{scene.file}: the camera "{prim.GetPath()}" has a focal length, an aperture or a transform '
            "that makes no picture: they should be finite, and lengths above 0."
        )
    return FileCamera(
        name=prim.GetName(),
        to_world=rigid(matrix),
        vertical=float(np.degrees(2 * np.arctan(sizes[2] / (2 * sizes[0])))),
        aspect=float(sizes[1] / sizes[2]),
        orthographic=camera.projection == Gf.Camera.Orthographic,
    )
