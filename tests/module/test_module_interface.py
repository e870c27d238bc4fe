# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Tests of packaging/module_interface.py: which names the module exports, and where."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packaging"))

import module_interface  # noqa: E402


class Interface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lines = module_interface.of_project().splitlines()

    def test_a_name_stands_in_its_namespace_once(self):
        text = module_interface.interface({"rtuwire::b", "rtuwire::a", "rtuwire::altivar::start"})
        self.assertEqual(text.removeprefix(module_interface.HEAD),
                         "export namespace rtuwire {\nusing rtuwire::a;\nusing rtuwire::b;\n} // namespace rtuwire\n\n"
                         "export namespace rtuwire::altivar {\nusing altivar::start;\n} // namespace rtuwire::altivar\n")

    def test_names_of_the_page_operators_and_what_drives_have_are_exported(self):
        for name in ("rtuwire::client", "rtuwire::operator*", "altivar::start", "atv320::device", "atv28::lfr"):
            self.assertEqual(self.lines.count(f"using {name};"), 1, name)

    def test_internal_names_ports_and_the_full_maps_are_not(self):
        for name in ("to_u8", "posix_serial", "parameters", "all_parameters", "configuration"):
            self.assertFalse([line for line in self.lines if line.endswith(f"::{name};")], name)
