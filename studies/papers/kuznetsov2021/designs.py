"""Designs of networks that read neural textures: kuznetsov2021's, and those it is compared with."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise


@dataclass(frozen=True)
class Design:
    """A decoder of neural textures, with or without the neural offset.

    Attributes:
        latent: channels of a texel that the decoder reads, and of the offset texture.
        hidden: widths of the hidden layers, of both networks.
        offset: with the neural offset module.
        whitened: texels hold a mean and a deviation of each colour too, six channels, and the decoder gives
            how many deviations a colour is from its mean.
        encoded: latents are an encoder's, of what is measured of a texel (`encoded_textures.py`).
        together: one encoder and one decoder are trained for many materials.
    """

    latent: int
    hidden: tuple[int, ...]
    offset: bool = False
    whitened: bool = False
    encoded: bool = False
    together: bool = False

    @property
    def decoder_widths(self) -> tuple[int, ...]:
        """Widths of all layers: texel, light and view to RGB."""
        return self.latent + 4, *self.hidden, 3

    @property
    def offset_widths(self) -> tuple[int, ...]:
        """Widths of all layers: texel and view to a ray depth."""
        return self.latent + 2, *self.hidden, 1

    @property
    def pyramid_channels(self) -> int:
        """Numbers of a texel of the pyramid."""
        return self.latent + 6 * self.whitened

    @property
    def channels(self) -> int:
        """Numbers of a texel, the offset texture's included, as Table 4 counts them."""
        return self.pyramid_channels + self.latent * self.offset

    @property
    def weights(self) -> int:
        """Weights of the networks, as Table 4 counts them."""
        networks = [self.decoder_widths, *([self.offset_widths] if self.offset else [])]
        return sum((a + 1) * b for widths in networks for a, b in pairwise(widths))


OURS, WITHOUT, RAINER19, RAINER20 = "ours", "ours without offset", "Rainer19", "Rainer20"
# Rainer et al. 2019 have 8 latent channels and 2020 have 32, beside mean and deviation of three colours; both
# decoders have four layers of 106, which gives the 35 725 and 38 269 weights of kuznetsov2021's Table 4.
DESIGNS = {
    WITHOUT: Design(7, (25, 25, 25)),
    OURS: Design(7, (25, 25, 25), offset=True),
    RAINER19: Design(8, (106,) * 4, whitened=True, encoded=True),
    RAINER20: Design(32, (106,) * 4, whitened=True, encoded=True, together=True),
}
# Rainer et al. 2019 with about as many weights as ours, 3273 beside 3254: the paper compares no such thing.
RAINER19_SMALL = "Rainer19 of 3273 weights"
ALL_DESIGNS = DESIGNS | {RAINER19_SMALL: Design(8, (30,) * 4, whitened=True, encoded=True)}
