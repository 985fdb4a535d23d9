"""U3M materials as sources: what pictures and factors say, both versions, and what is wrong in one sentence.

Files and archives are in tests/exporters/test_u3m.py.
"""

from __future__ import annotations

import copy
import io
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageCms

from loomlight.cli.main import run
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.llvm import require_llvm
from loomlight.models.material_spec import resolve
from loomlight.sources import u3m
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.u3m import U3mMaterial
from loomlight.sources.u3m_file import write_u3ma
from tests.helpers.u3m import image, material, png, visual

require_llvm()
DATA = os.environ.get("LOOMLIGHT_DATA")
GREY = np.full((2, 3, 3), 51, np.uint8)  # 0.2, in sRGB 0.0331
WHITE = {"r": 1, "g": 1, "b": 1}


def number(path: str = "a.png", factor: float = 1, offset: float = 0, **options: Any) -> dict[str, Any]:
    texture = {"factor": factor, "offset": offset, "image": image(path, **options)}
    return {"constant": 0.5, "texture": texture}


def color(mode: str = "multiply", factor: dict[str, float] = WHITE, **options: Any) -> dict[str, Any]:
    return {
        "constant": WHITE,
        "texture": {"mode": mode, "factor": factor, "image": image("a.png", **options)},
    }


def test_numbers_are_offset_plus_mean_times_factor() -> None:
    pixels = GREY.copy()
    pixels[..., 0] = 204
    front = material(visual(roughness=number(factor=0.5, offset=0.1)), a=png(pixels)).faces[0]
    # The mean of the three channels is 0.4.
    assert front.roughness.values == pytest.approx(np.full((2, 3, 1), 0.3), abs=1e-3)
    assert front.roughness.size_mm == (12.0, 8.0)
    assert front.size_mm == (12.0, 8.0)


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        ("multiply", 0.0331 * 0.2140),
        ("add", 0.0331 + 0.2140),
        ("subtract", 0.0),
        ("divide", 0.0331 / 0.2140),
        ("max", 0.2140),
        ("min", 0.0331),
        ("overlay", 2 * 0.0331 * 0.2140),
    ],
)
def test_colours_are_blended_linearly(mode: str, expected: float) -> None:
    """sRGB 0.2 is 0.0331, sRGB 0.5 is 0.2140."""
    front = material(visual(basecolor=color(mode, {"r": 0.5, "g": 0.5, "b": 0.5})), a=png(GREY)).faces[0]
    assert front.base.values == pytest.approx(np.full((2, 3, 3), expected), abs=2e-4)


def test_rows_begin_at_the_lower_edge_and_mirrors_double_the_repeat() -> None:
    pixels = np.zeros((2, 2, 3), np.uint8)
    pixels[0, 0] = 255
    made = material(visual(alpha=number(mode="mirror_x"), roughness=number(mode="mirror_xy")), a=png(pixels))
    alpha = made.faces[0].alpha
    assert alpha.values[..., 0].tolist() == [[0, 0, 0, 0], [1, 0, 0, 1]]
    assert alpha.size_mm == (24.0, 8.0)
    rough = made.faces[0].roughness
    assert rough.values[..., 0].tolist() == [[0, 0, 0, 0], [1, 0, 0, 1], [1, 0, 0, 1], [0, 0, 0, 0]]
    assert rough.size_mm == (24.0, 16.0)


def test_profiles_of_colours_are_honoured_and_those_of_data_are_not() -> None:
    """A profile of linear light: what sRGB would take for dark is half as bright as white."""
    linear = ImageCms.ImageCmsProfile(ImageCms.createProfile("XYZ"))
    stream = io.BytesIO()
    swapped = ImageCms.createProfile("sRGB")
    Image.fromarray(GREY).save(stream, format="png", icc_profile=ImageCms.ImageCmsProfile(swapped).tobytes())
    made = material(visual(basecolor=color(), roughness=number()), a=stream.getvalue())
    assert made.faces[0].base.values == pytest.approx(np.full((2, 3, 3), 0.0331), abs=1e-3)
    assert made.faces[0].roughness.values == pytest.approx(np.full((2, 3, 1), 0.2), abs=1e-3)
    # One that is damaged, or of another space than the picture's, is as none.
    for broken in (b"no profile", linear.tobytes()):
        stream = io.BytesIO()
        Image.fromarray(GREY).save(stream, format="png", icc_profile=broken)
        again = material(visual(basecolor=color()), a=stream.getvalue())
        assert again.faces[0].base.values == pytest.approx(np.full((2, 3, 3), 0.0331), abs=1e-3)


def test_normals_are_scaled_and_made_unit() -> None:
    normal = np.array([0.6, 0.0, 0.8])
    pixels = np.rint(127.5 + 127.5 * np.tile(normal, (2, 2, 1)))
    field = {"constant": {"x": 0, "y": 0, "z": 1}, "texture": {"scale": 2, "image": image("a.png")}}
    found = material(visual(normal=field), a=png(pixels)).faces[0].normal.values
    expected = np.array([1.2, 0, 0.8]) / np.hypot(1.2, 0.8)
    # Eight bits.
    assert found == pytest.approx(np.broadcast_to(expected, (2, 2, 3)), abs=0.01)


def test_missing_faces_and_fields_are_as_the_format_says() -> None:
    made = material(None, visual(roughness=0.3))
    assert made.faces[0] is made.faces[1]
    assert made.faces[0].roughness.values.item() == pytest.approx(0.3)
    assert made.faces[0].specular.values.item() == 0.5
    assert made.faces[0].alpha.values.item() == 1.0
    assert made.size_mm == (100.0, 100.0)


def test_large_pictures_are_halved(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(u3m, "_MAX_TEXELS", 4)
    rows = np.repeat(np.arange(4, dtype=np.uint8)[:, None, None] * 80, 4, 1).repeat(3, 2)
    found = material(visual(roughness=number()), a=png(rows)).faces[0].roughness.values
    assert found[..., 0] == pytest.approx(np.array([[200, 200], [40, 40]]) / 255)


def test_sixteen_bits_are_read() -> None:
    stream = io.BytesIO()
    Image.fromarray(np.full((2, 2), 13107, np.uint16)).save(stream, format="png")
    found = material(visual(roughness=number()), a=stream.getvalue()).faces[0].roughness.values
    assert found == pytest.approx(np.full((2, 2, 1), 0.2), abs=1e-5)


def test_what_is_left_out_is_said() -> None:
    with pytest.warns(LoomlightWarning, match="clear coat is left out"):
        material(visual(clearcoat_value=1.0))


@pytest.mark.skipif(DATA is None, reason="set LOOMLIGHT_DATA to the folder with U3M's example")
def test_the_example_of_version_1_0_is_read(tmp_path: Path) -> None:
    """Its dpi is one number, and it adds its colours to white; its pictures are not with it."""
    assert DATA is not None
    text = (Path(DATA) / "u3m" / "Example_1.0.u3m").read_text(encoding="utf-8")
    (tmp_path / "example.u3m").write_text(text)
    with pytest.raises(InputError, match=r"_ALPHA\.jpg|_NRM\.jpg|_BASE\.jpg|_MTL\.jpg|_ROUGH\.jpg"):
        load_source(tmp_path / "example.u3m")
    (tmp_path / "textures").mkdir()
    for part in ("ALPHA", "BASE", "MTL", "NRM", "ROUGH"):
        Image.fromarray(GREY).save(tmp_path / "textures" / f"Example_0.9_{part}.jpg")
    made = load_source(tmp_path / "example.u3m")
    assert isinstance(made, U3mMaterial)
    assert made.size_mm == pytest.approx((12.1759, 11.1195))
    assert made.faces[0].base.values.mean() == pytest.approx(0.0331, abs=2e-3)


def saved(folder: Path) -> Path:
    made = material(visual(basecolor=color(), roughness=number()), visual(roughness=0.2), a=png(GREY))
    path = folder / "bought.u3ma"
    write_u3ma(path, made.file)
    return path


def test_a_loom_keeps_all_of_it(tmp_path: Path) -> None:
    made = load_source(saved(tmp_path))
    write_loom(tmp_path / "a.loom", LoomFile("latent", made))
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(made, U3mMaterial)
    assert isinstance(again, U3mMaterial)
    assert (again.file.document, dict(again.file.files)) == (made.file.document, dict(made.file.files))
    assert again.name == "bought"


def test_it_is_shown_without_baking(tmp_path: Path) -> None:
    spec = resolve(saved(tmp_path))
    assert spec.model_name == "standard"
    assert spec.model() is spec.model()


def changed(document: dict[str, Any], place: str, value: Any) -> dict[str, Any]:
    found = copy.deepcopy(document)
    *names, last = place.split(".")
    inner = found["material"]
    for name in names:
        inner = inner[name]
    inner[last] = value
    return found


@pytest.mark.parametrize(
    ("place", "value", "says"),
    [
        ("front.shader", "phong", 'shader = "phong" is unknown'),
        ("front.roughness.texture.factor", "1", 'material.front: roughness: factor = "1" cannot be used'),
        ("front.roughness.texture.offset", True, "offset = true cannot be used"),
        ("front.roughness.texture.image.width", 0, "image.width = 0 cannot be used: write millimetres"),
        ("front.roughness.texture.image.path", 7, "image.path = 7 is no path"),
        ("front.roughness.texture.image.repeat", {"mode": "x"}, 'image.repeat.mode = "x" is unknown'),
        ("front.basecolor.texture.mode", "screen", 'texture.mode = "screen" is unknown'),
        ("front.basecolor.texture.factor", {"r": "x"}, 'factor.r = "x" cannot be used'),
        ("front.alpha", 3, "alpha: 3 cannot be used: write constant and texture as an object"),
        ("front", "none", "cannot be used: write a visual as an object"),
        ("front.roughness.texture.image.path", "b.png", '"b.png", which it names, is missing'),
    ],
)
def test_faults_are_one_sentence(
    place: str, value: Any, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = saved(tmp_path)
    made = load_source(path)
    assert isinstance(made, U3mMaterial)
    (tmp_path / "broken.u3m").write_text(json.dumps(changed(made.file.document, place, value)))
    (tmp_path / "a.png").write_bytes(png(GREY))
    assert run(["render", str(tmp_path / "broken.u3m"), "-o", str(tmp_path / "x.png")]) == 2
    said = capsys.readouterr().err
    assert says in said
    assert "broken.u3m" in said
    assert said.strip().count("\n") == 0
    assert not (tmp_path / "x.png").exists()


@pytest.mark.parametrize("content", [b"", b"no picture", png(GREY)[:40], b"GIF89a" + bytes(40)])
def test_pictures_that_are_none_are_named(content: bytes) -> None:
    with pytest.raises(InputError, match=r'the picture "a.png": it is no PNG, JPEG or TIFF'):
        material(visual(basecolor=color()), a=content)


def test_huge_pictures_are_refused_by_their_size() -> None:
    """Of a head that says 60000 × 60000."""
    content = bytearray(png(GREY))
    content[16:24] = (60000).to_bytes(4, "big") * 2
    with pytest.raises(InputError, match=r"60000 × 60000 pixels|no PNG"):
        material(visual(basecolor=color()), a=bytes(content))


def test_models_of_fabrics_refuse_it(tmp_path: Path, refused: Callable[..., str]) -> None:
    path = saved(tmp_path)
    said = refused(["render", str(path), "--model", "lobes", "-o", "x.png"], run)
    assert "bought" in said
