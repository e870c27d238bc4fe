# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A table that a page keeps for git hosts and that is not what it is made of is seen."""
import pathlib
import sys
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "docs" / "generate"))
import tables  # noqa: E402
import tables_in_pages as kept  # noqa: E402

DRIVE = "drive\t{}\tX1\t1\t31\t3, 6\t60\t59\t0\t0\tsll\ttto\tchcf\t30\t{}"
REGISTER = "register\tatv28\t{}\t{}\tName of it\tread, write\tnumber\t0.1 Hz\t0.0 Hz\t60.0 Hz\t\t\tdocumented\t{}"


class Marks(unittest.TestCase):
    def test_what_is_kept_is_replaced(self):
        text = "a\n<!-- made: it -->\nold\n\n```\nold\n```\n<!-- end -->\nb\n"
        self.assertEqual(kept.renewed(text, {"it": "new"}), ("a\n<!-- made: it -->\nnew\n<!-- end -->\nb\n", ["it"]))
        self.assertEqual(kept.renewed("<!-- made: it -->\n<!-- end -->\n", {"it": "new"})[0], "<!-- made: it -->\nnew\n<!-- end -->\n")

    def test_a_mark_alone(self):
        for text in ("<!-- made: it -->\nold\n", "<!-- end -->\n", "<!-- made: it -->\n<!-- made: it -->\n<!-- end -->\n"):
            with self.assertRaises(ValueError):
                kept.renewed(text, {"it": "new"})

    def test_what_nothing_makes(self):
        with self.assertRaises(ValueError):
            kept.renewed("<!-- made: other -->\n<!-- end -->\n", {"it": "new"})


class Made(unittest.TestCase):
    def facts(self, *rows):
        return tables.sorted_lines([DRIVE.format("atv28", len(rows)), *rows])

    def test_a_drive_shows_the_registers_for_driving_and_where_the_others_are(self):
        made = kept.of_drives(self.facts(REGISTER.format("CMD", 400, "base"), REGISTER.format("ACC", 252, "parameter")))
        self.assertIn("| CMD | 400 |", made["registers atv28"])
        self.assertNotIn("ACC", made["registers atv28"])
        self.assertIn("The 1 others: `rtuwire list --drive atv28`", made["registers atv28"])

    def test_all_of_them(self):
        self.assertTrue(kept.of_drives(self.facts(REGISTER.format("CMD", 400, "base")))["registers atv28"].endswith("| documented |"))

    def test_a_picture_has_each_arrow_once(self):
        self.assertEqual(kept.flowchart([("on", "switched off", "1: x\\n2: y"), ("switched off", "on", "z")]),
                         '```mermaid\nflowchart TD\n    s0["on"]\n    s1["switched off"]\n    s0 -->|"1: x<br>2: y"| s1\n'
                         '    s1 -->|"z"| s0\n```')

    def test_an_error_is_a_row(self):
        rows = kept.gallery.errors_page([("0x00", "none", "no error", "x", ""), ("0x80", "bad", "it is bad", "Why.", "Do this.")], place="")
        self.assertEqual(rows.splitlines()[2:], ["| `bad` 0x80 | it is bad | Why. | Do this. |"])
