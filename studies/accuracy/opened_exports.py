"""Exports opened by engines beside `loomlight render`: a cushion by glTF and USD, under a sun and a sky.

The cushion of the examples, seen from its front so that a pixel is a texel of the textures (1080 rows and 26°
of view are cut to a square). Mitsuba shows `lobes`; three.js, Babylon.js, Filament and PlayCanvas show what
their own loaders make of the files in Chromium, USD as UsdPreviewSurface; Godot, where it is asked for, shows
the density of its pack that is for the distance. Of an even sky no engine's filter of surroundings can be
wrong, so that the light is the same for all.

Cards of one material, seen from straight above, say what is an engine's own: how bright it shows them by the
sky and by the sun, over the formulas of glTF.
"""

from __future__ import annotations

import tempfile
from collections.abc import Collection
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import delta_e_2000, lab_of_linear, srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import GarmentSettings
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.exporters.engines import FAR_METRES, write_godot
from loomlight.exporters.fit import TEXEL_FIELDS, FittedMaterial
from loomlight.exporters.garment import clothed_garment
from loomlight.exporters.garment_gltf import garment_glb, textures_of
from loomlight.exporters.materials import fitted
from loomlight.exporters.standards import StandardMaterial, evaluate_gltf
from loomlight.exporters.usd import write_package
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import load_fabric
from loomlight.mesh.reading import read_mesh
from loomlight.mitsuba import choose_variant, material_bsdf, render, to_shape, uv_size
from studies.harness.study import EXAMPLES, Figures, Found, Run, Study, example, listed, names, on_display
from studies.instruments.engine_page import ENGINES, EnginePage, Light, engine_page, missing
from studies.instruments.godot import Job, drawn_by_godot, godot
from studies.instruments.sheet import Row, Tile, contact_sheet

FABRICS = ("denim", "linen", "silk-satin", "wool-houndstooth", "tweed", "organza")
# From the camera to the front of the cushion, metres.
DISTANCES = {"30 cm": 0.3, "1 m": 1.0, "2 m": 2.0}
_MESH, _FRONT = EXAMPLES / "cushion.obj", 0.09
_ROWS, _DEGREES, _SECONDS, _GODOT_SECONDS = 1080, 26.0, 120.0, 900.0
# Radiance of the sky, irradiance across the rays of the sun, and where it stands.
_SKY, _SUN = 0.25, float(np.pi)
_TO_SUN = (-0.4466, 0.4963, 0.7444)
LIGHTS = {"sun": Light(_SKY, _SUN, _TO_SUN), "sky": Light(_SKY)}
# What is opened in an engine: the file, by its format.
FILES = {"glTF": "cloth.glb", "USD": "cloth.usdz"}
PAGES = {
    **{f"glTF in {engine}": (engine, FILES["glTF"]) for engine in ENGINES},
    "USD in three.js": ("three.js", FILES["USD"]),
}
PACK, _PACK_FOLDER = "pack in Godot", "pack"
PROGRAMS = (*PAGES, PACK)


@dataclass(frozen=True)
class OpenedExports(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    distances: str = names(",".join(DISTANCES), "From the camera to the cloth.", tuple(DISTANCES))
    programs: str = names(",".join(PAGES), "What opens what.", PROGRAMS)
    light: str = names("sun", "A sun and an even sky, or the sky alone.", tuple(LIGHTS))
    cards: bool = setting(True, "Also compares cards of one material with glTF's formulas.")
    side: int = setting(256, "Pixels of a picture.", low=8)
    spp: int = setting(64, "Samples a pixel of Mitsuba's pictures.", low=1)


def measure(settings: OpenedExports, run: Run) -> Found:
    """FLIP, the difference of mean colours and the ratio of means, by fabric, distance and program."""
    asked = listed(settings.programs)
    programs = {name: PAGES[name] for name in asked if name in PAGES}
    for engine, _ in programs.values():
        if missing(engine):
            raise InputError(f"accuracy/opened_exports draws with {engine}, and {missing(engine)}.")
    if PACK in asked and godot() is None:
        raise InputError("accuracy/opened_exports draws with Godot 4, and no program `godot` is installed.")
    choose_variant(None)
    fabrics, distances = listed(settings.fabrics), listed(settings.distances)
    truths: dict[str, NDArray[np.float32]] = {}
    sizes: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as temporary:
        root = Path(temporary)
        # 1. What Mitsuba shows, and the files.
        for name, label in product(fabrics, distances):
            fabric, place = load_fabric(example(name)), f"{name}, {label}"
            truths[place] = _by_mitsuba(fabric, DISTANCES[label], settings)
            _export(fabric, fitted(fabric, "lobes", DISTANCES[label]), root / place)
            if PACK in asked:
                far = DISTANCES[label] if DISTANCES[label] >= FAR_METRES else None
                write_godot(root / place / _PACK_FOLDER, fabric, "lobes", far)
            sizes |= {
                f"{place}/{file.name}": sum(each.stat().st_size for each in (file, *file.rglob("*"))) / 1e6
                for file in (root / place).iterdir()
            }
            run.report(len(truths), 2 * len(fabrics) * len(distances))
        cards = _write_cards(root) if settings.cards else {}
        # 2. What engines show, each in one page: to start it takes longer than to draw.
        drawn: dict[tuple[str, str], NDArray[np.float32]] = {}
        shown: list[Figures] = []
        for engine in dict.fromkeys(engine for engine, _ in programs.values()):
            with engine_page(root, _SECONDS, engine=engine) as page:
                for card, expected in cards.items():
                    shown.append({"card": card, "engine": engine} | _of_card(page, card, expected))
                for (program, (of_program, file)), place in product(programs.items(), truths):
                    if of_program == engine:
                        distance = DISTANCES[place.partition(", ")[2]]
                        drawn[program, place] = _by_engine(page, f"{place}/{file}", distance, settings)
        if PACK in asked:
            drawn |= {(PACK, place): picture for place, picture in _by_godot(root, truths, settings).items()}
    # 3. How far they are apart.
    rows, tiles = [], []
    for place, truth in truths.items():
        name, _, label = place.partition(", ")
        row = [Tile(on_display(truth))]
        for program in asked:
            picture = drawn[program, place]
            found = _errors(picture, truth)
            said = {"fabric": name, "distance": label, "program": program}
            file = _PACK_FOLDER if program == PACK else programs[program][1]
            rows.append(said | {"megabytes": sizes[f"{place}/{file}"]} | found)
            row.append(Tile(on_display(picture), f"FLIP {found['flip']:.3f}, × {found['brightness']:.2f}"))
        tiles.append(Row(place, row))
    sheet = contact_sheet("Exports in engines", ["loomlight render", *asked], tiles)
    return Found({"pictures": rows, "cards": shown}, sheet)


def _export(fabric: Fabric, fit: FittedMaterial, folder: Path, mesh: Path = _MESH) -> None:
    """A mesh in a material that is fitted already, as both files in a new folder."""
    folder.mkdir()
    garment = clothed_garment(fabric, GarmentSettings(mesh=mesh), lambda _: fit)
    (folder / FILES["glTF"]).write_bytes(
        garment_glb(garment, [textures_of(cloth) for cloth in garment.cloths])
    )
    write_package(folder / FILES["USD"], garment)


def _view(distance: float, side: int) -> tuple[tuple[float, float, float], float]:
    """Where the camera stands, and its field of view, degrees."""
    half = np.tan(np.radians(_DEGREES / 2)) * side / _ROWS
    return (0.0, 0.0, _FRONT + distance), float(2 * np.degrees(np.arctan(half)))


def _by_mitsuba(fabric: Fabric, distance: float, settings: OpenedExports) -> NDArray[np.float32]:
    mesh, light = read_mesh(_MESH), LIGHTS[settings.light]
    eye, degrees = _view(distance, settings.side)
    towards: Any = mi.ScalarTransform4f().look_at(list(eye), [0, 0, 0], [0, 1, 0])
    film = {"type": "hdrfilm", "width": settings.side, "height": settings.side, "rfilter": {"type": "box"}}
    parts: dict[str, Any] = {
        "type": "scene",
        "shape": to_shape(mesh, material_bsdf(fabric)(uv_size(mesh, 1.0))),
        "sky": {"type": "constant", "radiance": {"type": "rgb", "value": light.sky}},
        "sensor": {"type": "perspective", "fov": degrees, "to_world": towards, "film": film},
    }
    if light.sun > 0:
        downwards = [-part for part in light.to_sun]
        sun = {"type": "rgb", "value": light.sun}
        parts["sun"] = {"type": "directional", "direction": downwards, "irradiance": sun}
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 4})
    return render(mi.load_dict(parts), spp=settings.spp, integrator=integrator, denoise="off")


def _by_engine(page: EnginePage, file: str, distance: float, settings: OpenedExports) -> NDArray[np.float32]:
    eye, degrees = _view(distance, settings.side)
    light = LIGHTS[settings.light]
    _, picture = page.draw(file, eye, degrees=degrees, side=settings.side, light=light)
    return srgb_to_linear(picture / 255).astype(np.float32)


def _by_godot(root: Path, places: Collection[str], settings: OpenedExports) -> dict[str, NDArray[np.float32]]:
    """Pictures of packs, each of the density that is for its distance."""
    metres = uv_size(read_mesh(_MESH))[0] / 1000
    found = {}
    for place in places:
        folder, distance = root / place / _PACK_FOLDER, DISTANCES[place.partition(", ")[2]]
        far = next(folder.glob("*_far.tres"))
        file = far.name if distance >= FAR_METRES else far.name.replace("_far.", "_near.")
        job = Job(file, *_view(distance, settings.side), settings.side, LIGHTS[settings.light])
        (picture,) = drawn_by_godot(folder, _MESH, metres, [job], _GODOT_SECONDS)
        found[place] = srgb_to_linear(picture / 255).astype(np.float32)
    return found


def _errors(picture: NDArray[np.float32], truth: NDArray[np.float32]) -> Figures:
    means = [each.reshape(-1, 3).mean(axis=0) for each in (picture, np.clip(truth, 0, 1))]
    return {
        "flip": flip_mean(picture, truth, np.ones(truth.shape[:2], bool)),
        "colour_difference": float(delta_e_2000(*map(lab_of_linear, means))),
        "brightness": float(means[0].mean() / means[1].mean()),
    }


# ---------------------------------------------------------------------------------------------------- cards

# Base colour, reflectance at normal incidence, at grazing angles, α along x and along y.
CARDS = {
    "matt": (0.5, 0.0, 0.0, 1.0, 1.0),
    "glossy as glass": (0.0, 0.04, 1.0, 0.3, 0.3),
    "glossy as yarns": (0.0, 0.4, 0.12, 0.3, 0.3),
    "anisotropic": (0.0, 0.4, 0.12, 0.6, 0.15),
}
_CARD_MM, _RAYS = 25.0, 1 << 18


def _write_cards(root: Path) -> dict[str, tuple[float, float]]:
    """Writes folders of cards, and returns what glTF's formulas show of each by the sky and by the sun."""
    square = root / "square.obj"
    corners = [(x, y) for y in (0, 1) for x in (0, 1)]
    lines = [f"v {x - 0.5} {y - 0.5} 0\nvt {x} {y}" for x, y in corners]
    square.write_text("\n".join([*lines, "f 1/1 2/2 4/4 3/3", ""]), encoding="utf-8")
    found = {}
    for name, numbers in CARDS.items():
        card = _card(*numbers)
        _export(load_fabric("plain"), card, root / name, square)
        found[name] = _by_formula(card)
    return found


def _of_card(page: EnginePage, name: str, expected: tuple[float, float]) -> Figures:
    """How bright an engine shows a card by the sky and by the sun, over the formulas."""
    lights = (Light(_SKY), Light(0.0, _SUN, _TO_SUN))
    sky, sun = (_mean_of_card(page, name, light) / due for light, due in zip(lights, expected, strict=True))
    return {"sky": float(sky), "sun": float(sun)}


def _card(base: float, reflectance: float, grazing: float, along_x: float, along_y: float) -> FittedMaterial:
    """A material of the same numbers in all texels."""

    def texels(value: float | list[float]) -> NDArray[np.float64]:
        return np.array(np.broadcast_to(value, (4, 4, *np.shape(value))), np.float64)

    is_wide_along_x = along_x >= along_y
    x, y = [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    return FittedMaterial(
        base=texels([base] * 3),
        transmission=texels(0.0),
        transmit=texels([0.0] * 3),
        specular=texels([reflectance] * 3),
        weight=grazing,
        alpha_x=texels(max(along_x, along_y)),
        alpha_y=texels(min(along_x, along_y)),
        normal=texels([0.0, 0.0, 1.0]),
        axis_x=texels(x if is_wide_along_x else y),
        axis_y=texels(y if is_wide_along_x else [-1.0, 0.0, 0.0]),
        sheen=np.zeros(3),
        sheen_roughness=0.5,
        size=(_CARD_MM, _CARD_MM),
        cover=texels(1.0),
        height=texels(0.0),
        direction=texels((x if is_wide_along_x else y)[:2]),
        error=0.0,
        brightness=1.0,
    )


def _by_formula(card: FittedMaterial) -> tuple[float, float]:
    """What the formulas of glTF show of a card by the sky and by the sun, from straight above."""

    def shown(light: NDArray[np.float64]) -> NDArray[np.float64]:
        count = len(light)
        texel = {name: np.repeat(getattr(card, name)[:1, 0], count, axis=0) for name in TEXEL_FIELDS}
        material = StandardMaterial(
            **texel, weight=card.weight, sheen=card.sheen, sheen_roughness=card.sheen_roughness
        )
        return evaluate_gltf(material, light, np.broadcast_to([0.0, 0.0, 1.0], light.shape)).mean(axis=-1)

    rng = np.random.default_rng(1)
    cosine, azimuth = rng.uniform(size=_RAYS), rng.uniform(0, 2 * np.pi, _RAYS)
    sine = np.sqrt(1 - cosine**2)
    sky = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)
    by_sky = float(shown(sky).mean() * 2 * np.pi * _SKY)
    return by_sky, float(shown(np.array([_TO_SUN]))[0] * _SUN)


def _mean_of_card(page: EnginePage, name: str, light: Light) -> float:
    eye, degrees = _view(0.3, 64)
    _, picture = page.draw(f"{name}/{FILES['glTF']}", eye, degrees=degrees, side=64, light=light)
    return float(srgb_to_linear(picture / 255).mean())


def tables(figures: Figures) -> list[Table]:
    """Errors by fabric, distance and program."""
    columns = ["FLIP", "CIEDE2000 of mean colours", "brightness over render's"]
    rows = {
        f"{row['fabric']}, {row['distance']}, {row['program']}": [
            row["flip"],
            row["colour_difference"],
            row["brightness"],
        ]
        for row in figures["pictures"]
    }
    cards = {f"{row['card']}, {row['engine']}": [row["sky"], row["sun"]] for row in figures.get("cards", [])}
    found = [Table("Exports opened by engines", columns, rows)]
    if cards:
        found.append(Table("Cards opened by engines", ["by an even sky", "by a sun"], cards))
    return found


# What tests run.
_SMALL = {
    "fabrics": "denim",
    "distances": "2 m",
    "programs": "glTF in three.js",
    "side": 32,
    "spp": 4,
    "cards": False,
}
STUDIES = (
    Study(
        "accuracy/opened_exports",
        "how near what engines show of glTF and USD comes to `loomlight render`, on a cushion",
        OpenedExports(),
        measure,
        tables,
        stands_on=("lobes",),
        small=_SMALL,
    ),
    Study(
        "accuracy/opened_exports_godot",
        "how near what Godot shows of its pack comes to `loomlight render`, on a cushion",
        OpenedExports(
            fabrics="denim,silk-satin,organza",
            distances="2 m",
            programs=PACK,
            side=128,
            spp=24,
            cards=False,
        ),
        measure,
        tables,
        stands_on=("lobes",),
        small=_SMALL,
    ),
)
