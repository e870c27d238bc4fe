# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Each drive's page has the paragraphs of docs/generate/drive_page.txt, in their order, with what the drive has of its own at the
dots; and shows all that the program beside it does.

    python3 drive_pages.py PROJECT
"""
import pathlib
import re
import sys

SHOWN = re.compile(r"^<!-- snippet: docs/snippets/(\w+)\.cpp (\w+) -->$", re.MULTILINE)
REGION = re.compile(r"^ *//! \[(\w+)\]$", re.MULTILINE)
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
OWN = "{...}"


def paragraphs(text):
    """Without code, which its program holds, and without regard to the ends of lines."""
    return [" ".join(each.split()) for each in re.split(r"\n\s*\n", CODE.sub("", text)) if each.strip()]


def template(text):
    return [each for each in paragraphs(text) if not each.startswith("# SPDX")]


def pattern(paragraph, page):
    return re.compile(".*".join(map(re.escape, paragraph.replace("{page}", page).split(OWN))), re.DOTALL)


def unlike(wanted, found, page):
    """The first paragraph that the page lacks or has beside the template; none where it is made of it."""
    at, may_have_own = 0, False
    for each in wanted:
        if each == OWN:
            may_have_own = True
            continue
        fitting = pattern(each, page)
        last = len(found) if may_have_own else min(at + 1, len(found))
        fits = next((place for place in range(at, last) if fitting.fullmatch(found[place])), None)
        if fits is None:
            return f"lacks '{each[:90]}'" + ("" if may_have_own or at >= len(found) else f" where it has '{found[at][:90]}'")
        at, may_have_own = fits + 1, False
    return "" if may_have_own or at == len(found) else f"has more than its template: '{found[at][:90]}'"


def wrong(page, text, program, wanted):
    """What a page lacks."""
    for region in dict.fromkeys(REGION.findall(program)):
        if (page.stem, region) not in SHOWN.findall(text):
            yield f"{page.name}: does not show [{region}] of its program"
    difference = unlike(wanted, paragraphs(text), page.stem)
    if difference:
        yield f"{page.name}: {difference}"


def main(place):
    project = pathlib.Path(place).resolve()
    wanted = template((project / "docs/generate/drive_page.txt").read_text(encoding="utf-8"))
    pages = sorted((project / "docs" / "drives").glob("*.md"))
    found = [each for page in pages for each in wrong(page, page.read_text(encoding="utf-8"),
             (project / "docs" / "snippets" / f"{page.stem}.cpp").read_text(encoding="utf-8"), wanted)]
    print("\n".join(found) or f"{len(pages)} pages of drives")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
