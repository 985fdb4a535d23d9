"""Pictures of the editor's page: `python -m tools.generate.editor_picture FILE.png [--artwork]`.

Chromium draws the page in software, and Python the cloth, as where a user has no graphics card. With
`--artwork` it is an artwork and its weaves, shown flat, as where a browser has no WebGPU.
"""

from __future__ import annotations

from argparse import ArgumentParser
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import sync_playwright

from loomlight.viewer.app import Access
from loomlight.viewer.client import client_folder
from studies.instruments.browser import SWIFTSHADER, launched, serving, wait_until

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
_SECONDS = 300


@dataclass(frozen=True)
class Shown:
    """What a picture shows.

    Attributes:
        fabric: among the examples.
        tab: the panel beside the cloth.
        size: of the page, pixels.
        options: of Chromium.
    """

    fabric: str
    tab: str
    size: tuple[int, int]
    options: tuple[str, ...]


DENIM = Shown("denim.toml", "draft", (1200, 760), SWIFTSHADER)
ARTWORK = Shown("artwork/peonies.toml", "weave", (1200, 760), ())


def make(output: Path, shown: Shown) -> None:
    """Writes the picture: cloth, and a panel beside it.

    Raises:
        RuntimeError: Chromium is not installed.
    """
    access = Access.for_host("127.0.0.1")
    with (
        serving(client_folder(), access, str(EXAMPLES / shown.fabric)) as port,
        sync_playwright() as playwright,
        launched(playwright, shown.options) as browser,
    ):
        width, height = shown.size
        page = browser.new_context(viewport={"width": width, "height": height}).new_page()
        page.set_default_timeout(1000 * _SECONDS)
        page.goto(f"http://127.0.0.1:{port}/")
        page.get_by_test_id(f"tab-{shown.tab}").click()
        if shown.options:
            page.get_by_text("rendered by the server").wait_for()
        else:
            wait_until(page, "window.loomlight?.statistics()?.frames > 0", _SECONDS)
        page.screenshot(path=output)


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path)
    parser.add_argument("--artwork", action="store_true")
    given = parser.parse_args()
    make(given.output, ARTWORK if given.artwork else DENIM)
