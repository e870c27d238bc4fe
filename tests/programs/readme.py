# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles the programs that the README shows, and asks its server as a client would.

    python3 readme.py COMPILER PROJECT
"""
import os
import pathlib
import re
import select
import subprocess
import sys
import tempfile
import time
import tty

from frames import with_crc

FLAGS = ["-std=c++20", "-O1", "-Wall", "-Wextra", "-Werror"]
DEVICE, OPEN_PORT = "/dev/ttyUSB0", "blocking_client line{"
WITH_TYPES = "#include <iostream>\n#include <rtuwire/altivar/atv12.hpp>\n#include <rtuwire/print.hpp>\n"
READ_101 = bytes.fromhex("07 03 00 65 00 01")
WRITE_101 = bytes.fromhex("07 06 00 65 12 34")
READ_100 = bytes.fromhex("07 03 00 64 00 01")


def blocks(text):
    return re.findall(r"^```cpp\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def compiled(compiler, project, program, target):
    done = subprocess.run([compiler, *FLAGS, "-I", str(project / "include"), "-x", "c++", "-", "-o", target],
                          input=program, text=True, check=False, capture_output=True)
    return "" if done.returncode == 0 else f"does not compile:\n{program}\n{done.stderr}"


def with_call(program, call):
    """The client's program with more requests in it, behind its line."""
    head, tail = program.split(OPEN_PORT)
    end, rest = tail.split(";\n", 1)
    return f"{head}{OPEN_PORT}{end};\n{call}{rest}"


def answer(near, request, limit=1.0):
    """What comes back; asked again, because a server hears nothing before its line was silent once."""
    for _ in range(10):
        os.write(near, with_crc(request))
        heard, end = b"", time.monotonic() + limit
        while time.monotonic() < end and not heard:
            if select.select([near], [], [], end - time.monotonic())[0]:
                time.sleep(0.05)
                heard = os.read(near, 512)
        if heard:
            return heard
    return b"nothing"


def served(near):
    """What is wrong with the answers of this server, or an empty string."""
    for request, wanted in [(READ_101, "07 03 02 00 00"), (WRITE_101, "07 06 00 65 12 34"),
                             (READ_101, "07 03 02 12 34"), (READ_100, "07 03 02 12 34")]:
        heard = answer(near, request)
        if heard != with_crc(bytes.fromhex(wanted)):
            return f"asked {request.hex(' ')}, heard {heard.hex(' ')}, not {wanted}"
    return ""


def complaints(compiler, project):
    shown = blocks((project / "README.md").read_text(encoding="utf-8"))
    programs = [block for block in shown if "int main()" in block]
    calls = [block for block in shown if block.startswith("auto const written = line.ask(")]
    typed = [block for block in shown if block.startswith("constexpr station<") and "checked(" in block]
    clients = [block for block in programs if OPEN_PORT in block]
    servers = [block for block in programs if "serve_once(" in block]
    if not (len(clients) == len(typed) == len(servers) == len(calls) == 1):
        yield (f"{len(clients)} clients, {len(typed)} typed ones, {len(servers)} servers and {len(calls)} writes in the "
               "README, not one of each")
        return
    with tempfile.TemporaryDirectory() as place:
        for program in [*clients, with_call(clients[0], calls[0] + "static_cast<void>(written);\n"),
                        WITH_TYPES + with_call(clients[0], f"int const ramp = 30;\n{typed[0]}")]:
            yield compiled(compiler, project, program, f"{place}/client")
        near, kept_open = os.openpty()
        tty.setraw(kept_open)
        program = servers[0].replace(DEVICE, os.ttyname(kept_open))
        wrong = compiled(compiler, project, program, f"{place}/server")
        yield wrong
        if not wrong:
            with subprocess.Popen([f"{place}/server"]) as running:
                yield served(near)
                running.kill()


if __name__ == "__main__":
    found = [each for each in complaints(sys.argv[1], pathlib.Path(sys.argv[2])) if each]
    print("\n".join(found) or "the README's programs compile, and its server answers")
    sys.exit(1 if found else 0)
