"""A real Chromium draws lit cloth as the Python host does: in software, by the smallest shader."""

from __future__ import annotations

import base64
import shutil
import subprocess
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.device import default_adapter
from loomlight.viewer.saving import tables_of
from tests.viewer.e2e.conftest import ROOT, SWIFTSHADER, launched, visiting, wait_until

SIZE = 64
FABRIC = 'weave = "twill 3/1"\nends_per_cm = 24\npicks_per_cm = 18\nwarp.color = "#20305c"\n'
PAGE = """<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">
<script type="module">window.web = await import("./module/loomlight-web.js");</script>"""
# Base64 of the linear picture.
DRAW = """async ({ fabric, size }) => {
  const renderer = await web.ClothRenderer.create({ size: [size, size], budget: null });
  renderer.setPieces([{ mesh: web.rectangle(0.02, 0.02), ...web.fabricOf(fabric), uvSizeMm: [20, 20] }]);
  renderer.setTables("neural", new Uint8Array(await (await fetch("neural.tables")).arrayBuffer()));
  renderer.setLights([{ kind: "directional", towards: [0.5, 0.3, 0.8] }]);
  renderer.setCamera({ origin: [0, -0.01, 0.03], target: [0, 0, 0] });
  await renderer.render(1);
  const { data } = await renderer.readLinear();
  return btoa(Array.from(new Uint8Array(data.buffer), (byte) => String.fromCharCode(byte)).join(""));
}"""


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    """A plain web server of the built module, a page and the tables of a fabric."""
    npx = shutil.which("npx")
    if npx is None or not (ROOT / "web" / "node_modules").is_dir():
        pytest.skip("needs Node, and `npm install` in web/: scripts/setup.sh does both")
    build = [npx, "vite", "build", "--config", "loomlight-web/vite.config.ts", "--logLevel", "error"]
    subprocess.run([*build, "--outDir", str(tmp_path / "module")], cwd=ROOT / "web", check=True, timeout=120)
    (tmp_path / "index.html").write_text(PAGE)
    (tmp_path / "neural.tables").write_bytes(tables_of(fabric_from_text(FABRIC), "neural"))
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(tmp_path)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()


@pytest.mark.slow
def test_chromium_draws_what_the_python_host_draws(address: str, playwright: Any) -> None:
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.skip(str(error))
    with launched(playwright, SWIFTSHADER) as browser, visiting(browser) as visit:
        visit.page.goto(address)
        wait_until(visit.page, "window.web !== undefined")
        if not visit.page.evaluate("async () => (await navigator.gpu?.requestAdapter()) != null"):
            pytest.skip("this Chromium has no WebGPU in software")
        drawn = base64.b64decode(visit.page.evaluate(DRAW, {"fabric": FABRIC, "size": SIZE}))
        assert visit.complaints == []
    theirs = np.frombuffer(drawn, np.float32).reshape(SIZE, SIZE, 4)
    cloth = Cloth(rectangle(0.02, 0.02), fabric_from_text(FABRIC), (20.0, 20.0))
    light = DirectionalLight((0.5, 0.3, 0.8))
    ours = Renderer([cloth], (SIZE, SIZE), "neural").render(Camera((0, -0.01, 0.03)), [light]).linear
    # Other compilers join products and sums in other ways: the bar of shaders' parity.
    np.testing.assert_allclose(theirs, ours, rtol=1e-3, atol=1e-5)
    assert theirs[..., :3].std() > 0.05
