"""The papers' figures and tables, made again with what is here: `loomlight reproduce`."""

from __future__ import annotations

from loomlight.evaluation.reproduce.catalogue import CATALOGUE, find_item
from loomlight.evaluation.reproduce.reproduce import reproduce
from loomlight.evaluation.reproduce.setting import Setting

__all__ = ["CATALOGUE", "Setting", "find_item", "reproduce"]
