"""The pictures of README and docs, by one command; it says which are older than what they show.

    python -m tools.generate.pictures                 # lists all: as shown today, older, or not known
    python -m tools.generate.pictures demo.jpg …      # makes these anew
    python -m tools.generate.pictures --older         # makes those that are older
    python -m tools.generate.pictures --all           # takes an hour of processor time: trainings too

Each picture is made by the commands of its recipe, as a user types them. `docs/images/made.json` keeps how
it was made, and what it stands on: small renders, which cloth, scene and light change and comments do not, or
the sources of shaders and of the page.
"""

from __future__ import annotations

import glob
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
from argparse import ArgumentParser, RawDescriptionHelpFormatter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from loomlight.core.files import replacing
from loomlight.core.provenance import provenance

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
MADE = IMAGES / "made.json"
# Of the mean of a small render: further off, a picture looks different to an eye that compares.
TOLERANCE = 0.03
_QUALITY = 84  # of JPEG


@dataclass(frozen=True)
class Recipe:
    """How a picture is made, and what it stands on.

    Attributes:
        commands: `loomlight …` or `MODULE …` of this repository, run one after the other; `{out}` is an empty
            folder, in which the last one leaves the picture.
        shows: names of `PROBES`.
        picture: what the last command writes, below `{out}`.
    """

    commands: tuple[str, ...]
    shows: tuple[str, ...] = ("renders",)
    picture: str = "picture.png"


def _learned(source: str, model: str, settings: str = "") -> Recipe:
    """A material of the gallery, beside its source."""
    return Recipe(
        (
            f"loomlight bake {source} --model {model} {settings}-o {{out}}/material.loom",
            f"tools.generate.source_pictures {{out}}/picture.png {source} {{out}}/material.loom",
        )
    )


_MATERIALS = "examples/materials"
_LAYERED = ("glazed-ceramic", "brushed-metal", "rough-plastic", "patinated-metal")
_FIBRES = "--set resolution=64 --set steps=2000 "
RECIPES: dict[str, Recipe] = {
    "demo.jpg": Recipe(("loomlight demo -o {out}/picture.png",)),
    "swatches.jpg": Recipe(
        ("loomlight swatches examples/*.toml -o {out}/picture.png --size 160 --spp 4 --model lobes",)
    ),
    "studio.jpg": Recipe(("loomlight render examples/denim.toml -o {out}/picture.png",)),
    "distances.jpg": Recipe(("studies look/distances -o {out}",), picture="look/distances.png"),
    "garments.jpg": Recipe(("tools.generate.garment_sheet shirt -o {out}/picture.png",)),
    "garment-shapes.jpg": Recipe(("tools.generate.garment_sheet shapes -o {out}/picture.png",)),
    "garment-maps.jpg": Recipe(("tools.generate.garment_sheet maps -o {out}/picture.png",)),
    "views.jpg": Recipe(("tools.generate.view_sheet -o {out}/picture.png",)),
    "u3m.jpg": Recipe(("tools.generate.u3m_sheet -o {out}/picture.png",)),
    "artwork.jpg": Recipe(("tools.generate.artwork_sheet -o {out}/picture.png",)),
    "layered.jpg": Recipe(("tools.generate.layered_sheet -o {out}/picture.png",)),
    "edges.jpg": Recipe(("tools.generate.edge_pictures -o {out}/picture.png",)),
    "daybed.jpg": Recipe(
        (
            "loomlight render examples/harris-tweed.toml --mesh examples/daybed.usdc --camera from_the_door "
            "--cloth front=examples/wool-houndstooth.toml --cloth linen=examples/linen.toml "
            "--cloth bolster=examples/denim.toml -o {out}/picture.png",
        )
    ),
    "moving-cloth.webp": Recipe(
        (
            "examples.makers.towel -o {out}/frames",
            "loomlight render examples/wool-houndstooth.toml --mesh '{out}/frames/*.obj' --scale 4 "
            "--size 320x240 -o {out}/picture.webp",
        ),
        picture="picture.webp",
    ),
    "yarns.jpg": Recipe(("studies look/yarns -o {out}",), picture="look/yarns.png"),
    "yarn-gaps.jpg": Recipe(("studies look/yarn_gaps -o {out}",), picture="look/yarn_gaps.png"),
    "yarn-fibres.jpg": Recipe(("studies look/yarn_fibres -o {out}",), picture="look/yarn_fibres.png"),
    "yarn-flanks.jpg": Recipe(("studies accuracy/flanks -o {out}",), picture="accuracy/flanks.png"),
    "blender.jpg": Recipe(
        ("studies accuracy/blender --spp 16 --blender-spp 16 -o {out}",),
        picture="accuracy/blender.png",
    ),
    "measured-cloth.jpg": Recipe(
        ("studies accuracy/measured_cloth -o {out}",), picture="accuracy/measured_cloth.png"
    ),
    "which-model.jpg": Recipe(("tools.generate.model_sheet {out}/picture.png",)),
    "neural.jpg": Recipe(("studies papers/chen2024/fig5 -o {out}",), picture="papers/chen2024/fig5.png"),
    "editor-artwork.jpg": Recipe(("tools.generate.editor_picture {out}/picture.png --artwork",), ("page",)),
    "editor.png": Recipe(("tools.generate.editor_picture {out}/picture.png",), ("page",)),
    "realtime.png": Recipe(("tools.generate.frame_picture {out}/picture.png",), ("shaders",)),
    "realtime_play.png": Recipe(
        ("loomlight play examples/denim.toml -o {out}/picture.png --size 480x360 --passes 16",), ("shaders",)
    ),
    "export-sample.png": Recipe(
        (
            "loomlight export examples/denim.toml --to wgsl -o {out}/denim-wgsl",
            "{out}/denim-wgsl/sample.py",
        ),
        ("shaders",),
        "denim-wgsl/sample.png",
    ),
    "neumip-twisted-wool.png": Recipe(
        (
            "loomlight bake examples/twisted-wool/twisted-wool.toml --model neumip -o {out}/wool.loom",
            "loomlight render {out}/wool.loom -o {out}/picture.png --size 480x360",
        )
    ),
    "neumip-basket-fibres.png": Recipe(
        (
            'examples.makers.fibre_tile "basket 2/2" {out}/basket',
            "tools.generate.source_pictures {out}/picture.png {out}/basket/basket.toml",
        )
    ),
    "latent-materials.jpg": Recipe(
        (
            *(
                f"loomlight bake {_MATERIALS}/{name}/{name}.toml --model latent -o {{out}}/{name}.loom"
                for name in _LAYERED
            ),
            "tools.generate.source_pictures --below --side 280 {out}/picture.png "
            + " ".join(f"{_MATERIALS}/{name}/{name}.toml {{out}}/{name}.loom" for name in _LAYERED),
        )
    ),
    "learned-jersey.jpg": _learned("examples/jersey/jersey.toml", "neumip", _FIBRES),
    "learned-corduroy.jpg": _learned("examples/corduroy/corduroy.toml", "neumip", _FIBRES),
    "learned-leather.jpg": _learned(
        "examples/leather/leather.toml", "neumip", "--set resolution=128 --set steps=2500 "
    ),
    "learned-metal.jpg": _learned(f"{_MATERIALS}/brushed-metal/brushed-metal.toml", "latent"),
    "learned-ceramic.jpg": _learned(f"{_MATERIALS}/glazed-ceramic/glazed-ceramic.toml", "latent"),
    "learned-library.jpg": Recipe(
        (
            "examples.makers.merl_library {out}/library",
            "loomlight bake {out}/library --model latent -o {out}/material.loom",
            "tools.generate.source_pictures {out}/picture.png {out}/library {out}/material.loom",
        )
    ),
}


# ------------------------------------------------------------------------------ what pictures stand on


def small_renders() -> dict[str, list[float]]:
    """Means of 4 by 3 fields of small pictures, by fabric and scene: cloth, surroundings, light, exposure."""
    from loomlight.mitsuba.pictures import render

    found = {}
    for fabric in ("denim", "linen"):
        for scene, zoom in (("flat", 20.0), ("drape", 1.0), ("sphere", 4.0)):
            picture = render(
                ROOT / "examples" / f"{fabric}.toml", scene, size=(32, 24), spp=64, zoom=zoom, denoise="off"
            )
            fields = np.asarray(picture).reshape(3, 8, 4, 8, -1).mean(axis=(1, 3, 4))
            found[f"{fabric} {scene}"] = [round(float(value), 4) for value in fields.ravel()]
    return found


def _digest(*patterns: str) -> dict[str, list[float]]:
    """One number of all files that match, a part of their SHA-256."""
    content = hashlib.sha256()
    for file in sorted(path for pattern in patterns for path in ROOT.glob(pattern)):
        content.update(file.read_bytes())
    return {"sources": [float(int(content.hexdigest()[:12], 16))]}


PROBES: dict[str, Callable[[], dict[str, list[float]]]] = {
    "renders": small_renders,
    "shaders": lambda: _digest("src/loomlight/realtime/shaders/wgsl/*.wgsl"),
    "page": lambda: _digest(
        "web/editor/src/**/*.ts*", "web/editor/src/**/*.css", "web/loomlight-web/src/*.ts"
    ),
}


@cache
def probed(name: str) -> dict[str, list[float]]:
    """A probe of today."""
    return PROBES[name]()


def difference(before: Mapping[str, list[float]], now: Mapping[str, list[float]]) -> tuple[str, float]:
    """Which part of a probe differs most, and by how much of its mean."""
    worst = ("", 0.0)
    for name, values in now.items():
        old, new = np.array(before.get(name, [])), np.array(values)
        off = float(np.abs(old - new).max() / new.mean()) if old.shape == new.shape else float("inf")
        worst = max(worst, (name, off), key=lambda found: found[1])
    return worst


def ages(made: Mapping[str, Any], now: Mapping[str, Mapping[str, list[float]]]) -> dict[str, str]:
    """What is to be said of each picture: "as shown today", "older: …" or "not known"."""
    said = {}
    for name, recipe in RECIPES.items():
        if name not in made:
            said[name] = "not known: made before this list"
            continue
        kept = made[name]["stands on"]
        part, off = max(
            (difference(kept.get(probe, {}), now[probe]) for probe in recipe.shows), key=lambda d: d[1]
        )
        is_digest = recipe.shows != ("renders",)
        if off <= (0 if is_digest else TOLERANCE):
            said[name] = "as shown today"
        else:
            said[name] = f"older: {part} changed" + ("" if is_digest else f" by {100 * off:.0f} %")
    return said


# ----------------------------------------------------------------------------------------- making them


def words_of(command: str, out: str) -> list[str]:
    """The words of a recipe's command: Python, and the module or file that it runs."""
    command = command.replace("{out}", out)
    first, *rest = shlex.split(command)
    quoted = re.findall(r"'([^']*)'", command)
    words: list[str] = []
    for part in rest:
        is_pattern = "*" in part and part not in quoted
        words += sorted(glob.glob(part, root_dir=ROOT)) if is_pattern else [part]
    return [sys.executable, *([first] if first.endswith(".py") else ["-m", first]), *words]


def make(name: str) -> dict[str, Any]:
    """Makes a picture anew; what is to be kept of how.

    Raises:
        CalledProcessError: a command failed.
    """
    recipe = RECIPES[name]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        for command in recipe.commands:
            words = words_of(command, folder)
            place = Path(words[1]).parent if words[1].endswith(".py") else ROOT
            environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT / "src"), str(ROOT)])}
            subprocess.run(words, cwd=place, check=True, env=environment)
        with Image.open(Path(folder) / recipe.picture) as picture, replacing(IMAGES / name) as temporary:
            if getattr(picture, "is_animated", False):
                shutil.copyfile(Path(folder) / recipe.picture, temporary)
            else:
                picture.convert("RGB").save(temporary, quality=_QUALITY, optimize=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {
        **provenance(" && ".join(recipe.commands), ROOT),
        "processor_seconds": round(spent),
        "stands on": {probe: probed(probe) for probe in recipe.shows},
    }


def main() -> None:
    """Lists the pictures, or makes some."""
    parser = ArgumentParser(description=__doc__, formatter_class=RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="PICTURE", choices=[[], *RECIPES])
    parser.add_argument("--older", action="store_true", help="those that are older than what they show")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    made = json.loads(MADE.read_text()) if MADE.exists() else {}
    names = list(RECIPES) if options.all else options.names
    if not names:
        said = ages(made, {name: probed(name) for name in PROBES})
        if not options.older:
            for name, sentence in said.items():
                print(f"{name:26}{sentence}")
            return
        names = [name for name, sentence in said.items() if sentence.startswith("older")]
    for name in names:
        print(name, flush=True)
        made[name] = make(name)
        with replacing(MADE) as temporary:
            temporary.write_text(json.dumps(dict(sorted(made.items())), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
