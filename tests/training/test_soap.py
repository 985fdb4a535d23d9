"""SOAP: its axes are those of the gradients, and its state is all that it depends on.

Covers: training/loop.py
"""

import pytest

torch = pytest.importorskip("torch")

# Without torch, which is optional, the file is skipped above; what imports it can only come here (E402).
from torch import nn  # noqa: E402

from loomlight.training.loop import optimiser_tensors, restore_optimiser  # noqa: E402
from loomlight.training.soap import Soap  # noqa: E402


def _random(*shape: int, seed: int = 0) -> torch.Tensor:
    return torch.randn(shape, generator=torch.Generator().manual_seed(seed))


def _orthogonal(side: int, seed: int) -> torch.Tensor:
    return torch.linalg.qr(_random(side, side, seed=seed))[0]


def _moved(kind: type[torch.optim.Optimizer], turn: torch.Tensor | None = None) -> torch.Tensor:
    """Where a square matrix gets to by gradients of a bowl and chance, in axes turned on both sides."""
    left, right = (_orthogonal(6, 1), _orthogonal(6, 2)) if turn is None else (turn, turn)
    weights = nn.Parameter(left @ _random(6, 6) @ right)
    optimiser = kind([weights], 1e-2)
    for step in range(25):
        # Columns and rows of unlike size, so that every axis is one of its own.
        chance = _random(6, 6, seed=step) * torch.linspace(0.2, 2, 6) * torch.linspace(1, 3, 6)[:, None]
        weights.grad = weights.detach() + left @ chance @ right
        optimiser.step()
    return left.T @ weights.detach() @ right.T


@pytest.mark.parametrize(("kind", "same"), [(Soap, True), (torch.optim.Adam, False)])
def test_axes_of_the_weights_do_not_matter(kind: type[torch.optim.Optimizer], same: bool) -> None:
    """Steps in turned axes are the turned steps; those of Adam are not."""
    # Single precision, over 25 steps of 0.01.
    off = (_moved(kind) - _moved(kind, torch.eye(6))).abs().max()
    assert off < 1e-4 if same else off > 1e-2


def test_long_sides_keep_their_own_axes() -> None:
    weights = nn.Parameter(_random(12, 20))
    optimiser = Soap([weights], 1e-2, largest_side=16)
    _advance(optimiser, [weights], range(12))
    state = optimiser.state[weights]
    assert "left_basis" in state
    assert "right_basis" not in state


def test_without_sides_to_turn_it_is_adam() -> None:
    """But for the first gradient, which only sets up the state."""
    ours, theirs = (nn.Parameter(_random(8)) for _ in range(2))
    soap, adam = Soap([ours], 1e-2), torch.optim.Adam([theirs], 1e-2, betas=(0.95, 0.95))
    for step in range(6):
        gradient = _random(8, seed=step)
        ours.grad = gradient
        soap.step()
        if step > 0:
            theirs.grad = gradient
            adam.step()
    # Single precision; the square root of the count's correction is applied at another place.
    assert torch.allclose(ours, theirs, rtol=0, atol=1e-6)


def test_axes_stay_orthogonal() -> None:
    weights = nn.Parameter(_random(12, 20))
    optimiser = Soap([weights], 1e-2)
    _advance(optimiser, [weights], range(100))
    for side, length in (("left", 12), ("right", 20)):
        basis = optimiser.state[weights][f"{side}_basis"]
        assert torch.allclose(basis.T @ basis, torch.eye(length), atol=1e-5)


def test_decay_shrinks_weights() -> None:
    weights = nn.Parameter(torch.ones(4, 4))
    optimiser = Soap([weights], 0.1, decay=0.5)
    for _ in range(2):
        weights.grad = torch.zeros(4, 4)
        optimiser.step()
    # The first gradient sets up the state; the second step takes 0.1 · 0.5 of the weights.
    assert torch.allclose(weights, torch.full((4, 4), 0.95))


def test_parameters_count_their_own_gradients() -> None:
    """Those that every fourth loss reaches improve their axes as often as others, by their own steps."""
    often, seldom = nn.Parameter(_random(6, 6)), nn.Parameter(_random(6, 6))
    optimiser = Soap([often, seldom], 1e-2, every=4)
    for step in range(33):
        often.grad = _random(6, 6, seed=step)
        seldom.grad = _random(6, 6, seed=step) if step % 4 == 0 else None
        optimiser.step()
    assert float(optimiser.state[often]["step"]) == 32
    assert float(optimiser.state[seldom]["step"]) == 8


def test_its_state_is_all_it_depends_on() -> None:
    """Convolutions, vectors and single numbers; put back into a new optimiser, steps are the same bits."""
    shapes = ((4, 3, 3, 3), (4,), (), (5, 7))
    kept = [nn.Parameter(_random(*shape)) for shape in shapes]
    first = Soap(kept, 1e-2, every=3)
    _advance(first, kept, range(7))
    others = [nn.Parameter(parameter.detach().clone()) for parameter in kept]
    second = Soap(others, 1e-2, every=3)
    restore_optimiser(second, {name: value.clone() for name, value in optimiser_tensors(first).items()})
    _advance(first, kept, range(7, 20))
    _advance(second, others, range(7, 20))
    assert all(torch.equal(one, other) for one, other in zip(kept, others, strict=True))


def _advance(optimiser: Soap, parameters: list[nn.Parameter], steps: range) -> None:
    for step in steps:
        for parameter in parameters:
            parameter.grad = _random(*parameter.shape, seed=step)
        optimiser.step()


def test_a_closure_is_refused() -> None:
    with pytest.raises(ValueError, match="no closure"):
        Soap([nn.Parameter(torch.ones(2))], 1e-2).step(lambda: None)
