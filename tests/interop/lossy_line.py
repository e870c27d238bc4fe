# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line to a unit that loses every second request: the stand-in that shows that repetitions are counted."""
import os
import select
import threading
import tty


class LossyLine:
    """with LossyLine(device) as lossy: what is sent to `lossy` reaches the device every other time."""

    def __init__(self, device):
        self.far = os.open(device, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.far)
        self.near, self.kept_open = os.openpty()
        tty.setraw(self.kept_open)
        self.ends = os.pipe()
        self.lost = 0
        self.thread = threading.Thread(target=self.forward, daemon=True)

    def __enter__(self):
        self.thread.start()
        return os.ttyname(self.kept_open)

    def __exit__(self, *_):
        os.write(self.ends[1], b".")
        self.thread.join()
        for number in (self.far, self.near, self.kept_open, *self.ends):
            os.close(number)
        print("requests lost on purpose:", self.lost)

    def forward(self):
        requests = 0
        while True:
            ready, _, _ = select.select([self.near, self.far, self.ends[0]], [], [])
            if self.ends[0] in ready:
                return
            if self.far in ready:
                os.write(self.near, os.read(self.far, 512))
            if self.near in ready:
                # A client writes a request at once, and waits then.
                request = os.read(self.near, 512)
                requests += 1
                if requests % 2:
                    os.write(self.far, request)
                else:
                    self.lost += 1
