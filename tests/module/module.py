# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds the module `rtuwire` with Clang, and runs programs that import it.

    python3 module.py COMPILER PROJECT

By calls of the compiler: CMake before 3.28 builds no modules. With each standard library that is here.
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = ("libstdc++", "libc++")
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
PROGRAMS = {"a client, a server and a drive": ["program.cpp"], "beside port.hpp": ["host.cpp"],
            "before port.hpp": ["-DIMPORT_FIRST", "host.cpp"]}
# What a program does not get: an internal name, a macro, a name of another door.
REFUSED = {"int main() { return rtuwire::to_u8(std::byte{}); }": "to_u8",
           "int main() { return RTUWIRE_VERSION; }": "RTUWIRE_VERSION",
           "int main() { rtuwire::posix_serial port; }": "posix_serial"}
ACCEPTED = "int main() { return rtuwire::version == 0 ? 1 : 0; }"


class Build:
    """The module for one standard library, in a folder."""

    def __init__(self, compiler, project, library, folder):
        self.begin = [compiler, "-std=c++20", "-pthread", f"-stdlib={library}", "-I", str(project / "include"), *WARNINGS]
        self.made = pathlib.Path(folder, "rtuwire.pcm")
        self.program = pathlib.Path(folder, "program")
        self.maker = project / "packaging" / "module_interface.py"
        self.interface = pathlib.Path(folder, "rtuwire.cppm")

    def run(self, *words, text=None):
        return subprocess.run([*self.begin, *map(str, words)], input=text, text=True, check=False, cwd=HERE,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def precompile(self):
        subprocess.run([sys.executable, "-B", self.maker, self.interface], check=True)
        return self.run("--precompile", self.interface, "-o", self.made)

    def compile(self, *words, text=None):
        return self.run(f"-fmodule-file=rtuwire={self.made}", *words, text=text)


def has(compiler, library):
    """Whether the compiler has the headers of a standard library and its binaries."""
    done = subprocess.run([compiler, "-std=c++20", f"-stdlib={library}", "-x", "c++", "-", "-o", "/dev/null"], text=True,
                          input="#include <sstream>\nint main() { std::ostringstream out; out << 1; }\n", check=False,
                          capture_output=True)
    return done.returncode == 0


def run_programs(build):
    for name, words in PROGRAMS.items():
        done = build.compile(*words, build.made, "-o", build.program)
        if done.returncode != 0:
            yield f"{name}: does not compile\n{done.stdout}"
            continue
        ran = subprocess.run([build.program], text=True, check=False, timeout=60, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        if ran.returncode != 0:
            yield f"{name}: ended with {ran.returncode}\n{ran.stdout}"


def refuse(build):
    """The same file without the culprit has to compile."""
    begin = "#include <cstddef>\nimport rtuwire;\n"
    for text, culprit in {ACCEPTED: None, **REFUSED}.items():
        done = build.compile("-fsyntax-only", "-x", "c++", "-", text=begin + text)
        if culprit is None and done.returncode != 0:
            yield f"does not compile: {text}\n{done.stdout}"
        if culprit is not None and (done.returncode == 0 or culprit not in done.stdout.partition("\n")[0]):
            yield f"not refused because of {culprit}: {text}\n{done.stdout}"


def main(compiler, project):
    libraries = [library for library in LIBRARIES if has(compiler, library)]
    found = []
    for library in libraries:
        with tempfile.TemporaryDirectory() as folder:
            build = Build(compiler, pathlib.Path(project).resolve(), library, folder)
            done = build.precompile()
            wrong = [f"the module does not compile\n{done.stdout}"] if done.returncode != 0 else \
                [*run_programs(build), *refuse(build)]
            found += [f"{library}: {each}" for each in wrong]
    print("\n".join(found) or f"{len(PROGRAMS)} programs run with the module and {' and '.join(libraries)}")
    return 1 if found or not libraries else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
