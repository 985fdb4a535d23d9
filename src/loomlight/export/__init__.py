"""Export of fabrics to engines and other programs: shader code, networks, textures."""

from __future__ import annotations

from loomlight.export.exporter import TARGETS, export

__all__ = ["TARGETS", "export"]
