# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that a header which says something else first is reported, and one that names no flag."""
import os
import pathlib
import tempfile
import unittest

import language

COMPILER = os.environ["RTUWIRE_COMPILER"]
SAYS_IT = f"#if __cplusplus < 202002L\n#error \"{language.SENTENCE}\"\n#endif\n"


class Language(unittest.TestCase):
    def complaints(self, text):
        with tempfile.TemporaryDirectory() as place:
            pathlib.Path(place, "a.hpp").write_text(text, encoding="utf-8")
            return list(language.complaints(COMPILER, place, ["a.hpp"])), \
                list(language.complaints_of_tools(COMPILER, place, "a.hpp"))

    def test_the_sentence_is_enough_and_flags_are_missed(self):
        of_headers, of_tools = self.complaints(SAYS_IT + "template <typename T> concept c = true;\n")
        self.assertEqual(of_headers, [])
        self.assertEqual(len(of_tools), sum(map(len, language.TOOLS.values())))

    def test_an_error_before_the_sentence_is_reported(self):
        of_headers, _ = self.complaints("#include <no_such_header>\n" + SAYS_IT)
        self.assertEqual(len(of_headers), 3)

    def test_errors_behind_the_sentence_are_reported(self):
        of_headers, _ = self.complaints(SAYS_IT + "".join(f"unknown a{i};\n" for i in range(7)))
        self.assertEqual(len(of_headers), 3)
        self.assertIn("one of 8 errors", of_headers[0])

    def test_a_header_that_compiles_is_reported(self):
        of_headers, of_tools = self.complaints("int a();\n")
        self.assertEqual(len(of_headers), 3)
        self.assertIn("[]", of_headers[0])
        self.assertTrue(of_tools)
