# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a fleet asks of one broker: the sizes of a gateway's messages as they pass, measured at a mosquitto, times gateways,
devices and periods; and how many retained messages a second that mosquitto takes here.

    python3 scale.py GATEWAY
"""
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(1, str(ROOT / "tests" / "gateway" / "process"))

from stand import Broker, Client, Folder, Gateway, Units, a_line, a_meter, flows, soon, text_of  # noqa: E402
from mqtt import DISCONNECT, PUBLISH, packet, text  # noqa: E402

GATEWAYS, DEVICES, VALUES = 100, 300, 10
PERIODS = (1.0, 10.0, 60.0)


def register_file():
    return "".join(f'[[register]]\nname = "value_{number}"\nspace = "input"\naddress = {number}\nscale = 0.1\nunit = "V"\n\n'
                   for number in range(VALUES))


def bytes_on_the_way(message):
    return len(packet(PUBLISH, text(message.topic) + message.payload))


def measured(program):
    """The mean size of each kind of message, in bytes with the header of MQTT."""
    with Folder() as folder, Broker(folder) as broker, \
            Units({unit: {number: 2300 + number for number in range(VALUES)} for unit in (1, 2, 3)}) as line:
        (folder / "values.toml").write_text(register_file(), encoding="utf-8")
        devices = [a_meter(f"device{unit:03}", unit, file="values.toml") for unit in (1, 2, 3)]
        with Client(broker.port, "#") as client, Gateway(program, folder, text_of(broker.port, [a_line(line.name, *devices)])):
            if not flows(client, "line1/device001", count=5):
                raise RuntimeError("no values come")
            soon(lambda: sum(each.topic.endswith("/config") for each in client.messages) >= 3 * VALUES)
        kinds = {}
        for each in client.messages:
            kind = each.topic.rpartition("/")[2] if not each.topic.endswith("/line1/status") else "line status"
            kinds.setdefault(kind, []).append(bytes_on_the_way(each))
        return {kind: sum(sizes) / len(sizes) for kind, sizes in kinds.items()}


def taken(size, count=50_000):
    """Retained messages of that size, each of its own topic, that mosquitto takes in a second."""
    with Folder() as folder, Broker(folder, "max_queued_messages 0") as broker, Client(broker.port) as client:
        payload = b"x" * (size - 60)
        data = b"".join(packet(PUBLISH, text(f"homeassistant/sensor/storm/topic_{number:06}/config") + payload, 1)
                        for number in range(count))
        began = time.monotonic()
        client.send(data)
        client.publish("end", "x")
        took = time.monotonic() - began
        client.send(packet(DISCONNECT, b""))
        resident = int(pathlib.Path(f"/proc/{broker.process.pid}/status").read_text(encoding="ascii").split("VmRSS:")[1].split()[0])
        return count / took, resident * 1024 / count


def main(program):
    sizes = measured(program)
    for kind, size in sorted(sizes.items()):
        print(f"{kind:<14}{size:8.0f} bytes")
    print(f"\n{GATEWAYS} gateways of {DEVICES} devices with {VALUES} values each, on 10 lines:")
    for period in PERIODS:
        states = GATEWAYS * DEVICES / period
        beats = GATEWAYS * 10
        print(f"every {period:4.0f} s: {states + beats:8.0f} messages/s, "
              f"{(states * sizes['state'] + beats * sizes['line status']) / 1e6:6.2f} MB/s to the broker, "
              f"as much to each subscriber of all")
    retained = GATEWAYS * (DEVICES * (VALUES + 1) + 11)
    rate, memory = taken(round(sizes["config"]))
    print(f"retained: {retained} topics, {GATEWAYS * DEVICES * VALUES * sizes['config'] / 1e6:.0f} MB of discovery; "
          f"mosquitto takes {rate:.0f} of them a second here and keeps each in {memory:.0f} bytes: "
          f"{retained / rate:.0f} s and {retained * memory / 1e6:.0f} MB for all")


if __name__ == "__main__":
    main(*sys.argv[1:])
