# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""System calls of either end for one transaction over a real pseudo-terminal, counted by strace.

    /usr/bin/python3 bench/system_calls/count.py

The difference between many transactions and twice as many, so that start and end do not count.
"""
import collections
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
ROUNDS = 200
BAR = 4
BAR_WAITING = 3  # with serial_settings::waits_in_read
LATE = 15  # milliseconds that a slow unit takes
OTHERS = 7  # libmodbus, a client


def calls(trace):
    """How often each was made: the names before the brackets."""
    lines = trace.read_text(encoding="utf-8").splitlines()
    return collections.Counter(line.split("(")[0] for line in lines if "(" in line)


def transactions(program, count, place, late, words):
    traces = {end: place / f"{end}.txt" for end in ("serve", "ask")}

    def traced(end, *words):
        return ["timeout", "60", "strace", "-o", traces[end], program, end, str(count), *words]
    with subprocess.Popen(traced("serve", str(late)), stdout=subprocess.PIPE, text=True) as server:
        device = server.stdout.readline().strip()
        subprocess.run(traced("ask", device, *words), check=True)
        if server.wait() != 0:
            raise SystemExit("count.py: the server's port failed")
    return {end: calls(trace) for end, trace in traces.items()}


def main():
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        program = place / "line"
        subprocess.check_call(["g++", "-std=c++20", "-O2", f"-I{PROJECT / 'include'}", "-o", program,
                               HERE / "line.cpp"])
        for words, bar, how in (((), BAR, ""), (("wait",), BAR_WAITING, " with waits_in_read")):
            for late, of in ((0, ""), (LATE, f" of a unit that takes {LATE} ms")):
                made = difference(program, place, late, words)
                show(f"client{of}{how}", made["ask"], bar)
                if not late and not words:
                    show("server", made["serve"], bar)


def difference(program, place, late, words):
    once = transactions(program, ROUNDS, place, late, words)
    twice = transactions(program, 2 * ROUNDS, place, late, words)
    return {end: twice[end] - once[end] for end in once}


def show(title, made, bar):
    total = sum(made.values()) / ROUNDS
    parts = ", ".join(f"{name} {count / ROUNDS:.1f}" for name, count in sorted(made.items()) if count)
    print(f"{title}: {total:.1f} system calls for a transaction, at most {bar}: "
          f"{'met' if round(total, 1) <= bar else 'MISSED'} (libmodbus {OTHERS}): {parts}")


if __name__ == "__main__":
    main()
