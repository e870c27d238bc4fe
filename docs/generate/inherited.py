# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a public class has of bases that the reference does not show: their public members but for those marked internal, written
into the class itself, all of it on the line that closes it, so that each line of the header keeps its number."""
import pathlib
import re
import sys
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests" / "structure"))
import declarations  # noqa: E402

INTERNAL = re.compile(r"\bInternal\b")
LABEL = re.compile(r"\s*(public|protected|private)\s*:(?!:)")
GROUP = r"\{(?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*\}"  # with three more inside of each other
START = r"[\w:]+(?:<[^;{}]*>)?\s*" + GROUP
STARTS = re.compile(rf"(?<=\))((?:[^;{{}}:?()]|::)*):(?!:)\s*{START}(?:\s*,\s*{START})*(?=\s*\{{)")
FUNCTION = re.compile(r"[^(={;]*?(\w+)\s*\(")
CLASS = re.compile(r"(class|struct)\s+(?P<name>\w+)\s*(?:final\s*)?(?P<bases>:[^:].*)?\Z", re.DOTALL)


@dataclass(frozen=True)
class Base:
    access: str
    name: str
    arguments: tuple


@dataclass(frozen=True)
class Class:
    """A class template's or a class's own words; `begin` and `end` are the places of its braces."""
    text: str
    begin: int
    end: int
    is_struct: bool
    parameters: tuple
    bases: tuple


@dataclass(frozen=True)
class Member:
    name: str
    access: str
    words: str
    comment: str


def split(words):
    """At the commas outside of brackets."""
    parts, depth, begin = [], 0, 0
    for at, letter in enumerate(words):
        depth += letter in "(<{["
        depth -= letter in ")>}]" and words[at - 1] != "-"
        if letter == "," and depth == 0:
            parts.append(words[begin:at])
            begin = at + 1
    return [part.strip() for part in (*parts, words[begin:]) if part.strip()]


def base_of(words, is_class):
    """A base as it is written: `public some::name<first, second>`."""
    access = re.match(r"(public|protected|private)\s+", words)
    name, _, rest = words[access.end() if access else 0:].partition("<")
    arguments = split(rest.rpartition(">")[0]) if rest else ()
    return Base(access[1] if access else "private" if is_class else "public", name.split("::")[-1].strip(), tuple(arguments))


def parameters_of(words):
    """The names of a template's parameters."""
    found = re.match(r"\s*template\s*<", words)
    if not found:
        return ()
    inside = words[found.end():declarations.closing_angle(words[found.start():]) + found.start() - 1]
    return tuple(re.findall(r"\w+", each.partition("=")[0])[-1] for each in split(inside))


def without_starts(code):
    """The code without what constructors begin with: its braces are no bodies."""
    return STARTS.sub(lambda found: found[1] + re.sub(r"[^\n]", " ", found[0][len(found[1]):]), code)


def classes(text):
    """The classes of a header by their names: the first of each, which is not a special case."""
    code, found = declarations.code_of(text), {}
    for _, begin, end in declarations.statements(code):
        words = code[begin:end]
        head = CLASS.match(declarations.declared(words).partition("{")[0].strip())
        if not head or "{" not in words:
            continue
        opens = begin + words.index("{", re.search(rf"\b{head[1]}\s+{head['name']}\b", words).end())
        bases = tuple(base_of(each, head[1] == "class") for each in split((head["bases"] or ":")[1:]))
        found.setdefault(head["name"], Class(text, opens, begin + words.rindex("}"), head[1] == "struct",
                                             parameters_of(words), bases))
    return found


def all_classes(texts):
    """Those of several headers; of two with one name the first."""
    found = {}
    for text in texts:
        for name, one in classes(text).items():
            found.setdefault(name, one)
    return found


def name_of(words):
    """Kind and name of a member; none where it has none."""
    if words.startswith(("friend", "static_assert")) or "operator" in words:
        return None
    function = FUNCTION.match(declarations.angles_cut(declarations.declared(words)))
    return ("function", function[1]) if function else declarations.name_of(words)


def head_of(words):
    """A function without its body; what is no function whole."""
    depth = 0
    for at, letter in enumerate(words):
        depth += letter in "(["
        depth -= letter in ")]"
        if letter == "{" and depth == 0:
            return words[:at].rstrip() + ";" if name_of(words)[0] == "function" else words
    return words


def members(one):
    """What a class declares, with access and comment; without constructors and operators."""
    inside = one.text[one.begin + 1:one.end]
    code, access = without_starts(declarations.code_of(inside)), "public" if one.is_struct else "private"
    for _, begin, end in declarations.statements(code):
        while label := LABEL.match(code, begin):
            access, begin = label[1], label.end()
        first = begin + len(code[begin:end]) - len(code[begin:end].lstrip())
        words = code[first:end]
        comment = declarations.comment_before(inside, inside.rfind("\n", 0, first) + 1)
        named = name_of(words)
        if words.startswith("using") and "=" not in words:
            for name in re.findall(r"::(\w+)\s*[,;]", words):
                yield Member(name, access, "", comment)
        elif named and named[0] in ("function", "object", "alias"):
            yield Member(named[1], access, re.sub(r"\s+", " ", re.sub(r"//[^\n]*", "", head_of(inside[first:end]))), comment)


def usable(found):
    """Members that are declared here and that a program may use."""
    internal = {each.name for each in found if INTERNAL.search(each.comment)}
    return [each for each in found if each.words and each.name not in internal]


def bases_of(one, arguments, known):
    """Access, base and its arguments, where a base may be a parameter of the class."""
    given = dict(zip(one.parameters, arguments))
    for base in one.bases:
        actual = base_of(given[base.name], False) if base.name in given else base
        if actual.name in known:
            yield base.access, actual.name, tuple(given.get(each, each) for each in actual.arguments)


def inherited(one, arguments, known, shown):
    """The members that a class has of bases which are not `shown`, with the access that it gives them."""
    own = list(members(one))
    declared = {each.name for each in own if each.words}
    made_public = {each.name: each.comment for each in own if not each.words and each.access == "public"}
    for access, name, its_arguments in bases_of(one, arguments, known):
        if name in shown:
            continue
        base = known[name]
        for each in [*usable(list(members(base))), *inherited(base, its_arguments, known, shown)]:
            if each.access == "private" or each.name in declared - made_public.keys() or each.name == name:
                continue
            is_public = each.name in made_public or access == each.access == "public"
            yield Member(each.name, "public" if is_public else access if access != "public" else each.access, each.words,
                         each.comment or made_public.get(each.name, ""))


def with_inherited(text, known, shown):
    """The header with these members in its classes."""
    places = []
    for one in classes(text).values():
        taken = {}
        for each in inherited(one, one.parameters, known, shown):
            if each.access == "public":
                taken.setdefault(each.words, each)
        if taken:
            lines = (f"/** {each.comment} */ {each.words}" if each.comment else each.words for each in taken.values())
            places.append((one.end, " public: " + " ".join(lines) + " "))
    for at, words in sorted(places, reverse=True):
        text = text[:at] + words + text[at:]
    return text
