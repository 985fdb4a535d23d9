"""Latents of fabrics, from the cache or by the encoder, and fine-tuning of the last layer."""

from __future__ import annotations

import math
from dataclasses import replace

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import MAX_THREADS
from loomlight.models.neural.encoded_fabric import EncodedFabric
from loomlight.models.neural.encoder import repeat_threads, run_encoder, shortest_repeat
from loomlight.models.neural.fine_tuning import fitted_correction
from loomlight.models.neural.latent_cache import cache_key, read_latents, store_latents
from loomlight.models.neural.parameter_ranges import trained_ranges, warn_outside_ranges
from loomlight.models.neural.weights import Weights


def encode(
    fabric: Fabric,
    weights: Weights,
    float_type: type,
    repeats: tuple[int, int] = (1, 1),
    refined: bool = False,
) -> EncodedFabric:
    """The latents of both faces, from the cache or by the encoder.

    Args:
        float_type: the Dr.Jit Float type that the encoder's maps are computed with.
        repeats: repetitions of the repeat along picks and along ends, for a common repeat of two fabrics.
        refined: fine-tune the last layer for the fabric, which takes seconds (`fine_tuning.py`); ignored
            without a lobe basis or a latent field.

    Raises:
        InputError: a repeat of more than 64 threads a side.
    """
    require_encodable(fabric)
    picks, ends = (count * times for count, times in zip(repeat_threads(fabric), repeats, strict=True))
    warn_outside_ranges(fabric, trained_ranges(weights))
    refined = refined and weights.table.bundles and weights.table.latent == "field"
    key = cache_key(fabric, weights, repeats, refined)
    encoded = read_latents(key, fabric, (picks, ends), weights, refined)
    if encoded is None and refined:
        encoded = _fine_tuned(fabric, weights, float_type, repeats)
    if encoded is None:
        encoded = run_encoder(fabric, weights, float_type, repeats)
    store_latents(key, encoded)
    return encoded


def require_encodable(fabric: Fabric) -> None:
    """Raises InputError unless the encoder takes the fabric: repeats of up to 64 threads a side."""
    picks, ends = repeat_threads(fabric)
    if max(picks, ends) > MAX_THREADS:
        raise InputError(
            f"{fabric.name}: its repeat of {ends} ends × {picks} picks is too large for the model neural, "
            f'which takes up to {MAX_THREADS} a side: use the model "point".'
        )


def encode_pair(
    first: Fabric, second: Fabric, weights: Weights, float_type: type, refined: bool = False
) -> tuple[EncodedFabric, EncodedFabric]:
    """Two fabrics on their common repeat, to be interpolated.

    Raises:
        InputError: a common repeat of more than 64 threads a side.
    """
    threads_of_first, threads_of_second = repeat_threads(first), repeat_threads(second)
    common = [math.lcm(a, b) for a, b in zip(threads_of_first, threads_of_second, strict=True)]
    if max(common) > MAX_THREADS:
        raise InputError(
            f"{first.name} and {second.name} have a common repeat of {common[1]} ends × {common[0]} picks: "
            f"latents are interpolated up to {MAX_THREADS} a side."
        )
    one, other = (
        encode(fabric, weights, float_type, (common[0] // threads[0], common[1] // threads[1]), refined)
        for fabric, threads in ((first, threads_of_first), (second, threads_of_second))
    )
    return one, other


def _fine_tuned(
    fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int]
) -> EncodedFabric:
    """The encoder's latents, and a correction of the last layer for the fabric."""
    single = encode(fabric, weights, float_type)
    correction = fitted_correction(fabric, shortest_repeat(fabric.layout()), single, weights, float_type)
    encoded = single if repeats == (1, 1) else encode(fabric, weights, float_type, repeats)
    return replace(encoded, correction=correction)
