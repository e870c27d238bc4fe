# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The page of public servers and clients is refused where its tables and its causes differ."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from public_servers import head, line_of  # noqa: E402
from public_servers_page import complaints  # noqa: E402

KNOWN = {"L34", "X01", "F05.3", "K12"}


def table(kind, *rows):
    return [line_of(head(kind)), line_of(["---"] * 5), *map(line_of, rows), ""]


def page(causes, failing="L34 X01", of_client="K12"):
    servers = table("server", ("a 1", "1 of 3", "0 of 1", failing, "F05.3"), ("b", "3 of 3", "1 of 1", "none", "none"))
    clients = table("client", ("a 1", "3 of 3", "0 of 1", "none", "K12"))
    return "\n".join(["# Page", "", *servers, "## a 1", "", "| clauses | what |", "| --- | --- |",
                      *[f"| {each} | text |" for each in causes], "", "## b", "", "Nothing.", "", "## Clients", "", *clients,
                      "### Client of a 1", "", "| clauses | what |", "| --- | --- |", f"| {of_client} | text |", ""])


class Page(unittest.TestCase):
    def found(self, *how, **more):
        return list(complaints(page(*how, **more), KNOWN))

    def test_each_has_one_cause(self):
        self.assertEqual(self.found(["L34", "X01 F05.3"]), [])

    def test_one_has_none(self):
        self.assertEqual(self.found(["L34 F05.3"]), ["a 1, server: X01 fails, and nothing says why"])

    def test_one_has_two(self):
        self.assertEqual(self.found(["L34", "L34 X01 F05.3"]), ["a 1, server: L34 has 2 causes"])

    def test_one_does_not_fail(self):
        self.assertEqual(self.found(["L34 X01 F05.3"], failing="L34"), ["a 1, server: X01 does not fail in the table"])

    def test_one_is_no_clause(self):
        self.assertEqual(self.found(["L34 L99 F05.3"], failing="L34 L99"), ["a 1, server: L99 is no clause"])

    def test_a_client_has_causes_of_its_own(self):
        self.assertEqual(self.found(["L34", "X01 F05.3"], of_client="L34"),
                         ["a 1, client: K12 fails, and nothing says why", "a 1, client: L34 does not fail in the table"])

    def test_a_server_without_a_heading(self):
        text = page(["L34", "X01 F05.3"]).replace("\n## b\n", "\n")
        self.assertEqual(list(complaints(text, KNOWN)), ["b, server: no heading"])


if __name__ == "__main__":
    unittest.main()
