# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The lines for CI that docs/tool.md shows, as they stand there: they end with the status of the check, and leave a report. What stands
for whoever uses them is made here: a device (one that keeps to all clauses, and one of pymodbus), sudo, and the copy of this repository,
whose tool is built already.

    python3 checked_in_ci.py TOOL PAGE
"""
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import textwrap
import xml.etree.ElementTree as tree

from support import DIFFERS, DONE, HERE, runs

LIMIT = 240  # s
METER = """
[device]
vendor = "Maker"
product = "Meter"
[[register]]
name = "voltage"
space = "holding"
address = 0
type = "u16"
simulated = 230
"""
STEP = re.compile(r"^      - run: \|\n((?:          .*\n)+)", re.MULTILINE)


def program(path, lines):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n" + lines + "\n", encoding="utf-8")
    path.chmod(0o755)


def report_of(shown, device, checked):
    """Status and report of the lines, with these commands as the device and as the tool."""
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "meter.toml").write_text(METER, encoding="utf-8")
        program(place / "device", f"exec {device} >serves")
        program(place / "sudo", "exit 0")
        # Where the tool is built first, the device has minutes to begin.
        program(place / "rtuwire" / "tools" / "rtuwire.sh", f"until [ -s serves ]; do sleep 0.1; done; exec {checked}")
        process = subprocess.Popen(["bash", "-e", "-c", shown], cwd=place, start_new_session=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True,
                                   env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "HOME": folder})
        try:
            process.wait(LIMIT)
        finally:
            # What the lines leave running is a runner's to end.
            os.killpg(process.pid, signal.SIGKILL)
        errors = process.communicate()[1]
        report = place / "report.xml"
        return process.returncode, tree.parse(report).getroot().find("testsuite").attrib if report.exists() else {}, errors


def main(check, tool, page):
    section = pathlib.Path(page).read_text(encoding="utf-8").partition("**In your own CI**")[2].partition("\n## ")[0]
    steps = STEP.findall(section)
    check(len(steps) == 1, "the page shows one step", steps)
    shown, name = textwrap.dedent(steps[0]), shlex.quote(os.path.abspath(tool))
    status, report, errors = report_of(shown, f'{name} --port "$1" simulate meter.toml:1', f'{name} "$@" --only L01,L34,F03')
    check(status == DONE and report.get("failures") == "0" and int(report.get("tests", 0)) > 10,
          "a device that keeps to all clauses", (status, report, errors))
    other = f'{shlex.quote(sys.executable)} -B {shlex.quote(str(HERE.parent / "interop" / "pymodbus_server.py"))} "$1"'
    status, report, errors = report_of(shown, other, f'{name} "$@" --only L01,L34')
    check(status == DIFFERS and report.get("failures") == "1" and report.get("tests") == "2",
          "a device that does not is told by the status, and in the report", (status, report, errors))


runs(main)
