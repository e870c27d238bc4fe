# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the gateway tells Home Assistant: every message is one that it takes, every template fits every message of values, and
what it sends back is carried out.

    python3 discovery.py GATEWAY TOOL messages|births
"""
import time

from home_assistant import Entity, complaints
from stand import LIMIT, SITE, Broker, Client, Folder, Gateway, Simulator, Units, a_line, a_meter, flows, meter, runs, soon, text_of


def config_topics(client):
    """Those that have a message, by the last of each."""
    kept = {}
    for each in list(client.messages):
        if each.topic.startswith("homeassistant/") and each.topic.endswith("/config"):
            kept[each.topic] = each.payload.decode()
    return {topic: payload for topic, payload in kept.items() if payload}


def named(entities, component, name):
    return next((each for each in entities if each.component == component and each.name == name), None)


FAN = {"name": "fan", "unit": 7, "drive": "atv320", "registers": ["RFR", "LCR", "ETA", "THD"], "feeds_supervision": True, "every": 0.5}


def messages(check, program, tool):
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Simulator(tool, "atv320:7") as device:
        device_of_meter = a_meter(settings=["set_point", "mode"], groups='[{ registers = ["energy"], every = 60.0 }]')
        text = text_of(broker.port, [a_line(line.name, device_of_meter), a_line(device, FAN, name="line2")])
        with Client(broker.port, "#") as client, Gateway(program, folder, text, "--write"):
            check(flows(client, count=4) and flows(client, "line2/fan", count=3), "values come")
            check(soon(lambda: len(config_topics(client)) >= 11, LIMIT), "all are discovered", sorted(config_topics(client)))
            found = [each for topic, payload in config_topics(client).items() for each in complaints(topic, payload)]
            check(not found, "Home Assistant takes each", found)
            entities = [Entity(*each) for each in config_topics(client).items()]
            check(len({each.said["unique_id"] for each in entities}) == len(entities), "each has an identity of its own")
            for each in entities:
                line_name, device_name = ("line2", "fan") if "fan" in each.topic else ("line1", "meter")
                topics = [one["topic"] for one in each.said.get("availability", [])]
                check(sorted(topics) == sorted([f"{SITE}/status", f"{SITE}/{line_name}/availability",
                                                f"{SITE}/{line_name}/{device_name}/availability"]) and
                      each.said.get("availability_mode") == "all", f"{each.name}: gone where the gateway, the line or the device is",
                      each.said.get("availability"))
                check(each.said.get("state_topic") == f"{SITE}/{line_name}/{device_name}/state", f"{each.name}: its values' topic",
                      each.said.get("state_topic"))
                if each.component == "sensor":
                    period = 60.0 if each.name == "energy" else 0.5
                    check(each.said.get("expire_after") == max(5, 3 * period), f"{each.name}: unavailable after three periods",
                          each.said.get("expire_after"))
                # Every message of its topic.
                wrong = []
                for message in client.of(each.said.get("state_topic")):
                    try:
                        shown = each.state(message.payload.decode())
                        if not each.fits(shown):
                            wrong.append((shown, message.payload))
                    except Exception as error:  # pylint: disable=broad-except
                        wrong.append((repr(error), message.payload))
                check(not wrong, f"{each.component} {each.name}: its template fits every message", wrong[:2])
            for name, of, unit, state in (("voltage", "voltage", "V", "measurement"), ("power", "power", "W", "measurement"),
                                          ("energy", "energy", "kWh", "total_increasing"), ("RFR", "frequency", "Hz", "measurement"),
                                          ("LCR", "current", "A", "measurement")):
                each = named(entities, "sensor", name)
                check(each and (each.said.get("device_class"), each.said.get("unit_of_measurement"), each.said.get("state_class")) ==
                      (of, unit, state), f"{name} is {of} in {unit}", each and each.said)
            each = named(entities, "sensor", "voltage")
            check(each and each.said.get("suggested_display_precision") == 1, "the digits that the scale has", each and each.said)
            each = named(entities, "sensor", "ETA")
            check(each and not {"state_class", "suggested_display_precision", "unit_of_measurement", "device_class"} & set(each.said),
                  "a status word is no measurement", each and each.said)
            check(not [each for each in entities if each.component != "sensor" and "fan" in each.topic], "of a drive nothing is set")
            check(not [each for each in entities if each.component != "sensor" and each.name not in ("set_point", "mode")],
                  "nor what the file does not name")
            each = named(entities, "number", "set_point")
            check(each is not None, "a setting is a number", sorted(config_topics(client)))
            said = each.said
            check((said.get("min"), said.get("max"), said.get("step"), said.get("mode"), said.get("entity_category")) ==
                  (5, 60, 0.1, "box", "config") and not said.get("optimistic") and not said.get("retain") and
                  said.get("command_topic") == f"{SITE}/line1/meter/set/set_point" and said.get("unit_of_measurement") == "°C",
                  "with its limits, in a box, never assumed and never retained", said)
            client.publish(said["command_topic"], each.command(22.5))
            check(soon(lambda: line.units[3][10] == 225, LIMIT), "what Home Assistant sends is written", line.writes)
            check(soon(lambda: '"done"' in (client.last(f"{SITE}/line1/meter/answer/set_point") or ""), LIMIT), "and answered",
                  client.last(f"{SITE}/line1/meter/answer/set_point"))
            check(soon(lambda: each.state(client.last(f"{SITE}/line1/meter/state")) == "22.5", LIMIT), "and shown")
            # A whole number comes without a point.
            time.sleep(1)
            client.publish(said["command_topic"], each.command(30))
            check(soon(lambda: line.units[3][10] == 300, LIMIT), "a whole number, too", line.writes)
            line.units[3][1] = 0x7FFF
            since = time.time()
            check(flows(client, since=since + 0.5), "values go on")
            power = named(entities, "sensor", "power")
            check(power.state(client.last(f"{SITE}/line1/meter/state")) is None, "an invalid value is unknown there",
                  client.last(f"{SITE}/line1/meter/state"))
        # Without --write nothing can be set.
        with Client(broker.port, "#") as client, Gateway(program, folder, text):
            check(flows(client), "values come")
            soon(lambda: len(config_topics(client)) >= 10, LIMIT)
            offered = [topic for topic, payload in config_topics(client).items() if "/sensor/" not in topic]
            check(not offered, "without --write no setting is offered", offered)


def births(check, program, _):
    """Home Assistant begins: all is told again; and anybody else's word there is none."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "#") as client:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage", "power"]))])):
            check(flows(client), "values come")
            check(soon(lambda: len(config_topics(client)) == 2, LIMIT), "two are discovered", sorted(config_topics(client)))

            def told():
                return sum(each.topic.endswith("/config") for each in list(client.messages))
            before = told()
            client.publish("homeassistant/status", "online")
            check(soon(lambda: told() >= before + 2, LIMIT), "its birth: told again", told() - before)
            before = told()
            client.publish("homeassistant/status", "offline")
            check(flows(client, count=3) and told() == before, "its end: nothing", told() - before)
            empty = [each for each in client.messages if each.topic.endswith("/config") and not each.payload]
            check(not empty, "nothing was emptied", empty)
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage", "power"]))], site="other",
                                              discovery="house")):
            check(soon(lambda: client.last("rtuwire/other/g1/line1/meter/availability") == "online", LIMIT), "values come")
            check(soon(lambda: sum(each.topic.startswith("house/sensor/") for each in list(client.messages)) == 2, LIMIT),
                  "under another prefix, which the file says")
            client.publish("house/status", "online")
            check(soon(lambda: sum(each.topic.startswith("house/sensor/") for each in list(client.messages)) == 4, LIMIT),
                  "where the birth is heard, too")


def main(check, program, tool, part):
    {"messages": messages, "births": births}[part](check, program, tool)


if __name__ == "__main__":
    runs(main)
