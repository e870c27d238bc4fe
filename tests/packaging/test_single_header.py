# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The single header: the same bytes each time, no warning from three compilers, two files of a program, each part only where
it is asked for; and what packaging/single_header.py does not know how to write is refused."""
import re
import shutil
import subprocess
import sys

from support import HERE, PROJECT, InAFolder, run

MAKER = PROJECT / "packaging" / "single_header.py"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wswitch-enum", "-Weffc++",
            "-Wold-style-cast", "-Werror"]
COMPILERS = {"g++": ["-Wuseless-cast"], "clang++": ["-Wcomma"], "clang++-19": ["-Wcomma"]}
EVERYTHING = "#define RTUWIRE_PORT\n#define RTUWIRE_PRINT\n#define RTUWIRE_PARAMETERS\n#include <rtuwire.hpp>\n"


def make(output, *options):
    return run(sys.executable, "-B", MAKER, output, *options)


class SingleHeader(InAFolder):
    def setUp(self):
        super().setUp()
        self.one = self.place / "rtuwire.hpp"
        make(self.one)

    def file(self, name, text):
        (self.place / name).write_text(text, encoding="utf-8")
        return self.place / name

    def test_it_is_the_same_when_made_again(self):
        again = self.place / "elsewhere" / "again.hpp"
        make(again)
        self.assertEqual(again.read_bytes(), self.one.read_bytes())

    def test_no_compiler_warns(self):
        program = self.file("main.cpp", EVERYTHING + "int main() {}\n")
        for compiler, further in COMPILERS.items():
            with self.subTest(compiler):
                run(compiler, "-std=c++20", "-fsyntax-only", "-I", self.place, *WARNINGS, *further, program)

    def test_a_warning_would_be_seen(self):
        self.one.write_text(self.one.read_text(encoding="utf-8") + "inline char narrowed(int a) { return a; }\n",
                            encoding="utf-8")
        program = self.file("main.cpp", "#include <rtuwire.hpp>\nint main() {}\n")
        with self.assertRaisesRegex(AssertionError, "-Werror=conversion"):
            run("g++", "-std=c++20", "-fsyntax-only", "-I", self.place, *WARNINGS, program)

    def test_two_files_of_a_program(self):
        flags = ["-std=c++20", "-I", self.place, "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]
        first = self.file("first.cpp", (HERE / "single_first.cpp").read_text(encoding="utf-8"))
        second = self.file("second.cpp", (HERE / "single_second.cpp").read_text(encoding="utf-8"))
        run("g++", *flags, first, second, "-o", self.place / "program")
        self.assertEqual(run(self.place / "program"), "no response in time\n")

    def test_a_part_that_is_not_asked_for_is_not_there(self):
        uses = {"RTUWIRE_PORT": "rtuwire::posix_serial port;",
                "RTUWIRE_PRINT": "void show(std::ostream& out) { out << rtuwire::errc::timed_out; }",
                "RTUWIRE_PARAMETERS": "auto const& rows = rtuwire::altivar::atv320::parameters;"}
        for name, code in uses.items():
            asked = self.file("asked.cpp", f"#define {name}\n#include <rtuwire.hpp>\n{code}\n")
            plain = self.file("plain.cpp", f"#include <rtuwire.hpp>\n{code}\n")
            with self.subTest(name):
                run("g++", "-std=c++20", "-fsyntax-only", "-I", self.place, asked)
                with self.assertRaisesRegex(AssertionError, "error:"):
                    run("g++", "-std=c++20", "-fsyntax-only", "-I", self.place, plain)

    def test_a_part_may_be_asked_for_later(self):
        later = self.file("later.cpp", "#include <rtuwire.hpp>\n#define RTUWIRE_PORT\n#include <rtuwire.hpp>\n"
                          "rtuwire::posix_serial port;\n")
        run("g++", "-std=c++20", "-fsyntax-only", "-I", self.place, later)

    def changed(self, name, change):
        """The headers, of which one is changed."""
        copy = self.place / "include"
        shutil.copytree(PROJECT / "include", copy)
        (copy / name).write_text(change((copy / name).read_text(encoding="utf-8")), encoding="utf-8")
        return copy

    def test_a_part_includes_what_another_that_may_be_missing_includes_too(self):
        copy = self.changed("rtuwire/print.hpp", lambda text: text.replace("#pragma once", "#pragma once\n#include <fcntl.h>", 1))
        make(self.one, "--headers", copy)
        parts = re.split(r"(?m)^#define RTUWIRE_HAS_(?=\w+$)", self.one.read_text(encoding="utf-8"))
        self.assertEqual([part.partition("\n")[0] for part in parts if "#include <fcntl.h>" in part], ["PORT", "PRINT"])

    def refused(self, name, change):
        """What the maker says of headers of which one is changed."""
        copy = self.changed(name, change)
        output = self.place / "refused.hpp"
        done = subprocess.run([sys.executable, "-B", MAKER, output, "--headers", copy], text=True, stderr=subprocess.PIPE,
                              check=False)
        self.assertEqual((done.returncode, output.exists()), (1, False))
        shutil.rmtree(copy)
        return done.stderr

    def test_what_it_does_not_know_is_refused_by_name(self):
        def conditional(text):
            return text.replace("#pragma once", "#pragma once\n#if 1\n#include <rtuwire/core/bytes.hpp>\n#endif", 1)

        def quoted(text):
            return text.replace("#pragma once", '#pragma once\n#include "bytes.hpp"', 1)

        def of_another_part(text):
            return text.replace("#pragma once", "#pragma once\n#include <rtuwire/port/descriptor.hpp>", 1)

        self.assertRegex(self.refused("rtuwire/core/hex.hpp", conditional), r"core/hex\.hpp: .* under a condition")
        self.assertRegex(self.refused("rtuwire/core/hex.hpp", quoted), r"core/hex\.hpp: #include \"bytes\.hpp\"")
        self.assertRegex(self.refused("rtuwire/print.hpp", of_another_part), "RTUWIRE_PRINT needs it, and only RTUWIRE_PORT")
        self.assertRegex(self.refused("rtuwire/port.hpp", lambda text: re.sub(r".*pseudo_terminal.*\n", "", text)),
                         r"no door reaches rtuwire/port/pseudo_terminal\.hpp")
