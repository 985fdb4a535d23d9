"""What a machine has of that which jobs need; each is asked in a process of its own, as drivers may crash."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from loomlight.core.errors import LoomlightError, MissingDependencyError
from studies.instruments.processes import in_own_process


@dataclass(frozen=True)
class Has:
    """Whether a machine has something.

    Attributes:
        name: of the device; empty where there is none.
        lacks: a sentence that says why not; empty where it is there.
    """

    name: str = ""
    lacks: str = ""


def adapter() -> tuple[str, str, bool]:
    """Name of the graphics adapter, what is missing, and whether it is a software driver."""
    from loomlight.realtime.device import default_adapter

    try:
        found = default_adapter()
    except MissingDependencyError as error:
        return "", str(error), False
    return found.name, "", found.is_software


def cuda_of_drjit() -> tuple[str, str, bool]:
    """As `adapter`, of the device that Dr.Jit compiles CUDA kernels for."""
    import drjit

    if not drjit.has_backend(drjit.JitBackend.CUDA):
        return "", "Dr.Jit finds no CUDA device: it needs an NVIDIA card and its driver.", False
    return "CUDA", "", False


def cuda_of_torch() -> tuple[str, str, bool]:
    """As `adapter`, of PyTorch's CUDA device."""
    try:
        import torch
    except ModuleNotFoundError:
        return "", "PyTorch is not installed: pip install 'loomlight[train]'.", False
    if not torch.cuda.is_available():
        return "", "PyTorch finds no CUDA device: it needs an NVIDIA card and PyTorch with CUDA.", False
    return torch.cuda.get_device_name(), "", False


# By name: how it is asked.
NEEDS: dict[str, Callable[[], tuple[str, str, bool]]] = {
    "graphics card": adapter,
    "CUDA for Dr.Jit": cuda_of_drjit,
    "CUDA for PyTorch": cuda_of_torch,
}
# What a rehearsal needs too; it does without the others.
_REHEARSED = ("graphics card",)


def look_for(need: str, rehearses: bool) -> Has:
    """Whether this machine has what a job needs.

    Args:
        need: a name of `NEEDS`.
        rehearses: a software driver will do, and what only a card can do is done without.
    """
    if rehearses and need not in _REHEARSED:
        return Has("not needed to rehearse")
    try:
        name, lacks, is_software = in_own_process(NEEDS[need])
    except LoomlightError as error:
        return Has(lacks=str(error))
    if is_software and not rehearses:
        return Has(name, f"{name} is a software driver, and a graphics card is needed.")
    return Has(name, lacks)
