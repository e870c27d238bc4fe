# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Places of any device, of units that nobody here wrote (pymodbus): a meter with function 04 only, and a module with
coils, discrete inputs and holding registers; and what is written to such a module, and to a drive by the same words.

    python3 any_device.py TOOL
    python3 any_device.py --serve DEVICE ADDRESSES
"""
import asyncio
import random
import struct
import subprocess
import sys

METER, MODULE, SHORT, SIXTEEN, BRANDED = 61, 62, 63, 64, 65
VALUES = [230.1, 231.5, -229.875, 49.98, 1e-7, 3.4e38]
HOLE = 12


def registers(packed, order="abcd"):
    """The registers of four or eight bytes, the highest first; an order as pymodbus' users know it."""
    words = list(struct.unpack(f">{len(packed) // 2}H", packed))
    words = words[::-1] if order in ("cdab", "dcba") else words
    return [(word >> 8 | word << 8) & 0xFFFF for word in words] if order in ("badc", "dcba") else words


def floats(order="cdab"):
    return [word for value in VALUES for word in registers(struct.pack(">f", value), order)]


HOLDING = [*floats("abcd"), *floats("badc"), *floats("dcba"), 0x1234, 0x5678, 0x4142, 0x4300, 65534, 723]
COILS = [i % 3 == 0 for i in range(40)]
INPUTS = [i % 5 == 1 for i in range(40)]


async def serve(device, addresses):
    from pymodbus.datastore import ModbusSequentialDataBlock as Block
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.device import ModbusDeviceIdentification
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.bit_write_message import WriteSingleCoilRequest
    from pymodbus.pdu import ModbusExceptions
    from pymodbus.register_write_message import (MaskWriteRegisterRequest, WriteMultipleRegistersRequest,
                                                 WriteSingleRegisterRequest)
    from pymodbus.transaction import ModbusRtuFramer

    class InputsOnly(ModbusSlaveContext):
        """It refuses what is not function 04."""

        def validate(self, code, address, count=1):
            return code == 4 and super().validate(code, address, count)

    class OneEach(ModbusSlaveContext):
        """Answers one register a request, as some meters do, and lacks function 16."""

        def validate(self, code, address, count=1):
            return count == 1 and super().validate(code, address, count)

    class SeveralOnly(ModbusSlaveContext):
        """Lacks functions 05, 06 and 22."""

    for request, kind in ((WriteSingleCoilRequest, SeveralOnly), (WriteSingleRegisterRequest, SeveralOnly),
                          (MaskWriteRegisterRequest, SeveralOnly), (WriteMultipleRegistersRequest, OneEach)):
        def execute(self, context, known=request.execute, kind=kind):
            lacks = isinstance(context, kind)
            return self.doException(ModbusExceptions.IllegalFunction) if lacks else known(self, context)
        request.execute = execute

    meter = InputsOnly(ir=ModbusSparseDataBlock({1000 + i: word for i, word in enumerate(floats())}), zero_mode=True)
    module = ModbusSlaveContext(hr=Block(0, list(HOLDING)), ir=ModbusSparseDataBlock(
        {i: i for i in range(30) if i != HOLE}), co=Block(0, list(COILS)), di=Block(0, list(INPUTS)), zero_mode=True)
    short = OneEach(hr=Block(0, list(range(100, 120))), zero_mode=True)
    sixteen = SeveralOnly(hr=Block(0, [0] * 10), co=Block(0, [False] * 10), zero_mode=True)
    # A drive that is sold under another name.
    branded = ModbusSlaveContext(hr=ModbusSparseDataBlock({int(each): 0 for each in addresses.split(",")}), zero_mode=True)
    identity = ModbusDeviceIdentification(info={0: "Maker", 1: "Module", 2: "1"})
    context = ModbusServerContext(slaves={METER: meter, MODULE: module, SHORT: short, SIXTEEN: sixteen, BRANDED: branded}, single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N",
                                          stopbits=2, identity=identity, ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


QUIET = ["--listen", "0.05", "-b", 38400, "-f", "8N2"]


def single(value):
    """A float as four bytes keep it."""
    return struct.unpack(">f", struct.pack(">f", value))[0]


def near(found, wanted):
    return abs(found - wanted) <= abs(wanted) * 1e-6


def check_meter(tool, check):
    """Function 04 only, low words first: read, watched, in each form."""
    how = [*QUIET, "-u", METER]
    words = "i:1000-1011:f32:cdab"
    ended = tool.run(*how, "--json", "read", words)
    found = ended.objects()
    check(ended.status == 0 and all(near(each["value"], value) for each, value in zip(found, VALUES)) and len(found) == 6,
          "the values of a meter", ended)
    check(found[0] == {"unit": METER, "register": "input:1000:f32:cdab", "address": 1000, "raw": "0x199A4366",
                       "value": 230.1, "measure": "", "text": "230.1"}, "an object says all of a value", found[0])
    rows = tool.run(*how, "--csv", "read", words).rows()
    check([row["text"] for row in rows] == [each["text"] for each in found], "CSV says the same", rows)
    table = tool.run(*how, "read", "input:1000:f32:cdab:0.001kV").table()
    check(table == [["input:1000:f32:cdab:0.001kV", "1000", "0.2301", "kV"]], "a table says the same, with a unit", table)
    for drive in ([], ["-d", "none"]):
        ended = tool.run(*how, *drive, "--csv", "watch", "input:1000:f32:cdab:1V", "--every", "50ms", "--for", "0.2s")
        values = [row["input:1000:f32:cdab:1V"] for row in ended.rows()]
        check(ended.status == 0 and len(values) > 1 and set(values) == {"230.1"}, "a watch", ended)
    ended = tool.run(*how, "--json", "read", "1000:f32")
    check(ended.status == 1 and "exception" in ended.objects()[0]["error"], "it has no holding registers", ended)


def check_orders(tool, check):
    for first, order in ((0, "abcd"), (12, "badc"), (24, "dcba")):
        found = tool.run(*QUIET, "-u", MODULE, "--json", "read", f"{first}-{first + 11}:f32:{order}").objects()
        check([near(each["value"], value) for each, value in zip(found, VALUES)] == [True] * 6, f"floats {order}", found)
    how = [*QUIET, "-u", MODULE, "--json", "read"]
    found = {each["register"]: each["value"] for each in tool.run(
        *how, "36:bcd16", "36:u32", "36:hex", "36.4-7", "36.2", "38:text3", "40:i16", "41:0.1degC-50").objects()}
    check(found == {"36:bcd16": 1234, "36:u32": 0x12345678, "36:hex": 0x1234, "36.4-7": 3, "36.2": True, "38:text3": "ABC",
                    "40:i16": -2, "41:0.1degC-50": 22.3}, "types of a module", found)


def check_bits(tool, check):
    for space, wanted in (("coil", COILS), ("discrete", INPUTS)):
        found = tool.run(*QUIET, "-u", MODULE, "--json", "read", f"{space}:0-39").objects()
        check([each["value"] for each in found] == wanted and found[3]["register"] == f"{space}:3", space, found[:4])
    found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "list:4", "list:10007", "list:40038", "list:30003").objects()
    check([each["value"] for each in found] == [True, True, 0x5678, 2] and found[2]["register"] == "holding:37",
          "numbers of a list", found)


def check_holes(tool, check):
    """A hole costs its own value only; nobody asks over one that was not typed."""
    found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "i:0-29").objects()
    check([each.get("value") for each in found] == [i if i != HOLE else None for i in range(30)], "a hole in a block", found)
    found = tool.run(*QUIET, "-u", MODULE, "--json", "read", f"i:0-{HOLE - 1}", f"i:{HOLE + 1}-29").objects()
    check(all("value" in each for each in found) and len(found) == 29, "two blocks beside a hole", found)
    found = tool.run(*QUIET, "-u", SHORT, "--json", "read", "0-19").objects()
    check([each.get("value") for each in found] == list(range(100, 120)), "one register a request", found)
    ended = tool.run(*QUIET, "-u", MODULE, "--json", "read", "40001", "30001:f32", "50001", "holding:40001")
    hints = ["list:40001 is holding:0" in ended.output, "list:30001 is input:0" in ended.output]
    check(ended.status == 1 and hints == [True, True] and ended.output.count("list:") == 2,
          "a number of a list is hinted at, and is the address that was typed", ended)


def check_any_values(tool, check):
    """What struct of Python makes of the same bytes."""
    chance = random.Random(40)
    wanted, words = [], []
    for order in ("abcd", "cdab", "badc", "dcba"):
        for kind, letter, size in (("u32", "I", 2), ("i32", "i", 2), ("u64", "Q", 4), ("i64", "q", 4), ("f32", "f", 2),
                                   ("f64", "d", 4)):
            at = chance.randrange(0, 36 - size)
            packed = struct.pack(f">{size}H", *HOLDING[at:at + size])
            value = struct.unpack(f">{letter}", struct.pack(f">{size}H", *registers(packed, order)))[0]
            wanted.append(value)
            words.append(f"{at}:{kind}:{order}")
    found = tool.run(*QUIET, "-u", MODULE, "--json", "read", *words).objects()
    check(len(found) == len(words) and all(
        each["value"] == value or kind.startswith("f32") and near(each["value"], value) for each, value, kind in zip(
            found, wanted, [word.split(":")[1] for word in words])),
        "any type in any order", list(zip(words, [each.get("value") for each in found], wanted)))
    rows = tool.run(*QUIET, "-u", MODULE, "--csv", "read", *words).rows()
    check([float(row["value"]) for row in rows] == [float(each["value"]) for each in found], "CSV has the same numbers", rows)


def check_formulas(tool, check):
    """A text that a spreadsheet would take for an order is none in CSV, and an amount stays one."""
    how = [*QUIET, "-u", MODULE]
    for held, shown in (("=1+2", "'=1+2"), ("@SUM", "'@SUM"), ("-2+3|x!", "'-2+3|x!"), ("+1-1", "'+1-1"), ("-cmd", "'-cmd"),
                        ("-12", "-12"), ("+1e-3", "+1e-3"), ("-5 Hz", "-5 Hz"), ("-", "-"), ("a=b", "a=b")):
        tool.run(*how, "-d", "none", "--write", "write", f"10:text8={held}")
        row = tool.run(*how, "--csv", "read", "10:text8").rows()[0]
        found = tool.run(*how, "--json", "read", "10:text8").objects()[0]
        check((row["text"], row["value"], found["text"]) == (shown, shown, held), f"{held} in CSV", (row, found))


def check_writes(tool, check):
    """By functions 05, 06 and 16, and by 15 and 16 alone where a unit lacks the others; what stands there, as struct has it."""
    how = [*QUIET, "-u", MODULE, "--json"]
    for beside, status, says in ((["-d", "none"], REFUSED, "--write"), (["--write"], DIFFERS, "--drive, which may be none")):
        ended = tool.run(*how, *beside, "write", "holding:2=5")
        check(ended.status == status and says in ended.errors, f"a write with {beside} only is refused", ended)
    how += ["-d", "none", "--write", "write"]
    chance = random.Random(61)
    kinds = (("u16", "H"), ("i16", "h"), ("u32", "I"), ("i32", "i"), ("u64", "Q"), ("i64", "q"), ("f32", "f"), ("f64", "d"))
    for kind, letter in kinds:
        size = struct.calcsize(f">{letter}")
        for order in ("abcd", "cdab", "badc", "dcba") if size > 2 else ("abcd", "badc"):
            sent = chance.randbytes(size)
            value = struct.unpack(f">{letter}", sent)[0]
            value = chance.uniform(-1e6, 1e6) if letter in "fd" else value
            packed = struct.pack(f">{letter}", value)
            typed = f"{single(value):.20f}"[:20] if letter == "f" else f"{value:.9f}" if letter == "d" else str(value)
            packed = struct.pack(f">{letter}", float(typed)) if letter in "fd" else packed
            ended = tool.run(*how, f"4:{kind}:{order}={typed}")
            found = tool.run(*QUIET, "-u", MODULE, "--json", "read", f"4-{3 + size // 2}").objects()
            check(ended.status == DONE and [each["raw"] for each in found] == registers(packed, order),
                  f"{kind} {order} is written", (ended, found, packed))
    ended = tool.run(*how, "coil:5=on", "coil:6=off", "holding:8=0x1234", "9:0.1V=230.1V", "10:text4=abc")
    found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "coil:5-6", "8-11").objects()
    check(ended.status == DONE and [each["raw"] for each in found] == [1, 0, 0x1234, 2301, 0x6162, 0x6300],
          "coils, a scale, a text", (ended, found))
    for beside, says in (([], "may be a drive"), (["--allow-run"], "which this unit may be")):
        ended = tool.run(*QUIET, "-u", BRANDED, "-d", "none", "--write", *beside, "write", "holding:8501=6")
        check(ended.status == REFUSED and says in ended.errors, f"a drive under another name is none to write {beside}", ended)
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
    check("\tcoil:5\t" in log and "\t9:0.1V\t" in log and "230.1 V" in log, "and is noted", log)
    ended = tool.run(*QUIET, "-u", SIXTEEN, "-d", "none", "--write", "--json", "write", "3=77", "coil:4=on")
    notes = [each["note"] for each in ended.objects()]
    found = tool.run(*QUIET, "-u", SIXTEEN, "--json", "read", "3", "coil:4").objects()
    check(ended.status == DONE and "written by 16" in notes[0] and "written by 15" in notes[1]
          and [each["raw"] for each in found] == [77, 1], "a unit without 05 and 06 is written, which is said", ended)
    ended = tool.run(*how, "40001=5")
    check(ended.status == DIFFERS and "list:40001 is holding:0" in ended.output, "a number of a list is hinted at", ended)
    for word, says in (("input:3=5", "read only"), ("2.3=2", "on or off"), ("2.4-7=16", "0 to 15"), ("2:u16=70000", "0 to 65535"),
                       ("2:0.1V=1.25", "1.2 V or 1.3 V"), ("2-3:u16=1", "2 values, and 1 stands"), ("2=-1", "2:i16"),
                       ("2:f32=16777217", "the nearest is 16777216"), ("2:text247=a", "at most 123 registers")):
        ended = tool.run(*how, "coil:7=on", word)
        held = tool.run(*QUIET, "-u", MODULE, "--json", "read", "coil:7").objects()[0]["value"]
        check(ended.status == USAGE and word in ended.errors and says in ended.errors and not held,
              f"{word} is refused before a frame leaves", ended)


def check_bits_written(tool, check):
    """Bits of a register by function 22, which leaves the others; without it only where somebody said so."""
    chance, held = random.Random(22), 0x1234
    how = [*QUIET, "-d", "none", "--write", "--json"]
    tool.run(*how, "-u", MODULE, "write", "8=0x1234")
    for _ in range(20):
        first = chance.randrange(16)
        last = chance.randrange(first, 16)
        value = chance.randrange(1 << (last - first + 1))
        bits = ((1 << (last - first + 1)) - 1) << first
        word = f"8.{first}={'on' if value else 'off'}" if first == last else f"h:8.{first}-{last}={value}"
        held = held & ~bits | value << first
        ended = tool.run(*how, "-u", MODULE, "write", word)
        found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "8").objects()[0]["raw"]
        check(ended.status == DONE and found == held and ended.objects()[0]["after"] == str(value), f"{word} gives {held:#06x}",
              (ended, hex(found)))
    tool.run(*how, "-u", SIXTEEN, "write", "5=0x00F0")
    ended = tool.run(*how, "-u", SIXTEEN, "write", "5.0=on")
    check(ended.status == DIFFERS and "no function 22" in ended.output and "--read-modify-write" in ended.output
          and ended.objects()[0]["after"] == "0", "a unit without function 22 is not written by itself", ended)
    ended = tool.run(*how, "-u", SIXTEEN, "write", "--read-modify-write", "5.0=on", "5.4-7=3")
    found = tool.run(*QUIET, "-u", SIXTEEN, "--json", "read", "5").objects()[0]["raw"]
    notes = [each["note"] for each in ended.objects()]
    check(ended.status == DONE and found == 0x31 and all("read, and written as a whole" in note for note in notes)
          and "written by 16" in notes[0], "where somebody says so it is read and written back, which is told", ended)
    ended = tool.run(*how, "-u", SHORT, "write", "2:u32=70000")
    check(ended.status == DIFFERS and "no function 16" in ended.output, "a unit without 16 takes no half of a value", ended)


MOVES = [["8501=6"], ["holding:8501=6"], ["h:0x2135=0x0006"], ["list:48502=6"], ["8501:u16=6"], ["8501:i16:1=6"],
         ["8501:badc=1536"], ["8501.3=1"], ["8501.0-3=15"], ["8500:u32=6"], ["8501-8502:u16=6"], ["8500-8501=0,6"], ["8499:u64=6"], ["8500:text8=ab"], ["8501:hex=6"], ["8501:bits=0x6"], ["8501:bcd16=6"], ["8501:2=12"], ["8501:text2=ab"],
         ["8602:i16=100"], ["list:48603=100rpm"], ["holding:12761:u16=6"]]


METER_FILE = """
[[register]]
name = "l1"
space = "input"
address = 1000
type = "f32"
order = "cdab"
unit = "V"
[[register]]
name = "l2"
space = "input"
address = 1002
type = "f32"
order = "cdab"
scale = 0.001
unit = "kV"
"""
MODULE_FILE = """
[[register]]
name = "setpoint"
address = 4
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = -10
max = 95.5
[[register]]
name = "relay"
space = "coil"
address = 9
access = "write"
[[register]]
name = "fixed"
address = 5
"""
RICH_FILE = """
[device]
max_registers = 2
pause = 5
[groups]
fast = "50ms"
slow = "10min"
[[register]]
name = "mode"
address = 12
type = "i16"
access = "write"
choices = { off = 0, heat = 1, cool = -1 }
stored = true
group = "fast"
[[register]]
name = "valve"
space = "coil"
address = 10
access = "write"
moves = true
choices = { closed = 0, open = 1 }
[[register]]
name = "power"
address = 13
type = "u32"
invalid = 0xFFFFFFFF
group = "slow"
[[register]]
name = "level"
address = 15
group = "slow"
"""
DRIVE_FILE = """
[[register]]
name = "speed"
address = 8501
access = "write"
[[register]]
name = "wide"
address = 8601
type = "u32"
access = "write"
"""


def check_register_file(tool, check):
    """Names of a meter and of a module that nobody here wrote; a file makes no drive's command words writable."""
    for name, text in (("meter", METER_FILE), ("module", MODULE_FILE), ("drive", DRIVE_FILE), ("wrong", METER_FILE + "adress = 1")):
        (tool.place / f"{name}.toml").write_text(text)
    meter = [*QUIET, "-u", METER, "--device", "meter.toml"]
    found = tool.run(*meter, "--json", "read", "l*").objects()
    check([(each["register"], each["text"]) for each in found] == [("l1", "230.1 V"), ("l2", "0.2315 kV")], "names are read", found)
    rows = tool.run(*meter, "--csv", "watch", "l1", "input:1002:f32:cdab", "--every", "50ms", "--for", "0.2s").rows()
    check({(row["l1"], row["input:1002:f32:cdab"]) for row in rows} == {("230.1", "231.5")}, "names are watched", rows)
    shown = tool.on_terminal(*meter, "monitor", "l1", keys=[("230.1 V", "q")])
    check(shown.status == DONE and "l1" in shown.output, "names are monitored", shown)
    module = [*QUIET, "-u", MODULE, "--device", "module.toml", "--write", "--json", "write"]
    ended = tool.run(*module, "setpoint=-9.9degC", "relay=on")
    held = [each["raw"] for each in tool.run(*QUIET, "-u", MODULE, "--json", "read", "4", "coil:9").objects()]
    check(ended.status == DONE and held == [65536 - 99, 1], "names are written", (ended, held))
    for word, says in (("setpoint=95.6", "at most 95.5 degC"), ("fixed=1", "read only"), ("5=1", "read only"), ("4=1", "say that name"),
                       ("relais=on", "did you mean relay?")):
        ended = tool.run(*module, "relay=off", word)
        held = tool.run(*QUIET, "-u", MODULE, "--json", "read", "coil:9").objects()[0]["raw"]
        check(ended.status == USAGE and says in ended.errors and held == 1, f"{word} is refused before a frame leaves", ended)
    ended = tool.run("device", "check", "meter.toml", "module.toml")
    check(ended.status == DONE and ["l1", "input:1000:f32:cdab:1V", "read", "only"] in ended.table(), "a file is checked", ended)
    for words in (["device", "check", "wrong.toml"], ["--device", "wrong.toml", "read", "l1"]):
        ended = tool.run(*words, port="/dev/nowhere")
        is_told = "wrong.toml:17:1: 'adress' is no key here; did you mean 'address'?" in ended.errors
        check(ended.status == USAGE and is_told, f"{words}: a wrong file is refused, and nothing opened", ended)
    for words, says in ((["-d", "atv320", "read", "l1"], "said to be an atv320"), (["stop"], "'stop' does not"),
                        (["--allow-run", "start", "--frequency", "9Hz"], "'start' does not")):
        ended = tool.run("-u", 7, "--device", "meter.toml", *words, port="sim:atv320:7")
        check(ended.status == USAGE and says in ended.errors, f"{words} takes no register file", ended)
    for words, status in ((["speed=6"], REFUSED), (["wide=6"], REFUSED), (["8501=6"], REFUSED)):
        for beside in ([], ["--allow-run"]):
            ended = tool.run("--no-listen", "-u", 7, "--device", "drive.toml", "--write", *beside, "write", *words, port="sim:atv320:7")
            check(ended.status == status, f"a file makes no command writable: {words} {beside}", ended)


def check_rich_file(tool, check):
    """Choices, what means no value, what moves, groups and their periods, of a unit that nobody here wrote."""
    (tool.place / "rich.toml").write_text(RICH_FILE)
    how = [*QUIET, "-u", MODULE, "--device", "rich.toml"]
    plain = [*QUIET, "-u", MODULE, "-d", "none", "--write", "write"]
    tool.run(*plain, "12:i16=-1", "13:u32=4294967295", "15=7")
    found = tool.run(*how, "--json", "read", "@slow", "mode", "valve").objects()
    shown = [(each["register"], each["value"], each["raw"], each["text"]) for each in found]
    check(shown == [("power", None, "0xFFFFFFFF", "no value (0xFFFFFFFF)"), ("level", 7, 7, "7 (0x0007)"),
                    ("mode", "cool", 65535, "cool (-1)"), ("valve", "closed", 0, "closed (0)")], "a rich file is read", found)
    rows = tool.run(*how, "--csv", "watch", "@slow", "mode", "--for", "0.4s").rows()
    check(len(rows) > 4 and {row["mode"] for row in rows} == {"cool"} and [row["level"] for row in rows] == ["7"] + [""] * (len(rows) - 1),
          "a watch reads each group in its period", rows)
    rows = tool.run(*how, "--csv", "watch", "@slow", "--every", "50ms", "--for", "0.3s").rows()
    check(len(rows) > 2 and {row["level"] for row in rows} == {"7"}, "and all where --every says so", rows)
    write = [*how, "--write", "--json", "write"]
    ended = tool.run(*write, "mode=heat")
    held = tool.run(*QUIET, "-u", MODULE, "--json", "read", "12").objects()[0]["raw"]
    check(ended.status == DONE and held == 1 and ended.objects()[0]["after"] == "heat (1)"
          and "bears a limited number of writes" in ended.objects()[0]["note"], "a choice is written by name", (ended, held))
    for words, status, says in ((["mode=2"], USAGE, "mode takes cool -1, off 0, heat 1"), (["mode=haet"], USAGE, "did you mean 'heat'"),
                                (["valve=open"], REFUSED, "say --allow-run besides"), (["valve=1"], REFUSED, "--allow-run"),
                                (["coil:10=on"], USAGE, "say that name"), (["power=1"], USAGE, "read only"),
                                (["@slow=1"], USAGE, "one register"), (["holding:30=AF"], USAGE, "say 0xAF if it is hexadecimal"),
                                (["holding:30=1F"], USAGE, "say 0x1F if it is hexadecimal"),
                                (["holding:30=1", "29:u32=1"], USAGE, "'29:u32=1' and 'holding:30=1' write one register")):
        ended = tool.run(*write, "mode=off", *words)
        held = tool.run(*QUIET, "-u", MODULE, "--json", "read", "12").objects()[0]["raw"]
        check(ended.status == status and says in ended.errors and held == 1, f"{words} is refused before a frame leaves", ended)
    ended = tool.run(*how, "--write", "--allow-run", "--json", "write", "valve=open")
    held = tool.run(*QUIET, "-u", MODULE, "--json", "read", "coil:10").objects()[0]["raw"]
    check(ended.status == DONE and held == 1, "what moves is written where --allow-run says so", ended)
    (tool.place / "two.toml").write_text('[device]\nmax_registers = 1\n' + "".join(
        f'[[register]]\nname = "r{i}"\naddress = {i}\n' for i in range(20)))
    found = tool.run(*QUIET, "-u", SHORT, "--device", "two.toml", "--json", "read", "r*").objects()
    check([each.get("value") for each in found] == list(range(100, 120)), "one register a request", found)
    ended = tool.run("--csv", "device", "check", "rich.toml", port="/dev/nowhere")
    row = next(row for row in ended.rows() if row["register"] == "mode")
    check(row["choices"] == "cool -1, off 0, heat 1" and row["group"] == "fast" and row["note"] == "stored", "a check shows them", row)


BITS_FILE = """
[[register]]
name = "alarm"
address = 8
bits = "0"
[[register]]
name = "pump"
address = 8
bits = "3"
access = "write"
moves = true
[[register]]
name = "mode"
address = 8
bits = "4-7"
access = "write"
choices = { off = 0, heat = 1, cool = 9 }
[[register]]
name = "level"
address = 8
bits = "8-11"
access = "write"
max = 12
"""


def check_named_bits(tool, check):
    """Bits that a register file has a name for are written alone, by function 22; of a device that is simulated as well."""
    (tool.place / "bits.toml").write_text(BITS_FILE)
    tool.run(*QUIET, "-u", MODULE, "-d", "none", "--write", "write", "8=0xA005")
    how = ["--device", "bits.toml", "--write", "--json"]
    for words, held, shown in ((["mode=cool"], 0xA095, ["cool (9)"]), (["level=12", "mode=heat"], 0xAC15, ["12", "heat (1)"]),
                               (["--allow-run", "pump=on"], 0xAC1D, ["1"])):
        beside = [words.pop(0)] if words[0].startswith("--") else []
        ended = tool.run(*QUIET, "-u", MODULE, *how, *beside, "write", *words)
        found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "8").objects()[0]["raw"]
        check(ended.status == DONE and found == held and [row["after"] for row in ended.objects()] == shown, f"{words}", (ended, hex(found)))
    for words, status, says in ((["pump=off"], REFUSED, "pump moves something"), (["alarm=on"], USAGE, "read only"), (["level=13"], USAGE, "at most 12"),
                                (["mode=2"], USAGE, "mode takes"), (["holding:8=1"], USAGE, "read only"), (["8.4-7=1"], USAGE, "say that name"),
                                (["mode,level=heat,1"], USAGE, "bits of a register are written by words of their own")):
        ended = tool.run(*QUIET, "-u", MODULE, *how, "write", *words)
        found = tool.run(*QUIET, "-u", MODULE, "--json", "read", "8").objects()[0]["raw"]
        check(ended.status == status and says in ended.errors and found == 0xAC1D, f"{words} is refused before a frame leaves", ended)
    ended = tool.run(*QUIET, "-u", SIXTEEN, *how, "write", "mode=heat")
    check(ended.status == DIFFERS and "--read-modify-write" in ended.output, "a unit without function 22 is not written by itself", ended)
    ended = tool.run(*QUIET, "-u", SIXTEEN, *how, "write", "--read-modify-write", "mode=heat")
    found = tool.run(*QUIET, "-u", SIXTEEN, "--json", "read", "8").objects()[0]["raw"]
    check(ended.status == DONE and found == 0x10, "and is where somebody says so", (ended, found))
    text = BITS_FILE.replace('bits = "0"', 'bits = "0"\nsimulated = true\nchoices = { bad = 1 }')
    (tool.place / "simulated.toml").write_text(text)
    ended = tool.run("-u", 5, "--device", "simulated.toml", "--write", "--json", "write", "mode=heat", "level=3", port="sim:simulated.toml:5")
    check(ended.status == DONE and [row["after"] for row in ended.objects()] == ["heat (1)", "3"], "a simulated one takes them", ended)


def check_drive(tool, check):
    """A drive's words are protected by whatever words they are named; so are they of a drive that is said to be none."""
    tool.port = "sim:atv320:7,atv28:4"
    how = ["-u", 7]
    plain = tool.run(*how, "--write", "--allow-run", "write", "8501=6")
    check(plain.status == REFUSED and "commands the motor" in plain.errors, "a command is refused", plain)
    for words in MOVES:
        for beside in ([], ["-d", "atv320"], ["-d", "none"]):
            ended = tool.run(*how, *beside, "--write", "--allow-run", "write", *words)
            check(ended.status == REFUSED and "commands the motor" in ended.errors, f"{words} {beside} is refused, too", ended)
        ended = tool.run(*how, "-d", "none", "--write", "write", *words)
        check(ended.status == REFUSED and "is an atv320" in ended.errors, f"{words} to what is said to be no drive", ended)
    for word in ("9001-9002:u16=6,7", "input:8501=6", "coil:8501=on", "9000:u32=6"):
        for beside in ([], ["-d", "none"]):
            ended = tool.run(*how, *beside, "--write", "--allow-run", "write", word)
            check(ended.status == USAGE and word in ended.errors, f"{word} {beside} is refused", ended)
    for words in (["8401=2"], ["holding:8401=2"], ["8401:u16=2"], ["list:48402=2"], ["7010:u16=0"], ["64000:u16=1"]):
        ended = tool.run(*how, "--write", "write", *words)
        check(ended.status == REFUSED and "--allow-run" in ended.errors, f"{words} needs --allow-run", ended)
    ended = tool.run("-u", 4, "-d", "none", "--write", "write", "400:u16=6")
    check(ended.status == REFUSED and "is an atv28" in ended.errors, "a drive is known by its registers as well", ended)
    ended = tool.run(*how, "--write", "--json", "write", "holding:9001=1.3s")
    check(ended.status == DONE and ended.objects()[0]["register"] == "ACC", "what is harmless is written", ended)
    ended = tool.run(*how, "--write", "write", "9001:0.1s=1.3s")
    check(ended.status == USAGE and "leave out ':0.1s'" in ended.errors, "the drive's own scale counts", ended)
    with Simulator(tool.program, "atv320:7") as device:
        words = ("INR=#0", "ACC=#13", "9002:u16=14")
        ended = tool.run("--no-listen", *how, "--write", "--json", "write", *words, port=device)
        check([row["after"] for row in ended.objects()][1:] == ["0.13 s", "0.14 s"], "a count is shown in the drive's steps", ended)
    ended = tool.run(*how, "-d", "none", "stop")
    check(ended.status == DONE, "stop stops what is said to be no drive", ended)


def check_units(tool, check):
    """A list of units: each is read, and one that fails keeps no other from it."""
    how = [*QUIET, "--timeout", 0.2, "--retries", 0, "-u", f"{SHORT},{SIXTEEN},99,{MODULE}"]
    ended = tool.run(*how, "--json", "read", "0", "1")
    found = [(each["unit"], each["register"], "value" in each) for each in ended.objects()]
    wanted = [(unit, register, unit != 99) for unit in (SHORT, SIXTEEN, 99, MODULE) for register in ("0", "1")]
    check(ended.status == NO_ANSWER and found == wanted, "a list of units", ended)
    rows = tool.run(*QUIET, "-u", f"{MODULE}-{SHORT}", "read", "36").table()
    check([row[:2] for row in rows] == [[str(MODULE), "36"], [str(SHORT), "36"]], "a range of units, for people", rows)
    ended = tool.run(*how, "read", "RFR")
    check(ended.status != DONE and all(f"unit {unit}" in ended.errors for unit in (SHORT, 99, MODULE)), "none is a drive", ended)
    for word in ("62-", "70-62", "62,300"):
        ended = tool.run(*QUIET, "-u", word, "read", "0")
        check(ended.status == USAGE, f"{word} is no list", ended)


def check_refusals(tool, check):
    """Refused before a frame leaves, with what to do."""
    for words, says in ((["input:40:f33"], "did you mean f32?"), (["inputs:40"], "did you mean input?"),
                        (["coil:1:u16"], "leave out ':u16'"), (["40-42:f32"], "end the range at 43"),
                        (["RFR", "40:f33"], "did you mean f32?")):
        ended = tool.run(*QUIET, "-u", MODULE, "read", *words)
        check(ended.status == 2 and words[-1] in ended.errors and says in ended.errors, f"{words} is refused", ended)


def check_stop(tool, check):
    """Whatever was said of the unit: it stops."""
    for said in (["-d", "none"], ["--name", "fan=7:none"]):
        unit = "fan" if said[0] == "--name" else 7
        ended = tool.run("-p", "sim:atv320:7", "--no-listen", *said, "-u", unit, "--json", "stop")
        check(ended.status == 0 and "none" not in ended.errors, f"stop of {said}", ended)


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        check_stop(tool, check)
        addresses = ",".join(row["address"] for row in tool.run("--csv", "list", "-d", "atv320").rows())
        near_end, tool.port = others.line()
        others.serve(near_end, [sys.executable, "-B", __file__, "--serve", "@", addresses], stderr=subprocess.DEVNULL)
        for part in (check_meter, check_orders, check_bits, check_holes, check_any_values, check_refusals, check_writes, check_bits_written, check_formulas, check_register_file, check_rich_file, check_named_bits, check_units,
                     check_drive):
            part(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from support import DIFFERS, DONE, NO_ANSWER, REFUSED, USAGE, Simulator, Tool, runs

    from pair import Programs  # noqa: I100

    runs(main)
