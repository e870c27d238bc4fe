# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs a server and a client on the two ends of a serial line made by socat; the status is the client's.

    python3 pair.py [--seconds LIMIT] SERVER [ARGUMENT...] -- CLIENT [ARGUMENT...]

The client has 40 seconds where no limit is named. In the commands, @ stands for the device of that end. The line
lives in the working directory.
"""
import os
import select
import signal
import subprocess
import sys
import tempfile
import time

READY_LIMIT = 10
CLIENT_LIMIT = 40


def wait_for_line(wire, ends):
    limit = time.monotonic() + READY_LIMIT
    while not all(map(os.path.exists, ends)):
        if time.monotonic() > limit or wire.poll() is not None:
            raise RuntimeError("socat makes no line")
        time.sleep(0.01)


def wait_for_server(server):
    heard, _, _ = select.select([server.stdout], [], [], READY_LIMIT)
    if not heard or server.stdout.readline().strip() != "ready":
        raise RuntimeError("the server is not ready")


def on(device, command):
    return [device if word == "@" else word for word in command]


def run(server, client, limit, folder, processes):
    ends = [os.path.join(folder, name) for name in ("server", "client")]
    processes.append(subprocess.Popen(["socat", *[f"pty,raw,echo=0,link={end}" for end in ends]]))
    wait_for_line(processes[-1], ends)
    processes.append(subprocess.Popen(on(ends[0], server), stdout=subprocess.PIPE, text=True))
    wait_for_server(processes[-1])
    return subprocess.run(on(ends[1], client), timeout=limit, check=False).returncode


def main(words):
    limit = CLIENT_LIMIT
    if words[0] == "--seconds":
        limit, words = float(words[1]), words[2:]
    cut = words.index("--")
    processes = []
    # An exception, so that being ended cleans up too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    with tempfile.TemporaryDirectory(prefix="line-", dir=os.getcwd()) as folder:
        try:
            status = run(words[:cut], words[cut + 1:], limit, folder, processes)
            print("the client's status:", status)
            return status
        finally:
            for process in reversed(processes):
                process.kill()
                process.wait()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
