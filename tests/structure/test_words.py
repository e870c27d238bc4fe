# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that each word that is refused is reported, and that what merely looks like one is not."""
import unittest

import words


def found(text):
    return list(words.complaints("a.hpp", text))


class Words(unittest.TestCase):
    def test_each_name_is_reported_with_the_one_to_take(self):
        for name, instead in words.PARTS.items():
            self.assertEqual(len(found(f"int {name};")), 1, name)
            self.assertIn(instead, found(f"int {name};")[0])

    def test_parts_of_a_name_are_reported(self):
        for name in ("last_octet", "octet_", "question_size", "Question", "engine_talk"):
            self.assertEqual(len(found(f"int {name};")), 1, name)
        for name in ("bear", "talkative", "wishful", "early", "octetless"):
            self.assertEqual(found(f"int {name};"), [], name)

    def test_comments_are_read_for_what_is_nobodys_english(self):
        self.assertEqual(len(found("int a; ///< the octets of a talk")), 2)
        self.assertEqual(found("/// A question has an answer."), [])

    def test_literals_and_includes_are_not_read(self):
        self.assertEqual(found('#include "lives/talk.hpp"\nchar const* a = "octet // talk";'), [])

    def test_a_line_is_told(self):
        self.assertIn("a.hpp:3:", found("\n\nint octet;")[0])

    def test_pages_are_read_where_they_show_code(self):
        page = "A heading.\n\n`start{drive, wish::forward}`\n```cpp\nclient link; // a talk\n```\nTalk."
        self.assertEqual([complaint.split(":")[1] for complaint in words.complaints_of_page("README.md", page)],
                         ["3", "5"])
