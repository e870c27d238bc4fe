# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Each command that a message shows does what the message says where it is pasted as it stands: with the port, the unit, the
type and the times of whoever reads it.

    python3 pasting.py TOOL SOURCES
"""
import pathlib
import re
import subprocess

from support import DIFFERS, DONE, LIMIT, NO_ANSWER, PORT, REFUSED, USAGE, Simulator, Tool, Units, runs

SHOWN = re.compile(r"`([^`\n]* [^`\n]*)`")
# A text of the sources that would show a command, with words of its own.
WRITTEN = re.compile(r"\"[^\"\n]*[`'](?:rtuwire|start|stop|reset|watch|capture|scan|write)[ `'][^\"\n]*\"")

UNIT = 7
TIMES = ["--no-listen", "--timeout", "0.2", "--retries", "2"]


def shown_in(text):
    return SHOWN.findall(text.replace("\r\n", "\n"))


def pasted(tool, text):
    """The commands that a text shows, and what a shell makes of the first, where nobody has put the program into its PATH."""
    found = shown_in(text)
    done = subprocess.run(["sh", "-c", found[0] if found else "false"], cwd=tool.place, check=False, stdin=subprocess.DEVNULL,
                          env={**tool.environment, "PATH": "/usr/bin:/bin"}, capture_output=True, text=True, timeout=LIMIT)
    return found, done


def check_reset(tool, simulator, device, check):
    """A start that finds a fault shows what resets it: of this drive, and of no other on the line."""
    (tool.place / "named lines.toml").write_text(f'name = ["fan={UNIT}:atv320"]\n', encoding="utf-8")
    cases = [("by address", ["-u", UNIT, "-d", "atv320"]), ("by name", ["--name", f"fan={UNIT}:atv320", "-u", "fan"]),
             ("by a file", ["--config", "named lines.toml", "--unit=fan"])]
    for what, words in cases:
        simulator.suffer(f"{UNIT} fault")
        check.soon(lambda: simulator.shown(UNIT)[0] == "fault", f"{what}: a fault")
        ended = tool.run("--port", device, *TIMES, *words, "--allow-run", "-y", "start", "--frequency", "9Hz")
        simulator.suffer(f"{UNIT} clear")
        found, done = pasted(tool, ended.errors)
        check(ended.status == DIFFERS and len(found) == 1 and "OCF" in ended.errors, f"{what}: a start names the fault", ended)
        check(done.returncode == DONE and "reset" in done.stdout, f"{what}: what it shows resets it", (found, done))
        check(simulator.shown(UNIT)[0] == "switch on disabled", f"{what}: it is reset", simulator.shown(UNIT))


def check_stop(tool, simulator, device, check):
    """A motor that somebody else runs is stopped by what a start shows; so is one whose command register is to be written."""
    start = ["--allow-run", "-y", "start", "--frequency", "9Hz"]
    for what, words in (("start", start), ("write", ["--write", "write", "CMD=0"])):
        for word in (6, 7, 15):
            simulator.suffer(f"{UNIT} write 8501 {word}")
        check.soon(lambda: simulator.shown(UNIT)[0] == "operation enabled", f"{what}: it has power")
        ended = tool.run("--port", device, *TIMES, "-u", UNIT, "-d", "atv320", *words)
        found, done = pasted(tool, ended.errors)
        check(ended.status == REFUSED and len(found) == 1, f"{what}: refused", ended)
        check(done.returncode == DONE and "stands" in done.stdout, f"{what}: what it shows stops it", (found, done))
        check(simulator.shown(UNIT)[0] == "switch on disabled", f"{what}: it stands", simulator.shown(UNIT))


def check_mute(tool, check):
    """What hears and never answers may have the word: that is said, with what sends it again and what to do."""
    for words in ([], ["-d", "atv320"], ["-d", "atv28"]):
        with Units({9: {}}) as line:
            ended = tool.run("--port", line.name, *TIMES, "-u", UNIT, *words, "stop")
            stops = {7: {b"\x07\6\x21\x35\0\0", b"\x07\6\1\x90\0\0", b"\x07\6\1\x90\0\7"}}[UNIT]
            sent = [each for each in line.requests if each[:-2] in stops]
            check(ended.status == NO_ANSWER and sent, f"mute, {words}: it is told to stop", (ended, line.requests))
            for part in ("no response in time", "the word that stops the motor was sent, and nothing confirmed it", "look at the motor", "power"):
                check(part in ended.output, f"mute, {words}: {part}", ended)
            found, done = pasted(tool, ended.output)
            check(len(found) == 1 and done.returncode == NO_ANSWER and len([each for each in line.requests if each[:-2] in stops]) > len(sent),
                  f"mute, {words}: what it shows sends it again", (found, done))


def check_settings(tool, simulator, device, check):
    """A setting that forbids a start is named with what changes it; the next start is not refused for it."""
    start = ["--allow-run", "-y", "start", "--frequency", "9Hz", "--for", "0.2s"]
    separate, together = 2, 1
    for code, address, word, good in (("SLL", 7010, 0, 1), ("SLL", 7010, 4, 1), ("CHCF", 8401, 3, 1), ("ATR", 7122, 1, 0),
                                      ("FR1", 8413, 1, 164)):
        simulator.suffer(f"{UNIT} write 8401 {separate if code == 'FR1' else together}")
        simulator.suffer(f"{UNIT} write {address} {word}")
        ended = tool.run("--port", device, *TIMES, "-u", UNIT, "-d", "atv320", *start)
        found, done = pasted(tool, ended.errors)
        check(ended.status == REFUSED and f"({code} is " in ended.errors and len(found) == 1, f"{code}={word}: a start is refused", ended)
        check(done.returncode == DONE, f"{code}={word}: what it shows is done", (found, done))
        ended = tool.run("--port", device, *TIMES, "-u", UNIT, "-d", "atv320", *start)
        check(ended.status == DONE, f"{code}={word}: and then it starts", ended)
        simulator.suffer(f"{UNIT} write {address} {good}")
    simulator.suffer(f"{UNIT} write 8401 {together}")


def check_scan(tool, simulator, device, check):
    """A scan shows what resets a drive that it leaves; a scan that finds nobody, what to try next."""
    for rates in ([], ["--bauds", "9600,19200"]):
        ended = tool.run("--port", device, *TIMES, "scan", "--units", f"{UNIT}-{UNIT + 1}", *rates)
        simulator.suffer(f"{UNIT} fault")
        simulator.suffer(f"{UNIT} clear")
        *lines, last = ended.errors.splitlines()
        found, done = pasted(tool, lines[-1])
        check(done.returncode == DONE and "RFR" in done.stdout, f"{rates}: what a scan shows next reads the drive", (found, done))
        found, done = pasted(tool, last)
        check(done.returncode == DONE and "reset" in done.stdout, f"{rates}: what a scan shows resets the drive", (found, done))
        check(not rates or "-b " in found[0], f"{rates}: with the rate at which it was found", found)
    with Units({9: {3201: 0}}) as line:
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", "0.05", "-b", "19200", "scan", "--units", "3,5-7")
        said = ended.errors
        check(ended.status == NO_ANSWER and not ended.output, "nobody there: status 3", ended)
        for part in ("nobody answered", "4 addresses", "19200 8E1", "0.05 s", "powered", "A and B", "keypad"):
            check(part in said, f"nobody there: {part}", said)
        found, done = pasted(tool, said)
        check(done.returncode == NO_ANSWER and "38400 8N2" in done.stderr and len(line.requests) == 4 + 24 * 4,
              "the next scan that it shows tries the usual rates and formats", (found, done, len(line.requests)))
        check(not shown_in(done.stderr), "and shows none behind it", done.stderr)
        ended = tool.run("--port", line.name, "--no-listen", "--timeout", "0.05", "scan", "--units", "9")
        check(ended.status == DONE and "nobody" not in ended.errors, "where somebody is there nothing of it", ended)


def check_screens(tool, device, check):
    """What works without a screen, or goes to standard output."""
    for words, form in ((["monitor"], ""), (["--json", "monitor"], '{"'), (["sniff", "-o", "-"], None)):
        ended = tool.run("--port", device, *TIMES, "-u", UNIT, *words)
        found = shown_in(ended.errors)
        check(ended.status == USAGE and len(found) == 1, f"{words}: shows what else to type", ended)
        command = f"timeout -s INT 2 {found[0]}" if found else "false"
        done = subprocess.run(["sh", "-c", command], cwd=tool.place, env=tool.environment, check=False, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=LIMIT)
        right = done.stdout.startswith(b"\x0a\x0d\x0d\x0a") if form is None else b"RFR" in done.stdout and \
            done.stdout.startswith(form.encode())
        check(right, f"{words}: and that does it", (found, done))


def check_quoting(tool, check):
    """Words that a shell would take apart."""
    ended = tool.run("--port", "/a b/it's $HOME", *TIMES, "-u", UNIT, "monitor")
    found, done = pasted(tool, ended.errors)
    check(len(found) == 1 and done.returncode == PORT and "/a b/it's $HOME" in done.stderr, "a port with blanks and signs",
          (ended, found, done))


def check_sources(sources, check):
    """No text of the program shows a command but by `shown_command`."""
    found = []
    for path in sorted(pathlib.Path(sources).rglob("*.[ch]pp")):
        if path.parent.name == "help":
            continue
        text = path.read_text(encoding="utf-8")
        code = "\n".join(line for line in text.splitlines() if not line.lstrip().startswith("//"))
        found += [f"{path.name}: {each}" for each in WRITTEN.findall(code)]
    check(not found, "a command that is written out", found)


def main(check, program, sources):
    with Tool(program) as tool:
        simulator = Simulator(program, f"atv320:{UNIT}", "atv12:3")
        with simulator as device:
            check_reset(tool, simulator, device, check)
            check_stop(tool, simulator, device, check)
            check_settings(tool, simulator, device, check)
            check_scan(tool, simulator, device, check)
            check_screens(tool, device, check)
        check_mute(tool, check)
        check_quoting(tool, check)
        check_sources(sources, check)


runs(main)
