# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Serial lines of this test program's own, on which every byte is kept, and what a frame is."""
import os
import select
import threading
import tty

SHORTEST, LONGEST = 4, 256


def crc(data):
    remainder = 0xFFFF
    for byte in data:
        remainder ^= byte
        for _ in range(8):
            remainder = remainder >> 1 ^ (0xA001 if remainder & 1 else 0)
    return remainder


def with_crc(data):
    return data + crc(data).to_bytes(2, "little")


def are_frames(data):
    """Whether these are nothing but whole frames, one behind the other. A CRC over a frame and its CRC is 0."""
    while data:
        ends = [end for end in range(SHORTEST, min(LONGEST, len(data)) + 1) if crc(data[:end]) == 0]
        if not ends:
            return False
        data = data[ends[0]:]
    return True


class Line:
    """with Line() as line: a program opens `line.name`, and `line.heard` is what it wrote there. What the program
    asks goes on to `far`, a device, if there is one."""

    def __init__(self, far=None):
        self.near, self.kept_open = os.openpty()
        tty.setraw(self.kept_open)
        self.name = os.ttyname(self.kept_open)
        self.far = os.open(far, os.O_RDWR | os.O_NOCTTY) if far else None
        if far:
            tty.setraw(self.far)
        self.ends = os.pipe()
        self.heard = b""
        self.thread = threading.Thread(target=self.forward, daemon=True)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        os.write(self.ends[1], b".")
        self.thread.join()
        for number in (self.near, self.kept_open, *self.ends, *([self.far] if self.far else [])):
            os.close(number)

    def say(self, data):
        os.write(self.near, data)

    def hear(self, data):
        self.heard += data

    def pass_on(self, data):
        os.write(self.far, data)

    def forward(self):
        watched = [self.near, self.ends[0]] + ([self.far] if self.far else [])
        while True:
            ready, _, _ = select.select(watched, [], [])
            if self.near in ready:
                data = os.read(self.near, 512)
                self.hear(data)
                if self.far:
                    self.pass_on(data)
            if self.far in ready:
                self.say(os.read(self.far, 512))
            if self.ends[0] in ready:
                return


class CountedLine(Line):
    """Acts at the client's n-th request, before that reaches `far`: a moment that does not depend on how fast anybody is."""

    def __init__(self, far, number=0, act=None):
        super().__init__(far)
        self.number, self.act, self.requests = number, act, 0

    def hear(self, data):
        super().hear(data)
        self.requests += 1  # a client writes a request at once, and waits then
        if self.requests == self.number:
            self.act()


class LossyLine(CountedLine):
    """Loses every second request: the stand-in that shows that repetitions are counted."""

    def __exit__(self, *how):
        super().__exit__(*how)
        print("requests lost on purpose:", self.requests // 2)

    def pass_on(self, data):
        if self.requests % 2:
            super().pass_on(data)
