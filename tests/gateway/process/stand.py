# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the tests of the gateway stand on: a mosquitto of their own, units on pseudo-terminals whose names stay, and the
gateway as a process."""
import datetime
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parents[1] / "tool"))

from support import Line, Simulator, crc, runs, soon, with_crc  # noqa: E402,F401

from mqtt import Client, Proxy  # noqa: E402,F401

LIMIT = 60  # s, for what has to come
SITE = "rtuwire/hall/g1"
MOSQUITTO = shutil.which("mosquitto", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")


def listens(port):
    """Somebody does there, seen without connecting: a broker would note it."""
    wanted = f":{port:04X}"
    with open("/proc/net/tcp", encoding="ascii") as table:
        return any(line.split()[1].endswith(wanted) and line.split()[3] == "0A" for line in list(table)[1:])


class Broker:
    """with Broker(folder) as broker: a mosquitto on a free port below those that a system gives to clients."""

    def __init__(self, folder, *lines, anonymous=True):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="broker-", dir=folder))
        self.lines, self.anonymous, self.process, self.port = lines, anonymous, None, None
        os.chmod(self.folder, 0o755)

    def begin(self):
        for _ in range(100):
            self.port = random.randrange(20000, 32000)
            if not listens(self.port) and self.start():
                return
        raise RuntimeError("no port for a broker")

    def start(self):
        """At the port that it has; whether it listens."""
        said = [f"listener {self.port} 127.0.0.1", f"allow_anonymous {'true' if self.anonymous else 'false'}",
                "persistence false", "log_dest stderr", "log_type error", "log_type warning", *self.lines]
        if os.getuid() == 0:
            said.append("user root")
        (self.folder / "mosquitto.conf").write_text("\n".join(said) + "\n", encoding="utf-8")
        with open(self.folder / "log", "ab") as log:
            self.process = subprocess.Popen([MOSQUITTO, "-c", str(self.folder / "mosquitto.conf")], stdout=log, stderr=log)
        return soon(lambda: self.process.poll() is not None or listens(self.port), LIMIT) and self.process.poll() is None

    def kill(self):
        self.process.kill()
        self.process.wait()

    def again(self):
        if not soon(self.start, LIMIT):
            raise RuntimeError("the broker does not start again")

    def freeze(self):
        self.process.send_signal(signal.SIGSTOP)

    def thaw(self):
        self.process.send_signal(signal.SIGCONT)

    def __enter__(self):
        self.begin()
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()


class Units(Line):
    """with Units({3: {0: 2301}}) as line: units on a line of their own, whose holding and input registers are one; `line.link`
    is its name in `folder`. They note each request, and each write as (time, unit, address, words)."""

    def __init__(self, units, link=None):
        super().__init__()
        self.units, self.silent, self.requests, self.writes, self.waiting = units, set(), [], [], b""
        self.refuses_writes = False
        self.link = link
        if link:
            pathlib.Path(link).unlink(missing_ok=True)
            os.symlink(self.name, link)

    def hear(self, data):
        super().hear(data)
        self.waiting += data
        while len(self.waiting) >= 7:
            size = 9 + self.waiting[6] if self.waiting[1] == 16 else 7 if self.waiting[1] == 43 else 8
            if len(self.waiting) < size:
                return
            request = self.waiting[:size]
            if crc(request):
                self.waiting = b""
                return
            self.waiting = self.waiting[size:]
            self.requests.append((time.time(), request))
            answer = self.answer(request)
            if answer:
                self.say(with_crc(answer))

    def answer(self, request):
        unit, function = request[0], request[1]
        if unit not in self.units or unit in self.silent:
            return None
        registers, start, count = self.units[unit], *(int.from_bytes(request[i:i + 2], "big") for i in (2, 4))
        if function in (3, 4):
            if any(each not in registers for each in range(start, start + count)):
                return bytes([unit, function | 0x80, 2])
            words = b"".join(registers[each].to_bytes(2, "big") for each in range(start, start + count))
            return bytes([unit, function, len(words)]) + words
        if function in (6, 16):
            words = [count] if function == 6 else [int.from_bytes(request[7 + 2 * i:9 + 2 * i], "big") for i in range(count)]
            self.writes.append((time.time(), unit, start, words))
            if self.refuses_writes:
                return bytes([unit, function | 0x80, 4])
            if any(start + i not in registers for i in range(len(words))):
                return bytes([unit, function | 0x80, 2])
            registers.update({start + i: word for i, word in enumerate(words)})
            return request[:6]
        return bytes([unit, function | 0x80, 1])

    def __exit__(self, *how):
        if self.link:  # first: the number of a pseudo-terminal that is gone is soon that of another test
            pathlib.Path(self.link).unlink(missing_ok=True)
        super().__exit__(*how)


METER = """[[register]]
name = "voltage"
space = "input"
address = 0
scale = 0.1
unit = "V"

[[register]]
name = "power"
space = "input"
address = 1
type = "i16"
unit = "W"
invalid = 0x7FFF

[[register]]
name = "energy"
space = "input"
address = 2
type = "u32"
scale = 0.01
unit = "kWh"

[[register]]
name = "set_point"
address = 10
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = 5
max = 60

[[register]]
name = "kept"
address = 11
access = "write"
min = 0
max = 1000
stored = true

[[register]]
name = "mode"
address = 12
access = "write"
choices = { off = 0, heat = 1 }

[[register]]
name = "gate"
address = 13
access = "write"
min = 0
max = 1
moves = true
"""
WORDS = {0: 2301, 1: 1200, 2: 0, 3: 12345, 10: 215, 11: 7, 12: 1, 13: 0}


def meter():
    """The registers of one, for `Units`."""
    return dict(WORDS)


def text_of(port, lines, site="hall", gateway="g1", **broker):
    """A file of the gateway. A line: {"name", "port", ..., "serve": {...}, "devices": [{...}]}."""
    said = [f'site = "{site}"', f'gateway = "{gateway}"']
    said += [f"{name} = {json.dumps(value)}" for name, value in broker.pop("top", {}).items()]
    said += ["[broker]", 'host = "127.0.0.1"', f"port = {port}"]
    said += [f"{name} = {json.dumps(value)}" for name, value in broker.items()]
    for line in lines:
        said.append("[[line]]")
        said += [f"{name} = {json.dumps(value)}" for name, value in line.items() if name not in ("devices", "serve") and value is not None]
        if "serve" in line:
            said.append("[line.serve]")
            said += [f"{name} = {json.dumps(value)}" for name, value in line["serve"].items()]
        for device in line["devices"]:
            said.append("[[line.device]]")
            said += [f"{name} = {value if name == 'groups' else json.dumps(value)}" for name, value in device.items()]
    return "\n".join(said) + "\n"


def a_meter(name="meter", unit=3, **more):
    return {"name": name, "unit": unit, "file": "meter.toml", "every": 0.5, **more}


def a_line(port, *devices, name="line1", **more):
    return {"name": name, "port": str(port), "baud": 38400, "format": "8E1", "timeout": 0.2, "retries": 1, **more,
            "devices": list(devices) or [a_meter()]}


class Gateway:
    """with Gateway(program, folder, text) as gateway: the process, with its file in `folder`, which has the register file
    `meter.toml`, too. `gateway.said()` is what it said for people."""

    def __init__(self, program, folder, text, *words, start=True):
        self.program, self.folder, self.words = os.path.abspath(program), pathlib.Path(folder), words
        self.file = self.folder / "gateway.toml"
        (self.folder / "meter.toml").write_text(METER, encoding="utf-8")
        self.write(text)
        self.process, errors = None, self.folder / "stderr"
        self.before = errors.stat().st_size if errors.exists() else 0
        self.environment = {**os.environ, "LC_ALL": "C.UTF-8", "NO_COLOR": "1", "HOME": str(self.folder)}
        if start:
            self.start()

    def write(self, text):
        """Whole or not at all, as an editor does."""
        new = self.folder / "gateway.toml.new"
        if "state_folder" not in text:
            text = f'state_folder = "{self.folder}/state"\n' + text
        new.write_text(text, encoding="utf-8")
        os.replace(new, self.file)

    def start(self):
        (self.folder / "state").mkdir(exist_ok=True)
        with open(self.folder / "stderr", "ab") as errors, open(self.folder / "stdout", "ab") as output:
            self.process = subprocess.Popen([self.program, str(self.file), *self.words], stdin=subprocess.DEVNULL,
                                            stdout=output, stderr=errors, cwd=self.folder, env=self.environment)

    def said(self):
        return (self.folder / "stderr").read_bytes()[self.before:].decode(errors="backslashreplace")

    def reload(self, text=None):
        if text is not None:
            self.write(text)
        self.process.send_signal(signal.SIGHUP)

    def end(self, how=signal.SIGTERM):
        """Its status."""
        self.process.send_signal(how)
        try:
            return self.process.wait(LIMIT)
        except subprocess.TimeoutExpired:
            return "did not end"

    def kill(self):
        self.process.kill()
        self.process.wait()

    def run_check(self, text=None):
        """`--check` of its file: status, output and errors."""
        if text is not None:
            self.write(text)
        return subprocess.run([self.program, str(self.file), "--check", *self.words],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, cwd=self.folder,
                              env=self.environment, timeout=LIMIT, check=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process and self.process.poll() is None:
            self.kill()
        if self.process:
            print("what the gateway said:", *self.said().splitlines()[-40:], sep="\n    ")


class Folder:
    """with Folder() as folder: ends with all that is in it."""

    def __enter__(self):
        self.place = tempfile.mkdtemp(prefix="gateway-")
        os.chmod(self.place, 0o755)
        return pathlib.Path(self.place)

    def __exit__(self, *_):
        shutil.rmtree(self.place, ignore_errors=True)


def when(moment):
    """Seconds since 1970 of a time as the gateway says it."""
    return datetime.datetime.strptime(moment, "%Y-%m-%dT%H:%M:%S.%fZ").replace(tzinfo=datetime.timezone.utc).timestamp()


def moment(seconds):
    at = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    return at.strftime("%Y-%m-%dT%H:%M:%S.") + f"{at.microsecond // 1000:03d}Z"


class State:
    """A message of a device's values."""

    def __init__(self, message):
        said = json.loads(message.payload)
        self.message, self.values, self.seq, self.time = message, said["values"], said["seq"], when(said["time"])
        self.age = message.arrived - self.time


def states(client, device="line1/meter", since=0):
    return [State(each) for each in client.of(f"{SITE}/{device}/state") if each.arrived >= since]


def flows(client, device="line1/meter", since=None, count=1):
    """Whether values come, with a time behind `since`, or from now on."""
    since = time.time() if since is None else since
    return soon(lambda: sum(each.time >= since for each in states(client, device)) >= count, LIMIT)
