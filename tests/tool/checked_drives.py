# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`check` beside a motor that runs, and what it does to places that may be changed.

    python3 checked_drives.py TOOL
"""
import os
import select
import signal
import threading
import time
import tty

from defective_servers import SCRATCH, SCRATCH_COILS, UNIT, Server
from defective_servers import Line as ServedLine
from support import DIFFERS, DONE, LIMIT, REFUSED, USAGE, Simulator, Tool, Units, crc, runs, soon

from pair import free_port, wait_for_listener  # noqa: I100
from simulator import Registers, asked, pymodbus_on  # noqa: I100

QUICK = ("--timeout", 0.3, "--no-listen")  # long enough on a busy machine


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
        ended = tool.run(*QUICK, "--yes", "-u", 7, "--json", "check", "--hostile", 2, port=device, limit=4 * LIMIT)
        rows = ended.objects()
        check(ended.status == DONE and not [row for row in rows if row["verdict"] == "fails" and row["level"] == "must"],
              "all musts hold", [row for row in rows if row["verdict"] == "fails"])
        check(sum(row["verdict"] == "holds" for row in rows) > 60 and
              not [row for row in rows if row["verdict"] == "holds" and "it writes" in row["why"]], "most are asked", len(rows))
        check(held(device, 7, registers) == before, "command, reference and settings of the drive are as they were")
        ended = tool.run(*QUICK, "-u", 7, "read", "RFR", "ETA", port=device)
        check("30.0 Hz" in ended.output, "the motor runs on", ended)


class SlowLine:
    """Between the tool and a drive: what the drive says comes later; keeps when it heard what."""

    def __init__(self, device, delay):
        self.delay, self.heard, self.is_over = delay, [], threading.Event()
        self.drive = os.open(device, os.O_RDWR | os.O_NOCTTY)
        self.end, client = os.openpty()
        for each in (self.drive, client):
            tty.setraw(each)
        self.client, self.name = client, os.ttyname(client)
        self.thread = threading.Thread(target=self.run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.is_over.set()
        self.thread.join()
        for each in (self.drive, self.end, self.client):
            os.close(each)

    def run(self):
        while not self.is_over.is_set():
            ready, _, _ = select.select([self.drive, self.end], [], [], 0.1)
            if self.end in ready:
                data = os.read(self.end, 4096)
                self.heard.append((time.monotonic(), data))
                os.write(self.drive, data)
            if self.drive in ready:
                data = os.read(self.drive, 4096)
                time.sleep(self.delay)
                os.write(self.end, data)

    def longest_pause(self, unit):
        """Between requests to that unit with a right CRC."""
        times = [at for at, data in self.heard if data[:1] == bytes([unit]) and len(data) > 3 and crc(data) == 0]
        return max(then - now for now, then in zip(times, times[1:]))


def check_supervision(check, tool_path):
    """A motor whose drive supervises its line runs on behind clauses in which nothing is said that the drive answers: what they
    say is broken by reads, and what would leave too long a pause is not tried."""
    registers = Registers("atv320")
    with Tool(tool_path) as tool, Simulator(tool_path, "atv320:7", vendor="Schneider Electric") as device:
        client = pymodbus_on(device)
        asked(lambda: client.write_register(registers.tto, 46, slave=7))
        client.close()
        started(device, 7, registers)
        before = held(device, 7, registers)
        # L12 says nothing to the unit for 5 s, F03.10 may for 4 s, and each hundred frames of H02 last 8 s.
        with SlowLine(device, 0.04) as line:
            ended = tool.run("--timeout", 1, "--no-listen", "--yes", "-u", 7, "--json", "check", "--only", "L07,L12,F03.10,H02",
                             "--hostile", 1, port=line.name, limit=2 * LIMIT)
        check(held(device, 7, registers) == before and before[:3] == [15, 300, 46], "a motor runs on at a time-out of 4.6 s",
              (before, line.longest_pause(7)))
        rows = {row["clause"]: (row["verdict"], row["why"]) for row in ended.objects()}
        check(ended.status == DONE and [rows[each][0] for each in ("L07", "L12", "H02")] == ["holds"] * 3, "the clauses hold", ended)
        check(rows["F03.10"][0] == "not tried" and "4.6 s" in rows["F03.10"][1], "one would last too long, and says so", rows)
        ended = tool.run("--timeout", 3, "--no-listen", "--yes", "-u", 7, "check", "--only", "L07", port=device)
        check(ended.status == REFUSED and "--timeout 2.2" in ended.errors and not ended.output,
              "a time-out that is too long for any of them is refused", ended)
    # What may be a drive, and does not tell: a third of 7 s.
    with Tool(tool_path) as tool, Units({7: {3201: 1, 8501: 0}}) as line:
        for seconds, status in ((3, REFUSED), (1, DONE)):
            ended = tool.run("--timeout", seconds, "--no-listen", "--yes", "-u", 7, "--json", "check", "--only", "L07,F03.10", port=line.name)
            check(ended.status == status and (status == DONE or "7 s, allows 2.33 s; say --timeout 2.2" in ended.errors),
                  f"a time-out of {seconds} s, of what may be a drive", ended)
        rows = {row["clause"]: (row["verdict"], row["why"]) for row in ended.objects()}
        check(rows["L07"][0] == "holds" and rows["F03.10"][0] == "not tried" and "may be 7 s" in rows["F03.10"][1], "and it says so", rows)


def check_unit_without_function_3(check, tool_path):
    """As meters are whose registers are all input registers: on a line, and over Modbus TCP."""
    number = free_port()
    with Tool(tool_path) as tool, tool.start("simulate", "sdm630:1", port=f"mbap://127.0.0.1:{number}") as drives:
        wait_for_listener(number)
        for port, only in (("sim:sdm630:1", "L15,L34,L35"), (f"mbap://127.0.0.1:{number}", "L01,F04.1,T05")):
            ended = tool.run("-u", 1, "--json", "check", "--only", only, port=port)
            check(ended.status == DONE and not [row for row in ended.objects() if row["verdict"] == "fails"],
                  f"{only} of a unit without function 3 at {port}", ended)
        drives.kill()


METER = """
[device]
vendor = "Maker"
product = "Meter"
[[register]]
name = "voltage"
space = "input"
address = 10
type = "f32"
simulated = 230.1
"""


def check_meters(check, tool_path):
    """What has no holding register is checked by its input registers; what has neither is told so."""
    with Tool(tool_path) as tool:
        (tool.place / "meter.toml").write_text(METER)
        (tool.place / "coils.toml").write_text(METER.replace("input", "coil").replace('type = "f32"\nsimulated = 230.1', ""))
        how = [*QUICK, "-u", 61, "--json", "check", "--only", "L01,L02,L07,F04,X01,H02", "--hostile", 1]
        ended = tool.run(*how, port="sim:meter.toml:61")
        check(ended.status == DIFFERS and "--readable" in ended.errors and not ended.output, "none of the usual is there", ended)
        ended = tool.run(*how, "--readable", 10, port="sim:meter.toml:61")
        verdicts = {row["clause"]: row["verdict"] for row in ended.objects()}
        check(ended.status == DONE, "a meter keeps its musts", ended)
        check(verdicts.get("L01") == verdicts.get("F04.2") == verdicts.get("X01") == "holds", "and is asked by function 04", verdicts)
        ended = tool.run(*how, port="sim:coils.toml:61")
        check(ended.status == DIFFERS and "no register was found" in ended.errors, "coils alone", ended)


def check_noise(check, tool_path):
    """No run of the bytes of random frames is a write, to whatever unit, with a right CRC and the size of its function."""
    class Listener(Server):
        heard = ()

        def hear(self, data):
            self.heard = (*self.heard, bytes(data))
            super().hear(data)

    line, is_over = ServedLine([Listener]), threading.Event()
    threading.Thread(target=line.run_until, args=(is_over.is_set,), daemon=True).start()
    unit = line.servers[0]
    with Tool(tool_path) as tool:
        ended = tool.run(*QUICK, "-u", UNIT, "check", "--only", "H01,H02", "--hostile", 4, port=unit.name)
    is_over.set()
    writes = [piece[at:at + size] for piece in unit.heard for at in range(len(piece) - 3)
              if (size := size_of_write(piece[at:])) and crc(piece[at:at + size]) == 0]
    check(ended.status == DONE and len(unit.heard) > 300, "random frames were sent", (ended, len(unit.heard)))
    check(not writes and not [each for each in unit.heard if crc(each) == 0 and each[1] == 0x2B and len(each) > 4 and each[2] != 0x0E],
          "none of them writes, nor asks by another kind of 43", writes)


def check_what_is_needed(check, tool_path):
    """A server that is deaf behind functions it does not know is checked by the clauses of others."""
    class DeafBehind(Server):
        is_deaf = False

        def take(self, frame):
            self.is_deaf = self.is_deaf or frame[:1] == bytes([UNIT]) and frame[1] in (8, 22, 23, 24)
            if not self.is_deaf:
                super().take(frame)

    line, is_over = ServedLine([DeafBehind]), threading.Event()
    threading.Thread(target=line.run_until, args=(is_over.is_set,), daemon=True).start()
    unit = line.servers[0]
    with Tool(tool_path) as tool:
        how = [*QUICK, "-u", UNIT, "--json", "--write", "check", "--scratch", SCRATCH]
        for only in ("F03.1,L07", "F06.1,F16.1"):
            ended = tool.run(*how, "--only", only, port=unit.name)
            check(ended.status == DONE and [row["verdict"] for row in ended.objects()] == ["holds"] * 2 and not unit.is_deaf,
                  f"--only {only} asks for no other function", ended)
        ended = tool.run(*how, "--only", "D01", port=unit.name)
        check(unit.is_deaf, "--only D01 does", ended)
    is_over.set()


def size_of_write(data):
    """Of a request that writes and begins there; 0 where none does."""
    function = data[1]
    size = {5: 8, 6: 8, 22: 10}.get(function, 0)
    if function in (15, 16) and len(data) > 6:
        size = 9 + data[6]
    if function == 23 and len(data) > 10:
        size = 13 + data[10]
    return size if 0 < size <= len(data) else 0


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
    check_supervision(check, tool_path)
    check_meters(check, tool_path)
    check_unit_without_function_3(check, tool_path)
    check_noise(check, tool_path)
    check_what_is_needed(check, tool_path)
    check_changes(check, tool_path)


if __name__ == "__main__":
    runs(main)
