# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A device that a register file describes, served to clients that nobody here wrote: pymodbus and mbpoll.

    python3 simulated_device.py TOOL
"""
import struct
import subprocess
import sys

from support import DONE, USAGE, Simulator, Tool, runs, soon

from simulator import pymodbus_on  # noqa: I100

UNIT = 61
FILE = """
[device]
vendor = "Acme"
product = "EM-3"
max_registers = 4

[[register]]
name = "voltage"
space = "input"
address = 1000
type = "f32"
order = "cdab"
unit = "V"
simulated = 230.1
[[register]]
name = "energy"
space = "input"
address = 1002
type = "u32"
scale = 0.001
unit = "kWh"
simulated = 1234.567
[[register]]
name = "far"
space = "input"
address = 1010
type = "u64"
[[register]]
name = "setpoint"
address = 40
type = "i16"
scale = 0.1
unit = "degC"
access = "write"
min = -10
max = 95.5
simulated = -5
[[register]]
name = "wide"
address = 41
type = "u32"
access = "write"
max = 100000
[[register]]
name = "mode"
address = 43
bits = "4-7"
choices = { off = 0, heat = 2 }
simulated = "heat"
[[register]]
name = "ready"
address = 43
bits = "0"
simulated = true
[[register]]
name = "label"
address = 50
type = "text7"
access = "write"
simulated = "pump"
[[register]]
name = "relay"
space = "coil"
address = 3
access = "write"
simulated = true
[[register]]
name = "lamp"
space = "coil"
address = 4
[[register]]
name = "door"
space = "discrete"
address = 9
simulated = true
"""


def words(answer):
    return answer.registers if not answer.isError() else answer.exception_code


def bits(answer, count):
    return answer.bits[:count] if not answer.isError() else answer.exception_code


def check_by_pymodbus(client, check):
    """What a file says is what a client gets, and what it refuses as a device would: 02 before 03."""
    low_first = list(struct.unpack(">2H", struct.pack(">f", 230.1)))[::-1]
    found = words(client.read_input_registers(1000, 4, UNIT))
    check(found == [*low_first, *divmod(1_234_567, 65_536)], "input registers", found)
    found = words(client.read_holding_registers(40, 4, UNIT))
    check(found == [65_536 - 50, 0, 0, 0x21], "holding registers, two fields of one among them", found)
    found = words(client.read_holding_registers(50, 4, UNIT))
    check(found == [0x7075, 0x6D70, 0, 0], "a text", found)
    check(bits(client.read_coils(3, 2, UNIT), 2) == [True, False], "coils")
    check(bits(client.read_discrete_inputs(9, 1, UNIT), 1) == [True], "discrete inputs")
    refused = {"a hole": client.read_input_registers(1003, 2, UNIT), "behind the last": client.read_holding_registers(43, 2, UNIT),
               "more than max_registers": client.read_holding_registers(40, 5, UNIT),
               "more than max_registers of inputs": client.read_input_registers(1010, 5, UNIT),
               "beyond max": client.write_register(40, 956, UNIT), "below min": client.write_register(40, 65_536 - 101, UNIT),
               "a wide value beyond max": client.write_registers(41, [1, 34_465], UNIT),
               "one beyond beside a good one": client.write_registers(40, [1, 0xFFFF, 0], UNIT),
               "read only": client.write_register(43, 0, UNIT), "read only beside others": client.write_registers(41, [0, 0, 0], UNIT),
               "a coil that is read only": client.write_coil(4, True, UNIT), "coils, one read only": client.write_coils(3, [False, True], UNIT),
               "no such coil": client.write_coil(7, True, UNIT)}
    wanted = [2, 2, 3, 3, 3, 3, 3, 3, 2, 2, 2, 2, 2]
    found = [answer.exception_code if answer.isError() else None for answer in refused.values()]
    check(found == wanted, "exceptions", list(zip(refused, found, wanted)))
    check(words(client.read_holding_registers(40, 4, UNIT))[0] == 65_536 - 50 and bits(client.read_coils(3, 2, UNIT), 2) == [True, False],
          "what is refused changes nothing")
    for what, done in (("06", client.write_register(40, 955, UNIT)), ("16", client.write_registers(41, [1, 34_464], UNIT)),
                       ("05", client.write_coil(3, False, UNIT)), ("15", client.write_coils(3, [True], UNIT)),
                       ("05 again", client.write_coil(3, False, UNIT))):
        check(not done.isError(), f"a write by {what}", done)
    found = words(client.read_holding_registers(40, 3, UNIT)), bits(client.read_coils(3, 1, UNIT), 1)
    check(found == ([955, 1, 34_464], [False]), "is there", found)


def check_functions(client, check):
    from pymodbus.mei_message import ReadDeviceInformationRequest
    found = client.execute(ReadDeviceInformationRequest(unit=UNIT, slave=UNIT))
    check([bytes(found.information[i]) for i in range(3)] == [b"Acme", b"EM-3", b"simulated"], "it says who it is", found)


def check_by_mbpoll(device, check):
    done = subprocess.run(["mbpoll", "-m", "rtu", "-b", "19200", "-P", "none", "-a", str(UNIT), "-0", "-r", "1000", "-c", "1",
                           "-t", "3:float", "-1", "-q", device], text=True, capture_output=True)
    check(done.returncode == 0 and "230.1" in done.stdout, "mbpoll reads a float, low word first", done)
    done = subprocess.run(["mbpoll", "-m", "rtu", "-b", "19200", "-P", "none", "-a", str(UNIT), "-0", "-r", "40", "-t", "4", "-q",
                           device, "2000"], text=True, capture_output=True)
    check(done.returncode != 0 and "Illegal data value" in done.stdout + done.stderr, "and is refused beyond the limits", done)


def check_input(simulator, device, check):
    """Values come from the command's own input, whatever is limited for others."""
    simulator.told(f"{UNIT} setpoint=300degC")
    for value in ("off", "16", "hot", "3"):
        simulator.told(f"{UNIT} mode={value}")
    simulator.told(f"{UNIT} voltage=0.5 V")
    simulator.told(f"{UNIT} door=off")
    simulator.told(f"{UNIT} show")
    shown = simulator.process.stdout.readline()
    wanted = (f"unit {UNIT}: voltage 0.5 V, energy 1234.567 kWh, far 0, setpoint 300.0 degC, wide 100000, "
              "mode 3, which is none of its choices, ready 1, label pump, relay 0, lamp 0, door 0\n")
    check(shown == wanted, "values are set, and shown", (shown, wanted))
    client = pymodbus_on(device, timeout=1)
    found = words(client.read_holding_registers(40, 4, UNIT)), bits(client.read_discrete_inputs(9, 1, UNIT), 1)
    check(found == ([3000, 1, 34_464, 0x31], [False]), "and read", found)
    simulator.told(f"{UNIT} mute")
    simulator.told(f"{UNIT} show")
    simulator.process.stdout.readline()
    client.close()
    client = pymodbus_on(device, timeout=0.2)
    check(client.read_coils(3, 1, UNIT).isError(), "it falls silent")
    client.close()


def check_port(tool, check):
    """A port word has it as well, and a drive beside it."""
    how = ["-p", "sim:meter.toml:61,atv320:7", "--no-listen"]
    ended = tool.run(*how, "-u", UNIT, "--device", "meter.toml", "--json", "read", "voltage", "mode", "label")
    check([each["text"] for each in ended.objects()] == ["230.1 V", "heat (2)", "pump"], "names are read of a port word", ended)
    ended = tool.run(*how, "-u", 7, "--json", "read", "HSP")
    check(ended.status == DONE, "a drive beside it", ended)
    ended = tool.run(*how, "-u", UNIT, "--device", "meter.toml", "--write", "--json", "write", "setpoint=21.5", "relay=off", "label=fan")
    check(ended.status == DONE and [each["after"] for each in ended.objects()] == ["21.5 degC", "0", "fan"], "and is written", ended)
    for words_, says in ((["-p", "sim:meter.toml:300", "read", "4"], "did you mean sim:meter.toml:1?"),
                         (["-p", "sim:meter.toml:1,meter.toml:1", "read", "4"], "given twice"),
                         (["-p", "sim:nothing.toml", "read", "4"], "nothing.toml: "),
                         (["-p", "sim:wrong.toml:2", "read", "4"], "wrong.toml:5:13: simulated: it is in V, not in A"),
                         (["simulate", "wrong.toml:2"], "wrong.toml:5:13"), (["simulate"], "simulate: what?")):
        ended = tool.run(*words_)
        check(ended.status == USAGE and says in ended.errors, f"{words_} is refused", ended)


def main(check, program):
    with Tool(program) as tool:
        (tool.place / "meter.toml").write_text(FILE)
        (tool.place / "wrong.toml").write_text('[[register]]\nname = "a1"\naddress = 1\nunit = "V"\nsimulated = "5A"\n')
        check_port(tool, check)
        file = str(tool.place / "meter.toml")
        simulator = Simulator(program, f"{file}:{UNIT}")
        with simulator as device:
            client = pymodbus_on(device, timeout=1)
            check_by_pymodbus(client, check)
            check_functions(client, check)
            client.close()
            check_by_mbpoll(device, check)
            check_input(simulator, device, check)
        for said in (["--device", "meter.toml:9"], ["-u", "9", "--device", "meter.toml"]):
            process = tool.start("simulate", *said)
            check(soon(lambda: process.stdout.readline().startswith("meter.toml unit 9 on ")), f"{said} is served")
            process.terminate()
            process.communicate()


runs(main)
