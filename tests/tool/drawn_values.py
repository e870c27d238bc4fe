# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Values of drawn types, orders, scales and addresses, of servers that nobody here wrote: what the tool says of a value and
what it writes is held against the server's own memory, as Python's struct and fractions have it.

    python3 drawn_values.py TOOL COUNT SEED [mbap] SERVER [WORD...]

SERVER is the command of memory_libmodbus.cpp, memory_pymodbus.py or memory_npm.js; device, first address and number of
addresses are added; with mbap it is asked over Modbus TCP. COUNT values are read and COUNT written, a third each to a unit that has all functions, to one without
15 and 16, and to one without 05, 06 and 22.
"""
import fractions
import math
import random
import struct
import subprocess
import sys

from support import DIFFERS, DONE, REFUSED, Tool, runs

from pair import Programs, free_port  # noqa: I100

FIRST, COUNT = 65236, 300  # up to the last address; no drive of this program has its words there
SPACES = {"holding": "h", "input": "i", "coil": "c", "discrete": "d"}
LISTS = {"coil": "0", "discrete": "1", "input": "3", "holding": "4"}
SIZES = {"u16": ("H", 1), "i16": ("h", 1), "u32": ("I", 2), "i32": ("i", 2), "u64": ("Q", 4), "i64": ("q", 4),
         "f32": ("f", 2), "f64": ("d", 4), "bcd16": ("", 1), "bcd32": ("", 2), "text": ("", 0), "bits": ("H", 1),
         "hex": ("H", 1), "": ("H", 1)}
LONG = {"u16": "uint16", "i16": "int16", "u32": "uint32", "i32": "int32", "u64": "uint64", "i64": "int64",
        "f32": "float32", "f64": "float64"}
SCALED = ("u16", "i16", "u32", "i32", "u64", "i64", "f32", "f64", "bcd16", "bcd32")
UNITS = ("", "", "V", "kWh", "m3/h", "%", "degC", "l/min")
VARIANTS = ("", "15 16", "5 6 22")


def reordered(packed, order):
    """The bytes as they come, of bytes with the highest first."""
    if len(order) == 8:
        return bytes(packed["abcdefgh".index(letter)] for letter in order)
    words = [packed[i:i + 2] for i in range(0, len(packed), 2)]
    words = words[::-1] if order in ("cdab", "dcba") else words
    return b"".join(word[::-1] if order in ("badc", "dcba") else word for word in words)


def put_back(came, order):
    """The bytes with the highest first, of those that came."""
    if len(order) == 8:
        return bytes(came[order.index(letter)] for letter in "abcdefgh")
    return reordered(came, order)  # each of the others undoes itself


def words_of(data):
    return list(struct.unpack(f">{len(data) // 2}H", data))


def single(value):
    return struct.unpack(">f", struct.pack(">f", value))[0]


def decimal(value):
    """A fraction of powers of ten, all its digits."""
    places = 0
    while (value * 10 ** places).denominator != 1:
        places += 1
    digits = str(abs(int(value * 10 ** places))).rjust(places + 1, "0")
    text = digits[:len(digits) - places] + ("." + digits[len(digits) - places:] if places else "")
    return ("-" if value < 0 else "") + text


class Place:
    """A drawn place: how it is typed, and how its bytes mean a value."""

    def __init__(self, chance, space, narrow=False, has_bits=True):
        self.space, self.is_bit = space, space in ("coil", "discrete")
        self.bits = None
        self.kind, self.order, self.scale, self.offset, self.unit = "", "", None, None, ""
        self.characters = 0
        if not self.is_bit and has_bits and chance.random() < 0.12:
            low = chance.randrange(16)
            self.bits = (low, low) if chance.random() < 0.5 else (low, chance.randrange(low, 16))
            self.is_one_bit = self.bits[0] == self.bits[1] and chance.random() < 0.7
        elif not self.is_bit:
            self.kind = chance.choice([kind for kind in SIZES if not narrow or SIZES[kind][1] < 2])
            self.characters = chance.randrange(1, 3 if narrow else 41) if self.kind == "text" else 0
        self.size = (self.characters + 1) // 2 if self.kind == "text" else SIZES[self.kind][1]
        self.address = FIRST + chance.choice((0, COUNT - self.size, *[chance.randrange(COUNT - self.size + 1) for _ in range(8)]))
        if not self.is_bit and self.bits is None:
            orders = ["", "", "abcd", "badc"] + (["cdab", "dcba"] * 3 if self.size > 1 and self.kind != "text" else [])
            self.order = chance.choice(orders)
            if SIZES[self.kind][1] == 4 and chance.random() < 0.2:
                self.order = "".join(chance.sample("abcdefgh", 8))
            if self.kind in SCALED and chance.random() < 0.4:
                self.draw_scale(chance)
        self.word = self.typed(chance)

    def draw_scale(self, chance):
        places = chance.randrange(0, 5)
        self.factor_text = decimal(fractions.Fraction(chance.choice((1, 1, 2, 5, 25)), 10 ** places))
        self.scale = fractions.Fraction(self.factor_text)
        self.unit = chance.choice(UNITS)
        self.offset_text = chance.choice(("", "", "", "-50", "+0.5", "-32.25"))
        self.offset = fractions.Fraction(self.offset_text or 0)
        # The text has as many digits behind the point as the scale or the offset was typed with.
        self.places = max(len(text.partition(".")[2]) for text in (self.factor_text, self.offset_text))

    def typed(self, chance):
        name = chance.choice((self.space, SPACES[self.space], self.space.upper(), *([""] if self.space == "holding" else [])))
        where = chance.choice((str(self.address), hex(self.address)))
        if chance.random() < 0.2:
            name, where = "list", f"{LISTS[self.space]}{self.address + 1:05}"
        if self.bits is not None:
            low, high = self.bits
            return f"{name or 'h'}:{where}.{low}" + ("" if self.is_one_bit else f"-{high}")
        how = [chance.choice((self.kind, LONG.get(self.kind, self.kind))) + (str(self.characters) if self.characters else ""),
               self.order, f"{self.factor_text}{self.unit}{self.offset_text}" if self.scale is not None else ""]
        how = [each for each in how if each]
        chance.shuffle(how)
        word = ":".join(([name] if name else []) + [where] + how)
        return word if ":" in word else "h:" + word

    def spans(self):
        return range(self.address, self.address + self.size)

    def amount(self, count):
        return count if self.scale is None else count * self.scale + self.offset

    def with_unit(self, text):
        return f"{text} {self.unit}" if self.unit else text

    def number_text(self, value):
        """As many digits behind the point as the scale has."""
        if self.scale is None:
            return str(value)
        digits = str(abs(int(value * 10 ** self.places))).rjust(self.places + 1, "0")
        text = digits[:len(digits) - self.places] + ("." + digits[len(digits) - self.places:] if self.places else "")
        return self.with_unit(("-" if value < 0 else "") + text)

    # What the tool is to say of words that came.

    def is_told(self, found, words):
        if "error" in found:
            return False
        if self.is_bit:
            return found["value"] is bool(words[0]) and found["raw"] == words[0]
        if self.bits is not None:
            low, high = self.bits
            value = words[0] >> low & (1 << (high - low + 1)) - 1
            return found["value"] == value and isinstance(found["value"], bool) == self.is_one_bit
        came = struct.pack(f">{len(words)}H", *words)
        raw = found["raw"]
        is_raw = raw == words[0] if len(words) == 1 else raw == "0x" + came.hex().upper()
        return is_raw and self.is_value(found, came)

    def is_value(self, found, came):
        value, text = found["value"], found["text"]
        if self.kind == "text":
            data = reordered(came, self.order)[:self.characters].partition(b"\0")[0].rstrip(b" ")
            return value == data.decode("ascii")
        packed = put_back(came, self.order)
        if self.kind in ("bcd16", "bcd32"):
            digits = packed.hex()
            return (value is None and "no BCD" in text) if not digits.isdigit() else self.is_amount(int(digits), value, text)
        number = struct.unpack(f">{SIZES[self.kind][0]}", packed)[0]
        if self.kind in ("f32", "f64"):
            return self.is_float(number, packed, value, text)
        if self.kind in ("hex", "bits", ""):
            return value == number and f"0x{number:04X}" in text
        return self.is_amount(number, value, text)

    def is_amount(self, count, value, text):
        exact = self.amount(count)
        return float(value) == float(exact) and text == self.number_text(exact)

    def is_float(self, number, packed, value, text):
        if not math.isfinite(number):
            return value is None
        if self.scale is None:
            return struct.pack(f">{SIZES[self.kind][0]}", value) == packed
        exact = self.amount(fractions.Fraction(number))
        most = max(abs(fractions.Fraction(number) * self.scale), abs(self.offset), abs(exact))
        error = fractions.Fraction(1, 10 ** 6 if self.kind == "f32" else 4 * 10 ** 15)
        if most > 1e300:
            return value is None or abs(fractions.Fraction(value) - exact) <= most * error
        return abs(fractions.Fraction(value) - exact) <= most * error + fractions.Fraction(5e-324) and text.endswith(self.unit)

    # What is written.

    def draw_words(self, chance):
        """Words that a server may hold."""
        if self.is_bit:
            return [chance.randrange(2)]
        if self.kind == "text":
            letters = [chance.randrange(32, 127) if chance.random() > 0.1 else chance.choice((0, 32)) for _ in range(2 * self.size)]
            return words_of(bytes(letters))
        if self.kind in ("bcd16", "bcd32") and chance.random() < 0.8:
            return words_of(reordered(bytes.fromhex("".join(chance.choices("0123456789", k=4 * self.size))), self.order))
        if chance.random() < 0.2:
            return words_of(reordered(self.edge(chance), self.order))
        return [chance.randrange(0x10000) for _ in range(self.size)]

    def edge(self, chance):
        return chance.choice((b"\0", b"\xff", b"\x80\0", b"\x7f\xff", b"\x7f\xf0\0", b"\x7f\xf8\0", b"\xff\x80")).ljust(
            2 * self.size, chance.choice((b"\0", b"\xff")))[:2 * self.size]

    def draw_value(self, chance):
        """A value as it is typed, and the words that struct makes of it; of bits those that they leave."""
        if self.is_bit:
            value = chance.randrange(2)
            return chance.choice((("off", "on")[value], str(value))), [value]
        if self.bits is not None:
            low, high = self.bits
            value = chance.randrange(1 << (high - low + 1))
            return ("off", "on")[value] if self.is_one_bit else chance.choice((str(value), hex(value))), [value << low]
        if self.kind == "text":
            data = bytes(chance.choice(b"abcXYZ0189+-_. ") for _ in range(chance.randrange(1, self.characters + 1)))
            data = b"x" + data[1:].rstrip()
            return data.decode(), words_of(reordered(data.ljust(2 * self.size, b"\0"), self.order))
        if self.kind in ("f32", "f64"):
            return self.draw_float(chance)
        return self.draw_count(chance)

    def draw_count(self, chance):
        is_packed = self.kind in ("bcd16", "bcd32")
        if is_packed:
            count = chance.choice((0, 10 ** (4 * self.size) - 1, chance.randrange(10 ** (4 * self.size))))
            packed = bytes.fromhex(str(count).rjust(4 * self.size, "0"))
        else:
            packed = self.edge(chance) if chance.random() < 0.15 else chance.randbytes(2 * self.size)
            count = struct.unpack(f">{SIZES[self.kind][0]}", packed)[0]
        words = words_of(reordered(packed, self.order))
        text = decimal(fractions.Fraction(self.amount(count)))
        is_long = len(text.replace("-", "").replace(".", "")) > 20
        ways = ["#" + str(count)] if is_long else [text + chance.choice(("", self.unit)), "#" + str(count)]
        if self.order in ("", "abcd") or self.kind in ("hex", "bits"):
            ways.append("0x" + packed.hex())
        return chance.choice(ways), words

    def draw_float(self, chance):
        letter = SIZES[self.kind][0]
        if self.scale is not None:
            text = f"{chance.choice((1, -1)) * chance.randrange(100, 100000)}"
            text = text[:-2] + "." + text[-2:]
            held = (fractions.Fraction(text) - self.offset) / self.scale
            return text + chance.choice(("", self.unit)), words_of(reordered(struct.pack(f">{letter}", float(held)), self.order))
        while True:
            packed = chance.randbytes(2 * self.size) if chance.random() < 0.5 else struct.pack(f">{letter}", chance.uniform(-1e6, 1e6))
            number = struct.unpack(f">{letter}", packed)[0]
            if math.isfinite(number):
                break
        digits = next(text for text in (f"{number:.{count}g}" for count in range(1, 18))
                      if abs(float(text)) < 3.5e38 and struct.pack(f">{letter}", float(text)) == packed or letter == "d" and float(text) == number)
        return digits, words_of(reordered(packed, self.order))


class Server:
    """Whose memory is told by itself."""

    def __init__(self, others, near_end, command):
        self.process = others.serve(near_end, [*command, "@", str(FIRST), str(COUNT)], stdin=subprocess.PIPE)

    def told(self, *words):
        self.process.stdin.write(" ".join(map(str, words)) + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().strip()

    def held(self, space):
        return [int(word, 16) for word in self.told("get", space, FIRST, COUNT).split()]

    def set(self, space, address, words):
        if self.told("set", space, address, *(f"{word:x}" for word in words)) != "done":
            raise RuntimeError("the server sets nothing")


def apart(chance, spaces, most, **how):
    """Drawn places that share no register."""
    taken, places = set(), []
    for _ in range(most):
        place = Place(chance, chance.choice(spaces), **how)
        cells = {(place.space, address) for address in place.spans()}
        if not cells & taken:
            taken |= cells
            places.append(place)
    return places


def check_reads(tool, check, server, chance, count):
    """The server's memory is set by itself, and read by the tool."""
    done = 0
    while done < count:
        places = apart(chance, list(SPACES), min(60, count - done))
        held = {}
        for place in places:
            held[place] = place.draw_words(chance)
            server.set(place.space, place.address, held[place])
        ended = tool.run("--no-listen", "--json", "read", *(place.word for place in places))
        found = ended.objects() if ended.status == DONE else []
        wrong = [(place.word, [f"{word:04x}" for word in held[place]], each) for place, each in zip(places, found)
                 if not place.is_told(each, held[place])]
        check(ended.status == DONE and len(found) == len(places) and not wrong,
              f"{done} values and more are read as struct has them",
              wrong or "" if len(found) == len(places) else (ended, [place.word for place in places]))
        done += len(places)


def check_writes(tool, check, server, chance, count, lacks, has_bits):
    """The tool writes, and the server's memory is looked at by itself: what was to be there, and nothing else."""
    server.told("lack", *lacks.split())
    lacking, done = set(lacks.split()), 0
    while done < count:
        narrow = "16" in lacking and chance.random() < 0.9
        places = apart(chance, ["holding", "holding", "coil"], min(40, count - done), narrow=narrow, has_bits=has_bits)
        if "16" in lacking:  # a value of several registers ends the command
            wide = [place for place in places if place.size > 1]
            places = [place for place in places if place.size == 1] + wide[:1]
        if not places:
            continue
        before = {space: server.held(space) for space in SPACES}
        wanted = {space: list(words) for space, words in before.items()}
        words = []
        for place in places:
            text, new = place.draw_value(chance)
            words.append(f"{place.word}={text}")
            if "16" in lacking and place.size > 1:
                continue
            at = place.address - FIRST
            if place.bits is not None:
                mask = (1 << (place.bits[1] + 1)) - (1 << place.bits[0])
                new = [wanted["holding"][at] & ~mask | new[0]]
            wanted[place.space][at:at + len(new)] = new
        ended = tool.run("--no-listen", "-d", "none", "--write", "--allow-run", "--json", "write", "--read-modify-write", *words)
        if ended.status == REFUSED and "hold a whole frame" in ended.errors:
            continue  # one of some 65 thousand
        is_refused = "16" in lacking and places[-1].size > 1
        held = {space: server.held(space) for space in SPACES}
        wrong = [(space, FIRST + i, f"{was:04x}", f"{found:04x} for {due:04x}") for space in SPACES
                 for i, (was, found, due) in enumerate(zip(before[space], held[space], wanted[space])) if found != due]
        due = DIFFERS if is_refused else DONE
        check(ended.status == due and not wrong and (not is_refused or "no function 16" in ended.output),
              f"{done} values and more are written as struct has them, to a unit that lacks {lacks or 'none'}",
              "" if ended.status == due and not wrong else (wrong or ended, words))
        done += len(places)
    server.told("lack")


def main(check, program, count, seed, *command):
    print("seed", seed)
    chance = random.Random(int(seed))
    with Tool(program) as tool, Programs() as others:
        if command[0] == "mbap":
            command, number = command[1:], free_port()
            near_end, tool.port = f"mbap:{number}", f"mbap://127.0.0.1:{number}"
        else:
            near_end, tool.port = others.line()
        server = Server(others, near_end, command)
        for space in SPACES:
            server.set(space, FIRST, [chance.randrange(2 if space in ("coil", "discrete") else 0x10000) for _ in range(COUNT)])
        plain, tool.run = tool.run, lambda *words: plain("-u", 1, "-b", 115200, "-f", "8N1", "--timeout", 0.3, *words)
        check_reads(tool, check, server, chance, int(count))
        # Function 22 leaves a server of jsmodbus deaf to all that follows.
        is_stuck_by_22 = command[-1] == "jsmodbus"
        for lacks in VARIANTS:
            check_writes(tool, check, server, chance, -(-int(count) // len(VARIANTS)), lacks, not is_stuck_by_22)


runs(main)
