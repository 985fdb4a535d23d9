"""Settings that studies of papers share, each declared once; a study has those that it reads."""

from __future__ import annotations

import os
from dataclasses import dataclass

from loomlight.core.picture_settings import MAX_SIDE
from loomlight.core.settings import Settings, same_setting, setting
from loomlight.models.options import TrainingOptions


@dataclass(frozen=True)
class PictureSettings(Settings):
    """Of figures of pictures."""

    size: tuple[int, int] = setting(
        (384, 216), "Pixels of each picture.", low=1, high=MAX_SIDE, metavar="WxH"
    )
    spp: int = setting(256, "Samples a pixel of references.", low=1, high=1_000_000)


@dataclass(frozen=True)
class LitSettings(PictureSettings):
    """Of scenes that an environment lights."""

    environment: os.PathLike[str] | None = setting(
        None, "A latitude-longitude picture that lights the scene.", otherwise="the studio", metavar="FILE"
    )


@dataclass(frozen=True)
class TrainedSettings(PictureSettings):
    """Of figures that train models; trainings are kept in the folder of runs, and used again."""

    quality: str = setting("preview", "How long is trained.", choices=("preview", "full", "published"))
    steps: int | None = same_setting(TrainingOptions, "steps", help="Of each training.")
    resolution: int | None = same_setting(TrainingOptions, "resolution", help="Texels a side of textures.")
