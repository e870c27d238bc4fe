# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A link that leads nowhere on a git host is seen."""
import pathlib
import tempfile
import unittest

import page_links


class Links(unittest.TestCase):
    def found(self, text, **others):
        pages = {"docs/a.md": text, **{f"docs/{name}.md": words for name, words in others.items()}}
        with tempfile.TemporaryDirectory() as place:
            for name, words in pages.items():
                path = pathlib.Path(place, name)
                path.parent.mkdir(exist_ok=True)
                path.write_text(words, encoding="utf-8")
            pathlib.Path(place, "build").mkdir()
            return list(page_links.broken(pathlib.Path(place), pages))

    def test_links_that_lead_somewhere(self):
        text = "# One\n[b](b.md#a-part-with-code) ![p](../docs/b.md) [x](#one) [out](https://nobody.invalid/) [all](../docs)\n"
        self.assertEqual(self.found(text, b="## A part, with `code`\n"), [])

    def test_links_that_do_not(self):
        for link, wrong in (("c.md", "no such file"), ("B.md", "no such file"), ("b.md#none", "no such heading"), ("#none", "no such heading"),
                            ("../../c", "leads out of the tree"), ("/docs/b.md", "leads out of the tree"),
                            ("../build", "is built, and not in the tree"), ("b.md/c", "no such file")):
            for text in (f"# A\n\n[x]({link})\n", f"# A\n\n![x]({link})\n", f'# A\n\n<img src="{link}">\n', f"# A\n\n[x]: {link}\n"):
                self.assertEqual(self.found(text, b="# B\n"), [f"docs/a.md:3: {link}: {wrong}"])

    def test_code_has_no_links(self):
        self.assertEqual(self.found("`[x](c.md)` ``a ` [x](c.md)``\n```\n[x](c.md)\n# No\n```\n"), [])
        self.assertEqual(len(self.found("```\n# No\n```\n[x](#no)\n")), 1)

    def test_anchors_by_the_rules_of_git_hosts(self):
        for heading, name in (("What it costs", "what-it-costs"), ("A `word_bank<16>`, or two", "a-word_bank16-or-two"), ("It's 8E1 - or not?", "its-8e1---or-not"),
                              ("See [the page](b.md)", "see-the-page"), ("**Bold** and _so_", "bold-and-so"), ("0000 / 1", "0000--1")):
            self.assertEqual(page_links.anchor(heading), name)
        self.assertEqual(page_links.anchors('# A\n## A\n### A\n| <a id="row"></a>x |\n'), {"a", "a-1", "a-2", "row"})


if __name__ == "__main__":
    unittest.main()
