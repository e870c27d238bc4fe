# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Names and values of a register file in frames that others sent: what is sniffed, captured, replayed and decoded of units
that nobody here wrote (pymodbus) has the names of the file, and the values that Python reads in the same bytes; and whatever
a file says of whatever bytes, it is what `read` says of them.

    python3 captured_names.py TOOL
    python3 captured_names.py --serve DEVICE SEED
"""
import asyncio
import json
import random
import signal
import struct
import subprocess
import sys

METER, BOX = 61, 62
SIZE = 300  # addresses in each space
VOLTAGE, ENERGY = 230.1, 123456  # V, 0.01 kWh


def words_of(unit, seed):
    """The four spaces of a unit: whole values of all kinds, and words that mean nothing."""
    chance = random.Random(f"{seed} {unit}")
    word = lambda: chance.choice((0, 0xFFFF, 0x8000, chance.randrange(100), 0x1234, 0x4142, chance.randrange(65536), chance.randrange(65536)))
    spaces = {"holding": [word() for _ in range(SIZE)], "input": [word() for _ in range(SIZE)],
              "coil": [chance.random() < 0.5 for _ in range(SIZE)], "discrete": [chance.random() < 0.5 for _ in range(SIZE)]}
    high, low = struct.unpack(">2H", struct.pack(">f", VOLTAGE))
    if unit == BOX:
        return spaces
    spaces["input"][100:104] = [low, high, ENERGY >> 16, ENERGY & 0xFFFF]
    spaces["holding"][41:43] = [0x0012, 0x7FFF]
    spaces["coil"][3:5] = [True, False]
    return spaces


async def serve(device, seed):
    from pymodbus.datastore import ModbusSequentialDataBlock as Block
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer
    units = {}
    for unit in (METER, BOX):
        spaces = words_of(unit, seed)
        units[unit] = ModbusSlaveContext(hr=Block(0, spaces["holding"]), ir=Block(0, spaces["input"]), co=Block(0, spaces["coil"]),
                                         di=Block(0, spaces["discrete"]), zero_mode=True)
    server = await StartAsyncSerialServer(ModbusServerContext(slaves=units, single=False), framer=ModbusRtuFramer, port=device,
                                          baudrate=38400, parity="N", stopbits=2, ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


METER_FILE = """
[[register]]
name = "voltage"
space = "input"
address = 100
type = "f32"
order = "cdab"
unit = "V"
[[register]]
name = "energy"
space = "input"
address = 102
type = "u32"
scale = 0.01
unit = "kWh"
[[register]]
name = "mode"
address = 41
bits = "4-7"
choices = { off = 0, heat = 1, cool = 2 }
[[register]]
name = "alarm"
address = 41
bits = "1"
[[register]]
name = "outside"
address = 42
type = "i16"
scale = 0.1
unit = "degC"
invalid = 0x7FFF
access = "write"
[[register]]
name = "relay"
space = "coil"
address = 3
choices = { closed = 0, open = 1 }
access = "write"
"""
BOX_FILE = """
[[register]]
name = "first"
space = "input"
address = 100
type = "hex"
[[register]]
name = "command"
address = 8501
"""
LINE = ["--no-listen", "-b", 38400, "-f", "8N2"]
NAMED = ["--name", f"meter={METER}:meter.toml", "--name", f"box={BOX}:box.toml"]


def field(rows, name, form="response"):
    """The values of the fields of that name."""
    return [row["value"] for row in rows if row["field"] == name and row["as"].endswith(form)]


def listened(tool, line, *words):
    """What a command that listens shows while the meter and the box are read."""
    process = tool.start("-b", 38400, "-f", "8N2", *words, port=line.tap_name)
    line.listen_to(process)
    tool.run(*LINE, "-u", METER, "read", "input:100-103", "holding:41-42", "coil:3-4", port=line.name)
    tool.run(*LINE, "-u", METER, "read", "input:101-102", port=line.name)
    tool.run(*LINE, "-u", BOX, "read", "input:100-101", port=line.name)
    line.wait_until_read()
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    line.is_tapped = False
    return output, errors


def check_meter(tool, line, check):
    """A float with the low word first, a wide count, bits, a choice, an invalid number, a coil; two units with a file each."""
    box = words_of(BOX, "fixed")["input"]
    wanted = {f"read voltage, 4 registers": "request", "voltage 230.1 V, energy 1234.56 kWh": "response",
              "41 18, mode heat (1), alarm 1, outside no value (0x7FFF)": "response", "relay open (1), coil 4 0": "response",
              "read relay, 2 bits": "request",
              "voltage no value: 0x4366 is register 2 of its 2, energy no value: 0x0001 is register 1 of its 2": "response",
              f"first 0x{box[100]:04X}, input 101 {box[101]}": "response"}
    output, errors = listened(tool, line, *NAMED, "--json", "sniff")
    told = {each["text"]: each["role"] for each in map(json.loads, output.splitlines())}
    check(wanted.items() <= told.items(), "sniff names registers of two units by two files", (told, errors))
    file = tool.place / "line.pcapng"
    listened(tool, line, "capture", "-o", file)
    told = {each["text"]: each["role"] for each in tool.run(*NAMED, "--json", "replay", file).objects()}
    check(wanted.items() <= told.items(), "a replay does", told)
    rows = {form: tool.run(*NAMED, form, "decode", port=file) for form in ("--json", "--csv")}
    rows = {form: ended.objects() if form == "--json" else ended.rows() for form, ended in rows.items()}
    for form, found in rows.items():
        values = {name: field(found, name) for name in (
            "registers 100 to 101 voltage", "registers 102 to 103 energy", "register 41", "register 41 mode", "register 41 alarm",
            "register 42 outside", "coil 3 relay", "register 101 voltage", "register 102 energy", "register 100 first")}
        check(values == {"registers 100 to 101 voltage": ["230.1 V"], "registers 102 to 103 energy": ["1234.56 kWh"],
                         "register 41": ["18"], "register 41 mode": ["heat (1)"], "register 41 alarm": ["1"],
                         "register 42 outside": ["no value (0x7FFF)"], "coil 3 relay": ["open (1)"],
                         "register 101 voltage": ["no value: 0x4366 is register 2 of its 2"],
                         "register 102 energy": ["no value: 0x0001 is register 1 of its 2"],
                         "register 100 first": [f"0x{box[100]:04X}"]}, f"decode {form} names them", values)
        check(field(found, "first input register", "request") == ["100 (voltage)", "101 (register 2 of voltage)", "100 (first)"],
              f"decode {form} names what was asked for", field(found, "first input register", "request"))
        held = [(row["register"], row["holds"], row["measure"]) for row in found if row["register"] and row["as"] == "response"]
        wanted = [("mode", "heat", ""), ("alarm", True, ""), ("outside", "", "degC"), ("voltage", VOLTAGE, "V"), ("energy", ENERGY / 100, "kWh"),
                  ("relay", "open", ""), ("voltage", "", ""), ("energy", "", ""), ("first", box[100], "")]
        plain = lambda it: "" if it is None else "yes" if it is True else str(it)  # CSV has texts, and JSON null for nothing
        check([[*map(plain, each)] for each in held] == [[*map(plain, each)] for each in wanted], f"{form} has them for programs", held)
    table = tool.run(*NAMED, "decode", port=file).output
    check("registers 100 to 101 voltage  230.1 V" in table, "a table does", table[:200])
    rows = tool.run("-u", METER, "--device", "meter.toml", "--json", "decode", port=file).objects()
    check(field(rows, "registers 100 to 101 voltage") == ["230.1 V"] and field(rows, "register 100") == [str(box[100])],
          "--device names registers of the unit of --unit alone", rows)
    for command in (["capture", "-o", "x.pcapng"], ["timing", file]):
        ended = tool.run("--device", "meter.toml", *command)
        check(ended.status == USAGE and f"'{command[0]}' does not" in ended.errors, f"{command[0]} shows no registers", ended)


def frame(*numbers):
    return with_crc(bytes(numbers)).hex(" ")


def check_pairs(tool, check):
    """Addresses are those of the request: a response without it, or to another, names nothing."""
    asked = frame(METER, 4, 0, 100, 0, 2)
    value = frame(METER, 4, 4, 0x19, 0x9A, 0x43, 0x66)
    other = frame(METER, 4, 0, 102, 0, 1)
    def named(*lines, how=NAMED):
        rows = tool.run(*how, "--json", "decode", "-", given="\n".join(lines) + "\n").objects()
        return [row["value"] for row in rows if row["as"].endswith("response") and "voltage" in row["field"]]
    check(named(asked, value) == ["230.1 V"], "a response has the names of its request", named(asked, value))
    check(named(asked, value, value) == ["230.1 V"], "once", named(asked, value, value))
    for lines in ([value], [asked, other, value], [frame(BOX, 4, 0, 100, 0, 2), value],
                  [frame(METER, 3, 0, 100, 0, 2), value], [asked.replace("3d", "3e", 1), value]):
        check(named(*lines) == [], f"{lines}: none", named(*lines))
    rows = tool.run(*NAMED, "--json", "decode", "-", given=f"{asked}\n{value[:-2]}00\n").objects()
    check(not any(row["register"] or row["holds"] for row in rows), "a program gets no value out of a frame with a wrong CRC", rows)
    how = ["--device", "meter.toml"]
    check(named(asked, value, how=how) == ["230.1 V"] and named(asked, value, how=[]) == [], "by --device, of all units")
    holding = tool.run(*NAMED, "--json", "decode", frame(METER, 3, 0, 100, 0, 2)).objects()
    check(field(holding, "first register", "request") == ["100"], "another space has no such names", holding)
    coils = [frame(METER, 1, 0, 0, 0, 3), frame(METER, 1, 1, 0xFF)]
    rows = tool.run(*NAMED, "--json", "decode", "-", given="\n".join(coils)).objects()
    check(field(rows, "coils 0 to 2") == ["1 1 1"] and not field(rows, "coil 3 relay"), "what fills a byte is no coil", rows)
    for write, name, wanted in (([6, 0, 42, 0xFF, 0x9D], "register 42 outside", "-9.9 degC"), ([5, 0, 3, 0xFF, 0], "coil 3 relay", "open (1)"),
                                ([15, 0, 2, 0, 2, 1, 0xFD], "coil 3 relay", "closed (0)"),
                                ([16, 0, 41, 0, 2, 4, 0, 0x22, 0, 5], "register 41 mode", "cool (2)")):
        rows = tool.run(*NAMED, "--json", "decode", frame(METER, *write)).objects()
        check(wanted in field(rows, name, "request") + field(rows, name), f"a write {write} is named", rows)


def check_refusals(tool, check):
    """What names nothing is refused, before bytes are looked at; a drive keeps the names of its own table."""
    bytes_typed = frame(METER, 4, 0, 100, 0, 2)
    (tool.place / "wrong.toml").write_text(METER_FILE + "adress = 1\n")
    for words, says in ((["--device", "nowhere.toml"], "nowhere.toml"), (["--name", "x=61:nowhere.toml"], "nowhere.toml"),
                        (["--device", "wrong.toml"], "'adress' is no key here"), (["--name", "x=61:atv32"], "atv32"),
                        (["--device", "meter.toml", "-u", "metre", *NAMED], "did you mean 'meter'?"),
                        (["--device", "meter.toml", "-d", "atv320"], "a register file is of what is no drive"),
                        (["--device", "meter.toml", "--name", "fan=7:atv320", "-u", "fan"], "a register file is of what is no drive")):
        for command in (["decode", bytes_typed], ["replay", "line.pcapng"], ["sniff", "--for", "0.1s"]):
            ended = tool.run(*words, *command, port="/dev/nowhere")
            check(ended.status == USAGE and says in ended.errors, f"{words} {command[0]} is refused", ended)
    both = ["--name", "fan=7:atv320", "--device", "box.toml"]
    for unit, name in ((7, "8501 (CMD)"), (METER, "8501 (command)")):
        rows = tool.run(*both, "--json", "decode", frame(unit, 3, 0x21, 0x35, 0, 1)).objects()
        check(field(rows, "first register", "request") == [name], f"unit {unit}: {name}", rows)
    ended = tool.run("--no-listen", "-u", 7, "--device", "box.toml", "--json", "ask", "03", "21350001", port="sim:atv320:7")
    check("8501 (command)" in field(ended.objects(), "first register", "request"), "ask names by a file", ended)
    for beside in ([], ["--allow-run"]):
        ended = tool.run("--no-listen", "-u", 7, "--device", "box.toml", "--write", *beside, "ask", "06", "21350006", port="sim:atv320:7")
        check(ended.status == REFUSED, "and no name of a file makes a drive's command less of one", ended)


TYPES = {"": 1, "u16": 1, "i16": 1, "u32": 2, "i32": 2, "u64": 4, "i64": 4, "f32": 2, "f64": 4, "bcd16": 1, "bcd32": 2, "text5": 3,
         "text8": 4, "bits": 1, "hex": 1}


def drawn_register(chance, name, space, address, words):
    """A register of a file, of whatever form, and how many addresses it has."""
    lines, size = [f'name = "{name}"', f'space = "{space}"', f"address = {address}"], 1
    if space in ("coil", "discrete"):
        return lines + ["choices = { no = 0, yes = 1 }"] * (chance.random() < 0.3), 1
    if chance.random() < 0.15:
        first = chance.randrange(16)
        last = chance.randrange(first, 16)
        return lines + [f'bits = "{first}-{last}"' if last > first else f'bits = "{first}"'], 1
    kind = chance.choice(list(TYPES))
    size = TYPES[kind]
    lines += [f'type = "{kind}"'] * bool(kind)
    orders = ("abcd", "badc") if size == 1 or kind.startswith("text") else ("abcd", "cdab", "badc", "dcba") + ("ghefcdab",) * (size == 4)
    lines += [f'order = "{chance.choice(orders)}"'] * bool(kind not in ("", "bits", "hex") and chance.random() < 0.7)
    is_scaled = kind not in ("text5", "text8", "bits", "hex") and chance.random() < 0.5
    if is_scaled:
        lines += [f"scale = {chance.choice(('0.1', '0.25', '10', '0.001'))}", 'unit = "kWh"'] + ["offset = -50"] * (chance.random() < 0.3)
    elif kind in ("u16", "i16") and chance.random() < 0.5:
        lines.append(f"choices = {{ zero = 0, some = {words[0] if kind == 'u16' and words[0] else 7} }}")
    if size == 1 and not is_scaled and chance.random() < 0.3:
        lines.append(f"invalid = {chance.choice((words[0], 0x7FFF))}")
    return lines, size


def drawn_file(chance, spaces):
    text, count = "", 0
    for space, values in spaces.items():
        address = chance.randrange(4)
        while address + 4 < SIZE and count < 400:
            lines, size = drawn_register(chance, f"r{count}_{space}", space, address, values[address:address + 4])
            text += "[[register]]\n" + "\n".join(lines) + "\n"
            address, count = address + size + chance.choice((0, 0, 0, 0, 0, 1, 7)), count + 1
    return text


def check_as_read(tool, check, seed):
    """Drawn files over drawn words: `read` and what shows its frames say the same."""
    chance = random.Random(seed)
    for unit in (METER, BOX):
        (tool.place / "drawn.toml").write_text(drawn_file(chance, words_of(unit, "fixed")))
        trace = tool.place / f"{seed}{unit}.pcapng"
        how = ["-u", unit, "--device", "drawn.toml", "--json"]
        ended = tool.run(*LINE, *how, "--trace", trace, "read", "*")
        said = {each["register"]: (each.get("text"), each.get("value"), each.get("measure")) for each in ended.objects()}
        check(ended.status == DONE and len(said) > 150, f"seed {seed}, unit {unit}: all is read", ended.errors)
        rows = [row for row in tool.run(*how, "decode", port=trace).objects() if row["as"] == "response"]
        found = {row["register"]: (row["value"], row["holds"], row["measure"] or "") for row in rows if row["register"]}
        differs = [(name, said.get(name), found.get(name)) for name in said.keys() | found.keys() if said.get(name) != found.get(name)]
        names = {row["field"].split()[-1] for row in rows if "_" in row["field"]}
        check(names == found.keys(), f"seed {seed}, unit {unit}: people and programs see the same names", names ^ found.keys())
        check(not differs, f"seed {seed}, unit {unit}: {len(said)} values are what read says", differs[:5])
        lines = [each["text"] for each in tool.run(*how, "replay", trace).objects() if each["role"] == "response"]
        shown = [name for name, (text, *_) in said.items() if any(f"{name} {text}" in line for line in lines)]
        check(len(shown) > 100, f"seed {seed}, unit {unit}: a replay shows {len(shown)} of them so", lines[:3])


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        (tool.place / "meter.toml").write_text(METER_FILE)
        (tool.place / "box.toml").write_text(BOX_FILE)
        near_end, tool.port = others.line()
        others.serve(near_end, [sys.executable, "-B", __file__, "--serve", "@", "fixed"], stderr=subprocess.DEVNULL)
        with LineBetween(tool.port) as line:
            check_meter(tool, line, check)
        for seed in range(4):
            check_as_read(tool, check, seed)
        tool.port = None
        check_pairs(tool, check)
        check_refusals(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from line_between import LineBetween
    from support import DONE, REFUSED, USAGE, Tool, runs, with_crc

    from pair import Programs  # noqa: I100

    runs(main)
