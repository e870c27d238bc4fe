# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The gallery of errors: each refused act of tests/fail with what GCC and Clang say of it, and each `errc` with its cause and
its remedy as its header documents them. A refusal without its sentence, or an error without a remedy, fails the build."""
import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import tempfile

COMPILERS = (("GCC", "g++"), ("Clang", "clang++"))
FLAGS = ("-std=c++20", "-Wall", "-Wextra", "-Werror", "-fmessage-length=0")
# With the headers precompiled, and as the test of the refusals compiles.
FAST, WHOLE = ("-fsyntax-only",), ("-c", "-o", os.devnull)
# Clang 14 fails at some constructors where they are refused, see tests/fail/CMakeLists.txt.
NOT_BY = {"clang++": {"count_known_at_run_time"}}
MOST_LINES = 12
ENTRY = re.compile(r"((?:^    ///[^\n]*\n)+)    (\w+) = (0x\w+),$", re.MULTILINE)
ENUMERATOR = re.compile(r"^    (\w+) = 0x\w+,", re.MULTILINE)
NAMED = re.compile(r'case errc::(\w+): return "([^"]*)";')
BUILD_NAMESPACE = re.compile(r"rtuwire::v\d+_\w+?::")


class Refusal:
    def __init__(self, path):
        self.name, self.path = path.stem, path
        self.text = path.read_text(encoding="utf-8")
        self.expected = re.findall(r"^// EXPECT: *(\S.*?) *$", self.text, re.MULTILINE)
        self.words = " ".join(re.findall(r"^// (?!SPDX|EXPECT|CASES)(.*)$", self.text.partition("#include")[0], re.MULTILINE))

    def code(self):
        """What the file has behind its includes: the refused lines, and the right ones."""
        lines = self.text.split("\n")
        last = max((at for at, line in enumerate(lines) if line.startswith("#include")), default=0)
        return "\n".join(lines[last + 1:]).strip("\n")


def precompiled(project, place, compiler):
    """The headers once for all files, as the flags that use them."""
    header = pathlib.Path(place) / "all.hpp"
    header.write_text("#include <rtuwire/rtuwire.hpp>\n#include <rtuwire/altivar/all.hpp>\n", encoding="utf-8")
    target = header.with_name("all.pch" if compiler == "clang++" else "all.hpp.gch")
    subprocess.run([compiler, *FLAGS, f"-I{project}/include", "-x", "c++-header", header, "-o", target], check=True)
    return ("-include-pch", target) if compiler == "clang++" else ("-include", header)


def output_of(project, refusal, compiler, headers):
    """Whether a compiler accepts the refused act, and what it says."""
    how = (*FAST, *headers) if headers else WHOLE
    done = subprocess.run([compiler, *FLAGS, *how, "-DREFUSED=1", f"-I{project}/include", refusal.path], text=True,
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, "LC_ALL": "C"})
    return done.returncode == 0, done.stdout


def refused(project, refusal, compiler, headers):
    """What a compiler says; with the file's own includes alone where more of them make it say something else."""
    is_accepted, said = output_of(project, refusal, compiler, headers)
    if headers and (is_accepted or any(sentence not in said for sentence in refusal.expected)):
        is_accepted, said = output_of(project, refusal, compiler, ())
    if is_accepted:
        raise ValueError(f"{compiler} accepts {refusal.name} with -DREFUSED=1")
    for sentence in refusal.expected:
        if sentence not in said:
            raise ValueError(f"{compiler} refuses {refusal.name} without saying `{sentence}`:\n{said}")
    return shortened(readable(project, said), refusal.expected)


def readable(project, text):
    """Paths from the project's root, and names as a program writes them."""
    text = re.sub(r"^In file included from .*$\n(^ +from .*$\n)*", "", text.replace(f"{project}/", ""), flags=re.MULTILINE)
    return BUILD_NAMESPACE.sub("rtuwire::", text)


def shortened(text, sentences):
    """The first lines, and those with the sentences; three dots stand for the rest."""
    lines = [line for line in text.splitlines() if not re.match(r"(In file included| +from) ", line)]
    kept = {at for at, line in enumerate(lines) if at < MOST_LINES or any(each in line for each in sentences)}
    out = []
    for at, line in enumerate(lines):
        if at in kept:
            out.append(line)
        elif out and out[-1] != "...":
            out.append("...")
    return "\n".join(out)


def sum_of(paths):
    found = hashlib.sha256()
    for path in sorted(paths):
        found.update(path.read_bytes())
    return found


class Memory:
    """What a compiler said before of the same text, kept in the build tree."""

    def __init__(self, project, build, compiler):
        version = subprocess.run([compiler, "--version"], check=True, capture_output=True).stdout
        self.base = sum_of([*(project / "include").rglob("*.hpp"), *(project / "tests").rglob("*.hpp"), pathlib.Path(__file__)])
        self.base.update(version)
        self.place = build / "gallery" / "said"
        self.place.mkdir(parents=True, exist_ok=True)

    def path(self, refusal):
        found = self.base.copy()
        found.update(refusal.text.encode())
        return self.place / found.hexdigest()


def said_by(project, build, compiler, refusals):
    memory = Memory(project, build, compiler)
    wanted = [each for each in refusals if each.name not in NOT_BY.get(compiler, ())]
    missing = [each for each in wanted if not memory.path(each).exists()]
    if missing:
        with tempfile.TemporaryDirectory(dir=build / "gallery") as place:
            headers = precompiled(project, place, compiler)
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                for each, text in zip(missing, pool.map(lambda one: refused(project, one, compiler, headers), missing)):
                    memory.path(each).write_text(text, encoding="utf-8")
    return {each.name: memory.path(each).read_text(encoding="utf-8") for each in wanted}


def refusals_page(refusals, said):
    lines = []
    for each in refusals:
        lines += [f"### {each.name.replace('_', ' ')} {{#errors-{each.name}}}", "", each.words, "", "```cpp", each.code(), "```", ""]
        for title, compiler in COMPILERS:
            if each.name in said[compiler]:
                lines += [f"{title} says:", "", "```", said[compiler][each.name], "```", ""]
            else:
                lines += [f"{title} 14 fails by itself where this is refused, and does not refuse it.", ""]
    return "\n".join(lines)


def errors(project):
    """Each error: number, name, words, cause and remedy."""
    header = (project / "include/rtuwire/wire/errc.hpp").read_text(encoding="utf-8")
    words = dict(NAMED.findall((project / "include/rtuwire/wire/errc_name.hpp").read_text(encoding="utf-8")))
    found = []
    for comment, name, number in ENTRY.findall(header):
        plain = " ".join(line.strip()[3:].strip() for line in comment.splitlines())
        cause, _, remedy = plain.partition("Remedy: ")
        if name != "none" and not (cause and remedy):
            raise ValueError(f"errc::{name} is documented without a cause or without a remedy")
        found.append((number, name, words[name], cause.strip(), remedy.strip()))
    missing = set(ENUMERATOR.findall(header)) - {name for _, name, *_ in found}
    if missing or set(words) != {name for _, name, *_ in found}:
        raise ValueError(f"the gallery misses errors: {missing or set(words) ^ {name for _, name, *_ in found}}")
    return found


def errors_page(found):
    lines = []
    for number, name, words, cause, remedy in found:
        if name == "none":
            continue
        lines += [f"### {name} ({number}) {{#errors-errc-{name}}}", "", f"Shown as \"{words}\".", "", f"**Cause:** {cause}", "",
                  f"**Remedy:** {remedy}", ""]
    return "\n".join(lines)


def pages(project, build):
    refusals = [Refusal(path) for path in sorted((project / "tests" / "fail").glob("*.cpp"))]
    said = {compiler: said_by(project, build, compiler, refusals) for _, compiler in COMPILERS}
    return {"refused acts": refusals_page(refusals, said), "errors": errors_page(errors(project)),
            "number of refused acts": f"{len(refusals)} acts are refused."}
