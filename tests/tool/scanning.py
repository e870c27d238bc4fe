# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A scan of a whole line: what it finds, what it costs, and how it goes on where it was ended.

    python3 scanning.py TOOL          what holds on any machine
    python3 scanning.py TOOL share    how long the scan takes, on a machine with nothing else to do
    python3 scanning.py TOOL left     what it leaves: drives that trip where nobody goes on asking
"""
import os
import re
import signal
import time

from support import DONE, LIMIT, NO_ANSWER, PORT, REFUSED, USAGE, CountedLine, Simulator, Tool, Units, runs, soon, with_crc

THERE = {3: "atv12", 7: "atv320", 130: "atv310"}
DRIVES = [f"{drive}:{unit}" for unit, drive in THERE.items()]
ADDRESSES = 247
TIMEOUT = 0.05  # s, in which a drive on a busy machine answers
PATIENCE = 0.3  # s, where it has to
RATE = 19_200
REQUEST = (8 + 3.5) * 11 / RATE  # s on the wire, with its silence

SHORT_TIMEOUT = 0.03  # s, on a machine with nothing else to do
SHARE = 1.15  # of the time-outs alone, there


def check_share(tool, check):
    with Simulator(tool.program, *DRIVES) as device:
        began = time.monotonic()
        ended = tool.run("--port", device, "--no-listen", "--timeout", SHORT_TIMEOUT, "--json", "scan")
        spent = time.monotonic() - began
        check({row["unit"]: row["drive"] for row in ended.objects()} == THERE, "busy? Three drives, and nothing else", ended)
        most = (SHARE * SHORT_TIMEOUT + REQUEST) * ADDRESSES
        check(spent < most, f"busy? The scan takes {spent:.2f} s, allowed {most:.2f} s")


def check_whole_line(tool, check):
    with Simulator(tool.program, *DRIVES) as device:
        how = ["--port", device, "--no-listen", "--timeout", TIMEOUT]
        ended = tool.run(*how, "--json", "scan", limit=2 * LIMIT)
        found = {row["unit"]: row["drive"] for row in ended.objects()}
        check(ended.status == DONE and found == THERE, "three drives among 247 addresses, and nothing else", ended)
        first, *lines, further, last = ended.errors.splitlines()
        check("247 addresses" in first and "at most" in first, "the first line says how long it may take", first)
        check(further.startswith("note: next: `") and "-u 3 read RFR`" in further, "the one before, what is next", further)
        check(last.startswith("note: a drive that"), "the last line is of what it leaves", last)
        check(5 < len(lines) and all(re.match(r"\d+ of 237, asking unit \d+ at 19200 8E1, \d found", line) for line in lines),
              "a line of progress now and then, where it is no terminal, behind the lowest addresses", lines)
        check("\r" not in ended.errors and "\x1b" not in ended.errors, "without a terminal's characters")
        shown = tool.on_terminal(*how, "scan", "--units", "1-20").output
        check("\r" in shown and "left" in shown, "a line that changes on a terminal, with the time left")
        ended = tool.run(*how, "-b", 19200, "scan", "--units", "8-12")
        check(ended.status == NO_ANSWER, "nobody there: status 3")
        many = tool.run(*how, "--csv", "scan", "--units", "7", "--bauds", "9600,19200", "--formats", "8E1,8N1").rows()
        check([(row["baud"], row["format"]) for row in many]
              == [("9600", "8E1"), ("9600", "8N1"), ("19200", "8E1"), ("19200", "8N1")], "each bit rate and format", many)


def check_port_word(tool, check):
    """The port may stand behind the command: who begins types no option."""
    with Simulator(tool.program, *DRIVES) as device:
        ended = tool.run("scan", device, "--no-listen", "--timeout", PATIENCE, "--units", "1-8", "--json")
        check([row["unit"] for row in ended.objects()] == [3, 7], "scan PORT is --port PORT scan", ended)
        check(f" -p {device} " in ended.errors, "and stands as such in a command to paste", ended)
        ended = tool.run("--port", device, "scan", device)
        check(ended.status == USAGE and "--port" in ended.errors, "both are refused", ended)


def check_resume(tool, check):
    with Simulator(tool.program, *DRIVES) as device, CountedLine(device) as line:
        words = ["--port", line.name, "--no-listen", "--timeout", PATIENCE, "-b", RATE, "--json", "scan", "--units", "1-20,130", "--resume",
                 "found"]
        process = tool.start(*words)
        first = process.stdout.readline()
        second = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest, errors = process.communicate()
        check(process.returncode == 128 + signal.SIGINT and '"unit":3' in first and '"unit":7' in second and not rest,
              "Ctrl-C leaves what was found", (first, second, rest))
        check("goes on from there" in errors, "and says how it goes on", errors)
        seen = len((tool.place / "found").read_text().splitlines()) - 1
        line.requests = 0
        ended = tool.run(*words)
        check([row["unit"] for row in ended.objects()] == sorted(THERE), "it goes on, and shows all", ended)
        check(seen >= 7 and line.requests <= 26 - seen, "without asking again, but whether the unit is alone", (seen, line.requests))
        line.requests = 0
        again = tool.run(*words)
        check(again.output == ended.output and line.requests == 0, "and asks nobody when it is through", line.requests)
        os.remove(tool.place / "found")
        (tool.place / "found").write_text("something else\n")
        check(tool.run(*words).status != DONE and (tool.place / "found").read_text() == "something else\n",
              "a file of another kind is left alone")


# A file, and the line of it that is not believed.
DAMAGED = [
    ("# rtuwire scan\n19200 8E1 7", 2),
    ("# rtuwire scan\n19200 8E1 3\n19200 8E1 7\tunit=7", 3),
    ("# rtuwire scan\n19200 8E1 7\tunit=7\n", 2),
    ("# rtuwire scan\n19200 8E1 7\tunit=3\tbaud=9600\tdrive=nonsense\n", 2),
    ("# rtuwire scan\n19200 8E1 7\tunit=3\tbaud=19200\tformat=8E1\tvendor=\tproduct=\trevision=\tdrive=\tnote=\n", 2),
    ("# rtuwire scan\n19200 8E1 7\tunit=7\tbaud=19200\tformat=8E1\tvendor=\tproduct=\trevision=\tdrive=x\tnote=\n", 2),
    ("# rtuwire scan\ngarbage\n19200 8E1 6\n", 2),
    ("# rtuwire scan\n19200 8E1 6\n19200 8E1 999\n", 3),
    ("# rtuwire scan\n19200 8E1 719200 8E1 5\n", 2),
    ("# rtuwire scan\n12 8E1 7\n", 2),
    ("# rtuwire scan\n19200 8E1 7\n19200 8E1 7\n", 3),
    ("# rtuwire scan\n\n19200 8E1 7\n", 2),
    ("# rtuwire scan\r\n", None),
    ("# rtuwire scan", None),
]


def check_damaged(tool, check):
    """A file that is not whole is not believed, and not touched: it would make a unit that is there an absent one."""
    words = ["--port", "sim:atv320:7", "--no-listen", "scan", "--units", "5-8", "--resume"]
    file = tool.place / "damaged"
    for text, line in DAMAGED:
        file.write_bytes(text.encode())
        ended = tool.run(*words, "damaged")
        place = f"damaged:{line}: " if line else "no file of a scan"
        check(ended.status == USAGE and place in ended.errors and not ended.output and file.read_bytes() == text.encode(),
              f"{text!r} is refused", ended)
    for name, reason in (("/dev/full", "is a device"), (".", "is a directory"), ("pipe", "is a pipe"),
                         ("missing/scan", "No such file or directory")):
        os.mkfifo(tool.place / "pipe") if name == "pipe" else None
        ended = tool.run(*words, name)
        check(ended.status in (USAGE, PORT) and f"{name}: {reason}" in ended.errors, f"--resume {name}", ended)
    # What a device says of itself reaches no terminal as it is, whichever way it takes.
    with Sayer({7: {}}) as line:
        for form in ([], ["--csv"]):
            for words in (["scan", "--units", "7"], ["-u", "7", "identify"], ["scan", "--units", "7", "--resume", "said"],
                          ["scan", "--units", "7", "--resume", "said"]):
                ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, *form, *words)
                check(re.search(r"\\x1B\]0;x\\x07\\x1B\[2J\\x0A\\x0D.\\xFF\\xC2\\x9B", ended.output)
                      and not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", ended.output), f"{form} {words}: plain", ended)
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, "--json", "-u", 7, "identify")
        check(ended.objects()[0]["vendor"] == "\x1b]0;x\x07\x1b[2J\n\r|\ufffd\x9b"
              and not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", ended.output), "objects have it all, escaped", ended)
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, "-u", 7, "read", "RFR")
        check("\\x1B[2J" in ended.errors and "\x1b" not in ended.errors, "and in errors", ended)
    ended = tool.run("decode", "-", given="01 0\x1b[31mx")
    check(ended.status == USAGE and "\\x1B" in ended.errors and "\x1b" not in ended.errors, "a piped word, too", ended)
    ended = tool.run("ra\x1b[2Jed")
    check(ended.status == USAGE and "\\x1B" in ended.errors and "\x1b" not in ended.errors, "a typed word, too", ended)


class Sayer(Units):
    """A unit whose vendor's name would clear a screen, set its title and forge rows."""

    texts = (b"\x1b]0;x\x07\x1b[2J\n\r|\xff\xc2\x9b", b"thing", b"1")

    def answer(self, request):
        if request[1] != 43:
            return super().answer(request)
        objects = b"".join(bytes([number, len(text)]) + text for number, text in enumerate(self.texts))
        return with_crc(bytes([request[0], 43, 14, 1, 1, 0, 0, 3]) + objects)


class Terse(Sayer):
    """An ATV310 without the registers that its manual does not print: SLL and TTO."""

    texts = (b"Schneider Electric", b"ATV310H037N4", b"0201")


def check_listening(tool, check):
    """A line on which another master speaks is not scanned."""
    with Units({}) as line:
        process = tool.start("--port", line.name, "--listen", "1", "scan")
        while process.poll() is None:
            line.say(bytes.fromhex("07030C820001270C"))
            time.sleep(0.1)
        output, errors = process.communicate(timeout=LIMIT)
        check(process.returncode == REFUSED and "talking" in errors and not output, "a line in use is not scanned", errors)
        check(not line.heard, "nothing was sent", line.heard)
        began = time.monotonic()
        process = tool.start("--port", line.name, "--timeout", TIMEOUT, "scan", "--units", "1-3")
        soon(lambda: line.heard)
        check(time.monotonic() - began > 0.95, "it listens for a second before it speaks")
        process.communicate(timeout=LIMIT)
    with Units({9: {}}) as line:
        rows = tool.run("--port", line.name, "--no-listen", "--timeout", TIMEOUT, "--json", "scan", "--units", "5-12").objects()
        check([(row["unit"], row["drive"]) for row in rows] == [(9, "")], "a unit that only refuses is one", rows)


# What another master set in each before the scan, and when it trips where nobody asks. By their manuals an ATV28 trips after
# 7 s, as long as bit 14 of CMI (402) does not switch that off; the others after TTO (6005, in 0.1 s; 10 s as delivered), unless
# SLL (7010) is 0.
LEFT = {
    3: ("atv12", [(6005, 20)], "2.0 s"),
    4: ("atv310", [], "10.0 s"),
    5: ("atv28", [], "7.0 s"),
    6: ("atv28", [(402, 1 << 14)], None),
    7: ("atv320", [(6005, 15)], "1.5 s"),
    8: ("atv310_2026", [(6005, 10), (7010, 0)], None),
}


def check_left(tool, check):
    """Each drive that a scan finds is left to trip. It says which, after how long, and what resets it; which is done here."""
    simulator = Simulator(tool.program, *(f"{drive}:{unit}" for unit, (drive, _, _) in LEFT.items()))
    with simulator as device:
        for unit, (_, settings, _) in LEFT.items():
            for address, word in settings:
                simulator.suffer(f"{unit} write {address} {word}")
        how = ["--port", device, "--no-listen", "--timeout", 0.2]
        due = {str(unit): time_out for unit, (_, _, time_out) in LEFT.items() if time_out}
        last = ""
        for form in (["--json"], ["--csv"], []):
            ended = tool.run(*how, *form, "scan", "--units", "3-8")
            last = ended.errors.splitlines()[-1] if ended.errors else ""
            told = dict(re.findall(r"unit (\d+) after ([\d.]+ s)", last))
            check("SLF" in last and told == due, f"{form}: the last line says which drives trip, and when", last)
            found = ended.objects() if "--json" in form else ended.rows() if "--csv" in form else ended.table()
            check(ended.status == DONE and len(found) == len(LEFT), f"{form}: the output is of the units alone", ended.output)
        for unit in (3, 7):
            check.soon(lambda: simulator.shown(unit)[::2] == ("fault", 5), f"unit {unit} trips: SLF1")
        check(simulator.shown(8)[0] != "fault", "unit 8 does not, though its TTO is shorter")
        reset = re.search(r"`\S+rtuwire -p \S+ .* -u (\d+) (--write reset)`", last)
        check(reset and reset[1] in due, "it says what resets one", last)
        ended = tool.run(*how, "-u", 7, *(reset[2].split() if reset else ["reset"]))
        check(ended.status == DONE and "SLF1" in ended.output, "and that does", ended)
    with Terse({9: {3201: 0x0250}}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.2, "scan", "--units", "9")
        check("unit 9 after at most 30.0 s" in ended.errors, "without its registers the longest that can be set", ended)
    with Units({9: {}}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", TIMEOUT, "scan", "--units", "9")
        check("SLF" not in ended.errors, "of a unit that is no drive nothing is said", ended)
    ended = tool.run("--port", "sim:atv320:7", "scan", "--units", "7")
    check(ended.status == DONE and "SLF" not in ended.errors, "nor of drives that end with the scan", ended)


def check_simulated(tool, check):
    """Who is on a simulated line is known: nobody else is waited for, which would be 0.2 s each. What is next is said."""
    began = time.monotonic()
    ended = tool.run("--port", "sim:atv320:200,atv12:3", "--json", "scan")
    spent = time.monotonic() - began
    check([row["unit"] for row in ended.objects()] == [3, 200] and spent < 247 * 0.2 / 2, f"both are found in {spent:.1f} s", ended)
    check("-p sim:atv320:200,atv12:3 -u 3 read RFR`" in ended.errors, "the command that reads the first", ended)
    ended = tool.run("--port", "sim:atv320:7,atv12:3", "--timeout", SHORT_TIMEOUT, "read", "RFR")
    check(ended.status == NO_ANSWER and "no unit 1, only 3 and 7: say -u 3" in ended.errors, "who else is there", ended)


PARTS = {"": (check_whole_line, check_simulated, check_port_word, check_resume, check_damaged, check_listening), "share": (check_share,), "left": (check_left,)}


def main(check, program, part=""):
    with Tool(program) as tool:
        for each in PARTS[part]:
            each(tool, check)


runs(main)
