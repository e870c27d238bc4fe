# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A wire between a pseudo-terminal and devices of this test's own: what passes is bits, sampled by a UART of each end. A
pseudo-terminal has no bit rate, but its master shows what a program set there; of the parity it only keeps PARODD, so that
8E1 and 8N1 are alike: as 8E1 here."""
import collections
import os
import termios
import threading
import time

from support import Line, Units, crc, with_crc

RATES = {getattr(termios, f"B{rate}"): rate
         for rate in (300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200)}


def levels_of(data, rate, form):
    """The bits of a burst as (time, level), from its first start bit on; the line rests behind the last."""
    at, levels = 0.0, []
    for byte in data:
        bits = [0] + [byte >> i & 1 for i in range(8)]
        if form[1] != "N":
            bits.append(bin(byte).count("1") % 2 ^ (form[1] == "O"))
        for bit in bits + [1] * int(form[2]):
            levels.append((at, bit))
            at += 1 / rate
    return levels + [(at, 1)]


def sampled(levels, rate, form):
    """What a UART hears of them: (byte, whether it is damaged). It begins at a falling edge, samples the middle of each bit and
    looks at the first stop bit only."""
    edges, index = [], 0

    def level_at(when):
        nonlocal index
        while index + 1 < len(levels) and levels[index + 1][0] <= when + 1e-12:
            index += 1
        return levels[index][1]

    for before, after in zip([(0.0, 1), *levels], levels):
        if before[1] == 1 and after[1] == 0:
            edges.append(after[0])
    heard, free = [], 0.0
    for edge in edges:
        if edge < free - 1e-12 or level_at(edge + 0.5 / rate) != 0:
            continue
        byte = sum(level_at(edge + (1.5 + i) / rate) << i for i in range(8))
        bits = 9
        wrong = False
        if form[1] != "N":
            wrong = level_at(edge + 9.5 / rate) != bin(byte).count("1") % 2 ^ (form[1] == "O")
            bits = 10
        stop = level_at(edge + (bits + 0.5) / rate)
        heard.append((byte, wrong or stop == 0))
        free = edge + (bits + 0.5) / rate
    return heard


def through(data, sender, receiver):
    """What arrives of a burst. An undamaged byte is itself; a pseudo-terminal marks nothing, so a damaged one is another."""
    return [(byte ^ 0x55 if bad else byte, bad) for byte, bad in sampled(levels_of(data, *sender), *receiver)]


def host_of(number):
    """How the program has set its end."""
    flags, rate = termios.tcgetattr(number)[2], termios.tcgetattr(number)[4]
    form = "8O1" if flags & termios.PARODD else "8N2" if flags & termios.CSTOPB else "8E1"
    return RATES[rate], form


class SetUnits(Units):
    """Units that are set to one bit rate and format, and answer at that after a time. A frame with a damaged byte is dropped,
    where parity is looked at. Those without holding registers (None) know function 04 only; `inputs` are its registers."""

    def __init__(self, units, rate, form, inputs=None, takes=0.005, checks_parity=True):
        super().__init__(units)
        self.setting, self.inputs, self.takes, self.checks_parity = (rate, form), inputs or {}, takes, checks_parity
        self.settings = []  # of the program, in the order in which it sent
        self.sent = []  # (setting, when) of each of its frames
        self.unheard = 0  # frames that were none to these units

    def hear(self, data):
        Line.hear(self, data)
        host = host_of(self.near)
        if host not in self.settings[-1:]:
            self.settings.append(host)
        while data:  # on a busy machine several requests come at once
            size = 7 if data[1:2] == b"\x2b" else 8
            self.hear_frame(data[:size], host)
            data = data[size:]

    def least_seconds(self):
        """How long the program asked, without what a busy machine adds: of all frames at a bit rate the shortest time to the
        next counts for each."""
        least, counts = {}, collections.Counter()
        for (setting, at), (_, after) in zip(self.sent, self.sent[1:]):
            rate = setting[0]
            counts[rate] += 1
            least[rate] = min(after - at, least.get(rate, after - at))
        return sum(least[rate] * counts[rate] for rate in counts)

    def hear_frame(self, data, host):
        self.sent.append((host, time.monotonic()))
        heard = sampled(levels_of(data, *host), *self.setting)
        is_damaged = self.checks_parity and any(bad for _, bad in heard)
        request = bytes(byte for byte, _ in heard)
        if is_damaged or len(request) < 4 or crc(request) != 0:
            self.unheard += 1
            return
        self.requests.append(request)
        if answer := self.answer(request):
            threading.Timer(self.takes, self.send, [answer]).start()

    def send(self, data):
        """To the program, as it is set now."""
        self.say(bytes(byte for byte, _ in through(data, self.setting, host_of(self.near))))

    def answer(self, request):
        unit, function = request[0], request[1]
        if unit not in self.units or self.units[unit] is not None:
            return super().answer(request)
        if function != 4:
            return with_crc(bytes([unit, function | 0x80, 1]))
        start, count = int.from_bytes(request[2:4], "big"), int.from_bytes(request[4:6], "big")
        asked = range(start, start + count)
        if not all(each in self.inputs for each in asked):
            return with_crc(bytes([unit, 0x84, 2]))
        return with_crc(bytes([unit, 4, 2 * count]) + b"".join(self.inputs[each].to_bytes(2, "big") for each in asked))


class Talk(Line):
    """A client and a unit that talk at one setting, period after period, whoever listens."""

    def __init__(self, rate, form, unit=17, period=0.1):
        super().__init__()
        self.setting, self.period, self.is_over = (rate, form), period, threading.Event()
        request = with_crc(bytes([unit, 3, 0, 107, 0, 3]))
        response = with_crc(bytes([unit, 3, 6]) + bytes.fromhex("AE415652 4340"))
        self.frames = [request, response]
        self.talker = threading.Thread(target=self.talk, daemon=True)

    def __enter__(self):
        super().__enter__()
        self.talker.start()
        return self

    def __exit__(self, *how):
        self.is_over.set()
        self.talker.join()
        super().__exit__(*how)

    def talk(self):
        while not self.is_over.wait(self.period):
            for each in self.frames:
                os.write(self.near, bytes(byte for byte, _ in through(each, self.setting, host_of(self.near))))
                time.sleep(0.004 + 11 * len(each) / self.setting[0])
