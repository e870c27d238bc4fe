# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`map`: which addresses a unit has, of units that nobody here wrote (pymodbus), whatever they refuse; how it ends and goes on.

    python3 mapping.py TOOL
    python3 mapping.py --serve DEVICE
"""
import asyncio
import signal
import subprocess
import sys

METER, MODULE, SHORT, FEW, ODD = 61, 62, 63, 64, 65
INPUTS = [*range(0, 9), 12, *range(100, 330), 400, 402, *range(1000, 1012), 65535]
COILS = [*range(5, 40), 77]


def runs_of(addresses):
    """[1, 2, 3, 7] -> [(1, 3), (7, 7)]"""
    found = []
    for each in sorted(addresses):
        if found and found[-1][1] == each - 1:
            found[-1] = (found[-1][0], each)
        else:
            found.append((each, each))
    return found


async def serve(device):
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.pdu import ModbusExceptions
    from pymodbus.register_read_message import ReadHoldingRegistersRequest, ReadInputRegistersRequest
    from pymodbus.bit_read_message import ReadCoilsRequest, ReadDiscreteInputsRequest
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    class Meter(ModbusSlaveContext):
        """Has function 04 only; others are refused with exception 01."""

    class OneEach(ModbusSlaveContext):
        """Answers one register a request."""

        def validate(self, code, address, count=1):
            return count == 1 and super().validate(code, address, count)

    class Few(ModbusSlaveContext):
        """Answers 20 registers at most, else exception 03."""

    class Odd(ModbusSlaveContext):
        """Refuses what it lacks with exception 03, and fails at 7 with 04."""

    for request, code in ((ReadHoldingRegistersRequest, 3), (ReadInputRegistersRequest, 4), (ReadCoilsRequest, 1),
                          (ReadDiscreteInputsRequest, 2)):
        def execute(self, context, known=request.execute, code=code):
            if isinstance(context, Meter) and code != 4:
                return self.doException(ModbusExceptions.IllegalFunction)
            if isinstance(context, Few) and self.count > 20:
                return self.doException(ModbusExceptions.IllegalValue)
            if isinstance(context, Odd) and self.address <= 7 < self.address + self.count:
                return self.doException(ModbusExceptions.SlaveFailure)
            if isinstance(context, Odd) and not context.validate(code, self.address, self.count):
                return self.doException(ModbusExceptions.IllegalValue)
            return known(self, context)
        request.execute = execute

    def block(addresses):
        return ModbusSparseDataBlock({each: each for each in addresses})

    def kind(which):
        return which(ir=block(INPUTS), hr=block(INPUTS), co=block(COILS), di=block(COILS), zero_mode=True)

    context = ModbusServerContext(slaves={METER: kind(Meter), MODULE: kind(ModbusSlaveContext), SHORT: kind(OneEach), FEW: kind(Few),
                                          ODD: kind(Odd)}, single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=115200, parity="N", stopbits=2,
                                          ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


QUIET = ["--listen", "0.05", "-b", 115200, "-f", "8N2", "-d", "none", "--timeout", 0.5]


def found_in(rows):
    return [(row["space"], int(row["first"]), int(row["last"])) for row in rows if not row["note"]]


def wanted(space, addresses, first, last):
    return [(space, *each) for each in runs_of([one for one in addresses if first <= one <= last])]


def check_kinds(tool, check):
    """What each kind of unit has is found, no more and no less."""
    for unit, space, addresses, first, last in (
            (METER, "input", INPUTS, 0, 1100), (MODULE, "holding", INPUTS, 90, 420), (MODULE, "input", INPUTS, 65400, 65535),
            (MODULE, "coil", COILS, 0, 200), (MODULE, "discrete", COILS, 30, 90), (SHORT, "holding", INPUTS, 0, 140),
            (FEW, "holding", INPUTS, 0, 420)):
        ended = tool.run(*QUIET, "-u", unit, "--json", "map", f"{space}:{first}-{last}")
        check(ended.status == DONE and found_in(ended.objects()) == wanted(space, addresses, first, last),
              f"unit {unit} has {space} {first} to {last}", ended)
    ended = tool.run(*QUIET, "-u", ODD, "--json", "map", "0-120")
    rows = ended.objects()
    check(ended.status == DONE and found_in(rows) == wanted("holding", [each for each in INPUTS if each != 7], 0, 120)
          and [(row["first"], row["last"]) for row in rows if "exception 0x04" in row["note"]] == [(7, 7)],
          "a unit that refuses by exception 03, and fails at one address", ended)
    for words in (["coil:0-99"], ["holding:0-99", "discrete:0-99"]):
        ended = tool.run(*QUIET, "-u", METER, "--json", "map", *words)
        check(ended.status == DIFFERS and not ended.output and ended.errors.count("exception 0x01") == len(words),
              f"{words}: a function that is not there is one request", ended)
    ended = tool.run(*QUIET, "-u", METER, "--json", "map", "input:500-600")
    check(ended.status == DIFFERS and not ended.output, "nothing there is no success", ended)


def check_forms(tool, check):
    rows = tool.run(*QUIET, "-u", METER, "--csv", "map", "list:30001-30016", "i:0x03E8-0x03F3").rows()
    check(found_in(rows) == [("input", 0, 8), ("input", 12, 12), ("input", 1000, 1011)] and rows[0]["count"] == "9", "as CSV", rows)
    table = tool.run(*QUIET, "-u", METER, "map", "input:0-20").table()
    check([row[:5] for row in table] == [["61", "input", "0", "8", "9"], ["61", "input", "12", "12", "1"]], "as a table", table)
    for words, says in ((["input:9-3"], "no range"), (["inputs:0-9"], "did you mean input?"), (["0-9:f32"], "addresses alone"),
                        (["0-9", "5"], "a word before it"), (["0-70000"], "70000"), (["RFR"], "RFR")):
        ended = tool.run(*QUIET, "-u", METER, "map", *words)
        check(ended.status == USAGE and says in ended.errors, f"{words} is refused", ended)


def check_end(tool, check):
    """Ctrl-C says what was done and keeps it; the same command goes on from there, and asks nothing twice."""
    for which, number in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
        name = f"{which.name}.map"
        words = [*QUIET, "--pause", 3, "-u", METER, "--json", "map", "input:0-1100", "--resume", name]
        process = tool.start(*words)
        check.soon(lambda: (tool.place / name).exists() and (tool.place / name).read_text().count("\n") > 100,
                   f"{which.name}: it is under way")
        process.send_signal(which)
        output, errors = process.communicate(timeout=30)
        check(process.returncode == number and "the same command goes on from there" in errors and '"first":0,"last":8' in output,
              f"{which.name} says what was done", (process.returncode, output, errors))
        kept = (tool.place / name).read_text()
        ended = tool.run(*words)
        check(ended.status == DONE and found_in(ended.objects()) == wanted("input", INPUTS, 0, 1100), "and the rest is found", ended)
        lines = (tool.place / name).read_text()
        check(lines.startswith(kept) and len(set(lines.splitlines())) == len(lines.splitlines()), "nothing is asked twice", lines[-200:])
        ended = tool.run(*words, port="/dev/null")
        check(ended.status == PORT, "a port is opened all the same", ended)
    head = "# rtuwire map\n# line 115200 8N2\n# unit 61\n# device that is not asked what it is\n# range input:0-20\n"
    for text, says in (("# rtuwire scan\n", "no file of a map"), (head + "61 input 0 9 here\n61 input 9 10 none\n", ":7:"),
                       (head + "61 input 0 9 he", ":6:"), (head + "61 input 9 0 here\n", ":6:"), (head[:-1], "no file of a map"),
                       (head[:-40], "no file of a map"), ("# rtuwire map\n61 input 0 9 here\n", "no file of a map"),
                       (head + "61 input 0 70000 here\n", ":6:"), (head + "62 input 0 7 here\n", ":6:"),
                       (head.replace("115200", "9600"), ":2:"), (head.replace("unit 61", "unit 62"), ":3:"),
                       (head.replace("that is not", "Acme"), ":4:"), (head.replace("0-20", "0-21"), ":5:")):
        (tool.place / "wrong.map").write_text(text)
        ended = tool.run(*QUIET, "-u", METER, "map", "input:0-20", "--resume", "wrong.map")
        check(ended.status == USAGE and says in ended.errors and (tool.place / "wrong.map").read_text() == text,
              f"{text!r} is refused, and left", ended)
    ended = tool.run(*QUIET, "--retries", 0, "-u", 99, "--json", "map", "0-99")
    check(ended.status == NO_ANSWER and not ended.output and "unit 99" in ended.errors, "nobody", ended)
    process = tool.start(*QUIET, "-u", METER, "--json", "map", "input")
    process.stdout.close()
    check(process.wait(timeout=30) in (DONE, DIFFERS), "a reader that goes away ends it", process.stderr.read())


def check_file(tool, check):
    """A register file to begin with: an address each, which `device check` and `read` take; never in place of another."""
    ended = tool.run(*QUIET, "-u", METER, "--json", "map", "input:0-20", "-o", "begun.toml")
    known = tool.run("--csv", "device", "check", "begun.toml")
    check(ended.status == DONE and "begun.toml has 10 registers" in ended.errors
          and [row["register"] for row in known.rows()] == [f"input_{each}" for each in (*range(9), 12)], "a file of ten", (ended, known))
    rows = tool.run(*QUIET, "-u", METER, "--device", "begun.toml", "--csv", "read", "input_12", "input_3").rows()
    check([row["text"] for row in rows] == ["0x000C", "0x0003"], "its values are read by it", rows)
    text = (tool.place / "begun.toml").read_text()
    ended = tool.run(*QUIET, "-u", METER, "-v", "map", "input:0-20", "-o", "begun.toml")
    check(ended.status == USAGE and "begun.toml: it is there already" in ended.errors and " -> " not in ended.errors
          and (tool.place / "begun.toml").read_text() == text, "what is there stays, and nobody is asked", ended)
    ended = tool.run(*QUIET, "-u", MODULE, "map", "coil:30-80", "holding:400-403", "-o", "two.toml")
    known = tool.run("--csv", "device", "check", "two.toml").rows()
    check([row["place"] for row in known] == [*(f"coil:{each}" for each in (*range(30, 40), 77)), "holding:400:hex", "holding:402:hex"], "two spaces", known)
    ended = tool.run(*QUIET, "-u", METER, "map", "input:500-600", "-o", "none.toml")
    check(ended.status == DIFFERS and not (tool.place / "none.toml").exists() and "none.toml is not written" in ended.errors, "nothing", ended)
    ended = tool.run(*QUIET, "-u", METER, "map", "input:0-2", "-o", "nowhere/new.toml")
    check(ended.status == PORT and "nowhere/new.toml" in ended.errors and "input" in ended.output, "a folder that is not there", ended)
    (tool.place / "some.toml").write_text('[[register]]\nname = "level"\nspace = "input"\naddress = 1\ntype = "u32"\n')
    ended = tool.run(*QUIET, "-u", METER, "--device", "some.toml", "map", "input:0-4", "-o", "rest.toml")
    known = tool.run("--csv", "device", "check", "rest.toml").rows()
    check([row["register"] for row in known] == ["input_0", "input_3", "input_4"], "what has a name is not in it", known)
    with Units({7: {each: each for each in range(2_100)}}) as line:
        how = ["--no-listen", "-u", 7, "-d", "none"]
        ended = tool.run(*how, "map", "0-2200", "-o", "large.toml", port=line.name)
        check(ended.status == DONE and "2000 registers" in ended.errors and "100 more were found" in ended.errors
              and len(tool.run("--csv", "device", "check", "large.toml").rows()) == 2_000, "more than a file has", ended)


def check_told_before(tool, check):
    """How long it may take, in front of what takes long: by hand, at 19200 8E1 (11 bits a character)."""
    with Units({7: {each: each for each in range(4_000)}}) as line:
        how = ["--no-listen", "-u", 7, "-d", "none"]
        ended = tool.run(*how, "map", "0-3999", port=line.name)
        character = 11 / 19_200
        silence = 2 * 3.5 * character
        quick = 4_000 / 125 * ((8 + 255) * character + silence + 0.002)
        slow = 4_000 * 1.5 * ((8 + 5) * character + silence + 0.002)
        check(f"4000 addresses: from {int(quick) + 1} s" in ended.errors and f"to {int(slow) // 60} min {int(slow) % 60 + 1} s" in ended.errors,
              "both ends of it", (quick, slow, ended))
        ended = tool.run(*how, "map", "0-99", port=line.name)
        check("addresses: from" not in ended.errors, "what takes a moment is not told", ended)


def named(units):
    """Units that say what they are by function 43, in three objects; without names they refuse to."""
    class Named(Units):
        names = None

        def answer(self, request):
            if request[1] != 0x2B or request[0] not in self.units:
                return super().answer(request)
            if self.names is None:
                return with_crc(bytes([request[0], 0xAB, 1]))
            objects = b"".join(bytes([i, len(each)]) + each.encode() for i, each in enumerate(self.names))
            return with_crc(bytes([request[0], 0x2B, 0x0E, 1, 1, 0, 0, len(self.names)]) + objects)

    return Named(units)


def check_another(tool, check):
    """What another device at the address has is not taken for the rest of a map."""
    with named({7: {each: 1 for each in range(10)}}) as line:
        words = ["--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, "--json", "map"]
        for before, now in ((("Acme", "M7", "1"), ("Other", "X2", "9")), (("Acme", "M7", "1"), ("Acme", "M8", "1")),
                            (None, ("Acme", "M7", "1")), (("Acme", "M7", "1"), None)):
            line.names = before
            name = f"{before and before[1]}-{now and now[1]}.map"
            first = [tool.run(*words, "0-40", "--resume", name, port=line.name) for _ in range(2)]
            check(all(each.status == DONE and found_in(each.objects()) == [("holding", 0, 9)] for each in first), "the same again", first)
            kept = (tool.place / name).read_text()
            check(before is None or " ".join(before) in kept, "who it was is kept", kept)
            line.names = now
            ended = tool.run(*words, "0-40", "--resume", name, port=line.name)
            check(ended.status == USAGE and not ended.output and f"{name}:4:" in ended.errors
                  and (tool.place / name).read_text() == kept, f"{before}, then {now}", ended)
        for beside, at in ((["-b", 9600], 2), (["-f", "8N1"], 2)):
            line.names = None
            ended = tool.run(*beside, *words, "0-40", "--resume", "None-M7.map", port=line.name)
            check(ended.status == USAGE and f":{at}:" in ended.errors, f"{beside}", ended)


def check_unnamed_drive(tool, check):
    """What does not say what it is, and has the status word and the command word of a drive, is asked for as a drive is."""
    marks = {3201: 1, 8501: 0, **{each: 1 for each in range(10)}}
    with named({7: marks, 8: {3201: 1}, 9: {0x6041: 1, 0x6040: 0}}) as line:
        for unit, names, is_asked in ((7, None, True), (8, None, False), (9, None, True), (7, ("Acme", "M7", "1"), False)):
            line.names = names
            words = ["--no-listen", "--timeout", 0.2, "--retries", 0, "-u", unit, "--json"]
            ended = tool.run(*words, "map", "3200-3202", port=line.name)
            if is_asked:
                check(ended.status == REFUSED and f"unit {unit} may be a drive" in ended.errors and not ended.output,
                      f"{unit} {names} is asked for", ended)
                ended = tool.run(*words, "--yes", "map", "3200-3202", port=line.name)
            check(ended.status == (DIFFERS if unit == 9 else DONE), f"{unit} {names} is mapped", ended)


def check_silent(tool, check):
    """A unit that says nothing to what it lacks is asked on; one that is gone is not."""
    class Mute(Units):
        is_off = False

        def answer(self, request):
            answer = super().answer(request)
            return None if answer is None or answer[1] == 0x83 or self.is_off else answer

    with Mute({7: {0: 1, 1: 1, 2: 1, 9: 1}}) as line:
        how = ["--no-listen", "--timeout", 0.05, "--retries", 0, "-d", "none", "-u", 7, "--json"]
        ended = tool.run(*how, "map", "0-12", port=line.name)
        check(ended.status == DONE and found_in(ended.objects()) == [("holding", 0, 2), ("holding", 9, 9)], "a mute unit", ended)
        line.is_off = True
        ended = tool.run(*how, "map", "0-12", port=line.name)
        check(ended.status == NO_ANSWER, "one that is off", ended)


FILE = """
[device]
vendor = "Maker"
product = "Meter"
max_registers = 50
[groups]
slow = "1min"
[[register]]
name = "level"
space = "input"
address = 2
[[register]]
name = "absent"
space = "input"
address = 10
type = "u32"
[[register]]
name = "low"
space = "input"
address = 12
bits = "0-3"
[[register]]
name = "high"
space = "input"
address = 12
bits = "8"
[[register]]
name = "power"
space = "input"
address = 1000
type = "f32"
[[register]]
name = "far"
space = "input"
address = 5000
[[register]]
name = "relay"
space = "coil"
address = 77
[[register]]
name = "lamp"
space = "coil"
address = 90
"""


def check_names(tool, check):
    """A register file beside it: what it names is a row of its own, whether the unit has it or not."""
    (tool.place / "meter.toml").write_text(FILE)
    how = [*QUIET, "-u", METER, "--device", "meter.toml"]
    rows = [(row["first"], row["last"], row["register"], row["note"])
            for row in tool.run(*how, "--csv", "map", "input:0-20", "input:990-1020").rows()]
    lacks = "the unit has no such address"
    check(rows == [("0", "1", "", ""), ("2", "2", "level", ""), ("3", "8", "", ""), ("10", "11", "absent", lacks),
                   ("12", "12", "low, high", ""), ("1000", "1001", "power", ""), ("1002", "1011", "", "")], "rows have the file's names", rows)
    ended = tool.run(*how, "--json", "map", "input:0-20")
    check("5 of the registers of meter.toml are beyond what was mapped" not in ended.errors
          and "4 of the registers of meter.toml are beyond" in ended.errors, "what is beyond is told", ended)
    ended = tool.run(*how, "--json", "map", "coil:0-99")
    rows = [(row["first"], row["register"], row["note"]) for row in ended.objects()]
    check(ended.status == DIFFERS and rows == [(77, "relay", lacks), (90, "lamp", lacks)], "of a space that the unit lacks all is told", ended)
    ended = tool.run(*how[:-4], "-u", "m", "--name", f"m={MODULE}:meter.toml", "--csv", "map", "coil:70-99", "--resume", "names.map")
    kept = tool.run(*how[:-4], "-u", MODULE, "--csv", "map", "coil:70-99", "--resume", "names.map")
    check([row["register"] for row in ended.rows()] == ["relay", "lamp"] and "register" not in kept.rows()[0], "a name's file as well", (ended, kept))
    with Simulator(tool.program, "atv320:7") as device:
        ended = tool.run("--no-listen", "-u", 7, "--device", "meter.toml", "map", "3200-3230", port=device)
        check(ended.status == REFUSED and "is an atv320" in ended.errors, "a file makes no drive one that is mapped unasked", ended)
    with named({7: {0: 1}}) as line:
        line.names = ("Other", "Thing", "1")
        ended = tool.run("--no-listen", "--timeout", 0.2, "-u", 7, "--device", "meter.toml", "map", "0-2", port=line.name)
        check(ended.status == DONE and "calls itself 'Other Thing', and is to be 'Maker Meter'" in ended.errors, "another device is told", ended)


def check_drive(tool, check):
    """A drive is mapped after a question, or with --yes."""
    with Simulator(tool.program, "atv320:7") as device:
        how = ["--no-listen", "-u", 7]
        listed = sorted(int(row["address"]) for row in tool.run("--csv", "list", "-d", "atv320").rows())
        for said in ([], ["-d", "atv320"]):
            ended = tool.run(*how, *said, "map", "3200-3230", port=device)
            check(ended.status == REFUSED and "supervision" in ended.errors and "--yes" in ended.errors and not ended.output,
                  f"{said}: a drive is not mapped unasked", ended)
        ended = tool.run(*how, "--yes", "--json", "map", "3100-3300", port=device)
        found = found_in(ended.objects())
        simulated = [each for first, last in [row[1:] for row in found] for each in range(first, last + 1)]
        check(ended.status == DONE and set(simulated) >= {each for each in listed if 3201 <= each <= 3204} and "SLF" in ended.errors,
              "with --yes it is, and what becomes of it is said", ended)
        shown = tool.on_terminal(*how, "map", "3201-3203", keys=[("map it? (y/n)", "n\n")], port=device)
        check(shown.status == REFUSED and "supervision" in shown.output, "somebody says no", shown)
        shown = tool.on_terminal(*how, "map", "3201-3203", keys=[("map it? (y/n)", "y\n")], port=device)
        check(shown.status == DONE and "3201" in shown.output, "somebody says yes", shown)


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        near, tool.port = others.line()
        others.serve(near, [sys.executable, "-B", __file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        for part in (check_kinds, check_names, check_forms, check_file, check_told_before, check_end, check_silent, check_drive, check_another, check_unnamed_drive):
            part(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from support import DIFFERS, DONE, NO_ANSWER, PORT, REFUSED, USAGE, Simulator, Tool, Units, runs, with_crc

    from pair import Programs  # noqa: I100

    runs(main)
