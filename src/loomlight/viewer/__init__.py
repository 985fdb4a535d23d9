"""The live editor: a page in the browser, the server behind it, and static folders that need none."""

from __future__ import annotations

from loomlight.viewer.server import serve
from loomlight.viewer.site import export_site

__all__ = ["export_site", "serve"]
