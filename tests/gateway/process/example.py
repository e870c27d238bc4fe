# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The quick start: runs as it stands on the page, shows what it says, ends by itself and leaves nothing behind.

    python3 example.py GATEWAY TOOL SCRIPT
"""
import json
import os
import pathlib
import signal
import subprocess
import time

from stand import LIMIT, Folder, listens, runs


def main(check, program, tool, script):
    with Folder() as folder:
        environment = {**os.environ, "RTUWIRE": os.path.abspath(tool), "RTUWIRE_GATEWAY": os.path.abspath(program),
                       "TMPDIR": str(folder), "LC_ALL": "C.UTF-8"}

        def start(*words):
            # Who runs this in the background has it ignored, and a shell cannot trap what was ignored when it began.
            return subprocess.Popen(["sh", script, *words], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True, start_new_session=True,
                                    preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        with start("--for", "10") as process:
            output, errors = process.communicate(timeout=LIMIT)
        check(process.returncode == 0, "it ends by itself, with status 0", (process.returncode, errors))
        states = {}
        for line in output.splitlines():
            topic, _, payload = line.partition(" ")
            if topic.endswith("/state"):
                states.setdefault(topic, []).append(json.loads(payload)["values"])
        check(set(states) == {f"rtuwire/desk/g1/line1/{each}/state" for each in ("meter", "fan", "pump")}, "all three are shown",
              sorted(states))
        meter = states.get("rtuwire/desk/g1/line1/meter/state", [{}])
        check((meter[-1]["voltage"]["value"], meter[-1]["voltage"]["unit"]) == (230.1, "V"), "the meter's voltage", meter[-1])
        check(len({each["power"]["value"] for each in meter if "power" in each}) > 1, "its power moves", meter[-1])
        check("rtuwire/desk/g1/status online" in output and "rtuwire/desk/g1/line1/fan/availability online" in output, "they are online")
        check(not list(folder.iterdir()), "its files are gone", list(folder.iterdir()))
        port = int(output.split("A broker on port ")[1].split(",")[0])
        check(not listens(port), "so is its broker")

        # Ctrl-C, in the middle: as typed, to all of the group. Twice by who thinks that the first was lost.
        for times in (1, 2):
            with start() as process:
                read = ""
                while "/state {" not in read and (line := process.stdout.readline()):
                    read += line
                check("/state {" in read, "values are shown", read[-300:])
                os.killpg(process.pid, signal.SIGINT)
                for _ in range(1, times):
                    time.sleep(0.02)  # the first is being answered
                    os.killpg(process.pid, signal.SIGINT)
                errors = process.communicate(timeout=LIMIT)[1]
            check(process.returncode == 130 and not list(folder.iterdir()), "behind Ctrl-C, too", (times, process.returncode, list(folder.iterdir()), errors))
        left = [each.name for each in pathlib.Path("/proc").glob("[0-9]*") if str(folder).encode() in cmdline(each)]
        check(not left, "no process is left", left)
        for words in (["--for"], ["--for", "x"], ["--for", "0"], ["now"]):
            with start(*words) as process:
                errors = process.communicate(timeout=LIMIT)[1]
            check(process.returncode == 2 and errors, f"{words} is refused", errors)


def cmdline(process):
    try:
        return (process / "cmdline").read_bytes()
    except OSError:
        return b""


if __name__ == "__main__":
    runs(main)
