# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes what the search of the site finds, which site/site.js looks through: the words of docs/glossary.md, which lead to what we
call it, the errors by name, words and number, the headings of all pages, and the names of the reference.

    python3 search.py SITE TAGS
"""
import html
import json
import pathlib
import re
import sys
import xml.etree.ElementTree

from reference import short, with_ending

ERRORS, GLOSSARY, CHANGES = "errors", "glossary", "changelog"
HEADING = re.compile(r'<h[1-6]><a class="anchor" id="(?P<anchor>[\w-]+)"></a>\s*(?P<words>.*?)\s*</h[1-6]>', re.DOTALL)
TITLE = re.compile(r'<div class="title">(.*?)\s*</div>', re.DOTALL)
ERROR = re.compile(r'id="(?P<anchor>errors-errc-\w+)"></a>\s*<code>(?P<name>\w+)</code>.*?0x(?P<number>[0-9A-F]{2})', re.DOTALL)
ROW = re.compile(r'<tr class="markdownTableRow(?:Odd|Even)">\s*(.*?)\s*</tr>', re.DOTALL)
CELL = re.compile(r"<td[^>]*>(.*?)</td>", re.DOTALL)
FEWEST = {"words": 250, "errors": 50, "headings": 300, "names": 1000}  # less means that a page is made otherwise
# Of two that fit as well the one of the larger rank comes first; what has changed comes behind what is.
RANKS = {"words": 60, "errors": 50, "headings": 30, "names": 20, "changes": -300}


def text_of(markup):
    words = html.unescape(re.sub(r"<[^>]*>", "", markup))
    return " ".join(re.sub(r"</?(?:tt|code)>", "", words).split())


def entry(kind, shown, place, where, words=""):
    """What is shown, the words that find it where they are others, its place, the line below it, its rank."""
    return [shown, "" if words == shown else words, place, where, RANKS[kind]]


def errors(page):
    """Each error: by its name, and an exception by its number."""
    for found in ERROR.finditer(page):
        name, place, number = found["name"], f"{ERRORS}.html#{found['anchor']}", int(found["number"], 16)
        yield entry("errors", name, place, "cause and remedy")
        if 0 < number < 0x80:
            shown = f"exception {number:02X}: {name.replace('_', ' ')}"
            for words in (shown, f"exception code {number:02X}", f"exception 0x{number:02X}", f"exception {number}"):
                yield entry("errors", shown, place, "cause and remedy", words)


def headings(name, page):
    """The headings of a page that the project wrote, alone and behind the page's title."""
    title = text_of(TITLE.search(page)[1])
    own = [found for found in HEADING.finditer(page) if found["anchor"].startswith(f"{name}-")]
    kind = "changes" if name == CHANGES else "headings"
    if own or f'id="{name}"' in page:
        yield entry(kind, title, f"{name}.html", "page")
    for found in own:
        shown, place = text_of(found["words"]), f"{name}.html#{found['anchor']}"
        yield entry(kind, shown, place, title)
        yield entry(kind, shown, place, title, f"{title} {shown}")


def rows(page):
    """The rows of the glossary: its words, what it is here, and the place that the last column links to."""
    for row in ROW.findall(page):
        cells = CELL.findall(row)
        link = re.search(r'href="([^"]+)"', cells[-1])
        if len(cells) != 3 or not link:
            raise ValueError(f"{GLOSSARY}: a row without a link: {text_of(row)}")
        yield text_of(cells[0]).split(", "), cells[1], html.unescape(link[1])


def glossary(page):
    """Each word of the glossary, which leads to the page of its row."""
    for words, meaning, place in rows(page):
        for word in words:
            yield entry("words", word, place, text_of(meaning))


def without_answer(site, page):
    """The rows of which the page that they lead to has no word: none of the first column, and no code or mnemonic of the second."""
    for words, meaning, place in rows(page):
        told = text_of((site / place.partition("#")[0]).read_text(encoding="utf-8"))
        ours = [text_of(code) for code in re.findall(r"<code>(.*?)</code>", meaning)] + re.findall(r"\b[A-Z]{3,}\b", text_of(meaning))
        if not any(re.search(rf"(?<!\w){re.escape(word)}(?!\w)", told, re.IGNORECASE) for word in (*words, *ours)):
            yield f"{place} has nothing of '{', '.join(words)}'"


def names(tags):
    """The names of the reference, each with the class or the namespace that has it; overloads once."""
    seen = set()
    for compound in xml.etree.ElementTree.parse(tags).getroot():
        kind, path, page = compound.get("kind"), compound.findtext("name"), with_ending(compound.findtext("filename"))
        if kind not in ("namespace", "struct", "class", "concept"):
            continue
        if kind != "namespace":
            yield entry("names", short(path), page, f"{kind}, reference")
        for member in compound.findall("member"):
            name, owner = member.findtext("name"), short(path) if kind != "namespace" else path
            if (name, owner) not in seen and not name.startswith(("operator", "~")):
                seen.add((name, owner))
                place = f"{with_ending(member.findtext('anchorfile'))}#{member.findtext('anchor')}"
                yield entry("names", name, place, f"{member.get('kind')} of {owner}, reference", f"{name} {owner}")


def main(site, tags):
    site = pathlib.Path(site)
    pages = {path.stem: path.read_text(encoding="utf-8") for path in sorted(site.glob("*.html"))}
    found = {"words": list(glossary(pages[GLOSSARY])), "errors": list(errors(pages[ERRORS])),
             "headings": [each for name, page in pages.items() if TITLE.search(page) for each in headings(name, page)],
             "names": list(names(tags))}
    empty = list(without_answer(site, pages[GLOSSARY]))
    if empty:
        print("\n".join(empty))
        return 1
    entries = ",\n".join(json.dumps(each, ensure_ascii=False, separators=(",", ":")) for kind in found.values() for each in kind)
    (site / "search.js").write_text(f"window.searchIndex = [\n{entries}\n];\n", encoding="utf-8")
    print("the search leads to " + ", ".join(f"{len(each)} {kind}" for kind, each in found.items()))
    return 0 if all(len(found[kind]) >= least for kind, least in FEWEST.items()) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
