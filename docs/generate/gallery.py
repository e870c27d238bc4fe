# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The gallery of errors: each refused act of tests/fail with what GCC and Clang say of it, and each `errc` with its cause and
its remedy as its header documents them. A refusal without its sentence, or an error without a remedy, fails the build."""
import concurrent.futures
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "fail"))

import refusal  # noqa: E402

COMPILERS = (("GCC", "g++"), ("Clang", "clang++"))
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


def said_by(project, build, compiler, refusals):
    """What a compiler says of each, as it was kept when its test ran; what was not, it is asked now."""
    include = project / "include"
    of = refusal.circumstances(compiler, include)
    places = [build / "refusals", *project.glob("build/*/refusals")]

    def said(each):
        name = refusal.kept_as(of, each.path)
        kept = next((place / name for place in places if (place / name).exists()), places[0] / name)
        wrong = "" if kept.exists() else refusal.complaint(compiler, include, each.path, True, kept)
        if wrong:
            raise ValueError(f"{compiler}: {each.name} {wrong}")
        return shortened(readable(project, kept.read_text(encoding="utf-8")), each.expected)
    wanted = [each for each in refusals if each.name not in NOT_BY.get(compiler, ())]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip((each.name for each in wanted), pool.map(said, wanted)))


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


def errors_page(found, place='<a id="errors-errc-{}"></a>'):
    """A row for each: its name and number, the words that are shown of it, its cause and its remedy."""
    lines = ["| error | shown as | cause | remedy |", "| --- | --- | --- | --- |"]
    return "\n".join(lines + [f"| {place.format(name)}`{name}` {number} | {words} | {cause} | {remedy} |" for number, name, words, cause, remedy in found
                              if name != "none"])


def pages(project, build):
    refusals = [Refusal(path) for path in sorted((project / "tests" / "fail").glob("*.cpp"))]
    said = {compiler: said_by(project, build, compiler, refusals) for _, compiler in COMPILERS}
    acts = f"{len(refusals)} acts are refused. What is longer than twelve lines is cut here, with three dots.\n\n{refusals_page(refusals, said)}"
    return {"refused acts": acts, "errors": errors_page(errors(project))}
