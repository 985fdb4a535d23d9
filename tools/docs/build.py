"""Builds the documentation site: `python -m tools.docs.build DIR`. Static files, no Python behind them.

Pages are the Markdown files of the project, by reader: for use, how it works, figures, what was tried. Each
page ends with one live cloth, the exported editor in a frame; a browser without WebGPU shows its picture.
"""

from __future__ import annotations

import argparse
import html
import posixpath
import re
import shutil
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

from markdown_it import MarkdownIt
from markdown_it.token import Token

from loomlight.core.errors import LoomlightError
from loomlight.exporters.folder import replacing_folder, write_manifest
from loomlight.viewer.client import copy_client
from loomlight.viewer.session import session
from tools.docs.api import TITLE, api_text
from tools.docs.template import page_html

ROOT = Path(__file__).resolve().parents[2]
PARTS = Path(__file__).parent
# Readers, and which of their pages come first; a page that is named nowhere is for use.
USE, HOW, FIGURES, PAPERS, TRIED = "Use", "How it works", "Figures", "Papers", "What was tried"
_FIRST = {
    USE: (
        "rendering",
        "cameras",
        "meshes",
        "garments",
        "animation",
        "moving-cloth",
        "fabric-files",
        "capture",
        "drafts",
        "artwork",
        "layers",
        "looms",
        "large-drafts",
        "editor",
        "editor-draft",
        "realtime",
        "realtime-shaders",
        "materials",
        "export",
        "engines",
        "usd",
        "u3m",
        "blender",
        "maps",
        "models",
        "comparison",
    ),
    HOW: ("notation", "scattering", "light-between-yarns", "aggregation"),
    FIGURES: (
        "figures",
        "figures-speed",
        "figures-realtime",
        "figures-baked",
        "figures-sampling",
        "figures-light",
        "measured-cloth",
        "studies",
        "evaluation",
    ),
    PAPERS: ("papers",),
    TRIED: (),
}
_PICTURES = {".png", ".jpg", ".jpeg", ".webp", ".gif", ".svg"}


@dataclass(frozen=True)
class Page:
    """One page.

    Attributes:
        source: its Markdown file, relative to the project, with slashes.
        target: its place in the site.
        reader: whom it is for; "" for the first page.
        title: its first heading.
        text: its Markdown.
    """

    source: str
    target: str
    reader: str
    title: str
    text: str


def read_pages(root: Path) -> list[Page]:
    """The first page, then all others by reader.

    Raises:
        ValueError: a page without a heading.
    """
    pages = [_page(root, root / "README.md", "index.html", "")]
    for reader in _FIRST:
        files = [file for file in _files(root) if _reader(root, file) == reader]
        first = _FIRST[reader]
        files.sort(key=lambda file: first.index(_name(file)) if _name(file) in first else len(first))
        pages += [_page(root, file, _target(root, file), reader) for file in files]
        if reader == USE:
            pages.append(Page("the Python reference", "api.html", USE, TITLE, api_text()))
        if reader == HOW:
            pages.append(_page(root, root / "ARCHITECTURE.md", "architecture.html", HOW))
    return pages


def _files(root: Path) -> list[Path]:
    """The Markdown files below docs/ and studies/papers/."""
    return [file for folder in ("docs", "studies/papers") for file in sorted((root / folder).rglob("*.md"))]


def _name(file: Path) -> str:
    """A page's name: its file's, or of a README its folder's."""
    return file.parent.name if file.stem == "README" else file.stem


def _reader(root: Path, file: Path) -> str:
    folders = file.relative_to(root).parts
    if folders[0] == "studies":
        return PAPERS
    if "notes" in folders:
        return TRIED
    if "research" in folders:
        return FIGURES if file.stem.startswith("figures") or file.stem in _FIRST[FIGURES] else HOW
    return USE


def _target(root: Path, file: Path) -> str:
    folder = "docs" if file.is_relative_to(root / "docs") else "studies"
    page = file.relative_to(root / folder)
    return (
        page.parent.with_suffix(".html") if page.stem == "README" else page.with_suffix(".html")
    ).as_posix()


def _page(root: Path, file: Path, target: str, reader: str) -> Page:
    # Comments say where figures of studies stand (`tools/generate/figures.py`).
    text = re.sub(r"^<!--.*?-->\n", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
    text = re.sub(r"(?<!`)<!-- cell .*?-->(.*?)<!-- end -->", r"\1", text)
    heading = re.search(r"^# (.+)$", text, re.MULTILINE)
    if heading is None:
        raise ValueError(f"{file} has no heading")
    return Page(file.relative_to(root).as_posix(), target, reader, heading[1].replace("`", ""), text)


class Translator:
    """Markdown to HTML, with links between files made into links between pages."""

    def __init__(self, pages: Sequence[Page], root: Path) -> None:
        self._targets = {page.source: page.target for page in pages}
        self._root = root
        self._markdown = MarkdownIt("commonmark", {"html": False}).enable("table")
        # Pictures that pages show, by their place in the project.
        self.pictures: set[str] = set()

    def body(self, page: Page) -> str:
        """The HTML of a page's text.

        Raises:
            ValueError: a link or a picture that leads nowhere.
        """
        tokens = self._markdown.parse(page.text)
        _add_anchors(tokens)
        for token in _with_children(tokens):
            if token.type == "link_open":
                self._set(token, "href", self._link(page, str(token.attrs["href"])))
            elif token.type == "image":
                self._set(token, "src", self._picture(page, str(token.attrs["src"])))
                token.attrs["loading"] = "lazy"
            elif token.type == "code_inline":
                self._link_of_code(page, token)
        return (
            str(self._markdown.renderer.render(tokens, self._markdown.options, {}))
            .replace("<table>", '<div class="wide" tabindex="0" role="region" aria-label="Table"><table>')
            .replace("</table>", "</table></div>")
        )

    @staticmethod
    def _set(token: Token, name: str, value: str | None) -> None:
        if value is None:  # a file that the site does not hold: the text stays, the link goes
            token.attrs = {"class": "file"}
        else:
            token.attrs[name] = value

    def _link(self, page: Page, link: str) -> str | None:
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            return link
        if not parts.path:
            return link
        source = posixpath.normpath(posixpath.join(posixpath.dirname(page.source), unquote(parts.path)))
        if source in self._targets:
            place = _relative(self._targets[source], page.target)
            return place + (f"#{parts.fragment}" if parts.fragment else "")
        if not (self._root / source).exists():
            raise ValueError(f"{page.source}: the link {link} leads nowhere")
        if posixpath.splitext(source)[1].lower() in _PICTURES:
            return self._picture(page, link)
        return None

    def _picture(self, page: Page, link: str) -> str:
        source = posixpath.normpath(posixpath.join(posixpath.dirname(page.source), unquote(link)))
        if not (self._root / source).is_file():
            raise ValueError(f"{page.source}: there is no picture {link}")
        self.pictures.add(source)
        return quote(_relative(_picture_target(source), page.target))

    def _link_of_code(self, page: Page, token: Token) -> None:
        """A page's name in code, `docs/drafts.md`, becomes a link to it."""
        near = posixpath.join(posixpath.dirname(page.source), token.content)
        target = self._targets.get(token.content, self._targets.get(near))
        if target is not None and target != page.target:
            token.type = "html_inline"
            place, shown = _relative(target, page.target), html.escape(token.content)
            token.content = f'<a href="{place}"><code>{shown}</code></a>'


def _picture_target(source: str) -> str:
    return "images/" + source.removeprefix("docs/").removeprefix("images/").replace("/", "-")


def _relative(target: str, page: str) -> str:
    return posixpath.relpath(target, posixpath.dirname(page) or ".")


def _with_children(tokens: Sequence[Token]) -> Iterator[Token]:
    for token in tokens:
        yield token
        yield from _with_children(token.children or ())


def _add_anchors(tokens: Sequence[Token]) -> None:
    """Names of headings, as Markdown viewers make them."""
    seen: dict[str, int] = {}
    for opened, inline in pairwise(tokens):
        if opened.type == "heading_open":
            words = re.sub(r"[^\w\- ]", "", inline.content.lower()).strip().replace(" ", "-")
            count = seen.get(words, 0)
            seen[words] = count + 1
            opened.attrs["id"] = words if count == 0 else f"{words}-{count}"


def build(folder: Path, root: Path = ROOT) -> int:
    """Writes the site into a folder, whole or not at all; returns the number of pages.

    Raises:
        InputError: a folder that cannot be written.
        MissingDependencyError: the editor's page is not built and cannot be.
        ValueError: a link that leads nowhere.
    """
    pages = read_pages(root)
    translator = Translator(pages, root)
    first = session(None, has_python=False)
    cloths = [(entry["id"], entry["name"], entry["description"]) for entry in first["gallery"]]
    groups = [
        (reader, [(page.title, page.target) for page in pages if page.reader == reader]) for reader in _FIRST
    ]
    groups[0][1].insert(0, ("Gallery", "gallery.html"))
    with replacing_folder(folder) as site:
        (site / "live").mkdir()
        copy_client(site / "live", first)
        for name in ("site.css", "live.js"):
            shutil.copyfile(PARTS / name, site / name)
        for number, page in enumerate(pages):
            cloth = cloths[number % len(cloths)]
            _write(
                site, page.target, page_html(page.title, translator.body(page), groups, page.target, [cloth])
            )
        _write(site, "gallery.html", page_html("Gallery", _gallery(cloths), groups, "gallery.html", []))
        for source in translator.pictures:
            target = site / _picture_target(source)
            target.parent.mkdir(exist_ok=True)
            shutil.copyfile(root / source, target)
        write_manifest(site, {"target": "documentation", "pages": len(pages) + 1})
    return len(pages) + 1


def _write(site: Path, target: str, text: str) -> None:
    file = site / target
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def _gallery(cloths: Sequence[tuple[str, str, str]]) -> str:
    return (
        "<h1>Gallery</h1><p>Fabrics that come with the editor; a click opens one there, "
        'where weave, yarns and light can be changed.</p><ul class="gallery">'
        + "\n".join(_gallery_entry(*cloth) for cloth in cloths)
        + "</ul>"
    )


def _gallery_entry(name: str, title: str, about: str) -> str:
    return (
        f'<li><a href="live/index.html?fabric={name}">'
        f'<img src="live/gallery/{name}.webp" alt="" width="320" height="320" loading="lazy">'
        f"<strong>{html.escape(title)}</strong></a><p>{html.escape(about)}</p></li>"
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Builds the site; the exit code is 2 where something is missing."""
    parser = argparse.ArgumentParser(prog="python -m tools.docs.build", description=__doc__)
    parser.add_argument("folder", type=Path, help="new, empty, or an earlier site")
    given = parser.parse_args(arguments)
    try:
        count = build(given.folder)
    except (LoomlightError, ValueError) as error:
        print(f"build_docs: {error}", file=sys.stderr)
        return 2
    print(f"{given.folder}: {count} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
