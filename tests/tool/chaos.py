# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""`chaos` between clients of libmodbus, pymodbus and ours and a server of libmodbus: what passes on both of its sides is kept by
this program, and held against what its capture says. Our client takes no wrong value under any fault; what the others take is
told.

    python3 chaos.py TOOL LIBMODBUS_SERVER COUNTING_LIBMODBUS COUNTING_CLIENT [COUNT [SEED [FAULT ...]]]
"""
import concurrent.futures
import json
import os
import re
import select
import signal
import sys
import threading
import time
import tty

from support import DONE, NO_ANSWER, USAGE, PORT, HERE, Simulator, Tool, crc, runs, soon, with_crc

from pair import Programs, free_port, wait_for_listener  # noqa: I100

TIME_OUT = 250  # ms
SHORT = 120  # transactions
FAULTS = ("babble=0.2%@20", "cut=0.1%@20", "request-cut=0.1%@20",  # those that last longest first
          "delay=5%:20ms", "late=2%", "doubled=5%", "foreign=5%", "lost=2%", "damaged=5%", "noise=5%", "echo=2%", "lumps=10%",
          "split=5%:20ms", "request-delay=5%:20ms", "request-lost=2%", "request-damaged=1%", "request-lumps=10%",
          "request-split=5%:10ms")


class Wire:
    """Two pseudo-terminals, near.name and far.name, and between them this program, which keeps what passes with its time."""

    def __init__(self):
        self.ends = [os.openpty() for _ in range(2)]
        for _, far in self.ends:
            tty.setraw(far)
        self.near, self.far = (os.ttyname(far) for _, far in self.ends)
        self.passed = {"to far": [], "to near": []}
        self.stop = os.pipe()
        self.thread = threading.Thread(target=self.forward, daemon=True)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.finish()
        for number in (*self.ends[0], *self.ends[1], *self.stop):
            os.close(number)

    def finish(self):
        """What is on its way has passed."""
        if self.thread.is_alive():
            os.write(self.stop[1], b".")
            self.thread.join()

    def forward(self):
        near, far = self.ends[0][0], self.ends[1][0]
        while True:
            ready, _, _ = select.select([near, far, self.stop[0]], [], [])
            for source, sink, way in ((near, far, "to far"), (far, near, "to near")):
                if source in ready:
                    data = os.read(source, 4096)
                    self.passed[way].append((time.monotonic(), data))
                    os.write(sink, data)
            if ready == [self.stop[0]]:
                return

    def bytes(self, way):
        return b"".join(data for _, data in self.passed[way])


def packets(file):
    """Bytes and last comment of each packet of a capture in its UDP form, as the document of pcapng has it."""
    data, at, found = file.read_bytes(), 0, []
    while at < len(data):
        kind, size = (int.from_bytes(data[at + i:at + i + 4], "little") for i in (0, 4))
        if size < 12 or at + size > len(data):
            break  # the block is being written
        if kind == 6:
            kept = int.from_bytes(data[at + 20:at + 24], "little")
            options, comment = at + 28 + (kept + 3) // 4 * 4, ""
            while (code := int.from_bytes(data[options:options + 2], "little")) != 0:
                length = int.from_bytes(data[options + 2:options + 4], "little")
                comment = data[options + 4:options + 4 + length].decode() if code == 1 else comment
                options += 4 + (length + 3) // 4 * 4
            found.append((data[at + 28 + 28:at + 28 + kept], comment))
        at += size
    return found


def told(file):
    """Four streams of bytes, as the comments have it: what came from each side, and what left for each."""
    came, left = {"request": b"", "answer": b""}, {"request": b"", "answer": b""}
    arrived = set()  # a fault has two packets: as the frame came, and what became of it
    for data, comment in packets(file):
        kind, number = comment.replace(":", "").split()[:2]
        is_kept = " came: kept back" in comment
        if " given back" in comment:
            left["answer"] += data
        elif " came: " in comment:
            came[kind] += b"" if is_kept and (kind, number) in arrived else data
            arrived.add((kind, number))
        elif " left: " in comment:
            left[kind] += data
            made_up = re.search("left: (foreign|noise|babble)", comment)
            assert made_up or data, comment
        else:
            came[kind] += data
            left[kind] += data
    return came, left


def numbers(file, fault):
    """Of the frames that a fault met."""
    found = []
    for _, comment in packets(file):
        words = comment.replace(",", "").split()
        if (words[2:3] == ["came:"] and fault in words[3:]) or (fault == "echo" and "given back" in comment):
            found.append(int(words[1]))
    return found


class Chaos:
    """with Chaos(tool, others, server, faults) as it: ... it.device, for a client; it.finish()."""

    def __init__(self, tool, others, server, faults, seed, name):
        self.tool, self.file, self.faults, self.seed = tool, tool.place / f"{name}.pcapng", faults, seed
        self.near, self.far = Wire(), Wire()
        self.others, self.server = others, server

    def __enter__(self):
        self.near.__enter__(), self.far.__enter__()
        self.serving = self.others.serve(self.far.far, [self.server, "@"])
        self.process = self.tool.start("--json", "--timeout", TIME_OUT / 1000, "chaos", "--from", self.near.far, "--to",
                                       self.far.near, "--seed", self.seed, "--faults", self.faults, "-o", self.file)
        self.heads = [self.process.stderr.readline() for _ in range(2)]
        self.device = self.near.near
        return self

    def seen(self):
        """What passed on both sides, in the form of `told`."""
        return ({"request": self.near.bytes("to far"), "answer": self.far.bytes("to near")},
                {"request": self.far.bytes("to far"), "answer": self.near.bytes("to near")})

    def has_settled(self):
        return self.seen()[0] == told(self.file)[0]

    def finish(self):
        self.process.send_signal(signal.SIGINT)
        self.output, self.errors = self.process.communicate(timeout=60)
        self.near.finish(), self.far.finish()
        return {(row["of"], row["fault"]): row["frames"] for row in map(json.loads, self.output.splitlines())}

    def __exit__(self, *_):
        for each in (self.process, self.serving):  # a server of libmodbus whose line is gone does not rest
            each.kill()
            each.communicate()
        self.near.__exit__(), self.far.__exit__()


def foretold(tool, faults, seed):
    ended = tool.run("--json", "--timeout", TIME_OUT / 1000, "chaos", "--faults", faults, "--seed", seed, "--dry")
    row = ended.objects()[0]
    return [int(word) for word in row["frames"].replace("...", "").split()]


def held(tool, check, others, server, who, client, fault, count, seed):
    """One client, one fault."""
    name = f"{who} {fault}"
    with Chaos(tool, others, server, fault, seed, re.sub("[^a-z0-9]", "_", name)) as line:
        process = others.start([*client, line.device, str(count), str(TIME_OUT)], stdout=-1, stderr=-1)
        output, errors = process.communicate(timeout=60 + count)
        check(soon(line.has_settled, 10), f"{name}: all that came is in the capture")
        counts = line.finish()
        check(process.returncode == 0, f"{name}: the client", errors)
        right, wrong, missing = map(int, output.split())
        (seen_came, seen_left), (came, left) = line.seen(), told(line.file)
        # The server may have answered when it had ended.
        check(all(seen_came[way].startswith(came[way]) for way in came), f"{name}: what came is what the capture says",
              [(len(seen_came[way]), len(came[way])) for way in came])
        check(seen_left == left, f"{name}: what left is what the capture says", [(len(seen_left[way]), len(left[way])) for way in left])
        kind = re.split("[=@]", fault)[0]
        met = numbers(line.file, kind)
        of = "requests" if kind.startswith("request-") or kind == "echo" else "answers"
        check(met and len(met) == counts.get((of, kind), 0), f"{name}: the figures are those of the capture", (met, counts))
        wanted = [each for each in foretold(tool, fault, seed) if each <= counts[(of, "all")]]
        check(met[:len(wanted)] == wanted, f"{name}: the frames that --dry foretold", (met, wanted))
        if who == "ours":
            check(wrong == 0, f"{name}: no wrong value", (right, wrong, missing))
            check(right > 0, f"{name}: some are right", (right, wrong, missing))
        return who, fault, right, wrong, missing


def check_clients(check, tool, others, server, clients, count, seed, faults):
    with concurrent.futures.ThreadPoolExecutor(12) as pool:  # they wait, nearly all of the time
        runs_ = [pool.submit(held, tool, check, others, server, who, client, fault, count, seed)
                 for fault in faults for who, client in clients.items()]
        rows = [each.result() for each in runs_]
    for who, fault, right, wrong, missing in rows:
        print(f"     {who:10} {fault:22} {right} right, {wrong} wrong, {missing} without a value")


def exchange(device, requests):
    """Each request, and what comes within the time-out."""
    number, heard = os.open(device, os.O_RDWR | os.O_NOCTTY), []
    for request in requests:
        os.write(number, request)
        end, data = time.monotonic() + TIME_OUT / 1000 + 0.2, b""
        while time.monotonic() < end and select.select([number], [], [], max(0, end - time.monotonic()))[0]:
            data += os.read(number, 4096)
        heard.append(data)
    os.close(number)
    return heard


def check_each(check, tool, others, server):
    """What single faults do, by the times and bytes that were seen on both sides."""
    read, answer = with_crc(bytes.fromhex("010300640001")), with_crc(bytes.fromhex("0103020064"))
    faults = "late@2:50ms,doubled@3,foreign@4,noise@5,split@6:20ms,echo@7,request-lost@8"
    with Chaos(tool, others, server, faults, 5, "each") as line:
        heard = exchange(line.device, [read] * 8)
        line.finish()
        check(heard[0] == answer and heard[1] == answer, "an answer, and a late one", heard)
        check(heard[2] == answer * 2, "twice", heard[2].hex(" "))
        check(heard[3].endswith(answer) and len(heard[3]) == 14 and crc(heard[3][:7]) == 0 and heard[3][0] != 1,
              "a foreign one before it", heard[3].hex(" "))
        check(answer in heard[4] and 7 < len(heard[4]) <= 11, "noise", heard[4].hex(" "))
        check(heard[5] == answer and heard[6] == read + answer and heard[7] == b"", "pieces, an echo, nothing", heard[5:])
        asked = [at for at, _ in line.far.passed["to far"]]
        answered = [at for at, _ in line.near.passed["to near"]]
        check(len(asked) == 7, "the server was asked seven times", len(asked))
        check(answered[1] - asked[1] > TIME_OUT / 1000, "the late one came behind the time-out", answered[1] - asked[1])
        check("motor" in line.heads[0] and line.near.far in line.heads[1], "what it is for is said first", line.heads)


def check_writes(check, tool, others, server):
    """Writes through everything: the server gets copies of what the client sent, and each at most as often."""
    writes = [with_crc(bytes([1, 6, 0, 100 + i % 50, 0x12, i])) for i in range(60)]
    faults = "damaged=30%,foreign=50%,noise=50%,babble=3%:60ms,doubled=30%,echo=20%,request-damaged=50%,request-split=30%:5ms"
    with Chaos(tool, others, server, faults, 9, "writes") as line:
        number = os.open(line.device, os.O_RDWR | os.O_NOCTTY)
        for each in writes:
            os.write(number, each)
            time.sleep(0.02)
        os.close(number)
        check(soon(line.has_settled), "all writes are in the capture")
        line.finish()
        heard = line.far.bytes("to far")
        found = [heard[at:at + 8] for at in range(len(heard) - 7) if crc(heard[at:at + 8]) == 0]
        check(found and all(each in writes for each in found) and len(found) == len(set(found)),
              "the server gets what the client wrote, once at most", len(found))


def check_tcp(check, tool, others, server, counting_client):
    """A server behind a serial device server."""
    number = free_port()
    others.serve(others.device_server(number), [server, "@"])
    wait_for_listener(number)
    process = tool.start("chaos", "--from", "pty", "--to", f"tcp://127.0.0.1:{number}", "--faults", "split=50%:5ms,request-split=50%:5ms")
    device = [process.stderr.readline() for _ in range(2)][1].split(",")[0].removeprefix("client on ")
    client = others.start([counting_client, device, "40", "2000"], stdout=-1)
    said, _ = client.communicate(timeout=60)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=20)
    check(said.split() == ["40", "0", "0"] and re.search("answers +split +[1-9]", output), "pieces over TCP", (said, output, errors))
    asked = f"127.0.0.1:{free_port()}"
    process = tool.start("chaos", "--from", f"tcp://{asked}", "--to", "sim:atv320:7", "--faults", "lost@2")
    heads = [process.stderr.readline() for _ in range(2)]
    check(f"client on {asked}, server on" in heads[1], "it says where it listens", heads)
    for words, status in ((["RFR"], DONE), (["LCR"], NO_ANSWER), (["RFR"], DONE)):  # each a client of its own
        ended = tool.run("--no-listen", "-u", 7, "-d", "atv320", "--timeout", 2, "--retries", 0, "read", *words, port=f"tcp://{asked}")
        check(ended.status == status, f"a client over TCP: {words} ends with {status}", ended)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=20)
    check(process.returncode == DONE and re.search("answers +lost +1", output), "and it has what they asked", (output, errors))
    ended = tool.run("chaos", "--from", "tcp://192.0.2.1:4001", "--to", "pty", "--faults", "lost=1%")
    check(ended.status == PORT and "--from: 192.0.2.1:4001: cannot listen there" in ended.errors, "an address of nobody here", ended)


def check_ports(check, tool):
    """A pseudo-terminal of its own, drives behind it, TCP; what is refused."""
    process = tool.start("chaos", "--from", "pty", "--to", "sim:atv320:7", "--faults", "lost@1", "--for", "20s")
    device = [process.stderr.readline() for _ in range(2)][1].split(",")[0].removeprefix("client on ")
    ended = tool.run("--listen", 0.05, "-u", 7, "-d", "atv320", "--timeout", 0.2, "--json", "read", "RFR", "LCR", "ETA", port=device)
    check(ended.status == DONE and len(ended.objects()) == 3, "our tool reads a drive through it", ended)
    process.send_signal(signal.SIGTERM)
    output, errors = process.communicate(timeout=20)
    check(process.returncode == DONE and "lost" in output, "and it ends with its figures", (output, errors))

    ended = tool.run("chaos", "--from", "pty", "--to", "pty", "--faults", "lost=1%", "--for", "0.1s")
    check(ended.status == NO_ANSWER, "nobody asked anything", ended)
    for words, status, says in ((["--faults", "lost=1%"], USAGE, "--from"), (["--from", "pty", "--faults", "lost=1%"], USAGE, "--to"),
                                (["--from", "pty", "--to", "pty"], USAGE, "--faults"),
                                (["--from", "pty", "--to", "mbap://127.0.0.1", "--faults", "lost=1%"], USAGE, "--to mbap://127.0.0.1: Modbus TCP has no line"),
                                (["--from", "/dev/null", "--to", "/dev/null", "--faults", "lost=1%"], USAGE, "both"),
                                (["--from", "sim:atv320:7", "--to", "pty", "--faults", "lost=1%"], USAGE, "ask nobody"),
                                (["--from", "pty", "--to", "pty", "--faults", "lost=1%", "-o", "-"], USAGE, "-o -"),
                                (["--from", "pty", "--to", "/dev/nothing", "--faults", "lost=1%"], PORT, "--to: /dev/nothing"),
                                (["--from", "pty", "--to", f"tcp://127.0.0.1:{free_port()}", "--faults", "lost=1%"], PORT, "--to"),
                                (["--from", "pty", "--to", "pty", "--faults", "late=1%,lots=1%"], USAGE, "did you mean 'lost'"),
                                (["--faults", "request-foreign=1%", "--dry"], USAGE, "command a motor")):
        ended = tool.run("chaos", *words)
        check(ended.status == status and says in ended.errors and not ended.output, f"{words} is refused", ended)
    kept = tool.place / "kept.pcapng"
    kept.write_bytes(b"of somebody")
    for words, status, says in ((["-o", kept], PORT, f"-o {kept}: is there already"), (["-o", ""], USAGE, "a file has a name"),
                                (["--seed", "4294967296"], USAGE, "4294967295"), (["--seed", "-1"], USAGE, "4294967295")):
        ended = tool.run("chaos", "--from", "pty", "--to", "pty", "--faults", "lost=1%", "--for", "0.1s", *words)
        check(ended.status == status and says in ended.errors and not ended.output, f"{words} is refused", ended)
    check(kept.read_bytes() == b"of somebody", "a file that is there stays as it is")
    ended = tool.run("--json", "chaos", "--faults", "lost=1%", "--seed", "4294967295", "--dry")
    check(ended.status == DONE and ended.objects(), "the last seed is one", ended)
    ended = tool.run("chaos", "--from", "pty", "--to", "pty", "--faults", "lost=1%", port="/dev/null")
    check(ended.status == USAGE and "two ports" in ended.errors, "--port is refused", ended)
    one, two, other = (tool.run("--json", "chaos", "--faults", "late=1%,lost@250x5", "--seed", seed, "--dry").output for seed in (3, 3, 4))
    check(one == two != other and '"frames":"250 251 252 253 254"' in one, "--dry says which frames", one)


def main(check, tool_path, server, counting_libmodbus, counting_client, count=SHORT, seed=1, *faults):
    clients = {"ours": [counting_client], "libmodbus": [counting_libmodbus],
               "pymodbus": [sys.executable, "-B", str(HERE.parent / "interop" / "counting_pymodbus.py")]}
    with Tool(tool_path) as tool, Programs() as others:
        check_clients(check, tool, others, os.path.abspath(server), clients, int(count), int(seed), faults or FAULTS)
        if not faults:
            check_each(check, tool, others, os.path.abspath(server))
            check_writes(check, tool, others, os.path.abspath(server))
            check_tcp(check, tool, others, os.path.abspath(server), counting_client)
            check_ports(check, tool)


if __name__ == "__main__":
    runs(main)
