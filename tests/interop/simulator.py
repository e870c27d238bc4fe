# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs `rtuwire simulate`, and says what others' tools need to know of the simulated drives."""
import subprocess
import sys
import threading
import time

DRIVES = ("atv12", "atv28", "atv310", "atv310_2026", "atv320")


class Registers:
    """Where a drive keeps what these tests touch."""

    def __init__(self, drive):
        old = drive == "atv28"
        self.cmd, self.lfr = (400, 401) if old else (8501, 8502)
        self.eta, self.rfr, self.lft = (458, 451, 457) if old else (3201, 3202, 7121)
        self.acc, self.dec = (252, 253) if old else (9001, 9002)
        self.tto = None if old else 6005
        self.monitoring = (451, 7) if old else (3201, 4)


class Simulator:
    """with Simulator(tool, "atv320:1") as device: ..."""

    def __init__(self, tool, *drives, vendor=None):
        self.drives = drives
        words = ["--vendor", vendor] if vendor else []
        self.process = subprocess.Popen([tool, "simulate", *drives, *words], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)

    def __enter__(self):
        device = None
        for drive in self.drives:
            line = self.process.stdout.readline()
            name, unit = drive.split(":")
            start, _, device = line.strip().rpartition(" ")
            if start != f"{name} unit {unit} on":
                raise RuntimeError(f"the simulator says {line!r}")
        return device

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def suffer(self, what):
        """What happens to a drive: "1 fault", "1 clear", "1 local"... It has happened when this returns."""
        self.told(what)
        self.shown(what.split()[0])

    def told(self, what):
        self.process.stdin.write(what + "\n")
        self.process.stdin.flush()

    def shown(self, unit):
        """State, output frequency in Hz and last fault (LFT) of a drive. No request goes over its line, so that
        looking does not keep it running."""
        self.told(f"{unit} show")
        state, frequency, fault = self.process.stdout.readline().split(": ")[1].split(", ")
        return state, float(frequency.removesuffix(" Hz")), int(fault.split()[1])


def pymodbus_on(device, timeout=5):
    """A client of pymodbus, which asks nothing twice by itself."""
    from pymodbus.client import ModbusSerialClient
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    line = ModbusSerialClient(device, baudrate=19200, parity="N", stopbits=1, timeout=timeout, retries=0)
    if not line.connect():
        raise RuntimeError("pymodbus cannot open the device")
    return line


class Repetitions:
    """Counts the requests of this run that are made again because nobody answered. On a machine that is busy
    a byte may be late enough to end a frame; that happens once at most, and a unit that loses requests is
    not taken for a good one."""
    allowed = 1

    def __init__(self):
        self.count = 0

    def note(self, why):
        """To be called before a request is made again; raises where that is once too often."""
        self.count += 1
        print("     no answer:", why)
        if self.count > self.allowed:
            raise RuntimeError(f"requests repeated: {self.count}, more than {self.allowed}")


repetitions = Repetitions()


def asked(request):
    """What a unit answers to a request of pymodbus, an exception too. Without an answer the request is made
    again, which counts."""
    from pymodbus.exceptions import ModbusIOException
    while True:
        try:
            answer = request()
        except ModbusIOException as error:
            answer = error
        if not isinstance(answer, ModbusIOException):
            return answer
        repetitions.note(answer)


def soon(is_so, limit=60):
    """Looks until it is so; whether it is. For what takes its time: looking must not change anything."""
    end = time.monotonic() + limit
    while not (found := is_so()) and time.monotonic() < end:
        time.sleep(0.02)
    return found


class Checks:
    """Prints each check as it is made, in whichever thread, and those that failed once more at the end, where they are looked
    for."""

    def __init__(self):
        self.failed, self.lock = [], threading.Lock()

    def __call__(self, is_right, what, detail=""):
        with self.lock:
            print("ok  " if is_right else "FAIL", what, detail, flush=True)
        if not is_right:
            self.failed.append(what)

    def status(self):
        """What the program ends with; says how often something was asked again."""
        print("requests repeated:", repetitions.count)
        for what in self.failed:
            print("failed:", what)
        return 1 if self.failed else 0

    def soon(self, is_so, what, limit=60):
        self(soon(is_so, limit), what)


def runs(main):
    """The program of a test: what it checks, with its arguments, is its status."""
    check = Checks()
    main(check, *sys.argv[1:])
    sys.exit(check.status())
