"""The editor's page in a real Chromium, without a graphics device: everything but the picture."""

from __future__ import annotations

import functools
import gzip
import http.server
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from loomlight.viewer.app import Access
from loomlight.viewer.client import export_site
from tests.viewer.conftest import Served, serving
from tests.viewer.e2e.pages import AXE, Visit, wait_for_cloth, wait_until

FIXTURES = Path(__file__).parents[2] / "cases" / "drafts"
# Of everything that the page may load, compressed as web servers do; and of what is not three.js's, which
# reads meshes and pictures of the user's own.
MAX_BUNDLE = 3 << 20
# Mostly shaders: with layers and the rise of highlights they make it 359 kB.
MAX_OWN = 380_000


def test_bundle_is_small(client: Path) -> None:
    size = sum(len(gzip.compress(file.read_bytes(), 6)) for file in client.rglob("*") if file.is_file())
    assert size < MAX_BUNDLE
    # `widget.html` is all of it again, for notebooks.
    own = [file for file in client.rglob("*.*") if file.suffix in (".js", ".css", ".html")]
    own = [file for file in own if file.name != "widget.html"]
    own = [file for file in own if "Loader" not in file.name and not file.name.startswith("three")]
    assert sum(len(gzip.compress(file.read_bytes(), 6)) for file in own) < MAX_OWN


def test_loads_without_a_request_outside_and_without_complaint(served: Served, visit: Visit) -> None:
    address = f"http://127.0.0.1:{served.port}/"
    visit.page.goto(address)
    visit.page.wait_for_load_state("networkidle")
    assert visit.outside(address) == []
    assert visit.complaints == []
    assert any(url.endswith("/api/session") for url in visit.requests)


@pytest.fixture
def plain_server(tmp_path: Path, client: Path) -> Iterator[str]:
    """A static export behind the plainest of web servers, in a folder of it."""
    export_site(tmp_path / "cloth", "satin 5/2")
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(tmp_path))
    handler.log_message = lambda *_: None  # type: ignore[attr-defined]
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_address[1]}/cloth/"
    server.shutdown()
    server.server_close()
    thread.join()


@pytest.mark.slow
def test_static_folder_needs_no_python(plain_server: str, visit: Visit) -> None:
    visit.page.goto(plain_server)
    visit.page.wait_for_load_state("networkidle")
    assert visit.outside(plain_server) == []
    assert not any("/api/" in url for url in visit.requests)
    visit.page.get_by_test_id("files").set_input_files(FIXTURES / "sinking-liftplan.wif")
    wait_until(visit.page, "window.loomlight.fabric().fields.draft === 'sinking-liftplan.wif'")
    visit.page.get_by_test_id("tab-finish").click()
    assert visit.page.get_by_test_id("between-yarns-on").is_enabled()
    visit.page.get_by_test_id("save").click()
    visit.page.get_by_test_id("save-export").click()
    assert not visit.page.get_by_test_id("export-start").is_disabled()  # a picture, by the page itself
    # What is being typed stays when the page draws itself anew, which it does whenever it likes.
    width = visit.page.get_by_test_id("export-width")
    width.fill("90")
    visit.page.evaluate("document.querySelector('[data-testid=export-transparent]').click()")
    visit.page.evaluate("window.settled()")
    assert width.input_value() == "90"
    width.press("Tab")
    visit.page.evaluate("window.settled()")
    assert width.input_value() == "90"
    for kind in ("maps", "gltf", "loom"):
        visit.page.get_by_test_id(f"export-kind-{kind}").click()
        assert "loomlight view" in visit.page.get_by_test_id("export-needs-python").inner_text()
        assert visit.page.get_by_test_id("export-start").is_disabled()
    assert visit.complaints == []


@pytest.mark.slow
def test_address_names_a_fabric_of_the_gallery_and_a_frame_shows_the_cloth_alone(
    served: Served, visit: Visit
) -> None:
    visit.page.goto(f"http://127.0.0.1:{served.port}/?fabric=denim&embed=1")
    wait_until(visit.page, "window.loomlight?.fabric().fields.name === 'Denim'")
    assert not visit.page.get_by_test_id("tab-weave").is_visible()
    assert visit.page.evaluate("[localStorage.length, sessionStorage.length]") == [0, 0]
    assert visit.complaints == []


@pytest.mark.slow
def test_edits_go_on_without_the_server_and_nothing_is_lost(client: Path, visit: Visit) -> None:
    running = serving(client, Access.for_host("127.0.0.1"))
    visit.page.goto(f"http://127.0.0.1:{next(running).port}/")
    wait_for_cloth(visit.page)
    running.close()  # as when the terminal is closed
    visit.page.get_by_test_id("tab-yarns").click()
    visit.page.get_by_test_id("field-both.roughness").press("End")
    visit.page.get_by_test_id("save").click()
    visit.page.get_by_test_id("save-export").click()
    visit.page.get_by_test_id("export-kind-loom").click()
    visit.page.get_by_test_id("export-start").click()
    assert "does not answer" in visit.page.get_by_test_id("export-fault").inner_text()
    assert visit.page.evaluate("window.loomlight.fabric().fields.warp.roughness") == 1


@pytest.mark.slow
@pytest.mark.skipif(not AXE.is_file(), reason="axe-core is not installed: npm install in web/")
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_is_accessible(served: Served, visit: Visit, scheme: str) -> None:
    visit.page.emulate_media(color_scheme=scheme)
    visit.page.goto(f"http://127.0.0.1:{served.port}/")
    visit.page.wait_for_load_state("networkidle")
    # The page's content policy lets no script in; the debugger's evaluation is not bound by it.
    visit.page.evaluate(AXE.read_text(encoding="utf-8"))
    found = visit.page.evaluate("axe.run()")
    assert [
        (fault["id"], [node["html"][:120] for node in fault["nodes"]]) for fault in found["violations"]
    ] == []
