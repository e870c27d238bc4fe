# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line between a client and simulated drives, that keeps what the client sent."""
import array
import fcntl
import os
import pty
import select
import termios
import threading
import time
import tty

SIZES = {3: 8, 4: 8, 43: 7}  # bytes of requests that only read


def _target(link):
    try:
        return os.readlink(link)
    except OSError:
        return None


class LineBetween:
    """with LineBetween(device) as line: ... line.name ... line.sent"""

    def __init__(self, device):
        self.client, self.end = pty.openpty()
        tty.setraw(self.end)
        self.name = os.ttyname(self.end)
        self.drives = os.open(device, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.drives)
        self.sent = b""
        self.tap, self.tap_end = pty.openpty()  # where a listener gets the bytes of both directions
        tty.setraw(self.tap_end)
        self.tap_name = os.ttyname(self.tap_end)
        self.is_tapped = False
        self.shall_end = False
        self.thread = threading.Thread(target=self._run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.shall_end = True
        self.thread.join()
        for each in (self.client, self.end, self.drives, self.tap, self.tap_end):
            os.close(each)

    def _run(self):
        other = {self.client: self.drives, self.drives: self.client}
        while not self.shall_end:
            for each in select.select(list(other), [], [], 0.05)[0]:
                moved = os.read(each, 512)
                if each == self.client:
                    self.sent += moved
                if self.is_tapped:
                    os.write(self.tap, moved)
                os.write(other[each], moved)

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
        found, rest = [], self.sent
        while len(rest) > 1:
            found.append(rest[1])
            rest = rest[SIZES[rest[1]]:]
        return found
