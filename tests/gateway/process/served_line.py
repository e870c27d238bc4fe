# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line that `rtuwire serve` owns, and the gateway as one of its clients: two simulated drives and a meter behind one adapter are read
and set from MQTT while others ask them by Modbus TCP; serve begins again, the adapter is pulled.

    python3 served_line.py GATEWAY TOOL together|restarted|unplugged
"""
import threading
import time

from devices import Changes, Linked
from stand import LIMIT, METER, SITE, Broker, Client, Folder, Gateway, a_line, a_meter, flows, runs, soon, states, text_of
from setting import Asking  # noqa: I100

from pair import free_port  # noqa: I100
from served import Asker, Served  # noqa: I100

METER_UNIT, FAN, PUMP = 3, 7, 8
DEVICES = ("line1/meter", "line1/fan", "line1/pump")


class Stand:
    """with Stand(program, tool) as stand: broker, drives and meter, `serve`, gateway; each value flows."""

    def __init__(self, program, tool):
        self.program, self.tool, self.parts = program, tool, []

    def take(self, part):
        self.parts.append(part)
        return part.__enter__()

    def __enter__(self):
        self.folder = self.take(Folder())
        (self.folder / "meter.toml").write_text(METER, encoding="utf-8")
        self.broker, self.number = self.take(Broker(self.folder)), free_port()
        self.client, self.link = self.take(Client(self.broker.port, "rtuwire/#")), self.folder / "usb-adapter"
        self.line = None
        self.plug_in()
        self.serve()
        drive = {"registers": ["RFR", "ITH"], "feeds_supervision": True, "every": 0.5}
        devices = [a_meter(registers=["voltage", "set_point"], settings=["set_point"]),
                   {"name": "fan", "unit": FAN, "drive": "atv320", "settings": ["ITH"], **drive},
                   {"name": "pump", "unit": PUMP, "drive": "atv12", **drive}]
        line = a_line(f"mbap://127.0.0.1:{self.number}", *devices, timeout=1.0)
        self.gateway = self.take(Gateway(self.program, self.folder, text_of(self.broker.port, [line]), "--write"))
        return self

    def plug_in(self):
        self.line = Linked(self.tool, self.link, f"{self.folder}/meter.toml:{METER_UNIT}", f"atv320:{FAN}", f"atv12:{PUMP}")
        self.line.__enter__()

    def pull_out(self):
        self.line.__exit__()
        self.line = None

    def serve(self):
        self.served = Served(self.tool, str(self.link), "--units", f"{METER_UNIT},{FAN},{PUMP}", "--write",
                             "--listen", f"mbap://127.0.0.1:{self.number}", line=("-b", 38400, "--timeout", 0.2, "--retries", 1))
        self.served.__enter__()

    def end_serve(self):
        self.served.__exit__()

    def __exit__(self, *how):
        for each in reversed(self.parts):
            each.__exit__(*how)
        self.end_serve()
        if self.line:
            self.pull_out()

    def all_flow(self, since=None):
        return all(flows(self.client, each, since) for each in DEVICES)


class Others:
    """with Others(stand) as others: two other clients that never cease to ask the meter and a drive."""

    def __init__(self, stand):
        self.number, self.is_over, self.wrong, self.counts = stand.number, False, [], [0, 0]
        self.threads = [threading.Thread(target=self.asks, args=each) for each in ((0, METER_UNIT, 10), (1, FAN, 8501))]

    def asks(self, which, unit, address):
        with Asker(self.number) as client:
            while not self.is_over:
                values = client.read(unit, address)
                self.counts[which] += 1
                if not isinstance(values, list) or (unit == FAN and values != [0]):
                    self.wrong.append((unit, values))

    def __enter__(self):
        for each in self.threads:
            each.start()
        return self

    def __exit__(self, *_):
        self.is_over = True
        for each in self.threads:
            each.join(LIMIT)


def together(check, program, tool):
    """Read and set from MQTT, beside other clients."""
    with Stand(program, tool) as stand:
        check(stand.all_flow(), "the values of the meter and of both drives come")
        said = {each: stand.client.last(f"{SITE}/{each}/availability") for each in DEVICES}
        check(set(said.values()) == {"online"}, "they are online", said)
        with Others(stand) as others:
            check(soon(lambda: min(others.counts) > 5), "two other clients ask at once")
            began = time.time()
            ask = Asking(check, stand.client)
            ask.expect("set_point", 22.5, ("done",), "a setting of the meter")
            ask.expect("set_point", 90, ("refused",), "one beyond the limits of its file")
            check(soon(lambda: states(stand.client)[-1].values["set_point"]["value"] == 22.5), "is read back")
            ask = Asking(check, stand.client, "line1/fan")
            ask.expect("ITH", 5.0, ("done",), "a setting of a drive")
            check(soon(lambda: states(stand.client, "line1/fan")[-1].values["ITH"]["value"] == 5.0), "is read back")
            check(all(flows(stand.client, each, began, 8) for each in DEVICES), "values go on")
            for each in DEVICES:
                got = [one.time for one in states(stand.client, each, began)]
                gaps = sorted(after - before for before, after in zip(got, got[1:]) if after > before)
                check(gaps[len(gaps) // 2] < 0.8, f"{each}: at their period of 0.5 s", [round(gap, 2) for gap in gaps])
            before = list(others.counts)
            check(soon(lambda: all(now > then for now, then in zip(others.counts, before))), "the others go on, too")
        check(not others.wrong, "and get their own answers", others.wrong[:3])
        rows = stand.served.noted()
        check([each[3:5] for each in rows if "127.0.0.1" in each[6]] == [[str(METER_UNIT), "10"], [str(FAN), "ITH"]],
              "what the gateway wrote is noted by serve, once each", rows)
        check(stand.gateway.end() == 0, "the gateway ends")


def restarted(check, program, tool):
    """serve ends, and is there again."""
    with Stand(program, tool) as stand:
        check(stand.all_flow(), "values come")
        changes = Changes(check, stand.client)
        for turn in range(2):
            gone = time.time()
            stand.end_serve()
            changes.says("line1/availability", "offline", gone, f"ended, turn {turn}")
            check(not [each for each in states(stand.client, since=gone) if each.time > gone + 1], "nothing is told as fresh")
            back = time.time()
            stand.serve()
            changes.says("line1/availability", "online", back, f"begun again, turn {turn}")
            check(stand.all_flow(back), "all values come")
            for each in DEVICES:
                check(soon(lambda it=each: stand.client.last(f"{SITE}/{it}/availability") == "online", LIMIT), f"{each} is online")
        changes.judge()
        check(stand.gateway.process.poll() is None, "the gateway is the same")


def unplugged(check, program, tool):
    """The adapter is pulled out and put in; other clients stay connected."""
    with Stand(program, tool) as stand, Asker(stand.number) as other:
        check(stand.all_flow(), "values come")
        changes = Changes(check, stand.client)
        for turn in range(2):
            gone = time.time()
            stand.pull_out()
            for each in DEVICES:
                changes.says(f"{each}/availability", "offline", gone, f"out, turn {turn}")
            check(stand.client.last(f"{SITE}/line1/availability") == "online", "serve is there, which is the gateway's port")
            check(other.read(METER_UNIT, 10) == -11, "another client is answered 0B")
            told = [each for device in DEVICES for each in states(stand.client, device, gone + 1)
                    for value in each.values.values() if value.get("value") is not None and not value.get("stale") and each.time > gone + 1]
            check(not told, "no value is told as fresh", [each.message for each in told[:2]])
            back = time.time()
            stand.plug_in()
            for each in DEVICES:
                changes.says(f"{each}/availability", "online", back, f"in, turn {turn}")
            check(stand.all_flow(back), "all values come")
            check(soon(lambda: isinstance(other.read(METER_UNIT, 10), list), LIMIT), "and the other client gets its own again")
        changes.judge()


def main(check, program, tool, part, *more):
    {"together": together, "restarted": restarted, "unplugged": unplugged}[part](check, program, tool, *more)


runs(main)
