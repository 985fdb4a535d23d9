"""Drafts: named weaves, weaving information files, pictures of drawdowns; drawing and textile units."""

from loomlight.weave.binding import bind_floats
from loomlight.weave.bitmaps import BitmapLayout, draft_of_wefts, read_bitmap, split_wefts, write_bitmaps
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, FamilyDefaults, LoomPlan, Threads, WifSource
from loomlight.weave.drawing import MAXIMUM_PICTURE_SIDE_PX, draw_draft, draw_drawdown, draw_layer
from loomlight.weave.dtx import write_dtx
from loomlight.weave.figured import figured_structure
from loomlight.weave.layer_drafts import (
    LayerDraft,
    binding_points,
    layer_draft,
    layers_text,
    named_layer,
    plain_draft,
)
from loomlight.weave.layers import Layers, ThreadSystem, find_layers
from loomlight.weave.load import DRAFT_SUFFIXES, load_draft
from loomlight.weave.loom import derive_loom_plan, plan_drawdown, with_loom_plan
from loomlight.weave.named import named_weave, weave_names
from loomlight.weave.palette import repeat_draft, with_palette
from loomlight.weave.picture import drawdown_from_picture
from loomlight.weave.save import save_draft
from loomlight.weave.textile import (
    DEFAULT_SETT_PER_CM,
    FloatLengths,
    longest_floats,
    per_cm,
    per_inch,
    repeat_size_cm,
    sett_per_cm,
    summary,
    unbound_threads,
    warp_cover,
    yarn_diameter_mm,
    yarn_tex,
)
from loomlight.weave.wif_reader import read_wif
from loomlight.weave.wif_writer import write_wif

__all__ = [
    "DEFAULT_SETT_PER_CM",
    "DRAFT_SUFFIXES",
    "MAXIMUM_PICTURE_SIDE_PX",
    "MAXIMUM_THREADS",
    "BitmapLayout",
    "Draft",
    "FamilyDefaults",
    "FloatLengths",
    "LayerDraft",
    "Layers",
    "LoomPlan",
    "ThreadSystem",
    "Threads",
    "WifSource",
    "bind_floats",
    "binding_points",
    "derive_loom_plan",
    "draft_of_wefts",
    "draw_draft",
    "draw_drawdown",
    "draw_layer",
    "drawdown_from_picture",
    "figured_structure",
    "find_layers",
    "layer_draft",
    "layers_text",
    "load_draft",
    "longest_floats",
    "named_layer",
    "named_weave",
    "per_cm",
    "per_inch",
    "plain_draft",
    "plan_drawdown",
    "read_bitmap",
    "read_wif",
    "repeat_draft",
    "repeat_size_cm",
    "save_draft",
    "sett_per_cm",
    "split_wefts",
    "summary",
    "unbound_threads",
    "warp_cover",
    "weave_names",
    "with_loom_plan",
    "with_palette",
    "write_bitmaps",
    "write_dtx",
    "write_wif",
    "yarn_diameter_mm",
    "yarn_tex",
]
