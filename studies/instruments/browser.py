"""Chromium, and the editor's server in a thread: for studies, tests and pictures of the page."""

from __future__ import annotations

import os
import shutil
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import uvicorn
from playwright.sync_api import Error

from loomlight.viewer.app import Access, editor_app

# A fresh profile that asks nothing of the network.
QUIET = (
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
# WebGPU in software; a canvas needs all of them.
SWIFTSHADER = (
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
)
_LOADING = ("Execution context was destroyed", "Cannot find context", "Frame is not ready")


def chromium() -> str | None:
    """The program, or None where it is not installed."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@contextmanager
def launched(playwright: Any, options: tuple[str, ...]) -> Iterator[Any]:
    """Chromium with further options, as Playwright drives it.

    Raises:
        RuntimeError: it is not installed.
    """
    program = chromium()
    if program is None:
        raise RuntimeError("chromium is not installed: apt-get install chromium")
    started = playwright.chromium.launch(
        executable_path=program, args=[*QUIET, *options], env=dict(os.environ)
    )
    try:
        yield started
    finally:
        started.close()


def wait_until(page: Any, condition: str, seconds: float) -> None:
    """Waits for a condition in the page; its content policy forbids Playwright's own way.

    Raises:
        AssertionError: it has not come true after so many seconds.
    """
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            if page.evaluate(condition):
                return
        except Error as error:
            # What is being loaded, once or once more, answers when it is there.
            if not any(part in error.message for part in _LOADING):
                raise
        page.wait_for_timeout(20)
    raise AssertionError(f"{condition} did not become true")


@contextmanager
def serving(page: Path, access: Access, fabric: str = "twill 3/1") -> Iterator[int]:
    """The editor's server in a thread, opened for a fabric; yields its port on loopback."""
    config = uvicorn.Config(editor_app(page, fabric, access), host="127.0.0.1", port=0, log_level="critical")
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    while not server.started:
        assert thread.is_alive()
        time.sleep(0.01)
    try:
        yield server.servers[0].sockets[0].getsockname()[1]
    finally:
        server.should_exit = True
        thread.join()
