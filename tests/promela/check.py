# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Searches the model of the motion law with Spin: whole, then without each of its guards.

    python3 check.py quick           that it compiles, a small search, and the guards of QUICK
    python3 check.py complete        every life of the model; no error may be found
    python3 check.py guards          without a guard, one at a time; each time an error has to be found
    python3 check.py life GUARD      prints the life that shows the error
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

# How many acts of the user and events around the drive.
COMPLETE = [(2, 2), (3, 1)]

# The switch that takes a guard away: acts, events, and what it is then that breaks. The first few states
# usually show it, so the smallest search that does is taken.
GUARDS = {
    "NO_STAMP": (2, 0, "an order that a stop or a loss overruled still enables"),
    "NO_HOLD": (2, 0, "an order given while a stop holds the unit enables"),
    "NO_ABORT": (2, 0, "a request taken before a stop leaves after it"),
    "NO_PRIORITY": (2, 0, "others go before a stop's word"),
    "TWO_ORDERS": (2, 1, "an older order goes on beside a newer one"),
    "BROADCAST_KEEPS_ORDERS": (2, 0, "a broadcast stop leaves orders in force"),
    "NO_OWN_ADDRESS": (2, 0, "a broadcast stop does not stop each ordered unit by its address"),
    "NO_CONFIRMATION": (2, 0, "a stop says that the motor stands when its word was answered"),
    "NO_LOSS": (2, 0, "missing responses are not a loss"),
    "ORDERED_LATE": (2, 0, "a unit counts as ordered when it answered, not when the request was taken"),
    "STOP_FORGETS_ORDERED": (2, 1, "a stop that begins makes the unit one that was not ordered"),
    "ORDER_OUTLIVES_LOSS": (2, 0, "a loss leaves orders in force"),
    "NO_SILENCE": (1, 1, "reads go on right behind the stop words"),
    "SHORT_SILENCE": (1, 1, "reads go on before the drive's own time-out"),
    "ENDLESS_STOP_WORDS": (1, 1, "stop words go on for ever, and a drive that does not obey them is fed"),
    "NO_READ_BACK": (2, 1, "000F without a look at the command register"),
    "NO_NEW_LOOK": (1, 1, "an attempt without a response is repeated, not begun again with a look"),
    "SHUTDOWN_ANYWHERE": (1, 1, "0006 goes to a drive that was not read in switch on disabled"),
    "NO_FALL_BACK": (1, 1, "a drive that fell back is pushed up"),
    "NO_FAULT": (1, 1, "a cycle's order outlives a fault"),
    "NO_STOP_KEY": (1, 1, "the STOP key is not looked at"),
    "CHECK_NOT_JUDGED": (1, 2, "the status that ends a cycle's check is not judged: the order goes on as before"),
    "SAYS_IT_AGAIN": (3, 0, "a stop that is used again repeats that the motor stands, and sends nothing"),
    "VISIT_BEGINS": (2, 0, "a start that has ended begins anew where a loop visits it"),
    "NO_TICKET": (2, 1, "who comes next takes the outcome"),
    "NO_FORGETTING": (2, 0, "a conversation made anew keeps the number of the old one's request"),
    "NO_DROP": (2, 0, "an outcome whose asker is gone is kept"),
    "GONE_ASKERS_SEND": (2, 0, "a request leaves whose asker is gone"),
    # Not a guard: that the bound is reached shows that the search comes so far.
    "BOUND=6": (2, 1, "a tick less than the drive may take"),
}

# What each build looks at.
QUICK = ["CHECK_NOT_JUDGED", "VISIT_BEGINS"]


def run(command, folder):
    return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False).stdout


def search(folder, acts, events, optimise, switches):
    """What the search says, and the life that ends in an error, if there is one."""
    for part in HERE.glob("*.pml"):
        shutil.copy(part, folder)
    defines = [f"-DACTS={acts}", f"-DEVENTS={events}", *(f"-D{switch}" for switch in switches)]
    said = run(["spin", *defines, "-a", "motion_law.pml"], folder)
    said += run([os.environ.get("CC", "gcc"), optimise, "-w", "-DSAFETY", "-DCOLLAPSE", "-DNOFAIR", "-DMEMLIM=4000",
                 "-o", "pan", "pan.c"], folder)
    if not pathlib.Path(folder, "pan").exists():
        sys.exit(f"check.py: the model does not compile:\n{said}")
    # -m: the longest life; a longer one is reported as an error of its own.
    said = run(["./pan", "-m100000", "-b"], folder)
    if not pathlib.Path(folder, "motion_law.pml.trail").exists():
        return said, ""
    return said, run(["spin", *defines, "-t", "-T", "motion_law.pml"], folder).split("spin: trail ends")[0]


def states(said):
    found = re.search(r"(\d+) states, stored", said)
    return int(found.group(1)) if found else 0


def is_complete(said):
    return "errors: 0" in said and states(said) > 0 and "Search not completed" not in said


def complete(size, optimise="-O1"):
    acts, events = size
    with tempfile.TemporaryDirectory() as folder:
        said, life = search(folder, acts, events, optimise, [])
    good = is_complete(said)
    print(f"{acts} acts, {events} events: {states(said):,} states, "
          f"{'no error' if good else 'AN ERROR'}", flush=True)
    if not good:
        print(life or said)
    return good


def without(guard):
    acts, events, meaning = GUARDS[guard]
    with tempfile.TemporaryDirectory() as folder:
        said, life = search(folder, acts, events, "-O0", [guard])
    error = re.search(r"^pan:1: (assertion violated.*|invalid end state.*)", said, re.MULTILINE)
    shown = error.group(1) if error else "NOT SEEN"
    return bool(error), f"{guard}: {meaning}\n    {states(said):,} states; {shown}", life


def guards(names):
    seen = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as workers:
        for found, text, _ in workers.map(without, names):
            seen += found
            print(text, flush=True)
    print(f"{seen} of {len(names)} seen")
    return seen == len(names)


def main(arguments):
    if arguments == ["complete"]:
        return all([complete(size) for size in COMPLETE])
    if arguments == ["quick"]:
        return complete((1, 1), "-O0") and guards(QUICK)
    if arguments == ["guards"]:
        return guards(GUARDS)
    if len(arguments) == 2 and arguments[0] == "life" and arguments[1] in GUARDS:
        found, text, life = without(arguments[1])
        print(text, life, sep="\n")
        return found
    print(__doc__, file=sys.stderr)
    return False


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1:]) else 1)
