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
WORDS = {1: "read coils", 2: "read discrete inputs", 3: "read holding registers", 4: "read input registers",
         5: "write single coil", 6: "write single register", 15: "write multiple coils", 16: "write multiple registers",
         22: "mask write register", 23: "read/write multiple registers"}


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


def capture(frames):
    """pcap with each frame as UDP to port 1502 of its unit."""
    out = struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65_535, 228)
    for number, frame in enumerate(frames):
        size = 28 + len(frame)
        packet = struct.pack(">BBHHHBBHII", 0x45, 0, size, 0, 0, 64, 17, 0, 0x0A0000FE, 0x0A000000 + frame[0])
        packet += struct.pack(">HHHH", 50_000, 1502, size - 20, 0) + frame
        out += struct.pack("<IIII", number, 0, size, size) + packet
    return out


def dissected(place, frames):
    file = place / "frames.pcap"
    file.write_bytes(capture(frames))
    fields = ("mbrtu.unit_id", "modbus.func_code", "modbus.reference_num", "modbus.read_reference_num", "modbus.word_cnt",
              "modbus.bit_cnt", "modbus.read_word_cnt", "mbrtu.crc16.status")
    shown = subprocess.run(["tshark", "-r", file, "-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE", "-T",
                            "fields", *(word for field in fields for word in ("-e", field))],
                           capture_output=True, text=True, check=True)
    return [line.split("\t") for line in shown.stdout.splitlines()]


def decoded(tool, frames):
    """What the tool says of each frame, read as a request: its fields by name."""
    found = tool.run("--json", "decode", "-", given="".join(frame.hex(" ") + "\n" for frame in frames))
    by_frame = {}
    for line in found.output.splitlines():
        each = json.loads(line)
        if each["as"] != "response":
            by_frame.setdefault(each["frame"], {})[each["field"]] = each["value"]
    return found.status, by_frame


def agrees(fields, row, start, count):
    unit, function, reference, read_reference, *counts, _ = row
    told_start = next((int(value.split()[0]) for name, value in fields.items()
                       if name.startswith("first") or name in ("register", "coil")), None)
    told_count = next((int(value) for name, value in fields.items() if name.startswith("quantity")), None)
    counted = {int(each) for each in ",".join(counts).split(",") if each}
    return (fields["unit"] == unit and fields["function"] == WORDS[int(function)] and
            told_start == int((read_reference or reference).split(",")[0]) == start and
            (count is None or (told_count == count and count in counted)))


def right_ones(tool, check):
    chance = random.Random(2026)
    made = [request(chance) for _ in range(COUNT)]
    frames = [frame for frame, _, _ in made]
    rows = dissected(tool.place, frames)
    status, told = decoded(tool, frames)
    check(status == DONE and len(told) == COUNT == len(rows), "every frame is explained", (status, len(told), len(rows)))
    wrong = [(frame.hex(" "), told.get(i + 1), rows[i]) for i, (frame, start, count) in enumerate(made)
             if i + 1 not in told or not agrees(told[i + 1], rows[i], start, count)]
    check(not wrong, "unit, function, address and quantity are those of tshark", wrong[:2])


def damaged_ones(tool, check):
    chance = random.Random(7)
    frames = []
    for _ in range(100):
        frame = bytearray(request(chance)[0])
        frame[chance.randrange(2, len(frame))] ^= 1 << chance.randrange(8)
        frames.append(bytes(frame))
    rows = dissected(tool.place, frames)
    wrong = []
    for frame, row in zip(frames, rows):
        found = tool.run("--json", "decode", frame.hex())
        says = "wrong" if '"wrong, right is ' in found.output or found.status == DIFFERS else "right"
        if found.status != DIFFERS or says != "wrong" or row[-1] not in ("0", "Bad"):
            wrong.append((frame.hex(), found, row))
    check(not wrong, "a damaged frame is told, as tshark tells it", wrong[:2])


def random_ones(tool, check):
    chance = random.Random(11)
    frames = [chance.randbytes(chance.randrange(1, 300)) for _ in range(COUNT)]
    found = tool.run("--json", "decode", "-", given="".join(frame.hex() + "\n" for frame in frames))
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
    named = tool.run("--drive", "atv320", "decode", "07 03 0C 82 00 01 27 CE", "07 03 02 01 F4 30 53")
    check("RFR" in named.output, "registers of a drive are named", named)


def main(check, program):
    with Tool(program) as tool:
        for part in (forms_of_hex, right_ones, damaged_ones, random_ones):
            part(tool, check)


if __name__ == "__main__":
    runs(main)
