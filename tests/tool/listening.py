# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""sniff, capture, replay and timing on a line on which another program reads simulated drives; and who speaks there.

    python3 listening.py TOOL
"""
import json
import re
import signal
import subprocess

from line_between import LineBetween
from support import DONE, LIMIT, NO_ANSWER, PORT, REFUSED, USAGE, Simulator, Tool, runs

NAMES = ("--name", "fan=7:atv320", "--name", "pump=3:atv12")


def traffic(tool, line, rounds=7, unit=7):
    """Another client reads, however long that takes."""
    process = tool.start("--no-listen", "-u", unit, "--json", *NAMES, "watch", "RFR", "LCR", "ACC", "--every", "0.1s",
                         port=line.name)
    for _ in range(rounds):
        process.stdout.readline()
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=LIMIT)


def listen(tool, line, *words):
    process = tool.start(*words, port=line.tap_name)
    line.listen_to(process)
    return process


def ended(process, line):
    """It is ended when it has read all that was said."""
    line.wait_until_read()
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=LIMIT)
    return process.returncode, output, errors


def sniffs(tool, line, check):
    process = listen(tool, line, "--json", *NAMES, "sniff", "--for", f"{LIMIT}s")
    traffic(tool, line)
    line.say_to_tap(bytes.fromhex("07030C820001"))  # cut off: no CRC
    tool.run("--no-listen", "-u", 9, "--timeout", "0.1", "--retries", "0", "read", "3202", port=line.name)
    seen = []
    for each in process.stdout:
        seen.append(json.loads(each))
        if seen[-1]["verdict"] == "unanswered" and seen[-1]["unit"] == 9:
            break
    status, _, _ = ended(process, line)
    good = [each for each in seen if each["verdict"] == "good" and each["unit"] == 7]
    check(status == DONE, "sniff ends well", status)
    check([each["role"] for each in good] == ["request", "response"] * (len(good) // 2) and len(good) >= 20,
          "requests and responses take turns", [each["role"] for each in good])
    texts = {each["text"] for each in good}
    check("read RFR, 3 registers" in texts and "read ACC" in texts, "requests are named", texts)
    check("RFR 0.0 Hz, FRH 0.0 Hz, LCR 0.0 A" in texts, "values have their units", texts)
    check(any(each["verdict"] == "unanswered" and each["unit"] == 9 and "no response to: read" in each["text"] for each in seen),
          "a request without a response is told", seen[-3:])
    check(any(each["verdict"] == "damaged" for each in seen), "damaged bytes are told", seen)
    # On a busy machine some take longer.
    times = [each["ms"] for each in good if each["role"] == "response"]
    check(min(times) < 20, "busy? Response times are those of a drive that answers at once", times)


def captures(tool, line, check):
    file = tool.place / "line.pcapng"
    process = listen(tool, line, "capture", "-o", file)
    traffic(tool, line, unit=3)
    status, output, errors = ended(process, line)
    check(status == DONE and not output and "frames" in errors, "capture ends well, and counts", errors)
    first, second = (tool.run("--json", *NAMES, "replay", file) for _ in range(2))
    check(first.output == second.output and first.status == DONE, "a replay says the same each time", first)
    seen = first.objects()
    good = [each for each in seen if each["verdict"] == "good"]
    check(len(good) == len(seen) and len(good) >= 20, "a replay pairs all", seen[:4])
    check(any("RFR 0.0 Hz" in each["text"] for each in good), "a replay names values", good[:4])
    again = tool.place / "again.pcapng"
    again.write_bytes(file.read_bytes()[:-7])
    cut = tool.run("replay", again)
    check(cut.status == PORT and re.search(r"at byte \d+", cut.errors), "a file that was cut short is told with its place", cut)
    shown = subprocess.run(["tshark", "-r", file, "-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE", "-T",
                            "fields", "-e", "modbus.func_code", "-e", "_ws.col.Info"], capture_output=True, text=True)
    rows = shown.stdout.splitlines()
    check(len(rows) == len(good) and all(row.split("\t")[0] and "Unable" not in row for row in rows),
          "Wireshark classifies every frame", rows[:4])
    figures = tool.run("--json", "timing", file).objects()
    check(figures[0]["frames"] == len(good) and figures[1]["unit"] == 3
          and figures[1]["requests"] == figures[1]["answered"] == len(good) // 2,
          "timing counts what passed", figures)
    people = tool.run("timing", file)
    check("below 1 " in people.output and "#" in people.output, "timing shows people how long responses took", people)


def decides_again(tool, line, check):
    """What a capture is heard as is what its line was heard as."""
    file = tool.place / "same.pcapng"
    sniffer = listen(tool, line, "--json", *NAMES, "sniff")
    traffic(tool, line)
    live = [json.loads(each) for each in ended(sniffer, line)[1].splitlines()]
    capture = listen(tool, line, "capture", "-o", file)
    traffic(tool, line)
    ended(capture, line)
    played = tool.run("--json", *NAMES, "replay", file).objects()
    same = [(each["role"], each["unit"], each["verdict"], each["text"], each["bytes"]) for each in played]
    kinds = {(each["role"], each["unit"], each["verdict"], each["text"], each["bytes"]) for each in live}
    check(same and set(same) == kinds, "the frames of the line and of its capture are told alike", set(same) ^ kinds)


def refuses_to_speak(tool, line, check):
    speaking = tool.start("--csv", "--no-listen", "-u", 7, *NAMES, "watch", "RFR", "--every", "0.1s", port=line.name)
    speaking.stdout.readline()
    line.is_tapped = True
    for command in (("scan",), ("-u", "7", "read", "3202")):
        found = tool.run(*command, port=line.tap_name)
        check(found.status == REFUSED and "frames of a client and of unit 7" in found.errors and "--no-listen" in found.errors,
              f"{command[-1]} refuses a line in use and says who talks", found)
    speaking.kill()
    speaking.communicate()


def silence(tool, line, check):
    found = tool.run("sniff", "--for", "0.2s", port=line.tap_name)
    check(found.status == NO_ANSWER and not found.output, "a silent line is told by the status", found)
    found = tool.run("capture", "-o", tool.place / "nothing.pcapng", "--for", "0.2s", port=line.tap_name)
    check(found.status == NO_ANSWER and "0 frames" in found.errors, "capture says the same", found)
    found = tool.run("replay", "/nowhere.pcapng")
    check(found.status == PORT and "/nowhere.pcapng" in found.errors, "a capture that is not there is named", found)
    found = tool.run("capture", "--as", "pcap", "-o", "x", port=line.tap_name)
    check(found.status == USAGE and "pcap" in found.errors, "a form that is none is named", found)


def main(check, program):
    with Simulator(program, "atv320:7", "atv12:3") as device, Tool(program) as tool:
        for part in (silence, sniffs, captures, decides_again, refuses_to_speak):
            with LineBetween(device) as line:
                part(tool, line, check)


runs(main)
