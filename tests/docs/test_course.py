# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that each rule of the course can be broken."""
import unittest

import course

PAGE = "| lesson | you learn | builds on |\n| --- | --- | --- |\n| [01_a](../examples/01_a.cpp) | this | |\n| [02_b](../examples/02_b.cpp) | that | 1 |\n"


def program(said):
    return f"// copyright\n// licence\n// {said}\n#include <a>\n"


def wrong(second="Lesson 2: that. Builds\n// on lesson 1.", page=PAGE, more=None):
    return list(course.wrong({"01_a": program("Lesson 1: this."), "02_b": program(second), **(more or {})}, page))


class Course(unittest.TestCase):
    def test_a_course(self):
        self.assertEqual(wrong(), [])

    def test_a_program_says_what_it_is(self):
        self.assertEqual(len(wrong("Lesson 3: that. Builds on lesson 1.")), 1)
        self.assertEqual(len(wrong("That. Builds on lesson 1.")), 1)
        self.assertTrue(any("does not say" in each for each in wrong("Lesson 2: that.")))

    def test_nothing_builds_on_what_comes_later(self):
        self.assertTrue(any("no earlier" in each for each in wrong("Lesson 2: that. Builds on lessons 1 and 2.")))

    def test_the_page_lists_them(self):
        self.assertEqual(len(wrong(page=PAGE.replace("| 1 |", "| |"))), 1)
        self.assertEqual(len(wrong(page=PAGE.replace("| [02_b](../examples/02_b.cpp) | that | 1 |\n", ""))), 1)
        self.assertEqual(len(wrong(more={"04_c": program("Lesson 4: more. Builds on lesson 2.")}, page=PAGE + "| [04_c](../examples/04_c.cpp) | more | 2 |\n")), 1)
