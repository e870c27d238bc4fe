# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The pages as Doxygen reads them. A page in the repository is plain Markdown that a git host shows, too; here it gets names for
its headings, its links lead to pages of the site, and its marks are replaced:

    <!-- snippet: examples/03_poll_a_drive.cpp plan -->   the region of that name stands in the block of code behind it
    <!-- made: registers atv320 -->                        what the build makes stands here; what is kept for git hosts, up to
                                                           `<!-- end -->`, is left out (tables_in_pages.py makes it)
"""
import os
import re

FENCE = re.compile(r"^( *)(```+)(.*)$")
HEADING = re.compile(r"^(#{1,4}) +(.*?)\s*$")
PICTURE = re.compile(r"!\[([^\]]*)\]\((?:[\w./]*/)?pictures/([\w.-]+)\)")
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")
SNIPPET = re.compile(r"^ *<!-- snippet: (\S+) (\S+) -->$")
MADE = re.compile(r"^<!-- made: (.+?) -->$")
END = "<!-- end -->"
FILE_NAME = re.compile(r"[\w/.-]+\.md|docs/")
NEEDS_CONTENTS = 5


class BrokenLink(Exception):
    """A link or a mark that leads nowhere; the text says where it stands."""


def identifier(path):
    """The name of a page on the site: docs/start/wiring.md is start_wiring."""
    if path == "README.md":
        return "readme"
    plain = re.sub(r"(^docs/|/?README\.md$|\.md$)", "", path)
    return re.sub(r"\W", "_", plain).lower() or "contents"


def slug(heading):
    """The anchor that git hosts make of a heading."""
    plain = re.sub(r"[`*]|\]\([^)]*\)|\[", "", heading).lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def lines_with_code(text):
    """Each line, and whether it stands in a block of code."""
    closing = ""
    for line in text.split("\n"):
        fence = FENCE.match(line)
        if closing:
            yield line, True
            if fence and fence[2] == closing and not fence[3].strip():
                closing = ""
        else:
            closing = fence[2] if fence else ""
            yield line, bool(fence)


def headings(text):
    return [(len(found[1]), found[2]) for line, is_code in lines_with_code(text)
            if not is_code and (found := HEADING.match(line))]


def spelled(line):
    """Code in a line as Doxygen takes it whatever stands in it: between two backticks."""
    return re.sub(r"(?<!`)`([^`]+)`(?!`)", r"``\1``", line)


class Bold:
    """`**` as tags: Doxygen leaves them as they are where they touch code, a quote or a bracket. Bold goes on over the end of a
    line, not over that of a paragraph."""

    def __init__(self, page):
        self.page = page
        self.is_open = False

    def tag(self, _):
        self.is_open = not self.is_open
        return "<b>" if self.is_open else "</b>"

    def line(self, text):
        parts = re.split(r"(`+[^`]*`+)", text)
        parts[::2] = [re.sub(r"\*\*", self.tag, part) for part in parts[::2]]
        if self.is_open and (not text.strip() or text.startswith("|")):
            raise BrokenLink(f"{self.page}: bold that does not end: {text or 'before an empty line'}")
        return "".join(parts)


def title_of(text):
    return next(words for level, words in headings(text) if level == 1)


def plain(page, heading):
    """A heading without marks of code: Doxygen shows them as they are, in the list of contents and in the search."""
    words = heading.replace("`", "")
    if words != heading and re.search(r"[<>*&\\]", words):
        raise BrokenLink(f"{page}: a heading with code that is more than a name: {heading}")
    return words


class Pages:
    """All pages of the project by their path, and what links between them become."""

    def __init__(self, project, made):
        self.project = project
        self.made = made  # what the build makes, by the words of its mark
        self.used = set()
        self.regions = set()  # of programs, as (file, name)
        paths = [project / "README.md", project / "CHANGELOG.md", *sorted((project / "docs").rglob("*.md"))]
        self.texts = {path.relative_to(project).as_posix(): path.read_text(encoding="utf-8")
                      for path in paths if path.exists()}
        self.programs = {path.relative_to(project).as_posix() for folder in ("examples", "examples/boards")
                         for path in (project / folder).glob("*.cpp")}

    def target(self, page, link):
        """What a link of a page becomes; none where the site has no such page, and the project does."""
        if re.match(r"[a-z]+:", link):
            return link
        path, _, anchor = link.partition("#")
        whole = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if (self.project / whole).is_dir() and f"{whole}/README.md" in self.texts:
            whole = f"{whole}/README.md"
        if whole in self.texts:
            if anchor and anchor not in {slug(words) for _, words in headings(self.texts[whole])}:
                raise BrokenLink(f"{page}: {link}: {whole} has no heading #{anchor}")
            return f"@ref {self.anchor(whole, anchor)}"
        if whole in self.programs and not anchor:
            return f"@ref {identifier(whole)}"
        if not (self.project / whole).exists():
            raise BrokenLink(f"{page}: {link}: there is no {whole}")
        return None

    def named(self, words, reference):
        """What a link shows: where it shows a file's name here, the title of the page there."""
        if not FILE_NAME.fullmatch(words):
            return words
        return next(title_of(text) for page, text in self.texts.items() if identifier(page) == reference.partition("-")[0])

    @staticmethod
    def anchor(page, heading):
        return f"{identifier(page)}-{heading}" if heading else identifier(page)

    def linked(self, page, line):
        codes = [found.span() for found in re.finditer(r"`[^`]+`", line)]

        def swap(found):
            if any(begin < found.start() < end for begin, end in codes):
                return found[0]
            words, link = found.groups()
            to = self.target(page, link)
            if to is None:
                return words if words.startswith("`") else f"`{words}`"
            # Doxygen's references take plain words only.
            if to.startswith("@ref "):
                shown = re.sub(r"`([^`]*)`", r"<code>\1</code>", self.named(words, to[5:]))
                return f'<a href="{html_place(to[5:])}">{shown}</a>'
            return f"[{words}]({to})"
        return spelled(LINK.sub(swap, PICTURE.sub(r'<img src="pictures/\2" alt="\1"/>', line)))

    def staged(self, page):
        """The page for Doxygen."""
        text = self.texts[page]
        has_contents = len(headings(text)) > NEEDS_CONTENTS
        out, snippet, bold, made = [], None, Bold(page), None
        for line, is_code in lines_with_code(text):
            if made:
                made = None if line == END and not is_code else made
                continue
            if is_code:
                if snippet:
                    snippet = self.skip_block(line, snippet, out)
                else:
                    out.append(line)
                continue
            mark = SNIPPET.match(line)
            if mark:
                snippet = mark.groups()
                self.regions.add(snippet)
                continue
            made = MADE.match(line)
            if made:
                out += self.generated(page, made[1])
                continue
            heading = HEADING.match(line)
            if heading and len(heading[1]) == 1:
                out.append(f"# {plain(page, heading[2])} {{#{identifier(page)}}}")
                if has_contents:
                    out += ["", "[TOC]", ""]
            elif heading:
                out.append(f"{heading[1]} {plain(page, heading[2])} {{#{self.anchor(page, slug(heading[2]))}}}")
            else:
                out.append(self.linked(page, bold.line(line)))
        if made:
            raise BrokenLink(f"{page}: behind '{made[0]}' there is no '{END}'")
        return "\n".join(out)

    @staticmethod
    def skip_block(line, snippet, out):
        """Leaves out a block of code that Doxygen takes from its file; the end of it gives the command."""
        fence = FENCE.match(line)
        if fence and not fence[3].strip():
            out.append(f"\\snippet {snippet[0]} {snippet[1]}")
            return None
        return snippet

    def generated(self, page, words):
        if words not in self.made:
            raise BrokenLink(f"{page}: nothing makes '{words}'")
        self.used.add(words)
        return self.made[words].split("\n")


def html_place(reference):
    """The file, and the place in it, that a name on the site has."""
    page, dash, heading = reference.partition("-")
    return f"{page}.html#{reference}" if dash else f"{page}.html"
