"""The decoder as an ONNX model, for programs that run networks: exported by torch from a weights file.

    python -m studies.papers.chen2024.training.decoder neural.safetensors      writes
    neural_decoder.onnx beside it

Inputs are those of `network.Decoder.forward` for queries of one face, outputs components in 1/sr and the
hole fraction. Latents are an input: whoever calls it interpolates them, see `encoded_fabric.taps`.
"""

from __future__ import annotations

import io
import os
import sys
import warnings
from pathlib import Path

import onnx
import torch
from torch import Tensor, nn

from loomlight.core.files import replacing
from loomlight.models.neural.architecture import BUNDLES, MAX_OUTPUT
from loomlight.models.neural.weights import Weights, read_weights_alone
from studies.papers.chen2024.training.losses import gain
from studies.papers.chen2024.training.network import COMPONENTS, FAMILIES, Decoder

_OPSET = 17
INPUTS = ("latent", "coordinates", "light", "view", "fibres", "bundles", "correction")


def export_decoder(weights_path: str | os.PathLike[str]) -> Path:
    """Writes the decoder of a weights file beside it; returns its path.

    Raises:
        InputError: no weights file, a damaged one, or a place that cannot be written to.
    """
    path = Path(weights_path)
    target = path.with_name(f"{path.stem}_decoder.onnx")
    with replacing(target) as temporary:
        temporary.write_bytes(decoder_model(read_weights_alone(weights_path)))
    return target


def decoder_model(weights: Weights) -> bytes:
    """The decoder as an ONNX model: the same bytes for the same weights and version of torch.

    Inputs, float32: latent [n, latent_size]; coordinates, light and view [n, 3]; fibres [2, 3], bundles
    [2, `BUNDLES`, 4] and correction [2 · `BUNDLES`, hidden + 1] of the face that is seen. Outputs:
    components [n, 4], 1/sr, and hole [n].
    """
    decoder = Decoder(weights.table)
    prefix = "decoder."
    decoder.load_state_dict(
        {
            name.removeprefix(prefix): torch.from_numpy(values)
            for name, values in weights.tensors.items()
            if name.startswith(prefix)
        }
    )
    graph = _DecoderGraph(decoder, weights.linear_diffuse).eval()
    count, table = 5, weights.table
    shapes = {
        "latent": (count, table.latent_size),
        "coordinates": (count, 3),
        "light": (count, 3),
        "view": (count, 3),
        "fibres": (FAMILIES, 3),
        "bundles": (FAMILIES, BUNDLES, 4),
        "correction": (FAMILIES * BUNDLES, table.hidden + 1),
    }
    buffer = io.BytesIO()
    with warnings.catch_warnings():
        # That the newer exporter is the default, and that constants are constants.
        warnings.simplefilter("ignore")
        torch.onnx.export(
            graph,
            tuple(torch.full(shapes[name], 0.5) for name in INPUTS),
            buffer,
            dynamo=False,
            opset_version=_OPSET,
            input_names=list(INPUTS),
            output_names=["components", "hole"],
            dynamic_axes={name: {0: "queries"} for name in (*INPUTS[:4], "components", "hole")},
        )
    model = buffer.getvalue()
    onnx.checker.check_model(model, full_check=True)
    return model


class _DecoderGraph(nn.Module):
    """The decoder with components in place of logarithms."""

    def __init__(self, decoder: Decoder, linear_diffuse: bool) -> None:
        super().__init__()
        self.decoder = decoder
        self.linear_diffuse = linear_diffuse

    def forward(
        self,
        latent: Tensor,
        coordinates: Tensor,
        light: Tensor,
        view: Tensor,
        fibres: Tensor,
        bundles: Tensor,
        correction: Tensor,
    ) -> tuple[Tensor, Tensor]:
        """Components [n, 4], 1/sr, ≥ 0, and the hole fraction [n], 0 to 1."""
        everywhere = fibres.expand(latent.shape[0], FAMILIES, 3)
        outputs, hole = self.decoder(latent, coordinates, light, view, everywhere, bundles[None], correction)
        assert outputs.shape[1] == COMPONENTS
        # ONNX has no expm1, which `losses.unmapped` takes.
        k = gain(light)
        components = (torch.exp(torch.clamp(outputs, 0, MAX_OUTPUT)) - 1) / k
        if self.linear_diffuse:
            components = torch.cat([torch.clamp(outputs[:, :2], min=0), components[:, 2:]], 1)
        return components, torch.clamp(hole, 0, 1)


if __name__ == "__main__":
    print(export_decoder(sys.argv[1]))
