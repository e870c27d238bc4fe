# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Shows that refusal.py passes the right refusal and no other."""
import os
import pathlib
import tempfile
import unittest

import refusal

COMPILER = os.environ["RTUWIRE_COMPILER"]


class Refusal(unittest.TestCase):
    def complaint(self, source, likeliest=""):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "act.cpp")
            pathlib.Path(folder, "likeliest.txt").write_text(f"# Names.\n{likeliest}\n", encoding="utf-8")
            file.write_text(source, encoding="utf-8")
            return refusal.complaint(COMPILER, folder, str(file))

    def test_the_expected_sentence_passes(self):
        self.assertEqual(self.complaint(
            "// EXPECT: a goose is not a swan\n"
            "#ifdef REFUSED\nstatic_assert(sizeof(int) == 1, \"a goose is not a swan\");\n#endif\n"), "")

    def test_a_culprit_named_by_its_type_passes(self):
        self.assertEqual(self.complaint(
            "// EXPECT: these_overlap<1, 2>\n"
            "template <int, int> struct these_overlap;\n"
            "#ifdef REFUSED\nthese_overlap<1, 2> x;\n#endif\n"), "")

    def test_another_error_does_not_pass(self):
        self.assertIn("without saying", self.complaint(
            "// EXPECT: a goose is not a swan\n#ifdef REFUSED\nint x = \"goose\";\n#endif\n"))

    def test_an_echo_of_the_source_does_not_pass(self):
        self.assertIn("without saying", self.complaint(
            "// EXPECT: a goose\n#ifdef REFUSED\nint x = \"a goose\";\n#endif\n"))

    def test_an_accepted_act_does_not_pass(self):
        self.assertIn("is accepted", self.complaint("// EXPECT: a goose\nint x = 1;\n"))

    def test_one_accepted_case_of_several_does_not_pass(self):
        self.assertIn("is accepted with -DREFUSED=2", self.complaint(
            "// EXPECT: a goose\n// CASES: 3\n"
            "#ifdef REFUSED\nstatic_assert(REFUSED == 2, \"a goose\");\n#endif\n"))

    def test_a_sentence_among_others_passes_only_where_it_may(self):
        source = ("// EXPECT: a goose\n#ifdef REFUSED\nstatic_assert(sizeof(int) == 1, \"a goose\");\n"
                  "static_assert(sizeof(int) == 1, \"a duck\");\n#endif\n")
        self.assertEqual(self.complaint(source), "")
        self.assertIn("as one of 2 errors", self.complaint("// ALONE\n" + source))

    def test_a_file_that_never_compiles_does_not_pass(self):
        self.assertIn("as it is", self.complaint("// EXPECT: goose\nint x = goose;\n"))

    def test_a_file_without_an_expectation_does_not_pass(self):
        self.assertIn("EXPECT", self.complaint("#ifdef REFUSED\n#error no\n#endif\n"))

    def test_a_sentence_behind_the_first_lines_passes_only_where_it_may(self):
        above = "".join(f"static_assert(sizeof(int) == 1, \"a duck of {i}\");\n" for i in range(5))
        source = "// EXPECT: a goose\n#ifdef REFUSED\n" + above + "static_assert(sizeof(int) == 1, \"a goose\");\n#endif\n"
        self.assertEqual(self.complaint(source), "")
        self.assertIn("at once: it stands in line", self.complaint(source, "act  talks of ducks"))

    def test_a_sentence_behind_a_long_line_passes_only_where_it_may(self):
        source = ("// EXPECT: a goose\n#ifdef REFUSED\nstatic_assert(sizeof(int) == 1, \"" + 400 * "duck" + "\");\n"
                  "static_assert(sizeof(int) == 1, \"a goose\");\n#endif\n")
        self.assertEqual(self.complaint(source), "")
        self.assertIn("at once: line", self.complaint(source, "act"))

    def test_a_folder_however_long_makes_no_line_long(self):
        place = "/pond" * 100 + "/act.cpp:7:9"
        said = f"{place}: error: static_assert failed due to requirement 'is_goose<(lambda at {place})>' \"a goose\""
        self.assertEqual(refusal.hidden("a goose", said), "")

    def test_a_sentence_at_once_passes(self):
        self.assertEqual(self.complaint(
            "// EXPECT: a goose\n#ifdef REFUSED\nstatic_assert(sizeof(int) == 1, \"a goose\");\n#endif\n", "act"), "")

    def test_the_likeliest_mistakes_are_twenty_or_more_files(self):
        folder = pathlib.Path(__file__).parent
        names = refusal.likeliest(str(folder))
        self.assertGreaterEqual(len(set(names)), 20)
        self.assertEqual([name for name in names if not (folder / f"{name}.cpp").exists()], [])
