"""Trains the universal network from nothing, data included.

python -m studies.papers.chen2024.training studies/papers/chen2024/neural.toml -o runs/neural
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.main import run
from loomlight.cli.terminal import done, note_left, supervised
from loomlight.core.errors import MissingDependencyError

NAME = "python -m studies.papers.chen2024.training"

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

# Seconds between lines.
_LINE_EVERY = 30.0


@app.command()
def neural(
    config: Annotated[
        Path, typer.Argument(metavar="CONFIG", help="Such as neural.toml beside the training.")
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="A folder for data, checkpoint and weights; runs/ and the config's name."
        ),
    ] = None,
    device: Annotated[str, typer.Option(help="cpu or cuda.")] = "cpu",
) -> None:
    """Trains the universal network from nothing, data included; run again, it goes on from where it was."""
    from studies.papers.chen2024.training.config import read_config

    recipe = read_config(config)
    # On shared cores threads that spin while they wait make small batches many times slower.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    # MKL's sums otherwise depend on where arrays lie in memory, and a resumed training on that.
    os.environ.setdefault("MKL_CBWR", "AUTO,STRICT")
    try:
        from loomlight.training.parallel import process_number
        from studies.papers.chen2024.training.train import process_group, train_neural
    except ModuleNotFoundError as error:
        raise MissingDependencyError("Training needs PyTorch: pip install 'loomlight[train]'.") from error
    folder = Path("runs") / config.stem if output is None else output
    note_left(f"{folder} keeps data and the last checkpoint: the same command goes on from there.")
    with process_group():
        speaks = process_number() == 0
        data, training = (_Lines("data"), _Lines("training")) if speaks else (None, None)
        weights = train_neural(recipe, folder, data, training, device)
    if speaks:
        done(weights)


class _Lines:
    """Progress with an estimate, a line now and then: a training's log is read more often than watched."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._begun: tuple[float, int] | None = None
        self._last = 0
        self._said = 0.0

    def __call__(self, done: int, total: int, loss: float | None = None) -> None:
        now = time.monotonic()
        if self._begun is None or done < self._last:
            # What an earlier run did says nothing about the speed of this one, nor one phase about the next.
            self._begun = now, done
        self._last = done
        if done < total and now - self._said < _LINE_EVERY:
            return
        self._said = now
        since, first = self._begun
        left = (now - since) * (total - done) / max(done - first, 1) / 60
        detail = "" if loss is None else f", loss {loss:.4f}"
        print(f"{self._title}: {done} of {total}{detail}, {left:.0f} min left", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(supervised(lambda: run(sys.argv[1:], app, NAME)))
