"""The picture of the editor's page, lit: `python -m tools.generate.editor_picture FILE.png`.

Chromium draws the page in software, and Python the cloth, as where a user has no graphics card.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

from tools.chromium import QUIET, SWIFTSHADER, chromium

FABRIC = "denim.toml"
SIZE = (1200, 760)
_SECONDS = 300


def make(output: Path) -> None:
    """Writes the picture: denim draped, its draft beside it.

    Raises:
        RuntimeError: Chromium is not installed.
    """
    program = chromium()
    if program is None:
        raise RuntimeError("Chromium is not installed: apt-get install chromium")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    fabric = Path(__file__).resolve().parents[2] / "examples" / FABRIC
    command = [sys.executable, "-m", "loomlight", "view", str(fabric), "--port", str(port), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server, sync_playwright() as started:
        try:
            assert server.stdout is not None
            address = next(word for line in server.stdout for word in line.split() if "http://" in word)
            browser = started.chromium.launch(
                executable_path=program, args=[*QUIET, *SWIFTSHADER], env=dict(os.environ)
            )
            page = browser.new_context(viewport={"width": SIZE[0], "height": SIZE[1]}).new_page()
            page.set_default_timeout(1000 * _SECONDS)
            page.goto(address)
            page.get_by_test_id("tab-draft").click()
            page.get_by_text("rendered by the server").wait_for()
            page.screenshot(path=output)
            browser.close()
        finally:
            server.terminate()


if __name__ == "__main__":
    make(Path(sys.argv[1]))
