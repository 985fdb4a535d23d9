"""The configuration of a training of the universal network, read from a TOML file."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.models.neural.architecture import ConfigTable, Count, NetworkTable

Positive = Annotated[float, Field(gt=0)]


class DataTable(ConfigTable):
    """[data]: the fabrics that queries are drawn from.

    Attributes:
        fabrics: how many; each face is a material of its own.
        weaves: "paper" are the seven weaves of chen2024 alone; "all" adds other named and random weaves.
        layouts: "paper" are the gap and the sett of chen2024; "varied" draws both for two fabrics in three.
        pairs, footprints: pairs of directions a fabric, and footprints a pair.
        lights, views: distinct directions that the pairs share.
        texels_per_thread: of the slices.
        seed: of everything that is drawn.
        store: of queries, made by `python -m studies.papers.chen2024.data`, to train on in place of drawn
            fabrics; a path that begins where the command runs, and of the paper's weaves and layouts alone.
            The fabrics are spread over the paper's 465 materials then.
        store_queries: of the store, so many are trained on, drawn once among all; the paper took 160 million.
            Each takes 12 bytes of memory.
    """

    fabrics: Count = 400
    weaves: Literal["paper", "all"] = "all"
    layouts: Literal["paper", "varied"] = "varied"
    pairs: Count = 256
    footprints: Count = 512
    lights: Count = 64
    views: Count = 64
    texels_per_thread: Count = 32
    seed: Annotated[int, Field(ge=0, le=2**31)] = 0
    store: str = ""
    store_queries: Count = 160_000_000


class TrainingTable(ConfigTable):
    """[training]: the recipe.

    Attributes:
        steps: how many.
        minutes: time limit in place of `steps`, for comparisons at equal budget; 0 is none.
        fabrics: faces of fabrics in one step.
        queries: of each of them in one step.
        encoder: "trained", or "shipped": that of the network that ships, to which `decoder_steps` fit a new
            decoder. `steps`, `rate` and `updates` have no meaning then.
        updates: of the decoder in one step, each with its own queries; the first updates the encoder too,
            which costs five times as much as the decoder.
        decoder_steps: further steps of the decoder alone, on the final latents of the encoder; those are
            computed once, so a step costs a tenth.
        decoder_hidden: width of a new decoder for these steps; 0 keeps the network's decoder, unless
            `decoder_bundles` is true.
        decoder_bundles: a new decoder with a lobe basis; see `NetworkTable`.
        decoder_rate: largest learning rate of these steps; the schedule starts again.
        decoder_loss: of these steps; "faint" adds relative errors of faint specular terms to "balanced".
        optimiser: "sgd", as published, "adam" or "soap", which is Adam along the principal axes of gradients.
        rate: largest learning rate.
        schedule: "steps" multiplies the rate by 0.2 at 6/10 and 9/10 of the training, as published; "cosine"
            warms up over the first hundredth and falls to 0.
        regularisation: weight of the sum of squares of all weights (decoupled with Adam).
        loss: "published" is chen2024 eq. 9–11; "balanced" see `studies.papers.chen2024.training.losses`.
        small_footprints: fraction of the queries of footprints far below a thread that are used; all from
            two threads on. A small network cannot fit their sharp edges, so they are mostly noise.
        seed: of initial weights and batches.
        curve: keeps `curve.csv` beside the checkpoint; see `studies.papers.chen2024.training.curve`.
    """

    steps: Count = 20000
    minutes: Annotated[float, Field(ge=0)] = 0.0
    fabrics: Count = 8
    queries: Count = 4096
    encoder: Literal["trained", "shipped"] = "trained"
    updates: Count = 4
    decoder_steps: Annotated[int, Field(ge=0)] = 0
    decoder_hidden: Annotated[int, Field(ge=0)] = 0
    decoder_bundles: bool = False
    decoder_rate: Positive = 1e-3
    decoder_loss: Literal["balanced", "faint"] = "balanced"
    optimiser: Literal["sgd", "adam", "soap"] = "adam"
    rate: Positive = 2e-3
    schedule: Literal["steps", "cosine"] = "cosine"
    regularisation: Annotated[float, Field(ge=0)] = 0.0
    loss: Literal["published", "balanced"] = "balanced"
    small_footprints: Annotated[float, Field(gt=0, le=1)] = 0.25
    seed: Annotated[int, Field(ge=0, le=2**31)] = 0
    curve: bool = False


class TrainingConfig(ConfigTable):
    """A whole configuration."""

    network: NetworkTable = NetworkTable()
    data: DataTable = DataTable()
    training: TrainingTable = TrainingTable()


def read_config(path: str | os.PathLike[str]) -> TrainingConfig:
    """The configuration in a TOML file.

    Raises:
        InputError: no such file, no TOML, an unknown field, or a value of another type or range.
    """
    file = Path(path)
    require_file(file)
    try:
        return TrainingConfig.model_validate(tomllib.loads(file.read_text(encoding="utf-8")))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"{file} is no TOML: {error}.") from error
    except ValidationError as error:
        first = error.errors()[0]
        field = ".".join(map(str, first["loc"]))
        raise InputError(f"{file}: {field} = {first['input']!r}: {first['msg'].lower()}.") from error
