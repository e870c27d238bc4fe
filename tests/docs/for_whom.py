# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds each page to begin with whom it is for: behind the title stands a paragraph that begins so.

    python3 for_whom.py PROJECT
"""
import pathlib
import sys

PAGES = ("docs/*.md", "docs/start/*.md")
LEFT_OUT = {"docs/README.md"}  # the contents
BEGINS = "For whoever "


def complaint(page, text):
    """What is wrong with the beginning of a page; none where it is right."""
    title, *paragraphs = text.split("\n\n")
    if not title.startswith("# ") or "\n" in title:
        return f"{page} does not begin with a title"
    if not paragraphs or not paragraphs[0].startswith(BEGINS):
        return f"{page}: behind its title stands no paragraph that begins with `{BEGINS}`"
    return None


def main(project):
    root = pathlib.Path(project)
    pages = {path.relative_to(root).as_posix(): path for pattern in PAGES for path in sorted(root.glob(pattern))}
    found = [complaint(page, path.read_text(encoding="utf-8")) for page, path in pages.items() if page not in LEFT_OUT]
    print("\n".join(filter(None, found)) or f"{len(found)} pages say whom they are for")
    return 1 if any(found) or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
