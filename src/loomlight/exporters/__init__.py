"""Export of fabrics to engines and other programs: shader code, networks, textures."""

from __future__ import annotations

from loomlight.exporters.exporter import TARGETS, export

__all__ = ["TARGETS", "export"]
