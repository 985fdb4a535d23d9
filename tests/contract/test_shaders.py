"""Shaders of models in Slang against Python: whole queries, what they are made of, and frames.

Libraries for engines ask the same of the text that is exported (test_exports.py); single functions, and the
point model for layouts of all ranges, are compared in tests/realtime.

Covers: realtime/words.py, models/texture/tables.py, models/lobes/tables.py, models/clustered/tables.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Bool, UInt
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.interface import Model
from loomlight.models.registry import REALTIME_MODELS
from loomlight.models.texture.neumip import CHANNELS
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.scattering.fibre import mean_layer_shares
from tests.helpers.arrays import pairs, vectors
from tests.helpers.parity import share_beyond
from tests.helpers.shader_cases import (
    CASES,
    Rows,
    bsdf_of,
    case_rows,
    model_of,
    packed,
)
from tests.helpers.slang import mapped
from tests.helpers.untrained import random_latent, random_neumip, small_clustered

require_llvm()
pytestmark = pytest.mark.usefixtures("graphics")

COUNT = 8192
Columns = list[NDArray[Any]]


@dataclass(frozen=True)
class Shader:
    """How a model's shader is asked in Slang, of the rows of `shader_cases.py`.

    Attributes:
        value: expression of f·cos and of the share that passes straight through, a float4.
        modules: beside the library of the model.
        body: statements that parts are of.
        parts: expressions separated by ";": what the value is made of.
        python: the same of Python's answer and the rows, a column each.
        flips: share of parts that may miss the bar beside those of the case.
        apart: parts are asked by a kernel of their own: both together take drivers minutes to compile.
    """

    value: str = "cloth_value(0u, centre, dx, dy, light, view)"
    modules: str = ""
    body: str = ""
    parts: str = ""
    python: Callable[[Any, Any, Rows], Columns] = lambda model, at, rows: []
    flips: float = 0.0
    apart: bool = False


FOOTPRINT = "Footprint p; p.dx = dx; p.dy = dy; let back = view.z < 0.0;"
# Of fabrics, among whose threads those of the cloth wander.
ON_CLOTH = FOOTPRINT + "p.centre = place_on_cloth(fabric, centre, p.spread_side());"
COMPONENTS = "c.diffuse_warp; c.diffuse_weft; c.specular_warp; c.specular_weft"
NAMES = ("diffuse_warp", "diffuse_weft", "specular_warp", "specular_weft")


def groups_of(model: Any, at: Any, rows: Rows) -> Columns:
    """Components by groups alone, at every size, and mean albedos of coloured threads."""
    hole, (sums,) = at.prefiltered([vectors(rows["light"])], None, Bool(True))
    warp, weft = model.means.over(at.footprint, vectors(rows["view"]).z < 0)
    found = [getattr(sums.components, name) for name in NAMES] + [hole]
    found += [warp.diffuse_reflect.x, warp.specular_transmit.z]
    found += [weft.diffuse_transmit.y, weft.specular_reflect.x]
    return [np.array(part) for part in found]


def parts_of_neural(model: Any, at: Any, rows: Rows) -> Columns:
    parts = at.components(vectors(rows["light"]))
    return [np.array(getattr(parts, name)) for name in (*NAMES, "light_visibility")]


def guides_of(at: Any) -> Columns:
    found = at.auxiliary
    return [*np.array(found.albedo), np.array(found.roughness), *np.array(found.normal)]


SHADERS: dict[str, Shader] = {
    "point": Shader(),
    "lobes": Shader(
        modules="prefiltered albedos point irregularity",
        body=ON_CLOTH + "let l = to_face_frame(light, back); let v = to_face_frame(view, back);"
        "let c = prefiltered_components(fabric, p, l, v, back);"
        "let a = albedos_over(fabric, p, back);",
        parts=f"{COMPONENTS}; c.hole; a.warp.diffuse_reflect.x; a.warp.specular_transmit.z;"
        "a.weft.diffuse_transmit.y; a.weft.specular_reflect.x",
        python=groups_of,
        apart=True,
    ),
    "clustered": Shader(
        "clustered_value(fabric, footprint_of(0u, centre, dx, dy), light, view, seed, number)",
        modules="clustered",
    ),
    "neural": Shader(
        modules="neural irregularity",
        body=ON_CLOTH
        + "NeuralView w; neural_view(fabric, p, view, w); let c = neural_components(fabric, w, light);",
        parts=f"{COMPONENTS}; c.light_visibility",
        python=parts_of_neural,
    ),
    "neumip": Shader(
        modules="neumip",
        body=FOOTPRINT + "p.centre = centre; NeumipView seen; neumip_view(fabric, p, view, seen);",
        parts=";".join(f"seen.latent[{channel}]" for channel in range(CHANNELS)),
        python=lambda model, at, rows: [*np.array(at._latent)],
        # Where interpolated channels cross 0, rounding of the position is more than a thousandth of them.
        flips=3e-4,
    ),
    "latent": Shader(
        modules="latent random_numbers",
        body=FOOTPRINT + "p.centre = centre; let size = float2(fabric.latent.width, fabric.latent.height);"
        "LatentView seen; latent_view(fabric, p, view, uniform_of(hashed(p, view, size), 0), seen);"
        "let a = latent_albedo(fabric, seen); let g = latent_auxiliary(fabric, seen);",
        parts="a.x; a.y; a.z; g.albedo.x; g.albedo.y; g.albedo.z; g.roughness;"
        "g.normal.x; g.normal.y; g.normal.z",
        python=lambda model, at, rows: [*np.array(at.directional_albedo), *guides_of(at)],
    ),
}


def test_every_shader_is_asked() -> None:
    assert {*SHADERS} == {*REALTIME_MODELS} == {case.model for case in CASES.values()}


def answered(case: str, rows: Rows, value: bool = True, parts: bool = True, half: bool = False) -> Any:
    """f·cos and what passes straight through [n, 4], and the parts [n, parts]; either may be left out."""
    name = CASES[case].model
    shader = SHADERS[name]
    results = ["f.x; f.y; f.z; f.w"] if value else []
    results += [shader.parts] if parts and shader.parts else []
    body = f"let f = {shader.value};" if value else ""
    body += shader.body if parts else ""
    modules = (
        f"{f'cloth_{name}' if value else ''} footprint {shader.modules if parts or not shader.apart else ''}"
    )
    return mapped(modules, body, ";".join(results), rows, packed(model_of(case), half))


def require_parts(case: str, found: NDArray[np.float32], expected: Columns) -> None:
    # Albedos of threads of one colour are the same everywhere.
    assert sum(np.ptp(part) > 0.05 for part in expected) >= min(len(expected), 4)
    flips = CASES[case].flips + SHADERS[CASES[case].model].flips
    for column, values in enumerate(expected):
        assert share_beyond(found[:, column], values) <= flips, column


# Of `point`, quick tests of test_exports.py and tests/realtime ask too.
@pytest.mark.quick("lobes, silk-satin")
@pytest.mark.parametrize("case", CASES)
def test_queries_are_those_of_the_model(case: str) -> None:
    rows = case_rows(case, COUNT)
    shader, flips = SHADERS[CASES[case].model], CASES[case].flips
    at = bsdf_of(model_of(case), rows)
    value = np.array(at.value(vectors(rows["light"]))).T
    through = np.broadcast_to(np.array(at.null_transmission), COUNT)
    found = answered(case, rows, parts=not shader.apart)
    # Bright values, or the bar's absolute part would say it all.
    assert value.max() > 0.1
    assert share_beyond(found[:, :3], value) <= flips
    assert share_beyond(found[:, 3], through) <= flips
    if not shader.apart:
        require_parts(case, found[:, 4:], shader.python(model_of(case), at, rows))


@pytest.mark.slow
@pytest.mark.parametrize("case", [case for case in CASES if SHADERS[CASES[case].model].apart])
def test_parts_are_those_of_the_model(case: str) -> None:
    rows = case_rows(case, COUNT)
    model = model_of(case)
    expected = SHADERS[CASES[case].model].python(model, bsdf_of(model, rows), rows)
    require_parts(case, answered(case, rows, value=False), expected)


@pytest.mark.quick("point, slubby")
@pytest.mark.parametrize("case", ["point, slubby", "lobes, denim", "lobes, slubby"])
def test_guides_are_those_of_the_model(case: str) -> None:
    """Albedo, roughness and normal as denoisers take them, of what the view shows."""
    rows = case_rows(case, COUNT)
    model, name = model_of(case), CASES[case].model
    # One call for both parts, of rows that are there twice: two calls take drivers four times as long.
    twice = {key: np.concatenate([values, values]) for key, values in rows.items()}
    twice["part"] = np.repeat(np.uint32([1, 2]), COUNT)
    body = "let a = cloth_auxiliary(0u, centre, dx, dy, view, part);"
    answers = mapped(f"cloth_{name} footprint", body, "a.x; a.y; a.z; a.w", twice, packed(model))
    found = np.concatenate([answers[:COUNT], answers[COUNT:, :3]], axis=1)
    at: Any = bsdf_of(model, rows)
    warp, weft = (np.array(part) for part in at.shown)
    is_seen = (np.array(at.hole) < 1) | (name == "lobes")
    share = np.where(warp + weft > 0, np.maximum(warp, 0) / np.maximum(warp + weft, 1e-30), 0.5)
    back = []
    for family, albedos in zip(("warp", "weft"), (at.albedos.warp, at.albedos.weft), strict=True):
        look = getattr(model.source.appearance(), family)
        turned = mean_layer_shares(look.roughness, model.source.appearance().optical_depth)[0]
        back.append(np.array(albedos.diffuse_reflect) + turned * np.array(albedos.specular_reflect))
    albedo = share * back[0] + (1 - share) * back[1]
    side = np.sign(rows["view"][:, 2])
    normal = np.stack([0 * side, 0 * side, side])
    if name == "point":
        normal = np.array(at.point.normal) * np.stack([1 + 0 * side, 1 + 0 * side, side])
    # Of `lobes`, a light at the eye grazes the yarn's edge wherever the eye does: rounding decides there.
    flips = 1.5e-2 if name == "lobes" else CASES[case].flips
    for column, values in enumerate([*albedo, np.array(at.roughness), *normal]):
        assert share_beyond(found[:, column], np.where(is_seen, values, 0)) <= flips, column


@pytest.mark.slow
def test_texels_of_half_precision_round_little() -> None:
    """Halves round each channel by up to 2⁻¹² of itself; such networks turn that into a few thousandths."""
    case = "neumip, two faces"
    rows = case_rows(case, COUNT)
    single, half = (answered(case, rows, half=half) for half in (False, True))
    np.testing.assert_allclose(half[:, :4], single[:, :4], atol=1e-2)
    # Latents are larger.
    np.testing.assert_allclose(half, single, atol=2e-2)
    error = np.sqrt(np.mean(np.square(half - single)[:, :3]))
    assert 0 < error < 1e-3 * np.sqrt(np.mean(single[:, :3] ** 2))


def test_light_passes_through_sources_of_two_faces_alone() -> None:
    """Of what is compared above: `neumip` has networks for it, which sources of one face lack."""
    for case, opaque in (("neumip, two faces", False), ("neumip, one face", True)):
        rows = case_rows(case, COUNT)
        value = np.array(bsdf_of(model_of(case), rows).value(vectors(rows["light"])))
        far = rows["light"][:, 2] * rows["view"][:, 2] < 0
        assert (value[:, far] == 0).all() == opaque


# --------------------------------------------------------------------------------------------------- frames

SUN = np.float32([0.5, 0.3, 0.8]) / np.linalg.norm([0.5, 0.3, 0.8])
Pixels = tuple[NDArray[Any], NDArray[Any]]
Expected = Callable[[Any, Any, Footprint, Any], Pixels]


def of_the_model(model: Model, view: Any, footprint: Footprint, light: Any) -> Pixels:
    """Values [n, 3] of footprints, and the share of each that passes straight through."""
    at = model.at(view, model.on_cloth(footprint))
    return np.array(at.value(light)).T, np.array(at.null_transmission)


def of_both_levels(model: Any, view: Any, footprint: Footprint, light: Any) -> Pixels:
    """`latent` of square footprints: both levels' values in proportion to their distance."""
    at = model.at(view, footprint)
    u, v = (footprint.centre[axis] / model.source.repeat_mm[axis] for axis in range(2))
    values = []
    for level in (0, 1):
        at.__dict__["_latent"] = at._device.latent_of_level(u, v, level, 0 * at.view.x)
        at.__dict__.pop("_frames", None)
        values.append(np.array(at.value(light)).T)
    assert np.abs(values[0] - values[1]).max() > 0.01
    share = np.log2(np.array(footprint.spread_side) / model.weights.shape.texel_mm)[:, None]
    return (1 - share) * values[0] + share * values[1], np.array(at.null_transmission)


def of_many_seeds(model: Any, view: Any, footprint: Footprint, light: Any) -> Pixels:
    """`clustered` of one footprint: the mean over texels, whose spread the base takes in part."""
    seed = UInt(np.random.default_rng(2).integers(0, 2**32, 4096, dtype=np.uint32))
    at = model.at(view, footprint, seed=seed)
    return np.array(at.value(light)).mean(axis=1)[None], np.array(at.null_transmission).mean()


@dataclass(frozen=True)
class Frame:
    """A square sheet of cloth seen by a camera.

    Attributes:
        make: the model.
        camera, size: the camera, and the picture's side in pixels.
        side: of the sheet, metres; uv spans it once.
        uv_mm: millimetres of cloth a unit of uv.
        passes: how many are added up.
        expected: of the model, views, footprints and lights.
        rtol, atol: of each number.
        misses: share of numbers that may be further off.
    """

    make: Callable[[], Model]
    camera: Camera
    size: int
    side: float
    uv_mm: float = 100.0
    passes: int = 1
    expected: Expected = of_the_model
    rtol: float = 1e-2
    atol: float = 1e-4
    misses: float = 0.0


def field_of(width: float, distance: float) -> float:
    """Degrees across so many metres from so far away."""
    return float(2 * np.degrees(np.arctan(width / 2 / distance)))


def latent_of_plain() -> Any:
    return random_latent(mips="stochastic")


# A pixel of `latent` is 1.4 texels wide.
PIXEL = 1.4e-3 * latent_of_plain().weights.shape.texel_mm
FRAMES = {
    # Positions agree to 1e-5 of the picture: taps and points beside an edge take its other side.
    "lobes": Frame(lambda: model_of("lobes, denim"), Camera((0, -0.36, 0.48)), 32, 0.5, misses=0.02),
    "neural": Frame(lambda: model_of("neural, denim"), Camera((0, 0, 0.05), up=(0, 1, 0)), 16, 0.1),
    # Texels are halves here.
    "neumip": Frame(random_neumip, Camera((0, 0, 0.02), up=(0, 1, 0)), 9, 0.016, 16.0, atol=4e-3),
    # Of 256 choices of an even sequence the share of each level is exact to a hundredth.
    "latent": Frame(
        latent_of_plain,
        Camera((0, 0, 0.02), up=(0, 1, 0), field_of_view=field_of(5 * PIXEL, 0.02)),
        5,
        4e-3,
        4.0,
        passes=256,
        expected=of_both_levels,
        rtol=0,
        atol=6e-3,
    ),
    # A pixel of a millimetre; means of 1024 texels.
    "clustered": Frame(
        lambda: small_clustered(1),
        Camera((0, 0, 0.02), up=(0, 1, 0), field_of_view=field_of(1e-3, 0.02)),
        1,
        0.1,
        passes=512,
        expected=of_many_seeds,
        rtol=0.05,
        atol=0.02,
    ),
}


def seen_by(frame: Frame) -> tuple[NDArray[Any], Footprint]:
    """Views [n, 3] and footprints of a frame's pixels, row by row, derived from the camera alone."""
    axes = frame.camera.axes(frame.size, frame.size)

    def on_cloth(row: NDArray[Any], column: NDArray[Any]) -> NDArray[Any]:
        right, up = 2 * column[..., None] / frame.size - 1, 1 - 2 * row[..., None] / frame.size
        ray = axes["forward"] + right * axes["right"] + up * axes["up"]
        return axes["origin"] - ray * (axes["origin"][2] / ray[..., 2:])

    row, column = (part.ravel() + 0.5 for part in np.mgrid[: frame.size, : frame.size].astype(float))
    centre, scale, step = on_cloth(row, column), frame.uv_mm / frame.side, 1e-3
    dx = (on_cloth(row, column + step) - on_cloth(row, column - step))[:, :2] * (scale / (2 * step))
    dy = (on_cloth(row + step, column) - on_cloth(row - step, column))[:, :2] * (scale / (2 * step))
    view = axes["origin"] - centre
    view /= np.linalg.norm(view, axis=1, keepdims=True)
    return view, Footprint(pairs((centre[:, :2] + frame.side / 2) * scale), pairs(dx), pairs(dy))


@pytest.mark.slow
@pytest.mark.parametrize("name", FRAMES)
def test_a_frame_shades_the_footprints_of_its_pixels(name: str) -> None:
    """Estimates tend to the mean. Of `point`, tests/realtime/test_renderer.py asks."""
    frame = FRAMES[name]
    model = frame.make()
    cloth = Cloth(rectangle(frame.side, frame.side), model, (frame.uv_mm, frame.uv_mm))
    renderer = Renderer([cloth], (frame.size, frame.size))
    assert renderer.model == name
    sun = DirectionalLight(SUN, (1.0, 1.0, 1.0))
    picture = renderer.render(frame.camera, [sun], passes=frame.passes, background=(0, 0, 0)).linear
    view, footprint = seen_by(frame)
    light = vectors(np.broadcast_to(SUN, view.shape))
    expected, through = frame.expected(model, vectors(view), footprint, light)
    assert expected.max() > 0.01
    found = picture[..., :3].reshape(-1, 3)
    misses = np.abs(found - expected) > frame.atol + frame.rtol * np.abs(expected)
    assert misses.mean() <= frame.misses, np.abs(found - expected).max()
    assert found.mean() == pytest.approx(expected.mean(), rel=max(frame.rtol, 1e-3), abs=frame.atol)
    opaque = 1 - np.broadcast_to(through, frame.size**2)
    assert np.mean(np.abs(picture[..., 3].ravel() - opaque) > max(frame.atol, 1e-3)) <= frame.misses
