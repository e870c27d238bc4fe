# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs the command line tool as a process, and units of this test's own on a pseudo-terminal."""
import csv
import io
import json
import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
for room in ("interop", "programs"):
    sys.path.insert(0, str(HERE.parent / room))

from controller import own_group, own_terminal  # noqa: E402,F401
from frames import CountedLine, Line, crc, with_crc  # noqa: E402,F401
from simulator import DRIVES, Simulator, runs, soon  # noqa: E402,F401

LIMIT = 60  # s, for a command that ends by itself
DONE, DIFFERS, USAGE, NO_ANSWER, PORT, REFUSED = range(6)


class Ended:
    """What a command printed, and its status."""

    def __init__(self, status, output, errors):
        self.status, self.output, self.errors = status, output, errors

    def objects(self):
        return [json.loads(line) for line in self.output.splitlines()]

    def rows(self):
        return list(csv.DictReader(io.StringIO(self.output), strict=True))

    def table(self):
        """The rows of a table for people, each a list of its columns."""
        lines = self.output.splitlines()
        starts = [i for i, letter in enumerate(lines[0]) if letter != " " and (i == 0 or lines[0][i - 2:i] == "  ")]
        # Numbers stand at the right of their column: words are enough.
        return starts and [line.split() for line in lines[1:]]

    def __repr__(self):
        return f"status {self.status}, {self.output!r}, {self.errors!r}"


class Tool:
    """with Tool(program) as tool: its files (log, configuration) are in a folder of their own."""

    def __init__(self, program, port=None):
        self.program, self.port = os.path.abspath(program), port

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="tool-")
        self.place = pathlib.Path(self.folder.name)
        self.environment = {**os.environ, "HOME": self.folder.name, "XDG_STATE_HOME": str(self.place / "state"),
                            "XDG_CONFIG_HOME": str(self.place / "config"), "NO_COLOR": "1", "LC_ALL": "C.UTF-8"}
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def command(self, words, port=None):
        where = port or self.port
        return [self.program, *(["--port", where] if where else []), *map(str, words)]

    def start(self, *words, port=None, **how):
        how = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **how}
        return subprocess.Popen(self.command(words, port), cwd=self.place, env=self.environment, **how)

    def run(self, *words, port=None, given=None, limit=LIMIT):
        how = {"stdin": subprocess.PIPE} if given is not None else {}
        process = self.start(*words, port=port, **how)
        try:
            output, errors = process.communicate(given, timeout=limit)
        except subprocess.TimeoutExpired:
            process.kill()
            output, errors = process.communicate()
            errors += f"\n(ended after {limit} s by the test)"
        return Ended(process.returncode, output, errors)

    def on_terminal(self, *words, keys=(), port=None):
        """With a terminal for all three: what it shows. Each key is pressed when a text has been shown; a function is called,
        and returns the key."""
        near, far = os.openpty()
        process = self.process = self.start(*words, port=port, stdin=far, stdout=far, stderr=far, text=False)
        os.close(far)
        text, waiting, end = b"", list(keys), time.monotonic() + LIMIT
        while time.monotonic() < end:
            ready, _, _ = select.select([near], [], [], 0.05)
            if ready:
                try:
                    text += os.read(near, 4096)
                except OSError:
                    break  # nobody has it open any more
            if waiting and waiting[0][0].encode() in text:
                key = waiting.pop(0)[1]
                os.write(near, (key() if callable(key) else key).encode())
        process.kill() if process.poll() is None and time.monotonic() >= end else None
        status = process.wait()
        os.close(near)
        return Ended(status, text.decode(errors="backslashreplace"), "")

    def interrupt(self):
        """As a key: Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        return ""


class Units(Line):
    """with Units({7: {100: 5}}) as line: units with holding registers on a line of their own; `line.name` is its device.
    They know functions 3, 6 and 16, and say nothing to those that they ignore. With a bit rate each answers after the
    time that the wire takes for both frames."""

    def __init__(self, units, bits_per_second=None, bits=11, ignored=()):
        super().__init__()
        self.units, self.requests, self.ignored = units, [], ignored
        self.character = bits / bits_per_second if bits_per_second else 0
        self.silence = (1.75e-3 if (bits_per_second or 0) > 19200 else 3.5 * self.character)
        self.waiting = b""

    def hear(self, data):
        began = time.monotonic()
        super().hear(data)
        self.waiting += data
        while request := self.next_request():
            self.requests.append(request)
            answer = self.answer(request)
            if answer:
                end = began + self.character * (len(request) + len(answer)) + self.silence
                time.sleep(max(0.0, end - time.monotonic()))
                self.say(answer)

    def next_request(self):
        size = 8
        if len(self.waiting) > 6 and self.waiting[1] == 16:
            size = 9 + self.waiting[6]
        elif len(self.waiting) > 2 and self.waiting[1] in (22, 43):
            size = 10 if self.waiting[1] == 22 else 7
        if len(self.waiting) < size:
            return None
        request, self.waiting = self.waiting[:size], self.waiting[size:]
        return request

    def answer(self, request):
        unit, function = request[0], request[1]
        if unit not in self.units or crc(request) != 0 or function in self.ignored:
            return None
        registers = self.units[unit]
        start = int.from_bytes(request[2:4], "big")
        value = int.from_bytes(request[4:6], "big")
        if function == 3:
            asked = range(start, start + value)
            if not all(each in registers for each in asked):
                return with_crc(bytes([unit, 0x83, 2]))
            return with_crc(bytes([unit, 3, 2 * value]) + b"".join(registers[each].to_bytes(2, "big") for each in asked))
        if function == 6:
            if start not in registers:
                return with_crc(bytes([unit, 0x86, 2]))
            registers[start] = value
            return request
        return with_crc(bytes([unit, function | 0x80, 1]))
