"""A real Chromium, the built page and a server; tests that need them are left out where one is missing."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from loomlight.core.errors import LoomlightError
from loomlight.viewer.app import Access
from loomlight.viewer.client import client_folder
from tests.viewer.conftest import Served, serving
from tests.viewer.e2e.pages import Visit, by_id, launched, open_editor, visiting

_ACTIONS = ("check", "click", "fill", "press", "select_option", "set_checked", "set_input_files", "tap")


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


@pytest.fixture(scope="session")
def served(client: Path) -> Iterator[Served]:
    """The editor behind a server on loopback, opened for a twill."""
    yield from serving(client, Access.for_host("127.0.0.1"))


@pytest.fixture
def visit(browser: Any) -> Iterator[Visit]:
    """A tab with a profile of its own."""
    with visiting(browser) as one:
        yield one


@pytest.fixture(scope="module")
def opened(served: Served, browser: Any) -> Iterator[Visit]:
    """One page for all tests of a module: to load it takes longer than a test."""
    with visiting(browser) as visit:
        open_editor(served, visit)
        yield visit


@pytest.fixture
def editor(opened: Visit) -> Iterator[Any]:
    """The page as it opens, a twill without notices, in any panel. Whatever a test makes is undone."""
    page = opened.page
    yield page
    while by_id(page, "undo").is_enabled():
        by_id(page, "undo").click()
    for button in page.get_by_label("Dismiss").all():
        button.click()
    assert opened.complaints == []
