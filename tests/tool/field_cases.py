# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What people met with units and lines of their own, at pseudo-terminals and TCP ports: what the tool says of it.

    python3 field_cases.py TOOL PART
"""
import os
import time

from field_units import UnitOnLine, UnitOnTcp
from support import DIFFERS, DONE, NO_ANSWER, Tool, runs, with_crc


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


def gaps_of(ended):
    """Between the requests, by the clock of who paused: a busy machine shows them to this test when it comes to that."""
    sent = [float(each.split()[0]) for each in ended.errors.splitlines() if " > " in each]
    return [round(after - before, 3) for before, after in zip(sent, sent[1:])]


def check_pause(tool, check):
    for timeout, pause in ((1, 1000), (0.2, 700), (1, 0)):
        with UnitOnLine(good) as line:
            how = ["--port", line.name, "--no-listen", "--timeout", timeout, "--retries", 0, "--pause", pause, "--json", "-v"]
            began = time.monotonic()
            ended = tool.run(*how, "-u", 1, "read", "0x0100", "0x0200", "0x0300")
            took, gaps = time.monotonic() - began, gaps_of(ended)
        check(took >= 2 * pause / 1000, f"two pauses of {pause} ms take their time: {took:.3f} s")
        check(ended.status == DONE and [row["raw"] for row in ended.objects()] == [0x100, 0x200, 0x300],
              f"three values with a pause of {pause} ms and a time-out of {timeout} s", ended)
        # A busy machine makes one of them longer; a pause that is spent within the time-out, or behind it, all.
        check(len(gaps) == 2 and pause / 1000 <= min(gaps) < pause / 1000 + 0.5, f"{pause} ms between them: {gaps}", ended)
    with UnitOnLine(lambda request: b"") as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, "--retries", 1, "--pause", 500, "-v", "-u", 1, "read", "1")
        check(ended.status == NO_ANSWER and "no response in time" in ended.output, "a silent line is not jammed", ended)
        check(len(line.unit.requests) == 2 and len(gaps_of(ended)) == 1 and gaps_of(ended)[0] >= 0.5, "a repetition has its pause", ended)
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


def reading(line, *more):
    return ["--port", line.name, "--no-listen", "--timeout", 0.4, "--retries", 0, *more, "read"]


def xon_taken(request):
    """19 registers, of which software flow control takes the 11 between 51 and 79."""
    values = [0, 0, 0, 280, 114, 6, 62968, 0, 3632, 3000, 3000, 0, 4242, 4275, 4689, 4473, 4645, 3000, 0]
    whole = with_crc(request[:2] + bytes([38]) + b"".join(each.to_bytes(2, "big") for each in values))
    at = whole.index(b"\x11\x79")
    return whole[:at] + whole[at + 1:]


# What comes to a read, how many registers that asks for, and what is to be said of it.
CAUSES = [
    ("W16, the first bytes lost", lambda request: good(request)[2:], "0x1234",
     "its beginning is missing (01 03 in front gives a right CRC): a driver is released late"),
    ("the unit alone lost", lambda request: good(request)[1:], "0x1234", "(01 in front gives a right CRC)"),
    ("W17, a line at the wrong level", lambda request: bytes(5), "0x1234", "nothing but 00 came: the line is held"),
    ("W01, a byte in front", lambda request: b"\xFF" + good(request), "0x1234", "1 byte in front (FF)"),
    ("two bytes in front", lambda request: b"\xFE\xFF" + good(request), "0x1234", "--noise 2 skips as many"),
    ("W33, Modbus TCP", lambda request: b"\x15\x5C\0\0\0\x05\x01\x03\x02\x12\x34", "0x1234", "this is Modbus TCP, transaction 5468, unit 1"),
    ("W34, Modbus ASCII", lambda request: b":010302123480\r\n", "0x1234", "this is Modbus ASCII"),
    ("W35, a 11 taken", xon_taken, "0x0000-0x0012", "a 11 is missing between 51 and 79"),
]


def check_causes(tool, check):
    for what, said, words, told in CAUSES:
        with UnitOnLine(said) as line:
            ended = tool.run(*reading(line), words)
            check(ended.status == DIFFERS and told in ended.output, f"{what}: {told}", ended)
            rows = tool.run(*reading(line, "--json"), words).objects()
            seen = said(line.unit.requests[-1])
            check(all(told in row["error"] and seen.hex(" ").upper() in row["error"] for row in rows), f"{what}: for programs", rows)
    with UnitOnLine(lambda request: good(request)[:-1] + b"!") as line:
        ended = tool.run(*reading(line), "0x0102")
        check("CRC mismatch: 7 bytes came: 01 03 02 01 02" in ended.output and ";" not in ended.output, "a cause that nobody knows is not made up", ended)


def check_noise(tool, check):
    with UnitOnLine(lambda request: b"\xFF\xFE" + good(request)) as line:
        for noise, status in ((0, DIFFERS), (1, DIFFERS), (2, DONE), (8, DONE)):
            ended = tool.run(*reading(line, "--noise", noise, "--json"), "0x1234")
            check(ended.status == status, f"two bytes in front with --noise {noise}", ended)
            check(status != DONE or ended.objects()[0]["raw"] == 0x1234, "and the value is that of the unit", ended)
    check(tool.run("--port", "/dev/null", "--noise", 9, "read", "1").status == 2, "--noise is at most 8")


def check_any_unit(tool, check):
    with UnitOnLine(good) as line:
        without = tool.run(*reading(line, "-u", 248), "0x1234")
        check(without.status == 2 and "--any-unit" in without.errors and not line.unit.requests, "248 names the permission", without)
        ended = tool.run(*reading(line, "-u", 248, "--any-unit", "--json"), "0x1234")
        check(ended.status == DONE and ended.objects()[0]["raw"] == 0x1234, "W06: 248 is read", ended)
        check(line.unit.requests[-1] == bytes.fromhex("F80312340001") + with_crc(bytes.fromhex("F80312340001"))[-2:], "by a frame to F8", line.unit.requests)
        for unit in (256, 300, "0,1", "0-1", "248,249"):
            check(tool.run(*reading(line, "-u", unit, "--any-unit"), "0x1234").status == 2, f"{unit} is none all the same")
        ended = tool.run(*reading(line, "-u", 0, "--any-unit", "--json"), "0x1234", "input:7")
        check(ended.status == DONE and [each["raw"] for each in ended.objects()] == [0x1234, 7]
              and {each["unit"] for each in ended.objects()} == {0}, "0 is read", ended)
        check([each[0] for each in line.unit.requests[-2:]] == [0, 0], "by frames to 00", line.unit.requests)
        ended = tool.run(*reading(line, "-u", 0, "--any-unit", "--csv")[:-1], "watch", "0x1234", "--every", "20ms", "--for", "0.2s")
        check(ended.status == DONE and all(each["4660"] == "4660" for each in ended.rows()), "and watched", ended)
        asked = len(line.unit.requests)
        for unit, command in ((unit, command) for unit in (0, 248) for command in (
                ["--write", "write", "100=1"], ["stop"], ["--allow-run", "start", "--frequency", "5Hz"], ["scan"])):
            ended = tool.run("--port", line.name, "--no-listen", "-u", unit, "--any-unit", *command)
            check(ended.status == 2 and "--any-unit is for read, watch and identify" in ended.errors, f"no {command}", ended)
            ended = tool.run("--port", line.name, "--no-listen", "-u", unit, *command) if command[-1] != "scan" else ended
            check(ended.status == 2, f"no {command} at {unit}", ended)
        check(len(line.unit.requests) == asked, "and nothing is sent for it", line.unit.requests[asked:])
    own = lambda request: with_crc(b"\x05" + good(b"\x05" + request[1:])[1:-2])
    with UnitOnLine(own) as line:
        ended = tool.run(*reading(line, "-u", 0, "--any-unit"), "0x1234")
        check(ended.status == NO_ANSWER, "a response of another address is none to 0", ended)


def blocks(data):
    """The types of the blocks of a pcapng file, and the bytes of its packets."""
    at, found, packets = 0, [], []
    while at < len(data):
        kind, size = int.from_bytes(data[at:at + 4], "little"), int.from_bytes(data[at + 4:at + 8], "little")
        if size < 12 or data[at + size - 4:at + size] != data[at + 4:at + 8]:
            raise ValueError(f"block of {size} at {at}")
        found.append(kind)
        if kind == 6:
            packets.append(data[at + 28:at + 28 + int.from_bytes(data[at + 20:at + 24], "little")])
        at += size
    return found, packets


def check_exchange(tool, check):
    with UnitOnLine(lambda request: good(request) if request[3] != 9 else good(request)[:-1] + b"!") as line:
        ended = tool.run(*reading(line, "-v"), "0x0007", "0x0009")
        request = with_crc(bytes.fromhex("010300070001")).hex(" ").upper()
        shown = ended.errors.splitlines()
        check(len(shown) >= 4 and shown[0].endswith("> " + request), "-v shows the request", ended)
        check("< 01 03 02 00 07" in shown[1], "and what came", ended)
        check(any("< 01 03 02 00 09" in each and each.endswith("damaged") for each in shown), "a damaged one as that", ended)
        times = [float(each.split()[0]) for each in shown]
        check(times == sorted(times) and times[-1] < 10, "one behind the other", times)
        check(ended.output.count("> 01 03") == 0, "not among the results", ended)
        file = tool.place / "exchange.pcapng"
        tool.run(*reading(line, "--trace", file), "0x0007", "0x0009")
        kinds, packets = blocks(file.read_bytes())
        check(kinds[0] == 0x0A0D0D0A and len(packets) >= 4 and any(bytes.fromhex(request) in each for each in packets), "--trace keeps the exchange", kinds)
        played = tool.run("replay", file)
        check(played.status in (DONE, DIFFERS) and "01 03" not in played.errors and "2100000" not in played.output, "replay reads it", played)
        refused = tool.run(*reading(line, "--trace", tool.place / "none" / "file"), "0x0007")
        check(refused.status == 4 and "file" in refused.errors, "a file that cannot be written ends the command", refused)
        kept = file.read_bytes()
        os.mkfifo(tool.place / "fifo")
        asked = len(line.unit.requests)
        for there in (file, tool.place / "fifo", tool.place, "/dev/full"):
            refused = tool.run(*reading(line, "--trace", there), "0x0007", limit=10)
            check(refused.status == 4 and f"--trace {there}: is there already" in refused.errors, f"{there} is not written", refused)
        check(file.read_bytes() == kept and len(line.unit.requests) == asked, "it is kept, and nothing is sent", line.unit.requests[asked:])
        refused = tool.run("--port", line.name, "--no-listen", "--trace", "x", "backup", "-o", "./x")
        check(refused.status == 2 and "another file of this command" in refused.errors, "two files of one name", refused)
        refused = tool.run("--port", tool.place / "no-port", "--trace", "x", "read", "0x0007")
        check(refused.status == 4 and not (tool.place / "x").exists(), "a line that is none leaves no file", refused)


# What decode says of bytes that are no RTU frame.
DECODED = [
    ("W33", "15 5c 00 00 00 06 01 03 00 00 00 04", DIFFERS, ["Modbus TCP request", "transaction", "5468", "read holding registers"]),
    ("W34", ":01040000001AE1", DIFFERS, ["Modbus ASCII request", "read input registers", "26", "LRC"]),
    ("W35", "02 03 26 00 00 00 00 00 00 01 18 00 72 00 06 F5 F8 00 00 0E 30 0B B8 0B B8 00 00 10 92 10 B3 12 51 79 12 25 0B B8 00 00 0A DF",
     DIFFERS, ["a 11 is missing between 51 and 79", "software flow control"]),
    ("W17", "00 00 00 00 00", DIFFERS, ["nothing but 00 came"]),
    ("W36", "01 03 40 21", DIFFERS, ["4 bytes, where its fields say at least 8", "right"]),
    ("a good frame", "01 03 00 00 00 01 84 0A", DONE, []),
    ("a damaged one of no known cause", "01 03 00 00 00 01 84 0B", DIFFERS, []),
]


def check_decoded(tool, check):
    for what, text, status, told in DECODED:
        ended = tool.run("decode", "-", given=text + "\n")
        check(ended.status == status and all(each in ended.output for each in told), f"{what}: {told}", ended)
        check(("cause" in ended.output) == (what in ("W35", "W17")), f"{what}: a cause where there is one", ended)


PARTS = {"causes": check_causes, "noise": check_noise, "any_unit": check_any_unit, "exchange": check_exchange, "decoded": check_decoded,
         "echo": check_echo, "formats": check_formats, "pieces": check_pieces, "pause": check_pause}


def main(check, program, part):
    with Tool(program) as tool:
        PARTS[part](tool, check)


runs(main)
