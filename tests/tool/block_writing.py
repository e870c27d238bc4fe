# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Values of neighbours in one word, as servers of pymodbus and libmodbus get them: by one request, or not at all; and what is
told of each.

    python3 block_writing.py TOOL LIBMODBUS_SERVER
    python3 block_writing.py --serve DEVICE LOG
"""
import asyncio
import json
import signal
import struct
import subprocess
import sys

from support import Simulator, Tool, Units, runs, with_crc

from pair import Programs  # noqa: I100

MODULE, LACKS, HALF, SHORT = 61, 62, 63, 64


async def serve(device, log):
    from pymodbus.bit_write_message import WriteMultipleCoilsRequest, WriteSingleCoilRequest
    from pymodbus.datastore import ModbusSequentialDataBlock as Block
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext
    from pymodbus.device import ModbusDeviceIdentification
    from pymodbus.pdu import ModbusExceptions
    from pymodbus.register_read_message import ReadWriteMultipleRegistersRequest
    from pymodbus.register_write_message import (MaskWriteRegisterRequest, WriteMultipleRegistersRequest,
                                                 WriteSingleRegisterRequest)
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    class Lacks(ModbusSlaveContext):
        """Has no functions 15 and 16."""

    class Half(ModbusSlaveContext):
        """Writes two of the registers that it is sent, and fails."""

    class Short(ModbusSlaveContext):
        """Reads one register a request."""

        def validate(self, code, address, count=1):
            return (code != 3 or count == 1) and super().validate(code, address, count)

    for request in (WriteSingleCoilRequest, WriteMultipleCoilsRequest, WriteSingleRegisterRequest, WriteMultipleRegistersRequest,
                    MaskWriteRegisterRequest, ReadWriteMultipleRegistersRequest):
        def execute(self, context, known=request.execute):
            values = getattr(self, "values", None)
            if self.function_code == 23:
                self.address, values = f"{self.write_address} then {self.read_address}+{self.read_count}", self.write_registers
            with open(log, "a", encoding="ascii") as out:
                print(self.unit_id, self.function_code, self.address, [int(each) for each in values] if values else "", file=out)
            if isinstance(context, Lacks) and self.function_code > 6:
                return self.doException(ModbusExceptions.IllegalFunction)
            if isinstance(context, Half) and self.function_code == 16:
                context.setValues(16, self.address, self.values[:2])
                return self.doException(ModbusExceptions.SlaveFailure)
            return known(self, context)
        request.execute = execute

    def unit(kind):
        return kind(hr=Block(0, [0] * 300), ir=Block(0, [0] * 10), co=Block(0, [False] * 2000), zero_mode=True)

    context = ModbusServerContext(slaves={MODULE: unit(ModbusSlaveContext), LACKS: unit(Lacks), HALF: unit(Half), SHORT: unit(Short)},
                                  single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N", stopbits=2,
                                          identity=ModbusDeviceIdentification(info={0: "Maker", 1: "Module", 2: "1"}),
                                          ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


LINE = ["--listen", "0.05", "-b", 38400, "-f", "8N2"]
NONE = ["-d", "none", "--write"]


class Module:
    """What the server was sent since it was looked at."""

    def __init__(self, tool):
        self.tool, self.log, self.seen = tool, tool.place / "requests.log", 0

    def sent(self):
        lines = self.log.read_text().splitlines() if self.log.exists() else []
        new, self.seen = lines[self.seen:], len(lines)
        return [line.strip() for line in new]

    def write(self, *words, unit=MODULE, beside=("-d", "none"), form="--json"):
        """Its end, and what came of it at the server."""
        self.sent()
        ended = self.tool.run(*LINE, "-u", unit, *beside, "--write", form, "write", *words)
        return ended, self.sent()

    def held(self, *words, unit=MODULE):
        return [each["raw"] for each in self.tool.run(*LINE, "-u", unit, "--json", "read", *words).objects()]

    def noted(self):
        """The rows of writes.log without time, user and port."""
        text = (self.tool.place / "state" / "rtuwire" / "writes.log").read_text()
        return [line.split("\t")[3:] for line in text.splitlines()]


def words_of(kind, *values):
    return [word for value in values for word in struct.unpack(f">{struct.calcsize(kind) // 2}H", struct.pack(f">{kind}", value))]


def check_forms(module, check):
    """One request each, with the values as pymodbus takes them."""
    half = words_of("f", 1.5)
    for word, sent, held in (
            ("40-43=1,2,3,4", "16 40 [1, 2, 3, 4]", ("40-43", [1, 2, 3, 4])),
            ("0x28-0x29=0xFFFF,#7", "16 40 [65535, 7]", ("40-41", [65535, 7])),
            ("list:40041-40042=5,6", "16 40 [5, 6]", ("40-41", [5, 6])),
            ("40-42:i16:0.1V=-1.5V,2,#-30", "16 40 [65521, 20, 65506]", ("40-42", [65521, 20, 65506])),
            ("50-53:f32:cdab=1.5,-2.25", f"16 50 {[*half[::-1], *words_of('f', -2.25)[::-1]]}", ("50-53:f32", None)),
            ("60,61:f32=7,1.5", f"16 60 {[7, *half]}", ("60", [7])),
            ("70-73:text4=ab,cd", f"16 70 {[0x6162, 0, 0x6364, 0]}", ("70", [0x6162])),
            ("coil:3-12=on,off,1,0,on,on,on,off,off,on", "15 3 [1, 0, 1, 0, 1, 1, 1, 0, 0, 1]", ("coil:2-13", [0, 1, 0, 1, 0, 1, 1, 1, 0, 0, 1, 0])),
            ("coil:20,coil:21=on,on", "15 20 [1, 1]", ("coil:20-21", [1, 1])),
            ("100-222=" + ",".join(str(i) for i in range(123)), f"16 100 {[*range(123)]}", ("222", [122])),
            ("coil:0-1967=" + ",".join(["on", "off"] * 984), f"15 0 {[1, 0] * 984}", ("coil:1966-1967", [1, 0]))):
        ended, came = module.write(word)
        is_held = held[1] is None or module.held(held[0]) == held[1]
        check(ended.status == 0 and came == [f"{MODULE} {sent}"] and is_held, f"{word[:40]} is one request", (came, ended))
        rows = ended.objects()
        check(len(rows) == word.partition("=")[2].count(",") + 1 and not any(row["note"] for row in rows),
              f"{word[:40]}: each value is a row", rows[:5])
    module.write("40-41=1,2")
    ended, came = module.write("40-41=8,9", "45=5", "46-47=3,4", "coil:1=on")
    check(came == [f"{MODULE} {sent}" for sent in ("16 40 [8, 9]", "6 45", "16 46 [3, 4]", "5 1")], "in the order of the words", came)
    rows = [(row["register"], row["before"], row["after"]) for row in ended.objects()]
    check(rows[:3] == [("40", "1 (0x0001)", "8"), ("41", "2 (0x0002)", "9"), ("45", "0 (0x0000)", "5")], "old and new of each", rows)
    check([row[1:] for row in module.noted()[-6:-3]] == [["40", "1 (0x0001)", "8"], ["41", "2 (0x0002)", "9"], ["45", "0 (0x0000)", "5"]],
          "each is noted", module.noted()[-6:])
    ended, came = module.write("40-43=1,2,3,4", unit=SHORT)
    check(ended.status == 0 and [row["after"] for row in ended.objects()] == ["1", "2", "3", "4"] and len(came) == 1,
          "what reads one register a request is read back so", ended)
    shown = module.tool.on_terminal(*LINE, "-u", MODULE, *NONE, "write", "40-41=6,7", keys=[("(y/n)", "n\n")])
    check(f"unit {MODULE}: 40: 8 (0x0008) -> 6" in shown.output and f"unit {MODULE}: 41: 9 (0x0009) -> 7" in shown.output
          and module.held("40-41") == [8, 9] and not module.sent(), "the question shows each", shown)


def check_refusals(module, check):
    """Before a frame leaves that writes: what is beside it in the command is not written either."""
    many = ",".join(["1"] * 124)
    for word, says in (("40-43=1,2,3", "40-43 is 4 values, and 3 stand behind it"), ("40-43=1", "and 1 stands behind it"),
                       ("40-41=1,2,3", "2 values"), ("40,42=1,2", "42 is none of the one before it"), ("41,40=1,2", "rising order"),
                       ("40,coil:41=1,on", "neighbours"), ("40:f32,41=1,2", "neighbours"), ("40-41=1,", "41=: a value"), ("40-41=,1", "REG=VALUE"),
                       ("40-41=1,70000", "41=70000"), ("40-41:i16=1,-40000", "41:i16=-40000"), ("40-42:f32=1,2", "end the range at 43"),
                       ("coil:0-1=on,2", "coil:1=2"), ("40.0,40.1=on,off", "bits of a register"), ("input:0-1=1,2", "read only"),
                       ("discrete:0-1=on,off", "read only"), (f"100-223={many}", "one request has at most 123 registers, and these are 124"),
                       ("coil:0-1968=" + ",".join(["on"] * 1969), "at most 1968 coils"), ("65535-65536=1,2", "0 to 65535"),
                       ("40-41:0.1V=1.25V,1V", "1.2 V or 1.3 V"), ("40-41=1,2", "'40=1' and '40=9'"), ("'*'=1,2", "")):
        ended, came = module.write("40=9" if "'40=9'" in says else "45=9", word)
        check(ended.status == 2 and says in ended.errors and not came and not ended.output, f"{word[:40]} is refused", (ended, came))
    # A whole frame of function 06 in the values: who ends a frame by its length takes it for a request.
    frame = with_crc(bytes([MODULE, 6, 0, 40, 0, 6]))
    registers = ",".join(str(each) for each in struct.unpack(">4H", frame))
    bits = ",".join("on" if byte >> i & 1 else "off" for byte in frame for i in range(8))
    for word in (f"100-103={registers}", f"coil:0-63={bits}"):
        ended, came = module.write(word)
        check(ended.status == 5 and "a whole frame" in ended.errors and not came, f"{word[:30]} holds a frame", (ended, came))


FILE = """
[device]
max_registers = 3
[[register]]
name = "level"
address = 40
type = "i16"
scale = 0.1
unit = "m"
access = "write"
max = 5
[[register]]
name = "mode"
address = 41
access = "write"
choices = { off = 0, heat = 1 }
[[register]]
name = "jog"
address = 42
access = "write"
moves = true
[[register]]
name = "shown"
address = 43
[[register]]
name = "gain"
address = 44
type = "f32"
access = "write"
[[register]]
name = "third"
address = 46
type = "u32"
access = "write"
"""


def check_names(module, check):
    """A register file's names: each value by its own form, limits and marks."""
    (module.tool.place / "module.toml").write_text(FILE)
    beside = ("--device", "module.toml")
    ended, came = module.write("level,mode=1.2m,heat", beside=beside)
    check(ended.status == 0 and came == [f"{MODULE} 16 40 [12, 1]"] and [row["after"] for row in ended.objects()] == ["1.2 m", "heat (1)"],
          "names are one request", (ended, came))
    for word, status, says in (("level,mode=5.1m,heat", 2, "level takes at most 5 m"), ("level,mode=1m,haet", 2, "did you mean 'heat'"),
                               ("mode,jog=off,1", 5, "jog moves something"), ("jog,shown=1,1", 5, "jog moves something"),
                               ("mode,level=off,1", 2, "rising order"),
                               ("40-41=1,1", 2, "say that name"), ("40-42=1,1,1", 2, "say that name"),
                               ("gain,third=1,2", 2, "at most 3 registers"), ("lev*,mode=1,2", 2, "one register")):
        ended, came = module.write(word, beside=beside)
        check(ended.status == status and says in ended.errors and not came, f"{word} is refused", (ended, came))
    ended, came = module.write("mode,jog=off,1", beside=(*beside, "--allow-run"))
    check(ended.status == 0 and came == [f"{MODULE} 16 41 [0, 1]"], "what moves is written where --allow-run says so", (ended, came))
    ended, came = module.write("jog,shown=1,1", beside=(*beside, "--allow-run"))
    check(ended.status == 2 and "shown is read only" in ended.errors and not came, "what is read only is not", (ended, came))


def check_exchange(module, check):
    """Function 23: the write as pymodbus takes it, and what it reads behind it."""
    module.write("100-102=5,6,7")
    half = struct.unpack(">2H", struct.pack(">f", 1.5))
    for words, sent, read in ((["40-41=1,2", "--then-read", "40-42"], "40 then 40+3 [1, 2]", [("40", "1"), ("41", "2")]),
                              (["--then-read", "100-101,102:i16:0.1V", "45=9"], "45 then 100+3 [9]",
                               [("100", "5"), ("101", "6"), ("102:i16:0.1V", "0.7 V")]),
                              (["60:f32=1.5", "--then-read", "60:f32"], f"60 then 60+2 {[*half]}", [("60:f32", "1.5")])):
        ended, came = module.write(*words)
        rows = [(row["register"], row["after"]) for row in ended.objects() if row["note"] == "read by the same request"]
        check(ended.status == 0 and came == [f"{MODULE} 23 {sent}"] and rows[:len(read)] == read, f"{words}", (came, ended))
    for words, status, says in ((["40=1", "41=2"], 2, "of one word"), (["coil:1=on"], 2, "of one word"), (["40.1=on"], 2, "of one word"),
                                (["8501=6,7"], 2, ""), (["100-221=" + ",".join(["1"] * 122)], 2, "writes at most 121")):
        ended, came = module.write(*words, "--then-read", "100")
        check(ended.status == status and says in ended.errors and not came, f"{words[0][:20]} and a read", (ended, came))
    for read, says in (("input:3", "holding registers only"), ("100,102", "without a hole"), ("100-225", "at most 125"), ("level", "level")):
        ended, came = module.write("40=1", "--then-read", read)
        check(ended.status == 2 and says in ended.errors and not came, f"a read of {read}", (ended, came))
    ended, came = module.write("40=1", "--then-read", "100", unit=LACKS)
    check(ended.status == 1 and "no function 23" in ended.output and len(came) == 1, "a unit without it", (ended, came))
    ended = module.tool.run("--no-listen", "-u", 7, "--write", "write", "ACC=2s", "--then-read", "3202", port="sim:atv320:7")
    check(ended.status == 2 and "of what is no drive" in ended.errors, "a drive", ended)
    ended = module.tool.run("--no-listen", "-u", 7, "--write", "--allow-run", "write", "8501=6", "--then-read", "3202", port="sim:atv320:7")
    check(ended.status == 5 and "commands the motor" in ended.errors, "and its command", ended)


def check_failures(module, check):
    """What came of each value is told and noted, and what stands behind is not begun."""
    before = len(module.noted())
    for word, by, then, single in (("40-42=1,2,3", "16 40 [1, 2, 3]", "06", "6 40"), ("coil:0-1=on,on", "15 0 [1, 1]", "05", "5 0")):
        ended, came = module.write(word, "45=5", unit=LACKS)
        errors = [row["error"] for row in ended.objects()]
        check(ended.status == 1 and came == [f"{LACKS} {by}"] and all(f"one by one, by {then}" in error for error in errors[:-1])
              and errors[-1] == "not tried", f"{word} of a unit without {by[:2]}", (ended, came))
        ended, came = module.write(*(["40=1", "41=2"] if then == "06" else ["coil:0=on", "coil:1=on"]), unit=LACKS)
        check(ended.status == 0 and came[0] == f"{LACKS} {single}" and len(came) == 2, "words of their own are written one by one", came)
    check(len(module.noted()) == before + 4, "what was refused before anything was done is not noted", module.noted())
    ended, came = module.write("40-43=1,2,3,4", "50=5", unit=HALF)
    rows = [(row["register"], row["after"], bool(row.get("error"))) for row in ended.objects()]
    check(ended.status == 1 and rows == [("40", "1", True), ("41", "2", True), ("42", "0", True), ("43", "0", True), ("50", None, True)],
          "half of it is written: each says what it holds", ended)
    check(module.noted()[before + 4:] == [[str(HALF), "40", "0 (0x0000)", "1"], [str(HALF), "41", "0 (0x0000)", "2"]],
          "and what is written is noted", module.noted()[before:])


class Sixteen(Units):
    """Takes function 16, and does something behind the first of them."""

    def __init__(self, then=None):
        super().__init__({7: {40: 0, 41: 0, 42: 0}})
        self.then, self.is_dead = then, False

    def answer(self, request):
        if self.is_dead:
            return None
        if request[1] == 43:
            return with_crc(bytes([7, 43, 14, 1, 1, 0, 0, 3, 0, 1, 77, 1, 1, 77, 2, 1, 49]))
        if request[1] != 16:
            return super().answer(request)
        count = request[5]
        self.units[7].update(enumerate(struct.unpack(f">{count}H", request[7:7 + 2 * count]), request[3]))
        self.is_dead = self.then == "dies"
        if callable(self.then):
            self.then()
        return None if self.is_dead else with_crc(request[:6])


def check_ends(tool, check):
    """A Ctrl-C, a unit that is silent behind it, an output that takes nothing: what was done is told."""
    how = ["--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, *NONE]
    with Sixteen() as line:
        process = tool.start(*how, "--json", "write", "40-41=1,2", "42=3", port=line.name, stdin=subprocess.DEVNULL)
        line.then = lambda: process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=60)
        errors = [json.loads(row).get("error") for row in output.splitlines()]
        check(process.returncode == 130 and errors == [None, None, "not tried"] and line.units[7] == {40: 1, 41: 2, 42: 0},
              "what was begun is ended, the rest is not begun", (output, line.units))
    with Sixteen("dies") as line:
        ended = tool.run(*how, "--json", "write", "40-41=1,2", "42=3", port=line.name)
        rows = [(row["after"], row["error"]) for row in ended.objects()]
        noted = (tool.place / "state" / "rtuwire" / "writes.log").read_text().splitlines()[-2:]
        check(ended.status == 3 and rows[0][0] is None and "no response" in rows[1][1] and rows[2][1] == "not tried"
              and all(row.endswith("\tunknown") for row in noted), "silence", (ended, noted))
    with Sixteen() as line, open("/dev/full", "wb") as full:
        process = tool.start(*how, "--json", "write", "40-41=1,2", "42=3", port=line.name, stdout=full)
        _, errors = process.communicate(timeout=60)
        check(process.returncode == 4 and "40: 0 (0x0000) -> 1; unit 7: 41: 0 (0x0000) -> 2; what stands behind it was not tried" in errors
              and line.units[7][42] == 0, "told into a full disk", errors)
    for words in (["8500-8501=1,6"], ["8501-8502=6,500"], ["8500:f32,8502=1,500"], ["0x603F-0x6041=1,2,3"]):
        with Units({7: {each: 0 for each in (40, 8500, 8501, 8502)}}) as line:
            ended = tool.run(*how, "--json", "write", "40=5", *words, port=line.name)
            check(ended.status == 5 and "which this unit may be" in ended.errors and not [each for each in line.requests if each[1] not in (1, 3, 43)],
                  f"{words} of what may be a drive", ended)


def check_drive(tool, check):
    """Of a drive no block is written, and none that meets its command is anything but unsafe."""
    with Simulator(tool.program, "atv320:7") as device:
        tool.port = device
        held = ["--no-listen", "-u", 7, "--json", "read", "8500-8503", "9001-9002", "3104", "3105"]
        before = tool.run(*held).output
        for word, status, says in (("8501-8502=6,500", 5, "commands the motor"), ("8500-8501=0,6", 5, "commands the motor"),
                                   ("8501-8502=6", 5, "commands the motor"), ("CMD,LFR=6,500", 5, "commands the motor"),
                                   ("8501:u16,9001=6,25", 5, "commands the motor"), ("8500:u32,8502=6,0", 5, "commands the motor"),
                                   ("9001-9002=#25,#25", 2, "say a word for each"), ("ACC,DEC=2.5s,2.5s", 2, "say a word for each"),
                                   ("coil:0-1=on,on", 2, "say a word for each")):
            for beside in ([], ["--allow-run"]):
                ended = tool.run("--no-listen", "-u", 7, "--write", *beside, "write", word)
                check(ended.status == status and says in ended.errors and not ended.output, f"{word} {beside}", ended)
            ended = tool.run("--no-listen", "-u", 7, "-d", "none", "--write", "write", word)
            check(ended.status in (2, 5) and not ended.output, f"{word} of what is said to be no drive", ended)
        check(tool.run(*held).output == before, "nothing is written")


def check_libmodbus(tool, check, others, server):
    near, tool.port = others.line()
    others.serve(near, [server, "@"], stderr=subprocess.DEVNULL)
    ended = tool.run("--listen", "0.05", "-u", 1, *NONE, "--json", "write", "100-103=1,2,3,4")
    raw = [each["raw"] for each in tool.run("--listen", "0.05", "-u", 1, "--json", "read", "100-104").objects()]
    check(ended.status == 0 and raw == [1, 2, 3, 4, 104], "libmodbus holds a block", (ended, raw))


def main(check, program, libmodbus_server):
    with Tool(program) as tool, Programs() as others:
        near, tool.port = others.line()
        others.serve(near, [sys.executable, "-B", __file__, "--serve", "@", str(tool.place / "requests.log")], stderr=subprocess.DEVNULL)
        module = Module(tool)
        for part in (check_forms, check_refusals, check_names, check_exchange, check_failures):
            part(module, check)
        check_ends(tool, check)
        check_libmodbus(tool, check, others, libmodbus_server)
        check_drive(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    runs(main)
