# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds the server that the README shows, and asks it as a client would; that every block compiles, snippets.py shows.

    python3 readme.py COMPILER PROJECT
"""
import os
import pathlib
import select
import subprocess
import sys
import tempfile
import time
import tty

from snippets import blocks

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from frames import with_crc  # noqa: E402

FLAGS = ["-std=c++20", "-O1", "-Wall", "-Wextra", "-Werror"]
DEVICE = "/dev/ttyUSB0"
READ_101 = bytes.fromhex("07 03 00 65 00 01")
WRITE_101 = bytes.fromhex("07 06 00 65 12 34")
READ_100 = bytes.fromhex("07 03 00 64 00 01")


def compiled(compiler, project, program, target):
    done = subprocess.run([compiler, *FLAGS, "-I", str(project / "include"), "-x", "c++", "-", "-o", target],
                          input=program, text=True, check=False, capture_output=True)
    return "" if done.returncode == 0 else f"does not compile:\n{program}\n{done.stderr}"


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


def complaint(compiler, project):
    """What is wrong with the README's server, or an empty string."""
    shown = blocks((project / "README.md").read_text(encoding="utf-8"))
    servers = [block for _, block in shown if "int main()" in block and "serve_once(" in block]
    if len(servers) != 1:
        return f"{len(servers)} servers in the README, not one"
    with tempfile.TemporaryDirectory() as place:
        near, kept_open = os.openpty()
        tty.setraw(kept_open)
        wrong = compiled(compiler, project, servers[0].replace(DEVICE, os.ttyname(kept_open)), f"{place}/server")
        if wrong:
            return wrong
        with subprocess.Popen([f"{place}/server"]) as running:
            wrong = served(near)
            running.kill()
    return wrong


if __name__ == "__main__":
    found = complaint(sys.argv[1], pathlib.Path(sys.argv[2]))
    print(found or "the README's server answers")
    sys.exit(1 if found else 0)
