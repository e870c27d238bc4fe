# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The library's CMake files, as CMake 3.16 would read them: with its version given out as 3.16, nothing that came later is
used. The list of what came later is that of CMake's release notes as far as a project of this kind may meet it."""
import json
import pathlib

from support import LIBRARY_ALONE, PROJECT, InAFolder, run

OLDEST = PROJECT / "tests" / "packaging" / "cmake_3_16.cmake"
# Commands, and words among the arguments of a command, by the version that brought them.
COMMANDS = {"cmake_language": "3.18", "cmake_path": "3.20", "block": "3.25", "endblock": "3.25"}
WORDS = {
    ("target_sources", "FILE_SET"): "3.23", ("install", "FILE_SET"): "3.23", ("install", "RUNTIME_DEPENDENCIES"): "3.21",
    ("install", "IMPORTED_RUNTIME_ARTIFACTS"): "3.21", ("file", "CONFIGURE"): "3.18", ("file", "ARCHIVE_CREATE"): "3.18",
    ("file", "ARCHIVE_EXTRACT"): "3.18", ("file", "REAL_PATH"): "3.19", ("file", "CHMOD"): "3.19",
    ("file", "COPY_FILE"): "3.21", ("string", "JSON"): "3.19", ("return", "PROPAGATE"): "3.25",
    ("find_package", "GLOBAL"): "3.24", ("find_program", "REQUIRED"): "3.18", ("find_library", "REQUIRED"): "3.18",
    ("find_path", "REQUIRED"): "3.18", ("find_program", "VALIDATOR"): "3.25",
    ("configure_file", "NO_SOURCE_PERMISSIONS"): "3.19", ("configure_file", "USE_SOURCE_PERMISSIONS"): "3.20",
    ("add_custom_command", "DEPENDS_EXPLICIT_ONLY"): "3.27", ("foreach", "ZIP_LISTS"): "3.17",
    ("project", "COMPAT_VERSION"): "4.1",
}
VARIABLES = {"PROJECT_IS_TOP_LEVEL": "3.21", "CMAKE_CURRENT_FUNCTION_LIST_DIR": "3.17", "CMAKE_CURRENT_FUNCTION": "3.17",
             "$<TARGET_RUNTIME_DLLS": "3.21", "$<CONFIG:Debug,": "3.19", "BUILD_LOCAL_INTERFACE": "3.26"}


def newer(calls, since=(3, 16)):
    """What each call uses that came after a version."""
    def after(text):
        return tuple(map(int, text.split("."))) > since
    for call in calls:
        command, words = call["cmd"].lower(), call["args"]
        place = f"{pathlib.Path(call['file']).name}:{call['line']}"
        if after(COMMANDS.get(command, "0")):
            yield f"{place}: {command} is of CMake {COMMANDS[command]}"
        for word in words:
            if after(WORDS.get((command, word), "0")):
                yield f"{place}: {command} with {word} is of CMake {WORDS[command, word]}"


def texts(files):
    """Variables and generator expressions that came later: a file that names one does so in no version's guard."""
    for path in files:
        for name, since in VARIABLES.items():
            if tuple(map(int, since.split("."))) > (3, 16) and name in path.read_text(encoding="utf-8"):
                yield f"{path.name}: {name} is of CMake {since}"


def calls_of(place, source, *options):
    """The calls of a configuration that come from the project's own files, and which files those are."""
    trace = pathlib.Path(place, "trace.json")
    run("cmake", "-S", source, "-B", pathlib.Path(place, "build"), "-G", "Ninja", "--trace", "--trace-format=json-v1",
        f"--trace-redirect={trace}", *options)
    lines = [json.loads(line) for line in trace.read_text(encoding="utf-8").splitlines()]
    own = [line for line in lines if line.get("file", "").startswith(f"{source}/") and line["file"] != str(OLDEST)]
    return own, sorted({pathlib.Path(line["file"]) for line in own})


class OlderCMake(InAFolder):
    def test_the_library_the_examples_and_the_tool_use_nothing_newer(self):
        calls, files = calls_of(self.place, PROJECT, f"-DCMAKE_PROJECT_INCLUDE={OLDEST}")
        read = {path.relative_to(PROJECT).as_posix() for path in files}
        self.assertLessEqual({"CMakeLists.txt", "cmake/install.cmake", "cmake/install_tool.cmake", "cmake/warnings.cmake",
                              "examples/CMakeLists.txt", "tools/rtuwire/CMakeLists.txt"}, read)
        self.assertNotIn("tests/CMakeLists.txt", read)
        self.assertEqual([*newer(calls), *texts(files)], [])

    def test_what_a_later_one_uses_is_seen(self):
        calls, _ = calls_of(self.place, PROJECT, *LIBRARY_ALONE)
        self.assertTrue(any("FILE_SET" in complaint for complaint in newer(calls)))

    def test_tests_are_refused_in_words(self):
        with self.assertRaisesRegex(AssertionError, r"need CMake 3.23 or\s+later, and\s+this\s+is\s+3.16"):
            calls_of(self.place, PROJECT, f"-DCMAKE_PROJECT_INCLUDE={OLDEST}", "-DRTUWIRE_BUILD_TESTS=ON")

    def test_an_installation_by_an_older_one_is_the_same(self):
        trees = []
        for name, options in {"new": [], "old": [f"-DCMAKE_PROJECT_INCLUDE={OLDEST}"]}.items():
            tree, prefix = pathlib.Path(self.place, name), pathlib.Path(self.place, f"{name}-prefix")
            run("cmake", "-S", PROJECT, "-B", tree, "-G", "Ninja", *LIBRARY_ALONE, *options)
            run("cmake", "--install", tree, "--prefix", prefix)
            trees.append({path.relative_to(prefix).as_posix(): path.read_bytes() for path in prefix.rglob("*")
                          if path.is_file()})
        new, old = trees
        self.assertEqual(sorted(new), sorted(old))
        # A reader of 3.16 knows no file set, so the folder is named apart from it.
        config = "share/cmake/rtuwire/rtuwire-config.cmake"
        for tree in trees:
            self.assertIn(b'INTERFACE_INCLUDE_DIRECTORIES "${_IMPORT_PREFIX}/include"', tree[config])
        self.assertEqual([name for name in new if name != config and new[name] != old[name]], [])
