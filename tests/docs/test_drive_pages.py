# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What holds the pages of the drives to their template sees what is missing, added, or in another order."""
import unittest

import drive_pages

TEMPLATE = drive_pages.template("# SPDX-x\n# words\n\n# {page}\n\nA drive of {...}.\n\n{...}\n\n## End\n\nAll of\nit.\n")


class Template(unittest.TestCase):
    def unlike(self, text):
        return drive_pages.unlike(TEMPLATE, drive_pages.paragraphs(text), "atv1")

    def test_a_page_with_something_of_its_own(self):
        for own in ("", "Own.\n\n```cpp\nint a;\n\nint b;\n```\n\nMore.\n\n"):
            self.assertEqual(self.unlike(f"# atv1\n\nA drive of 1999.\n\n{own}## End\n\nAll\nof it.\n"), "")

    def test_a_page_that_lacks_a_paragraph(self):
        self.assertIn("lacks 'All of it.'", self.unlike("# atv1\n\nA drive of 1999.\n\n## End\n"))

    def test_a_page_with_another_word(self):
        self.assertIn("lacks 'All of it.' where it has 'Some of it.'", self.unlike("# atv1\n\nA drive of 1999.\n\n## End\n\nSome of it.\n"))

    def test_a_page_with_more_where_nothing_is_its_own(self):
        self.assertIn("'Own.'", self.unlike("# atv1\n\nOwn.\n\nA drive of 1999.\n\n## End\n\nAll of it.\n"))
        self.assertIn("more than its template: 'Own.'", self.unlike("# atv1\n\nA drive of 1999.\n\n## End\n\nAll of it.\n\nOwn.\n"))

    def test_a_page_of_another_drive(self):
        self.assertIn("lacks '# {page}'", self.unlike("# atv2\n\nA drive of 1999.\n\n## End\n\nAll of it.\n"))


if __name__ == "__main__":
    unittest.main()
