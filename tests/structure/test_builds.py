# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that a header outside the namespace of the build is reported."""
import unittest

import builds

HEAD = "// A head.\n#pragma once\n\n#include <array>\n\n"
VERSION = "#include <rtuwire/core/version.hpp>\n"


class Builds(unittest.TestCase):
    def count(self, text, header="core/a.hpp"):
        return len(list(builds.complaints_of(header, text)))

    def test_the_namespace_of_the_build_is_accepted(self):
        for inner in ("", "::sim", "::altivar::atv12"):
            self.assertEqual(self.count(f"{HEAD}{VERSION}\nnamespace rtuwire::inline RTUWIRE_BUILD{inner} {{\n}}"), 0)

    def test_another_namespace_is_reported(self):
        for name in ("rtuwire", "rtuwire::sim", "rtuwire::RTUWIRE_BUILD", "rtuwire::inline v1",
                     "rtuwire::sim::inline RTUWIRE_BUILD"):
            self.assertEqual(self.count(f"{HEAD}{VERSION}namespace {name} {{\n}}"), 1, name)

    def test_the_second_namespace_is_read_too(self):
        ours = "namespace rtuwire::inline RTUWIRE_BUILD {\n}\n"
        self.assertEqual(self.count(f"{HEAD}{VERSION}{ours}namespace rtuwire::sim {{\n}}"), 1)

    def test_a_missing_or_late_include_is_reported(self):
        ours = "namespace rtuwire::inline RTUWIRE_BUILD {\n}\n"
        self.assertEqual(self.count(HEAD + ours), 1)
        self.assertEqual(self.count(HEAD + ours + VERSION), 1)
        self.assertEqual(self.count(HEAD + ours, builds.VERSION), 0)

    def test_a_declaration_outside_is_reported(self):
        self.assertEqual(self.count(f"{HEAD}{VERSION}using word = int;\n"), 1)
        self.assertEqual(self.count(f"{HEAD}int a();\n{VERSION}namespace rtuwire::inline RTUWIRE_BUILD {{\n}}"), 1)

    def test_a_door_has_includes_only(self):
        self.assertEqual(self.count(HEAD + VERSION), 0)
        self.assertEqual(self.count(HEAD + "#define A \\\n    1\n#ifdef B\n#endif\n"), 0)


if __name__ == "__main__":
    unittest.main()
