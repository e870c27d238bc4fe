# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Subscribers of others see what is promised, also behind a broker that was away: mqtt of npm, and Node-RED.

    python3 npm.py GATEWAY TOOL mqtt|node_red      (NODE_PATH names their folder)
"""
import json
import os
import subprocess
import time
import urllib.request

from home_assistant import complaints
from stand import HERE, LIMIT, SITE, Broker, Client, Folder, Gateway, Units, a_line, a_meter, flows, meter, runs, soon, text_of, when


def mqtt(check, program, _):
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage", "power", "energy"]))])):
            with Client(broker.port, "#") as client:
                check(flows(client), "values come")
            for version in (4, 5):
                with subprocess.Popen(["node", str(HERE / "subscriber.js"), str(broker.port), "20", str(version)],
                                      stdout=subprocess.PIPE, text=True) as node:
                    check("ready" in node.stdout.readline(), f"version {version} subscribes")
                    time.sleep(4)
                    broker.kill()
                    killed = time.time()
                    time.sleep(2)
                    broker.again()
                    again = time.time()
                    heard = [json.loads(each) for each in node.communicate()[0].splitlines()]
                heard = [each for each in heard if "topic" in each]
                values = [each for each in heard if each["topic"] == f"{SITE}/line1/meter/state"]
                for since, until, what in ((0, killed, "before"), (again, again + 60, "behind")):
                    ages = [each["arrived"] - when(json.loads(each["payload"])["time"]) for each in values
                            if since < each["arrived"] < until]
                    check(ages and min(ages) < 1 and not any(each["retained"] or each["qos"] for each in values),
                          f"version {version}: values {what} the restart", [round(each, 2) for each in ages])
                configs = {each["topic"]: each["payload"] for each in heard if each["topic"].endswith("/config")}
                check(len(configs) == 3 and not [one for each in configs.items() for one in complaints(*each)],
                      f"version {version}: discovery", configs)
                last = [each["payload"] for each in heard if each["topic"] == f"{SITE}/status"][-1]
                check(last == "online", f"version {version}: online", last)


FLOW = [
    {"id": "tab", "type": "tab", "label": "test"},
    {"id": "broker", "type": "mqtt-broker", "broker": "127.0.0.1", "port": "PORT", "clientid": "", "usetls": False,
     "protocolVersion": "4", "keepalive": "60", "cleansession": True, "autoConnect": True},
    {"id": "in", "type": "mqtt in", "z": "tab", "topic": f"{SITE}/+/+/state", "qos": "0", "datatype": "json", "broker": "broker",
     "wires": [["keep"]]},
    {"id": "keep", "type": "function", "z": "tab", "func": "flow.set('last', msg.payload); flow.set('count', (flow.get('count') || 0) + 1);",
     "outputs": 0, "wires": []},
    {"id": "asked", "type": "http in", "z": "tab", "url": "/last", "method": "get", "wires": [["tell"]]},
    {"id": "tell", "type": "function", "z": "tab", "outputs": 1,
     "func": "msg.payload = {last: flow.get('last'), count: flow.get('count')}; return msg;", "wires": [["answer"]]},
    {"id": "answer", "type": "http response", "z": "tab", "statusCode": "", "wires": []},
]


def node_red(check, program, _):
    """A flow of the palette's own nodes takes the values without anything added."""
    red = os.path.join(os.environ["NODE_PATH"], "node-red", "red.js")
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        at = broker.port + 1
        home = folder / "red"
        home.mkdir()
        (home / "flows.json").write_text(json.dumps(FLOW).replace('"PORT"', f'"{broker.port}"'), encoding="utf-8")
        (home / "settings.js").write_text(f"module.exports = {{ uiPort: {at}, uiHost: '127.0.0.1', flowFile: 'flows.json', "
                                          "httpAdminRoot: false, telemetry: { enabled: false } };\n", encoding="utf-8")
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, a_meter(registers=["voltage"]))])):
            with subprocess.Popen(["node", red, "--userDir", str(home)], stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT) as node:
                try:
                    def told():
                        try:
                            with urllib.request.urlopen(f"http://127.0.0.1:{at}/last", timeout=5) as answer:
                                return json.load(answer)
                        except (OSError, ValueError):
                            return {}
                    check(soon(lambda: told().get("count", 0) > 3, LIMIT), "Node-RED takes values", told())
                    voltage = told().get("last", {}).get("values", {}).get("voltage", {})
                    check((voltage.get("value"), voltage.get("unit")) == (230.1, "V"), "with name and unit", voltage)
                finally:
                    node.terminate()


def main(check, program, tool, part):
    {"mqtt": mqtt, "node_red": node_red}[part](check, program, tool)


if __name__ == "__main__":
    runs(main)
