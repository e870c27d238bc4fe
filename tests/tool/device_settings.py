# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Settings of a device by its register file: backed up, compared and restored, on a unit that nobody here wrote (pymodbus).

    python3 device_settings.py TOOL
    python3 device_settings.py --serve DEVICE
"""
import asyncio
import csv
import io
import json
import signal
import struct
import subprocess
import sys

MODULE, CLAMPING, SHORT = 62, 63, 64
STUCK = 20
FILE = """
[device]
vendor = "Maker"
product = "Module"
[groups]
slow = "1min"
[[register]]
name = "setpoint"
address = 40
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = -10
max = 95.5
setting = true
group = "slow"
[[register]]
name = "gain"
address = 41
type = "f32"
order = "cdab"
scale = 0.001
access = "write"
setting = true
[[register]]
name = "mode"
address = 43
access = "write"
choices = { off = 0, heat = 1, cool = 2 }
setting = true
stored = true
[[register]]
name = "label"
address = 44
type = "text6"
access = "write"
setting = true
[[register]]
name = "counter"
address = 47
type = "u32"
access = "write"
[[register]]
name = "jog"
address = 49
access = "write"
moves = true
[[register]]
name = "relay"
space = "coil"
address = 9
access = "write"
setting = true
[[register]]
name = "absent"
address = 50
type = "i16"
access = "write"
invalid = 0x7FFF
setting = true
[[register]]
name = "fixed"
address = 51
"""
COMMAND = """
[[register]]
name = "speed"
address = 8501
access = "write"
setting = true
"""
STUCK_FILE = f"""
[[register]]
name = "first"
address = 19
access = "write"
setting = true
[[register]]
name = "stuck"
address = {STUCK}
type = "u32"
access = "write"
setting = true
[[register]]
name = "third"
address = 22
access = "write"
setting = true
"""
GAIN = 0.0371
BEGIN = {40: 215, 43: 1, 44: 0x7075, 45: 0x6D70, 46: 0, 47: 7, 48: 8, 49: 0, 50: 0x7FFF, 51: 99, 8501: 0}
LOW, HIGH = struct.unpack(">2H", struct.pack(">f", GAIN))[::-1]
BEGIN |= {41: LOW, 42: HIGH}


async def serve(device):
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.device import ModbusDeviceIdentification
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    class Clamping(ModbusSlaveContext):
        """Takes any value, and keeps 3 in one register."""

        def setValues(self, code, address, values):
            super().setValues(code, address, [3 if address + i == STUCK else each for i, each in enumerate(values)])

    module = ModbusSlaveContext(hr=ModbusSparseDataBlock(dict(BEGIN)), co=ModbusSparseDataBlock({9: True}), zero_mode=True)
    clamping = Clamping(hr=ModbusSparseDataBlock({i: i for i in range(19, 25)}), zero_mode=True)
    short = ModbusSlaveContext(hr=ModbusSparseDataBlock({40: 1, 43: 1}), zero_mode=True)
    context = ModbusServerContext(slaves={MODULE: module, CLAMPING: clamping, SHORT: short}, single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N", stopbits=2,
                                          identity=ModbusDeviceIdentification(info={0: "Maker", 1: "Module", 2: "1"}),
                                          ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


LINE = ["--listen", "0.05", "-b", 38400, "-f", "8N2"]
HOW = [*LINE, "-u", MODULE, "--device", "module.toml"]


def held(tool):
    found = tool.run(*LINE, "-u", MODULE, "--json", "read", "40-51", "coil:9").objects()
    return [each["raw"] for each in found]


def check_backup(tool, check):
    """Settings only, in the forms of a drive's backup."""
    ended = tool.run(*HOW, "--json", "backup", "-o", "module.json")
    told = ended.objects()[0]
    check(ended.status == DONE and told == {"unit": MODULE, "device": "module.toml", "file": "module.json", "read": 5,
                                            "without a value": 1}, "a backup", ended)
    saved = json.loads((tool.place / "module.json").read_text())
    rows = {each["register"]: (each.get("raw"), each.get("value"), each.get("unit"), each.get("error")) for each in saved["parameters"]}
    check(saved["device"] == "module.toml" and saved["product"] == "Module" and saved["rows"] == "6" and rows == {
        "setpoint": (215, 21.5, "degC", None), "gain": (f"0x{LOW:04X}{HIGH:04X}", 3.71e-05, None, None),
        "mode": (1, "heat", None, None), "label": ("0x70756D700000", "pump", None, None), "relay": (1, 1, None, None),
        "absent": (None, None, None, "no value")},
        "has settings only, with values", saved)
    tool.run(*HOW, "backup", "-o", "module.csv")
    rows = list(csv.DictReader(io.StringIO((tool.place / "module.csv").read_text())))
    check({row["register"]: row["value"] for row in rows if row["group"] != "backup"}["setpoint"] == "21.5", "as a table", rows)
    ended = tool.run(*HOW, "compare", "module.json")
    check(ended.status == DONE and "0 of 5 settings differ" in ended.errors, "nothing differs", ended)
    ended = tool.run(*HOW, "compare", "module.json", "module.csv")
    check(ended.status == DONE, "nor between the two files", ended)


def check_restore(tool, check):
    begin = held(tool)
    changes = ["setpoint=-3", "gain=0.5", "mode=cool", "label=fan", "relay=off", "counter=9"]
    ended = tool.run(*HOW, "--write", "write", *changes)
    changed = held(tool)
    ended = tool.run(*HOW, "--json", "compare", "module.json")
    check(ended.status == DIFFERS and [(each["register"], each["left"], each["right"]) for each in ended.objects()][0]
          == ("setpoint", "21.5 degC", "-3.0 degC") and len(ended.objects()) == 5, "what differs", ended)
    ended = tool.run(*HOW, "--json", "restore", "module.json", "--dry-run")
    check(ended.status == DONE and len(ended.objects()) == 5 and held(tool) == changed and "5 to be written" in ended.errors,
          "a dry run writes nothing", ended)
    check(tool.run(*HOW, "restore", "module.json").status == REFUSED, "a restore needs --write")
    ended = tool.run(*HOW, "--write", "--json", "restore", "module.json")
    wanted = begin[:7] + changed[7:9] + begin[9:]
    check(ended.status == DONE and held(tool) == wanted and changed[7:9] != begin[7:9], "settings are restored, and nothing else",
          (ended, held(tool), wanted))
    check([each["after"] for each in ended.objects() if each["register"] == "mode"] == ["heat (1)"]
          and "bears a limited number of writes" in ended.output, "each is read back, and a wear is told", ended)
    check(tool.run(*HOW, "compare", "module.csv").status == DONE, "and is what it was")
    ended = tool.run(*HOW, "--write", "--json", "restore", "module.json")
    check(ended.status == DONE and ended.output == "" and "the unit holds all of it" in ended.errors, "a second one writes nothing", ended)
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
    check("\tsetpoint\t-3.0 degC\t21.5 degC" in log, "and is noted", log)
    (tool.place / "people.csv").write_text("\ufeffregister;value;unit\r\nsetpoint;12,5;degC\r\nmode;COOL;\r\nrelay;off;\r\n")
    ended = tool.run(*HOW, "--write", "--json", "restore", "people.csv")
    check(ended.status == DONE and held(tool)[0] == 125 and held(tool)[3] == 2 and held(tool)[-1] == 0, "a spreadsheet's table", ended)


def check_refusals(tool, check):
    """Named with the place, before a line is opened; what runs or moves is never restored."""
    whole = (tool.place / "module.json").read_text()
    for text, says in (("register,value\nfixed,5\n", "t.csv:2:1: fixed is no setting: module.toml:"),
                       ("register,value\njog,5\n", "t.csv:2:1: jog is no setting"), ("register,value\nmdoe,1\n", "did you mean 'mode'?"),
                       ("register,value\nsetpoint,96\n", "t.csv:2:10: setpoint takes at least -10 degC and at most 95.5 degC"),
                       ("register,value\nsetpoint,abc\n", "t.csv:2:10: setpoint: 'abc'"), ("register,value\nsetpoint,1.25\n", "say 1.2 degC or 1.3 degC"),
                       ("register,value,unit\nsetpoint,12,K\n", "in degC, not in K"), ("register,raw\nmode,7\n", "t.csv:2:6: mode takes off 0"),
                       ("register,raw\ngain,5\n", "t.csv:2:6: gain: '5' is no raw count: 0x and 8 hexadecimal digits"),
                       ("register,raw\nabsent,32767\n", "means that absent has no value"), ("register,raw\nrelay,2\n", "no raw count"),
                       ("register,raw,value\nsetpoint,215,21.6\n", "t.csv:2:14: setpoint: the raw count 215 is 21.5, not '21.6'"),
                       ("register,address,value\nmode,42,1\n", "mode is register 43, not 42"),
                       ("register,value\nmode,1\nMODE,1\n", "stands here a second time"), ("register,value\nmode,\n", "mode has no value"),
                       ("register,error\nmode,silent\n", "no value in it that could be restored"),
                       (whole.replace('"rows": "6"', '"rows": "7"'), "it says that it has 7 rows"),
                       (whole.replace('"device": ', '"drive": "atv320", "device": '), "it is of an atv320"), ("", "nothing in it")):
        name = "t.json" if text.startswith("{") else "t.csv"
        (tool.place / name).write_text(text)
        ended = tool.run("-u", MODULE, "--device", "module.toml", "--write", "restore", name, port="/dev/nowhere")
        check(ended.status == USAGE and says in ended.errors, f"{text[:40]!r} is refused: {says}", ended)
    (tool.place / "other.toml").write_text(FILE.replace('product = "Module"', 'product = "Other"'))
    (tool.place / "nobody.toml").write_text(FILE.replace('vendor = "Maker"\nproduct = "Module"\n', ""))
    (tool.place / "of.json").write_text(whole.replace('"product": "Module"', '"product": "Other"'))
    before = held(tool)
    for words, status in ((["--device", "other.toml", "restore", "module.json"], REFUSED), (["--device", "nobody.toml", "restore", "of.json"], REFUSED),
                          (["--device", "other.toml", "backup", "-o", "x.json"], REFUSED),
                          (["--device", "other.toml", "write", "-y", "setpoint=20"], REFUSED), (["--device", "other.toml", "ask", "06", "00280014"], REFUSED),
                          (["--device", "other.toml", "compare", "module.json"], REFUSED)):
        ended = tool.run(*LINE, "-u", MODULE, "--write", *words)
        check(ended.status == status and "'Maker Module', and is to be" in ended.errors and held(tool) == before, f"{words}: another device", ended)
    ended = tool.run(*LINE, "-u", MODULE, "--device", "other.toml", "read", "fixed")
    check(ended.status == DONE and "'Maker Module', and is to be 'Maker Other'" in ended.errors, "a read tells it", ended)
    ended = tool.run(*LINE, "-u", MODULE, "--device", "module.toml", "read", "fixed")
    check(ended.status == DONE and ended.errors == "", "and nothing of the right one", ended)
    ended = tool.run(*LINE, "-u", SHORT, "--device", "nobody.toml", "--write", "restore", "module.json")
    check(ended.status == DIFFERS and "nothing was written" in ended.errors, "a setting that cannot be read", ended)
    for words, says in ((["compare", "--factory"], "--factory"), (["restore", "module.json", "--save"], "--save"),
                        (["restore", "module.json", "--with-inferred"], "--with-")):
        ended = tool.run(*HOW, "--write", *words)
        check(ended.status == USAGE and says in ended.errors, f"{words} is of drives", ended)
    (tool.place / "command.toml").write_text(COMMAND)
    (tool.place / "command.csv").write_text("register,value\nspeed,6\n")
    for beside in ([], ["--allow-run"]):
        how = ["--device", "command.toml", "--write", *beside, "restore", "command.csv"]
        ended = tool.run("--no-listen", "-u", 7, *how, port="sim:atv320:7")
        check(ended.status == REFUSED, f"a drive is no device: {beside}", ended)
    ended = tool.run("--no-listen", "-u", 7, "--device", "command.toml", "--write", "restore", "command.csv", "--dry-run", port="sim:atv320:7")
    check(ended.status == DONE, "a dry run writes nothing, whatever it is", ended)


def check_halfway(tool, check):
    """A value that the unit does not keep, and a Ctrl-C: what was written is told, and the rest is not begun."""
    (tool.place / "stuck.toml").write_text(STUCK_FILE)
    (tool.place / "stuck.csv").write_text("register,value\nfirst,100\nstuck,101\nthird,102\n")
    how = [*LINE, "-u", CLAMPING, "--device", "stuck.toml", "--write", "--json", "restore", "stuck.csv"]
    ended = tool.run(*how)
    rows = [(each["register"], each["after"], each["note"]) for each in ended.objects()]
    check(ended.status == DIFFERS and rows == [
        ("first", "100 (0x0064)", ""), ("stuck", str((3 << 16) + 101), "the unit holds another value"), ("third", None, "not tried")],
          "a unit that keeps another value", ended)
    (tool.place / "stuck.csv").write_text("register,value\nfirst,200\nthird,202\n")
    # While the first one is read back, a second behind its write.
    process = tool.start("-v", "--pause", 1000, *how)
    while "> 3F 06 00 13" not in (line := process.stderr.readline()) and line:
        pass
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=30)
    first = output.splitlines()[0]
    held_now = [each["raw"] for each in tool.run(*LINE, "-u", CLAMPING, "--json", "read", "19", "22").objects()]
    check(process.returncode == 130 and '"after":"200' in first and "not tried" in output and "ended by a signal" in errors and held_now == [200, 22],
          "Ctrl-C ends it between two registers", (process.returncode, first, output, errors, held_now))


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        (tool.place / "module.toml").write_text(FILE)
        near_end, tool.port = others.line()
        others.serve(near_end, [sys.executable, "-B", __file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        for part in (check_backup, check_restore, check_refusals, check_halfway):
            part(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from support import DIFFERS, DONE, REFUSED, USAGE, Tool, runs

    from pair import Programs  # noqa: I100

    runs(main)
