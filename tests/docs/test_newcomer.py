# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The newcomer's path reads a page as a person does, and sees where it shows something else than what comes."""
import unittest

from newcomer import commands, matches


class Newcomer(unittest.TestCase):
    def test_commands_of_a_page(self):
        page = "text\n```console\n$ one\nout\nmore\n$ two\n```\n```sh\nthree\n```\n"
        self.assertEqual(commands(page), [("one", ["out", "more"]), ("two", [])])

    def test_the_same_lines(self):
        self.assertTrue(matches(["a  b", "c"], ["a b", "c"]))
        self.assertFalse(matches(["a"], ["b"]))
        self.assertFalse(matches(["a"], []))
        self.assertFalse(matches(["a"], ["a", "b"]))
        self.assertFalse(matches([], ["a"]))

    def test_lines_left_out(self):
        self.assertTrue(matches(["...", "end"], ["a", "b", "end"]))
        self.assertTrue(matches(["...", "mid", "..."], ["mid"]))
        self.assertFalse(matches(["...", "end"], ["a", "end", "b"]))

    def test_the_end_of_a_line_left_out(self):
        self.assertTrue(matches(["0 failed out of ..."], ["0 failed out of 12"]))
        self.assertFalse(matches(["0 failed out of ..."], ["1 failed out of 12"]))
