"""Drafts: named weaves, weaving information files, pictures of drawdowns; drawing and textile units."""

from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan, Threads
from loomlight.weave.named import named_weave, weave_names
from loomlight.weave.palette import with_palette

__all__ = [
    "MAXIMUM_THREADS",
    "Draft",
    "LoomPlan",
    "Threads",
    "named_weave",
    "weave_names",
    "with_palette",
]
