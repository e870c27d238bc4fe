# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""--drive none: of which units it is believed, and that what they hold is shown and noted as plain text.

    python3 no_drive.py TOOL
"""
import itertools
import struct

from support import DONE, NO_ANSWER, REFUSED, USAGE, Tool, Units, runs, with_crc


class Odd(Units):
    """Ends function 43 and reads of registers with these exceptions, or by silence (0); has coils 0 to 9."""

    def __init__(self, identity, reading=None, registers=None):
        self.identity, self.reading, self.coils = identity, reading, {}
        super().__init__({7: registers or {}})

    def answer(self, request):
        unit, function, address, value = request[0], request[1], *struct.unpack(">HH", request[2:6])
        if function in (3, 43):
            code = self.identity if function == 43 else self.reading
            if isinstance(code, dict):
                objects = b"".join(bytes([number, len(text)]) + text.encode() for number, text in code.items())
                return with_crc(bytes([unit, 43, 14, 1, 1, 0, 0, len(code)]) + objects)
            return super().answer(request) if code is None else code and with_crc(bytes([unit, function | 0x80, code]))
        if function == 5 and address < 10:
            self.coils[address] = value == 0xFF00
            return request
        if function == 1 and address < 10:
            return with_crc(bytes([unit, 1, 1, self.coils.get(address, False)]))
        if function == 16 and address in self.units[unit]:
            words = struct.unpack(f">{value}H", request[7:-2])
            self.units[unit].update({address + i: word for i, word in enumerate(words)})
            return with_crc(request[:6])
        return super().answer(request)

    def writes(self):
        return [each for each in self.requests if each[1] not in (1, 2, 3, 4, 8, 43)]


def check_gate(tool, check):
    """--drive none is believed of a unit that says, or whose registers show, that it is none; of no other."""
    def written(line, *words):
        ended = tool.run("-p", line.name, "--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, "-d", "none", "--write",
                         *words)
        return ended, line.writes()

    words = itertools.cycle(("holding:8501=6", "coil:1=on", "40:u32=5"))
    for code in (4, 5, 6, 8, 0x0A, 0x0B, 0x63, 0):
        for identity in (code, 1):
            with Odd(identity, code) as line:
                word = next(words)
                for beside in ([], ["--allow-run"]):
                    ended, sent = written(line, *beside, "write", word)
                    is_told = "is not known, so nothing is written" in ended.errors
                    check(ended.status == (REFUSED if code else NO_ANSWER) and is_told and not sent,
                          f"43 ends with {identity}, reading with {code}: {word} {beside}", ended)
    for identity, code in ((6, 2), (0, 2), (1, 1), (4, 3), (1, None), ({0: "ATS", 1: "Meter matv 3"}, 2)):
        with Odd(identity, code, {40: 1}) as line:
            ended, sent = written(line, "write", "coil:1=on")
            check(ended.status == DONE and len(sent) == 1, f"43 ends with {identity}, reading with {code}: is no drive", ended)
    for reading in (1, 2, 3):
        # A drive that starts, or hides its status, answers so, and takes the word all the same.
        for word in ("8501=15", "8502=500", "8602=1", "400=6", "h:0x6040=6", "0x60FF=6", "8500:u32=6", "8501:f32=1"):
            with Odd(1, reading, {int(a, 0): 0 for a in ("8501", "8502", "8602", "400", "0x6040", "0x60FF")}) as line:
                ended, sent = written(line, "write", "40=5", word)
                check(ended.status == REFUSED and "which this unit may be" in ended.errors and not sent,
                      f"reading with {reading}, and no name: {word} is refused", ended)
    with Odd({0: "Maker", 1: "PLC"}, 2, {400: 1}) as line:
        ended, sent = written(line, "write", "400=6")
        check(len(sent) == 1, "what says that it is none has its own registers there", ended)
    for said in ("atv320", "atv28"):
        with Odd({0: "Schneider Electric", 1: "ATV71HU15N4"}, None, {3201: 0x250, 3202: 0, 3105: 0, 10: 1}) as line:
            ended = tool.run("-p", line.name, "--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, "-d", said, "--write",
                             "write", "LSP=10Hz")
            check(ended.status == REFUSED and "calls itself" in ended.errors and not line.writes(), f"an ATV71 is no {said}", ended)
            ended = tool.run("-p", line.name, "--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, "-d", said, "backup", "-o",
                             "other.json")
            check(ended.status == USAGE and "is 'ATV71HU15N4', and --drive" in ended.errors, f"nor is its backup one of {said}", ended)
    for name in ("Altivar 71", "ATV71HU22", "atv 630", "VFD ATV-12", "Altistart 48", "LXM32", "ATV"):
        for identity in ({0: "Schneider Electric", 1: name}, {0: name, 1: "X"}):
            with Odd(identity, 2) as line:
                ended, sent = written(line, "--allow-run", "write", "coil:1=on")
                check(ended.status == REFUSED and "calls itself" in ended.errors and not sent, f"{identity} is a drive", ended)
    for command, registers in ((8501, {3201: 0x250, 8501: 0}), (0x6040, {0x6041: 0x250, 0x6040: 0})):
        with Odd({0: "Maker", 1: "X"}, None, {**registers, command - 1: 0, command + 1: 0, 40: 1, 611: 1}) as line:
            ended, sent = written(line, "write", "40=5")
            check(ended.status == REFUSED and f"and {command}" in ended.errors and not sent, f"a drive of anybody, {command}", ended)
            for word in (f"{command}=6", f"h:{command}:u16=6", f"{command - 1}:u32=6", f"{command - 3}:text9=abcdefgh",
                         f"{command}.3=1", f"{command}:f32=1"):
                ended, sent = written(line, "--allow-run", "write", "40=5", word)
                check(ended.status == REFUSED and "which this unit may be" in ended.errors and not sent, f"{word} there", ended)
            ended, sent = written(line, "--allow-run", "write", "611=5")
            check(ended.status == USAGE and "ATV310's menu" in ended.errors and not sent, "a number of two meanings", ended)
            ended, sent = written(line, "--allow-run", "write", "40=5", "0x0263=5")
            check(ended.status == DONE and len(sent) == 2, "its other registers are its owner's", ended)
    tool.port = "sim:atv310:7"
    ended = tool.run("--no-listen", "-u", 7, "-d", "none", "--write", "--allow-run", "write", "611=5")
    check(ended.status == USAGE and "ATV310's menu" in ended.errors, "a number of an ATV310's menu, said to be none", ended)


def check_control(tool, check):
    """What a unit holds is shown and noted as plain text."""
    with Odd(1, None, {40: 0x1B5B, 41: 0x324A, 42: 0x0A09, 43: 0x419B}) as line:
        tool.port = line.name
        how = ["--no-listen", "-u", 7, "-d", "none", "--write"]
        shown = tool.on_terminal(*how, "write", "40:text8=a", keys=[("(y/n)", "n\n")])
        check("\\x1B[2J\\x0A\\x09A\\x9B -> a" in shown.output and "\x1b[2J" not in shown.output, "the question is plain", shown)
        ended = tool.run(*how, "write", "40:text8=b")
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_bytes()
        check(b"\t40:text8\t\\x1B[2J\\x0A\\x09A\\x9B\t" in log and b"\x1b" not in log and b"\x9b" not in log,
              "and so is the log", (ended, log))


OWN_FILE = """[[register]]
name = "mover"
address = 43
access = "write"
moves = true

[[register]]
name = "limited"
address = 44
access = "write"
max = 10

[[register]]
name = "shown"
address = 45
"""


def check_file_of_name(tool, check):
    """--drive none leaves a name its register file, with what it says of each register; a type of a drive contradicts it."""
    (tool.place / "own.toml").write_text(OWN_FILE)
    (tool.place / "none.toml").write_text('drive = "none"\nname = ["m=7:own.toml"]\n')
    (tool.place / "drive.toml").write_text('drive = "atv320"\nname = ["m=7:own.toml"]\n')
    typed = ["--name", "m=7:own.toml"]
    with Odd({0: "Maker", 1: "PLC"}, None, {43: 0, 44: 0, 45: 0}) as line:
        tool.port, how = line.name, ["--no-listen", "--write", "-u"]
        for beside in ([*typed, "-d", "none"], typed, ["--config", "none.toml"]):
            for unit in ("m", 7):
                for word, status, says in (("mover=1", REFUSED, "mover moves something"), ("holding:43=1", USAGE, "say that name"),
                                           ("limited=11", USAGE, "at most 10"), ("44=11", USAGE, "say that name"),
                                           ("shown=1", USAGE, "read only")):
                    ended = tool.run(*how, unit, *beside, "write", word)
                    check(ended.status == status and says in ended.errors and not line.writes(), f"{beside} {unit}: {word}", ended)
        for beside in ([*typed, "-d", "atv320"], ["--config", "drive.toml"]):
            for words in (["write", "mover=1"], ["read", "shown"]):
                ended = tool.run(*how, "m", *beside, *words)
                is_told = "--name m=7:own.toml" in ended.errors and "said to be an atv320" in ended.errors
                check(ended.status == USAGE and is_told and not line.writes(), f"{beside}: {words}", ended)
        ended = tool.run(*how, "m", *typed, "-d", "none", "write", "limited=9")
        check(ended.status == DONE and line.units[7][44] == 9, "what the file allows is written", ended)


def check_question(tool, check):
    """Behind the question another unit of the same kind answers, or the value is another one."""
    for identity, status in (({0: "Acme", 1: "MX2", 2: "1.0"}, REFUSED), ({0: "Acme", 1: "MX1", 2: "1.1"}, REFUSED),
                             ({0: "Acme", 1: "MX1", 2: "1.0"}, DONE)):
        with Odd({0: "Acme", 1: "MX1", 2: "1.0"}, None, {40: 0}) as line:
            def answer():
                line.identity, line.units[7][40] = identity, 77
                return "y\n"

            ended = tool.on_terminal("--no-listen", "-u", 7, "-d", "none", "--write", "write", "40=5", port=line.name,
                                     keys=[("(y/n)", answer)])
            is_told = "another unit answers" in ended.output if status else "it was 0 (0x0000) when you were asked" in ended.output
            check(ended.status == status and line.units[7][40] == (77 if status else 5) and is_told, f"{identity} behind it", ended)
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text().splitlines()
    check(log[-1].endswith("\t40\t77 (0x004D)\t5"), "what was overwritten is noted", log[-1])


def main(check, program):
    with Tool(program) as tool:
        for part in (check_gate, check_control, check_file_of_name, check_question):
            part(tool, check)


runs(main)
