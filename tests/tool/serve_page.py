# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The commands, files and tables of docs/serve.md are what the program, and the programs of others that are here, take: each command as it stands
there, but for the device and for the numbers of ports, which are this test's.

    python3 serve_page.py TOOL PAGE UNIT_FILE
    python3 serve_page.py TOOL PAGE UNIT_FILE others     with promtool and stunnel, which have to be here then
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import socket
import subprocess
import tempfile
import urllib.parse
import urllib.request

from support import DONE, LIMIT, Tool, runs, soon

from pair import free_port, wait_for_listener  # noqa: I100
from served import FIRST, LISTENING, Asker, PlainUnits, Served, value_of  # noqa: I100

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
NUMBERS = ("1502", "9502", "4001")


def blocks(text, language):
    return [found[2] for found in BLOCK.finditer(text) if found[1] == language]


def run_block(check, tool, line, block):
    """A `serve` goes on until the block's other commands have ended."""
    numbers = {each: str(free_port()) for each in NUMBERS}
    served = []
    for command in block.splitlines():
        words = shlex.split(command)
        if not words:
            continue
        if words[0] not in ("rtuwire", "mbpoll"):
            check(False, "a command that nobody here runs", command)
            continue
        for number, mine in numbers.items():
            words = [re.sub(rf"\b{number}\b", mine, word) for word in words]
        words = [line.name if word == "/dev/ttyUSB0" else tool.program if word == "rtuwire" else word for word in words]
        if "serve" in words:
            process = subprocess.Popen(words, cwd=tool.place, env=tool.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, text=True)
            served.append((command, process))
            wanted = max(words.count("--listen"), 1) + words.count("--metrics")
            said = []
            while sum(bool(LISTENING.search(each)) for each in said) < wanted and (text := process.stdout.readline()):
                said.append(text)
            check(sum(bool(LISTENING.search(each)) for each in said) == wanted, command, said)
        elif shutil.which(words[0]):
            done = subprocess.run(words, cwd=tool.place, env=tool.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  timeout=LIMIT, check=False)
            value = str(value_of(1, FIRST))
            check(done.returncode == 0 and value in done.stdout, command, (done.returncode, done.stdout, done.stderr))
    for command, process in served:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LIMIT)
        check(process.returncode == DONE, f"ends: {command}", process.returncode)


def check_commands(check, tool, text):
    shown = blocks(text, "sh")
    check(len(shown) == 3, "the page shows three blocks of commands", len(shown))
    with PlainUnits(1, 2, 3, 4) as line:
        for block in shown:
            run_block(check, tool, line, block)


def check_words(check, tool, text):
    """What is named is there; what is there is named."""
    help_text = tool.run("serve", "--help").output
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", text)) - {"--now"}
    known = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", help_text + tool.run("--help").output))
    check(named <= known, "each option of the page is one of the program", named - known)
    own = set(re.findall(r"^ +(?:-\w, *)?(--[a-z][a-z-]+)", help_text, re.MULTILINE))
    check(own and own - named <= {"--help", "--help-all"}, "each option of the command is on the page", own - named)
    with PlainUnits(1, silent=(2,)) as line, \
            Served(tool.program, line.name, "--units", "1,2", "--metrics", "127.0.0.1:0", line=("--timeout", 0.2, "--retries", 0)) as served, \
            Asker(served.number) as client:
        client.read(1, FIRST)
        client.read(1, 1)
        client.read(2, FIRST)
        client.read(9, FIRST)
        kinds = served.metrics().kinds
    counted = {each for each, kind in kinds.items() if kind != "summary"} | {
        each + tail for each, kind in kinds.items() if kind == "summary" for tail in ("_sum", "_count")}
    table = set(re.findall(r"`(rtuwire_serve_\w+)`", text.partition("| metric | counts |")[2].partition("\n\n")[0]))
    check(table == counted, "the table has the metrics that there are", (sorted(table - counted), sorted(counted - table)))
    used = set(re.findall(r"\brtuwire_serve_\w+", text))
    check(used <= counted, "and the rules use no others", used - counted)


def check_unit(check, text, unit):
    """The unit file and what the page adds to it, by systemd, where that is here."""
    analyze = shutil.which("systemd-analyze")
    words = pathlib.Path(unit).read_text(encoding="utf-8")
    for name in ("NoNewPrivileges=yes", "DynamicUser=yes", "ProtectSystem=strict", "DeviceAllow=", "SupplementaryGroups=dialout"):
        check(name in words, f"the unit file has {name}")
    check("--write" not in words and "--allow" not in words, "and allows nothing")
    if not analyze:
        print("     no systemd here: the unit file is not looked at")
        return
    drop_in = next(each for each in blocks(text, "ini") if each.startswith("[Service]"))
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        # The program need not be installed.
        words = words.replace("/usr/bin/rtuwire ", f"{shutil.which('true')} ").replace("Documentation=man:rtuwire(1)\n", "")
        file = place / "rtuwire-serve@hall3.service"
        file.write_text(words, encoding="utf-8")
        extra = place / "rtuwire-serve@hall3.service.d"
        for name in ("as it is", "with what the page adds"):
            done = subprocess.run([analyze, "verify", str(file)], capture_output=True, text=True, timeout=LIMIT, check=False)
            check(done.returncode == 0 and not done.stderr.strip(), f"systemd takes the unit file {name}", done.stderr)
            extra.mkdir(exist_ok=True)
            (extra / "own.conf").write_text(drop_in, encoding="utf-8")
        shutil.rmtree(extra)
        done = subprocess.run([analyze, "security", "--offline=true", str(file)], capture_output=True, text=True, timeout=LIMIT, check=False)
        found = re.search(r"Overall exposure level .*: ([\d.]+)", done.stdout)
        shown = re.search(r"its exposure ([\d.]+) of 10", text)
        if found:  # --offline is there from systemd 250 on; newer ones weigh more
            check(shown and abs(float(found[1]) - float(shown[1])) <= 0.5, "its exposure is what the page says", (found[1], shown and shown[1]))


def check_service_words(check, tool, text):
    """The words of the service's file make one command line."""
    shown = dict(each.split("=", 1) for each in blocks(text, "ini")[0].splitlines())
    with PlainUnits(1, 2, 3, 4) as line:
        words = shown["SERVE"].replace("9502", str(free_port()))
        ended = tool.run(*shown["LINE"].split(), "serve", *words.split(), "--listen", "mbap://127.0.0.1:0", "--for", "0.1s", port=line.name)
        check(ended.status == DONE, "the words of the service's file", ended)
    check(set(shown) == {"PORT", "LINE", "SERVE"}, "are those of the unit file", shown)


def check_yaml(check, text):
    """By promtool."""
    scrape, rules = blocks(text, "yaml")
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "prometheus.yml").write_text(scrape, encoding="utf-8")
        (place / "rules.yml").write_text(rules, encoding="utf-8")
        for words in (["check", "config", "prometheus.yml"], ["check", "rules", "rules.yml"]):
            done = subprocess.run(["promtool", *words], cwd=place, capture_output=True, text=True, timeout=LIMIT, check=False)
            check(done.returncode == 0 and "SUCCESS" in done.stdout + done.stderr, f"promtool {' '.join(words)}", (done.stdout, done.stderr))


def check_scraped(check, tool, text):
    """Prometheus, by the page's configuration, has the figures."""
    scrape = blocks(text, "yaml")[0]
    with PlainUnits(1, 2) as line, tempfile.TemporaryDirectory() as folder, \
            Served(tool.program, line.name, "--units", "1-2", "--metrics", "127.0.0.1:0") as served, Asker(served.number) as client:
        for i in range(5):
            client.read(1, FIRST + i)
        place, number = pathlib.Path(folder), free_port()
        words = scrape.replace("9502", str(served.ports["http"][0])).replace("15s", "1s")
        (place / "prometheus.yml").write_text(words, encoding="utf-8")
        prometheus = subprocess.Popen(["prometheus", "--config.file=prometheus.yml", "--storage.tsdb.path=data",
                                       f"--web.listen-address=127.0.0.1:{number}"], cwd=place, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.PIPE, text=True)
        try:
            wait_for_listener(number)

            def asked(query):
                with urllib.request.urlopen(f"http://127.0.0.1:{number}/api/v1/query?query={urllib.parse.quote(query)}", timeout=LIMIT) as answer:
                    return json.load(answer)["data"]["result"]
            check(soon(lambda: [each["value"][1] for each in asked('up{job="rtuwire"}')] == ["1"]), "Prometheus scrapes it")
            found = asked('sum(rtuwire_serve_requests_total{unit="1",line="hall3"})')
            check(found and float(found[0]["value"][1]) >= 5, "and has the requests", found)
        finally:
            prometheus.kill()
            prometheus.communicate()


def check_tls(check, tool, text):
    """stunnel, by the page's file, with a certificate of its own."""
    shown = next(each for each in blocks(text, "ini") if each.startswith("[modbus]"))
    with PlainUnits(1) as line, tempfile.TemporaryDirectory() as folder, Served(tool.program, line.name, "--units", "1") as served:
        place, inside, outside = pathlib.Path(folder), free_port(), free_port()

        def openssl(*words):
            subprocess.run(["openssl", *words], cwd=place, check=True, capture_output=True)
        for name in ("authority", "hall3", "client"):
            openssl("req", "-x509" if name == "authority" else "-new", "-newkey", "rsa:2048", "-nodes", "-keyout", f"{name}.key", "-out",
                    f"{name}.crt" if name == "authority" else f"{name}.csr", "-subj", f"/CN={name}", *(["-days", "2"] if name == "authority" else []))
            if name != "authority":
                openssl("x509", "-req", "-in", f"{name}.csr", "-CA", "authority.crt", "-CAkey", "authority.key", "-CAcreateserial", "-days", "2", "-out",
                        f"{name}.crt")
                (place / f"{name}.pem").write_bytes((place / f"{name}.crt").read_bytes() + (place / f"{name}.key").read_bytes())
        words = shown.replace("accept = 802", f"accept = 127.0.0.1:{outside}").replace("1502", str(served.number)).replace(
            "/etc/stunnel/hall3.pem", str(place / "hall3.pem")).replace("/etc/stunnel/clients.pem", str(place / "authority.crt"))
        (place / "server.conf").write_text(f"foreground = yes\npid =\n{words}", encoding="utf-8")
        for name, own in (("client", f"cert = {place / 'client.pem'}\n"), ("nobody", "")):
            (place / f"{name}.conf").write_text(f"foreground = yes\npid =\n[modbus]\nclient = yes\naccept = 127.0.0.1:{inside}\n"
                                                f"connect = 127.0.0.1:{outside}\n{own}", encoding="utf-8")
        stunnel = shutil.which("stunnel") or shutil.which("stunnel4")
        processes = [subprocess.Popen([stunnel, "server.conf"], cwd=place, stderr=subprocess.DEVNULL)]
        try:
            wait_for_listener(outside)
            for name in ("client", "nobody"):
                processes.append(subprocess.Popen([stunnel, f"{name}.conf"], cwd=place, stderr=subprocess.DEVNULL))
                wait_for_listener(inside)
                before = len(line.reads())
                with Asker(inside) as client:
                    try:
                        answer = client.read(1, FIRST)
                    except (RuntimeError, OSError):
                        answer = None
                if name == "client":
                    check(answer == [value_of(1, FIRST)], "through stunnel, with a certificate", answer)
                else:
                    check(answer is None and len(line.reads()) == before, "and not without one", answer)
                last = processes.pop()
                last.kill()
                last.wait()
        finally:
            for each in processes:
                each.kill()
                each.wait()
        with socket.create_connection(("127.0.0.1", served.number)):
            pass


def main(check, program, page, unit, others=""):
    text = pathlib.Path(page).read_text(encoding="utf-8")
    with Tool(os.path.abspath(program)) as tool:
        if others:
            check_yaml(check, text)
            check_scraped(check, tool, text)
            check_tls(check, tool, text)
            return
        check_commands(check, tool, text)
        check_words(check, tool, text)
        check_service_words(check, tool, text)
        check_unit(check, text, unit)


runs(main)
