# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Units that answer each request, in their order, and later than all times: no value is told of a register that is another's.
Each register holds its address, so that a value at the wrong one is seen.

    python3 late_units.py TOOL [PART ...]
"""
import collections
import concurrent.futures
import functools
import itertools
import json
import queue
import threading
import time

from support import DONE, NO_ANSWER, Line, Tool, Units, runs, with_crc

UNIT = 9
HERE = [*range(100, 140), *range(200, 203), *range(300, 340), 500]  # the addresses that the unit has
READ = ["100", "110", "201", "300", "339", "500"]


class LateUnit(Units):
    """with LateUnit(...) as line: ... line.requests. Answers the functions `known`, and refuses the others, or is silent to them.
    `lag(n)`: so many requests more have to come before the n-th (1, 2, ...) is answered. `delay`: or so many seconds pass."""

    def __init__(self, known=(3, 4, 6, 8, 16, 43), refuses=True, most=125, lag=None, delay=None):
        super().__init__({})
        self.known, self.refuses, self.most, self.lag, self.delay = known, refuses, most, lag, delay
        self.held = {each: each for each in HERE}
        self.owed, self.due = collections.deque(), queue.SimpleQueue()
        self.speaker = threading.Thread(target=self.speak_in_time, daemon=True)

    def __enter__(self):
        self.speaker.start()
        return super().__enter__()

    def __exit__(self, *how):
        self.due.put(None)
        self.speaker.join()
        super().__exit__(*how)

    def hear(self, data):
        Line.hear(self, data)
        self.waiting += data
        while request := self.next_request():
            self.requests.append(request)
            answer, number = self.answer(request), len(self.requests)  # what it holds now
            if self.delay:
                self.due.put((time.monotonic() + self.delay, answer))
                continue
            self.owed.append((number + self.lag(number), answer))
            while self.owed and self.owed[0][0] <= number:
                self.say(self.owed.popleft()[1])

    def speak_in_time(self):
        while due := self.due.get():
            time.sleep(max(0.0, due[0] - time.monotonic()))
            self.say(due[1])

    def answer(self, request):
        unit, function = request[0], request[1]
        refusal = lambda code: with_crc(bytes([unit, function | 0x80, code]))
        if unit != UNIT:
            return b""
        if function not in self.known:
            return refusal(1) if self.refuses else b""
        if function == 8:
            return request
        if function == 43:
            return with_crc(bytes([unit, 43, 14, 1, 1, 0, 0, 2, 0, 5]) + b"Maker" + bytes([1, 6]) + b"Module")
        start, value = int.from_bytes(request[2:4], "big"), int.from_bytes(request[4:6], "big")
        if function in (3, 4):
            if value > self.most:
                return refusal(3)
            if not all(each in self.held for each in range(start, start + value)):
                return refusal(2)
            other = 0x8000 if function == 4 else 0
            words = b"".join((self.held[each] ^ other).to_bytes(2, "big") for each in range(start, start + value))
            return with_crc(bytes([unit, function, 2 * value]) + words)
        if start not in self.held:
            return refusal(2)
        if function == 6:
            self.held[start] = value
            return request
        for i in range(value):
            self.held[start + i] = int.from_bytes(request[7 + 2 * i:9 + 2 * i], "big")
        return with_crc(request[:6])


HOLDING = {
    "all functions": {},
    "03 alone, others refused": {"known": (3, 6)},
    "03 alone, silent to others": {"known": (3, 6), "refuses": False},
    "one register a request": {"known": (3, 6, 43), "most": 1},
    "one register a request, silent to others": {"known": (3, 6), "refuses": False, "most": 1},
}
KINDS = {**HOLDING, "04 alone, others refused": {"known": (4,)}, "04 alone, silent to others": {"known": (4,), "refuses": False}}


def late_for(count, most):
    """The first `count` requests are answered when `most` more have come; those behind them at once."""
    return lambda number: most if number <= count else 0


def late_within(first, last, most=1):
    return lambda number: most if first <= number <= last else 0


def always(most):
    return late_for(1_000_000, most)


def how(line, retries=0, timeout=0.1):
    return ["--port", line.name, "--no-listen", "--timeout", timeout, "--retries", retries, "-u", UNIT]


def may_recover(kind):
    """Whether one of its answers can be told from those that it owes."""
    return "one register a request, silent" not in kind and "04 alone, silent" not in kind


class Cases:
    """They wait for nearly all of their time: side by side. Each returns what it has seen; what is checked of that is told in order."""

    def __init__(self, tool, check):
        self.tool, self.check, self.cases = tool, check, []

    def add(self, judge, of, *words, **unit):
        self.cases.append((judge, of, words, unit))

    def run_one(self, case):
        judge, of, words, unit = case
        with LateUnit(**unit) as line:
            ended = self.tool.run(*how(line, **of), *words)
            return judge, ended, line

    def run(self):
        with concurrent.futures.ThreadPoolExecutor(12) as workers:
            for judge, ended, line in workers.map(self.run_one, self.cases):
                judge(ended, line)


def wrong_values(rows, other=0):
    return [row for row in rows if "error" not in row and row["raw"] != row["address"] ^ other]


def check_read(cases, check):
    for kind, of in KINDS.items():
        other = 0x8000 if 3 not in of.get("known", (3,)) else 0
        words = ["--drive", "none", "--json", "read", *[f"input:{each}" if other else each for each in READ]]

        def judge(ended, line, what, is_late_once, kind=kind, other=other):
            rows = ended.objects()
            check(len(rows) == len(READ) and not wrong_values(rows, other), f"{kind}, {what}: no value is another's", (ended, line.requests))
            check(ended.status == DONE or any("error" in row for row in rows), f"{kind}, {what}: what failed is told", ended)
            if is_late_once and may_recover(kind):
                check(all("error" not in row for row in rows[3:]), f"{kind}, {what}: those behind it are read", (ended, line.requests))

        for lag, retries in itertools.product((1, 3), (0, 1)):
            what = f"{lag} requests late, {retries} repetitions"
            cases.add(functools.partial(judge, what=what, is_late_once=False), {"retries": retries}, *words, **of, lag=always(lag))
        cases.add(functools.partial(judge, what="late once", is_late_once=True), {}, *words, **of, lag=late_for(1, 1))


def check_times(cases, check):
    def judge(ended, line, what, is_told):
        check(not wrong_values(ended.objects()), f"{what}: no value is another's", (ended, line.requests))
        if is_told:
            check(ended.status == NO_ANSWER and all("no response in time" in row.get("error", "") for row in ended.objects()), f"{what}: all fail", ended)
            check("its answers come too late, the last after" in ended.output and "say --timeout" in ended.output, f"{what}: that is said", ended)

    words = ["--drive", "none", "--json", "read", *READ]
    for delay, retries in itertools.product((0.5, 1.2, 2.5, 5), (0, 1)):
        what = f"{delay} times the time-out, {retries} repetitions"
        cases.add(functools.partial(judge, what=what, is_told=False), {"retries": retries}, *words, delay=0.1 * delay)
    cases.add(functools.partial(judge, what="0.8 s", is_told=True), {}, *words, delay=0.8)


def check_watch(cases, check):
    words = READ[:3]

    def judge(ended, line, kind):
        rows = ended.objects()
        wrong = [row for row in rows for each in words if row[each] not in (None, int(each))]
        check(rows and not wrong, f"{kind}: a watch shows no value at another's place", (wrong, line.requests))
        if may_recover(kind):
            check(rows and all(rows[-1][each] == int(each) for each in words), f"{kind}: it goes on where the unit is prompt again",
                  (rows[-1:], line.requests))

    for kind, of in HOLDING.items():
        cases.add(functools.partial(judge, kind=kind), {}, "--drive", "none", "--json", "watch", *words, "--every", 0.2, "--for", 8, **of,
                  lag=late_for(6, 1))


def check_map(cases, check):
    def judge(ended, line, kind):
        found = [each for row in ended.objects() for each in range(row["first"], row["last"] + 1) if not row["note"]]
        check(set(found) <= set(HERE), f"{kind}: a map shows nothing that is not there", (ended, line.requests))
        check(ended.status != DONE or set(found) == set(range(100, 140)), f"{kind}: and all that is, or it fails", (ended, line.requests))

    for (kind, of), lag in itertools.product(HOLDING.items(), (late_for(3, 1), late_within(3, 6), late_within(2, 12, 2), late_within(5, 5, 2), always(1))):
        cases.add(functools.partial(judge, kind=kind), {}, "--drive", "none", "--json", "map", "95-145", **of, lag=lag)


def check_write(cases, check):
    def judge(ended, line, kind):
        for row in ended.objects():
            address = int(row["register"])
            new = {110: 7, 201: 8}[address]
            before, after = [row[each] and int(row[each].split()[0]) for each in ("before", "after")]
            check(before in (None, address), f"{kind}: before is its own", (row, line.requests))
            check(after in (None, address, new) and (after != new or line.held[address] == new), f"{kind}: what was read back is its own",
                  (row, line.requests))
            check("error" in row or line.held[address] == new, f"{kind}: what is told as written is", (row, line.requests))

    for (kind, of), lag in itertools.product(HOLDING.items(), (late_for(2, 1), late_for(5, 1), late_within(5, 9), late_within(8, 8), late_within(9, 12), always(1))):
        cases.add(functools.partial(judge, kind=kind), {"retries": 1}, "--drive", "none", "--json", "--write", "--yes", "write", "110=7", "201=8",
                  **of, lag=lag)


FILE = """
[device]
vendor = "Maker"
product = "Module"
""" + "".join(f'[[register]]\nname = "r{each}"\naddress = {each}\naccess = "write"\nsetting = true\n' for each in READ)


def check_backup(cases, check):
    names = cases.tool.place / "module.toml"
    names.write_text(FILE)

    def judge(ended, line, kind, file):
        rows = json.loads(file.read_text())["parameters"] if file.exists() else []
        wrong = [row for row in rows if row.get("raw", row["address"]) != row["address"]]
        check(not wrong, f"{kind}: nothing is kept that is another's", (ended, line.requests))
        check(ended.status != DONE or len(rows) == len(READ), f"{kind}: and all, or it fails", (ended, line.requests))

    lags = (late_for(2, 1), late_within(2, 2), late_within(3, 5), always(1), always(0))
    for i, ((kind, of), lag, retries) in enumerate(itertools.product(HOLDING.items(), lags, (0, 1))):
        file = cases.tool.place / f"kept{i}.json"
        cases.add(functools.partial(judge, kind=kind, file=file), {"retries": retries}, "--device", names, "backup", "-o", file, **of, lag=lag)


PARTS = {"read": check_read, "times": check_times, "watch": check_watch, "map": check_map, "write": check_write, "backup": check_backup}


def main(check, program, *parts):
    with Tool(program) as tool:
        for part in parts or PARTS:
            cases = Cases(tool, check)
            PARTS[part](cases, check)
            cases.run()


runs(main)
