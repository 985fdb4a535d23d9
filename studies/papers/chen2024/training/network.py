"""The network of chen2024: an encoder of fabrics, and a decoder of footprints and directions.

Encoder: a ResNet-18 without its last stage over the maps of one face, and a residual block that joins α and β
of both families (chen2024 4.2). Two departures from the paper:

- Batch normalisation of a few fabrics a step is noise; residual branches start at a gain of zero instead.
- Convolutions wrap around, so global pooling would lose the origin of the weave's repeat. The "vector" latent
  takes every texel of the last map; the "field" latent is fetched at the footprint instead.

Decoder: one-blob coded footprint and latent are fused by two layers, then five layers over directions follow,
with one skip connection. A separate head gives the hole fraction, which does not depend on the light.

Highlights are narrower than a small network can fit. With a lobe basis, the network learns the weights of
bundles of fibres in a footprint, and the lobes of the bundles are computed.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.neural.architecture import (
    BINS,
    BLOB_RADIUS,
    BUNDLE_UNIT,
    BUNDLES,
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_BINS,
    INCLINATION_CROWDING,
    INCLINATION_RADIUS,
    LEAKY_SLOPE,
    LIGHT_FEATURES,
    LOG_ROUGHNESS,
    OPPOSITE,
    VECTOR_MAP,
    VIEW_FEATURES,
    NetworkTable,
)
from loomlight.models.neural.encoded_fabric import FINEST_LEVEL, Level, fine_tuning_weight, levels_of
from loomlight.models.neural.face_maps import CHANNELS
from studies.papers.chen2024.training.losses import gain

PARAMETERS = 4
ANGLES = 5
COMPONENTS = 4
FAMILIES = 2
# The first components are diffuse.
_DIFFUSE = 2
# Output for each lobe of the basis at initialization.
_FIRST_WEIGHT = 0.25


class ClothNetwork(nn.Module):
    """Encoder and decoder together."""

    def __init__(self, table: NetworkTable) -> None:
        super().__init__()
        self.table = table
        self.encoder: VectorEncoder | FieldEncoder
        self.encoder = VectorEncoder(table) if table.latent == "vector" else FieldEncoder(table)
        self.decoder = Decoder(table)


class _Block(nn.Module):
    """Two convolutions with a skip connection, as in ResNet-18 (He et al. 2016), gain 0 at first."""

    def __init__(self, inputs: int, outputs: int, stride: int) -> None:
        super().__init__()
        self.first = _convolution(inputs, outputs, 3, stride)
        self.second = _convolution(outputs, outputs, 3, 1)
        self.gain = nn.Parameter(torch.zeros(()))
        self.skip = None if inputs == outputs else _convolution(inputs, outputs, 1, stride)

    def forward(self, maps: Tensor) -> Tensor:
        short = maps if self.skip is None else self.skip(maps)
        return functional.relu(short + self.gain * self.second(functional.relu(self.first(maps))))


def _convolution(inputs: int, outputs: int, size: int, stride: int) -> nn.Conv2d:
    layer = nn.Conv2d(inputs, outputs, size, stride, size // 2, padding_mode="circular")
    nn.init.kaiming_normal_(layer.weight, nonlinearity="relu")
    nn.init.zeros_(layer.bias)
    return layer


class _Trunk(nn.Module):
    """ResNet-18 without its last stage: maps at 1/2, 1/4, 1/8 and 1/16 of the input's side."""

    def __init__(self, table: NetworkTable) -> None:
        super().__init__()
        width = table.width
        # Heights are the last channel of the maps.
        self.channels = CHANNELS if table.heights else CHANNELS - 1
        self.stem = _convolution(self.channels, width, 7, 2)
        self.stages = nn.ModuleList(
            nn.Sequential(_Block(inputs, outputs, stride), _Block(outputs, outputs, 1))
            for inputs, outputs, stride in (
                (width, width, 1),
                (width, 2 * width, 2),
                (2 * width, 4 * width, 2),
            )
        )

    def forward(self, maps: Tensor) -> list[Tensor]:
        maps = functional.relu(self.stem(maps[:, : self.channels]))
        found = [maps]
        # A periodic map's mean of 2×2 in place of the largest of 3×3, which needs padding.
        maps = functional.avg_pool2d(maps, 2)
        for stage in self.stages:
            maps = stage(maps)
            found.append(maps)
        return found


class _Join(nn.Module):
    """The residual block that joins features and the parameters α and β into a latent."""

    def __init__(self, features: int, hidden: int, latent: int) -> None:
        super().__init__()
        self.first = nn.Linear(features + PARAMETERS, hidden)
        self.second = nn.Linear(hidden, hidden)
        self.last = nn.Linear(hidden, latent)

    def forward(self, features: Tensor, parameters: Tensor) -> Tensor:
        joined = self.first(torch.cat([features, scaled_parameters(parameters)], 1))
        hidden = functional.leaky_relu(joined, LEAKY_SLOPE)
        return self.last(functional.leaky_relu(joined + self.second(hidden), LEAKY_SLOPE))


def scaled_parameters(parameters: Tensor) -> Tensor:
    """ln α and β [n, 4], each about −1 to 1: widths of highlights scale with ratios of α."""
    roughness, height_scale = parameters[:, :2], parameters[:, 2:]
    return torch.cat([1 + torch.log(roughness) / LOG_ROUGHNESS, 2 * height_scale - 1], 1)


class VectorEncoder(nn.Module):
    """One latent a face of a fabric, as published."""

    def __init__(self, table: NetworkTable) -> None:
        super().__init__()
        self.trunk = _Trunk(table)
        self.squeeze = _convolution(4 * table.width, 16, 1, 1)
        self.join = _Join(16 * (VECTOR_MAP // 16) ** 2, 128, table.latent_size)

    def forward(self, maps: Tensor, parameters: Tensor) -> Tensor:
        """Latents [n, latent_size] of maps [n, 7, 128, 128] and parameters [n, 4]."""
        last = functional.relu(self.squeeze(self.trunk(maps)[-1]))
        return self.join(last.flatten(1), parameters)


class FieldEncoder(nn.Module):
    """A latent for every position and size: a pyramid of 8 to 1 texels a thread, then of running means."""

    def __init__(self, table: NetworkTable) -> None:
        super().__init__()
        width, features = table.width, table.latent_size
        self.trunk = _Trunk(table)
        self.sideways = nn.ModuleList(
            _convolution(channels, features, 1, 1) for channels in (width, width, 2 * width, 4 * width)
        )
        # None at the finest level, where it would cost as much as the trunk.
        self.smooth = nn.ModuleList(_convolution(features, features, 3, 1) for _ in range(FINEST_LEVEL - 1))
        self.join = _Join(features + 1, 64, table.latent_size)

    def forward(self, maps: Tensor, parameters: Tensor) -> tuple[Tensor, list[Level]]:
        """Latents [texels, latent_size] of one face, level by level, and the levels.

        Args:
            maps: [7, 16·picks, 16·ends].
            parameters: [4].
        """
        found = self.pyramid(maps[None])
        picks, ends = found[-1].shape[-2:]
        levels = levels_of(picks, ends)
        while len(found) < len(levels) - 1:
            found.append(_wider(found[-1], int(levels[len(found)].window)))
        found.append(found[FINEST_LEVEL].mean((2, 3), keepdim=True))
        rows = []
        for number, features in enumerate(found):
            flat = features[0].flatten(1).T
            rows.append(functional.pad(flat, (0, 1), value=number / 8))
        texels = torch.cat(rows)
        return self.join(texels, parameters.expand(len(texels), -1)), levels

    def pyramid(self, maps: Tensor) -> list[Tensor]:
        """Features of 8, 4, 2 and 1 texels a thread [1, latent_size, rows, columns] of maps [1, 7, …]."""
        stages = self.trunk(maps)
        found = [self.sideways[-1](stages[-1])]
        for number in range(FINEST_LEVEL - 1, -1, -1):
            coarser = functional.interpolate(found[0], scale_factor=2, mode="nearest")
            joined = functional.relu(self.sideways[number](stages[number]) + coarser)
            found.insert(0, self.smooth[number - 1](joined) if number else joined)
        return found


def _wider(means: Tensor, window: int) -> Tensor:
    """Running means over `window` threads of those over half as many, around the texel's upper corner."""
    half = window // 2
    before, after = (0, -1) if half == 1 else (half // 2, -(half // 2))
    along = 0.5 * (torch.roll(means, before, 3) + torch.roll(means, after, 3))
    return 0.5 * (torch.roll(along, before, 2) + torch.roll(along, after, 2))


class Decoder(nn.Module):
    """Latents, footprints and directions to components."""

    def __init__(self, table: NetworkTable) -> None:
        super().__init__()
        hidden = table.hidden
        self.table = table
        spatial = table.latent_size + (3 * BINS if table.position == "one_blob" else 3)
        fused = hidden if table.fusion else spatial
        self.fusion = _layers(spatial, hidden, hidden) if table.fusion else nn.ModuleList()
        inner = [hidden] * (4 if table.fusion else 6)
        directions = ANGLES + (LIGHT_FEATURES + VIEW_FEATURES if table.fibres else 0)
        self.angular = _layers(fused + directions, *inner, table.outputs)
        if table.bundles:
            # All lobes have a positive weight at first, so that all have gradients.
            nn.init.constant_(self.angular[-1].bias[_DIFFUSE:], _FIRST_WEIGHT)
        self.hole = _layers(fused + 2, 16, 1)

    def forward(
        self,
        latent: Tensor,
        coordinates: Tensor,
        light: Tensor,
        view: Tensor,
        fibres: Tensor,
        bundles: Tensor | None = None,
        correction: Tensor | None = None,
    ) -> tuple[Tensor, Tensor]:
        """Components [n, 4] as logarithms (see `losses.mapped`), and the hole fraction [n].

        Args:
            latent: [n, latent_size].
            coordinates: position x and y, and size of the footprint, each 0 to 1 [n, 3].
            light, view: unit vectors in the frame of the face that is seen [n, 3].
            fibres: of the face that is seen [n, 2, 3]; see `Fibres.face`.
            bundles: of the face that is seen [b, 2, `BUNDLES`, 4], each for n/b consecutive queries; see
                `Fibres.bundles`. Required with a lobe basis.
            correction: of the last layer's rows for the lobe basis [2 · `BUNDLES`, hidden + 1], applied in
                reflection by large footprints; see `EncodedFabric`.
        """
        coded = one_blob(coordinates) if self.table.position == "one_blob" else coordinates
        spatial = torch.cat([latent, coded], 1)
        for layer in self.fusion:
            spatial = functional.leaky_relu(layer(spatial), LEAKY_SLOPE)
        directions = [light, view[:, :2]]
        if self.table.fibres:
            directions.append(fibre_features(light, view, fibres))
        hidden: Any = torch.cat([spatial, *directions], 1)
        skip, kind = None, coordinates.device.type
        for number, layer in enumerate(self.angular):
            last = number + 1 == len(self.angular)
            # The output is a logarithm, for which bfloat16 is too coarse.
            with torch.autocast(kind, enabled=torch.is_autocast_enabled(kind) and not last):
                last_inputs = hidden.to(layer.weight.dtype) if last else hidden
                hidden = layer(last_inputs)
                if last and correction is not None:
                    weight = fine_tuning_weight(coordinates[:, 2:], torch) * (light[:, 2:] > 0)
                    added = functional.linear(last_inputs, correction[:, :-1], correction[:, -1])
                    hidden = torch.cat([hidden[:, :_DIFFUSE], hidden[:, _DIFFUSE:] + weight * added], 1)
            if number == 0:
                skip = hidden
            elif number == 2:
                hidden = hidden + skip
            if not last:
                hidden = functional.leaky_relu(hidden, LEAKY_SLOPE)
        if bundles is not None and self.table.bundles:
            with torch.autocast(kind, enabled=False):
                mixed = mixed_bundles(hidden[:, _DIFFUSE:], light + view, bundles)
                hidden = torch.cat([hidden[:, :_DIFFUSE], _logarithmic(mixed * gain(light))], 1)
        hole = functional.leaky_relu(self.hole[0](torch.cat([spatial, view[:, :2]], 1)), LEAKY_SLOPE)
        return hidden, self.hole[1](hole)[:, 0]


def fibre_features(light: Tensor, view: Tensor, fibres: Tensor) -> Tensor:
    """Features [n, 38] of lights and views [n, 3] along the fibres of both families.

    Highlights are ridges of width α where the half vector is perpendicular to the fibres, which are rotated
    against the threads by the twist. For each family, warp then weft:

    - the cosines of the view, then of the light, with the fibres on a yarn's crown;
    - the inclination along these of which fibres would reflect the light into the view, one-blob coded, bins
      crowded about 0, where highlights are narrowest;
    - the density of normals of the fibres on a crown towards the half vector, as a logarithm.

    Args:
        fibres: direction on a crown, x and y, and α [n, 2 families, 3].
    """
    along, roughness = fibres[..., :2], fibres[..., 2]
    cosines = [(along * direction[:, None, :2]).sum(2) for direction in (view, light)]
    total = light + view
    cosine = cosines[0] + cosines[1]
    square = cosine.square()
    length = torch.sqrt(square + total[:, 2:].square() + OPPOSITE)
    position = (1 + INCLINATION_CROWDING) * cosine / (cosine.abs() + INCLINATION_CROWDING * length)
    numbers = torch.arange(INCLINATION_BINS, dtype=position.dtype, device=position.device)
    centres = (numbers + 0.5) / INCLINATION_BINS
    distance = (0.5 + 0.5 * position[:, :, None] - centres) * (INCLINATION_BINS / INCLINATION_RADIUS)
    bins = torch.clamp(1 - distance * distance, min=0).square().flatten(1)
    flat = square / (total.square().sum(1, keepdim=True) + OPPOSITE)
    squared_roughness = roughness.square()
    q = squared_roughness + flat * (1 - squared_roughness)
    density = squared_roughness * roughness / (torch.pi * q.square())
    return torch.cat([*cosines, bins, DENSITY_SCALE * torch.log1p(DENSITY_GAIN * density)], 1)


def mixed_bundles(lobe_weights: Tensor, total: Tensor, bundles: Tensor) -> Tensor:
    """Specular components [n, 2], 1/sr: mixtures of the lobe basis.

    Args:
        lobe_weights: outputs for the bundles of both families [n, 2 · `BUNDLES`].
        total: light plus view [n, 3].
        bundles: [b, 2, `BUNDLES`, 4], each for n/b consecutive queries.
    """
    count, groups = total.shape[0], len(bundles)  # the shape, which ONNX keeps open
    inverse = 1 / (total.square().sum(1) + OPPOSITE)
    cosine = torch.einsum("gnc,gfbc->gnfb", total.view(groups, -1, 3), bundles[..., :3])
    width = bundles[:, None, :, :, 3].expand_as(cosine).reshape(count, FAMILIES, BUNDLES)
    root = width + cosine.reshape(count, FAMILIES, BUNDLES).square() * inverse[:, None, None]
    weights = BUNDLE_UNIT * functional.leaky_relu(lobe_weights, LEAKY_SLOPE).view(count, FAMILIES, BUNDLES)
    return (weights / root.square()).sum(2)


def _logarithmic(values: Tensor) -> Tensor:
    """ln(x + 1), and x below 0, where it keeps a gradient."""
    return torch.where(values > 0, torch.log1p(torch.clamp(values, min=0)), values)


def _layers(*widths: int) -> nn.ModuleList:
    return nn.ModuleList(nn.Linear(before, after) for before, after in pairwise(widths))


def one_blob(place: Tensor) -> Tensor:
    """One-blob coding (Müller et al. 2021) of x, y and size [n, 3] by 8 bins each [n, 24].

    Positions wrap around. The bump is quartic, which is near the Gaussian and needs no exponential.
    """
    centres = (torch.arange(BINS, dtype=place.dtype, device=place.device) + 0.5) / BINS
    offset = place[:, :, None] - centres
    around = offset[:, :2] - torch.round(offset[:, :2])
    distance = torch.cat([around, offset[:, 2:]], 1) * (BINS / BLOB_RADIUS)
    return torch.clamp(1 - distance * distance, min=0).square().flatten(1)
