# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What Home Assistant takes as a discovery message of MQTT, by what it publishes of its schemas (the pages of MQTT, sensor,
number, select and binary sensor, and the tables of units and of state classes a device class goes with, November 2026).
Stricter than it is in one thing: a key that it would drop without a word is refused.

`complaints(topic, payload)` is what is wrong with one; `Entity` renders its templates as Home Assistant does."""
import datetime
import json
import re

import jinja2
import jinja2.sandbox

TOPIC = re.compile(r"([^/]+)/(\w+)/(?:([a-zA-Z0-9_-]+)/)?([a-zA-Z0-9_-]+)/config")
LONGEST_STATE = 255  # characters

TEXT, NUMBER, WHOLE, FLAG, LIST, TABLE = str, (int, float), int, bool, list, dict
COMMON = {
    "availability": LIST, "availability_mode": TEXT, "availability_topic": TEXT, "availability_template": TEXT,
    "payload_available": TEXT, "payload_not_available": TEXT, "device": TABLE, "origin": TABLE, "enabled_by_default": FLAG,
    "encoding": TEXT, "entity_category": TEXT, "entity_picture": TEXT, "icon": TEXT, "json_attributes_topic": TEXT,
    "json_attributes_template": TEXT, "name": TEXT, "object_id": TEXT, "default_entity_id": TEXT, "qos": WHOLE,
    "unique_id": TEXT, "device_class": TEXT, "value_template": TEXT, "state_topic": TEXT,
}
COMMANDED = {"command_topic": TEXT, "command_template": TEXT, "optimistic": FLAG, "retain": FLAG}
COMPONENTS = {
    "sensor": {**COMMON, "expire_after": WHOLE, "force_update": FLAG, "state_class": TEXT, "unit_of_measurement": TEXT,
               "suggested_display_precision": WHOLE, "options": LIST, "last_reset_value_template": TEXT},
    "binary_sensor": {**COMMON, "expire_after": WHOLE, "force_update": FLAG, "off_delay": NUMBER, "payload_on": TEXT,
                      "payload_off": TEXT},
    "number": {**COMMON, **COMMANDED, "min": NUMBER, "max": NUMBER, "step": NUMBER, "mode": TEXT, "unit_of_measurement": TEXT,
               "payload_reset": TEXT},
    "select": {**COMMON, **COMMANDED, "options": LIST},
}
NEEDED = {"sensor": ("state_topic",), "binary_sensor": ("state_topic",), "number": ("command_topic",),
          "select": ("command_topic", "options")}
AVAILABILITY = {"topic": TEXT, "payload_available": TEXT, "payload_not_available": TEXT, "value_template": TEXT}
DEVICE = {"identifiers": (list, str), "connections": LIST, "manufacturer": TEXT, "model": TEXT, "model_id": TEXT, "name": TEXT,
          "hw_version": TEXT, "sw_version": TEXT, "serial_number": TEXT, "via_device": TEXT, "suggested_area": TEXT,
          "configuration_url": TEXT}
ORIGIN = {"name": TEXT, "sw_version": TEXT, "support_url": TEXT}

# What a device class of a sensor may be measured in, and which state classes go with it, of those that a device on a line
# may have. None: no unit.
MEASURED, COUNTED = {"measurement"}, {"total", "total_increasing"}
VOLUMES = {"L", "mL", "m³", "gal", "fl. oz.", "ft³", "CCF", "MCF"}
CLASSES = {
    "apparent_power": ({"VA", "mVA", "kVA"}, MEASURED),
    "battery": ({"%"}, MEASURED),
    "carbon_dioxide": ({"ppm"}, MEASURED),
    "conductivity": ({"S/cm", "mS/cm", "μS/cm"}, MEASURED),
    "current": ({"A", "mA"}, MEASURED),
    "distance": ({"mm", "cm", "m", "km", "in", "ft", "yd", "mi"}, MEASURED | COUNTED),
    "duration": ({"d", "h", "min", "s", "ms"}, MEASURED | COUNTED),
    "energy": ({"J", "kJ", "MJ", "GJ", "mWh", "Wh", "kWh", "MWh", "GWh", "TWh", "cal", "kcal", "Mcal", "Gcal"}, COUNTED),
    "enum": (set(), set()),
    "frequency": ({"Hz", "kHz", "MHz", "GHz"}, MEASURED),
    "gas": ({"m³", "ft³", "CCF", "L", "MCF"}, COUNTED),
    "humidity": ({"%"}, MEASURED),
    "illuminance": ({"lx"}, MEASURED),
    "irradiance": ({"W/m²", "BTU/(h⋅ft²)"}, MEASURED),
    "moisture": ({"%"}, MEASURED),
    "ph": ({None}, MEASURED),
    "power": ({"mW", "W", "kW", "MW", "GW", "TW"}, MEASURED),
    "power_factor": ({"%", None}, MEASURED),
    "pressure": ({"mbar", "cbar", "bar", "mPa", "Pa", "hPa", "kPa", "MPa", "inHg", "mmHg", "inH₂O", "psi"}, MEASURED),
    "reactive_energy": ({"varh", "kvarh"}, COUNTED),
    "reactive_power": ({"var", "mvar", "kvar"}, MEASURED),
    "speed": ({"mm/d", "mm/h", "mm/s", "m/s", "m/min", "km/h", "in/d", "in/h", "in/s", "ft/s", "mph", "kn", "Beaufort"}, MEASURED),
    "temperature": ({"°C", "°F", "K"}, MEASURED),
    "temperature_delta": ({"°C", "°F", "K"}, MEASURED),
    "timestamp": ({None}, set()),
    "voltage": ({"V", "mV", "μV", "µV", "kV", "MV"}, MEASURED),
    "volume": (VOLUMES, COUNTED),
    "volume_flow_rate": ({"m³/h", "m³/min", "m³/s", "L/h", "L/min", "L/s", "mL/s", "ft³/min", "gal/min", "gal/h"}, MEASURED),
    "volume_storage": (VOLUMES, MEASURED),
    "water": ({"L", "m³", "gal", "ft³", "CCF", "MCF"}, COUNTED),
    "weight": ({"µg", "μg", "mg", "g", "kg", "t", "oz", "lb", "st"}, MEASURED | COUNTED),
}
NOT_OF_NUMBERS = {"enum", "timestamp"}


def typed(what, table, keys):
    for key, value in table.items():
        kinds = keys.get(key)
        if kinds is None:
            yield f"{what}: {key} is no key of it, and would be dropped"
        elif isinstance(value, bool) is not (kinds is bool) or not isinstance(value, kinds):
            yield f"{what}: {key} is {value!r}"


def is_topic(text):
    return isinstance(text, str) and text and not set("+#\0") & set(text) and len(text.encode()) < 65536


def availability(said):
    if "availability" in said and "availability_topic" in said:
        yield "availability and availability_topic at once"
    for each in said.get("availability", []):
        if not isinstance(each, dict):
            yield f"availability: {each!r} is no table"
            continue
        yield from typed("availability", each, AVAILABILITY)
        if not is_topic(each.get("topic")):
            yield f"availability: the topic {each.get('topic')!r}"
    if said.get("availability_mode", "latest") not in ("all", "any", "latest"):
        yield f"availability_mode {said['availability_mode']!r}"


def device(said):
    if "device" not in said:
        return
    yield from typed("device", said["device"], DEVICE)
    if not said["device"].get("identifiers") and not said["device"].get("connections"):
        yield "device: neither identifiers nor connections"
    if "unique_id" not in said:
        yield "a device without unique_id counts for nothing"
    url = said["device"].get("configuration_url")
    if url is not None and not re.match(r"(https?|homeassistant)://.", str(url)):
        yield f"device: configuration_url {url!r}"


def sensor(said):
    of, unit, state = said.get("device_class"), said.get("unit_of_measurement"), said.get("state_class")
    if said.get("entity_category") not in (None, "diagnostic"):
        yield f"the entity category of a sensor is {said['entity_category']!r}"
    if state not in (None, "measurement", "measurement_angle", "total", "total_increasing"):
        yield f"state_class {state!r}"
    if "options" in said and (of != "enum" or state or unit):
        yield "options need the device class enum, and neither state class nor unit"
    if of == "enum" and not said.get("options"):
        yield "the device class enum without options"
    if "last_reset_value_template" in said and state != "total":
        yield "last_reset_value_template without the state class total"
    if said.get("suggested_display_precision", 0) < 0 or said.get("expire_after", 0) < 0:
        yield "a negative number"
    if of is not None:
        if of not in CLASSES:
            yield f"device_class {of!r}"
            return
        units, states = CLASSES[of]
        if units and unit not in units:
            yield f"{of} is not measured in {unit!r}"
        if not units and unit is not None:
            yield f"{of} has no unit"
        if state is not None and state not in states:
            yield f"{of} with the state class {state!r}"


def number(said):
    low, high = said.get("min", 1), said.get("max", 100)
    if low >= high:
        yield f"min {low} is not below max {high}"
    if said.get("step", 1) < 0.001:
        yield f"the step {said['step']}"
    if said.get("mode", "auto") not in ("auto", "box", "slider"):
        yield f"mode {said['mode']!r}"
    of, unit = said.get("device_class"), said.get("unit_of_measurement")
    if of is not None and (of not in CLASSES or of in NOT_OF_NUMBERS or unit not in CLASSES[of][0]):
        yield f"a number of {of!r} in {unit!r}"
    if said.get("entity_category") not in (None, "config", "diagnostic"):
        yield f"entity_category {said['entity_category']!r}"


def select(said):
    options = said.get("options", [])
    if not options or len(set(map(str, options))) != len(options) or not all(isinstance(each, str) for each in options):
        yield f"options {options!r}"


BY_COMPONENT = {"sensor": sensor, "number": number, "select": select, "binary_sensor": lambda said: ()}


def complaints(topic, payload, prefix="homeassistant"):
    """What Home Assistant refuses, drops or warns of."""
    at = TOPIC.fullmatch(topic)
    if not at or at[1] != prefix:
        return [f"{topic}: no topic of discovery"]
    component = at[2]
    if component not in COMPONENTS:
        return [f"{topic}: component {component}"]
    try:
        said = json.loads(payload)
    except ValueError as error:
        return [f"{topic}: no JSON: {error}"]
    if not isinstance(said, dict):
        return [f"{topic}: no table"]
    found = list(typed(component, said, COMPONENTS[component]))
    if found:
        return [f"{topic}: {each}" for each in found]
    found += [f"{key} is missing" for key in (*NEEDED[component], "unique_id", "device") if key not in said]
    found += [f"{key} {said[key]!r}" for key in said if key.endswith("_topic") and not is_topic(said[key])]
    if said.get("qos", 0) not in (0, 1, 2):
        found.append(f"qos {said['qos']}")
    found += [*availability(said), *device(said), *typed("origin", said.get("origin", {}), ORIGIN)]
    if "origin" in said and "name" not in said["origin"]:
        found.append("origin without a name")
    found += BY_COMPONENT[component](said)
    for key in said:
        if key.endswith("_template"):
            try:
                ENVIRONMENT.from_string(said[key])
            except jinja2.TemplateError as error:
                found.append(f"{key}: {error}")
    return [f"{topic}: {each}" for each in found]


# Templates. An undefined name is an error here; there it is a line in the log for each message.

ENVIRONMENT = jinja2.sandbox.ImmutableSandboxedEnvironment(undefined=jinja2.StrictUndefined)


def utc_now():
    return datetime.datetime.now(datetime.timezone.utc)


ENVIRONMENT.globals.update(now=lambda: utc_now().astimezone(), utcnow=utc_now, timedelta=datetime.timedelta,
                           as_timestamp=lambda at: at.timestamp() if hasattr(at, "timestamp") else float(at))
ENVIRONMENT.filters.update(to_json=json.dumps, from_json=json.loads, timestamp_custom=lambda at, form="%Y-%m-%d %H:%M:%S", local=True:
                           datetime.datetime.fromtimestamp(at, None if local else datetime.timezone.utc).strftime(form),
                           as_timestamp=ENVIRONMENT.globals["as_timestamp"], is_defined=lambda value: value)


class Entity:
    """One that was discovered, on its component and its keys."""

    def __init__(self, topic, payload):
        self.topic, self.said, self.component = topic, json.loads(payload), topic.split("/")[1]
        self.name = topic.split("/")[-2]

    def state(self, payload):
        """What it shows behind a message of its state topic; None: unknown, "": as before."""
        template = self.said.get("value_template")
        if template is None:
            return payload
        shown = ENVIRONMENT.from_string(template).render(value=payload, value_json=json.loads(payload)).strip()
        return None if shown in ("None", "unknown") else shown

    def fits(self, shown):
        """Whether its kind takes that."""
        if shown is None or shown == "":
            return True
        if len(shown) > LONGEST_STATE:
            return False
        of_numbers = self.component == "number" or any(
            self.said.get(each) is not None for each in ("state_class", "unit_of_measurement", "suggested_display_precision")) or \
            self.said.get("device_class") not in (None, "enum", "timestamp")
        if self.component in ("sensor", "number") and of_numbers:
            try:
                return float(shown) == float(shown)
            except ValueError:
                return False
        if self.said.get("options"):
            return shown in self.said["options"]
        return True

    def command(self, value):
        """What Home Assistant sends where somebody sets that."""
        template = self.said.get("command_template")
        return str(value) if template is None else ENVIRONMENT.from_string(template).render(value=value)
