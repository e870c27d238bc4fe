# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""pymodbus takes a simulated drive through its manual's words, from power-on to running and back.

    python3 pymodbus_drives.py SIMULATE DRIVE [lossy]

With "lossy" every second request is lost on its way, and the run has to fail.
"""
import contextlib

from pymodbus.mei_message import ReadDeviceInformationRequest

from frames import LossyLine
from simulator import Registers, Simulator, asked, pymodbus_on, runs

UNIT = 7
SHUTDOWN, SWITCH_ON, ENABLE, DISABLE_VOLTAGE, RESET = 0x0006, 0x0007, 0x000F, 0x0000, 0x0080
REVERSE = 0x0800
OVERCURRENT = 9


class Drive:
    def __init__(self, line, registers):
        self.line, self.at = line, registers

    def read(self, address, count=1):
        answer = asked(lambda: self.line.read_holding_registers(address, count, slave=UNIT))
        if answer.isError():
            raise RuntimeError(f"no word at {address}: {answer}")
        return answer.registers if count > 1 else answer.registers[0]

    def write(self, address, word):
        return not asked(lambda: self.line.write_register(address, word, slave=UNIT)).isError()

    def state(self):
        word = self.read(self.at.eta)
        masked = {0x40: "disabled", 0x08: "fault"}.get(word & 0x4F)
        return masked or {0x21: "ready", 0x23: "on", 0x27: "enabled"}.get(word & 0x6F, "other")

    def frequency(self):
        word = self.read(self.at.rfr)
        return (word - 0x10000 if word > 0x7FFF else word) / 10


def climbs(drive, check):
    for word, state in ((SHUTDOWN, "ready"), (SWITCH_ON, "on"), (ENABLE, "enabled")):
        check(drive.write(drive.at.cmd, word) and drive.state() == state, f"CMD {word:04X}: {state}")


def turns(drive, check):
    check(drive.state() == "disabled", "at power-on: switch on disabled")
    check(drive.write(drive.at.acc, 10) and drive.write(drive.at.dec, 10), "ramps of one second")
    check(drive.write(drive.at.lfr, 400), "LFR 40.0 Hz")
    climbs(drive, check)
    check.soon(lambda: drive.frequency() == 40, "40.0 Hz are reached")
    check(drive.read(drive.at.eta) & 0x0400 != 0, "ETA bit 10: reference reached")
    check(drive.write(drive.at.cmd, ENABLE | REVERSE), "bit 11: reverse")
    check.soon(lambda: drive.read(drive.at.eta) & 0x8400 == 0x8400, "ETA bit 15: reverse rotation")
    check(drive.write(drive.at.cmd, SWITCH_ON), "CMD 0007: disable operation")
    check.soon(lambda: drive.state() == "on" and drive.frequency() == 0, "the motor stands")
    check(drive.write(drive.at.cmd, SHUTDOWN) and drive.state() == "ready", "CMD 0006: ready")
    check(drive.write(drive.at.cmd, DISABLE_VOLTAGE) and drive.state() == "disabled",
          "CMD 0000: switch on disabled")


def says_who_it_is(drive, name, check):
    """What a master that looks at the maker sees; an ATV28 does not know the function."""
    who = asked(lambda: drive.line.execute(
        ReadDeviceInformationRequest(read_code=1, object_id=0, unit=UNIT)))
    if name == "atv28":
        check(who.isError() and who.exception_code == 1, "43/14 is no function of it", who)
        return
    family = name.partition("_")[0].upper().encode()
    check(not who.isError() and who.information.get(0) == b"Schneider Electric", "the maker", who)
    check(who.information.get(1, b"").startswith(family), "a reference of the family")
    check(who.information.get(2) == b"0201" and who.conformity == 2, "version and conformity")


def trips(drive, simulator, check):
    climbs(drive, check)
    simulator.suffer(f"{UNIT} fault")
    check.soon(lambda: drive.state() == "fault", "a fault")
    check(drive.read(drive.at.lft) == OVERCURRENT and drive.frequency() == 0, "LFT: overcurrent")
    check(drive.write(drive.at.cmd, RESET) and drive.state() == "fault", "its cause is still there")
    simulator.suffer(f"{UNIT} clear")
    # The simulator has read its input when it has answered another request.
    check(drive.state() == "fault", "its cause is gone: the fault stays")
    check(drive.write(drive.at.cmd, 0) and drive.write(drive.at.cmd, RESET), "an edge of bit 7")
    check.soon(lambda: drive.state() == "disabled", "resets the fault")


def main(check, program, name, *how):
    simulator = Simulator(program, f"{name}:{UNIT}")
    with simulator as device, contextlib.ExitStack() as between:
        if how == ("lossy",):
            device = between.enter_context(LossyLine(device)).name
        drive = Drive(pymodbus_on(device), Registers(name))
        says_who_it_is(drive, name, check)
        turns(drive, check)
        trips(drive, simulator, check)


runs(main)
