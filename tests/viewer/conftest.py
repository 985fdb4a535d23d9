"""A page of two files, and the editor's application with it behind a real server in a thread."""

from __future__ import annotations

import http.client
from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from loomlight.viewer.app import Access
from loomlight.viewer.limited_reader import MEMORY_BYTES, DraftReader
from studies.instruments import browser
from tests.limits import HANG


@dataclass(frozen=True)
class Served:
    """Where a server listens."""

    port: int

    def ask(
        self, method: str, place: str, body: bytes | None = None, headers: Mapping[str, str] | None = None
    ) -> tuple[int, dict[str, str], bytes]:
        """Status, headers by lower-case name, and body of an answer; the place is sent as it is."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=HANG)
        try:
            connection.request(method, place, body, dict(headers or {}))
            response = connection.getresponse()
            return (
                response.status,
                {name.lower(): value for name, value in response.getheaders()},
                response.read(),
            )
        finally:
            connection.close()


@pytest.fixture(scope="session")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a page, in a folder with a file that nobody may read."""
    folder = tmp_path_factory.mktemp("client") / "static"
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text('<meta name="loomlight-session" content="api/session" /><p>page</p>')
    (folder / "assets" / "page.js").write_text("export {};")
    (folder.parent / "secret.txt").write_text("secret")
    (folder / "link.txt").symlink_to(folder.parent / "secret.txt")
    return folder


def serving(page: Path, access: Access) -> Generator[Served, None, None]:
    """Serves until the generator is closed."""
    with browser.serving(page, access) as port:
        yield Served(port)


@pytest.fixture(scope="module")
def local(page: Path) -> Iterator[Served]:
    """A server on loopback."""
    yield from serving(page, Access.for_host("127.0.0.1"))


@pytest.fixture(scope="module")
def shared(page: Path) -> Iterator[Served]:
    """A server that asks for the token "token"."""
    yield from serving(page, Access(loopback=False, token="token"))


@pytest.fixture(scope="session", autouse=True)
def all_the_time() -> Iterator[None]:
    """What the server gives up after seconds may take as long as a busy machine needs."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(DraftReader.__init__, "__defaults__", (float(HANG), MEMORY_BYTES))
        patch.setattr("loomlight.viewer.app._DRAIN_SECONDS", float(HANG))
        yield
