# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What is written, what is refused before a frame leaves, and what is noted of it.

    python3 writing.py TOOL
"""
import json
import os
import queue
import re
import resource
import signal
import subprocess

from support import DIFFERS, DONE, LIMIT, NO_ANSWER, PORT, REFUSED, USAGE, Ended, Simulator, Tool, Units, runs, with_crc

# Word, status, and what is said. The unit has these registers, as an ATV320 has them.
REFUSALS = [
    ("ACC=1.35s", USAGE, ["ACC=1.35s", "0.1 s"]),
    ("ACC=5Hz", USAGE, ["ACC=5Hz"]),
    ("HSP=70Hz", USAGE, ["HSP", "60.0 Hz"]),
    ("CHCF=NOPE", USAGE, ["CHCF", "SEP"]),
    ("RFR=3Hz", USAGE, ["RFR", "read only"]),
    ("ACCC=1s", USAGE, ["ACCC", "ACC"]),
    ("SP2X=1", USAGE, ["SP2X", "not among the 849 registers", "by its address", "SP2"]),
    ("SP2=1Hzz", USAGE, ["SP2"]),
    ("SP2=700Hz", USAGE, ["SP2", "599.0 Hz"]),
    ("CLI=1A", USAGE, ["CLI", "read only"]),
    ("9001=70000", USAGE, ["9001=70000s", "9001=#1 or"]),
    # Whoever has read raw counts at an address may mean them: no tenfold value.
    ("9001=25", USAGE, ["9001 is ACC", "9001=25s", "9001=#25", "9001=0x0019"]),
    ("9001=2.5", USAGE, ["9001 is ACC", "9001=2.5s", "9001=#"]),
    ("0x2329=25", USAGE, ["9001 is ACC", "9001=25s", "9001=#25"]),
    ("3104=50", USAGE, ["3104 is HSP", "3104=50Hz", "3104=#50"]),
    ("CMD=6", REFUSED, ["CMD", "start"]),
    ("8501=6", REFUSED, ["start"]),
    ("LFR=40Hz", REFUSED, ["LFR", "start"]),
    ("LFRD=100rpm", REFUSED, ["LFRD", "start"]),
    ("CMI=1", REFUSED, ["CMI"]),
    ("12345=1", REFUSED, ["12345", "--allow-run"]),
    ("NC1=15", REFUSED, ["NC1", "start"]),
    ("NCA1=8501", REFUSED, ["NCA1", "controller's words", "--allow-run"]),
    ("12722=0", REFUSED, ["NCA2", "controller's words", "--allow-run"]),
    ("TUN=YES", REFUSED, ["TUN", "current in the motor", "--allow-run"]),
    ("FCS=InI", REFUSED, ["FCS", "takes a drive's settings away"]),
    ("8002=64", REFUSED, ["FCS", "takes a drive's settings away"]),
    ("CFG=PId", REFUSED, ["CFG", "channels", "--allow-run"]),
    ("RP=YES", REFUSED, ["RP", "restarts the drive", "--allow-run"]),
    ("PISP=100", REFUSED, ["PISP", "reference", "--allow-run"]),
    ("AIV1=10%", REFUSED, ["AIV1", "reference", "--allow-run"]),
    ("FBCD=1", REFUSED, ["FBCD", "function blocks", "--allow-run"]),
    ("IL01=nO", REFUSED, ["IL01", "function blocks", "--allow-run"]),
    ("PS2=LI3", REFUSED, ["PS2", "which signal", "--allow-run"]),
    ("RRS=LI2", REFUSED, ["RRS", "a motor may turn", "--allow-run"]),
    ("TCC=3C", REFUSED, ["TCC", "a motor may turn", "--allow-run"]),
    ("COP=ALL", REFUSED, ["COP", "a motor may turn", "--allow-run"]),
    ("FLR=YES", REFUSED, ["FLR", "--allow-run"]),
    ("AUT=YES", REFUSED, ["AUT", "--allow-run"]),
    ("INH=LI3", REFUSED, ["INH", "--allow-run"]),
    ("STOA=nO", REFUSED, ["STOA", "safety", "--allow-run"]),
    ("S101=1", REFUSED, ["S101", "parameter sets", "--allow-run"]),
    ("OLL=nO", REFUSED, ["OLL=0", "reaction to a fault", "--allow-run"]),
    ("EPL=rLS", REFUSED, ["EPL=5", "reaction to a fault", "--allow-run"]),
    ("NST=nO", REFUSED, ["NST", "--allow-run"]),
    ("CHCF=SEP", REFUSED, ["CHCF", "a motor may turn", "--allow-run"]),
    ("CD1=TER", REFUSED, ["CD1", "a motor may turn", "--allow-run"]),
    ("FR1=MDB", REFUSED, ["FR1", "a motor may turn", "--allow-run"]),
    ("FLO=1", REFUSED, ["FLO", "a motor may turn", "--allow-run"]),
    ("SLL=NO", REFUSED, ["SLL=0", "supervision of the link off", "--allow-run"]),
    ("SLL=0", REFUSED, ["SLL=0", "supervision of the link off", "--allow-run"]),
    ("7010=0", REFUSED, ["SLL=0", "supervision of the link off", "--allow-run"]),
    ("SLL=4", REFUSED, ["SLL=4", "without its link", "--allow-run"]),
    ("SLL=RLS", REFUSED, ["SLL=5", "without its link", "--allow-run"]),
    # Defect D41: an address that nobody can ask.
    ("ADD=0", REFUSED, ["ADD=0", "no address", "--allow-run"]),
    ("6001=#0", REFUSED, ["ADD=0", "no address", "--allow-run"]),
    ("ATR=YES", REFUSED, ["ATR", "a motor may turn", "--allow-run"]),
]
REGISTERS = {3201: 0x0250, 3104: 500, 3105: 0, 9001: 30, 9020: 1, 8401: 1, 3202: 0, 8501: 0, 8502: 0, 8504: 0, 8602: 0,
             12345: 7, 12721: 8501, 12722: 8602, 12761: 0, 8413: 164, 8423: 10, 8431: 0, 7122: 0, 7010: 1, 3103: 600,
             6001: 7}


class Interrupting(Units):
    """Sends a signal, that of Ctrl-C or another, where the second write has come, before it answers that."""

    def __init__(self, units, number):
        self.waiting_for, self.writes, self.number = queue.Queue(), 0, number
        super().__init__(units)

    def answer(self, request):
        self.writes += request[1] == 6
        if request[1] == 6 and self.writes == 2:
            self.waiting_for.get().send_signal(self.number)
        return super().answer(request)


def check_interrupt(tool, check, number):
    """A signal between two values, as Ctrl-C is: what was begun is ended, told and noted."""
    with Interrupting({7: dict(REGISTERS)}, number) as line:
        process = tool.start("--port", line.name, "-u", "7", "--no-listen", "-d", "atv320", "--write", "--json", "write",
                             "HSP=49Hz", "HSP=48Hz", "LSP=1Hz", "HSP=47Hz")
        line.waiting_for.put(process)
        output, errors = process.communicate(timeout=LIMIT)
        errors_of = [row.get("error") for row in map(json.loads, output.splitlines())]
        check(process.returncode == 128 + number, f"{number}: its status is that of the signal", (process.returncode, output, errors))
        check(errors_of == [None, None, "not tried", "not tried"], "what was begun is told, and the rest is not begun", output)
        check(line.units[7][3104] == 480 and line.units[7][3105] == 0, "which is so", line.units[7])
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
        check("48.0 Hz" in log.splitlines()[-1], "and noted", log)


def check_interrupts(tool, check):
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGUSR1):
        check_interrupt(tool, check, number)


def check_refusals(tool, check):
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320"]
        for word, status, parts in REFUSALS:
            ended = tool.run(*how, "--write", "-y", "write", word)
            is_named = all(part in ended.errors for part in parts)
            check(ended.status == status and is_named, f"{word} is refused", ended)
        # A wrong type: what commands the motor of another one is refused, whatever is allowed.
        for drive, word in (("atv28", "8501=6"), ("atv28", "8602=1000"), ("atv320", "400=6"), ("atv12", "12768=1")):
            ended = tool.run(*how[:-1], drive, "--write", "--allow-run", "-y", "write", word)
            check(ended.status == REFUSED and "commands the motor of an" in ended.errors, f"{drive}: {word} is refused", ended)
        # The first is right, the second wrong: neither is written.
        check(tool.run(*how, "--write", "write", "ACC=2s", "RFR=1Hz").status == USAGE, "one wrong word among right ones")
        ended = tool.run(*how, "write", "ACC=2s")
        check(ended.status == REFUSED and "--write" in ended.errors, "nothing is written without --write", ended)
        check(not [each for each in line.requests if each[1] not in (3, 43)], "and nothing but reads was on the line")
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
    with Answering("keeps", {7: dict(REGISTERS)}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "write", "ACC=1.3s")
        check(ended.status == DIFFERS and "another value" in ended.output, "a unit that holds another value", ended)


FAILING = {"fails, and writes": 4, "busy, and writes": 6}  # exceptions


class Answering(Units):
    """Answers a write as it is told to: one of FAILING, `refuses` (exception 3), `loses` its response, `keeps` the old value, `stores` another,
    `damages` the CRC of all it says, or `dies` behind the write."""

    def __init__(self, how, units):
        self.how, self.is_dead = how, False
        super().__init__(units)

    def answer(self, request):
        start = int.from_bytes(request[2:4], "big")
        if self.is_dead or start == 9002 and self.how == "refuses second" and request[1] == 6:
            return None if self.is_dead else with_crc(bytes([request[0], 0x86, 3]))
        if request[1] == 6:
            if self.how in FAILING:
                super().answer(request)
                return with_crc(bytes([request[0], 0x86, FAILING[self.how]]))
            if self.how == "refuses":
                return with_crc(bytes([request[0], 0x86, 3]))
            if self.how == "refuses oddly":
                return with_crc(bytes([request[0], 0x86, 0x63]))
            if self.how == "keeps":
                return request
            said = super().answer(request)
            if self.how == "stores":
                self.units[request[0]][start] = 77
            self.is_dead = self.how == "dies"
            return None if self.how in ("loses", "dies") else said
        said = super().answer(request)
        return said and self.how == "damages" and said[:-1] + bytes([said[-1] ^ 1]) or said


# How the unit answers; status, what it shows as after and as error, and what the log says (nothing: no line).
RESULTS = [
    ("obeys", DONE, "1.3 s", None, "1.3 s"),
    ("refuses", DIFFERS, "3.0 s", "illegal data value (exception 0x03)", None),
    ("refuses oddly", DIFFERS, "3.0 s", "exception 0x63, which no specification lists", None),
    ("fails, and writes", DIFFERS, "1.3 s", "server device failure (exception 0x04)", "1.3 s"),
    ("busy, and writes", DIFFERS, "1.3 s", "server device busy (exception 0x06)", "1.3 s"),
    ("keeps", DIFFERS, "3.0 s", "the unit holds another value", "3.0 s"),
    ("stores", DIFFERS, "7.7 s", "the unit holds another value", "7.7 s"),
    ("loses", DONE, "1.3 s", None, "1.3 s"),
    ("dies", NO_ANSWER, None, "no response in time", "unknown"),
]


def check_results(tool, check):
    """What is shown and noted is what the unit holds, not what was wanted; what was not tried is told, too."""
    def answered(how, *words):
        with Answering(how, {7: {**REGISTERS, 9002: 40}}) as line:
            return tool.run("--port", line.name, "--no-listen", "--timeout", "0.5", "-u", 7, "-d", "atv320", "--write", *words), line

    file = tool.place / "state" / "rtuwire" / "writes.log"
    both = ("write", "ACC=1.3s", "DEC=2s")
    for how, status, after, error, noted in RESULTS:
        before = len(file.read_text().splitlines())
        ended, line = answered(how, "--json", *both)
        rows = ended.objects()
        check(ended.status == status and (rows[0]["after"], rows[0].get("error")) == (after, error), f"{how}: shown", ended)
        others = (rows[1]["before"], rows[1]["after"], rows[1].get("error"))
        expected = ("4.0 s", "2.0 s", None) if status == DONE and how != "loses" else ("4.0 s", None, "not tried")
        check(others == expected or how == "loses" and others[1] == "2.0 s", f"{how}: the other value", others)
        log = file.read_text().splitlines()[before:]
        found = [each.split("\t")[-1] for each in log if f"\t{line.name}\t7\tACC\t" in each]
        check(found == ([noted] if noted else []), f"{how}: noted", log)
        ended, _ = answered(how, *both)
        check((error or "1.3 s") in ended.output and (status == DONE or "not tried" in ended.output), f"{how}: table", ended)
        rows = answered(how, "--csv", *both)[0].rows()
        check((rows[0]["after"], rows[0]["error"]) == (after or "", error or ""), f"{how}: as CSV", rows)
    rows = answered("refuses second", "--json", *both)[0].objects()
    check([row["after"] for row in rows] == ["1.3 s", "4.0 s"] and "error" in rows[1], "the second is refused", rows)
    ended, _ = answered("damages", "--json", "read", "ACC")
    check(ended.status == DIFFERS and "CRC" in ended.objects()[0]["error"], "a wrong CRC is not silence", ended)


def check_once(tool, check):
    """Without retries a busy unit gets a write once."""
    for retries, sent in ((0, 1), (1, 4)):
        with Answering("busy, and writes", {7: dict(REGISTERS)}) as line:
            tool.run("--port", line.name, "--no-listen", "--retries", retries, "-u", 7, "-d", "atv320", "--write", "write", "ACC=1.3s")
            found = [each[1] for each in line.requests].count(6)
            check(found == sent, f"--retries {retries}: a busy unit gets it {sent} times", found)


class Masking(Units):
    """Has function 22; it writes these others besides."""

    def __init__(self, others):
        self.others = others
        super().__init__({7: {40: 0x0100, 41: 1}})

    def answer(self, request):
        if request[1] != 22:
            return super().answer(request)
        held, others, value = (int.from_bytes(request[at:at + 2], "big") for at in (2, 4, 6))
        self.units[7][held] = self.units[7][held] & others | value | self.others
        return request


def check_other_bits(tool, check):
    """A unit that writes other bits of the register, too, is told of, and all of it is noted."""
    file = tool.place / "state" / "rtuwire" / "writes.log"
    for others, status, words in ((0, DONE, ["40.0=on", "40.1=on"]), (0xF000, DIFFERS, ["40.0=on", "40.1=on"])):
        with Masking(others) as line:
            ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "-d", "none", "--write", "--json", "write", *words)
            error = ended.objects()[0].get("error")
            expected = "other bits of the register changed: 0x0100 -> 0xF101" if others else None
            check(ended.status == status and error == expected, f"others {others:#x}: told", ended)
            log = [each.split("\t")[4:] for each in file.read_text().splitlines()]
            check(log[-1] == (["40", "0x0100", "0xF101"] if others else ["40.1", "0", "1"]), f"others {others:#x}: noted", log[-2:])


def check_full_log(tool, check):
    """Nothing is written of which there is no room for a row, and no half row stays."""
    folder = tool.place / "state" / "rtuwire"
    log = folder / "writes.log"

    def written(line, size, *words):
        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        process = tool.start("--port", line.name, "--no-listen", "-u", 7, "-d", "none", "--write", "--csv", "write", *words,
                             preexec_fn=limited)
        output, errors = process.communicate(timeout=LIMIT)
        return Ended(process.returncode, output, errors)

    folder.mkdir(parents=True, exist_ok=True)
    for size in (0, 30, 1000):
        with Units({7: {40: 0, 41: 0}}) as line:
            log.write_text("")
            ended = written(line, size, "40=5")
            check(ended.status == PORT and "File too large" in ended.errors and not line.heard and not log.read_text(),
                  f"a log of at most {size} bytes", ended)
    with Units({7: {40: 0, 41: 0}}) as line:
        log.write_text("a half row")
        ended = written(line, 4096 + 256 + 20, "40=5", "41=6")
        notes = [row["note"] for row in ended.rows()]
        check(ended.status == PORT and (line.units[7][40], line.units[7][41]) == (5, 0) and notes[0] == ""
              and "not written: nothing could be noted" in notes[1], "the first row takes the room of the second", ended)
        rows = log.read_text().split("\n")
        check(rows[0] == "a half row" and rows[1].endswith("\t40\t0 (0x0000)\t5") and rows[2:] == [""], "a row is a line of its own", rows)
    log.unlink()
    if subprocess.run(["unshare", "-rm", "true"], capture_output=True).returncode != 0:
        return  # nobody may mount here
    with Units({7: {40: 0, 41: 0}}) as line:
        script = ('mount -t tmpfs -o size=64k none "$XDG_STATE_HOME" && mkdir "$XDG_STATE_HOME/rtuwire" && '
                  ': >"$XDG_STATE_HOME/rtuwire/writes.log" && { cat /dev/zero >"$XDG_STATE_HOME/fill" 2>/dev/null; "$@"; '
                  'echo "status $?"; cat "$XDG_STATE_HOME/rtuwire/writes.log"; }')
        command = tool.command(["--no-listen", "-u", 7, "-d", "none", "--write", "write", "40=5", "41=6"], line.name)
        ended = subprocess.run(["unshare", "-rm", "sh", "-c", script, "sh", *command], capture_output=True, text=True,
                               env=tool.environment, timeout=LIMIT)
        check(ended.stdout == "status 4\n" and "No space left" in ended.stderr and not line.heard, "a full disk", ended)


def check_permissions(tool, check):
    """A unit in the hands of its owner: --allow-run, raw counts, an amount with its unit."""
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write"]
        for word, address, value in (("9001=2.5s", 9001, 25), ("9001=#31", 9001, 31), ("9001=0x0020", 9001, 32),
                                     ("ACC=4", 9001, 40), ("SLL=6", 7010, 6)):
            ended = tool.run(*how, "write", word)
            check(ended.status == DONE and line.units[7][address] == value, f"{word} is written", ended)
        ended = tool.run(*how, "--allow-run", "write", "SLL=0")
        check(ended.status == DONE and line.units[7][7010] == 0, "--allow-run allows to run on without the link", ended)
        line.units[7][3103] = 0xFFFF
        ended = tool.run(*how, "write", "HSP=5000Hz")
        check(ended.status == USAGE and "TFR" in ended.errors, "an absurd limit is none", ended)


def check_full_disk(tool, check):
    """What was written is told, though the output takes nothing."""
    for form in ([], ["--json"], ["--csv"]):
        with Units({7: dict(REGISTERS)}) as line, open("/dev/full", "wb") as full:
            process = tool.start("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", *form, "write",
                                 "ACC=1.3s", "HSP=49Hz", stdout=full)
            _, errors = process.communicate(timeout=LIMIT)
            is_told = "standard output" in errors and "ACC: 3.0 s -> 1.3 s; what stands behind it was not tried" in errors
            held = (line.units[7][9001], line.units[7][3104])
            check(process.returncode == PORT and is_told and held == (13, 500), f"a write into a full disk {form}", (errors, held))


def check_no_reader(tool, check):
    """What was written is told, though nobody reads the output."""
    with Units({7: dict(REGISTERS)}) as line:
        reading, writing = os.pipe()
        os.close(reading)
        process = tool.start("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "write", "ACC=1.3s",
                             "HSP=49Hz", stdout=writing)
        os.close(writing)
        _, errors = process.communicate(timeout=LIMIT)
        is_told = "standard output" in errors and "ACC: 3.0 s -> 1.3 s; what stands behind it was not tried" in errors
        held = (line.units[7][9001], line.units[7][3104])
        check(process.returncode == PORT and is_told and held == (13, 500), "a write that nobody reads", (errors, held))


def check_log(tool, check):
    """The log is a regular file, or nothing is written: a pipe would keep the program waiting."""
    folder = tool.place / "state" / "rtuwire"
    log = folder / "writes.log"
    with Units({7: dict(REGISTERS)}) as line:
        how = ["--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write"]
        for what, make, says in (("a pipe", lambda: os.mkfifo(log), "is a pipe"), ("a folder", log.mkdir, "is a directory"),
                                 ("a device", lambda: log.symlink_to("/dev/full"), "is a device")):
            log.unlink(missing_ok=True) if not log.is_dir() else log.rmdir()
            make()
            ended = tool.run(*how, "write", "CMI=2")
            check(ended.status == PORT and says in ended.errors and str(log) in ended.errors, f"the log is {what}", ended)
            check(tool.run(*how, "reset").status == PORT, f"the log is {what}: reset")
        check(not line.heard, "nothing was sent", line.heard)
        log.unlink()
        (tool.place / "wanted.csv").write_text("register,value\nHSP,45 Hz\n")
        os.rmdir(folder)
        folder.write_text("in the way")
        ended = tool.run(*how, "write", "CMI=2")
        check(ended.status == PORT and "Not a directory" in ended.errors, "the log's folder is a file", ended)
        folder.unlink()
        kept = {name: tool.environment.pop(name) for name in ("HOME", "XDG_STATE_HOME")}
        places = {"defect: D41 there is no home": ({}, "no home"),
                  "a relative folder is none, as its specification says": ({"XDG_STATE_HOME": "state"}, "no home"),
                  "defect: D41 the log's folder cannot be made": ({"XDG_STATE_HOME": "/proc/nowhere"}, "/proc/nowhere")}
        for what, (place, says) in places.items():
            tool.environment.update(place)
            for words in (("write", "CMI=2"), ("write", "ACC=1s"), ("reset",), ("restore", "wanted.csv")):
                ended = tool.run(*how, *words)
                is_told = "nothing is written" in ended.errors and says in ended.errors
                check(ended.status == PORT and is_told, f"{what}: {words[0]}", ended)
        tool.environment.update(kept)
        check(not line.heard, "nothing was sent", line.heard)


def check_terminal(tool, check):
    with Simulator(tool.program, "atv320:7") as device:
        how = ["--port", device, "--no-listen", "-u", "7", "--write"]
        ended = tool.on_terminal(*how, "write", "ACC=1.3s", keys=[("(y/n)", "n\n")])
        check(ended.status == REFUSED and "3.0 s -> 1.3 s" in ended.output, "asks back, and takes no for an answer", ended)
        check(tool.run(*how, "--json", "read", "ACC").objects()[0]["raw"] == 30, "nothing is written")
        ended = tool.on_terminal(*how, "write", "ACC=1.3s", keys=[("", "y\n"), ("(y/n)", "n\n")])
        check(ended.status == REFUSED, "what was typed before the question is no answer to it", ended)
        check(tool.run(*how, "--json", "read", "ACC").objects()[0]["raw"] == 30, "nothing is written for it")
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


def check_question(tool, check):
    """While somebody is asked, the step of the value changes: 13 tenths of a second would be 0.13 s."""
    acc, step = 9001, 9020
    for changed, status, held in ((False, DONE, 13), (True, REFUSED, 30)):
        with Units({7: dict(REGISTERS)}) as line:
            def answer():
                line.units[7][step] = 0 if changed else 1
                return "y\n"

            ended = tool.on_terminal("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "write",
                                     "ACC=1.3s", keys=[("(y/n)", answer)])
            is_told = not changed or ("was 13 in the unit's steps" in ended.output and "130 in the unit's steps now" in ended.output)
            what = f"defect: D24 ACC=1.3s, its step {'changed' if changed else 'the same'} behind the question"
            check(ended.status == status and line.units[7][acc] == held and is_told, what, (ended, line.units[7][acc]))
    # A raw count is the same word, and another amount.
    for words in (["write", "ACC=#25"], ["ask", "06", "23290019"]):
        with Units({7: dict(REGISTERS)}) as line:
            def finer():
                line.units[7][step] = 0
                return "y\n"

            ended = tool.on_terminal("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "--allow-run", *words,
                                     keys=[("(y/n)", finer)])
            check(ended.status == REFUSED and line.units[7][acc] == 30 and "was 2.5 s" in ended.output and "0.25 s now" in ended.output,
                  f"{words}: the size of its steps has changed", (ended, line.units[7][acc]))
    with Units({7: dict(REGISTERS)}) as line:
        def lower():
            line.units[7][3104] = 100
            return "y\n"

        ended = tool.on_terminal("--port", line.name, "--no-listen", "-u", 7, "-d", "atv320", "--write", "--allow-run", "ask", "06",
                                 "0C210190", keys=[("(y/n)", lower)])
        check(ended.status == USAGE and "LSP takes" in ended.output and not any(each[1] == 6 for each in line.requests),
              "ask: a limit has changed", (ended, line.requests))


def main(check, program):
    with Tool(program) as tool:
        for part in (check_refusals, check_together, check_write, check_interrupts, check_results, check_once, check_other_bits, check_permissions,
                     check_full_disk, check_no_reader, check_log, check_full_log, check_terminal, check_question):
            part(tool, check)


runs(main)
