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

    def test_a_header_is_where_the_changes_say(self):
        def of(*rows):
            text = "# A\n\n| now | before |\n| --- | --- |\n" + "".join(f"| {row} |\n" for row in rows) + "\n| `no.hpp` | b |\n"
            return list(mentions.wrong_moves("C.md", text, {"ask/poller.hpp", "core/crc16.hpp"}))
        self.assertEqual(of("`ask/poller.hpp` | `client/poller.hpp`", "`ask/`, `core/` | `client/`"), [])
        self.assertEqual(of("`ask/poller.hpp` | `a.hpp`", "`ask/no.hpp` | `a.hpp`", "`client/` | `a.hpp`"),
                         ["C.md:6: there is no header ask/no.hpp", "C.md:7: there is no header client/"])
        self.assertEqual(len(list(mentions.wrong_moves("C.md", "# A\n", set()))), 1)

    def test_a_list_of_headers(self):
        text = "# words\na.hpp | 1\nb.hpp | 2\na.hpp | 3\n"
        self.assertEqual(list(mentions.wrong_rows("a.txt", text, {"a.hpp", "b.hpp"}, "often")), [])
        self.assertEqual(list(mentions.wrong_rows("a.txt", text, {"a.hpp"}, "once")),
                         ["a.txt:3: there is no header b.hpp", "a.txt:4: a.hpp has a row already"])

    def test_comments(self):
        self.assertEqual(of_program("int a; // see 04_poll and b_c", {"b_c"}), [])
        self.assertEqual(of_program("char const* a{\"// b_c\"};\n// b_c\n"), ["examples/a.cpp:2: b_c is no name of the code"])

    def test_a_comment_is_no_source(self):
        self.assertEqual(mentions.words_of("a.cpp", 'int a; // b\n/* c */ auto d{"// e"};'), {"int", "a", "auto", "d", "e"})
        self.assertEqual(mentions.words_of("a.py", "a // b"), {"a", "b"})
