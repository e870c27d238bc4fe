# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the tool does with units that nobody here wrote, servers of libmodbus and pymodbus: found, named, read, written,
watched, shown on a full screen, and refused while others talk to them; and over TCP.

    python3 others_servers.py TOOL LIBMODBUS_SERVER
"""
import subprocess
import sys

from line_between import LineBetween
from screen import Screen
from support import DIFFERS, DONE, HERE, NO_ANSWER, REFUSED, USAGE, Tool, runs

from pair import Programs, free_port, wait_for_listener  # noqa: I100

QUIET = ["--listen", "0.05"]


def finds(tool, check, what, identity):
    ended = tool.run(*QUIET, "--json", "scan", "--units", "1-4")
    found = [(each["unit"], each["vendor"], each["drive"]) for each in ended.objects()]
    check(ended.status == DONE and found == [(1, identity, "")], f"{what}: a scan finds the unit, and no other", ended)
    ended = tool.run(*QUIET, "--json", "identify")
    check(ended.objects()[0]["vendor"] == identity and ended.objects()[0]["drive"] == "", f"{what}: who it is", ended)
    check(ended.status == (DONE if identity else DIFFERS), f"{what}: and the status says whether it told", ended)


def reads(tool, check, what):
    """The same in each form; a glob has nothing to match without a drive."""
    ended = tool.run(*QUIET, "--json", "read", "100-103", "0x006E")
    check([each["raw"] for each in ended.objects()] == [100, 101, 102, 103, 110], f"{what}: reads", ended)
    rows = tool.run(*QUIET, "--csv", "read", "100-103", "0x006E").rows()
    check([row["raw"] for row in rows] == ["100", "101", "102", "103", "110"], f"{what}: as CSV", rows)
    table = tool.run(*QUIET, "read", "100-103", "0x006E").table()
    check([row[1] for row in table] == ["100", "101", "102", "103", "110"], f"{what}: as a table", table)
    ended = tool.run(*QUIET, "read", "'DP*'")
    check(ended.status in (DIFFERS, USAGE) and "unit 1" in ended.errors, f"{what}: no patterns without a drive", ended)
    ended = tool.run(*QUIET, "--json", "read", "100", "5000")
    check(ended.status == DIFFERS and ended.objects()[0]["raw"] == 100 and ended.objects()[1]["error"],
          f"{what}: one that it does not have is an error of its own", ended)
    ended = tool.run(*QUIET, "read", "RFR")
    check(ended.status in (DIFFERS, NO_ANSWER) and "unit 1" in ended.errors, f"{what}: no name without a drive", ended)
    ended = tool.run(*QUIET, "--csv", "watch", "100", "--every", "50ms", "--for", "0.22s")
    check(ended.status == DONE and [row["100"] for row in ended.rows()] == ["100"] * len(ended.rows()) != [],
          f"{what}: watches", ended)


def writes(tool, check, what):
    """A table that does not know a register is no reason to write it: two permissions are, and it is read back."""
    how = [*QUIET, "-u", 1, "-d", "atv320", "--json", "--write"]
    ended = tool.run(*how, "write", "120=77")
    check(ended.status == REFUSED and "--allow-run" in ended.errors, f"{what}: a register of no table is refused", ended)
    ended = tool.run(*how, "--allow-run", "write", "120=77")
    check(ended.status == DONE and ended.objects()[0]["note"] == "", f"{what}: is written and read back", ended)
    check(tool.run(*QUIET, "--json", "read", "120").objects()[0]["raw"] == 77, f"{what}: holds it")
    ended = tool.run(*how, "--allow-run", "write", "5000=1")
    check(ended.status == DIFFERS and "address" in ended.objects()[0]["note"], f"{what}: refuses what it lacks", ended)


def shows(tool, check, what, port):
    words = [tool.program, "--port", port, "--no-listen", "--name", "rack=1", "monitor", "100", "110", "--every", "100ms"]
    for width, height in ((80, 24), (120, 40)):
        with Screen(words, width, height) as page:
            check(page.until_shown(r"^rack: unit 1, no drive "), f"{what}: monitor at {width}x{height}", page.text)
            check(page.until_shown(r"^ 100 .*100 \(0x0064\)") and page.until_shown(r"^ 110 .*110 \(0x006E\)"),
                  f"{what}: its registers", page.text)
            page.type("q")
            check(page.end() == DONE and page.is_restored(), f"{what}: q", page.raw[-80:])


def refuses(tool, check, what, port):
    """Another client reads; the tool hears it first."""
    with LineBetween(port) as line:
        other = tool.start("--no-listen", "watch", "100", "--every", "50ms", port=line.name)
        other.stdout.readline()
        line.is_tapped = True
        for words in (["scan"], ["read", "100"], ["identify"]):
            ended = tool.run(*words, port=line.tap_name)
            check(ended.status == REFUSED and "unit 1" in ended.errors and "--no-listen" in ended.errors,
                  f"{what}: {words[0]} refuses a line in use", ended)
        other.kill()
        other.communicate()


def over_tcp(tool, check, others, server):
    """A server of its own, and drives behind a serial device server."""
    number = free_port()
    others.serve(f"tcp:{number}", server, stderr=subprocess.DEVNULL)
    wait_for_listener(number)
    tool.port = f"tcp://127.0.0.1:{number}"
    reads(tool, check, "pymodbus over TCP")
    number = free_port()
    others.processes.append(tool.start("simulate", "atv320:7", port=others.device_server(number)))
    others.processes[-1].stdout.readline()
    wait_for_listener(number)
    ended = tool.run(*QUIET, "--json", "-u", 7, "read", "RFR", port=f"tcp://127.0.0.1:{number}")
    check(ended.status == DONE and ended.objects()[0]["value"] == 0.0, "a drive behind a serial device server", ended)


def main(check, program, libmodbus_server):
    servers = {"libmodbus": ([libmodbus_server, "@"], ""),
               "pymodbus": ([sys.executable, "-B", str(HERE.parent / "interop" / "pymodbus_server.py"), "@"], "pymodbus")}
    for what, (command, identity) in servers.items():
        with Tool(program) as tool, Programs() as others:
            near, tool.port = others.line()
            others.serve(near, command, stderr=subprocess.DEVNULL)
            finds(tool, check, what, identity)
            reads(tool, check, what)
            writes(tool, check, what)
            shows(tool, check, what, tool.port)
            refuses(tool, check, what, tool.port)
    with Tool(program) as tool, Programs() as others:
        over_tcp(tool, check, others, servers["pymodbus"][0])


runs(main)
