# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Help, completion, the man page, the configuration file, and how a wrong word is refused.

    python3 command_line.py TOOL
"""
import os
import re
import shlex
import shutil
import subprocess

from support import DIFFERS, DONE, NO_ANSWER, PORT, USAGE, Line, Tool, runs, soon

CABINET = "sim:atv320:7,atv12:3"

WRONG = [
    (["raed", "RFR"], ["'raed' is no command", "'read'"]),
    (["--for", "1s", "sniff"], ["'--for' belongs behind 'sniff'"]),
    (["read", "RFR", "--baudd", "9600"], ["'--baudd' is no option", "'--baud'"]),
    (["read"], ["REG", "such as `rtuwire -p /dev/ttyUSB0 -u 7 read RFR", "`read --help`"]),
    ([], ["`--help`"]),
    (["help"], ["'help' is no command", "`--help`"]),
    (["backup", "fan.json"], ["--output", "backup -o fan.json`"]),
    (["read", "RFR", "sim:atv320:7"], ["which line?", "did you mean -p sim:atv320:7?"]),
    (["serve", "/dev/ttyUSB0"], ["'serve' takes no word '/dev/ttyUSB0'", "did you mean -p /dev/ttyUSB0?"]),
    (["list", "--device", "sdm630"], ["'list' does not", "`device check sdm630`"]),
    (["decode", "line.pcapng"], ["`decode -p line.pcapng`"]),
    (["--port", CABINET, "sniff"], ["nobody else talks on a simulated line", "--trace"]),
    (["--port", CABINET, "capture", "-o", "x.pcapng"], ["nobody else talks on a simulated line", "--trace"]),
    (["list", "--drive", "atv99"], ["atv99"]),
    # What begins with a digit, is no number and has a point, of what is no drive.
    (["--port", CABINET, "-d", "none", "read", "32O1.3"], ["32O1.3", "0 to 65535"]),
    (["--port", CABINET, "-d", "none", "-u", "7", "read", "40", "4a.3"], ["4a.3", "0 to 65535"]),
    (["--json", "--csv", "list"], ["--json", "--csv"]),
    (["--port", "sim:atv320", "--unit", "248", "read", "RFR"], ["248", "1 to 247"]),
    (["--port", "sim:atv320", "--unit", "fan", "read", "RFR"], ["fan", "--name"]),
    (["--port", "sim:atv320", "--format", "7E1", "scan"], ["7E1", "8E1"]),
    (["--port", "sim:atv320", "read", "RRF"], ["RRF"]),
    (["read", "RFR"], ["--port"]),
    (["completion", "fish"], ["fish", "bash"]),
    (["simulate", "atv28:99"], ["unit 99", "atv28", "1 to 31"]),
    (["simulate", "atv320:2", "atv28:2"], ["unit 2", "twice"]),
    (["simulate", "atv99:1"], ["atv99", "atv320"]),
    (["simulate", "atv320:"], ["unit", "atv320"]),
    (["simulate", "atv320", "--vendor", 64 * "x"], ["--vendor", "63"]),
    (["simulate", "atv320", "--port", "tcp://host:4001"], ["tcp://host:4001", "/dev/"]),
    (["--port", CABINET, "--name", "fan=7", "--name", "fan=3", "-u", "fan", "identify"], ["'fan'", "unit 7", "unit 3"]),
    (["--port", CABINET, "--name", "fan=3", "--name", "fan=7", "-u", "fan", "identify"], ["'fan'", "unit 7", "unit 3"]),
    (["--port", CABINET, "--name", "fan=7:atv320", "--name", "mixer=7:atv12", "-u", "7", "identify"], ["7", "two types"]),
    (["--port", CABINET, "--name", "3=7", "-u", "3", "identify"], ["'3=7'", "digit"]),
    (["--port", CABINET, "--name", "3-7=7", "-u", "3", "identify"], ["'3-7=7'", "digit"]),
    (["--port", CABINET, "--name", "a,b=7", "identify"], ["'a,b=7'", "comma"]),
    (["--port", CABINET, "--name", "m=7", "--name", "M=3", "-u", "m", "identify"], ["'m' of unit 7", "'M' of unit 3"]),
    (["--port", CABINET, "-u", "7,", "read", "RFR"], ["'7,'", "missing at a comma"]),
    (["--port", CABINET, "-u", "7,,3", "read", "RFR"], ["'7,,3'", "missing at a comma"]),
    (["--port", CABINET, "-u", "-1", "read", "RFR"], ["'-1' in '-1' is neither", "1 to 247"]),
    (["--port", CABINET, "-u", "3-", "read", "RFR"], ["'3-' in '3-' is neither"]),
    # What changes something takes no unit by itself.
    (["--port", CABINET, "--write", "write", "ACC=1s"], ["which unit?", "--unit"]),
    (["--port", CABINET, "--write", "reset"], ["which unit?", "--unit"]),
    (["--port", CABINET, "--allow-run", "start", "--frequency", "10Hz"], ["which unit?", "--unit"]),
]

# A command that lasts, and lengths of time that are none: no zero is "without end".
LASTING = [["watch", "RFR"], ["sniff"], ["capture", "-o", "x"], ["timing"], ["--allow-run", "start", "--frequency", "9Hz"]]
NO_LENGTHS = ["0", "0s", "0.0min", "-1s", "-5min", "1e10s", "99999999999999999999s", "9000h", "", "s", "1m", "1,5s", "nan",
              "inf", "0x10s", "1us"]
LENGTHS = ["300ms", "0.3s", "0.005min", "0.0001h", "0.3"]

# A file, the line and column that are wrong, and what is said of it.
WRONG_FILES = [
    ('port = "sim:atv320"\nbauds = 9600\n', "2:1", ["'bauds'", "'baud'"]),
    ('\n# a comment\nbaud = "fast"', "3:8", ["baud", "'fast'"]),
    ("baud = 12", "1:8", ["12 bits a second"]),
    ("format = 8E1", "1:10", ["quotation marks", '"8E1"']),
    ("port = /dev/ttyUSB0 # left", "1:8", ["quotation marks", '"/dev/ttyUSB0"']),
    ('format = "7E1"', "1:10", ["7E1"]),
    ('name = [\n "fan=7:atv320",\n "pump"\n]', "3:2", ["pump", "fan=7"]),
    ('name = [\n "fan=7:atv320"\n "pump=3"\n]', "3:2", []),
    # What the parser of Debian 12 asserts.
    *((f'port = "sim:atv320"\n{line}\n[line]\n', "2:1", ["a table's header has a name"])
      for line in ("[", "[[", "[ ", "[=", "[.a]", "[[#", "[,]]", "[\t=")),
    ("[=", "1:1", ["a table's header"]),
    ('name = ["fan=7:atv99"]', "1:9", ["atv99"]),
    ('port = "sim:atv320\n', "1:", ["does not end on its line"]),
    ('port = "sim:atv320"\nport = "sim:atv12"', "2:", ["port", "redefine"]),
    ("[line]\nbaud = 9600", "1:", ["'line' is no option"]),
    ("write = true", "1:1", ["write", "typed"]),
    ("retries = 11", "1:11", ["retries", "11"]),
    ("timeout = nan", "1:11", ["timeout", "nan"]),
    ("unit = 07", "1:", []),
    ("unit = [7]", "1:8", ["one value"]),
    ("listen = 2026-11-29", "1:10", ["one value"]),
    ("echo = 1", "1:8", ["true or false"]),
    ('name = ["fan=7:atv320", "fan=3:atv12"]', "1:25", ["'fan'", "unit 7", "unit 3"]),
    ('name = ["3=7"]', "1:9", ["'3=7'", "digit"]),
    ("port = " + 3_000 * "[", "1:", []),
    ("retries = 1.5", "1:11", ["'1.5' is no whole number"]),
    ("baud = 19200.5", "1:8", ["no whole number"]),
    ('pause = "0.5"', "1:9", ["no whole number"]),
    ("baud = 1e9", "1:8", ["1 to 10000000"]),
]

COMPLETED = [
    (["sca"], ["scan"]),
    (["--drive", "atv3"], ["atv310", "atv310_2026", "atv320"]),
    (["-d", "no"], ["none"]),
    (["-d", "atv320", "read", "RFR"], ["RFR", "RFRD"]),
    (["-d", "atv28", "read", "RFRD"], ["RFRD"]),
    (["-d", "atv320", "read", "@hou"], ["@hours"]),
    (["--drive=atv320", "--write", "write", "AC"], ["ACC=", "AC2="]),
    (["-p", "scan", "scan", "--un"], ["--units", "--unit"]),
    (["simulate", "atv12"], ["atv12"]),
    (["completion", ""], ["bash", "zsh"]),
]


def check_help(tool, check):
    commands = re.findall(r"^  ([a-z]+) ", tool.run("--help").output.split("Subcommands:")[1], re.M)
    check({"scan", "read", "watch", "write", "simulate", "list"} <= set(commands), "commands", commands)
    for each in commands:
        ended = tool.run(each, "--help")
        is_whole = f"Example: rtuwire" in ended.output and f" {each}" in ended.output.split("Example:")[1]
        check(ended.status == DONE and is_whole and "Exit status" in ended.output, f"{each} --help has an example")
    for each in ("decode", "list", "man", "completion"):
        words = tool.run(each, "--help").output.split("Example: rtuwire ")[1].splitlines()[0].split(" > ")[0]
        check(tool.run(*words.split()).status == DONE, f"the example of {each} does what it says")
    text = tool.run("stop", "--help").output
    check(text.count("else 0000 goes, and it coasts") == 2, "where a stop coasts is said before it", text)
    page = tool.run("man").output
    check(all(f".SS {each}" in page for each in commands), "all of them are in the man page")
    (tool.place / "rtuwire.1").write_text(page)
    if shutil.which("groff"):
        said = subprocess.run(["groff", "-man", "-ww", "-Tascii", "-z", "rtuwire.1"], cwd=tool.place, check=False,
                              stderr=subprocess.PIPE, text=True)
        check(said.returncode == 0 and not said.stderr, "groff has nothing to say of it", said.stderr)
    with open("/dev/full", "wb") as full:
        for words in (["--help"], ["man"], ["list"], ["--csv", "list", "--drive", "atv320"]):
            process = tool.start(*words, stdout=full)
            _, errors = process.communicate()
            check(process.returncode == PORT and "standard output" in errors, f"{words} into a full disk", errors)


def check_completion(tool, check):
    (tool.place / "script").write_text(tool.run("completion", "bash").output)
    for words, expected in COMPLETED:
        quoted = " ".join(f"'{word}'" for word in ["rtuwire", *words])
        text = (f". ./script; COMP_WORDS=({quoted}); COMP_CWORD={len(words)}; _rtuwire; "
                'printf "%s\\n" "${COMPREPLY[@]}"')
        found = subprocess.run(["bash", "-c", text], cwd=tool.place, check=False, stdout=subprocess.PIPE, text=True).stdout
        check(found.split() == expected, f"completes {words}", found.split())
    # zsh asks its own function, which filters by what is typed: here that is the test's.
    (tool.place / "_rtuwire").write_text(tool.run("completion", "zsh").output)
    for words, expected in COMPLETED:
        quoted = " ".join(f"'{word}'" for word in ["rtuwire", *words])
        text = ('compdef() {}; compadd() { while [ "$1" != -- ]; do [ "$1" = -S ] && { end=$2; shift }; shift; done; shift; '
                f'print -rl -- $^@$end }}; . ./_rtuwire; words=({quoted}); CURRENT={len(words) + 1}; _rtuwire')
        found = subprocess.run(["zsh", "-f", "-c", text], cwd=tool.place, check=False, capture_output=True, text=True)
        offered = [word for word in found.stdout.split() if word.startswith(words[-1])]
        check(offered == expected and not found.stderr, f"zsh completes {words}", found)


def check_configuration(tool, check):
    file = tool.place / "cabinet.toml"
    for text, line, parts in WRONG_FILES:
        file.write_text(text)
        ended = tool.run("--config", "cabinet.toml", "read", "RFR")
        is_told = ended.errors.startswith(f"rtuwire: cabinet.toml:{line}") and all(part in ended.errors for part in parts)
        check(ended.status == USAGE and is_told, f"{text!r} is refused", ended.errors)
    check(tool.run("--config", "cabinet.toml", "--help").status == DONE, "help is shown all the same")
    check("missing.toml" in tool.run("--config", "missing.toml", "list").errors, "a file that is not there is named")
    os.mkfifo(tool.place / "pipe")
    for name, reason in (("missing.toml", "No such file or directory"), ("/dev/zero", "is a device"), (".", "is a directory"),
                         ("pipe", "is a pipe"), ("", "missing")):
        ended = tool.run("--config", name, "list")
        check(ended.status == USAGE and name in ended.errors and reason in ended.errors, f"--config {name!r}", ended)
    (tool.place / "rtuwire.toml").mkdir()
    ended = tool.run("list")
    check(ended.status == USAGE and "is a directory" in ended.errors, "a folder in the place of the file", ended)
    (tool.place / "rtuwire.toml").rmdir()
    file.write_bytes(b'\xef\xbb\xbfbaud = 12\n')
    ended = tool.run("--config", "cabinet.toml", "list")
    check(ended.status == USAGE and "cabinet.toml:1:8: baud" in ended.errors, "a byte order mark is no part of it", ended)
    file.write_text('port = ""\n')
    ended = tool.run("--config", "cabinet.toml", "list")
    check(ended.errors.startswith('rtuwire: cabinet.toml:1:8: port = "": ') and "port : " not in ended.errors,
          "a value that is empty is shown", ended)
    for data, reason in ((60_000_000 * b"#", "60000000 bytes"), (b"baud = 9600\n\0", "a byte is zero")):
        file.write_bytes(data)
        ended = tool.run("--config", "cabinet.toml", "list")
        check(ended.status == USAGE and reason in ended.errors, f"{reason} is refused", ended)
    check("is a directory" in tool.run("replay", ".").errors, "a folder is no capture")
    file.write_text('port = "sim:atv320:7"\nbaud = "9600"\nretries = "0"\necho = "false"\ntimeout = 0.25\nlisten = 0\nunit = "7"\n')
    ended = tool.run("--config", "cabinet.toml", "--json", "read", "RFR")
    check(ended.status == DONE and ended.objects()[0]["unit"] == 7, "numbers in quotation marks are taken, as they were", ended)
    file.write_text('port = "sim:atv320:7"\nrs485 = true\n')
    ended = tool.run("--config", "cabinet.toml", "-d", "atv320", "-u", 7, "read", "RFR")
    check(ended.status == USAGE and "--rs485: sim:atv320:7 is no serial device" in ended.errors, "rs485 of the file", ended)
    file.write_text('port = "sim:atv320:7,atv12:3"\nname = [\n  "fan=7:atv320",  # in the cellar\n  \'pump=3\',\n]\n'
                    "baud = 9600\ntimeout = 0.5\nunit = 7\n")
    ended = tool.run("--config", "cabinet.toml", "--json", "-u", "fan", "read", "RFR")
    check(ended.status == DONE and ended.objects()[0]["unit"] == 7, "a name of the file", ended)
    ended = tool.run("--config=cabinet.toml", "--json", "--name", "mixer=3", "-u", "mixer", "read", "RFR")
    check(ended.status == DONE and ended.objects()[0]["unit"] == 3, "and one of the command line beside it", ended)
    found = tool.run("--config", "cabinet.toml", "-u", "3", "-u", "fan", "--json", "read", "RFR").objects()
    check([each["unit"] for each in found] == [3, 7], "several units", found)
    check(tool.run("--config", "cabinet.toml", "--unit", "3", "--json", "read", "RFR").objects()[0]["unit"] == 3,
          "the command line overrides the file")
    ended = tool.run("--config=cabinet.toml", "--json", "--name", "fan=3", "-u", "fan", "read", "RFR")
    check(ended.status == DONE and ended.objects()[0]["unit"] == 3, "a name of the command line replaces the file's", ended)
    ended = tool.run("--config", "cabinet.toml", "--write", "--json", "write", "ACC=1s")
    check(ended.status == DONE and ended.objects()[0]["unit"] == 7, "a unit of the file is one that was named", ended)
    (tool.place / "config").mkdir()
    (tool.place / "config" / "rtuwire.toml").write_text('port = "sim:atv12:9"\nunit = 9\n')
    check(tool.run("--json", "read", "RFR").objects()[0]["unit"] == 9, "$XDG_CONFIG_HOME is looked into")
    (tool.place / "rtuwire.toml").write_text(file.read_text())
    check(tool.run("--json", "read", "RFR").objects()[0]["unit"] == 7, "./rtuwire.toml goes before it")
    (tool.place / "rtuwire.toml").unlink()
    (tool.place / "config" / "rtuwire.toml").unlink()


def check_times(tool, check):
    """The same lengths of time for every command that has some; zero, and what is none, are refused by each."""
    for words in LASTING:
        for each in NO_LENGTHS:
            ended = tool.run("--port", CABINET, "-u", "7", "-y", *words, f"--for={each}")
            check(ended.status == USAGE and "--for" in ended.errors and not ended.output,
                  f"{words} --for={each} is refused", ended)
    for option, words in (("--timeout", ("nan", "NaN", "-nan", "nan(1)", "inf", "0", "31")), ("--listen", ("nan", "-nan", "inf"))):
        for each in words:
            ended = tool.run("--port", CABINET, "-u", "7", f"{option}={each}", "read", "RFR", limit=5)
            check(ended.status == USAGE and option in ended.errors and not ended.output,
                  f"defect: D41 {option}={each} is refused", ended)
    for each in LENGTHS:
        ended = tool.run("--port", CABINET, "-u", "7", "watch", "RFR", "--every", "0.00001h", "--for", each)
        check(ended.status == DONE, f"--for {each}", ended)
    ended = tool.run("--port", CABINET, "-u", "7", "-y", "--allow-run", "start", "--frequency", "9Hz", "--for", "300ms")
    check(ended.status == DONE and "for 0.3 s" in ended.errors and "the time is over" in ended.errors, "start --for 300ms", ended)
    for each in ("-1s", "1m", "fast", "1e10s"):
        ended = tool.run("--port", CABINET, "-u", "7", "watch", "RFR", f"--every={each}")
        check(ended.status == USAGE and "--every" in ended.errors, f"--every={each} is refused", ended)


def check_without_value(tool, check):
    """What an empty variable leaves of an option is named, whatever stands behind it."""
    for words in (["serve", "--units=", "--for", "1s"], ["serve", "--units="], ["-u=", "read", "RFR"], ["--drive=", "read", "RFR"],
                  ["scan", "--bauds=", "--units", "7"]):
        ended = tool.run("--port", CABINET, *words)
        option = next(each for each in words if each.endswith("="))
        wanted = f"'{option}': no value stands behind it" if option.startswith("--") else ""
        check(ended.status == USAGE and wanted in ended.errors and "1s" not in ended.errors, f"{words}", ended)


def check_simulate(tool, check):
    """Who shows no frames says so."""
    for words in (["-v"], ["--trace", "frames.pcapng"]):
        ended = tool.run(*words, "simulate", "atv320:7", limit=5)
        check(ended.status == USAGE and f"{words[0]}: simulate shows no frames" in ended.errors and not (tool.place / "frames.pcapng").exists(),
              f"{words} simulate", ended)


def check_rs485(tool, check):
    """Said of what has no transceiver it is refused, before a frame leaves."""
    ended = tool.run("--port", CABINET, "-u", "7", "--rs485", "read", "RFR")
    check(ended.status == USAGE and "no serial device" in ended.errors, "--rs485 behind sim:", ended)
    with Line() as line:
        ended = tool.run("--port", line.name, "--no-listen", "-u", "7", "--rs485", "read", "40")
        check(ended.status == PORT and "does not switch an RS-485 transceiver" in ended.errors and not line.heard,
              "--rs485 of a driver that cannot", ended)


def check_register_files(tool, check):
    """No command leaves a register file out in silence: it reads it before anything is opened, or says that it does not."""
    listed = tool.run("--help").output.partition("\nSubcommands:\n")[2]
    commands = re.findall(r"^  (\w+) ", listed, re.MULTILINE)
    check(len(commands) > 20, "the commands of the help", commands)
    reads = []
    for command in commands:
        example = re.search(r"^Example: rtuwire (.*?)(?:;| >|$)", tool.run(command, "--help").output, re.MULTILINE)[1]
        ended = tool.run("--device", "nowhere.toml", *shlex.split(example))
        is_read = ended.errors.endswith(".toml: No such file or directory\n")  # of the example itself, or of --device
        is_refused = f"know register files, '{command}' does not" in ended.errors
        check(ended.status == USAGE and is_read != is_refused, f"--device of {command}", ended)
        reads += [command] if is_read else []
    for command in ("read", "watch", "monitor", "write", "ask", "map", "backup", "compare", "restore", "sniff", "replay", "decode"):
        check(command in reads, f"{command} knows register files", reads)


def check_stop(tool, check):
    for words, is_told in (([], True), (["-u", "1"], False)):
        ended = tool.run("--port", CABINET, "--timeout", "0.05", *words, "stop")
        check(ended.status == NO_ANSWER and ("that was unit 1" in ended.output) == is_told, f"{words} stop says its unit", ended)


def check_stop_beside(tool, check):
    """A file that is wrong keeps no stop from a unit whose port and address are typed; of another nothing is guessed."""
    for text in ("[\n", "baud = 9600\nretries = 1.5\n", 'name = ["fan=7\n', "\0"):
        (tool.place / "rtuwire.toml").write_text(text)
        ended = tool.run("--port", CABINET, "--timeout", "0.05", "-u", 7, "--json", "stop")
        check(ended.status == DONE and "note: rtuwire.toml" in ended.errors and "left out: it stops at 19200 bit/s, 8E1" in ended.errors,
              f"{text!r}: a stop whose line is typed", ended)
        for words in ((), ("--port", CABINET), ("-u", 7), ("--port", CABINET, "-u", "fan")):
            ended = tool.run(*words, "stop")
            is_told = "fan" in ended.errors if "fan" in words else "with --port and --unit it stops without the file" in ended.errors
            check(ended.status == USAGE and is_told, f"{text!r}, {words}: one whose line is not", ended)
        ended = tool.run("--port", CABINET, "-u", 7, "read", "RFR")
        check(ended.status == USAGE and not ended.output, f"{text!r}: another command", ended)
    (tool.place / "rtuwire.toml").unlink()


def check_holder(tool, check):
    """Who has the port is named; of a motor nothing is said where none is run."""
    with Line() as line:
        watch = tool.start("--no-listen", "-u", 7, "-d", "none", "watch", "40", port=line.name)
        soon(lambda: line.heard, 20)
        ended = tool.run("-u", 7, "read", "40", port=line.name)
        watch.kill()
        watch.communicate()
        wanted = f"held by rtuwire (process {watch.pid}): two programs cannot share a port; end that first"
        check(ended.status == PORT and wanted in ended.errors and "motor" not in ended.errors, "a port that a watch has", ended)


def check_names(tool, check):
    """Names of no drive are looked for in a register file, which has an option."""
    (tool.place / "level.toml").write_text('[[register]]\nname = "level"\naddress = 5\n')
    ended = tool.run("-p", "sim:level.toml:61", "-u", 61, "read", "level")
    check(ended.status == DIFFERS and ended.errors.rstrip().endswith("names of what is no drive need --device FILE"), "a name without its file", ended)


def check_gateway(tool, check):
    """The gateway is a program of its own: beside this one, or in PATH."""
    place, path = tool.place / "alone", tool.place / "path"
    for each in (place, path):
        each.mkdir()
    shutil.copy(tool.program, place / "rtuwire")

    def run(*words):
        return subprocess.run([place / "rtuwire", *words], env={**tool.environment, "PATH": str(path)}, cwd=tool.place,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    ended = run("gateway", "g.toml")
    check(ended.returncode == USAGE and "rtuwire-gateway is not installed" in ended.stderr, "where it is not", ended)
    for folder in (path, place):
        (folder / "rtuwire-gateway").write_text(f'#!/bin/sh\nprintf "%s|" {folder.name} "$@"\nexit 5\n')
        (folder / "rtuwire-gateway").chmod(0o755)
        ended = run("--json", "--write", "gateway", "g 1.toml", "--check")
        check((ended.returncode, ended.stdout) == (5, f"{folder.name}|g 1.toml|--check|--write|--json|"),
              "its words and its status are the gateway's", ended)
    check(run("gateway").stdout == "alone|", "without a word")
    ended = run("--csv", "gateway")
    check(ended.returncode == USAGE and "--csv" in ended.stderr, "it knows no CSV", ended)


def main(check, program):
    with Tool(program) as tool:
        for words, parts in WRONG:
            ended = tool.run(*words)
            is_named = ended.errors.startswith("rtuwire: ") and all(part in ended.errors for part in parts)
            check(ended.status == USAGE and not ended.output and is_named, f"{words} is refused", ended)
        for part in (check_help, check_completion, check_configuration, check_times, check_without_value, check_simulate, check_rs485, check_register_files,
                     check_stop, check_stop_beside, check_holder, check_names, check_gateway):
            part(tool, check)


runs(main)
