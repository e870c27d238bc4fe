# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Tests of exports.py: a module that drifts from the page is seen, either way."""
import unittest

import exports

PUBLIC = {"rtuwire::client", "rtuwire::operator+", "rtuwire::altivar::start"}
MODULE = "module;\n#include <rtuwire/rtuwire.hpp>\nexport module rtuwire;\n" + exports.written(PUBLIC)


class Differences(unittest.TestCase):
    def test_a_list_that_was_written_is_the_same(self):
        self.assertEqual(exports.differences(PUBLIC, MODULE), [])

    def test_a_public_name_that_is_not_exported(self):
        found = exports.differences(PUBLIC | {"rtuwire::server"}, MODULE)
        self.assertEqual(found, [f"{exports.MODULE}: rtuwire::server is public and not exported"])

    def test_an_exported_name_that_is_not_public(self):
        found = exports.differences(PUBLIC - {"rtuwire::altivar::start"}, MODULE)
        self.assertEqual(found, [f"{exports.MODULE}: rtuwire::altivar::start is exported and not public"])

    def test_a_name_in_another_namespace(self):
        found = exports.differences(PUBLIC, MODULE.replace("namespace rtuwire::altivar", "namespace rtuwire::sim"))
        self.assertEqual(len(found), 2)

    def test_a_name_that_stands_there_twice(self):
        found = exports.differences(PUBLIC, MODULE.replace("using rtuwire::client;\n", "using rtuwire::client;\n" * 2))
        self.assertEqual(found, [f"{exports.MODULE}: rtuwire::client stands there twice"])

    def test_a_using_outside_of_the_list(self):
        found = exports.differences(PUBLIC, MODULE + "export using rtuwire::server;\n")
        self.assertEqual(len(found), 1)
