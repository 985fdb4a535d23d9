"""A picture: cloth draped in the studio, linear RGB, refined while you wait."""

from pathlib import Path

import loomlight

EXAMPLES = Path(__file__).parent


def so_far(picture):
    """Called with whole pictures, each better than the one before."""
    loomlight.save(picture, "linen.png")


picture = loomlight.render(EXAMPLES / "linen.toml", "drape", size=(320, 240), spp=4, partial=so_far)
print("mean linear RGB", picture.mean(axis=(0, 1)))
loomlight.save(picture, "linen.png")  # sRGB
loomlight.save(picture, "linen.exr")  # the linear values
