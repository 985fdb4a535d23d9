"""The picture of the editor's page, lit: `python -m tools.generate.editor_picture FILE.png`.

Chromium draws the page in software, and Python the cloth, as where a user has no graphics card.
"""

from __future__ import annotations

import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

from loomlight.viewer.app import Access
from loomlight.viewer.client import client_folder
from studies.instruments.browser import SWIFTSHADER, launched, serving

FABRIC = Path(__file__).resolve().parents[2] / "examples" / "denim.toml"
SIZE = (1200, 760)
_SECONDS = 300


def make(output: Path) -> None:
    """Writes the picture: denim draped, its draft beside it.

    Raises:
        RuntimeError: Chromium is not installed.
    """
    access = Access.for_host("127.0.0.1")
    with (
        serving(client_folder(), access, str(FABRIC)) as port,
        sync_playwright() as playwright,
        launched(playwright, SWIFTSHADER) as browser,
    ):
        page = browser.new_context(viewport={"width": SIZE[0], "height": SIZE[1]}).new_page()
        page.set_default_timeout(1000 * _SECONDS)
        page.goto(f"http://127.0.0.1:{port}/")
        page.get_by_test_id("tab-draft").click()
        page.get_by_text("rendered by the server").wait_for()
        page.screenshot(path=output)


if __name__ == "__main__":
    make(Path(sys.argv[1]))
