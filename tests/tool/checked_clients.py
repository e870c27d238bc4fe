# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `check --client` says of clients with one defect each (defective_clients.py), which clauses each breaks, and of
clients that are in use. All are checked at once: nearly all of that time is waiting.

    python3 checked_clients.py TOOL defects [WORD OF A CLIENT'S NAME | N: every Nth]
    python3 checked_clients.py TOOL clients OUR_CLIENT LIBMODBUS_CLIENT DOCS_TOOL_MD
    python3 checked_clients.py TOOL npm
"""
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree

from support import DIFFERS, DONE, HERE, USAGE, Line, Tool, runs, soon

import defective_clients
from defective_clients import Client, SendsAtOnce
from pair import Programs, free_port

PROGRAM = [sys.executable, "-S", "-E", "-B", os.path.join(HERE, "defective_clients.py")]
TIMEOUT = 0.3  # s
LONG = 1.0  # of clients that are answered: no machine is so busy
LATE = {"K63"}  # fails by what comes too early, which nothing does on a busy machine
CLAUSES = 44


class Found:
    """What a check said."""

    def __init__(self, process, place):
        self.status, self.errors = process.wait(), place.with_suffix(".err").read_text()
        self.rows = {row["clause"]: row for row in map(json.loads, place.read_text().splitlines())}

    def clauses(self, verdict, level=None):
        return {key for key, row in self.rows.items() if row["verdict"] == verdict and level in (None, row["level"])}

    def why(self, clauses):
        return {each: (self.rows[each]["verdict"], self.rows[each]["why"]) for each in clauses if each in self.rows}

    def differences(self, musts, shoulds, unasked):
        """From what is due."""
        musts, shoulds, unasked = set(musts.split()), set(shoulds.split()), set(unasked.split())
        wrong = (self.clauses("fails", "must") ^ musts) | (self.clauses("fails", "should") ^ shoulds)
        missing = (self.clauses("does not apply") | self.clauses("not tried")) - musts - shoulds
        wrong |= {each for each in missing if "clause K11" not in self.rows[each]["why"]} if "*" in unasked else missing ^ unasked
        wrong |= set() if len(self.rows) == CLAUSES else {"rows"}
        wrong |= set() if self.status == (DIFFERS if musts else DONE) else {f"status {self.status}: {self.errors[-200:]}"}
        return self.why(wrong) or wrong

    def differences_of_others(self, musts, shoulds, unasked):
        """The same of clients that nobody here can make faster."""
        wrong = self.differences(musts, shoulds, unasked)
        return {each for each in wrong if each not in LATE or self.rows[each]["verdict"] != "holds"}


def checked(tool, commands):
    """Each by its name."""
    started = {}
    for name, (words, command) in commands.items():
        place = tool.place / name
        with open(place, "w") as output, open(place.with_suffix(".err"), "w") as errors:
            process = tool.start("--timeout", TIMEOUT, "--json", *words, "check", "--client", "--", *command,
                                 stdout=output, stderr=errors)
        started[name] = process, place
    return {name: Found(*each) for name, each in started.items()}


def check_defects(tool, check, wanted=""):
    kinds = [Client, *Client.__subclasses__()]
    kinds = kinds[::int(wanted)] if wanted.isdigit() else [kind for kind in kinds if wanted in kind.__name__]

    def found_of(kinds):
        return checked(tool, {kind.__name__: ([], [*PROGRAM, kind.__name__]) for kind in kinds})

    def differences(kind):
        return found[kind.__name__].differences(kind.musts, kind.shoulds, kind.unasked)

    found = found_of(kinds)
    # On a busy machine a time-out may pass: what is not as it should be is looked at once more, with few beside it.
    again = [kind for kind in kinds if differences(kind)]
    for kind in again:
        print("     again:", kind.__name__, differences(kind))
    found |= found_of(again)
    for kind in kinds:
        due = f"{kind.musts} {kind.shoulds}".strip() or "all hold"
        check(not differences(kind), f"{kind.__name__}: {kind.__doc__.split('.')[0]}: {due}", differences(kind))


def check_clients(tool, check, ours, libmodbus, page):
    # What was found of libmodbus 3.1.6, used without its error recovery.
    due = {"ours": ("", "", ""), "libmodbus": ("K30 K31 K60 K61 K63 K73", "K12 K50 K51 K75 K80", "K62")}
    of_page, by_line = Page(tool, page), [ByLine(tool, kind) for kind in (Client, SendsAtOnce)]
    found = checked(tool, {"ours": ([], [os.path.abspath(ours)]), "libmodbus": ([], [os.path.abspath(libmodbus)])})
    for name, each in due.items():
        check(not found[name].differences_of_others(*each), f"{name}: {each}", found[name].differences(*each))
    of_page.end(check)
    for each in by_line:
        each.end(check)
    check_ports(tool, check)
    check_words(tool, check)
    check_programs(tool, check)


def check_npm(tool, check):
    """What was found of modbus-serial 8.0.25 and jsmodbus 5.0.0."""
    due = {"modbus-serial": ("K26 K30 K31 K60 K61 K63 K72", "K12 K80", "K62"),
           "jsmodbus": ("K25 K30 K31 K60 K63 K72 K73", "K12 K75 K80", "K62")}
    script = os.path.join(HERE.parent, "interop", "checked_npm.js")
    found = checked(tool, {name: ([], ["node", script, name]) for name in due})
    for name, each in due.items():
        check(not found[name].differences_of_others(*each), f"{name}: {each}", found[name].differences(*each))


class Page:
    """The client of the page is run as it stands there, and what the page shows is what comes."""

    def __init__(self, tool, page):
        with open(page, encoding="utf-8") as file:
            text = file.read().split("## Check a client", 1)[1].split("\n## ", 1)[0]
        (tool.place / "my_client.py").write_text(re.search(r"```python\n(.*?)```", text, re.S)[1])
        command, *self.shown = re.search(r"```\n(\$ rtuwire .*?)```", text, re.S)[1].splitlines()
        self.process = tool.start(*command.removeprefix("$ rtuwire ").replace("python3", sys.executable).split())

    def end(self, check):
        output, errors = self.process.communicate(timeout=120)
        came = output.splitlines() + errors.splitlines()
        check(len(self.shown) > 4 and all(line in came for line in self.shown if line != "..."), "the page shows what comes",
              output + errors)


def check_ports(tool, check):
    """A serial device, whose other end the client opens, and TCP."""
    some = ["--only", "K01,K02,K20,K23"]
    with Line() as line:
        refused = tool.run("check", "--client", "--", "true", port=line.name)
    check(refused.status == USAGE and "--client-port" in refused.errors, "a device has another end", refused)
    # Between two pseudo-terminals bytes take no time, whatever the bit rate.
    with Programs() as programs:
        near, far = programs.line()
        said = tool.run("--timeout", TIMEOUT, "check", "--only", "K01,K63", "--client", "--client-port", far, "--",
                        *PROGRAM, "Client", port=near)
        check(said.status == DONE, "a right client at the other end of a pair of pseudo-terminals", said)
    where = f"tcp://127.0.0.1:{free_port()}"
    for name, status in (("Client", DONE), ("NoUnit", DIFFERS)):
        said = tool.run("--timeout", TIMEOUT, "check", *some, "--client", "--", *PROGRAM, name, port=where)
        check(said.status == status and ("K23" in said.output) == (status == DIFFERS), f"{name} over TCP", said)


class ByLine:
    """A client that asks by itself: its requests alone are judged."""
    tried = {"K11", "K13", "K63", "K70", "K71", "K72", "K73", "K74", "K75"}

    def __init__(self, tool, kind):
        self.kind, self.ends = kind, threading.Event()
        self.process = tool.start("--timeout", TIMEOUT, "--json", "check", "--client")
        port = re.search(r" on (\S+),", self.process.stderr.readline())[1]
        self.poller = threading.Thread(target=self.poll, args=[kind(port, TIMEOUT)])
        self.poller.start()

    def poll(self, client):
        while not self.ends.is_set():
            try:
                client.obey("read", 1, 100, 2)
            except defective_clients.Failed:
                pass
            except OSError:
                return  # the tool has ended

    def end(self, check):
        output, errors = self.process.communicate(timeout=120)
        self.ends.set()
        self.poller.join()
        verdicts = {row["clause"]: row["verdict"] for row in map(json.loads, output.splitlines())}
        tried = {key for key, verdict in verdicts.items() if verdict != "not tried"}
        check(tried == self.tried, "what requests alone show", tried)
        fails = {key for key, verdict in verdicts.items() if verdict == "fails"}
        check(fails == set(self.kind.musts.split()) and self.process.returncode == (DIFFERS if fails else DONE),
              f"{self.kind.__name__} by its requests", (fails, errors))


def check_words(tool, check):
    said = tool.run("--json", "check", "--client", "--list")
    check(len(said.objects()) == CLAUSES and said.status == DONE, "all are listed", said)
    check("is answered: nothing" in tool.run("check", "--explain", "K11").output, "each is explained")
    said = tool.run("check", "--explain", "K62").output
    check("~T: a silence" in said and "GOOD: the right" in said and "LAST" not in said, "with the words that it uses", said)
    for words, what in ((["check", "--", "true"], "--client"), (["check", "--client", "--scratch", "1-8"], "for servers"),
                        (["check", "--client", "--", "/no/such/program"], "No such file"),
                        (["-p", "sim:atv320:1", "check", "--client", "--", "true"], "sim:atv320:1")):
        said = tool.run(*words)
        check(said.status == USAGE and what in said.errors, f"{words} is refused", said)
    said = tool.run("--timeout", TIMEOUT, "--json", "check", "--client", "--junit", tool.place / "client.xml", "--", "false")
    verdicts = {row["verdict"] for row in said.objects()[1:]}
    check(said.status == DIFFERS and verdicts == {"not tried"} and "ended with status 1" in said.objects()[0]["why"],
          "a client that does not read is one failure", said)
    check('failures="1" skipped="43"' in (tool.place / "client.xml").read_text(), "and one in the file for others")
    for clause in ("K60", "K62"):
        check("has to wait" in tool.run("check", "--explain", clause).output, f"{clause} says what a client has to do")
    said = tool.run("--timeout", 0, "check", "--client", "--", "true")
    check(said.status == USAGE and "--timeout" in said.errors and "'--'" not in said.errors, "what is wrong stands before --", said)


ASKS_8E1 = """
import sys, serial
line = serial.Serial(sys.argv[1], 19200, parity="E", timeout=int(sys.argv[2]) / 1000)
line.write(bytes.fromhex("01030064000285D4"))
answer = line.read(9)
print(*[int.from_bytes(answer[at:at + 2], "big") for at in (3, 5)])
"""
ASKS_WITHOUT_END = """
import os, sys, tty
line = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
tty.setraw(line)
for _ in range(3000):
    os.write(line, bytes.fromhex("01030064000285D4"))
"""


AS_ASKED_AND_MORE = ASKS_8E1 + """
if len(answer) < 9:
    for _ in range(300):
        line.write(bytes.fromhex("01030064000285D4"))
    print("error")
"""


def lives(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def check_programs(tool, check):
    """What is no client, or none that does what it is told."""
    def checked_by(*command, only="K01", junit="one.xml"):
        return tool.run("--timeout", LONG, "--json", "check", "--client", "--only", only, "--junit", tool.place / junit, "--",
                        *command)

    said = tool.run("-v", "--timeout", LONG, "check", "--only", "K01", "--client", "--", *PROGRAM, "Client")
    check(said.status == DONE and "01 03 00 64 00 02 85 D4" in said.errors, "its frames are shown where that is asked for", said)
    python = [sys.executable, "-c"]
    said = checked_by(*python, ASKS_8E1)
    check(said.status == DONE, "a client may ask for 8E1", said)
    said = checked_by(*python, "print('4196 4197')")
    check(said.status == DIFFERS and "no such request came" in said.objects()[0]["why"], "values that nobody asked for are none", said)
    said = checked_by(*PROGRAM, "EndsAtFailure", only="K60,K74")
    check(said.status == DIFFERS and "K60 was not tried" in said.errors and "clause K70" in said.errors,
          "what hides a clause is no success, though it is another's", said)
    said = checked_by("true", only="K11,K20")
    check(said.status == DIFFERS and "clause K01" in said.errors, "nor is a program that does nothing", said)
    said = checked_by(*python, "print('error: \\x1b[31m\\x01')", junit="marks.xml")
    whys = [each.text for each in xml.etree.ElementTree.parse(tool.place / "marks.xml").iter("failure")]
    check(said.status == DIFFERS and len(whys) == 1 and "x1B" in whys[0], "control characters are none in XML", (said, whys))
    said = checked_by(*python, ASKS_WITHOUT_END, only="K01,K13")
    check(said.status == DIFFERS, "who asks without end and reads nothing keeps nobody", said)
    rows = checked_by(*python, AS_ASKED_AND_MORE, only="K13").objects()
    check(rows[0]["verdict"] == "fails" and "more" in rows[0]["why"] and len(rows[0]["why"]) < 400, "nor fills a row", rows[0]["why"])
    left = tool.place / "left"
    said = checked_by("sh", "-c", f'sleep 1000 & echo $! >> {left}; exec {" ".join(PROGRAM)} Client "$@"', "-", only="K01,K03")
    pids = left.read_text().split()
    check(said.status == DONE and len(pids) == 2 and soon(lambda: not any(map(lives, pids))), "what a client leaves running is ended",
          (said, pids))
    # Ended in its first clause: no file of nothing that failed.
    begun = tool.place / "begun"
    process = tool.start("check", "--client", "--junit", tool.place / "cut.xml", "--", "sh", "-c", f"echo > {begun}; sleep 1000")
    check(soon(begun.exists), "the first clause has begun")
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=60)
    cases = list(xml.etree.ElementTree.parse(tool.place / "cut.xml").iter("testcase"))
    check(process.returncode == 128 + signal.SIGTERM and len(cases) == CLAUSES and cases[0].find("error") is not None
          and all(each.find("skipped") is not None for each in cases[1:]), "a check that was cut is an error for other programs",
          (process.returncode, len(cases)))


PARTS = {"defects": check_defects, "clients": check_clients, "npm": check_npm}


def main(check, program, part, *words):
    began = time.monotonic()
    with Tool(program) as tool:
        PARTS[part](tool, check, *words)
    print(f"{time.monotonic() - began:.0f} s")


if __name__ == "__main__":
    runs(main)
