# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that each place which names another version is reported, by name."""
import shutil

import versions
from support import DECIDED, PROJECT, InAFolder, version

# By place: what is changed there, and to what.
CHANGES = {
    "library.json": (f'"version": "{version()}"', '"version": "9.9.9"'),
    "idf_component.yml": (f'version: "{version()}"', 'version: "9.9.9"'),
    "CHANGELOG.md": (f"## {version()}", "## 9.9.9"),
    "packaging/debian/changelog": (f"rtuwire ({version()}-1)", "rtuwire (9.9.9-1)"),
    "packaging/meson/meson.build": ("@VERSION@", version()),
    "README.md": (f"rtuwire-{version()}-linux", "rtuwire-9.9.9-linux"),
    "docs/packaging.md": (f"/rtuwire-{version()}.tar.gz", "/rtuwire-9.9.9.tar.gz"),
    "docs/start/tool.md": (f"rtuwire-{version()}-linux", "rtuwire-9.9.9-linux"),
    "packaging/debian/tests/headers": (f"find_package(rtuwire {version().rpartition('.')[0]} ", "find_package(rtuwire 9.9 "),
    "tests/consumer/find_package/CMakeLists.txt": ("find_package(rtuwire 0", "find_package(rtuwire 9"),
    "tests/packaging/consumer/meson/meson.build": ("version: '>=", "version: '>=9"),
    "CMakeLists.txt": ('VERSION "${rtuwire_major}', 'VERSION "9.9.9"  # "${rtuwire_major}'),
}


class Versions(InAFolder):
    def setUp(self):
        super().setUp()
        for name in (DECIDED, *CHANGES, *versions.FILLED):
            (self.place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(PROJECT / name, self.place / name)

    def test_the_project_agrees(self):
        self.assertEqual(list(versions.complaints(self.place)), [])

    def test_each_change_is_reported(self):
        for place, (old, new) in CHANGES.items():
            with self.subTest(place):
                text = (self.place / place).read_text(encoding="utf-8")
                self.assertIn(old, text)
                (self.place / place).write_text(text.replace(old, new, 1), encoding="utf-8")
                found = list(versions.complaints(self.place))
                self.assertTrue(found and all(each.startswith(place) for each in found), found)
                (self.place / place).write_text(text, encoding="utf-8")
