# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs the file for Linux on a pseudo-terminal, at whose other end a unit answers, is silent, loses a byte, damages one, and is
gone in the end. Who switches the transceiver of a real port is shown in tests/programs.

    python3 linux_rs485.py PROGRAM
"""
import os
import pathlib
import select
import subprocess
import sys
import time
import tty

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from frames import with_crc  # noqa: E402

REQUEST = with_crc(bytes.fromhex("07 03 0C 81 00 01"))
ANSWER = with_crc(bytes.fromhex("07 03 02 02 50"))
SHORT = ANSWER[:3] + ANSWER[4:]
DAMAGED = ANSWER[:4] + b"\x51" + ANSWER[5:]


def requests(near, count, limit=60.0):
    """So many requests, one by one, each of which is to be answered before the next comes."""
    heard, end = b"", time.monotonic() + limit
    while count > 0 and select.select([near], [], [], max(0.0, end - time.monotonic()))[0]:
        heard += os.read(near, 256)
        while len(heard) >= len(REQUEST):
            assert heard[:len(REQUEST)] == REQUEST, f"heard {heard.hex(' ')}"
            heard, count = heard[len(REQUEST):], count - 1
            yield
    assert count == 0, "no request came"


def main(program):
    near, far = os.openpty()
    tty.setraw(far)
    with subprocess.Popen([program, os.ttyname(far)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        for number, _ in enumerate(requests(near, 40)):
            answer = {10: SHORT, 20: DAMAGED}.get(number, ANSWER)
            os.write(near, b"" if 30 <= number < 34 else answer)
        os.close(far)
        os.close(near)
        said, told = running.communicate(timeout=60)
    values = said.split()
    print(f"{len(values)} values; {sorted(set(told.splitlines()))}")
    assert set(values) == {"592"} and len(values) >= 30, values
    assert "no response in time" in told, told
    assert running.returncode == 1, "the end of the port is told by the status"
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
