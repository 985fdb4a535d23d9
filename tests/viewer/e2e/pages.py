"""The editor's page as tests see it: tabs of a browser, parts of the page, its fabric, pixels and exports."""

from __future__ import annotations

import io
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from studies.instruments.browser import SWIFTSHADER, chromium
from studies.instruments.browser import launched as start_chromium
from studies.instruments.browser import wait_until as wait_for
from tests.limits import HANG
from tests.viewer.conftest import Served

__all__ = ["SWIFTSHADER"]
ROOT = Path(__file__).resolve().parents[3]
AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
# Windows, [width, height] pixels.
SIZES = {"desk": (1440, 900), "small": (1024, 768), "phone": (390, 844)}
# Answers once what a page does after it is painted is done, its own clock or one of a test.
_SETTLED = """{ const [frame, later] = [requestAnimationFrame, setTimeout];
  window.settled = () => new Promise((resolve) => frame(() => later(() => later(resolve)))); }"""
# Console messages of Chromium about this machine, not about the page.
_OF_THE_MACHINE = ("No available adapters", "GPU stall due to ReadPixels", "experimental on this platform")

# Notes whether progress was ever shown, even if it was gone before a test could look.
_WATCH = """() => {
  window.progressWasShown = false;
  new MutationObserver(() => {
    window.progressWasShown ||= document.querySelector("[data-testid=export-progress]") !== null;
  }).observe(document.body, { childList: true, subtree: true });
}"""


@dataclass
class Visit:
    """A tab of the browser, and what its page asked for and complained about."""

    page: Any
    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)

    def outside(self, address: str) -> list[str]:
        """Requests that went elsewhere than to the page's own server."""
        return [url for url in self.requests if not url.startswith((address, "data:", "blob:", "about:"))]


@contextmanager
def launched(playwright: Any, options: tuple[str, ...]) -> Iterator[Any]:
    """Chromium with further options; skips the test where it is missing."""
    if chromium() is None:
        pytest.skip("chromium is not installed: apt-get install chromium")
    with start_chromium(playwright, options) as started:
        yield started


@contextmanager
def visiting(browser: Any, **options: Any) -> Iterator[Visit]:
    """A tab with a profile of its own; its requests and complaints are written down."""
    context = browser.new_context(viewport={"width": 1280, "height": 800}, **options)
    one = Visit(context.new_page())
    one.page.add_init_script(_SETTLED)
    one.page.set_default_timeout(1000 * HANG)
    one.page.on("request", lambda request: one.requests.append(request.url))
    one.page.on("pageerror", lambda error: one.complaints.append(str(error)))

    def note(message: Any) -> None:
        if message.type in ("error", "warning") and not any(part in message.text for part in _OF_THE_MACHINE):
            one.complaints.append(message.text)

    one.page.on("console", note)
    try:
        yield one
    finally:
        context.close()


def wait_until(page: Any, condition: str) -> None:
    """Waits for a condition in the page, as long as a busy machine needs."""
    wait_for(page, condition, HANG)


def wait_for_cloth(page: Any) -> None:
    """Waits until the page shows its first frame."""
    wait_until(page, "window.loomlight?.statistics()?.frames > 0")


def open_editor(served: Served, visit: Visit, after: str = "") -> None:
    """Opens the editor at what stands after the server's address, until the cloth is shown."""
    visit.page.goto(f"http://127.0.0.1:{served.port}/{after}")
    wait_for_cloth(visit.page)


def address_of(page: Any) -> str:
    """The part of the page's address after "#", once it carries the fabric as it is now."""
    wait_until(page, "window.loomlight.isAddressed()")
    found: str = page.evaluate("location.hash")
    return found


def by_id(page: Any, name: str) -> Any:
    """The part of the page of this `data-testid`."""
    return page.get_by_test_id(name)


def fabric_of(page: Any) -> dict[str, Any]:
    """The fabric that the page holds, as it sends it."""
    found: dict[str, Any] = page.evaluate("window.loomlight.fabric()")
    return found


def pixels_of(page: Any) -> list[int]:
    """Red, green and blue of every hundredth pixel that is shown."""
    picked = "window.loomlight.readPixels().then(({data}) => data.filter((_, at) => at % 400 < 3))"
    found: list[int] = page.evaluate(picked)
    return found


def pixels_other_than(page: Any, before: list[int]) -> list[int]:
    """The pixels, once they are others than before."""
    end = time.monotonic() + HANG
    while time.monotonic() < end:
        now = pixels_of(page)
        if now != before:
            return now
        page.wait_for_timeout(20)
    raise AssertionError("the picture stays as it was")


def exported(page: Any, kind: str, **given: str | bool) -> Path:
    """The file that the dialogue makes of one kind, with what is filled in by name."""
    if not by_id(page, "export").is_visible():
        by_id(page, "save").click()
        by_id(page, "save-export").click()
    by_id(page, f"export-kind-{kind}").click()
    for name, value in given.items():
        field = by_id(page, f"export-{name}")
        if isinstance(value, bool):
            field.set_checked(value)
        elif name == "model":
            field.select_option(value)
        else:
            field.fill(value)
            field.press("Tab")
    page.evaluate(_WATCH)
    with page.expect_download() as downloaded:
        by_id(page, "export-start").click()
    if kind == "gltf":  # the others may be there at once
        assert page.evaluate("window.progressWasShown")
    by_id(page, "export-done").wait_for()
    assert downloaded.value.suggested_filename in by_id(page, "export-done").inner_text()
    return Path(downloaded.value.path())


def picture_of(content: Path | bytes) -> NDArray[np.uint8]:
    """Pixels of a picture, [height, width, channels]."""
    return np.asarray(Image.open(io.BytesIO(content) if isinstance(content, bytes) else content))
