# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Makes a link of each name on the page of public names, where the reference has it; and of links to places that Doxygen does not
make (operators that are friends, in its lists of members), words.

    python3 reference.py SITE TAGS
"""
import html
import pathlib
import re
import sys
import xml.etree.ElementTree

PAGE = "names.html"
CODE = re.compile(r"<code>([^<>\s]+)</code>")
MEMBER = re.compile(r'<a class="el" href="([^"#]+)#([^"]+)">(.*?)</a>')
FEWEST = 250  # of the names have to be found: less means that the reference lost some


def places(tags):
    """Where each name is, by its path without the outer namespace."""
    found = {}
    for compound in xml.etree.ElementTree.parse(tags).getroot():
        if compound.get("kind") not in ("namespace", "struct", "class", "concept"):
            continue
        path, page = compound.findtext("name"), compound.findtext("filename")
        if compound.get("kind") != "namespace":
            found.setdefault(short(path), with_ending(page))
        for member in compound.findall("member") if compound.get("kind") == "namespace" else ():
            anchor = f"{with_ending(member.findtext('anchorfile'))}#{member.findtext('anchor')}"
            found.setdefault(short(f"{path}::{member.findtext('name')}"), anchor)
    return found


def with_ending(page):
    return page if page.endswith(".html") else f"{page}.html"


def short(path):
    return re.sub(r"^rtuwire::(literals::)?", "", re.sub(r"<.*", "", path).replace(" ", ""))


def without_dead_links(site, path):
    """Leaves the words of a link to a place that its page does not have."""
    count = 0

    def swap(link):
        nonlocal count
        target = site / link[1]
        if target.exists() and f'id="{link[2]}"' in target.read_text(encoding="utf-8"):
            return link[0]
        count += 1
        return link[3]
    text = path.read_text(encoding="utf-8")
    path.write_text(MEMBER.sub(swap, text), encoding="utf-8")
    return count


def main(site, tags):
    page, known = pathlib.Path(site, PAGE), places(tags)
    seen, lost = set(), set()

    def swap(code):
        name = html.unescape(code[1])
        if name not in known:
            lost.add(name)
            return code[0]
        seen.add(name)
        return f'<a class="code" href="{known[name]}">{code[0]}</a>'
    page.write_text(CODE.sub(swap, page.read_text(encoding="utf-8")), encoding="utf-8")
    unlinked = sum(without_dead_links(pathlib.Path(site), each) for each in pathlib.Path(site).glob("*-members.html"))
    print(f"{len(seen)} names lead to the reference, {len(lost)} words of code have no place there; {unlinked} links of lists "
          "of members led nowhere")
    return 0 if len(seen) >= FEWEST else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
