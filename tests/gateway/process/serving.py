# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A line of the gateway that answers clients of Modbus TCP itself, by `[line.serve]`.

    python3 serving.py GATEWAY TOOL together|turns|dead|unplugged|late|reload
"""
import json
import socket
import threading
import time

from devices import Changes, OneLate
from setting import Asking
from stand import LIMIT, SITE, Broker, Client, Folder, Gateway, Units, a_line, a_meter, flows, meter, runs, soon, states, text_of

from pair import free_port  # noqa: I100
from served import Asker, read_of  # noqa: I100


def the_file(broker, port, number, *devices, units="3,4", **more):
    serve = {"listen": f"mbap://127.0.0.1:{number}", "units": units, **more}
    return text_of(broker.port, [a_line(port, *devices, serve=serve)])


def listens(gateway, number, count=1):
    return soon(lambda: gateway.said().count(f"at mbap://127.0.0.1:{number}\n") >= count, LIMIT)


def together(check, program, _):
    """What clients get, and what is refused; a setting from MQTT is written all the same."""
    units, number = {3: meter(), 4: {0: 1234}}, free_port()
    with Folder() as folder, Broker(folder) as broker, Units(units) as line, Client(broker.port, "rtuwire/#") as client:
        a_device = a_meter(registers=["voltage", "set_point"], settings=["set_point"])
        with Gateway(program, folder, the_file(broker, line.name, number, a_device), "--write") as gateway:
            check(flows(client), "values come")
            check(listens(gateway, number), "it is said where it listens", gateway.said())
            with Asker(number) as one, Asker(number) as two:
                check(one.read(3, 10) == [215] and two.read(4, 0) == [1234], "each client reads its own")
                check(one.read(3, 99) == -2, "an exception of the unit is its own")
                check(two.read(5, 0) == -10, "a unit that is not named is refused by 0A")
                heard = len(line.requests)
                for what, pdu in (("a register", b"\x06\x00\x0a\x00\xe1"), ("registers", b"\x10\x00\x0a\x00\x01\x02\x00\xe1"),
                                  ("a coil", b"\x05\x00\x00\xff\x00"), ("by a mask", b"\x16\x00\x0a\x00\x00\x00\x01"),
                                  ("beside a read", b"\x17\x00\x00\x00\x01\x00\x0a\x00\x01\x02\x00\xe1"),
                                  ("diagnostics", b"\x08\x00\x04\x00\x00"), ("a maker's", b"\x64\x01\x00")):
                    check(one.ask(3, pdu)[:2] == bytes([pdu[0] | 0x80, 1]), f"a write ({what}) is refused by 01")
                check(not line.writes and not [each for each in line.requests[heard:] if each[1][1] not in (3, 4, 43)],
                      "and nothing of it was on the line", line.writes)
                ask = Asking(check, client)
                ask.expect("set_point", 22.5, ("done",), "a setting")
                check(len(line.writes) == 1 and one.read(3, 10) == [225], "is written once, and a client sees it", line.writes)
                line.silent = {4}
                check(two.read(4, 0) == -11, "a unit that is silent is told by 0B")
            with socket.create_connection(("127.0.0.1", number), timeout=LIMIT) as wrong:
                wrong.sendall(b"GET / HTTP/1.1\r\n\r\n")
                check(wrong.recv(16) == b"", "who speaks another protocol is hung up on")
            check(flows(client), "values go on")

            def status():
                return json.loads(client.last(f"{SITE}/line1/status"))
            check(soon(lambda: status()["client_requests"] >= 4 and status()["client_silences"] == 1, LIMIT), "what clients asked is counted", status())
            check("only reads pass\n" in gateway.said() and "unit 5 is not served: units does not name it" in gateway.said(),
                  "what was refused is told in words of the file", gateway.said())
            check(gateway.end() == 0, "it ends")


def turns(check, program, _):
    """Clients that ask as fast as they can, one of them a unit that is away: values keep their period, changes are told in time."""
    units, number = {3: meter(), 4: meter(), 5: meter()}, free_port()
    with Folder() as folder, Broker(folder) as broker, Units(units) as line, Client(broker.port, "rtuwire/#") as client:
        text = the_file(broker, line.name, number, a_meter(registers=["voltage"]), a_meter("other", 4, registers=["voltage"]), units="3-9")
        with Gateway(program, folder, text) as gateway:
            check(flows(client) and flows(client, "line1/other") and listens(gateway, number), "values come")
            counts, is_over = {3: 0, 5: 0, 9: 0}, threading.Event()

            def floods(unit, wanted):
                with Asker(number) as one:
                    while not is_over.is_set():
                        if one.read(unit, 10) == wanted:
                            counts[unit] += 1
            threads = [threading.Thread(target=floods, args=each) for each in ((3, [215]), (5, [215]), (9, -11))]
            for each in threads:
                each.start()
            try:
                check(soon(lambda: min(counts.values()) > 5, LIMIT), "clients get their answers", counts)
                began = time.time()
                check(flows(client, since=began, count=14), "values go on")
                got = [each.time for each in states(client, since=began)]
                gaps = sorted(after - before for before, after in zip(got, got[1:]))
                check(gaps[len(gaps) // 2] < 0.8, "at their period of 0.5 s", [round(each, 2) for each in gaps])
                changes = Changes(check, client)
                for turn in range(3):
                    line.silent = {4}
                    changes.says("line1/other/availability", "offline", time.time(), f"turn {turn}")
                    line.silent = set()
                    changes.says("line1/other/availability", "online", time.time(), f"turn {turn}")
                changes.judge()
                before = dict(counts)
                check(soon(lambda: all(counts[each] > before[each] for each in counts), LIMIT), "clients go on", counts)
            finally:
                is_over.set()
                for each in threads:
                    each.join(LIMIT)


def dead(check, program, _):
    """Six clients with eight requests each to units that are away, one of them a device: a seventh has its turns, and so have the values."""
    units, number, away, timeout = {3: meter(), 4: meter(), 5: meter()}, free_port(), (4, 10, 11, 12, 13, 14), 0.3
    with Folder() as folder, Broker(folder) as broker, Units(units) as line, Client(broker.port, "rtuwire/#") as client:
        text = text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"]), a_meter("other", 4, registers=["voltage"]), timeout=timeout,
                                            serve={"listen": f"mbap://127.0.0.1:{number}", "units": "3-5,10-14"})])
        with Gateway(program, folder, text) as gateway:
            check(flows(client) and flows(client, "line1/other") and listens(gateway, number), "values come")
            is_over, told = threading.Event(), []

            def floods(unit):
                with Asker(number) as one:
                    for _ in range(8):
                        one.send(unit, read_of(10))
                    while not is_over.is_set():
                        told.append(one.answer()[2])
                        one.send(unit, read_of(10))
            line.silent, began, heard = {4}, time.time(), len(line.requests)
            threads = [threading.Thread(target=floods, args=(unit,)) for unit in away]
            for each in threads:
                each.start()
            try:
                with Asker(number) as seventh:
                    got = [seventh.read(5, 10) for _ in range(60)]
                check(got == [[215]] * 60, "the seventh reads its unit", got)
                check(flows(client, since=began, count=10), "values go on")
                line_said = [each.payload for each in client.of(f"{SITE}/line1/availability") if each.arrived >= began]
                check(not line_said, "and the line is there", line_said)
                order, took = [each[1][0] for each in line.requests[heard:]], time.time() - began
                asked = sum(order.count(each) for each in away if each != 4)
                check(5 <= asked <= 5 + 2 + took / (10 * timeout), "all that is away has a tenth of the line, once it is known", (asked, took))
                check(b"\x83\x0b" in told, "and who asks for it is told so", set(told))
            finally:
                is_over.set()
                for each in threads:
                    each.join(LIMIT)


def unplugged(check, program, _):
    """The adapter is pulled out and put in; clients stay connected."""
    number = free_port()
    with Folder() as folder, Broker(folder) as broker, Client(broker.port, "rtuwire/#") as client:
        link = folder / "usb-adapter"
        with Gateway(program, folder, the_file(broker, link, number, a_meter(registers=["voltage"]))) as gateway:
            check(listens(gateway, number), "it listens without an adapter", gateway.said())
            with Asker(number) as one:
                check(one.read(3, 10) == -11, "who asks is told that nobody answers")
                for turn in range(2):
                    with Units({3: meter()}, link):
                        check(flows(client), f"turn {turn}: values come")
                        check(soon(lambda: one.read(3, 10) == [215], LIMIT), "and clients read")
                    check(soon(lambda: one.read(3, 10) == -11, LIMIT), "out again, they are told so")
                    check(soon(lambda: client.last(f"{SITE}/line1/availability") == "offline", LIMIT), "as is the broker")


def reload(check, program, _):
    """A place that is taken is waited for; a reload takes it, changes and leaves it, and the line goes on meanwhile."""
    number = free_port()
    with Folder() as folder, Broker(folder) as broker, Units({3: meter(), 4: {0: 1234}}) as line, \
            Client(broker.port, "rtuwire/#") as client:
        device = a_meter(registers=["voltage"])
        without = text_of(broker.port, [a_line(line.name, device)])
        with socket.create_server(("127.0.0.1", number)) as other:
            with_all = the_file(broker, line.name, number, device)
            with Gateway(program, folder, with_all) as gateway:
                check(soon(lambda: "nobody is served: " in gateway.said(), LIMIT), "a place that is taken is told", gateway.said())
                check(flows(client), "values come all the same")
                other.close()
                check(listens(gateway, number), "it is taken once it is free", gateway.said())
                check(gateway.said().count("nobody is served: ") == 1, "which was told once")
                with Asker(number) as one:
                    check(one.read(4, 0) == [1234], "a client reads")
                    gateway.reload(the_file(broker, line.name, number, device, units="3"))
                    check(one.answer() is None, "a reload that changes who may read ends its connection")
                check(listens(gateway, number, 2), "it listens again", gateway.said())
                with Asker(number) as one:
                    check(one.read(4, 0) == -10 and one.read(3, 10) == [215], "by the new file")
                    gateway.reload(without)
                    check(one.answer() is None, "without the table it ends")
                check(flows(client), "values go on")
                check(gateway.said().count("its port is open") == 1, "the port of the line was open all the time", gateway.said())
                numbers = [each.seq for each in states(client)]
                check(numbers == sorted(numbers), "and no value began to count anew", numbers)
                with socket.socket() as late:
                    check(late.connect_ex(("127.0.0.1", number)) != 0, "and nobody listens")


def late(check, program, _):
    """A device that answers later than `timeout` is read as soon as it owes nothing, where clients are served as well."""
    with Folder() as folder, Broker(folder) as broker, OneLate({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        text = text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"]), timeout=0.5,
                                            serve={"listen": f"mbap://127.0.0.1:{free_port()}", "units": "3,4"})])
        with Gateway(program, folder, text):
            check(flows(client), "values come")
            line.late = 3
            check(flows(client, count=5), "and go on when it is late")
            sent = [at for at, _ in line.requests]
            waited = [after - at - line.delay for at, after in zip(sent, sent[1:])][-8:]
            check(min(each for each in waited if each > 0) < 1, "soon behind its latest answer", [round(each, 2) for each in waited])


def main(check, program, tool, part, *more):
    {"together": together, "turns": turns, "dead": dead, "unplugged": unplugged, "late": late, "reload": reload}[part](check, program, tool, *more)


if __name__ == "__main__":
    runs(main)
