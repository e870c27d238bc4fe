# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`ask`: any function, sent to units that nobody here wrote (pymodbus, libmodbus) and shown with what came; what is free, what
needs which permission, and that nothing reaches a drive by it that `write` refuses.

    python3 asking.py TOOL LIBMODBUS_SERVER
    python3 asking.py --serve DEVICE
"""
import asyncio
import struct
import subprocess
import sys

FIRST, SECOND, NOBODY = 61, 62, 99
OWN_FUNCTION = 0x41


async def serve(device):
    from pymodbus.datastore import ModbusSequentialDataBlock as Block
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext
    from pymodbus.device import ModbusDeviceIdentification
    from pymodbus.pdu import ModbusRequest, ModbusResponse
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer

    class Sum(ModbusResponse):
        function_code = OWN_FUNCTION

        def __init__(self, text=b"", **kwargs):
            super().__init__(**kwargs)
            self.text = text

        def encode(self):
            return self.text

    class Add(ModbusRequest):
        """A maker's own function: two bytes, and a text of any length that no table knows."""
        function_code = OWN_FUNCTION
        _rtu_frame_size = 6

        def decode(self, data):
            self.numbers = data

        def encode(self):
            return self.numbers

        def execute(self, _):
            return Sum(b"sum %d" % sum(self.numbers))

    def unit():
        return ModbusSlaveContext(hr=Block(0, list(range(100, 150))), ir=Block(0, list(range(200, 250))),
                                  co=Block(0, [i % 3 == 0 for i in range(40)]), di=Block(0, [i % 5 == 1 for i in range(40)]),
                                  zero_mode=True)

    context = ModbusServerContext(slaves={FIRST: unit(), SECOND: unit()}, single=False)
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    server = await StartAsyncSerialServer(
        context, framer=ModbusRtuFramer, port=device, baudrate=38400, parity="N", stopbits=2, ignore_missing_slaves=True,
        identity=ModbusDeviceIdentification(info={0: "Maker", 1: "Module", 2: "1"}),
        broadcast_enable=True, defer_start=True)
    server.decoder.register(Add)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


QUIET = ["--listen", "0.05", "-b", 38400, "-f", "8N2", "--timeout", 0.5, "--retries", 0]
NONE = ["-d", "none", "--write"]


def frames_of(rows, check, what):
    """The whole frames of an answer by who sent them, each with a right CRC by this test's own; the error beside."""
    frames = {row["as"]: bytes.fromhex(row["bytes"]) for row in rows if row["field"] == "frame"}
    check(all(crc(frame) == 0 for frame in frames.values()), f"{what}: each frame has its CRC", frames)
    error = [row["value"] for row in rows if row["field"] == "error"]
    return frames.get("request"), frames.get("response"), error[0] if error else ""


def ask(tool, check, unit, words, *beside):
    ended = tool.run(*QUIET, *beside, "-u", unit, "--json", "ask", *words)
    return ended, *frames_of(ended.objects(), check, words)


def check_free(tool, check):
    """What reads is sent as it is typed, and what comes is shown byte by byte, as pymodbus means it."""
    words = b"".join(struct.pack(">H", 100 + i) for i in range(3))
    inputs = b"".join(struct.pack(">H", 200 + i) for i in range(3))
    cases = ((["01", "00000009"], bytes([1, 2, 0x49, 0x00])), (["02", "00 00 00 09"], bytes([2, 2, 0x42, 0x00])),
             (["3", "0x0000", "0x0003"], bytes([3, 6]) + words), (["0x04", "0000", "0003"], bytes([4, 6]) + inputs),
             (["07"], bytes([7, 0])), (["08", "0000", "A5A5"], bytes.fromhex("080000a5a5")), (["0B"], None), (["0C"], None),
             (["11"], None), (["14", "07", "06", "0001", "0000", "0001"], None), (["18", "0000"], None),
             (["2B", "0E", "01", "00"], None))
    for typed, wanted in cases:
        ended, request, response, error = ask(tool, check, FIRST, typed)
        sent = bytes.fromhex("".join(each.replace("0x", "").zfill(2) for each in typed))
        check(request[:-2] == bytes([FIRST]) + sent, f"{typed} is sent as it is typed", request)
        if wanted is not None:
            check(ended.status == DONE and response[:-2] == bytes([FIRST]) + wanted and not error, f"{typed} is answered", ended)
        is_answered = response is not None and response[1] < 0x80
        check((ended.status == DONE) == is_answered == (not error), f"{typed}: its status says whether it is answered", ended)
    rows = tool.run(*QUIET, "-u", FIRST, "--csv", "ask", "03", "00000002").rows()
    check([row["value"][:3] for row in rows if row["as"] == "response" and row["field"].startswith("register ")] == ["100", "101"],
          "CSV has the values", rows)
    decoded = [row for row in tool.run("--csv", "decode", rows[0]["bytes"]).rows() if row["as"] == "request"]
    check([(row["at"], row["field"], row["value"]) for row in rows if row["as"] == "request"][1:] ==
          [(row["at"], row["field"], row["value"]) for row in decoded], "a request is shown as decode shows it", (rows, decoded))
    table = tool.run(*QUIET, "-u", FIRST, "ask", "03", "00000002").table()
    check(["1", "request", "0", "3D", "03", "00", "00", "00", "02"] == table[0][:9], "a table has the frame first", table)
    rows = tool.run("--no-listen", "-u", 7, "-d", "atv320", "--json", "ask", "03", "0C820001", port="sim:atv320:7").objects()
    check(any("RFR" in row["field"] for row in rows if row["as"] == "response"), "a drive's registers are named", rows)


def check_failures(tool, check):
    ended, _, response, error = ask(tool, check, FIRST, ["03", "03E80001"])
    check(ended.status == DIFFERS and response[:3] == bytes([FIRST, 0x83, 2]) and "exception 0x02" in error, "an exception", ended)
    ended, request, response, error = ask(tool, check, NOBODY, ["03", "00000001"])
    check(ended.status == NO_ANSWER and request and not response and "no response" in error, "silence", ended)
    for beside in ([], NONE):
        ended = tool.run(*QUIET, *beside, "-u", FIRST, "ask", "03", "0000")
        check(ended.status == REFUSED and not ended.output, f"a request that is cut short is not free, {beside}", ended)
    ended, _, response, error = ask(tool, check, FIRST, ["03", "0000"], *NONE, "--allow-run")
    check(ended.status in (DIFFERS, NO_ANSWER) and error, "and is sent with both permissions", ended)
    tool.run(*QUIET, "-u", FIRST, "ask", "07")  # pymodbus has kept the beginning, and takes this for the rest
    for words, says in ((["03", "0C8"], "3 digits"), (["03", "0G"], "hexadecimal"), (["80"], "01 to 7F"), (["00"], "01 to 7F"),
                        (["03", *["00"] * 253], "at most 252"), (["03", "1"], "1 digit"), (["0x"], "hexadecimal"),
                        ([with_crc(bytes([FIRST, 3, 0, 0, 0, 1])).hex(" ")], "03 00 00 00 01")):
        ended = tool.run(*QUIET, "-u", FIRST, "ask", *words)
        check(ended.status == USAGE and says in ended.errors and not ended.output, f"{words[:3]} is refused", ended)
    ended = tool.run(*QUIET, "-u", FIRST, "ask", "43", "0E0100")
    check(ended.status == REFUSED and "function 43 (0x2B), encapsulated interface transport, is typed 2B" in ended.errors, "a decimal number is hinted at", ended)


# Requests that may change something, to whom they are meant as frames of their own.
NOT_FREE = ("3e0600050007", "3e1000050001020007", "00050001ff00", "3e1509060004000000010006", "3e4101", "3e0800010000", "3e0800040000",
            "3e2b0d0000006040", "3e16000500ff0007", "f70600050007", "3e170000000100050001020007", "3e0f000a00020103")


def check_frames_within(tool, check):
    """The bytes on the line hold no frame of another kind, at whatever byte, its CRC among the data or that of the whole frame."""
    for inner in map(bytes.fromhex, NOT_FREE):
        for words in (["08", "0000A5A5", with_crc(inner).hex()], ["41", "01", with_crc(inner).hex(), "00"],
                      ["14", "00", with_crc(inner).hex()]):
            ended = tool.run(*QUIET, *NONE, "--allow-run", "-u", FIRST, "ask", *words)
            check(ended.status == REFUSED and "whole frame" in ended.errors and not ended.output, f"{words}: a frame within", ended)
    # 05 08 00 00 D6 3F brings a CRC back to its beginning, so that the CRC of the whole frame is that of its rest.
    for rest in ("070621350006", "070800010000", "07410102"):
        sent = with_crc(bytes.fromhex("05080000d63f" + rest))
        check(crc(sent[6:]) == 0, "its rest is a whole frame", sent)
        ended = tool.run(*QUIET, "-u", 5, "ask", "08", "0000D63F", rest)
        check(ended.status == REFUSED and sent[6:].hex(" ").upper() in ended.errors, f"{rest}: its CRC is the outer one's", ended)
    ended = tool.run(*QUIET, *NONE, "-u", FIRST, "write", "0:u64=0x050621350006127E")
    check(ended.status == REFUSED and "whole frame" in ended.errors and not ended.output, "a value that is a frame", ended)
    ended = tool.run("--no-listen", "-u", 7, "-d", "atv320", "ask", "08", "0000", with_crc(bytes([SECOND, 3, 0, 0, 0, 1])).hex(),
                     port="sim:atv320:7")
    check(ended.status == REFUSED and "whole frame" in ended.errors, "a loopback holds not even one that only reads", ended)


def check_writes(tool, check):
    """A unit that says that it is no drive: one permission; what came of it stands there, and in the log."""
    for words in (["06", "00050007"], ["05", "0001FF00"], ["10", "00060001020008"], ["16", "0007FF0F00A0"], ["41", "0102"],
                  ["17", "0000000100080001020009"], ["08", "00010000"], ["0F", "000A00020103"]):
        ended = tool.run(*QUIET, "-u", FIRST, "ask", *words)
        check(ended.status == REFUSED and "--write" in ended.errors and not ended.output, f"{words} without --write", ended)
        ended = tool.run(*QUIET, *NONE, "ask", *words)
        check(ended.status == USAGE and "which unit?" in ended.errors, f"{words} without a unit", ended)
    for words, wanted in ((["06", "00050007"], "0600050007"), (["05", "0001FF00"], "050001ff00"), (["10", "00060001020008"], "1000060001"),
                          (["16", "0007FF0F00A0"], "160007ff0f00a0"), (["17", "0000000100080001020009"], "17020064"),
                          (["0F", "000A00020103"], "0f000a0002"), (["41", "0102"], "41" + b"sum 3".hex())):
        ended, _, response, error = ask(tool, check, FIRST, words, *NONE)
        check(ended.status == DONE and response[:-2].hex() == f"{FIRST:02x}{wanted}" and not error, f"{words} is answered", ended)
    held = [row["raw"] for row in tool.run(*QUIET, "-u", FIRST, "--json", "read", "5-8", "coil:1", "coil:10-11").objects()]
    check(held == [7, 8, 107 & 0xFF0F | 0xA0, 9, 1, 1, 1], "and stands there", held)
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
    check(f"\t{FIRST}\task 06 00 05 00 07\tunknown\tanswered" in log and "\t5\tunknown\t7 was sent" in log, "and is noted", log)
    for words, says in ((["06", "000500"], "nobody knows what a unit writes"), (["10", "0006000202000800"], "nobody knows"),
                        (["05", "00010001"], "nobody knows")):
        ended = tool.run(*QUIET, *NONE, "-u", FIRST, "ask", *words)
        check(ended.status == USAGE and says in ended.errors, f"{words} is refused before a frame leaves", ended)
    shown = tool.on_terminal(*QUIET, *NONE, "-u", FIRST, "ask", "06", "00050009", keys=[("send? (y/n)", "n\n")])
    check(shown.status == REFUSED and "5 = 9" in shown.output, "somebody is asked", shown)
    held = tool.run(*QUIET, "-u", FIRST, "--json", "read", "5").objects()[0]["raw"]
    check(held == 7, "and says no", held)


def check_masks(tool, check):
    """A mask is a write of the bits that it changes: what a register file has a name for is refused, as 06 is."""
    (tool.place / "own.toml").write_text("""
[[register]]
name = "mover"
address = 43
access = "write"
moves = true
[[register]]
name = "setpoint"
address = 40
access = "write"
max = 95
[[register]]
name = "status"
address = 44
[[register]]
name = "mode"
address = 45
bits = "4-7"
choices = { off = 0, heat = 1 }
""")
    said = [*QUIET, "--name", f"m={FIRST}:own.toml", "-u", "m", "--write", "--allow-run"]
    held = [row["raw"] for row in tool.run(*QUIET, "-u", FIRST, "--json", "read", "40-45").objects()]
    for words in (["06", "002B0001"], ["16", "002B00000001"], ["16", "002BFFFE0001"], ["16", "002800007FFF"], ["16", "002C0000FFFF"],
                  ["16", "002CFFFF0100"], ["16", "002DFF0F0090"], ["16", "002DFFEF0000"], ["16", "002BFFFF0001"]):
        ended = tool.run(*said, "ask", *words)
        is_told = "own.toml" in ended.errors and ("is read only" in ended.errors or "form and limits" in ended.errors)
        check(ended.status == USAGE and is_told and not ended.output, f"{words} is refused", ended)
    ended = tool.run(*said, "ask", "16", "002BFFFF0000")
    check(ended.status == USAGE and "no bit" in ended.errors, "a mask that changes nothing", ended)
    ended, *_ = ask(tool, check, FIRST, ["16", "002DFEF5000A"], "--name", f"m={FIRST}:own.toml", "--write")
    now = [row["raw"] for row in tool.run(*QUIET, "-u", FIRST, "--json", "read", "40-45").objects()]
    check(ended.status == DONE and now == [*held[:5], held[5] & 0xFEF5 | 0x000A], "bits without a name are changed", (ended, held, now))
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
    check(all(f"\t{each} was sent" in log for each in ("45.1\tunknown\t1", "45.3\tunknown\t1", "45.8\tunknown\t0")), "and noted", log)
    with Units({7: {3201: 0, 8501: 0, 40: 5}}) as line:
        ended = tool.run("--no-listen", "-u", 7, *NONE, "--allow-run", "ask", "16", "002800000006", port=line.name)
        check(ended.status == REFUSED and "may be a drive" in ended.errors and all(each[1] in (3, 43) for each in line.requests),
              "a unit that has the words of a drive takes none", (ended, line.requests))


def check_broadcast(tool, check):
    to_all = [*QUIET, "-u", 0]
    for words, beside, status, says in (
            (["06", "00140005"], [], REFUSED, "--write"), (["06", "00140005"], ["--write"], REFUSED, "--allow-run"),
            (["03", "00000001"], [], USAGE, "nobody answers"), (["41", "0102"], ["--write", "--allow-run"], USAGE, "nobody answers"),
            (["17", "0000000100080001020009"], ["--write", "--allow-run"], USAGE, "nobody answers"),
            (["06", "2135000F"], ["--write", "--allow-run"], REFUSED, "CMD"),
            (["10", "2134000204000000" + "0F"], ["--write", "--allow-run"], REFUSED, "CMD"),
            (["16", "2135000F000F"], ["--write", "--allow-run"], REFUSED, "CMD"),
            (["06", "0190000F"], ["--write", "--allow-run"], REFUSED, "atv28"),
            (["15", "0906000421350001000F"], ["--write", "--allow-run"], REFUSED, "CMD"),
            (["15", "09060004"], ["--write", "--allow-run"], REFUSED, "specification")):
        ended = tool.run(*to_all, *beside, "ask", *words)
        check(ended.status == status and says in ended.errors and not ended.output, f"{words} to all with {beside}", ended)
    # The objects of CiA 402: its command, its mode, its targets of speed, torque, position and velocity.
    for target in (0x6040, 0x6042, 0x6060, 0x6071, 0x607A, 0x60FF):
        before, at = f"{target - 1:04X}", f"{target:04X}"
        for words in (["05", at + "FF00"], ["06", at + "000F"], ["0F", before + "00020103"], ["10", before + "00020400000006"],
                      ["16", at + "FFF0000F"]):
            ended = tool.run(*to_all, "--write", "--allow-run", "ask", *words)
            check(ended.status == REFUSED and "CiA 402" in ended.errors and not ended.output, f"{words} to all", ended)
    ended = tool.run(*to_all, "--write", "--allow-run", "--json", "ask", "06", "00140005")
    request, response, _ = frames_of(ended.objects(), check, "a broadcast")
    check(ended.status == DONE and request[:-2].hex() == "000600140005" and response is None and "nobody answers" in ended.errors,
          "a broadcast is sent, and it is said that nobody answers", ended)
    held = [tool.run(*QUIET, "-u", unit, "--json", "read", "20").objects()[0]["raw"] for unit in (FIRST, SECOND)]
    check(held == [5, 5], "all have it", held)


def check_unnamed(tool, check, others, server):
    """A server of libmodbus has no function 2B: it may be a drive, so that writing takes both permissions."""
    near, tool.port = others.line()
    others.serve(near, [server, "@"], stderr=subprocess.DEVNULL)
    how = ["--listen", "0.05", "--json"]
    ended = tool.run(*how, "ask", "03", "00640002")
    _, response, _ = frames_of(ended.objects(), check, "libmodbus")
    check(ended.status == DONE and response[:-2].hex() == "0103040064" + "0065", "libmodbus answers", ended)
    for words in (["06", "00640007"], ["41", "0102"], ["08", "00040000"], ["2B", "0D0102"]):
        ended = tool.run(*how, *NONE, "-u", 1, "ask", *words)
        check(ended.status == REFUSED and "--allow-run" in ended.errors and not ended.output, f"{words} needs both", ended)
    ended = tool.run(*how, *NONE, "--allow-run", "-u", 1, "ask", "06", "00640007")
    check(ended.status == DONE, "both are enough", ended)
    ended = tool.run(*how, *NONE, "--allow-run", "-u", 1, "ask", "41", "0102")
    check(ended.status in (DIFFERS, NO_ANSWER), "a function that it lacks", ended)
    check(tool.run(*how, "read", "100").objects()[0]["raw"] == 7, "and stands there")


# All of them command a motor, or a drive's settings; by any function.
NEVER = [["06", "2135000F"], ["06", "2136 01F4"], ["10", "21350001020006"], ["10", "2134000204000000" + "06"],
         ["17", "0C8100012135000102000F"], ["16", "2135FFFF000F"], ["06", "219A0032"], ["06", "1F420001"], ["06", "21380001"], ["06", "31D9000F"],
         ["16", "0BB8FFFF0001"], ["2B", "0D00006040"]]


def check_drive(tool, check):
    """Nothing reaches a drive by ask that write refuses, and nothing else without --allow-run."""
    with Simulator(tool.program, "atv320:7") as device:
        tool.port = device
        words = ["--no-listen", "-u", 7, "--json", "read", "8501", "8502", "8602", "3201", "3202"]
        held = [row["raw"] for row in tool.run(*words).objects()]
        for never in NEVER:
            for said in ([], ["-d", "atv320"], ["-d", "none"]):
                ended = tool.run("--no-listen", "-u", 7, *said, "--write", "--allow-run", "ask", *never)
                check(ended.status in (REFUSED, USAGE) and not ended.output, f"{never} {said} is refused", ended)
        for sent in (["06", "23290003"], ["41", "0102"], ["08", "00040000"], ["15", "07060001000000010001"]):
            ended = tool.run("--no-listen", "-u", 7, "--write", "ask", *sent)
            check(ended.status == REFUSED and "--allow-run" in ended.errors, f"{sent} needs --allow-run", ended)
        ended = tool.run("--no-listen", "-u", 7, "--write", "--allow-run", "--json", "ask", "06", "2329000D")
        check(ended.status == DONE, "a ramp is written", ended)
        ended = tool.run("--no-listen", "-u", 7, "--write", "--allow-run", "ask", "06", "0C20FFFF")
        check(ended.status == USAGE and "HSP takes" in ended.errors, "its limits count", ended)
        ended = tool.run("--no-listen", "-u", 7, "--write", "--allow-run", "--json", "ask", "41", "0102")
        check(ended.status == DIFFERS and "exception 0x01" in ended.output, "a function that it lacks", ended)
        now = [row["raw"] for row in tool.run(*words).objects()]
        check(now == held, "its words are as they were", (held, now))


def check_once(tool, check):
    """What may change something is sent once, whatever --retries says."""
    class Deaf(Units):
        def answer(self, request):
            return None if request[1] == OWN_FUNCTION else super().answer(request)

        def next_request(self):
            if len(self.waiting) > 1 and self.waiting[1] == OWN_FUNCTION:
                request, self.waiting = self.waiting, b""
                return request
            return super().next_request()

    with Deaf({7: {0: 1}}) as line:
        ended = tool.run("--no-listen", "--timeout", 0.2, "--retries", 3, "-u", 7, *NONE, "--allow-run", "--json", "ask", "41", "01",
                         port=line.name)
        sent = [each for each in line.requests if each[1] == OWN_FUNCTION]
        check(ended.status == NO_ANSWER and len(sent) == 1, "it is sent once", (ended, sent))
    log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
    check("\task 41 01\tunknown\tno response" in log, "and noted, for nobody knows what came of it", log)


def check_flaws(tool, check):
    """A response that is not what its function has is an error: to 0C fewer bytes than it always has, to 2B 0E another access."""
    class Flawed(Units):
        says = b""

        def next_request(self):
            if len(self.waiting) >= 4 and crc(self.waiting) == 0:
                request, self.waiting = self.waiting, b""
                return request
            return None

        def answer(self, request):
            return with_crc(bytes([7]) + self.says)

    for words, says, status in ((["0C"], "0c020000", DIFFERS), (["0C"], "0c06000000010002", DONE),
                                (["2B", "0E0100"], "2b0e0481000001000141", DIFFERS), (["2B", "0E0100"], "2b0e0181000001000141", DONE)):
        with Flawed({7: {}}) as line:
            line.says = bytes.fromhex(says)
            ended = tool.run("--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, "--json", "ask", *words, port=line.name)
            error = [row["value"] for row in ended.objects() if row["field"] == "error"]
            check(ended.status == status and bool(error) == (status == DIFFERS), f"{words} is answered by {says}", ended)


def check_full_disk(tool, check):
    """What was sent is told, though the output takes nothing."""
    for form in ([], ["--json"], ["--csv"]):
        for unit, words, says in ((7, ["06", "00140005"], "unit 7: function 06, write single register: 06 00 14 00 05; 20 = 5 was sent: answered"),
                                  (0, ["06", "00140005"], "all units: function 06, write single register: 06 00 14 00 05 was sent")):
            with Units({7: {20: 1}}) as line, open("/dev/full", "wb") as full:
                process = tool.start("--no-listen", *NONE, "--allow-run", "-u", unit, *form, "ask", *words, port=line.name, stdout=full)
                _, errors = process.communicate(timeout=60)
                sent = [each for each in line.requests if each[1] == 6]
                check(process.returncode == PORT and len(sent) == 1 and says in errors, f"{unit} {form}: told into a full disk", (errors, sent))


def check_log_gone(tool, check):
    """A log that cannot be added to any more when the frame was sent: who was written what is told, and the status says so."""
    log = tool.place / "state" / "rtuwire" / "writes.log"

    class Losing(Units):
        def answer(self, request):
            if request[1] in (5, 6, 0x41):
                log.unlink()
                log.mkdir()
            return super().answer(request) if request[0] else None

    for unit, words, says in ((7, ["06", "00140005"], "unit 7: function 06, write single register: 06 00 14 00 05; 20 = 5 was sent: answered; nothing of it is noted"),
                              (0, ["06", "00140005"], "all units: function 06, write single register: 06 00 14 00 05 was sent: sent to all; nothing of it is noted")):
        with Losing({7: {20: 1}, 0: {20: 1}}) as line:
            ended = tool.run("--no-listen", *NONE, "--allow-run", "-u", unit, "--json", "ask", *words, port=line.name)
            held = line.units[7][20] if unit else line.requests[-1][5]
            check(ended.status == PORT and held == 5 and says in ended.errors and f"{log}: is a directory" in ended.errors and ended.output,
                  f"unit {unit}: a frame that is not noted is told", ended)
        log.rmdir()


def check_echo(tool, check):
    """A line that gives back what is sent: the response to 08, 05 and 06 looks like it, whether anybody is there or not."""
    class Echoing(Units):
        def next_request(self):
            request = super().next_request()
            if request:
                self.say(request)
            return request

    ramp = ["-d", "atv320", "--write", "--allow-run", "06", "23290003"]  # limits are read first: the client knows the echo then
    for units, words, status, says in (({}, ["08", "00001234"], DIFFERS, "echoes"), ({}, ramp, NO_ANSWER, "; the line echoes (say --echo"),
                                       ({7: {}}, ["08", "00001234"], DIFFERS, ""),
                                       ({7: {9001: 30, 9020: 1, 3201: 0}}, ramp, DONE, "")):
        *beside, function, data = words
        with Echoing(units) as line:
            ended = tool.run("--no-listen", "--timeout", 0.2, "--retries", 0, "-u", 7, *beside, "--json", "ask", function, data,
                             port=line.name)
            error = "".join(row["value"] for row in ended.objects() if row["field"] == "error")
            check(ended.status == status and says in error and bool(error) == (status != DONE),
                  f"{words} of {[*units]} on a line that echoes", ended)
            check(status != DONE or line.units[7][9001] == 3, "and is taken by the unit", line.units)
    with Units({7: {40: 1}}) as line:
        line.answer_08 = line.answer
        line.answer = lambda request: request if request[1] == 8 else line.answer_08(request)
        ended = tool.run("--no-listen", "-u", 7, "--json", "ask", "08", "00001234", port=line.name)
        check(ended.status == DONE, "a unit that says it back is none", ended)


def main(check, program, libmodbus_server):
    with Tool(program) as tool, Programs() as others:
        near, tool.port = others.line()
        others.serve(near, [sys.executable, "-B", __file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        for part in (check_free, check_failures, check_frames_within, check_writes, check_masks, check_broadcast):
            part(tool, check)
        check_unnamed(tool, check, others, libmodbus_server)
        check_drive(tool, check)
        check_once(tool, check)
        check_echo(tool, check)
        check_full_disk(tool, check)
        check_log_gone(tool, check)
        check_flaws(tool, check)


if len(sys.argv) > 1 and sys.argv[1] == "--serve":
    asyncio.run(serve(*sys.argv[2:]))
else:
    from support import DIFFERS, DONE, NO_ANSWER, PORT, REFUSED, USAGE, Simulator, Tool, Units, crc, runs, with_crc

    from pair import Programs  # noqa: I100

    runs(main)
