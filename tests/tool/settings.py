# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Backups of drives, what differs between them, and what a restore writes, leaves out and says.

    python3 settings.py TOOL
"""
import csv
import json
import os
import queue
import re
import resource
import signal

from support import DIFFERS, DONE, LIMIT, NO_ANSWER, PORT, REFUSED, USAGE, Simulator, Tool, Units, runs

# What the test's own unit holds, as an ATV12 has it: at rest, not commanded.
AT_REST = {3201: 0x0040, 8501: 0, 3202: 0, 3103: 600, 3104: 500, 3105: 0, 9001: 30, 9002: 40, 8401: 1, 8423: 10, 8413: 164,
           7010: 1, 6005: 100, 11101: 0, 11410: 100, 11411: 150, 11412: 200, 3301: 4}
NAMES = {9001: "ACC", 9002: "DEC", 11410: "SP2", 11411: "SP3", 11412: "SP4", 3104: "HSP", 8423: "CD1", 7010: "SLL",
         3301: "SPN"}
READS = (3, 43)  # functions


def registers_of_drive(tool, **words):
    """All that an ATV12 has, 0 where nothing else is said."""
    rows = tool.run("--csv", "list", "--drive", "atv12").rows()
    return {**{int(row["address"]): 0 for row in rows}, **AT_REST, **words}


def how(line, *words, timeout=5):
    """The time-out is short only where a unit falls silent."""
    return ["--port", line.name, "--no-listen", "--timeout", timeout, "--retries", "0", "-u", 7, "-d", "atv12", *words]


def writes(line):
    return [(int.from_bytes(each[2:4], "big"), int.from_bytes(each[4:6], "big"))
            for each in line.requests if each[1] not in READS]


def own_file(tool, name="wanted.json", drive="atv12", **words):
    rows = ",\n".join(json.dumps({"register": code, **(word if isinstance(word, dict) else {"raw": word})})
                      for code, word in words.items())
    file = tool.place / name
    file.write_text(f'{{"format":"rtuwire backup 1","drive":"{drive}","parameters":[\n{rows}\n]}}')
    return name


def check_backup(tool, check):
    """Each parameter once, a line each, in JSON and as a table; what it holds is what `read` says."""
    words = ["--port", "sim:atv320:7", "-u", 7]
    ended = tool.run(*words, "--json", "backup", "-o", "a.json")
    told = ended.objects()[0]
    text = (tool.place / "a.json").read_text()
    kept = json.loads(text)
    rows = kept["parameters"]
    known = tool.run("--csv", "list", "--drive", "atv320").rows()
    check(ended.status == DONE and len(rows) == len(known) == told["read"] + told["refused by the drive"],
          "every parameter is there, read or refused", told)
    check([(row["group"], row["address"]) for row in rows] == sorted((row["group"], row["address"]) for row in rows),
          "by group and address")
    check(all(sum(f'"register":"{row["register"]}"' in line for line in text.splitlines()) == 1 for row in rows[:50]),
          "a line each")
    check((kept["drive"], kept["vendor"], kept["unit"]) == ("atv320", "Schneider Electric", "7") and kept["time"]
          and kept["rating"] and kept["made by"].startswith("rtuwire "), "who it is, when, and by what", list(kept))
    found = {row["register"]: row for row in rows}
    for each in tool.run(*words, "--json", "read", "ACC", "HSP", "CHCF", "LFRD", "COS").objects():
        row = found[each["register"]]
        check(row["raw"] == each["raw"] and (row["value"] == each["value"] or each["text"].startswith(str(row["value"]))),
              f"{each['register']} as read says", (row, each))
    check(tool.run(*words, "backup", "-o", "b.json").status == DONE, "a second backup")
    other = (tool.place / "b.json").read_text().splitlines()
    check([line for line in text.splitlines() if line not in other and '"time"' not in line] == [],
          "of an unchanged drive is the same but for its time")
    ended = tool.run(*words, "backup", "-o", "a.csv")
    raw = (tool.place / "a.csv").read_bytes()
    table = list(csv.DictReader(raw.decode().splitlines(), strict=True))
    check(raw.count(b"\r\n") == raw.count(b"\n") and all(None not in row for row in table), "as RFC 4180 says")
    check({row["register"]: row["raw"] for row in table if row["group"] != "backup"}
          == {row["register"]: str(row.get("raw", "")) for row in rows}, "the table has the same")
    check(tool.run(*words, "backup", "-o", "-").output.splitlines()[-1] == "]}", "to standard output")
    check(tool.run("compare", "a.json", "a.csv").status == DONE, "both forms are the same")
    for drive in ("atv12", "atv28", "atv310", "atv310_2026"):
        ended = tool.run("--port", f"sim:{drive}:3", "-u", 3, "-d", drive, "backup", "-o", "c.json")
        check(ended.status == DONE and tool.run("compare", "c.json", "c.json").status == DONE, f"of an {drive}", ended)


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))


def check_file(tool, check):
    """A backup is whole, or what was there before stays."""
    words = ["--port", "sim:atv320:7", "-u", 7, "backup", "-o"]
    (tool.place / "kept.json").write_text("as before")
    process = tool.start(*words, "kept.json", preexec_fn=small_files)
    _, errors = process.communicate()
    check(process.returncode == PORT and "kept.json" in errors and "not kept" in errors, "a full disk is told", errors)
    check((tool.place / "kept.json").read_text() == "as before", "and leaves what was there")
    (tool.place / "again.json").write_text("of yesterday")
    ended = tool.run(*words, "again.json")
    check(ended.status == DONE and "again.json was there already, and is replaced" in ended.errors, "what is replaced is told", ended)
    ended = tool.run("--timeout", 0.1, "--retries", 0, "-u", 9, "-d", "atv320", "backup", "-o", "kept.json", port="sim:atv320:7")
    check(ended.status == NO_ANSWER and "nothing is kept" in ended.errors, "so does a unit that does not answer", ended)
    check((tool.place / "kept.json").read_text() == "as before", "which leaves it as well")
    for name, status, says in (("/dev/full", USAGE, "is a device"), (".", USAGE, "is a directory"),
                               ("missing/a.json", PORT, "No such file")):
        ended = tool.run(*words, name)
        check(ended.status == status and says in ended.errors, f"-o {name} is refused", ended)
    check(not [each.name for each in tool.place.iterdir() if "json." in each.name], "nothing half-written is left")
    ended = tool.run(*words, "kept.json")
    check(ended.status == DONE and len((tool.place / "kept.json").read_text()) > 50_000, "a good one takes its place", ended)


def check_wrong_drive(tool, check):
    """What --drive says wrongly makes no backup, and takes no good one away."""
    port = ["--port", "sim:atv320:7", "-u", 7]
    (tool.place / "kept.json").write_text("as before")
    for words, status, says in ((["--port", "sim:atv320:7", "-u", 7, "-d", "atv28"], USAGE, "and --drive or --name calls it atv28"),
                                (["--port", "sim:atv320:7", "-u", "fan", "--name", "fan=7:atv12"], USAGE, "calls it atv12"),
                                (["--port", "sim:atv28:5", "-u", 5, "-d", "atv320"], USAGE, "is an atv28, and")):
        ended = tool.run(*words, "backup", "-o", "kept.json")
        check(ended.status == status and says in ended.errors, f"a backup of {words} is refused", ended)
        check((tool.place / "kept.json").read_text() == "as before", "and the old file stays")
    with Units({7: {1: 1}}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "-u", 7, "-d", "atv28", "backup", "-o", "kept.json")
        check(ended.status == DIFFERS and "none of the parameters" in ended.errors, "nor is one of which nothing was read", ended)
        check((tool.place / "kept.json").read_text() == "as before", "and that leaves the old file as well")
    (tool.place / "empty.json").write_text('{"format":"rtuwire backup 1","drive":"atv320","parameters":[\n]}')
    (tool.place / "refused.json").write_text('{"format":"rtuwire backup 1","drive":"atv320","parameters":[\n'
                                             '{"register":"HSP","error":"illegal data address"}]}')
    for name in ("empty.json", "refused.json"):
        for how_to in (["--write", "-y"], []):
            ended = tool.run(*port, *how_to, "restore", name, *([] if how_to else ["--dry-run"]))
            check(ended.status == USAGE and f"{name}: " in ended.errors, f"{name} restores nothing, and says so", ended)


def check_compare(tool, check):
    with Units({7: registers_of_drive(tool), 8: registers_of_drive(tool, **{})}) as line:
        line.units[8][11411] = 333
        line.units[8][3202] = 77  # a reading is no setting
        words = how(line)
        check(tool.run(*words, "backup", "-o", "seven.json").status == DONE, "a backup of the test's own unit")
        ended = tool.run(*words, "--json", "compare", "seven.json")
        check(ended.status == DONE and not ended.output, "a file with its drive: nothing differs", ended)
        ended = tool.run(*words, "--json", "compare", "seven.json", "8")
        rows = ended.objects()
        check(ended.status == DIFFERS and [row["register"] for row in rows] == ["SP3"], "another unit: what differs", rows)
        check((rows[0]["left"], rows[0]["right"], rows[0]["group"]) == ("15.0 Hz", "33.3 Hz", "functions_speed"),
              "with both values and the group", rows)
        ended = tool.run(*words, "--json", "compare", "7", f"8@{line.name}")
        check([row["register"] for row in ended.objects()] == ["SP3"], "two units, of two ports", ended)
        line.units[7][9001] = 50
        ended = tool.run(*words, "compare", "seven.json")
        check(ended.status == DIFFERS and "3.0 s" in ended.output and "5.0 s" in ended.output
              and "1 of" in ended.errors, "a change of the drive", ended)
        rows = tool.run(*words, "--json", "compare", "--factory").objects()
        check({"register": "ACC", "left": "5.0 s", "right": "3.0 s"}.items() <= rows[[r["register"] for r in rows].index("ACC")].items(),
              "the factory's values", rows[:3])
        own_file(tool, ACC={"value": 5}, SP3={"raw": 150, "value": "15,0", "unit": "Hz"})
        ended = tool.run(*words, "--json", "compare", "wanted.json")
        check(ended.status == DONE, "a file of two parameters", ended)
        check(not writes(line), "nothing was written")
    for words, parts in ((["compare"], ["FILE"]), (["compare", "a", "b", "c"], ["two sides"]),
                         (["compare", "missing.json"], ["missing.json", "No such file"]),
                         (["compare", "seven.json", "wanted.json", "--factory"], ["two sides"])):
        ended = tool.run(*words)
        check(ended.status == USAGE and all(part in ended.errors for part in parts), f"{words} is refused", ended)
    for name, text, place in (("cut.json", (tool.place / "seven.json").read_text()[:-9], ":"),
                              ("wrong.csv", "register;raw\r\nHSP;500\r\nHSQ;1\r\n", ":3:1: 'HSQ'"),
                              ("twice.csv", "register,raw\nHSP,500\nHSP,500\n", ":3:1: HSP"),
                              ("nan.json", '{"drive":"atv12","parameters":[\n{"register":"HSP","raw":NaN}]}', ":2:")):
        (tool.place / name).write_text(text)
        ended = tool.run("-d", "atv12", "compare", name, "seven.json")
        check(ended.status == USAGE and ended.errors.startswith(f"rtuwire: {name}:") and place in ended.errors,
              f"{name} is refused with its place", ended.errors)
    (tool.place / "binary").write_bytes(os.urandom(5_000))
    check(tool.run("-d", "atv12", "compare", "binary", "seven.json").status == USAGE, "so is what is no text at all")
    (tool.place / "huge.csv").write_bytes(b"register,raw\n" + b"HSP,1\n" * 900_000)
    check("larger" in tool.run("-d", "atv12", "compare", "huge.csv", "seven.json").errors, "and a file that is too large")
    check(tool.run("-d", "atv320", "compare", "seven.json", "seven.json").status == USAGE, "and one of another drive")


def check_restore(tool, check):
    """What is written is what differs and is allowed; all else is told."""
    own_file(tool, ACC=50, DEC=40, SP2=120, SP3=150, CD1=2, SLL=0, SPN=9)
    with Units({7: registers_of_drive(tool)}) as line:
        before = dict(line.units[7])
        ended = tool.run(*how(line), "--json", "restore", "wanted.json", "--dry-run")
        rows = {row["register"]: row for row in ended.objects()}
        check(ended.status == DONE and {code for code, row in rows.items() if row["outcome"] == "to be written"} == {"ACC", "SP2"},
              "a dry run says what would be written", ended)
        check("channels" in rows["CD1"]["outcome"] and "supervision" in rows["SLL"]["outcome"] and "SPN" not in rows,
              "and what is left out, and why", rows)
        check((rows["ACC"]["held"], rows["ACC"]["wanted"]) == ("3.0 s", "5.0 s"), "with both values", rows["ACC"])
        ended = tool.run(*how(line), "restore", "wanted.json")
        check(ended.status == REFUSED and "--write" in ended.errors, "it needs --write", ended)
        check(not writes(line) and line.units[7] == before, "nothing was written")
        ended = tool.run(*how(line), "--write", "--json", "restore", "wanted.json")
        check(ended.status == DONE and sorted(writes(line)) == [(9001, 50), (11410, 120)], "what differs is written", ended)
        rows = {row["register"]: row["outcome"] for row in ended.objects()}
        check(rows["ACC"] == rows["SP2"] == "written and read back", "and read back", rows)
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
        check("\t7\tACC\t3.0 s\t5.0 s" in log and "\t7\tSP2\t10.0 Hz\t12.0 Hz" in log, "and noted", log)
        ended = tool.run(*how(line), "--write", "restore", "wanted.json")
        check(ended.status == DONE and len(writes(line)) == 2 and "holds all that" in ended.errors, "a second one has nothing to do", ended)
        for options, code in ((["--with-channels"], "CD1"), (["--with-supervision"], "SLL")):
            ended = tool.run(*how(line), "--write", "restore", "wanted.json", *options)
            check(ended.status == REFUSED and code in ended.errors and "--allow-run" in ended.errors and len(writes(line)) == 2,
                  f"{options} needs --allow-run", ended)
        ended = tool.run(*how(line), "--write", "--allow-run", "restore", "wanted.json", "--with-supervision")
        check(ended.status == DONE and line.units[7][7010] == 0, "which allows it", ended)
    ended = tool.run("--port", "sim:atv12:7", "--write", "restore", "wanted.json")
    check(ended.status == USAGE and "which unit?" in ended.errors, "it takes no unit by itself", ended)


def check_refusals(tool, check):
    """Before the first write, and where it can be before the first frame."""
    for code, word in (("HSP", 60_000), ("CHCF", 77), ("ACC", {"value": 6000})):
        own_file(tool, "limits.json", **{code: word})
        with Units({7: registers_of_drive(tool)}) as line:
            ended = tool.run(*how(line), "--write", "--allow-run", "restore", "limits.json", "--with-channels")
            is_told = ended.errors.startswith("rtuwire: limits.json:2:") and code in ended.errors
            check(ended.status == USAGE and (is_told or "stands" in ended.errors) and not line.requests,
                  f"{code} out of its limits is refused with its place", ended)
    own_file(tool, "above.json", HSP=3000)
    with Units({7: registers_of_drive(tool)}) as line:
        ended = tool.run(*how(line), "--write", "restore", "above.json")
        check(ended.status == DIFFERS and not writes(line) and "cannot be written as it is wanted" in ended.errors,
              "what another register limits is no value that reads back otherwise", ended)
    own_file(tool, "other.json", drive="atv320", HSP=450)
    own_file(tool, "wanted.json", ACC=50, SP2=120)
    for words, says in (({3201: 0x0627}, "while the motor is stopped"), ({8501: 0x000F}, "command"), ({3202: 120}, "while the motor is stopped")):
        with Units({7: {**registers_of_drive(tool), **words}}) as line:
            ended = tool.run(*how(line), "--write", "--json", "restore", "wanted.json")
            check(ended.status == REFUSED and not writes(line) and "nothing was written" in ended.errors and says in ended.errors,
                  f"{words}: refused before the first write", ended)
    ended = tool.run("--port", "sim:atv12:7", "-u", 7, "--write", "--json", "restore", "other.json", "--with-inferred")
    check(ended.status == REFUSED and "family" in ended.errors and len(ended.errors.splitlines()) == 1
          and list(ended.objects()[0]) == ["unit", "error"] and len(ended.objects()) == 1,
          "another drive's settings are refused by one sentence, and by one object", ended)
    ended = tool.run("--port", "sim:atv12:7", "-u", 7, "restore", "other.json", "--dry-run")
    check(ended.status == REFUSED and "family" in ended.errors and not ended.output, "for people as well", ended)
    own_file(tool, "old.json", drive="atv28", ACC=50)
    ended = tool.run("--port", "sim:atv28:7", "-u", 7, "--write", "restore", "old.json")
    check(ended.status == REFUSED and "not restored" in ended.errors, "an ATV28's are not restored", ended)


class Dying(Units):
    """Does not answer any more after so many requests; the last one may have been carried out."""

    def __init__(self, left, units):
        self.left = left
        super().__init__(units)

    def answer(self, request):
        self.left -= 1
        said = super().answer(request) if self.left >= 0 else None
        return said if self.left > 0 else None


WANTED = {"ACC": 51, "DEC": 52, "SP2": 121, "SP3": 122, "SP4": 123, "HSP": 480}
OLD = {"ACC": 30, "DEC": 40, "SP2": 100, "SP3": 150, "SP4": 200, "HSP": 500}


def check_cut(tool, check):
    """A line that is cut anywhere leaves each register old or new, and the end says which; a second restore completes it."""
    own_file(tool, "wanted.json", **WANTED)
    addresses = {code: address for address, code in NAMES.items()}
    with Units({7: registers_of_drive(tool)}) as line:
        tool.run(*how(line), "--write", "restore", "wanted.json")
        whole = len(line.requests)
    for left in range(whole // 2 - 4, whole + 1, max(1, whole // 24)):
        with Dying(left, {7: registers_of_drive(tool)}) as line:
            ended = tool.run(*how(line, timeout=0.2), "--write", "--json", "restore", "wanted.json")
            held = {code: line.units[7][addresses[code]] for code in WANTED}
            check(all(held[code] in (OLD[code], WANTED[code]) for code in WANTED), f"cut after {left}: old or new", held)
            if left < whole:
                check(ended.status in (NO_ANSWER, REFUSED), f"cut after {left}: told", ended)
            rows = {row["register"]: row["outcome"] for row in ended.objects()}
            for code in WANTED:
                said = rows.get(code, "")
                is_right = not said or {"written and read back": held[code] == WANTED[code],
                                        "to be written": held[code] == OLD[code],
                                        "not reached": held[code] == OLD[code]}.get(said.split(":")[0], True)
                check(is_right, f"cut after {left}: {code} is as it says", (said, held[code]))
            line.left = 10_000
            ended = tool.run(*how(line), "--write", "restore", "wanted.json")
            held = {code: line.units[7][addresses[code]] for code in WANTED}
            check(ended.status == DONE and held == WANTED, f"cut after {left}: a second restore completes it", (ended, held))


class Interrupting(Units):
    """Presses Ctrl-C where the first write has come, before it answers that."""

    def __init__(self, units):
        self.waiting_for = queue.Queue()
        super().__init__(units)

    def answer(self, request):
        if request[1] not in READS and len(writes(self)) == 1:
            self.waiting_for.get().send_signal(signal.SIGINT)
        return super().answer(request)


def check_interrupt(tool, check):
    """Ctrl-C between two parameters: what was begun is ended, and told."""
    own_file(tool, "wanted.json", **WANTED)
    with Interrupting({7: registers_of_drive(tool)}) as line:
        process = tool.start(*how(line), "--write", "--json", "restore", "wanted.json")
        line.waiting_for.put(process)
        output, errors = process.communicate(timeout=LIMIT)
        done = [row["register"] for row in map(json.loads, output.splitlines()) if row["outcome"] == "written and read back"]
        check(process.returncode == 130 and "signal" in errors, "its status is that of the signal", (process.returncode, errors))
        check(1 <= len(done) == len(writes(line)) < len(WANTED), "each write is told, and the rest is not begun", (done, errors))
        log = (tool.place / "state" / "rtuwire" / "writes.log").read_text()
        check(all(f"{line.name}\t7\t{code}\t" in log for code in done), "and noted", log)


def check_terminal(tool, check):
    """A simulated drive as a whole: a backup, a change, back again; asked back on a terminal."""
    with Simulator(tool.program, "atv320:7") as device:
        words = ["--port", device, "--no-listen", "-u", "7"]
        check(tool.run(*words, "backup", "-o", "drive.json").status == DONE, "a backup")
        check(tool.run(*words, "--write", "write", "ACC=1.3s", "HSP=42Hz").status == DONE, "a change")
        check([row["register"] for row in tool.run(*words, "--json", "compare", "drive.json").objects()] == ["HSP", "ACC"],
              "which compare shows")
        restore = [*words, "--write", "restore", "drive.json", "--with-inferred"]
        ended = tool.on_terminal(*restore, keys=[("(y/n)", "n\n")])
        check(ended.status == REFUSED and "2 settings" in ended.output, "asks back, and takes no for an answer", ended)
        check(tool.run(*words, "compare", "drive.json").status == DIFFERS, "nothing is written")
        ended = tool.on_terminal(*restore, "--save", keys=[("(y/n)", "y\n")])
        check(ended.status == DONE and ended.output.count("written and read back") == 2, "writes at a yes", ended)
        check(tool.run(*words, "compare", "drive.json").status == DONE, "and the drive is as it was")


def check_steps(tool, check):
    """What a ramp counts in is the drive's: a file in other steps changes no ramp, and a step alone none either."""
    with Simulator(tool.program, "atv320:7") as device:
        words = ["--port", device, "--no-listen", "-u", "7"]
        check(tool.run(*words, "backup", "-o", "before.json").status == DONE, "a backup of an ATV320")

        def unchanged():
            return tool.run(*words, "compare", "before.json").status == DONE

        for options, ramps in (([], {"ACC": 5, "DEC": 6}), (["--with-inferred"], {"ACC": 5, "DEC": 6}),
                               (["--with-inferred"], {})):
            own_file(tool, "steps.json", drive="atv320", INR=2, **ramps)
            ended = tool.run(*words, "--write", "--json", "restore", "steps.json", *options)
            rows = {row["register"]: row for row in ended.objects()}
            check(ended.status == DIFFERS and "nothing was written" in ended.errors and unchanged(),
                  f"{ramps} in other steps {options}", ended)
            check(all("steps" in rows[code]["outcome"] and rows[code]["held"] == "3.0 s" for code in ramps),
                  "each is told, with what the drive holds in its own steps", rows)
        own_file(tool, "steps.json", drive="atv320", ACC=50)
        ended = tool.run(*words, "--write", "restore", "steps.json")
        check(ended.status == DIFFERS and unchanged(), "a count of a file that does not say its steps", ended)
        own_file(tool, "steps.json", drive="atv320", INR=1, ACC=50, DEC=60)
        ended = tool.run(*words, "--write", "restore", "steps.json", "--save")
        check(ended.status == DONE and "; saved;" in ended.errors, "in the drive's own steps, and saved", ended)
        own_file(tool, "steps.json", drive="atv320", INR=2, ACC=5, DEC=6, AC2=7, DE2=8)
        ended = tool.run(*words, "--write", "--json", "restore", "steps.json", "--with-inferred")
        rows = {row["register"]: row for row in ended.objects()}
        check(ended.status == DONE and rows["ACC"]["held"] == "5.0 s" and rows["ACC"]["wanted"] == "5 s",
              "with all ramps the step goes along", (ended, rows))


def check_whole(tool, check):
    """A backup that lost a part is none; a count below zero is one of a signed register only."""
    words = ["--port", "sim:atv310:7", "-u", 7]
    for name in ("part.json", "part.csv"):
        check(tool.run(*words, "backup", "-o", name).status == DONE, f"a backup, {name}")
        lines = (tool.place / name).read_bytes().splitlines(keepends=True)
        at = next(i for i, line in enumerate(lines) if b"HSP" in line)
        (tool.place / name).write_bytes(b"".join(lines[:at] + lines[at + 1:]))
        ended = tool.run("compare", name, name)
        check(ended.status == USAGE and ended.errors.startswith(f"rtuwire: {name}:") and "rows" in ended.errors,
              f"{name} without a line is refused", ended)
    own_file(tool, "below.json", ACC=-1)
    ended = tool.run("compare", "below.json", "below.json")
    check(ended.status == USAGE and "ACC" in ended.errors and "from 0" in ended.errors, "-1 of an unsigned register", ended)


def check_inputs(tool, check):
    """A drive that does not tell its inputs gets no channel, unless its user has looked at them."""
    with Simulator(tool.program, "atv310:7") as device:
        words = ["--port", device, "--no-listen", "-u", "7", "-d", "atv310", "--write", "--allow-run", "restore", "channel.json",
                 "--with-channels", "--with-inferred"]
        own_file(tool, "channel.json", drive="atv310", FR1=1)
        ended = tool.run(*words)
        check(ended.status == REFUSED and "--inputs-open" in ended.errors, "it says what to say", ended)
        ended = tool.run(*words, "--inputs-open")
        check(ended.status == DONE and "1 written" in ended.errors, "which does it", ended)


def check_told_to_stop(tool, check):
    """A drive that this program told to stop still holds that word: it says so, and what helps."""
    with Simulator(tool.program, "atv320:7") as device:
        words = ["--port", device, "--no-listen", "-u", "7"]
        own_file(tool, "slower.json", drive="atv320", HSP=400)
        check(tool.run(*words, "stop").status == DONE, "a stop on the ramp")
        restore = [*words, "--write", "restore", "slower.json", "--with-inferred"]
        ended = tool.run(*restore)
        shown = re.search(r"`\S+ ([^`]+)`", ended.errors)
        check(ended.status == REFUSED and "its command is not 0000" in ended.errors and shown, "its word is not 0000", ended)
        both = [tool.run(*each) for each in (shown[1].split(), restore)]
        check([each.status for each in both] == [DONE, DONE], "what is shown helps", both)


def main(check, program):
    with Tool(program) as tool:
        for part in (check_backup, check_file, check_wrong_drive, check_compare, check_restore, check_refusals, check_cut,
                     check_interrupt, check_terminal, check_steps, check_whole, check_inputs, check_told_to_stop):
            part(tool, check)


runs(main)
