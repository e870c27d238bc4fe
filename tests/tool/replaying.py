# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A replay says, byte for byte, what was decided of each frame when it passed: by a client and by a server whose line
has faults, and by a listener whose line was sniffed; and what a capture file is good for as a port.

    python3 replaying.py TOOL WRITE_DECISIONS
"""
import collections
import concurrent.futures
import datetime
import random
import signal
import subprocess
import time

from line_between import LineBetween
from support import DIFFERS, DONE, LIMIT, USAGE, Simulator, Tool, runs, with_crc

SEEDS = (1, 2, 3, 4, 5)
KINDS = {"client": {"good", "damaged", "late", "stray"}, "server": {"good", "damaged", "foreign", "stray"}}


def time_text(microseconds):
    """Of a frame, as the tool writes it; the zone is that of the machine."""
    at = datetime.datetime.fromtimestamp(microseconds // 1_000_000).astimezone()
    return at.strftime("%Y-%m-%dT%H:%M:%S.") + f"{microseconds % 1_000_000:06}" + at.strftime("%z")


def line_of(time_words, role, verdict, own, data):
    return f"{time_words},{role},{verdict},{own},{data}\n"


def engines(tool, check, write_decisions):
    for engine, kinds in KINDS.items():
        seen = collections.Counter()
        for seed in SEEDS:
            file = tool.place / f"{engine}{seed}.pcapng"
            told = subprocess.run([write_decisions, file, engine, str(seed)], check=True, capture_output=True, text=True)
            rows = [line.split(",") for line in told.stdout.splitlines()]
            seen.update(row[2] for row in rows)
            decided = "".join(line_of(time_text(int(at)), role, verdict, own == "1", data.strip())
                              for at, role, verdict, own, data in rows)
            played = tool.run("--json", "replay", file)
            repeated = "".join(line_of(each["time"], each["role"], each["verdict"], each["own"], each["bytes"])
                               for each in played.objects() if each["role"] != "silence")
            check(played.status == DONE and len(rows) > 500 and repeated == decided,
                  f"{len(rows)} decisions of a {engine}, seed {seed}, are repeated byte for byte",
                  "" if repeated == decided else first_difference(decided, repeated))
        check(kinds <= set(seen), f"decisions of a {engine} of all kinds", dict(seen))


def first_difference(one, other):
    for a, b in zip(one.splitlines(), other.splitlines()):
        if a != b:
            return a, b
    return len(one), len(other)


def exchange(chance):
    """A read of an exchange, whole or with something wrong: the pieces that pass, with the pauses behind them."""
    unit, start, count = chance.randrange(1, 30), chance.randrange(60_000), chance.randrange(1, 20)
    request = with_crc(bytes([unit, 3]) + start.to_bytes(2, "big") + count.to_bytes(2, "big"))
    response = with_crc(bytes([unit, 3, 2 * count]) + chance.randbytes(2 * count))
    kind = chance.randrange(8)
    if kind == 0:
        response = bytes([response[0], response[1], response[2], response[3] ^ 4]) + response[4:]
    elif kind == 1:
        return [(request, 0.6)]
    elif kind == 2:
        return [(request, 0.6), (response, 0.01)]
    elif kind == 3:
        return [(request[:-3], 0.03), (request, 0.01), (response, 0.01)]
    return [(request, 0.006), (response, 0.01)]


def sniffed(tool, seed):
    """What a sniffer shows of a line, and its capture."""
    chance = random.Random(seed)
    file = tool.place / f"sniffed{seed}.pcapng"
    with Simulator(tool.program, "atv320:7") as device, LineBetween(device) as line:
        process = tool.start("--json", "sniff", "-o", file, port=line.tap_name)
        line.say_to_tap(with_crc(bytes([7, 3, 0x0C, 0x82, 0, 1]))[4:])  # joins in the middle
        time.sleep(0.7)
        for _ in range(25):
            for data, pause in exchange(chance):
                line.say_to_tap(data)
                time.sleep(pause)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        return process.communicate(timeout=LIMIT)[0], file


def listener(tool, check):
    """What a sniffer showed of a line is, byte for byte, what a replay of the capture shows that it kept. Each seed has a line
    of its own: they wait side by side."""
    with concurrent.futures.ThreadPoolExecutor() as lines:
        of_lines = list(lines.map(lambda seed: sniffed(tool, seed), SEEDS))
    for seed, (shown, file) in zip(SEEDS, of_lines):
        played = tool.run("--json", "replay", file)
        verdicts = collections.Counter(each["verdict"] for each in played.objects())
        check(shown == played.output and {"good", "damaged"} <= set(verdicts),
              f"seed {seed}: a replay says what the sniffer said", "" if shown == played.output
              else first_difference(shown, played.output))
        check(sum(verdicts.values()) > 40, "of all frames", dict(verdicts))


def others_capture(tool, check, began):
    """A capture of which nobody judged the frames is listened to: link type 147, as loggers write it. A board without a
    calendar begins in 1970."""
    request, response = with_crc(bytes.fromhex("07030C820001")), with_crc(bytes.fromhex("07030201F4"))
    packets = b""
    for number, data in enumerate((request, response, request, response[:-1] + b"?")):
        packets += b"".join(each.to_bytes(4, "little") for each in (began + number // 2, 5000 * (number % 2), len(data),
                                                                    len(data))) + data
    file = tool.place / f"other{began}.pcap"
    file.write_bytes(bytes.fromhex("d4c3b2a1020004000000000000000000ffff000093000000") + packets)
    found = [(each["role"], each["verdict"]) for each in tool.run("--json", "replay", file).objects()]
    check(found == [("request", "good"), ("response", "good"), ("request", "good"), ("unknown", "damaged"),
                    ("silence", "unanswered")], f"another program's capture, from {began} on, is judged by the listener", found)
    return file


def as_ports(tool, check, file):
    """What works offline works with a capture as --port; what would speak is refused, and says what to do instead."""
    replay = tool.run("--json", "replay", file)
    for words in (["sniff"], ["replay"]):
        check(tool.run("--json", *words, port=str(file)).output == replay.output, f"{words} of a capture as port")
    check(tool.run("--json", "timing", port=str(file)).output == tool.run("--json", "timing", file).output != "",
          "timing of a capture as port")
    found = tool.run("--json", "decode", port=str(file))
    names = [each["value"] for each in found.objects() if each["field"] == "function"]
    check(found.status == DIFFERS and "read holding registers" in names, "decode of a capture as port", found)
    for words in (["read", "RFR"], ["scan"], ["identify"], ["watch", "RFR"], ["stop"], ["capture", "-o", "x"],
                  ["--write", "write", "ACC=1s"], ["--allow-run", "start", "--speed", "10rpm"]):
        ended = tool.run("-d", "atv320", "-u", 7, *words, port=str(file))
        check(ended.status == USAGE and f"{file} is a capture" in ended.errors and "replay" in ended.errors,
              f"{words} of a capture is refused", ended)
    ended = tool.run("sniff", "-o", "x", port=str(file))
    check(ended.status == USAGE and "already" in ended.errors, "a capture is not captured again", ended)
    ended = tool.run("replay")
    check(ended.status == USAGE and "which capture" in ended.errors, "no capture at all", ended)


def main(check, program, write_decisions):
    with Tool(program) as tool:
        engines(tool, check, write_decisions)
        others_capture(tool, check, 0)
        as_ports(tool, check, others_capture(tool, check, 1_000))
        listener(tool, check)


runs(main)
