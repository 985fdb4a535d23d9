"""Table 3: the time of a picture by parts: encoder, network, and the rest of the renderer.

The paper's columns are network and "others" (intersection, transfer, shading); its encoder, once a fabric or
edit, stands outside of the sum, as it does here. The network is the decoder, which also fetches latents;
holes ask for a part of it. Others hold Python that traces and launches kernels, much the same for any number
of pixels. Times are processor milliseconds on one thread.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from loomlight.core.llvm import llvm_float
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.measured_scenes import MeasuredShot
from loomlight.models.neural.decoder import CompiledDecoder
from loomlight.models.neural.encoding import encode
from studies.harness.study import Found, Run, Study, on_display
from studies.instruments.renders import one_picture
from studies.instruments.sheet import Tile, contact_sheet, in_two_rows
from studies.instruments.timing import Spent, one_thread, spent
from studies.papers.chen2024.cache import without_cached_latents
from studies.papers.chen2024.fabrics import Look, paper_fabric, unseen_fabrics
from studies.papers.chen2024.shots import BACKLIT, BALL, CYLINDER, DRAPE
from studies.papers.chen2024.stage import NetworkSettings

_TIMES = 3


@dataclass(frozen=True)
class NetworkTime:
    """The time of a picture, and of the network in it.

    Attributes:
        picture: kernels compiled beforehand.
        network: of the decoder.
    """

    picture: Spent
    network: Spent


def network_time(run: Callable[[], object]) -> NetworkTime:
    """Renders a picture of a scene with networks and measures its parts; compile it beforehand."""
    before = CompiledDecoder.seconds, CompiledDecoder.cpu_seconds
    _, picture = spent(run)
    network = Spent(CompiledDecoder.seconds - before[0], CompiledDecoder.cpu_seconds - before[1])
    return NetworkTime(picture, network)


def split(settings: NetworkSettings, run: Run) -> Found:
    """Table 3: milliseconds of network and others in each scene."""
    table = Table(
        "Processor milliseconds of a picture",
        ["network", "others", "sum", "network's share", "encoder, once"],
        note=f"{settings.size[0]} × {settings.size[1]} pixels, one sample, direct light, one thread; the "
        f"least of {_TIMES} pictures after a first one. The encoder's are of both faces and not in the sum.",
    )
    tiles, pictures = [], {}
    scenes = _scenes()
    for number, (name, (shot, fabric)) in enumerate(scenes.items()):
        scene = settings.stage(shot, fabric).neural_scene()
        with one_thread():
            picture = on_display(one_picture(scene, 1))
            taken = min(
                (network_time(partial(one_picture, scene, 1)) for _ in range(_TIMES)),
                key=lambda time: time.picture.cpu_seconds,
            )
        network, whole = taken.network.cpu_seconds, taken.picture.cpu_seconds
        encoder = _encoder_seconds(settings, fabric)
        parts = [1e3 * seconds for seconds in (network, whole - network, whole)]
        table.rows[name] = [*parts, network / whole, 1e3 * encoder]
        tiles.append(Tile(picture, f"{name}: network {1e3 * network:.0f} of {1e3 * whole:.0f} ms"))
        pictures[name] = picture
        run.report(number + 1, len(scenes))
    sheet = contact_sheet("chen2024 table 3: where the time goes", [], in_two_rows(tiles), table.note)
    return Found(settings.figures(table), sheet, pictures)


def _scenes() -> dict[str, tuple[MeasuredShot, Fabric]]:
    backlit = Look(("#c9b58f", "#e6dcc4"), translucency=0.4)
    return {
        "drape, satin 8×8": (DRAPE, paper_fabric("satin 8×8")),
        "ball, twill 4×4": (BALL, unseen_fabrics()[0]),
        "cylinder, plain": (CYLINDER, paper_fabric("plain")),
        "backlit, plain": (BACKLIT, paper_fabric("plain", backlit)),
    }


def _encoder_seconds(settings: NetworkSettings, fabric: Fabric) -> float:
    """Processor seconds of both faces, the least of some runs, the first of which compiles."""
    network, seconds = settings.network(), []
    for _ in range(_TIMES):
        with without_cached_latents():
            seconds.append(spent(lambda: encode(fabric, network, llvm_float()))[1].cpu_seconds)
    return min(seconds)


STUDY = Study(
    "papers/chen2024/table3",
    "the time of a picture: network, others, encoder",
    NetworkSettings(),
    split,
    stands_on=("neural", "picture"),
    small={"size": (24, 16)},
)
