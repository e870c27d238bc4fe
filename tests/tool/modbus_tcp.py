# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Modbus TCP: servers that nobody here wrote, servers that say what no server should, and simulated drives behind the tool's
own gateway.

    python3 modbus_tcp.py TOOL others SERVER [WORD...]    as drawn_values.py names it
    python3 modbus_tcp.py TOOL hostile
    python3 modbus_tcp.py TOOL drives
"""
import signal
import socket
import subprocess
import threading
import time

from support import DIFFERS, DONE, NO_ANSWER, PORT, USAGE, Tool, runs, soon, with_crc

from field_units import OnTcp  # noqa: I100
from pair import Programs, free_port, wait_for_listener  # noqa: I100
from simulator import Registers  # noqa: I100

ONCE = ("--timeout", 0.3, "--retries", 0)  # for what stays silent
PATIENT = ("--timeout", 10, "--retries", 0)  # for what answers


def message(number, body, protocol=0, length=None):
    size = len(body) if length is None else length
    return number.to_bytes(2, "big") + protocol.to_bytes(2, "big") + size.to_bytes(2, "big") + body


class Request:
    """As it came: number, protocol, unit and PDU."""

    def __init__(self, data):
        self.data, self.number, self.protocol = data, int.from_bytes(data[:2], "big"), int.from_bytes(data[2:4], "big")
        self.unit, self.pdu = data[6], data[7:]

    def answer(self, value, unit=None):
        """To a read of holding registers: each has this value."""
        count = int.from_bytes(self.pdu[3:5], "big")
        body = bytes([self.unit if unit is None else unit, 3, 2 * count]) + value.to_bytes(2, "big") * count
        return message(self.number, body)


class Server(OnTcp):
    """with Server(said) as server: what is said to each request, in parts: bytes; a number of seconds to wait; None, which ends the
    connection. `server.name` is its port of the tool."""

    def __init__(self, said, word="mbap"):
        self.said, self.requests, self.heard = said, [], b""
        super().__init__(word)

    def talk(self, line):
        waiting = b""
        while data := line.recv(512):
            waiting += data
            self.heard += data
            while len(waiting) >= 6 and len(waiting) >= 6 + int.from_bytes(waiting[4:6], "big"):
                size = 6 + int.from_bytes(waiting[4:6], "big")
                request, waiting = Request(waiting[:size]), waiting[size:]
                self.requests.append(request)
                for part in self.said(request):
                    if part is None:
                        return
                    time.sleep(part) if isinstance(part, (int, float)) else line.sendall(part)


# Servers of others.

def others(check, program, *command):
    """Read, watched, mapped, found and asked who they are; values: drawn_values.py."""
    number = free_port()
    # jsmodbus answers a read behind its last register with nothing, which no write is let through behind.
    count = "9900" if "jsmodbus" in command else "50"
    with Tool(program, f"mbap://127.0.0.1:{number}") as tool, Programs() as programs:
        server = programs.serve(f"mbap:{number}", [*command, "@", "100", count], stdin=subprocess.PIPE,
                                stderr=subprocess.DEVNULL)

        def told(words):
            server.stdin.write(words + "\n")
            server.stdin.flush()
            return server.stdout.readline().strip()
        told("set holding 100 1234 0007 ffff")
        told("set input 101 00ff")
        told("set coil 102 1")
        ended = tool.run("--json", "read", "100-102", "input:101", "coil:102")
        check([each["raw"] for each in ended.objects()] == [0x1234, 7, 0xFFFF, 0xFF, 1], "its memory is read", ended)
        ended = tool.run("-u", 1, "-d", "none", "--write", "--allow-run", "--json", "write", "103=77", "coil:103=on", "104:u32=70000")
        check(ended.status == DONE and told("get holding 103 3") == "004d 0001 1170" and told("get coil 103 1") == "0001",
              "and written, each by itself and two at once", ended)
        ended = tool.run("--csv", "watch", "100", "--every", "50ms", "--for", "0.3s")
        check(ended.status == DONE and {row["100"] for row in ended.rows()} == {str(0x1234)}, "and watched", ended)
        ended = tool.run("-v", "read", "100")
        check("> 01 03 00 64 00 01\n" in ended.errors and "< 01 03 02 12 34\n" in ended.errors,
              "what passes is shown without header and CRC", ended)
        ended = tool.run("--trace", "told.pcapng", "read", "100")
        check(b"Modbus TCP, CRCs made up: 127.0.0.1" in (tool.place / "told.pcapng").read_bytes(),
              "a trace says that its CRCs are made up", ended)
        ended = tool.run("--json", "scan", "--units", "1-2", "--timeout", 2)
        found = [each["unit"] for each in ended.objects()]
        check(ended.status == DONE and found[0] == 1, "a scan finds it", ended)
        if "jsmodbus" not in command:  # it has no function 43, all registers, and says nothing to what it lacks
            told("lack 22")
            ended = tool.run("--csv", "map", "90-160")
            check(ended.status == DONE and [(row["first"], row["last"]) for row in ended.rows()] == [("100", "149")],
                  "a map finds the registers that it has", ended)
            ended = tool.run("identify")
            check(ended.status in (DONE, DIFFERS), "it is asked who it is", ended)


# Servers of this test.

def answers(check, tool, what, said, status, *says, words=("read", "100"), word="mbap", how=None):
    how = how or (ONCE if status == NO_ANSWER else PATIENT)
    with Server(said, word) as server:
        ended = tool.run(*how, *words, port=server.name)
        check(ended.status == status and all(each in ended.output + ended.errors for each in says), what, ended)
        return server, ended


def pieces(check, tool):
    def in_bytes(request):
        for each in request.answer(0x1234):
            yield bytes([each])
            yield 0.002
    answers(check, tool, "an answer in single bytes is one", in_bytes, DONE, "4660")
    lump = answers(check, tool, "two in one lump: the first counts, and the next question gets its own",
                   lambda it: [it.answer(it.number) + it.answer(0x7777)], DONE, '"raw":1,', '"raw":2,',
                   words=("--json", "read", "100", "200"))[0]
    check([each.number for each in lump.requests] == [1, 2] and all(each.protocol == 0 for each in lump.requests),
          "numbers count up", [each.data for each in lump.requests])
    check(lump.requests[0].data == bytes.fromhex("0001 0000 0006 01 03 0064 0001"), "a request is what the book says",
          lump.requests[0].data)


def numbers(check, tool):
    """Every answer comes as the answer to the question behind it would, but for its number."""
    waiting = []

    def late(request):
        waiting.append(request)
        if len(waiting) > 1:
            before = waiting[-2]
            return [before.answer(0x0BAD), request.answer(0x600D)]
        return []
    _, ended = answers(check, tool, "a late answer is never another's", late, NO_ANSWER, "24589", "no response",
                       words=("--json", "read", "100", "300"), how=("--timeout", 2, "--retries", 0))
    check("2989" not in ended.output, "at no register", ended)
    # To each request that to the one before.
    waiting.clear()

    def behind(request):
        waiting.append(request)
        return [each.answer(1) for each in waiting[-2:-1]]
    answers(check, tool, "what comes too late is told with how late it is", behind, NO_ANSWER,
            "were dropped by their number", "say --timeout", words=("read", "100"), how=("--timeout", 1, "--retries", 2))
    # Answered to the second sending: the next question is the third request, with nothing in between.
    sent = []

    def second(request):
        sent.append(request)
        return [request.answer(5)] if len(sent) != 1 else []
    answers(check, tool, "the repetition is answered", second, DONE, words=("read", "100", "300"),
            how=("--timeout", 2, "--retries", 1))
    check([each.pdu[1:3] for each in sent] == [bytes([0, 100]), bytes([0, 100]), bytes([1, 44])],
          "and nothing is asked in between", [each.data for each in sent])
    answers(check, tool, "another number is no answer", lambda it: [message(it.number + 7, it.answer(9)[6:])], NO_ANSWER)


def units(check, tool):
    answers(check, tool, "the answer of another unit is none", lambda it: [it.answer(9, unit=9)], NO_ANSWER, "of unit 9", "-u 9")
    answers(check, tool, "nor that of unit 0", lambda it: [it.answer(9, unit=0)], NO_ANSWER, "--any-unit -u 0")
    for unit in (0, 255):
        server, _ = answers(check, tool, f"unit {unit} goes as it is", lambda it: [it.answer(9)], DONE, "9",
                            words=("--any-unit", "-u", unit, "read", "100"))
        check({each.unit for each in server.requests} == {unit}, f"unit {unit} is in the message", server.requests[0].data)
    server, _ = answers(check, tool, "what is for all units goes to 0", lambda it: [it.data], DONE, "nobody answers",
                        words=("-y", "-u", 0, "--write", "--allow-run", "ask", "06", "FDE80005"))
    check([each.unit for each in server.requests] == [0], "once", server.requests)


def wrong(check, tool):
    answers(check, tool, "a wrong protocol", lambda it: [message(it.number, it.answer(1)[6:], protocol=1)], PORT,
            "no Modbus TCP", "protocol is not 0", "00 01 00 01")
    for length in (0, 1, 255, 300, 65535):
        answers(check, tool, f"a length of {length}", lambda it: [message(it.number, it.answer(1)[6:], length=length)], PORT,
                "no Modbus TCP", "2 to 254")
    short = answers(check, tool, "one that has too little", lambda it: [message(it.number, it.answer(1)[6:-1])], DIFFERS,
                    "wrong length", "4 bytes came, 5 are due: 01 03 02 00", how=("--timeout", 2, "--retries", 0))[1]
    answers(check, tool, "one that has too much", lambda it: [message(it.number, it.answer(1)[6:] + b"\7")], DIFFERS,
            "6 bytes came, 5 are due: 01 03 02 00 01 07", how=("--timeout", 2, "--retries", 0))
    echo = answers(check, tool, "a server that gives back what it is sent", lambda it: [it.data], DIFFERS, "gives back what it is sent",
                   how=("--timeout", 2, "--retries", 0))[1]
    check(not any(each in ended.output + ended.errors for ended in (echo, short) for each in ("CRC", "--echo", "A and B")),
          "no word of what only a serial line has", (echo, short))
    answers(check, tool, "no echo is waited for", lambda it: [it.answer(9)], DONE, "9", words=("--echo", "--noise", 8, "read", "100"))
    answers(check, tool, "a refusal of a gateway", lambda it: [message(it.number, bytes([it.unit, 0x83, 0x0B]))], DIFFERS,
            "gateway")
    _, ended = answers(check, tool, "it goes in the middle", lambda it: [it.answer(1)[:8], None], PORT,
                       "closed by the other end", "8 bytes had come")
    check("tcp://" not in ended.errors, "which is no other protocol", ended)
    answers(check, tool, "it goes without a word", lambda it: [None], PORT, "closed by the other end", "tcp://127.0.0.1")


def other_protocol(check, tool):
    """Each spoken to the other."""
    def rtu(request):
        return [with_crc(bytes([1, 3, 2, 0, 5]))]
    server, _ = answers(check, tool, "RTU frames at the port of Modbus TCP", rtu, PORT, "no Modbus TCP", "01 03 02 00 05",
                        "tcp://127.0.0.1")
    answers(check, tool, "and an exception of RTU, which is shorter than a header",
            lambda it: [with_crc(bytes([1, 0x83, 2]))], PORT, "01 83 02 C0 F1", "tcp://127.0.0.1")
    answers(check, tool, "silence where Modbus TCP was sent", lambda it: [], NO_ANSWER, f"tcp://127.0.0.1")
    answers(check, tool, "silence where RTU frames were sent", lambda it: [], NO_ANSWER, "mbap://127.0.0.1", word="tcp")
    for words in (["read", "100"], ["read", "RFR"], ["identify"], ["stop"]):
        for sent, other, frames in (("tcp", "mbap", "RTU frames with a CRC were sent"), ("mbap", "tcp", "Modbus TCP was sent")):
            with socket.create_server(("127.0.0.1", 0)) as listening:
                def hang_up():
                    line, _ = listening.accept()
                    line.recv(64)
                    line.close()
                threading.Thread(target=hang_up, daemon=True).start()
                number = listening.getsockname()[1]
                ended = tool.run(*PATIENT, "--no-listen", *words, port=f"{sent}://127.0.0.1:{number}")
            told = ended.output + ended.errors
            check(ended.status == PORT and f"{other}://127.0.0.1:{number}" in told and frames in told,
                  f"{words}: an end where {sent}:// was spoken", ended)
    ended = tool.run("read", "100", port=f"mbap://127.0.0.1:{free_port()}")
    check(ended.status == PORT and "Connection refused" in ended.errors, "nobody listens", ended)
    ended = tool.run("read", "100", port="mbap://no-such-host.invalid")
    check(ended.status == PORT and "no-such-host.invalid:502: no such host" in ended.errors, "no such host", ended)


def no_line(check, tool):
    """What only a serial line has."""
    nowhere = f"mbap://127.0.0.1:{free_port()}"
    for words, says in ((["sniff"], "nothing to listen to"), (["capture", "-o", "x"], "nothing to listen to"),
                        (["timing"], "nothing to listen to"), (["scan", "--find"], "no bit rate"),
                        (["sniff", "--find"], "no bit rate"), (["--rs485", "read", "1"], "no serial device")):
        ended = tool.run(*words, port=nowhere)
        check(ended.status == USAGE and says in ended.errors, f"{words} is refused", ended)


def hostile(check, program):
    with Tool(program) as tool:
        for part in (pieces, numbers, units, wrong, other_protocol, no_line):
            part(check, tool)


# Simulated drives.

class Gateway:
    """with Gateway(program, "atv320:7") as gateway: drives behind Modbus TCP; `gateway.shown(7)` without a request."""

    def __init__(self, program, *drives):
        self.number = free_port()
        self.name = f"mbap://127.0.0.1:{self.number}"
        self.process = subprocess.Popen([program, "--port", self.name, "simulate", *drives], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        for _ in drives:
            self.process.stdout.readline()

    def told(self, what):
        self.process.stdin.write(what + "\n")
        self.process.stdin.flush()

    def shown(self, unit):
        self.told(f"{unit} show")
        state, frequency, fault = self.process.stdout.readline().split(": ")[1].split(", ")
        return state, float(frequency.removesuffix(" Hz")), int(fault.split()[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()


def ends_half_way(check, tool, gateway):
    """A real drive, which refuses function 43: the line ends, or falls silent, behind so many answers."""
    for count in range(5):
        for how in ("cut", "silent"):
            for words in (["identify"], ["read", "RFR"], ["scan", "--units", "4"]):
                what = f"{words[0]}, {how} behind {count} answers"
                with socket.create_connection(("127.0.0.1", gateway.number)) as drive, Server(None) as server:
                    def said(request):
                        if len(server.requests) > count:
                            return [None] if how == "cut" else []
                        drive.sendall(request.data)
                        return [drive.recv(512)]
                    server.said = said
                    asks = ONCE if how == "silent" else PATIENT
                    ended = tool.run(*words, *asks, port=server.name) if words[0] == "scan" else \
                        tool.run(*asks, "-u", 4, *words, port=server.name)
                told = ended.output + ended.errors
                check("those of no drive" not in told, f"{what}: nothing is said of what was not read", ended)
                if how == "cut":
                    check(ended.status == PORT and "closed by the other end" in told, f"{what}: the port's failure", ended)
                elif words[0] != "scan":
                    check(ended.status == NO_ANSWER and "no response" in told, f"{what}: no answer", ended)
                elif count > 1:
                    check("no response" in ended.output, f"{what}: the row says so", ended)


def ends_before_a_stop(check, tool, gateway):
    """The line ends before a request of a stop goes on, or behind its answer."""
    says = {"unsent": "no word that stops the motor was sent before", "sent": "sent, and no answer confirmed it",
            "confirmed": "the drive has confirmed the word"}
    seen = []
    for drive in ((), ("-d", "atv320")):
        for count in range(1, 6):
            for behind in (False, True):
                with socket.create_connection(("127.0.0.1", gateway.number)) as far, Server(None) as server:
                    answered = []

                    def said(request):
                        is_last = len(server.requests) >= count
                        if is_last and not behind:
                            return [None]
                        far.sendall(request.data)
                        answered.append(request)
                        return [far.recv(512), *([None] if is_last else [])]
                    server.said = said
                    ended = tool.run(*PATIENT, "-u", 7, *drive, "stop", port=server.name)
                came = [request.pdu[0] == 6 for request in server.requests]
                how = "confirmed" if any(each.pdu[0] == 6 for each in answered) else "sent" if any(came) else "unsent"
                what = f"stop {' '.join(drive)}, cut {'behind' if behind else 'before'} answer {count}: {how}"
                if ended.status == DONE:  # it was over before
                    check("the motor" in ended.output and len(server.requests) <= count, what, ended)
                    continue
                told = ended.output + ended.errors
                check(ended.status == PORT and "the connection is gone" in told and "stop` stops it" in told, what, ended)
                # What is written behind an end that was not seen yet is sent, and comes to nobody.
                may_be = ["unsent", "sent"] if how == "unsent" else [how]
                found = [each for each in says if says[each] in told]
                check(found in [[each] for each in may_be], f"{what}: is said", ended)
                seen += found
    check(set(seen) == set(says), "each of the three was said", seen)


class Between:
    """A connection that can be cut, or fall silent, between a client and a server."""

    def __init__(self, number):
        self.number, self.ends, self.is_silent = number, [], False
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.name = f"mbap://127.0.0.1:{self.listening.getsockname()[1]}"
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                near, _ = self.listening.accept()
            except OSError:
                return
            far = socket.create_connection(("127.0.0.1", self.number))
            self.ends += [near, far]
            for one, other in ((near, far), (far, near)):
                threading.Thread(target=self.pass_on, args=(one, other), daemon=True).start()

    def pass_on(self, one, other):
        try:
            while data := one.recv(512):
                if not self.is_silent:
                    other.sendall(data)
        except OSError:
            pass

    def cut(self):
        for each in self.ends:
            each.shutdown(socket.SHUT_RDWR)

    def close(self):
        self.listening.close()
        for each in self.ends:
            each.close()


def reads_drives(check, tool, gateway):
    ended = tool.run("--json", "scan", "--units", "1-12", port=gateway.name)
    found = {each["unit"]: each["drive"] for each in ended.objects()}
    check(ended.status == DONE and found == {3: "atv12", 4: "atv28", 7: "atv320"}, "a scan finds the drives, and nobody else", ended)
    check(all(each["baud"] is None and each["format"] is None for each in ended.objects()), "at no bit rate", ended)
    ended = tool.run("scan", "--units", "8-9", port=gateway.name)
    check(ended.status == NO_ANSWER and "nobody answered: 2 addresses asked, 1 s each" in ended.errors
          and not any(each in ended.errors for each in ("19200", "A and B", "bit rate")), "nor is one named where nobody is", ended)
    ended = tool.run("-u", 5, "read", "3201", port=gateway.name)
    check(ended.status == DIFFERS and "gateway" in ended.errors + ended.output, "a unit that is not there is one of a gateway", ended)
    ended = tool.run("-u", 5, "identify", port=gateway.name)
    check(ended.status == DIFFERS and "gateway" in ended.output and "answers, but" not in ended.output, "and does not answer", ended)
    ended = tool.run("--json", "-u", "7,3", "read", "RFR", port=gateway.name)
    check(ended.status == DONE and len(ended.objects()) == 2, "both are read", ended)
    ended = tool.run("-u", 7, "--yes", "--json", "check", port=gateway.name)
    rows = {row["clause"]: row for row in ended.objects()}
    check(ended.status == DONE and not [row for row in rows.values() if row["verdict"] == "fails" and row["level"] == "must"],
          "check: all musts hold", ended)
    check(rows["L01"]["verdict"] == "holds" and "serial line" in rows["L02"]["why"] and rows["L02"]["verdict"] != "holds",
          "what needs a serial line does not apply", (rows["L01"], rows["L02"]))
    check(sum(row["verdict"] == "holds" for row in rows.values()) > 20, "and the others are asked", len(rows))
    clients = [tool.start("-u", 7, "--csv", "watch", "RFR", "--every", "20ms", "--for", "1s", port=gateway.name)
               for _ in range(4)]
    check(all(each.communicate()[0].count("\n") > 1 and each.returncode == 0 for each in clients), "four clients at once")


def runs_a_motor(check, tool, gateway):
    at = Registers("atv320")
    for register, word in ((at.acc, 5), (at.dec, 5), (at.tto, 50)):
        gateway.told(f"7 write {register} {word}")

    def stands():
        return gateway.shown(7)[1] == 0

    def start(port):
        process = tool.start("-u", 7, "--allow-run", "start", "--frequency", "40Hz", port=port)
        check(soon(lambda: gateway.shown(7)[1] > 35, 30), "the motor runs", "" if process.poll() is None else process.communicate())
        return process
    ended = tool.run("-u", 7, "--allow-run", "start", "--frequency", "40Hz", "--for", "1s", port=gateway.name)
    check(ended.status == DONE and "the motor stands" in ended.output and stands(), "runs and stops by its time", ended)
    for signal_number, status in ((signal.SIGINT, DONE), (signal.SIGHUP, 129)):
        process = start(gateway.name)
        process.send_signal(signal_number)
        process.communicate()
        check(process.returncode == status and stands() and gateway.shown(7)[2] == 0,
              f"{signal_number.name} stops it by words, with no fault", (process.returncode, gateway.shown(7)))
    # An error of the program: one frame, straight to the socket, as a message.
    process = start(gateway.name)
    process.send_signal(signal.SIGSEGV)
    process.communicate()
    check(soon(stands, 60) and gateway.shown(7)[2] == 0, "an error of the program stops it by a word, with no fault", gateway.shown(7))
    for how in ("cut", "silent"):
        between = Between(gateway.number)
        process = start(between.name)
        between.is_silent = True
        if how == "cut":
            between.cut()
        output, errors = process.communicate()
        check(process.returncode != DONE, f"{how}: the program says that it failed", (process.returncode, output, errors))
        check(soon(stands, 60) and gateway.shown(7)[2] != 0, f"{how}: the drive stops by its own time-out", gateway.shown(7))
        between.close()
        ended = tool.run("-u", 7, "-y", "--write", "reset", port=gateway.name)
        check(ended.status == DONE, "it is reset", ended)


def shares_its_port(check, tool, gateway):
    ended = tool.run("simulate", "atv12:3", port=gateway.name)
    check(ended.status == PORT and "cannot listen there: Address already in use" in ended.errors, "its port is taken", ended)
    garbage = [b"\0\1\0\0\0\1\1", b"GET / HTTP/1.1\r\n\r\n", bytes(3), b"\xff" * 600, with_crc(bytes([7, 3, 12, 129, 0, 1]))]
    held = []
    for each in garbage:
        line = socket.create_connection(("127.0.0.1", gateway.number))
        line.sendall(each)
        held.append(line)
    ended = tool.run("-u", 7, "read", "RFR", port=gateway.name)
    check(ended.status == DONE, "what other clients send that is no Modbus TCP harms nobody", ended)
    for line in held:
        line.close()


def drives(check, program):
    with Tool(program) as tool:
        # A drive that was asked, and then is not for 10 s, is in fault: the motor's is another one.
        for parts in ((reads_drives, ends_half_way, ends_before_a_stop, shares_its_port), (runs_a_motor,)):
            with Gateway(tool.program, "atv320:7", "atv12:3", "atv28:4") as gateway:
                for part in parts:
                    part(check, tool, gateway)


def main(check, program, part, *words):
    {"others": others, "hostile": hostile, "drives": drives}[part](check, program, *words)


runs(main)
