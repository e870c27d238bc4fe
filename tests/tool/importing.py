# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Files of other programs become register files: what is in them, what is told of the rest, and that each passes the tool's own
check. All are written by hand here, in the forms of which the programs' manuals tell."""
import json
import random
import sys
import time
import tomllib

from support import DIFFERS, DONE, USAGE, Tool, runs

WIRENBOARD = """// A template with comments.
{
    "device_type": "MTR1", /* and another */
    "device": {
        "name": "MTR1", "id": "mtr1", "max_read_registers": 60, "guard_interval_us": 5500,
        "channels": [
            {"name": "Voltage L1", "reg_type": "input", "address": "0x00", "type": "voltage", "format": "float"},
            {"name": "Energy", "reg_type": "input", "address": 6, "format": "u32", "scale": 0.01, "units": "kWh",
             "word_order": "little_endian", "error_value": "0xFFFFFFFF"},
            {"name": "Counter", "reg_type": "input", "address": 20, "format": "u64", "byte_order": "little_endian"},
            {"name": "Setpoint", "reg_type": "holding", "address": 40, "format": "s16", "scale": 0.1, "offset": -50,
             "units": "deg C", "min": -10, "max": 95.5, "round_to": 0.1},
            {"name": "Flags 4..7", "reg_type": "holding", "address": "41:4:4"},
            {"name": "Ready", "reg_type": "holding", "address": "41:3:1", "readonly": true},
            {"name": "Relay", "reg_type": "coil", "address": 3, "type": "switch"},
            {"name": "Door", "reg_type": "discrete", "address": 7},
            {"name": "Label", "reg_type": "holding", "address": 50, "format": "string8", "string_data_size": 4, "readonly": true},
            {"name": "Mode", "reg_type": "holding", "address": 60, "enum": [0, 1], "enum_titles": ["Off", "Eco heat"]},
            {"name": "Fine power", "reg_type": "input", "address": 80, "format": "s32", "scale": 1.52588e-5, "units": "W"},
            {"name": "Old text", "reg_type": "holding", "address": 90, "format": "string", "string_data_size": 4},
            {"name": "Again", "reg_type": "input", "address": 1, "condition": "a==1"},
            {"name": "Pair", "consists_of": []}
        ],
        "parameters": {"baud": {"title": "Baud rate", "reg_type": "holding", "address": 110, "default": 96}}
    }
}
"""

HOME_ASSISTANT = """
# A part of a configuration.
modbus:
  - name: hub
    type: serial
    port: /dev/ttyUSB0
    message_wait_milliseconds: 30
    sensors:
      - {name: Flow, address: 0x10, device_address: 5, input_type: input, data_type: float32, swap: word, unit_of_measurement: m³/h}
      - {name: Outside, address: 4, slave: 5, scale: 0.1, offset: -40, unit_of_measurement: "°C", nan_value: 0x8000}
      - {name: Maker, address: 20, slave: 5, data_type: string, count: 4}
      - {name: Odd, address: 30, slave: 5, data_type: custom, structure: ">3H"}
      - {name: Long, address: 40, slave: 5, data_type: uint64, swap: word_byte, min_value: 0}
      - {name: Elsewhere, address: 1, slave: 6}
      - {name: Hidden, address: !secret place}
    binary_sensors:
      - {name: Alarm, address: 2, slave: 5}
      - {name: Running, address: 3, slave: 5, input_type: holding}
    switches:
      - {name: Pump, address: 1, slave: 5, write_type: coil}
      - {name: Boost, address: 7, slave: 5, command_on: 2, command_off: 1, verify: {delay: 1}}
    climates:
      - {name: Room, address: 50, slave: 5, target_temp_register: 51, scale: 0.1, min_temp: 5, max_temp: 30, hvac_mode_register: {address: 60}}
"""

ESPHOME = """
esphome: {name: test}
modbus: {id: bus}
modbus_controller:
  - {id: boiler, address: 0x0B, command_throttle: 50ms}
sensor:
  - platform: modbus_controller
    modbus_controller_id: boiler
    name: "Supply"
    register_type: read
    address: 100
    value_type: S_WORD
    unit_of_measurement: "°C"
    filters:
      - multiply: 0.5
      - offset: -10
      - throttle: 5s
  - {platform: modbus_controller, name: Energy, register_type: holding, address: 200, value_type: U_DWORD_R}
  - platform: modbus_controller
    name: Computed
    register_type: holding
    address: 210
    unit_of_measurement: kW
    lambda: |-
      return x / 7;
  - {platform: adc, pin: 3}
binary_sensor:
  - {platform: modbus_controller, name: Fault, register_type: holding, address: 220, bitmask: 0x10}
number:
  - {platform: modbus_controller, name: Target, address: 230, value_type: S_WORD, multiply: 10, min_value: 5, max_value: 80}
select:
  - platform: modbus_controller
    name: Mode
    address: 240
    optionsmap: {"Off": 0, "Heat": 2}
switch:
  - {platform: modbus_controller, name: Enable, register_type: coil, address: 5}
text_sensor:
  - {platform: modbus_controller, name: Serial, register_type: holding, address: 250, register_count: 3}
"""

TELEGRAF = """
[agent]
interval = "10s"
[[inputs.modbus]]
  name = "meter"
  slave_id = 3
  controller = "tcp://localhost:502"
  configuration_type = "register"
  discrete_inputs = [ { name = "start", address = [0]} ]
  coils = [ { name = "motor run", address = [1]} ]
  holding_registers = [
    { name = "power_factor", byte_order = "AB", data_type = "FIXED", scale = 0.01, address = [8] },
    { name = "energy", byte_order = "CDAB", data_type = "UFIXED", scale = 0.001, address = [5, 6] },
    { name = "torn", byte_order = "ABCD", data_type = "UFIXED", scale = 1.0, address = [30, 32] },
    { name = "half", byte_order = "AB", data_type = "FLOAT16-IEEE", address = [40] },
  ]
  input_registers = [ { name = "level", byte_order = "BA", data_type = "INT16", scale = 1.0, address = [0] } ]
  [inputs.modbus.workarounds]
    pause_between_requests = "15ms"
[[inputs.modbus]]
  name = "other style"
  configuration_type = "request"
  [[inputs.modbus.request]]
    slave_id = 3
    byte_order = "DCBA"
    register = "input"
    fields = [
      { address = 100, name = "voltage", type = "FLOAT32" },
      { address = 102, name = "left out", type = "INT16", omit = true },
      { address = 103, name = "counter", type = "UINT64", scale = 0.5 },
    ]
"""

SUNSPEC = """
{"id": 901, "group": {"name": "meter", "type": "group", "label": "A meter", "points": [
    {"name": "ID", "type": "uint16", "size": 1, "value": 901}, {"name": "L", "type": "uint16", "size": 1},
    {"name": "Mn", "type": "string", "size": 4}, {"name": "A", "type": "uint16", "size": 1, "sf": "A_SF", "units": "A"},
    {"name": "A_SF", "type": "sunssf", "size": 1}, {"name": "T", "type": "int16", "size": 1, "sf": -1, "units": "C"},
    {"name": "St", "type": "enum16", "size": 1, "symbols": [{"name": "OFF", "value": 1}, {"name": "RUN", "value": 4}]},
    {"name": "Evt", "type": "bitfield32", "size": 2, "symbols": [{"name": "GROUND", "value": 0}]},
    {"name": "Pad", "type": "pad", "size": 1}, {"name": "E", "type": "acc64", "size": 4, "units": "Wh", "access": "RW"},
    {"name": "MAC", "type": "eui48", "size": 4}, {"name": "F", "type": "float32", "size": 2}],
  "groups": [{"name": "in", "type": "group", "count": 2, "points": [{"name": "V", "type": "uint16", "size": 1}]},
             {"name": "more", "type": "group", "count": 0, "points": [{"name": "X", "type": "uint16", "size": 1}]}]}}
"""

SOURCES = {"wirenboard.json": WIRENBOARD, "home_assistant.yaml": HOME_ASSISTANT, "esphome.yaml": ESPHOME,
           "telegraf.conf": TELEGRAF, "sunspec.json": SUNSPEC}


def imported(tool, check, name, text, *more):
    """What a file becomes: its registers by name, the file's own table, and what was told. What comes out passes the check."""
    (tool.place / name).write_text(text)
    ended = tool.run("device", "import", name, *more, limit=300)  # a thousand names, with the sanitizers, beside other tests
    check(ended.status in (DONE, DIFFERS), f"{name} is imported", ended)
    (tool.place / "out.toml").write_text(ended.output)
    checked = tool.run("device", "check", "out.toml", limit=300)
    check(checked.status == DONE, f"what {name} became passes the check", checked)
    read = tomllib.loads(ended.output)
    return {each["name"]: each for each in read["register"]}, read, ended


def check_told(check, name, text, ended, pairs):
    """What is told of the line that has a text."""
    for where, says in pairs:
        line = text[:text.index(where)].count("\n") + 1
        told = [each for each in ended.errors.splitlines() if f"{name}:{line}:" in each]
        check(any(says in each for each in told), f"line {line}: {says}", ended.errors)


def compare(check, found, wanted):
    for name, register in wanted.items():
        check(found.get(name) == {"name": name, **register}, name, found.get(name))
    check(set(found) == set(wanted), "no other registers", set(found) ^ set(wanted))


def check_wirenboard(tool, check):
    found, file, ended = imported(tool, check, "wirenboard.json", WIRENBOARD)
    compare(check, found, {
        "Voltage_L1": {"space": "input", "address": 0, "type": "f32", "unit": "V"},
        "Energy": {"space": "input", "address": 6, "type": "u32", "order": "cdab", "scale": 0.01, "unit": "kWh",
                   "invalid": 0xFFFFFFFF},
        "Counter": {"space": "input", "address": 20, "type": "u64", "order": "badc"},
        "Setpoint": {"address": 40, "type": "i16", "scale": 0.1, "offset": -50, "unit": "degC", "access": "write", "min": -10,
                     "max": 95.5},
        "Flags_4_7": {"address": 41, "bits": "4-7"},
        "Ready": {"address": 41, "bits": "3"},
        "Relay": {"space": "coil", "address": 3, "access": "write"},
        "Door": {"space": "discrete", "address": 7},
        "Label": {"address": 50, "type": "text8"},
        "Mode": {"address": 60, "access": "write", "choices": {"Off": 0, "Eco_heat": 1}},
        "Fine_power_raw": {"space": "input", "address": 80, "type": "i32"},
        "baud": {"address": 110, "access": "write", "setting": True}})
    check(file["device"] == {"max_registers": 60, "pause": 6}, "limits of requests", file.get("device"))
    check(ended.status == DIFFERS, "something was lost", ended)
    check_told(check, "wirenboard.json", WIRENBOARD, ended, (
        ("Fine power", "Fine power is carried over as Fine_power_raw"), ("Old text", "'string'"), ("Again", "condition = a==1"),
        ("Again", "are those of Voltage_L1"), ("Pair", "made of several registers"), ("Baud", "default = 96")))
    small = '{"device": {"name": "M", "channels": [{"name": "V", "reg_type": "input", "address": 1}]}}'
    check(imported(tool, check, "small.json", small)[2].status == DONE, "nothing was lost")
    module = small.replace('"name": "M"', '"name": "M", "protocol": "modbus_io"')
    (tool.place / "module.json").write_text(module)
    ended = tool.run("device", "import", "module.json")
    check(ended.status == USAGE and "--base" in ended.errors, "a module needs its place", ended)
    check(imported(tool, check, "module.json", module, "--base", 1000)[0]["V"]["address"] == 1001, "a module's place")
    for words in (["small.json", "--base", 1000], ["wirenboard.json", "small.json"], []):
        check(tool.run("device", "import", *words).status == USAGE, f"import {words}")


def check_home_assistant(tool, check):
    found, file, ended = imported(tool, check, "home_assistant.yaml", HOME_ASSISTANT)
    compare(check, found, {
        "Flow": {"space": "input", "address": 16, "type": "f32", "order": "cdab", "unit": "m³/h"},
        "Outside": {"address": 4, "type": "i16", "scale": 0.1, "offset": -40, "unit": "°C", "invalid": 0x8000},
        "Maker": {"address": 20, "type": "text8"},
        "Long": {"address": 40, "type": "u64", "order": "dcba"},
        "Alarm": {"space": "coil", "address": 2},
        "Running": {"address": 3, "bits": "0"},
        "Pump": {"space": "coil", "address": 1, "access": "write"},
        "Boost": {"address": 7, "access": "write", "choices": {"off": 1, "on": 2}},
        "Room_current": {"address": 50, "type": "i16", "scale": 0.1, "unit": "degC"},
        "Room_target": {"address": 51, "type": "i16", "scale": 0.1, "unit": "degC", "access": "write", "min": 5, "max": 30}})
    check(file["device"] == {"pause": 30} and "# Unit 5." in ended.output, "unit and pause", ended)
    check_told(check, "home_assistant.yaml", HOME_ASSISTANT, ended, (
        ("Odd", "data_type 'custom'"), ("Odd", "structure"), ("Long", "min_value"), ("Elsewhere", "import it with -u 6"),
        ("Hidden", "!secret"), ("Boost", "verify"), ("Room", "hvac_mode_register")))
    found = imported(tool, check, "home_assistant.yaml", HOME_ASSISTANT, "-u", 6)[0]
    check(list(found) == ["Elsewhere"], "the other unit", found)


def check_esphome(tool, check):
    found, file, ended = imported(tool, check, "esphome.yaml", ESPHOME)
    compare(check, found, {
        "Supply": {"space": "input", "address": 100, "type": "i16", "scale": 0.5, "offset": -10, "unit": "°C"},
        "Energy": {"address": 200, "type": "u32", "order": "cdab"},
        "Computed_raw": {"address": 210},
        "Fault": {"address": 220, "bits": "4"},
        "Target": {"address": 230, "type": "i16", "scale": 0.1, "access": "write", "min": 5, "max": 80},
        "Mode": {"address": 240, "access": "write", "choices": {"Off": 0, "Heat": 2}},
        "Enable": {"space": "coil", "address": 5, "access": "write"},
        "Serial": {"address": 250, "type": "text6"}})
    check(file["device"] == {"pause": 50} and "# Unit 11." in ended.output, "unit and pause", ended)
    check_told(check, "esphome.yaml", ESPHOME, ended, (("- platform: modbus_controller\n    name: Computed", "made by a lambda in line"),))


def check_what_is_written(tool, check):
    """What is written means something else than the register's number: read only, and by another name."""
    text = """modbus_controller: {id: c, address: 5}
switch:
  - {platform: modbus_controller, name: Lambda, register_type: coil, address: 3, write_lambda: "return !x;"}
  - {platform: modbus_controller, name: Turned, register_type: coil, address: 4, inverted: true}
  - {platform: modbus_controller, name: Moved, register_type: coil, address: 10, offset: 5}
  - {platform: modbus_controller, name: Plain, register_type: coil, address: 20, inverted: false, offset: 0}
number:
  - {platform: modbus_controller, name: Speed, address: 1, write_lambda: "return x * 5;"}
output:
  - {platform: modbus_controller, id: fan, address: 2, register_type: holding, inverted: true}
"""
    found, _, ended = imported(tool, check, "written.yaml", text)
    compare(check, found, {
        "Lambda_raw": {"space": "coil", "address": 3}, "Turned_raw": {"space": "coil", "address": 4},
        "Moved_raw": {"space": "coil", "address": 10}, "Plain": {"space": "coil", "address": 20, "access": "write"},
        "Speed_raw": {"address": 1}, "fan_raw": {"address": 2}})
    check_told(check, "written.yaml", text, ended, (("Lambda", "write_lambda"), ("Turned", "inverted"), ("Moved", "offset"),
                                                    ("Speed", "write_lambda"), ("fan", "inverted")))
    text = """modbus:
  - name: h
    switches:
      - {name: Turned, slave: 5, address: 40, write_type: coil, command_on: 0, command_off: 1}
      - {name: Plain, slave: 5, address: 41, write_type: coil, command_on: 1, command_off: 0}
      - {name: Word, slave: 5, address: 42, command_on: 0, command_off: 1}
      - {name: Text, slave: 5, address: 43, command_on: 15, command_off: abc}
"""
    found, _, ended = imported(tool, check, "coils.yaml", text)
    compare(check, found, {
        "Turned_raw": {"space": "coil", "address": 40}, "Plain": {"space": "coil", "address": 41, "access": "write"},
        "Word": {"address": 42, "access": "write", "choices": {"on": 0, "off": 1}}, "Text_raw": {"address": 43}})
    check_told(check, "coils.yaml", text, ended, (("Turned", "on where the coil is off"), ("Text", "command_off is no whole number")))


def check_devices(tool, check):
    """One unit number behind two lines: two devices. The first is imported, and the other told."""
    for name, text in (("hubs.yaml", """modbus:
  - name: lineA
    sensors: [{name: a, slave: 5, address: 1}]
  - name: lineB
    sensors:
      - {name: b, slave: 5, address: 2}
"""), ("controllers.yaml", """modbus_controller:
  - {id: m1, modbus_id: lineA, address: 5}
  - {id: m2, modbus_id: lineB, address: 5}
sensor:
  - {platform: modbus_controller, modbus_controller_id: m1, name: a, register_type: holding, address: 1}
  - {platform: modbus_controller, modbus_controller_id: m2, name: b, register_type: holding, address: 2}
  - {platform: modbus_controller, modbus_controller_id: m3, name: c, register_type: holding, address: 3}
  - {platform: modbus_controller, name: d, register_type: holding, address: 4}
"""), ("plugins.conf", """[[inputs.modbus]]
controller = "file:///dev/lineA"
slave_id = 5
holding_registers = [ { name = "a", data_type = "INT16", address = [1] } ]
[[inputs.modbus]]
controller = "file:///dev/lineB"
slave_id = 5
holding_registers = [ { name = "b", data_type = "INT16", address = [2] } ]
""")):
        found, _, ended = imported(tool, check, name, text)
        check(list(found) == ["a"] and ended.status == DIFFERS, f"{name}: one device", ended)
        check("b is left out: it is of another device, behind" in ended.errors and "lineB" in ended.errors, f"{name}: the other", ended)
        for each in "cd" if name == "controllers.yaml" else "":
            check(f"{each} is left out: nobody says of which unit" in ended.errors, f"{each} is told", ended)
    text = "modbus: [{name: h, sensors: [{name: a, slave: 5, address: 1}, {name: b, slave: !secret x, address: 2}]}]"
    found, _, ended = imported(tool, check, "secret.yaml", text)
    check(list(found) == ["a"] and "b is left out: nobody says of which unit" in ended.errors, "a unit that nobody says", ended)


def check_no_numbers(tool, check):
    """A scale or an offset that is none: what is held is not the value."""
    for scale in ("1_0", '"0,1"', ".inf", "abc"):
        text = "modbus: [{name: h, sensors: [" + ",".join(
            f"{{name: {key}, slave: 5, address: {i}, {key}: {scale}}}" for i, key in enumerate(("scale", "offset"))) + "]}]"
        found, _, ended = imported(tool, check, "scales.yaml", text)
        check(list(found) == ["scale_raw", "offset_raw"] and "its offset is no number" in ended.errors, f"scale {scale}", ended)
    text = '{"device": {"channels": [{"name": "V", "reg_type": "holding", "address": 1, "scale": "0,1"}]}}'
    found, _, ended = imported(tool, check, "scales.json", text)
    check(found == {"V_raw": {"name": "V_raw", "address": 1}}, "a channel's scale", ended)


def check_beyond(tool, check):
    """A number for no value that no register holds; what a bit and limits become of what is written."""
    text = "modbus: [{name: h, sensors: [" + ",\n".join(
        f"{{name: {name}, slave: 5, address: {i}, data_type: {kind}, nan_value: {number}}}" for i, (name, kind, number) in enumerate((
            ("small", "uint16", "0xFFFFF"), ("low", "int16", -32769), ("right", "int16", -32768), ("same", "uint16", 65535)))) + "]}]"
    found, _, ended = imported(tool, check, "nan.yaml", text)
    compare(check, found, {"small": {"address": 0}, "low": {"address": 1, "type": "i16"}, "right": {"address": 2, "type": "i16", "invalid": 0x8000},
                           "same": {"address": 3, "invalid": 0xFFFF}})
    check_told(check, "nan.yaml", text, ended, (("small", "nan_value 0xFFFFF is left out: it is beyond 16 bits"), ("low", "beyond 16 bits")))
    text = """{"device": {"parameters": [
{"id": "scaled", "address": 10, "reg_type": "holding", "format": "s16", "scale": 0.1, "min": -5, "max": 20, "enum": [0, 1], "enum_titles": ["a", "b"]},
{"id": "narrow", "address": 11, "reg_type": "holding", "min": 0, "max": 1, "enum": [0, 1, 2], "enum_titles": ["a", "b", "c"]}],
"channels": [
{"name": "bit", "reg_type": "holding", "address": "31:5:1", "type": "switch"},
{"name": "half", "reg_type": "holding", "address": 32, "format": "u8", "type": "range"},
{"name": "shown", "reg_type": "holding", "address": "33:5:1", "readonly": true}]}}"""
    found, _, ended = imported(tool, check, "limits.json", text)
    compare(check, found, {
        "scaled": {"address": 10, "type": "i16", "scale": 0.1, "access": "write", "min": -5, "max": 20, "setting": True},
        "narrow": {"address": 11, "access": "write", "choices": {"a": 0, "b": 1}, "setting": True},
        "bit": {"address": 31, "bits": "5"}, "half": {"address": 32, "bits": "0-7"}, "shown": {"address": 33, "bits": "5"}})
    check_told(check, "limits.json", text, ended, (("scaled", "choices are left out"), ("narrow", "'c' is beyond its limits"),
                                                   ('"bit"', "read only here"), ("half", "read only here")))
    check("shown" not in ended.errors, "what the file itself reads only", ended)


def check_unclear(tool, check):
    """A number that is octal to some, and a name that stands twice."""
    home = """modbus:
  - name: h
    sensors:
      - {name: right, slave: 5, address: 1}
      - {name: octal, slave: 5, address: 010}
      - {name: twice, slave: 5, address: 3, address: 4}
      - {name: times, slave: 5, address: 6, scale: 00.5}
"""
    boiler = """modbus_controller: {id: c, address: 5}
sensor:
  - {platform: modbus_controller, name: right, register_type: holding, address: 1}
  - {platform: modbus_controller, name: octal, register_type: holding, address: 010}
  - {platform: modbus_controller, name: twice, register_type: holding, address: 3, address: 4}
  - {platform: modbus_controller, name: times, register_type: holding, address: 6, bitmask: 010}
"""
    channels = """{"device": {"channels": [
{"name": "right", "reg_type": "input", "address": 1},
{"name": "octal", "reg_type": "input", "address": "010"},
{"name": "twice", "reg_type": "input", "address": 3, "address": 4},
{"name": "times", "reg_type": "input", "address": 6, "scale": "00.5"}]}}"""
    for name, text in (("home.yaml", home), ("boiler.yaml", boiler), ("channels.json", channels)):
        found, _, ended = imported(tool, check, name, text)
        check(sorted(found) == ["right", "times_raw"], f"{name}: the rest is left out", ended)
        check_told(check, name, text, ended, (("octal", "octal is left out"), ("twice", "address stands here a second time"), ("twice", "twice is left out")))
    found, _, ended = imported(tool, check, "twice.yaml", home + home.replace("right", "second"))
    check("modbus stands here a second time" in ended.errors, "a part of the file that stands twice", ended)


def check_many_names(tool, check):
    """A thousand of one name, in the time of a thousand of different ones."""
    took = []
    for name in ("n{}", "same"):
        channels = [{"name": name.format(i), "reg_type": "input", "address": i} for i in range(1500)]
        begun = time.monotonic()
        found = imported(tool, check, "many.json", json.dumps({"device": {"channels": channels}}))[0]
        took.append(time.monotonic() - begun)
        check(len(found) == 1500, f"{name}: each has a name", len(found))
    check(took[1] < 3 * took[0] + 1, "names alike cost what others do", took)


def check_telegraf(tool, check):
    found, file, ended = imported(tool, check, "telegraf.conf", TELEGRAF)
    compare(check, found, {
        "start": {"space": "discrete", "address": 0},
        "motor_run": {"space": "coil", "address": 1},
        "power_factor": {"address": 8, "type": "i16", "scale": 0.01},
        "energy": {"address": 5, "type": "u32", "order": "cdab", "scale": 0.001},
        "level": {"space": "input", "address": 0, "type": "i16", "order": "badc"},
        "voltage": {"space": "input", "address": 100, "type": "f32", "order": "dcba"},
        "counter": {"space": "input", "address": 103, "type": "u64", "order": "dcba", "scale": 0.5}})
    check(file["device"] == {"pause": 15}, "the pause", file)
    check("torn is left out" in ended.errors and "'FLOAT16-IEEE'" in ended.errors, "the rest is told", ended)


def check_sunspec(tool, check):
    found, _, ended = imported(tool, check, "sunspec.json", SUNSPEC, "--base", 40070)
    compare(check, found, {
        "ID": {"address": 40070, "invalid": 0xFFFF}, "L": {"address": 40071, "invalid": 0xFFFF},
        "Mn": {"address": 40072, "type": "text8"},
        "A_raw": {"address": 40076, "invalid": 0xFFFF}, "A_SF": {"address": 40077, "type": "i16", "invalid": 0x8000},
        "T": {"address": 40078, "type": "i16", "scale": 0.1, "unit": "C", "invalid": 0x8000},
        "St": {"address": 40079, "choices": {"OFF": 1, "RUN": 4}, "invalid": 0xFFFF},
        "Evt": {"address": 40080, "type": "u32", "invalid": 0xFFFFFFFF},
        "E": {"address": 40083, "type": "u64", "unit": "Wh", "access": "write", "invalid": 0},
        "F": {"address": 40091, "type": "f32"},
        "in_1_V": {"address": 40093, "invalid": 0xFFFF}, "in_2_V": {"address": 40094, "invalid": 0xFFFF}})
    for says in ("what A_SF holds", "GROUND", "'eui48'", "the device says"):
        check(says in ended.errors, says, ended)
    ended = tool.run("device", "import", "sunspec.json")
    check(ended.status == USAGE and "--base 40070" in ended.errors, "a model needs its place", ended)


def check_names(tool, check):
    """What a shell, a topic, a template or a spreadsheet takes for an order is in no name, and that is told."""
    hostile = ["=cmd()", "+1", "-x", "@sum", "a/b", "a+b", "a#b", "{{x}}", "\\u001b[31m", "a\\nb", "time", "u16", "input", "Ünï", "",
               "same", "same", "x" * 80, "9lives", "\\u202egnp"]
    channels = ",".join(f'{{"name": "{name}", "reg_type": "input", "address": {i}, "units": "{name}"}}' for i, name in enumerate(hostile))
    found, _, ended = imported(tool, check, "names.json", '{"device": {"name": "=x\\n[a]", "channels": [' + channels + "]}}")
    check(len(found) == len(hostile), "each has a name", found)
    check(all(name[0].isalpha() and name.replace("_", "a").isalnum() and len(name) <= 40 for name in found), "of letters", found)
    for said, name in (("'=cmd()'", "cmd"), ("'a/b'", "a_b"), ("'{{x}}'", "x")):
        check(f"{said} is called {name} here" in ended.errors, f"{said} is told", ended)
    check("\x1b" not in ended.output + ended.errors and not any(sign in line for line in ended.output.splitlines() for sign in ("{{", "cmd()")),
          "and nowhere else", ended)


def check_hostile(tool, check):
    """Refused with the place, nothing written."""
    deep = 100_000
    for name, text, says in (
            ("nul.json", '{"device": "\0"}', "nul.json:1:13: a byte is zero"),
            ("deep.json", '{"device":' * deep, "deep.json:1:"),
            ("deep.yaml", "modbus: " + "[" * deep, "deep.yaml:1:"),
            ("deeper.yaml", "".join("  " * i + "a:\n" for i in range(600)), "tables or lists within each other"),
            ("deep.toml", "[[inputs.modbus]]\na = " + "[" * deep, "deep.toml:2:"),
            ("alias.yaml", "a: &a [x, x]\nmodbus:\n  - {sensors: [*a, *a]}\n", "alias.yaml:3:16: an alias"),
            ("wide.json", '{"device": [' + "[]," * 400_000 + "[]]}", "more than 300000 values"),
            ("broken.json", '{"device": {,}}', "broken.json:1:13: this is no JSON"),
            ("broken.yaml", "modbus:\n  - sensors: [\n", "broken.yaml:"),
            ("broken.toml", "[[inputs.modbus]]\nname = \n", "broken.toml:2:"),
            ("jinja.json", '{"device": {"channels": [{% for i in range(3) %}]}}', "Jinja"),
            ("none.yaml", "sensor:\n  - platform: dht\n", "none of the files that are imported"),
            ("none.json", "{}", "none of the files that are imported"),
            ("empty", "", "none of the files that are imported"),
            ("other.json", '{"device": {"name": "x", "protocol": "milur", "channels": []}}', "its protocol is 'milur'"),
            ("nothing.json", '{"device": {"name": "x", "channels": []}}', "no register that can be carried over")):
        (tool.place / name).write_bytes(text.encode())
        ended = tool.run("device", "import", name, "-o", "never.toml")
        check(ended.status == USAGE and says in ended.errors, f"{name} is refused", (ended.status, ended.errors[-300:]))
        check(not (tool.place / "never.toml").exists(), f"{name}: nothing is written")
    with open(tool.place / "large.json", "wb") as file:
        file.truncate(60 << 20)
    ended = tool.run("device", "import", "large.json")
    check(ended.status == USAGE and "62914560 bytes" in ended.errors, "60 MB are refused", ended)
    for name, text in (("types.json", '{"device": {"channels": {"a": 1, "b": {"name": [], "address": {}}}, "parameters": 5}}'),
                       ("types.yaml", "modbus: {sensors: 5, switches: [1, {name: [x], address: {}}], climates: {a: b}}"),
                       ("model.json", '{"group": {"points": [1, {"size": -3}]}}')):
        (tool.place / name).write_text(text)
        ended = tool.run("device", "import", name, *(["--base", 1] if name == "model.json" else []))
        check(ended.status == USAGE, f"{name}: wrong types are refused", ended)


def check_long_keys(tool, check):
    """A key of many parts ends at its 33rd, wherever it stands and whatever stands before it; values, texts and comments have dots."""
    key = ".".join(["a"] * 100_000)
    for name, text in (("key", f"{key} = 1\n"), ("table", f"[{key}]\n"), ("list", f"[[inputs.modbus.{key}]]\n"), ("inline", f"x = {{{key} = 1}}\n"),
                       ("spaces", " . ".join(["'a'"] * 100_000) + " = 1"), ("quoted", ".".join(['"a."'] * 100_000) + " = 1"),
                       ("behind", 'x = [{b = """\\"""..""""", ' + key + " = 1}]\n"), ("comment", f"# \"\"\" '\n{key} = 1"),
                       ("literal", f"x = '\\'\n{key} = 1"), ("lone", f"x = 1 # \r {key}\r{key} = 1"), ("other", f"# \u2028{key} = 1\u2028{key} = 1"),
                       ("many", "\n".join(f"[{'.'.join(['a'] * 33)}]" for _ in range(3)))):
        for words in (("device", "import"), ("device", "check")):
            (tool.place / "keys.toml").write_text("[[inputs.modbus]]\n" + text)
            ended = tool.run(*words, "keys.toml")
            check(ended.status == USAGE and (name in ("lone", "other") or "a key of more than 32 parts" in ended.errors), f"{name}, {words[1]}",
                  (ended.status, ended.errors[-200:]))
    text = "[[inputs.modbus]]\nslave_id = 3\nname = '" + key[:200] + "' # " + key + '\nalias = """' + "a.\n" * 40 + '"""\n' + """
holding_registers = [ { name = "v", data_type = "INT16", scale = 0.1, address = [4] } ]
"""
    check(list(imported(tool, check, "dots.toml", text)[0]) == ["v"], "dots that are none of a key")


def check_output(tool, check):
    """A file that is there stays as it is."""
    (tool.place / "sunspec.json").write_text(SUNSPEC)
    words = ("device", "import", "sunspec.json", "--base", 0, "-o", "meter.toml")
    check(tool.run(*words).status == DIFFERS and "[[register]]" in (tool.place / "meter.toml").read_text(), "a new file")
    (tool.place / "meter.toml").write_text("mine")
    ended = tool.run(*words)
    check(ended.status not in (DONE, DIFFERS) and "already" in ended.errors, "an old one is refused", ended)
    check((tool.place / "meter.toml").read_text() == "mine", "and stays")
    check([each.name for each in tool.place.glob("meter.toml*")] == ["meter.toml"], "nothing is left beside it")


def check_mutants(tool, check):
    """Whatever a file has: a file that passes the check, or a reason."""
    chance = random.Random(40)
    for name, text in SOURCES.items():
        wrong = []
        for _ in range(25):
            mutant = text
            for _ in range(chance.randrange(1, 4)):
                at, size = chance.randrange(len(mutant)), chance.randrange(1, 12)
                piece = chance.choice(["", "-1", "99999", "null", "[]", "{}", '"', "1e400", "0x", "u64", "true", ": ", ",",
                                       mutant[chance.randrange(len(mutant)):][:size]])
                mutant = mutant[:at] + piece + mutant[at + size:]
            (tool.place / name).write_text(mutant)
            ended = tool.run("device", "import", name, *(["--base", 40000] if name == "sunspec.json" else []))
            is_told = ended.status in (DONE, DIFFERS) or (ended.status == USAGE and ended.errors and not ended.output)
            (tool.place / "out.toml").write_text(ended.output)
            is_right = not ended.output or tool.run("device", "check", "out.toml").status == DONE
            if not is_told or not is_right:
                wrong.append((mutant, ended))
        check(not wrong, f"mutants of {name}", wrong[:1])


def main(check, program):
    with Tool(program) as tool:
        for part in (check_wirenboard, check_home_assistant, check_esphome, check_what_is_written, check_devices, check_no_numbers, check_beyond, check_unclear, check_many_names, check_telegraf, check_sunspec, check_names, check_hostile, check_long_keys,
                     check_output, check_mutants):
            part(tool, check)


runs(main)
