# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The picture of the tool shows what was on the terminal, as text."""
import pathlib
import sys
import unittest
import xml.etree.ElementTree

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "docs" / "generate"))
import picture  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"


class Picture(unittest.TestCase):
    def texts(self, drawn):
        return [("".join(each.itertext()), int(each.get("y"))) for each in xml.etree.ElementTree.fromstring(drawn).iter(f"{SVG}text")]

    def test_each_line_is_text_at_its_place(self):
        found = self.texts(picture.drawn([("a <b>", ["1  & 2", "", "3"]), ("c", ["4"])]))
        self.assertEqual([words for words, _ in found], ["$ a <b>", "1  & 2", "3", "$ c", "4"])
        first = found[0][1]
        self.assertEqual([(y - first) // picture.LINE for _, y in found], [0, 1, 3, 5, 6])

    def test_what_is_kept_is_small_has_a_title_and_knows_the_dark(self):
        kept = (PROJECT / "docs/pictures/tool.svg").read_text(encoding="utf-8")
        self.assertLess(len(kept.encode()), 30_000)
        self.assertEqual(xml.etree.ElementTree.fromstring(kept).find(f"{SVG}title").text, picture.TITLE)
        self.assertIn("prefers-color-scheme: dark", kept)
        self.assertIn(f"![{picture.TITLE}](docs/pictures/tool.svg)", (PROJECT / "README.md").read_text(encoding="utf-8"))
        self.assertEqual([words for words, _ in self.texts(kept) if words.startswith("$ ")], [f"$ {each}" for each in picture.SESSION])
