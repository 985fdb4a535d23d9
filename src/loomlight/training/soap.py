"""SOAP: Adam in the eigenbases of Shampoo's preconditioner (Vyas et al. 2024, arXiv 2409.11321)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import torch
from torch import Tensor, nn

_TINY = 1e-8


class Soap(torch.optim.Optimizer):
    """Adam with steps along the principal axes of each matrix's gradients.

    Small networks with large batches have gradients with little noise; then Adam is limited by its axes,
    which are those of single weights. The state is tensors alone, one set a parameter, so that every
    parameter has its own step count, and a checkpoint contains all of it.
    """

    def __init__(
        self,
        parameters: Iterable[nn.Parameter],
        rate: float,
        decay: float = 0.0,
        memory: tuple[float, float] = (0.95, 0.95),
        every: int = 10,
        largest_side: int = 256,
    ) -> None:
        """
        Args:
            rate: learning rate.
            decay: of the weights themselves, each step, in units of the rate.
            memory: decay of the running means of gradients and of their products, each step.
            every: steps between improvements of the eigenbases.
            largest_side: longer sides of matrices are not rotated; the sides of a convolution are its outputs
                and all of its inputs.
        """
        super().__init__(
            parameters,
            {"lr": rate, "decay": decay, "memory": memory, "every": every, "largest_side": largest_side},
        )

    @torch.no_grad()
    def step(self, closure: Callable[[], Any] | None = None) -> None:
        """Updates every parameter that has a gradient; the first gradient only initializes the bases."""
        if closure is not None:
            raise ValueError("Soap takes no closure.")
        for group in self.param_groups:
            for parameter in group["params"]:
                if parameter.grad is not None:
                    self._move(parameter, group)

    def _move(self, parameter: nn.Parameter, group: dict[str, Any]) -> None:
        gradient = parameter.grad.reshape(len(parameter), -1) if parameter.dim() > 1 else parameter.grad
        state = self.state[parameter]
        if not state:
            _begin(state, gradient, group["largest_side"] if parameter.dim() > 1 else 0)
            return
        first, second = group["memory"]
        state["step"] += 1
        count = int(state["step"])
        turned = _turned(gradient, state)
        state["mean"].lerp_(gradient, 1 - first)
        state["square"].mul_(second).addcmul_(turned, turned, value=1 - second)
        change = _turned(state["mean"], state) / (state["square"].sqrt() + _TINY)
        rate = group["lr"] * (1 - second**count) ** 0.5 / (1 - first**count)
        parameter.mul_(1 - group["lr"] * group["decay"])
        parameter.add_(_turned_back(change, state).reshape(parameter.shape), alpha=-rate)
        for side, product in _products(gradient, state):
            state[side].lerp_(product, 1 - second)
        if count % group["every"] == 0:
            _improve(state)


def _begin(state: dict[str, Any], gradient: Tensor, largest_side: int) -> None:
    state["step"] = torch.zeros(())
    state["mean"] = torch.zeros_like(gradient)
    state["square"] = torch.zeros_like(gradient)
    # A side of one has one axis.
    for side, length in zip(("left", "right"), gradient.shape, strict=False):
        if 1 < length <= largest_side:
            state[side] = torch.empty(0)
    for side, product in list(_products(gradient, state)):
        state[side] = product
        state[f"{side}_basis"] = torch.linalg.eigh(product)[1].flip(1).contiguous()


def _products(gradient: Tensor, state: dict[str, Any]) -> Iterable[tuple[str, Tensor]]:
    """Of the gradient with itself, for each side that is turned."""
    if "left" in state:
        yield "left", gradient @ gradient.T
    if "right" in state:
        yield "right", gradient.T @ gradient


def _turned(matrix: Tensor, state: dict[str, Any]) -> Tensor:
    """Into the eigenbases."""
    if "left" in state:
        matrix = state["left_basis"].T @ matrix
    return matrix @ state["right_basis"] if "right" in state else matrix


def _turned_back(matrix: Tensor, state: dict[str, Any]) -> Tensor:
    if "left" in state:
        matrix = state["left_basis"] @ matrix
    return matrix @ state["right_basis"].T if "right" in state else matrix


def _improve(state: dict[str, Any]) -> None:
    """One step of power iteration for both bases, sorted by eigenvalue; the squares follow their axes."""
    for axis, side in enumerate(("left", "right")):
        if side not in state:
            continue
        basis = state[f"{side}_basis"]
        product = state[side] @ basis
        order = (basis * product).sum(0).argsort(descending=True)
        state["square"] = state["square"].index_select(axis, order)
        state[f"{side}_basis"] = torch.linalg.qr(product[:, order])[0].contiguous()
