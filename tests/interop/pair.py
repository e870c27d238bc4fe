# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs a server and a client on the two ends of a serial line made by socat; the status is the client's.

    python3 pair.py [--seconds LIMIT] SERVER [ARGUMENT...] -- CLIENT [ARGUMENT...]
    python3 pair.py --tcp listens|behind SERVER [ARGUMENT...] -- CLIENT [ARGUMENT...]

The client has 240 seconds where no limit is named. In the commands, @ stands for the device of that end. The line
lives in the working directory. With --tcp the client's device is tcp:PORT: the server listens there itself, or knows only
its serial device, behind a serial device server, which is socat.
"""
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile

from simulator import soon

READY_LIMIT = 60
CLIENT_LIMIT = 240


def wait_until(is_so, what):
    if not soon(is_so, READY_LIMIT):
        raise RuntimeError(what)


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return found.getsockname()[1]


def wait_for_listener(port):
    """Until somebody listens, without connecting: a device server may serve one client only."""
    def listens():
        with open("/proc/net/tcp", encoding="ascii") as table:
            return any(line.split()[1].endswith(f":{port:04X}") and line.split()[3] == "0A" for line in list(table)[1:])
    wait_until(listens, "nobody listens")


def on(device, command):
    return [device if word == "@" else word for word in command]


class Programs:
    """with Programs() as others: lines, servers and device servers, which end with it."""

    def __enter__(self):
        self.folder, self.processes = tempfile.TemporaryDirectory(prefix="line-", dir=os.getcwd()), []
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.kill()
            process.wait()
        self.folder.cleanup()

    def start(self, words, **how):
        self.processes.append(subprocess.Popen(words, text=True, **how))
        return self.processes[-1]

    def line(self):
        """The two ends of a line of its own."""
        ends = [os.path.join(self.folder.name, f"{len(self.processes)}{name}") for name in ("server", "client")]
        wire = self.start(["socat", *[f"pty,raw,echo=0,link={end}" for end in ends]])
        wait_until(lambda: wire.poll() is not None or all(map(os.path.exists, ends)), "socat makes no line")
        if wire.poll() is not None:
            raise RuntimeError("socat makes no line")
        return ends

    def serve(self, device, command, **how):
        """A server of that device, once it says that it is ready, which is returned."""
        server = self.start(on(device, command), stdout=subprocess.PIPE, **how)
        heard, _, _ = select.select([server.stdout], [], [], READY_LIMIT)
        if not heard or server.stdout.readline().strip() != "ready":
            raise RuntimeError("the server is not ready")
        return server

    def device_server(self, port):
        """A TCP port on one side, a line on the other; its far end is returned. socat opens its second side only when
        somebody has connected, so the line is made by another."""
        far, near = self.line()
        self.start(["socat", f"tcp-listen:{port},bind=127.0.0.1,reuseaddr,nodelay", f"{near},raw,echo=0"])
        return far


def main(words):
    limit, kind = CLIENT_LIMIT, ""
    if words[0] == "--seconds":
        limit, words = float(words[1]), words[2:]
    elif words[0] == "--tcp":
        kind, words = words[1], words[2:]
    cut = words.index("--")
    # An exception, so that being ended cleans up too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    with Programs() as others:
        if kind:
            port = free_port()
            far = f"tcp:{port}"
            near = others.device_server(port) if kind == "behind" else far
        else:
            near, far = others.line()
        others.serve(near, words[:cut])
        if kind:
            wait_for_listener(port)
        status = subprocess.run(on(far, words[cut + 1:]), timeout=limit, check=False).returncode
        print("the client's status:", status)
        return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
