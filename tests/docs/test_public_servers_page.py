# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The page of public servers is refused where its table and its causes differ."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from public_servers import HEAD, line_of  # noqa: E402
from public_servers_page import complaints  # noqa: E402

KNOWN = {"L34", "X01", "F05.3"}


def page(causes, failing="L34 X01"):
    rows = [line_of(HEAD), line_of(["---"] * 5), line_of(("a 1", "1 of 3", "0 of 1", failing, "F05.3")),
            line_of(("b", "3 of 3", "1 of 1", "none", "none"))]
    return "\n".join(["# Page", "", *rows, "", "## a 1", "", "| clauses | what |", "| --- | --- |",
                      *[f"| {each} | text |" for each in causes], "", "## b", "", "Nothing.", ""])


class Page(unittest.TestCase):
    def found(self, *how, **more):
        return list(complaints(page(*how, **more), KNOWN))

    def test_each_has_one_cause(self):
        self.assertEqual(self.found(["L34", "X01 F05.3"]), [])

    def test_one_has_none(self):
        self.assertEqual(self.found(["L34 F05.3"]), ["a 1: X01 fails, and nothing says why"])

    def test_one_has_two(self):
        self.assertEqual(self.found(["L34", "L34 X01 F05.3"]), ["a 1: L34 has 2 causes"])

    def test_one_does_not_fail(self):
        self.assertEqual(self.found(["L34 X01 F05.3"], failing="L34"), ["a 1: X01 does not fail in the table"])

    def test_one_is_no_clause(self):
        self.assertEqual(self.found(["L34 L99 F05.3"], failing="L34 L99"), ["a 1: L99 is no clause"])

    def test_a_server_without_a_heading(self):
        text = page(["L34", "X01 F05.3"]).replace("\n## b\n", "\n")
        self.assertEqual(list(complaints(text, KNOWN)), ["b: no heading"])


if __name__ == "__main__":
    unittest.main()
