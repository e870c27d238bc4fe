# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The gateway's values, its availability and its end; its file; its secrets.

    python3 values.py GATEWAY TOOL values|ends|check|command|secrets|disk
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

from stand import (LIMIT, METER, SITE, Broker, Client, Folder, Gateway, Simulator, Units, a_line, a_meter, flows, meter, runs,
                   soon, states, text_of)

SECRET = "hush-7f3a-Kreide"


def values(check, program, tool):
    """A meter of this test, and a simulated drive whose supervision the file lets be fed."""
    fan = {"name": "fan", "unit": 7, "drive": "atv320", "registers": ["RFR", "LCR", "ETA"], "feeds_supervision": True,
           "every": 0.5}
    slow = a_meter(groups='[{ registers = ["energy"], every = 2.0 }]', registers=["voltage", "power", "energy"])
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Simulator(tool, "atv320:7") as device:
        text = text_of(broker.port, [a_line(line.name, slow), a_line(device, fan, name="line2")])
        with Client(broker.port, "#") as client, Gateway(program, folder, text):
            check(flows(client, count=8), "a meter's values come", client.messages[-3:])
            check(flows(client, "line2/fan", count=4), "and a drive's", client.messages[-3:])
            got = states(client)
            check({each.values["voltage"]["unit"] for each in got if "voltage" in each.values} == {"V"} and
                  {each.values["voltage"]["value"] for each in got if "voltage" in each.values} == {230.1},
                  "scaled, with the unit", got[-1].values)
            check({each.values["energy"]["value"] for each in got if "energy" in each.values} == {123.45},
                  "of 32 bits, too", got[-1].values)
            check(all(each.seq < after.seq for each, after in zip(got, got[1:])), "seq counts up", [each.seq for each in got])
            check(all(each.time <= after.time for each, after in zip(got, got[1:])) and
                  min(each.age for each in got) < 1 and all(each.age > -0.1 for each in got), "with the time of the reading",
                  [round(each.age, 3) for each in got])
            check(not any(each.message.is_retained for each in got), "no value is retained")
            drive = states(client, "line2/fan")[-1].values
            check((drive["RFR"]["value"], drive["RFR"]["unit"]) == (0.0, "Hz") and set(drive) == {"RFR", "LCR", "ETA"},
                  "those that the file names, and no others", drive)
            energy = [each for _, each in line.requests if each[3] <= 2 < each[3] + each[5]]
            check(0 < len(energy) < len(line.requests) / 2 + 2, "a group has its own period", (len(energy), len(line.requests)))
            # Marked, not a number.
            line.units[3][1] = 0x7FFF
            since = time.time() + 0.5
            check(flows(client, since=since, count=2), "they go on")
            marked = [each.values["power"] for each in states(client) if each.time > since and "power" in each.values]
            check(marked and all(each["value"] is None and each["invalid"] is True for each in marked),
                  "a value that the device marks invalid is marked", marked)
            line.units[3][1] = 1200
            for topic in ("status", "line1/availability", "line2/availability", "line1/meter/availability",
                          "line2/fan/availability"):
                check(soon(lambda: client.last(f"{SITE}/{topic}") == "online", LIMIT), f"{topic} says online",
                      client.last(f"{SITE}/{topic}"))
            check(soon(lambda: len(client.of(f"{SITE}/line1/status")) > 3, LIMIT), "the line's loop says that it lives")
            beats = [json.loads(each.payload) for each in client.of(f"{SITE}/line1/status")]
            check(all(set(each) >= {"time", "seq", "requests", "silences", "errors", "up"} for each in beats) and
                  all(each["seq"] < after["seq"] and each["requests"] <= after["requests"]
                      for each, after in zip(beats, beats[1:])) and beats[0]["requests"] < beats[-1]["requests"],
                  "its counters count", beats[-2:])
            with Client(broker.port, "#") as later:
                soon(lambda: later.last(f"{SITE}/status"), LIMIT)
                kept = {each.topic: each.payload.decode() for each in later.messages if each.is_retained}
            for topic in ("status", "line1/availability", "line1/meter/availability"):
                check(kept.get(f"{SITE}/{topic}") == "online", f"{topic} is retained", sorted(kept))
            check(not [each for each in kept if each.endswith(("/state", "line1/status", "line2/status")) or "/answer/" in each],
                  "nothing is retained that ages", sorted(kept))


def ends(check, program, _):
    """A clean end says so itself; what is killed, the broker says."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        text = text_of(broker.port, [a_line(line.name)])
        for how, name in ((signal.SIGTERM, "TERM"), (signal.SIGINT, "INT")):
            with Client(broker.port, "rtuwire/#") as client, Gateway(program, folder, text) as gateway:
                check(flows(client), "values come")
                check(soon(lambda: client.last(f"{SITE}/status") == "online", LIMIT), "online")
                check(gateway.end(how) == 0, f"{name}: status 0")
                check(soon(lambda: client.last(f"{SITE}/status") == "offline", LIMIT), "offline is said")
                check(client.messages[-1].topic == f"{SITE}/status", "as its last word", client.messages[-1])
        with Client(broker.port, "rtuwire/#") as client, Gateway(program, folder, text) as gateway:
            check(flows(client), "values come")
            gateway.kill()
            check(soon(lambda: client.last(f"{SITE}/status") == "offline", LIMIT), "killed: the last will says offline")
        # Frozen: the line's loop is silent before the will comes.
        with Client(broker.port, "rtuwire/#") as client, Gateway(program, folder, text) as gateway:
            check(flows(client), "values come")
            gateway.process.send_signal(signal.SIGSTOP)
            stopped = time.time()
            check(soon(lambda: client.last(f"{SITE}/status") == "offline", LIMIT), "frozen: the will comes")
            late = [each for each in client.of(f"{SITE}/line1/status") if each.arrived > stopped + 1]
            check(not late, "the heartbeat does not go on without the loop", late)
            gateway.process.send_signal(signal.SIGCONT)
            went_on = time.time()
            check(flows(client, since=went_on + 1), "it goes on by itself")
            check(soon(lambda: client.last(f"{SITE}/status") == "online", LIMIT), "and is online again")
            old = [each for each in states(client, since=went_on + 0.5) if each.time < stopped]
            check(len(old) <= 1, "nothing from before comes as new", [(each.time - stopped, each.age) for each in old])


WRONG = (
    ("no site", lambda text: text.replace('site = "hall"\n', ""), "site"),
    ("a topic's sign", lambda text: text.replace('"hall"', '"hall/#"'), "site"),
    ("a key that is none", lambda text: text.replace("baud =", "bauds ="), "bauds"),
    ("no TOML", lambda text: text.replace("unit = 3", "unit = = 3"), "gateway.toml:"),
    ("a unit that is none", lambda text: text.replace("unit = 3", "unit = 248"), "unit"),
    ("a register that the file has not", lambda text: text + 'registers = ["voltag"]\n', "voltag"),
    ("a register file that is not there", lambda text: text.replace("meter.toml", "metre.toml"), "metre.toml"),
    ("a setting that is only read", lambda text: text.replace('"set_point"', '"voltage"'), "voltage"),
    ("a setting that moves something", lambda text: text.replace('"set_point"', '"gate"'), "gate"),
    ("a period of nothing", lambda text: text.replace("every = 0.5", "every = 0"), "every"),
    ("the same unit twice on a line", lambda text: text + text[text.index("[[line.device]]"):].replace('"meter"', '"other"'),
     "3"),
    ("the same name twice", lambda text: text + text[text.index("[[line.device]]"):].replace("unit = 3", "unit = 4"), "meter"),
    ("a port word that is none", lambda text: text.replace("/nowhere/ttyUSB0", "mbpa://x"), "mbpa"),
    ("a drive that nobody allowed to feed", lambda text: text.replace('file = "meter.toml"', 'drive = "atv320"'),
     "feeds_supervision"),
)


def check_(check, program, _):
    """The whole file, and nothing opened."""
    good = text_of(1, [a_line("/nowhere/ttyUSB0", a_meter(settings=["set_point"]))])
    with Folder() as folder:
        with Gateway(program, folder, good, start=False) as gateway:
            ended = gateway.run_check()
            check(ended.returncode == 0, "a file that is right", ended)
            for word in ("line1", "meter", "voltage", "energy", "set_point", f"{SITE}/line1/meter/state"):
                check(word in ended.stdout, f"its table has {word}", ended.stdout)
            for what, change, says in WRONG:
                changed = change(good)
                check(changed != good, f"{what}: the text is changed")
                ended = gateway.run_check(changed)
                check(ended.returncode == 2 and says in ended.stderr, f"{what} is refused by name", ended)
            drive = {"name": "fan", "unit": 7, "drive": "atv320", "registers": ["RFR"], "feeds_supervision": True}
            for register in ("CMD", "LFR", "CHCF", "FR1", "CMI"):
                ended = gateway.run_check(text_of(1, [a_line("/nowhere/ttyUSB0", {**drive, "settings": [register]})]))
                check(ended.returncode == 2 and register in ended.stderr, f"{register} of a drive is no setting", ended)
            ended = gateway.run_check(text_of(1, [a_line("/nowhere/ttyUSB0", drive)]))
            check(ended.returncode == 0, "a drive is polled where the file says so in words", ended)
            check("superv" in ended.stdout + ended.stderr, "and what it means is said", ended)
        # What is wrong opens nothing, either.
        with Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "#") as client:
            text = text_of(broker.port, [a_line(line.name)]).replace("baud =", "bauds =")
            with Gateway(program, folder, text) as gateway:
                check(gateway.process.wait(LIMIT) == 2, "a wrong file ends the gateway")
                check(not line.requests and not client.messages, "before a frame or a message", (line.requests, client.messages))


def secrets(check, program, _):
    """A password is read from a file of its owner's, and stands nowhere else."""
    with Folder() as folder:
        made = folder / "users"
        subprocess.run(["mosquitto_passwd", "-b", "-c", str(made), "rtuwire", SECRET], check=True)
        made.chmod(0o644)
        password = folder / "broker.password"
        password.write_text(SECRET + "\n", encoding="utf-8")
        with Broker(folder, f"password_file {made}", anonymous=False) as broker, Units({3: meter()}) as line:
            text = text_of(broker.port, [a_line(line.name)], user="rtuwire", password_file="broker.password")
            for mode in (0o644, 0o604, 0o606):
                password.chmod(mode)
                with Gateway(program, folder, text, start=False) as gateway:
                    ended = gateway.run_check()
                    check(ended.returncode == 2 and "broker.password" in ended.stderr and SECRET not in ended.stderr,
                          f"a password that others may read ({mode:o}) is refused", ended)
                    gateway.start()
                    check(gateway.process.wait(LIMIT) == 2, "by the gateway, too")
            check(not line.requests, "before a frame")
            for mode in (0o600, 0o640):
                password.chmod(mode)
                with Client(broker.port, "#", user="rtuwire", password=SECRET) as client, \
                        Gateway(program, folder, text, "--json") as gateway:
                    check(flows(client), f"{mode:o} is taken")
                    process = f"/proc/{gateway.process.pid}"
                    for name in ("cmdline", "environ"):
                        check(SECRET.encode() not in pathlib.Path(process, name).read_bytes(), f"it is not in the {name}")
                    check(gateway.end() == 0, "it ends")
                    heard = b"".join(each.topic.encode() + each.payload for each in client.messages)
                    check(SECRET.encode() not in heard, "nor in a message")
                    kept = [each for each in folder.rglob("*") if each.is_file() and each != password
                            and SECRET.encode() in each.read_bytes()]
                    check(not kept, "nor in a log or a state", kept)
            # A wrong one: said, without it, and not again and again.
            password.write_text("wrong-" + SECRET + "\n", encoding="utf-8")
            with Gateway(program, folder, text) as gateway:
                check(soon(lambda: "assword" in gateway.said() or "uthori" in gateway.said(), LIMIT), "a wrong password is told")
                check(SECRET not in gateway.said(), "and not shown")
                asked = len(line.requests)
                check(soon(lambda: len(line.requests) > asked + 4, LIMIT), "the line is asked all the same")
                began = time.monotonic()
                used = used_by(gateway)
                time.sleep(3)
                spent = used_by(gateway) - used
                check(spent < 0.5 * (time.monotonic() - began), "it does not spin", spent)
                tries = gateway.said().lower().count("assword") + gateway.said().lower().count("uthori")
                check(tries < 8, "and is not told over and over", tries)
                # Put right.
                password.write_text(SECRET + "\n", encoding="utf-8")
                with Client(broker.port, "#", user="rtuwire", password=SECRET) as client:
                    gateway.reload()
                    check(flows(client), "a right one is taken at a reload")


def used_by(gateway):
    """Seconds of processor time."""
    words = pathlib.Path(f"/proc/{gateway.process.pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def disk(check, program, _):
    """The state's folder is full, or may not be written: values go on, and it is said."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        full = folder / "full"
        full.mkdir()
        text = f'state_folder = "{full}"\n' + text_of(broker.port, [a_line(line.name)])
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(full)], capture_output=True, check=False)
        if mounted.returncode:
            print("skipped: no tmpfs can be mounted here:", mounted.stderr.decode().strip())
            return
        try:
            with open(full / "fill", "wb", buffering=0) as fill:
                try:
                    while fill.write(b"x" * 4096):
                        pass
                except OSError:
                    pass
            with Client(broker.port, "#") as client, Gateway(program, folder, text) as gateway:
                check(flows(client, count=4), "values come")
                check(soon(lambda: str(full) in gateway.said(), LIMIT), "what could not be kept is said", gateway.said())
                (full / "fill").unlink()
                gateway.reload()
                check(flows(client), "they go on")
                check(gateway.end() == 0, "and it ends cleanly")
        finally:
            subprocess.run(["umount", str(full)], check=False)


def command(check, program, tool):
    """`rtuwire gateway` is the program beside it, else the one in PATH; without both it names the package."""
    with Folder() as folder:
        (folder / "meter.toml").write_text(METER, encoding="utf-8")
        (folder / "gateway.toml").write_text(text_of(1, [a_line("/nowhere/ttyUSB0")]), encoding="utf-8")
        alone, both = folder / "alone", folder / "both"
        for place in (alone, both):
            place.mkdir()
            shutil.copy(tool, place / "rtuwire")
        shutil.copy(program, both / "rtuwire-gateway")

        def run(place, path, *words):
            return subprocess.run([place / "rtuwire", "gateway", "gateway.toml", "--check", *words], cwd=folder, text=True,
                                  env={**os.environ, "PATH": str(path), "HOME": str(folder)}, capture_output=True,
                                  stdin=subprocess.DEVNULL, timeout=LIMIT, check=False)
        for place, path, where in ((both, "/usr/bin:/bin", "beside it"), (alone, both, "in PATH")):
            ended = run(place, path)
            check(ended.returncode == 0 and f"{SITE}/line1/meter/state" in ended.stdout, f"the program {where} is run", ended)
        ended = run(alone, folder)
        check(ended.returncode != 0 and "rtuwire-gateway" in ended.stderr, "where none is, the package is named", ended)
        ended = run(both, "/usr/bin:/bin", "--chek")
        check(ended.returncode == 2 and "--chek" in ended.stderr, "a wrong word is refused by name, with status 2", ended)


def main(check, program, tool, part):
    {"command": command, "values": values, "ends": ends, "check": check_, "secrets": secrets, "disk": disk}[part](check, program, tool)


if __name__ == "__main__":
    runs(main)
