"""The encoder as an ONNX model, exported by torch from a weights file.

    python -m studies.papers.chen2024.training.export neural.safetensors        writes neural.onnx beside it

Traced by torch's TorchScript exporter: the newer one needs the package onnxscript besides. Everything that
depends on the repeat is computed in the graph from the extents of the maps, so that one graph takes all
repeats. Weights that half precision holds exactly lie in half precision, and ONNX Runtime widens them once,
when it reads the model.
"""

from __future__ import annotations

import io
import os
import sys
import warnings
from pathlib import Path
from typing import Any

import onnx
import torch
from torch import Tensor, nn
from torch.nn import functional
from torch.nn.utils import parametrize

from loomlight.models.neural.architecture import FIELD_MAP, LEAKY_SLOPE, MAX_THREADS, VECTOR_MAP
from loomlight.models.neural.encoded_fabric import FINEST_LEVEL, WHOLE_REPEATS
from loomlight.models.neural.face_maps import CHANNELS
from loomlight.models.neural.weights import Weights, read_weights_alone
from studies.papers.chen2024.training.network import (
    PARAMETERS,
    FieldEncoder,
    VectorEncoder,
    scaled_parameters,
)
from studies.papers.chen2024.training.weights_file import write_encoder

# The first opset whose Pad wraps around, and the place of rows and columns among the axes of maps.
_OPSET = 19
_ROWS, _COLUMNS = 2, 3


def export_encoder(weights_path: str | os.PathLike[str]) -> Path:
    """Writes the encoder of a weights file beside it; returns its path.

    Raises:
        InputError: no weights file, a damaged one, or a place that cannot be written to.
    """
    weights = read_weights_alone(weights_path)
    return write_encoder(weights_path, encoder_model(weights), weights.sha256)


def encoder_model(weights: Weights) -> bytes:
    """The encoder of one face as an ONNX model: the same bytes for the same weights and version of torch.

    See `encoder.encoder_session` for inputs and output.
    """
    field = weights.table.latent == "field"
    encoder = FieldEncoder(weights.table) if field else VectorEncoder(weights.table)
    prefix = "encoder."
    encoder.load_state_dict(
        {
            name.removeprefix(prefix): torch.from_numpy(values)
            for name, values in weights.tensors.items()
            if name.startswith(prefix)
        }
    )
    graph = (_FieldGraph(encoder) if isinstance(encoder, FieldEncoder) else _VectorGraph(encoder)).eval()
    _store_in_half(graph)
    # A repeat whose extents differ from each other and from all channels.
    rows, columns = (3 * FIELD_MAP, 2 * FIELD_MAP) if field else (VECTOR_MAP, VECTOR_MAP)
    buffer = io.BytesIO()
    torch.onnx.register_custom_op_symbolic("aten::pad", _periodic_pad, _OPSET)
    try:
        with warnings.catch_warnings():
            # That the newer exporter is the default, and that constants are constants.
            warnings.simplefilter("ignore")
            torch.onnx.export(
                graph,
                (torch.zeros(1, CHANNELS, rows, columns), torch.full((PARAMETERS,), 0.5)),
                buffer,
                dynamo=False,
                opset_version=_OPSET,
                input_names=["maps", "parameters"],
                output_names=["latents"],
                dynamic_axes={"maps": {_ROWS: "rows", _COLUMNS: "columns"}, "latents": {0: "texels"}}
                if field
                else None,
                # Otherwise weights would be widened here.
                do_constant_folding=False,
            )
    finally:
        torch.onnx.unregister_custom_op_symbolic("aten::pad", _OPSET)
    model = buffer.getvalue()
    onnx.checker.check_model(model, full_check=True)
    return model


class _VectorGraph(nn.Module):
    """The "vector" encoder of one face."""

    def __init__(self, encoder: VectorEncoder) -> None:
        super().__init__()
        self.encoder = encoder

    def forward(self, maps: Tensor, parameters: Tensor) -> Tensor:
        """Latents [1, latent_size] of maps [1, 7, 128, 128] and parameters [4]."""
        return self.encoder(maps, parameters[None])


class _FieldGraph(nn.Module):
    """`FieldEncoder.forward` for repeats of any extent.

    All running means that a repeat of `MAX_THREADS` has are computed, and those that this one has are kept.
    """

    def __init__(self, encoder: FieldEncoder) -> None:
        super().__init__()
        self.encoder = encoder

    def forward(self, maps: Tensor, parameters: Tensor) -> Tensor:
        """Latents [texels, latent_size] of maps [1, 7, 16·picks, 16·ends] and parameters [4]."""
        found = self.encoder.pyramid(maps)
        rows = [_rows(features, level / 8) for level, features in enumerate(found)]
        shape = torch._shape_as_tensor(found[FINEST_LEVEL])
        picks, ends = shape[_ROWS], shape[_COLUMNS]
        windows = _windows()
        levels = (torch.tensor(windows) <= WHOLE_REPEATS * torch.maximum(picks, ends)).sum()
        means, wide = found[FINEST_LEVEL], []
        for level, window in enumerate(windows, FINEST_LEVEL + 1):
            half = window // 2
            before, after = (0, -1) if half == 1 else (half // 2, -(half // 2))
            for axis, extent in ((_COLUMNS, ends), (_ROWS, picks)):
                means = 0.5 * (_rolled(means, axis, extent, before) + _rolled(means, axis, extent, after))
            wide.append(_rows(means, level / 8))
        rows.append(torch.cat(wide)[: levels * picks * ends])
        last = ((levels + FINEST_LEVEL + 1).float() / 8).reshape(1, 1)
        rows.append(torch.cat([found[FINEST_LEVEL].mean((_ROWS, _COLUMNS)), last], 1))
        return self._joined(torch.cat(rows), parameters)

    def _joined(self, rows: Tensor, parameters: Tensor) -> Tensor:
        """`_Join.forward`; the parameters are the same in all rows, so their part is a bias."""
        join = self.encoder.join
        weight = join.first.weight
        features = weight.shape[1] - PARAMETERS
        bias = functional.linear(scaled_parameters(parameters[None]), weight[:, features:], join.first.bias)
        joined = functional.linear(rows, weight[:, :features], bias[0])
        hidden = functional.leaky_relu(joined, LEAKY_SLOPE)
        return join.last(functional.leaky_relu(joined + join.second(hidden), LEAKY_SLOPE))


def _rows(features: Tensor, level: float) -> Tensor:
    """Features [1, c, rows, columns] as rows [texels, c + 1]; the last is the level's number."""
    rows = features[0].flatten(1).T
    return torch.cat([rows, torch.full_like(rows[:, :1], level)], 1)


def _rolled(maps: Tensor, axis: int, extent: Tensor, shift: int) -> Tensor:
    """torch.roll by shifts that may be larger than the extent, which is known in the graph alone."""
    if shift == 0:
        return maps
    return maps.index_select(axis, (torch.arange(extent) - shift) % extent)


def _windows() -> list[int]:
    """Threads across of every running mean that a repeat of `MAX_THREADS` has."""
    windows = [2]
    while 2 * windows[-1] <= WHOLE_REPEATS * MAX_THREADS:
        windows.append(2 * windows[-1])
    return windows


class _Widened(nn.Module):
    def forward(self, values: Tensor) -> Tensor:
        return values.float()


def _store_in_half(graph: nn.Module) -> None:
    """Keeps parameters that half precision holds exactly in it, to be widened where they are used."""
    for module in list(graph.modules()):
        for name, values in list(module.named_parameters(recurse=False)):
            half = values.detach().half()
            if torch.equal(half.float(), values):
                setattr(module, name, nn.Parameter(half, requires_grad=False))
                parametrize.register_parametrization(module, name, _Widened(), unsafe=True)


def _periodic_pad(graph: Any, maps: Any, pads: Any, mode: Any, _value: Any) -> Any:
    """Periodic padding as one node; the exporter itself would cut out and join edges, which takes longer."""
    helper = torch.onnx.symbolic_helper
    if helper._parse_arg(mode, "s") != "circular":
        raise NotImplementedError("only periodic padding is exported")
    left, right, lower, upper = helper._parse_arg(pads, "is")
    ends = graph.op("Constant", value_t=torch.tensor([0, 0, lower, left, 0, 0, upper, right]))
    return graph.op("Pad", maps, ends, mode_s="wrap")


if __name__ == "__main__":
    print(export_encoder(sys.argv[1]))
