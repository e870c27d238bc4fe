# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Each command in the table of docs/tool.md that stands beside other programs does what its row says, of a unit that nobody
here wrote (pymodbus).

    python3 beside_others.py TOOL PAGE
"""
import pathlib
import re
import shlex
import subprocess
import sys

from support import DIFFERS, DONE, HERE, PORT, REFUSED, USAGE, Tool, runs

from pair import Programs, free_port  # noqa: I100

FILE = """
[[register]]
name = "voltage"
space = "input"
address = 100
type = "f32"
[[register]]
name = "mode"
address = 60
choices = { off = 0, heat = 1 }
"""
# What a command shows, by its row: a status, and what stands in its output.
SHOWS = {
    "read coil:0-3 discrete:3 input:100 holding:40": (DONE, "input:100"),
    "-d none --write write coil:3=on holding:40=5 42:u32=70000": (DONE, "70000"),
    "-d none --write write 40.3=on": (DONE, "40.3"),
    "-d none --write ask 17 00280001002900010200AF": (DONE, "00 AF"),
    "ask 07": (DONE, "response"),
    "identify": (DONE, "pymodbus"),
    "ask 11": (DONE, "response"),
    "read 40:i32 42:f32": (DONE, "42:f32"),
    "read 40:u64 44:f64": (DONE, "44:f64"),
    "read 40:f32:cdab 44:u32:dcba": (DONE, "44:u32:dcba"),
    "read 40:hex 41:text4 43:bcd16 44:bits": (DONE, "41:text4"),
    "read 40:0.1degC-50": (DONE, "degC"),
    "--device meter.toml read 'v*'": (DONE, "voltage"),
    "--device meter.toml read mode": (DONE, "off (0)"),
    "-u 2 read 40": (DONE, "   2  40"),
    "--csv watch 40 --every 50ms --for 0.2s": (DONE, "time,seconds,40,error"),
    "monitor 40 --plot 40": (DONE, "unit 1"),
    "--json read 40": (DONE, '"register":"40"'),
    "--csv read 40-49": (DONE, ",49,"),
    "-v read 40": (DONE, "> 01 03 00 28 00 01 04 02"),
    "map 0-99": (DONE, "0    99    100"),
    "scan --units 1-3": (DONE, "pymodbus"),
    "write 40=5": (REFUSED, "--write"),
    "read 5000": (DIFFERS, "illegal data address"),
    "--rs485 read 40": (PORT, "RS-485"),  # a pseudo-terminal has no transceiver
}
ROWS = 25


def commands_of(page):
    """The commands of each row of the table."""
    table = pathlib.Path(page).read_text(encoding="utf-8").partition("## Beside other programs")[2]
    rows = [line for line in table.splitlines() if line.startswith("| ")][2:]
    return [re.findall(r"`([^`]+)`", row.split(" | ")[1]) for row in rows]


def run_one(tool, command):
    words = shlex.split(command)
    if words[0] == "monitor":
        return tool.on_terminal("--no-listen", "-u", 1, *words, keys=[("unit 1", "q")])
    return tool.run("--no-listen", "-u", 1, *words)


def over_tcp(check, tool, others, server, command):
    """The same server at a port of this machine."""
    number = free_port()
    others.serve(f"mbap:{number}", server, stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
    words = shlex.split(command)
    ended = tool.run("-u", 1, *words[2:], port=f"mbap://127.0.0.1:{number}")
    check(ended.status == DONE and "40  " in ended.output, command, ended)


def main(check, program, page):
    rows = commands_of(page)
    check(len(rows) == ROWS and sum(bool(each) for each in rows) == ROWS, f"{ROWS} rows", rows)
    with Tool(program) as tool, Programs() as others:
        (tool.place / "meter.toml").write_text(FILE)
        near_end, tool.port = others.line()
        server = [sys.executable, "-B", str(HERE.parent / "interop" / "memory_pymodbus.py"), "@", "0", "300"]
        others.serve(near_end, server, stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for command in (each for row in rows for each in row):
            if command.startswith("-p mbap://"):
                over_tcp(check, tool, others, server, command)
                continue
            if command.startswith("simulate"):
                served = tool.start(*shlex.split(command))
                check("unit 61" in served.stdout.readline(), command)
                served.kill()
                continue
            status, text = SHOWS[command]
            ended = run_one(tool, command)
            check(ended.status == status and text in ended.output + ended.errors, command, ended)
        ended = tool.run("--rs485", "read", "RFR", port="sim:atv320:1")
        check(ended.status == USAGE and "no serial device" in ended.errors, "no transceiver behind sim:", ended)


runs(main)
