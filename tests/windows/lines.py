# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The ports of a host as Windows has them, in Wine: a serial port that is a link to a pseudo-terminal, and TCP. Others'
programs of Linux are at the other end. LINE_PROGRAM, PORTS_PROGRAM and HOOK_PROGRAMS are those of this folder.

What Wine does not show, and nothing here tests: parity and damaged bytes, that a second program is kept out of a port, how an
adapter's driver ends when it is unplugged.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import tty
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "interop"))

from mbpoll import words_in  # noqa: E402
from pair import Programs, free_port, wait_for_listener  # noqa: E402

PROGRAM, PORTS_PROGRAM = os.environ["LINE_PROGRAM"], os.environ["PORTS_PROGRAM"]
LIMIT = 120  # s, for what has to come
ENUM, THERE = r"SYSTEM\CurrentControlSet\Enum", r"HARDWARE\DEVICEMAP\SERIALCOMM"


class Wine:
    """with Wine() as wine: a Windows of this test's own, with no serial port at first."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="wine-", dir=os.getcwd())
        self.environment = {**os.environ, "WINEPREFIX": self.folder.name}
        self.run("wineboot", "--init")
        return self

    def __exit__(self, *_):
        subprocess.run(["wineserver", "-k"], env=self.environment, check=False)
        subprocess.run(["wineserver", "-w"], env=self.environment, check=False)
        self.folder.cleanup()

    def command(self, words):
        return ["sh", str(HERE / "wine.sh"), *map(str, words)]

    def start(self, *words, **how):
        how = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL, "text": True, **how}
        return subprocess.Popen(self.command(words), env=self.environment, **how)

    def run(self, *words):
        """Its status, and what it says."""
        with self.start(*words) as process:
            output, errors = process.communicate(timeout=LIMIT)
        return process.returncode, (output + errors).splitlines()

    def enter(self, key, **values):
        """Values of the registry's machine, all of them texts."""
        for name, text in values.items():
            status, lines = self.run("reg", "add", rf"HKLM\{key}", "/v", name, "/d", text, "/f")
            if status != 0:
                raise RuntimeError(f"{key}: {lines}")

    def run_with(self, keys, program):
        """As `run`, behind these texts in the registry. In one go: what the system keeps in memory ends with the last program."""
        def quoted(text):
            return '"' + text.replace("\\", "\\\\") + '"'
        lines = ["REGEDIT4"]
        for key, values in keys.items():
            lines += ["", rf"[HKEY_LOCAL_MACHINE\{key}]", *(f"{quoted(name)}={quoted(text)}" for name, text in values.items())]
        texts = pathlib.Path(self.folder.name, "texts.reg")
        texts.write_text("\r\n".join(lines) + "\r\n", encoding="ascii")
        place = "Z:" + str(texts).replace("/", "\\")
        return self.run("cmd", "/c", f"regedit /S {place} & Z:" + program.replace("/", "\\"))

    def link(self, number, device):
        """From now on COM9 is this device."""
        place = pathlib.Path(self.folder.name, "dosdevices", f"com{number}")
        place.unlink(missing_ok=True)
        place.symlink_to(device)


class PseudoTerminal:
    """with PseudoTerminal() as line: a program opens `line.name`, and nobody answers."""

    def __enter__(self):
        self.near, far = os.openpty()
        tty.setraw(far)
        self.name = os.ttyname(far)
        self.far = far
        return self

    def pull(self):
        """No end of it is left here."""
        for number in filter(None, (self.near, self.far)):
            os.close(number)
        self.near = self.far = None

    def __exit__(self, *_):
        self.pull()


class Lines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.wine = cls.enterClassContext(Wine())

    def said(self, *words):
        status, lines = self.wine.run(PROGRAM, *words)
        self.assertEqual(status, 0, lines)
        return lines

    def test_a_hundred_exchanges_with_pymodbus_at_com9_and_com10(self):
        for number in (9, 10):
            with self.subTest(number), Programs() as others:
                near, far = others.line()
                others.serve(near, ["/usr/bin/python3", "-B", str(HERE.parent / "interop" / "pymodbus_server.py"), "@"])
                self.wine.link(number, os.path.realpath(far))
                self.assertEqual(self.said("ask", f"COM{number}", 100), ["100 of 100"])

    def test_mbpoll_asks_a_server_at_com9(self):
        with Programs() as others:
            near, far = others.line()
            self.wine.link(9, os.path.realpath(near))
            server = self.wine.start(PROGRAM, "serve", "COM9")
            self.addCleanup(server.communicate)
            self.addCleanup(server.kill)
            self.assertEqual(server.stdout.readline(), "ready\n")
            for start in (100, 137):
                self.assertEqual(self.mbpoll(["-m", "rtu", "-b", 19200, "-P", "none", "-r", start, "-c", 60], far),
                                 {at: at for at in range(start, start + 60)})

    def mbpoll(self, words, where):
        done = subprocess.run(["mbpoll", "-a", "1", "-0", "-1", "-o", "5", *map(str, words), where], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LIMIT)
        self.assertEqual(done.returncode, 0, done.stdout)
        return words_in(done.stdout)

    def test_nothing_comes_before_the_deadline(self):
        with PseudoTerminal() as line:
            self.wine.link(9, line.name)
            began = time.monotonic()
            self.assertEqual(self.said("read", "COM9", 700), ["nothing"])
            self.assertGreaterEqual(time.monotonic() - began, 0.7)
            self.assertEqual(self.said("read", "COM9", 0), ["nothing"])

    def test_a_missing_value_calls_the_hook_of_the_program(self):
        for program in os.environ["HOOK_PROGRAMS"].split(":"):
            self.assertEqual(self.wine.run(program), (7, ["stopped"]), program)

    def test_what_nobody_takes_is_given_up(self):
        with PseudoTerminal() as line:
            self.wine.link(9, line.name)
            self.assertEqual(self.said("write", "COM9", 256, 5000), ["sent"])
            self.assertEqual(self.said("write", "COM9", 1_000_000, 500)[0].split(" | ")[0], "the transmitter never finished")

    def test_a_port_that_is_pulled_has_vanished(self):
        with PseudoTerminal() as line:
            self.wine.link(9, line.name)
            program = self.wine.start(PROGRAM, "pulled", "COM9", stdin=subprocess.PIPE)
            self.addCleanup(program.kill)
            self.assertEqual(program.stdout.readline(), "open\n")
            line.pull()
            output, _ = program.communicate("\n", timeout=LIMIT)
        read, left = output.splitlines()
        self.assertRegex(read, r"^the device vanished \| COM9: the device vanished")
        self.assertEqual(left, "closed")

    def test_what_is_no_port_is_told_with_its_name(self):
        for name, words in (("COM44", "no such device"), ("nothing at all", "no such device"), ("", "no such device"),
                            ("NUL", "not a serial device")):
            status, lines = self.wine.run(PROGRAM, "read", name, 1)
            self.assertEqual(status, 2, lines)
            self.assertRegex(lines[-1], f"^{name}: {words}")

    def test_a_port_on_usb_is_known_by_the_registry(self):
        with PseudoTerminal() as line:
            self.wine.link(9, line.name)
            self.assertEqual(self.said("silence", "COM9", 115200), ["1750"])
            self.wine.enter(rf"{ENUM}\USB\VID_1A86&PID_7523\5&1c3a&0&2\Device Parameters", PortName="COM9")
            for name in ("COM9", "com9", r"\\.\COM9"):
                self.assertEqual(self.said("silence", name, 115200), ["0"], name)
            self.wine.link(19, line.name)
            self.assertEqual(self.said("silence", "COM19", 115200), ["1750"])

    def test_ports_are_those_that_are_there_with_what_is_known_of_them(self):
        # As Windows 10 has an adapter of FTDI, one of a class of USB with a serial number, a CH340, which has none, and a
        # port on the board. COM77 was there once; two adapters have been COM31.
        devices = (
                (r"FTDIBUS\VID_0403+PID_6001+A9XYZ123A\0000", "COM40",
                 {"FriendlyName": "USB Serial Port (COM40)", "Mfg": "@oem12.inf,%ftdi%;FTDI", "Service": "FTSER2K"}),
                (r"USB\VID_2E8A&PID_000A&MI_00\E66118C4E3", "COM5",
                 {"FriendlyName": "USB Serial Device (COM5)", "Mfg": "@usbser.inf,%msft%;Microsoft", "Service": "usbser"}),
                (r"USB\VID_1A86&PID_7523\5&2f4a&0&1", "COM12",
                 {"FriendlyName": "USB-SERIAL CH340 (COM12)", "Mfg": "wch.cn", "Service": "CH341SER_A64"}),
                (r"USB\VID_1A86&PID_7523\5&2f4a&0&2", "COM77", {"FriendlyName": "USB-SERIAL CH340 (COM77)"}),
                (r"USB\VID_1A86&PID_7523\5&2f4a&0&3", "COM31", {"FriendlyName": "USB-SERIAL CH340 (COM31)"}),
                (r"USB\VID_0403&PID_6015\D30A", "COM31", {"FriendlyName": "another (COM31)"}))
        keys = {THERE: {r"\Device\VCP0": "COM40", r"\Device\USBSER000": "COM5", r"\Device\Serial2": "COM12",
                                  r"\Device\Serial0": "COM1", r"\Device\Serial7": "COM31"}}
        for bus, port, values in devices:
            keys |= {rf"{ENUM}\{bus}": values, rf"{ENUM}\{bus}\Device Parameters": {"PortName": port}}
        status, lines = self.wine.run_with(keys, PORTS_PROGRAM)
        self.assertEqual((status, lines), (0, ["COM1|||||", "COM5||usbser|Microsoft|USB Serial Device|E66118C4E3",
                                               "COM12||CH341SER_A64|wch.cn|USB-SERIAL CH340|", "COM31|||||",
                                               "COM40||FTSER2K|FTDI|USB Serial Port|A9XYZ123"]))

    def test_pymodbus_over_tcp(self):
        with Programs() as others:
            number = free_port()
            others.serve(f"tcp:{number}",
                         ["/usr/bin/python3", "-B", str(HERE.parent / "interop" / "pymodbus_server.py"), "@"])
            wait_for_listener(number)
            for host in ("127.0.0.1", "localhost"):
                self.assertEqual(self.said("ask", f"tcp:{host}:{number}", 100), ["100 of 100"])

    def test_where_nobody_listens_is_told(self):
        status, lines = self.wine.run(PROGRAM, "read", f"tcp:127.0.0.1:{free_port()}", 1)
        self.assertEqual(status, 2)
        self.assertRegex(lines[-1], r"^127\.0\.0\.1:\d+: no connection \(Connection refused\)")
        status, lines = self.wine.run(PROGRAM, "read", "tcp:nobody.invalid:502", 1)
        self.assertEqual(status, 2)
        self.assertRegex(lines[-1], r"^nobody\.invalid:502: no such host \(")

    def test_mbpoll_asks_a_listener_and_so_does_a_stream(self):
        number = free_port()
        server = self.wine.start(PROGRAM, "serve", f"mbap:127.0.0.1:{number}")
        self.addCleanup(server.communicate)
        self.addCleanup(server.kill)
        self.assertEqual(server.stdout.readline(), "ready\n")
        for start in (100, 137):
            self.assertEqual(self.mbpoll(["-m", "tcp", "-p", number, "-r", start, "-c", 60], "127.0.0.1"),
                             {at: at for at in range(start, start + 60)})
        self.assertEqual(self.said("ask", f"mbap:127.0.0.1:{number}", 100), ["100 of 100"])
        status, lines = self.wine.run(PROGRAM, "serve", f"mbap:127.0.0.1:{number}")
        self.assertEqual(status, 2, lines)
        self.assertRegex(lines[-1], f"127.0.0.1:{number}: cannot listen there: Address already in use")


if __name__ == "__main__":
    unittest.main()
