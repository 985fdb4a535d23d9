"""The cache of latents: the last fabrics in memory, and files under the user's cache folder.

A file is a safetensors file whose name is the key: `front` and `back` in half precision, and `correction`
where the last layer was fine-tuned. Damaged files are ignored, and their latents computed again.
"""

from __future__ import annotations

import hashlib
from collections import OrderedDict

import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.files import cache_folder, replacing
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.encoded_fabric import EncodedFabric, sizes_of
from loomlight.models.neural.encoder import fabric_parameters, shortest_repeat
from loomlight.models.neural.fibres import Fibres
from loomlight.models.neural.weights import Weights
from loomlight.sources.loom_file import LoomFile

# Part of every key: to be raised when maps of the same layout change.
_VERSION = 2
# Fabrics kept in memory, and texels above which a fabric is not kept on disk (8 MB of half precision).
_FABRICS_IN_MEMORY = 64
_MAX_TEXELS_ON_DISK = 1 << 16
_in_memory: OrderedDict[str, EncodedFabric] = OrderedDict()


def read_latents(
    key: str, fabric: Fabric, repeat: tuple[int, int], weights: Weights, fine_tuned: bool
) -> EncodedFabric | None:
    """The latents of a key, from memory or disk; None if they are not cached.

    Args:
        repeat: picks and ends.
    """
    return _in_memory.get(key) or _read(key, fabric, repeat, weights, fine_tuned)


def store_latents(key: str, encoded: EncodedFabric) -> None:
    """Stores latents under a key, as the most recently used."""
    if key not in _in_memory:
        _write(key, encoded)
    _in_memory[key] = encoded
    _in_memory.move_to_end(key)
    while len(_in_memory) > _FABRICS_IN_MEMORY:
        _in_memory.popitem(last=False)


def clear_encodings() -> None:
    """Clears the cache in memory."""
    _in_memory.clear()


def cache_key(fabric: Fabric, weights: Weights, repeats: tuple[int, int], fine_tuned: bool) -> str:
    """SHA-256 of everything that the latents depend on."""
    layout = shortest_repeat(fabric.layout())
    digest = hashlib.sha256(f"{_VERSION} {weights.sha256} {repeats} {fine_tuned}\n".encode())
    digest.update(repr(layout.warp_on_top.shape).encode() + np.packbits(layout.warp_on_top).tobytes())
    for family in (layout.warp, layout.weft):
        digest.update(np.asarray(family.spacing, np.float64).tobytes())
        digest.update(np.asarray(family.width, np.float64).tobytes())
        digest.update(repr((float(family.inclination), float(family.twist))).encode())
    digest.update(fabric_parameters(fabric).tobytes())
    appearance = fabric.appearance()
    digest.update(repr((float(appearance.diffuse_blend), float(appearance.optical_depth))).encode())
    return digest.hexdigest()


def _read(
    key: str, fabric: Fabric, repeat: tuple[int, int], weights: Weights, fine_tuned: bool
) -> EncodedFabric | None:
    """The latents on disk; None if there is no file or an unusable one."""
    picks, ends = repeat
    try:
        arrays = load_file(cache_folder("neural") / f"{key}.safetensors")
        read = LoomFile("neural", fabric, arrays).tables(
            EncodedFabric,
            sizes_of(picks, ends, weights.table),
            picks=picks,
            ends=ends,
            fibre_numbers=Fibres.of(fabric).array(),
        )
    except (InputError, SafetensorError, OSError, ValueError):
        return None
    return read if (read.correction is not None) == fine_tuned else None


def _write(key: str, encoded: EncodedFabric) -> None:
    """Writes latents to disk; ignores errors, which cost a run of the encoder next time."""
    if len(encoded.faces[0]) > _MAX_TEXELS_ON_DISK:
        return
    folder = cache_folder("neural")
    file = folder / f"{key}.safetensors"
    if file.exists():
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            arrays = encoded.arrays()
            del arrays["fibres"]  # those of the fabric
            save_file(arrays, temporary)
    except (OSError, LoomlightError, SafetensorError):
        return
