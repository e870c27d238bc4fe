# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A program on a terminal of its own, whose screen can be read."""
import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios
import time

import pyte

from support import own_terminal

LIMIT = 60.0  # s, for what has to happen
LEAVES = b"\x1b[?1049l"  # the end of the whole screen
FORM = {"TERM": "screen-256color", "LC_ALL": "C.UTF-8"}  # what pyte understands


class Screen:
    """with Screen([program, ...], 80, 24) as screen: ..."""

    def __init__(self, words, width=80, height=24, **environment):
        self.keyboard, self.terminal = pty.openpty()
        self.before = termios.tcgetattr(self.terminal)
        self.shown = pyte.Screen(width, height)
        self.stream = pyte.ByteStream(self.shown)
        self.raw = b""
        self._set_size(width, height)
        forms = {**os.environ, **FORM, **environment}
        forms.pop("NO_COLOR", None)
        forms.pop("LINES", None)
        forms.pop("COLUMNS", None)
        self.process = subprocess.Popen(words, stdin=self.terminal, stdout=self.terminal, stderr=self.terminal,
                                        env=forms, preexec_fn=own_terminal(self.terminal))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for each in (self.keyboard, self.terminal):
            if each is not None:
                os.close(each)

    def _set_size(self, width, height):
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", height, width, 0, 0))

    def resize(self, width, height):
        self.shown.resize(height, width)
        self._set_size(width, height)

    def close(self):
        """The terminal goes away, as a window that is closed."""
        os.close(self.keyboard)
        self.keyboard = None

    def type(self, keys):
        os.write(self.keyboard, keys.encode())

    def take(self, seconds):
        """Reads what the program draws, for a time."""
        until = time.monotonic() + seconds
        while (left := until - time.monotonic()) > 0:
            if not select.select([self.keyboard], [], [], left)[0]:
                return
            try:
                drawn = os.read(self.keyboard, 65536)
            except OSError:
                return
            self.raw += drawn
            self.stream.feed(drawn)

    @property
    def lines(self):
        return [each.rstrip() for each in self.shown.display]

    @property
    def text(self):
        return "\n".join(self.lines)

    def until(self, is_so, seconds=LIMIT):
        """Whether something becomes true of the screen. In steps that are short beside what a person notices."""
        until = time.monotonic() + seconds
        while not is_so():
            if time.monotonic() > until:
                return False
            self.take(0.02)
        return True

    def until_shown(self, pattern, seconds=LIMIT):
        return self.until(lambda: re.search(pattern, self.text, re.MULTILINE), seconds)

    def is_red(self, text):
        """Whether all letters of a text that is on the screen are red, somewhere."""
        for row, line in enumerate(self.shown.display):
            for found in re.finditer(re.escape(text), line):
                cells = [self.shown.buffer[row][column] for column in range(*found.span())]
                if all(each.fg == "red" for each in cells):
                    return True
        return False

    def end(self, seconds=LIMIT):
        """The status with which the program ends by itself; None where it does not."""
        self.until(lambda: self.process.poll() is not None, seconds)
        seen = -1
        while seen != len(self.raw):  # what it drew last may be much
            seen = len(self.raw)
            self.take(0.05)
        return self.process.poll()

    def is_restored(self):
        """Whether the settings are what they were, the whole screen is left, and the cursor is to be seen."""
        after = termios.tcgetattr(self.terminal)
        drawn, left, rest = self.raw.rpartition(LEAVES)
        return after == self.before and bool(left) and b"\x1b[?1049h" in drawn and not self.shown.cursor.hidden \
            and b"\x1b[?1049h" not in rest
