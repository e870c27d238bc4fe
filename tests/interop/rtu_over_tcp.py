# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Our client over TCP: against pymodbus, which speaks RTU over TCP itself, or through socat, as a serial device server,
against a server that knows only its serial device.

    python3 rtu_over_tcp.py listens|behind SERVER... -- CLIENT...

The client's status. In the commands, @ stands for the device of that end: "tcp:PORT", or the server's pseudo-terminal.
"""
import os
import select
import socket
import subprocess
import sys
import tempfile
import time

READY_LIMIT, CLIENT_LIMIT = 10, 40


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return found.getsockname()[1]


def wait_until(is_so, what):
    limit = time.monotonic() + READY_LIMIT
    while not is_so():
        if time.monotonic() > limit:
            raise RuntimeError(what)
        time.sleep(0.01)


def listens(port):
    """Whether somebody listens, without connecting: a device server may serve one client only."""
    with open("/proc/net/tcp", encoding="ascii") as table:
        return any(line.split()[1].endswith(f":{port:04X}") and line.split()[3] == "0A" for line in list(table)[1:])


def device_server(folder, port, processes):
    """A TCP port on one side, a line on the other; its far end is returned. socat opens its second side only when somebody
    has connected, so the line is made by another."""
    far, near = ends = [os.path.join(folder, name) for name in ("far", "near")]
    processes.append(subprocess.Popen(["socat", *[f"pty,raw,echo=0,link={end}" for end in ends]]))
    wait_until(lambda: all(map(os.path.exists, ends)), "socat makes no line")
    processes.append(subprocess.Popen(["socat", f"tcp-listen:{port},bind=127.0.0.1,reuseaddr,nodelay",
                                       f"{near},raw,echo=0"]))
    return far


def run(kind, server, client, folder, processes):
    port = free_port()
    device = device_server(folder, port, processes) if kind == "behind" else f"tcp:{port}"
    processes.append(subprocess.Popen([device if word == "@" else word for word in server], stdout=subprocess.PIPE,
                                      text=True))
    heard, _, _ = select.select([processes[-1].stdout], [], [], READY_LIMIT)
    if not heard or processes[-1].stdout.readline().strip() != "ready":
        raise RuntimeError("the server is not ready")
    wait_until(lambda: listens(port), "nobody listens")
    return subprocess.run([f"tcp:{port}" if word == "@" else word for word in client], timeout=CLIENT_LIMIT,
                          check=False).returncode


def main(kind, *words):
    cut = words.index("--")
    processes = []
    with tempfile.TemporaryDirectory(prefix="tcp-", dir=os.getcwd()) as folder:
        try:
            return run(kind, words[:cut], words[cut + 1:], folder, processes)
        finally:
            for process in reversed(processes):
                process.kill()
                process.wait()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
