"""Parts of a batch on threads, or in processes of torchrun, have the gradients of the whole.

Covers: training/loop.py, training/parallel.py
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

# Nothing below can be imported without torch, which only training needs (hence E402).
torch = pytest.importorskip("torch")

from loomlight.training.loop import Schedule, train  # noqa: E402
from loomlight.training.parallel import SideBySide  # noqa: E402
from tests.limits import HANG  # noqa: E402


@pytest.mark.parametrize("threads", [1, 2])
def test_parts_have_the_gradients_of_the_whole(threads: int) -> None:
    """Of parts of different sizes; what no part uses has no gradient."""
    torch.manual_seed(0)
    network = torch.nn.ModuleDict({"used": torch.nn.Linear(5, 3), "unused": torch.nn.Linear(2, 2)})
    given = torch.randn(10, 5)

    def loss_of(rows: slice) -> torch.Tensor:
        value: torch.Tensor = network["used"](given[rows]).square().mean()
        return value

    parts = [slice(0, 4), slice(4, 10)]
    loss = SideBySide(threads).loss([lambda part=part: loss_of(part) for part in parts], [0.4, 0.6], network)
    loss.backward()
    actual = [parameter.grad for parameter in network["used"].parameters()]
    expected = torch.autograd.grad(loss_of(slice(None)), list(network["used"].parameters()))
    assert torch.allclose(loss.detach(), loss_of(slice(None)))
    # Rounding alone: sums are taken in another order.
    assert all(torch.allclose(a, b, rtol=1e-5, atol=1e-7) for a, b in zip(actual, expected, strict=True))
    assert all(parameter.grad is None for parameter in network["unused"].parameters())


def test_what_goes_wrong_in_a_part_is_raised() -> None:
    """Not lost on its thread."""
    network = torch.nn.Linear(1, 1)

    def broken() -> torch.Tensor:
        raise ArithmeticError("no")

    with pytest.raises(ArithmeticError):
        SideBySide(2).loss([broken, broken], [0.5, 0.5], network)


def _tiny() -> float:
    return float((torch.full((64,), 1e-38) * 0.01).max())


def test_numbers_too_small_to_be_normal_are_nothing(tmp_path: Path) -> None:
    """On the threads, and where the optimiser's are moved; afterwards all is as before."""
    network = torch.nn.Linear(2, 1)
    side_by_side = SideBySide(2)
    on_threads, on_main = [], []

    def part() -> torch.Tensor:
        on_threads.append(_tiny())
        value: torch.Tensor = network(torch.ones(3, 2)).square().mean()
        return value

    def losses(_: int) -> Iterator[torch.Tensor]:
        on_main.append(_tiny())
        yield side_by_side.loss([part, part], [0.5, 0.5], network)

    optimiser = torch.optim.SGD(network.parameters(), 0.1)
    schedule = Schedule(steps=2, rate=lambda _: 0.1)
    assert train(network, optimiser, losses, schedule, tmp_path / "checkpoint.safetensors", "x") == 2
    assert on_threads == [0] * 4
    assert on_main == [0] * 2
    assert _tiny() > 0


CONFIG = """
[network]
width = 4
latent_size = 8
hidden = 16
[data]
layouts = "paper"
fabrics = 2
pairs = 64
footprints = 16
lights = 16
views = 16
texels_per_thread = 8
[training]
steps = 3
fabrics = 2
queries = 64
decoder_steps = 2
"""


@pytest.mark.slow
def test_two_processes_train_what_one_trains(tmp_path: Path) -> None:
    config = tmp_path / "tiny.toml"
    config.write_text(CONFIG)
    train = ["-m", "studies.papers.chen2024.training", str(config), "-o"]
    starter = ["-m", "torch.distributed.run", "--standalone", "--nproc-per-node", "2"]
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    for command in ([*train, str(tmp_path / "one")], [*starter, *train, str(tmp_path / "two")]):
        done = subprocess.run(
            [sys.executable, *command], env=environment, capture_output=True, text=True, timeout=HANG
        )
        assert done.returncode == 0, done.stderr
        # One process speaks for all.
        assert done.stdout.count("neural.safetensors") == 1
    one, two = (load_file(tmp_path / name / "neural.safetensors") for name in ("one", "two"))
    assert one.keys() == two.keys()
    for name in one:
        # Sums of two gradients in another order: a rounding of float32 each step, which Adam's division by
        # small second moments enlarges.
        np.testing.assert_allclose(two[name], one[name], rtol=1e-4, atol=1e-6, err_msg=name)
    files = sorted(str(path.relative_to(tmp_path / "one")) for path in (tmp_path / "one").rglob("*"))
    assert files == sorted(str(path.relative_to(tmp_path / "two")) for path in (tmp_path / "two").rglob("*"))
