# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What people met with units and lines of their own, at pseudo-terminals and TCP ports: what the tool says of it.

    python3 field_cases.py TOOL PART
"""
import socket
import threading
import time

from support import DIFFERS, DONE, NO_ANSWER, Line, Tool, runs, with_crc


class Unit:
    """Answers each request of function 3 by what `said` makes of it: bytes, or (seconds to wait first, bytes) in a list."""

    def __init__(self, said):
        self.said, self.requests, self.times = said, [], []

    def take(self, request, send):
        self.requests.append(request)
        self.times.append(time.monotonic())
        answer = self.said(request)
        for wait, data in answer if isinstance(answer, list) else [(0, answer)]:
            time.sleep(wait)
            send(data)


class UnitOnLine(Line):
    """with UnitOnLine(said) as line: ... line.name, line.unit.requests"""

    def __init__(self, said):
        super().__init__()
        self.unit = Unit(said)

    def hear(self, data):
        self.unit.take(data, self.say)


class UnitOnTcp:
    """The same behind a TCP port."""

    def __init__(self, said):
        self.unit = Unit(said)
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.name = f"tcp://127.0.0.1:{self.listening.getsockname()[1]}"
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                line, _ = self.listening.accept()
            except OSError:
                return
            line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            while request := line.recv(512):
                self.unit.take(request, line.sendall)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.listening.close()


def words_of(request):
    start, count = int.from_bytes(request[2:4], "big"), int.from_bytes(request[4:6], "big")
    return b"".join((each & 0xFFFF).to_bytes(2, "big") for each in range(start, start + count))


def good(request):
    """Each register holds its address."""
    data = words_of(request)
    return with_crc(request[:2] + bytes([len(data)]) + data)


# What a unit says instead; how many bytes are due to a request of one register, and of three.
FORMATS = [
    ("two codes", lambda request: with_crc(bytes([request[0], 0x83, 2, 0])), (5, 5)),
    ("no byte count", lambda request: with_crc(request[:2] + words_of(request)), (7, 11)),
    ("a wide byte count", lambda request: with_crc(request[:2] + b"\0" + good(request)[2:-2]), (7, 11)),
    ("a byte more", lambda request: with_crc(good(request)[:-2] + b"\6"), (7, 11)),
    ("registers of four bytes", lambda request: with_crc(request[:2] + bytes([2 * len(words_of(request))]) + 2 * words_of(request)), (7, 11)),
]


def check_formats(tool, check):
    for what, said, due in FORMATS:
        for words, size in (("0x1234", due[0]), ("0x1234-0x1236", due[1])):
            with UnitOnLine(said) as line:
                how = ["--port", line.name, "--no-listen", "--timeout", 0.5, "--retries", 0, "-u", 9]
                table = tool.run(*how, "read", words)
                rows = tool.run(*how, "--json", "read", words).objects()
                seen = said(line.unit.requests[-1])
            told = (f"right CRC, wrong length: the unit departs from the function's format: {len(seen)} bytes came, {size} are due: "
                    + seen.hex(" ").upper())
            check(table.status == DIFFERS and told in table.output, f"{what}, {words}: {told}", table)
            check(all(told in row["error"] for row in rows), f"{what}, {words}: for programs, too", rows)
    with UnitOnLine(FORMATS[3][1]) as line:
        rows = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "--json", "scan", "--units", "4").objects()
        check(len(rows) == 1 and "8 bytes came, 7 are due: 04 03 02 0C 81 06" in rows[0]["note"], "of a scan", rows)
    with UnitOnLine(lambda request: good(request)[:-1] + b"!") as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "-u", 9, "read", "0x0102")
        check("CRC mismatch: 7 bytes came: 09 03 02 01 02" in ended.output, "a damaged one is shown as well", ended)
    with UnitOnLine(lambda request: with_crc(bytes([request[0], request[1] | 0x80, 1]))) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "-u", 9, "read", "1000:f32", "coil:3")
        check(ended.status == DIFFERS and "exception 0x01); input:1000 asks by function 04" in ended.output
              and ended.output.count("asks by") == 1, "a unit without holding registers", ended)


def in_pieces(size, pause):
    def said(request):
        data = good(request)
        return [(pause if at else 0, data[at:at + size]) for at in range(0, len(data), size)]
    return said


def check_pieces(tool, check):
    for size, pause, words, values in ((4, 0.12, "0x0001-0x0002", [1, 2]), (5, 0.12, "0x0300", [0x300]),
                                       (40, 0.3, "0x1000-0x103F", list(range(0x1000, 0x1040))), (1, 0.06, "7", [7])):
        with UnitOnTcp(in_pieces(size, pause)) as line:
            ended = tool.run("--port", line.name, "--no-listen", "--timeout", 10, "--retries", 0, "--json", "-u", 1, "read", words)
            check(ended.status == DONE and [row["raw"] for row in ended.objects()] == values,
                  f"{words} in pieces of {size} bytes, {pause} s apart", ended)
    with UnitOnTcp(lambda request: good(request)[:-1]) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "--retries", 0, "-u", 1, "read", "0x0001")
        check(ended.status == NO_ANSWER and "no response in time" in ended.output, "one that never ends ends by the time-out", ended)


def check_pause(tool, check):
    for timeout, pause in ((1, 1000), (0.2, 700), (1, 0)):
        with UnitOnLine(good) as line:
            how = ["--port", line.name, "--no-listen", "--timeout", timeout, "--retries", 0, "--pause", pause, "--json"]
            ended = tool.run(*how, "-u", 1, "read", "0x0100", "0x0200", "0x0300")
            gaps = [after - before for before, after in zip(line.unit.times, line.unit.times[1:])]
        check(ended.status == DONE and [row["raw"] for row in ended.objects()] == [0x100, 0x200, 0x300],
              f"three values with a pause of {pause} ms and a time-out of {timeout} s", ended)
        check(len(gaps) == 2 and min(gaps) >= pause / 1000 and max(gaps) < pause / 1000 + 0.5, f"{pause} ms between them: {gaps}", ended)
    with UnitOnLine(lambda request: b"") as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, "--retries", 1, "--pause", 500, "-u", 1, "read", "1")
        check(ended.status == NO_ANSWER and "no response in time" in ended.output, "a silent line is not jammed", ended)
        check(len(line.unit.times) == 2 and line.unit.times[1] - line.unit.times[0] >= 0.5, "a repetition has its pause", line.unit.times)
    ended = tool.run("--port", "/dev/null", "--pause", 3001, "read", "1")
    check(ended.status == 2 and "--pause" in ended.errors, "a pause of more than 3 s is refused", ended)


def echoed(request):
    """The line gives back what is sent, and the unit answers at once."""
    return request + (good(request) if request[1] in (3, 4) else request)


def check_echo(tool, check):
    for words, value in (("0", 0), ("100", 100), ("1000", 1000), ("3201", 3201), ("8501", 8501), ("0x0200", 0x200)):
        with UnitOnLine(echoed) as line:
            how = ["--port", line.name, "--no-listen", "--timeout", 0.3, "--retries", 0, "-u", 1, "--json"]
            first = tool.run(*how, "read", words)
            check(first.status == DIFFERS and "the line echoes" in first.output and "--echo" in first.output, f"{words} tells the echo", first)
            known = tool.run(*how, "--echo", "read", words)
            check(known.status == DONE and [row["raw"] for row in known.objects()] == [value], f"{words} is read with --echo", known)
            two = tool.run(*how, "read", words, "0x4000").objects()
            check("the line echoes" in two[0]["error"] and two[1]["raw"] == 0x4000, f"{words} is told once, and what is behind it read", two)
    with UnitOnLine(echoed) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--json", "scan", "--units", "1-5")
        rows = ended.objects()
        check(ended.status == DIFFERS and len(rows) == 1 and "the line echoes" in rows[0]["note"], "the one finding of a scan", ended)
        check(len(line.unit.requests) == 1, "which asks no more", line.unit.requests)
    with UnitOnLine(lambda request: request + (good(request) if request[0] == 3 and request[1] == 3 else b"")) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.3, "--echo", "--json", "scan", "--units", "1-5")
        check(ended.status == DONE and [row["unit"] for row in ended.objects()] == [3], "a scan through the echo", ended)
    with UnitOnLine(lambda request: request) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.3, "--retries", 0, "--echo", "-u", 1, "read", "1")
        check(ended.status == NO_ANSWER and "no response in time" in ended.output, "an echo alone is no answer", ended)


PARTS = {"echo": check_echo, "formats": check_formats, "pieces": check_pieces, "pause": check_pause}


def main(check, program, part):
    with Tool(program) as tool:
        PARTS[part](tool, check)


runs(main)
