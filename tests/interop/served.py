# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`rtuwire serve` as a process, its clients by plain sockets, units behind it that keep what reaches them, and its figures."""
import collections
import json
import os
import re
import socket
import subprocess
import tempfile
import threading
import time

from frames import Line, crc, with_crc
from simulator import soon

LISTENING = re.compile(r"\b(\w+)://([\w.:\[\]-]+):(\d+)(?:/\S*)? listening")
LIMIT = 60  # s, for what has to come


class Served:
    """with Served(program, port, words) as served: ... once it listens; `served.ports["mbap"]` are numbers of ports.
    Nothing but `words` is behind `serve`; what belongs to the line is in `line`."""

    def __init__(self, program, port, *words, line=("--timeout", 10, "--retries", 0), listens=None, **how):
        words = [str(word) for word in words]
        if "--listen" not in words:
            words += ["--listen", "mbap://127.0.0.1:0"]
        self.wanted = words.count("--listen") + words.count("--metrics") if listens is None else listens
        self.lines, self.changed = {"stdout": [], "stderr": []}, threading.Condition()
        # What it keeps is in a folder of its own, unless `how` says where.
        self.folder = tempfile.TemporaryDirectory(prefix="served-")
        how.setdefault("env", {**os.environ, "XDG_STATE_HOME": self.folder.name})
        self.process = subprocess.Popen(
            [program, "--port", port, *map(str, line), "serve", *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, **how)
        self.readers = [threading.Thread(target=self.read, args=(name,), daemon=True) for name in self.lines]

    def read(self, name):
        for line in getattr(self.process, name):
            with self.changed:
                self.lines[name].append(line.rstrip("\n"))
                self.changed.notify_all()

    def said(self):
        with self.changed:
            return [*self.lines["stdout"], *self.lines["stderr"]]

    def __enter__(self):
        for each in self.readers:
            each.start()
        soon(lambda: len(self.listening()) >= self.wanted or self.process.poll() is not None, LIMIT)
        self.ports = collections.defaultdict(list)
        for word, _, number in self.listening():
            self.ports[word].append(int(number))
        if len(self.listening()) < self.wanted:
            self.process.kill()
            raise RuntimeError(f"serve does not listen: {self.said()}")
        return self

    def listening(self):
        return [found.groups() for line in self.said() if (found := LISTENING.search(line))]

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        for each in self.readers:
            each.join()
        self.folder.cleanup()

    def noted(self):
        """The rows of its writes.log: time, user, port, unit, register, before, after."""
        try:
            with open(os.path.join(self.folder.name, "rtuwire", "writes.log"), encoding="utf-8") as rows:
                return [row.rstrip("\n").split("\t") for row in rows]
        except FileNotFoundError:
            return []

    @property
    def number(self):
        return self.ports["mbap"][0]

    def events(self):
        """What --json has said so far."""
        with self.changed:
            return [json.loads(line) for line in self.lines["stdout"] if line.startswith("{")]

    def ended(self, signal_number=None):
        """Its status, once it has ended (by this signal)."""
        if signal_number is not None:
            self.process.send_signal(signal_number)
        status = self.process.wait(timeout=LIMIT)
        for each in self.readers:
            each.join()
        return status

    def memory(self):
        """KiB that are its own."""
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as lines:
            return next(int(line.split()[1]) for line in lines if line.startswith("RssAnon:"))

    def metrics(self):
        text = http(self.ports["http"][0], "GET /metrics HTTP/1.1\r\nHost: test\r\nConnection: close\r\n\r\n")
        return Exposition(text.partition("\r\n\r\n")[2])


def http(number, request):
    with socket.create_connection(("127.0.0.1", number), timeout=LIMIT) as line:
        line.sendall(request.encode())
        data = b""
        while part := line.recv(4096):
            data += part
    return data.decode()


class Exposition:
    """The text form of Prometheus, 0.0.4, by its document: what is not of that form raises. `it.samples[name, ((label, value),)]`,
    `it.total(name, unit=7)`."""

    NAME = r"[a-zA-Z_:][a-zA-Z0-9_:]*"
    SAMPLE = re.compile(rf"({NAME})(?:\{{(.*)\}})?[ \t]+(\S+)(?:[ \t]+-?\d+)?")
    LABEL = re.compile(r'\s*([a-zA-Z_][a-zA-Z0-9_]*)="((?:[^"\\\n]|\\["\\n])*)"\s*(,|$)')
    KINDS = ("counter", "gauge", "histogram", "summary", "untyped")
    SUFFIXES = {"summary": ("", "_sum", "_count"), "histogram": ("_bucket", "_sum", "_count")}

    def __init__(self, text):
        if text and not text.endswith("\n"):
            raise ValueError("the last line has no end")
        self.samples, self.kinds, self.helps, self.text = {}, {}, {}, text
        self.order = []
        for line in text.split("\n")[:-1]:
            self.take(line)

    def take(self, line):
        if not line.strip():
            return
        if line.startswith("#"):
            words = line.split(None, 3)
            if len(words) > 2 and words[1] in ("TYPE", "HELP"):
                self.describe(words[1], words[2], words[3] if len(words) > 3 else "")
            return
        found = self.SAMPLE.fullmatch(line)
        if not found:
            raise ValueError(f"no sample: {line!r}")
        name, labels, value = found.groups()
        key = (name, tuple(sorted(self.labels(labels or ""))))
        if key in self.samples:
            raise ValueError(f"twice: {line!r}")
        self.enter(self.family(name))
        self.samples[key] = float(value.replace("Inf", "inf"))

    def describe(self, what, name, rest):
        kept = self.kinds if what == "TYPE" else self.helps
        if name in kept:
            raise ValueError(f"{what} {name} twice")
        if what == "TYPE" and rest not in self.KINDS:
            raise ValueError(f"TYPE {name} {rest}")
        if what == "TYPE" and any(self.family(sample) == name for sample, _ in self.samples):
            raise ValueError(f"TYPE {name} behind its samples")
        kept[name] = rest
        self.enter(name)

    def enter(self, family):
        """All lines of one metric stand together."""
        if family in self.order[:-1]:
            raise ValueError(f"{family} in two places")
        if self.order[-1:] != [family]:
            self.order.append(family)

    def family(self, name):
        for suffix in ("_bucket", "_sum", "_count"):
            base = name.removesuffix(suffix)
            if base != name and suffix in self.SUFFIXES.get(self.kinds.get(base), ()):
                return base
        return name

    def labels(self, text):
        at, found = 0, []
        while at < len(text):
            label = self.LABEL.match(text, at)
            if not label or label[1] in dict(found):
                raise ValueError(f"no labels: {text!r}")
            found.append((label[1], label[2].replace(r"\n", "\n").replace(r"\"", '"').replace("\\\\", "\\")))
            at = label.end()
        return found

    def total(self, metric, **labels):
        """The sum of all samples of that name which have these labels."""
        wanted = {(key, str(value)) for key, value in labels.items()}
        return sum(value for (each, has), value in self.samples.items() if each == metric and wanted <= set(has))


def header(number, size, protocol=0):
    return number.to_bytes(2, "big") + protocol.to_bytes(2, "big") + size.to_bytes(2, "big")


def message(number, unit, pdu):
    return header(number, len(pdu) + 1) + bytes([unit]) + pdu


def read_of(address, count=1, function=3):
    return bytes([function]) + address.to_bytes(2, "big") + count.to_bytes(2, "big")


class Asker:
    """with Asker(number of a port) as client: a client of Modbus TCP. Several requests may be under way."""

    def __init__(self, number, source=None, receive_buffer=None):
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        if source:
            self.socket.bind((source, 0))
        self.socket.settimeout(LIMIT)
        self.socket.connect(("127.0.0.1", number))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.waiting, self.last = b"", 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.socket.close()

    def send(self, unit, pdu, number=None):
        self.last = (self.last + 1) & 0xFFFF if number is None else number
        self.socket.sendall(message(self.last, unit, pdu))
        return self.last

    def take(self, size):
        """So many bytes; fewer only where the connection has ended."""
        while len(self.waiting) < size:
            try:
                data = self.socket.recv(4096)
            except ConnectionError:
                data = b""
            if not data:
                break
            self.waiting += data
        taken, self.waiting = self.waiting[:size], self.waiting[size:]
        return taken

    def answer(self):
        """Number, unit and PDU of the next answer; None where the connection has ended."""
        front = self.take(7)
        if len(front) < 7:
            return None
        if front[2:4] != b"\0\0" or not 2 <= int.from_bytes(front[4:6], "big") <= 254:
            raise RuntimeError(f"no Modbus TCP: {front.hex(' ')}")
        return int.from_bytes(front[:2], "big"), front[6], self.take(int.from_bytes(front[4:6], "big") - 1)

    def ask(self, unit, pdu, number=None):
        """The PDU of the answer to this request, which is the next one."""
        number = self.send(unit, pdu, number)
        found = self.answer()
        if found is None or found[:2] != (number, unit):
            raise RuntimeError(f"the answer to {number} of unit {unit}: {found}")
        return found[2]

    def read(self, unit, address, count=1):
        """Values, or the code of the exception as a negative number."""
        pdu = self.ask(unit, read_of(address, count))
        if pdu[0] == 0x83:
            return -pdu[1]
        return [int.from_bytes(pdu[at:at + 2], "big") for at in range(2, len(pdu), 2)]

    def has_ended(self, limit=LIMIT):
        """Whether the other end closes within that time; what comes before that is dropped."""
        self.socket.settimeout(limit)
        try:
            while self.socket.recv(4096):
                pass
            return True
        except ConnectionError:
            return True
        except TimeoutError:
            return False


class RtuAsker(Asker):
    """The same for RTU frames over TCP, which have no number: one request after the other."""

    def send(self, unit, pdu, number=None):
        self.socket.sendall(with_crc(bytes([unit]) + pdu))
        self.last = 0
        return 0

    def answer(self):
        """By the length of what reads and writes registers, and of exceptions."""
        front = self.take(3)
        if len(front) < 3:
            return None
        size = 5 if front[1] & 0x80 else 5 + front[2] if front[1] in (1, 2, 3, 4, 23) else 8
        frame = front + self.take(size - 3)
        if crc(frame) != 0:
            raise RuntimeError(f"no RTU: {frame.hex(' ')}")
        return 0, frame[0], frame[1:-2]


def request_size(data):
    """Of the request that begins here, by its function; 0 where that is not known yet, or none is there."""
    if len(data) < 4:
        return 0
    fixed = {1: 8, 2: 8, 3: 8, 4: 8, 5: 8, 6: 8, 7: 4, 11: 4, 12: 4, 17: 4, 22: 10, 24: 6, 43: 7}
    counts = {15: (6, 9), 16: (6, 9), 20: (2, 5), 21: (2, 5), 23: (10, 13)}
    size = fixed.get(data[1], 0)
    if data[1] in counts:
        at, more = counts[data[1]]
        size = more + data[at] if len(data) > at else 0
    if not size:
        # One at a time is on a line: the longest that ends so. Of a frame whose CRC ends with 00 all but that byte is one, too.
        return max((end for end in range(4, len(data) + 1) if crc(data[:end]) == 0), default=0)
    return size if len(data) >= size and crc(data[:size]) == 0 else 0


def requests_in(data):
    """The requests that stand there one behind the other, and what is left over."""
    found = []
    while size := request_size(data):
        found.append(data[:size])
        data = data[size:]
    return found, data


FIRST, LAST = 1000, 1999  # the addresses that the units have: none that makes a drive


def value_of(unit, address):
    return (unit * 4099 + address * 31) & 0xFFFF


class PlainUnits(Line):
    """with PlainUnits(1, 2) as line: units that are no drives, on a line of their own, whose registers hold what `value_of` says. Every
    frame is kept in `requests`. Those of `mute` keep silent where they are asked who they are. Behind `line.hold()` no answer leaves before
    `line.release_all()`."""

    def __init__(self, *units, silent=(), delay=0, nameless=(), mute=()):
        super().__init__()
        self.units, self.silent, self.delay, self.nameless = set(units), set(silent), delay, set(nameless)
        self.mute = set(mute)
        self.requests, self.waiting = [], b""
        self.gate, self.is_held = threading.Semaphore(0), False
        self.before_answer = None

    def __exit__(self, *how):
        self.is_held = False
        self.gate.release(1 << 20)
        super().__exit__(*how)

    def hold(self):
        self.is_held = True

    def release_all(self):
        self.is_held = False
        self.gate.release()

    def hear(self, data):
        super().hear(data)
        self.waiting += data
        requests, self.waiting = requests_in(self.waiting)
        for request in requests:
            self.requests.append(request)
            if request[0] in self.silent or request[0] not in self.units or (request[1] == 43 and request[0] in self.mute):
                continue
            if self.is_held:
                self.gate.acquire()
            if self.before_answer:
                self.before_answer(request)
            if self.delay:
                time.sleep(self.delay)
            self.say(with_crc(request[:1] + self.answer(request[0], request[1:-2])))

    def is_whole(self):
        """Whether nothing but whole requests has come."""
        return not self.waiting and b"".join(self.requests) == self.heard

    def asked(self, function=None, unit=None):
        """The requests of that function to that unit, but for those by which the program asks who is there."""
        return [each for each in list(self.requests) if function in (None, each[1]) and unit in (None, each[0]) and each[1] not in (17, 43)]

    def reads(self):
        """Unit and address of each read of our registers, in their order."""
        return [(each[0], int.from_bytes(each[2:4], "big")) for each in list(self.requests)
                if each[1] == 3 and FIRST <= int.from_bytes(each[2:4], "big") <= LAST]

    def answer(self, unit, pdu):
        function = pdu[0]
        address, count = int.from_bytes(pdu[1:3], "big"), int.from_bytes(pdu[3:5], "big")
        if function in (3, 4, 23):
            if not (FIRST <= address and address + count <= LAST + 1 and count):
                return bytes([function | 0x80, 2])
            return bytes([function, 2 * count]) + b"".join(value_of(unit, address + i).to_bytes(2, "big") for i in range(count))
        if function in (1, 2):
            return bytes([function, (count + 7) // 8]) + bytes((count + 7) // 8)
        if function in (5, 6, 8, 22):
            return pdu
        if function in (15, 16):
            return pdu[:5]
        if function == 7:
            return bytes([7, 0])
        if function == 11:
            return bytes([11, 0, 0, 0, 1])
        if function == 43 and pdu[1:2] == b"\x0e" and unit not in self.nameless:
            return bytes.fromhex("2b0e010100000300") + b"\5Maker" + b"\1\5Meter" + b"\2\0031.0"
        return bytes([function | 0x80, 1])
