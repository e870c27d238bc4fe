# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Puts the errors of the gallery into the search, which Doxygen fills with names and titles of pages: who types an error is led to
its cause and its remedy, too.

    python3 search.py SITE
"""
import json
import pathlib
import re
import sys

PAGE = "errors.html"
HEADING = re.compile(r'<h[1-6]><a class="anchor" id="(errors-(?:errc-\w+|late-answer))"></a>\s*(.*?)\s*</h[1-6]>', re.DOTALL)
LETTERS = re.compile(r'0: "([^"]*)"')
ENTRIES_BEGIN = "var searchData=\n[\n"
FEWEST = 30  # errors have to be found: less means that the page is made otherwise


def entries(text):
    """What the page explains: the place, and the words to find it by."""
    for anchor, words in HEADING.findall(text):
        yield anchor, re.sub(r" \(0x\w+\)$", "", words)


def spelled(words):
    """As Doxygen's script looks for it."""
    return re.sub(r"[^a-z0-9]", lambda sign: f"_{ord(sign[0]):02x}", words.lower())


def add(place, number, anchor, words):
    """One more result in the list of its first letter."""
    letters = LETTERS.search((place / "searchdata.js").read_text(encoding="utf-8"))[1]
    path = place / f"all_{letters.index(words[0].lower()):x}.js"
    text = path.read_text(encoding="utf-8")
    if ENTRIES_BEGIN not in text:
        raise ValueError(f"{path.name} is no list of results")
    row = [f"{spelled(words)}_e{number}", [words, [f"../{PAGE}#{anchor}", 1, "cause and remedy"]]]
    path.write_text(text.replace(ENTRIES_BEGIN, f"{ENTRIES_BEGIN}  {json.dumps(row)},\n", 1), encoding="utf-8")


def main(site):
    place = pathlib.Path(site)
    found = list(entries((place / PAGE).read_text(encoding="utf-8")))
    for number, (anchor, words) in enumerate(found):
        add(place / "search", number, anchor, words)
    print(f"the search leads to {len(found)} errors")
    return 0 if len(found) >= FEWEST else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
