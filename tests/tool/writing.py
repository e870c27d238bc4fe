# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What is written, what is refused before a frame leaves, and what is noted of it.

    python3 writing.py TOOL
"""
import re

from support import DIFFERS, DONE, REFUSED, USAGE, Simulator, Tool, Units, runs

# Word, status, and what is said. The unit has these registers, as an ATV320 has them.
REFUSALS = [
    ("ACC=1.35s", USAGE, ["ACC=1.35s", "0.1 s"]),
    ("ACC=5Hz", USAGE, ["ACC=5Hz"]),
    ("HSP=70Hz", USAGE, ["HSP", "60.0 Hz"]),
    ("CHCF=NOPE", USAGE, ["CHCF", "SEP"]),
    ("RFR=3Hz", USAGE, ["RFR", "read only"]),
    ("ACCC=1s", USAGE, ["ACCC", "ACC"]),
    ("9001=70000", USAGE, ["70000"]),
    ("CMD=6", REFUSED, ["CMD", "start"]),
    ("8501=6", REFUSED, ["start"]),
    ("LFR=40Hz", REFUSED, ["LFR", "start"]),
    ("LFRD=100rpm", REFUSED, ["LFRD", "start"]),
    ("CMI=1", REFUSED, ["CMI"]),
    ("12345=1", REFUSED, ["12345", "--allow-run"]),
]
REGISTERS = {3104: 500, 3103: 600, 3105: 0, 9001: 30, 9020: 1, 8401: 1, 3202: 0, 8501: 0, 8502: 0, 8504: 0, 8602: 0,
             12345: 7}


def check_refusals(tool, check):
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320"]
        for word, status, parts in REFUSALS:
            ended = tool.run(*how, "--write", "-y", "write", word)
            is_named = all(part in ended.errors for part in parts)
            check(ended.status == status and is_named, f"{word} is refused", ended)
        # The first is right, the second wrong: neither is written.
        check(tool.run(*how, "--write", "write", "ACC=2s", "RFR=1Hz").status == USAGE, "one wrong word among right ones")
        ended = tool.run(*how, "write", "ACC=2s")
        check(ended.status == REFUSED and "--write" in ended.errors, "nothing is written without --write", ended)
        check(not [each for each in line.requests if each[1] != 3], "and nothing but reads was on the line")
        check(line.units[7] == REGISTERS, "all is as it was")


def check_write(tool, check):
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write"]
        row = tool.run(*how, "--json", "write", "ACC=1.3s").objects()[0]
        check((row["before"], row["after"], row["note"]) == ("3.0 s", "1.3 s", ""), "old and new", row)
        check(line.units[7][9001] == 13 and [each[1] for each in line.requests[-2:]] == [6, 3], "written, and read back")
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_text().splitlines()
        is_whole = re.fullmatch(rf"\S+\t\S+\t{line.name}\t7\tACC\t3\.0 s\t1\.3 s", log[-1])
        check(len(log) == 1 and is_whole, "noted: when, who, where, what", log)
    with Forgetful({7: dict(REGISTERS)}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "write", "ACC=1.3s")
        check(ended.status == DIFFERS and "another value" in ended.output, "a unit that holds another value", ended)


class Forgetful(Units):
    """Confirms writes, and keeps what it had."""

    def answer(self, request):
        return request if request[1] == 6 else super().answer(request)


def check_terminal(program, tool, check):
    with Simulator(program, "atv320:7") as device:
        how = ["--port", device, "--no-listen", "-u", "7", "--write"]
        ended = tool.on_terminal(*how, "write", "ACC=1.3s", keys=[("(y/n)", "n\n")])
        check(ended.status == REFUSED and "3.0 s -> 1.3 s" in ended.output, "asks back, and takes no for an answer", ended)
        check(tool.run(*how, "--json", "read", "ACC").objects()[0]["raw"] == 30, "nothing is written")
        ended = tool.on_terminal(*how, "write", "ACC=1.3s", keys=[("(y/n)", "y\n")])
        check(ended.status == DONE, "writes at a yes", ended)
        check("supervision" in ended.output, "says what a request does to a drive's supervision", ended.output)
        check(tool.run(*how, "--json", "read", "ACC").objects()[0]["raw"] == 13, "it is written")
        ended = tool.on_terminal(*how, "-y", "write", "ACC=2s")
        check(ended.status == DONE and "(y/n)" not in ended.output, "--yes asks nothing", ended)
        # Saving is counted, for this port and unit.
        notes = [tool.run(*how, "--json", "write", "CMI=2").objects()[0]["note"] for _ in range(3)]
        check([re.search(r"EEPROM (\d+) times", note)[1] for note in notes] == ["1", "2", "3"], "saves are counted", notes)
        check("limited" in notes[0], "and warned of")


def main(check, program):
    with Tool(program) as tool:
        check_refusals(tool, check)
        check_write(tool, check)
        check_terminal(program, tool, check)


runs(main)
