# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The bit rate and the format of a line are found: by asking, and by listening to who talks.

    python3 finding.py TOOL asking    by asking
    python3 finding.py TOOL words     where it is said, by listening, and what is refused
"""
import os
import re
import shlex
import struct
import time

from support import DIFFERS, DONE, NO_ANSWER, REFUSED, USAGE, Ended, Line, Tool, runs, soon, with_crc
from uart import SetUnits, Talk, levels_of, sampled

QUIET = ["--no-listen", "--json"]
READS = {1, 2, 3, 4, 43}
SHOWN = re.compile(r"`([^`\n]* [^`\n]*)`")


def inputs_of(first, values, order):
    """Floats as two registers each."""
    words = {}
    for i, value in enumerate(values):
        halves = struct.unpack(">HH", struct.pack(">f", value))
        for j, half in enumerate(halves if order == "abcd" else halves[::-1]):
            words[first + 2 * i + j] = half
    return words


def told_seconds(text):
    told = re.search(r"at most (?:(\d+) min )?(\d+) s", text)
    return int(told[1] or 0) * 60 + int(told[2]) if told else None


def shown(tool, text, *more):
    """The first command that a text shows, run with more words."""
    words = shlex.split(SHOWN.findall(text)[0])
    return tool.run(*words[1:], *more)


def check_stand_in(check):
    """What the others rest on: a UART hears its own setting and either count of stop bits; another parity is damage, another
    rate another number of bytes."""
    frame = with_crc(bytes([61, 3, 12, 129, 0, 1]))

    def heard(sender, receiver):
        return sampled(levels_of(frame, *sender), *receiver)

    right = [(byte, False) for byte in frame]
    for rate in (1200, 9600, 115200):
        for form in ("8E1", "8O1", "8N1", "8N2"):
            check(heard((rate, form), (rate, form)) == right, f"{rate} {form}")
        check(heard((rate, "8N2"), (rate, "8N1")) == heard((rate, "8N1"), (rate, "8N2")) == right, f"{rate}: stop bits")
        for one, other in (("8E1", "8O1"), ("8E1", "8N2"), ("8N2", "8E1"), ("8N1", "8O1")):
            check(any(bad for _, bad in heard((rate, one), (rate, other))), f"{rate}: {one} is damage at {other}")
    check(len(heard((38400, "8N2"), (9600, "8N2"))) < 5 < 11 < len(heard((9600, "8N2"), (38400, "8N2"))), "another rate")


def check_find(tool, check):
    """A unit of which nobody knows anything: 38 400 bit/s, 8N2, function 04 only."""
    voltage = inputs_of(1000, [230.1, 1.5], "cdab")
    with SetUnits({61: None}, 38400, "8N2", voltage) as line:
        ended = tool.run("--port", line.name, *QUIET, "scan", "--units", "60-64")
        took, told = line.least_seconds(), told_seconds(ended.errors)
        rows = ended.objects()
        check(ended.status == DONE and [(row["unit"], row["baud"], row["format"]) for row in rows] == [(61, 38400, "8N2")],
              "it is found", ended)
        check(told and took < told, "sooner than what was told before it began", (took, told))
        check(line.settings[:2] == [(19200, "8E1"), (9600, "8N2")] and line.settings[-1] == (38400, "8N2"),
              "the usual settings first, and none behind the right one", line.settings)
        check({request[1] for request in line.requests} <= READS, "it only reads", line.requests)
        check({request[0] for request in line.requests} == {60, 61, 62, 63, 64}, "all addresses are asked at the setting that is found")
        check("baud = 38400" in ended.errors and "8N1 as well" in ended.errors, "it says how to set it", ended.errors)
        found = shown(tool, ended.errors, "input:990-1010")
        check(found.status == DONE and re.search(r"61 +input +1000 +1003 +4", found.output), "the command behind it maps it", found)
        forms = shown(tool, found.errors)
        check(forms.status == DONE and re.search(r"input:1000:f32:cdab +1000 +230.1", forms.output),
              "and the one behind that shows a value", forms)
    with SetUnits({2: {3201: 0}, 50: {3201: 0}}, 2400, "8E1") as line:
        ended = tool.run("--port", line.name, *QUIET, "scan", "--find", "--units", "1-3,50")
        check([(row["unit"], row["baud"], row["format"]) for row in ended.objects()] == [(2, 2400, "8E1"), (50, 2400, "8E1")],
              "all units of the line", ended)
        check(line.settings.count((19200, "8E1")) == 1, "the lowest addresses go first, at each setting", line.settings)


def check_slow(tool, check):
    """Who answers when others are asked already is asked again."""
    with SetUnits({61: {3201: 0}}, 19200, "8N2", takes=0.2) as line:
        ended = tool.run("--port", line.name, *QUIET, "scan", "--units", "50-80")
        check([(row["unit"], row["baud"], row["format"]) for row in ended.objects()] == [(61, 19200, "8N2")], "late: found", ended)
        check("no response" not in ended.output, "and who it is was asked with patience", ended.output)
    with SetUnits({61: {3201: 0}}, 9600, "8E1", checks_parity=False) as line:
        ended = tool.run("--port", line.name, *QUIET, "scan", "--units", "60-62")
        check([(row["unit"], row["baud"], row["format"]) for row in ended.objects()] == [(61, 9600, "8E1")],
              "an answer of another parity leads to the right one", ended)
        check(line.settings[:3] == [(19200, "8E1"), (9600, "8N2"), (9600, "8E1")], "at once", line.settings)


def check_nobody(tool, check):
    with SetUnits({}, 9600, "8N2") as line:
        ended = tool.run("--port", line.name, *QUIET, "scan", "--units", "9,11")
        took, told = line.least_seconds(), told_seconds(ended.errors)
        check(ended.status == NO_ANSWER and not ended.output and "nobody answered: 2 addresses" in ended.errors, "status 3", ended)
        check(told and told / 2 < took < told, "not longer than was told", (took, told))
        check(len(set(line.settings)) == 24 and line.unheard == 46 and len(line.requests) == 2,
              "each address once at each setting; a unit hears those of its own", (line.settings, line.unheard))
    with Line() as line:
        # Noise that is nobody's answer does not hold it up for good.
        ended = noisy(tool, line)
        check(ended.status == NO_ANSWER and "something was heard" in ended.errors, "noise is told", ended)


def check_begun(tool, check):
    """A client that begins while it asks is left alone."""
    with Line() as line:
        process = tool.start("--port", line.name, "--listen", "0.1", "scan", "--find", "--units", "11")
        soon(lambda: line.heard)
        while process.poll() is None:
            line.say(with_crc(bytes.fromhex("11030006")))
            time.sleep(0.05)
        _, errors = process.communicate()
        check(process.returncode == REFUSED and "somebody is talking" in errors, "a client that begins later is told", errors)


def noisy(tool, line):
    process = tool.start("--port", line.name, *QUIET, "scan", "--find", "--units", "11")
    while process.poll() is None:
        line.say(b"\x80")
        time.sleep(0.3)
    output, errors = process.communicate()
    return Ended(process.returncode, output, errors)


def check_words(tool, check):
    """Where the setting is said nothing else is tried; --find tries all the same; a port without a bit rate has none to find."""
    (tool.place / "set.toml").write_text("baud = 9600\n", encoding="utf-8")
    for words, how in ((["-b", "9600"], (9600, "8E1")), (["-f", "8N2"], (19200, "8N2")), (["--config", "set.toml"], (9600, "8E1"))):
        with SetUnits({}, 1200, "8N2") as line:
            ended = tool.run("--port", line.name, *QUIET, *words, "scan", "--units", "5-6")
            check(ended.status == NO_ANSWER and line.settings == [how], f"{words}: one setting", line.settings)
            check("scan --find --units 5-6`" in ended.errors, f"{words}: what tries the others", ended.errors)
    with SetUnits({5: {3201: 0}}, 9600, "8N2") as line:
        ended = tool.run("--port", line.name, *QUIET, "--config", "set.toml", "scan", "--find", "--units", "5")
        check([row["format"] for row in ended.objects()] == ["8N2"], "--find goes before the file", ended)
    for port in ("sim:atv320:7", "tcp://127.0.0.1:9"):
        for command in ("scan", "sniff"):
            ended = tool.run("--port", port, "--no-listen", command, "--find")
            check(ended.status == USAGE and "bit rate" in ended.errors, f"{command} --find {port}", ended)
    ended = tool.run("--port", "/dev/null", "scan", "--find", "--bauds", "9600")
    check(ended.status == USAGE and "--bauds" in ended.errors, "--find with --bauds", ended)
    with SetUnits({61: {3201: 0}}, 9600, "8N2") as line:
        words = ["--port", line.name, *QUIET, "scan", "--units", "60-62", "--resume", "found"]
        first = tool.run(*words)
        asked = len(line.heard)
        again = tool.run(*words)
        check(first.status == again.status == DONE and again.output == first.output and len(line.heard) == asked,
              "--resume: what was found is not asked for again", again)


def check_heard(tool, check):
    """Found without a word."""
    for rate, form in ((19200, "8E1"), (9600, "8N2"), (57600, "8E1"), (9600, "8O1"), (2400, "8N2")):
        with Talk(rate, form) as line:
            ended = tool.run("--port", line.name, "--json", "sniff", "--find")
            rows = ended.objects()
            check(ended.status == DONE and [(row["baud"], row["format"], row["units"]) for row in rows] == [(rate, form, "17")],
                  f"{rate} {form}: heard", ended)
            check(not line.heard, "without a word", line.heard)
            check(f"-b {rate} -f {form} sniff" in ended.errors, "the command behind it", ended.errors)
            ended = shown(tool, ended.errors, "--for", "0.5s") if rate == 9600 and form == "8N2" else None
            check(ended is None or "17" in ended.output, "shows what is said", ended)
    with Talk(38400, "8N2") as line:
        ended = tool.run("--port", line.name, "scan", "--units", "1")
        check("sniff --find" in ended.errors and not line.heard, "a scan of a line in use names it", ended)
    with Line() as line:
        ended = tool.run("--port", line.name, "sniff", "--find", "--for", "0.5s")
        check(ended.status == NO_ANSWER and "nobody talks" in ended.errors and "scan --find`" in ended.errors and not line.heard,
              "a silent line", ended)
        process = tool.start("--port", line.name, "sniff", "--find", "--for", "0.3s")
        while process.poll() is None:
            line.say(os.urandom(16))
            time.sleep(0.06)
        _, errors = process.communicate()
        check(process.returncode == DIFFERS and "none of the usual" in errors and not line.heard, "what is no Modbus", errors)


PARTS = {"asking": (check_find, check_slow, check_nobody), "words": (check_begun, check_words, check_heard)}


def main(check, program, part):
    check_stand_in(check)
    with Tool(program) as tool:
        for each in PARTS[part]:
            each(tool, check)


runs(main)
