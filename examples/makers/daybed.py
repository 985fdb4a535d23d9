"""Makes `examples/daybed.usdc`, a stage of several prims that the documentation clothes part by part.

python -m examples.makers.daybed
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade, Vt

from loomlight.core.files import replacing

FILE = Path(__file__).resolve().parents[1] / "daybed.usdc"
Floats = NDArray[np.float64]
# Quads along a side of each cloth.
QUADS = 24


def pillow(
    sides: tuple[float, float], bulge: float, softness: float
) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Points in centimetres, uv of corners in metres, and quads of two cloths sewn along their rim.

    Args:
        sides: of each cloth, along x and y.
        bulge: half of its greatest thickness.
        softness: 0 of a box, 1 of a lens.
    """
    steps = np.linspace(-1, 1, QUADS + 1)
    # Closer together at the rim, where it curves.
    steps = np.sign(steps) * (1 - (1 - np.abs(steps)) ** 1.6)
    x, y = (grid.ravel() for grid in np.meshgrid(steps, steps))
    fullness = ((1 - x**2) * (1 - y**2)) ** (softness / 2)
    inward = 1 - 0.06 * softness * ((1 - x**2) * y**2 + (1 - y**2) * x**2)
    corner = (np.arange(QUADS)[:, None] * (QUADS + 1) + np.arange(QUADS)).ravel()
    quads = corner[:, None] + np.array([0, 1, QUADS + 2, QUADS + 1])
    rim = np.maximum(np.abs(x), np.abs(y)) == 1
    lower = np.where(rim, np.arange(len(x)), len(x) + np.cumsum(~rim) - 1)
    flat = np.stack([x * sides[0], y * sides[1]], axis=1) / 2 * inward[:, None]
    points = np.concatenate(
        [
            np.concatenate([flat, bulge * fullness[:, None]], axis=1),
            np.concatenate([flat, -bulge * fullness[:, None]], axis=1)[~rim],
        ]
    )
    uv = np.stack([x * sides[0], y * sides[1]], axis=1) / 200
    of_corners = np.concatenate([uv[quads], (uv * [-1, 1])[quads[:, ::-1]]]).reshape(-1, 2)
    return points, of_corners, np.concatenate([quads, lower[quads[:, ::-1]]])


def bolster(length: float, radius: float) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """As `pillow`, a roll along x whose cloth is gathered over both ends."""
    rings = 8
    narrow = np.linspace(0.03, 1, rings, endpoint=False)
    x = np.linspace(-0.5, 0.5, QUADS + 1) * length
    x = np.concatenate([np.repeat(x[0], rings), x, np.repeat(x[-1], rings)])
    radii = radius * np.concatenate([narrow, np.ones(QUADS + 1), narrow[::-1]])
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(radii)))])
    turns, count = np.linspace(0, 2 * np.pi, 4 * QUADS, endpoint=False), len(x)
    points = np.stack(
        [
            np.tile(x, len(turns)),
            np.outer(np.cos(turns), radii).ravel(),
            np.outer(np.sin(turns), radii).ravel(),
        ],
        axis=1,
    )
    first = (np.arange(len(turns))[:, None] * count + np.arange(count - 1)).ravel()
    quads = first[:, None] + np.array([0, count, count + 1, 1])
    turn, step = np.divmod(quads, count)
    of_corners = np.stack([along[step], turn * 2 * np.pi / len(turns) * radius], axis=2).reshape(-1, 2) / 100
    return points, of_corners, quads % len(points)


def _mesh(
    stage: Usd.Stage, path: str, shape: tuple[Floats, Floats, NDArray[np.int64]], material: str
) -> UsdGeom.Mesh:
    points, uv, quads = shape
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr([4] * len(quads))
    mesh.CreateFaceVertexIndicesAttr(quads.ravel().tolist())
    mesh.CreateSubdivisionSchemeAttr("none")
    kind = Sdf.ValueTypeNames.TexCoord2fArray
    st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", kind, UsdGeom.Tokens.faceVarying)
    rows, index = np.unique(uv.astype(np.float32), axis=0, return_inverse=True)
    st.Set(Vt.Vec2fArray.FromNumpy(rows))
    st.SetIndices(Vt.IntArray(index.ravel().tolist()))
    _bind(stage, mesh, material)
    return mesh


def _bind(stage: Usd.Stage, bound: Any, material: str) -> None:
    look = UsdShade.Material.Define(stage, f"/daybed/looks/{material}")
    UsdShade.MaterialBindingAPI.Apply(bound.GetPrim()).Bind(look)


def fill(stage: Usd.Stage) -> None:
    """A mattress, a cushion of two cloths in two places, a roll, and a camera; centimetres, z up."""
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    stage.SetDefaultPrim(UsdGeom.Xform.Define(stage, "/daybed").GetPrim())
    mattress = _mesh(stage, "/daybed/mattress", pillow((150, 70), 8, 0.25), "tweed")
    mattress.AddTranslateOp().Set((0, 0, 8))
    stage.CreateClassPrim("/cushion")
    cushion = _mesh(stage, "/cushion/cushion", pillow((48, 48), 9, 1.0), "houndstooth")
    binding = UsdShade.MaterialBindingAPI(cushion)
    lower = list(range(QUADS**2, 2 * QUADS**2))
    for name, faces, material in (("front", range(QUADS**2), "houndstooth"), ("back", lower, "linen")):
        _bind(stage, binding.CreateMaterialBindSubset(name, Vt.IntArray(list(faces))), material)
    for number, (place, turn) in enumerate((((-40, 20, 37), 6.0), ((12, 18, 38), -14.0))):
        copy = UsdGeom.Xform.Define(stage, f"/daybed/place{number}")
        copy.AddTranslateOp().Set(place)
        copy.AddRotateXYZOp().Set((68, 0, turn))
        copy.GetPrim().GetReferences().AddInternalReference("/cushion")
        copy.GetPrim().SetInstanceable(True)
    roll = _mesh(stage, "/daybed/bolster", bolster(58, 9), "stripe")
    roll.AddTranslateOp().Set((58, -2, 24.5))
    roll.AddRotateZOp().Set(82)
    camera = UsdGeom.Camera.Define(stage, "/daybed/from_the_door")
    view = Gf.Matrix4d().SetLookAt((-70, -260, 120), (2, 0, 22), (0, 0, 1)).GetInverse()
    camera.AddTransformOp().Set(view)
    camera.CreateFocalLengthAttr(62)
    camera.CreateHorizontalApertureAttr(36)
    camera.CreateVerticalApertureAttr(24)


def main() -> None:
    """Writes the file."""
    with tempfile.TemporaryDirectory() as folder, replacing(FILE) as temporary:
        made = Path(folder) / FILE.name
        stage = Usd.Stage.CreateNew(str(made))
        fill(stage)
        stage.GetRootLayer().Save()
        temporary.write_bytes(made.read_bytes())


if __name__ == "__main__":
    main()
