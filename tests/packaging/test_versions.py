# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that each place which names another version is reported, by name."""
import pathlib
import shutil
import tempfile
import unittest

import versions
from support import PROJECT, version

# By place: what is changed there, and to what.
CHANGES = {
    "library.json": (f'"version": "{version()}"', '"version": "9.9.9"'),
    "idf_component.yml": (f'version: "{version()}"', 'version: "9.9.9"'),
    "packaging/debian/changelog": (f"rtuwire ({version()}-1)", "rtuwire (9.9.9-1)"),
    "packaging/meson/meson.build": ("@VERSION@", version()),
    "CMakeLists.txt": ('VERSION "${rtuwire_major}', 'VERSION "9.9.9"  # "${rtuwire_major}'),
}


class Versions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in (versions.DECIDED, *CHANGES, *versions.FILLED):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(PROJECT / name, self.root / name)

    def test_the_project_agrees(self):
        self.assertEqual(list(versions.complaints(self.root)), [])

    def test_each_change_is_reported(self):
        for place, (old, new) in CHANGES.items():
            with self.subTest(place):
                text = (self.root / place).read_text(encoding="utf-8")
                self.assertIn(old, text)
                (self.root / place).write_text(text.replace(old, new, 1), encoding="utf-8")
                found = list(versions.complaints(self.root))
                self.assertTrue(found and all(each.startswith(place) for each in found), found)
                (self.root / place).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    unittest.main(verbosity=2)
