# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that a block which does not compile is seen, and a frame that stands for none."""
import os
import pathlib
import unittest

import snippets

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PLAIN = snippets.Frame("plain.cpp", "#include <rtuwire/client.hpp>\nusing namespace rtuwire;\nvoid f()\n{\n// BLOCK\n}\n")
OWN = snippets.Frame("own.cpp", "// PAGE: docs/a.md\n// BEGINS: int b\n// FOR: ... => 1\n// REST FROM: int c\n"
                                "// BLOCK\nvoid g() {\n// REST\n}\n")


def page(*lines):
    return "Text.\n\n```cpp\n" + "".join(line + "\n" for line in lines) + "```\n"


class Seen(unittest.TestCase):
    def wrong(self, text):
        return [snippets.complaint(os.environ["RTUWIRE_COMPILER"], PROJECT, *each)
                for each in snippets.programs({"docs/a.md": text}, [PLAIN])]

    def test_block(self):
        self.assertEqual(self.wrong(page("unit_id const pump{7};")), [""])
        self.assertIn("docs/a.md:4", self.wrong(page("unit_id const pump{7}", "pump.start();"))[0])
        self.assertIn("docs/a.md:5", self.wrong(page("int a = 1;", "short b = a;"))[0])  # a warning

    def test_program(self):
        self.assertEqual(self.wrong(page("#include <rtuwire/client.hpp>", "int main() { return 0; }")), [""])
        self.assertNotEqual(self.wrong(page("int main() { return x; }")), [""])

    def test_each_block_of_a_page(self):
        self.assertEqual(len(self.wrong(page("int a = 1;") + page("int b = 2;"))), 2)
        self.assertEqual(self.wrong("```sh\nls\n```\n"), [])

    def test_frame(self):
        made = list(snippets.programs({"docs/a.md": page("int b = ...;", "int c = 2;")}, [PLAIN, OWN]))
        self.assertEqual(made[0][1], 4)
        self.assertIn('#line 4 "docs/a.md"\nint b = 1;\nvoid g() {\n#line 5 "docs/a.md"\nint c = 2;\n}', made[0][2])

    def test_frame_without_a_block(self):
        with self.assertRaises(ValueError):
            list(snippets.programs({"docs/a.md": page("int a;")}, [PLAIN, OWN]))
        with self.assertRaises(ValueError):  # the page has nothing that would be filled in
            list(snippets.programs({"docs/a.md": page("int b = 1;", "int c = 2;")}, [PLAIN, OWN]))
