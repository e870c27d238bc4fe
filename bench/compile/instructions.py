# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What headers cost the compiler, in its own instructions under callgrind: the same on an idle and on a busy machine.

    /usr/bin/python3 bench/compile/instructions.py [BEFORE]

With BEFORE, another checkout, the change is shown as well. Needs GCC and Valgrind; takes half a minute a header.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parents[2]
# The engine of each end, the tables of one drive, and everything.
HEADERS = ("client/client.hpp", "server/server.hpp", "altivar/atv320.hpp", "rtuwire.hpp")


def instructions(tree, header):
    compiler = subprocess.run(["g++", "-print-prog-name=cc1plus"], check=True, capture_output=True, text=True)
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "include.cpp")
        source.write_text(f"#include <rtuwire/{header}>\n", encoding="utf-8")
        done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", compiler.stdout.strip(),
                               "-quiet", "-std=gnu++20", "-O1", "-imultiarch", "x86_64-linux-gnu", "-D_GNU_SOURCE",
                               f"-I{tree}/include", str(source), "-o", "/dev/null"],
                              check=True, capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


def main(before=None):
    for header in HEADERS:
        now = instructions(HERE, header)
        change = f"{100 * now / instructions(before, header) - 100:+6.1f} %" if before else ""
        print(f"{header:22} {now / 1e6:8.0f} million {change}")


if __name__ == "__main__":
    main(*sys.argv[1:])
