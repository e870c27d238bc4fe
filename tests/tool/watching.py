# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Registers read again and again: at a period, into a pipe, until the reader goes away; and how much of a line it uses.

    python3 watching.py TOOL          what holds on any machine
    python3 watching.py TOOL share    how much of a line it uses, on a machine with nothing else to do
"""
import json
import os
import signal
import time
from datetime import datetime

from support import DIFFERS, DONE, LIMIT, NO_ANSWER, USAGE, Simulator, Tool, Units, runs

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


METER = """[[register]]
name = "power"
address = 100
unit = "W"

[[register]]
name = "hours"
address = 110
"""
RFR, LCR = 3202, 3204


def several(line, *units, timeout=10):
    return ["--port", line.name, "--no-listen", "--name", "fan=7:atv320", "--timeout", timeout, "--retries", 0,
            *(word for each in units for word in ("-u", each))]


def check_units(tool, check):
    """A drive and two meters on one line: their columns are told apart, in each form."""
    for name in ("meter.toml", "other.toml"):
        (tool.place / name).write_text(METER.replace("power", "load" if name == "other.toml" else "power"))
    with Units({7: {RFR: 400, LCR: 12}, 61: {100: 230, 110: 9}, 62: {100: 231, 110: 8}}) as line:
        how, briefly = several(line, "fan", "61,62"), ["--every", "50ms", "--for", "0.12s"]
        ended = tool.run(*how, "--device", "meter.toml", "--csv", "watch", "RFR", "power", "LCR@fan", "hours@62", *briefly)
        check(ended.status == DONE and ended.output.startswith(
            "time,seconds,RFR@fan,RFR@fan measure,LCR@fan,LCR@fan measure,error@fan,power@unit61,power@unit61 measure,error@unit61,"
            "power@unit62,power@unit62 measure,hours@unit62,error@unit62\n"),
            "columns of each unit, a drive beside a register file", ended)
        check(ended.rows()[0]["RFR@fan"] == "40" and ended.rows()[0]["power@unit62"] == "231", "and their values", ended)
        check([ended.rows()[0][f"{each} measure"] for each in ("RFR@fan", "LCR@fan", "power@unit62")] == ["Hz", "A", "W"],
              "and their units", ended)
        check("fan has no power" in ended.errors and "unit61 has no RFR" in ended.errors, "what is not asked of whom is said", ended)
        found = tool.run(*how, "--device", "meter.toml", "--json", "watch", "RFR@7,power@61,power@62", *briefly).objects()[0]
        check([found[each] for each in ("RFR@fan", "power@unit61", "power@unit62", "error@unit61", "power@unit61 measure")] == [40, 230, 231, None, "W"],
              "the same in JSON", found)
        ended = tool.run(*how, "--device", "meter.toml", "watch", "RFR", "power", *briefly)
        check("power@unit62" in ended.output and "40.0 Hz" in ended.output and "231 W" in ended.output, "and in a table", ended)
        named = ["--name", "main=61:meter.toml", "--name", "sub=62:other.toml"]
        ended = tool.run(*several(line, "main,sub"), *named, "--csv", "watch", "power", "load", *briefly)
        check(ended.rows()[0]["power@main"] == "230" and ended.rows()[0]["load@sub"] == "231", "each name its register file", ended)
        own = ["--port", line.name, "--no-listen", "--name", "main=61:meter.toml"]
        for command, beside in (("read", []), ("watch", briefly)):
            ended = tool.run(*own, "-u", "main,62", "--json", command, "power", "holding:100@62", *beside)
            found = ended.objects()
            held = found[0]["holding:100@unit62"] if command == "watch" else found[1].get("value")
            check(ended.status == DONE and held == 231 and "unit62 has no power" in ended.errors,
                  f"{command}: a place of a unit that does not say what it is, beside a name of another one", ended)
        ended = tool.run(*own, "-u", "main,62", "read", "power")
        check("say --drive" in ended.errors and "230" in ended.output, "without a place nothing is read of it", ended)
        devices = tool.place / ".local" / "share" / "rtuwire" / "devices"
        devices.mkdir(parents=True)
        for name in ("pm9", "atv320"):
            (devices / f"{name}.toml").write_text(METER)
        ended = tool.run(*several(line, "fan,main"), "--name", "main=61:pm9", "--csv", "watch", "RFR", "power", *briefly)
        check(ended.status == DONE and ended.rows()[0]["power@main"] == "230" and ended.rows()[0]["RFR@fan"] == "40",
              "a register file by its name; a drive's name is the drive", ended)
        found = tool.run(*several(line, "fan,61"), "--device", "meter.toml", "--json", "read", "RFR", "power").objects()
        check([(each["unit"], each["register"]) for each in found] == [(7, "RFR"), (61, "power")], "read does the same", found)
        asked = len(line.requests)
        for words, parts in ((["powr"], ["powr", "power"]), (["RFR@fun", "power"], ["'fun'", "'fan'"]), (["RFR@fan"], ["unit61"]),
                             (["RFR@"], ["RFR@"])):
            ended = tool.run(*several(line, "fan,61"), "--device", "meter.toml", "watch", *words)
            check(ended.status == USAGE and all(each in ended.errors for each in parts), f"{words} is refused", ended)
        for names, parts in ((["unit61=62"], ["unit61", "62"]), (["x=61:no.toml"], ["no.toml"]), (["x=61:atv99"], ["atv99"])):
            ended = tool.run(*several(line, "61,62"), *(word for each in names for word in ("--name", each)), "watch", "100")
            check(ended.status == USAGE and all(each in ended.errors for each in parts), f"{names} is refused", ended)
        ended = tool.run(*several(line, "7,fan"), "--name", "mixer=8:atv12", "-u", "8", "--device", "meter.toml", "watch", "RFR")
        check(ended.status == USAGE and "meter.toml" in ended.errors, "a register file of drives is refused", ended)
        check(len(line.requests) == asked, "before anything is sent")


def check_silent_unit(tool, check):
    """One that is silent holds up the others for one time-out, less and less often, and is read again when it is back."""
    (tool.place / "meter.toml").write_text(METER)
    units = {7: {RFR: 400}, 61: {100: 230, 110: 9}}
    with Units(dict(units)) as line:
        ended = tool.run(*several(line, "9,fan", timeout=0.3), "--csv", "watch", "RFR", "--every", "50ms", "--for", "0.2s")
        row = ended.rows()[-1]
        check(ended.status == NO_ANSWER and list(row)[2:] == ["error@unit9", "RFR@fan", "RFR@fan measure", "error@fan"] and row["error@unit9"] and
              row["RFR@fan"] == "40", "one that does not say which drive it is has an error, and the other its values", ended)
        process = tool.start(*several(line, "61,fan,9", timeout=0.3), "--device", "meter.toml", "--json", "watch", "RFR@fan", "power@61",
                             "hours@61", "power@9", "--every", "50ms", "--for", f"{LIMIT}s")
        row = next(row for row in map(json.loads, process.stdout) if row["power@unit61"] == 230)
        check(row["RFR@fan"] == 40 and row["error@unit9"] and not row["error@fan"], "one is silent from the beginning", row)
        line.units = {7: {RFR: 410}}
        gone, asked = time.monotonic(), len(line.requests)
        rows = [json.loads(process.stdout.readline()) for _ in range(20)]
        check(rows[-1]["RFR@fan"] == 41 and rows[-1]["error@unit61"] and rows[-1]["hours@unit61"] is None and not rows[-1]["error@fan"],
              "another falls silent, and the rest goes on", rows[-1])
        silent = sum(request[0] == 61 for request in line.requests[asked:])
        check(silent < 8, f"it is asked less often: {silent} of {len(rows)} rounds in {time.monotonic() - gone:.1f} s")
        line.units = units
        row = next(row for row in map(json.loads, process.stdout) if not row["error@unit61"])
        check(row["power@unit61"] == 230 and row["hours@unit61"] == 9, "it is back", row)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LIMIT)
        check(process.returncode == NO_ANSWER, "the status is that of the one that was silent to the end", process.returncode)


GROUPS = """[[register]]
name = "fast"
address = 100
group = "often"

[[register]]
name = "slow"
address = 110
group = "seldom"

[groups]
often = "100ms"
seldom = "60s"
"""


def check_groups(tool, check):
    """What failed the last time that it was read counts, although it was not due in the last round."""
    (tool.place / "groups.toml").write_text(GROUPS)
    with Units({7: {100: 1}}) as line:
        words = ["--port", line.name, "--no-listen", "-u", 7, "--device", "groups.toml", "--json", "watch", "fast", "slow", "--for", "0.35s"]
        ended = tool.run(*words)
        rows = ended.objects()
        check(ended.status == DIFFERS and rows[0]["error"] and rows[-1]["fast"] == 1 and not rows[-1]["error"], "a register that is not there", ended)
        line.units = {7: {100: 1, 110: 2}}
        check(tool.run(*words).status == DONE, "and one that is")


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
        for each in (check_share,) if part == "share" else (check_period, check_reader, check_silence, check_units,
                                                                 check_silent_unit, check_groups, check_suspension):
            each(tool, check)


runs(main)
