# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes headers in which every change is there at once, each behind a switch that the running program turns:
so that the tests are compiled once, not once for each change."""
import re

SUPPORT = """#pragma once
#include <cstdlib>
#include <type_traits>
namespace rtuwire_mutation {
inline int const chosen = std::getenv("RTUWIRE_CHANGE") ? std::atoi(std::getenv("RTUWIRE_CHANGE")) : -1;
inline unsigned char reached[%d]{};
inline bool look(int change) noexcept
{
    reached[change] = 1;
    return change == chosen;
}
/// Whether this change is chosen. The compiler, where it evaluates an expression, takes the original.
constexpr bool is(int change) noexcept { return not std::is_constant_evaluated() and look(change); }
} // namespace rtuwire_mutation
"""
IS = "::rtuwire_mutation::is"
# A number that is constant the compiler computes, where it can, and takes the original.
CONSTANT = re.compile(r"^(\s+(?:for \(|if \()?)([\w:<>, ]*\w>?) const (\w+ = )", re.MULTILINE)


def on_one_line(code):
    return " ".join(re.sub(r"//[^\n]*", " ", code).split())


def switched(text, numbered):
    """The text with a switch for each of these (number, change)."""
    def written(start, end, inside):
        """What stands there, with the switches of the changes inside."""
        out, at = "", start
        while inside:
            number, outer = max(inside, key=lambda each: (each[1].last - each[1].first, -each[1].first))
            first, last = outer.first, outer.last
            before = [each for each in inside if each[1].last <= first]
            after = [each for each in inside if each[1].first >= last]
            within = [each for each in inside if each[0] != number and each not in before and each not in after]
            changed = on_one_line(text[first:outer.start] + f" {outer.new} " + text[outer.end:last])
            out += written(at, first, before)
            unchanged = written(first, last, within)
            if text[outer.start:outer.end].startswith("not"):  # of what may only be asked, not copied
                out += f"({IS}({number}) != ({unchanged}))"
            else:
                out += f"({IS}({number}) ? ({changed}) : ({unchanged}))"
            at, inside = last, after
        return out + text[at:end]
    return written(0, len(text), list(numbered))


def variable(code):
    """Without `const`, a compiler may not compute what it could."""
    return CONSTANT.sub(lambda match: match.group() if "constexpr" in match.group()
                        else match.group(1) + match.group(2) + " " + match.group(3), code)


def write(target, source, changes, numbers):
    """Writes a folder of headers; `numbers` are the places in `changes` of those that become switches."""
    for path in source.rglob("*.hpp"):
        header = path.relative_to(source).as_posix()
        text = path.read_text(encoding="utf-8")
        own = [(number, changes[number]) for number in numbers if changes[number].header == header]
        if own:
            text = variable(switched(text, own))
            behind = text.index("#pragma once\n") + len("#pragma once\n")
            next_line = text.count("\n", 0, behind) + 1
            text = f'{text[:behind]}#include "rtuwire_mutation.hpp"\n#line {next_line} "{header}"\n{text[behind:]}'
        place = target / "rtuwire" / header
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8")
    (target / "rtuwire_mutation.hpp").write_text(SUPPORT % len(changes), encoding="utf-8")
