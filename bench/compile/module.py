# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a file costs Clang 19 that imports the module, against the same file with the headers: user time.

    /usr/bin/python3 bench/compile/module.py [--rounds N]

The files take turns, and the best round of each counts. The bar is for a file that uses the client and instantiates little:
what a program instantiates, it pays for in either way.
"""
import argparse
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
COMPILER = "clang++-19"
# A file, the headers that the import replaces, and the most that it may take of their time.
CLIENT = "void run(rtuwire::client& link, rtuwire::instant now) { link.advance(now); }\n"
BOTH_ENDS = (PROJECT / "examples/02_client_and_server.cpp").read_text(encoding="utf-8").replace(
    "#include <rtuwire/rtuwire.hpp>\n", "")
DRIVE = (PROJECT / "tests/module/program.cpp").read_text(encoding="utf-8").replace("import rtuwire;", "")
FILES = [("a client, against client.hpp", CLIENT, "client.hpp", 0.35),
         ("a client, against rtuwire.hpp", CLIENT, "rtuwire.hpp", 0.35),
         ("client, server and bench", BOTH_ENDS, "rtuwire.hpp", 0.35),
         ("tables, a poller, orders and a drive", DRIVE, "rtuwire.hpp", None)]


def user_time(*words, text=None):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([COMPILER, "-std=c++20", f"-I{PROJECT}/include", *words], input=text, text=True, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def with_headers(text, door):
    return user_time("-DBY_HEADER", "-c", "-o", "/dev/null", "-x", "c++", "-", text=f"#include <rtuwire/{door}>\n{text}")


def with_module(text, made):
    # The import stands behind the includes of standard headers, where a program has it.
    head, _, rest = text.rpartition("#include <c")
    line, _, rest = rest.partition("\n") if head else ("", "", text)
    whole = f"{head}#include <c{line}\nimport rtuwire;\n{rest}" if head else f"import rtuwire;\n{text}"
    return user_time(f"-fmodule-file=rtuwire={made}", "-c", "-o", "/dev/null", "-x", "c++", "-", text=whole)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--rounds", type=int, default=5)
    rounds = options.parse_args().rounds
    if not shutil.which(COMPILER):
        print(f"{COMPILER} is not here: nothing was measured")
        return
    with tempfile.TemporaryDirectory() as folder:
        made = f"{folder}/rtuwire.pcm"
        interface = f"{folder}/rtuwire.cppm"
        subprocess.run([sys.executable, "-B", f"{PROJECT}/packaging/module_interface.py", interface], check=True)
        once = user_time("--precompile", interface, "-o", made)
        print(f"the module itself, once          {once:6.2f} s")
        for name, text, door, bar in FILES:
            both = [(with_headers(text, door), with_module(text, made)) for _ in range(rounds)]
            headers, module = (min(times) for times in zip(*both))
            verdict = "" if bar is None else f"  bar {bar} {'met' if module / headers <= bar else 'MISSED'}"
            print(f"{name:37} {headers:6.2f} s by headers {module:6.2f} s by module {module / headers:6.2f} times{verdict}")


if __name__ == "__main__":
    main()
