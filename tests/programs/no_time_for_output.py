# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets the demo run a simulated motor while its output blocks, or while it does not run itself.

    python3 no_time_for_output.py SIMULATE DEMO DRIVE pipe|ctrl-s|stopped|asleep
    python3 no_time_for_output.py SIMULATE DEMO DRIVE simulate    the same for a full pipe of `simulate`
"""
import os
import re
import signal
import subprocess
import threading
import time

from controller import TTO, UNIT, Drive, full_pipe, gone, own_group, runs, soon, turning
from frames import Line, with_crc

PAUSE = 0.5  # s
LONG_PAUSE = TTO / 10 / 3 + 0.5  # s, more than a third of the drive's time-out
ETA = {"atv28": 458, "atv320": 3201}
XOFF, XON = b"\x13", b"\x11"
DROPPED = re.compile(rb"demo: (\d+) lines were dropped: the output is blocked")


def nobody_reads(program, drive, check):
    reader, writer = full_pipe()
    process = turning(program, drive, check, stdout=writer)
    check(soon(drive.turns_back), "and turns back, so that the cycle goes on")
    _, errors = gone(process, drive, check, 0)
    said = DROPPED.search(errors)
    check(said and int(said.group(1)) > 20, "it says how much was dropped", errors)
    os.close(reader)
    os.close(writer)


class Terminal:
    """A terminal that somebody reads all the time."""

    def __init__(self):
        self.near, self.far = os.openpty()
        self.text = b""
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        try:
            while data := os.read(self.near, 512):
                self.text += data
        except OSError:
            pass

    def press(self, key):
        os.write(self.near, key)

    def stands_still(self):
        before = self.text
        time.sleep(PAUSE)
        return self.text == before


def somebody_presses_ctrl_s(program, drive, check):
    terminal = Terminal()
    process = turning(program, drive, check, stdout=terminal.far)
    terminal.press(XOFF)
    check(soon(terminal.stands_still), "Ctrl-S holds the terminal")
    before = terminal.text
    check(soon(drive.turns_back), "it turns back, so that the cycle goes on")
    check(terminal.text == before, "while nothing is shown")
    terminal.press(XON)
    gone(process, drive, check, 0)
    check(soon(lambda: b"The motor stands." in terminal.text), "the rest is shown")


def it_is_stopped(program, drive, check, pause=PAUSE, **how):
    process = turning(program, drive, check, **how)
    process.send_signal(signal.SIGSTOP)
    os.waitpid(process.pid, os.WUNTRACED)
    time.sleep(pause)
    check(drive.turns(), "nobody has stopped it", drive.shown())
    process.send_signal(signal.SIGCONT)
    text, _ = gone(process, drive, check, 1)
    check(b"the order to run is gone" in text, "it says that the order is gone")


def it_is_not_told_that_it_was_stopped(program, drive, check):
    """As when the machine slept: only the clock tells."""
    it_is_stopped(program, drive, check, LONG_PAUSE, before=lambda: own_group(signal.SIGCONT))


CASES = {"pipe": nobody_reads, "ctrl-s": somebody_presses_ctrl_s, "stopped": it_is_stopped,
         "asleep": it_is_not_told_that_it_was_stopped}


def simulate_answers(program, name, check):
    """Its drives answer although nobody reads what it was asked to show."""
    reader, writer = full_pipe()
    request = with_crc(bytes([UNIT, 3, *ETA[name].to_bytes(2, "big"), 0, 1]))
    with Line() as line:
        process = subprocess.Popen([program, "simulate", f"{name}:{UNIT}", "--port", line.name],
                                   stdin=subprocess.PIPE, stdout=writer, stderr=writer)
        process.stdin.write(f"{UNIT} show\n{UNIT} nonsense\n".encode() * 500)
        process.stdin.flush()
        time.sleep(PAUSE)
        for _ in range(3):
            before = len(line.heard)
            line.say(request)
            check(soon(lambda count=before: len(line.heard) > count), "it answers", line.heard[before:])
        process.terminate()
        check(soon(lambda: process.poll() is not None), "it ends")
        process.kill()
        check(process.wait() == 0, "and well", process.returncode)
    os.close(reader)
    os.close(writer)


def main(check, simulate, program, name, case):
    if case == "simulate":
        simulate_answers(simulate, name, check)
        return
    with Drive(simulate, name) as drive:
        CASES[case](program, drive, check)


runs(main)
