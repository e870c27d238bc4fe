# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles each board's file for its processors, and holds what stands for a maker's headers to what these declare: facts/
says it as types and compiles with the real headers, too."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
BOARDS = sorted(path.stem for path in (PROJECT / "examples/boards").glob("*.cpp") if (HERE / f"{path.stem}.cpp").exists())
STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]
SMALL = ["-Os", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"]
# A declaration of a function, or of a pointer to one: what it returns, its name, what it takes.
DECLARATION = re.compile(r"^(?P<before> *(?:virtual )?(?!return|typedef|inline|#)[\w:]+[\w: *&]*?[ *&(]+)(?P<name>\w+\)?)\((?P<takes>[^()]*)\)"
                         r"(?P<after>(?: = 0| override)?;)$", re.MULTILINE)


def stand_ins(board):
    return HERE / "stand_ins" / board


def run(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    return done.returncode == 0, done.stderr


def facts(board, headers):
    return run([os.environ["RTUWIRE_COMPILER"], "-std=c++20", "-fsyntax-only", "-w", "-I", headers, HERE / "facts" / f"{board}.cpp"])


def arm_headers():
    """Where the Arm toolchain has the headers of C++ and C, most of them the same for any 32-bit processor."""
    told = subprocess.run(["arm-none-eabi-g++", "-mthumb", "-mcpu=cortex-m0plus", "-E", "-v", "-x", "c++", "/dev/null"],
                          capture_output=True, text=True, check=True).stderr
    return re.findall(r"^ (/\S*(?:c\+\+\S*|/arm-none-eabi/include))$", told, re.MULTILINE)


def compiler_for(processor):
    if processor.startswith("cortex"):
        return ["arm-none-eabi-g++", "-mthumb", f"-mcpu={processor}"]
    foreign = ["-nostdinc++", *(word for folder in arm_headers() for word in ("-isystem", folder))]
    if processor.startswith("rv32"):
        return ["riscv64-unknown-elf-g++", f"-march={processor}", "-mabi=ilp32", *foreign]
    return [f"xtensa-{processor}-elf-g++", *foreign]


def with_another_parameter(found):
    takes = f"double{', ' if found['takes'] else ''}{found['takes']}"
    return f"{found['before']}{found['name']}({takes}){found['after']}"


def with_another_result(found):
    indent = re.match(r" *(?:virtual )?", found["before"])[0]
    star = "(*" if found["name"].endswith(")") else ""
    return f"{indent}stand_in_other {star}{found['name']}({found['takes']}){found['after']}"


def unseen_changes(board, change):
    """The functions of the stand-in that may be declared in another way, which no fact refuses; and how many there are."""
    with tempfile.TemporaryDirectory() as place:
        shutil.copytree(stand_ins(board), place, dirs_exist_ok=True)
        names = set()
        for path in pathlib.Path(place).rglob("*.h"):
            text = path.read_text(encoding="utf-8")
            names |= {found["name"].rstrip(")") for found in DECLARATION.finditer(text) if not found["name"].startswith("stand_in_")}
            text = DECLARATION.sub(lambda found: found[0] if found["name"].startswith("stand_in_") else change(found), text)
            path.write_text(text.replace("#pragma once\n", "#pragma once\nstruct stand_in_other;\n", 1), encoding="utf-8")
        said = facts(board, place)[1]
    lines = (HERE / "facts" / f"{board}.cpp").read_text(encoding="utf-8").splitlines()
    refused = "\n".join(lines[int(number) - 1] for number in re.findall(r"facts/\w+\.cpp:(\d+):", said))
    return {name for name in names if not re.search(rf"\b{name}\b", refused)}, len(names)


class Boards(unittest.TestCase):
    def test_there_are_some(self):
        self.assertGreaterEqual(len(BOARDS), 1)

    def test_each_is_40_to_80_lines_to_copy(self):
        for path in sorted((PROJECT / "examples/boards").glob("*.cpp")):
            with self.subTest(path.stem):
                lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.strip() and not line.lstrip().startswith("//")]
                self.assertIn(len(lines), range(40, 81))

    def test_stand_ins_are_as_the_makers_headers(self):
        for board in BOARDS:
            with self.subTest(board):
                if (HERE / "facts" / f"{board}.cpp").exists():
                    self.assertEqual(facts(board, stand_ins(board)), (True, ""))
                else:
                    self.assertEqual(board, "bare_cortex_m", "that one has no maker")

    def test_another_declaration_is_refused(self):
        for board in [each for each in BOARDS if each != "bare_cortex_m"]:
            for change in (with_another_parameter, with_another_result):
                with self.subTest(board, change=change.__name__):
                    unseen, count = unseen_changes(board, change)
                    self.assertEqual(unseen, set())
                    self.assertGreater(count, 8)

    def test_each_compiles_for_its_processors(self):
        for board in BOARDS:
            text = (HERE / f"{board}.cpp").read_text(encoding="utf-8")
            for processor in re.search(r"^// PROCESSORS: (.*)$", text, re.MULTILINE)[1].split():
                command = compiler_for(processor)
                with self.subTest(board, processor=processor), tempfile.TemporaryDirectory() as place:
                    self.assertTrue(shutil.which(command[0]), f"{command[0]}: sh tests/packages.sh arm portability")
                    self.assertEqual(run([*command, *STRICT, *SMALL, "-I", PROJECT / "include", "-I", stand_ins(board),
                                          "-I", PROJECT / "examples/firmware", "-c", "-o", f"{place}/board.o",
                                          PROJECT / "examples/boards" / f"{board}.cpp"]), (True, ""))
