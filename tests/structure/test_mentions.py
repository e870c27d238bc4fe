# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that a mention of what is not there is found, and that of what is there is not."""
import unittest

import mentions


def of_page(text, known=(), files=(), page="docs/a.md"):
    return list(mentions.wrong_in(page, mentions.sayings_of_page(text), set(known), set(files), {"04_poll"}))


def of_program(text, known=()):
    return list(mentions.wrong_in("examples/a.cpp", mentions.sayings_of_program(text), set(known), set(), {"04_poll"}))


class Mentions(unittest.TestCase):
    def test_a_name_is_in_the_code(self):
        for said in ("`stop_by`", "`sim::stop_by`", "`link.stop_by`", "`stop_by(3)`"):
            self.assertEqual(of_page(said, {"sim", "stop_by", "link"}), [])
            self.assertEqual(len(of_page("first\n" + said, {"sim", "link"})), 1, said)
        self.assertEqual(of_page("`sim::bench`", {"sim"}), ["docs/a.md:1: bench is no name of the code"])
        self.assertEqual(of_page("stop_by, `plain words -x`\n```cpp\n`stop_by`\n```\n"), [])

    def test_what_others_named(self):
        self.assertEqual(of_page("`v_sf`", page="docs/registers.md"), [])
        self.assertEqual(len(of_page("`v_sf`", page="docs/tool.md")), 1)
        self.assertEqual(of_page("`modbus_connect`, `nmbs_t`"), [])

    def test_files_and_examples(self):
        self.assertEqual(of_page("`docs/b.md` `tests/wire/NAME.cpp` `build/docs/html/a.html` `docs/b`", files={"docs/b.md"}), [])
        self.assertEqual(of_page("`docs/c.md`", files={"docs/b.md"}), ["docs/a.md:1: there is no file docs/c.md"])
        self.assertEqual(of_page("`04_poll` `examples/04_poll.cpp` `2 * 0.01_s`", files={"examples/04_poll.cpp"}), [])
        self.assertEqual(of_page("`05_poll`"), ["docs/a.md:1: there is no example 05_poll"])

    def test_comments(self):
        self.assertEqual(of_program("int a; // see 04_poll and b_c", {"b_c"}), [])
        self.assertEqual(of_program("char const* a{\"// b_c\"};\n// b_c\n"), ["examples/a.cpp:2: b_c is no name of the code"])

    def test_a_comment_is_no_source(self):
        self.assertEqual(mentions.words_of("a.cpp", 'int a; // b\n/* c */ auto d{"// e"};'), {"int", "a", "auto", "d", "e"})
        self.assertEqual(mentions.words_of("a.py", "a // b"), {"a", "b"})
