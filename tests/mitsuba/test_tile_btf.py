"""Tiles of Mitsuba scenes: light that is known, geometry across the sides, and files at fault.

Covers: sources/tile.py, mitsuba/traced_btf.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.mitsuba.traced_btf import TileBtf, _with_last_curve
from loomlight.mitsuba.variants import choose_variant
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.tile import TileScene

require_llvm()
choose_variant("llvm_ad_rgb")

COUNT = 4000
TOML = 'tile = "tile.xml"\nsize_mm = [2.0, 1.0]\n'
# A plane of one colour, as wide as the tile, at z = 0.25.
PLANE = """
<scene version="3.0.0">
  <shape type="rectangle">
    <transform name="to_world"><scale x="1" y="0.5"/><translate x="1" y="0.5" z="0.25"/></transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0.8, 0.4, 0.2"/></bsdf>
  </shape>
</scene>"""
# A rod along x in the middle, and one across the side y = 0, of which half lies in the next tile.
RODS = """
<scene version="3.0.0">
  <bsdf type="hair" id="fibre"><rgb name="sigma_a" value="0.1, 0.1, 0.1"/></bsdf>
  <shape type="bsplinecurve"><string name="filename" value="curves/rods.txt"/><ref id="fibre"/></shape>
</scene>"""


def written(folder: Path, scene: str, toml: str = TOML) -> Path:
    (folder / "curves").mkdir()
    rods = "\n\n".join("\n".join(f"{x} {y} 0 0.1" for x in np.linspace(-0.5, 2.5, 7)) for y in (0.5, 0.0))
    (folder / "curves" / "rods.txt").write_text(rods + "\n")
    (folder / "tile.xml").write_text(scene)
    (folder / "tile.toml").write_text(toml)
    return folder / "tile.toml"


def loaded(folder: Path, scene: str, toml: str = TOML) -> TileScene:
    source = load_source(written(folder, scene, toml))
    assert isinstance(source, TileScene)
    return source


def rays(
    light: list[float], view: list[float]
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Positions over several repeats [n, 2], and as many lights and views [n, 3]."""
    positions = np.random.default_rng(1).uniform(-4, 4, (COUNT, 2)).astype(np.float32)
    both = [np.array(v, np.float32) / np.float32(np.linalg.norm(v)) for v in (light, view)]
    return positions, np.tile(both[0], (COUNT, 1)), np.tile(both[1], (COUNT, 1))


def test_a_plane_has_the_value_of_its_bsdf(tmp_path: Path) -> None:
    btf = TileBtf(loaded(tmp_path, PLANE))
    assert (btf.faces, btf.transmits, btf.has_holes) == (1, False, False)
    positions, lights, views = rays([0.5, -0.2, 0.8], [0.9, 0.3, 0.2])
    found = btf.values(positions, lights, views, (0,))
    wanted = np.array([0.8, 0.4, 0.2]) / np.pi * lights[0, 2]
    # The light's cone is 2.9° wide; no ray is lost at the seams of the copies.
    np.testing.assert_allclose(found.mean(axis=0), wanted, rtol=0.005)
    np.testing.assert_allclose(found.min(axis=0), wanted, rtol=0.06)


@pytest.mark.slow
def test_fibres_across_a_side_are_whole_and_holes_are_found(tmp_path: Path) -> None:
    """Rods of radius 0.1 every 0.5: from above 60 % are holes, and rods are lit from below."""
    btf = TileBtf(loaded(tmp_path, RODS, TOML + "two_sided = true\n"))
    assert (btf.faces, btf.transmits, btf.has_holes) == (2, True, True)
    positions, lights, views = rays([0.1, 0.2, -1.0], [0.0, 0.0, 1.0])
    across = np.abs((positions[:, 1] + 0.25) % 0.5 - 0.25)
    edge = np.abs(across - 0.1) < 1e-3
    holes = btf.holes(positions, views)
    assert np.array_equal(holes[~edge] == 1, (across > 0.1)[~edge])
    through = btf.values(positions, lights, views, (0,))
    assert (through[holes == 1] == 0).all()
    assert through[holes == 0].mean() > 0.01


def test_a_last_curve_is_added_that_no_ray_meets() -> None:
    """Without it Mitsuba reads beyond the control points at the end of the last curve, and may crash."""
    rods = b"0 0 0 0.1\n1 0 0 0.1\n2 0 0 0.1\n3 0 0 0.1\n4 0 0 0.1"
    held = _with_last_curve(rods)
    assert held.startswith(rods + b"\n\n")
    assert held.decode().split("\n\n")[1].splitlines()[3] == "3 0 0 1e-09"


def test_a_loom_holds_the_scene_and_its_files(tmp_path: Path) -> None:
    source = loaded(tmp_path, RODS, TOML + "reference_height_mm = 0.1\nbounces = 3\n")
    write_loom(tmp_path / "a.loom", LoomFile("neumip", source))
    (tmp_path / "curves" / "rods.txt").unlink()
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(again, TileScene)
    assert again.files == source.files
    assert list(again.files) == ["curves/rods.txt"]
    assert (again.bounces, again.reference_height_mm, again.scene) == (3, 0.1, source.scene)
    queries = rays([0, 0.3, 1], [0.2, 0, 1])
    first, second = (TileBtf(one).values(*queries, (4,)) for one in (source, again))
    assert np.array_equal(first, second)


@pytest.mark.parametrize(
    ("scene", "toml", "says"),
    [
        (PLANE, 'tile = "none.xml"\nsize_mm = [1, 1]', "none.xml does not exist"),
        (PLANE, TOML + "bounces = 0", "bounces = 0 cannot be used: write a whole number from 1 to 64"),
        (PLANE, TOML + "boun = 1", '"boun" is no field that a tile has: did you mean bounces?'),
        (PLANE, 'tile = "tile.xml"', "size_mm is missing: write two lengths above 0"),
        ("<scene>", TOML, "it is no valid XML"),
        ("<shape/>", TOML, "it is no Mitsuba scene"),
        (RODS.replace("curves/rods", "../rods"), TOML, "files lie in the scene's folder or below it"),
        (RODS.replace("curves/rods", "curves/none"), TOML, "none.txt does not exist"),
        ("<scene version='3.0.0'/>", TOML, "its scene has no shapes"),
        (PLANE.replace("rectangle", "rectangel"), TOML, "did you mean rectangle?"),
        (
            PLANE.replace('"reflectance"', '"colour"'),
            TOML,
            "load its scene: While loading loomlight-tile.xml (line 2, col 4): Found 1 unreferenced",
        ),
        (
            PLANE.replace('x="1" y="0.5" z', 'x="9" y="0.5" z'),
            TOML,
            "sticks out of size_mm = [2.0, 1.0] by 8",
        ),
        (PLANE.replace("</scene>", '<emitter type="constant"/></scene>'), TOML, "holds an emitter"),
    ],
)
def test_a_tile_at_fault_is_one_sentence(scene: str, toml: str, says: str, tmp_path: Path) -> None:
    file = written(tmp_path, scene, toml)
    with pytest.raises(InputError) as caught:
        TileBtf(load_source(file))  # type: ignore[arg-type]
    assert says in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_the_command_refuses_it_with_code_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, "<scene>")
    assert run(["bake", str(file), "--model", "neumip", "-o", str(tmp_path / "a.loom")]) == 2
    assert "it is no valid XML" in capsys.readouterr().err
    assert not (tmp_path / "a.loom").exists()


@pytest.mark.parametrize(("name", "says"), [("a.ply", "a.ply"), ("a.txt", "it is no .ply file")])
def test_a_damaged_mesh_of_a_tile_ends_no_process(name: str, says: str) -> None:
    head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    mesh = head + faces + "0 0 0\n1 0 0\n0 1 0\n3 0 1 99999999\n"
    shape = f'<shape type="ply"><string name="filename" value="{name}"/></shape>'
    scene = f'<scene version="3.0.0">{shape}</scene>'
    with pytest.raises(InputError, match="Mitsuba cannot load its scene: ") as caught:
        TileBtf(TileScene("t", scene, {name: mesh.encode()}, (1.0, 1.0), 0.0, False, 4))
    assert says in str(caught.value)
    good = mesh.replace("99999999", "2").encode()
    if name == "a.ply":
        assert TileBtf(TileScene("t", scene, {name: good}, (1.0, 1.0), 0.0, False, 4)).has_holes
