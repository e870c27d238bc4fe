# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles every block of C++ in the README and the pages, with the warnings of the project.

    python3 snippets.py PROJECT COMPILER...

A block with a `main` is a program and is compiled as it stands. Any other block is put into a frame, which declares what
the page calls the reader's own. A frame is a file in `snippets/` that says which block is its, by page and first words:

    // PAGE: docs/registers.md
    // BEGINS: bank<pump::setpoint
    ... // BLOCK ...              the block stands here
    // REST FROM: client link     from this line on it stands where `// REST` does
    // FOR: /* ... */ => a, b,    what the page leaves out

A block without a frame of its own has `plain.cpp`. A frame without a block is an error, as is a page without any. A block that is
the region of a program (docs/generate/snippets.py holds it to that) is compiled there.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FRAMES = pathlib.Path(__file__).resolve().parent / "snippets"
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]
# A snippet shows names that it does not use.
ALLOWED = ["-Wno-unused-variable", "-Wno-unused-but-set-variable", "-Wno-unused-function"]
# Clang 14 fails at some constructors only where it makes code.
HOW = {"clang": ["-O0", "-c", "-o", os.devnull], "gcc": ["-fsyntax-only"]}
BLOCK = re.compile(r"^```cpp\n(.*?)^```$", re.MULTILINE | re.DOTALL)
REGION = re.compile(r"^<!-- snippet: \S+ \S+ -->\n\Z", re.MULTILINE)


def blocks(text):
    """The line number and the text of each block."""
    return [(text.count("\n", 0, found.start(1)) + 1, found[1]) for found in BLOCK.finditer(text)
            if not REGION.search(text[max(0, found.start() - 200):found.start()])]


def marks(frame, mark):
    return re.findall(rf"^// {mark}: *(\S.*?) *$", frame, re.MULTILINE)


class Frame:
    def __init__(self, name, text):
        self.name, self.text = name, text
        self.page, self.begins = (marks(text, mark) for mark in ("PAGE", "BEGINS"))

    def fits(self, page, block):
        return page in self.page and any(block.startswith(begin) for begin in self.begins)

    def around(self, page, line, block):
        """The program: compilers report the lines of the page."""
        for swap in marks(self.text, "FOR"):
            left_out, _, meant = swap.partition(" => ")
            if left_out not in block:
                raise ValueError(f"{self.name} fills in {left_out}, which {page} does not have")
            block = block.replace(left_out, meant)
        first, rest, after = block, "", line
        for start in marks(self.text, "REST FROM"):
            at = block.index(start)
            first, rest, after = block[:at], block[at:], line + block.count("\n", 0, at)
        text = self.text.replace("// BLOCK\n", f'#line {line} "{page}"\n{first}', 1)
        return text.replace("// REST\n", f'#line {after} "{page}"\n{rest}', 1)


def read_frames(folder):
    return [Frame(path.name, path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.cpp"))]


def programs(pages, frames):
    """What is to be compiled, by page and line; frames that no block needs are an error."""
    plain = next(each for each in frames if not each.page)
    unused = {each.name for each in frames if each.page}
    for page, text in pages.items():
        for line, block in blocks(text):
            if re.search(r"^int main\(", block, re.MULTILINE):
                yield page, line, block
                continue
            frame = next((each for each in frames if each.fits(page, block)), plain)
            unused.discard(frame.name)
            yield page, line, frame.around(page, line, block)
    if unused:
        raise ValueError("no page has the block of " + ", ".join(sorted(unused)))


def complaint(compiler, project, page, line, program):
    kind = "clang" if "clang" in os.path.basename(compiler) else "gcc"
    with tempfile.NamedTemporaryFile("w", suffix=".cpp", encoding="utf-8") as source:
        source.write(program)
        source.flush()
        done = subprocess.run([compiler, "-std=c++20", *WARNINGS, *ALLOWED, *HOW[kind], "-I", str(project / "include"),
                               "-I", str(FRAMES), source.name], text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return "" if done.returncode == 0 else f"{page}:{line}: {compiler} does not compile this block\n{done.stdout}\n"


def main(project, *compilers):
    root = pathlib.Path(project)
    pages = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
             for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]}
    blocks = list(programs(pages, read_frames(FRAMES)))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(complaint, compiler, root, *each) for compiler in compilers for each in blocks]
        found = [job.result() for job in jobs if job.result()]
    print("\n".join(found) or f"{len(blocks)} blocks of C++ on {len(pages)} pages compile, by {' and '.join(compilers)}")
    return 1 if found or not blocks or not compilers else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
