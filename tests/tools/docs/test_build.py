"""The documentation site: every page is there, every link leads somewhere, nothing is loaded from elsewhere.

Covers: viewer/client.py
"""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

import loomlight
from loomlight.viewer import client as viewer_site
from tools.docs.build import ROOT, Translator, build, main, read_pages

_PLACES = re.compile(r'(?:href|src)="([^"]*)"')


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site of this project's pages, with a page of one file in place of the editor."""
    folder = tmp_path_factory.mktemp("docs")
    client = folder / "client"
    client.mkdir()
    (client / "index.html").write_text('<meta name="loomlight-session" content="api/session" />')
    (client / "icon.svg").touch()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(viewer_site, "client_folder", lambda: client)
        assert build(folder / "site") > 30
    return folder / "site"


def test_every_page_of_the_project_is_there(site: Path) -> None:
    for file in (ROOT / "docs").rglob("*.md"):
        page = site / file.relative_to(ROOT / "docs").with_suffix(".html")
        heading = file.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ").replace("`", "")
        assert heading.split()[0] in page.read_text(encoding="utf-8")
    assert (site / "papers.html").is_file()
    assert (site / "papers" / "zhu2024.html").is_file()
    readers = {page.source: page.reader for page in read_pages(ROOT)}
    assert readers["docs/fabric-files.md"] == "Use"
    assert readers["docs/research/figures.md"] == "Figures"
    assert readers["docs/research/notes/simd.md"] == "What was tried"
    assert readers["studies/papers/chen2024/README.md"] == "Papers"


def test_the_python_reference_has_every_public_name(site: Path) -> None:
    page = (site / "api.html").read_text(encoding="utf-8")
    for name in loomlight.__all__:
        assert f'id="{name.lower()}"' in page
    assert "spp: int = 8" in page
    assert "<code>settings</code>: by default those of" in page


def test_every_link_leads_somewhere(site: Path) -> None:
    anchors = {
        page: set(re.findall(r'id="([^"]*)"', page.read_text(encoding="utf-8")))
        for page in site.rglob("*.html")
    }
    broken = []
    for page in anchors:
        for place in _PLACES.findall(page.read_text(encoding="utf-8")):
            parts = urlsplit(place)
            if parts.scheme:
                continue
            target = page if not parts.path else (page.parent / unquote(parts.path)).resolve()
            if not target.is_file() or (parts.fragment and parts.fragment not in anchors.get(target, set())):
                broken.append((str(page.relative_to(site)), place))
    assert broken == []


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert re.findall(r'<(?:script|link|img|iframe)[^>]*(?:src|href)="https?:', text) == []
    for part in ("site.css", "live.js"):
        assert "http" not in (site / part).read_text(encoding="utf-8")


def test_each_page_ends_with_one_live_cloth(site: Path) -> None:
    for page in site.glob("*.html"):
        found = re.findall(
            r'data-live="live/index.html\?fabric=([\w-]+)&amp;embed=1"', page.read_text(encoding="utf-8")
        )
        assert len(found) == (0 if page.name == "gallery.html" else 1)
        assert all((site / "live" / "gallery" / f"{name}.webp").is_file() for name in found)


def test_cells_of_records_are_plain_text(tmp_path: Path) -> None:
    """Comments that say where a figure comes from are for GitHub's readers of the source."""
    (tmp_path / "docs").mkdir()
    cell = "<!-- cell a/b: T / r -->0.5<!-- end -->"
    (tmp_path / "README.md").write_text(f"# Name\n\n{cell} in all, written `{cell}`\n")
    (tmp_path / "ARCHITECTURE.md").write_text("# Architecture\n")
    pages = read_pages(tmp_path)
    body = Translator(pages, tmp_path).body(pages[0])
    assert "<p>0.5 in all" in body
    assert body.count("&lt;!-- cell") == 1


def test_links_that_lead_nowhere_are_told(tmp_path: Path) -> None:
    (tmp_path / "docs").mkdir()
    (tmp_path / "README.md").write_text("# Name\n\n[a](docs/missing.md)\n")
    (tmp_path / "ARCHITECTURE.md").write_text("# Architecture\n")
    pages = read_pages(tmp_path)
    with pytest.raises(ValueError, match=r"README\.md: the link docs/missing\.md leads nowhere"):
        Translator(pages, tmp_path).body(pages[0])


def test_folder_with_other_files_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "mine").touch()
    assert main([str(tmp_path)]) == 2
    assert "holds other files" in capsys.readouterr().err
