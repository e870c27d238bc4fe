# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Clients that nobody here wrote ask a server of libmodbus through `rtuwire serve`, all at once, and one like it directly: drawn reads
and writes get equal answers. Each client has registers and bits of its own, so that what the others write changes nothing for it.

    python3 serve_clients.py TOOL MEMORY_LIBMODBUS COUNT SEED -- CLIENT [WORD...] [-- CLIENT [WORD...]]

@ stands for the number of the port in a client's words (asking_libmodbus.cpp says what is said to it); those of npm have no 22 and 23.
"""
import concurrent.futures
import os
import random
import struct
import subprocess
import sys

from frames import crc, with_crc
from pair import Programs, free_port, wait_for_listener
from served import Asker, Served
from simulator import Checks

FIRST, WINDOW = 1000, 150
READS = {1: 150, 2: 150, 3: 125, 4: 125}
WRITES = {5: 1, 6: 1, 15: 150, 16: 123}
LATER = {22: 1, 23: 121}
LIMIT = 3600


TABLE = [crc(bytes([byte])) for byte in range(256)]  # of 0xFFFF; by it of any remainder


def holds_a_frame(words):
    """Whether a whole frame stands in the bytes of what the unit is asked. serve refuses that, as `write` does: a unit that lost the
    beginning takes it for a request of its own."""
    function, address, *values = words
    if function not in (15, 16, 23) or len(values) < 2:
        return False
    if function == 15:
        data = sum(bit << i for i, bit in enumerate(values)).to_bytes((len(values) + 7) // 8, "little")
        front = struct.pack(">BBHHB", 1, 15, address, len(values), len(data))
    elif function == 16:
        front, data = struct.pack(">BBHHB", 1, 16, address, len(values), 2 * len(values)), struct.pack(f">{len(values)}H", *values)
    else:
        count, to, *values = values
        front, data = struct.pack(">BBHHHHB", 1, 23, address, count, to, len(values), 2 * len(values)), struct.pack(f">{len(values)}H", *values)
    frame = with_crc(front + data)
    for start in range(1, len(frame) - 3):
        remainder = 0xFFFF
        for at in range(start, len(frame)):
            remainder = remainder >> 8 ^ TABLE[(remainder ^ frame[at] ^ 0xFF) & 0xFF] ^ 0x00FF
            if remainder == 0 and at - start >= 3:
                return True
    return False


def drawn_request(drawn, start, end, has_all):
    """What `drawn_words` draws, and no frame within."""
    while holds_a_frame(words := drawn_words(drawn, start, end, has_all)):
        pass
    return words


def drawn_words(drawn, start, end, has_all):
    """Of the window that begins at `start`; now and then behind the end of all."""
    function = drawn.choice([*READS] * 2 + [*WRITES] + ([*LATER] if has_all else []))
    most = {**READS, **WRITES, **LATER}[function] if has_all or function != 16 else 110  # jsmodbus gives longer ones a wrong length
    size = 1 if most == 1 else drawn.choice((1, 2, drawn.randint(1, 20), drawn.randint(1, most)))
    address = drawn.randint(start, start + WINDOW - size)
    if drawn.random() < 0.1:
        address = drawn.choice((end - size + 1, end, end + 500, 65536 - size, 0))
    values = [drawn.randint(0, 1) if function in (5, 15) else drawn.randint(0, 65535) for _ in range(size)]
    if function in READS:
        return [function, address, size]
    if function == 22:
        return [function, address, values[0], drawn.randint(0, 65535)]
    if function == 23:
        return [function, drawn.randint(start, start + WINDOW - 5), 5, address, *values]
    return [function, address, *values]


class Server:
    """A server of libmodbus with what both begin with."""

    def __init__(self, others, memory, device, count):
        self.process = others.serve(device, [memory, "@", str(FIRST), str(count)], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for space in ("input", "discrete"):
            for at in range(0, count, 50):
                words = [f"{(7 * (at + i) + 3) & (0xFFFF if space == 'input' else 1):x}" for i in range(50)]
                self.told(f"set {space} {FIRST + at} " + " ".join(words))

    def told(self, words):
        self.process.stdin.write(words + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().strip()

    def memory(self, count):
        """All of it."""
        return [self.told(f"get {space} {FIRST + at} 50") for space in ("holding", "input", "coil", "discrete") for at in range(0, count, 50)]


def start(others, command, number):
    words = [str(number) if word == "@" else word for word in command]
    return others.start(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def answers(processes, requests):
    """Each client has all that it is to ask at once, and asks one after the other."""
    texts = ["".join(" ".join(map(str, each)) + "\n" for each in asked) for asked in requests]
    with concurrent.futures.ThreadPoolExecutor(len(processes)) as pool:
        told = [pool.submit(process.communicate, text, LIMIT) for process, text in zip(processes, texts)]
        return [each.result()[0].splitlines() for each in told]


def main(check, tool, memory, count, seed, commands):
    end = FIRST + len(commands) * WINDOW
    size = end - FIRST
    requests = []
    for i, command in enumerate(commands):
        drawn = random.Random(1000 * int(seed) + i)
        has_all = not any("npm" in word for word in command)
        requests.append([drawn_request(drawn, FIRST + i * WINDOW, end, has_all) for _ in range(int(count))])
    with Programs() as others:
        near, far = others.line()
        behind = Server(others, memory, near, size)
        line = ("-b", 115200, "-f", "8N1", "--timeout", 2, "--retries", 0)
        with Served(os.path.abspath(tool), far, "--units", "1", "--write", "--json", line=line) as served:
            # Before its first write a unit is asked who it is. This one is silent then, for longer than requests wait.
            with Asker(served.number) as first:
                check(first.ask(1, bytes([6, 0, 0, 0, 0])) == b"\x86\2", "it is known")
            through = answers([start(others, each, served.number) for each in commands], requests)
            said = [each for each in served.said() if "connect" not in each]
        number = free_port()
        asked = Server(others, memory, f"mbap:{number}", size)
        wait_for_listener(number)
        direct = []
        for command, each in zip(commands, requests):
            direct += answers([start(others, command, number)], [each])
        for command, sent, one, other in zip(commands, requests, through, direct):
            name = " ".join(os.path.basename(word) for word in command if word not in ("@", "-B"))
            check(len(one) == len(other) == int(count), f"{name}: each request has an answer", (len(one), len(other)))
            differ = [each for each in zip(sent, one, other, range(len(one))) if each[1] != each[2]]
            check(not differ, f"{name}: through serve and directly", [tuple(str(part)[:120] for part in each) for each in differ[:3]])
            good = sum(each.startswith("ok") for each in one)
            failed = [(which, at, each) for which, found in (("through", one), ("directly", other)) for at, each in enumerate(found)
                      if each.startswith("failed")]
            check(good > 0.7 * int(count) and not failed and any(each.startswith("exception") for each in one),
                  f"{name}: values, some exceptions, and nothing else", (good, failed[:3]))
            print(f"     {name}: {good} values or writes, {int(count) - good} exceptions")
        print("     serve said:", *said[-20:], sep="\n       ")
        check(behind.memory(size) == asked.memory(size), "both servers hold the same in the end")


if __name__ == "__main__":
    checks = Checks()
    groups, rest = [], sys.argv[5:]
    while rest:
        cut = rest.index("--", 1) if "--" in rest[1:] else len(rest)
        groups.append(rest[1:cut])
        rest = rest[cut:]
    main(checks, *sys.argv[1:5], groups)
    sys.exit(checks.status())
