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
    ("NC1=15", REFUSED, ["NC1", "start"]),
    ("NCA1=8501", REFUSED, ["NCA1", "scanner", "--allow-run"]),
    ("12722=0", REFUSED, ["NCA2", "scanner", "--allow-run"]),
    ("CHCF=SEP", REFUSED, ["CHCF", "a motor may turn", "--allow-run"]),
    ("CD1=TER", REFUSED, ["CD1", "a motor may turn", "--allow-run"]),
    ("FR1=MDB", REFUSED, ["FR1", "a motor may turn", "--allow-run"]),
    ("FLO=1", REFUSED, ["FLO", "a motor may turn", "--allow-run"]),
    ("ATR=YES", REFUSED, ["ATR", "a motor may turn", "--allow-run"]),
]
REGISTERS = {3104: 500, 3103: 600, 3105: 0, 9001: 30, 9020: 1, 8401: 1, 3202: 0, 8501: 0, 8502: 0, 8504: 0, 8602: 0,
             12345: 7, 12721: 8501, 12722: 8602, 12761: 0, 8413: 164, 8423: 10, 8431: 0, 7122: 0}


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


def check_together(tool, check):
    """Registers that limit each other are checked as they will be when each is written, in the order that was typed."""
    for words, refused, written in ((["LSP=40Hz", "HSP=45Hz"], "", (400, 450)),
                                    (["HSP=58Hz", "LSP=55Hz"], "", (550, 580)),
                                    (["LSP=55Hz", "HSP=58Hz"], "LSP takes 0.0 Hz to 50.0 Hz (HSP)", (0, 500)),
                                    (["LSP=40Hz", "HSP=30Hz"], "HSP takes 40.0 Hz (LSP) to 60.0 Hz (TFR)", (0, 500)),
                                    (["HSP=30Hz", "LSP=40Hz"], "LSP takes 0.0 Hz to 30.0 Hz (HSP)", (0, 500))):
        with Units({7: dict(REGISTERS)}) as line:
            ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "write", *words)
            is_told = ended.status == (USAGE if refused else DONE) and refused in ended.errors
            check(is_told and (line.units[7][3105], line.units[7][3104]) == written, f"{words} together", ended)


def check_write(tool, check):
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write"]
        row = tool.run(*how, "--json", "write", "ACC=1.3s").objects()[0]
        check((row["before"], row["after"], row["note"]) == ("3.0 s", "1.3 s", ""), "old and new", row)
        check(line.units[7][9001] == 13 and [each[1] for each in line.requests[-2:]] == [6, 3], "written, and read back")
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_text().splitlines()
        is_whole = re.fullmatch(rf"\S+\t\S+\t{line.name}\t7\tACC\t3\.0 s\t1\.3 s", log[-1])
        check(is_whole, "noted: when, who, where, what", log)
        ended = tool.run(*how, "--allow-run", "write", "NCA1=8602")
        check(ended.status == DONE and line.units[7][12721] == 8602, "--allow-run allows what may move a motor", ended)
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
        check_together(tool, check)
        check_write(tool, check)
        check_terminal(program, tool, check)


runs(main)
