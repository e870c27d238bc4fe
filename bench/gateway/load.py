# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a gateway costs: 300 devices on 10 lines, each device eight values a second, simulated in processes of their own.

    /usr/bin/python3 bench/gateway/load.py TOOL LINES_ALONE [SECONDS [SILENT]]

TOOL is to be optimised: build/release/tools/rtuwire/rtuwire; LINES_ALONE beside it in tests/gateway. SILENT devices of each
line are in the file and not on the line. A device that is there and was not read, an error, or memory that grows behind
the first fifth of the time is a failure; the processor's share is a figure of the machine, and none.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

LINES, DEVICES, VALUES = 10, 30, 8
MOST_GROWTH_KB = 1024


def register_file():
    rows = [f'[[register]]\nname = "value_{i}"\nspace = "input"\naddress = {2 * i}\ntype = "f32"\nunit = "V"\nsimulated = {i}.5\n'
            for i in range(VALUES)]
    return "\n".join(rows)


def gateway_file(ports, silent):
    text = ['site = "bench"', 'gateway = "g1"']
    for number, port in enumerate(ports):
        text += ["[[line]]", f'name = "line{number}"', f'port = "{port}"', "timeout = 0.2", "retries = 0", "listen = 0"]
        for unit in range(1, DEVICES + 1 + silent):
            text += ["[[line.device]]", f'name = "m{unit}"', f"unit = {unit}", 'file = "./meter.toml"', "every = 1.0"]
    return "\n".join(text) + "\n"


def simulated(tool, folder):
    """A process that simulates one line, and its port."""
    words = [f"{folder}/meter.toml:{unit}" for unit in range(1, DEVICES + 1)]
    process = subprocess.Popen([tool, "simulate", ",".join(words)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    for line in process.stdout:
        for word in line.split():
            if word.startswith("/dev/"):
                return process, word.rstrip(".,:;")
    raise SystemExit("load.py: the simulated line told no port")


def processor_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident_kb(pid):
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    return next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS:"))


def main(tool, lines_alone, seconds=30.0, silent=0):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "meter.toml").write_text(register_file())
        others = []
        try:
            for _ in range(LINES):
                others.append(simulated(tool, folder))
            file = pathlib.Path(folder, "gateway.toml")
            file.write_text(gateway_file([port for _, port in others], silent))
            gateway = subprocess.Popen([lines_alone, file, str(seconds)], stdout=subprocess.PIPE, text=True)
            time.sleep(seconds / 5)
            before = time.monotonic(), processor_seconds(gateway.pid), resident_kb(gateway.pid)
            time.sleep(seconds * 3 / 5)
            after = time.monotonic(), processor_seconds(gateway.pid), resident_kb(gateway.pid)
            told = json.loads(gateway.communicate()[0])
        finally:
            for process, _ in others:
                process.kill()
                process.wait()
    share = (after[1] - before[1]) / (after[0] - before[0])
    print(f"{told['devices']} devices on {LINES} lines, {told['available']} of them there: {told['rounds'] / seconds:.0f} rounds/s, "
          f"{told['requests'] / seconds:.0f} requests/s, {100 * share:.1f} % of a processor, {after[2]} kB resident "
          f"({after[2] - before[2]:+} kB), {told['overruns']} rounds left out, {told['silences']} silences")
    wrong = [name for name, is_wrong in {
        "not all devices that are there are read": told["available"] != LINES * DEVICES,
        "errors": told["errors"] != 0,
        "memory grows": after[2] - before[2] > MOST_GROWTH_KB,
    }.items() if is_wrong]
    for each in wrong:
        print(f"load.py: {each}: {told}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4, 5):
        raise SystemExit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], *(kind(word) for kind, word in zip((float, int), sys.argv[3:]))))
