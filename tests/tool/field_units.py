# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Units of a test's own that say what the test wants, at a pseudo-terminal or behind a TCP port."""
import socket
import threading
import time

from support import Line


class Unit:
    """Answers each request of function 3 by what `said` makes of it: bytes, or (seconds to wait first, bytes) in a list."""

    def __init__(self, said):
        self.said, self.requests = said, []

    def take(self, request, send):
        self.requests.append(request)
        answer = self.said(request)
        for wait, data in answer if isinstance(answer, list) else [(0, answer)]:
            time.sleep(wait)
            send(data)


class UnitOnLine(Line):
    """with UnitOnLine(said) as line: ... line.name, line.unit.requests"""

    def __init__(self, said):
        super().__init__()
        self.unit = Unit(said)

    def hear(self, data):
        self.unit.take(data, self.say)


class OnTcp:
    """with ... as it: listens on a TCP port, `it.name` of the tool, and hands each connection to its `talk`, one after the other."""

    def __init__(self, word="tcp"):
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.name = f"{word}://127.0.0.1:{self.listening.getsockname()[1]}"
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                line, _ = self.listening.accept()
            except OSError:
                return
            line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            try:
                self.talk(line)
            except OSError:
                pass
            line.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.listening.close()


class UnitOnTcp(OnTcp):
    """A unit behind a TCP port."""

    def __init__(self, said):
        self.unit = Unit(said)
        super().__init__()

    def talk(self, line):
        while request := line.recv(512):
            self.unit.take(request, line.sendall)
