# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The headers as the reference shows them: the public names with all that they have, without the namespace of the build and
without what is marked internal."""
import re

import inherited

import declarations  # noqa: I100  (the reader that holds docs/names.md to the headers, where `inherited` found it)

INTERNAL = re.compile(r"\bInternal\b")
INTERNAL_HEADER = re.compile(r"^// Internal\b", re.MULTILINE)
ALIAS = re.compile(r"^using (\w+) = (?:detail::)?(\w+)<", re.MULTILINE)
NOT_SHOWN = re.compile(r"^(?:(?:inline )?namespace (?:detail|RTUWIRE_BUILD) \{|\} // namespace (?:detail|RTUWIRE_BUILD))$|\bdetail::",
                       re.MULTILINE)

NAMESPACES = {
    "rtuwire": "All names of the library; docs/names.md sorts them by what they are for.",
    "rtuwire::altivar": "Altivar drives: orders, set-up, what all of them share.",
    "rtuwire::altivar::atv12": "The registers and words of an ATV12, by the mnemonics of its manual.",
    "rtuwire::altivar::atv28": "The registers and words of an ATV28, and what only this drive has.",
    "rtuwire::altivar::atv310": "The registers and words of an ATV310, by both revisions of its manual.",
    "rtuwire::altivar::atv320": "The registers and words of an ATV320.",
    "rtuwire::cia402": "The drive profile: states, commands, transitions.",
    "rtuwire::sim": "Simulated drives and lines, in virtual time.",
    "rtuwire::units": "Amounts whose short name has another meaning.",
    "rtuwire::literals": "Amounts as they are written: 50_Hz.",
}


def is_internal_header(text):
    return INTERNAL_HEADER.search(text.partition("#pragma once")[0]) is not None


def blanked(piece):
    """The same lines with nothing on them: what Doxygen reports keeps its line."""
    return re.sub(r"[^\n]", "", piece)


def comment_begin(text, begin):
    """Where the `///` lines right before a place begin."""
    at = text.rfind("\n", 0, begin) + 1
    while at > 0:
        before = text.rfind("\n", 0, at - 1) + 1
        if not text[before:at].strip().startswith("///"):
            break
        at = before
    return at


def specialises(words, names):
    """Whether a declaration is a special case, or a part, of one of these."""
    head = re.split(r"[{=;]", words, maxsplit=1)[0]
    return words.startswith("template") and not names.isdisjoint(re.findall(r"\b(\w+)\s*<", head))


def is_detail(space):
    return space.endswith("::detail")


def named_by_aliases(texts):
    """Classes that are public by another name of their header only."""
    return {match[2] for text in texts for match in ALIAS.finditer(text)}


def internal_names(texts):
    """What headers declare and mark internal, or declare in an internal header."""
    return {each.name for text in texts for each in declarations.declarations(text)
            if is_internal_header(text) or INTERNAL.search(each.comment) or is_detail(each.space)} - named_by_aliases(texts)


def with_what_aliases_name(text):
    """A class of the header that is public by another name only is shown as what that name stands for."""
    named = set(match[2] for match in ALIAS.finditer(text))
    for each in declarations.declarations(text):
        if each.name in named and INTERNAL.search(each.comment):
            text = re.sub(r"(/// )Internal\.(?=\n(?:template[^;{]*)?\n?(?:class|struct) " + each.name + r"\b)", r"\1", text)
    return text


def without_internal(text, names=()):
    code = declarations.code_of(text)
    pieces, done, hidden, aliased = [], 0, set(names), named_by_aliases([text])
    for space, begin, end in declarations.statements(code):
        first = begin + len(code[begin:end]) - len(code[begin:end].lstrip())
        start = text.rfind("\n", 0, first) + 1
        comment = declarations.comment_before(text, start)
        named = declarations.name_of(code[first:end])
        is_own = is_detail(space) and not (named and named[1] in aliased)
        if is_own or INTERNAL.search(comment) or (not comment and specialises(code[first:end], hidden)):
            hidden.update(named[1:] if named else ())
            cut = comment_begin(text, first)
            pieces += [text[done:cut], blanked(text[cut:end])]
            done = end
    return "".join(pieces) + text[done:]


def stage(project, target):
    """Writes the headers that a program may know of."""
    texts = {path: path.read_text(encoding="utf-8") for path in sorted((project / "include").rglob("*.hpp"))}
    texts = {path: text if is_internal_header(text) else with_what_aliases_name(text) for path, text in texts.items()}
    internal, known = internal_names(texts.values()), inherited.all_classes(texts.values())
    for path, text in texts.items():
        if is_internal_header(text):
            continue
        shown = inherited.with_inherited(without_internal(text, internal), known, known.keys() - internal)
        shown = NOT_SHOWN.sub("", shown)
        place = target / path.relative_to(project / "include")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(shown, encoding="utf-8")
    described = "".join(f"/** \\namespace {name}\n {words} */\n" for name, words in NAMESPACES.items())
    (target / "namespaces.hpp").write_text(described, encoding="utf-8")
