"""A real Chromium, the built page and a server; tests that need them are left out where one is missing."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from loomlight.core.errors import LoomlightError
from loomlight.viewer.app import Access
from loomlight.viewer.client import client_folder
from studies.instruments.browser import SWIFTSHADER, chromium
from studies.instruments.browser import launched as start_chromium
from studies.instruments.browser import wait_until as wait_for
from tests.limits import HANG
from tests.viewer.conftest import Served, serving

__all__ = ["SWIFTSHADER"]
ROOT = Path(__file__).resolve().parents[3]
AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
# Console messages of Chromium about this machine, not about the page.
# Answers once what a page does after it is painted is done, its own clock or one of a test.
_SETTLED = """{ const [frame, later] = [requestAnimationFrame, setTimeout];
  window.settled = () => new Promise((resolve) => frame(() => later(() => later(resolve)))); }"""
_ACTIONS = ("check", "click", "fill", "press", "select_option", "set_checked", "set_input_files", "tap")
_OF_THE_MACHINE = ("No available adapters", "GPU stall due to ReadPixels", "experimental on this platform")


@dataclass
class Visit:
    """A tab of the browser, and what its page asked for and complained about."""

    page: Any
    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)

    def outside(self, address: str) -> list[str]:
        """Requests that went elsewhere than to the page's own server."""
        return [url for url in self.requests if not url.startswith((address, "data:", "blob:", "about:"))]


@pytest.fixture(scope="session")
def client() -> Path:
    """The folder of the built page, built now where its sources are newer."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return client_folder()
    except (LoomlightError, Warning) as error:
        pytest.skip(str(error))


@pytest.fixture(scope="session")
def playwright() -> Iterator[Any]:
    """Drives browsers; a process has one."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    with sync_api.sync_playwright() as started:
        yield started


@pytest.fixture(scope="session", autouse=True)
def settled_actions() -> Iterator[None]:
    """An action on a part of a page has had its effects when it returns: a busy machine paints later."""
    try:
        from playwright.sync_api import Error, Locator
    except ImportError:
        yield
        return

    def settling(act: Callable[..., Any]) -> Callable[..., Any]:
        def act_and_settle(locator: Any, *arguments: Any, **options: Any) -> Any:
            done = act(locator, *arguments, **options)
            with suppress(Error):  # of a page that goes elsewhere
                locator.page.evaluate("window.settled?.()")
            return done

        return act_and_settle

    with pytest.MonkeyPatch.context() as patch:
        for name in _ACTIONS:
            patch.setattr(Locator, name, settling(getattr(Locator, name)))
        yield


@pytest.fixture(scope="session")
def browser(client: Path, playwright: Any) -> Iterator[Any]:
    """Chromium without a graphics device: what a page does by itself."""
    with launched(playwright, ()) as started:
        yield started


@contextmanager
def launched(playwright: Any, options: tuple[str, ...]) -> Iterator[Any]:
    """Chromium with further options; skips the test where it is missing."""
    if chromium() is None:
        pytest.skip("chromium is not installed: apt-get install chromium")
    with start_chromium(playwright, options) as started:
        yield started


@pytest.fixture(scope="session")
def served(client: Path) -> Iterator[Served]:
    """The editor behind a server on loopback, opened for a twill."""
    yield from serving(client, Access.for_host("127.0.0.1"))


@pytest.fixture
def visit(browser: Any) -> Iterator[Visit]:
    """A tab with a profile of its own."""
    with visiting(browser) as one:
        yield one


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


def address_of(page: Any) -> str:
    """The part of the page's address after "#", once it carries the fabric as it is now."""
    wait_until(page, "window.loomlight.isAddressed()")
    found: str = page.evaluate("location.hash")
    return found
