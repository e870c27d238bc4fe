# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`check` against servers: one that keeps to the protocol, and others that differ from it by one defect each, which break the
musts listed beside it and no other. None of them is made of this library.

    python3 checking.py TOOL [DEFECT]
"""
import json
import os
import pathlib
import pty
import select
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tty

UNIT = 17
REGISTERS, INPUTS, COILS, DISCRETES = 200, 100, 64, 64
SCRATCH, COIL_SCRATCH = "192-199", "48-63"

# The musts that a defect breaks: what it does to a client is seen nowhere else.
DEFECTS = {
    "none": "",
    "takes any CRC": "L02 L03 L04 L05 L06 L24 L27 L28 D07",
    "takes a swapped CRC": "L03",
    "answers a broadcast": "L17 L19 X03",
    "answers quantity 0": "F03.1 F03.8",
    "sees the low byte of a quantity": "F03.3 F03.4",
    "sends 126 registers": "F03.2",
    "wraps addresses": "F03.6",
    "has every register": "F03.6",
    "refuses without the high bit": "X04",
    "refuses with 03 for 01": "X01 X02 D04 I10",
    "is silent to unknown functions": "X01 X02",
    "writes a part": "F16.7",
    "reads before it writes": "F23.1",
    "ignores the byte count of 16": "F16.3 F16.4 F16.5 F16.6",
    "confirms a write to nothing": "F06.2",
    "answers 05 with on": "F05.1",
    "takes 1 for on": "F05.2",
    "sets padding bits": "F02.2",
    "exchanges the masks": "F22.1 F22.2",
    "pages without end": "I01 I03",
    "states a wrong length": "I01 I02 I05 I06",
    "ends a frame where its CRC fits": "L35 L36 L37",
    "writes though the read is refused": "F23.2 F23.5",
    "counts only its own messages": "D06",
    "sends a byte more": "F04.2 L44",
}


def crc(data):
    value = 0xFFFF
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ (0xA001 if value & 1 else 0)
    return bytes((value & 0xFF, value >> 8))


class Refused(Exception):
    """With its code."""


def number(data, at):
    return data[at] << 8 | data[at + 1]


class Server:
    """A unit whose frames end by silence."""

    def __init__(self, defect):
        self.defect = defect
        self.holding = [(3 * i + 1) & 0xFFFF for i in range(REGISTERS)]
        self.inputs = [(5 * i + 2) & 0xFFFF for i in range(INPUTS)]
        self.coils = [i % 3 == 0 for i in range(COILS)]
        self.discretes = [i % 5 == 1 for i in range(DISCRETES)]
        self.counts = dict.fromkeys(range(0x0B, 0x10), 0)
        self.is_silenced = False
        self.near, far = pty.openpty()
        tty.setraw(self.near)
        tty.setraw(far)
        self.far = far
        self.device = os.ttyname(far)
        self.asked = []
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        buffer = b""
        while True:
            ready, _, _ = select.select([self.near], [], [], 0.008 if buffer else 1)
            if ready:
                try:
                    buffer += os.read(self.near, 4096)
                except OSError:
                    return
                if self.defect == "ends a frame where its CRC fits":
                    for size in range(4, min(len(buffer), 60)):
                        if crc(buffer[:size - 2]) == buffer[size - 2:size]:
                            self.take(buffer[:size])
                            buffer = b""
                            break
            elif buffer:
                self.take(buffer)
                buffer = b""

    def has_right_crc(self, frame):
        right = crc(frame[:-2])
        return right == frame[-2:] or self.defect == "takes any CRC" or (
            self.defect == "takes a swapped CRC" and right == frame[:-3:-1])

    def take(self, frame):
        self.asked.append(frame)
        if not 4 <= len(frame) <= 256 or not self.has_right_crc(frame):
            self.counts[0x0C] += 1
            return
        own = frame[0] == UNIT
        if self.defect != "counts only its own messages" or own:
            self.counts[0x0B] += 1
        if frame[0] not in (0, UNIT) or frame[1] > 0x7F:
            return
        self.counts[0x0E] += 1
        pdu = frame[1:-2]
        if self.is_silenced and pdu[:3] != bytes((8, 0, 1)):
            return
        try:
            answer = self.answer(pdu)
        except Refused as why:
            code = why.args[0]
            self.counts[0x0D] += 1
            answer = bytes((pdu[0] | (0 if self.defect == "refuses without the high bit" else 0x80), code))
            if code == 1 and self.defect == "refuses with 03 for 01":
                answer = bytes((pdu[0] | 0x80, 3))
        if answer is None or (frame[0] == 0 and self.defect != "answers a broadcast"):
            self.counts[0x0F] += 1
            return
        answer = bytes((UNIT,)) + answer
        tail = b"\0" if self.defect == "sends a byte more" and answer[1] == 4 else b""
        os.write(self.near, answer + crc(answer) + tail)

    def answer(self, pdu):
        function = pdu[0]
        act = {1: self.bits, 2: self.bits, 3: self.words, 4: self.words, 5: self.one_coil, 6: self.one_word,
               8: self.diagnose, 0x0F: self.some_coils, 0x10: self.some_words, 0x16: self.mask, 0x17: self.exchange,
               0x2B: self.identify}.get(function)
        if act is None:
            if self.defect == "is silent to unknown functions":
                return None
            raise Refused(1)
        return act(pdu)

    def quantity(self, pdu, at, most):
        count = number(pdu, at)
        if self.defect == "sees the low byte of a quantity" and pdu[0] == 3:
            count &= 0xFF
        if pdu[0] == 3 and count == 0 and self.defect == "answers quantity 0":
            return 0
        if pdu[0] == 3 and count == 126 and self.defect == "sends 126 registers":
            return count
        if not 1 <= count <= most:
            raise Refused(3)
        return count

    def size(self, pdu, due):
        if len(pdu) != due:
            raise Refused(3)

    def fits(self, first, count, of):
        if first + count > of:
            raise Refused(2)

    def bits(self, pdu):
        self.size(pdu, 5)
        count = self.quantity(pdu, 3, 2000)
        table = self.coils if pdu[0] == 1 else self.discretes
        first = number(pdu, 1)
        self.fits(first, count, len(table))
        data = bytearray((count + 7) // 8)
        for i in range(count):
            data[i // 8] |= table[first + i] << i % 8
        if self.defect == "sets padding bits" and pdu[0] == 2 and count % 8:
            data[-1] |= 0xFF << count % 8 & 0xFF
        return bytes((pdu[0], len(data))) + bytes(data)

    def words(self, pdu):
        self.size(pdu, 5)
        count = self.quantity(pdu, 3, 125)
        return bytes((pdu[0], 2 * count & 0xFF)) + self.read(pdu[0], number(pdu, 1), count)

    def read(self, function, first, count):
        table = self.inputs if function == 4 else self.holding
        if function == 3 and self.defect == "has every register":
            table = table + [0] * (65536 - len(table))
            first &= 0xFFFF
            return b"".join(table[(first + i) & 0xFFFF].to_bytes(2, "big") for i in range(count))
        if function == 3 and self.defect == "wraps addresses" and first + count > 65536:
            return b"".join(table[(first + i) & 0xFFFF & 0x7F].to_bytes(2, "big") for i in range(count))
        self.fits(first, count, len(table))
        return b"".join(each.to_bytes(2, "big") for each in table[first:first + count])

    def one_coil(self, pdu):
        self.size(pdu, 5)
        value = number(pdu, 3)
        is_on = value == 0xFF00 or (value == 1 and self.defect == "takes 1 for on")
        if not is_on and value != 0:
            raise Refused(3)
        self.fits(number(pdu, 1), 1, COILS)
        self.coils[number(pdu, 1)] = is_on
        return pdu[:3] + b"\xFF\0" if self.defect == "answers 05 with on" else pdu

    def one_word(self, pdu):
        self.size(pdu, 5)
        if number(pdu, 1) >= REGISTERS and self.defect == "confirms a write to nothing":
            return pdu
        self.fits(number(pdu, 1), 1, REGISTERS)
        self.holding[number(pdu, 1)] = number(pdu, 3)
        return pdu

    def some_coils(self, pdu):
        if len(pdu) < 6:
            raise Refused(3)
        count = self.quantity(pdu, 3, 1968)
        if pdu[5] != (count + 7) // 8 or len(pdu) != 6 + pdu[5]:
            raise Refused(3)
        first = number(pdu, 1)
        self.fits(first, count, COILS)
        for i in range(count):
            self.coils[first + i] = bool(pdu[6 + i // 8] >> i % 8 & 1)
        return pdu[:5]

    def some_words(self, pdu):
        if len(pdu) < 6:
            raise Refused(3)
        count = self.quantity(pdu, 3, 123)
        if self.defect != "ignores the byte count of 16" and (pdu[5] != 2 * count or len(pdu) != 6 + pdu[5]):
            raise Refused(3)
        data = pdu[6:] + bytes(2 * count)
        first = number(pdu, 1)
        for i in range(count):
            if first + i >= REGISTERS:
                raise Refused(2)
            if self.defect == "writes a part":
                self.holding[first + i] = number(data, 2 * i)
        self.store(first, count, data)
        return pdu[:5]

    def store(self, first, count, data):
        self.fits(first, count, REGISTERS)
        for i in range(count):
            self.holding[first + i] = number(data, 2 * i)

    def mask(self, pdu):
        self.size(pdu, 7)
        at, keep, put = number(pdu, 1), number(pdu, 3), number(pdu, 5)
        self.fits(at, 1, REGISTERS)
        if self.defect == "exchanges the masks":
            keep, put = put, keep
        self.holding[at] = self.holding[at] & keep | put & ~keep & 0xFFFF
        return pdu

    def exchange(self, pdu):
        if len(pdu) < 10:
            raise Refused(3)
        first, to = number(pdu, 1), number(pdu, 5)
        counts_fit = 1 <= number(pdu, 3) <= 125
        count, written = number(pdu, 3), number(pdu, 7)
        if not 1 <= written <= 121 or pdu[9] != 2 * written or len(pdu) != 10 + pdu[9]:
            raise Refused(3)
        if self.defect == "writes though the read is refused" and to + written <= REGISTERS:
            self.store(to, written, pdu[10:])
        if not counts_fit:
            raise Refused(3)
        self.fits(first, count, REGISTERS)
        self.fits(to, written, REGISTERS)
        before = self.read(0x17, first, count)
        self.store(to, written, pdu[10:])
        after = self.read(0x17, first, count)
        return bytes((0x17, 2 * count)) + (before if self.defect == "reads before it writes" else after)

    def diagnose(self, pdu):
        if len(pdu) < 5 or len(pdu) % 2 == 0:
            raise Refused(3)
        sub = number(pdu, 1)
        if sub == 0:
            return pdu
        if sub not in (1, 4, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F):
            raise Refused(1)
        data = number(pdu, 3)
        if len(pdu) != 5 or (data != 0 and not (sub == 1 and data == 0xFF00)):
            raise Refused(3)
        if sub == 1:
            woken, self.is_silenced = self.is_silenced, False
            return None if woken else pdu
        if sub == 4:
            self.is_silenced = True
            return None
        if sub == 0x0A:
            self.counts = dict.fromkeys(self.counts, 0)
            return pdu
        return pdu[:3] + (self.counts[sub] & 0xFFFF).to_bytes(2, "big")

    def identify(self, pdu):
        if pdu[1:2] != b"\x0E":
            raise Refused(1)
        self.size(pdu, 4)
        names = {0: b"Makers", 1: b"M-17", 2: b"V1.0", 3: b"http://maker.example", 4: b"Measuring unit"}
        code, first = pdu[2], pdu[3]
        if code == 4:
            if first not in names:
                raise Refused(2)
            return pdu[:3] + bytes((0x82, 0, 0, 1, first, len(names[first]))) + names[first]
        if not 1 <= code <= 3:
            raise Refused(3)
        last = 2 if code == 1 else 0x7F
        if first not in names or first > last:
            first = 0
        wanted = [each for each in names if first <= each <= last]
        page, rest = wanted[:2], wanted[2:]
        more, following = (0xFF, rest[0]) if rest else (0, 0)
        if self.defect == "pages without end":
            more, following = 0xFF, 0
        objects = b"".join(bytes((each, len(names[each]))) + names[each] for each in page)
        count = len(page) + (1 if self.defect == "states a wrong length" else 0)
        return pdu[:3] + bytes((0x82, more, following, count)) + objects


def run(program, server, *words, timeout=0.15):
    line = [program, "-p", server.device, "-u", str(UNIT), "--timeout", str(timeout), "--no-listen", "--json", "--write",
            "check", *words]
    return subprocess.run(line, text=True, capture_output=True, timeout=280)


def main():
    program = sys.argv[1]
    chosen = sys.argv[2:] or list(DEFECTS)
    failures = []
    lock = threading.Lock()

    def check(ok, what):
        with lock:
            if not ok:
                failures.append(what)
                print("FAILED:", what, flush=True)

    def one(defect):
        server = Server(defect)
        before = (list(server.holding), list(server.coils))
        done = run(program, server, "--only", "L,F,X,I,D", "--scratch", SCRATCH, "--scratch-coils", COIL_SCRATCH, "--alone",
                   "--disruptive")
        rows = [json.loads(each) for each in done.stdout.splitlines()]
        fails = sorted(each["clause"] for each in rows if each["verdict"] == "fails" and each["level"] == "must")
        due = sorted(DEFECTS[defect].split())
        reasons = {each["clause"]: each["why"] for each in rows if each["verdict"] == "fails"}
        odd = {each["clause"]: each["why"] for each in rows if each["verdict"] == "not tried"}
        check(fails == due, f"{defect}: {fails} instead of {due}: {reasons} {done.stderr[-300:]}")
        check(done.returncode == (1 if due else 0), f"{defect}: status {done.returncode}: {done.stderr[-300:]}")
        check(len(rows) > 120, f"{defect}: {len(rows)} clauses")
        check((server.holding, server.coils) == before, f"{defect}: the scratch places were not put back")
        if defect == "none":
            not_tried = set(odd) - {"L25", "L26", "L29", "L41", "L23", "L35", "L36", "L37"}
            check(not not_tried, f"not tried: {odd}")

    threads = [threading.Thread(target=one, args=(each,)) for each in chosen]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    print(f"{len(chosen)} servers, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
