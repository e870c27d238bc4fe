# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`serve`: one line for many clients. Units of this test's own, servers of libmodbus and simulated drives are on the line; the clients
are plain sockets. What depends on an order is held until it has come about: no part waits for a time that a busy machine would change.

    python3 serving.py TOOL clients|gate|limits|port|words|fair|drives
    python3 serving.py TOOL crowd COUNT [unmeasured]
    python3 serving.py TOOL turns [COUNT [SEED]]
    python3 serving.py TOOL libmodbus MEMORY_LIBMODBUS
"""
import json
import os
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

from support import DIFFERS, DONE, HERE, LIMIT, PORT, REFUSED, USAGE, Line, Simulator, Tool, runs, soon, with_crc

from field_units import OnTcp  # noqa: I100
from pair import Programs, free_port  # noqa: I100
from served import (FIRST, LAST, Asker, PlainUnits, RtuAsker, Served, header, http, message, read_of,  # noqa: I100
                    requests_in, value_of)
from simulator import Registers  # noqa: I100

PATIENT = ("--timeout", 10, "--retries", 0)  # for what answers
SHORT = ("--timeout", 0.2, "--retries", 0)  # for what stays silent
METRICS = ("--metrics", "127.0.0.1:0")
BUSY, NO_PATH, SILENT = 6, 10, 11  # exceptions


def tells(served, word):
    """Whether an event with this word in it comes."""
    return soon(lambda: any(word in json.dumps(each) for each in served.events()), 20)


def is_right(unit, address, count, values):
    return values == [value_of(unit, address + i) for i in range(count)]


# Who asked gets the answer.

def ask_much(client, seed, count, units, wrong):
    drawn = random.Random(seed)
    for i in range(count):
        unit, address, size = drawn.choice(units), drawn.randrange(FIRST, LAST - 20), drawn.randrange(1, 20)
        # All clients use the same numbers.
        pdu = client.ask(unit, read_of(address, size), i + 1)
        values = [int.from_bytes(pdu[at:at + 2], "big") for at in range(2, len(pdu), 2)]
        if pdu[0] != 3 or not is_right(unit, address, size, values):
            wrong.append((seed, unit, address, size, pdu.hex()))


def own_answers(check, program):
    units = [1, 2, 9, 247]
    with PlainUnits(*units) as line, \
            Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1-9,247",
                   line=PATIENT) as served:
        clients = [Asker(served.number) for _ in range(6)] + [RtuAsker(served.ports["tcp"][0]) for _ in range(2)]
        wrong = []
        threads = [threading.Thread(target=ask_much, args=(client, seed, 60, units, wrong)) for seed, client in enumerate(clients)]
        for each in threads:
            each.start()
        for each in threads:
            each.join(120)
        check(not wrong and not any(each.is_alive() for each in threads), "eight clients with the same numbers get their own values", wrong[:3])
        check(line.is_whole(), "and nothing but whole frames is on the line")
        client, rtu = clients[0], clients[-1]
        check(client.ask(1, read_of(LAST + 1))[:2] == b"\x83\2", "a unit's exception comes as it is")
        check(rtu.ask(1, read_of(LAST + 1))[:2] == b"\x83\2", "over RTU, too")
        # In one lump, in pieces, and one behind half of the next.
        client.socket.sendall(b"".join(message(100 + i, 2, read_of(FIRST + i)) for i in range(10)))
        found = [client.answer() for _ in range(10)]
        check(sorted(each[0] for each in found) == list(range(100, 110)) and all(
            each[1:] == (2, b"\3\2" + value_of(2, FIRST + each[0] - 100).to_bytes(2, "big")) for each in found),
            "ten requests in one lump get ten answers", found)
        check(is_right(2, FIRST, 125, client.read(2, FIRST, 125)), "the longest answer")
        client.socket.sendall(message(5, 1, read_of(FIRST)) + message(5, 1, read_of(FIRST)))
        check([client.answer()[0] for _ in range(2)] == [5, 5], "one number twice: two answers")
        for byte in message(7, 9, read_of(FIRST)):
            client.socket.sendall(bytes([byte]))
        check(client.answer() == (7, 9, b"\3\2" + value_of(9, FIRST).to_bytes(2, "big")), "a request in single bytes")
        both = message(0xFFFF, 1, read_of(FIRST)) + message(0, 1, read_of(FIRST + 1))
        client.socket.sendall(both[:17])
        first = client.answer()
        client.socket.sendall(both[17:])
        check((first[0], client.answer()[0]) == (0xFFFF, 0), "one, and half of the next")
        # RTU over TCP: a frame that is damaged gets no answer.
        frame = with_crc(bytes([1]) + read_of(FIRST))
        asked = len(line.asked(unit=1))
        rtu.socket.sendall(frame[:-1] + bytes([frame[-1] ^ 1]))
        again = RtuAsker(served.ports["tcp"][0])
        check(is_right(1, FIRST + 5, 1, again.read(1, FIRST + 5)) and len(line.asked(unit=1)) == asked + 1,
              "a damaged frame goes nowhere, and harms no other client")
        for each in [*clients, again]:
            each.close()


def no_answers(check, program):
    with PlainUnits(1, silent=(5,)) as line, \
            Served(program, line.name, "--units", "1,5", "--json", *METRICS, line=SHORT) as served, Asker(served.number) as client:
        check(client.ask(5, read_of(FIRST)) == bytes([0x83, SILENT]), "a silent unit: 0B")
        check(client.ask(6, read_of(FIRST)) == bytes([0x83, NO_PATH]), "a unit that is not named: 0A")
        check(client.ask(255, read_of(FIRST)) == bytes([0x83, NO_PATH]), "one that nobody can have: 0A")
        check(not line.asked(unit=6) and not line.asked(unit=255), "and nothing of these is on the line", line.requests)
        check(is_right(1, FIRST, 1, client.read(1, FIRST)), "the other one answers")
        it = served.metrics()
        check(it.total("rtuwire_serve_silences_total", unit=5) >= 1 and not it.total("rtuwire_serve_silences_total", unit=1),
              "silences are counted", it.text)
        check(it.total("rtuwire_serve_exceptions_total", unit=5) >= 1, "and exceptions", it.text)
        check(tells(served, "silent"), "silence is told", served.events())


def late_answers(check, program):
    """A unit that answers in order, every second time later than the time-out."""
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", line=("--timeout", 0.1, "--retries", 0)) as served:
        wrong, counts = [], []
        line.before_answer = lambda request: time.sleep(0.14 if len(line.requests) % 2 else 0)

        def asks(seed):
            with Asker(served.number) as client:
                right = 0
                for i in range(6):
                    address = FIRST + 10 * i + seed
                    values = client.read(1, address)
                    right += isinstance(values, list)
                    if isinstance(values, list) and not is_right(1, address, 1, values):
                        wrong.append((address, values))
                counts.append(right)
        threads = [threading.Thread(target=asks, args=(seed,)) for seed in range(3)]
        for each in threads:
            each.start()
        for each in threads:
            each.join(120)
        check(not wrong and len(counts) == 3, "no late answer is another client's", wrong)
        print("     right values of 6 each:", counts)


class Converter(PlainUnits):
    """What answers reads (03) by and by, so long after each, and all else at once: in another order than it was asked."""

    def __init__(self, *units, late):
        super().__init__(*units)
        self.late, self.timers = late, []

    def __exit__(self, *how):
        for each in self.timers:
            each.join()
        super().__exit__(*how)

    def hear(self, data):
        Line.hear(self, data)
        self.waiting += data
        requests, self.waiting = requests_in(self.waiting)
        for request in requests:
            self.requests.append(request)
            answer = with_crc(request[:1] + self.answer(request[0], request[1:-2]))
            if request[1] == 3:
                self.timers.append(threading.Timer(self.late, self.say, [answer]))
                self.timers[-1].start()
            else:
                self.say(answer)


def answers_out_of_order(check, program):
    for late in (0.35, 0.8):
        with Converter(1, late=late) as line, Served(program, line.name, "--units", "1", line=("--timeout", 0.1, "--retries", 0)) as served:
            wrong = []

            def asks(seed):
                with Asker(served.number) as client:
                    for i in range(2):
                        address = FIRST + 10 * i + seed
                        values = client.read(1, address)
                        if isinstance(values, list) and not is_right(1, address, 1, values):
                            wrong.append((address, values))
            threads = [threading.Thread(target=asks, args=(seed,)) for seed in range(3)]
            for each in threads:
                each.start()
            for each in threads:
                each.join(120)
            check(not wrong and len(line.reads()) == 6, f"no answer out of order, {late} s late, is another client's", (wrong, line.reads()))


def who_leaves(check, program):
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", "--json", line=PATIENT) as served, \
            Asker(served.number) as stays:
        stays.read(1, FIRST)
        line.hold()
        leaves = Asker(served.number)
        for i in range(8):
            leaves.send(1, read_of(FIRST + 100 + i))
        check(soon(lambda: (1, FIRST + 100) in line.reads()), "the first of eight is on the line")
        leaves.close()
        check(tells(served, "disconnect"), "its end is told", served.events())
        number = stays.send(1, read_of(FIRST + 7))
        line.release_all()
        check(stays.answer() == (number, 1, b"\3\2" + value_of(1, FIRST + 7).to_bytes(2, "big")), "who stays gets its own answer")
        check([address for _, address in line.reads() if address >= FIRST + 100] == [FIRST + 100],
              "what waited for the client that left is never asked", line.reads())


def clients(check, program):
    for part in (own_answers, no_answers, late_answers, answers_out_of_order, who_leaves):
        part(check, program)


def libmodbus(check, program, memory):
    """A server that nobody here wrote, on a line of two pseudo-terminals."""
    with Programs() as others:
        near, far = others.line()
        server = others.serve(near, [memory, "@", "100", "50"], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)

        def told(words):
            server.stdin.write(words + "\n")
            server.stdin.flush()
            return server.stdout.readline().strip()
        told("set holding 100 1234 0007 ffff")
        with Served(program, far, "--units", "1-2", "--write", line=("-b", 115200, "-f", "8N1", "--timeout", 2, "--retries", 0)) as served, \
                Asker(served.number) as one, Asker(served.number) as other:
            check(one.read(1, 100, 3) == [0x1234, 7, 0xFFFF] and other.read(1, 102) == [0xFFFF], "its registers are read by two")
            check(one.read(1, 149, 2) == -2, "its exception is handed on")
            check(other.ask(1, bytes.fromhex("060066 00ab")) == bytes.fromhex("06006600ab") and told("get holding 102 1") == "00ab",
                  "a register is written")
            check(one.ask(1, bytes.fromhex("10006700020400010002"))[:5] == bytes.fromhex("1000670002") and
                  told("get holding 103 2") == "0001 0002", "two are")
            check(other.ask(1, bytes.fromhex("17006400010068000102beef")) == bytes.fromhex("17021234") and
                  told("get holding 104 1") == "beef", "function 23")
            check(one.ask(1, bytes.fromhex("050064ff00"))[0] == 5 and told("get coil 100 1") == "0001", "a coil")


# What may pass.

READS = {1: "0010 0001", 2: "0010 0001", 3: "03e8 0001", 4: "03e8 0001", 7: "", 8: "0000 1234", 11: "", 12: "", 17: "", 20: "07 06 0001 0000 0001",
         24: "03e8", 43: "0e 01 00"}
WRITES = {5: "0010 ff00", 6: "03e8 0001", 15: "0010 0001 01 01", 16: "03e8 0001 02 0001", 21: "09 06 0001 0000 0001 0001",
          22: "03e8 ffff 0001", 23: "03e8 0001 03e8 0001 02 0001"}
FORBIDDEN = (400, 401, 8501, 8502, 8503, 8504, 8601, 8602)


def read_only(check, program):
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", *METRICS, line=PATIENT) as served, \
            Asker(served.number) as client:
        def passes(pdu):
            """What it is answered, and what of it came to the unit."""
            before = len(line.requests)
            answer = client.ask(1, pdu)
            return answer, [each for each in line.requests[before:] if each[1:-2] == pdu]
        for function, data in READS.items():
            pdu = bytes([function]) + bytes.fromhex(data)
            answer, came = passes(pdu)
            check(len(came) == 1 and answer[0] & 0x7F == function, f"function {function} reads", (answer, came))
        refused = [bytes([function]) + bytes.fromhex(data) for function, data in WRITES.items()]
        refused += [bytes([8]) + sub.to_bytes(2, "big") + bytes(2) for sub in (1, 2, 3, 4, 10, 11, 18, 20, 21, 255, 256, 65535)]
        refused += [bytes([function]) + bytes(4) for function in range(128) if function not in READS and function not in WRITES]
        refused += [bytes.fromhex("2b0d0000"), bytes.fromhex("2bff0100"), bytes([8]), bytes([8, 0]), bytes([43])]
        for pdu in refused:
            before = len(line.requests)
            answer = client.ask(1, pdu)
            check(answer[0] == pdu[0] | 0x80 and len(answer) == 2 and line.requests[before:] == [],
                  f"refused, and not on the line: {pdu.hex(' ')}", (answer, line.requests[before:]))
            if pdu[0] in WRITES:
                check(answer[1] == 1, f"by exception 01: {pdu.hex(' ')}", answer)
        it = served.metrics()
        check(it.total("rtuwire_serve_refused_total") >= len(WRITES), "and counted", it.text)
        # No code of a function is above 7F. An answer or none: nothing reaches the unit.
        before = len(line.requests)
        for function in (0x80, 0x83, 0x90, 0xFF):
            with Asker(served.number) as each:
                each.send(1, bytes([function]) + bytes(4))
        check(is_right(1, FIRST, 1, client.read(1, FIRST)), "the next request passes")
        check([each[1] for each in line.requests[before:]] == [3], "codes of exceptions are no requests", line.requests[before:])


def broadcasts(check, program):
    for words in ((), ("--write",), ("--units", "1", "--write")):
        with PlainUnits(1) as line, Served(program, line.name, *words, line=PATIENT) as served:
            for pdu in (read_of(FIRST), bytes.fromhex("0603e80001"), bytes.fromhex("1003e80001020001"), bytes.fromhex("0621350000")):
                # Whether it is answered is nobody's promise.
                with Asker(served.number) as client:
                    client.send(0, pdu)
                    client.send(1, read_of(FIRST))
                    soon(lambda: client.answer()[1] == 1, LIMIT)
            check(all(each[0] != 0 for each in line.requests) and line.requests, f"{words}: nothing goes to all units", line.requests)
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", "--write", "--allow-broadcast", line=PATIENT) as served, \
            Asker(served.number) as client:
        client.send(0, bytes.fromhex("0603e80001"))
        check(soon(lambda: with_crc(bytes.fromhex("000603e80001")) in line.requests), "with --allow-broadcast it does", line.requests)
        client.send(0, bytes.fromhex("062135000f"))  # CMD: a motor of whoever is there
        client.send(0, bytes.fromhex("100190000102000f"))
        client.send(0, bytes.fromhex("0603e80002"))
        check(soon(lambda: with_crc(bytes.fromhex("000603e80002")) in line.requests), "and the next", line.requests)
        check(all(each[2:4] == b"\x03\xe8" for each in line.requests if each[0] == 0), "but no control word without --allow-run", line.requests)


def writes(check, program):
    """Unit 1 says who it is, and is no drive; unit 2 says nothing of itself, and has none of the registers that tell drives."""
    with PlainUnits(1, 2, nameless=(2,)) as line, Served(program, line.name, "--units", "1-2", "--write", line=PATIENT) as served, \
            Asker(served.number) as client:
        for function, data in WRITES.items():
            pdu = bytes([function]) + bytes.fromhex(data)
            answer = client.ask(1, pdu)
            check(with_crc(b"\1" + pdu) in line.requests, f"function {function} is written", (answer, line.asked()))
        check(client.ask(2, bytes([6]) + struct.pack(">HH", FIRST, 5))[0] == 6, "what is elsewhere is written to a unit that says nothing of itself, too")
        longest = bytes([16]) + struct.pack(">HHB", FIRST, 123, 246) + bytes(246)
        check(client.ask(1, longest) == longest[:5] and with_crc(b"\1" + longest) in line.requests, "the longest write")
        for place in FORBIDDEN:
            for pdu in (bytes([6]) + struct.pack(">HH", place, 15), bytes([16]) + struct.pack(">HHBH", place, 1, 2, 15),
                        bytes([16]) + struct.pack(">HHB3H", place - 2, 3, 6, 0, 0, 15), bytes([16]) + struct.pack(">HHB3H", place, 3, 6, 15, 0, 0),
                        bytes([22]) + struct.pack(">HHH", place, 0xFFFF, 15),
                        bytes([23]) + struct.pack(">HHHHBH", FIRST, 1, place, 1, 2, 15),
                        bytes([23]) + struct.pack(">HHHHB4H", FIRST, 1, place - 3, 4, 8, 0, 0, 0, 15)):
                before = len(line.requests)
                answer = client.ask(2, pdu)
                check(answer[0] == pdu[0] | 0x80 and not [each for each in line.requests[before:] if each[1:-2] == pdu],
                      f"no control word to who may be a drive: {pdu.hex(' ')}", (answer, line.requests[before:]))
        # What contradicts itself must not carry more than was judged.
        for pdu in (bytes([16]) + struct.pack(">HHB4H", 8498, 1, 8, 0, 0, 0, 15), bytes([16]) + struct.pack(">HHBH", 8501, 0, 2, 15),
                    bytes([16]) + struct.pack(">HHBH", 8490, 20, 2, 15), bytes([16]) + struct.pack(">HHB", FIRST, 124, 246) + bytes(246),
                    bytes([6]) + struct.pack(">HHH", FIRST, 1, 0x2135), bytes([6, 3]), bytes([16]), bytes([23]) + struct.pack(">HH", FIRST, 1),
                    bytes([15]) + struct.pack(">HHB", 16, 1, 9)):
            before = len(line.requests)
            answer = client.ask(1, pdu)
            came = line.requests[before:]
            check(answer[0] == pdu[0] | 0x80 and not came, f"what contradicts itself is refused: {pdu.hex(' ')}", (answer, came))


def by_words(check, program):
    with PlainUnits(1) as line, \
            Served(program, line.name, "--units", "1", "--functions", "3,6", "--write", line=PATIENT) as served, Asker(served.number) as client:
        check(is_right(1, FIRST, 1, client.read(1, FIRST)), "a function that is named")
        before = len(line.requests)
        for pdu in (read_of(FIRST, 1, 4), bytes([16]) + struct.pack(">HHBH", FIRST, 1, 2, 5), bytes.fromhex("0800001234")):
            check(client.ask(1, pdu) == bytes([pdu[0] | 0x80, 1]), f"01 to function {pdu[0]}, which is not")
        check(line.requests[before:] == [], "and nothing on the line", line.requests[before:])
        check(client.ask(1, bytes([6]) + struct.pack(">HH", FIRST, 5))[0] == 6, "a write that is named and allowed")
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", "--functions", "6", line=PATIENT) as served, \
            Asker(served.number) as client:
        check(client.ask(1, bytes([6]) + struct.pack(">HH", FIRST, 5)) == b"\x86\1" and not line.asked(6),
              "--functions allows no write by itself")
    with PlainUnits(1) as line, \
            Served(program, line.name, "--units", "1", "--from", "127.0.0.2", "--from", "127.0.1.0/24", "--json", *METRICS,
                   line=PATIENT) as served:
        for source in ("127.0.0.2", "127.0.1.77"):
            with Asker(served.number, source) as client:
                check(is_right(1, FIRST, 1, client.read(1, FIRST)), f"from {source}, which is named")
        for source in ("127.0.0.1", "127.0.0.3", "127.0.2.1"):
            before = len(line.requests)
            with Asker(served.number, source) as client:
                try:
                    client.send(1, read_of(FIRST))
                except ConnectionError:
                    pass
                check(client.has_ended(), f"from {source}, which is not: the connection is closed")
            check(line.requests[before:] == [], "and nothing on the line")
        it = served.metrics()
        check(it.total("rtuwire_serve_refused_total") >= 3, "that is counted", it.text)
        check(tells(served, "127.0.0.3"), "and told, with the address", served.events())


class Exchanged(PlainUnits):
    """A unit that is a meter until `is_drive`; then a drive, which answers all that a meter does."""

    is_drive = False

    def answer(self, unit, pdu):
        if self.is_drive and pdu[:2] == b"\x2b\x0e":
            return bytes.fromhex("2b0e010100000300") + b"\x12Schneider Electric" + b"\1\x0cATV320U07M2B" + b"\2\0040201"
        return super().answer(unit, pdu)


def command(word):
    return bytes([6]) + struct.pack(">HH", 8501, word)


def exchanged(check, program):
    """A drive in a meter's place, without a silence that anybody saw, gets no command word."""
    free = bytes([6]) + struct.pack(">HH", FIRST, 5)
    for way in ("pause", "asked", "lost"):
        with Exchanged(1) as line, Served(program, line.name, "--units", "1", "--write", line=("--timeout", 0.5, "--retries", 1)) as served, \
                Asker(served.number) as client:
            check(client.ask(1, free) == free, f"{way}: the meter is written to")
            line.is_drive = True
            if way == "pause":
                time.sleep(1.1)
            elif way == "asked":
                check(b"ATV320" in client.ask(1, bytes.fromhex("2b0e0100")), "a client asks who it is")
            else:
                line.silent = {1}
                line.before_answer = None
                lost = len(line.requests)
                client.send(1, read_of(FIRST))
                soon(lambda: len(line.requests) > lost)
                line.silent = set()
                check(client.answer()[2][0] == 3, "its repetition is answered")
            check(client.ask(1, command(6)) == b"\x86\1", f"{way}: 01 to a command word", way)
            check(not [each for each in line.asked(6) if each[2:4] == b"\x21\x35"], f"{way}: and no frame", line.asked(6))


def mute(check, program):
    """A unit that is silent to function 43 is asked who it is once, and costs one time-out."""
    with PlainUnits(1, 2, mute=(1,)) as line, \
            Served(program, line.name, "--units", "1-2", "--write", line=("--timeout", 0.3, "--retries", 1)) as served, Asker(served.number) as client:
        free = bytes([6]) + struct.pack(">HH", FIRST, 5)
        check(client.ask(1, free) == free, "what is elsewhere is written")
        check(len([each for each in line.requests if each[1] == 43]) == 1, "it was asked once who it is", [each.hex() for each in line.requests])
        check(client.ask(1, command(6)) == b"\x86\1", "and may be a drive")
        before = len([each for each in line.requests if each[1] == 43])
        check(client.ask(2, command(6)) == command(6), "the other one says that it is none")
        check(len([each for each in line.requests[before:] if each[1] == 43 and each[0] == 2]) >= 1, "when it is asked")


def noted(check, program):
    """Each write is a row of writes.log, with who sent it; what cannot be noted is not written."""
    with PlainUnits(1, silent=(2,)) as line, \
            Served(program, line.name, "--units", "1-3", "--write", "--allow-broadcast", line=SHORT) as served, Asker(served.number) as client:
        client.read(1, FIRST)
        client.ask(1, command(6))  # of what says that it is a meter
        client.ask(1, bytes([16]) + struct.pack(">HHB2H", FIRST, 2, 4, 5, 6))
        client.ask(1, bytes([21]) + bytes.fromhex(WRITES[21]))
        client.ask(1, bytes([6]) + struct.pack(">HHH", FIRST, 1, 1))  # refused
        client.ask(3, command(6))  # nobody there
        client.send(0, bytes.fromhex("0603e80001"))
        client.read(1, FIRST)
        me = "127.0.0.1:" + str(client.socket.getsockname()[1])
        rows = served.noted()
        check([each[2:5] for each in rows] == [[line.name, unit, what] for unit, what in (
            ("1", "8501"), ("1", str(FIRST)), ("1", str(FIRST + 1)), ("1", "serve 15 09 06 00 01 00 00 00 01 00 01"), ("0", "serve 06 03 E8 00 01"))],
            "each value that was sent is a row, and what was refused none", rows)
        check(all(each[6].endswith(f"sent by {me}") or f"sent by {me}: " in each[6] for each in rows) and rows[0][6].startswith("6 was sent by"),
              "with who sent it", rows)
        check("exception 01" in rows[3][6] or "illegal function" in rows[3][6], "and what the unit answered, where it refused", rows)
        # Where nothing can be noted, nothing is written.
        log = os.path.join(served.folder.name, "rtuwire", "writes.log")
        os.remove(log)
        os.mkdir(log)
        before = len(line.requests)
        check(client.ask(1, command(7)) == b"\x86\4", "04 where nothing can be noted")
        check(not [each for each in line.requests[before:] if each[1] == 6], "and nothing on the line", line.requests[before:])
        check(soon(lambda: [each for each in served.lines["stderr"] if "writes.log" in each], 20), "that is told", served.lines["stderr"])
    with PlainUnits(1) as line, Tool(program) as tool:
        (tool.place / "state" / "rtuwire" / "writes.log").mkdir(parents=True)
        ended = tool.run("serve", "--units", "1", "--write", "--listen", "mbap://127.0.0.1:0", "--for", "0.1s", port=line.name)
        check(ended.status == PORT and "writes.log" in ended.errors, "nor does it begin", ended)
        ended = tool.run("serve", "--units", "1", "--listen", "mbap://127.0.0.1:0", "--for", "0.1s", port=line.name)
        check(ended.status == DONE, "without --write it does", ended)


def carried(check, program):
    """A loopback that carries a frame, of whatever function and for whatever unit."""
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", line=PATIENT) as served, Asker(served.number) as client:
        inner = with_crc(bytes([7]) + command(15))
        behind = [bytes([8, 0, 0]) + inner, bytes([8, 0, 0, 0]) + inner * 4 + b"\0"]
        # Public ones, reads among them, in another form than their own, of a maker, and what is no function; to all, units and reserved.
        for each in ("07030000 0001", "0707", "f80800010000", "07100000", "0712", "0741ffff", "075a0002", "0064", "078006", "07ff0001", "0700", "ff0600000001"):
            behind += [bytes([8, 0, 0]) + filler + with_crc(bytes.fromhex(each)) for filler in (b"", b"\xaa", bytes(100))]
        # 01 08 00 00 and this bring a CRC back to its beginning: the CRC of the whole is that of its rest.
        back = next(each for each in (bytes(divmod(word, 256)) for word in range(0x10000)) if with_crc(bytes([1, 8, 0, 0]) + each)[-2:] == b"\xff\xff")
        behind += [bytes([8, 0, 0]) + back + bytes.fromhex("0741ffff")]
        for pdu in (each if len(each) % 2 == 1 else each + b"\0" for each in behind):  # two bytes make a word
            check(client.ask(1, pdu) == b"\x88\1", "01 to a loopback with a frame in it", pdu.hex(" "))
        check(not line.asked(8), "and nothing on the line", line.asked(8))
        for pdu in (bytes.fromhex("0800001234"), bytes([8, 0, 0]) + bytes(200)):
            check(client.ask(1, pdu) == pdu, "another loopback passes", pdu.hex(" "))


def unknown(check, program):
    """What a function does that nobody knows, even a unit that says who it is, is not tried out; nor a file's limits guessed."""
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", "--write", line=PATIENT) as served, Asker(served.number) as client:
        for pdu in ("4100", "0800010000", "0800040000", "2b0d0100"):
            check(client.ask(1, bytes.fromhex(pdu))[1:] == b"\1", f"01 to {pdu}")
        check(not line.asked(0x41) and not line.asked(8), "and no frame", line.requests)
    with Tool(program) as tool:
        (tool.place / "fan.toml").write_text("[[register]]\nname = \"fan\"\naddress = 42\naccess = \"write\"\nmoves = true\n")
        ended = tool.run("--name", "x=1:fan.toml", "--write", "serve", "--listen", "mbap://127.0.0.1:0", port="sim:atv320:1")
        check(ended.status == USAGE and "fan.toml" in ended.errors, "a register file and --write", ended)


def gate(check, program):
    for part in (read_only, broadcasts, writes, by_words, exchanged, mute, noted, carried, unknown):
        part(check, program)


# Limits.

class HeldBack:
    """with HeldBack() as server: unit 1 behind RTU over TCP, where register N holds N. Its connection lets a response wait until the one
    before is confirmed, as TCP does that nobody tells otherwise. `server.late` seconds late is the next one alone."""

    def __enter__(self):
        self.late, self.listening = 0, socket.create_server(("127.0.0.1", 0))
        self.number = self.listening.getsockname()[1]
        self.thread = threading.Thread(target=self.serve)
        self.thread.start()
        return self

    def serve(self):
        connection, _ = self.listening.accept()
        while data := connection.recv(300):
            pdu = data[1:-2]
            values = b"".join(struct.pack(">H", struct.unpack(">H", pdu[1:3])[0] + i) for i in range(pdu[4]))
            response = with_crc(bytes([1, 3, len(values)]) + values if pdu[0] == 3 else bytes([1, pdu[0] | 0x80, 1]))
            late, self.late = self.late, 0
            if late:
                threading.Timer(late, connection.sendall, (response,)).start()
            else:
                connection.sendall(response)
        connection.close()

    def __exit__(self, *_):
        self.thread.join(LIMIT)
        self.listening.close()


def late(check, program):
    """Behind one response that comes too late no other does."""
    with HeldBack() as server, Served(program, f"tcp://127.0.0.1:{server.number}", "--units", "1", line=("--timeout", 0.3, "--retries", 1)) as served, \
            Asker(served.number) as client:
        check(client.read(1, 5) == [5], "it answers")
        for seconds in (1.6, 2.2):
            server.late, wrong, end = seconds, [], time.monotonic() + seconds + 1
            while time.monotonic() < end:
                for register in range(0, 50, 7):
                    values = client.read(1, register)
                    if isinstance(values, list) and values != [register]:
                        wrong.append((register, values))
                    time.sleep(0.01)
            check(len(wrong) <= 1, f"{seconds} s late: the late one at most is another's", wrong)


def too_many(check, program):
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", *METRICS, line=PATIENT) as served:
        held = [Asker(served.number) for _ in range(32)]
        check(all(is_right(1, FIRST + i, 1, each.read(1, FIRST + i)) for i, each in enumerate(held)), "32 clients are served")
        with Asker(served.number) as more:
            try:
                more.send(1, read_of(FIRST))
            except ConnectionError:
                pass
            check(more.has_ended(), "the next one's connection is closed")
        check(is_right(1, FIRST, 1, held[31].read(1, FIRST)), "the others stay")
        it = served.metrics()
        check(it.total("rtuwire_serve_clients") == 32 and it.total("rtuwire_serve_refused_total") >= 1, "both are counted", it.text)
        held.pop().close()

        def comes_in():
            with Asker(served.number) as client:
                try:
                    client.send(1, read_of(FIRST))
                    return client.answer() is not None
                except ConnectionError:
                    return False
        check(soon(comes_in, 20), "a place that is free again is another's")
        for each in held:
            each.close()
        check(soon(lambda: served.metrics().total("rtuwire_serve_clients") == 0, 20), "and all leave")


def full_queue(check, program):
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", *METRICS, line=("--timeout", 30, "--retries", 0)) as served, \
            Asker(served.number) as greedy, Asker(served.number) as other:
        other.read(1, FIRST)
        line.hold()
        for i in range(40):
            greedy.send(1, read_of(FIRST + i), i)
        # What finds no place is answered while the line is held: 16 wait, one may be on the line.
        refused = [greedy.answer() for _ in range(40 - 17)]
        check(all(each[1:] == (1, bytes([0x83, BUSY])) for each in refused), "what finds no place is answered 06 at once", refused)
        number = other.send(1, read_of(FIRST + 50))
        line.release_all()
        check(other.answer() == (number, 1, b"\3\2" + value_of(1, FIRST + 50).to_bytes(2, "big")), "another client's queue has room")
        rest = [greedy.answer() for _ in range(17)]
        right = [each for each in rest if each[2] == b"\3\2" + value_of(1, FIRST + each[0]).to_bytes(2, "big")]
        check(sorted(each[0] for each in refused + rest) == list(range(40)), "each request has one answer")
        check(len(right) in (16, 17), "and 16 have waited", len(right))
        it = served.metrics()
        check(it.total("rtuwire_serve_refused_total") + it.total("rtuwire_serve_exceptions_total", code=6) +
              it.total("rtuwire_serve_exceptions_total", code="06") >= 23, "that is counted", it.text)


def too_old(check, program):
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", line=("--timeout", 30, "--retries", 0)) as served, \
            Asker(served.number) as first, Asker(served.number) as second:
        first.read(1, FIRST)
        line.hold()
        first.send(1, read_of(FIRST + 1))
        check(soon(lambda: (1, FIRST + 1) in line.reads()), "one is on the line")
        began = time.monotonic()
        second.send(1, read_of(FIRST + 2))
        found = second.answer()
        took = time.monotonic() - began
        check(found[1:] == (1, bytes([0x83, BUSY])) and took > 4.9, "one that waits for too long is answered 06, not before 5 s", (found, took))
        line.release_all()
        check(first.answer()[2][0] == 3, "who was on the line gets its answer")
        check((1, FIRST + 2) not in line.reads(), "and the old one is not asked any more", line.reads())


def write_of(address, value):
    return bytes([6]) + struct.pack(">HH", address, value)


def written(line):
    """What the writes on the line were, in their order."""
    return [int.from_bytes(each[2:4], "big") for each in line.asked(6)]


def in_order(check, program):
    """Of writes that a client sends one behind the other none is done behind one that was refused as too old."""
    long = ("--timeout", 30, "--retries", 0)
    with PlainUnits(1) as line, \
            Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1", "--write", line=long) as served, \
            Asker(served.number) as holder, Asker(served.number) as client, RtuAsker(served.ports["tcp"][0]) as rtu:
        check(client.ask(1, write_of(FIRST, 1))[0] == 6, "a write")
        line.hold()
        holder.send(1, read_of(FIRST + 1))
        check(soon(lambda: (1, FIRST + 1) in line.reads()), "the line is held")
        client.send(1, write_of(FIRST + 10, 1), 10)
        # RTU frames have no number: both are there before the first is answered.
        rtu.socket.sendall(with_crc(b"\1" + write_of(FIRST + 20, 1)) + with_crc(b"\1" + write_of(FIRST + 21, 1)))
        time.sleep(4)
        client.send(1, write_of(FIRST + 11, 1), 11)
        client.send(1, read_of(FIRST + 12), 12)
        found = [client.answer()]
        refused = [rtu.answer()[2]]
        line.release_all()
        found += [client.answer() for _ in range(2)]
        check(found == [(10, 1, b"\x86\6"), (11, 1, b"\x86\6"), (12, 1, b"\x83\6")], "what stands behind one that is too old is answered 06 with it",
              found)
        refused.append(rtu.answer()[2])
        check(refused == [b"\x86\6"] * 2, "RTU frames, too", refused)
        check(holder.answer()[2][0] == 3, "the line goes on")
        check(client.ask(1, write_of(FIRST + 13, 1))[0] == 6 and rtu.ask(1, write_of(FIRST + 23, 1))[0] == 6, "what is sent behind these answers is done")
        check(written(line) == [FIRST, FIRST + 13, FIRST + 23], "and nothing else", written(line))


def in_order_behind_full(check, program):
    """Nor behind one that found no place."""
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", "--write", line=("--timeout", 30, "--retries", 0)) as served, \
            Asker(served.number) as client:
        client.read(1, FIRST)
        line.hold()
        client.send(1, read_of(FIRST + 1))
        check(soon(lambda: (1, FIRST + 1) in line.reads()), "the line is held")
        for i in range(20):
            client.send(1, write_of(FIRST + 10 + i, 1), 100 + i)
        refused = [client.answer() for _ in range(4)]
        check([each[0] for each in refused] == [116, 117, 118, 119] and all(each[2] == b"\x86\6" for each in refused), "four find no place", refused)
        # A place is free as soon as the first is on the line; those before still wait.
        line.before_answer = lambda request: len(line.asked(6)) == 2 and soon(lambda: has_sent)
        has_sent = []
        line.release_all()
        client.answer()
        client.answer()
        client.send(1, write_of(FIRST + 50, 1), 200)
        has_sent.append(True)
        rest = [client.answer() for _ in range(16)]
        check(dict((each[0], each[2]) for each in rest)[200] == b"\x86\6", "one behind them is refused while they wait", rest)
        check(client.ask(1, write_of(FIRST + 51, 1))[0] == 6, "and taken once none waits")
        check(written(line) == [FIRST + 10 + i for i in range(16)] + [FIRST + 51], "in their order", written(line))


def idle(check, program):
    """Who asks nothing is hung up on; who waits for an answer is not idle."""
    with PlainUnits(1) as line, \
            Served(program, line.name, "--units", "1", "--idle", "1s", "--json", line=("--timeout", 30, "--retries", 0)) as served, \
            Asker(served.number) as waits:
        waits.read(1, FIRST)
        line.hold()
        waits.send(1, read_of(FIRST + 1))
        check(soon(lambda: (1, FIRST + 1) in line.reads()), "one waits for its answer")
        began = time.monotonic()
        with Asker(served.number) as sleeps:
            check(sleeps.has_ended() and time.monotonic() - began > 0.9, "one that asks nothing is hung up on, not before its time")
        check(tells(served, "asked nothing for 1 s"), "that is told", served.events())
        check(not [each for each in served.events() if each["event"] == "disconnect" and str(waits.socket.getsockname()[1]) in each["client"]],
              "and not of the one that waits", served.events())
        line.release_all()
        check(waits.answer()[2][0] == 3, "which gets its answer")
        check(waits.has_ended(), "and is hung up on when it asks no more")
    with PlainUnits(1) as line, Tool(program) as tool:
        for said in ("0s", "soon", ""):
            ended = tool.run("serve", "--idle", said, "--listen", "mbap://127.0.0.1:0", "--for", "0.1s", port=line.name)
            check(ended.status == USAGE and "--idle" in ended.errors, f"no time to be idle: '{said}'", ended)


def halves(check, program):
    with PlainUnits(1) as line, \
            Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1", line=PATIENT) as served:
        parts = ((served.number, b"\0\1\0\0"), (served.number, message(1, 1, read_of(FIRST))[:-1]),
                 (served.ports["tcp"][0], with_crc(b"\1" + read_of(FIRST))[:5]))
        slow = RtuAsker(served.ports["tcp"][0])
        frame = with_crc(b"\1" + read_of(FIRST + 1))
        slow.socket.sendall(frame[:4])
        results = []

        def sends(number, data):
            with Asker(number) as client:
                began = time.monotonic()
                client.socket.sendall(data)
                results.append((number, data, client.has_ended(), time.monotonic() - began))
        threads = [threading.Thread(target=sends, args=each) for each in parts]
        for each in threads:
            each.start()
        idle = Asker(served.number)
        time.sleep(1.5)  # a segment that was lost comes again later than that
        slow.socket.sendall(frame[4:])
        check(slow.answer() == (0, 1, b"\3\2" + value_of(1, FIRST + 1).to_bytes(2, "big")), "its other half may come seconds later, over RTU, too")
        slow.close()
        for each in threads:
            each.join()
        for number, data, has_ended, took in results:
            check(has_ended and took > 9.9, f"half a request is waited for 10 s: {data.hex(' ')}", took)
        check(is_right(1, FIRST, 1, idle.read(1, FIRST)), "who sends nothing at all stays for longer")
        check(line.reads() == [(1, FIRST + 1), (1, FIRST)], "no half went to the unit", line.reads())
        idle.close()


def no_modbus(check, program):
    with PlainUnits(1) as line, \
            Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1", line=PATIENT) as served, \
            Asker(served.number) as client:
        for data in (header(1, 6, 1) + b"\1" + read_of(FIRST), header(1, 0), header(1, 1) + b"\1", header(1, 255) + bytes(255),
                     header(1, 65535) + bytes(600), b"GET /metrics HTTP/1.1\r\n\r\n", with_crc(b"\1" + read_of(FIRST)) * 3):
            with Asker(served.number) as each:
                each.socket.sendall(data)
                check(each.has_ended() if data[2:4] != b"\0\0" or int.from_bytes(data[4:6], "big") not in (1,) else True,
                      f"what is no Modbus TCP ends the connection: {data[:10].hex(' ')}")
        for data in (message(1, 1, read_of(FIRST)), b"GET / HTTP/1.1\r\n\r\n", bytes(300), b"\xff" * 300):
            with RtuAsker(served.ports["tcp"][0]) as each:
                each.socket.sendall(data)
        check(is_right(1, FIRST, 1, client.read(1, FIRST)) and line.reads() == [(1, FIRST)], "and nothing of it reaches the unit", line.requests)


def other_protocol(check, program):
    """A client that is set up for the other port is told so, once for each connection."""
    def told(served, word):
        return [each for each in served.events() if each["event"] == "refused" and each["kind"] == "protocol" and word in each["text"]]
    with PlainUnits(1) as line, \
            Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1", "--json", *METRICS,
                   line=PATIENT) as served:
        mbap, rtu = served.number, served.ports["tcp"][0]
        with Asker(mbap) as client:
            client.socket.sendall(with_crc(b"\1" + read_of(FIRST)))
            check(client.has_ended(), "RTU frames at the port of Modbus TCP: the connection is closed")
        check(soon(lambda: told(served, "sends RTU frames")), "and it is said what it sends", served.events())
        check(len(told(served, f"tcp://127.0.0.1:{rtu}")) == 1, "and where that is taken", served.events())
        with RtuAsker(rtu) as client:
            for i in range(3):
                client.socket.sendall(message(i, 1, read_of(FIRST)))
                check(soon(lambda n=i: served.metrics().total("rtuwire_serve_refused_total", why="damaged") > n, 20), "Modbus TCP at the port of RTU frames")
            check(is_right(1, FIRST, 1, client.read(1, FIRST)), "which stays open")
        check(len(told(served, "sends Modbus TCP")) == 1 and told(served, "sends Modbus TCP")[0]["text"].endswith(f"mbap://127.0.0.1:{mbap}"),
              "is said once, with where that is taken", served.events())
        check(served.metrics().total("rtuwire_serve_refused_total", why="protocol") == 2, "both are counted", served.metrics().text)
        said = [each for each in served.lines["stderr"] if " sends " in each]
        check(len(said) == 2, "and in words", served.lines["stderr"])
    # The line's own port.
    with PlainUnits(1) as line, Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1",
                                       line=PATIENT) as upstream:
        for port, right in ((f"tcp://127.0.0.1:{upstream.number}", "mbap://127.0.0.1"), (f"mbap://127.0.0.1:{upstream.ports['tcp'][0]}", "tcp://127.0.0.1")):
            with Served(program, port, "--units", "1", "--json", line=SHORT) as served, Asker(served.number) as client:
                check(client.ask(1, read_of(FIRST)) == bytes([0x83, SILENT]), f"{port}: of the other protocol")
                check(soon(lambda: [each for each in served.events() if each["event"] in ("silent", "port_lost") and right in each["text"]], 20),
                      "is said, with the word for it", served.events())
                check(soon(lambda: [each for each in served.lines["stderr"] if right in each], 20), "to people as well", served.lines["stderr"])


class HangingUp(OnTcp):
    """A server of Modbus TCP that hangs up on each request, until it `answers`."""

    def __init__(self):
        self.answers, self.once, self.connections = False, False, 0
        super().__init__("mbap")

    def talk(self, line):
        self.connections += 1
        while (data := line.recv(512)) and self.answers:
            line.sendall(message(int.from_bytes(data[:2], "big"), data[6], b"\3\2" + value_of(data[6], FIRST).to_bytes(2, "big")))
            if self.once:
                return


def hung_up_on(check, program):
    """It is told once, and once when it answers: not as often as it is tried."""
    with HangingUp() as server, Served(program, server.name, "--units", "1", "--json", *METRICS, line=SHORT) as served, Asker(served.number) as client:
        def told_of_port():
            return [each["event"] for each in served.events() if each["event"].startswith("port_")]

        def losses():
            return client.ask(1, read_of(FIRST)) == bytes([0x83, SILENT]) and served.metrics().total("rtuwire_serve_port_losses_total")
        check(soon(lambda: losses() >= 4, LIMIT) and server.connections >= 4, "it hangs up again and again", server.connections)
        check(told_of_port() == ["port_lost"], "that is told once", served.events())
        check(len([each for each in served.lines["stderr"] if "connection is gone" in each]) == 1, "to people as well", served.lines["stderr"])
        server.answers = True
        check(soon(lambda: client.read(1, FIRST) == [value_of(1, FIRST)], LIMIT), "it answers")
        check(soon(lambda: told_of_port() == ["port_lost", "port_opened"], LIMIT), "that is told, once", served.events())
        server.once = True
        before = server.connections
        check(soon(lambda: isinstance(client.read(1, FIRST), list) and server.connections >= before + 3, LIMIT) and
              told_of_port() == ["port_lost", "port_opened"], "one that hangs up behind each answer is no news", served.events())
        server.answers = False
        check(soon(lambda: client.read(1, FIRST) == -SILENT and told_of_port().count("port_lost") == 2, LIMIT), "and the next time anew", served.events())


def at_once(check, program, parts):
    """Side by side: they wait."""
    failed = []

    def does(part):
        try:
            part(check, program)
        except Exception as error:  # noqa: B902  told by the check below
            failed.append((part.__name__, repr(error)))
    threads = [threading.Thread(target=does, args=(part,)) for part in parts]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    check(not failed, "all parts came to their end", failed)


def limits(check, program):
    at_once(check, program, (too_many, full_queue, too_old, in_order, in_order_behind_full, idle, halves, late, no_modbus, other_protocol, hung_up_on))


# The port, the figures, the end.

def point(link, device):
    fresh = str(link) + ".new"
    os.symlink(device, fresh)
    os.replace(fresh, link)


def port_goes(check, program):
    with Tool(program) as tool:
        link = tool.place / "adapter"
        first = PlainUnits(1)
        with first:
            point(link, first.name)
            served = Served(program, str(link), "--units", "1", "--json", *METRICS, line=SHORT)
            served.__enter__()
            client = Asker(served.number)
            check(is_right(1, FIRST, 1, client.read(1, FIRST)), "the port is there")
            check(served.metrics().total("rtuwire_serve_port_up") == 1, "and told to be up")
            os.remove(link)  # before its number is that of another test
        # Its two ends are closed.
        check(soon(lambda: client.ask(1, read_of(FIRST)) == bytes([0x83, SILENT]), 20), "behind a port that is away: 0B")
        check(soon(lambda: served.metrics().total("rtuwire_serve_port_up") == 0, 20), "it is told to be down")
        check(tells(served, "lost"), "that is an event", served.events())
        with PlainUnits(1) as second:
            point(link, second.name)
            check(soon(lambda: is_right(1, FIRST + 1, 1, client.read(1, FIRST + 1)), 60), "it is opened again, and the same client is answered")
            check(served.metrics().total("rtuwire_serve_port_up") == 1, "and it is up")
            check(tells(served, "opened"), "that is an event, too", served.events())
            told = [line for line in served.lines["stderr"] if str(link) in line]
            check(told, "people are told which port", served.lines["stderr"])
            check(served.ended(signal.SIGTERM) == DONE, "it ends well")
        client.close()
        served.__exit__()


def port_is_late(check, program):
    """A port that is not there yet at the start is an error with its name, at once."""
    with Tool(program) as tool:
        ended = tool.run("serve", "--listen", "mbap://127.0.0.1:0", port=str(tool.place / "none"))
        check(ended.status == PORT and "none" in ended.errors, "a port that is not there", ended)


def figures(check, program):
    with PlainUnits(1, 2, silent=(5,)) as line, Served(program, line.name, "--units", "1-5", "--json", *METRICS, line=SHORT) as served:
        number = served.ports["http"][0]
        answer = http(number, "GET /metrics HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n")
        head = answer.partition("\r\n\r\n")[0]
        check(head.startswith("HTTP/1.") and " 200 " in head.splitlines()[0] and "version=0.0.4" in head and "text/plain" in head,
              "it says its form", head)
        check(" 404" in http(number, "GET /other HTTP/1.0\r\n\r\n").splitlines()[0], "another path is not found")
        check(http(number, "POST /metrics HTTP/1.0\r\nContent-Length: 0\r\n\r\n").splitlines()[0].split()[1] in ("404", "405"), "a post is refused")
        before = served.metrics()
        with Asker(served.number) as one, Asker(served.number) as two:
            for i in range(7):
                one.read(1, FIRST + i)
            for i in range(3):
                two.ask(2, read_of(FIRST, 1, 4))
            two.read(1, LAST + 1)
            two.read(5, FIRST)
            now = served.metrics()
            check(now.total("rtuwire_serve_clients") == 2, "two clients", now.text)
        check(now.total("rtuwire_serve_requests_total", unit=1) - before.total("rtuwire_serve_requests_total", unit=1) == 8 and
              now.total("rtuwire_serve_requests_total", unit=2) - before.total("rtuwire_serve_requests_total", unit=2) == 3,
              "requests by unit", now.text)
        check(now.total("rtuwire_serve_requests_total", unit=2, function=4) + now.total("rtuwire_serve_requests_total", unit=2, function="04") == 3,
              "and function", now.text)
        check(now.total("rtuwire_serve_exceptions_total", unit=1) == 1, "an exception", now.text)
        check(now.total("rtuwire_serve_silences_total", unit=5) == 1, "a silence", now.text)
        count = now.total("rtuwire_serve_round_trip_seconds_count", unit=1)
        check(count >= 8 and 0 < now.total("rtuwire_serve_round_trip_seconds_sum", unit=1) < LIMIT, "times of answers", now.text)
        check(now.total("rtuwire_serve_connections_total") >= 2 and now.total("rtuwire_serve_queue") == 0, "connections, and an empty queue", now.text)
        missing = {name for name, _ in now.samples} - set(now.kinds) - {name + tail for name in now.kinds for tail in ("_sum", "_count", "_bucket")}
        check(not missing and now.helps, "each has its type", missing)
        check(all(now.kinds.get(name) == "counter" for name, _ in now.samples if name.endswith("_total")), "a total is a counter", now.kinds)
        check(all(now.samples[each] >= value for each, value in before.samples.items() if each[0].endswith("_total")), "no counter falls")
        # A slow reader of figures, and one that never ends its request.
        slow = [socket.create_connection(("127.0.0.1", number)) for _ in range(20)]
        for each in slow[:10]:
            each.sendall(b"GET /metrics HT")
        slow[-1].sendall(b"x" * 100_000)
        with Asker(served.number) as client:
            check(is_right(1, FIRST, 1, client.read(1, FIRST)), "clients of figures that do not go on cost nobody")
        for each in slow:
            each.close()
        
        def are_there():
            try:
                return served.metrics().samples
            except ConnectionError:
                return False
        check(soon(are_there, 30), "and the figures are there again")
        events = served.events()
        check(all(isinstance(each, dict) for each in events) and tells(served, "connect"), "events are objects", events)
        check(all(line.startswith("{") for line in served.lines["stdout"] if "listening" not in line), "and nothing else is on that stream",
              served.lines["stdout"])


def ends(check, program):
    for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        with PlainUnits(1) as line, Served(program, line.name, "--units", "1", line=PATIENT) as served, Asker(served.number) as client:
            client.read(1, FIRST)
            line.hold()
            number = client.send(1, read_of(FIRST + 1))
            client.send(1, read_of(FIRST + 2))
            check(soon(lambda: (1, FIRST + 1) in line.reads()), "a request is on the line")
            served.process.send_signal(each)
            # It can't end before: the answer is held here.
            time.sleep(0.2)
            check(served.process.poll() is None, f"{each.name}: the request under way is waited for")
            line.release_all()
            found = client.answer()
            check(found == (number, 1, b"\3\2" + value_of(1, FIRST + 1).to_bytes(2, "big")), "who asked gets the answer", found)
            check(client.has_ended(), "the connection ends")
            check(served.ended() == DONE, "the status is 0")
            check(line.is_whole() and (1, FIRST + 2) not in line.reads(), "whole frames, and no new one", line.reads())
            try:
                Asker(served.number).close()
                check(False, "nobody listens any more")
            except ConnectionRefusedError:
                pass


def for_a_time(check, program):
    with PlainUnits(1) as line:
        began = time.monotonic()
        with Served(program, line.name, "--units", "1", "--for", "1s") as served:
            status = served.ended()
        check(status == DONE and time.monotonic() - began > 0.9, "--for ends it", status)


def port(check, program):
    at_once(check, program, (port_goes, port_is_late, figures, ends, for_a_time))


# Words.

def words(check, program):
    with Tool(program) as tool, PlainUnits(1) as line:
        taken = socket.create_server(("127.0.0.1", 0))
        number = taken.getsockname()[1]
        for said, names in ((["--listen", "foo://127.0.0.1:1502"], ["foo"]), (["--listen", "mbap://127.0.0.1:99999"], ["99999"]),
                            (["--listen", "mbap://no-such-host.invalid:1502"], ["no-such-host.invalid"]), (["--listen", "/dev/ttyS0"], ["/dev/ttyS0"]),
                            (["--listen", "sim:atv320:7"], ["sim:"]), (["--units", "0"], ["0"]), (["--units", ""], ["--units"]),
                            (["--functions", ""], ["--functions"]), (["--metrics", ""], ["--metrics"]),
                            (["--from", ""], ["--from"]), (["--listen", ""], ["--listen"]), (["--units", ","], ["','"]), (["--units", "1-300"], ["300"]),
                            (["--units", "5-2"], ["5-2"]), (["--units", "abc"], ["abc"]), (["--functions", "0"], ["0"]), (["--functions", "300"], ["300"]),
                            (["--functions", "x"], ["x"]), (["--from", "abc"], ["abc"]), (["--from", "1.2.3.4/33"], ["1.2.3.4/33"]),
                            (["--from", "1.2.3"], ["1.2.3"]), (["--from", "10.0.0.0/024"], ["10.0.0.0/024", "without a zero"]), (["--metrics", "nowhere"], ["nowhere"]), (["--metrics", "127.0.0.1:70000"], ["70000"]),
                            (["--write", "--listen", "mbap://0.0.0.0:0"], ["--from", "0.0.0.0"]), (["--for", "soon"], ["soon"]),
                            (["--listen", "mbap://224.0.0.1:1502"], ["224.0.0.1", "many machines"]),
                            (["--listen", "tcp://[ff02::1]:1502"], ["ff02::1", "many machines"]), (["--metrics", "224.0.0.1:9502"], ["224.0.0.1"]),
                            (["--listen", "mbap://0.0.0.0:0", "--from", "fd00::/8"], ["--from", "mbap://0.0.0.0:0", "IPv6 alone"]),
                            (["--listen", "mbap://[fd00::1]:0", "--from", "10.0.0.0/8"], ["--from", "mbap://[fd00::1]:0", "IPv4 alone"]),
                            (["--listen", "mbap://[::1]:0", "--from", "10.0.0.0/8"], ["--from", "mbap://[::1]:0", "this machine alone reaches it, by ::1"]),
                            (["--listen", "mbap://127.0.0.1:0", "--from", "10.0.0.0/8", "--from", "192.168.1.7"],
                             ["--from", "mbap://127.0.0.1:0", "this machine alone reaches it, by 127.0.0.1; name that, or listen at 0.0.0.0"]),
                            (["--listen", "mbap://0.0.0.0:0", "--listen", "tcp://127.0.0.1:0", "--from", "10.0.0.0/8"], ["--from", "tcp://127.0.0.1:0"]),
                            (["--allow-run"], ["--allow-run"]), (["--allow-run", "--write"], ["--allow-run"]), (["--allow-broadcast"], ["--write"])):
            ended = tool.run("serve", *said, "--for", "0.1s", port=line.name) if "--for" not in said else tool.run("serve", *said, port=line.name)
            check(ended.status in (USAGE, REFUSED, PORT) and all(each in ended.errors for each in names), f"refused, with its word: {' '.join(said)}", ended)
        for said in (["-u", 5], ["--unit", 5], ["-u", "meter", "--name", "meter=5"]):
            ended = tool.run(*said, "serve", "--listen", "mbap://127.0.0.1:0", "--for", "0.1s", port=line.name)
            check(ended.status == USAGE and "--units 5" in ended.errors, f"the word to use instead: {said}", ended)
        for said in (["--listen", f"mbap://127.0.0.1:{number}"], ["--listen", "mbap://127.0.0.1:0", "--metrics", f"127.0.0.1:{number}"]):
            ended = tool.run("serve", *said, port=line.name)
            check(ended.status in (PORT, USAGE) and str(number) in ended.errors and "in use" in ended.errors, f"taken: {' '.join(said)}", ended)
        taken.close()
        check(not line.requests, "and nothing of all that was on the line", line.requests)
        ended = tool.run("serve", "--for", "0.1s", port="mbap://127.0.0.1:1")
        check(ended.status == PORT and "127.0.0.1:1" in ended.errors, "nobody is behind the port", ended)
        own = f"mbap://127.0.0.1:{free_port()}"
        ended = tool.run("serve", "--listen", own, "--for", "0.1s", port=own)
        check(ended.status == USAGE and f"{own} is the line's own port" in ended.errors, "a line that would ask itself", ended)
        # Another test may have it: then the error names it.
        ended = tool.run("serve", "--units", "1", "--for", "0.2s", port=line.name)
        check("127.0.0.1:1502" in ended.output + ended.errors and ended.status in (DONE, PORT), "without a word it listens on 127.0.0.1:1502", ended)
        with Served(program, line.name, "--units", "1") as served:
            with open("/proc/net/tcp", encoding="ascii") as table:
                local = [each.split()[1] for each in list(table)[1:] if each.split()[1].endswith(f":{served.number:04X}")]
            check(local and all(each.startswith("0100007F") for each in local), "and is reached from this machine only", local)
    for upstream in ("sim:atv320:7", "pymodbus"):
        behind(check, program, upstream)


def behind(check, program, upstream):
    """Ports that are no serial line."""
    if upstream != "pymodbus":
        with Served(program, upstream, "--units", "7") as served, Asker(served.number) as client:
            check(isinstance(client.read(7, 3202), list), "a simulated drive as a port")
        return
    number = free_port()
    with Programs() as others:
        others.serve(f"mbap:{number}", [sys.executable, "-B", str(HERE.parent / "interop" / "memory_pymodbus.py"), "@", "1000", "100"], stdin=subprocess.PIPE,
                     stderr=subprocess.DEVNULL)
        with Served(program, f"mbap://127.0.0.1:{number}", "--units", "1-3", "--write") as served, Asker(served.number) as one, \
                Asker(served.number) as other:
            check(one.ask(1, bytes.fromhex("0603e81234")) == bytes.fromhex("0603e81234") and other.read(1, 1000) == [0x1234],
                  "a server of Modbus TCP for many clients")
            check(one.read(1, 5000) == -2, "and its exceptions")


# Fair.

def stop_asking(self):
    """Of a client in a thread."""
    self.is_over = True
    try:
        self.client.socket.shutdown(socket.SHUT_RDWR)
    except OSError:
        pass
    self.thread.join()
    self.client.close()


class Flood:
    """A client whose queue is always full: what was answered is asked anew."""

    def __init__(self, number, unit, address, depth=16):
        self.client, self.unit, self.address, self.answers = Asker(number), unit, address, 0
        for _ in range(depth):
            self.client.send(unit, read_of(address))
        self.is_over = False
        self.thread = threading.Thread(target=self.goes_on, daemon=True)
        self.thread.start()

    def goes_on(self):
        try:
            while not self.is_over and self.client.answer():
                self.answers += 1
                self.client.send(self.unit, read_of(self.address))
        except OSError:
            pass

    end = stop_asking


class Steady:
    """A client that asks again as soon as it is answered; `sent` and `answered` count."""

    def __init__(self, number, unit, address):
        self.client, self.unit, self.address, self.sent, self.answered, self.failed = Asker(number), unit, address, 0, 0, []
        self.is_over = False

    def start(self):
        self.thread = threading.Thread(target=self.goes_on, daemon=True)
        self.thread.start()

    def goes_on(self):
        try:
            while not self.is_over:
                self.client.send(self.unit, read_of(self.address))
                self.sent += 1
                found = self.client.answer()
                if found is None:
                    return
                self.answered += 1
                if found[2] != b"\3\2" + value_of(self.unit, self.address).to_bytes(2, "big"):
                    self.failed.append(found)
        except OSError:
            pass

    end = stop_asking


def all_ask(line, steady, foreign=()):
    """No unit answers before each of these has a request waiting or on the line: turns are then what the program makes of them, however
    busy the machine is."""
    counts = {(each.unit, each.address): 0 for each in steady}

    def wait(request):
        key = (request[0], int.from_bytes(request[2:4], "big"))
        if request[1] == 3 and key in counts:
            counts[key] += 1  # on the line for so many times
        for each in steady:
            # What was answered is asked anew before the next answer leaves.
            has = counts[(each.unit, each.address)]
            soon(lambda it=each, n=has: it.sent > n or it.is_over or (request[0], int.from_bytes(request[2:4], "big")) == (it.unit, it.address),
                 LIMIT)
    line.before_answer = wait


def shares(check, program):
    """Eight clients, one of which has sixteen requests waiting at any time."""
    rounds = 400
    with PlainUnits(1) as line, Served(program, line.name, "--units", "1", line=PATIENT) as served:
        steady = [Steady(served.number, 1, FIRST + 10 + i) for i in range(7)]
        steady[0].client.read(1, FIRST)
        line.hold()
        flood = Flood(served.number, 1, FIRST + 1)
        for each in steady:
            each.start()
        soon(lambda: all(each.sent for each in steady))
        all_ask(line, steady)
        line.release_all()
        check(soon(lambda: len(line.reads()) > rounds + 20), "they ask")
        order = [address for _, address in line.reads()][20:rounds + 20]
        for each in [*steady, flood]:
            each.end()
        line.before_answer = None
        least = min(order.count(each.address) for each in steady)
        print("     requests on the line:", {address - FIRST: order.count(address) for address in sorted(set(order))})
        check(least >= 0.8 * rounds / 8, "each of the seven others has 80 % of its fair share", least / (rounds / 8))
        longest = max((gap for each in steady for gap in gaps(order, each.address)), default=0)
        check(longest <= 16, "and waits for two rounds at most", longest)
        check(not any(each.failed for each in steady), "with right values")


def gaps(order, address):
    places = [i for i, each in enumerate(order) if each == address]
    return [after - before for before, after in zip(places, places[1:])]


def dead_unit(check, program):
    """A unit that never answers, which one client never ceases to ask, between two that others ask."""
    rounds = 300
    with PlainUnits(1, 2, silent=(9,)) as line, \
            Served(program, line.name, "--units", "1,2,9", line=("--timeout", 0.1, "--retries", 0)) as served:
        steady = [Steady(served.number, 1, FIRST + 10), Steady(served.number, 2, FIRST + 20)]
        flood = Flood(served.number, 9, FIRST + 1)
        for each in steady:
            each.start()
        # Where the machine is so busy that a unit of ours is late for 0.1 s, it is silent, too: then its values are counted as failed,
        # and the turns are still what is looked at.
        check(soon(lambda: len([1 for unit, _ in line.reads() if unit != 9]) > rounds, 120), "the others go on")
        order = [unit for unit, _ in line.reads()]
        for each in [*steady, flood]:
            each.end()
        dead = order.count(9)
        twice = sum(1 for before, after in zip(order, order[1:]) if before == after == 9)
        print(f"     of {len(order)} requests on the line {dead} were to the unit that is silent; its client was answered {flood.answers} times")
        check(twice == 0, "it is never asked twice before others had their turn", twice)
        check(1 <= dead <= len(order) / 10, "with growing pauses: few of the requests are its own", (dead, len(order)))
        check(flood.answers >= dead, "and its client is answered 0B meanwhile", (flood.answers, dead))


def dead_units(check, program):
    """Six clients with eight requests each to units that never answer, and one that asks another."""
    timeout, dead, rounds = 0.2, (10, 11, 12, 13, 14, 15), 300
    with PlainUnits(1, silent=dead) as line, \
            Served(program, line.name, "--units", "1,10-15", line=("--timeout", timeout, "--retries", 1)) as served:
        began = time.time()
        floods = [Flood(served.number, unit, FIRST + 1, 8) for unit in dead]
        steady = Steady(served.number, 1, FIRST + 10)
        steady.start()
        check(soon(lambda: [unit for unit, _ in line.reads()].count(1) > rounds, 120), "the seventh goes on")
        order, took = [unit for unit, _ in line.reads()], time.time() - began
        for each in [steady, *floods]:
            each.end()
        asked = len(order) - order.count(1)
        print(f"     of {len(order)} requests in {took:.1f} s {asked} were to the six")
        check(len(dead) <= asked <= len(dead) + 2 + took / (10 * timeout), "they have a tenth of the line, once each is known", (asked, took))
        check(not steady.failed, "and the seventh its values", steady.failed[:3])


def lost_in_turns(check, program):
    """A request whose response is lost is sent again behind the others' turns."""
    with PlainUnits(1, 2) as line, Served(program, line.name, "--units", "1,2", line=("--timeout", 0.5, "--retries", 1)) as served, \
            Asker(served.number) as one:
        check(is_right(1, FIRST, 1, one.read(1, FIRST)), "a unit that answers")
        flood = Flood(served.number, 2, FIRST + 1)
        check(soon(lambda: flood.answers > 3), "another client asks, as fast as it can")
        line.silent = {1}
        one.send(1, read_of(FIRST + 5))
        check(soon(lambda: (1, FIRST + 5) in line.reads()), "its response is lost")
        line.silent = set()
        found = one.answer()
        order = line.reads()
        flood.end()
        check(found[2] == b"\3\2" + value_of(1, FIRST + 5).to_bytes(2, "big"), "its repetition is answered", found)
        places = [i for i, each in enumerate(order) if each == (1, FIRST + 5)]
        between = order[places[0] + 1:places[-1]]
        check(len(places) == 2 and (2, FIRST + 1) in between, "which came behind a turn of the other", order[places[0]:places[-1] + 1])


def back_again(check, program):
    """A unit that was silent, and answers."""
    with PlainUnits(1, 2, silent=(2,)) as line, Served(program, line.name, "--units", "1,2", "--json", line=SHORT) as served, \
            Asker(served.number) as one, Asker(served.number) as other:
        for _ in range(4):
            check(one.ask(2, read_of(FIRST)) == bytes([0x83, SILENT]), "silent")
            other.read(1, FIRST)
        line.silent = set()

        def answers():
            other.read(1, FIRST)
            return is_right(2, FIRST, 1, one.read(2, FIRST))
        check(soon(answers, 60), "it is found again", line.reads()[-5:])
        check(tells(served, "back"), "and that is told", served.events())


def fair(check, program):
    at_once(check, program, (shares, dead_unit, dead_units, lost_in_turns, back_again))


# A crowd.

def misbehaves(number, kind, drawn):
    """A client that is none, in one of many ways; what it holds open."""
    client = socket.create_connection(("127.0.0.1", number))
    client.settimeout(5)
    try:
        if kind == "noise":
            client.sendall(drawn.randbytes(drawn.randrange(1, 2000)))
        elif kind == "half":
            client.sendall(message(1, 1, read_of(FIRST))[:drawn.randrange(1, 12)])
        elif kind == "huge":
            client.sendall(header(1, 65535) + bytes(3000))
        elif kind == "other protocol":
            client.sendall(b"GET / HTTP/1.1\r\nHost: a\r\n\r\n" * drawn.randrange(1, 50))
        elif kind == "reads nothing":
            client.sendall(message(1, 200, read_of(FIRST)) * 3000)  # a unit that is not served
        elif kind == "refused":
            client.sendall(message(1, 1, bytes.fromhex("0621350000")) * 500)
        elif kind == "gone":
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            client.sendall(message(1, 200, read_of(FIRST)) * 5)
            client.close()
        elif kind == "half closed":
            client.sendall(message(1, 200, read_of(FIRST)))
            client.shutdown(socket.SHUT_WR)
    except OSError:
        pass  # it was shown the door meanwhile
    return client


KINDS = ("noise", "half", "huge", "other protocol", "reads nothing", "refused", "gone", "half closed", "nothing")
MOST_GROWTH = 4096  # KiB


def crowd(check, program, count="100", how="measured"):
    drawn = random.Random(int(count))
    with PlainUnits(1) as line, Served(program, line.name, "--listen", "mbap://127.0.0.1:0", "--listen", "tcp://127.0.0.1:0", "--units", "1",
                                       *METRICS, line=PATIENT) as served, Asker(served.number) as honest:
        def right(i):
            return is_right(1, FIRST + i % 500, 1, honest.read(1, FIRST + i % 500))
        check(right(0), "before")
        before, held, wrong = served.memory(), [], 0
        peak = before
        numbers = (served.number, served.number, served.ports["tcp"][0], served.ports["http"][0])
        for i in range(int(count)):
            held.append(misbehaves(drawn.choice(numbers), KINDS[i % len(KINDS)], drawn))
            if len(held) > 24:
                held.pop(drawn.randrange(len(held))).close()
            asked = len(line.requests)
            wrong += not right(i)
            # Not one of those has a request that may reach the unit, so each of ours is the next on the line.
            wrong += len(line.requests) != asked + 1
            peak = max(peak, served.memory())
        check(not wrong, f"among {count} clients that are none, each request of ours is the next on the line", wrong)
        for each in held:
            each.close()
        check(soon(lambda: served.metrics().total("rtuwire_serve_clients") == 1, 30), "they are gone", served.metrics().text)
        print(f"     memory: {before} KiB before, {peak} at most, {served.memory()} at the end")
        if how == "measured":
            check(peak - before <= MOST_GROWTH, "memory is bounded", (before, peak))
        check(line.is_whole() and all(each[1] == 3 or each[1] in (17, 43) for each in line.requests), "and nothing of it reached the line")
        check(served.process.poll() is None and served.ended(signal.SIGINT) == DONE, "it ends well")


# Drives.

class Tap(Line):
    """with Tap(device) as line: between the program and a simulated drive; `line.frames()` are those that the program sent."""

    def frames(self):
        return requests_in(self.heard)[0]


def not_named(check, program):
    with Simulator(program, "atv320:7", "atv28:4") as device, Tap(device) as line, \
            Served(program, line.name, line=PATIENT) as served, Asker(served.number) as client:
        for unit, place in ((7, 3202), (4, 451), (7, 9001)):
            check(client.ask(unit, read_of(place)) == bytes([0x83, NO_PATH]), f"unit {unit}, a drive that is not named: 0A")
        asked = [each for each in line.frames() if each[2:4] in (struct.pack(">H", 9001),)]
        check(not asked, "and is not asked what the client wanted", asked)
        told = [each for each in served.lines["stderr"] if "--units" in each and "7" in each]
        check(len(told) == 1, "that is told once, with the word to add", served.lines["stderr"])


def named(check, program):
    with Simulator(program, "atv320:7", "atv28:4") as device, Tap(device) as line, \
            Served(program, line.name, "--units", "4,7", line=PATIENT) as served, Asker(served.number) as client:
        check(soon(lambda: any("7" in each and "supervis" in each for each in served.lines["stderr"]), 10) or
              soon(lambda: any("time-out" in each for each in served.lines["stderr"]), 1), "that reads feed its time-out is said at the start",
              served.lines["stderr"])
        check(isinstance(client.read(7, 3202), list) and isinstance(client.read(4, 451), list), "drives that are named are read")
        for pdu in (bytes.fromhex("0621350006"), bytes.fromhex("1021350001020006"), bytes.fromhex("0623290032"),
                    bytes.fromhex("170c820001213500010200 06".replace(" ", ""))):
            before = len(line.frames())
            check(client.ask(7, pdu) == bytes([pdu[0] | 0x80, 1]), f"without --write nothing is written: {pdu.hex(' ')}")
            check(len(line.frames()) == before, "and nothing is on the line")


# What `write` refuses of a drive's registers at rest, and what it takes: register, raw value.
JUDGED = ((9001, 50), (9002, 50), (3104, 450), (3105, 100), (8501, 6), (8502, 400), (8503, 1), (8504, 15), (8401, 1), (8413, 164), (8423, 10),
          (7010, 0), (7010, 1), (6005, 100), (8032, 1), (12701, 8501), (12721, 3201), (9608, 1), (11920, 0), (12345, 1), (8602, 100), (65535, 1))


def as_write_does(check, program):
    """The same judgement as that of `write`, register by register."""
    with Simulator(program, "atv320:7") as device, Tool(program, device) as tool:
        # A value that `write` calls a mistake in words (9001=25) is said in raw counts.
        direct = {each: tool.run("--no-listen", "-u", 7, "-d", "atv320", "--write", "write", f"{each[0]}=#{each[1]}") for each in JUDGED}
    with Simulator(program, "atv320:7") as device, Tap(device) as line, \
            Served(program, line.name, "--units", "7", "--write", line=PATIENT) as served, Asker(served.number) as client:
        for (register, value), ended in direct.items():
            for pdu in (bytes([6]) + struct.pack(">HH", register, value), bytes([16]) + struct.pack(">HHBH", register, 1, 2, value)):
                before = len(line.frames())
                answer = client.ask(7, pdu)
                wrote = [each for each in line.frames()[before:] if each[1:-2] == pdu]
                if ended.status in (REFUSED, USAGE):
                    check(answer[0] & 0x80 and not wrote, f"refused as by write: {register}={value}", (answer, wrote, ended.errors))
                elif ended.status == DONE:
                    check(answer[0] == pdu[0] and len(wrote) == 1, f"written as by write: {register}={value}", (answer, line.frames()[before:], ended.output))
        before = len(line.frames())
        for pdu in (bytes([22]) + struct.pack(">HHH", 8501, 0xFFFF, 15), bytes([23]) + struct.pack(">HHHHBH", 3201, 1, 8501, 1, 2, 15),
                    bytes([16]) + struct.pack(">HHB4H", 8498, 4, 8, 0, 0, 0, 15), bytes([16]) + struct.pack(">HHB2H", 9001, 8, 4, 50, 50)):
            check(client.ask(7, pdu)[0] & 0x80, f"and in other forms: {pdu.hex(' ')}")
        check(not [each for each in line.frames()[before:] if each[1] in (6, 16, 22, 23)], "nothing of these is on the line", line.frames()[before:])


def runs_at(simulator, unit, drive, hertz=30):
    """Another master runs it, on its own line."""
    at = Registers(drive)
    simulator.suffer(f"{unit} write {at.tto} 300")
    simulator.suffer(f"{unit} write {at.acc} 1")
    for word in (0x80, 6, 7, 15):
        simulator.suffer(f"{unit} write {at.cmd} {word}")
    simulator.suffer(f"{unit} write {at.lfr} {hertz * 10}")
    return soon(lambda: simulator.shown(unit)[1] == hertz)


def stopped(check, program, drive):
    """`stop` as a client: whoever may write may take the power from a motor."""
    simulator = Simulator(program, f"{drive}:7")
    with simulator as device, Tap(device) as line, Tool(program) as tool, \
            Served(program, line.name, "--units", "7", "--write", line=("--timeout", 1, "--retries", 0)) as served:
        check(runs_at(simulator, 7, drive), f"{drive}: another master runs it", simulator.shown(7))
        ended = tool.run("-u", 7, "stop", "--freewheel", port=f"mbap://127.0.0.1:{served.number}")
        check(ended.status == DONE and soon(lambda: simulator.shown(7)[1] == 0), f"{drive}: stop --freewheel through serve", (ended, simulator.shown(7)))
        sent = {int.from_bytes(each[4:6], "big") for each in line.frames() if each[1] == 6 and int.from_bytes(each[2:4], "big") == 8501}
        check(sent == {0}, "by the word that takes its power away alone", sent)
        rows = [each for each in served.noted() if each[4] == "CMD"]
        check(rows and "127.0.0.1" in rows[0][6], "which is noted", served.noted())


def stops(check, program):
    for drive in ("atv320", "atv12", "atv310"):
        stopped(check, program, drive)


def stop_words(check, program):
    """Which words pass, and where."""
    simulator = Simulator(program, "atv320:7")
    with simulator as device, Tap(device) as line, PlainUnits(7) as meter:
        def written():
            return [each for each in line.frames() if each[1] in (6, 16)]
        with Served(program, line.name, "--units", "7", line=PATIENT) as served, Asker(served.number) as client:
            check(client.ask(7, command(0)) == b"\x86\1" and not written(), "without --write none does")
        with Served(program, line.name, "--units", "7", "--write", line=PATIENT) as served, Asker(served.number) as client:
            for word in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14, 15, 0x17, 0x47, 0x80, 0x87, 0x100, 0x102, 0x107, 0x700, 0x702, 0x800, 0x8007, 0xFFFF):
                check(client.ask(7, command(word)) == b"\x86\1", f"{word:04X} stops no motor")
            for pdu in (bytes([16]) + struct.pack(">HHB2H", 8501, 2, 4, 0, 0), bytes([16]) + struct.pack(">HHB2H", 8500, 2, 4, 0, 0),
                        bytes([22]) + struct.pack(">HHH", 8501, 0, 0), bytes([23]) + struct.pack(">HHHHBH", 3201, 1, 8501, 1, 2, 0),
                        bytes([6]) + struct.pack(">HH", 8502, 0), bytes([6]) + struct.pack(">HH", 8602, 0), bytes([6]) + struct.pack(">HH", 400, 0)):
                check(client.ask(7, pdu)[1] == 1, f"nor may another form: {pdu.hex(' ')}")
            check(not written(), "and nothing is on the line", written())
            for pdu in (command(0), bytes([16]) + struct.pack(">HHBH", 8501, 1, 2, 0)):
                check(client.ask(7, pdu) == pdu[:5], f"{pdu.hex(' ')} stops a motor")
        with Served(program, line.name, "--units", "7", "--write", line=PATIENT) as served, Asker(served.number) as client:
            simulator.suffer("7 write 8401 3")
            check(client.read(7, 8401) == [3], "the I/O profile")
            check(client.ask(7, command(0)) == command(0), "0000 passes in it, too")
        with Served(program, meter.name, "--units", "7", "--write", line=PATIENT) as served, Asker(served.number) as client:
            check(client.ask(7, command(0)) == command(0), "what says that it is a meter may be written there")
    with PlainUnits(7, nameless=(7,)) as meter, Served(program, meter.name, "--units", "7", "--write", line=PATIENT) as served, \
            Asker(served.number) as client:
        check(client.ask(7, command(0)) == b"\x86\1" and not meter.asked(6), "what is no drive that is known, and may be one, is not")


SHOWN = re.compile(r"`([^`]* stop[^`]*)`")


def pasted(tool, text):
    """The command that a text shows, and what became of it in a shell."""
    found = SHOWN.search(text)
    return found and subprocess.run(["sh", "-c", found[1]], cwd=tool.place, env=tool.environment, check=False, stdin=subprocess.DEVNULL,
                                    capture_output=True, text=True, timeout=LIMIT)


def shown_stops(check, program):
    """A stop that is refused here is told with one that passes, of this port and this unit."""
    simulator = Simulator(program, "atv320:7")
    with simulator as device, Tool(program) as tool, Served(program, device, "--units", "7", "--write", line=PATIENT) as served:
        for who in ("another client", "stop"):
            check(runs_at(simulator, 7, "atv320"), f"{who}: a motor runs", simulator.shown(7))
            if who == "stop":
                ended = tool.run("-u", 7, "stop", port=f"mbap://127.0.0.1:{served.number}")
                check(ended.status == DIFFERS and "0000" in ended.output, "a ramp is refused", ended)
                said = ended.output
            else:
                with Asker(served.number) as client:
                    check(client.ask(7, command(7)) == b"\x86\1", "another word is refused")
                soon(lambda: any("commands the motor" in each for each in served.said()), LIMIT)
                said = "\n".join(served.said())
            done = pasted(tool, said)
            check(done and done.returncode == DONE and soon(lambda: simulator.shown(7)[1] == 0), f"{who}: what is shown stops it", (said, done))
    with Simulator(program, "atv320:7") as device, Tool(program) as tool, Served(program, device, "--units", "7", line=PATIENT) as served:
        ended = tool.run("-u", 7, "stop", "--freewheel", port=f"mbap://127.0.0.1:{served.number}")
        check(ended.status == DIFFERS and "end it, and stop at the port" in ended.output, "where only reads pass, that is said", ended)


def stop_of_silent(check, program):
    """The pauses of a unit that is silent hold no stop back."""
    with PlainUnits(1, silent=(9,)) as line, Served(program, line.name, "--units", "1,9", "--write", line=SHORT) as served, \
            Asker(served.number) as client:
        def asked():
            return len([each for each in line.requests if each[0] == 9])

        def again():
            client.ask(9, read_of(FIRST))
            client.read(1, FIRST)
            return asked() >= 5
        check(soon(again, LIMIT), "it is asked with growing pauses")  # the next is 4 s
        before = asked()
        check(client.ask(9, command(6)) == bytes([0x86, SILENT]) and asked() == before, "another word is answered 0B at once")
        check(client.ask(9, command(0)) == bytes([0x86, SILENT]) and asked() > before, "for a stop it is looked for", (before, asked()))


def drives(check, program):
    at_once(check, program, (not_named, named, as_write_does, stop_words, stops, shown_stops, stop_of_silent))


# Words that a client may try, and where they would do something: control words, references, whose they are, what may be assigned to an input.
HOT = (8501, 8502, 8503, 8504, 8601, 8602, 400, 401, 3104, 3105, 8401, 8411, 8412, 8413, 8423, 8424, 7010, 6005, 7131, 7124, 9608, 12701, 12721, 12722, 12741,
       9001, 9002, 9001, 9002, 3052, 3053, 8002, 8022, 11101, 11102, 11201, 11202, 11203, 5261, 4402, 13501, 13529)


def drawn_write(drawn):
    """Of one to four registers, by any function that writes."""
    register = drawn.choice(HOT) if drawn.random() < 0.6 else drawn.choice((drawn.randrange(3000, 3400), drawn.randrange(4400, 5300), drawn.randrange(
        6000, 9700), drawn.randrange(11100, 14100), drawn.randrange(65536)))
    value = drawn.choice((0, 1, 2, 3, 4, 6, 7, 10, 15, 164, 300, 500, 0x80, 0x8F, 0x80F, 0xFFFF, drawn.randrange(65536)))
    count = drawn.randint(1, 4)
    first = max(0, register - drawn.randrange(count))
    words = struct.pack(f">{count}H", *[value if drawn.random() < 0.7 else drawn.randrange(1000) for _ in range(count)])
    return drawn.choice((bytes([6]) + struct.pack(">HH", register, value), bytes([16]) + struct.pack(">HHB", first, count, len(words)) + words,
                         bytes([22]) + struct.pack(">HHH", register, 0, value), bytes([5]) + struct.pack(">HH", register, 0xFF00),
                         bytes([15]) + struct.pack(">HHBB", register, 8, 1, 0xFF),
                         bytes([23]) + struct.pack(">HHHHB", 3201, 2, first, count, len(words)) + words))


LINK_LOST = 5  # LFT: SLF
OF_A_LINE = (6001, 6003, 6004, 6005)  # ADD, TBR, TFO, TTO


def command_in_turn(simulator, at, words):
    for word in words:
        simulator.suffer(f"7 write {at.cmd} {word}")


def turns(check, program, count="200", seed="1"):
    """Whatever clients write, with --write and without a limit of functions: a motor at rest stays so, and one that another master runs goes on
    as it did."""
    at, drawn = Registers("atv320"), random.Random(int(seed))
    for words in ((), (0x80, 6, 7), (0x80, 6, 7, 15)):
        simulator = Simulator(program, "atv320:7")
        with simulator as device, Served(program, device, "--units", "7", "--write", line=PATIENT) as served, Asker(served.number) as client:
            simulator.suffer(f"7 write {at.tto} 300")
            simulator.suffer(f"7 write {at.acc} 1")
            line = {each: client.read(7, each)[0] for each in OF_A_LINE}
            command_in_turn(simulator, at, words)
            if 15 in words:
                simulator.suffer(f"7 write {at.lfr} 300")
                check(soon(lambda: simulator.shown(7)[1] == 30), "another master runs it", simulator.shown(7))
            before, passed, wrong = simulator.shown(7), 0, []
            for _ in range(int(count)):
                pdu = drawn_write(drawn)
                while pdu[:3] == b"\6\x21\x35" and pdu[3:] in (b"\0\0", b"\0\2", b"\0\7") or \
                        pdu[:6] == bytes.fromhex("102135000102") and pdu[6:] in (b"\0\0", b"\0\2", b"\0\7"):
                    pdu = drawn_write(drawn)  # a stop, which is what it is for
                answer = client.ask(7, pdu)
                client.read(7, at.eta)
                passed += not answer[0] & 0x80
                now = simulator.shown(7)
                # Some settings take the power away from a drive that is switched on and stands. Another format of characters, or
                # a time-out below the pauses here, trips it: its own doing, and no way to turn.
                if 15 not in words and now == ("fault", 0, LINK_LOST):
                    for register, value in line.items():
                        simulator.suffer(f"7 write {register} {value}")
                    command_in_turn(simulator, at, (0x80, *words))
                    now = simulator.shown(7)
                stands = 15 not in words and now[0] in (before[0], "switch on disabled") and now[1:] == (0, 0)
                if now != before and not stands:
                    wrong.append((pdu.hex(" "), answer.hex(" "), before, now))
                    break
            check(not wrong, f"{before[0]}, {before[1]} Hz: {count} drawn writes turn no motor, and none otherwise", wrong)
            print(f"     {passed} of them were written")


PARTS = {each.__name__: each for each in (clients, libmodbus, gate, limits, port, words, fair, crowd, drives, turns)}


def main(check, program, part, *more):
    PARTS[part](check, os.path.abspath(program), *more)


runs(main)
