"""Table 3: the time of a picture by parts: encoder, network, and the rest of the renderer.

The paper's columns are network and "others" (intersection, transfer, shading); its encoder, once a fabric or
edit, stands outside of the sum, as it does here. The network is the decoder, which also fetches latents;
holes ask for a part of it. "Host" is Python that traces and launches kernels, much the same for any number of
pixels.
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
from studies.instruments.timing import launched_kernels, timed
from studies.papers.chen2024.cache import without_cached_latents
from studies.papers.chen2024.fabrics import Look, paper_fabric, unseen_fabrics
from studies.papers.chen2024.shots import BACKLIT, BALL, CYLINDER, DRAPE
from studies.papers.chen2024.stage import NetworkSettings

_TIMES = 3


@dataclass(frozen=True)
class NetworkTime:
    """The time of a picture by parts, seconds.

    Attributes:
        seconds: of the whole picture, kernels compiled beforehand.
        network: of the decoder.
        others: of all Dr.Jit kernels; the rest of `seconds` is the host's.
    """

    seconds: float
    network: float
    others: float

    @property
    def host(self) -> float:
        """Seconds outside of kernels: Python, tracing, launches."""
        return max(self.seconds - self.network - self.others, 0.0)


def network_time(run: Callable[[], object]) -> NetworkTime:
    """Renders a picture of a scene with networks and measures its parts; compile it beforehand."""
    before, seconds = CompiledDecoder.seconds, 0.0

    def picture() -> None:
        nonlocal seconds
        _, seconds = timed(run)

    others = sum(kernel["execution_time"] for kernel in launched_kernels(picture)) / 1e3
    return NetworkTime(seconds, CompiledDecoder.seconds - before, others)


def split(settings: NetworkSettings, run: Run) -> Found:
    """Table 3: milliseconds of network and others in each scene."""
    table = Table(
        "Milliseconds of a picture",
        ["network", "other kernels", "host", "sum", "network's share", "encoder, once"],
        note=f"{settings.size[0]} × {settings.size[1]} pixels, one sample, direct light; the fastest of "
        f"{_TIMES} pictures after a first one. The encoder's are both faces and stand outside of the sum.",
    )
    tiles, pictures = [], {}
    scenes = _scenes()
    for number, (name, (shot, fabric)) in enumerate(scenes.items()):
        scene = settings.stage(shot, fabric).neural_scene()
        picture = on_display(one_picture(scene, 1))
        spent = min(
            (network_time(partial(one_picture, scene, 1)) for _ in range(_TIMES)),
            key=lambda split: split.seconds,
        )
        encoder = _encoder_seconds(settings, fabric)
        seconds_by_part = [spent.network, spent.others, spent.host, spent.seconds]
        table.rows[name] = [
            *(1e3 * seconds for seconds in seconds_by_part),
            spent.network / spent.seconds,
            1e3 * encoder,
        ]
        caption = f"network {1e3 * spent.network:.0f} of {1e3 * spent.seconds:.0f} ms"
        tiles.append(Tile(picture, f"{name}: {caption}"))
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
    """Seconds of both faces, the fastest of some runs, the first of which compiles."""
    network, seconds = settings.network(), []
    for _ in range(_TIMES):
        with without_cached_latents():
            seconds.append(timed(lambda: encode(fabric, network, llvm_float()))[1])
    return min(seconds)


STUDY = Study(
    "papers/chen2024/table3",
    "the time of a picture: network, others, encoder",
    NetworkSettings(),
    split,
    stands_on=("neural", "picture"),
    small={"size": (24, 16)},
)
