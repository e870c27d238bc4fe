# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `rtuwire monitor` does to a terminal: what it leaves behind, what it sends, and what it takes.

    python3 monitor_terminal.py TOOL leaves|sizes|typed|sent
"""
import fcntl
import os
import pathlib
import random
import shlex
import signal
import struct
import subprocess
import tempfile
import termios
import unicodedata

from screen import LIMIT, Screen
from support import runs, soon

WORDS = ["--port", "sim:atv320:7", "--no-listen", "-u", "7", "monitor", "--every", "100ms"]
STATE = r"^ +7 +atv320 +switch on disabled"
CLOCK = len("\x1b[1;78H\x1b[0m00:00:00")  # what the time of day takes, at most


class Shell:
    """A shell with its jobs in tmux, which shows what a person would see. (The pages of pyte have no second screen.)"""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.tmux_words = ["tmux", "-S", str(self.folder / "socket"), "-f", "/dev/null"]
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "PS1": "$ "}
        environment.pop("TMUX", None)
        subprocess.run([*self.tmux_words, "-u", "new-session", "-d", "-x", "100", "-y", "30",
                        "bash --norc --noprofile -i"], check=True, env=environment)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.tmux("kill-server")

    def tmux(self, *words):
        return subprocess.run([*self.tmux_words, *words], capture_output=True, text=True, check=True).stdout

    def type(self, text):
        self.tmux("send-keys", "-l", text)

    def shown(self):
        return self.tmux("capture-pane", "-p")

    def run(self, command):
        """What the command has written by its end, in a file: nothing of it is on the screen but its own line."""
        file = self.folder / "output"
        file.unlink(missing_ok=True)
        self.type(f"{command} > {file}.new; mv {file}.new {file}\r")
        soon(file.exists, LIMIT)
        return file.read_text()

    def state(self):
        """The settings of the terminal, and of its screen: whether it is the second one, shows a cursor and wraps."""
        return self.run("stty -a"), self.tmux("display-message", "-p", "#{alternate_on} #{cursor_flag} #{wrap_flag}")


def is_monitor(shell):
    return soon(lambda: "switch on disabled" in shell.shown() and "q quit" in shell.shown(), LIMIT)


def leaves(tool, check):
    with tempfile.TemporaryDirectory(prefix="terminal-") as folder, Shell(folder) as shell:
        shell.type("stty -ixon; echo first\r")
        soon(lambda: "\nfirst" in shell.shown(), LIMIT)
        before = shell.state()
        pid = pathlib.Path(folder, "pid")
        command = shlex.join([tool, *WORDS])

        def send(number):
            return lambda: os.kill(int(pid.read_text()), number)

        ways = {"q": (lambda: shell.type("q"), 0), "Ctrl-C": (lambda: shell.type("\x03"), 130),
                **{each.name: (send(each), 128 + each) for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1)}}
        for what, (end, status) in ways.items():
            shell.type(f"clear; echo before; bash -c 'echo $$ > {pid}; exec \"$@\"' - {command}; echo \"status $?\"\r")
            check(is_monitor(shell), f"{what}: its screen", shell.shown())
            end()
            check(soon(lambda: "status" in shell.shown(), LIMIT), f"{what}: it ends", shell.shown())
            lines = shell.shown().splitlines()
            check(lines[:2] == ["before", f"status {status}"], f"{what}: what was there is there, and nothing else", lines)
            check(shell.state() == before, f"{what}: the terminal is as it was", shell.state())
        shell.type(f"clear; {command}\r")
        check(is_monitor(shell), "its screen", shell.shown())
        shell.type("\x1a")
        check(soon(lambda: "Stopped" in shell.shown(), LIMIT), "Ctrl-Z", shell.shown())
        check(shell.state() == before, "the shell finds the terminal as it was", shell.state())
        shell.type("fg\r")
        check(is_monitor(shell), "fg, and it is drawn again", shell.shown())
        shell.type("p")
        check(soon(lambda: "PAUSED" in shell.shown(), LIMIT), "and takes keys", shell.shown())
        job = shell.tmux("list-panes", "-F", "#{pane_pid}").strip()
        os.kill(int(pathlib.Path(f"/proc/{job}/task/{job}/children").read_text()), signal.SIGSTOP)
        check(soon(lambda: "Stopped" in shell.shown(), LIMIT), "suspended without a word", shell.shown())
        shell.type("clear; fg\r")
        check(is_monitor(shell), "fg, and it is drawn again", shell.shown())
        shell.type("q")
        check(soon(lambda: "q quit" not in shell.shown(), LIMIT) and shell.state() == before, "q", shell.state())


def sizes(tool, check):
    for width, height in ((1, 1), (500, 200), (79, 24), (80, 24)):
        with Screen([tool, *WORDS], width, height) as page:
            if (width, height) == (1, 1):
                check(page.until(lambda: page.text == "T"), "1x1: what fits of a sentence", page.text)
            elif width < 80:
                check(page.until_shown(f"^This terminal has {width}x{height}"), f"{width}x{height}: too small", page.text)
            else:
                check(page.until_shown(STATE) and page.until(lambda: page.lines[-1].startswith("q quit")),
                      f"{width}x{height}: all of it", page.text[:200])
            # To and fro, faster than it draws.
            for each in range(50):
                page.resize(1 + each * 37 % 200, 1 + each * 23 % 60)
                page.take(0.01)
            page.resize(90, 25)
            check(page.until(lambda: page.until_shown(STATE) and page.lines[-1].startswith("q quit")), "another size", page.text)
            page.resize(width, height)
            page.type("q")
            check(page.end() == 0 and page.is_restored(), f"{width}x{height}: q", page.raw[-80:])
    # Marks and wide characters move no column.
    named = [tool, "--port", "sim:atv320:7,atv320:3", "--no-listen", "--name", "\u98ce\u673a=7", "--name", "e\u0301te\u0301=3", "monitor"]
    with Screen(named, LC_ALL="xx_XX.utf8") as page:
        check(page.until(lambda: page.text.count("switch on disabled") >= 2), "names of others", page.text)
        rows = [[page.shown.buffer[row][column].data for column in range(80)] for row in range(24)]
        unit = "".join(next(each for each in rows if "".join(each).startswith(" name "))).index("unit")
        for name, address in (("\u98ce", "7"), ("e\u0301", "3")):
            row = next(each for each in rows if each[1] in (name, unicodedata.normalize("NFC", name)))
            check(row[unit] == address, f"unit {address} stands in its column", row)
    with Screen([tool, *WORDS], 0, 0) as page:
        page.shown.resize(24, 80)
        check(page.until_shown(STATE) and page.lines[23].startswith("q quit"), "a terminal without a size has 80x24", page.text)


def typed(tool, check):
    ends = b"qQ\x03\x1a\x13\x11\x1c"  # what ends, suspends or holds it, by itself or by the terminal
    draw = random.Random(20261130)
    with Screen([tool, *WORDS]) as page:
        check(page.until_shown(STATE), "its screen", page.text)
        os.set_blocking(page.keyboard, False)
        for _ in range(20):
            garbage = bytes(each for each in draw.randbytes(3000) if each not in ends)
            while garbage:
                try:
                    garbage = garbage[os.write(page.keyboard, garbage):]
                except BlockingIOError:  # it draws first
                    page.take(0.01)
        page.type("\x1b[1;5q\x1bOq\x1b]0;quit\x07\x1bPquit\x1b\\")
        page.type("\x0c")  # by which all before it was taken
        seen = len(page.raw)
        check(page.until(lambda: b"\x1b[2J" in page.raw[seen:]), "garbage is survived, Ctrl-L draws anew", page.text)
        check(page.process.poll() is None, "sequences that nobody knows are no keys")
        page.type("\x1bq")
        check(page.end() == 0 and page.is_restored(), "Esc, and q ends it", page.raw[-80:])


def unread(page):
    return struct.unpack("i", fcntl.ioctl(page.keyboard, termios.FIONREAD, bytes(4)))[0]


def sent(tool, check):
    with Screen([tool, *WORDS]) as page:
        check(page.until_shown(STATE), "its screen", page.text)
        page.type("p")
        check(page.until_shown("PAUSED"), "paused", page.text)
        page.take(0.5)
        whole, page.raw, clock = len(page.raw), b"", page.lines[0]
        page.until(lambda: page.lines[0] != clock)
        clock = page.lines[0]
        page.until(lambda: page.lines[0] != clock)
        check(0 < len(page.raw) <= 3 * CLOCK < whole, "of a page that stands only the time of day is sent", page.raw)
        page.type("q")
        page.end()
    # It has drawn more than a terminal holds that nobody reads.
    with Screen([tool, *WORDS], 500, 200) as page:
        check(soon(lambda: unread(page) >= 4000, LIMIT), "a terminal that takes no more", unread(page))
        page.process.send_signal(signal.SIGTERM)
        check(soon(lambda: termios.tcgetattr(page.terminal) == page.before, LIMIT), "has its settings back")
        check(page.end() == 128 + signal.SIGTERM and page.is_restored(), "and its screen when it goes on", page.raw[-80:])


PARTS = {each.__name__: each for each in (leaves, sizes, typed, sent)}


def main(check, tool, part):
    PARTS[part](os.path.abspath(tool), check)


runs(main)
