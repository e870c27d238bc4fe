# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that a page without a reader is found."""
import unittest

from for_whom import complaint


class ForWhom(unittest.TestCase):
    def test_a_page(self):
        self.assertIsNone(complaint("a.md", "# A\n\nFor whoever has one. At the end ...\n\nMore.\n"))

    def test_what_is_wrong(self):
        for text in ("For whoever has one.\n", "# A\n\nWhat it is.\n\nFor whoever has one.\n", "# A\nFor whoever has one.\n", "# A\n",
                     "# A\n\n| For whoever | |\n"):
            self.assertIsNotNone(complaint("a.md", text), text)
