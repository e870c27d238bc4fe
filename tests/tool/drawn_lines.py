# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Command lines of read, watch, write, ask and device that are drawn by chance, most of them wrong: each ends in time with a
status of the list, says why where it refuses, and a refused one has written nothing; nor has any without --write.

    python3 drawn_lines.py TOOL COUNT SEED
"""
import random
import threading
import time

from support import REFUSED, USAGE, Line, Tool, runs, with_crc

SIDE_BY_SIDE, LIMIT = 4, 30
READING = (1, 2, 3, 4, 7, 11, 12, 17, 20, 24)
NUMBERS = ("0", "-1", "0x", "0xFFFFF", "4294967296", "99999999999999999999", "1e3", "0.1", "40001", "٣", "1 ", "")
SPACES = ("holding:", "i:", "c:", "discrete:", "list:", "HOLDING:", "x:", ":", "::", "group:", "@", "")
FORMS = (":u16", ":f32", ":f64", ":cdab", ":abcdefga", ":hgfedcba", ":0.1V", ":0.1V-50", ":1e9", ":text0", ":text250", ":text99999999999",
         ":bits", ":hex", ":bcd32", ":", ":999999999V+999999999", ":0", ":0.1=5", ":i64", ":f33", ".3", ".3-7", ".7-3", ".16", "-43", "-0")
GOOD_FORMS = ("", ":u16", ":f32", ":i16", ":u32:cdab", ":0.1V", ".3", ".3-7", ":text8", ":hex", ":bcd16", ":f64")
VALUES = ("5", "-5", "on", "#5", "#-5", "0x5", "0x", "#", "", "nan", "-inf", "1e400", "1e-400", "1,5", "5V", "5 V", "9" * 23, "0.1",
          "\u202e", "x" * 300, "=5", "\n", "%s%n", "$(id)", '"', "0x" + "F" * 17, "-0", "5.", ".5", "--", "18446744073709551616")
OPTIONS = ("-u 1", "-u 0", "-u 248", "-u 1,7", "-u 7-1", "-d none", "-d atv320", "-d atv9", "--write", "--allow-run", "--json", "--csv", "-v",
           "--timeout 0.05", "--timeout nan", "--timeout -1", "--retries 0", "--retries 11", "--pause 3001", "-b 0", "-b 9600", "-f 7E1",
           "--noise 8", "--any-unit", "--echo", "--rs485", "--name a=1", "--name =1", "--device meter.toml", "--device ../x", "--bogus", "-y")
DRIVES = (3201, 8501, 400, 458, 0x6041, 0x6040, 8603, 8602)
FILE = '[[register]]\nname = "set"\naddress = 9\ntype = "i16"\nscale = 0.1\naccess = "write"\nmin = -10\nmax = 95\n'


class Unit(Line):
    """Says that it is no drive, has all registers but a drive's own, and takes whatever is written."""

    def __init__(self):
        super().__init__()
        self.requests = []

    def hear(self, data):
        super().hear(data)
        self.requests.append(data)
        unit, function, first, count = data[0], data[1], int.from_bytes(data[2:4], "big"), int.from_bytes(data[4:6], "big")
        body = b""
        if function == 43:
            body = bytes([14, 1, 1, 0, 0, 3]) + b"\0\4Acme\1\4EM-3\2\0011"
        elif function in (1, 2, 3, 4) and count <= 125 and first not in DRIVES:
            size = 2 * count if function > 2 else (count + 7) // 8
            body = bytes([size]) + bytes(size)
        elif function in (5, 6, 15, 16, 22):
            body = data[2:8 if function == 22 else 6]
        self.say(with_crc(bytes([unit, function]) + body if body else bytes([unit, function | 0x80, 2])))


def place(chance):
    if chance.random() < 0.6:
        return chance.choice(("", "h:", "i:", "holding:", "c:", "d:")) + str(chance.randrange(300)) + chance.choice(GOOD_FORMS)
    if chance.random() < 0.2:
        return chance.choice(("RFR", "@fault", "@", "*", "set", "s*", "ETA.fault", "705.0", "?", "-", "--", ""))
    number = chance.choice(NUMBERS) if chance.random() < 0.2 else str(chance.randrange(66000))
    return chance.choice(SPACES) + number + "".join(chance.choices(FORMS, k=chance.choice((0, 1, 1, 2, 3))))


def changed(chance, word):
    """One letter more, less or another, now and then."""
    at = chance.randrange(len(word) + 1)
    letter = chance.choice("09afx:.-+=#@*?,/\\ '\"{}[]é\x7f\x1b")
    return word if chance.random() > 0.1 else word[:at] + chance.choice((letter, letter + word[at:at + 1], "")) + word[at + 1:]


def line(chance):
    words = [word for option in chance.sample(OPTIONS, chance.choice((0, 0, 1, 1, 2))) for word in option.split()]
    command = chance.choice(("read", "read", "watch", "write", "write", "write", "ask", "device"))
    if command in ("write", "ask") and chance.random() < 0.7:
        words += ["-u", "1", "-d", "none", "--write"]
    words.append(command)
    count = chance.choice((0, 1, 1, 1, 2, 3))
    if command == "watch":
        words += ["--for", chance.choice(("0.05s", "50ms", "0s", "-1s", "1e99s", "abc")), "--every", chance.choice(("0s", "20ms", "x", "1h"))]
    if command in ("read", "watch"):
        words += [changed(chance, place(chance)) for _ in range(count)]
    elif command == "write":
        words += [changed(chance, place(chance) + chance.choice(("=", "=", "", "==")) + chance.choice(VALUES)) for _ in range(count)]
    elif command == "ask":
        words += [changed(chance, chance.choice(("03", "06", "10", "16", "17", "2B", "08", "80", "FF", "GG", "", "043"))),
                  changed(chance, "".join(chance.choices("0123456789ABCDEFabcdef", k=chance.choice((0, 2, 4, 8, 8, 9, 10, 14, 520)))))]
    else:
        words += [chance.choice(("check", "import", "export", "bogus", "")),
                  changed(chance, chance.choice(("meter.toml", "none.toml", "atv320", "bad.toml", "/dev/null", "/", "sdm630", "deep.json")))]
    return words


def only_reads(request):
    return request[1] in READING or request[1] == 8 and request[2:4] == b"\0\0" or request[1] == 43 and request[2] == 14


def fault_of(words, ended, taken, requests):
    """What is wrong with it; nothing where all is well."""
    written = [request.hex() for request in requests if not only_reads(request)]
    if ended.status not in range(6) or taken > LIMIT:
        return "its end"
    if ended.status in (USAGE, REFUSED) and (written or not ended.errors.strip()):
        return f"it is refused, and wrote {written}, or does not say why"
    may_write = "--write" in words and ("write" in words or "ask" in words)
    return f"it wrote {written}" if written and not may_write else ""


def run_all(program, lines, wrong, statuses):
    with Tool(program) as tool, Unit() as unit:
        (tool.place / "meter.toml").write_text(FILE)
        (tool.place / "bad.toml").write_bytes(b'[[register]]\nname = "\x00"\n\xff')
        (tool.place / "deep.json").write_text("[" * 5000)
        for words in lines:
            unit.requests.clear()
            began = time.monotonic()
            ended = tool.run("--no-listen", *words, port=unit.name, limit=LIMIT)
            if fault := fault_of(words, ended, time.monotonic() - began, unit.requests):
                wrong.append((words, fault, ended))
            statuses.append(ended.status)


def main(check, program, count, seed):
    print("seed", seed)
    chance = random.Random(int(seed))
    lines, wrong, statuses = [line(chance) for _ in range(int(count))], [], []
    threads = [threading.Thread(target=run_all, args=(program, lines[i::SIDE_BY_SIDE], wrong, statuses)) for i in range(SIDE_BY_SIDE)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    print({status: statuses.count(status) for status in sorted(set(statuses))})
    for words, fault, ended in wrong:
        check(False, f"{words}: {fault}", ended)
    check(len(statuses) == int(count) and len(set(statuses)) > 2, f"{count} drawn command lines", len(wrong))


runs(main)
