# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that devices and PDUs are found in headers, and that each rule of the lists can be broken."""
import unittest

import lists

DEVICES = """#pragma once
namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::compact {
struct family_device { int a; };
struct device { int a; };
}
namespace altivar::atv99 {
// struct device_1999 {};
struct device_limit_table;
enum class mode : int { low };
struct device : compact::family_device { static constexpr literal name{"struct device_2000 {"}; };
struct device_2030 : device { int b; };
struct row { struct device_inside {}; };
}
}
}
"""

FUNCTIONS = """#pragma once
namespace rtuwire {
struct frame_rules { int a; };
struct answer { static result<answer> decode(byte_view pdu); };
struct request {
    using response = answer;
    static constexpr frame_rules rules{1};
};
template <typename Words> struct ask {
    using response = ask<>;
    static constexpr frame_rules rules{2};
};
struct row { static constexpr frame_rules rules{3}; };
}
"""


class Headers(unittest.TestCase):
    def test_devices_are_found(self):
        self.assertEqual(list(lists.devices({"a.hpp": DEVICES})), ["atv99::device", "atv99::device_2030"])

    def test_functions_are_found(self):
        self.assertEqual(list(lists.functions({"a.hpp": FUNCTIONS})), ["request", "ask"])


class Conversations(unittest.TestCase):
    HEADERS = {"a.hpp": """class asker {};
class finite : public asker {};
template <typename T> class one : public finite {};
// class none : public asker {};
template <> class two<int> : public one<int> {};
class cycle : public asker {
    [[nodiscard]] static constexpr bool settled() noexcept { return false; }
};
class other : public base {};
"""}

    def test_those_that_end_are_found(self):
        self.assertEqual(lists.conversations(self.HEADERS), ["two"])

    def test_one_may_be_missing(self):
        self.assertEqual(list(lists.never_used_again(self.HEADERS, "t", "two")), [])
        self.assertEqual(list(lists.never_used_again(self.HEADERS, "t", "twos")), ["t: two is not used again"])
        self.assertEqual(len(list(lists.never_used_again({}, "t", "two"))), 1)


class Lists(unittest.TestCase):
    TEXT = """// using all_drives = drive_list<gone::device>;
using some = drive_list<altivar::atv1::device>;
using all_drives = drive_list<altivar::atv1::device, // the first
                              rtuwire::altivar::atv2::device>;
using all_functions = type_list<request, answer<>, page<pair<int, char>>>;
"""

    def found(self, *defined, name="all_drives", text=TEXT):
        return list(lists.differences("tests/a.hpp", text, name, defined))

    def test_a_list_is_read(self):
        self.assertEqual(lists.listed(self.TEXT, "all_drives"), ["atv1::device", "atv2::device"])
        self.assertEqual(lists.listed(self.TEXT, "all_functions"), ["request", "answer", "page"])
        self.assertEqual(self.found("atv1::device", "atv2::device"), [])

    def test_a_list_lacks_one(self):
        found = self.found("atv1::device", "atv2::device", "atv2::device_2030")
        self.assertEqual(found, ["tests/a.hpp: all_drives lacks atv2::device_2030"])
        self.assertEqual(len(self.found("request", "answer", "page", "other", name="all_functions")), 1)

    def test_a_list_holds_what_is_not_there(self):
        self.assertEqual(len(self.found("atv1::device")), 1)

    def test_a_list_holds_one_twice(self):
        twice = "using all_drives = drive_list<atv1::device, atv1::device>;"
        self.assertEqual(len(self.found("atv1::device", text=twice)), 1)

    def test_a_list_is_not_there(self):
        self.assertEqual(len(self.found("atv1::device", text="")), 1)

    def test_headers_that_define_nothing_are_noticed(self):
        self.assertIn("tests/a.hpp: nothing was found in the headers that all_drives should hold", self.found())


class SecondLists(unittest.TestCase):
    def found(self, text, *allowed):
        return list(lists.second_lists({"tests/a.cpp": text}, allowed))

    def test_drives_are_named_one_by_one_in_their_list_only(self):
        text = "run<atv12::device>();\nrun<atv310::device_2026>();"
        self.assertEqual(len(self.found(text)), 1)
        self.assertIn("all_drives", self.found(text)[0])
        self.assertEqual(self.found(text, "tests/a.cpp"), [])
        self.assertEqual(len(self.found("using namespace atv310; device_2026 a; altivar::atv12 :: device b;")), 1)

    def test_single_drives_may_be_named(self):
        self.assertEqual(self.found("run<atv12::device>();\nrun<atv310::device>();"), [])
        self.assertEqual(self.found("run<atv310::device_2026>();\nrun<atv310::device>();"), [])
        self.assertEqual(self.found("run<atv12::device>(); // not device_2026"), [])

    def test_a_permission_is_needed(self):
        self.assertEqual(len(self.found("run<atv12::device>();", "tests/a.cpp")), 1)
        self.assertEqual(len(self.found("", "tests/gone.cpp")), 1)

    def test_generic_headers_know_no_drive(self):
        generic = "namespace altivar {\nauto a = atv28::device::layout;\n}"
        self.assertEqual(len(list(lists.named_drives({"include/rtuwire/sim/a.hpp": generic}))), 1)
        self.assertEqual(list(lists.named_drives({"include/rtuwire/altivar/device/atv28.hpp": generic})), [])
        own = generic.replace("altivar {", "altivar::atv28 {")
        said = "// as an atv28 does\n#include <rtuwire/altivar/atv28.hpp>\n"
        self.assertEqual(list(lists.named_drives({"include/rtuwire/sim/a.hpp": own, "include/b.hpp": said})), [])
