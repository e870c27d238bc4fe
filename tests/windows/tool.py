# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The tool for Windows, in Wine, against a drive that the tool for Linux simulates at the other end of COM9: what a person
does with it, and that a motor is stopped by a frame whatever ends the program. RTUWIRE_EXE is rtuwire.exe, CONSOLE_PROGRAM
console_program.exe, TOOL the tool for Linux.

What Wine does not show: parity, a console whose text somebody marks, log-off and shutdown, and what a driver does when its
adapter is pulled.
"""
import fcntl
import json
import os
import pathlib
import select
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unittest
import xml.etree.ElementTree

from pymodbus.client import ModbusTcpClient

os.environ |= {"LINE_PROGRAM": "", "PORTS_PROGRAM": ""}  # of lines.py alone

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "programs"), str(HERE.parent / "interop")]

from frames import with_crc  # noqa: E402
from lines import THERE, Wine  # noqa: E402
from mbpoll import words_in  # noqa: E402
from pair import Programs, free_port, wait_for_listener  # noqa: E402
from simulator import Registers, Simulator, soon  # noqa: E402

PROGRAM, CONSOLE, TOOL = (os.environ[name] for name in ("RTUWIRE_EXE", "CONSOLE_PROGRAM", "TOOL"))
DONE, DIFFERS, USAGE, NO_ANSWER, PORT, REFUSED = range(6)
LIMIT = 120  # s, for what has to come
# A pseudo-terminal has no parity, and Wine says so.
LINE = ("-p", "COM9", "-f", "8N1", "-u", "7", "--no-listen")
TTO = 30  # s, before which the drive stops by itself


def mbpoll(number, *words):
    where = () if "127.0.0.1" in words else ("127.0.0.1",)
    return subprocess.run(["mbpoll", "-m", "tcp", "-p", str(number), "-a", "7", "-0", "-1", "-o", "5", *map(str, (*words, *where))],
                          check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout


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

    def in_console(self, event, *words):
        """In a console of its own: a line on its input is that event."""
        process = self.start(event, pathlib.Path(PROGRAM).resolve(), *words, program=CONSOLE, stdin=subprocess.PIPE)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    @staticmethod
    def end(process):
        """By that event."""
        output, errors = process.communicate(b"\n", timeout=LIMIT)
        return Ended(process.returncode, output, errors)

    def writes_log(self):
        log, = pathlib.Path(self.wine.folder.name).glob("drive_c/users/*/AppData/Local/rtuwire/writes.log")
        return log.read_text(encoding="utf-8")

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
        for command in ("read", "watch", "scan", "chaos", "check", "simulate", "monitor"):
            self.assertNotRegex(self.done(command, "--help").output, "/dev/|'DP|--from pty")
        self.assertIn("Example: rtuwire -p mbap://", self.done("simulate", "--help").output)
        self.assertIn("did you mean -p COM9?", self.done("read", "COM9", "RFR", status=USAGE).errors)

    def test_import_of_json_and_toml_and_words_for_yaml(self):
        (self.folder / "wb.json").write_text(json.dumps({
            "device_type": "meter", "device": {"name": "m", "channels": [
                {"name": "Voltage", "reg_type": "input", "address": 0, "type": "value", "format": "float"}]}}))
        (self.folder / "telegraf.toml").write_text(
            '[[inputs.modbus]]\nname = "m"\nslave_id = 1\nholding_registers = [\n'
            '  {name = "power", byte_order = "AB", data_type = "UINT16", scale = 1.0, address = [4]},\n]\n')
        (self.folder / "esphome.yaml").write_text("sensor:\n  - platform: modbus_controller\n")
        for source, name in (("wb.json", "Voltage"), ("telegraf.toml", "power")):
            made = self.done("device", "import", source).output
            self.assertIn(f'name = "{name}"', made)
            (self.folder / "made.toml").write_bytes(made.encode())
            self.done("device", "check", "made.toml")
        refused = self.done("device", "import", "esphome.yaml", status=USAGE).errors
        for word in ("YAML", "Home Assistant", "JSON", "TOML", "Linux"):
            self.assertIn(word, refused)

    # Without a wire

    def test_simulated_drives(self):
        found = self.done("--json", "-p", "sim:atv320:7", "scan")
        self.assertEqual([json.loads(line)["unit"] for line in found.output.splitlines()], [7])
        self.assertIn("Hz", self.done("-p", "sim:atv320:7,atv12:3", "-u", "7", "read", "RFR").output)
        for _ in range(8):
            self.assertIn("nOF", self.done("-p", "sim:atv320:7", "-u", "7", "read", "LFT").output)
        started = self.done("-p", "sim:atv320:7", "-u", "7", "--allow-run", "--yes", "start", "--frequency", "40Hz", "--for", "3s")
        self.assertIn("the motor stands", started.output + started.errors)
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

    def test_ports_names_com9(self):
        with Drive(self.wine) as drive:
            self.wine.link(9, drive.device)
            status, said = self.wine.run_with({THERE: {r"\Device\Serial9": "COM9"}}, f"{PROGRAM} ports")
            self.assertEqual(status, DONE, said)
            self.assertIn("COM9", " ".join(said).split())

    def test_backup_compare_and_restore(self):
        with Drive(self.wine) as drive:
            self.done(*LINE, "backup", "-o", "kept.json")
            text = (self.folder / "kept.json").read_bytes()
            self.assertNotIn(b"\r", text)
            self.assertIn("rtuwire backup 1", text.decode())
            self.done(*LINE, "compare", "kept.json")
            self.done(*LINE, "backup", "-o", "kept.json")
            self.assertEqual([each.name for each in self.folder.glob("kept*")], ["kept.json"])
            drive.simulator.suffer(f"7 write {drive.at.acc} 33")
            self.assertIn("ACC", self.done(*LINE, "compare", "kept.json", status=DIFFERS).output)
            for words, held in ((("--dry-run",), 3.3), ((), 0.5)):
                self.assertIn("ACC", self.done(*LINE, "--write", "restore", "kept.json", *words).output)
                self.assertEqual(json.loads(self.done(*LINE, "--json", "read", "ACC").output)["value"], held)
            self.done(*LINE, "compare", "kept.json")
            self.assertIn("\tCOM9\t7\tACC\t3.3 s\t0.5 s", self.writes_log())

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

    # What many take part in

    def test_it_listens_to_others_and_keeps_what_they_say(self):
        with Programs() as others:
            near, far = others.line()
            self.wine.link(9, os.path.realpath(near))
            sniffing = self.in_console("c", "-p", "COM9", "-f", "8N1", "--json", "sniff")
            # What was sent before it listens is gone: it is said until somebody hears it.
            is_heard = threading.Event()
            talking = threading.Thread(target=self.talk, args=(far, is_heard))
            talking.start()
            self.addCleanup(talking.join)
            self.addCleanup(is_heard.set)
            self.assertIn(b"07 03 0C 82 00 01", sniffing.stdout.readline() + sniffing.stdout.readline())
            self.end(sniffing)
            self.done("-p", "COM9", "-f", "8N1", "capture", "-o", "heard.pcapng", "--for", "2s")
            is_heard.set()
            talking.join()
        self.assertIn("07 03 0C 82 00 01", self.done("replay", "heard.pcapng").output)
        self.assertIn("0", self.done("timing", "heard.pcapng").output)

    @staticmethod
    def talk(device, is_heard):
        """A client and its unit, until they are heard."""
        with open(device, "wb", buffering=0) as line:
            while not is_heard.wait(0.05):
                line.write(with_crc(bytes.fromhex("07030C820001")))
                is_heard.wait(0.05)
                line.write(with_crc(bytes.fromhex("0703020190")))

    def test_many_clients_ask_through_serve_until_ctrl_c(self):
        with Drive(self.wine) as drive:
            drive.simulator.suffer("7 write 9001 21")
            number = free_port()
            served = self.in_console("c", *LINE[:4], "--no-listen", "serve", "--units", "7", "--listen", f"mbap://127.0.0.1:{number}",
                                     "--metrics", "127.0.0.1:0")
            wait_for_listener(number)
            self.assertEqual(words_in(mbpoll(number, "-r", 9001, "-c", 2)), {9001: 21, 9002: 5})
            first, second = (ModbusTcpClient("127.0.0.1", port=number, timeout=LIMIT) for _ in range(2))
            for client in (first, second, first):
                self.assertEqual(client.read_holding_registers(9001, 2, slave=7).registers, [21, 5])
            self.assertEqual(first.write_register(9001, 9, slave=7).exception_code, 1, "it only reads")
            first.close()
            second.close()
            ended = self.end(served)
            self.assertEqual(ended.status, DONE, ended)
            self.assertRegex(ended.output + ended.errors, r"http://127\.0\.0\.1:\d+/metrics listening")

    def test_serve_opens_the_port_anew_where_it_comes_back(self):
        number, said = free_port(), self.folder / "said.txt"
        with open(said, "wb") as output, Drive(self.wine):
            served = self.start(*LINE[:4], "--no-listen", "serve", "--units", "7", "--write", "--listen", f"mbap://127.0.0.1:{number}",
                                stdout=output, stderr=output)
            self.addCleanup(served.wait)
            self.addCleanup(served.kill)
            wait_for_listener(number)
            self.assertIn("Written 1", mbpoll(number, "-r", 9001, "127.0.0.1", 33))
            self.assertEqual(words_in(mbpoll(number, "-r", 9001)), {9001: 33})
        mbpoll(number, "-r", 9001)
        self.assertTrue(soon(lambda: b"the port has gone" in said.read_bytes(), LIMIT), said.read_text())
        with Drive(self.wine):
            self.assertTrue(soon(lambda: b"is open again" in said.read_bytes(), LIMIT), said.read_text())
            self.assertEqual(words_in(mbpoll(number, "-r", 9001)), {9001: 5})
        self.assertIn("\tCOM9\t7\tACC\t", self.writes_log())

    def test_chaos_loses_an_answer_between_a_client_over_tcp_and_com9(self):
        with Drive(self.wine):
            number = free_port()
            line = self.in_console("c", "-f", "8N1", "--json", "chaos", "--from", f"tcp://127.0.0.1:{number}", "--to", "COM9", "--faults",
                                   "lost@2", "-o", "chaos.pcapng")
            wait_for_listener(number)
            asked = [subprocess.run([TOOL, "-p", f"tcp://127.0.0.1:{number}", "-u", "7", "-d", "atv320", "--retries", "0", "read", "RFR"],
                                    check=False, stdout=subprocess.PIPE).returncode for _ in range(3)]
            self.assertEqual(asked.count(NO_ANSWER), 1, asked)
            ended = self.end(line)
            self.assertEqual(ended.status, DONE, ended)
            counts = {(row["of"], row["fault"]): row["frames"] for row in map(json.loads, ended.output.splitlines())}
            self.assertEqual(counts["answers", "lost"], 1, counts)
            self.assertTrue((self.folder / "chaos.pcapng").exists())
        self.assertIn("lost", self.done("chaos", "--faults", "lost@2", "--dry").output)
        self.assertIn("--from tcp://", self.done("chaos", "--faults", "lost@2", status=USAGE).errors)
        self.assertIn("--from COM3", self.done("chaos", "--faults", "lost@2", "--from", "pty", "--to", "COM9", status=PORT).errors)

    def test_check_holds_a_meter_against_the_clauses(self):
        with Simulator(TOOL, "sdm630:1") as device:
            self.wine.link(9, device)
            told = self.done("-p", "COM9", "-f", "8N1", "--no-listen", "-u", "1", "--json", "check", "--only", "L01,L35,F04,X,T", "--junit",
                             "check.xml")
        rows = {row["clause"]: row for row in map(json.loads, told.output.splitlines())}
        self.assertEqual([rows[each]["verdict"] for each in ("L01", "L35", "F04.1", "T02", "T03")],
                         ["holds", "holds", "holds", "does not apply", "holds"])
        self.assertNotRegex(rows["T01"]["why"], r"\.-")
        self.assertEqual(len(xml.etree.ElementTree.parse(self.folder / "check.xml").findall(".//testcase")), len(rows))
        self.assertIn("starts no client",
                      self.done("-p", f"tcp://127.0.0.1:{free_port()}", "check", "--client", "--", "x", status=USAGE).errors)
        self.assertIn("-p tcp://", self.done("check", "--client", status=PORT).errors)

    # What goes on

    def test_watch_goes_on_as_long_as_it_is_told(self):
        with Drive(self.wine) as drive:
            told = self.done(*LINE, "--csv", "watch", "RFR", "@monitor", "--every", "200ms", "--for", "2s")
            lines = told.output.splitlines()
            self.assertTrue(lines[0].startswith("time,seconds,RFR"), lines[0])
            self.assertGreater(len(lines), 3, told)
            watching = self.in_console("break", *LINE, "--json", "watch", "RFR")
            self.assertIn(b'"RFR":0.0', watching.stdout.readline())
            self.end(watching)
            self.assertEqual(drive.shown()[1], 0)

    def test_monitor_draws_on_a_console_and_ends_with_q(self):
        with Drive(self.wine) as drive:
            near, far = os.openpty()
            fcntl.ioctl(far, termios.TIOCSWINSZ, struct.pack("4H", 24, 100, 0, 0))
            process = self.start(*LINE, "monitor", stdin=far, stdout=far, stderr=far, start_new_session=True,
                                 preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
            os.close(far)
            shown, end = b"", time.monotonic() + LIMIT
            while b"atv320" not in shown and time.monotonic() < end and select.select([near], [], [], LIMIT)[0]:
                shown += os.read(near, 65536)
            self.assertIn(b"atv320", shown)
            os.write(near, b"q")
            while select.select([near], [], [], LIMIT)[0]:
                try:
                    shown += os.read(near, 65536)
                except OSError:
                    break  # it has ended
            os.close(near)
            self.assertEqual(process.wait(LIMIT), DONE)
            self.assertIn(b"\x1b[?1049l", shown)
            self.assertEqual(drive.shown()[1], 0)
        self.assertIn("no console", self.done("-p", "sim:atv320:7", "monitor", status=USAGE).errors)

    # Whatever ends it

    def running(self, drive, event, *words):
        """`start` in a console of its own, once the motor runs."""
        process = self.in_console(event, *LINE, "--allow-run", "--yes", "start", "--frequency", "40Hz", *words)
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
