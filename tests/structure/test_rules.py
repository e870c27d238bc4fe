# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that every rule reports what it forbids and accepts what it allows."""
import unittest

import rules


def tree(**headers):
    """tree(wire__adu="core/crc16.hpp <bit>"): include lines from words, `__` for the slash."""
    def text(words):
        return "\n".join(f"#include {word if word[0] == '<' else f'<rtuwire/{word}>'}"
                         for word in words.split())
    return rules.Tree({name.replace("__", "/") + ".hpp": text(words)
                       for name, words in headers.items()})


class Layers(unittest.TestCase):
    def complaints(self, **headers):
        return list(rules.layers(tree(**headers)))

    def refused(self, header, target):
        found = self.complaints(**{header: target, target[:-4].replace("/", "__"): ""})
        self.assertEqual(len(found), 1, found)
        self.assertIn(target, found[0])

    def allowed(self, header, target):
        self.assertEqual(self.complaints(**{header: target, target[:-4].replace("/", "__"): ""}), [])

    def test_arrows_are_followed(self):
        self.allowed("wire__adu", "core/crc16.hpp")
        self.allowed("rtu__framer", "core/bytes.hpp")
        self.allowed("server__server", "wire/adu.hpp")
        self.allowed("table__table", "wire/function.hpp")
        self.allowed("port__posix_serial", "rtu/line.hpp")
        self.allowed("altivar__procedure__start", "ask/access.hpp")
        self.allowed("altivar__cyclic__cyclic", "altivar/device/family.hpp")
        self.allowed("altivar__atv320", "altivar/device/atv320.hpp")

    def test_against_the_arrows_is_reported(self):
        self.refused("core__bytes", "wire/adu.hpp")
        self.refused("wire__adu", "rtu/framer.hpp")
        self.refused("client__client", "server/server.hpp")
        self.refused("server__server", "client/client.hpp")
        self.refused("port__posix_serial", "rtu/framer.hpp")
        self.refused("cia402__words", "wire/errc.hpp")
        self.refused("ask__poller", "client/client.hpp")
        self.refused("altivar__device__atv320", "ask/access.hpp")
        self.refused("altivar__procedure__start", "client/client.hpp")
        self.refused("altivar__procedure__start", "altivar/cyclic/cyclic.hpp")
        self.refused("sim__drive__drive", "altivar/procedure/motion/start.hpp")
        self.refused("sim__drive__drive", "sim/line/line.hpp")
        self.refused("sim__line__line", "client/client.hpp")

    def test_a_header_that_is_a_room_of_its_own(self):
        self.allowed("sim__bench", "client/client.hpp")
        self.assertEqual(len(self.complaints(sim__other="sim/line/line.hpp", sim__line__line="")), 1)

    def test_one_header_of_a_room_is_not_the_room(self):
        self.refused("table__table", "wire/adu.hpp")
        self.refused("table__table", "wire/raw.hpp")

    def test_drives_and_the_operating_system_stay_above(self):
        for below in ("core", "wire", "rtu", "table", "client", "server"):
            for above in ("cia402", "altivar/device", "altivar/procedure", "sim/drive", "port"):
                self.refused(f"{below}__a", f"{above}/b.hpp")

    def test_doors_include_everything_and_no_room_a_door(self):
        self.allowed("client", "client/client.hpp")
        self.allowed("client", "frames.hpp")
        self.allowed("port", "port/chrono.hpp")
        self.refused("client__client", "frames.hpp")
        self.refused("altivar__atv320", "drives.hpp")

    def test_unknown_rooms_and_missing_headers_are_reported(self):
        self.assertEqual(len(self.complaints(utils__misc="")), 1)
        self.assertEqual(len(self.complaints(core__bytes="core/gone.hpp")), 1)

    def test_spelling_of_the_directive_does_not_matter(self):
        texts = {"core/a.hpp": '  #  include "rtuwire/wire/b.hpp"', "wire/b.hpp": ""}
        self.assertEqual(len(list(rules.layers(rules.Tree(texts)))), 1)


class StandardIncludes(unittest.TestCase):
    def count(self, **headers):
        return len(list(rules.standard_includes(tree(**headers))))

    def test_the_list(self):
        self.assertEqual(self.count(core__a="<array> <bit> <span>"), 0)
        self.assertEqual(self.count(core__a="<array> <chrono> <vector>"), 2)
        self.assertEqual(self.count(port__chrono="<chrono>"), 0)
        self.assertEqual(self.count(rtuwire="<string>"), 1)

    def test_string_view_only_where_a_name_is_shown(self):
        self.assertEqual(self.count(wire__errc_name="<string_view>"), 0)
        self.assertEqual(self.count(wire__adu="<string_view>"), 1)

    def test_a_path_beside_the_header_is_reported(self):
        self.assertEqual(len(list(rules.standard_includes(
            rules.Tree({"core/a.hpp": '#include "b.hpp"'})))), 1)


class Others(unittest.TestCase):
    def test_cycles(self):
        self.assertEqual(list(rules.cycles(tree(core__a="core/b.hpp", core__b=""))), [])
        self.assertEqual(len(list(rules.cycles(
            tree(core__a="core/b.hpp", core__b="core/c.hpp", core__c="core/a.hpp")))), 1)
        self.assertEqual(len(list(rules.cycles(tree(core__a="core/a.hpp")))), 1)

    def test_umbrella(self):
        def count(**headers):
            return len(list(rules.umbrella(tree(**headers))))
        self.assertEqual(count(core__a=""), 1)
        self.assertEqual(count(rtuwire="core/a.hpp", core__a="core/b.hpp", core__b=""), 0)
        self.assertEqual(count(rtuwire="core/a.hpp", core__a="", core__b=""), 1)
        self.assertEqual(count(rtuwire="port/a.hpp", port__a=""), 1)
        self.assertEqual(count(rtuwire="", port="port/a.hpp", port__a=""), 0)
        self.assertEqual(count(rtuwire="", altivar__parameters__a="", altivar__atv1_parameters=""), 0)
        self.assertEqual(count(rtuwire="altivar/parameters/a.hpp", altivar__parameters__a=""), 1)
        functions = {"rtuwire": "wire/serial_line/a.hpp wire/b.hpp", "wire__serial_line__a": ""}
        self.assertEqual(count(**functions, wire__b=""), 0)
        self.assertEqual(count(**functions, client="wire/b.hpp", wire__b="wire/serial_line/a.hpp"), 2)

    def test_form(self):
        def count(text):
            return len(list(rules.form(rules.Tree({"core/a.hpp": text}))))
        head = "\n".join(rules.SPDX) + "\n"
        self.assertEqual(count(head), 0)
        self.assertEqual(count("\n" + head), 1)
        self.assertEqual(count(rules.SPDX[0]), 1)


HEAD = "// A head.\n#pragma once\n\n#include <array>\n\n"
VERSION = f"#include <rtuwire/{rules.VERSION}>\n"
BUILD = "namespace rtuwire {\ninline namespace RTUWIRE_BUILD {\n"


class Builds(unittest.TestCase):
    def count(self, text, header="core/a.hpp"):
        return len(list(rules.build(rules.Tree({header: text}))))

    def test_the_namespace_of_the_build_is_accepted(self):
        for inner in ("", "namespace sim {\n}\n", "namespace altivar::atv12 {\n}\n"):
            self.assertEqual(self.count(f"{HEAD}{VERSION}\n{BUILD}{inner}}}\n}}"), 0)

    def test_another_namespace_is_reported(self):
        for name in ("rtuwire", "rtuwire::sim", "rtuwire::RTUWIRE_BUILD", "rtuwire {\ninline namespace v1",
                     "rtuwire {\nnamespace sim {\ninline namespace RTUWIRE_BUILD", "rtuwire::inline RTUWIRE_BUILD::detail",
                     "rtuwire::detail"):
            self.assertEqual(self.count(f"{HEAD}{VERSION}namespace {name} {{\n}}"), 1, name)

    def test_the_second_namespace_is_read_too(self):
        ours = BUILD + "}\n}\n"
        self.assertEqual(self.count(f"{HEAD}{VERSION}{ours}namespace rtuwire::sim {{\n}}"), 1)

    def test_a_missing_or_late_include_is_reported(self):
        ours = BUILD + "}\n}\n"
        self.assertEqual(self.count(HEAD + ours), 1)
        self.assertEqual(self.count(HEAD + ours + VERSION), 1)
        self.assertEqual(self.count(HEAD + ours, rules.VERSION), 0)

    def test_a_declaration_outside_is_reported(self):
        self.assertEqual(self.count(f"{HEAD}{VERSION}using word = int;\n"), 1)
        self.assertEqual(self.count(f"{HEAD}int a();\n{VERSION}{BUILD}}}\n}}"), 1)

    def test_a_door_has_includes_only(self):
        self.assertEqual(self.count(HEAD + VERSION), 0)
        self.assertEqual(self.count(HEAD + "#define A \\\n    1\n#ifdef B\n#endif\n"), 0)
