# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs `rtuwire monitor` on terminals of this test, against simulated drives.

    python3 monitor.py TOOL screen|alarms|refused_state|keys|beside|reads|ways_out|refusals
"""
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import time

import meter_beside
from line_between import LineBetween
from meter_beside import METER_FILE, SharedLine
from pair import Programs
from screen import Screen
from support import LIMIT, Simulator, Units, runs

KEYS = "q quit  up/down unit  </> value  g plot  c changed  t times  p pause  "
SIM = "sim:atv320:7,atv12:3,atv28:4"
NAMES = ["--name", "fan=7:atv320", "--name", "pump=3", "--name", "mixer=4:atv28"]
DOWN, UP = "\x1bOB", "\x1bOA"  # as TERM says


def monitor(tool, port, *words):
    return [tool, "--port", port, "--no-listen", *words]


def keys_of(width):
    return KEYS + ("b bell  +/- period  ? help" if width >= 100 else "? help")


def check_whole(screen, check, width, height):
    """What every page has; pyte would wrap a line that is too long onto the next, so that the last is not the keys."""
    what = f"{width}x{height}"
    check(screen.until(lambda: screen.lines[-1] == keys_of(width)), f"{what}: the keys are the last line", screen.text)
    check(len(screen.lines) == height and all(len(each) <= width for each in screen.lines), f"{what}: it fits")
    curve = r" +▁" if width > 100 else r"$"
    for name, start in (("fan", "7 +atv320"), ("pump", "3 +atv12"), ("mixer", "4 +atv28")):
        is_there = screen.until_shown(rf"^ {name} +{start} +switch on disabled +0\.0 Hz{curve}")
        check(is_there, f"{what}: the {name}", screen.text)
    check("Its reads hold off the drives' own time-outs" in screen.text, f"{what}: what reads do", screen.text)


def screen(tool, check):
    with Screen(monitor(tool, SIM, *NAMES, "monitor", "--every", "100ms")) as page:
        check_whole(page, check, 80, 24)
        check(page.until_shown(r"^fan: unit 7, atv320, switch on disabled +\d+\.\d ms"), "the first is chosen")
        check(page.until_shown(r"^ RFR +Output frequency +0\.0 Hz +▁▁▁"), "a value and its curve", page.text)
        check(page.until_shown(r"^ ULN +Mains voltage from the DC bus +400\.0 V +▁▁▁"), "another", page.text)
        check(not page.until_shown("alarm", 0.2), "no alarm", page.text)
        page.resize(120, 40)
        check_whole(page, check, 120, 40)
        check(page.until_shown(r"ULN +Mains voltage from the DC bus +400\.0 V +▁{10}"), "longer curves", page.text)
        page.resize(60, 20)
        check(page.until_shown(r"^This terminal has 60x20 characters; monitor needs 80x24"), "too small", page.text)
        check("fan" not in page.text, "and nothing else", page.text)
        page.resize(80, 24)
        check_whole(page, check, 80, 24)
        page.type("q")
        check(page.end() == 0 and page.is_restored(), "q ends it, and the terminal is as it was", page.raw[-80:])
    words = monitor(tool, SIM, "-u", "3,7-7", "-d", "atv320", "monitor", "RFR", "ETA.fault", "3204")
    with Screen(words, LC_ALL="C") as page:
        check(page.until_shown(r"^ +7 +atv320 +switch on disabled +0\.0 Hz$"), "a list of units", page.text)
        check(page.until_shown(r"^ RFR .* __") and page.until_shown(r"^ ETA\.fault"), "registers that were asked for", page.text)
        check(page.text.isascii() and "ULN" not in page.text, "and no others; ASCII is enough", page.text)


def alarms(tool, check):
    drives = Simulator(tool, "atv320:7", "atv12:3", "atv28:4")
    with drives as device, Screen(monitor(tool, device, *NAMES, "monitor", "--every", "100ms")) as page:
        check_whole(page, check, 80, 24)
        drives.suffer("7 fault")
        check(page.until_shown(r"fault, OCF"), "the fault in words", page.text)
        check(page.until(lambda: page.is_red("fault, OCF")) and page.is_red(" fan "), "in red", page.text)
        check(page.until_shown(r"^fault: OCF: .*current"), "and whole", page.text)
        check(page.until_shown("1 alarm "), "is counted", page.lines[0])
        drives.suffer("3 cut")
        check(page.until_shown(r"^ pump +3 +atv12 +link lost, silent for \d+ s$"), "a unit is cut off", page.text)
        check(page.is_red("link lost") and not page.is_red("mixer"), "that one only", page.text)
        before = page.text
        check(page.until_shown(r"silent for 2 s"), "it counts", before)
        drives.suffer("4 local")
        check(page.until_shown(r"^ mixer +4 +atv28 +.*, local"), "local control", page.text)
        check(page.until(lambda: page.is_red(", local")) and page.until_shown("3 alarms"), "in red", page.text)
        drives.suffer("3 join")
        check(page.until_shown(r"^ pump +3 +atv12 +switch on disabled", 10), "it is back", page.text)
        drives.suffer("4 remote")
        check(page.until_shown("1 alarm "), "one alarm is left", page.text)


def refused_state(tool, check):
    eta, lft = 3201, 7121
    words = {3202: 400, 3204: 10, lft: 0, eta: 0x0637}
    with Units({7: words}) as line:
        with Screen(monitor(tool, line.name, "--name", "fan=7:atv320", "monitor", "RFR", "--every", "100ms")) as page:
            check(page.until_shown(r"^ fan +7 +atv320 +operation enabled"), "it runs", page.text)
            del words[eta]
            check(page.until_shown(r"^ fan +7 +atv320 +state unknown: illegal data"), "defect: D24 its state is refused", page.text)
            check("operation enabled" not in page.text and page.is_red("state unknown"), "what it said before is gone", page.text)
            check(page.until_shown(r"^its state is not known: it answers a read of ETA with: illegal data address"), "and why", page.text)
            words[eta] = 0x0250
            check(page.until_shown(r"^ fan +7 +atv320 +switch on disabled +40\.0 Hz"), "it tells it again", page.text)
            check("unknown" not in page.text, "and nothing is left", page.text)


def keys(tool, check):
    drives = Simulator(tool, "atv320:7")
    silent = ["--name", "ghost=9:atv12", "--name", "fan=7", "--name", "spirit=10:atv12"]
    with drives as device, Screen(monitor(tool, device, *silent, "--timeout", "2", "monitor", "RFR")) as page:
        check(page.until_shown(r"^ fan +7 +atv320 +switch on disabled", 30), "a silent unit delays no other for good")
        check(page.until_shown(r"^ghost: unit 9"), "the first is chosen", page.text)
        page.type(DOWN)
        check(page.until_shown(r"^fan: unit 7"), "down", page.text)
        page.type(UP + UP)
        check(page.until_shown(r"^ghost: unit 9"), "up, and there it ends", page.text)
        page.type("+")
        check(page.until_shown("every 1 s"), "+", page.lines[0])
        page.type("--")
        check(page.until_shown(r"every 0\.2 s"), "-", page.lines[0])
        times = []
        for i in range(9):
            began = time.monotonic()
            page.type("?")
            check(page.until(lambda: ("It writes nothing" in page.text) == (i % 2 == 0)), "the help comes and goes")
            times.append(time.monotonic() - began)
        # Keys that wait for a silent unit would take a second, half of its time-out.
        check(statistics.median(times) < 0.6, "busy? Keys do not wait for units that are silent", times)
        page.type("?p")
        check(page.until_shown("PAUSED"), "p", page.lines[0])
        page.type("q")
        check(page.end() == 0 and page.is_restored(), "q", page.raw[-80:])


def has_dots(page):
    return any(0x2801 <= ord(each) <= 0x28FF for each in page.text)


def beside(tool, check):
    """A drive beside a meter of pymodbus with a register file: plots, alarms, times, and what has changed."""
    with tempfile.TemporaryDirectory(prefix="beside-") as folder, Programs() as others, Simulator(tool, "atv320:7") as drive:
        (file := pathlib.Path(folder, "meter.toml")).write_text(METER_FILE)
        far, near = others.line()
        others.serve(far, [sys.executable, "-B", meter_beside.__file__, "--serve", "@"], stderr=subprocess.DEVNULL)
        with SharedLine(drive, near) as line:
            words = monitor(tool, line.name, "--name", "fan=7:atv320", "--name", f"meter=61:{file}", "monitor", "--every", "100ms")
            with Screen([*words, "--plot", "voltage", "--alarm", "ULN@fan=..390V", "--alarm", "power=1000..2000W"]) as page:
                check(page.until_shown(r"^ meter +61 +responds +\d+\.\d+ V$"), "a device by its register file", page.text)
                check(page.until_shown(r"^ fan +7 +atv320 +switch on disabled, ULN above 390 V"), "a value outside", page.text)
                check(page.until_shown(r"^ULN is 400\.0 V: above 390 V$") and page.is_red("above 390 V"), "is an alarm, red", page.text)
                check(page.until(lambda: page.is_red("400.0 V")) and page.until_shown("1 alarm "), "and counted", page.text)
                check(b"\x07" not in page.raw, "without a bell")
                check(page.until_shown(r"^ voltage@meter +\d+\.\d+ V .*the last \d+ s$"), "a plot that was asked for", page.text)
                check(page.until(lambda: has_dots(page)), "in dots of braille", page.text)
                page.type(DOWN)
                check(page.until_shown(r"^meter: unit 61, no drive .*\d+\.\d ms, longest \d+\.\d; 0 of \d+ failed$"),
                      "its response times", page.text)
                check(page.until_shown(r"^ energy +1000\.\d+ kWh"), "all of its registers", page.text)
                page.type(">>")
                check(page.until_shown(r"^>power "), "> chooses a value", page.text)
                page.type("g")
                check(page.until_shown(r"^ power@meter ") and page.until_shown(r"^>power +~"), "g plots it", page.text)
                page.type("g")
                check(page.until(lambda: "power@meter" not in page.text), "and ends that", page.text)
                page.type("t")
                check(page.until_shown(r"^ meter +61 +(\d+\.\d +){3}\d+ +0 +0 +0$"), "t shows times and errors", page.text)
                page.type("tc")
                check(page.until_shown(r"^ voltage@meter +\d+\.\d+ V ") and page.until(lambda: "nothing" not in page.text and " energy " not in page.text),
                      "c shows what has changed", page.text)
                page.type("p")
                check(page.until_shown("PAUSED"), "paused", page.text)
                page.type("q")
                check(page.end() == 0 and page.is_restored(), "q", page.raw[-80:])
            with Screen([*words, "--bell", "--alarm", "ULN=..390V"], LC_ALL="C") as page:
                check(page.until(lambda: b"\x07" in page.raw), "--bell rings it")
                page.type("g")
                check(page.until_shown(r"^ RFR@fan ") and page.text.isascii(), "a plot in ASCII", page.text)
            for words_of, parts in ((["--alarm", "ULN=390"], ["ULN=390", "LCR=2..8.5A"]), (["--alarm", "ULN=1,5..2"], ["'1,5'"]),
                                    (["--alarm", "ULN=nan.."], ["'nan'"]), (["--alarm", "ULN=3..2"], ["above"]),
                                    (["--alarm", "ULNX=3..4"], ["ULNX"]), (["--alarm", "ULN@pump=3..4"], ["'pump'"]),
                                    (["--alarm", "ULN=1V..2A"], ["V", "A"]), (["--plot", "voltag"], ["voltag", "voltage"])):
                refused([*words, *words_of], check, words_of[1], *parts)
            with Screen([*words, "--alarm", "ULN=..390A", "--alarm", "LFT=0..1"]) as page:
                check(page.until_shown("its limit is in A, and it is in V") and page.until_shown("LFT.*no number"),
                      "limits that say nothing are alarms", page.text)


def reads(tool, check):
    with Units({7: {100: 5, 611: 6}}, ignored=(43,)) as line:
        with Screen(monitor(tool, line.name, "-u", "7", "--timeout", "0.2", "monitor", "100", "611")) as page:
            check(page.until_shown(r"^ 100 .*5 \(0x0005\)") and page.until_shown("0x0263"), "a number of a menu that it may not have", page.text)
            check("6 (0x0006)" not in page.text, "is not guessed", page.text)
    with Simulator(tool, "atv320:7", "atv12:3") as device, LineBetween(device) as line:
        with Screen(monitor(tool, line.name, "-u", "3,7", "monitor", "--every", "100ms")) as page:
            check(page.until_shown(r"^ +7 +atv320 +switch on disabled"), "they are recognised", page.text)
            page.take(1.0)
            page.type("p")
            check(page.until_shown("PAUSED"), "it pauses", page.lines[0])
            page.take(0.3)
            before = len(line.heard)
            page.take(0.5)
            check(len(line.heard) == before, "and asks nothing then")
            page.type("p")
            check(page.until(lambda: len(line.heard) > before), "until it goes on")
        try:
            found = line.functions()
            check(len(found) > 20 and set(found) <= {3, 43}, "nothing but reads was sent", set(found))
        except KeyError as why:
            check(False, "nothing but reads was sent", why)


def ends_by(tool, device, check, what, end, status):
    words = monitor(tool, device, "--name", "fan=7:atv320", "--name", "ghost=9:atv12", "monitor")
    with Screen(words) as page:
        page.until_shown(r"^ fan +7 +atv320 +switch on disabled")
        end(page)
        found = page.end()
        check(found == status, f"{what}: the status", found)
        check(page.is_restored(), f"{what}: the terminal is as it was", page.raw[-120:])
        return page.raw.decode(errors="replace")


def ways_out(tool, check):
    drives = Simulator(tool, "atv320:7")
    with drives as device:
        ends_by(tool, device, check, "q", lambda page: page.type("q"), 0)
        for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            ends_by(tool, device, check, each.name, lambda page: page.process.send_signal(each), 128 + each)
        ends_by(tool, device, check, "Ctrl-C", lambda page: page.type("\x03"), 128 + signal.SIGINT)
        ends_by(tool, device, check, "Ctrl-\\ does nothing, q ends", lambda page: page.type("\x1cq"), 0)
        ends_by(tool, device, check, "Ctrl-C twice", lambda page: page.type("\x03\x03"), 128 + signal.SIGINT)
        with Screen(monitor(tool, device, "-u", "7", "monitor")) as page:
            page.until_shown(r"^ +7 +atv320 +switch on disabled")
            page.close()
            check(page.process.wait(timeout=LIMIT) == 128 + signal.SIGHUP, "its terminal is closed: it ends")
        drawn = ends_by(tool, device, check, "the port vanishes", lambda page: drives.process.kill(), 4)
        said = drawn.rpartition("\x1b[?1049l")[2]
        check(f"rtuwire: {device}" in said, "it says which port", said)


def refused(words, check, what, *sentences, **environment):
    """Refused with a sentence; nothing is drawn."""
    with Screen(words, **environment) as page:
        status = page.end()
        check(status == 2 and b"\x1b" not in page.raw, f"{what}: status 2, nothing is drawn", (status, page.raw))
        said = " ".join(page.raw.decode().split())
        check(all(each in said for each in sentences), f"{what}: a sentence", said)


def refusals(tool, check):
    piped = subprocess.run([tool, "monitor"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    check(piped.returncode == 2 and piped.stdout == "" and "watch" in piped.stderr, "no terminal", piped)
    piped = subprocess.run([tool, "--port", "sim:atv320:7", "monitor", "7", "3", "2"], stdin=subprocess.DEVNULL, capture_output=True,
                           text=True, check=False)
    check(piped.returncode == 2 and "-u 7,3,2 monitor` shows the units" in piped.stderr, "units in place of registers", piped)
    words = monitor(tool, "sim:atv320:7", "-u", "7", "monitor")
    refused(words, check, "an unknown TERM", "TERM is 'no-such'", "watch", TERM="no-such")
    refused(words, check, "an empty TERM", "TERM is ''", TERM="")
    refused(words, check, "a TERM without a screen", "TERM is 'dumb'", TERM="dumb")
    refused([*words, "RFX"], check, "a register of no drive", "RFX")
    refused([*words, "--json"], check, "--json", "watch")
    refused(monitor(tool, "sim:atv320:7", "-u", "7,fun", "--name", "fan=7", "monitor"), check, "no unit", "'fun'", "fan")
    refused(monitor(tool, "sim:atv320:7", "-u", "7,300", "monitor"), check, "no address", "300")
    refused(monitor(tool, "sim:atv320:7", "--name", "fan=7:atv321", "monitor"), check, "no drive", "atv321", "atv320")
    refused([tool, "monitor"], check, "no port", "--port")
    with Screen(monitor(tool, "/dev/no-such-port", "monitor")) as page:
        check(page.end() == 4 and b"\x1b" not in page.raw, "no such port: status 4", page.raw)


PARTS = {each.__name__: each for each in (screen, alarms, refused_state, keys, beside, reads, ways_out, refusals)}


def main(check, tool, part):
    PARTS[part](os.path.abspath(tool), check)


runs(main)
