# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""An inverter with SunSpec's mark, served by pymodbus: who it is, and its points by the files of its models, which are written by
hand here, shorter than the public ones.

    python3 sunspec.py TOOL
    python3 sunspec.py --serve DEVICE
"""
import asyncio
import json
import struct
import subprocess
import sys

INVERTER, LONG, PLAIN, OTHER, BEYOND = 5, 6, 7, 8, 9


def point(name, kind, size=1, **more):
    return {"name": name, "type": kind, "size": size, **more}


def model(number, name, points, groups=()):
    head = [point("ID", "uint16"), point("L", "uint16")]
    return {"id": number, "group": {"name": name, "type": "group", "points": head + points, "groups": list(groups)}}


MODELS = {
    1: model(1, "common", [point("Mn", "string", 16), point("Md", "string", 16), point("Opt", "string", 8), point("Vr", "string", 8),
                           point("SN", "string", 16), point("DA", "uint16"), point("Pad", "pad")]),
    103: model(103, "inverter", [
        point("A", "uint16", units="A", sf="A_SF", label="Amps"), point("AphA", "uint16", units="A", sf="A_SF"), point("A_SF", "sunssf"),
        point("W", "int16", units="W", sf="W_SF"), point("W_SF", "sunssf"), point("WH", "acc32", 2, units="Wh", sf="WH_SF"),
        point("WH_SF", "sunssf"), point("TmpCab", "int16", units="C", sf="Tmp_SF"), point("Tmp_SF", "sunssf"),
        point("St", "enum16", symbols=[{"name": "OFF", "value": 1}, {"name": "MPPT", "value": 4}]),
        point("Evt1", "bitfield32", 2, symbols=[{"name": "GROUND_FAULT", "value": 0}, {"name": "OVER_TEMP", "value": 17}]),
        point("Hz", "float32", 2, units="Hz"), point("Va", "float32", 2, units="V")]),
    160: model(160, "mppt", [point("DCA_SF", "sunssf"), point("DCV_SF", "sunssf"), point("N", "count")],
               [{"name": "module", "type": "group", "count": "N", "points": [
                   point("ID", "uint16"), point("DCA", "uint16", units="A", sf="DCA_SF"), point("DCV", "uint16", units="V", sf="DCV_SF")]}]),
    64001: model(64001, "long", [], [{"name": "cell", "type": "group", "count": 0,
                                      "points": [point("V", "uint32", 2, units="mV"), point("T", "uint16", sf=-1, units="C")]}]),
}


def text(said, registers):
    return list(struct.unpack(f">{registers}H", said.encode().ljust(2 * registers, b"\0")))


def chain(*models):
    """Models behind the mark."""
    words = [0x5375, 0x6E53]
    for number, body in models:
        words += [number, len(body), *body]
    return [*words, 0xFFFF, 0]


COMMON = [*text("Sun & Sons", 16), *text("Inverter 3", 16), *text("", 8), *text("1.2", 8), *text("SN007", 16), 5, 0x8000]
BODY = [1234, 0xFFFF, 0x10000 - 2, 0x10000 - 500, 1, 0x0001, 0x86A0, 0, 415, 0x8000, 4, 0x0002, 0x0001,
        *struct.unpack(">2H", struct.pack(">f", 49.98)), 0x7FC0, 0]
TRACKERS = [0x10000 - 1, 0x10000 - 1, 2, 1, 55, 6500, 2, 0xFFFF, 6400]
CELLS = [word for i in range(60) for word in (i, 3000 + i, 200 + i)]


async def serve(device):
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    def unit(base, words):
        return ModbusSlaveContext(hr=ModbusSparseDataBlock({base + i: word for i, word in enumerate(words)}), zero_mode=True)

    context = ModbusServerContext(single=False, slaves={
        INVERTER: unit(40000, chain((1, COMMON), (103, BODY), (160, TRACKERS))),
        LONG: unit(50000, chain((64001, CELLS), (64002, [1, 2]))), PLAIN: unit(100, [1, 2, 3]),
        OTHER: unit(40000, chain((103, BODY[:5]), (160, [*TRACKERS, 1, 2]), (160, TRACKERS[:6]))),
        BEYOND: unit(40000, [0x5375, 0x6E53, 103, 65000])})
    server = await StartAsyncSerialServer(context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N", stopbits=2,
                                          ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


QUIET = ["--listen", "0.05", "-b", 38400, "-f", "8N2"]


def check_identify(tool, check):
    ended = tool.run(*QUIET, "-u", INVERTER, "--json", "identify")
    wanted = "SunSpec at 40000: model 1 at 40002 (66), 103 at 40070 (17), 160 at 40089 (9)"
    check(ended.status == DONE and ended.objects()[0]["note"] == wanted, "the mark and the models", ended)
    ended = tool.run(*QUIET, "-u", PLAIN, "--json", "identify")
    check("SunSpec" not in ended.output, "no mark, no models", ended)


def check_points(tool, check):
    ended = tool.run(*QUIET, "-u", INVERTER, "--json", "read", "@sunspec", "--sunspec", "models")
    found = {each["register"]: each for each in ended.objects()}
    check(ended.status == DONE and len(found) == 8 + 15 + 5 + 6, "all points but the padding", ended)
    for name, address, value, measure, said in (
            ("1.Mn", 40004, "Sun & Sons", "", "Sun & Sons"), ("103.A", 40072, 12.34, "A", "12.34 A"),
            ("103.AphA", 40073, None, "", "not implemented"), ("103.W", 40075, -5000, "W", "-5000 W"),
            ("103.WH", 40077, 100000, "Wh", "100000 Wh"), ("103.TmpCab", 40080, None, "", "not implemented: no scale factor"),
            ("103.St", 40082, "MPPT", "", "MPPT (4)"), ("103.Evt1", 40083, 0x20001, "", "GROUND_FAULT+OVER_TEMP (0x00020001)"),
            ("103.Hz", 40085, 49.98, "Hz", "49.98 Hz"), ("103.Va", 40087, None, "V", "not implemented"), ("160.module_1.DCA", 40095, 5.5, "A", "5.5 A"),
            ("160.module_2.DCA", 40098, None, "", "not implemented"), ("160.module_2.DCV", 40099, 640, "V", "640.0 V")):
        each = found.get(name)
        check(each and (each["address"], each["value"], each["measure"], each["text"]) == (address, value, measure, said), name, each)
    ended = tool.run(*QUIET, "-u", INVERTER, "read", "@sunspec", "--sunspec", "models")
    check("103.A" in ended.output and "Amps" in ended.output, "for people", ended)


def check_long(tool, check):
    """A model that is longer than a response, up to its end; one without a file."""
    ended = tool.run(*QUIET, "-u", LONG, "--json", "read", "@sunspec", "--sunspec", "models")
    found = {each["register"]: each["value"] for each in ended.objects()}
    wanted = {f"64001.cell_{i + 1}.V": i << 16 | 3000 + i for i in range(60)}
    check(ended.status == DONE and all(found.get(name) == value for name, value in wanted.items()), "each value comes by one response", ended)
    check(found["64001.cell_60.T"] == 25.9 and "model 64002 at 50184: models has no model_64002.json" in ended.errors, "and the rest", ended)


def check_lengths(tool, check):
    """Models that are shorter and longer than their files, or lead beyond the last register: what is not shown is told."""
    ended = tool.run(*QUIET, "-u", OTHER, "--json", "read", "@sunspec", "--sunspec", "models")
    check(ended.status == DIFFERS and len(ended.objects()) == 7 + 5 + 6 + 5 + 3, "what is there", ended)
    for says in ("model 103: WH and what stands behind it are left out: the device's model ends before", "model 160: its last 2 registers are left out",
                 "model 160: module_2.ID and what stands behind it are left out"):
        check(says in ended.errors, says, ended)
    ended = tool.run(*QUIET, "-u", BEYOND, "identify")
    check(ended.status == DIFFERS and "beyond 65535" in ended.output, "a length beyond the last register", ended)


def check_refused(tool, check):
    (tool.place / "empty").mkdir()
    for folder in ("empty", "nofolder"):
        ended = tool.run(*QUIET, "-u", INVERTER, "read", "@sunspec", "--sunspec", folder)
        check(ended.status == USAGE and f"--sunspec {folder}: " in ended.errors, f"{folder} has no models", ended)
    for words, says in ((["@sunspec"], "--sunspec FOLDER"), (["@sunspec", "40", "--sunspec", "models"], "stands alone")):
        ended = tool.run(*QUIET, "-u", INVERTER, "read", *words)
        check(ended.status == USAGE and says in ended.errors, f"{words} is refused", ended)
    ended = tool.run(*QUIET, "-u", PLAIN, "read", "@sunspec", "--sunspec", "models")
    check(ended.status == DIFFERS and "no mark of SunSpec" in ended.errors, "a unit without a mark", ended)
    for broken, says in (("{", "this is no JSON"), ("{}", "no model of SunSpec")):
        (tool.place / "models" / "model_64002.json").write_text(broken)
        ended = tool.run(*QUIET, "-u", LONG, "read", "@sunspec", "--sunspec", "models")
        check(ended.status == USAGE and says in ended.errors and "model_64002.json" in ended.errors, f"{broken!r} is no model", ended)


def main(check, program):
    with Tool(program) as tool, Programs() as others:
        (tool.place / "models").mkdir()
        for number, content in MODELS.items():
            (tool.place / "models" / f"model_{number}.json").write_text(json.dumps(content))
        near_end, tool.port = others.line()
        others.serve(near_end, [sys.executable, "-B", __file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        for part in (check_identify, check_points, check_long, check_lengths, check_refused):
            part(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from support import DIFFERS, DONE, USAGE, Tool, runs

    from pair import Programs  # noqa: I100

    runs(main)
