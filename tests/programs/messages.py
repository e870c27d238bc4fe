# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the demo says.

    python3 messages.py SIMULATE DEMO messages     of its command line, and where an output takes nothing
    python3 messages.py SIMULATE DEMO leaving      of what it leaves, which then happens; the next one looks first, and starts no
                                                   motor of a drive in fault
    python3 messages.py SIMULATE DEMO cut_cable    interrupted while the cable of its own simulated drive is cut: it sees the
                                                   motor stand before it ends
"""
import os
import signal
import subprocess

from controller import DRIVES, Simulator, runs

LINK_FAULT = 5  # LFT: SLF1
ALL_DRIVES = "|".join(DRIVES)

# Arguments, and what the message has to hold.
REFUSED = [
    ("--unit 248", ["unit 248", "atv320", "1 to 247"]),
    ("--unit 0", ["unit 0", "atv320", "1 to 247"]),
    ("--drive atv28 --unit 32", ["unit 32", "atv28", "1 to 31"]),
    ("--unit two", ["--unit two", "number"]),
    ("--drive atv99", ["atv99", ALL_DRIVES]),
    ("--speed 3", ["unknown flag --speed"]),
    ("now", ["unexpected word now"]),
    ("--unit", ["--unit needs a value"]),
    ("--port --allow-run", ["--port needs a value"]),
    ("--baud 12", ["--baud 12"]),
    ("--format 7E1", ["--format 7E1", "8E1"]),
]


def run(program, words, stdout=subprocess.PIPE):
    return subprocess.run([program, *words.split()], stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, text=True, timeout=60, check=False)


def run_on(device, demo, words="", svg=os.devnull):
    return run(demo, f"--drive atv12 --port {device} --svg {svg} {words}")


def check_refusals(demo, check):
    for words, parts in REFUSED:
        ended = run(demo, words)
        message = ended.stderr.splitlines()[0] if ended.stderr else ""
        is_named = message.startswith("demo: ") and all(part in message for part in parts)
        check(ended.returncode == 2 and not ended.stdout and is_named, f"demo {words}:", message)
        check("usage: demo" in ended.stderr, "and how it is used")


def check_help(demo, check):
    ended = run(demo, "--help")
    check(ended.returncode == 0 and not ended.stderr and ended.stdout.startswith("usage: demo "), "--help", ended.stdout)
    with open("/dev/full", "wb") as full:
        check(run(demo, "--help", stdout=full).returncode == 1, "--help into a full disk")


def check_drawing(demo, simulate, check):
    with Simulator(simulate, "atv12:1") as device:
        ended = run_on(device, demo, svg="/dev/full")
    check(ended.returncode == 1 and "NO drawing could be written to /dev/full" in ended.stdout,
          "a drawing that cannot be written is a failure", ended.returncode)


def check_signs(program, check):
    """A motor that turns backwards is shown with its sign, also below one hertz."""
    simulator = Simulator(program, "atv320:1")
    with simulator:
        for word in (0x0006, 0x0007):
            simulator.suffer(f"1 write 8501 {word}")
        seen = set()
        simulator.suffer(f"1 write 8502 {0x10000 - 5}")
        simulator.suffer("1 write 8501 15")
        check.soon(lambda: seen.add(simulator.shown(1)[1]) or -0.5 in seen, "-0.5 Hz is shown")
        check(max(seen) <= 0, "and nothing above zero before", sorted(seen))


def messages(simulate, demo, check):
    check_refusals(demo, check)
    check_help(demo, check)
    check_drawing(demo, simulate, check)
    check_signs(simulate, check)


def leaving(simulate, demo, check):
    simulator = Simulator(simulate, "atv12:1")
    with simulator as device:
        simulator.suffer("1 write 6005 30")  # TTO: 3.0 s
        first = run_on(device, demo)
        check(first.returncode == 0 and "trips (SLF)" in first.stdout and "-u 1 --write reset" in first.stdout,
              "it says what it leaves, and what resets it", first.stdout[-300:])
        check.soon(lambda: simulator.shown(1)[::2] == ("fault", LINK_FAULT), "and so it is: SLF1")
        second = run_on(device, demo)
        check(second.returncode == 0 and "in fault: SLF1" in second.stdout, "the next one says so, and reads on", second.stdout)
        third = run_on(device, demo, "--allow-run")
        check(third.returncode == 1 and "in fault: SLF1" in third.stdout and "Start" not in third.stdout,
              "and where it should run the motor, it leaves the drive alone", third.stdout)
        check(simulator.shown(1)[0] == "fault", "nothing was reset")


def cut_cable(_, demo, check):
    process = subprocess.Popen([demo, "--svg", os.devnull], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    said = ""
    for line in process.stdout:
        said += line
        if "order to run is dropped: no response" in line:
            process.send_signal(signal.SIGINT)
            break
    said += process.communicate()[0]
    check("The cable is cut" in said and "The motor stands." in said, "it waits for the motor", said)
    check(process.returncode == 128 + signal.SIGINT, "its status tells the signal", process.returncode)


def main(check, simulate, demo, part):
    {each.__name__: each for each in (messages, leaving, cut_cable)}[part](simulate, demo, check)


runs(main)
