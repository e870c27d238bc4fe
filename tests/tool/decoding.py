# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""decode says what tshark says of ten thousand frames that are right, and ends well with ten thousand that are not.

    python3 decoding.py TOOL
"""
import json
import random
import struct
import subprocess

from support import DIFFERS, DONE, USAGE, Tool, runs, with_crc

COUNT = 10_000
LONG = 100  # s, for that many under the sanitizers on a busy machine
WORDS = {1: "read coils", 2: "read discrete inputs", 3: "read holding registers", 4: "read input registers",
         5: "write single coil", 6: "write single register", 15: "write multiple coils", 16: "write multiple registers",
         22: "mask write register", 23: "read/write multiple registers"}

EXCEPTIONS = {"": "", "1": "illegal function", "2": "illegal data address", "3": "illegal data value",
              "4": "server device failure", "6": "server device busy", "8": "memory parity error",
              "10": "gateway path unavailable", "11": "gateway target failed to respond"}
COUNTS = ("modbus.word_cnt", "modbus.bit_cnt", "modbus.read_word_cnt")
FIELDS = ("mbrtu.unit_id", "modbus.func_code", "modbus.reference_num", "modbus.read_reference_num", *COUNTS,
          "modbus.byte_cnt", "modbus.regval_uint16", "modbus.exception_code", "mbrtu.crc16.status")


def request(chance):
    """A request of a function that tshark dissects field by field: its bytes, start address and quantity."""
    unit, function = chance.randrange(1, 248), chance.choice(list(WORDS))
    start = chance.randrange(60_000)
    if function in (1, 2, 3, 4):
        count = chance.randrange(1, 126)
        body = struct.pack(">HH", start, count)
    elif function in (5, 6):
        count, body = None, struct.pack(">HH", start, chance.choice((0, 0xFF00)))
    elif function == 22:
        count, body = None, struct.pack(">HHH", start, chance.randrange(65_536), chance.randrange(65_536))
    elif function == 15:
        count = chance.randrange(1, 200)
        data = bytes((count + 7) // 8)
        body = struct.pack(">HHB", start, count, len(data)) + data
    elif function == 16:
        count = chance.randrange(1, 100)
        body = struct.pack(">HHB", start, count, 2 * count) + chance.randbytes(2 * count)
    else:
        count = chance.randrange(1, 100)
        body = struct.pack(">HHHHB", start, count, chance.randrange(60_000), 2, 4) + chance.randbytes(4)
    return with_crc(bytes([unit, function]) + body), start, count


def response(chance):
    """A response of such a function: its bytes, its start address or, where it has none, nothing, and a quantity."""
    unit, function = chance.randrange(1, 248), chance.choice(list(WORDS))
    start, count = chance.randrange(60_000), None
    if function in (1, 2, 3, 4, 23):
        start, size = None, 2 * (125 if chance.randrange(100) == 0 else chance.randrange(1, 12))
        body = bytes([size]) + chance.randbytes(size)
    elif function in (5, 6):
        body = struct.pack(">HH", start, chance.choice((0, 0xFF00)))
    elif function == 22:
        body = struct.pack(">HHH", start, chance.randrange(65_536), chance.randrange(65_536))
    else:
        count = chance.randrange(1, 124)
        body = struct.pack(">HH", start, count)
    return with_crc(bytes([unit, function]) + body), start, count


def refusal(chance):
    unit, function = chance.randrange(1, 248), chance.choice(list(WORDS))
    return with_crc(bytes([unit, 0x80 + function, chance.choice((1, 2, 3, 4, 6, 8, 10, 11))])), None, None


def capture(frames, are_requests=True):
    """pcap with each frame as UDP to port 1502 of its unit, or from there."""
    ends = [0x0A0000FE, 50_000], [0x0A000000, 1502]
    out = struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65_535, 228)
    for number, frame in enumerate(frames):
        size = 28 + len(frame)
        (client, client_port), (units, unit_port) = ends
        source, to, *ports = ((client, units + frame[0], client_port, unit_port) if are_requests else
                              (units + frame[0], client, unit_port, client_port))
        packet = struct.pack(">BBHHHBBHII", 0x45, 0, size, 0, 0, 64, 17, 0, source, to)
        packet += struct.pack(">HHHH", *ports, size - 20, 0) + frame
        out += struct.pack("<IIII", number, 0, size, size) + packet
    return out


def dissected(place, frames, are_requests=True):
    file = place / "frames.pcap"
    file.write_bytes(capture(frames, are_requests))
    shown = subprocess.run(["tshark", "-r", file, "-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE", "-T",
                            "fields", *(word for field in FIELDS for word in ("-e", field))],
                           capture_output=True, text=True, check=True)
    return [dict(zip(FIELDS, line.split("\t"))) for line in shown.stdout.splitlines()]


def decoded(tool, frames, but="response"):
    """What the tool says of each frame, read as one or the other: its fields by name."""
    found = tool.run("--json", "decode", "-", given="".join(frame.hex(" ") + "\n" for frame in frames), limit=LONG)
    by_frame = {}
    for line in found.output.splitlines():
        each = json.loads(line)
        if each["as"] != but:
            by_frame.setdefault(each["frame"], {})[each["field"]] = each["value"]
    return found.status, by_frame


def agrees(fields, row, start, count):
    first = row["modbus.read_reference_num"] or row["modbus.reference_num"].split(",")[0]
    told_start = next((value.split()[0] for name, value in fields.items()
                       if name.startswith("first") or name in ("register", "coil")), "")
    told_count = next((int(value) for name, value in fields.items() if name.startswith("quantity")), None)
    counted = {int(each) for field in COUNTS for each in row[field].split(",") if each}
    words = WORDS[int(row["modbus.func_code"])] + (", refused" if row["modbus.exception_code"] else "")
    return (fields["unit"] == row["mbrtu.unit_id"] and fields["function"] == words and
            told_start == first == ("" if start is None else str(start)) and
            (count is None or (told_count == count and count in counted)) and
            fields.get("exception", "") == EXCEPTIONS[row["modbus.exception_code"]] and
            has_right_crc(row) and fields["CRC"] == "right")


def same_answer(fields, row, start, count):
    """Of a response, its byte count and its registers besides; tshark does not look into those of function 23."""
    told = [value for name, value in fields.items() if name.startswith("register no.")]
    shown = row["modbus.regval_uint16"].split(",") if told and row["modbus.func_code"] != "23" else told
    return (agrees(fields, row, start, count) and fields.get("byte count", "") == row["modbus.byte_cnt"] and
            told == shown)


def has_right_crc(row):
    return {"1": True, "0": False}[row["mbrtu.crc16.status"]]


def right_ones(tool, check, make, count, are_requests, agree):
    chance = random.Random(2026)
    made = [make(chance) for _ in range(count)]
    frames = [frame for frame, _, _ in made]
    rows = dissected(tool.place, frames, are_requests)
    status, told = decoded(tool, frames, "response" if are_requests else "request")
    check(status == DONE and len(told) == count == len(rows), "every frame is explained", (status, len(told), len(rows)))
    wrong = [(frame.hex(" "), told.get(i + 1), rows[i]) for i, (frame, start, quantity) in enumerate(made)
             if i + 1 not in told or not agree(told[i + 1], rows[i], start, quantity)]
    check(not wrong, "what it says is what tshark says", wrong[:2])


def damaged_ones(tool, check):
    """One bit each; every other frame has it in its CRC."""
    chance = random.Random(7)
    right = [request(chance)[0] for _ in range(1_000)]
    frames = []
    for number, frame in enumerate(right):
        bad = bytearray(frame)
        bad[chance.randrange(2, len(bad)) if number % 2 else -chance.randrange(1, 3)] ^= 1 << chance.randrange(8)
        frames.append(bytes(bad))
    rows = dissected(tool.place, frames)
    status, told = decoded(tool, frames)
    check(status == DIFFERS and len(told) == len(rows) == len(frames), "damaged frames are explained", (status, len(told)))
    wrong = []
    for number, (frame, row) in enumerate(zip(right, rows)):
        said = told[number + 1].get("CRC", "")
        is_told = said != "right" if number % 2 else said.startswith("wrong, right is " + frame[-2:].hex(" ").upper())
        if not is_told or has_right_crc(row):
            wrong.append((frames[number].hex(" "), told[number + 1], row))
    check(not wrong, "the CRC of a damaged frame is wrong, as tshark says, and the right one is told", wrong[:2])


def random_ones(tool, check):
    chance = random.Random(11)
    frames = [chance.randbytes(chance.randrange(1, 300)) for _ in range(COUNT)]
    found = tool.run("--json", "decode", "-", given="".join(frame.hex() + "\n" for frame in frames), limit=LONG)
    check(found.status == DIFFERS and not found.errors, "ten thousand random runs are explained as far as they go",
          (found.status, found.errors[:200]))
    for line in found.output.splitlines():
        json.loads(line)


def forms_of_hex(tool, check):
    frame = "02 03 0C 1E 00 04 27 6C"
    plain = tool.run("--json", "decode", frame).output
    for text in (frame.lower(), frame.replace(" ", ""), frame.replace(" ", ","), frame.replace(" ", ":"),
                 "0x" + frame.replace(" ", " 0x"), "\\x" + frame.replace(" ", "\\x")):
        found = tool.run("--json", "decode", text)
        check(found.output == plain and found.status == DONE, f"{text!r} is understood", found)
    found = tool.run("decode", "02 03 0G")
    check(found.status == USAGE and "0G" in found.errors, "what is no hex is named", found)
    found = tool.run("decode", "line.pcapng")
    check(found.status == USAGE and "line.pcapng: there are no bytes" in found.errors and "-p line.pcapng" in found.errors,
          "and so is what has no bytes", found)
    pair = (with_crc(bytes.fromhex(each)).hex() for each in ("07 03 0C 82 00 01", "07 03 02 01 F4"))
    named = tool.run("--json", "--drive", "atv320", "decode", *pair)
    told = {each["field"]: each["value"] for each in named.objects()}
    check(named.status == DONE and told.get("first register") == "3202 (RFR)" and
          told.get("register 3202 RFR") == "50.0 Hz", "registers of a drive are named", named)


def main(check, program):
    with Tool(program) as tool:
        for part in (forms_of_hex, damaged_ones, random_ones):
            part(tool, check)
        right_ones(tool, check, request, 6_000, True, agrees)
        right_ones(tool, check, response, 3_500, False, same_answer)
        right_ones(tool, check, refusal, 500, False, same_answer)


runs(main)
