# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll, as a commissioning engineer calls it.

    python3 mbpoll.py server DEVICE      asks our server
    python3 mbpoll.py drives SIMULATE    reads the monitoring registers of five simulated drives on one line, in turn, and
                                         brings each of them to operation and back
"""
import re
import subprocess

from simulator import DRIVES, Registers, Simulator, runs

LINE = ["-m", "rtu", "-b", "19200", "-P", "even", "-0", "-1", "-o", "5"]
ROUNDS = 3
LONG = 300  # in 0.1 s: a drive's own time-out, which must not end between two processes of a busy machine


def mbpoll(device, *words, unit=1):
    """Its status and what it prints; what is to be written begins with an equals sign."""
    options = [str(word) for word in words if not str(word).startswith("=")]
    values = [word[1:] for word in words if str(word).startswith("=")]
    done = subprocess.run(["mbpoll", *LINE, "-a", str(unit), *options, device, *values], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
    return done.returncode, done.stdout


def words_in(text):
    """The registers that it shows, by address."""
    return {int(at): int(word) for at, word in re.findall(r"\[(\d+)\]: \t(\d+)", text)}


def server(check, device):
    def expect(what, words, *parts, unit=1, may_fail=True):
        status, text = mbpoll(device, "-v", *words, unit=unit)  # it shows the bytes it sends
        check((may_fail or status == 0) and all(part in text for part in parts), what, text)

    expect("03 reads", ["-r", 100, "-c", 3], "[01][03]", "[102]: \t102", may_fail=False)
    expect("06 writes", ["-r", 110, "=4711"], "[01][06]", "Written 1 reference", may_fail=False)
    expect("16 writes", ["-r", 111, "=7", "=8"], "[01][10]", "Written 2 reference", may_fail=False)
    expect("all was written", ["-r", 110, "-c", 3], "[110]: \t4711", "[112]: \t8")
    expect("exception 01", ["-t", 0, "-r", 0], "Illegal function")
    expect("exception 02", ["-r", 199, "-c", 2], "Illegal data address")
    expect("exception 03", ["-r", 100, "-c", 64], "Illegal data value")
    expect("silence of another unit", ["-r", 100], "timed out", unit=9)


def read(device, unit, start, count):
    return words_in(mbpoll(device, "-r", start, "-c", count, unit=unit)[1])


def goes_up_and_down(device, unit, name, check):
    at = Registers(name)
    for word, mask, state in ((0x0006, 0x6F, 0x21), (0x0007, 0x6F, 0x23), (0x000F, 0x6F, 0x27),
                              (0x0007, 0x6F, 0x23), (0x0006, 0x6F, 0x21), (0x0000, 0x4F, 0x40)):
        written, _ = mbpoll(device, "-r", at.cmd, f"={word}", unit=unit)
        status = read(device, unit, at.eta, 1)
        is_right = written == 0 and status.get(at.eta, 0) & mask == state
        check(is_right, f"{name}: CMD {word:04X} leads to xx{state:02X}", status)


def drives(check, program):
    names = dict(enumerate(DRIVES, 1))
    simulator = Simulator(program, *(f"{name}:{unit}" for unit, name in names.items()))
    with simulator as device:
        for unit, name in names.items():
            if Registers(name).tto:
                simulator.suffer(f"{unit} write {Registers(name).tto} {LONG}")
        for _ in range(ROUNDS):
            for unit, name in names.items():
                at = Registers(name)
                words = read(device, unit, *at.monitoring)
                is_whole = len(words) == at.monitoring[1] and words[at.rfr] == 0
                status = read(device, unit, at.eta, 1)
                is_right = is_whole and status[at.eta] & 0x4F == 0x40
                check(is_right, f"{name} at unit {unit}", words)
        for unit, name in names.items():
            # Others were asked meanwhile: a drive that is switched on again expects nobody yet.
            simulator.suffer(f"{unit} cycle")
            check.soon(lambda at=unit: simulator.shown(at)[0] == "switch on disabled", f"{name} is ready for a start", 20)
            goes_up_and_down(device, unit, name, check)
        check(read(device, 9, 3201, 1) == {}, "nobody at unit 9")


def main(check, what, with_whom):
    {"server": server, "drives": drives}[what](check, with_whom)


if __name__ == "__main__":
    runs(main)
