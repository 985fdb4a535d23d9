"""The editor's server while many read drafts: latency, errors and memory.

Clients post drafts of 641 ends, each another one, as fast as they are answered, while one more posts a draft
of 16,384 ends again and again. Bars: no error, a 99th percentile below 2 s, and resident memory of the server
within 50 MiB between request 200 and the end.
"""

from __future__ import annotations

import http.client
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from studies.harness.study import Figures, Found, Run, Study

_MIB = 1 << 20


def draft_of(ends: int, picks: int, seed: int) -> bytes:
    """A draft of eight shafts with a threading of its own."""
    chance = np.random.default_rng(seed)
    lines = ["[WIF]", "Version=1.1", "[WEAVING]", "Shafts=8", "Treadles=8", "[THREADING]"]
    lines += [f"{end}={shaft}" for end, shaft in enumerate(chance.integers(1, 9, ends), 1)]
    lines += ["[TIEUP]"] + [f"{treadle}={treadle},{1 + treadle % 8}" for treadle in range(1, 9)]
    lines += ["[TREADLING]"]
    lines += [f"{pick}={treadle}" for pick, treadle in enumerate(chance.integers(1, 9, picks), 1)]
    return "\n".join(lines).encode()


class _Load:
    """Clients of a server: what they measured."""

    def __init__(self, port: int, until: float) -> None:
        self.port, self.until = port, until
        self.seconds: list[float] = []
        self.large: list[float] = []
        self.errors: list[str] = []

    def post(self, draft: bytes, into: list[float]) -> None:
        begin = time.perf_counter()
        try:
            connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
            connection.request("POST", "/api/wif?name=a.wif", draft)
            answer = connection.getresponse()
            content = answer.read()
            connection.close()
            if answer.status != 200:
                self.errors.append(f"{answer.status} {content[:200]!r}")
        except OSError as error:
            self.errors.append(str(error))
        into.append(time.perf_counter() - begin)

    def client(self, number: int) -> None:
        """Posts until the time is over."""
        drafts = [draft_of(641, 641, 100 * number + each) for each in range(3)]
        while time.monotonic() < self.until:
            self.post(drafts[len(self.seconds) % 3], self.seconds)

    def large_client(self) -> None:
        """Posts the draft of 16,384 ends until the time is over."""
        draft = draft_of(16384, 641, 7)
        while time.monotonic() < self.until:
            self.post(draft, self.large)


@dataclass(frozen=True)
class ServerLoad(Settings):
    clients: int = setting(64, "Clients that post drafts.", low=1)
    seconds: float = setting(60.0, "Of the load.", low=0.1)
    warm: int = setting(200, "Requests before it.", low=1)
    port: int = setting(8799, "Of the server.", low=1024, high=65535)


def measure(settings: ServerLoad, run: Run) -> Found:
    """Percentiles of latency in seconds, errors, and resident MiB."""
    with tempfile.TemporaryDirectory() as page:
        Path(page, "index.html").write_text("page")
        code = (
            "import uvicorn; from pathlib import Path; from loomlight.viewer.app import Access; "
            "from loomlight.viewer.app import editor_app; "
            f"app = editor_app(Path({page!r}), 'twill 3/1', Access(True, None)); "
            f"uvicorn.run(app, port={settings.port}, log_level='error')"
        )
        server = subprocess.Popen([sys.executable, "-c", code])
        try:
            _await_server(settings.port, server)
            return Found(_figures(settings, server.pid))
        finally:
            server.terminate()
            server.wait()


def _await_server(port: int, server: subprocess.Popen[bytes]) -> None:
    while server.poll() is None:
        try:
            http.client.HTTPConnection("127.0.0.1", port, timeout=1).connect()
        except OSError:
            time.sleep(0.1)
        else:
            return
    raise InputError(f"The server ended; if something else listens at {port}, choose another --port.")


def _figures(settings: ServerLoad, server: int) -> Figures:
    warm = _Load(settings.port, 0)
    for number in range(settings.warm):
        warm.post(draft_of(641, 641, number), warm.seconds)
    before = _resident_mib(server)
    load = _Load(settings.port, time.monotonic() + settings.seconds)
    threads = [threading.Thread(target=load.client, args=(number,)) for number in range(settings.clients)]
    threads.append(threading.Thread(target=load.large_client))
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    after = _resident_mib(server)
    missed = []
    late = float(np.percentile(load.seconds, 99))
    if load.errors:
        missed.append(f"{len(load.errors)} errors, such as {load.errors[0]}")
    if late >= 2:
        missed.append(f"p99 {late:.2f} s, not below 2 s")
    if after["server"] - before["server"] > 50:
        missed.append(f"the server grew by {after['server'] - before['server']:.0f} MiB")
    return {
        "clients": settings.clients,
        "requests": len(load.seconds),
        "errors": len(load.errors),
        "p50_s": float(np.median(load.seconds)),
        "p99_s": late,
        "large_requests": len(load.large),
        "large_p50_s": float(np.median(load.large)),
        "resident_mib": {"after_200": before, "at_the_end": after},
        "missed": missed,
    }


def _resident_mib(server: int) -> dict[str, float]:
    """Of the server, and of the processes that it started."""
    tasks = list(Path(f"/proc/{server}/task").iterdir())
    children = sorted({pid for task in tasks for pid in _read(task / "children").split()})
    return {"server": _rss(server), "readers": sum(_rss(int(pid)) for pid in children)}


def _rss(process: int) -> float:
    pages = _read(Path(f"/proc/{process}/statm")).split()
    return int(pages[1]) * 4096 / _MIB if pages else 0.0


def _read(file: Path) -> str:
    """What the system says of a process or a thread; nothing if it has ended since it was listed."""
    try:
        return file.read_text()
    except (FileNotFoundError, ProcessLookupError):
        return ""


def tables(figures: Figures) -> list[Table]:
    """Latency, errors and growth."""
    keys = ("clients", "requests", "errors", "p50_s", "p99_s", "large_p50_s")
    before, after = (figures["resident_mib"][when]["server"] for when in ("after_200", "at_the_end"))
    columns = [
        "clients",
        "requests",
        "errors",
        "median, s",
        "99th percentile, s",
        "large, median, s",
        "grew by, MiB",
    ]
    return [
        Table("Drafts read by a server", columns, {"load": [*(figures[key] for key in keys), after - before]})
    ]


STUDY = Study(
    "speed/server_load",
    "the editor's server while many read drafts: latency, errors and memory",
    ServerLoad(),
    measure,
    tables,
    small={"clients": 2, "seconds": 1.0, "warm": 4},
)
