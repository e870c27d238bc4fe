# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a message of a line tells to set is there to be set: by the program that says it, in its own words. The gateway has a file,
and `serve` asks for many units.

    python3 option_words.py TOOL GATEWAY
"""
import contextlib
import json
import re
import socket
import subprocess
import sys
import threading
import time

from support import HERE, Line, Tool, runs, soon, with_crc

from field_units import OnTcp  # noqa: I100
from pair import free_port  # noqa: I100
from served import FIRST, Asker, PlainUnits, Served, message, read_of  # noqa: I100

sys.path.insert(0, str(HERE.parent / "gateway" / "process"))

from stand import Broker, Client  # noqa: E402,I100

OPTION = re.compile(r"(?<![\w-])--?[a-z][a-z-]*")
OWN = {"gateway": {"--check", "--write", "--json", "--version", "--help"}}
NOT_OF_SERVE = {"-u", "--unit", "-d", "--drive", "--device", "--any-unit", "--allow-run"}
UNIT = 7
WHOLE = 4  # answers: who it is, and first values
STATUS = 3201  # the register of a drive's status word
LIMIT = 20  # s, for what has to come


class Disturbed(PlainUnits):
    """A unit whose answers are `late`, or as they should be until so many of them were `whole`: then behind `noise`, or in their place an
    `echo`, or with another CRC. Where it `may_be_drive`, this holds of what tells that it is none, and of nothing else."""

    def __init__(self, noise=b"", late=0, echo=False, crc=False, whole=WHOLE, may_be_drive=False):
        super().__init__(UNIT, nameless=(UNIT,) if may_be_drive else ())
        self.noise, self.late, self.echo, self.crc, self.whole, self.said = noise, late, echo, crc, whole, 0
        self.may_be_drive = may_be_drive

    def say(self, data):
        self.said += 1
        is_spoilt = int.from_bytes(self.requests[-1][2:4], "big") == STATUS if self.may_be_drive else self.said > self.whole
        time.sleep(self.late)
        if is_spoilt:
            data = self.requests[-1] if self.echo else self.noise + data[:-1] + bytes([data[-1] ^ self.crc])
        super().say(data)


class Talking(Line):
    """Another client and its unit, from the beginning on."""

    def __enter__(self):
        super().__enter__()
        self.is_over = False
        self.talker = threading.Thread(target=self.talk)
        self.talker.start()
        return self

    def talk(self):
        while not self.is_over:
            self.say(with_crc(b"\x09\3\0\1\0\1"))
            time.sleep(0.05)
            self.say(with_crc(b"\x09\3\2\0\7"))
            time.sleep(0.05)

    def __exit__(self, *how):
        self.is_over = True
        self.talker.join()
        super().__exit__(*how)


class Babbling(Talking):
    """What is no frame at this rate."""

    def talk(self):
        while not self.is_over:
            self.say(b"\x55\xAA\x33")
            time.sleep(0.05)


class Server(OnTcp):
    """Modbus TCP, whose answers to reads are so late, or of another unit."""

    def __init__(self, late=0, unit=None):
        self.late, self.unit, self.said = late, unit, 0
        super().__init__("mbap")

    def talk(self, line):
        while data := line.recv(512):
            if data[7] == 43:
                line.sendall(message(int.from_bytes(data[:2], "big"), data[6], bytes.fromhex("2b0e010100000300054d616b657201054d657465720203312e30")))
            elif data[7] in (3, 4):
                is_spoilt = self.said > WHOLE
                time.sleep(self.late if is_spoilt else 0)
                count = int.from_bytes(data[10:12], "big")
                self.said += 1
                line.sendall(message(int.from_bytes(data[:2], "big"), (is_spoilt and self.unit) or data[6], bytes([data[7], 2 * count]) + bytes(2 * count)))


@contextlib.contextmanager
def on(line):
    with line as it:
        yield it.name


@contextlib.contextmanager
def at(port):
    yield port


ECHOES = ("line1: meter: no response in time; not asked: a late answer of this unit could be taken for this one; a longer timeout waits for it; "
          "the line echoes (say echo = ")
# What is wrong with a line; how it is set; what each of both programs says of it, and may not say.
CASES = (
    ("nobody at this address", lambda: at(f"sim:atv320:{UNIT + 1}"), {}, f"no unit {UNIT}, only {UNIT + 1}: say unit = {UNIT + 1}",
     f"no unit {UNIT}, only {UNIT + 1}"),
    ("an echo", lambda: on(Disturbed(echo=True)), {}, "(say echo = true, or switch", None),
    ("noise", lambda: on(Disturbed(noise=b"\xFF\xFE")), {}, "of a whole frame, as a driver makes that is switched", None),
    ("late answers", lambda: on(Disturbed(late=0.5)), {"timeout": 0.1}, " s: say timeout = ", None),
    ("others talk", lambda: on(Talking()), {"listen": 1.0}, "speak all the same, say listen = 0", "speak all the same, say --no-listen"),
    ("others talk at another rate", lambda: on(Babbling()), {"listen": 1.0}, "no frame at this bit rate and format.", "sniff --find"),
    ("late answers over Modbus TCP", lambda: on(Server(late=0.5)), {"timeout": 0.1}, " s: say timeout = ", None),
    ("another unit over Modbus TCP", lambda: on(Server(unit=255)), {}, "came of unit 255 and was dropped", None),
    ("no serial device", lambda: at("tcp://127.0.0.1:1"), {"rs485": True}, "rs485: tcp://127.0.0.1:1 is no serial device", "--rs485: tcp://"),
    ("an echo from the beginning", lambda: on(Disturbed(echo=True, whole=0)), {}, ECHOES, None),
    ("noise from the beginning", lambda: on(Disturbed(noise=b"\xFF\xFE", whole=0)), {}, "line1: meter: CRC mismatch: 9 bytes came: FF FE ", None),
    ("a wrong CRC from the beginning", lambda: on(Disturbed(crc=True, whole=0)), {}, "line1: meter: CRC mismatch: ", None),
    ("an echo later", lambda: on(Disturbed(echo=True)), {}, ECHOES, None),
    ("noise later", lambda: on(Disturbed(noise=b"\xFF\xFE")), {}, "line1: meter: CRC mismatch: 9 bytes came: FF FE ", None),
    ("a wrong CRC later", lambda: on(Disturbed(crc=True)), {}, "line1: meter: CRC mismatch: ", None),
    ("noise where it would tell that it is no drive", lambda: on(Disturbed(noise=b"\xFF\xFE", may_be_drive=True)), {},
     "line1: meter: CRC mismatch: 7 bytes came: FF FE ", None),
)


def text_of(port, how, broker=1):
    said = ['site = "s"', 'gateway = "g"', 'state_folder = "state"', "[broker]", f"port = {broker}", "[[line]]", 'name = "line1"']
    how = {"port": port, "timeout": 0.2, "retries": 0, "listen": 0, **how}
    said += [f"{name} = {json.dumps(value)}" for name, value in how.items()]
    said += ["[[line.device]]", 'name = "meter"', f"unit = {UNIT}", 'file = "meter.toml"', "every = 0.5"]
    return "\n".join(said) + "\n"


def said_by_gateway(tool, gateway, port, how, wanted):
    """All that it says, and publishes, until the wanted words have come, or it has ended."""
    errors = tool.place / "errors"
    with Broker(tool.place) as broker, Client(broker.port, "rtuwire/#") as client, open(errors, "wb") as to:
        (tool.place / "gateway.toml").write_text(text_of(port, how, broker.port), encoding="utf-8")

        def said():
            return errors.read_text(errors="replace") + "\n".join(f"{each.topic}: {each.payload}" for each in list(client.messages))
        with subprocess.Popen([gateway, "gateway.toml"], cwd=tool.place, stdin=subprocess.DEVNULL, stdout=to, stderr=to, env=tool.environment) as process:
            soon(lambda: wanted in said() or process.poll() is not None, LIMIT)
            process.kill()
        return said()


def check_gateway(tool, gateway, check):
    for what, line, how, wanted, _ in CASES:
        with line() as port:
            said = said_by_gateway(tool, gateway, port, how, wanted)
        check(wanted in said, f"gateway, {what}: {wanted}", said)
        check(set(OPTION.findall(said)) <= OWN["gateway"], f"gateway, {what}: no option that it does not have", said)
    for words, wanted in (('settings = ["CMD"]', "commands the motor"), ('settings = ["SLL"]', "SLL cannot be a setting")):
        (tool.place / "gateway.toml").write_text(
            text_of("sim:atv320:7", {}).replace('file = "meter.toml"', 'drive = "atv320"\nfeeds_supervision = true\n' + words), encoding="utf-8")
        ended = subprocess.run([gateway, "--check", "gateway.toml"], cwd=tool.place, env=tool.environment, capture_output=True, text=True, check=False)
        check(wanted in ended.stderr, f"gateway, {words}", ended.stderr)
        shown = re.sub(r"`[^`]*`", "", ended.stderr)  # a command of the tool has its own
        check(set(OPTION.findall(shown)) <= OWN["gateway"], f"gateway, {words}: no option that it does not have", ended.stderr)
        check("CMD" not in words or "`rtuwire -p sim:atv320:7 -u 7 stop`" in ended.stderr, "what stops the motor is shown with its port and unit", ended.stderr)


# What a client of a line sends, what `serve` says of that, and what the gateway does of its own clients.
CLIENTS = (
    ("an address that is not let in", None, {"from": ["127.0.0.9"]}, "is none of --from, and", "is none of from, and"),
    ("RTU frames at Modbus TCP", with_crc(bytes((UNIT, 3, 0, 1, 0, 1))), {}, "what it sends is for --listen tcp://ADDRESS:PORT",
     'what it sends is for listen = "tcp://ADDRESS:PORT"'),
    ("another unit", message(1, UNIT + 1, read_of(FIRST)), {}, "is not served: --units does not name it", "is not served: units does not name it"),
    ("all units", message(1, 0, bytes((6, 0, 1, 0, 1))), {}, "all units of the line: that takes --allow-broadcast and --write", "all units of the line\n"),
    ("a write", message(1, UNIT, bytes((6, 0, 1, 0, 1))), {}, "only reads pass; say --write", "only reads pass\n"),
)


def sends(number, data):
    """A client that waits for what becomes of that, at most a while."""
    with socket.create_connection(("127.0.0.1", number), LIMIT) as line:
        line.settimeout(1)
        with contextlib.suppress(OSError):
            line.sendall(data or b"")
            line.recv(512)


def text_with(serve):
    keys = "".join(f"{name} = {json.dumps(value)}\n" for name, value in serve.items())
    return text_of(f"sim:meter.toml:{UNIT}", {}).replace("[[line.device]]", f"[line.serve]\n{keys}[[line.device]]")


def check_clients(tool, program, gateway, check):
    for what, data, how, _, wanted in CLIENTS:
        number = free_port()
        (tool.place / "clients.toml").write_text(
            text_with({"listen": f"mbap://127.0.0.1:{number}", "units": str(UNIT), **how}), encoding="utf-8")
        with open(tool.place / "errors", "w+b") as to, subprocess.Popen(
                [gateway, "clients.toml"], cwd=tool.place, stdin=subprocess.DEVNULL, stdout=to, stderr=to, env=tool.environment) as process:
            def said(place=tool.place / "errors"):
                return place.read_text(errors="replace")
            check(soon(lambda: f"clients may read units {UNIT} at" in said(), LIMIT), f"gateway, a client, {what}: it listens", said())
            sends(number, data)
            soon(lambda: wanted in said(), LIMIT)
            process.kill()
        check(wanted in said(), f"gateway, a client, {what}: {wanted}", said())
        check(set(OPTION.findall(said())) <= OWN["gateway"], f"gateway, a client, {what}: no option that it does not have", said())
    for what, data, how, wanted, _ in CLIENTS:
        options = [part for each in how.get("from", ()) for part in ("--from", each)]
        with Served(program, f"sim:atv320:{UNIT}", "--units", str(UNIT), *options) as served:
            sends(served.number, data)
            check(soon(lambda: any(wanted in each for each in served.said()), LIMIT), f"serve, a client, {what}: {wanted}", served.said())
    for key, value, wanted in (("listen", "nowhere", ": listen: "), ("from", ["10.0.0.1/8"], "from 10.0.0.1/8: it is an address")):
        (tool.place / "gateway.toml").write_text(text_with({"units": str(UNIT), key: value}), encoding="utf-8")
        ended = subprocess.run([gateway, "--check", "gateway.toml"], cwd=tool.place, env=tool.environment, capture_output=True, text=True, check=False)
        check(ended.returncode == 2 and wanted in ended.stderr and set(OPTION.findall(ended.stderr)) <= OWN["gateway"],
              f"gateway, {key} that is wrong: its own word", ended.stderr)


def check_serve(tool, program, check):
    for what, line, how, _, wanted in CASES:
        if wanted is None:
            continue
        options = ["--timeout", 0.2, "--retries", 0, *(["--rs485"] if "rs485" in how else [])]
        with line() as port:
            if "listen" in how or "rs485" in how:
                ended = tool.run(*options, "serve", "--listen", "mbap://127.0.0.1:0", "--for", "1s", port=port)
                said = ended.errors
            else:
                with Served(program, port, "--units", str(UNIT), line=options) as served, Asker(served.number) as client:
                    soon(lambda: client.ask(UNIT, read_of(FIRST)) and any(wanted in each for each in served.said()), LIMIT)
                    said = "\n".join(served.said())
        check(wanted in said, f"serve, {what}: {wanted}", said)
        check(not set(OPTION.findall(said)) & NOT_OF_SERVE, f"serve, {what}: no option that it does not have", said)


def check_forms(tool, check):
    """The same lines asked by a command name its options."""
    for what, line, how, _, _ in CASES[1:4]:
        with line() as port:
            options = ["--no-listen", "--retries", 0, "--timeout", how.get("timeout", 0.2), "-u", UNIT, "-d", "none", "--json"]
            ended = tool.run(*options, "watch", str(FIRST), "--every", "50ms", "--for", "3s", port=port)
        wanted = {"an echo": "--echo", "noise": "--noise 2", "late answers": "--timeout"}[what]
        check(wanted in ended.errors + ended.output, f"read, {what}: {wanted}", ended)


def main(check, program, gateway):
    with Tool(program) as tool:
        (tool.place / "meter.toml").write_text('[[register]]\nname = "level"\naddress = 1000\n', encoding="utf-8")
        (tool.place / "state").mkdir(exist_ok=True)
        check_gateway(tool, gateway, check)
        check_serve(tool, program, check)
        check_clients(tool, program, gateway, check)
        check_forms(tool, check)


runs(main)
