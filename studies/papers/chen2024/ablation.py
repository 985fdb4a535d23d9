"""Figure 7: the network without one-blob coding, and without spatial fusion, at equal budget.

The three networks are trained by configurations that differ in that alone (ablation_*.toml).
"""

from __future__ import annotations

from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.query_benchmark import run_query_benchmark
from loomlight.evaluation.table import Table
from loomlight.models.neural.weights import Weights, read_weights
from studies.instruments.held_out import held_out_fabrics
from studies.instruments.renders import Stage, one_picture
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.papers.chen2024.fabrics import paper_fabric
from studies.papers.chen2024.shots import CLOSE, CYLINDER, DRAPE
from studies.papers.figure import Evidence, error_caption, on_display
from studies.papers.setting import NEURAL, Setting, cloth_bsdf, neural_predictor

# By heading: the configuration in studies/papers/chen2024/.
NETWORKS = {
    "both": "ablation_both",
    "no one-blob": "ablation_one_blob",
    "no spatial fusion": "ablation_fusion",
}
_FABRICS, _PAIRS, _FOOTPRINTS = 8, 40, 40
_SCENES = {
    "twill 5×5, close": (CLOSE, "twill 5×5"),
    "twill 3×3": (DRAPE, "twill 3×3"),
    "satin 5×5": (CYLINDER, "satin 5×5"),
}


def ablated(setting: Setting) -> Evidence:
    """Figure 7: pictures of the three networks, and their query benchmark.

    Raises:
        InputError: a training is missing; the message says which commands make them.
    """
    files = weights_files(setting.runs)
    networks = {name: read_weights(file) for name, file in files.items()}
    columns = [*NETWORKS, "reference"]
    rows, pictures = [], {}
    tables = [Table(metric, list(NETWORKS)) for metric in ("MSE", "FLIP")]
    for number, (label, (shot, weave)) in enumerate(_SCENES.items()):
        fabric = paper_fabric(weave)
        stage = Stage(setting, shot, fabric)
        reference = stage.reference().linear
        shown = {
            name: one_picture(stage.neural_scene(cloth_bsdf(fabric, NEURAL, file)), 1)
            for name, file in files.items()
        }
        errors = {name: picture_error(picture, reference, stage.counted) for name, picture in shown.items()}
        tiles = [Tile(on_display(picture), error_caption(errors[name])) for name, picture in shown.items()]
        tiles.append(Tile(on_display(reference), f"{setting.samples} spp"))
        rows += [Row(label, tiles), Row("", [Tile(error.flip_picture) for error in errors.values()])]
        for column, tile in zip(columns, tiles, strict=True):
            if tile.picture is not None:
                pictures[f"{label}-{column}"] = tile.picture
        tables[0].rows[label] = [error.mse for error in errors.values()]
        tables[1].rows[label] = [error.flip for error in errors.values()]
        setting.step(number + 1, len(_SCENES) + 1)
    test = run_query_benchmark(
        {name: neural_predictor(network) for name, network in networks.items()},
        held_out_fabrics(_FABRICS),
        pairs=_PAIRS,
        footprints=_FOOTPRINTS,
        monte_carlo=(1,),
    )
    setting.step(len(_SCENES) + 1, len(_SCENES) + 1)
    note = (
        f"Query benchmark on {_FABRICS} held-out fabrics, nMAE of grey reflection and of colour: "
        + ", ".join(
            f"{name} {row.metric('reflection'):.3f} and {row.metric('colour'):.3f}"
            for name, row in test.rows.items()
            if name in networks
        )
        + f". Trained for {_budget(networks)}. Below each picture its FLIP map."
    )
    title = "chen2024 figure 7: one-blob coding and spatial fusion"
    return Evidence(contact_sheet(title, columns, rows, note), pictures, [*tables, *test.tables()[:3]])


def weights_files(runs: Path) -> dict[str, Path]:
    """The weights of the three networks by heading.

    Raises:
        InputError: one is missing.
    """
    files = {name: runs / run / "neural.safetensors" for name, run in NETWORKS.items()}
    missing = [NETWORKS[name] for name, file in files.items() if not file.is_file()]
    if missing:
        commands = "; ".join(
            f"python -m studies.papers.chen2024.training studies/papers/chen2024/{run}.toml -o {runs / run}"
            for run in missing
        )
        raise InputError(
            f"chen2024/fig7 shows trainings that are not in the folder {runs}: make them with {commands}."
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
