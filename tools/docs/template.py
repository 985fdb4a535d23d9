"""The frame of every page: navigation by reader, the text, one live cloth."""

from __future__ import annotations

import html
import posixpath
from collections.abc import Sequence

# Reader, and pages as (title, place).
Groups = Sequence[tuple[str, Sequence[tuple[str, str]]]]
# Name, title, description.
Cloth = tuple[str, str, str]


def page_html(title: str, body: str, groups: Groups, target: str, cloths: Sequence[Cloth]) -> str:
    """A whole page.

    Args:
        body: HTML.
        target: the page's place in the site.
        cloths: shown at the end, live where the browser can.
    """
    up = "../" * target.count("/")
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(title if title == "loomlight" else f"{title} – loomlight")}</title>
<link rel="icon" href="{up}live/icon.svg">
<link rel="stylesheet" href="{up}site.css">
<script type="module" src="{up}live.js"></script>
</head>
<body>
<a class="skip" href="#text">To the text</a>
<header>
<a class="name" href="{up}index.html">loomlight</a>
<a class="open" href="{up}live/index.html">Open the editor</a>
</header>
<div class="columns">
<nav aria-label="Pages">{_navigation(groups, target)}</nav>
<main id="text">
{body}
{"".join(_live(cloth, up) for cloth in cloths)}
</main>
</div>
</body>
</html>
"""


def _navigation(groups: Groups, target: str) -> str:
    parts = []
    for reader, pages in groups:
        links = "".join(_entry(title, place, target) for title, place in pages)
        is_open = " open" if any(place == target for _, place in pages) or reader == groups[0][0] else ""
        parts.append(f"<details{is_open}><summary>{html.escape(reader)}</summary><ul>{links}</ul></details>")
    return "\n".join(parts)


def _entry(title: str, place: str, target: str) -> str:
    here = ' aria-current="page"' if place == target else ""
    relative = posixpath.relpath(place, posixpath.dirname(target) or ".")
    return f'<li><a href="{relative}"{here}>{html.escape(title)}</a></li>'


def _live(cloth: Cloth, up: str) -> str:
    name, title, about = cloth
    place = f"{up}live/index.html?fabric={name}"
    picture, shown = f"{up}live/gallery/{name}.webp", html.escape(about)
    return f"""<figure class="live" data-live="{place}&amp;embed=1">
<div class="stage"><img src="{picture}" alt="{shown}" width="320" height="320" loading="lazy"></div>
<figcaption><strong>{html.escape(title)}</strong> {shown}
<a href="{place}">Open it in the editor</a></figcaption>
</figure>
"""
