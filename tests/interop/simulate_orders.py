# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `simulate` is told to do to a drive, as pymodbus sees it: a power cycle, a held STOP key, another master's
words, a line that is lost one way.

    python3 simulate_orders.py SIMULATE DRIVE
"""

from pymodbus.mei_message import ReadDeviceInformationRequest

from simulator import Registers, Simulator, pymodbus_on, runs

UNIT = 7
SHUTDOWN, SWITCH_ON, ENABLE = 0x0006, 0x0007, 0x000F
STOP_KEY = 0x4000


class Drive:
    """One request at a time; nothing is asked again, for here silence is an answer."""

    def __init__(self, line, registers):
        self.line, self.at = line, registers

    def word(self, address):
        answer = self.line.read_holding_registers(address, 1, slave=UNIT)
        return None if answer.isError() else answer.registers[0]

    def write(self, address, word):
        return not self.line.write_register(address, word, slave=UNIT).isError()

    def stands_at(self, mask, state):
        return (self.word(self.at.eta) or 0) & mask == state

    def is_disabled(self):
        return self.stands_at(0x4F, 0x40)


def loses_its_power(drive, simulator, check):
    check(drive.write(drive.at.lfr, 300) and drive.write(drive.at.acc, 77), "LFR and ACC")
    check(drive.write(drive.at.cmd, SHUTDOWN) and drive.stands_at(0x6F, 0x21), "ready")
    simulator.suffer(f"{UNIT} cycle")
    check.soon(drive.is_disabled, "cycle: switch on disabled")
    check(drive.word(drive.at.lfr) == 0, "the reference is gone")
    check(drive.word(drive.at.cmd) in (0, 0x00F0), "the command is gone")
    check(drive.word(drive.at.acc) == 30, "what was not saved is gone")


def is_stopped_by_hand(drive, simulator, check):
    simulator.suffer(f"{UNIT} hold")
    check.soon(lambda: (drive.word(drive.at.eta) or 0) & STOP_KEY, "hold: ETA tells the STOP key")
    check(drive.write(drive.at.cmd, SHUTDOWN) and drive.is_disabled(), "nothing moves it")
    simulator.suffer(f"{UNIT} let-go")

    def is_ready():
        return drive.write(drive.at.cmd, 0) and drive.write(drive.at.cmd, SHUTDOWN) and \
            drive.stands_at(0x6F, 0x21)
    check.soon(is_ready, "let-go: it obeys again")


def hears_another_master(drive, simulator, check):
    simulator.suffer(f"{UNIT} write {drive.at.cmd} {SWITCH_ON}")
    check.soon(lambda: drive.stands_at(0x6F, 0x23), "write: another master switched it on")
    check(drive.word(drive.at.cmd) == SWITCH_ON, "its word can be read")
    check(drive.write(drive.at.cmd, 0) and drive.is_disabled(), "and ours counts again")


def is_lost_one_way(drive, simulator, check):
    for what, word, found in (("deaf", 44, 30), ("mute", 55, 55)):
        simulator.suffer(f"{UNIT} {what}")
        check.soon(lambda: drive.word(drive.at.eta) is None, f"{what}: no answer")
        check(not drive.write(drive.at.acc, word), f"{what}: no answer to a write")
        simulator.suffer(f"{UNIT} join")
        check.soon(lambda held=found: drive.word(drive.at.acc) == held, f"join: {found}, as only mute takes {word}")


def names_another_vendor(program, name, check):
    with Simulator(program, f"{name}:{UNIT}", vendor="rtuwire") as device:
        line = pymodbus_on(device, 1)
        who = line.execute(ReadDeviceInformationRequest(read_code=1, object_id=0, unit=UNIT))
        check(not who.isError() and who.information.get(0) == b"rtuwire", "--vendor", who)


def main(check, program, name):
    simulator = Simulator(program, f"{name}:{UNIT}")
    with simulator as device:
        drive = Drive(pymodbus_on(device, 1), Registers(name))
        loses_its_power(drive, simulator, check)
        is_stopped_by_hand(drive, simulator, check)
        hears_another_master(drive, simulator, check)
        is_lost_one_way(drive, simulator, check)
    if name != "atv28":
        names_another_vendor(program, name, check)


runs(main)
