# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line between a client and simulated drives, that keeps what the client sent."""
import array
import fcntl
import os
import termios
import time
import tty

from support import Line

SIZES = {3: 8, 4: 8, 43: 7}  # bytes of requests that only read


def _target(link):
    try:
        return os.readlink(link)
    except OSError:
        return None


class LineBetween(Line):
    """with LineBetween(device) as line: ... line.name ... line.heard"""

    def __init__(self, device):
        super().__init__(device)
        self.tap, self.tap_end = os.openpty()  # where a listener gets the bytes of both directions
        tty.setraw(self.tap_end)
        self.tap_name = os.ttyname(self.tap_end)
        self.is_tapped = False

    def __exit__(self, *how):
        super().__exit__(*how)
        os.close(self.tap)
        os.close(self.tap_end)

    def hear(self, data):
        super().hear(data)
        if self.is_tapped:
            self.say_to_tap(data)

    def say(self, data):
        if self.is_tapped:
            self.say_to_tap(data)
        super().say(data)

    def listen_to(self, process):
        """From when the process has the tap open, and has dropped what was there before."""
        folder = f"/proc/{process.pid}/fd"
        while process.poll() is None and self.tap_name not in map(_target, (f"{folder}/{each}" for each in os.listdir(folder))):
            time.sleep(0.01)
        time.sleep(0.15)
        self.is_tapped = True

    def wait_until_read(self, settles=0.3):
        """Until the listener has read what was said, and has seen the silence behind it."""
        left = array.array("i", [1])
        while left[0]:
            time.sleep(0.01)
            fcntl.ioctl(self.tap_end, termios.FIONREAD, left)
        time.sleep(settles)

    def say_to_tap(self, data):
        """Bytes that only the listener gets."""
        os.write(self.tap, data)

    def functions(self):
        """The function codes of all requests; raises KeyError at the first that does more than read."""
        found, rest = [], self.heard
        while len(rest) > 1:
            found.append(rest[1])
            rest = rest[SIZES[rest[1]]:]
        return found
