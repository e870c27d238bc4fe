# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Puts more into the search, which Doxygen fills with names of C++ and titles of pages: the headings of all pages by each of their
words, the errors by name, words and number, and the words of docs/glossary.md, which lead to what we call it.

    python3 search.py SITE
"""
import html
import json
import pathlib
import re
import shutil
import sys

ERRORS, GLOSSARY, CHANGES = "errors", "glossary", "changelog"
HEADING = re.compile(r'<h[1-6]><a class="anchor" id="(?P<anchor>[\w-]+)"></a>\s*(?P<words>.*?)\s*</h[1-6]>', re.DOTALL)
TITLE = re.compile(r'<div class="title">(.*?)\s*</div>', re.DOTALL)
ERROR = re.compile(r"errors-(?:errc-\w+|late-answer)")
ROW = re.compile(r'<tr class="markdownTableRow(?:Odd|Even)">\s*(.*?)\s*</tr>', re.DOTALL)
CELL = re.compile(r"<td[^>]*>(.*?)</td>", re.DOTALL)
LETTERS = re.compile(r'(0: ")([^"]*)(")')
ENTRIES_BEGIN = "var searchData=\n[\n"
SMALL = frozenset("a an and are as at by does for from in is it its of on one or that the to what when where which who with".split())
FEWEST = {"errors": 30, "headings": 150, "words": 150}  # less means that a page is made otherwise


def text_of(markup):
    words = html.unescape(re.sub(r"<[^>]*>", "", markup))
    return " ".join(re.sub(r"</?(?:tt|code)>", "", words).split())


def entry(words, shown, place, scope):
    return {"words": words, "shown": shown, "place": place, "scope": scope}


def by_each_word(words):
    """A sentence from each of its words on: the search compares beginnings."""
    parts = re.split(r"[\s_]+", words)
    for at, part in enumerate(parts):
        bare = re.sub(r"^\W+", "", part)
        if bare and (at == 0 or bare.lower() not in SMALL):
            yield " ".join([bare, *parts[at + 1:]])


def errors(page):
    """Each error: by its name, by its words, and an exception by its number."""
    for found in HEADING.finditer(page):
        if not ERROR.fullmatch(found["anchor"]):
            continue
        name, _, code = text_of(found["words"]).partition(" (0x")
        place = f"{ERRORS}.html#{found['anchor']}"
        if "_" in name:
            yield entry(name, name, place, "cause and remedy")
        for words in by_each_word(name):
            yield entry(words, name, place, "cause and remedy")
        number = int(code.rstrip(")"), 16) if code else 0
        if 0 < number < 0x80:
            shown = f"exception {number:02X}: {name.replace('_', ' ')}"
            for words in (shown, f"exception code {number:02X}", f"exception 0x{number:02X}", f"exception {number}"):
                yield entry(words, shown, place, "cause and remedy")


def headings(name, page):
    """The headings of a page that the project wrote, by each word, and behind the page's title."""
    title = text_of(TITLE.search(page)[1])
    own = [found for found in HEADING.finditer(page) if found["anchor"].startswith(f"{name}-") and not ERROR.fullmatch(found["anchor"])]
    if not own:
        return
    for words in by_each_word(title):
        yield entry(words, title, f"{name}.html", "page")
    for found in own:
        shown, place = text_of(found["words"]), f"{name}.html#{found['anchor']}"
        for words in (*by_each_word(shown), f"{title} {shown}"):
            yield entry(words, shown, place, title)


def in_order(names):
    """The pages of which each name is; what has changed comes behind what is."""
    return sorted(names, key=lambda name: (name == CHANGES, name))


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
            for begin in by_each_word(word):
                yield entry(begin, word, place, text_of(meaning))


def without_answer(site, page):
    """The rows of which the page that they lead to has no word: none of the first column, and no code or mnemonic of the second."""
    for words, meaning, place in rows(page):
        told = text_of((site / place.partition("#")[0]).read_text(encoding="utf-8"))
        ours = [text_of(code) for code in re.findall(r"<code>(.*?)</code>", meaning)] + re.findall(r"\b[A-Z]{3,}\b", text_of(meaning))
        if not any(re.search(rf"(?<!\w){re.escape(word)}(?!\w)", told, re.IGNORECASE) for word in (*words, *ours)):
            yield f"{place} has nothing of '{', '.join(words)}'"


def spelled(words):
    """As Doxygen's script looks for it."""
    return re.sub(r"[^a-z0-9]", lambda sign: f"_{ord(sign[0]):02x}", words.lower())


def list_of(place, letter):
    """The file of all results that begin with a letter; a new one where there was none."""
    data = place / "searchdata.js"
    text = data.read_text(encoding="utf-8")
    letters = LETTERS.search(text)[2]
    if letter not in letters:
        data.write_text(LETTERS.sub(lambda found: f"{found[1]}{letters}{letter}{found[3]}", text, count=1), encoding="utf-8")
        number = f"{len(letters):x}"
        (place / f"all_{number}.js").write_text(f"{ENTRIES_BEGIN}];\n", encoding="utf-8")
        shutil.copy(place / "all_0.html", place / f"all_{number}.html")
        page = (place / f"all_{number}.html").read_text(encoding="utf-8")
        (place / f"all_{number}.html").write_text(page.replace("all_0.js", f"all_{number}.js"), encoding="utf-8")
        letters += letter
    return place / f"all_{letters.index(letter):x}.js"


def add(place, entries):
    """More results, each in the list of its first letter, before those that are there."""
    lists = {}
    for number, each in enumerate(entries):
        row = [f"{spelled(each['words'])}_e{number}", [each["shown"], [f"../{each['place']}", 1, each["scope"]]]]
        lists.setdefault(each["words"][0].lower(), []).append(f"  {json.dumps(row)}")
    for letter, rows in lists.items():
        path = list_of(place, letter)
        text = path.read_text(encoding="utf-8")
        if ENTRIES_BEGIN not in text:
            raise ValueError(f"{path.name} is no list of results")
        rest = text.partition(ENTRIES_BEGIN)[2]
        more = ",\n".join(rows) + ("\n" if rest.startswith("]") else ",\n")
        path.write_text(text.replace(ENTRIES_BEGIN, ENTRIES_BEGIN + more, 1), encoding="utf-8")


def main(site):
    site = pathlib.Path(site)
    pages = {path.stem: path.read_text(encoding="utf-8") for path in sorted(site.glob("*.html"))}
    found = {"words": list(glossary(pages[GLOSSARY])), "headings": [each for name in in_order(pages) if TITLE.search(pages[name])
                                                                    for each in headings(name, pages[name])],
             "errors": list(errors(pages[ERRORS]))}
    empty = list(without_answer(site, pages[GLOSSARY]))
    if empty:
        print("\n".join(empty))
        return 1
    add(site / "search", [each for kind in found.values() for each in kind])
    print("the search leads to " + ", ".join(f"{len(each)} {kind}" for kind, each in found.items()))
    return 0 if all(len(found[kind]) >= least for kind, least in FEWEST.items()) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
