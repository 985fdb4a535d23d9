"""The jobs of a graphics card, in order of worth: each a command of this repository with expected minutes.

A job is declared here alone; the plan, its JSON, the rehearsal and the page follow.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from studies.harness.study import REPOSITORY

_RECIPES = REPOSITORY / "studies" / "papers" / "chen2024"


@dataclass(frozen=True)
class Places:
    """Where jobs read and write.

    Attributes:
        records: the folder of records.
        runs: the folder of trainings.
        work: what the kit keeps, within `runs`; commands run there.
    """

    records: Path
    runs: Path
    work: Path


@dataclass(frozen=True)
class Job:
    """A job.

    Attributes:
        name: of the job.
        answers: its question.
        words: the command after `python -m`; {records}, {runs} and {work} are folders of `Places`, {recipe}
            is the file below.
        minutes: that it takes on a card, as estimated.
        estimated: what the minutes were estimated from.
        rehearsal: words of the command that does the same at a tiny size on whatever driver there is.
        needs: names of `machine.NEEDS`.
        resumes: whether it goes on where it was stopped.
        after: the job that has to be done before; empty for none.
        recipe: a file of settings of a training.
        small: lines of the recipe, and those that the rehearsal has in their place.
    """

    name: str
    answers: str
    words: tuple[str, ...]
    minutes: float
    estimated: str
    rehearsal: tuple[str, ...]
    needs: tuple[str, ...] = ()
    resumes: bool = False
    after: str = ""
    recipe: Path | None = None
    small: Mapping[str, str] = field(default_factory=dict)

    def command(self, places: Places, rehearses: bool) -> list[str]:
        """The words of the command; a rehearsal's smaller recipe is written first."""
        recipe = self.recipe
        if rehearses and recipe is not None:
            recipe = places.work / f"small-{recipe.name}"
            recipe.write_text(self.small_recipe(), encoding="utf-8")
        words = self.rehearsal if rehearses else self.words
        return [word.format(**vars(places), recipe=recipe) for word in words]

    def small_recipe(self) -> str:
        """The text of the rehearsal's recipe.

        Raises:
            ValueError: the recipe has a line not once.
        """
        text = "" if self.recipe is None else self.recipe.read_text(encoding="utf-8")
        for line, other in self.small.items():
            if text.count(f"\n{line}") != 1:
                raise ValueError(f"{self.name}: its recipe has {text.count(line)} lines {line}")
            text = text.replace(f"\n{line}", f"\n{other}")
        return text


def _study(name: str, *settings: str) -> tuple[str, ...]:
    return ("studies", name, "-o", "{records}", "--runs", "{runs}", *settings)


def _training(folder: str, *options: str) -> tuple[str, ...]:
    return ("studies.papers.chen2024.training", "{recipe}", "-o", f"{{work}}/{folder}", *options)


_CUDA = ("--device", "cuda")
_QUERIES = "queries of chen2024"
_STORE = ("studies.papers.chen2024.data", "-o", "{work}/queries.zarr")

_FRAMES, _BACKENDS = "speed/frames", "speed/backends"
_TABLE2, _RUNGS = "papers/kuznetsov2021/table2", "papers/zeltner2024/tables1-4"

JOBS: Sequence[Job] = (
    Job(
        "frames",
        "milliseconds of frames of all models at 1080p and 4K, beside the card's limits",
        _study(_FRAMES, "--sizes", "1920x1080,3840x2160"),
        5,
        "eight models twice, of which baking `clustered` and `neural` takes most; frames take no minute",
        _study(_FRAMES, "--small"),
        needs=("graphics card",),
        resumes=True,
    ),
    Job(
        "Dr.Jit on CUDA",
        "queries and pictures a second of all models by cuda_ad_rgb, and how far they are from LLVM",
        _study(_BACKENDS, "--variant", "cuda_ad_rgb"),
        6,
        "eight models, 40 s each for kernels of PTX and of LLVM",
        _study(_BACKENDS, "--small"),
        needs=("CUDA for Dr.Jit",),
        resumes=True,
    ),
    Job(
        "designs of kuznetsov2021",
        "table 2 at equal steps, those of the paper: with and without the offset, and Rainer et al.",
        _study(
            _TABLE2,
            *("--quality", "full", "--steps", "30000", "--batch", "65536"),
            *("--materials", "twisted wool,straight wool", *_CUDA),
        ),
        80,
        "ten trainings of 30 000 steps at 15 ms, bound by gathering queries on the host; rays take 2",
        _study(_TABLE2, "--small"),
        needs=("CUDA for PyTorch",),
        resumes=True,
    ),
    Job(
        _QUERIES,
        "the data of chen2024, 200 000 queries of each of 465 materials; none where they are carried",
        _STORE,
        4,
        "0.5 s a material on two cores (speed/data_rate), on sixteen cores bounded by writing",
        (*_STORE, "--materials", "0:1", "--queries", "4096"),
        resumes=True,
    ),
    Job(
        "chen2024 as published",
        "the published network: 465 materials, 10 epochs of 160 million queries",
        _training("published", *_CUDA),
        150,
        "3 125 000 steps of 512 queries at 3 ms, what launching their kernels takes",
        _training("small-published"),
        needs=("CUDA for PyTorch",),
        resumes=True,
        after=_QUERIES,
        recipe=_RECIPES / "chen2024.toml",
        small={
            "fabrics = 465": "fabrics = 1",
            "store_queries = 160_000_000": "store_queries = 2048",
            "steps = 3125000": "steps = 3",
            "curve = true": "curve = false",
        },
    ),
    Job(
        "chen2024 as shipped",
        "the network of `neural`, data included",
        _training("shipped", *_CUDA),
        40,
        "588 s of data on two cores (speed/neural_training), a fifth on sixteen; 68 000 updates at 30 ms",
        _training("small-shipped"),
        needs=("CUDA for PyTorch",),
        resumes=True,
        recipe=_RECIPES / "neural.toml",
        small={
            "fabrics = 800": "fabrics = 2",
            "steps = 11000": "steps = 2",
            "fabrics = 6": "fabrics = 1",
            "queries = 4096": "queries = 256",
            "decoder_steps = 12000": "decoder_steps = 2",
        },
    ),
    Job(
        "rungs of zeltner2024",
        "tables 1 to 4 at the paper's 300 000 steps of 131 072 queries, on varnished wood",
        _study(
            _RUNGS,
            *("--materials", "varnished-wood", "--steps", "300000"),
            *("--batch", "131072", "--queries", "16777216", *_CUDA),
        ),
        320,
        "three trainings of 300 000 steps at 20 ms, bound by gathering queries; 20 for the queries",
        _study(_RUNGS, "--small"),
        needs=("CUDA for PyTorch",),
        resumes=True,
    ),
)
