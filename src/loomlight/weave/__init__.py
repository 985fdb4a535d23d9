"""Drafts: named weaves, weaving information files, pictures of drawdowns; drawing and textile units."""

from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan, Threads
from loomlight.weave.loom import derive_loom_plan, plan_drawdown, with_loom_plan
from loomlight.weave.named import named_weave, weave_names
from loomlight.weave.palette import with_palette
from loomlight.weave.wif_reader import read_wif
from loomlight.weave.wif_source import FamilyDefaults, WifSource
from loomlight.weave.wif_writer import write_wif

__all__ = [
    "MAXIMUM_THREADS",
    "Draft",
    "FamilyDefaults",
    "LoomPlan",
    "Threads",
    "WifSource",
    "derive_loom_plan",
    "named_weave",
    "plan_drawdown",
    "read_wif",
    "weave_names",
    "with_loom_plan",
    "with_palette",
    "write_wif",
]
