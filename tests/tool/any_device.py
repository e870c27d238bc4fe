# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Places of any device, of units that nobody here wrote (pymodbus): a meter with function 04 only, and a module with
coils, discrete inputs and holding registers.

    python3 any_device.py TOOL
    python3 any_device.py --serve DEVICE
"""
import asyncio
import random
import struct
import subprocess
import sys

METER, MODULE, SHORT = 61, 62, 63
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


async def serve(device):
    from pymodbus.datastore import ModbusSequentialDataBlock as Block
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    class InputsOnly(ModbusSlaveContext):
        """It refuses what is not function 04."""

        def validate(self, code, address, count=1):
            return code == 4 and super().validate(code, address, count)

    class OneEach(ModbusSlaveContext):
        """Answers one register a request, as some meters do."""

        def validate(self, code, address, count=1):
            return count == 1 and super().validate(code, address, count)

    meter = InputsOnly(ir=ModbusSparseDataBlock({1000 + i: word for i, word in enumerate(floats())}), zero_mode=True)
    module = ModbusSlaveContext(hr=Block(0, list(HOLDING)), ir=ModbusSparseDataBlock(
        {i: i for i in range(30) if i != HOLE}), co=Block(0, list(COILS)), di=Block(0, list(INPUTS)), zero_mode=True)
    short = OneEach(hr=Block(0, list(range(100, 120))), zero_mode=True)
    context = ModbusServerContext(slaves={METER: meter, MODULE: module, SHORT: short}, single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N",
                                          stopbits=2, ignore_missing_slaves=True, defer_start=True)
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
        each["value"] == value or near(each["value"] or 0, value) for each, value in zip(found, wanted)),
        "any type in any order", list(zip(words, [each.get("value") for each in found], wanted)))


def check_refusals(tool, check):
    """Refused before a frame leaves, with what to do."""
    for words, says in ((["input:40:f33"], "did you mean f32?"), (["inputs:40"], "did you mean input?"),
                        (["coil:1:u16"], "leave out ':u16'"), (["40-42:f32"], "end the range at 43")):
        ended = tool.run(*QUIET, "-u", MODULE, "read", *words)
        check(ended.status == 2 and words[0] in ended.errors and says in ended.errors, f"{words} is refused", ended)


def check_stop(tool, check):
    """Whatever was said of the unit: it stops."""
    for said in (["-d", "none"], ["--name", "fan=7:none"]):
        unit = "fan" if said[0] == "--name" else 7
        ended = tool.run("-p", "sim:atv320:7", "--no-listen", *said, "-u", unit, "--json", "stop")
        check(ended.status == 0 and "none" not in ended.errors, f"stop of {said}", ended)


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        check_stop(tool, check)
        near_end, tool.port = others.line()
        others.serve(near_end, [sys.executable, "-B", __file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        for part in (check_meter, check_orders, check_bits, check_holes, check_any_values, check_refusals):
            part(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(sys.argv[2]))
else:
    from support import Tool, runs

    from pair import Programs  # noqa: I100

    runs(main)
