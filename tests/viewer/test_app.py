"""The server as a browser, and as somebody who is up to no good, meets it.

Covers: viewer/app.py, viewer/session.py, viewer/answers.py
Covers: viewer/messages.py
"""

from __future__ import annotations

import asyncio
import http.client
import json
import socket
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from safetensors.numpy import load
from starlette.exceptions import HTTPException
from starlette.requests import Request

from loomlight.core.errors import LoomlightWarning
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.realtime.materials import tables_for
from loomlight.realtime.records import numpy_type
from loomlight.realtime.words import pack_fabrics
from loomlight.viewer.app import Access, is_loopback, read_body
from loomlight.viewer.limited_reader import MAX_UPLOAD
from loomlight.viewer.messages import fabric_json
from tests.limits import HANG
from tests.viewer.conftest import Served

WIF = Path(__file__).resolve().parents[2] / "examples" / "undulating-twill.wif"


def fabric_of(served: Served) -> dict[str, Any]:
    session: dict[str, Any] = json.loads(served.ask("GET", "/api/session")[2])
    fabric: dict[str, Any] = session["fabric"]
    return fabric


def error_of(answer: tuple[int, dict[str, str], bytes]) -> str:
    sentence = json.loads(answer[2])["error"]
    assert isinstance(sentence, str)
    assert "\n" not in sentence
    return sentence


def test_page_and_session(local: Served) -> None:
    status, headers, body = local.ask("GET", "/")
    assert (status, b"page" in body) == (200, True)
    assert "default-src 'self'" in headers["content-security-policy"]
    session = json.loads(local.ask("GET", "/api/session")[2])
    assert (session["version"], session["has_python"], session["token"]) == (1, True, None)
    assert session["fabric"]["fields"] == {"weave": "twill 3/1"}
    names = [entry["id"] for entry in session["gallery"]]
    assert {"denim", "wool-houndstooth", "gingham"} <= set(names)
    assert all(entry["description"] and entry["draft"]["ends"] for entry in session["gallery"])


@pytest.mark.parametrize(
    "place",
    [
        "/../secret.txt",
        "/%2e%2e/secret.txt",
        "/assets/../../secret.txt",
        "/assets/%2e%2e%2f%2e%2e%2fsecret.txt",
        "/..%5csecret.txt",
        "//etc/passwd",
        "/link.txt",
        "/%00",
    ],
)
def test_nothing_outside_the_folder_is_served(local: Served, place: str) -> None:
    status, _, body = local.ask("GET", place)
    assert status in (400, 404)
    assert b"secret" not in body
    assert b"root:" not in body


def test_draft_is_read(local: Served) -> None:
    status, _, body = local.ask("POST", "/api/wif?name=my%20twill.wif", WIF.read_bytes())
    assert (status, json.loads(body)["ends"]) == (200, 144)
    broken = local.ask("POST", "/api/wif?name=broken.wif", b"[THREADING]\n1=x\n")
    assert (broken[0], error_of(broken).startswith("broken.wif")) == (422, True)


def test_large_upload_is_refused_before_it_is_read(local: Served) -> None:
    with socket.create_connection(("127.0.0.1", local.port), timeout=HANG) as connection:
        connection.sendall(
            b"POST /api/wif HTTP/1.1\r\nHost: localhost\r\nContent-Length: 209715200\r\n"
            b"Accept-Encoding: gzip\r\n\r\n"
        )
        # Not a byte of the body is sent.
        answer = b""
        while b"MiB that" not in answer:
            part = connection.recv(65536)
            assert part, answer
            answer += part
    assert answer.startswith(b"HTTP/1.1 413")
    assert b"The upload of 200 MiB is larger than the 16 MiB" in answer


def test_large_upload_of_unknown_length_is_refused(local: Served) -> None:
    def chunks() -> Any:
        for _ in range(2 * MAX_UPLOAD >> 20):
            yield bytes(1 << 20)

    connection = http.client.HTTPConnection("127.0.0.1", local.port, timeout=HANG)
    connection.request("POST", "/api/wif", chunks(), encode_chunked=True)
    response = connection.getresponse()
    assert (response.status, "16 MiB" in json.loads(response.read())["error"]) == (413, True)
    connection.close()


def test_connection_cut_in_the_middle_leaves_the_server_up(local: Served) -> None:
    for path in (b"/api/wif", b"/api/save"):
        with socket.create_connection(("127.0.0.1", local.port)) as connection:
            connection.sendall(
                b"POST " + path + b" HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5000\r\n\r\n{"
            )
    assert local.ask("GET", "/api/session")[0] == 200


def test_files_of_an_edited_fabric(local: Served) -> None:
    fabric = fabric_of(local)
    fabric["fields"]["warp"] = {"roughness": 0.25}
    fabric["name"] = "My Twill, no. 2"
    status, headers, body = local.ask("POST", "/api/save", json.dumps({"format": "toml", **fabric}).encode())
    assert (status, "my-twill-no-2.toml" in headers["content-disposition"]) == (200, True)
    assert fabric_from_text(body.decode()).fields.warp.roughness == 0.25
    wif = local.ask("POST", "/api/save", json.dumps({"format": "wif", **fabric}).encode())[2]
    assert b"[THREADING]" in wif
    point = {"format": "loom", "model": "point", **fabric}
    loom = load(local.ask("POST", "/api/save", json.dumps(point).encode())[2])
    assert loom["source.drawdown"].shape == (4, 4)


@pytest.mark.parametrize(
    ("body", "status", "said"),
    [
        (b"{", 400, "no JSON"),
        (b"[1]", 400, "no object"),
        (b'{"format": "toml"}', 422, "fields"),
        (b"[" * 100_000, 400, "no JSON"),
    ],
)
def test_bad_requests_are_told_so(local: Served, body: bytes, status: int, said: str) -> None:
    answer = local.ask("POST", "/api/save", body)
    assert (answer[0], said in error_of(answer)) == (status, True)


def test_unknown_formats_and_models_are_told_so(local: Served) -> None:
    fabric = fabric_of(local)
    for asked, said in (
        ({"format": "exe"}, '"exe" is unknown'),
        ({"format": "loom", "model": "neumip"}, "trained for minutes"),
        ({"format": "loom", "model": "lobs"}, "did you mean lobes"),
        ({"format": "zip", "size": 5000}, "size = 5000 is out of range: write 16 to 4096 texels"),
        ({"format": "zip", "size": "many"}, "size = 'many' is no whole number"),
    ):
        assert said in error_of(local.ask("POST", "/api/save", json.dumps(asked | fabric).encode()))
    answer = local.ask("POST", "/api/tables", json.dumps({"model": "neumip", **fabric}).encode())
    assert "has no tables" in error_of(answer)
    assert error_of(local.ask("GET", "/api/nothing")) == "There is no /api/nothing here."


def test_tables_of_a_model(local: Served) -> None:
    asked = {"model": "neural", **fabric_of(local)}
    status, _, body = local.ask("POST", "/api/tables", json.dumps(asked).encode())
    assert status == 200
    tables = load(body)
    # What the Python renderer uploads for the same fabric.
    fabric = fabric_from_text('weave = "twill 3/1"')
    look = fabric.layout(), fabric.appearance()
    packed = pack_fabrics([look], models=[tables_for(fabric, "neural")]).buffers()
    assert {name: part.tobytes() for name, part in tables.items()} == {
        name: values.tobytes() for name, values in packed.items()
    }


def test_tables_of_cloth_in_layers(local: Served) -> None:
    """The page asks for those of its own models, once it is told how many layers there are."""
    with pytest.warns(LoomlightWarning, match="2 layers"):
        fabric = load_fabric(WIF.parent / "layered" / "double-plain.wif")
    asked = {"model": "point", **fabric_json(fabric)}
    tables = load(local.ask("POST", "/api/tables", json.dumps(asked).encode())[2])
    assert tables["fabrics"].view(numpy_type("Fabric"))["planes"] == [2]
    answer = local.ask("POST", "/api/openness", json.dumps(fabric_json(fabric)).encode())
    assert json.loads(answer[2])["planes"] == [2]


def test_openness_of_yarns(local: Served) -> None:
    """Numbers of Python, whatever the colours are; a fabric that cannot be is told so."""
    fabric = fabric_of(local)
    asked = [fabric | {"fields": fabric["fields"] | more} for more in ({}, {"warp": {"color": "#102030"}})]
    answers = [local.ask("POST", "/api/openness", json.dumps(each).encode()) for each in asked]
    assert [answer[0] for answer in answers] == [200, 200]
    first, second = (json.loads(answer[2]) for answer in answers)
    assert first == second
    known = fabric_from_text('weave = "twill 3/1"\ninterreflection = true').appearance().openness
    assert known is not None
    for name in ("by_view", "interior", "facing", "facing_layer"):
        assert first[name] == getattr(known, name).ravel().tolist(), name
    assert [len(first[name]) for name in ("by_point", "per_relief", "layers")] == [72, 1, 4]
    wide = fabric | {"fields": fabric["fields"] | {"gap": 2}}
    answer = local.ask("POST", "/api/openness", json.dumps(wide).encode())
    assert (answer[0], "gap" in error_of(answer)) == (422, True)


def test_pages_of_other_sites_are_refused(local: Served) -> None:
    rebound = local.ask("GET", "/api/session", headers={"Host": "evil.example"})
    assert (rebound[0], "this machine alone" in error_of(rebound)) == (403, True)
    foreign = local.ask("POST", "/api/wif", b"", headers={"Origin": "https://evil.example"})
    assert (foreign[0], "another site" in error_of(foreign)) == (403, True)
    own = f"http://127.0.0.1:{local.port}"
    assert local.ask("GET", "/api/session", headers={"Origin": own})[0] == 200


@pytest.mark.parametrize(
    "headers", [{"Host": "[::1"}, {"Host": "[x]"}, {"Origin": "http://[::1"}, {"Origin": "//[x]"}]
)
def test_malformed_hosts_and_origins_are_told_so(local: Served, headers: dict[str, str]) -> None:
    answer = local.ask("GET", "/api/session", headers=headers)
    assert (answer[0], f"The {next(iter(headers))} " in error_of(answer)) == (400, True)


def test_too_many_values_are_refused_before_they_are_parsed(local: Served) -> None:
    # No JSON at all, which a parser would say.
    answer = local.ask("POST", "/api/save", b"," * 1_000_001)
    assert (answer[0], "1,000,000 values" in error_of(answer)) == (413, True)


def test_a_body_that_never_comes_is_given_up() -> None:
    async def receive() -> Any:
        await asyncio.Event().wait()

    request = Request({"type": "http", "headers": []}, receive)
    # In a thread of its own: Playwright leaves its loop running in that of the tests.
    with ThreadPoolExecutor(1) as pool, pytest.raises(HTTPException, match="did not arrive within 0 s"):
        pool.submit(lambda: asyncio.run(read_body(request, 10, seconds=0))).result()


def test_token_is_asked_for(shared: Served) -> None:
    for headers in ({}, {"X-Loomlight-Token": "other"}, {"Cookie": "loomlight-token=other"}):
        status, _, body = shared.ask("GET", "/", headers=headers)
        assert (status, b"token is missing or wrong" in body) == (401, True)
    status, headers, _ = shared.ask("GET", "/?token=token&fabric=x")
    assert (status, headers["location"]) == (303, "/?fabric=x")
    cookie = headers["set-cookie"].partition(";")[0]
    assert "httponly" in headers["set-cookie"].lower()
    assert shared.ask("GET", "/", headers={"Cookie": cookie})[0] == 200
    session = shared.ask("GET", "/api/session", headers={"X-Loomlight-Token": "token"})
    assert json.loads(session[2])["token"] == "token"


def test_a_token_is_made_unless_on_loopback() -> None:
    assert Access.for_host("localhost") == Access(True, None)
    tokens = {Access.for_host("0.0.0.0").token for _ in range(2)}
    assert len(tokens) == 2
    assert all(token is not None and len(token) >= 43 for token in tokens)
    assert [is_loopback(host) for host in ("127.0.0.1", "::1", "[::1]", "127.1.2.3", "LOCALHOST")] == [
        True
    ] * 5
    assert not any(
        is_loopback(host) for host in ("0.0.0.0", "::", "192.168.1.2", "localhost.evil.example", "")
    )
