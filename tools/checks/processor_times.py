"""Plugin of pytest that lists the tests which take the most processor time.

    pytest -p tools.checks.processor_times [--times-file FILE]

Seconds are user and system time of all threads, and of child processes once they have ended. A fixture counts
in the first test that asks for it, and so do imports, compiling and caches that fill.
"""

from __future__ import annotations

import resource
from collections import defaultdict
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

LISTED = 30
MARK = pytest.StashKey[float]()
FIXTURE = "processor seconds of a fixture"


def processor_seconds() -> float:
    """User and system time of this process and of its ended children."""
    usages = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--times-file", type=Path, help="file for all times: seconds, phase, test or fixture")


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> None:
    item.stash[MARK] = processor_seconds()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, Any, Any]:
    report = yield
    now = processor_seconds()
    report.processor_seconds = now - item.stash[MARK]  # xdist sends attributes of reports on
    item.stash[MARK] = now
    return report


@pytest.hookimpl(wrapper=True)
def pytest_fixture_setup(fixturedef: Any, request: Any) -> Generator[None, Any, Any]:
    before = processor_seconds()
    try:
        return (yield)
    finally:
        seconds = processor_seconds() - before
        request._pyfuncitem.user_properties.append((FIXTURE, [fixturedef.argname, seconds]))


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    rows: list[tuple[float, str, str]] = []
    folders: dict[str, float] = defaultdict(float)
    for report in (report for reports in terminalreporter.stats.values() for report in reports):
        if not hasattr(report, "processor_seconds"):
            continue
        rows.append((report.processor_seconds, report.when, report.nodeid))
        folders[str(Path(report.nodeid.split("::")[0]).parent)] += report.processor_seconds
        if report.when == "setup":
            made = [value for name, value in report.user_properties if name == FIXTURE]
            rows += [(seconds, "fixture", f"{name} of {report.nodeid}") for name, seconds in made]
    rows.sort(reverse=True)
    lines = [f"{seconds:8.2f} s {phase:8} {name}" for seconds, phase, name in rows]
    if config.option.times_file:
        config.option.times_file.write_text("\n".join(lines) + "\n")
    terminalreporter.section(f"processor time: {sum(folders.values()):.0f} s in tests")
    for folder, seconds in sorted(folders.items(), key=lambda pair: -pair[1]):
        terminalreporter.write_line(f"{seconds:8.1f} s {folder}")
    for line in lines[:LISTED]:
        terminalreporter.write_line(line)
