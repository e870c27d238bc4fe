# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Makes the site's first page of docs/site/first.html, and the picture that others show of a link to it.

    python3 first.py PROJECT SITE

SITE_ADDRESS, where it is set, is the address under which the site will stand: only then is that picture named, which others
find by a whole address alone.
"""
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

from pages import BrokenLink, Pages, html_place
from stage import contents, version

PART = re.compile(r"<!-- (picture|social) -->\n(.*?)<!-- end of \1 -->\n", re.DOTALL)
ADDRESS = re.compile(r"https?://[^/\s\"<>]+(/[^\s\"<>?#]*)?")
# 1200 by 630 pixels, at 100 to the inch: what those who show a link ask for.
SOCIAL = """graph {{ bgcolor="#0f151b"; viewport="864,453.6"; dpi=100; rankdir=LR; nodesep=0.2; ranksep=3.2; labelloc=t; fontname="DejaVu Sans";
fontcolor="#e8eef4"; fontsize=32; label="\\nrtuwire {version}\\nModbus RTU for firmware, a line tool, a gateway\\n\\n ";
node [shape=box, style="rounded", color="#6cb4ff", fontcolor="#e8eef4", fontname="DejaVu Sans", fontsize=30, penwidth=3, margin="0.4,0.3"];
edge [color="#ffd27a", penwidth=4, fontname="DejaVu Sans Mono", fontcolor="#ffd27a", fontsize=18];
client -- drive [label="07 03 0C 82 00 01"]; client -- drive [label="07 03 02 01 F4"]; }}
"""


def sentence_of(readme):
    """What this is, as the README begins."""
    return re.sub(r"\s+", " ", re.search(r"^# [^\n]*\n\n(.*?\.)\s", readme, re.DOTALL)[1]).replace("`", "")


def listed(menu):
    """The contents: each section with its pages."""
    parts = []
    for section, entries in menu:
        rows = "".join(f'<li><a href="{html_place(to.removeprefix("@ref "))}">{html.escape(words)}</a></li>' for words, to in entries)
        parts.append(f"<section><h3>{html.escape(section)}</h3><ul>{rows}</ul></section>")
    return "\n".join(parts)


def words_of(picture):
    """What the picture shows, as it says itself."""
    return re.search(r"<title[^>]*>(.*?)</title>", picture, re.DOTALL)[1]


def size_of(picture):
    """Width and height that the picture has, so that nothing moves when it comes."""
    head = picture[:picture.index(">", picture.index("<svg"))]
    width, height = re.search(r'viewBox="[\d.-]+ [\d.-]+ ([\d.]+) ([\d.]+)"', head).groups()
    return f'width="{round(float(width))}" height="{round(float(height))}"'


def page(text, menu, readme, number, address, picture):
    """The page, without the place of the tool's picture where there is none, or of the other one where no address is known."""
    if address and not ADDRESS.fullmatch(address):
        raise BrokenLink(f"SITE_ADDRESS is '{address}'; the address of the site is a whole one, as https://example.org/rtuwire/")
    has = {"picture": picture, "social": address}
    text = PART.sub(lambda found: found[2] if has[found[1]] else "", text)
    marks = {"sentence": html.escape(sentence_of(readme)), "version": number, "address": html.escape(f"{address.rstrip('/')}/"), "contents": listed(menu), "picture_words": words_of(picture) if picture else "",
             "picture_size": size_of(picture) if picture else ""}
    return re.sub(r"\{(\w+)\}", lambda found: marks.get(found[1], found[0]), text)


def main(project, site):
    project, site = pathlib.Path(project).resolve(), pathlib.Path(site)
    number, sources, pictures = version(project), project / "docs" / "site", project / "docs" / "pictures"
    picture = pictures / "tool.svg"
    pages = Pages(project, {})
    made = page((sources / "first.html").read_text(encoding="utf-8"), contents(pages), pages.texts["README.md"], number,
                os.environ.get("SITE_ADDRESS", ""), picture.read_text(encoding="utf-8") if picture.exists() else "")
    (site / "index.html").write_text(made, encoding="utf-8")
    for name in ("first.css", "find.css", "icon.svg"):
        shutil.copy(sources / name, site)
    if pictures.exists():
        shutil.copytree(pictures, site / "pictures", dirs_exist_ok=True)
    subprocess.run(["dot", "-Tpng", "-o", site / "social.png"], input=SOCIAL.format(version=number), text=True, check=True)
    print(f"the first page: {len(made.encode())} bytes")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except BrokenLink as broken:
        sys.exit(f"docs: {broken}")
