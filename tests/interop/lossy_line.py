# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line to a unit that loses every second request: the stand-in that shows that repetitions are counted."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "programs"))

from frames import Line  # noqa: E402


class LossyLine(Line):
    """with LossyLine(device) as lossy: what is sent to `lossy.name` reaches the device every other time."""
    requests, lost = 0, 0

    def __exit__(self, *how):
        super().__exit__(*how)
        print("requests lost on purpose:", self.lost)

    def pass_on(self, data):
        self.requests += 1  # a client writes a request at once, and waits then
        if self.requests % 2:
            super().pass_on(data)
        else:
            self.lost += 1
