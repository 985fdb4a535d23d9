"""Gradients of parts on threads of their own are those of the whole batch."""

import pytest

# Nothing below can be imported without torch, which only training needs (hence E402).
torch = pytest.importorskip("torch")

from loomlight.training.side_by_side import SideBySide  # noqa: E402


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
    found = [parameter.grad for parameter in network["used"].parameters()]
    wanted = torch.autograd.grad(loss_of(slice(None)), list(network["used"].parameters()))
    assert torch.allclose(loss.detach(), loss_of(slice(None)))
    # Rounding alone: sums are taken in another order.
    assert all(torch.allclose(a, b, rtol=1e-5, atol=1e-7) for a, b in zip(found, wanted, strict=True))
    assert all(parameter.grad is None for parameter in network["unused"].parameters())


def test_what_goes_wrong_in_a_part_is_raised() -> None:
    """Not lost on its thread."""
    network = torch.nn.Linear(1, 1)

    def broken() -> torch.Tensor:
        raise ArithmeticError("no")

    with pytest.raises(ArithmeticError):
        SideBySide(2).loss([broken, broken], [0.5, 0.5], network)
