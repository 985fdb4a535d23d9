"""Figure 7: the network without one-blob coding, and without spatial fusion, at equal budget; and others.

The networks are trained by configurations that differ in what they leave out (ablation_*.toml). `ablations`
is the query benchmark of all of them: nMAE of grey reflection overall and by the size of the footprint, b0 to
b3, of transmission, and of colours, of 12 held-out fabrics.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.query_benchmark import BANDS, OVERALL, QueryBenchmark, run_query_benchmark
from loomlight.evaluation.table import Table
from loomlight.models.neural.weights import Weights, read_weights
from studies.harness.study import Figures, Found, Run, Study, listed, names, on_display, with_tables
from studies.instruments.held_out import held_out_fabrics
from studies.instruments.renders import one_picture
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.chen2024.fabrics import paper_fabric
from studies.papers.chen2024.shots import CLOSE, CYLINDER, DRAPE
from studies.papers.chen2024.stage import Stage, neural_bsdf, neural_predictor
from studies.papers.setting import PictureSettings

# By heading: the configuration in studies/papers/chen2024/; those of the figure, and all.
NETWORKS = {
    "both": "ablation_both",
    "no one-blob": "ablation_one_blob",
    "no spatial fusion": "ablation_fusion",
}
ALL_NETWORKS = {
    "published recipe": "ablation_published",
    "one latent a face": "ablation_vector",
    **NETWORKS,
    "no fibre features": "ablation_fibres",
    "no lobe basis": "ablation_bundles",
    "no parallax": "ablation_parallax",
}
_SCENES = {
    "twill 5×5, close": (CLOSE, "twill 5×5"),
    "twill 3×3": (DRAPE, "twill 3×3"),
    "satin 5×5": (CYLINDER, "satin 5×5"),
}


@dataclass(frozen=True)
class BenchmarkSettings(Settings):
    """Of the query benchmark of the networks."""

    fabrics: int = setting(8, "Held-out fabrics of the query benchmark.", low=1, high=24)
    pairs: int = setting(40, "Of directions, of each fabric.", low=1, high=1000)
    footprints: int = setting(40, "Of each pair.", low=1, high=1000)


@dataclass(frozen=True)
class FigureSettings(PictureSettings, BenchmarkSettings):
    """Of the figure."""


@dataclass(frozen=True)
class AllSettings(BenchmarkSettings):
    """Of all networks."""

    networks: str = names(",".join(ALL_NETWORKS), "Trainings that are compared.", tuple(ALL_NETWORKS))


def ablated(settings: FigureSettings, run: Run) -> Found:
    """Figure 7: pictures of the three networks, and their query benchmark.

    Raises:
        InputError: a training is missing; the message says which commands make them.
    """
    files = weights_files(run.runs, NETWORKS)
    networks = {name: read_weights(file) for name, file in files.items()}
    title = "chen2024 figure 7: one-blob coding and spatial fusion"
    shown = PictureTable(title, [*NETWORKS, "reference"])
    tables = [Table(metric, list(NETWORKS)) for metric in ("MSE", "FLIP")]
    for number, (label, (shot, weave)) in enumerate(_SCENES.items()):
        fabric = paper_fabric(weave)
        stage = Stage(settings, shot, fabric)
        reference = stage.reference()
        pictures = {
            name: one_picture(stage.neural_scene(neural_bsdf(fabric, file)), 1)
            for name, file in files.items()
        }
        errors = [picture_error(picture, reference, stage.counted) for picture in pictures.values()]
        tiles = [
            Tile(on_display(picture), error_caption(error))
            for picture, error in zip(pictures.values(), errors, strict=True)
        ]
        shown.add(label, [*tiles, Tile(on_display(reference), f"{settings.spp} spp")], errors)
        tables[0].rows[label] = [error.mse for error in errors]
        tables[1].rows[label] = [error.flip for error in errors]
        run.report(number + 1, len(_SCENES) + 1)
    test = _benchmark(settings, networks)
    run.report(len(_SCENES) + 1, len(_SCENES) + 1)
    note = (
        f"Query benchmark on {settings.fabrics} held-out fabrics, nMAE of grey reflection and of colour: "
        + ", ".join(
            f"{name} {row.metric('reflection'):.3f} and {row.metric('colour'):.3f}"
            for name, row in test.rows.items()
            if name in networks
        )
        + f". Trained for {_budget(networks)}. Below each picture its FLIP map."
    )
    return shown.found(with_tables(*tables, *test.tables()[:3]), note)


def compared(settings: AllSettings, run: Run) -> Found:
    """The query benchmark of all networks.

    Raises:
        InputError: a training is missing; the message says which commands make them.
    """
    files = weights_files(run.runs, {name: ALL_NETWORKS[name] for name in listed(settings.networks)})
    test = _benchmark(settings, {name: read_weights(file) for name, file in files.items()})
    rows = {
        name: {
            quantity: {part: sums.nmae for part, sums in classes.items() if sums.count}
            for quantity, classes in row.sums.items()
        }
        for name, row in test.rows.items()
    }
    return Found({"fabrics": test.fabrics, "queries_per_fabric": test.queries, "rows": rows})


def tables(figures: Figures) -> list[Table]:
    """nMAE of the networks."""
    columns = {part: ("reflection", part) for part in (OVERALL, *BANDS)}
    columns |= {quantity: (quantity, OVERALL) for quantity in ("transmission", "colour")}
    table = Table("nMAE of networks that leave something out", list(columns))
    for name, found in figures["rows"].items():
        if name in ALL_NETWORKS:
            table.rows[name] = [found[quantity].get(part) for quantity, part in columns.values()]
    return [table]


def _benchmark(settings: BenchmarkSettings, networks: dict[str, Weights]) -> QueryBenchmark:
    return run_query_benchmark(
        {name: neural_predictor(network) for name, network in networks.items()},
        held_out_fabrics(settings.fabrics),
        pairs=settings.pairs,
        footprints=settings.footprints,
        monte_carlo=(1,),
    )


def weights_files(runs: Path, networks: dict[str, str]) -> dict[str, Path]:
    """The weights of networks by heading.

    Raises:
        InputError: one is missing.
    """
    files = {name: runs / run / "neural.safetensors" for name, run in networks.items()}
    missing = [networks[name] for name, file in files.items() if not file.is_file()]
    if missing:
        commands = "; ".join(
            f"python -m studies.papers.chen2024.training studies/papers/chen2024/{run}.toml -o {runs / run}"
            for run in missing
        )
        raise InputError(
            f"Trainings are not in the folder {runs}, which --runs names: make them with {commands}."
        )
    return files


def _budget(networks: dict[str, Weights]) -> str:
    """Training time and steps of each network, from its recipe."""
    facts = []
    for name, network in networks.items():
        minutes = network.recipe.get("training", {}).get("minutes", 0)
        steps = network.provenance.get("steps", "unknown")
        facts.append(f"{name}: {f'{minutes:g} minutes, ' if minutes else ''}{steps} steps")
    return "; ".join(facts)


_BENCHMARK = {"fabrics": 1, "pairs": 4, "footprints": 4}
STUDIES = (
    Study(
        "papers/chen2024/fig7",
        "ablations: no one-blob coding, no spatial fusion",
        FigureSettings(),
        ablated,
        stands_on=("point", "picture"),
        small={"size": (24, 16), "spp": 4, **_BENCHMARK},
    ),
    Study(
        "papers/chen2024/ablations",
        "the query benchmark of all networks that leave something out",
        AllSettings(fabrics=12, pairs=160, footprints=160),
        compared,
        tables,
        stands_on=("point",),
        small=_BENCHMARK,
    ),
)
