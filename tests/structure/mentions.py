# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds what pages and the comments of programs mention to what there is: a name stands somewhere in the code, a file lies
where it is said to, an example has that number. A header lies where the list of changes and those of mutations name it.

    python3 mentions.py PROJECT
"""
import pathlib
import re
import sys

PAGES = ("README.md", "docs/**/*.md")
PROGRAMS = ("examples", "docs/snippets")
# Where a name may come from: code, and files that tools read; no page, and no list of names to be refused.
SOURCES = ("include", "tools", "examples", "docs", "packaging", "bench", "cmake", "fuzz", "tests")
NO_SOURCE = ("tests/structure/", "build/")
C_LIKE = (".hpp", ".cpp", ".h", ".c", ".mjs", ".js", ".ino")

FENCED = re.compile(r"```.*?```", re.DOTALL)
INLINE = re.compile(r"`([^`\n]+)`")
LINE_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//(?P<said>[^\n]*)')
WORD = re.compile(r"[A-Za-z_]\w*")
# What reads like a name of the code: of several words, qualified, or called.
NAME = re.compile(r"(?<=::)[A-Za-z]\w*|(?<!\w)[A-Za-z]\w*(?:(?=::|[({])|_\w+)")
EXAMPLE = re.compile(r"(?<![\w/.])(?:examples/)?(\d\d_[a-z]\w+)(?:\.cpp)?(?![\w/])")
# A file as it lies in the project; NAME in capitals is any name.
FILE = re.compile(r"(?<![\w/.-])(?:include|examples|docs|tests|tools|packaging|bench|cmake)/[\w./-]*\w")
ANY = re.compile(r"\b[A-Z]{4,}\b")

# Where headers stand by their place below include/rtuwire: in tables that say where they are now, and first in each row of a list.
MOVES, MOVED = "CHANGELOG.md", "| now | before |\n"
LISTS = {"tests/mutation/tried.txt": "once", "tests/mutation/open.txt": "often", "tests/mutation/survivors.txt": "often"}

# Names that others gave, or that a program puts together.
OF_LIBRARIES = re.compile(r"(?:modbus|nmbs|NMBS)_\w+")
OF_OTHERS = {
    "docs/boards.md": {"HAL_TIM_Base_Start", "HAL_TIM_Base_Start_IT", "HAL_RS485Ex_Init", "CMAKE_CXX_STANDARD", "pico_stdlib",
                       "hardware_uart", "hardware_irq", "CONFIG_SYS_CLOCK_TICKS_PER_SEC", "CONFIG_FREERTOS_HZ",
                       "CONFIG_CPP", "CONFIG_STD_CPP20", "CONFIG_REQUIRES_FULL_LIBCPP", "CONFIG_SERIAL",
                       "CONFIG_UART_INTERRUPT_DRIVEN", "CONFIG_GPIO", "k_cycle_get_32",
                       "configMAX_SYSCALL_INTERRUPT_PRIORITY"},
    "docs/coming-from.md": {"no_response_expected", "read_port", "write_port", "requestFrom", "HOLDING_REGISTERS"},
    "docs/engine-rules.md": {"chars"},
    "docs/gateway.md": {"mqtt_consumer", "data_format", "json_v2", "acl_file"},
    "docs/hosts.md": {"lws2_32", "dead_strip"},
    "docs/packaging.md": {"DZEPHYR_EXTRA_MODULES"},
    "docs/public-servers.md": {"check_confirmation"},
    "docs/registers.md": {"v_sf"},
    "docs/serve.md": {"rtuwire_serve_port_losses_total", "ssl_verify_client", "proxy_pass"},
    "docs/tool.md": {"input_1000", "model_103"},
    "docs/wireshark.md": {"packet_flags_direction"},
}


def without_comments(text):
    """The code of a C++ file and its string literals."""
    return re.sub(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', lambda found: found[1] or " ", text, flags=re.DOTALL)


def words_of(path, text):
    return set(WORD.findall(without_comments(text) if path.endswith(C_LIKE) else text))


def sayings_of_page(text):
    """What stands in backticks within a line, with the number of its line."""
    plain = FENCED.sub(lambda found: "\n" * found.group().count("\n"), text)
    for found in INLINE.finditer(plain):
        yield plain.count("\n", 0, found.start()) + 1, found[1]


def sayings_of_program(text):
    """What comments say, with the number of their line."""
    for found in LINE_COMMENT.finditer(text):
        if found["said"]:
            yield text.count("\n", 0, found.start()) + 1, found["said"]


def wrong_in(page, sayings, known, files, examples):
    """What is mentioned and is not there."""
    others = OF_OTHERS.get(page, set())
    for line, saying in sayings:
        for name in EXAMPLE.findall(saying):
            if name not in examples:
                yield f"{page}:{line}: there is no example {name}"
        for path in FILE.findall(saying):
            if path not in files and pathlib.PurePath(path).suffix and not ANY.search(path):
                yield f"{page}:{line}: there is no file {path}"
        for name in NAME.findall(EXAMPLE.sub(" ", FILE.sub(" ", saying))):
            if name not in known and name not in others and not OF_LIBRARIES.fullmatch(name):
                yield f"{page}:{line}: {name} is no name of the code"


def wrong_moves(path, text, headers):
    """Headers that are said to be there now, and are not; folders end with a slash."""
    tables = text.split(MOVED)
    if len(tables) == 1:
        yield f"{path}: no table says where headers are now"
    line = 1
    for before, table in zip(tables, tables[1:]):
        line += before.count("\n") + 1
        for at, row in enumerate(table.partition("\n\n")[0].splitlines()[1:], line + 1):
            for place in INLINE.findall(row.split(" | ")[0]):
                if place not in headers and not (place.endswith("/") and any(each.startswith(place) for each in headers)):
                    yield f"{path}:{at}: there is no header {place}"


def wrong_rows(path, text, headers, how_often):
    """Rows about a header that is not there, or that has one already."""
    seen = set()
    for line, row in enumerate(text.splitlines(), 1):
        header = row.partition(" | ")[0]
        if row.startswith("#"):
            continue
        if header not in headers:
            yield f"{path}:{line}: there is no header {header}"
        if how_often == "once" and header in seen:
            yield f"{path}:{line}: {header} has a row already"
        seen.add(header)


def main(project):
    root = pathlib.Path(project)
    known, files = set(), set()
    for folder in SOURCES:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.is_file() and "/__pycache__/" not in name:
                files.add(name)
                if path.suffix != ".md" and not name.startswith(NO_SOURCE):
                    known |= words_of(name, path.read_text(encoding="utf-8", errors="replace"))
    examples = {path.stem for path in (root / "examples").glob("*.cpp")}
    found, sayings = [], 0
    for path in (page for pattern in PAGES for page in sorted(root.glob(pattern))):
        of_page = list(sayings_of_page(path.read_text(encoding="utf-8")))
        sayings += len(of_page)
        found += wrong_in(path.relative_to(root).as_posix(), of_page, known, files, examples)
    for folder in PROGRAMS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            of_program = list(sayings_of_program(path.read_text(encoding="utf-8")))
            sayings += len(of_program)
            found += wrong_in(path.relative_to(root).as_posix(), of_program, known, files, examples)
    headers = {path.removeprefix("include/rtuwire/") for path in files if path.startswith("include/rtuwire/")}
    found += wrong_moves(MOVES, (root / MOVES).read_text(encoding="utf-8"), headers)
    for path, how_often in LISTS.items():
        found += wrong_rows(path, (root / path).read_text(encoding="utf-8"), headers, how_often)
    print("\n".join(found) or f"{sayings} mentions are of what there is")
    return 1 if found or not sayings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
