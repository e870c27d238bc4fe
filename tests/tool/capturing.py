# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A capture that joins in the middle and is ended in the middle is a whole file; and the line as an interface of
Wireshark, with the program itself behind it, for a user without privileges.

    python3 capturing.py TOOL EXTCAP
"""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

from line_between import LineBetween
from support import DONE, LIMIT, Simulator, Tool, crc, runs, soon, with_crc

UDP = ["-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE"]
# To be asked to end is how a capture ends.
STATUS = {signal.SIGINT: DONE, signal.SIGTERM: DONE, signal.SIGHUP: DONE, signal.SIGKILL: -signal.SIGKILL}


def shown_by_tshark(file):
    """Function, CRC, comment and payload of each packet; fails where the file is not whole."""
    return subprocess.run(["tshark", "-n", "-r", file, *UDP, "-T", "fields", "-e", "modbus.func_code", "-e", "frame.comment",
                           "-e", "udp.payload"], capture_output=True, text=True, check=False)


def is_whole(data):
    """Whether these are whole blocks of pcapng, one after the other."""
    at = 0
    while at < len(data):
        size = int.from_bytes(data[at + 4:at + 8], "little")
        if size < 12 or at + size > len(data) or data[at + size - 4:at + size] != data[at + 4:at + 8]:
            return False
        at += size
    return at > 0


def ended_in_the_middle(tool, line, check):
    for number, status in STATUS.items():
        file = tool.place / f"ended{number}.pcapng"
        client = tool.start("--no-listen", "-u", 7, "-d", "atv320", "watch", "RFR", "LCR", "--every", "5ms", port=line.name)
        client.stdout.readline()
        process = tool.start("capture", "-o", file, port=line.tap_name)
        # The head of the file is there when it listens; it joins in the middle of a response.
        check(soon(lambda: file.exists() and file.stat().st_size > 0), "the file begins")
        line.say_to_tap(with_crc(bytes.fromhex("070304001200340056"))[5:])
        line.is_tapped = True
        check(soon(lambda: file.stat().st_size > 6_000), "and grows while the line talks")
        line.say_to_tap(bytes.fromhex("07030C"))  # a frame has begun
        process.send_signal(number)
        process.communicate(timeout=LIMIT)
        line.is_tapped = False
        client.kill()
        client.communicate()
        name = signal.Signals(number).name
        check(process.returncode == status, f"{name}: status", process.returncode)
        check(is_whole(file.read_bytes()), f"{name}: the file consists of whole blocks")
        shown = shown_by_tshark(file)
        rows = [row.split("\t") for row in shown.stdout.splitlines()]
        good = [row for row in rows if not row[1]]
        check(shown.returncode == 0 and "cut short" not in shown.stderr, f"{name}: tshark reads it to its end", shown.stderr)
        check(len(good) > 20 and all(row[0] and crc(bytes.fromhex(row[2])) == 0 for row in good),
              f"{name}: each frame is classified and right", good[:3])
        check(rows[0][1] in ("damaged", "stray") or rows[0][0] == "", f"{name}: what was joined in the middle is told", rows[:2])
        replay = tool.run("--json", "replay", file)
        check(replay.status == DONE and not replay.errors, f"{name}: it is replayed to its end", replay.errors)


def as_interface(tool, line, extcap, check):
    """Wireshark takes the folder of extcap programs from nobody who is root."""
    with tempfile.TemporaryDirectory(prefix="extcap-") as place:
        folder = pathlib.Path(place, "extcap")
        folder.mkdir()
        shutil.copy(extcap, folder)
        program = pathlib.Path(shutil.copy(tool.program, pathlib.Path(place, "rtuwire")))
        user = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.getuid() == 0 else []
        for path in (pathlib.Path(place), folder, *folder.iterdir(), program, pathlib.Path(line.tap_name)):
            os.chmod(path, 0o777)
        environment = {**os.environ, "HOME": place, "WIRESHARK_EXTCAP_DIR": str(folder), "RTUWIRE": str(program),
                       "LC_ALL": "C.UTF-8"}
        listed = subprocess.run([*user, "tshark", "-D"], env=environment, capture_output=True, text=True, check=False)
        check("Modbus RTU line" in listed.stdout, "the line is among the interfaces", listed)
        client = tool.start("--no-listen", "-u", 7, "-d", "atv320", "watch", "RFR", "LCR", "--every", "20ms", port=line.name)
        client.stdout.readline()
        line.is_tapped = True
        words = ["-n", "-i", "rtuwire", "-o", f"extcap.rtuwire.port:{line.tap_name}", "-c", "40"]
        shown = subprocess.run([*user, "tshark", *words, *UDP, "-T", "fields", "-e", "modbus.func_code", "-e",
                                "modbus.response_time", "-e", "frame.comment"], env=environment, capture_output=True,
                               text=True, check=False, timeout=LIMIT)
        rows = [row.split("\t") for row in shown.stdout.splitlines()]
        good = [row for row in rows if not row[2]]
        check(len(rows) == 40 and len(good) > 30 and all(row[0] == "3" for row in good), "tshark shows the line live",
              (rows[:4], shown.stderr))
        check(sum(bool(row[1]) for row in good) > 10, "and pairs what it shows", good[:4])
        file = pathlib.Path(place, "live.pcapng")
        kept = subprocess.run([*user, "tshark", "-q", *words, "-w", str(file)], env=environment, capture_output=True,
                              text=True, check=False, timeout=LIMIT)
        replay = tool.run("--json", "replay", file)
        found = [each for each in replay.objects() if each["role"] != "silence"]
        check(replay.status == DONE and len(found) == 40, "what Wireshark keeps of it is replayed", (kept, replay.errors))
        client.kill()
        client.communicate()
        check(soon(lambda: not running(program)), "the program ends with tshark", running(program))


def running(program):
    found = []
    for place in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if place.read_bytes().startswith(str(program).encode() + b"\0"):
                found.append(place)
        except OSError:
            pass  # has just ended
    return found


def main(check, program, extcap):
    with Simulator(program, "atv320:7") as device, Tool(program) as tool:
        with LineBetween(device) as line:
            ended_in_the_middle(tool, line, check)
        with LineBetween(device) as line:
            as_interface(tool, line, extcap, check)


runs(main)
