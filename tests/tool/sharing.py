# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Two units at one address, servers of pymodbus that share a line: `identify` and `scan` say so, and of one unit say nothing.

    python3 sharing.py TOOL
"""
import os
import select
import subprocess
import sys
import threading
import time
import tty

from support import DIFFERS, DONE, HERE, Tool, Units, runs, with_crc

from pair import Programs  # noqa: I100


class Hub:
    """with Hub(ends) as hub: `hub.names[0]` is the client's end; what it says goes to all others, what they say to it, those
    behind the first so many seconds later."""

    def __init__(self, ends, later):
        self.pairs, self.later = [os.openpty() for _ in range(ends)], later
        for _, far in self.pairs:
            tty.setraw(far)
        self.names = [os.ttyname(far) for _, far in self.pairs]

    def __enter__(self):
        self.is_running = True
        self.thread = threading.Thread(target=self.carry)
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.is_running = False
        self.thread.join()
        for pair in self.pairs:
            for each in pair:
                os.close(each)

    def carry(self):
        near = [each for each, _ in self.pairs]
        while self.is_running:
            for each in select.select(near, [], [], 0.05)[0]:
                data = os.read(each, 4096)
                if each == near[0]:
                    for other in near[1:]:
                        os.write(other, data)
                else:
                    time.sleep(self.later if each != near[1] else 0)
                    os.write(near[0], data)


SERVER = [sys.executable, "-B", str(HERE.parent / "interop" / "pymodbus_server.py"), "@"]


def check_servers(tool, check, later):
    for servers in (1, 2):
        with Hub(servers + 1, later) as hub, Programs() as others:
            for name in hub.names[1:]:
                others.serve(name, SERVER, stderr=subprocess.DEVNULL)
            tool.port = hub.names[0]
            ended = tool.run("--no-listen", "--json", "identify")
            is_told = "several units answer at this address" in ended.objects()[0]["note"]
            check(is_told == (servers == 2) and ended.status == (DIFFERS if is_told else DONE),
                  f"{servers} servers, {later} s apart: identify", ended)
            ended = tool.run("--no-listen", "--json", "scan", "--units", "1-2")
            check(len(ended.objects()) == 1 and ("several units answer" in ended.objects()[0]["note"]) == (servers == 2),
                  f"{servers} servers, {later} s apart: a scan", ended)


def check_collision(tool, check):
    """Two that speak at once: each answer begins right and is damaged."""
    class Both(Units):
        def answer(self, request):
            answer = super().answer(request)
            if request[1] == 43:
                answer = with_crc(bytes([7, 43, 14, 1, 1, 0, 0, 1, 0, 5]) + b"Maker")
            return answer and answer[:3] + bytes(each & 0x5A for each in answer[3:])

    with Both({7: {3201: 5, 0: 1}}) as line:
        tool.port = line.name
        for words in (["-u", 7, "identify"], ["scan", "--units", "7"]):
            ended = tool.run("--no-listen", "--timeout", 0.3, "--json", *words)
            rows = ended.objects()
            check(len(rows) == 1 and "two units may have this address" in rows[0]["note"], f"{words}: a collision", ended)


def main(check, program):
    with Tool(program) as tool:
        for later in (0, 0.03):
            check_servers(tool, check, later)
        check_collision(tool, check)


runs(main)
