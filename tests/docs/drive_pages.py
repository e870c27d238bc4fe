# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Each drive's page shows all that the program beside it does, and says how a program begins and leaves that drive.

    python3 drive_pages.py PROJECT
"""
import pathlib
import re
import sys

SHOWN = re.compile(r"^<!-- snippet: docs/snippets/(\w+)\.cpp (\w+) -->$", re.MULTILINE)
REGION = re.compile(r"^ *//! \[(\w+)\]$", re.MULTILINE)
SECTION = re.compile(r"^## Begin and leave\n(.*?)^## ", re.MULTILINE | re.DOTALL)
# The fault that a silent line ends in; what resets it; what is never changed to avoid it.
SAID = ("SLF", "`reset_fault`", "--write reset", "keypad", "Nothing is changed in order to leave")


def wrong(page, text, program):
    """What a page lacks."""
    for region in dict.fromkeys(REGION.findall(program)):
        if (page.stem, region) not in SHOWN.findall(text):
            yield f"{page.name}: does not show [{region}] of its program"
    section = SECTION.search(text)
    said = " ".join(section[1].split()) if section else ""
    for each in SAID:
        if each not in said:
            yield f"{page.name}: does not say {each!r}, of how to begin and leave"


def main(place):
    project = pathlib.Path(place).resolve()
    pages = sorted((project / "docs" / "drives").glob("*.md"))
    found = [each for page in pages for each in wrong(page, page.read_text(encoding="utf-8"),
             (project / "docs" / "snippets" / f"{page.stem}.cpp").read_text(encoding="utf-8"))]
    print("\n".join(found) or f"{len(pages)} pages of drives")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
