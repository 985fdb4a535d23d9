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
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from tests.viewer.e2e.conftest import ROOT, SWIFTSHADER, launched, visiting, wait_until

CELLS = (
    "import loomlight\ncloth = loomlight.view('twill 3/1')\ncloth",
    "print('roughness', cloth.fabric.fields.warp.roughness)",
    "cloth.fabric = 'houndstooth'",
    "print('weave', cloth.fabric.fields.weave)",
)
TOKEN = "of-a-test"
# Seconds that a step may take where other tests keep the processors busy; alone the whole test takes 36.
LONG = 180
FRAME = "iframe[title^=loomlight]"


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
            server.wait(20)


def _address(server: subprocess.Popen[bytes], log: Path) -> str:
    for _ in range(600):
        found = re.search(r"http://127\.0\.0\.1:(\d+)/lab", log.read_text())
        if found:
            return f"http://127.0.0.1:{found[1]}/lab/tree/cloth.ipynb?token={TOKEN}"
        assert server.poll() is None, log.read_text()
        time.sleep(0.1)
    raise AssertionError(log.read_text())


def _answer_dialogs(page: Any) -> None:
    """Accepts what JupyterLab asks or tells of itself, such as a kernel started anew; a failure prints it."""

    def accept(dialog: Any) -> None:
        print(dialog.inner_text())
        dialog.locator(".jp-mod-accept").click()

    page.add_locator_handler(page.locator(".jp-Dialog"), accept)


def _run(page: Any, number: int) -> None:
    page.locator(".jp-CodeCell").nth(number).locator(".cm-content").click()
    page.keyboard.press("Control+Enter")


def _require_printed(page: Any, number: int, expected: str) -> None:
    """A cell prints so, run anew until what was sent before has reached the kernel."""
    output = page.locator(".jp-CodeCell").nth(number).locator(".jp-OutputArea-output")
    for _ in range(20):
        _run(page, number)
        page.wait_for_timeout(1000)
        if output.count() and output.inner_text().strip() == expected:
            return
    raise AssertionError(f"{output.inner_text()} is not {expected}")


@pytest.mark.usefixtures("client")
def test_page_and_python_follow_each_other(notebook: str, playwright: Any) -> None:
    with launched(playwright, SWIFTSHADER) as browser, visiting(browser) as visit:
        page = visit.page
        _answer_dialogs(page)
        page.goto(notebook)
        page.locator(".jp-CodeCell").nth(3).wait_for(timeout=1000 * LONG)
        page.locator("[data-status=idle]").first.wait_for(state="attached", timeout=1000 * LONG)
        # A notebook that is still being laid out may lose a click.
        for _ in range(6):
            _run(page, 0)
            with suppress(AssertionError):
                wait_until(page, f"document.querySelector('{FRAME}') !== null", LONG / 6)
                break
        element = page.wait_for_selector(FRAME)
        frame = element.content_frame()
        wait_until(frame, "window.loomlight?.statistics()?.frames > 0", LONG)
        assert frame.evaluate("window.loomlight.fabric().fields.weave") == "twill 3/1"
        # It lies in the notebook's frame and keeps nothing in the notebook's storage.
        assert frame.evaluate("Object.keys(localStorage).filter((key) => key.startsWith('loomlight'))") == []
        frame.get_by_test_id("tab-yarns").click()
        frame.get_by_test_id("field-both.roughness").press("End")
        _require_printed(page, 1, "roughness 1.0")
        _run(page, 2)
        wait_until(frame, "window.loomlight.fabric().fields.weave === 'houndstooth'", LONG)
        frame.get_by_test_id("undo").click()
        _require_printed(page, 3, "weave twill 3/1")
        if frame.evaluate("async () => (await navigator.gpu?.requestAdapter()) != null"):
            wait_until(frame, "window.loomlight.statistics().passes > 0", LONG)  # lit
