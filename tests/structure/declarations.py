# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Finds what a header declares in its namespaces: a reader of braces and first words, not a compiler."""
import re
from dataclasses import dataclass

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*',
                      re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"\s*(inline\s+)?namespace\b(?P<path>[\s\w:]*)\Z")
AGGREGATE = re.compile(r"(class|struct|union|enum)\b")


@dataclass(frozen=True)
class Declaration:
    """A name that a namespace holds: `kind` is type, alias, concept, function or object; `comment` stands before it."""
    space: str
    name: str
    kind: str
    comment: str
    line: int
    end: int

    def path(self):
        return "::".join(part for part in (self.space, self.name) if part)


def code_of(text):
    """The text with blanks for comments, literals and directives; each place stays where it was."""
    def blank(found):
        piece = found.group()
        return "".join(letter if letter == "\n" else " " for letter in piece) if piece[0] != '"' else \
            '"' + " " * (len(piece) - 2) + '"'
    return NOT_CODE.sub(blank, text)


def namespace_of(head):
    """The namespace that these words open; none where they open none. An inline one has no name here."""
    found = NAMESPACE.match(head)
    if not found:
        return None
    parts = re.sub(r"\s*::\s*", "::", found["path"].strip()).split("::")
    named = [part for part in parts if not part.startswith("inline ")]
    return "::".join(named) if not found[1] else ""


def statements(code):
    """What stands in namespaces: the namespace, and from where to where it goes."""
    spaces, depth, begin = [], 0, 0
    for at, letter in enumerate(code):
        if letter == "{":
            opened = namespace_of(code[begin:at]) if depth == 0 else None
            if opened is not None:
                spaces.append(opened)
                begin = at + 1
            else:
                depth += 1
        elif letter == "}" and depth == 0:
            if spaces:
                spaces.pop()
            begin = at + 1
        elif letter == "}":
            depth -= 1
            if depth == 0 and ends_without_semicolon(code[begin:at]):
                yield "::".join(filter(None, spaces)), begin, at + 1
                begin = at + 1
        elif letter == ";" and depth == 0:
            yield "::".join(filter(None, spaces)), begin, at + 1
            begin = at + 1


def ends_without_semicolon(words):
    """Whether a closing brace ends it: a function's does, that of a type, a concept or a value does not."""
    head = declared(words)
    if head.count("(") > head.count(")"):
        return False
    before = parameters_cut(head).partition("{")[0]
    if AGGREGATE.match(head) or head.startswith("concept"):
        return False
    return ")" in before and not re.search(r"[^=!<>]=[^=]", before)


def parameters_cut(words):
    """Words with nothing between brackets."""
    kept, depth = [], 0
    for letter in words:
        depth -= letter == ")"
        if depth == 0:
            kept.append(letter)
        depth += letter == "("
    return "".join(kept)


def angles_cut(words):
    """Words without template arguments."""
    while True:
        shorter = re.sub(r"<[^<>()]*(\([^()]*\)[^<>()]*)*>", "", words)
        if shorter == words:
            return words
        words = shorter


def declared(words):
    """A declaration without its template heads, constraints and attributes."""
    words = words.strip()
    while True:
        if re.match(r"template\s*<", words):
            words = words[closing_angle(words):].lstrip()
        elif words.startswith("requires"):
            starts = re.search(r"[\s)>](?=(struct|class|inline|constexpr|consteval|using|auto|\[\[)\b)", words)
            if not starts:
                return words
            words = words[starts.end():].lstrip()
        elif words.startswith("[["):
            words = words[words.index("]]") + 2:].lstrip()
        else:
            return words


def closing_angle(words):
    depth = 0
    for at, letter in enumerate(words):
        if letter == "<":
            depth += 1
        elif letter == ">" and words[at - 1] != "-":
            depth -= 1
            if depth == 0:
                return at + 1
    return len(words)


def name_of(words):
    """Kind and name of a declaration; none where it declares nothing new."""
    head = declared(words)
    if not head or head.startswith(("static_assert", "friend", "using namespace", "extern")):
        return None
    found = re.match(r"(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[.*?\]\]\s*)?(\w+)\s*(.*)", head, re.DOTALL)
    if found:
        is_new = "{" in found[2] and not found[2].startswith(("<", "::"))
        return ("type", found[1]) if is_new else None
    found = re.match(r"using\s+(\w+)\s*=", head) or re.match(r"using\s+[\w:]*?(\w+)\s*;", head)
    if found:
        return "alias", found[1]
    found = re.match(r"concept\s+(\w+)", head)
    if found:
        return "concept", found[1]
    found = re.search(r"\boperator\s*(\"\s*\"\s*_\w+)", head)
    if found:
        return "function", "operator" + re.sub(r"\s", "", found[1])
    if re.search(r"\boperator\b", head):
        return None
    return value_or_function(angles_cut(head.split("{")[0]))


def value_or_function(head):
    found = re.match(r"[^(=]*?(\w+)\s*(?:\[[^\]]*\]\s*)?(\(|=|;|$)", head.strip(), re.DOTALL)
    if not found or re.search("::" + found[1] + r"\b", head.split("(")[0]):
        return None
    return ("function" if found[2] == "(" else "object"), found[1]


def comment_before(text, begin):
    """The `///` lines right before a place."""
    lines = []
    for line in reversed(text[:begin].splitlines()):
        if not line.strip().startswith("///"):
            break
        lines.append(line.strip()[3:].strip())
    return " ".join(reversed(lines))


def declarations(text):
    """What a header declares in its namespaces, each name once."""
    code, seen = code_of(text), set()
    for space, begin, end in statements(code):
        first = begin + len(code[begin:end]) - len(code[begin:end].lstrip())
        found = name_of(code[first:end])
        if found and (space, found[1]) not in seen:
            seen.add((space, found[1]))
            start = text.rfind("\n", 0, first) + 1
            yield Declaration(space, found[1], found[0], comment_before(text, start), text.count("\n", 0, first) + 1, end)
