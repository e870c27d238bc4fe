# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds a firmware example, runs it on an emulated board, and lets a program ask it.

    python3 emulated.py BOARD controller SIMULATE DRIVE    it runs a simulated drive
    python3 emulated.py BOARD server [lossy]               mbpoll and pymodbus ask it
    python3 emulated.py BOARD frame_server [lossy]         the same, with DMA and an idle-line interrupt
    python3 emulated.py BOARD simulated_drive [lossy]      the same, and pymodbus runs it
    python3 emulated.py BOARD checked TOOL                 the server is held to each must of `check`
    python3 emulated.py BOARD bare_cortex_m                the file of examples/boards polls a unit

With "lossy" every second request is lost on its way, and the run has to fail.
"""
import contextlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import time
import tty

HERE = pathlib.Path(__file__).resolve().parent
FIRMWARE = HERE.parents[1] / "examples" / "firmware"
sys.path.insert(0, str(HERE.parent / "interop"))

from frames import LossyLine, with_crc  # noqa: E402
from mbpoll import mbpoll, words_in  # noqa: E402
from simulator import Simulator, asked, repetitions, runs  # noqa: E402

MACHINES = {"mps2_an385": "mps2-an385", "lm3s6965evb": "lm3s6965evb"}


def build(place, board, program, *flags):
    elf = pathlib.Path(place) / f"{pathlib.PurePath(program).name}.elf"
    subprocess.run(["sh", FIRMWARE / "build.sh", board, program, elf, *flags], check=True)
    return elf


class Emulator:
    """A board whose line is `line` ("pty" makes one) and whose console is read here."""

    def __init__(self, board, elf, line):
        self.process = subprocess.Popen(
            ["qemu-system-arm", "-M", MACHINES[board], "-kernel", elf, "-display", "none",
             "-monitor", "none", "-serial", line, "-serial", "stdio",
             "-semihosting-config", "enable=on,target=native"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        # A program that hangs ends the test, not the machine.
        self.limit = threading.Timer(240, self.process.kill)
        self.limit.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.limit.cancel()
        self.process.kill()
        self.process.wait()

    def wait_for(self, pattern):
        """The first line that the pattern is found in."""
        for line in self.process.stdout:
            print("|", line, end="")
            if found := re.search(pattern, line):
                return found
        raise RuntimeError(f"the emulator ended without {pattern!r}")


@contextlib.contextmanager
def held_open(device):
    """The line stays up between two programs that open it. Where the last one closes it, the emulator looks only once
    a second whether somebody is there again, and a new terminal echoes until it is told not to."""
    line = os.open(device, os.O_RDWR | os.O_NOCTTY)
    try:
        tty.setraw(line)
        yield
    finally:
        os.close(line)


def run_controller(check, place, board, simulate, drive):
    elf = build(place, board, "controller", f"-DRTUWIRE_DRIVE={drive}")
    with Simulator(simulate, f"{drive}:1") as line, Emulator(board, elf, line) as firmware:
        firmware.wait_for("^ready")
        check(firmware.wait_for("^start: (\\w+)")[1] == "done", "it starts the drive")
        seconds = 0
        while not (line := firmware.wait_for("^(output frequency (.*?),|stop: (\\w+)|no values)"))[3]:
            seconds += 1
            frequency = line[2]
        check(seconds == 4, "a line for each of four seconds", seconds)
        check(frequency == "30.0 Hz", "the motor turns at 30 Hz", frequency)
        check(line[3] == "done", "it stops the drive", line[3])
        check(firmware.process.wait(60) == 0, "it ends well")


def polled(device, *words):
    """What mbpoll prints; what got no answer is asked again, which counts."""
    while "timed out" in (text := mbpoll(device, *words)[1]):
        repetitions.note(text)
    return text


class Unit:
    """Unit 1 on a line, asked by pymodbus."""

    def __init__(self, client):
        self.client = client

    def read(self, address, count=1):
        answer = asked(lambda: self.client.read_holding_registers(address, count, slave=1))
        return [] if answer.isError() else answer.registers

    def write(self, address, word):
        """None when it is done, else the exception."""
        answer = asked(lambda: self.client.write_register(address, word, slave=1))
        return answer.exception_code if answer.isError() else None

    def write_many(self, address, *words):
        return not asked(lambda: self.client.write_registers(address, words, slave=1)).isError()


def ask_server(device, check):
    from pymodbus.client import ModbusSerialClient
    text = polled(device, "-r", 10, "=475")
    check("Written 1 references" in text, "mbpoll writes the setpoint")
    words = words_in(polled(device, "-r", 10, "-c", 3, "-q"))
    check((words[10], words[11]) == (475, 475), "mbpoll reads the pump", words)
    with ModbusSerialClient(device, baudrate=19200, timeout=5, retries=0) as client:
        pump = Unit(client)
        check(pump.read(12) == [65531], "-5 degrees")
        check(pump.write(10, 601) == 3, "601 is above its limit")
        check(pump.write(11, 1) == 2, "a reading is not written")
        check(pump.write_many(10, 300) and pump.read(10, 2) == [300, 300],
              "pymodbus writes and reads")


def run_drive(device, check):
    from pymodbus.client import ModbusSerialClient
    # A unit that has just started takes no request before its line was silent: 50 ms with a host's timing.
    time.sleep(0.2)
    with ModbusSerialClient(device, baudrate=19200, timeout=5, retries=0) as client:
        drive = Unit(client)

        def status():
            return drive.read(3201)[0] & 0x6F
        check.soon(lambda: status() & 0x4F == 0x40, "the drive is switch on disabled")
        drive.write(8502, 300)
        for command, state in ((6, 0x21), (7, 0x23), (15, 0x27)):
            drive.write(8501, command)
            check.soon(lambda: status() == state, f"command {command}")
        check.soon(lambda: drive.read(3202) == [300], "30 Hz")
    words = words_in(polled(device, "-r", 3201, "-c", 2, "-q"))
    check(words[3202] == 300, "mbpoll reads 30 Hz", words)


def run_checked(check, place, board, tool):
    elf = build(place, board, "server")
    with Emulator(board, elf, "pty") as firmware:
        device = firmware.wait_for("redirected to (\\S+)")[1]
        with held_open(device):
            firmware.wait_for("^ready")
            ended = subprocess.run(
                [tool, "--port", device, "--unit", "1", "--no-listen", "--json", "check", "--readable", "10"],
                env={**os.environ, "HOME": place}, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=500)
    rows = [json.loads(line) for line in ended.stdout.splitlines()]
    fails = [(row["clause"], row["why"]) for row in rows if row["verdict"] == "fails" and row["level"] == "must"]
    holds = sum(row["verdict"] == "holds" for row in rows)
    print(ended.stderr)
    check(ended.returncode == 0 and not fails and holds > 60, "every must holds", (ended.returncode, fails, holds))


def run_bare(check, place, board):
    """A unit that answers each request, but every third with a byte too few."""
    elf = build(place, board, "../boards/bare_cortex_m")
    asks, answer = with_crc(bytes.fromhex("07 03 0C 81 00 01")), with_crc(bytes.fromhex("07 03 02 02 50"))
    with Emulator(board, elf, "pty") as firmware:
        device = firmware.wait_for("redirected to (\\S+)")[1]
        line = os.open(device, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(line)

        def answers():
            heard = b""
            for number in range(1, 13):
                while len(heard) < len(asks):
                    heard += os.read(line, 256)
                request, heard = heard[:len(asks)], heard[len(asks):]
                check(request == asks, "it asks for the register", request)
                os.write(line, answer if number % 3 else answer[:-1])
        unit = threading.Thread(target=answers)
        unit.start()
        values = [firmware.wait_for("^value (\\d+)")[1] for _ in range(8)]
        unit.join()
        os.close(line)
    check(values == ["592"] * 8, "it reads the register", values)


def run_unit(check, place, board, program, *how):
    elf = build(place, board, program)
    with Emulator(board, elf, "pty") as firmware, contextlib.ExitStack() as between:
        device = firmware.wait_for("redirected to (\\S+)")[1]
        between.enter_context(held_open(device))
        firmware.wait_for("^ready")
        if how == ("lossy",):
            device = between.enter_context(LossyLine(device)).name
        {"server": ask_server, "frame_server": ask_server,
         "simulated_drive": run_drive}[program](device, check)


def main(check, board, program, *rest):
    with tempfile.TemporaryDirectory() as place:
        if program == "controller":
            run_controller(check, place, board, *rest)
        elif program == "checked":
            run_checked(check, place, board, *rest)
        elif program == "bare_cortex_m":
            run_bare(check, place, board)
        else:
            run_unit(check, place, board, program, *rest)


runs(main)
