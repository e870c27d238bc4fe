# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`check` beside a motor that runs, and what it does to places that may be changed.

    python3 checked_drives.py TOOL
"""
import signal
import threading
import time

from defective_servers import SCRATCH, SCRATCH_COILS, UNIT, Server
from defective_servers import Line as ServedLine
from support import DIFFERS, DONE, REFUSED, USAGE, Simulator, Tool, runs, soon

from simulator import Registers, asked, pymodbus_on  # noqa: I100

QUICK = ("--timeout", 0.1, "--no-listen")


def held(device, unit, registers):
    """Command, reference, time-out, acceleration: by pymodbus."""
    client = pymodbus_on(device)
    values = [asked(lambda at=at: client.read_holding_registers(at, 1, slave=unit)).registers[0]
              for at in (registers.cmd, registers.lfr, registers.tto, registers.acc)]
    client.close()
    return values


def started(device, unit, registers):
    client = pymodbus_on(device)
    for at, value in ((registers.lfr, 300), (registers.cmd, 6), (registers.cmd, 7), (registers.cmd, 15)):
        asked(lambda at=at, value=value: client.write_register(at, value, slave=unit))
    for _ in range(40):
        asked(lambda: client.read_holding_registers(registers.rfr, 1, slave=unit))
        time.sleep(0.1)
    client.close()


def check_drive(check, tool_path):
    registers = Registers("atv320")
    with Tool(tool_path) as tool, Simulator(tool_path, "atv320:7", vendor="Schneider Electric") as device:
        started(device, 7, registers)
        before = held(device, 7, registers)
        check(before[:2] == [15, 300], "a motor runs", before)

        for words in (["--write", "check", "--scratch", "100-107"], ["--write", "check", "--disruptive"],
                      ["--write", "-d", "none", "check", "--scratch-coils", "0-15"]):
            ended = tool.run(*QUICK, "--yes", "-u", 7, *words, port=device)
            check(ended.status == REFUSED and "is a drive" in ended.errors, f"{words} is refused for a drive", ended)
        ended = tool.run(*QUICK, "-u", 7, "check", port=device)
        check(ended.status == REFUSED and "--yes" in ended.errors and not ended.output, "somebody is asked before it is fed", ended)
        ended = tool.run(*QUICK, "--yes", "-u", 7, "--json", "check", "--hostile", 2, port=device)
        rows = ended.objects()
        check(ended.status == DONE and not [row for row in rows if row["verdict"] == "fails" and row["level"] == "must"],
              "all musts hold", [row for row in rows if row["verdict"] == "fails"])
        check(sum(row["verdict"] == "holds" for row in rows) > 60 and
              not [row for row in rows if row["verdict"] == "holds" and "it writes" in row["why"]], "most are asked", len(rows))
        check(held(device, 7, registers) == before, "command, reference and settings of the drive are as they were")
        ended = tool.run(*QUICK, "-u", 7, "read", "RFR", "ETA", port=device)
        check("30.0 Hz" in ended.output, "the motor runs on", ended)


def check_changes(check, tool_path):
    """What may be changed is put back, whatever ends the command."""
    with Tool(tool_path) as tool:
        line, is_over = ServedLine([Server]), threading.Event()
        threading.Thread(target=line.run_until, args=(is_over.is_set,), daemon=True).start()
        server = line.servers[0]
        kept = (list(server.holding), list(server.coils))
        words = ["--write", "check", "--scratch", SCRATCH, "--scratch-coils", SCRATCH_COILS]
        for how, status in ((["check", "--scratch", SCRATCH], REFUSED), (["check", "--disruptive"], REFUSED),
                            (["--write", "check", "--scratch", "1-3"], USAGE), (["--write", "check", "--scratch", "x"], USAGE),
                            (["--write", "check", "--scratch-coils", "0-3"], USAGE), (["check", "--alone"], USAGE),
                            (["check", "--only", "Q9"], USAGE), (["check", "--explain", "L99"], USAGE),
                            (["--write", "check", "--scratch", "400-407"], DIFFERS)):
            ended = tool.run(*QUICK, "-u", UNIT, *how, port=server.name)
            check(ended.status == status and ended.errors, f"{how}: {status}", ended)
        check((server.holding, server.coils) == kept, "nothing was changed by what was refused")

        for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
            process = tool.start(*QUICK, "-u", UNIT, "--json", *words, "--only", "F16,F06,F05,F15", port=server.name)
            is_changed = soon(lambda: server.holding != kept[0])
            process.send_signal(number)
            _, errors = process.communicate(timeout=60)
            check(is_changed and process.returncode == 128 + number and "ended after" in errors,
                  f"{signal.Signals(number).name} ends it", (process.returncode, errors))
            check((server.holding, server.coils) == kept, "and what it changed is put back",
                  [i for i, each in enumerate(server.holding) if each != kept[0][i]])
        is_over.set()


def main(check, tool_path):
    check_drive(check, tool_path)
    check_changes(check, tool_path)


if __name__ == "__main__":
    runs(main)
