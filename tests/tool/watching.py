# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Registers read again and again: at a period, into a pipe, until the reader goes away; and how much of a line it uses.

    python3 watching.py TOOL          what holds on any machine
    python3 watching.py TOOL share    how much of a line it uses, on a machine with nothing else to do
"""
import json
import os
import signal
from datetime import datetime

from support import DONE, LIMIT, NO_ANSWER, Simulator, Tool, Units, runs

COUNT = 20  # registers
RATE = 19_200
LEAST = 0.97  # of what the line allows


def check_period(tool, check):
    process = tool.start("--json", "-u", 7, "watch", "RFR", "ETA", "--every", "200ms", port="sim:atv320:7")
    came = [json.loads(process.stdout.readline()) for _ in range(6)]
    was_running = process.poll() is None
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=LIMIT)
    check(was_running, "a line at a time, while it goes on")
    seconds = [row["seconds"] for row in came]
    # On a busy machine a line may be late; the next ones come at their times, or as soon as they can.
    check(all(each > i * 0.2 - 0.05 for i, each in enumerate(seconds)), "counted from the beginning, and none too soon", seconds)
    check(seconds == sorted(seconds), "one after the other", seconds)
    check(min(after - before for before, after in zip(seconds, seconds[1:])) < 0.3, "busy? None left out", seconds)
    times = [datetime.fromisoformat(row["time"].replace("Z", "+00:00")) for row in came]
    check(times == sorted(times) and times[0] < times[-1], "with the time of day", times)
    check(all(row["RFR"] == 0.0 and row["ETA"] is not None for row in came), "and the values")
    ended = tool.run("--csv", "-u", 7, "watch", "RFR", "--every", "100ms", "--for", "0.45s", port="sim:atv320:7")
    check(ended.status == DONE and 1 <= len(ended.rows()) <= 5, "for a time", ended)


def check_reader(tool, check):
    process = tool.start("--csv", "-u", 7, "watch", "RFR", "--every", "20ms", port="sim:atv320:7")
    process.stdout.readline()
    process.stdout.close()
    status = process.wait(timeout=LIMIT)
    errors = process.stderr.read()
    check(status == DONE and not errors, "ends without a word when its reader has gone",
          (status, errors))


def check_silence(tool, check):
    """A unit that falls silent is a line with an error, and the watch goes on."""
    with Units({7: {100: 5}}) as line:
        process = tool.start("--port", line.name, "--no-listen", "--json", "-u", 7, "--timeout", 1, "--retries", 0, "watch", "100",
                             "--every", "100ms", "--for", f"{LIMIT}s")
        rows = [json.loads(process.stdout.readline())]
        line.units = {}
        rows += [json.loads(process.stdout.readline()) for _ in range(3)]
        line.units = {7: {100: 6}}
        last = next((row for row in map(json.loads, process.stdout) if not row["error"]), rows[-1])
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LIMIT)
        check(rows[0]["100"] == 5 and rows[-1]["100"] is None and rows[-1]["error"], "its error is in the line", rows)
        check(last["100"] == 6 and not last["error"] and process.returncode == DONE, "and it comes back", last)
        line.units = {}
        ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "--timeout", 0.05, "watch", "100", "--every", "100ms", "--for", "0.3s")
        check(ended.status == NO_ANSWER, "silent to the end: status 3", ended)


def check_suspension(tool, check):
    """A watch that is suspended keeps nobody from the line, as from a stop; it is over when it goes on."""
    with Simulator(tool.program, "atv320:7") as device:
        how = ["--port", device, "--no-listen", "-u", 7]
        # A group of its own, in which a suspension is one.
        process = tool.start(*how, "--json", "watch", "RFR", "--every", "100ms", preexec_fn=lambda: os.setpgid(0, 0))
        process.stdout.readline()
        process.send_signal(signal.SIGTSTP)
        _, status = os.waitpid(process.pid, os.WUNTRACED)
        check(os.WIFSTOPPED(status), "TSTP suspends it", status)
        ended = tool.run(*how, "stop")
        check(ended.status == DONE, "the line is free meanwhile", ended)
        process.send_signal(signal.SIGCONT)
        _, errors = process.communicate(timeout=LIMIT)
        check(process.returncode == DONE and "this watch is over" in errors, "and it ends when it goes on", (process.returncode, errors))


def check_share(tool, check):
    """A line with the times of 19 200 bits a second: a request, its response, and a silence before each."""
    with Units({7: dict.fromkeys(range(100, 100 + COUNT), 1)}, RATE) as line:
        ended = tool.run("--port", line.name, "--no-listen", "-b", RATE, "--csv", "-u", 7, "watch", f"100-{99 + COUNT}",
                         "--every", "0s", "--for", "3s")
        seconds = [float(row["seconds"]) for row in ended.rows()]
    took = (seconds[-1] - seconds[4]) / (len(seconds) - 5)
    exchange = (8 + 5 + 2 * COUNT + 7) * 11 / RATE
    share = exchange / took
    check(share >= LEAST, f"busy? {share:.3f} of what the line allows: {1000 * took:.2f} ms a round for {1000 * exchange:.2f} ms")


def main(check, program, part=""):
    with Tool(program) as tool:
        for each in (check_share,) if part == "share" else (check_period, check_reader, check_silence, check_suspension):
            each(tool, check)


runs(main)
