# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client of libmodbus brings five simulated drives on one line to operation and back.

    python3 libmodbus_drives.py SIMULATE CLIENT
"""
import subprocess
import sys

from simulator import DRIVES, Registers, Simulator


def main(program, client):
    units = list(enumerate(DRIVES, 1))
    with Simulator(program, *(f"{name}:{unit}" for unit, name in units)) as device:
        words = [str(word) for unit, name in units
                 for word in (unit, Registers(name).cmd, Registers(name).eta)]
        return subprocess.run([client, device, *words], timeout=240, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
