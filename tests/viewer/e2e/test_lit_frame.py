"""A real Chromium without a graphics device draws lit cloth as the Python host does, by every model."""

from __future__ import annotations

import base64
import shutil
import subprocess
import threading
import time
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import MissingDependencyError
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.device import default_adapter
from loomlight.viewer.answers import tables_of
from loomlight.viewer.messages import openness_json
from tests.limits import HANG
from tests.viewer.conftest import Served
from tests.viewer.e2e.pages import ROOT, SWIFTSHADER, exported, launched, picture_of, visiting, wait_until

SIZE = 64
FABRIC = 'weave = "twill 3/1"\nends_per_cm = 24\npicks_per_cm = 18\nwarp.color = "#20305c"\n'
LAYERS = ROOT / "examples" / "layered" / "pattern-double-weave.wif"
PAGE = """<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">
<script type="module">window.web = await import("./module/loomlight-web.js");</script>"""
# The renderer of a model on a canvas that lets through what lies behind it, and seconds until it could draw.
PREPARE = """async ({ fabric, openness, size, model }) => {
  window.prepared ??= {};
  if (window.prepared[model] !== undefined) return window.prepared[model].seconds;
  const begin = performance.now();
  const canvas = Object.assign(document.createElement("canvas"), { width: size, height: size });
  const renderer = await web.ClothRenderer.create({ canvas, transparent: true, budget: null });
  const piece = { ...web.fabricOf(fabric), openness, uvSizeMm: [20, 20] };
  renderer.setPieces([{ mesh: web.rectangle(0.02, 0.02), ...piece }]);
  if (model === "neural" || model === "clustered")
    renderer.setTables(model, new Uint8Array(await (await fetch(`${model}.tables`)).arrayBuffer()));
  else renderer.setModel(model);
  renderer.setLights([{ kind: "directional", towards: [0.5, 0.3, 0.8] }]);
  await renderer.ready();
  const seconds = (performance.now() - begin) / 1000;
  window.prepared[model] = { renderer, canvas, seconds };
  return seconds;
}"""
# Base64 of the linear picture.
DRAW = """async (model) => {
  const { renderer } = window.prepared[model];
  renderer.setCamera({ origin: [0, -0.01, 0.03], target: [0, 0, 0] });
  await renderer.render(1);
  const { data } = await renderer.readLinear();
  return btoa(Array.from(new Uint8Array(data.buffer), (byte) => String.fromCharCode(byte)).join(""));
}"""
# Pixels of the cloth from afar on a background, and what a page of the colour `behind` shows of the canvas.
SHOW = """async ({ model, background, behind }) => {
  const { renderer, canvas } = window.prepared[model];
  renderer.setCamera({ origin: [0, -0.03, 0.09], target: [0, 0, 0] });
  renderer.setBackground(background);
  const page = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  page.fillStyle = behind;
  page.fillRect(0, 0, canvas.width, canvas.height);
  await renderer.render(1);
  page.drawImage(canvas, 0, 0);
  renderer.setBackground(null);
  const { data } = await renderer.readPixels();
  const shown = page.getImageData(0, 0, canvas.width, canvas.height).data;
  return { read: Array.from(data), shown: Array.from(shown) };
}"""
# Linear pictures of an open cloth: alone, with a sheet over its right half, with cloth behind it and such a
# sheet between both, and without that. Sheets are not drawn.
CAST = """async ({ fabric }) => {
  const { renderer } = window.prepared.point;
  const cloth = { ...web.fabricOf(fabric), openness: null, uvSizeMm: [20, 20] };
  const mesh = web.rectangle(0.02, 0.02);
  const at = (z) => ({ ...mesh, positions: mesh.positions.map((value, i) => value + (i % 3 === 2 ? z : 0)) });
  const [z, triangles] = [0.001, mesh.triangles];
  const over = { positions: [0, -1, z, 1, -1, z, 1, 1, z, 0, 1, z], triangles };
  const between = at(-0.002);
  renderer.setLights([{ kind: "directional", towards: [0, 0, 1] }]);
  renderer.setCamera({ origin: [0, 0, 0.03], target: [0, 0, 0] });
  const pictures = [];
  for (const [pieces, casters] of [
    [[mesh], []],
    [[mesh], [over]],
    [[mesh, at(-0.004)], [between]],
    [[mesh, at(-0.004)], []],
  ]) {
    renderer.setPieces(pieces.map((each) => ({ mesh: each, ...cloth })), casters);
    await renderer.render(1);
    pictures.push(Array.from((await renderer.readLinear()).data));
  }
  delete window.prepared.point;
  renderer.destroy();
  return pictures;
}"""
# Mean brightness of a picture of one pass at rest and by twice the exposure, and how often the canvas was
# drawn to: until rest, in ten frames at rest, and for the exposure.
REST = """async () => {
  const { renderer } = window.prepared.point;
  const texture = GPUCanvasContext.prototype.getCurrentTexture;
  let drawn = 0;
  GPUCanvasContext.prototype.getCurrentTexture = function () { drawn++; return texture.call(this); };
  const counts = [];
  const frames = async (isEnough) => {
    drawn = 0;
    for (let number = 1, report = null; report === null || !isEnough(report, number); number++) {
      report = renderer.frame();
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    counts.push(drawn);
    const { data } = await renderer.readPixels();
    return data.reduce((sum, value) => sum + value, 0) / data.length;
  };
  renderer.setModel("point", { passes: 1 });
  renderer.setCamera({ origin: [0, -0.01, 0.03], target: [0, 0, 0] });
  const before = await frames((report) => report.isComplete);
  await frames((_, number) => number === 10);
  renderer.setExposure(1);
  const after = await frames((_, number) => number === 2);
  renderer.setExposure(0);
  GPUCanvasContext.prototype.getCurrentTexture = texture;
  return { before, after, counts };
}"""

# Reports of the first frame with a picture, and of the first that is no preview; some kernels are refused.
REFUSE = """async ({ fabric, openness, size, refused }) => {
  const compile = GPUDevice.prototype.createComputePipelineAsync;
  GPUDevice.prototype.createComputePipelineAsync = function (options) {
    const isRefused = refused.includes(options.compute.entryPoint);
    return isRefused ? Promise.reject(new Error("too much for it.\\nReally")) : compile.call(this, options);
  };
  const renderer = await web.ClothRenderer.create({ size: [size, size] });
  const piece = { ...web.fabricOf(fabric), openness, uvSizeMm: [20, 20] };
  renderer.setPieces([{ mesh: web.rectangle(0.02, 0.02), ...piece }]);
  renderer.setTables("clustered", new Uint8Array(await (await fetch("clustered.tables")).arrayBuffer()));
  renderer.setCamera({ origin: [0, -0.01, 0.03], target: [0, 0, 0] });
  const reports = [];
  for (let report = null; report === null || report.passes === 0 || report.isPreview; ) {
    report = renderer.frame();
    if (report.passes > 0) reports.push(report);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  GPUDevice.prototype.createComputePipelineAsync = compile;
  renderer.destroy();
  return [reports[0], reports.at(-1)];
}"""


# Whether the picture that Python rendered has the size of the canvas.
SAME_SIZE = """(async () => {
  const { width, height } = await window.loomlight.readPixels();
  const canvas = document.querySelector("canvas.cloth-canvas");
  return width === canvas.width && height === canvas.height;
})()"""


# Base64 of the linear picture of a fabric by tables that Python packed, before and behind.
SERVED = """async ({ fabric, size, model }) => {
  const renderer = await web.ClothRenderer.create({ size: [size, size], budget: null });
  const piece = { ...web.fabricOf(fabric), openness: null, uvSizeMm: [20, 20] };
  renderer.setPieces([{ mesh: web.rectangle(0.02, 0.02), ...piece }]);
  const content = await (await fetch(`layers-${model}.tables`)).arrayBuffer();
  renderer.setTables(model, new Uint8Array(content), { samples: 1 });
  renderer.setLights([{ kind: "directional", towards: [0.5, 0.3, 0.8] }]);
  renderer.setCamera({ origin: [0, -0.01, 0.03], target: [0, 0, 0] });
  await renderer.ready();
  await renderer.render(1);
  const { data } = await renderer.readLinear();
  renderer.destroy();
  return btoa(Array.from(new Uint8Array(data.buffer), (byte) => String.fromCharCode(byte)).join(""));
}"""


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory, playwright: Any) -> Iterator[Any]:
    """A page with the built module, beside the tables of a fabric, in a browser that computes in software."""
    npx = shutil.which("npx")
    if npx is None or not (ROOT / "web" / "node_modules").is_dir():
        pytest.skip("needs Node, and `npm install` in web/: scripts/setup.sh does both")
    folder = tmp_path_factory.mktemp("page")
    build = [npx, "vite", "build", "--config", "loomlight-web/vite.config.ts", "--logLevel", "error"]
    subprocess.run([*build, "--outDir", str(folder / "module")], cwd=ROOT / "web", check=True, timeout=HANG)
    (folder / "index.html").write_text(PAGE)
    for model in ("neural", "clustered"):
        (folder / f"{model}.tables").write_bytes(tables_of(fabric_from_text(FABRIC), model))
    for model in ("point", "lobes"):
        (folder / f"layers-{model}.tables").write_bytes(tables_of(load_fabric(LAYERS), model))
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with launched(playwright, SWIFTSHADER) as browser, visiting(browser) as visit:
        visit.page.goto(f"http://127.0.0.1:{server.server_port}/")
        wait_until(visit.page, "window.web !== undefined")
        if not visit.page.evaluate("async () => (await navigator.gpu?.requestAdapter()) != null"):
            pytest.skip("this Chromium has no WebGPU in software")
        yield visit.page
        assert visit.complaints == []
    server.shutdown()


def prepared(page: Any, model: str) -> float:
    """Seconds until the page's renderer of a model could draw."""
    scene = {"fabric": FABRIC, "openness": openness_json(fabric_from_text(FABRIC)), "size": SIZE}
    return float(page.evaluate(PREPARE, {**scene, "model": model}))


@pytest.mark.slow
@pytest.mark.parametrize("model", ["lobes", "point", "clustered", "neural"])
def test_chromium_draws_what_the_python_host_draws(page: Any, model: str) -> None:
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.skip(str(error))
    print(f"{model}: could draw after {prepared(page, model):.1f} s")
    drawn = base64.b64decode(page.evaluate(DRAW, model))
    theirs = np.frombuffer(drawn, np.float32).reshape(SIZE, SIZE, 4)
    cloth = Cloth(rectangle(0.02, 0.02), fabric_from_text(FABRIC), (20.0, 20.0))
    host = Renderer([cloth], (SIZE, SIZE), model, bake="gpu" if model == "lobes" else "cpu")
    light = DirectionalLight((0.5, 0.3, 0.8))
    ours = host.render(Camera((0, -0.01, 0.03)), [light], passes=1).linear
    assert theirs[..., :3].std() > 0.05
    # Other compilers join products and sums in other ways: 3e-6 were seen, and more where a ray grazes the
    # flank of a yarn, in one pixel of a hundred.
    difference = np.abs(theirs - ours).max(axis=2)
    grazed = 0.02 if model in ("lobes", "point") else 0.0
    assert (difference > 1e-4).mean() <= grazed
    assert difference.max() < (0.05 if grazed else 1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("model", ["point", "lobes"])
def test_chromium_draws_layers_as_the_python_host_draws_them(page: Any, model: str) -> None:
    """Those of tables that Python packs: the page compiles its kernels with layers for them."""
    scene = {"fabric": FABRIC, "size": SIZE, "model": model}
    begin = time.perf_counter()
    drawn = base64.b64decode(page.evaluate(SERVED, scene))
    print(f"{model} of layers: drawn after {time.perf_counter() - begin:.1f} s")
    theirs = np.frombuffer(drawn, np.float32).reshape(SIZE, SIZE, 4)
    host = Renderer([Cloth(rectangle(0.02, 0.02), load_fabric(LAYERS), (20.0, 20.0))], (SIZE, SIZE), model)
    light = DirectionalLight((0.5, 0.3, 0.8))
    ours = host.render(Camera((0, -0.01, 0.03)), [light], passes=1, samples=1).linear
    assert theirs[..., :3].std() > 0.03
    difference = np.abs(theirs - ours).max(axis=2)
    assert (difference > 1e-4).mean() <= 0.02


@pytest.mark.slow
def test_the_background_has_one_colour_on_screen_and_read_back(page: Any) -> None:
    prepared(page, "point")
    paper = page.evaluate(SHOW, {"model": "point", "background": [0.913, 0.88, 0.807], "behind": "#f5f1e8"})
    read, shown = (np.array(paper[name]).reshape(SIZE, SIZE, 4) for name in ("read", "shown"))
    assert len(np.unique(read.reshape(-1, 4), axis=0)) > 100  # there is cloth
    assert read[0, 0, 2] < 240  # the paper's blue
    # The canvas interpolates between pixels, which it takes from 8 bits.
    np.testing.assert_allclose(shown, read, atol=1)
    nothing = page.evaluate(SHOW, {"model": "point", "background": [0, 0, 0], "behind": "#f5f1e8"})
    np.testing.assert_array_equal(
        np.array(nothing["shown"]).reshape(SIZE, SIZE, 4)[0, 0], [245, 241, 232, 255]
    )


@pytest.mark.slow
def test_a_page_at_rest_draws_nothing_but_another_exposure(page: Any) -> None:
    prepared(page, "point")
    rest = page.evaluate(REST)
    assert rest["counts"] == [1, 0, 1]
    assert rest["after"] > 1.1 * rest["before"]


@pytest.mark.slow
def test_what_others_draw_casts_shadows_on_cloth_and_hides_what_is_behind(page: Any) -> None:
    prepared(page, "point")
    pictures = page.evaluate(CAST, {"fabric": FABRIC + "gap = 0.4\n"})
    alone, under, before, through = (np.array(each).reshape(SIZE, SIZE, 4) for each in pictures)
    half = SIZE // 2
    # The sheet's edge lies half a pixel or less from the middle.
    np.testing.assert_array_equal(under[:, : half - 1], alone[:, : half - 1])
    assert under[:, half + 1 :, :3].max() == 0  # there is no other light
    np.testing.assert_array_equal(under[..., 3], alone[..., 3])
    assert alone[:, half + 1 :, :3].mean() > 0.01
    # Through holes the second cloth is seen, unless the sheet lies before it.
    assert (through - alone)[..., 3].mean() > 0.03
    np.testing.assert_array_equal(before[..., 3], alone[..., 3])


@pytest.mark.slow
def test_a_device_that_cannot_compile_a_model_says_so_and_shows_points(page: Any) -> None:
    scene = {"fabric": FABRIC, "openness": openness_json(fabric_from_text(FABRIC)), "size": SIZE}
    _, last = page.evaluate(REFUSE, {**scene, "refused": ["shade_clustered"]})
    sentence = (
        "This device could not compile shade_clustered (too much for it): the cloth is shown point by point."
    )
    assert last["missing"] == [sentence]
    assert not last["isPreview"]
    assert last["compiled"] == 1


@pytest.mark.slow
def test_the_editor_lights_its_cloth(
    served: Served, playwright: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    with launched(playwright, SWIFTSHADER) as browser, visiting(browser) as visit:
        begin = time.perf_counter()
        visit.page.goto(f"http://127.0.0.1:{served.port}/")
        steps = {
            "flat cloth": "window.loomlight?.statistics()?.frames > 0",
            "first light": "window.loomlight.statistics().passes > 0",
            "as asked for": "window.loomlight.statistics().preparing === null",
        }
        for step, condition in steps.items():
            wait_until(visit.page, condition)
            print(f"{step}: after {time.perf_counter() - begin:.1f} s")
            if step != "as asked for":
                assert visit.page.get_by_test_id("preparing").inner_text().startswith("Preparing the light")
        pixels = visit.page.evaluate("window.loomlight.readPixels().then(({ data }) => data)")
        assert np.array(pixels).reshape(-1, 4)[:, :3].std() > 20  # of 255: cloth on paper
        assert visit.page.locator("canvas.cloth-canvas").count() == 1
        # At rest Python renders the picture, of the canvas's size, until the next turn.
        wait_until(visit.page, "window.loomlight.statistics().rendered === 'shown'")
        assert visit.page.evaluate(SAME_SIZE)
        assert visit.page.evaluate("window.loomlight.statistics().isComplete")
        # Its camera is one of `render`: the view of the drape, in the studio.
        visit.page.evaluate("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
        visit.page.get_by_test_id("copy-camera").click()
        command = visit.page.evaluate("window.copied")
        assert command.startswith("loomlight render twill-3-1.toml -o twill-3-1.png --scene drape --size ")
        assert "--view 19.29,27.43 --target " in command
        assert command.endswith(" --focal-length 51.978 --light-from -56,33")
        visit.page.locator("canvas.cloth-canvas").press("ArrowRight")
        wait_until(visit.page, "window.loomlight.statistics().rendered !== 'shown'")
        assert not visit.page.locator(".stage-picture").is_visible()
        clear = picture_of(exported(visit.page, "picture", width="90", height="60", transparent=True))
        paper = picture_of(exported(visit.page, "picture", transparent=False))
        visit.page.emulate_media(color_scheme="dark")
        dark = picture_of(exported(visit.page, "picture"))
        assert visit.complaints == []
    for page, colour in ((paper, (0xF5, 0xF1, 0xE8)), (dark, (0x3A, 0x37, 0x32))):
        np.testing.assert_allclose(page[0, 0, :3], colour, atol=1)  # --paper of style.css
    assert clear.shape == paper.shape == (60, 90, 4)
    assert (paper[..., 3] == 255).all()
    opacity = clear[..., 3:] / 255
    assert opacity[0, 0] == 0
    assert (opacity > 0.9).mean() > 0.05
    assert clear[opacity[..., 0] > 0.9][:, :3].std() > 20
    # A picture without a background over paper is the one with paper, but for the shadow on it. Both have
    # 8 bits; .005 was seen.
    over = opacity * srgb_to_linear(clear[..., :3] / 255) + (1 - opacity) * srgb_to_linear(
        paper[0, 0, :3] / 255
    )
    shadow = over - srgb_to_linear(paper[..., :3] / 255)
    np.testing.assert_allclose(shadow[opacity[..., 0] == 1], 0, atol=0.01)
    assert shadow.min() > -0.01
    assert shadow.max() > 0.2  # beside the drape
