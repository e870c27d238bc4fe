# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""How many requests each kind of `read` sends, and how long the program takes beside the line: from its start to its end, less
the time from each request to its response; the median of so many rounds.

    /usr/bin/python3 bench/tool/round_trips.py TOOL [ROUNDS]

TOOL is to be optimised: build/release/tools/rtuwire/rtuwire. The unit is this script's own, on a pseudo-terminal, and
answers at once; a drive is `rtuwire simulate`, whose own time is in the figure. More requests than a read needs are a
failure; times are figures of the machine, and none. A drive that was not said is asked who it is, since the same word is
another register of another drive; an ATV28, which cannot say, is told by its registers.
"""
import pathlib
import statistics
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tests" / "tool"))

from support import DONE, Line, Simulator, Tool, with_crc  # noqa: E402

MOST_MS, MOST_START_MS = 20, 30
FILE = '[[register]]\nname = "l1"\nspace = "input"\naddress = 1000\ntype = "f32"\norder = "cdab"\nunit = "V"\n'


class Unit(Line):
    """Has every register and coil, at any address. Notes when it was asked and when it had answered."""

    def __init__(self):
        super().__init__()
        self.functions, self.line_time = [], 0.0

    def hear(self, data):
        asked = time.perf_counter()
        super().hear(data)
        unit, function, count = data[0], data[1], int.from_bytes(data[4:6], "big")
        self.functions.append(function)
        size = 2 * count if function in (3, 4) else (count + 7) // 8
        known = function in (1, 2, 3, 4)
        self.say(with_crc(bytes([unit, function, size]) + bytes(size) if known else bytes([unit, function | 0x80, 1])))
        self.line_time += time.perf_counter() - asked


def timed(tool, words, port):
    began = time.perf_counter()
    ended = tool.run("--no-listen", *words, port=port)
    taken = time.perf_counter() - began
    if ended.status != DONE:
        raise SystemExit(f"round_trips.py: {words}: {ended}")
    return 1000 * taken


def beside_line(tool, words, rounds):
    """Numbers of the functions that were asked by, and milliseconds."""
    times = []
    for _ in range(rounds):
        with Unit() as unit:
            taken = timed(tool, words, unit.name)
            times.append(taken - 1000 * unit.line_time)
            asked = unit.functions
    return asked, statistics.median(times)


def of_drive(tool, drive, words, rounds):
    """The same of a simulated drive, whose own time is in it."""
    with Simulator(tool.program, f"{drive}:7") as device:
        shown = tool.run("--no-listen", "-v", *words, port=device).errors
        asked = [int(line.split(">")[1].split()[1], 16) for line in shown.splitlines() if " > " in line]
        return asked, statistics.median(timed(tool, words, device) for _ in range(rounds))


def main(program, rounds=9):
    rounds = int(rounds)
    with Tool(program) as tool:
        (tool.place / "meter.toml").write_text(FILE)
        rows = []
        start = statistics.median(timed(tool, ["list"], "sim:atv320:7") for _ in range(rounds))
        rows.append(("start, no line (list)", [], start, MOST_START_MS, 0))
        for what, words, most in (
                ("a float of a place", ["-u", 61, "read", "input:1000:f32:cdab"], 1),
                ("... of a register file", ["-u", 61, "--device", "meter.toml", "read", "l1"], 1),
                ("a coil", ["-u", 61, "read", "coil:3"], 1),
                ("a bit of a register", ["-u", 61, "read", "holding:40.3"], 1),
                ("125 registers", ["-u", 61, "read", "holding:0-124"], 1),
                ("two units", ["-u", "61,62", "read", "holding:40"], 2),
                ("an address, nothing said", ["-u", 61, "-d", "none", "read", "40"], 1)):
            rows.append((what, *beside_line(tool, words, rounds), MOST_MS, most))
        for what, drive, words, most in (
                ("a drive's word, drive said", "atv320", ["-u", 7, "-d", "atv320", "read", "RFR"], 1),
                ("... not said: asked by 2B", "atv320", ["-u", 7, "read", "RFR"], 2),
                ("... that has no function 2B", "atv28", ["-u", 7, "read", "RFR"], 7)):
            rows.append((what, *of_drive(tool, drive, words, rounds), MOST_MS, most))
        print(f"{'':30} requests  {'functions':30} {'ms':>6}")
        for what, asked, taken, _, _ in rows:
            print(f"{what:30} {len(asked):8}  {' '.join(f'{each:02X}' for each in asked):30} {taken:6.1f}")
        print(f"later than {MOST_MS} ms, or a start than {MOST_START_MS} ms:",
              ", ".join(what for what, _, taken, most, _ in rows if taken > most) or "none")
        talkative = [what for what, asked, _, _, most in rows if len(asked) > most]
        print("more requests than needed:", ", ".join(talkative) or "none")
        return 1 if talkative else 0


sys.exit(main(*sys.argv[1:]))
