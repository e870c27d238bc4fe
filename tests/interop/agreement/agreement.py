# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Random valid requests for our server, and what it has to answer: agreement.hpp once more, for a client in Python."""
import random

ADDRESSES = 0x10000
WINDOW = 4096
MOST = {1: 2000, 2: 2000, 3: 125, 4: 125, 15: 1968, 16: 123}  # of a request of each function
STATUS_AT, EVENTS_AT, MESSAGES_AT, COUNTERS_AT, ID_AT, LOG_AT = 0x8000, 0x8001, 0x8002, 0x8008, 0x8010, 0x8100


def input_word(address):
    return (address * 40503 + 7) & 0xFFFF


def input_bit(address):
    return bool(address * 40503 >> 9 & 1)


def record_at(file, record):
    return (file * 10007 + record) % ADDRESSES


class Lost(Exception):
    """No response: the machine was too slow."""


class Agreement:
    """A client is what has `read_bits`, `read_words`, `write_bit`, `write_word`, `write_bits` and `write_words`."""

    def __init__(self, client):
        self.client = client
        self.random = random.Random(3)
        self.held = [0] * ADDRESSES
        self.coils = [False] * ADDRESSES
        self.differences = self.repeated = self.asked = 0

    def ask(self, request, *words):
        """What the client returns; asked again where nothing came."""
        for _ in range(3):
            try:
                return request(*words)
            except Lost:
                self.repeated += 1
        raise Lost

    def expect(self, is_right, *what):
        if not is_right:
            self.differences += 1
            if self.differences <= 10:
                print("FAIL", *what)

    def word(self):
        return self.random.randrange(0x10000)

    def words(self, count):
        return [self.word() for _ in range(count)]

    def count(self, most):
        kind = self.random.randrange(8)
        if kind < 2:
            return (1, most)[kind]
        return self.random.randint(1, most // 4 + 1 if kind < 5 else most)

    def start(self, size):
        first = self.random.choice((0, ADDRESSES - WINDOW))
        last = first + WINDOW - size
        kind = self.random.randrange(16)
        return (first, last)[kind] if kind < 2 else self.random.randint(first, last)

    def read_bits(self, function, start, count):
        seen = self.ask(self.client.read_bits, function, start, count)
        told = (self.coils[start:start + count] if function == 1
                else [input_bit(at) for at in range(start, start + count)])
        self.expect(seen == told, f"{function:02} reads", start, count)

    def read_words(self, function, start, count):
        seen = self.ask(self.client.read_words, function, start, count)
        told = (self.held[start:start + count] if function == 3
                else [input_word(at) for at in range(start, start + count)])
        self.expect(seen == told, f"{function:02} reads", start, count)

    def write_bits(self, start, bits):
        self.expect(self.ask(self.client.write_bits, start, bits), "15 writes", start, len(bits))
        self.coils[start:start + len(bits)] = bits

    def write_words(self, start, words):
        self.expect(self.ask(self.client.write_words, start, words), "16 writes", start, len(words))
        self.held[start:start + len(words)] = words

    def request(self, function):
        """One random request."""
        if function in (1, 2):
            count = self.count(MOST[function])
            self.read_bits(function, self.start(count), count)
        elif function in (3, 4):
            count = self.count(MOST[function])
            self.read_words(function, self.start(count), count)
        elif function == 5:
            at, value = self.start(1), self.random.random() < 0.5
            self.expect(self.ask(self.client.write_bit, at, value), "05 writes", at, value)
            self.coils[at] = value
        elif function == 6:
            at, value = self.start(1), self.word()
            self.expect(self.ask(self.client.write_word, at, value), "06 writes", at, value)
            self.held[at] = value
        elif function == 15:
            bits = [self.random.random() < 0.5 for _ in range(max(2, self.count(MOST[15])))]
            self.write_bits(self.start(len(bits)), bits)
        elif function == 16:
            words = self.words(max(2, self.count(MOST[16])))
            self.write_words(self.start(len(words)), words)
        else:
            self.further(function)

    def each_part(self, function, visit_words, visit_bits):
        size, visit = (1024, visit_bits) if function in (1, 5, 15) else (64, visit_words)
        for first in (0, ADDRESSES - WINDOW):
            for at in range(first, first + WINDOW, size):
                visit(at, size)

    def fill(self, function):
        self.each_part(function, lambda at, count: self.write_words(at, self.words(count)),
                       lambda at, count: self.write_bits(at, [self.random.random() < 0.5 for _ in range(count)]))

    def sweep(self, function):
        self.each_part(function, lambda at, count: self.read_words(3, at, count),
                       lambda at, count: self.read_bits(1, at, count))

    def run(self, count, functions):
        for function in functions:
            self.fill(function)
            for _ in range(count):
                self.request(function)
            self.sweep(function)
            self.asked += count
            print("FAIL" if self.differences else "ok  ", f"function {function:02}: {count} requests")

    def status(self):
        print(f"differences: {self.differences}, asked again: {self.repeated}")
        return 1 if self.differences or self.repeated * 100 > self.asked else 0
