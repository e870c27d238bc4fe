# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A broker that knows MQTT 3.1.1 alone, played here: the gateway finds its protocol, and stays with it; or it is told which.

    python3 old_broker.py GATEWAY
"""
import datetime
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "tool"))
from support import runs  # noqa: E402

LIMIT = 60  # s, for what has to come
CONNECT, PUBLISH, SUBSCRIBE, UNSUBSCRIBE, PINGREQ, DISCONNECT = 1, 3, 8, 10, 12, 14
ROOT = "rtuwire/hall/g1"
DEVICE = """
[[register]]
name = "set_point"
address = 10
scale = 0.1
unit = "degC"
access = "write"
min = 5
max = 60
"""
FILE = """
site = "hall"
gateway = "g1"
state_folder = "state"
[broker]
port = {port}
{more}
[[line]]
name = "line1"
port = "sim:oven.toml:3"
[[line.device]]
name = "oven"
unit = 3
file = "oven.toml"
every = 0.2
settings = ["set_point"]
"""


class Connection:
    """One of the gateway's."""

    def __init__(self, listener):
        self.socket, _ = listener.accept()
        self.socket.settimeout(LIMIT)
        kind, _, body = self.packet()
        assert kind == CONNECT, kind
        size = int.from_bytes(body[:2], "big")
        self.level, self.published = body[2 + size], {}

    def take(self, size):
        data = b""
        while len(data) < size:
            more = self.socket.recv(size - len(data))
            if not more:
                raise EOFError("the gateway hung up")
            data += more
        return data

    def packet(self):
        head = self.take(1)[0]
        size, shift = 0, 0
        while True:
            byte = self.take(1)[0]
            size |= (byte & 127) << shift
            shift += 7
            if not byte & 128:
                return head >> 4, head & 15, self.take(size)

    def say(self, *data):
        self.socket.sendall(b"".join(data))

    def serve(self, until):
        """Answers as 3.1.1 has it, until the publications are as wanted; whether they are."""
        while not until(self.published):
            kind, flags, body = self.packet()
            if kind == SUBSCRIBE:
                self.say(b"\x90\x03", body[:2], b"\x00")
            elif kind == UNSUBSCRIBE:
                self.say(b"\xb0\x02", body[:2])
            elif kind == PINGREQ:
                self.say(b"\xd0\x00")
            elif kind == PUBLISH:
                size = int.from_bytes(body[:2], "big")
                payload = body[2 + size + (2 if flags & 6 else 0):]
                self.published.setdefault(body[2:2 + size].decode(), []).append(payload.decode())
            elif kind == DISCONNECT:
                return False
        return True

    def publish(self, topic, said, is_retained):
        topic, payload = topic.encode(), json.dumps(said).encode()
        body = len(topic).to_bytes(2, "big") + topic + payload
        assert 127 < len(body) < 16384
        self.say(bytes([PUBLISH << 4 | is_retained, len(body) & 127 | 128, len(body) >> 7]), body)


def command(value, number):
    end = datetime.datetime.now(datetime.timezone.utc) + datetime.timedelta(seconds=20)
    return {"value": value, "expires": end.strftime("%Y-%m-%dT%H:%M:%SZ"), "id": number.ljust(40, ".")}


def answers(published):
    return [json.loads(each) for each in published.get(f"{ROOT}/line1/oven/answer/set_point", [])]


def main(check, program):
    with tempfile.TemporaryDirectory(prefix="gateway-") as folder, socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(LIMIT)
        place = pathlib.Path(folder)
        (place / "oven.toml").write_text(DEVICE)
        (place / "gateway.toml").write_text(FILE.format(port=listener.getsockname()[1], more=""))
        with subprocess.Popen([os.path.abspath(program), "gateway.toml", "--write"], cwd=place, stdin=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as gateway:
            try:
                new = Connection(listener)
                check(new.level == 5, "it begins by MQTT 5", new.level)
                new.say(b"\x20\x02\x00\x01")  # unacceptable protocol version
                new.socket.close()
                for turn in range(2):
                    old = Connection(listener)
                    check(old.level == 4, f"connection {turn} behind that is by 3.1.1", old.level)
                    old.say(b"\x20\x02\x00\x00")
                    check(old.serve(lambda all_: len(all_.get(f"{ROOT}/line1/oven/state", [])) > 3), "values come")
                    check(old.published[f"{ROOT}/status"] == ["online"], "and it is online")
                    old.publish(f"{ROOT}/line1/oven/set/set_point", command(30 + turn, "kept"), True)
                    check(old.serve(answers), "what a broker kept is answered")
                    check(answers(old.published)[0]["result"] == "refused", "refused", answers(old.published))
                    old.publish(f"{ROOT}/line1/oven/set/set_point", command(20 + turn, "now"), False)
                    check(old.serve(lambda all_: len(answers(all_)) > 1), "a command is answered")
                    check(answers(old.published)[1]["result"] == "done", "done", answers(old.published))
                    if turn == 0:
                        old.socket.close()
                old = another(check, place, gateway, old)
                gateway.send_signal(signal.SIGTERM)
                check(not old.serve(lambda _: False), "it says that it ends")
                check(old.published[f"{ROOT}/status"][-1] == "offline", "offline before", old.published[f"{ROOT}/status"])
                check(gateway.wait(LIMIT) == 0, "with status 0")
            finally:
                gateway.kill()
                print(gateway.stderr.read())
        told_which(check, program, listener, place)


def another(check, place, gateway, old):
    """A reload to another broker, of which nobody knows what it knows; a connection by 3.1.1."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(LIMIT)
        (place / "gateway.toml").write_text(FILE.format(port=listener.getsockname()[1], more=""))
        gateway.send_signal(signal.SIGHUP)
        check(not old.serve(lambda _: False), "the one before is left")
        new = Connection(listener)
        check(new.level == 5, "the other one is spoken to by MQTT 5", new.level)
        new.say(b"\x20\x02\x00\x01")
        new.socket.close()
        old = Connection(listener)
        check(old.level == 4, "and then by 3.1.1", old.level)
        old.say(b"\x20\x02\x00\x00")
        check(old.serve(lambda all_: len(all_.get(f"{ROOT}/line1/oven/state", [])) > 3), "values come")
        return old


def told_which(check, program, listener, place):
    """With protocol = "3.1.1" nothing of MQTT 5 is read: neither properties, nor those that are none."""
    (place / "gateway.toml").write_text(FILE.format(port=listener.getsockname()[1], more='protocol = "3.1.1"'))
    with subprocess.Popen([os.path.abspath(program), "gateway.toml"], cwd=place, stdin=subprocess.DEVNULL) as gateway:
        try:
            old = Connection(listener)
            check(old.level == 4, "it begins by 3.1.1", old.level)
            old.say(b"\x20\x02\x00\x00", bytes.fromhex("300600016102 7f00"))
            check(old.serve(lambda all_: len(all_.get(f"{ROOT}/line1/oven/state", [])) > 3), "values come behind that")
            gateway.send_signal(signal.SIGTERM)
            check(not old.serve(lambda _: False), "it says that it ends")
            check(gateway.wait(LIMIT) == 0, "with status 0")
        finally:
            gateway.kill()


if __name__ == "__main__":
    runs(main)
