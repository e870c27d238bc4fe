# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Bytes and settings of cases that people reported, W01 to W37: what the tool says to each, or which test holds it.

    python3 field_vectors.py TOOL
"""
import time

from field_units import UnitOnLine, UnitOnTcp
from support import DIFFERS, DONE, HERE, REFUSED, USAGE, Line, Tool, runs, with_crc

TESTS = HERE.parent


class Scripted:
    """A unit of a case: to this request it says each of these answers once, the last one from there on; each is bytes, or
    pieces (seconds to wait, bytes). Whatever else is asked, who it is, it does not know."""

    def __init__(self, request, *answers):
        self.request, self.answers, self.count = bytes.fromhex(request), answers, 0

    def __call__(self, request):
        if request != self.request:
            return with_crc(bytes([request[0], request[1] | 0x80, 1])) if request[0] else b""
        answer = self.answers[min(self.count, len(self.answers) - 1)]
        self.count += 1
        return bytes.fromhex(answer) if isinstance(answer, str) else [(wait, bytes.fromhex(data)) for wait, data in answer]


WRITES = ["-d", "none", "--write"]
ASKS = [*WRITES, "--allow-run"]  # nobody says that the unit is no drive
FREE = []

# A case; its line and options; the command; the frame that has to be sent, what comes; status, what is said, what is not; and
# how often the frame is sent.
CLIENT = [
    ("W01", "19200 8E1", ASKS, ["-u", 1, "ask", "06", "0F9F0000"], "01 06 0F 9F 00 00 BA F0", ["FF 01 06 0F 9F 00 00 BA F0"],
     DIFFERS, ["1 byte in front (FF)", "--noise 1"], [], 1),
    ("W01", "19200 8E1", [*ASKS, "--noise", 1], ["-u", 1, "ask", "06", "0F9F0000"], "01 06 0F 9F 00 00 BA F0",
     ["FF 01 06 0F 9F 00 00 BA F0"], DONE, [], ["CRC mismatch"], 1),
    ("W02", "9600 8N1", FREE, ["-u", 1, "read", "28674"], "01 03 70 02 00 01 3F 0A", ["01 03 00 02 17 81 2B 9A"],
     DIFFERS, ["right CRC, wrong length", "8 bytes came, 7 are due"], ["1781", "6017"], 1),
    ("W03", "9600 8N1", FREE, ["-u", 1, "read", "2030-2031"], "01 03 07 EE 00 02 A5 4A",
     ["01 03 0C 43 3F 00 00 20 4C 49 54 48 49 55 4D D0 05"], DIFFERS, ["right CRC, wrong length", "17 bytes came, 9 are due"], [], 1),
    ("W04", "9600 8N1", ["--retries", 1], ["-u", 1, "read", "input:0-1"], "01 04 00 00 00 02 71 CB",
     ["01 04 00 22 C0", "01 04 04 43 67 AF 55 E2 10"], DONE, ["17255", "44885"], [], 2),
    ("W06", "9600 8N1", ["--any-unit"], ["-u", 248, "read", "input:0-7"], "F8 04 00 00 00 08 E5 A5",
     ["F8 04 10 04 95 00 00 00 00 00 00 00 02 00 00 00 00 00 00 8D C8"], DONE, ["1173"], [], 1),
    ("W07", "9600 8N1", ["--retries", 2], ["-u", 1, "ask", "04", "00000009"], "01 04 00 00 00 09 30 0C", ["01 84 02 C2 C1"],
     DIFFERS, ["0x02"], [], 1),
    ("W08", "9600 8E1", [*ASKS, "-y"], ["-u", 0, "ask", "06", "40000002"], "00 06 40 00 00 02 1C 1A",
     [[(0.03, "02 06 00 00 00 02 08 38")]], DONE, ["nobody answers a broadcast"], ["mismatch"], 1),
    ("W09", "9600 8N1", ["--any-unit"], ["-u", 0, "read", "holding:0"], "00 03 00 00 00 01 85 DB", ["00 03 02 00 05 45 87"],
     DONE, ["5"], [], 1),
    ("W10", "9600 8N1", ASKS, ["-u", 201, "ask", "10", "00C00001020000"], "C9 10 00 C0 00 01 02 00 00 80 95", ["C9 01 00 A0 6E"],
     DIFFERS, ["another function"], [], 1),
    ("W11", "9600 8N1", FREE, ["-u", 1, "ask", "03", "00000001"], "01 03 00 00 00 01 84 0A", ["01 83 02 00 F1 50"],
     DIFFERS, ["right CRC, wrong length", "6 bytes came, 5 are due"], ["exception 0x02"], 1),
    ("W12", "9600 8N1", ASKS, ["-u", 2, "ask", "06", "00000000"], "02 06 00 00 00 00 89 F9", ["02 06 00 00 00 00 06 B8 A4"],
     DIFFERS, ["right CRC, wrong length", "9 bytes came, 8 are due"], [], 1),
    ("W13", "9600 8N1", FREE, ["-u", 1, "ask", "03", "00000004"], "01 03 00 00 00 04 44 09", ["01 03 00 00 00 00 00 00 00 00 35 32"],
     DIFFERS, ["right CRC, wrong length", "12 bytes came"], [], 1),
    ("W14", "19200 8E1", FREE, ["-u", 32, "ask", "11"], "20 11 D8 7C", ["20 11 10 FF 68 75 6D 2D 31 2E 30 2D 35 35 02 04"],
     DIFFERS, ["right CRC, wrong length", "16 bytes came"], [], 1),
    ("W15", "9600 8N1", FREE, ["-u", 5, "ask", "0C"], "05 0C 02 E5", ["05 0C 09 00 00 00 00 00 03 80 42 80 B7 DD"], DONE, ["80 42 80"], [], 1),
    ("W16", "9600 8N1", FREE, ["-u", 1, "ask", "03", "00000001"], "01 03 00 00 00 01 84 0A", ["02 23 6E 20 98"],
     DIFFERS, ["01 03 in front gives a right CRC", "a driver is released late"], [], 1),
    ("W17", "9600 8E1", FREE, ["-u", 1, "ask", "04", "00000012"], "01 04 00 00 00 12 70 07", ["00 00 00 00 00"],
     DIFFERS, ["nothing but 00 came", "held"], [], 1),
    ("W18", "9600 8N1", FREE, ["-u", 1, "ask", "03", "00000001"], "01 03 00 00 00 01 84 0A",
     [[(0, "01 03 00 00 00 01 84 0A"), (0.003, "01 03 02 00 07 F9 86")]], DIFFERS, ["echo"], [], 1),
    ("W18", "9600 8N1", ["--echo"], ["-u", 1, "read", "0"], "01 03 00 00 00 01 84 0A",
     [[(0, "01 03 00 00 00 01 84 0A"), (0.003, "01 03 02 00 07 F9 86")]], DONE, ["7"], [], 1),
    ("W19", "9600 8N1", FREE, ["-u", 1, "read", "0-1"], "01 03 00 00 00 02 C4 0B", [[(0.005, "01 03 04 00"), (0.12, "01 00 02 2A 32")]],
     DIFFERS, [], [], 1),
    ("W20", "9600 8N1", ["--pause", 1000, "--timeout", 1], ["-u", 1, "watch", "input:0-1", "--every", "10ms", "--for", "2.5s"],
     "01 04 00 00 00 02 71 CB", [[(0.02, "01 04 04 43 67 AF 55 E2 10")]], DONE, ["17255"], ["jam"], 3),
    ("W21", "300 8E1", FREE, ["-u", 1, "read", "0"], "01 03 00 00 00 01 84 0A", ["01 03 02 00 07 F9 86"], DONE, ["7"], [], 1),
    ("W21", "250000 8N1", FREE, ["-u", 1, "read", "0"], "01 03 00 00 00 01 84 0A", ["01 03 02 00 07 F9 86"], DONE, ["7"], [], 1),
    ("W22", "9600 8E2", FREE, ["-u", 53, "ask", "2B", "0E0100"], "35 2B 0E 01 00 C1 B3",
     [[(0.02, "35 2B 0E 01 01 00 00 03 00 01 41 01 01 42 02 01 43 0C 8A")]], DONE, [], [], 1),
    ("W24", "9600 8N1", ASKS, ["-u", 1, "ask", "05", "021388"], "01 05 02 13 88 B5 9A", [],
     USAGE, ["05"], ["echo"], 0),
]

# decode: a case, what is typed, status, what is said, what is not.
DECODED = [
    ("W27", r"b'\x01\x03\x02\x12\x34\xb5\x33'", DONE, ["4660", "right"], ["wrong"]),
    ("W28", "SEND: 0x2 0x3 0x0 0x18 0x0 0x9 0x5 0xf8", DONE, ["request", "24", "9", "right"], ["wrong"]),
    ("W29", "F7.03.50.0A.00.05.A0.5D", DONE, ["request", "247", "20490", "5", "right"], ["wrong"]),
    ("W30", "Tx:000011-01 01 01 00 51 88", DONE, ["response", "read coils", "byte count", "right"], ["wrong"]),
    ("W31", "-> 1-3-0-13-0-1-21-201", DONE, ["request", "13", "right", "decimal"], ["wrong"]),
    ("W32", "1-3-0-13-0-1-21-99", DIFFERS, ["hexadecimal", "decimal"], ["  right\n"]),
    ("W33", "15 5c 00 00 00 06 01 03 00 00 00 04", DIFFERS, ["Modbus TCP", "5468"], []),
    ("W34", ":01040000001AE1", DIFFERS, ["Modbus ASCII", "26", "LRC"], []),
    ("W35", "02 03 26 00 00 00 00 00 00 01 18 00 72 00 06 F5 F8 00 00 0E 30 0B B8 0B B8 00 00 10 92 10 B3 12 51 79 12 25 0B B8 00 00 0A DF",
     DIFFERS, ["a 11 is missing between 51 and 79", "software flow control"], []),
    ("W36", "01 03 40 21", DIFFERS, ["4 bytes", "at least 8", "right"], []),
    ("W37", "01 03 02 58 00 01 04 61", DONE, ["first register  600\n", "right"], []),
]

# What no program shows from outside: the test that holds it, by its name.
ELSEWHERE = {
    "W02": "client/own_formats.cpp", "W03": "client/own_formats.cpp", "W24": "client/own_formats.cpp",  # by an express rule
    "W05": "client/own_formats.cpp",  # function 0x41 to 248
    "W23": "defect/port_transceiver.cpp",
}


def check_client(tool, check):
    for case, line, options, command, request, answers, status, told, never, count in CLIENT:
        rate, form = line.split()
        with UnitOnLine(Scripted(request, *answers) if answers else lambda _: b"") as there:
            how = ["--port", there.name, "--no-listen", "-b", rate, "-f", form]
            how += [] if "--timeout" in options else ["--timeout", 0.5]
            how += [] if "--retries" in options else ["--retries", 0]
            ended = tool.run(*how, *options, *command)
            sent = there.unit.requests.count(bytes.fromhex(request))
            said = ended.output + ended.errors
            check(ended.status == status, f"{case}: status {status}", ended)
            check(all(each in said for each in told), f"{case}: {told}", ended)
            check(not any(each in said for each in never), f"{case}: nothing of {never}", ended)
            check(sent == count, f"{case}: {request} is sent {count} times", there.unit.requests)


def check_default_at_0(tool, check):
    """W09: a broadcast read has no answer."""
    with UnitOnLine(lambda _: b"") as line:
        ended = tool.run("--port", line.name, "--no-listen", "-u", 0, "read", "0")
        check(ended.status == USAGE and "--any-unit" in ended.errors and not line.unit.requests, "W09: not by default", ended)


def check_16_after_06(tool, check):
    """W25, to the end: bytes of this test's own."""
    by_16 = bytes.fromhex("01 10 00 05 00 01 02 00 07")
    held = [3]

    def said(request):
        if request[1] == 3 and request[2:4] == b"\0\5":
            return with_crc(bytes([1, 3, 2, 0, held[0]]))
        if request == with_crc(by_16):
            held[0] = 7
            return with_crc(by_16[:6])
        return with_crc(bytes([request[0], request[1] | 0x80, 1]))

    for code in (1, 2, 3, 4):
        def refused(request, code=code):
            return with_crc(bytes([1, 0x86, code])) if request[1] == 6 else said(request)
        held[0] = 3
        with UnitOnLine(refused) as line:
            ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "-u", 1, *WRITES, "--json", "write", "5=7")
            writes = [each for each in line.unit.requests if each[1] in (6, 16)]
        first = bytes.fromhex("01 06 00 05 00 07 D8 09")
        if code == 1:
            check(writes == [first, with_crc(by_16)] and ended.status == DONE and held == [7]
                  and "no function 06: written by 16" in ended.objects()[0]["note"], "W25: 16 once, which is said", (ended, writes))
        else:
            check(writes == [first] and ended.status == DIFFERS and held == [3], f"exception {code:02} is no reason for 16", (ended, writes))
    held[0] = 3
    with UnitOnLine(lambda request: said(request) if request[1] == 3 else with_crc(bytes([1, request[1] | 0x80, 1]))) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.5, "-u", 1, *WRITES, "write", "5=7")
        writes = [each[1] for each in line.unit.requests if each[1] in (6, 16)]
        check(writes == [6, 16] and ended.status == DIFFERS, "a unit without either is asked by 16 once", (ended, writes))


def check_pieces_over_tcp(tool, check):
    with UnitOnTcp(Scripted("01 03 00 00 00 02 C4 0B", [(0.005, "01 03 04 00"), (0.12, "01 00 02 2A 32")])) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 2, "--json", "-u", 1, "read", "0-1")
        check(ended.status == DONE and [each["raw"] for each in ended.objects()] == [1, 2], "W19: over TCP", ended)


def check_line_in_use(tool, check):
    """W26: whoever listens first hears a client and its unit; the second frame lacks a byte."""
    frames = [bytes.fromhex("14 04 00 34 00 02 32 C0"), bytes.fromhex("14 04 04 14 00 00 FA 7D")]
    with Line() as line:
        process = tool.start("--port", line.name, "--listen", 1.5, "-u", 7, "read", "0")
        for _ in range(3):
            for frame, wait in zip(frames, (0.05, 0.2)):
                time.sleep(wait)
                line.say(frame)
        output, errors = process.communicate(timeout=20)
        check(process.returncode == REFUSED and "20" in errors and not line.heard, "W26: nobody speaks in between", (output, errors, line.heard))


def check_decode(tool, check):
    for case, text, status, told, never in DECODED:
        ended = tool.run(*(["-d", "atv320"] if case == "W37" else []), "decode", "-", given=text + "\n")
        said = ended.output + ended.errors
        check(ended.status == status and all(each in said for each in told), f"{case}: {told}", ended)
        check(not any(each in said for each in never), f"{case}: nothing of {never}", ended)


def check_whole(check):
    held = {each[0] for each in (*CLIENT, *DECODED)} | {"W25", "W26"}
    for case, place in ELSEWHERE.items():
        check(case in (TESTS / place).read_text(), f"{place} holds {case}")
    every = {f"W{number:02}" for number in range(1, 38)}
    check(held | set(ELSEWHERE) == every, "each of the 37 cases is held", sorted(every - held - set(ELSEWHERE)))


def main(check, program):
    check_whole(check)
    with Tool(program) as tool:
        for part in (check_client, check_default_at_0, check_16_after_06, check_pieces_over_tcp, check_line_in_use, check_decode):
            part(tool, check)


runs(main)
