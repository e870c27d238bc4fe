# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The demo is interrupted while the cable of its simulated drive is cut: it sees the motor stand before it ends.

    python3 cut_cable.py DEMO
"""
import signal
import subprocess
import sys


def main(demo):
    process = subprocess.Popen([demo, "--svg", "/dev/null"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    output = []
    for line in process.stdout:
        output.append(line)
        if "order to run is dropped: no response" in line:
            process.send_signal(signal.SIGINT)
            break
    output += process.stdout.readlines()
    process.stdout.close()
    status = process.wait()
    said = "".join(output)
    is_right = "The cable is cut" in said and "The motor stands." in said and status == 128 + signal.SIGINT
    print(f"status {status}\n{said}")
    return 0 if is_right else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
