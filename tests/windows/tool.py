# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The tool for Windows, in Wine, against a drive that the tool for Linux simulates at the other end of COM9: what a person
does with it, and that a motor is stopped by a frame whatever ends the program. RTUWIRE_EXE is rtuwire.exe, CONSOLE_PROGRAM
console_program.exe, TOOL the tool for Linux.

What Wine does not show: parity, a console whose text somebody marks, log-off and shutdown, and what a driver does when its
adapter is pulled.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

os.environ |= {"LINE_PROGRAM": "", "PORTS_PROGRAM": ""}  # of lines.py alone

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "programs"), str(HERE.parent / "interop")]

from lines import Wine  # noqa: E402
from pair import free_port, wait_for_listener  # noqa: E402
from simulator import Registers, Simulator, soon  # noqa: E402

PROGRAM, CONSOLE, TOOL = (os.environ[name] for name in ("RTUWIRE_EXE", "CONSOLE_PROGRAM", "TOOL"))
DONE, DIFFERS, USAGE, NO_ANSWER, PORT, REFUSED = range(6)
LIMIT = 120  # s, for what has to come
# A pseudo-terminal has no parity, and Wine says so.
LINE = ("-p", "COM9", "-f", "8N1", "-u", "7", "--no-listen")
TTO = 30  # s, before which the drive stops by itself


class Ended:
    def __init__(self, status, output, errors):
        self.status, self.output, self.errors = status, output.decode(), errors.decode()

    def __repr__(self):
        return f"status {self.status}\n{self.output}\n{self.errors}"


class Drive:
    """with Drive(wine) as drive: an ATV320 at COM9, whose simulation tells what the motor does, without a frame."""

    def __init__(self, wine):
        self.wine, self.simulator, self.at = wine, Simulator(TOOL, "atv320:7"), Registers("atv320")

    def __enter__(self):
        self.device = self.simulator.__enter__()
        self.wine.link(9, self.device)
        for address in (self.at.acc, self.at.dec):
            self.simulator.suffer(f"7 write {address} 5")
        return self

    def __exit__(self, *_):
        self.simulator.__exit__()

    def shown(self):
        return self.simulator.shown(7)

    def runs(self):
        return self.shown()[1] == 40


class Tool(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.wine = cls.enterClassContext(Wine())
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="tool-", dir=os.getcwd())))

    def start(self, *words, program=PROGRAM, **how):
        return self.wine.start(program, *words, text=False, cwd=self.folder, **how)

    def run_tool(self, *words, given=None):
        with self.start(*words, **({"stdin": subprocess.PIPE} if given is not None else {})) as process:
            output, errors = process.communicate(given, timeout=LIMIT)
        return Ended(process.returncode, output, errors)

    def done(self, *words, status=DONE, **how):
        ended = self.run_tool(*words, **how)
        self.assertEqual(ended.status, status, ended)
        return ended

    @staticmethod
    def windows_path(path):
        return "Z:" + str(path).replace("/", "\\")

    def assert_stopped_by_frame(self, drive, began):
        """It stands long before its own time-out, and has no fault: that of a lost line is one."""
        self.assertTrue(soon(lambda: drive.shown()[1] == 0, 10), drive.shown())
        self.assertLess(time.monotonic() - began, TTO / 2)
        self.assertEqual(drive.shown()[2], 0, drive.shown())
        self.assertNotIn("fault", drive.shown()[0])

    # What it is

    def test_it_needs_windows_alone_and_hears_of_log_off(self):
        told = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", PROGRAM], check=True, text=True, stdout=subprocess.PIPE)
        needed = {line.split()[-1].lower() for line in told.stdout.splitlines() if "DLL Name" in line}
        self.assertLessEqual(needed, {"kernel32.dll", "msvcrt.dll", "ws2_32.dll", "advapi32.dll"})

    def test_help_version_and_wrong_words(self):
        self.assertIn("scan", self.done("--help").output)
        self.assertNotIn("\r", self.done("read", "--help").output)
        self.assertRegex(self.done("--version").output, r"^\d+\.\d+\.\d+\n$")
        self.assertIn("did you mean", self.done("raed", status=USAGE).errors)
        self.assertIn("no such device", self.done("-p", "COM44", "read", "RFR", status=PORT).errors)
        self.assertIn("a port is COM3", self.done("-p", "nothing", "read", "RFR", status=USAGE).errors)

    def test_what_windows_has_not_is_said(self):
        self.assertIn("COM3", self.done("simulate", "atv320:7", status=PORT).errors)
        self.assertIn("there is none on Windows", self.done("gateway", "file.toml", status=USAGE).errors)
        esphome = self.folder / "esphome.yaml"
        esphome.write_text("sensor:\n  - platform: modbus_controller\n")
        self.assertIn("YAML", self.done("device", "import", "esphome.yaml", status=USAGE).errors)

    # Without a wire

    def test_simulated_drives(self):
        found = self.done("--json", "-p", "sim:atv320:7", "scan")
        self.assertEqual([json.loads(line)["unit"] for line in found.output.splitlines()], [7])
        self.assertIn("Hz", self.done("-p", "sim:atv320:7,atv12:3", "-u", "7", "read", "RFR").output)
        self.assertEqual(self.done("-p", "sim:atv320:7", "-u", "9", "--retries", "0", "read", "RFR",
                                   status=NO_ANSWER).errors.count("mbap"), 0)

    def test_degrees_and_files_with_letters_of_all_kinds(self):
        place = self.folder / "Zähler °C"
        place.mkdir()
        (place / "ofen.toml").write_text("\r\n".join((
            '[[register]]', 'name = "ofen"', 'address = 40', 'type = "i16"', 'scale = 0.1', 'unit = "°C"', 'access = "write"', '')),
            newline="")
        for path in ("Zähler °C/ofen.toml", "Zähler °C\\ofen.toml", self.windows_path(place / "ofen.toml")):
            self.assertIn("0.0 °C", self.done("-p", f"sim:{path}:61", "-u", "61", "--device", path, "read", "ofen").output)
        written = self.done("-p", "sim:Zähler °C/ofen.toml:61", "-u", "61", "--device", "Zähler °C/ofen.toml", "--write", "write",
                            "ofen=21.5°C")
        self.assertIn("21.5 °C", written.output)
        self.done("-p", "sim:Zähler °C/ofen.toml:61", "-u", "61", "--device", "Zähler °C/ofen.toml", "--trace", "Zähler °C/°.pcapng",
                  "read", "ofen")
        self.assertTrue((place / "°.pcapng").read_bytes().startswith(b"\x0a\x0d\x0d\x0a"))

    # At COM9

    def test_read_write_identify_and_scan(self):
        with Drive(self.wine) as drive:
            self.assertIn("ATV320", self.done(*LINE, "identify").output)
            self.assertEqual(json.loads(self.done(*LINE, "--json", "read", "ACC").output)["value"], 0.5)
            self.done(*LINE, "--write", "write", "ACC=2.5s")
            self.assertEqual(json.loads(self.done(*LINE, "--json", "read", "ACC").output)["value"], 2.5)
            found = self.done("-p", "COM9", "-f", "8N1", "--no-listen", "--json", "scan", "--baud", "19200", "--units", "5-8")
            self.assertIn(7, [json.loads(line).get("unit") for line in found.output.splitlines()])
            self.assertEqual(drive.shown()[1], 0)

    def test_backup_and_compare(self):
        with Drive(self.wine):
            self.done(*LINE, "backup", "-o", "kept.json")
            text = (self.folder / "kept.json").read_bytes()
            self.assertNotIn(b"\r", text)
            self.assertIn("rtuwire backup 1", text.decode())
            self.done(*LINE, "compare", "kept.json")
            self.done(*LINE, "backup", "-o", "kept.json")
            self.assertEqual([each.name for each in self.folder.glob("kept*")], ["kept.json"])

    def test_a_capture_is_one_for_wireshark(self):
        with Drive(self.wine):
            self.done(*LINE, "--trace", "seen.pcapng", "read", "RFR", "ACC", "LSP")
            frames = subprocess.run(["tshark", "-r", str(self.folder / "seen.pcapng")], check=True, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertGreaterEqual(len(frames.stdout.splitlines()), 2, frames)
            self.assertEqual(frames.stderr.count("damaged"), 0)
            self.assertIn("register 3202", self.done("-p", "seen.pcapng", "decode").output)

    def test_start_for_some_time_and_stop_by_another_call(self):
        with Drive(self.wine) as drive:
            ended = self.done(*LINE, "--allow-run", "--yes", "start", "--frequency", "40Hz", "--for", "3s")
            self.assertIn("the motor stands", ended.output + ended.errors)
            self.assertEqual(drive.shown()[1:], (0, 0))
            for word in (6, 7, 15):
                drive.simulator.suffer(f"7 write {drive.at.cmd} {word}")
            drive.simulator.suffer(f"7 write {drive.at.lfr} 400")
            self.assertTrue(soon(drive.runs, 10))
            self.assertIn("the motor stands", self.done(*LINE, "stop").output)
            self.assertEqual(drive.shown()[1:], (0, 0))

    def test_over_tcp(self):
        number = free_port()
        with subprocess.Popen([TOOL, "-p", f"mbap://127.0.0.1:{number}", "simulate", "atv320:7"],
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as drives:
            self.addCleanup(drives.kill)
            wait_for_listener(number)
            where = ("-p", f"mbap://127.0.0.1:{number}", "-u", "7")
            self.assertIn("Hz", self.done(*where, "read", "RFR").output)
            self.assertIn("the motor stands", (lambda it: it.output + it.errors)(
                self.done(*where, "--allow-run", "--yes", "start", "--frequency", "40Hz", "--for", "2s")))
            drives.kill()

    def test_it_simulates_for_others_over_tcp(self):
        number = free_port()
        drives = self.start("-p", f"mbap://127.0.0.1:{number}", "simulate", "atv320:7", stdin=subprocess.PIPE)
        self.addCleanup(drives.wait)
        self.addCleanup(drives.kill)
        self.assertIn(b"atv320 unit 7", drives.stdout.readline())
        read = subprocess.run([TOOL, "-p", f"mbap://127.0.0.1:{number}", "-u", "7", "read", "RFR"], check=True, text=True,
                              stdout=subprocess.PIPE)
        self.assertIn("Hz", read.stdout)
        drives.stdin.write(b"7 show\n")
        drives.stdin.flush()
        self.assertIn(b"unit 7: ", drives.stdout.readline())

    # Whatever ends it

    def running(self, drive, event, *words):
        """`start` in a console of its own, once the motor runs."""
        process = self.start(event, pathlib.Path(PROGRAM).resolve(), *LINE, "--allow-run", "--yes", "start", "--frequency", "40Hz",
                             *words, program=CONSOLE, stdin=subprocess.PIPE)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.assertTrue(soon(drive.runs, 60), drive.shown())
        return process

    def ended_by(self, event, line=b"\n"):
        with Drive(self.wine) as drive:
            process = self.running(drive, event)
            began = time.monotonic()
            process.stdin.write(line)
            process.stdin.flush()
            self.assert_stopped_by_frame(drive, began)
            output, errors = process.communicate(timeout=LIMIT)
            return Ended(process.returncode, output, errors)

    def test_ctrl_c_stops_the_motor(self):
        ended = self.ended_by("c")
        self.assertEqual(ended.status, DONE, ended)
        self.assertIn("the motor stands", ended.output + ended.errors)

    def test_ctrl_break_stops_the_motor(self):
        ended = self.ended_by("break")
        self.assertIn("the motor stands", ended.output + ended.errors)

    def test_a_window_that_is_closed_a_log_off_and_a_shutdown_stop_the_motor(self):
        for event in ("close", "logoff", "shutdown"):
            with self.subTest(event):
                ended = self.ended_by(event)
                self.assertIn("the motor stands", ended.output + ended.errors)

    def test_a_closed_window_takes_the_power_of_a_motor_that_slows_too_long(self):
        with Drive(self.wine) as drive:
            drive.simulator.suffer(f"7 write {drive.at.dec} 600")
            process = self.running(drive, "close")
            process.stdin.write(b"\n")
            process.stdin.flush()
            process.wait(LIMIT)
            self.assertEqual(process.returncode, 98, "Windows has ended it")
            self.assertEqual(drive.shown()[0], "switch on disabled")
            self.assertTrue(soon(lambda: drive.shown()[1] == 0, TTO))
            self.assertEqual(drive.shown()[2], 0)

    def test_an_output_that_nobody_reads_stops_the_motor(self):
        with Drive(self.wine) as drive:
            process = self.start(*LINE, "--json", "--allow-run", "--yes", "start", "--frequency", "40Hz")
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
            self.assertTrue(soon(drive.runs, 60), drive.shown())
            began = time.monotonic()
            process.stdout.close()
            self.assert_stopped_by_frame(drive, began)
            self.assertEqual(process.wait(LIMIT), PORT)


if __name__ == "__main__":
    unittest.main()
