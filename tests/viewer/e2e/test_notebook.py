"""The widget in JupyterLab in a real Chromium: the page and Python follow each other.

Covers: viewer/widget.js
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.limits import HANG
from tests.viewer.e2e.pages import ROOT, SWIFTSHADER, launched, visiting, wait_for_cloth, wait_until

CELLS = (
    "import loomlight\ncloth = loomlight.view('twill 3/1')\ncloth",
    "print('roughness', cloth.fabric.fields.warp.roughness)",
    "cloth.fabric = 'houndstooth'",
    "print('weave', cloth.fabric.fields.weave)",
)
TOKEN = "of-a-test"
FRAME = "iframe[title^=loomlight]"
# Runs a cell by its number, and is done when that is. A click on a notebook that is still being laid out may
# be lost, and a second run replaces the frame of the first.
RUN = """async (number) => {
  await jupyterapp.restored;
  const { content, context } = jupyterapp.shell.currentWidget;
  await context.ready;
  await context.sessionContext.ready;
  content.activeCellIndex = number;
  await jupyterapp.commands.execute("notebook:run-cell");
}"""


@pytest.fixture
def notebook(tmp_path: Path) -> Iterator[str]:
    """The address of a notebook of `CELLS` in JupyterLab, whose kernel is this Python."""
    for package in ("jupyterlab", "anywidget"):
        pytest.importorskip(package, reason=f"{package} is not installed")
    cell = {"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": None}
    cells = [{**cell, "id": f"cell-{number}", "source": source} for number, source in enumerate(CELLS)]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    content = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    (tmp_path / "cloth.ipynb").write_text(json.dumps(content))
    places = {f"JUPYTER_{name}_DIR": str(tmp_path / name) for name in ("CONFIG", "DATA", "RUNTIME")}
    options = {
        "IdentityProvider.token": TOKEN,
        "ServerApp.ip": "127.0.0.1",
        "ServerApp.port": 0,
        "ServerApp.root_dir": tmp_path,
        "ServerApp.allow_root": True,
        "LabApp.news_url": "",
        "LabApp.expose_app_in_browser": True,
        "LabApp.check_for_updates_class": "jupyterlab.NeverCheckForUpdate",
    }
    given = [f"--{name}={value}" for name, value in options.items()]
    with (tmp_path / "log").open("w") as log:
        server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", "--no-browser", *given],
            env={**os.environ, **places, "PYTHONPATH": f"{ROOT / 'src'}"},
            stdout=subprocess.DEVNULL,
            stderr=log,
        )
        try:
            yield _address(server, tmp_path / "log")
        finally:
            server.terminate()
            server.wait(HANG)


def _address(server: subprocess.Popen[bytes], log: Path) -> str:
    while True:
        found = re.search(r"http://127\.0\.0\.1:(\d+)/lab", log.read_text())
        if found:
            return f"http://127.0.0.1:{found[1]}/lab/tree/cloth.ipynb?token={TOKEN}"
        assert server.poll() is None, log.read_text()
        time.sleep(0.1)


def _answer_dialogs(page: Any) -> None:
    """Accepts what JupyterLab asks or tells of itself, such as a kernel started anew; a failure prints it."""

    def accept(dialog: Any) -> None:
        print(dialog.inner_text())
        dialog.locator(".jp-mod-accept").click()

    page.add_locator_handler(page.locator(".jp-Dialog"), accept)


def _require_printed(page: Any, number: int, expected: str) -> None:
    """A cell prints so, run anew until what was sent before has reached the kernel."""
    output = page.locator(".jp-CodeCell").nth(number).locator(".jp-OutputArea-output")
    end = time.monotonic() + HANG
    while time.monotonic() < end:
        page.evaluate(RUN, number)
        if output.count() and output.inner_text().strip() == expected:
            return
        page.wait_for_timeout(200)
    raise AssertionError(f"{output.inner_text()} is not {expected}")


@pytest.mark.slow
@pytest.mark.usefixtures("client")
def test_page_and_python_follow_each_other(notebook: str, playwright: Any) -> None:
    with launched(playwright, SWIFTSHADER) as browser, visiting(browser) as visit:
        page = visit.page
        _answer_dialogs(page)
        page.goto(notebook)
        page.locator(".jp-CodeCell").nth(3).wait_for()
        page.evaluate(RUN, 0)
        element = page.wait_for_selector(FRAME)
        frame = element.content_frame()
        wait_for_cloth(frame)
        assert frame.evaluate("window.loomlight.fabric().fields.weave") == "twill 3/1"
        # It lies in the notebook's frame and keeps nothing in the notebook's storage.
        assert frame.evaluate("Object.keys(localStorage).filter((key) => key.startsWith('loomlight'))") == []
        frame.get_by_test_id("tab-yarns").click()
        frame.get_by_test_id("field-both.roughness").press("End")
        _require_printed(page, 1, "roughness 1.0")
        page.evaluate(RUN, 2)
        wait_until(frame, "window.loomlight.fabric().fields.weave === 'houndstooth'")
        frame.get_by_test_id("undo").click()
        _require_printed(page, 3, "weave twill 3/1")
        if frame.evaluate("async () => (await navigator.gpu?.requestAdapter()) != null"):
            wait_until(frame, "window.loomlight.statistics().passes > 0")  # lit
