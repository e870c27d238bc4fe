# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Settings from MQTT: what is written, what never is, and what each command is answered.

    python3 setting.py GATEWAY TOOL done|replaced|late|exchanged|holds|ended|stored|refused|moments|hung|cuts|drive

Behind `cuts`: all, for every moment with both qualities of service.
"""
import json
import signal
import threading
import time

from devices import OneLate, turns_between
from stand import (LIMIT, METER, SITE, Broker, Client, Folder, Gateway, Proxy, Simulator, Units, a_line, a_meter, flows, meter, moment, runs,
                   soon, states, text_of, when)

SET, ANSWER = f"{SITE}/line1/meter/set", f"{SITE}/line1/meter/answer"


class Asking:
    """Commands of one device, each with a name of its own."""

    def __init__(self, check, client, device="line1/meter"):
        self.check, self.client, self.count, self.device = check, client, 0, device

    def send(self, name, value, expires=10.0, retain=False, qos=1, **more):
        self.count += 1
        said = {"value": value, "id": f"c{self.count}", **more}
        if expires is not None:
            said["expires"] = moment(time.time() + expires) if isinstance(expires, (int, float)) else expires
        self.client.publish(f"{SITE}/{self.device}/set/{name}", json.dumps(said), retain, qos)
        return said["id"]

    def answers(self, name, number):
        found = []
        for each in self.client.of(f"{SITE}/{self.device}/answer/{name}"):
            said = json.loads(each.payload)
            if said.get("id") == number:
                found.append((said, each))
        return found

    def expect(self, name, value, results, what, says="", **how):
        number = self.send(name, value, **how)
        self.check(soon(lambda: self.answers(name, number), LIMIT), f"{what}: answered")
        found = self.answers(name, number)
        if found:
            said, message = found[0]
            self.check(said["result"] in results and says in said.get("why", ""), f"{what}: {results}", said)
            self.check("time" in said and not message.is_retained, f"{what}: with its time, not retained", said)
            self.check(said["result"] == "done" or said.get("why"), f"{what}: with the reason", said)
        return found[0][0] if found else None


def the_file(broker, line, **more):
    return text_of(broker.port if hasattr(broker, "port") else broker,
                   [a_line(line.name, a_meter(settings=["set_point", "kept", "mode"], registers=["voltage", "set_point", "mode"], **more))])


def done(check, program, _):
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come")
            ask = Asking(check, client)
            ask.expect("set_point", 22.5, ("done",), "a value")
            check(line.units[3][10] == 225 and len(line.writes) == 1, "it is written once, by its scale", line.writes)
            check(soon(lambda: states(client)[-1].values.get("set_point", {}).get("value") == 22.5, LIMIT), "and read back")
            ask.expect("set_point", 22.5, ("done",), "an equal value")
            check(len(line.writes) == 1, "it is not written again", line.writes)
            ask.expect("mode", "off", ("done",), "a value by its name")
            check(line.units[3][12] == 0 and len(line.writes) == 2, "is written", line.writes)
            ask.expect("kept", 500, ("done",), "a stored register")
            check(line.units[3][11] == 500, "is written", line.writes)
            before = len(line.writes)
            ask.expect("kept", 501, ("refused",), "a stored register at once again")
            check(len(line.writes) == before and line.units[3][11] == 500, "is not written", line.writes[before:])
            line.refuses_writes = True
            ask.expect("set_point", 40, ("failed", "refused"), "the unit refuses")
            tried = len(line.writes)
            line.refuses_writes = False
            check(flows(client, count=6) and len(line.writes) == tried, "nothing is tried a second time", line.writes[before:])
            # The unit says nothing.
            line.silent = {3}
            number = ask.send("set_point", 41, expires=3.0)
            check(soon(lambda: ask.answers("set_point", number), LIMIT), "a silent unit: answered")
            check(ask.answers("set_point", number)[0][0]["result"] in ("failed", "expired", "refused"), "it failed",
                  ask.answers("set_point", number))
            tried = len(line.writes)
            line.silent = set()
            check(flows(client, count=8), "it is back")
            check(len(line.writes) == tried and line.units[3][10] == 225, "the command is not carried out later", line.writes[before:])
            check("set_point" in gateway.said(), "a write is told to people")
            check(gateway.end() == 0, "it ends")


class Held(Units):
    """A unit that keeps the answer by which it would be known as no drive, before it is written, until `let_go` is set."""

    FIRST = 3201

    def __init__(self, units):
        super().__init__(units)
        self.is_held, self.let_go = threading.Event(), threading.Event()
        self.let_go.set()

    def answer(self, request):
        if int.from_bytes(request[2:4], "big") == self.FIRST and not self.let_go.is_set():
            self.is_held.set()
            self.let_go.wait(LIMIT)
        return super().answer(request)


def replaced(check, program, _):
    """A newer command takes the place of one for the same register whose device is late; each has one answer, and a line of the log."""
    with Folder() as folder, Broker(folder) as broker, Held({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        text = text_of(broker.port, [a_line(line.name, a_meter(settings=["set_point", "kept", "mode"], registers=["voltage"]), timeout=30)])
        with Gateway(program, folder, text, "--write") as gateway:
            check(flows(client), "values come")
            ask, sent = Asking(check, client), []

            def send(name, value):
                sent.append((name, value, ask.send(name, value, expires=50.0)))

            line.let_go.clear()
            send("kept", 500)
            check(line.is_held.wait(LIMIT), "one is under way, and its unit is late")
            for name, value in (("set_point", 30), ("kept", 501), ("mode", "off"), ("set_point", 31), ("kept", 502)):
                send(name, value)
            ask.expect("mode", 1, ("refused",), "what is wrong in itself is answered at once, and those before it were taken", expires=None)
            line.let_go.set()
            check(soon(lambda: all(ask.answers(name, number) for name, _, number in sent), LIMIT), "all are answered")
            check(flows(client, count=3), "values go on")
            results = [[(said["result"], said["why"]) for said, _ in ask.answers(name, number)] for name, _, number in sent]
            older, newest = [("refused", "a newer one took its place")], [("done", "")]
            check(results == [older, older, older, newest, newest, newest], "each once: the newest of each register is done", results)
            check([each[2:] for each in line.writes] == [(12, [0]), (10, [310]), (11, [502])], "and nothing else is written", line.writes)
            for name, value, _ in sent:
                told = [each for each in gateway.said().splitlines() if f" {name}={value}: " in each]
                check(len(told) == 1, f"{name}={value} is told once", told)


def late_line(folder, broker, line, identity):
    """The file of a line with a late device, which has settings, and another one that is read five times as often."""
    line.identity = identity
    (folder / "late.toml").write_text(('[device]\nvendor = "Maker"\nproduct = "Meter"\n' if identity else "") + METER, encoding="utf-8")
    devices = [a_meter(registers=["voltage"], settings=["set_point"], file="late.toml", every=1.0), a_meter("other", 4, registers=["voltage"], every=0.2)]
    return text_of(broker.port, [a_line(line.name, *devices, timeout=0.5)])


def late(check, program, _):
    """Each of the requests by which a late device is set is a turn between those of others; the last one, and the look at what came of
    it, follow each other. A late one that has said who it is says so again just before."""
    for identity in (None, (b"Maker", b"Meter")):
        with Folder() as folder, Broker(folder) as broker, OneLate({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
            with Gateway(program, folder, late_line(folder, broker, line, identity), "--write"):
                line.late = 3
                check(flows(client, count=2) and flows(client, "line1/other"), "values come")
                ask, before = Asking(check, client), len(line.requests)
                ask.expect("set_point", 22.5, ("done",), f"{identity}: a setting of a late device", expires=50.0)
                check([each[1:] for each in line.writes] == [(3, 10, [225])], "is written once", line.writes)
                asked = [each for _, each in line.requests[before:]]
                written = [each[:2] for each in asked].index(b"\3\6")
                other, itself = turns_between(asked[:written], 3, 4)
                check(other >= 3 * max(itself, 1), "in turns", asked)
                own = [each[:4] for each in asked[:written] if each[0] == 3]
                turns = [each for each, after in zip(own, [*own[1:], None]) if each != after]
                check(identity or turns.count(b"\3\3\x01\xca") <= turns.count(b"\3\x2b\x0e\1"), "each thing once", turns)
                if identity:
                    said = [i for i, each in enumerate(asked[:written]) if each[:2] == b"\3\x2b"]
                    behind = [each for each in asked[said[-1]:written] if each[0] == 3]
                    check({each[1] for each in behind} == {43}, "into one that has just said who it is", behind)
                check(flows(client) and flows(client, "line1/other"), "values go on")
                check(len(line.writes) == 1, "and nothing is written later", line.writes)


def exchanged(check, program, _):
    """A late device that is exchanged for one of another type, or goes, between two turns of its setting is not written."""
    for how in ("other", "silent"):
        with Folder() as folder, Broker(folder) as broker, OneLate({3: meter(), 4: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
            with Gateway(program, folder, late_line(folder, broker, line, (b"Maker", b"Meter")), "--write"):
                line.late = 3
                check(flows(client, count=2), "values come")
                ask, before = Asking(check, client), len(line.requests)
                number = ask.send("set_point", 22.5, expires=50.0)

                def behind():  # what the device was asked behind its identification
                    asked = [each[:2] for _, each in line.requests[before:]]
                    firsts = [i for i, each in enumerate(asked) if each == b"\3\3"]
                    return firsts and b"\3\x2b" in asked[:firsts[-1]]
                check(soon(behind, LIMIT), "it has said who it is")
                if how == "other":
                    line.identity = (b"Maker", b"Heater")
                else:
                    line.silent = {3}
                check(soon(lambda: ask.answers("set_point", number), LIMIT), f"{how}: answered")
                found = [said["result"] for said, _ in ask.answers("set_point", number)]
                check(found in (["failed"], ["refused"]), f"{how}: once", ask.answers("set_point", number))
                line.silent = set()
                check(flows(client, "line1/other", count=20) and not line.writes, f"{how}: nothing is written", line.writes)


class TakesItsPlace(OneLate):
    """Another device is there from a moment on, with the same registers and what they hold."""

    behind = None  # "said": once who it is was asked again; "written": at the request that writes, whose response is lost

    def answer(self, request):
        found = super().answer(request)
        if self.behind == "said" and request[1] == 43:
            self.identity, self.behind = (b"Maker", b"Heater"), None
        if self.behind == "written" and request[1] in (6, 16):
            self.identity, self.behind = (b"Maker", b"Heater"), None
            return None
        return found


def holds(check, program, _):
    """A device that is exchanged for one of another type, which holds the value, is not told to be set."""
    for behind, value in (("said", 20.0), ("written", 22.5)):
        with Folder() as folder, Broker(folder) as broker, TakesItsPlace({3: meter(), 4: meter()}) as line, \
                Client(broker.port, "rtuwire/#") as client:
            line.units[3][10] = 200
            with Gateway(program, folder, late_line(folder, broker, line, (b"Maker", b"Meter")), "--write"):
                check(flows(client, count=2), "values come")
                ask = Asking(check, client)
                ask.expect("set_point", 20.0, ("done",), "held already", says="already", expires=50.0)
                line.behind = behind
                ask.expect("set_point", value, ("failed",), f"{behind}: by another one", says="Heater", expires=50.0)
                check(len(line.writes) == (behind == "written"), f"{behind}: written once at most", line.writes)


def ended(check, program, _):
    """A line ends, by a reload or with the gateway, behind a command whose device is late: the broker hears the gateway all the time,
    the other line goes on, and each command has its answer."""
    for how in ("reload", "end"):
        with Folder() as folder, Broker(folder) as broker, Held({3: meter()}) as line, Units({4: meter()}) as other, \
                Client(broker.port, "rtuwire/#") as client:
            second = a_line(other.name, a_meter("two", 4, registers=["voltage"]), name="line2")
            named = ["set_point", "kept", "mode"]
            text = lambda **more: text_of(broker.port, [a_line(line.name, a_meter(settings=named, registers=["voltage"], **more), timeout=30), second])
            with Gateway(program, folder, text(), "--write") as gateway:
                check(flows(client) and flows(client, "line2/two"), f"{how}: values come")
                ask, sent, since = Asking(check, client), [], time.time()
                line.let_go.clear()
                sent.append(("set_point", ask.send("set_point", 30, expires=50.0)))
                check(line.is_held.wait(LIMIT), f"{how}: one is under way, and its unit is late")
                sent.append(("kept", ask.send("kept", 500, expires=50.0)))
                gateway.reload(text(every=0.25)) if how == "reload" else gateway.process.send_signal(signal.SIGTERM)
                time.sleep(1)
                ask.expect("mode", "auto", ("refused",), f"{how}: what comes now is answered at once", says="the line ends")
                if how == "reload":
                    check(flows(client, "line2/two", count=10), "the other line goes on")  # for longer than the broker would wait
                else:
                    time.sleep(10)
                states_said = [each.payload for each in client.of(f"{SITE}/status") if each.arrived > since]
                check(b"offline" not in states_said, f"{how}: the broker has not missed the gateway", states_said)
                line.let_go.set()
                check(soon(lambda: all(ask.answers(name, number) for name, number in sent), LIMIT), f"{how}: all are answered")
                results = [[said["result"] for said, _ in ask.answers(name, number)] for name, number in sent]
                check(results == [["done"], ["refused"]], f"{how}: the one under way is done, once, and the one that waited is refused", results)
                if how == "reload":
                    check(flows(client), "and the line goes on with its new file")
                else:
                    check(soon(lambda: gateway.process.poll() == 0, LIMIT), "it ends", gateway.process.poll())
                    check(soon(lambda: client.last(f"{SITE}/status") == "offline", LIMIT), "and says so")


def stored(check, program, _):
    """The interval of a register that its device stores outlives the line, the gateway, and a clock that was set back."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        record = folder / "state" / "written.json"
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come")
            ask = Asking(check, client)
            ask.expect("kept", 500, ("done",), "a stored register")
            since = time.time()
            gateway.reload(the_file(broker, line, every=0.4))
            check(soon(lambda: "read again" in gateway.said(), LIMIT) and flows(client, since=since, count=3), "its line begins anew")
            ask.expect("kept", 501, ("refused",), "behind a reload", "60 s lie between two")
            check(gateway.end() == 0, "it ends")
        client.messages.clear()
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come again")
            ask.expect("kept", 502, ("refused",), "behind a restart", "60 s lie between two")
            gateway.kill()
        # As if the calendar had been set forward by an hour in between.
        noted = json.loads(record.read_text(encoding="utf-8"))
        for each in noted.values():
            each["clock"]["began"] -= 3_600_000_000
            each.update({which: moment(when(at) - 3600) for which, at in each.items() if which != "clock"})
        record.write_text(json.dumps(noted), encoding="utf-8")
        client.messages.clear()
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come again")
            ask.expect("kept", 502, ("refused",), "a clock that was set forward", "60 s lie between two")
            gateway.kill()
        check(len(line.writes) == 1, "it was written once", line.writes)
        # Noted an hour ahead, at another start of the machine: it waits, and no longer than a minute.
        for each in noted.values():
            del each["clock"]
            each.update({which: moment(time.time() + 3600) for which in each})
        record.write_text(json.dumps(noted), encoding="utf-8")
        client.messages.clear()
        begins = time.time()
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come again")
            ask.expect("kept", 503, ("refused",), "a clock that was set back", "60 s lie between two")
            time.sleep(max(0.0, begins + 63 - time.time()))
            ask.expect("kept", 504, ("done",), "a minute later")
            gateway.kill()
        record.write_text("{", encoding="utf-8")
        (folder / "state" / "published.json").write_text("[1", encoding="utf-8")
        client.messages.clear()
        with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
            check(flows(client), "values come again")
            ask.expect("kept", 505, ("refused",), "behind a record that was damaged", "60 s lie between two")
            for name in ("written.json", "published.json"):
                check(f"{name}: it is damaged, and begun anew" in gateway.said(), f"{name} is said to be damaged")
                check((folder / "state" / f"{name}.damaged").exists(), "and kept")
            check(len(line.writes) == 2, "nothing was written in between", line.writes)


def refused(check, program, _):
    """By what it is: nothing of these is ever written."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, the_file(broker, line), "--write"):
            check(flows(client), "values come")
            ask = Asking(check, client)
            for value in (4.9, 60.1, -1, 1e9, 1e300, "twenty", "22.5; stop", None, True, [22.5], {"value": 22.5}):
                ask.expect("set_point", value, ("refused",), f"{value!r}")
            ask.expect("mode", "cool", ("refused",), "none of the choices")
            ask.expect("mode", 7, ("refused",), "a number of none of them")
            ask.expect("set_point", 30, ("refused",), "without an expiry", expires=None)
            ask.expect("set_point", 30, ("refused",), "an expiry that is none", expires="tomorrow")
            ask.expect("set_point", 30, ("refused",), "an expiry far away", expires=120.0)
            ask.expect("set_point", 30, ("refused",), "one of next year", expires="2099-01-01T00:00:00Z")
            ask.expect("set_point", 30, ("expired", "refused"), "one that has gone", expires=-1.0)
            ask.expect("set_point", 30, ("refused",), "a retained one", retain=True)
            for payload in ("", "22.5", "{", "[]", "null", '{"value": 22.5', b"\xff\xfe{}", '{"expires": 1}', "x" * 100_000,
                            '{"value": NaN, "expires": "2099-01-01T00:00:00Z"}', "[" * 5000):
                client.publish(f"{SET}/set_point", payload)
            # What the file does not name, or that the device has for others.
            for name in ("voltage", "gate", "energy", "none", "set_point/more", ""):
                client.publish(f"{SET}/{name}", json.dumps({"value": 1, "id": "x", "expires": moment(time.time() + 10)}))
            client.publish(f"{SITE}/line1/other/set/set_point", json.dumps({"value": 30, "id": "x", "expires": moment(time.time() + 10)}))
            check(flows(client, count=4), "values go on")
            check(not line.writes, "nothing was written", line.writes)
            check(line.units[3] == meter(), "nothing is changed")
            ask.expect("set_point", 25, ("done",), "a right one behind all these")
            client.publish(f"{SET}/set_point", "", retain=True)
        before = len(line.writes)
        with Gateway(program, folder, the_file(broker, line)):
            check(flows(client), "values come")
            ask = Asking(check, client)
            number = ask.send("set_point", 33)
            check(flows(client, count=6), "values go on")
            answered = ask.answers("set_point", number)
            check(len(line.writes) == before, "without --write nothing is written", line.writes[before:])
            check(not answered or answered[0][0]["result"] == "refused", "and it is not called done", answered)


def moments(check, program, _):
    """By when it was said: before the gateway began, while it was away, while the broker hung."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Client(broker.port, "rtuwire/#") as client:
            ask = Asking(check, client)
            ask.send("set_point", 31, expires=50.0)
            ask.send("set_point", 32, expires=50.0, retain=True)
            ask.send("mode", "off", expires=50.0, retain=True)
            with Gateway(program, folder, the_file(broker, line), "--write") as gateway:
                check(flows(client, count=6), "values come")
                check(not line.writes, "what was said before it began is not done", line.writes)
                gateway.kill()
            ask.send("set_point", 33, expires=50.0)
            with Gateway(program, folder, the_file(broker, line), "--write"):
                check(flows(client, count=6), "values come")
                check(not line.writes, "nor what was said while it was away", line.writes)
            client.publish(f"{SET}/set_point", "", retain=True)
            client.publish(f"{SET}/mode", "", retain=True)
        # Between the gateway and the broker nothing passes; the broker keeps what is said for who comes again.
        with Proxy(broker.port) as proxy, Client(broker.port, "rtuwire/#") as client:
            with Gateway(program, folder, the_file(proxy, line), "--write"):
                check(flows(client), "values come")
                ask = Asking(check, client)
                ask.expect("set_point", 23, ("done",), "a command")
                before, connections = len(line.writes), len(proxy.connections)
                proxy.silence()
                ask.send("set_point", 34, expires=50.0)
                check(soon(lambda: len(proxy.connections) > connections, LIMIT), "it connects again")
                since = time.time()
                check(flows(client, since=since, count=6), "values come again")
                check(len(line.writes) == before, "what was said in between is not done", line.writes[before:])
                ask.expect("set_point", 35, ("done",), "one behind it")
                check(len(line.writes) == before + 1, "is, once", line.writes[before:])


def hung(check, program, _):
    """The broker hangs, and goes on: what was given to it in between is old."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Client(broker.port, "rtuwire/#") as client, Gateway(program, folder, the_file(broker, line), "--write"):
            check(flows(client), "values come")
            ask, before = Asking(check, client), len(line.writes)
            broker.freeze()
            ask.count += 1
            said = {"value": 36, "id": "frozen", "expires": moment(time.time() + 3)}
            ask.client.publish(f"{SET}/set_point", json.dumps(said), qos=0)  # waits in the broker's socket
            time.sleep(4)
            broker.thaw()
            check(flows(client, since=time.time() + 1, count=4), "values go on")
            check(len(line.writes) == before, "what expired on its way is not done", line.writes[before:])


def cuts(check, program, _, which=""):
    """The connection ends with a command on its way, at each moment: it is carried out once or not at all."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Proxy(broker.port) as proxy, \
            Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, the_file(proxy, line), "--write"):
            check(flows(client), "values come")
            value = 100
            for qos in (0, 1):
                for behind in ("before", "command", "behind"):
                    if not which and (qos, behind) not in ((0, "before"), (1, "command")):
                        continue
                    value += 7
                    connection, before = proxy.connections[-1], len(line.writes)
                    seen = [False]

                    def behave(each, connection=connection, behind=behind, seen=seen):
                        if each is not connection or not any(SET.encode() in body for kind, _, body in each.told if kind == 3):
                            return None
                        if behind == "command" or seen[0]:
                            return "cut"
                        seen[0] = True
                        return None
                    connection.told.clear()
                    if behind == "before":
                        connection.cut()
                    else:
                        proxy.behave = behave
                    Asking(check, client).send("set_point", value / 10, expires=30.0, qos=qos)
                    check(soon(lambda: proxy.connections[-1] is not connection, LIMIT), f"qos {qos}, {behind}: it connects again")
                    proxy.behave = lambda _: None
                    since = time.time()
                    check(flows(client, since=since, count=5), "values come again")
                    written = line.writes[before:]
                    check(len(written) <= (0 if behind == "before" else 1), f"qos {qos}, {behind}: never twice, nor later", written)


def drive(check, program, tool):
    """Of a drive: what turns a motor otherwise, or guards it, is no setting; the rest goes by its rows."""
    fan = {"name": "fan", "unit": 7, "drive": "atv320", "registers": ["RFR"], "feeds_supervision": True, "every": 0.5}
    with Folder() as folder, Broker(folder) as broker, Simulator(tool, "atv320:7") as device, Client(broker.port, "rtuwire/#") as client:
        with Gateway(program, folder, "", "--write", start=False) as gateway:
            for register in ("ACC", "DEC", "HSP", "LSP", "CMD", "LFR", "CHCF", "FR1", "NCA1", "TTO", "SLL", "ADD", "TBR", "TFO"):
                ended = gateway.run_check(text_of(broker.port, [a_line(device, {**fan, "settings": [register]})]))
                check(ended.returncode == 2 and f"{register} cannot be a setting" in ended.stderr, f"{register} is no setting", ended)
        text = text_of(broker.port, [a_line(device, {**fan, "settings": ["ITH"]})])
        with Gateway(program, folder, text, "--write"):
            check(flows(client, "line1/fan"), "values come")
            ask, before = Asking(check, client, "line1/fan"), states(client, "line1/fan")[-1].values["ITH"]["value"]
            wanted = round(before - 0.1, 1)
            ask.expect("ITH", wanted, ("done",), "a setting of a drive at rest")
            check(soon(lambda: states(client, "line1/fan")[-1].values["ITH"]["value"] == wanted, LIMIT), "is read back",
                  states(client, "line1/fan")[-1].values)
            for value in (7000.0, -1, f"#{round(before * 10)}", hex(round(before * 10))):
                ask.expect("ITH", value, ("refused",), f"{value}: beyond its row's limits, or a raw count")
            for register in ("CMD", "LFR", "CHCF", "ACC", "NMD", "TTO", "SLL", "8501", "holding:8501"):
                client.publish(f"{SITE}/line1/fan/set/{register}",
                               json.dumps({"value": 1, "id": register, "expires": moment(time.time() + 10)}))
            check(flows(client, "line1/fan", count=4), "values go on")
            done_ = [each for each in client.messages if "/answer/" in each.topic and b'"done"' in each.payload
                     and not each.topic.endswith("/ITH")]
            check(not done_, "nothing else is done", done_)


def main(check, program, tool, part, *more):
    {"done": done, "replaced": replaced, "late": late, "exchanged": exchanged, "holds": holds, "ended": ended, "stored": stored, "refused": refused, "moments": moments, "hung": hung, "cuts": cuts, "drive": drive}[part](check, program, tool, *more)


if __name__ == "__main__":
    runs(main)
