"""The encoded fabric: latents of both faces, with its fibres."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.tables import (
    Layer,
    Number,
    Shown,
    Tables,
    computed,
    derived,
    flag,
    given,
    number,
    size,
    table,
)
from loomlight.models.neural.architecture import BUNDLES, NetworkTable
from loomlight.models.neural.fibres import Fibres
from loomlight.models.neural.footprint_coding import Level, levels_of


def _fibre_fault(numbers: NDArray[np.float32]) -> str:
    error = Fibres.from_array(numbers).validation_error()
    return "" if error is None else f"out of range, as {error}"


def _crown(family: int, entry: int, meaning: str = "") -> Number[float]:
    """An entry of `Fibres.face` of the front."""
    return Number("float", meaning, lambda encoded: float(encoded.fibres.face(False)[family, entry]))


def _lobe_roughness(family: int, meaning: str = "") -> Number[float]:
    return Number("float", meaning, lambda encoded: encoded.fibres.lobe_roughness()[family])


def _last_layer(correction: NDArray[np.float32]) -> list[Layer]:
    return [(correction[:, :-1], correction[:, -1])]


class EncodedFabric(Tables):
    """The inputs of the decoder that belong to a fabric: in files, on devices and in shaders.

    Attributes:
        picks, ends: of the shortest repeat, without its colours.
    """

    record = "neural"

    is_encoded = flag("0 where the fabric has no latents")
    network = given("uint", "first element of the layers in packed_numbers", "layers")
    front: NDArray[np.float16] = table("latents of the front", ("texels", "latent_size"))
    back: NDArray[np.float16] = table("latents of the back", ("texels", "latent_size"))

    @derived("halves: latents of both faces", ("2 faces", "texels", "NEURAL_LATENT"), words="elements")
    def latents(self) -> NDArray[np.float16]:
        """In half precision, in memory as in files."""
        return np.concatenate(self.faces)

    texels = size("of one face", of="front")

    @derived("first texel, columns, rows, texels a thread of each level", (None, 4), words="words")
    def levels(self) -> NDArray[np.float32]:
        """Whole numbers below 2^24, which single precision holds exactly."""
        rows = [(level.first, level.columns, level.rows, level.per_thread) for level in self.pyramid]
        return np.array(rows, np.float32)

    @computed("the mean of the repeat")
    def top_level(self) -> int:
        """Its number."""
        return len(self.pyramid) - 1

    ends: int = number("float", "threads of the warp in the repeat of the latents")
    picks: int = number("float", "the same of the weft")
    ends_per_mm = given("float", "")
    picks_per_mm = given("float", "")
    pitch = given("float", "geometric mean of the spacings of both families")
    warp_x = _crown(0, 0, "fibre direction on the crown of a yarn of the warp, of the front")
    warp_y = _crown(0, 1)
    warp_roughness = _crown(0, 2, "α that the network sees")
    weft_x = _crown(1, 0, "the same of the weft")
    weft_y = _crown(1, 1)
    weft_roughness = _crown(1, 2)
    warp_lobe_roughness = _lobe_roughness(0, "α of the lobe that directions are sampled with")
    weft_lobe_roughness = _lobe_roughness(1)

    @derived("b and a of each lobe of the basis", ("2 families", f"{BUNDLES} lobes", 4), words="words")
    def bundles(self) -> NDArray[np.float32]:
        """See `Fibres.bundles`."""
        return self.fibres.bundles(False)

    @computed("1 where the last layer is fitted to the fabric")
    def is_corrected(self) -> int:
        """Whether there is a correction."""
        return int(self.correction is not None)

    fibre_numbers: NDArray[np.float32] = table(
        "twist, roughness, inclination and height scale of the fibres; see `Fibres`",
        (4, "2 families"),
        tensor="fibres",
        fault=_fibre_fault,
    )
    correction: NDArray[np.float32] | None = table(
        "added to the decoder's last layer, to its rows for the lobe basis, biases last; singles, as halves "
        "would round it",
        (2 * BUNDLES, "hidden + 1"),
        words="layers",
        shown=Shown((), _last_layer),
        default=None,
    )

    @classmethod
    def of(
        cls,
        repeat: tuple[int, int],
        faces: tuple[NDArray[np.float16], NDArray[np.float16]],
        fibres: Fibres,
        correction: NDArray[np.float32] | None = None,
    ) -> EncodedFabric:
        """A fabric of latents of front and back.

        Args:
            repeat: picks and ends.
        """
        picks, ends = repeat
        front, back = faces
        return cls(front, back, ends, picks, fibres.array(), correction)

    @property
    def faces(self) -> tuple[NDArray[np.float16], NDArray[np.float16]]:
        """Latents of front and back."""
        return self.front, self.back

    @cached_property
    def fibres(self) -> Fibres:
        """Of both families."""
        return Fibres.from_array(self.fibre_numbers)

    @property
    def pyramid(self) -> list[Level]:
        """The levels of the latent field."""
        return levels_of(self.picks, self.ends)

    @cached_property
    def stacked(self) -> NDArray[np.float32]:
        """Front above back [2 texels, latent_size], in single precision."""
        return np.concatenate(self.faces).astype(np.float32)

    def mixed(self, other: EncodedFabric, weight: float) -> EncodedFabric:
        """Interpolates latents and fibres to another fabric of the same repeat.

        Args:
            weight: 0 is this fabric, 1 the other; other values extrapolate.

        Raises:
            InputError: repeats of different size.
        """
        if (self.picks, self.ends) != (other.picks, other.ends):
            raise InputError(
                f"fabrics of {self.ends} × {self.picks} and {other.ends} × {other.picks} threads cannot be "
                "interpolated: encode both for a common repeat."
            )
        front, back = (
            (mine + weight * (yours.astype(np.float32) - mine)).astype(np.float16)
            for mine, yours in zip(self.faces, other.faces, strict=True)
        )
        correction = None
        if self.correction is not None and other.correction is not None:
            correction = self.correction + np.float32(weight) * (other.correction - self.correction)
        fibres = self.fibres.mixed(other.fibres, weight)
        return EncodedFabric.of((self.picks, self.ends), (front, back), fibres, correction)


def sizes_of(picks: int, ends: int, network: NetworkTable) -> dict[str, int]:
    """Sizes of the tables of a repeat by a network, which files must have."""
    texels = levels_of(picks, ends)[-1].first + 1 if network.latent == "field" else 1
    return {"texels": texels, "latent_size": network.latent_size, "hidden": network.hidden}
