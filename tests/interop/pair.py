# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs a server and a client on the two ends of a serial line made by socat; the status is the client's.

    python3 pair.py SERVER [ARGUMENT...] -- CLIENT [ARGUMENT...]

In the commands, @ stands for the device of that end.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time


def line(folder):
    ends = [os.path.join(folder, name) for name in ("server", "client")]
    process = subprocess.Popen(["socat", *[f"pty,raw,echo=0,link={end}" for end in ends]])
    limit = time.monotonic() + 10
    while not all(map(os.path.exists, ends)):
        if time.monotonic() > limit or process.poll() is not None:
            raise RuntimeError("socat makes no line")
        time.sleep(0.01)
    return process, ends


def on(device, command):
    return [device if word == "@" else word for word in command]


def main(words):
    cut = words.index("--")
    processes = []
    with tempfile.TemporaryDirectory() as folder:
        try:
            wire, ends = line(folder)
            processes.append(wire)
            server = subprocess.Popen(on(ends[0], words[:cut]), stdout=subprocess.PIPE, text=True)
            processes.append(server)
            if server.stdout.readline().strip() != "ready":
                print("the server is not ready")
                return 1
            client = subprocess.run(on(ends[1], words[cut + 1:]), timeout=60, check=False)
            return client.returncode
        finally:
            for process in reversed(processes):
                process.send_signal(signal.SIGKILL)
                process.wait()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
