# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that the reader of declarations finds what a header declares, and that each rule of names can be broken."""
import unittest

import declarations
import names
import rules

HEADER = """// Head.
#pragma once
#include <rtuwire/core/result.hpp>
namespace rtuwire {
inline namespace RTUWIRE_BUILD {
enum class early : int;
class ahead;
/// A type.
template <typename T>
requires(sizeof(T) > 1) class [[nodiscard]] box {
public:
    void open() { int inside; }
    struct lid {};
};
template <> class box<char> { int own; };
struct aggregate { int a{1}; };
enum class colour : int { red, green };
template <typename T> concept drawn = requires(T& a) { { a.draw() } -> same_as<int>; };
using shape = box<aggregate>;
/// Internal.
inline constexpr int corners[] = {1, 2};
inline constexpr box<int> unit_box{.a = 1};
template <auto const& R> [[nodiscard]] constexpr auto area(box<int> of = {}) noexcept -> int { return of.a; }
consteval int side(int of) { return of; }
constexpr bool operator==(aggregate a, aggregate b) { return a.a == b.a; }
inline namespace literals {
consteval int operator""_m(unsigned long long metres) { return 1; }
}
namespace detail { inline int hidden() { return 1; } }
static_assert(sizeof(aggregate) == 4);
constexpr int box<int>::outside() { return 1; }
// int commented();
}
}
"""


def house(**texts):
    return names.House(rules.Tree({path.replace("__", "/") + ".hpp": text for path, text in texts.items()}))


def in_rtuwire(words, head=""):
    return f"{head}\n#pragma once\nnamespace rtuwire {{\n{words}\n}}\n"


class Declarations(unittest.TestCase):
    def setUp(self):
        self.found = {each.path(): each for each in declarations.declarations(HEADER)}

    def test_each_name_once(self):
        self.assertEqual({path.removeprefix("rtuwire::") for path in self.found},
                         {"box", "aggregate", "colour", "drawn", "shape", "corners", "unit_box", "area", "side",
                          'literals::operator""_m', "detail::hidden"} - {'literals::operator""_m'} | {'operator""_m'})

    def test_kinds(self):
        kinds = {path.removeprefix("rtuwire::"): each.kind for path, each in self.found.items()}
        self.assertEqual(kinds["box"], "type")
        self.assertEqual(kinds["drawn"], "concept")
        self.assertEqual(kinds["corners"], "object")
        self.assertEqual(kinds["area"], "function")

    def test_comments_and_lines(self):
        self.assertEqual(self.found["rtuwire::box"].comment, "A type.")
        self.assertEqual(self.found["rtuwire::corners"].comment, "Internal.")
        self.assertEqual(self.found["rtuwire::aggregate"].comment, "")
        self.assertEqual(self.found["rtuwire::box"].line, 9)


class Names(unittest.TestCase):
    def test_a_name_is_public_or_marked(self):
        def found(words, head="", public=(), room="altivar__procedure__a"):
            return list(names.unlisted(house(**{room: in_rtuwire(words, head)}), set(public)))
        self.assertEqual(len(found("struct a {};")), 1)
        self.assertEqual(found("struct a {};", public={"a"}), [])
        self.assertEqual(found("/// Internal.\nstruct a {};"), [])
        self.assertEqual(found("struct a {};", head="// Internal: may change."), [])
        self.assertEqual(len(found("/// Internal.\nstruct a {};", room="sim__drive__a")), 1)
        self.assertEqual(len(found("struct a {};", head="// Internal: may change.", room="core__a")), 1)
        self.assertEqual(found("namespace detail { struct a {}; }", room="core__a"), [])
        self.assertEqual(found("inline void this_value_does_not_fit() {}"), [])
        self.assertEqual(len(found("inline void bytes_at_the_most() {}")), 1)

    def test_the_page_says_what_is_there(self):
        inside = house(client='#include <rtuwire/core/a.hpp>', core__a=in_rtuwire("struct a {};"),
                       core__b=in_rtuwire("struct b {};"), altivar__c=in_rtuwire("struct c {};", "// Internal."))
        self.assertEqual(list(names.wrongly_listed(inside, {"client.hpp": ["a"]})), [])
        self.assertEqual(len(list(names.wrongly_listed(inside, {"client.hpp": ["b"]}))), 1)
        self.assertEqual(len(list(names.wrongly_listed(inside, {"What it has (client.hpp)": ["a", "b"]}))), 1)
        self.assertEqual(len(list(names.wrongly_listed(inside, {"client.hpp": ["gone"]}))), 1)
        self.assertEqual(len(list(names.wrongly_listed(inside, {"client.hpp": ["c"]}))), 2)

    def test_the_page_is_read(self):
        page = "# Names\n\n| `no` | above all |\n\n## client.hpp\n\n| names | for |\n| --- | --- |\n" \
               "| `a`, `sim::b`, `operator\"\"_Hz` | `c` |\n"
        self.assertEqual(names.sections(page), {"client.hpp": ["a", "sim::b", 'operator""_Hz']})

    def test_a_name_stands_once(self):
        self.assertEqual(len(list(names.twice({"client.hpp": ["a"], "server.hpp": ["a", "b"]}))), 1)

    def test_programs_use_doors_and_public_names(self):
        def found(code):
            return list(names.uses("examples/a.cpp", code, {"turns"}, {"client.hpp", "altivar/atv320.hpp"}))
        self.assertEqual(found("#include <rtuwire/client.hpp>\n#include <rtuwire/altivar/atv320.hpp>\n"), [])
        self.assertEqual(len(found("#include <rtuwire/client/turns.hpp>\n")), 1)
        self.assertEqual(len(found("rtuwire::turns all;")), 1)
        self.assertEqual(found("motor.turns = 1; motor->turns(); // turns\nauto a = \"turns\";"), [])

    def test_a_program_with_many_names_of_its_own_names_the_library(self):
        def found(code):
            return list(names.uses("tools/t/a.cpp", code, {"turns"}, set()))
        self.assertEqual(found("turns mine; tool::turns others;"), [])
        self.assertEqual(len(found("rtuwire::turns all; rtuwire::detail::more more;")), 2)
        self.assertEqual(len(found("using namespace rtuwire;")), 1)

    def test_what_a_drive_has_is_public_by_its_manual(self):
        text = "#pragma once\nnamespace rtuwire::altivar::atv99 {\ninline constexpr int eta{1};\n}\n"
        self.assertEqual(list(names.unlisted(house(altivar__device__atv99=text), set())), [])
        self.assertEqual(names.internal_names(house(altivar__device__atv99=text), set()), set())
