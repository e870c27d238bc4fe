# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Starts a program with some of its standard descriptors closed: the line carries nothing but frames, and is none
of the three.

    python3 closed_descriptors.py SIMULATE DEMO demo|simulate
"""
import itertools
import os
import signal
import subprocess

from controller import LIMIT, UNIT, Drive, closing, demo, runs, soon
from frames import Line, are_frames, with_crc

STANDARD = (0, 1, 2)
FAILED = {"demo": 1, "simulate": 4}  # the status where standard output fails
SEVERAL = 40  # bytes: five requests
ETA = with_crc(bytes([UNIT, 3, 0x0C, 0x81, 0, 1]))


def uses_as_standard(process, device):
    """Whether one of the three leads to the device; none does in a process that has ended."""
    def target(number):
        try:
            return os.readlink(f"/proc/{process.pid}/fd/{number}")
        except OSError:
            return None
    return any(target(each) == device for each in STANDARD)


def end(process):
    process.send_signal(signal.SIGTERM)
    try:
        return process.wait(timeout=LIMIT)
    except subprocess.TimeoutExpired:
        process.kill()
        return None


def check_all(program, process, line, closed, status, check):
    """Looks at the process once it has asked or answered something, and lets it end."""
    what = "closed: " + (", ".join(map(str, closed)) or "none")
    spoke = soon(lambda: len(line.heard) >= SEVERAL or process.poll() is not None)
    check(spoke and not uses_as_standard(process, line.name), f"{what}; the line is none of the three")
    found = end(process)
    check(found == (FAILED[program] if 1 in closed else status), f"{what}; the status", found)
    check(are_frames(line.heard), f"{what}; nothing but frames", line.heard[:24])
    check(1 in closed or len(line.heard) >= SEVERAL, f"{what}; and there were some")


def demo_asks(simulate, program, closed, check):
    with Drive(simulate, "atv320") as drive, Line(drive.device) as line:
        drive.device = line.name
        process = demo(program, drive, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, before=closing(closed))
        check_all("demo", process, line, closed, 128 + signal.SIGTERM, check)


def simulate_answers(simulate, _, closed, check):
    with Line() as line:
        process = subprocess.Popen(
            [simulate, "simulate", f"atv320:{UNIT}", "--port", line.name], stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=closing(closed))

        def is_answering():
            before = len(line.heard)
            line.say(ETA)
            return soon(lambda: len(line.heard) > before, 0.3) or process.poll() is not None
        check(soon(is_answering), "it answers or ends")
        for _ in range(SEVERAL // 7 + 1):
            is_answering()
        check_all("simulate", process, line, closed, 0, check)


PROGRAMS = {"demo": demo_asks, "simulate": simulate_answers}


def main(check, simulate, program, which):
    for count in range(len(STANDARD) + 1):
        for closed in itertools.combinations(STANDARD, count):
            PROGRAMS[which](simulate, program, closed, check)


runs(main)
