"""How long the training of the universal network takes from nothing, phase by phase.

The recipe that ships is trained into the folder of runs, data included: the first phase draws fabrics and
answers queries about them, the second trains the whole network, the third its decoder alone. Seconds are by
the clock and of the processor. What the folder holds already is not made again, and would not be measured.
"""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from typing import Any

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from studies.harness.study import REPOSITORY, Figures, Found, Run, Study
from studies.papers.chen2024.training.config import TrainingConfig, read_config

RECIPE = REPOSITORY / "studies" / "papers" / "chen2024" / "neural.toml"


@dataclass(frozen=True)
class NeuralTraining(Settings):
    fabrics: int = setting(800, "Of the data.", low=1)
    pairs: int = setting(256, "Pairs of directions of a fabric.", low=4)
    footprints: int = setting(512, "Of a pair of directions.", low=1)
    steps: int = setting(5500, "Of the network.", low=1)
    decoder_steps: int = setting(8000, "Of the decoder alone.", low=1)
    queries: int = setting(4096, "Of each fabric of a step.", low=1)


class Marks:
    """When phases end, by the clock and of the processor."""

    def __init__(self) -> None:
        self._last = time.monotonic(), time.process_time()
        self.phases: dict[str, dict[str, float]] = {}

    def end(self, phase: str) -> None:
        """Notes what has passed since the phase before."""
        now = time.monotonic(), time.process_time()
        wall, used = (after - before for after, before in zip(now, self._last, strict=True))
        self._last = now
        self.phases[phase] = {"seconds": round(wall, 1), "processor_seconds": round(used, 1)}


def measure(settings: NeuralTraining, run: Run) -> Found:
    """Seconds of every phase."""
    # On shared cores threads that spin while they wait make small batches many times slower.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    try:
        from studies.papers.chen2024.training.train import train_neural
    except ModuleNotFoundError as error:
        raise MissingDependencyError("Training needs PyTorch: pip install 'loomlight[train]'.") from error
    recipe = changed(read_config(RECIPE), settings)
    folder = run.runs / "neural_training"
    if folder.exists():
        raise InputError(f"{folder} holds a training, whose time is over: remove it, or choose other --runs.")
    marks = Marks()

    def data(done: int, total: int) -> None:
        run.report(done, total)
        if done == total:
            marks.end("data")

    def training(done: int, total: int, loss: float) -> None:
        run.report(done, total)
        if done == total:
            marks.end("decoder alone" if "network" in marks.phases else "network")

    train_neural(recipe, folder, data, training)
    return Found({"recipe": recipe.model_dump(), "phases": marks.phases})


def changed(recipe: TrainingConfig, settings: NeuralTraining) -> TrainingConfig:
    """The recipe with the numbers of the settings."""
    data = {"fabrics": settings.fabrics, "pairs": settings.pairs, "footprints": settings.footprints}
    training: dict[str, Any] = {
        "steps": settings.steps,
        "decoder_steps": settings.decoder_steps,
        "queries": settings.queries,
    }
    return recipe.model_copy(
        update={
            "data": recipe.data.model_copy(update=data),
            "training": recipe.training.model_copy(update=training),
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Minutes by phase, and of all."""
    phases = figures["phases"]
    keys = [key for key in ("seconds", "processor_seconds") if key in next(iter(phases.values()))]
    rows = {name: [found[key] / 60 for key in keys] for name, found in phases.items()}
    rows["all"] = [sum(found[key] for found in phases.values()) / 60 for key in keys]
    names = {"seconds": "minutes", "processor_seconds": "processor minutes"}
    return [Table("A training of `neural`", [names[key] for key in keys], rows, figures.get("note", ""))]


STUDY = Study(
    "speed/neural_training",
    "how long the training of the universal network takes from nothing, phase by phase",
    NeuralTraining(),
    measure,
    tables,
    stands_on=("network",),
    small={"fabrics": 3, "pairs": 8, "footprints": 2, "steps": 2, "decoder_steps": 2, "queries": 16},
)
