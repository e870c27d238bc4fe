# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Devices that fall silent, come back or are replaced, and an adapter that is pulled out: what the gateway says of each, how
soon, and that no old value is told as a new one.

    python3 devices.py GATEWAY TOOL silent|usual|waited|late|divided|met|joined|beside|overtaken|one_function|rested|repeated|pulled|replaced|unnamed|many
"""
import contextlib
import json
import os
import subprocess
import threading
import time

from stand import (LIMIT, METER, SITE, Broker, Client, Folder, Gateway, Simulator, Units, a_line, a_meter, flows, meter, runs, soon,
                   states, text_of, with_crc)

SOON = 3  # s, in which each change is said


class Changes:
    """How long a topic took to say something, over several tries: on a machine that is busy the shortest counts."""

    def __init__(self, check, client):
        self.check, self.client, self.took = check, client, {}

    def says(self, topic, word, since, what):
        def said():
            found = [each for each in self.client.of(f"{SITE}/{topic}") if each.arrived >= since]
            return found and found[-1].payload.decode() == word
        self.check(soon(said, LIMIT), f"{what}: {topic} says {word}", self.client.last(f"{SITE}/{topic}"))
        found = [each for each in self.client.of(f"{SITE}/{topic}") if each.arrived >= since and each.payload.decode() == word]
        if found:
            self.took.setdefault((topic, word), []).append(found[0].arrived - since)

    def judge(self, limit=SOON):
        for (topic, word), took in self.took.items():
            self.check(min(took) <= limit, f"{topic}: {word} within {limit} s", [round(each, 2) for each in took])


def silent(check, program, _):
    """One of three, twice; the others notice nothing, and nothing of it is told as new."""
    units = {1: meter(), 2: meter(), 3: meter()}
    devices = [a_meter(f"meter{unit}", unit, every=0.5, registers=["voltage", "power"]) for unit in units]
    with Folder() as folder, Broker(folder) as broker, Units(units) as line, Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices)])) as gateway:
            check(all(flows(client, f"line1/meter{unit}") for unit in units), "values come of all")
            changes = Changes(check, client)
            for turn in range(2):
                line.silent = {2}
                since = time.time()
                changes.says("line1/meter2/availability", "offline", since, f"turn {turn}")
                check(client.last(f"{SITE}/line1/availability") == "online", "the line is there")
                went = time.time()
                check(flows(client, "line1/meter1", went, 4), "the others go on")
                told = [each for each in states(client, "line1/meter2", went) for value in each.values.values()
                        if value.get("value") is not None and not value.get("stale") and not value.get("invalid")]
                check(not told, "a silent device's values are not told as fresh", [each.message for each in told[:2]])
                line.silent = set()
                since = time.time()
                changes.says("line1/meter2/availability", "online", since, f"turn {turn}")
                check(flows(client, "line1/meter2", since), "its values come again")
            for unit in (1, 3):
                said = [each.payload for each in client.of(f"{SITE}/line1/meter{unit}/availability")]
                check(set(said[said.index(b"online"):]) == {b"online"}, f"of meter{unit} nothing else was said", said)
            changes.judge()
            said = gateway.said()
            check("meter2" in said and said.count("meter2") < 20, "each change is one line for people", said.count("meter2"))
            # What a silent one costs the others: the rounds of their period, by the median.
            line.silent = {2}
            began = time.time()
            check(flows(client, "line1/meter1", began + 2, 12), "they go on")
            got = [each.time for each in states(client, "line1/meter1", began + 2)]
            gaps = sorted(after - each for each, after in zip(got, got[1:]))
            check(gaps[len(gaps) // 2] < 0.8, "at their period of 0.5 s", [round(each, 2) for each in gaps])


class Leaving(Units):
    """Units that say nothing to function 43, of which one, `leaves`, answers once more and then no more."""

    leaves, left = None, 0

    def answer(self, request):
        if request[1] == 43:
            return None
        found = super().answer(request)
        if found and request[0] == self.leaves and request[1] == 4:
            self.silent, self.leaves, self.left = {request[0]}, None, time.time()
        return found


def usual(check, program, _):
    """The same with all that a file need not say, and each second: the first of three, while another one has gone for good; one
    that goes between two requests of a reading."""
    units = {unit: meter() for unit in (1, 2, 3)}
    devices = [a_meter(f"meter{unit}", unit, every=1.0, registers=["voltage", "energy", "set_point", "mode"]) for unit in units]
    with Folder() as folder, Broker(folder) as broker, Leaving(units) as line, Client(broker.port, "rtuwire/#") as client:
        the_line = a_line(line.name, *devices, timeout=None, retries=None)
        with Gateway(program, folder, text_of(broker.port, [the_line])):
            check(all(flows(client, f"line1/meter{unit}") for unit in units), "values come of all")
            changes = Changes(check, client)
            changes_of_other = Changes(check, client)
            line.silent = {3}
            changes.says("line1/meter3/availability", "offline", time.time(), "alone")
            for turn in range(2):
                line.silent = {1, 3}
                changes.says("line1/meter1/availability", "offline", time.time(), f"turn {turn}")
                line.silent = {3}
                changes_of_other.says("line1/meter1/availability", "online", time.time(), f"turn {turn}")
                check(flows(client, "line1/meter1"), "its values come again")
            line.silent = set()
            changes_of_other.says("line1/meter3/availability", "online", time.time(), "the other")
            for turn in range(2):
                line.leaves = 2
                check(soon(lambda: line.leaves is None, LIMIT), "it answers once more")
                changes.says("line1/meter2/availability", "offline", line.left, f"while it is read, turn {turn}")
                line.silent = set()
                changes.says("line1/meter2/availability", "online", time.time(), f"alone, turn {turn}")
            changes.judge()
            changes_of_other.judge(2 * SOON)


def waited(check, program, _):
    """A line that waits for 4 s for each response is there all the same."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        the_line = a_line(line.name, a_meter(registers=["voltage"]), timeout=4.0, retries=0)
        with Gateway(program, folder, text_of(broker.port, [the_line])):
            check(flows(client), "values come")
            line.silent, since = {3}, time.time()
            check(soon(lambda: client.last(f"{SITE}/line1/meter/availability") == "offline", LIMIT), "a device is silent")
            said = [each.payload for each in client.of(f"{SITE}/line1/availability") if each.arrived >= since]
            check(not said, "and its line has not gone", said)
            beats = [each for each in client.of(f"{SITE}/line1/status") if each.arrived >= since]
            check(len(beats) >= 5, "it has shown that it runs", len(beats))


class Late(Units):
    """Units whose answers leave later than the client waits, in their order."""

    delay = 0

    def say(self, data):
        if not self.delay:
            return super().say(data)
        threading.Timer(self.delay, super().say, [data]).start()


def late(check, program, _):
    """A device that answers a little too late is told of, with what would help."""
    with Folder() as folder, Broker(folder) as broker, Late({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        devices = [a_meter(registers=["voltage"]), a_meter("other", 4, registers=["voltage"])]
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])) as gateway:
            check(flows(client) and flows(client, "line1/other"), "values come")
            line.delay = 0.55
            check(soon(lambda: "its answers come too late, the last after " in gateway.said(), LIMIT), "that is told", gateway.said())
            check("say timeout = " in gateway.said() and "longer periods" not in gateway.said(), "with the key that helps", gateway.said())
            line.delay = 0


class OneLate(Units):
    """Units of which one answers later than the client waits."""

    late, delay = None, 0.55
    identity = None  # (vendor, product) that they say

    def __init__(self, units):
        super().__init__(units)
        self.due = []

    def __exit__(self, *how):
        for each in self.due:  # before the number of its line is another's
            each.cancel()
            each.join()
        super().__exit__(*how)

    def answer(self, request):
        found = super().answer(request)
        if self.identity and request[1] == 43:
            objects = b"".join(bytes([i, len(each)]) + each for i, each in enumerate((*self.identity, b"1.0")))
            found = bytes([request[0], 43, 14, 1, 1, 0, 0, 3]) + objects
        if found and request[0] == self.late:
            self.due.append(threading.Timer(self.delay, self.say, [with_crc(found)]))
            self.due[-1].start()
            return None
        return found


def turns_between(requests, one, other):
    """How often `other` was asked behind a request of `one`, and how often `one` itself something else."""
    order = [each for each, after in zip(requests, requests[1:]) if each != after]
    behind = [after[0] for each, after in zip(order, order[1:]) if each[0] == one]
    return behind.count(other), behind.count(one)


def divided(check, program, _):
    """A device whose responses come too late is not read at a stretch: another one that is due has its turn in between."""
    names = ["voltage", "set_point"]  # of two functions
    with Folder() as folder, Broker(folder) as broker, OneLate({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        devices = [a_meter(registers=names), a_meter("other", 4, registers=["voltage"])]
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])):
            check(flows(client) and flows(client, "line1/other"), "values come")
            line.late, since, before = 3, time.time(), len(line.requests)
            check(soon(lambda: len(line.requests) > before + 60, LIMIT), "it goes on")
            order = [request[:2] for _, request in line.requests[before:]]
            other, itself = turns_between(order, 3, 4)
            check(other > 3 * itself, "each of its requests is a turn", order)
            for name in names:
                told = [each.values[name].get("value") for each in states(client, since=since) if name in each.values]
                check(len([each for each in told if each is not None]) > 3, f"{name} comes", told)
            said = [each.payload for each in client.of(f"{SITE}/line1/meter/availability") if each.arrived >= since]
            check(not said, "and it is there", said)


def met(check, program, _):
    """A device whose responses come too late from the start on: what it is asked until its values count, each time where it says who
    it is, is no stretch, either."""
    for identity in (None, (b"Maker", b"Meter")):
        with Folder() as folder, Broker(folder) as broker, OneLate({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
            line.late, line.identity = 3, identity
            (folder / "late.toml").write_text(('[device]\nvendor = "Maker"\nproduct = "Meter"\n' if identity else "") + METER, encoding="utf-8")
            devices = [a_meter(registers=["voltage"], file="late.toml"), a_meter("other", 4, registers=["voltage"], every=0.2)]
            with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])):
                check(flows(client), "values of the late one come")
                asked = [each for _, each in line.requests]
                other, itself = turns_between(asked, 3, 4)
                check(other > 3 * itself, "each of the requests by which it is met is a turn", asked)
                since, before = time.time(), len(line.requests)
                check(flows(client, count=3), "and go on")
                other, itself = turns_between([each for _, each in line.requests[before:]], 3, 4)
                check(other > 3 * itself, "and so each later one", line.requests[before:])
                told = [each.values["voltage"]["value"] for each in states(client, since=since)]
                check(set(told) == {230.1}, "each is its own", told)


class ExchangedInTurns(OneLate):
    """Unit 3 goes when it is first looked at for the status word of a drive: the next one in its place has one, and the voltage 999.9 V."""

    late, is_gone, is_other = 3, False, False
    OTHER = {0: 9999, 0x6040: 0, 0x6041: 0x0250}

    def answer(self, request):
        if request[0] == 3 and not self.is_other:
            if request[1:4] == b"\3\x60\x41":
                self.is_gone = True
                return None
            if self.is_gone:
                self.is_other = True
                self.units[3].update(self.OTHER)
        return super().answer(request)


def joined(check, program, _):
    """A late device that is exchanged for a drive while it is asked, in turns, who it is: what the one said is not taken for the other."""
    with Folder() as folder, Broker(folder) as broker, ExchangedInTurns({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        devices = [a_meter(registers=["voltage"]), a_meter("other", 4, registers=["voltage"])]
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])) as gateway:
            check(soon(lambda: line.is_gone, LIMIT), "it goes")
            check(soon(lambda: "may be a drive" in gateway.said() or states(client), LIMIT), "another one comes")
            check(flows(client, "line1/other", count=10), "values of others go on")
            check("reading it feeds its supervision" in gateway.said(), "it is found to be a drive", gateway.said())
            check(not [each for each in states(client) if each.values.get("voltage", {}).get("value")], "and not read", states(client))


class AllLate(OneLate):
    """Units of which all but unit 3 are late."""

    def answer(self, request):
        self.late = request[0] if request[0] != 3 else None
        return super().answer(request)


def beside(check, program, _):
    """Four devices whose responses come too late cost another one a turn of each, and no time in which they owe an answer."""
    units = {unit: meter() for unit in range(3, 8)}
    with Folder() as folder, Broker(folder) as broker, AllLate(units) as line, Client(broker.port, "rtuwire/#") as client:
        devices = [a_meter(f"meter{unit}", unit, registers=["voltage"], every=0.2) for unit in units]
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])):
            check(all(flows(client, f"line1/meter{unit}") for unit in units), "values come")
            since = time.time()
            check(flows(client, "line1/meter3", since, 15), "and go on")
            got = [each.time for each in states(client, "line1/meter3", since)]
            gaps = sorted(after - each for each, after in zip(got, got[1:]))
            # A turn takes a little longer than its answer.
            check(gaps[len(gaps) // 4] < 5 * line.delay, "a turn of each apart", [round(each, 2) for each in gaps])


class Overtaking(Units):
    """A unit that answers for its slow register 0 out of order: LATEST s behind the request, while nothing is asked; or, where it `crosses`,
    earlier, in the place of the answer for register 20, which follows."""

    LATEST = 1.7
    crosses = False

    def __init__(self, units):
        super().__init__(units)
        self.held, self.guard = [], threading.RLock()

    def answer(self, request):
        found = super().answer(request)
        if request[1] != 4 or not found:
            return found
        with self.guard:
            if request[3] == 0:
                self.held.append([with_crc(found)])
                threading.Timer(self.LATEST, self.release, self.held[-1:]).start()
                return None
            if self.crosses and self.held:
                self.release(self.held[0])
                time.sleep(0.05)
        return found

    def release(self, which):
        with self.guard:
            if any(each is which for each in self.held):
                self.held = [each for each in self.held if each is not which]
                self.say(which[0])


def overtaken(check, program, _):
    """A unit whose answers overtook each other while nothing was asked: no value of it is another register's, when they do so later."""
    names = {"quick": 20, "slow": 0}
    with Folder() as folder, Broker(folder) as broker, Overtaking({3: {0: 11111, 20: 222, 40: 3}}) as line, Client(broker.port, "rtuwire/#") as client:
        (folder / "two.toml").write_text("".join(f'[[register]]\nname = "{name}"\nspace = "input"\naddress = {at}\n' for name, at in names.items()),
                                         encoding="utf-8")
        device = {"name": "meter", "unit": 3, "file": "two.toml", "every": 1.0}
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, device, timeout=0.3, retries=0)])):
            def told(name):
                return [each.values[name]["value"] for each in states(client) if each.values.get(name, {}).get("value") is not None]
            check(soon(lambda: len([each for each in line.requests if each[1][1:4] == b"\4\0\0"]) > 3, LIMIT), "it is read")
            line.crosses = True
            count = len(line.requests)
            check(soon(lambda: len(line.requests) > count + 20, LIMIT), "and goes on to be")
            check(set(told("slow")) <= {11111} and set(told("quick")) <= {222}, "no value is another register's", (told("slow"), told("quick")))
            check(told("quick"), "the quick one comes")


class LateByOne(OneLate):
    """Units of which one is late with what it is asked by function 3, and with nothing else."""

    def answer(self, request):
        self.late = 3 if request[1] == 3 else None
        return super().answer(request)


def one_function(check, program, _):
    """A unit that is late by one function alone, by little or by much: each value is one of its own register."""
    registers = {"first": 10, "second": 500, "third": 1200}
    file = "".join(f'[[register]]\nname = "{name}"\naddress = {at}\n' for name, at in registers.items())
    device = {"name": "meter", "unit": 3, "file": "far.toml", "every": 1.0, "groups": '[{ registers = ["third"], every = 2.0 }]'}
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(Folder())
        broker = stack.enter_context(Broker(folder))
        client = stack.enter_context(Client(broker.port, "rtuwire/#"))
        (folder / "far.toml").write_text(file, encoding="utf-8")
        stands = {}
        for delay in (0.9, 1.2, 1.5, 1.6, 1.7):
            stands[delay] = stack.enter_context(LateByOne({3: {at: at for at in registers.values()}}))
            stands[delay].delay, stands[delay].identity = delay, (b"Maker", b"Meter")
        lines = [a_line(line.name, device, timeout=0.5, name=f"line{number}") for number, line in enumerate(stands.values())]
        stack.enter_context(Gateway(program, folder, text_of(broker.port, lines)))

        def told(number, name):
            values = [each.values.get(name, {}).get("value") for each in states(client, f"line{number}/meter")]
            return [each for each in values if each is not None]
        check(soon(lambda: min(len(told(0, each)) for each in registers) > 1, LIMIT), "what is a little late comes", {each: told(0, each) for each in registers})
        check(soon(lambda: len(stands[0.9].requests) > 45, LIMIT), "for a while", [len(line.requests) for line in stands.values()])
        for number, delay in enumerate(stands):
            found = {name: told(number, name) for name in registers}
            check(all(set(found[name]) <= {at} for name, at in registers.items()), f"{delay} s late: each value is its own", found)


class LateTwice(OneLate):
    """Units of which one is late with `left` answers by function 4, and not with what it is asked behind that."""

    delay, left = 1.5, 0

    def answer(self, request):
        self.late = 3 if self.left and request[:2] == b"\3\4" else None
        self.left -= self.late is not None
        return super().answer(request)


def rested(check, program, _):
    """A unit whose late answers come when it has answered others is not asked until all that it owes may have come. It is there."""
    with Folder() as folder, Broker(folder) as broker, LateTwice({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        the_line = a_line(line.name, a_meter(registers=["voltage", "set_point"]), timeout=0.5)
        with Gateway(program, folder, text_of(broker.port, [the_line])) as gateway:
            check(flows(client), "values come")
            for turn in range(2):
                line.left, since = 2, time.time()
                check(soon(lambda: not line.left, LIMIT), "it is late")
                check(flows(client, since=time.time() + line.delay, count=2), "values come again")
                said = [each.payload for each in client.of(f"{SITE}/line1/meter/availability") if each.arrived >= since]
                check(not said, f"turn {turn}: it is there all the time", said)
            check("longer periods" not in gateway.said(), "and its period is not to blame", gateway.said())


class Repeating(Units):
    """Units whose line says responses again: `how` is doubled, late or foreign. A voltage is another number each time, 10000 more
    of unit 4."""

    def __init__(self, units):
        super().__init__(units)
        self.how, self.said_before, self.repeated, self.asked = None, {}, 0, 0

    def answer(self, request):
        if request[1] == 4:
            self.asked += 1
            self.units[request[0]][0] = self.asked + 10000 * (request[0] == 4)
        found = super().answer(request)
        if found:
            self.disturb(found)
        return found

    def disturb(self, found):
        before, self.said_before[found[0]] = self.said_before.get(7 - found[0]), found
        if self.how == "doubled":
            self.say(with_crc(found))
        elif self.how == "late":
            threading.Timer(0.05, self.say, (with_crc(found),)).start()
        elif self.how == "foreign" and before:
            self.say(with_crc(before))
            time.sleep(0.02)
        self.repeated += self.how is not None


def repeated(check, program, _):
    """Responses that a line says again: none of them is another value's, or a newer one."""
    units = {3: meter(), 4: meter()}
    names = ["voltage", "set_point", "mode"]
    devices = [a_meter("meter", 3, registers=names), a_meter("other", 4, registers=names)]
    with Folder() as folder, Broker(folder) as broker, Repeating(units) as line, Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])) as gateway:
            check(flows(client) and flows(client, "line1/other"), "values come")
            for how in ("doubled", "late", "foreign"):
                line.how, line.repeated = how, 0
                since = time.time()
                check(soon(lambda: line.repeated > 40, LIMIT), f"{how}: the line repeats responses")
                line.how = None
                check(flows(client) and flows(client, "line1/other"), f"{how}: values come behind that")
                for unit, name in ((3, "meter"), (4, "other")):
                    values = [each.values for each in states(client, f"line1/{name}", since)]
                    told = {key: [each[key]["value"] for each in values if each.get(key, {}).get("value") is not None] for key in names}
                    volts = [round(each * 10) for each in told["voltage"]]
                    check(all(each < after for each, after in zip(volts, volts[1:])), f"{how}: each voltage of {name} is new", volts)
                    check(all((each > 10000) == (unit == 4) for each in volts), f"{how}: and its own", volts)
                    check(set(told["set_point"]) <= {21.5} and set(told["mode"]) <= {"heat"}, f"{how}: none is another register's", told)
                    check(len(volts) > 3, f"{how}: values come meanwhile", len(volts))
            check(gateway.end() == 0, "it ends")


def pulled(check, program, _):
    """The adapter: out and in at the same name, thrice."""
    with Folder() as folder, Broker(folder) as broker, Client(broker.port, "rtuwire/#") as client:
        link = folder / "usb-adapter"
        with Units({5: meter()}) as other:
            lines = [a_line(link, a_meter(registers=["voltage"])), a_line(other.name, a_meter("other", 5), name="line2")]
            with Gateway(program, folder, text_of(broker.port, lines)) as gateway:
                changes = Changes(check, client)
                check(flows(client, "line2/other"), "without an adapter the other line lives")
                check(client.last(f"{SITE}/line1/availability") == "offline", "and this one is offline",
                      client.last(f"{SITE}/line1/availability"))
                for turn in range(3):
                    since = time.time()
                    with Units({3: meter()}, link) as line:
                        changes.says("line1/availability", "online", since, f"in, turn {turn}")
                        check(flows(client, since=since), "values come")
                        check(soon(lambda: client.last(f"{SITE}/line1/meter/availability") == "online", LIMIT), "the device is online")
                        check(line.requests, "from the new one")
                        since = time.time()
                    changes.says("line1/availability", "offline", since, f"out, turn {turn}")
                    beats = len(client.of(f"{SITE}/line1/status"))
                    check(soon(lambda: len(client.of(f"{SITE}/line1/status")) > beats + 1, LIMIT), "its loop still lives")
                    check(json.loads(client.last(f"{SITE}/line1/status"))["up"] is False, "and says that the port is away",
                          client.last(f"{SITE}/line1/status"))
                    fresh = [each for each in states(client, "line1/meter") if each.time > since + 1]
                    check(not fresh, "no value has a time at which there was no port", [each.message for each in fresh[:2]])
                check(gateway.process.poll() is None and flows(client, "line2/other"), "the other line goes on")
                said = [each.payload for each in client.of(f"{SITE}/line2/availability")]
                check(set(said[said.index(b"online"):]) == {b"online"}, "it noticed nothing", said)
                changes.judge()


class Linked(Simulator):
    """Simulated drives on a line whose name stays."""

    def __init__(self, tool, link, *drives):
        super().__init__(tool, *drives)
        self.link = link

    def __enter__(self):
        device = super().__enter__()
        self.link.unlink(missing_ok=True)
        os.symlink(device, self.link)
        return device

    def __exit__(self, *how):
        self.link.unlink(missing_ok=True)
        return super().__exit__(*how)


def replaced(check, program, tool):
    """A drive goes, and another type answers at its address: its words mean something else there."""
    fan = {"name": "fan", "unit": 7, "drive": "atv320", "registers": ["RFR", "LCR", "ETA"], "feeds_supervision": True, "every": 0.5}
    with Folder() as folder, Broker(folder) as broker, Client(broker.port, "rtuwire/#") as client:
        link = folder / "usb-adapter"
        with Gateway(program, folder, text_of(broker.port, [a_line(link, fan)])) as gateway:
            with Linked(tool, link, "atv320:7"):
                check(flows(client, "line1/fan"), "the drive's values come")
                changes = Changes(check, client)
                gone = time.time()
            changes.says("line1/availability", "offline", gone, "gone")
            with Linked(tool, link, "atv12:7"):
                back = time.time()
                changes.says("line1/availability", "online", back, "another type at its address")
                check(soon(lambda: "atv12" in gateway.said().lower(), LIMIT), "what answers there is named", gateway.said())
                told = [each for each in states(client, "line1/fan", back + 1)
                        for value in each.values.values() if value.get("value") is not None]
                check(not told, "its words are not told as those of the type before", [each.message for each in told[:2]])
                check(client.last(f"{SITE}/line1/fan/availability") == "offline", "the device is offline",
                      client.last(f"{SITE}/line1/fan/availability"))
                gone = time.time()
            changes.says("line1/availability", "offline", gone, "gone again")
            with Linked(tool, link, "atv320:7"):
                back = time.time()
                changes.says("line1/fan/availability", "online", back, "the right type")
                check(flows(client, "line1/fan", back), "its values come again")


class Exchanged(Units):
    """A unit that says who it is, and another one in its place, of which function 43 learns nothing: it `refuses` that, is `mute`, or
    `loses` its answer, once, with the repetition."""

    how = None

    def answer(self, request):
        if request[1] != 43 or request[0] in self.silent:
            return super().answer(request)
        if self.how == "refuses":
            return bytes([request[0], 0x80 | 43, 1])
        if self.how == "mute" or (self.how == "loses" and sum(each[1] == 43 for _, each in self.requests) < 3):
            return None
        objects = b"".join(bytes([i, len(each)]) + each for i, each in enumerate((b"Other" if self.how else b"Maker", b"Meter", b"1.0")))
        return bytes([request[0], 43, 14, 1, 1, 0, 0, 3]) + objects


def unnamed(check, program, _):
    """Another device at the address of one whose file has a `vendor`: it is not read as the one before, also where it does not say who
    it is, or that was lost."""
    for how in ("refuses", "mute", "loses"):
        with Folder() as folder, Broker(folder) as broker, Exchanged({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
            (folder / "named.toml").write_text('[device]\nvendor = "Maker"\nproduct = "Meter"\n' + METER, encoding="utf-8")
            text = text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"], settings=["set_point"], file="named.toml"))])
            with Gateway(program, folder, text, "--write"):
                check(flows(client), f"{how}: values come")
                line.silent = {3}
                check(soon(lambda: client.last(f"{SITE}/line1/meter/availability") == "offline", LIMIT), f"{how}: it is gone")
                line.units[3][0], line.how = 999, how
                line.requests.clear()
                line.silent = set()
                check(soon(lambda: any(each.values["voltage"].get("why", "").startswith("unit 3 ") for each in states(client) if "voltage" in each.values), LIMIT),
                      f"{how}: it is told that another one is there", [each.message for each in states(client)[-2:]])
                check(not soon(lambda: any(each.values["voltage"].get("value") == 99.9 for each in states(client) if "voltage" in each.values), 3),
                      f"{how}: no value of it is told", [each.message for each in states(client)[-2:]])
    # One that never says it is read, and that nobody can tell it from another is said once.
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        (folder / "named.toml").write_text('[device]\nvendor = "Maker"\nproduct = "Meter"\n' + METER, encoding="utf-8")
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"], file="named.toml"))])) as gateway:
            check(flows(client), "never said: values come")
            check(gateway.said().count("does not say who it is") == 1, "and that is told, once", gateway.said())


def many(check, program, tool, lines="10", devices="30", seconds="60"):
    """300 devices on 10 lines, each every second: all come, at their period."""
    lines, devices = int(lines), int(devices)
    with Folder() as folder, Broker(folder, "max_queued_messages 0") as broker, Client(broker.port, "rtuwire/#") as client:
        stands, said = [], []
        try:
            for number in range(lines):
                line = Units({unit: meter() for unit in range(1, devices + 1)})
                line.__enter__()
                stands.append(line)
                said.append(a_line(line.name, *[a_meter(f"meter{unit}", unit, every=1.0, registers=["voltage", "power", "energy"])
                                                for unit in range(1, devices + 1)], name=f"line{number}", baud=115200))
            with Gateway(program, folder, text_of(broker.port, said)) as gateway:
                wanted = [f"{SITE}/line{number}/meter{unit}/state" for number in range(lines) for unit in range(1, devices + 1)]
                check(soon(lambda: set(wanted) <= {each.topic for each in list(client.messages)}, LIMIT), "all devices come",
                      len({each.topic for each in list(client.messages)}))
                began = time.time()
                time.sleep(float(seconds))
                got = [each for each in list(client.messages) if each.arrived > began and each.topic.endswith("/state")]
                print(len(got), "messages in", seconds, "s;", subprocess.run(
                    ["ps", "-o", "rss=,cputime=", "-p", str(gateway.process.pid)], capture_output=True, text=True,
                    check=False).stdout.strip())
                check(len(got) > 0.9 * lines * devices * float(seconds), "each at its period", len(got))
                check(gateway.end() == 0, "it ends")
        finally:
            for line in stands:
                line.__exit__()


def main(check, program, tool, part, *more):
    parts = {"silent": silent, "usual": usual, "waited": waited, "late": late, "divided": divided, "met": met, "joined": joined, "beside": beside, "overtaken": overtaken, "one_function": one_function, "rested": rested, "repeated": repeated, "pulled": pulled, "replaced": replaced, "unnamed": unnamed, "many": many}
    parts[part](check, program, tool, *more)


if __name__ == "__main__":
    runs(main)
