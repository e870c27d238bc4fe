# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Each link of a page leads somewhere on a git host: its file is in the tree, and its anchor is that of a heading by a git host's
rules. On the site, links.py follows them.

    python3 page_links.py PROJECT
"""
import collections
import os
import pathlib
import re
import sys

FENCE = re.compile(r"^ *(`{3,}|~{3,})")
HEADING = re.compile(r"^#{1,6} +(.*?) *#*$")
LINK = re.compile(r"\]\(\s*<?([^)\s>]*)>?[^)]*\)")
TAG = re.compile(r"<(?:a|img|source)\b[^>]*?\b(?:href|src|srcset)=\"([^\"]*)\"")
REFERENCE = re.compile(r"^\[[^\]]+\]: +(\S+)")
PLACE = re.compile(r"<a\b[^>]*?\b(?:id|name)=\"([^\"]+)\"")
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)")


def prose(text):
    """Each line that is no code, with its number."""
    fence = ""
    for number, line in enumerate(text.split("\n"), 1):
        found = FENCE.match(line)
        if fence:
            if found and found[1].startswith(fence) and not line.strip(" `~"):
                fence = ""
        elif found:
            fence = found[1]
        else:
            yield number, line


def anchor(heading):
    """The anchor of the words that a reader sees: small letters, digits, `_` and `-`, and `-` for a space."""
    seen = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    seen = re.sub(r"(?<!\w)_([^_]+)_(?!\w)", r"\1", seen.replace("`", "").replace("*", ""))
    return "".join("-" if each == " " else each for each in seen.lower() if each.isalnum() or each in " -_")


def anchors(text):
    """All of a page. A heading whose words an earlier one has gets a number."""
    count, found = collections.Counter(), set()
    for _, line in prose(text):
        found.update(PLACE.findall(line))
        if heading := HEADING.match(line):
            name = anchor(heading[1])
            found.add(f"{name}-{count[name]}" if count[name] else name)
            count[name] += 1
    return found


def links(text):
    for number, line in prose(text):
        plain = CODE.sub(lambda each: "x" * len(each[0]), line)
        for link in [*LINK.findall(plain), *TAG.findall(plain), *REFERENCE.findall(plain)]:
            yield number, link


def has_exactly(project, path):
    """Whether the tree has it, with these capital letters."""
    place = project
    for part in path.split("/"):
        if part not in os.listdir(place) if place.is_dir() else True:
            return False
        place /= part
    return True


def broken(project, pages):
    """What leads nowhere. PAGES: texts by their paths."""
    for page, text in pages.items():
        for number, link in links(text):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, place = link.partition("#")
            whole = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            wrong = ""
            if whole.startswith("..") or path.startswith("/"):
                wrong = "leads out of the tree"
            elif whole != "." and not has_exactly(project, whole):
                wrong = "no such file"
            elif whole.split("/")[0] == "build":
                wrong = "is built, and not in the tree"
            elif place and place not in (anchors(pages[whole]) if whole in pages else ()):
                wrong = "no such heading"
            if wrong:
                yield f"{page}:{number}: {link}: {wrong}"


def pages_of(project):
    """All pages of the tree."""
    found = {}
    for folder, inside, files in os.walk(project):
        place = pathlib.Path(folder).relative_to(project).as_posix()
        inside[:] = [] if place == "build" else sorted(each for each in inside if each not in (".git", "node_modules"))
        for name in sorted(each for each in files if each.endswith(".md")):
            found[name if place == "." else f"{place}/{name}"] = (pathlib.Path(folder) / name).read_text(encoding="utf-8")
    return found


def main(place):
    project = pathlib.Path(place).resolve()
    sys.path.insert(0, str(project / "docs" / "generate"))
    from pages import headings, slug  # of the site: it has to name headings as git hosts do
    pages = pages_of(project)
    found = list(broken(project, pages))
    found += [f"{page}: the site calls '{words}' #{slug(words)}, a git host #{anchor(words)}"
              for page, text in pages.items() for _, words in headings(text) if slug(words) != anchor(words)]
    count = sum(not re.match(r"[a-z]+:", link) for text in pages.values() for _, link in links(text))
    print("\n".join(found) or f"{count} links of {len(pages)} pages")
    return 1 if found or count < 300 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
