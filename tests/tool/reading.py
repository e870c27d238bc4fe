# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What is read, by which words, in which form; who the unit is; and units that are no drives.

    python3 reading.py TOOL
"""
from support import DIFFERS, DONE, DRIVES, NO_ANSWER, PORT, USAGE, Simulator, Tool, Units, runs, with_crc

from pair import free_port  # noqa: I100

CABINET = "sim:atv320:7,atv12:3,atv28:4,atv310:5,atv310_2026:6"
UNITS = {"atv320": 7, "atv12": 3, "atv28": 4, "atv310": 5, "atv310_2026": 6}


def check_forms(tool, check):
    """The same in each form."""
    words = ["-u", 7, "read", "RFR", "ACC", "ETA", "LFT"]
    people = tool.run(*words).table()
    objects = tool.run("--json", *words).objects()
    rows = tool.run("--csv", *words).rows()
    check([row[0] for row in people] == [each["register"] for each in objects] == [row["register"] for row in rows]
          == ["RFR", "ACC", "ETA", "LFT"], "a table, objects and rows are of the same registers")
    check([str(each["raw"]) for each in objects] == [row["raw"] for row in rows], "and have the same values")
    check(objects[0] == {"unit": 7, "register": "RFR", "address": 3202, "raw": 0, "value": 0.0, "measure": "Hz",
                         "text": "0.0 Hz"}, "an object says all of a value", objects[0])
    ended = tool.run("-u", 9, "--json", "-d", "atv320", "--timeout", "0.1", "--retries", 0, "read", "RFR")
    check(ended.status == NO_ANSWER and ended.objects()[0]["error"], "a failure is an object, too", ended)
    for drive in DRIVES:
        rows = tool.run("--csv", "list", "--drive", drive).rows()
        check(len(rows) > 20 and len({row["register"] for row in rows}) == len(rows), f"the list of {drive}")
        check(all(None not in row and None not in row.values() for row in rows), "has the same columns in each row")


def read(tool, *words):
    return [each["register"] for each in tool.run("--json", "-u", 7, "-d", "atv320", "read", *words).objects()]


def check_words(tool, check):
    check(read(tool, "DP?") == [f"DP{i}" for i in range(9)], "a glob")
    check(read(tool, "rfr", "RFR") == ["RFR"], "small letters, and each once")
    check("RFR" in read(tool, "@monitor"), "a group")
    check(read(tool, "3202", "0x0C81") == ["RFR", "ETA"], "numbers, with the names of the drive")
    check(read(tool, "ETA.fault") == ["ETA.fault"], "a bit")
    check(read(tool, "3201-3203") == ["ETA", "RFR", "FRH"], "a range")
    ended = tool.run("-u", 7, "-d", "atv320", "read", "RFRR")
    check(ended.status == USAGE and "RFRR" in ended.errors and "RFR" in ended.errors, "a wrong one", ended)


class Short(Units):
    """Takes 60 registers in a request."""

    def answer(self, request):
        if request[1] == 3 and int.from_bytes(request[4:6], "big") > 60:
            return with_crc(bytes([request[0], 0x83, 3]))
        return super().answer(request)


def check_long_range(tool, check):
    """More registers than a unit takes in a request are read by more of them."""
    with Short({7: {each: each for each in range(100, 240) if each != 130}}) as line:
        words = ["--port", line.name, "-u", "7", "--no-listen", "--json", "read", "100-239"]
        ended = tool.run(*words)
        rows = ended.objects()
        check([row.get("raw") for row in rows] == [each if each != 130 else None for each in range(100, 240)], "each is told", ended)
        check(ended.status == DIFFERS and rows[30]["error"].startswith("illegal data address"), "but the one that is not there", ended)


def check_parameters(tool, check):
    """All parameters of the public lists: read, listed and explained."""
    check(read(tool, "SP2", "@functions_ramp")[0] == "SP2", "a parameter, and a group of the menu")
    rows = tool.run("--csv", "list", "-d", "atv320", "--group", "motor_control", "--search", "rated motor").rows()
    check({"UNS", "FRS", "NCR", "NSP"} <= {row["register"] for row in rows} and all(
        row["group"] == "motor_control" for row in rows), "a group and a search together", rows)
    ended = tool.run("list", "-d", "atv320", "--group", "motor_contrl")
    check(ended.status == USAGE and "motor_control" in ended.errors, "a group that there is not", ended)
    rows = {row["register"]: row for row in tool.run("--csv", "list", "-d", "atv310").rows()}
    check((rows["NMA1"]["menu"], rows["ADD"]["menu"]) == ("705.0", "701"), "an ATV310 has the numbers of its menu")
    found = tool.run("--json", "-u", 5, "-d", "atv310", "read", "512.2").objects()[0]
    check(found["register"] == "HSP", "by which it is read", found)
    explained = tool.run("--json", "explain", "ACC").objects()
    check([each["drive"] for each in explained] == list(DRIVES), "a register of each drive that has it", explained)
    one = tool.run("--json", "explain", "8401", "-d", "atv320").objects()[0]
    check(one["register"] == "CHCF" and "SEP (2)" in one["values"] and "a motor may turn" in one["a write"]
          and one["source"].startswith("inferred"), "all that is known of it", one)
    text = tool.run("explain", "LFRD", "-d", "atv320").output
    check("only start and stop write it" in text and "rpm" in text, "for people, too", text)
    for words, says in ((["explain", "NOPE"], "NOPE"), (["explain", "64999", "-d", "atv12"], "nothing is known")):
        ended = tool.run(*words)
        check(ended.status == USAGE and says in ended.errors, f"{words} is refused", ended)
    for word, says in (("ZZ", "known to have it\n"), ("ACCX", "did you mean ACC?"), ("@foo", "known to have it\n")):
        ended = tool.run("explain", word)
        is_general = f"{word}: no drive of this program is" in ended.errors and "atv" not in ended.errors
        check(ended.status == USAGE and is_general and says in ended.errors, f"{word} is of no drive that was named", ended)


def check_menu_numbers(tool, check):
    """A number means one register, whatever stands beside it and whether the drive was named."""
    numbers = ["705.0", "512.2", "611", "704"]
    wanted = ["NMA1", "HSP", "SLL", "TTO"]
    for beside in ([], ["RFR"], ["3201.2"]):
        for named in ([], ["-d", "atv310"]):
            found = tool.run("-u", 5, *named, "--json", "read", *beside, *numbers).objects()
            check([each["register"] for each in found][len(beside):] == wanted, f"menu numbers {beside} {named}", found)
    found = [tool.run("-u", 5, "--json", "read", word).objects()[0]["register"] for word in numbers]
    check(found == wanted, "each alone", found)
    ended = tool.run("-u", 5, "--csv", "watch", "611", "--for", "0.1s")
    check(list(ended.rows()[0])[2] == "SLL", "a watch does so, too", ended)
    found = tool.run("-u", 7, "--json", "read", "3201.9", "3201.2").objects()
    check([(each["register"], each["value"]) for each in found] == [("3201.9", True), ("3201.2", False)],
          "a bit of a unit that nobody named is that bit", found)
    found = tool.run("-u", 7, "--json", "read", "705.0", "611").objects()
    check([each["address"] for each in found] == [705, 611], "another drive has addresses there", found)
    found = tool.run("-u", 5, "--json", "read", "0x0263").objects()[0]
    check(found["register"] == "611" and "error" in found, "a number in hexadecimal is an address", found)
    ended = tool.run("-u", 5, "--write", "write", "512.2=30")
    check(ended.status == USAGE and "512.2=30Hz" in ended.errors, "a value is told by the number typed", ended)
    for command in ("read", "watch", "monitor"):
        text = tool.run(command, "--help").output
        check("without --drive the unit is asked" in text and "ETA.fault" in text, f"{command} --help says so")


def check_unknown_units(tool, check):
    """Without function 43: what refuses it is no ATV310; of what is silent to it nobody knows."""
    for ignored, is_read in (((), True), ((43,), False)):
        with Units({7: {100: 5, 611: 6, 705: 1}}, ignored=ignored) as line:
            how = ["--port", line.name, "--no-listen", "--timeout", 1, "--retries", 0, "--json", "-u", 7, "read"]
            check(tool.run(*how, "100", "100.0").objects()[0]["raw"] == 5 and {each[1] for each in line.requests} == {3},
                  "other numbers are addresses: nobody is asked who it is")
            ended = tool.run(*how, "611", "705.0")
            if is_read:
                check([each["raw"] for each in ended.objects()] == [6, 1], "a device that refuses 43 has no menu", ended)
            else:
                check(ended.status == DIFFERS and "0x0263" in ended.errors, "who is not known is not guessed", ended)
                check(tool.run(*how, "0x0263").objects()[0]["raw"] == 6, "the word that is named works")


def check_faults(tool, check):
    """The history: the last fault and those before, in words, with the state at each where the drive keeps it."""
    simulator = Simulator(tool.program, "atv320:7", "atv28:4")
    with simulator as device:
        how = ["--no-listen", "--json"]
        rows = tool.run(*how, "-u", 7, "faults", port=device).objects()
        check([row["register"] for row in rows] == ["LFT", *(f"DP{i}" for i in range(9))] and rows[0]["when"] == "last",
              "a row a fault", rows)
        simulator.suffer("7 fault")
        rows = tool.run(*how, "-u", 7, "faults", port=device).objects()
        check(rows[0]["when"] == "now, in fault" and rows[0]["state"] == "fault" and rows[0]["raw"] != 0
              and ": " in rows[0]["fault"], "the fault that stands", rows[0])
        check(tool.run(*how, "-u", 4, "faults", port=device).objects()[0]["register"] == "LFT", "an ATV28 has one, too")
        ended = tool.run(*how, "--timeout", 0.1, "--retries", 0, "-u", 9, "-d", "atv320", "faults", port=device)
        check(ended.status == NO_ANSWER, "nobody answers", ended)


def check_identity(tool, check):
    for drive, unit in UNITS.items():
        found = tool.run("--json", "-u", unit, "identify").objects()[0]
        # The two revisions of one manual are one drive to whoever asks.
        check(found["drive"].startswith(drive.removesuffix("_2026")) or "atv310" in found["note"],
              f"{drive} is recognised", found)


def registers_of(tool, drive):
    return {int(row["address"]): 0 for row in tool.run("--csv", "list", "--drive", drive).rows()}


def check_no_identity(tool, check):
    """Units that do not say who they are: function 43 is ignored, as by something between that does not let it pass."""
    for drive in ("atv320", "atv12", "atv28"):
        with Units({7: registers_of(tool, drive)}, ignored=(43,)) as line:
            ended = tool.run("--port", line.name, "--no-listen", "--timeout", 1, "--retries", 0, "--json", "-u", 7, "read", "RFR")
            check(ended.status == DONE and ended.objects()[0]["raw"] == 0, f"an {drive} is known by its registers", ended)
            check({request[1] for request in line.requests} == {3, 43}, "by reads only")
    everything = dict.fromkeys(range(65_536), 0)
    low = {**dict.fromkeys(range(42), 1), 100: 5}
    for what, registers, ignored in (("few registers", {100: 5}, (43,)), ("low registers, as modules have", low, ()), ("any register", everything, (43,)),
                                     ("any register, and refuses function 43", everything, ())):
        with Units({7: registers}, ignored=ignored) as line:
            how = ["--port", line.name, "--no-listen", "--timeout", 1, "--retries", 0, "-u", 7]
            ended = tool.run(*how, "read", "RFR")
            check(ended.status == DIFFERS and "unit 7: answers" in ended.errors and "--drive" in ended.errors,
                  f"a unit with {what} is no drive, and --drive is named", ended)
            check(tool.run(*how, "read", "100").status == DONE, "its registers have numbers all the same")
    with Units({}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", 0.1, "--retries", 0, "-u", 7, "read", "RFR")
        check(ended.status == NO_ANSWER and "no response" in ended.errors and len(line.requests) == 2,
              "a silent unit is asked once more, not for each register", (ended, line.requests))


def check_ports(tool, check):
    with Simulator(tool.program, "atv12:3", vendor="Example GmbH") as device:
        found = tool.run("--port", device, "--listen", "0.05", "--json", "-u", 3, "identify").objects()[0]
        check(found["vendor"] == "Example GmbH" and found["drive"] == "atv12", "simulated drives for other programs", found)
    ended = tool.run("--port", "/dev/ttyUSB-not", "--listen", "0", "read", "1")
    check(ended.status == PORT and "/dev/ttyUSB-not" in ended.errors, "a port that is not there", ended)
    number = free_port()
    ended = tool.run("--port", f"tcp://127.0.0.1:{number}", "read", "1")
    check(ended.status == PORT and str(number) in ended.errors, "nor there", ended)


def main(check, program):
    with Tool(program, CABINET) as tool:
        for part in (check_forms, check_words, check_parameters, check_menu_numbers, check_faults, check_identity):
            part(tool, check)
    with Tool(program) as tool:
        for part in (check_ports, check_no_identity, check_unknown_units, check_long_range):
            part(tool, check)
        with Units({1: dict.fromkeys(range(10), 3)}) as line:
            check(tool.run("--port", line.name, "--listen", "0.05", "identify").status != PORT, "a unit that says nothing")


runs(main)
