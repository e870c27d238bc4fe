# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Memory after an hour (of captures: six) and after a day of what a command does, as fast as it goes: it does not grow.
A day has an exchange a second, a round a second; of `monitor` it is half a minute, with a round as often as it can.

    python3 days.py TOOL play|watch|monitor|sniff
"""
import os
import pathlib
import struct
import time

from line_between import LineBetween
from support import Simulator, Tool, runs, with_crc

HOUR, DAY = 3_600, 86_400
EARLY = 6 * HOUR  # pipes hold an hour of it
MOST_GROWTH = 64  # KiB: what an allocator may take for itself; a byte an exchange would be more
START = 1_700_000_000


def own_memory(process):
    """KiB; without the pages of its code, which come when they are needed."""
    for line in pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii").splitlines():
        if line.startswith("RssAnon:"):
            return int(line.split()[1])
    return 0


class Growth:
    """Looks at the memory of a process early in its work, and again at the end."""

    def __init__(self, process):
        self.process, self.before = process, None

    def early(self):
        self.before = own_memory(self.process)

    def end(self, check, what):
        late = own_memory(self.process)
        check(self.before and late - self.before <= MOST_GROWTH, f"{what}: KiB of memory early and late",
              (self.before, late))


def exchange(second):
    """A read of one of thirty units and its response; now and then none, or a damaged one."""
    unit = 1 + second % 30
    request = with_crc(bytes([unit, 3, 0x0C, 0x82, 0, 1]))
    response = with_crc(bytes([unit, 3, 2]) + (second % 600).to_bytes(2, "big"))
    if second % 50 == 7:
        return [request]
    return [request, response if second % 40 != 3 else response[:-1] + bytes([response[-1] ^ 1])]


EXCHANGES = [exchange(second) for second in range(600)]


def packets(second):
    """Of link type 147, so that the listener judges them."""
    made = b""
    for number, data in enumerate(EXCHANGES[second % len(EXCHANGES)]):
        # The response comes after 5 to 904 ms: a day has many different ones.
        at = 5_000 + (number and 10_000 + 1_000 * (second * 7 % 350))
        made += struct.pack("<IIII", START + second, at, len(data), len(data)) + data
    return made


def play(tool, check):
    """A day of a line, an exchange a second, through the listener and what shows and counts it."""
    for words in (["--json", "replay"], ["replay"], ["timing"]):
        ends = os.pipe()
        with open(os.devnull, "wb") as nothing:
            process = tool.start(*words, "/dev/stdin", stdin=ends[0], stdout=nothing, stderr=None)
        os.close(ends[0])
        with os.fdopen(ends[1], "wb", buffering=1 << 16) as pipe:
            pipe.write(bytes.fromhex("d4c3b2a1020004000000000000000000ffff000093000000"))
            growth = Growth(process)
            for second in range(DAY):
                pipe.write(packets(second))
                if second == EARLY:
                    growth.early()
            pipe.flush()
            growth.end(check, " ".join(words))
        check(process.wait(timeout=60) == 0, "it ends well")


def watch(tool, check):
    """Rounds of a period of one second, at once."""
    process = tool.start("--csv", "-u", 7, "watch", "RFR", "LCR", "ETA", "--every", "0s", port="sim:atv320:7")
    growth = Growth(process)
    for rounds in range(DAY):
        if not process.stdout.readline():
            check(False, "it goes on", rounds)
            break
        if rounds == HOUR:
            growth.early()
    growth.end(check, "watch")
    process.kill()
    process.communicate()


def sniff(tool, check):
    """As many exchanges as a day has seconds, through a line; kept in a capture besides."""
    with Simulator(tool.program, "atv320:7") as device, LineBetween(device) as line:
        with open(os.devnull, "wb") as nothing:
            process = tool.start("--json", "sniff", "-o", os.devnull, port=line.tap_name, stdout=nothing)
        time.sleep(0.5)
        growth = Growth(process)
        for second in range(0, DAY, 20):
            line.say_to_tap(b"".join(data for near in range(20) for data in EXCHANGES[(second + near) % 600]))
            if second == HOUR:
                growth.early()
        growth.end(check, "sniff")
        process.terminate()
        process.communicate()


def monitor(tool, check):
    """Rounds as often as it can, while the screen is drawn."""
    from screen import Screen
    words = [tool.program, "--port", "sim:atv320:7,atv12:3", "-u", "7,3", "monitor", "--every", "1ms"]
    with Screen(words) as page:
        check(page.until_shown(r"^ +7 +atv320 +switch on disabled"), "it is shown", page.text)
        page.take(5)
        growth = Growth(page.process)
        growth.early()
        page.take(25)
        growth.end(check, "monitor")
        page.type("q")
        check(page.end() == 0, "and ends", page.text)


PARTS = {each.__name__: each for each in (play, watch, sniff, monitor)}


def main(check, program, part):
    with Tool(program) as tool:
        PARTS[part](tool, check)


runs(main)
