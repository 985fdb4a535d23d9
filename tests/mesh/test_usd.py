"""USD stages: units, transforms, primvars, subsets, instances, skeletons, times and cameras; damaged ones.

Covers: mesh/usd.py
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade, UsdSkel, UsdUtils, Vt

from examples.makers.daybed import FILE as EXAMPLE
from examples.makers.daybed import fill
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, cross_products
from loomlight.mesh.reading import frame_times, read_cameras, read_parts
from tests.mesh.test_gltf_data import gltf
from tests.mesh.test_subdivision import CUBE, FACES

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
UV = [(0, 0), (1, 0), (1, 1), (0, 1)]
DATA = os.environ.get("LOOMLIGHT_DATA")


def new_stage(file: Path, unit: float = 1.0, up: str = "Y") -> Usd.Stage:
    stage = Usd.Stage.CreateNew(str(file))
    UsdGeom.SetStageMetersPerUnit(stage, unit)
    UsdGeom.SetStageUpAxis(stage, up)
    return stage


def quad(stage: Usd.Stage, path: str = "/cloth", points: Any = CORNERS, with_uv: bool = True) -> UsdGeom.Mesh:
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(points)
    mesh.CreateFaceVertexCountsAttr([4])
    mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3])
    mesh.CreateSubdivisionSchemeAttr("none")
    if with_uv:
        primvar(mesh, "st", UV, "vertex")
    return mesh


def primvar(
    mesh: UsdGeom.Mesh, name: str, values: Any, kind: str, indices: Any = None, role: bool = True
) -> None:
    types = Sdf.ValueTypeNames
    made = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
        name, types.TexCoord2fArray if role else types.Float2Array, kind
    )
    made.Set(values)
    if indices is not None:
        made.SetIndices(Vt.IntArray(indices))


def written(folder: Path, make: Callable[[Usd.Stage], object], name: str = "mesh.usda", **of: Any) -> Path:
    stage = new_stage(folder / name, **of)
    make(stage)
    stage.GetRootLayer().Save()
    return folder / name


def mesh_of(file: Path, time: float | None = None) -> ClothMesh:
    (part,) = read_parts(file, time)
    return part.mesh


def extent(mesh: ClothMesh) -> tuple[np.ndarray, np.ndarray]:
    return mesh.positions.min(axis=0), mesh.positions.max(axis=0)


def by_corner(mesh: ClothMesh) -> dict[tuple[float, ...], tuple[float, ...]]:
    return {
        tuple(p): tuple(q)
        for p, q in zip(mesh.positions.round(6).tolist(), mesh.uv.round(6).tolist(), strict=True)
    }


@pytest.mark.parametrize("suffix", [".usd", ".usda", ".usdc", ".usdz"])
def test_a_quad_of_every_kind_of_file(tmp_path: Path, suffix: str) -> None:
    file = written(tmp_path, quad, "mesh.usdc" if suffix == ".usdz" else f"mesh{suffix}")
    if suffix == ".usdz":
        assert UsdUtils.CreateNewUsdzPackage(str(file), str(tmp_path / "mesh.usdz"))
        file = tmp_path / "mesh.usdz"
    (part,) = read_parts(file)
    assert (part.name, part.material) == ("cloth", "")
    np.testing.assert_allclose(cross_products(part.mesh), [[0, 0, 1]] * 2)
    assert by_corner(part.mesh) == {
        tuple(map(float, p)): (u, 1 - v) for p, (u, v) in zip(CORNERS, UV, strict=True)
    }
    np.testing.assert_allclose(part.mesh.normals, [[0, 0, 1]] * 4)
    assert frame_times(file) == []
    assert read_cameras(file) == []


def test_the_same_mesh_as_obj_and_gltf(tmp_path: Path) -> None:
    file = written(tmp_path, quad)
    down = np.array([(u, 1 - v) for u, v in UV], "<f4")
    arrays = {"POSITION": np.array(CORNERS, "<f4"), "TEXCOORD_0": down}
    gltf_mesh = mesh_of(gltf(tmp_path, {**arrays, "indices": np.array([0, 1, 2, 0, 2, 3], "<u2")}))
    rows = [*(f"v {x} {y} {z}" for x, y, z in CORNERS), *(f"vt {u} {v}" for u, v in UV), "f 1/1 2/2 3/3 4/4"]
    (tmp_path / "mesh.obj").write_text("\n".join(rows))
    usd, obj = mesh_of(file), mesh_of(tmp_path / "mesh.obj")
    for other in (obj, gltf_mesh):
        assert by_corner(usd) == by_corner(other)
        np.testing.assert_array_equal(usd.positions[usd.triangles], other.positions[other.triangles])
        np.testing.assert_allclose(usd.normals, other.normals)


def test_centimetres_with_z_up_become_metres_with_y_up(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        UsdGeom.Xform.Define(stage, "/world").AddTranslateOp().Set((0, 0, 100))
        quad(stage, "/world/cloth", [(0, 0, 0), (10, 0, 0), (10, 20, 0), (0, 20, 0)])

    low, high = extent(mesh := mesh_of(written(tmp_path, make, unit=0.01, up="Z")))
    np.testing.assert_allclose([low, high], [[0, 1, -0.2], [0.1, 1, 0]], atol=1e-7)
    np.testing.assert_allclose(mesh.normals, [[0, 1, 0]] * 4, atol=1e-7)


def test_transforms_are_composed_and_mirrors_keep_the_front(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        world = UsdGeom.Xform.Define(stage, "/world")
        world.AddTranslateOp().Set((5, 0, 0))
        mesh = quad(stage, "/world/cloth")
        mesh.AddRotateZOp().Set(90)
        mesh.AddScaleOp().Set((-2, 1, 1))

    mesh = mesh_of(written(tmp_path, make))
    # (1, 0, 0) is scaled to (-2, 0, 0), turned to (0, -2, 0) and moved to (5, -2, 0).
    low, high = extent(mesh)
    np.testing.assert_allclose([low, high], [[4, -2, 0], [5, 0, 0]], atol=1e-6)
    np.testing.assert_allclose(cross_products(mesh), [[0, 0, 2]] * 2, atol=1e-6)
    np.testing.assert_allclose(mesh.normals, [[0, 0, 1]] * 4, atol=1e-6)


def test_left_handed_faces_are_turned(tmp_path: Path) -> None:
    mesh = mesh_of(written(tmp_path, lambda stage: quad(stage).CreateOrientationAttr("leftHanded")))
    np.testing.assert_allclose(cross_products(mesh), [[0, 0, -1]] * 2)
    np.testing.assert_allclose(mesh.normals, [[0, 0, -1]] * 4)


def strip(stage: Usd.Stage, path: str = "/cloth") -> UsdGeom.Mesh:
    """Two quads side by side: points 0 1 2 below, 3 4 5 above."""
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr([(x, y, 0) for y in (0, 1) for x in (0, 1, 2)])
    mesh.CreateFaceVertexCountsAttr([4, 4])
    mesh.CreateFaceVertexIndicesAttr([0, 1, 4, 3, 1, 2, 5, 4])
    return mesh


# Of the second quad u goes on at 2, so that its corners are others than those of the first.
SEAM = [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (3, 0), (3, 1), (2, 1)]
NO_SEAM = [(0, 0), (1, 0), (1, 1), (0, 1), (1, 0), (2, 0), (2, 1), (1, 1)]


@pytest.mark.parametrize(("values", "vertices"), [(SEAM, 8), (NO_SEAM, 6)])
@pytest.mark.parametrize("indexed", [True, False])
def test_face_varying_uv_split_vertices_at_seams_alone(
    tmp_path: Path, values: Any, vertices: int, indexed: bool
) -> None:
    def make(stage: Usd.Stage) -> None:
        backwards = list(range(7, -1, -1)) if indexed else None
        primvar(strip(stage), "st", values[::-1] if indexed else values, "faceVarying", backwards)

    mesh = mesh_of(written(tmp_path, make))
    assert len(mesh.positions) == vertices
    corners = np.concatenate([mesh.positions[:, :2], mesh.uv], axis=1)
    expected = {
        (x, y, u, 1 - v)
        for (x, y), (u, v) in zip(
            [(0, 0), (1, 0), (1, 1), (0, 1), (1, 0), (2, 0), (2, 1), (1, 1)], values, strict=True
        )
    }
    assert {tuple(row) for row in corners.tolist()} == expected
    np.testing.assert_allclose(mesh.normals, np.tile([0, 0, 1], (vertices, 1)))  # smooth across the seam


def test_further_primvars_are_attributes(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = quad(stage)
        primvar(mesh, "print", [(0.25, 0.75)] * 4, "varying")
        primvar(mesh, "flow", [(3, 4)], "uniform", role=False)

    mesh = mesh_of(written(tmp_path, make))
    assert set(mesh.attributes) - {"index", "uv"} == {"uv1", "print", "flow"}
    for name, value in {"uv1": (0.25, 0.25), "print": (0.25, 0.25), "flow": (3, -3)}.items():
        np.testing.assert_allclose(mesh.attributes[name], [value] * 4)
    np.testing.assert_allclose(sorted(mesh.uv.tolist()), sorted([u, 1 - v] for u, v in UV))


def test_the_uv_that_the_material_reads_go_first(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = quad(stage)
        primvar(mesh, "panels", [(u / 2, v / 2) for u, v in UV], "vertex")
        material = UsdShade.Material.Define(stage, "/looks/wool")
        given = material.CreateInput("which", Sdf.ValueTypeNames.String)
        given.Set("panels")
        reader = UsdShade.Shader.Define(stage, "/looks/wool/reader")
        reader.CreateIdAttr("UsdPrimvarReader_float2")
        reader.CreateInput("varname", Sdf.ValueTypeNames.String).ConnectToSource(given)
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)

    mesh = mesh_of(written(tmp_path, make))
    assert mesh.uv[:, 0].max() == 0.5
    assert mesh.attributes["uv1"][:, 0].max() == 1


def test_any_texture_coordinates_serve_where_there_is_no_st(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        primvar(quad(stage, with_uv=False), "of_my_tool", UV, "vertex")

    assert by_corner(mesh_of(written(tmp_path, make)))[1.0, 0.0, 0.0] == (1, 1)


def test_normals_of_corners(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = strip(stage)
        mesh.CreateNormalsAttr([(0, 0, 2)] * 4 + [(0, 3, 0)] * 4)
        mesh.SetNormalsInterpolation("faceVarying")

    mesh = mesh_of(written(tmp_path, make))
    assert len(mesh.positions) == 8
    assert sorted(mesh.normals.tolist()) == [[0, 0, 1]] * 4 + [[0, 1, 0]] * 4


def test_subsets_are_parts_with_their_materials(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = strip(stage)
        for name, prim in (("wool", mesh.GetPrim()), ("silk", None)):
            material = UsdShade.Material.Define(stage, f"/looks/{name}")
            if prim is None:
                prim = UsdShade.MaterialBindingAPI(mesh).CreateMaterialBindSubset("cuff", [1]).GetPrim()
            UsdShade.MaterialBindingAPI.Apply(prim).Bind(material)

    cuff, rest = read_parts(written(tmp_path, make))
    assert [(part.name, part.material) for part in (cuff, rest)] == [("cuff", "silk"), ("cloth", "wool")]
    np.testing.assert_allclose(extent(cuff.mesh), [[1, 0, 0], [2, 1, 0]])
    np.testing.assert_allclose(extent(rest.mesh), [[0, 0, 0], [1, 1, 0]])


def box(stage: Usd.Stage, scheme: str | None = "catmullClark") -> UsdGeom.Mesh:
    """A cube from -1 to 1 of quads, whose uv run from 0 to 1 on each face."""
    mesh = UsdGeom.Mesh.Define(stage, "/box")
    mesh.CreatePointsAttr(CUBE)
    mesh.CreateFaceVertexCountsAttr([4] * 6)
    mesh.CreateFaceVertexIndicesAttr(FACES.ravel().tolist())
    primvar(mesh, "st", UV * 6, "faceVarying")
    if scheme is not None:
        mesh.CreateSubdivisionSchemeAttr(scheme)
    return mesh


def test_surfaces_of_catmull_clark_are_subdivided(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        UsdGeom.Subset.CreateGeomSubset(box(stage), "lid", "face", [1])

    lid, rest = read_parts(written(tmp_path, make))
    assert [len(part.mesh.triangles) for part in (lid, rest)] == [2 * 16, 5 * 2 * 16]
    # The surface nears a ball: 5/9 of the corners' √3 is 0.96, and faces come down from 1.
    radius = np.linalg.norm(rest.mesh.positions, axis=1)
    assert 0.8 < radius.min() <= radius.max() < 0.97
    np.testing.assert_allclose(np.unique(lid.mesh.uv.round(6)), [0, 0.25, 0.5, 0.75, 1])
    np.testing.assert_allclose(
        np.linalg.norm(np.cross(lid.mesh.normals, lid.mesh.positions), axis=1), 0, atol=0.2
    )


def test_creases_of_a_surface(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = box(stage)
        mesh.CreateCreaseIndicesAttr([4, 5, 7, 6, 4])
        mesh.CreateCreaseLengthsAttr([5])
        mesh.CreateCreaseSharpnessesAttr([10.0])

    low, high = extent(mesh_of(written(tmp_path, make)))
    assert high[2] == 1
    # The middle of a creased edge is (6 + 0.75 + 0.75) / 8 after the second level.
    assert high[0] == pytest.approx(0.9375)
    assert low[2] > -0.97


@pytest.mark.parametrize("scheme", [None, "none", "bilinear"])
def test_polygons_stay(tmp_path: Path, scheme: str | None) -> None:
    mesh = mesh_of(written(tmp_path, lambda stage: box(stage, scheme)))
    assert len(mesh.triangles) == 12
    np.testing.assert_allclose(np.abs(mesh.positions), np.ones_like(mesh.positions))


def test_of_loop_surfaces_the_control_mesh_is_said(tmp_path: Path) -> None:
    with pytest.warns(LoomlightWarning, match='"/box", a surface of the scheme "loop"'):
        read_parts(written(tmp_path, lambda stage: box(stage, "loop")))


def test_holes_are_left_out(tmp_path: Path) -> None:
    mesh = mesh_of(written(tmp_path, lambda stage: strip(stage).CreateHoleIndicesAttr([0])))
    np.testing.assert_allclose(extent(mesh), [[1, 0, 0], [2, 1, 0]])


def test_hidden_meshes_and_guides_are_left_out(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        UsdGeom.Xform.Define(stage, "/hidden").CreateVisibilityAttr("invisible")
        quad(stage, "/hidden/a")
        for name in ("guide", "proxy", "render"):
            quad(stage, f"/{name}").CreatePurposeAttr(name)
        quad(stage, "/off").GetPrim().SetActive(False)
        quad(stage, "/shown")

    assert [part.name for part in read_parts(written(tmp_path, make))] == ["render", "shown"]


def test_native_instances(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        stage.CreateClassPrim("/kind")
        quad(stage, "/kind/panel").AddTranslateOp().Set((0, 0, 1))
        for number in range(3):
            place = UsdGeom.Xform.Define(stage, f"/copy{number}")
            place.AddTranslateOp().Set((10 * number, 0, 0))
            place.GetPrim().GetReferences().AddInternalReference("/kind")
            place.GetPrim().SetInstanceable(True)

    parts = read_parts(written(tmp_path, make))
    assert [part.name for part in parts] == ["panel"] * 3
    np.testing.assert_allclose([extent(part.mesh)[0] for part in parts], [[0, 0, 1], [10, 0, 1], [20, 0, 1]])


def test_point_instances(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        UsdGeom.Xform.Define(stage, "/set").AddScaleOp().Set((2, 2, 2))
        many = UsdGeom.PointInstancer.Define(stage, "/set/many")
        quad(stage, "/set/many/kinds/button").AddTranslateOp().Set((0, 0, 1))
        quad(stage, "/set/many/kinds/bead")
        many.CreatePrototypesRel().SetTargets(["/set/many/kinds/button", "/set/many/kinds/bead"])
        many.CreatePositionsAttr([(0, 0, 0), (5, 0, 0), (0, 7, 0), (0, 0, 0)])
        many.CreateProtoIndicesAttr([0, 0, 1, 1])
        half = 0.5**0.5
        many.CreateOrientationsAttr([Gf.Quath(1), Gf.Quath(half, 0, 0, half), Gf.Quath(1), Gf.Quath(1)])
        many.CreateIdsAttr([7, 8, 9, 10])
        many.CreateInvisibleIdsAttr([10])

    parts = read_parts(written(tmp_path, make))
    assert [part.name for part in parts] == ["button", "button", "bead"]
    # The second is turned by 90° about z: x from -1 to 0. Half floats hold its turn to 1e-3.
    expected = [[(0, 0, 2), (2, 2, 2)], [(8, 0, 2), (10, 2, 2)], [(0, 14, 0), (2, 16, 0)]]
    np.testing.assert_allclose([extent(part.mesh) for part in parts], expected, atol=5e-3)


def test_points_that_move(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        stage.SetTimeCodesPerSecond(24)
        stage.SetStartTimeCode(101)
        stage.SetEndTimeCode(103)
        points = quad(stage).GetPointsAttr()
        points.Clear()
        for code in (101, 103):
            points.Set([(x, y, code - 101) for x, y, _ in CORNERS], code)

    file = written(tmp_path, make)
    assert frame_times(file) == pytest.approx([0, 1 / 24, 2 / 24])
    for time, height in ((None, 0), (0, 0), (1 / 24, 1), (2 / 24, 2), (9, 2)):
        np.testing.assert_allclose(mesh_of(file, time).positions[:, 2], [height] * 4, atol=1e-6)


def test_times_of_a_file_that_states_no_range(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        stage.SetTimeCodesPerSecond(1)
        move = UsdGeom.Xform.Define(stage, "/world").AddTranslateOp()
        for code in (2, 3):
            move.Set((code, 0, 0), code)
        quad(stage, "/world/cloth")

    file = written(tmp_path, make)
    assert frame_times(file) == pytest.approx(np.arange(25) / 24)
    np.testing.assert_allclose(extent(mesh_of(file))[0], [2, 0, 0])
    np.testing.assert_allclose(extent(mesh_of(file, 0.5))[0], [2.5, 0, 0])


def test_a_range_of_one_time_code_is_none(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        stage.SetStartTimeCode(0)
        stage.SetEndTimeCode(0)
        points = quad(stage).GetPointsAttr()
        for code in (1, 2, 3):
            points.Set([(x, y, code) for x, y, _ in CORNERS], code)

    file = written(tmp_path, make)
    assert frame_times(file) == pytest.approx([0, 1 / 24, 2 / 24])
    np.testing.assert_allclose(mesh_of(file).positions[:, 2], [1] * 4)


def test_frames_have_the_vertices_of_rest(tmp_path: Path) -> None:
    """Faces are cut alike, and corners are joined alike, whatever positions and normals do."""

    def make(stage: Usd.Stage) -> None:
        mesh = strip(stage)
        points = np.array(mesh.GetPointsAttr().Get(), dtype=float)
        mesh.SetNormalsInterpolation("faceVarying")
        for code, lift in ((0, 0.0), (1, 0.7)):
            moved = (
                points + np.array([0, 0, lift]) * (np.arange(6) % 2)[:, None] - [0, lift, 0] * (points > 1)
            )
            mesh.GetPointsAttr().Set(moved, code)
            mesh.CreateNormalsAttr().Set([(0, lift * (k % 3), 1) for k in range(8)], code)

    file = written(tmp_path, make)
    rest, later = mesh_of(file), mesh_of(file, frame_times(file)[-1])
    np.testing.assert_array_equal(rest.triangles, later.triangles)
    assert len(rest.positions) == len(later.positions) == 6


def skeleton(stage: Usd.Stage, animated: bool = True) -> UsdGeom.Mesh:
    """A quad whose upper points hang on a joint 1 above the other; it turns by 90° about z in a second."""
    UsdSkel.Root.Define(stage, "/body")
    mesh = quad(stage, "/body/cloth")
    bones = UsdSkel.Skeleton.Define(stage, "/body/bones")
    bones.AddTranslateOp().Set((3, 0, 0))
    up = Gf.Matrix4d().SetTranslate((0, 1, 0))
    bones.CreateJointsAttr(["hip", "hip/knee"])
    bones.CreateBindTransformsAttr([Gf.Matrix4d(1), up])
    bones.CreateRestTransformsAttr([Gf.Matrix4d(1), up])
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([bones.GetPath()])
    binding.CreateJointIndicesPrimvar(False, 1).Set([0, 0, 1, 1])
    binding.CreateJointWeightsPrimvar(False, 1).Set([1.0] * 4)
    if animated:
        stage.SetTimeCodesPerSecond(10)
        motion = UsdSkel.Animation.Define(stage, "/body/motion")
        motion.CreateJointsAttr(["hip", "hip/knee"])
        motion.CreateTranslationsAttr([(0, 0, 0), (0, 1, 0)])
        motion.CreateScalesAttr([(1, 1, 1)] * 2)
        half = 0.5**0.5
        motion.CreateRotationsAttr().Set([Gf.Quatf(1), Gf.Quatf(1)], 0)
        motion.GetRotationsAttr().Set([Gf.Quatf(1), Gf.Quatf(half, 0, 0, half)], 10)
        UsdSkel.BindingAPI.Apply(bones.GetPrim()).CreateAnimationSourceRel().SetTargets([motion.GetPath()])
    return mesh


def test_skinned_poses(tmp_path: Path) -> None:
    file = written(tmp_path, skeleton)
    assert frame_times(file) == pytest.approx(np.arange(11) / 10)
    np.testing.assert_allclose(extent(mesh_of(file)), [[3, 0, 0], [4, 1, 0]], atol=1e-6)
    # The upper corner (1, 1) is (1, 0) from its joint, which turns it to (0, 1): it comes to (3, 2).
    low, high = extent(mesh_of(file, 1.0))
    np.testing.assert_allclose([low, high], [[3, 0, 0], [4, 2, 0]], atol=1e-6)


def test_instances_of_a_skeleton_stand_apart(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        skeleton(stage)
        for number in range(2):
            place = UsdGeom.Xform.Define(stage, f"/copy{number}")
            place.AddTranslateOp().Set((100 * number, 0, 0))
            copied = stage.DefinePrim(f"/copy{number}/body")
            copied.GetReferences().AddInternalReference("/body")
            copied.SetInstanceable(True)
        stage.GetPrimAtPath("/body").SetSpecifier(Sdf.SpecifierClass)

    parts = read_parts(written(tmp_path, make), 1.0)
    np.testing.assert_allclose([extent(part.mesh)[0] for part in parts], [[3, 0, 0], [103, 0, 0]], atol=1e-6)


def test_a_skeleton_without_an_animation_rests(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        skeleton(stage, animated=False)
        knee = Gf.Matrix4d().SetTranslate((0, 1, 5))
        UsdSkel.Skeleton.Get(stage, "/body/bones").GetRestTransformsAttr().Set([Gf.Matrix4d(1), knee])

    file = written(tmp_path, make)
    assert frame_times(file) == []
    np.testing.assert_allclose(extent(mesh_of(file)), [[3, 0, 0], [4, 1, 5]], atol=1e-6)


@pytest.mark.parametrize("joints", [["hip/knee", "hip"], ["hip/knee", "of_another", "hip"]])
def test_joints_that_a_mesh_names_in_its_own_order(tmp_path: Path, joints: list[str]) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = skeleton(stage)
        binding = UsdSkel.BindingAPI(mesh)
        binding.CreateJointsAttr(joints)
        binding.GetJointIndicesPrimvar().Set([joints.index("hip")] * 2 + [joints.index("hip/knee")] * 2)

    low, high = extent(mesh_of(written(tmp_path, make), 1.0))
    np.testing.assert_allclose([low, high], [[3, 0, 0], [4, 2, 0]], atol=1e-6)


def test_blend_shapes(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        mesh = skeleton(stage)
        shape = UsdSkel.BlendShape.Define(stage, "/body/cloth/wind")
        shape.CreateOffsetsAttr([(0, 0, 2)])
        shape.CreatePointIndicesAttr([1])
        binding = UsdSkel.BindingAPI(mesh)
        binding.CreateBlendShapesAttr(["wind"])
        binding.CreateBlendShapeTargetsRel().SetTargets([shape.GetPath()])
        motion = UsdSkel.Animation.Get(stage, "/body/motion")
        motion.CreateBlendShapesAttr(["wind"])
        motion.CreateBlendShapeWeightsAttr().Set([0.0], 0)
        motion.GetBlendShapeWeightsAttr().Set([0.5], 10)

    file = written(tmp_path, make)
    assert extent(mesh_of(file))[1][2] == 0
    np.testing.assert_allclose(mesh_of(file, 1.0).positions[:, 2].max(), 1, atol=1e-6)


def test_cameras(tmp_path: Path) -> None:
    def make(stage: Usd.Stage) -> None:
        quad(stage)
        camera = UsdGeom.Camera.Define(stage, "/rig/front")
        camera.AddTranslateOp().Set((0, -300, 150))
        camera.AddRotateXOp().Set(90)
        camera.AddScaleOp().Set((2, 2, 2))
        camera.CreateFocalLengthAttr(50)
        camera.CreateHorizontalApertureAttr(36)
        camera.CreateVerticalApertureAttr(24)
        UsdGeom.Camera.Define(stage, "/plan").CreateProjectionAttr("orthographic")

    front, plan = read_cameras(written(tmp_path, make, unit=0.01, up="Z"))
    assert (front.name, plan.name) == ("front", "plan")
    assert (front.orthographic, plan.orthographic) == (False, True)
    assert front.vertical == pytest.approx(2 * np.degrees(np.arctan(12 / 50)))
    assert front.aspect == pytest.approx(1.5)
    # In a stage with z up it looks along y, which is -z with y up.
    expected = np.eye(4)
    expected[:3, 3] = 0, 1.5, 3
    np.testing.assert_allclose(front.to_world, expected, atol=1e-6)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda m: m.GetFaceVertexIndicesAttr().Set([0, 1, 2, 9]), "names vertex 9, and there are 4"),
        (lambda m: m.GetFaceVertexCountsAttr().Set([3]), "have 3 corners, and 4 are listed"),
        (lambda m: m.GetFaceVertexCountsAttr().Set([5, -1]), "have 4 corners, and 4 are listed"),
        (lambda m: m.GetPointsAttr().Set([(0, 0, np.nan)] * 4), "a vertex position is not finite"),
        (lambda m: primvar(m, "st", UV[:3], "vertex"), r"primvars:st\" \(vertex\) has 3 values, and 4"),
        (lambda m: primvar(m, "st", UV, "faceVarying", [0, 1, 2, 4]), "names value 4 of 4"),
        (lambda m: UsdGeom.Subset.CreateGeomSubset(m, "a", "face", [7]), 'cloth/a" names face 7 of 1'),
        (lambda m: m.MakeInvisible(), "holds no triangles: its meshes are hidden"),
        (lambda m: m.AddTranslateOp().Set((np.inf, 0, 0)), "transform of .* is not finite"),
    ],
)  # fmt: skip
def test_damage_is_named(tmp_path: Path, change: Callable[[UsdGeom.Mesh], object], says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_parts(written(tmp_path, lambda stage: change(quad(stage))))


@pytest.mark.parametrize("name", ["mesh.usda", "mesh.usdc", "mesh.usdz", "mesh.usd"])
def test_what_is_no_usd_says_nothing_else(
    tmp_path: Path, name: str, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_bytes(b"#usda 1.0\ndef Mesh {")
    with pytest.raises(InputError, match="is damaged or no USD file"):
        read_parts(tmp_path / name)
    assert capfd.readouterr() == ("", "")


def test_a_file_that_was_mended_is_read_anew(tmp_path: Path) -> None:
    file = written(tmp_path, lambda stage: quad(stage).GetFaceVertexCountsAttr().Set([3]))
    with pytest.raises(InputError, match="have 3 corners"):
        read_parts(file)
    file.write_text(file.read_text().replace("faceVertexCounts = [3]", "faceVertexCounts = [4]"))
    assert len(mesh_of(file).triangles) == 2


def test_other_geometry_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="it shows Sphere alone, and meshes are read"):
        read_parts(written(tmp_path, lambda stage: UsdGeom.Sphere.Define(stage, "/ball")))


def test_references_beside_the_file_are_read_and_missing_ones_named(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    written(tmp_path, lambda stage: stage.SetDefaultPrim(quad(stage).GetPrim()), "part.usda")

    def make(stage: Usd.Stage) -> None:
        stage.DefinePrim("/shirt").GetReferences().AddReference("./part.usda")
        stage.DefinePrim("/coat").GetPayloads().AddPayload("./lost.usda")

    with pytest.warns(LoomlightWarning, match=r'names "./lost.usda", which cannot be read'):
        (part,) = read_parts(written(tmp_path, make))
    assert part.name == "shirt"
    (tmp_path / "part.usda").unlink()
    capfd.readouterr()
    with pytest.raises(
        InputError, match=r'"./lost.usda", "./part.usda", which cannot be read in .*, and holds no'
    ):
        read_parts(tmp_path / "mesh.usda")
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("name", ["../part.usda", "{}/part.usda", "sub/../../part.usda"])
@pytest.mark.parametrize("arc", ["references", "payload", "subLayers"])
def test_files_outside_the_folder_are_not_read(tmp_path: Path, name: str, arc: str) -> None:
    written(tmp_path, quad, "part.usda")
    (tmp_path / "in").mkdir()
    asset = name.format(tmp_path)
    if arc == "subLayers":
        text = f"#usda 1.0\n(subLayers = [@{asset}@])\n"
    else:
        text = f'#usda 1.0\ndef "a" (prepend {arc} = @{asset}@</cloth>) {{}}\n'
    (tmp_path / "in" / "mesh.usda").write_text(text)
    with pytest.raises(InputError, match="lies outside its folder"):
        read_parts(tmp_path / "in" / "mesh.usda")


@pytest.mark.parametrize("folder", [".", ".."])
def test_value_clips_are_frames(tmp_path: Path, folder: str) -> None:
    (tmp_path / "in").mkdir()
    for code in (1, 2):

        def clip(stage: Usd.Stage, code: int = code) -> None:
            UsdGeom.Mesh.Define(stage, "/cloth").CreatePointsAttr().Set(
                [(x, y, code) for x, y, _ in CORNERS], code
            )

        written(tmp_path / "in" / folder, clip, f"clip{code}.usda")

    def make(stage: Usd.Stage) -> None:
        stage.SetStartTimeCode(1)
        stage.SetEndTimeCode(2)
        mesh = quad(stage)
        mesh.GetPointsAttr().Clear()
        clips = Usd.ClipsAPI(mesh.GetPrim())
        clips.SetClipAssetPaths([Sdf.AssetPath(f"{folder}/clip{code}.usda") for code in (1, 2)])
        clips.SetClipPrimPath("/cloth")
        clips.SetClipActive([(1, 0), (2, 1)])
        clips.SetClipTimes([(1, 1), (2, 2)])

    file = written(tmp_path / "in", make)
    if folder == "..":
        with pytest.raises(InputError, match="lies outside its folder"):
            read_parts(file)
        return
    assert frame_times(file) == pytest.approx([0, 1 / 24])
    np.testing.assert_allclose(mesh_of(file, 1 / 24).positions[:, 2], [2] * 4)


def test_nothing_is_fetched(tmp_path: Path) -> None:
    text = '#usda 1.0\ndef "a" (prepend references = @https://example.com/a.usd@) {}\n'
    (tmp_path / "mesh.usda").write_text(text)
    with pytest.raises(InputError, match="nothing is fetched"):
        read_parts(tmp_path / "mesh.usda")


def test_the_example_is_what_its_maker_makes(tmp_path: Path) -> None:
    made, kept = read_parts(written(tmp_path, fill, "mesh.usdc")), read_parts(EXAMPLE)
    names = [(part.name, part.material) for part in kept]
    cushion = [("front", "houndstooth"), ("back", "linen")]
    assert names == [("mattress", "tweed"), *cushion, *cushion, ("bolster", "stripe")]
    for part, other in zip(made, kept, strict=True):
        np.testing.assert_allclose(part.mesh.positions, other.mesh.positions, atol=1e-6)
        np.testing.assert_array_equal(part.mesh.triangles, other.mesh.triangles)
    assert [camera.name for camera in read_cameras(EXAMPLE)] == ["from_the_door"]


@pytest.mark.skipif(not DATA, reason="set LOOMLIGHT_DATA to the folder of measured data")
def test_the_shirt() -> None:
    (part,) = read_parts(Path(DATA or "") / "meshes" / "unisex_shirt.usd")
    assert part.name == "shirt"
    assert len(part.mesh.triangles) == 12_736
    np.testing.assert_allclose(np.ptp(part.mesh.positions, axis=0), [0.651, 0.646, 0.275], atol=1e-3)
