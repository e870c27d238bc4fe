# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Follows each link, picture, script and style sheet of the site: the file has to be there, and the place in it.

    python3 links.py SITE
"""
import pathlib
import re
import sys
import urllib.parse
from html.parser import HTMLParser

STATE = re.compile(r'^  "([\w-]+)": "atv\w*;', re.MULTILINE)  # one that the playground opens by its name
TAKES = {"a": "href", "link": "href", "img": "src", "script": "src", "iframe": "src", "area": "href"}


class Page(HTMLParser):
    """What a page refers to, and what can be referred to in it."""

    def __init__(self, text):
        super().__init__()
        self.links, self.places = [], set(STATE.findall(text))
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.places.update(given[name] for name in ("id", "name") if given.get(name))
        if tag in TAKES and given.get(TAKES[tag]):
            self.links.append((self.getpos()[0], given[TAKES[tag]]))


def read(site):
    return {path.relative_to(site).as_posix(): Page(path.read_text(encoding="utf-8", errors="strict"))
            for path in sorted(site.rglob("*.html"))}


def broken(site, pages):
    """Each link that leads nowhere, with its place; links out of the site are not followed, and must say so."""
    for name, page in pages.items():
        for line, link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https", "mailto", "data", "javascript"):
                continue
            base = (site / name).parent / urllib.parse.unquote(parts.path) if parts.path else site / name
            target = base.resolve()
            if not target.is_file():
                yield f"{name}:{line}: {link}: no such file"
                continue
            inside = target.relative_to(site).as_posix() if target.is_relative_to(site) else None
            if inside is None:
                yield f"{name}:{line}: {link} leads out of the site"
            elif parts.fragment and inside in pages and urllib.parse.unquote(parts.fragment) not in pages[inside].places:
                yield f"{name}:{line}: {link}: no such place"


def main(place):
    site = pathlib.Path(place).resolve()
    pages = read(site)
    found = list(broken(site, pages))
    count = sum(len(page.links) for page in pages.values())
    print("\n".join(found) or f"{count} links on {len(pages)} pages lead to something")
    return 1 if found or not count else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
