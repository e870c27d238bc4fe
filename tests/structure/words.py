# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Keeps words of the field in the code: names that nobody else in the field uses are reported with the one to take.

    python3 words.py PROJECT
"""
import pathlib
import re
import sys

FOLDERS = ("include", "tests", "examples", "bench", "fuzz")
# Pages, of which what stands in code is read; CHANGELOG.md, which lists old names beside new ones, is none of them.
PAGES = ("README.md", "docs/**/*.md")
CODE = re.compile(r"```.*?```|`[^`\n]+`", re.DOTALL)

# Parts of an identifier, between underscores, in any letters: what to take instead.
PARTS = {
    "octet": "byte", "octets": "bytes", "question": "request", "questions": "requests", "talk": "conversation",
    "talks": "conversations", "wish": "action", "wishes": "actions", "deed": "access", "deeds": "accesses",
    "ear": "listener", "ears": "listeners", "twitch": "glitch", "dice": "random_source", "patience": "retry_policy",
    "stranger": "foreign_unit", "strangers": "foreign_units",
}
# What no comment says either.
COMMENTS = re.compile(r"\b(octets?|talks?|talked|wish(?:es|ed)?|deeds?|ears?|twitch(?:es)?|dice|patience|strangers?)\b",
                      re.IGNORECASE)
# Comments, string literals, #include lines, and what is left: code.
PIECES = re.compile(r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<other>"(?:\\.|[^"\\\n])*"|^[ \t]*#[ \t]*include[^\n]*)'
                    r"|(?P<name>[A-Za-z_]\w*)", re.DOTALL | re.MULTILINE)


def instead_of(name):
    """What to take instead of an identifier; none where it may stay."""
    parts = [PARTS.get(part.lower()) for part in name.split("_")]
    return next((part for part in parts if part), None)


def complaints(path, text):
    """What a file says in words of nobody's."""
    for piece in PIECES.finditer(text):
        line = text.count("\n", 0, piece.start()) + 1
        if piece["comment"]:
            for found in COMMENTS.findall(piece["comment"]):
                yield f"{path}:{line}: the comment says \"{found}\""
        elif piece["name"] and instead_of(piece["name"]):
            yield f"{path}:{line}: {piece['name']}, for which the field says {instead_of(piece['name'])}"


def complaints_of_page(path, text):
    """The same of a page's code: its blocks, and what stands between backticks."""
    for code in CODE.finditer(text):
        before = text.count("\n", 0, code.start())
        yield from complaints(path, "\n" * before + code.group())


def main(project):
    root = pathlib.Path(project)
    found, files = [], 0
    for page in (page for pattern in PAGES for page in sorted(root.glob(pattern))):
        found += complaints_of_page(page.relative_to(root), page.read_text(encoding="utf-8"))
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            files += 1
            found += complaints(path.relative_to(root), path.read_text(encoding="utf-8"))
    print("\n".join(found) or f"{files} files are in words of the field")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
