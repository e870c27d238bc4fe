# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A file that is read anew while the gateway runs: what left it is forgotten everywhere, what stayed notices nothing.

    python3 reloading.py GATEWAY TOOL changed|wrong|gone
"""
import json
import time

from discovery import config_topics
from stand import (LIMIT, SITE, Broker, Client, Folder, Gateway, Units, a_line, a_meter, flows, meter, runs, soon, states, text_of)


def went_on(check, client, line):
    """The line began nothing anew, and lost no frame: its own count is what the units heard."""
    seqs = [each.seq for each in states(client)]
    check(all(each < after for each, after in zip(seqs, seqs[1:])), "its device's numbers go on", seqs)
    beats = [json.loads(each.payload) for each in client.of(f"{SITE}/line1/status")]
    check(all(each["seq"] < after["seq"] and each["requests"] <= after["requests"] for each, after in zip(beats, beats[1:])),
          "and the line's", [(each["seq"], each["requests"]) for each in beats])
    up = [each["up"] for each in beats]
    check(not any(each["silences"] or each["errors"] for each in beats) and all(up[up.index(True):]), "no frame was lost",
          (up, beats[-1]))
    at = client.of(f"{SITE}/line1/status")[-1].arrived
    heard = sum(each < at for each, _ in line.requests)
    check(abs(heard - beats[-1]["requests"]) <= 12, "it counted what the units heard", (heard, beats[-1]))


def changed(check, program, _):
    """Another line changes: this one goes on without a frame lost, its device's numbers too."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Units({4: meter(), 5: meter()}) as other:
        first = a_line(line.name, a_meter(every=0.2, registers=["voltage"]))
        with Client(broker.port, "#") as client:
            two = a_line(other.name, a_meter("two", 4, registers=["voltage"]), name="line2")
            with Gateway(program, folder, text_of(broker.port, [first, two])) as gateway:
                check(flows(client, count=5) and flows(client, "line2/two"), "values come")
                opened = len(line.requests)
                both = a_line(other.name, a_meter("two", 4, every=1.0), a_meter("three", 5), name="line2")
                gateway.reload(text_of(broker.port, [first, both]))
                check(flows(client, "line2/three"), "a device that came is read")
                third = a_line(folder / "nowhere", a_meter("far", 9), name="line3")
                gateway.reload(text_of(broker.port, [first, both, third]))
                check(soon(lambda: client.last(f"{SITE}/line3/availability") == "offline", LIMIT), "a line that came is told")
                gateway.reload(text_of(broker.port, [first]))
                check(soon(lambda: not [each for each in other.requests if each[0] > time.time() - 1.5], LIMIT), "one that went is silent")
                check(flows(client, count=3), "the first goes on")
                went_on(check, client, line)
                check(gateway.end() == 0, "it ends")


def wrong(check, program, _):
    """A file that is wrong, or not there: told, and the one before goes on."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "#") as client:
        good = text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"]))])
        with Gateway(program, folder, good) as gateway:
            check(flows(client), "values come")
            for what, text, says in (("a key", good.replace("baud =", "bauds ="), "bauds"),
                                     ("no TOML", good + "[[", "gateway.toml:"),
                                     ("a register", good.replace('"voltage"', '"voltag"'), "voltag"),
                                     ("a word that may not be", good + 'settings = ["gate"]\n', "gate")):
                gateway.reload(text)
                check(soon(lambda says=says: says in gateway.said(), LIMIT), f"{what}: told", gateway.said())
                check(gateway.process.poll() is None and flows(client), f"{what}: the one before goes on")
            gateway.file.unlink()
            before = gateway.said()
            gateway.reload()
            check(soon(lambda: len(gateway.said()) > len(before), LIMIT), "a file that is gone: told")
            check(flows(client), "the one before goes on")
            gateway.reload(good)
            check(flows(client), "a right one again")
            went_on(check, client, line)
            check({each.payload for each in client.of(f"{SITE}/status")} == {b"online"}, "nor was it ever offline")


def gone(check, program, _):
    """A device that leaves the file leaves Home Assistant: at a reload, at a restart, and where the broker was away."""
    both = lambda port: [a_line(port, a_meter(registers=["voltage", "power"]), a_meter("second", 4, registers=["voltage"]))]
    one = lambda port: [a_line(port, a_meter(registers=["voltage", "power"]))]
    fewer = lambda port: [a_line(port, a_meter(registers=["voltage"]))]

    def kept(port):
        with Client(port, "homeassistant/#") as later:
            later.publish("mark", "x")  # what is retained comes before it
            later.subscribe("mark2")
            soon(lambda: later.messages, 2)
            return config_topics(later)
    with Folder() as folder, Broker(folder) as broker, Units({3: meter(), 4: meter()}) as line:
        with Client(broker.port, "#") as client, Gateway(program, folder, text_of(broker.port, both(line.name))) as gateway:
            check(soon(lambda: len(kept(broker.port)) == 3, LIMIT), "three are there", kept(broker.port))
            gateway.reload(text_of(broker.port, one(line.name)))
            check(soon(lambda: len(kept(broker.port)) == 2, LIMIT), "at a reload the one that left is emptied", kept(broker.port))
            check(not [each for each in kept(broker.port) if "second" in each], "that one")
            empty = [each for each in client.messages if "second" in each.topic and each.topic.endswith("/config") and not each.payload]
            check(empty, "by an empty message")
            check(flows(client), "the other goes on")
            gateway.reload(text_of(broker.port, both(line.name)))
            check(soon(lambda: len(kept(broker.port)) == 3, LIMIT), "it comes back")
            check(gateway.end() == 0, "ends")
            check(len(kept(broker.port)) == 3, "an end takes nothing away")
        with Gateway(program, folder, text_of(broker.port, one(line.name))) as gateway:
            check(soon(lambda: len(kept(broker.port)) == 2, LIMIT), "what left between two runs is emptied at the start",
                  kept(broker.port))
            gateway.kill()
        # Killed in between: what it had told is known all the same.
        with Gateway(program, folder, text_of(broker.port, fewer(line.name))) as gateway:
            check(soon(lambda: len(kept(broker.port)) == 1, LIMIT), "also behind a kill", kept(broker.port))
            gateway.reload(text_of(broker.port, both(line.name)))
            check(soon(lambda: len(kept(broker.port)) == 3, LIMIT), "three again")
            # Reloaded while the broker hangs: the emptying waits for the connection.
            broker.freeze()
            gateway.reload(text_of(broker.port, one(line.name)))
            time.sleep(9)
            broker.thaw()
            check(soon(lambda: len(kept(broker.port)) == 2, LIMIT), "what left while the broker hung is emptied", kept(broker.port))
        # Another prefix, and none.
        with Gateway(program, folder, text_of(broker.port, one(line.name), discovery="")) as gateway:
            check(soon(lambda: not kept(broker.port), LIMIT), "without discovery nothing stays", kept(broker.port))


def main(check, program, tool, part):
    {"changed": changed, "wrong": wrong, "gone": gone}[part](check, program, tool)


if __name__ == "__main__":
    runs(main)
