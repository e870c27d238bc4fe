# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The tool runs and stops the motor of a simulated drive in another process, which tells what the motor does.

    python3 motion.py TOOL moments [COUNT]    kills the tool in so many moments of `start`, by each signal
    python3 motion.py TOOL ways               the other ways out, each on a drive of its own, all at once
    python3 motion.py TOOL orders             what is refused; `stop` and `reset`
    python3 motion.py TOOL settings           what is written to a drive whose motor runs, or stands
"""
import concurrent.futures
import json
import os
import pathlib
import re
import select
import signal
import subprocess
import tempfile
import threading
import time

from support import DRIVES, LIMIT, CountedLine, Line, Tool, own_group, own_terminal, runs, soon

from controller import DISABLED, RUNS, TTO, UNIT, Drive, Registers, closing, full_pipe  # noqa: I100
from frames import are_frames

AT_ONCE = 12  # simulated drives, each with its own process
QUICK = 15  # TTO of a drive that has to stop by itself, in 0.1 s
SIGNALS = ("INT", "TERM", "HUP", "PIPE", "KILL")
SPEED = 40  # in Hz
START = ("--allow-run", "start", "--frequency", f"{SPEED}Hz")
LSP = 3105
UNFOLLOWED = 30  # in seconds, in which the motor gets no slower
ONE_PRESS = 1  # in seconds, as long as several Ctrl-C are one


class Motor(Drive):
    """A drive with short ramps, in 0.1 s; with a longer one to its stop, where that has to be seen."""

    def __init__(self, program, name="atv320", tto=None, ramp=5):
        super().__init__(program, name)
        self.at, self.tto, self.ramp = Registers(name), tto, ramp
        # Half of what the program may keep its drive waiting: a machine that is busy is no lost line.
        self.timeout = min(1, (tto or TTO) / 60)

    def __enter__(self):
        super().__enter__()
        self.write(self.at.acc, 5)
        self.write(self.at.dec, self.ramp)
        if self.tto and self.at.tto:
            self.write(self.at.tto, self.tto)
        return self

    def write(self, address, word):
        self.simulator.suffer(f"{UNIT} write {address} {word}")

    def suffer(self, what):
        self.simulator.suffer(f"{UNIT} {what}")

    def how(self):
        return ["--unit", str(UNIT), "--no-listen", "--timeout", str(self.timeout), "--retries", "0"]

    def tool(self, program, *words, device=None, **how):
        how = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE,
               "preexec_fn": own_group, **how}
        self.controllers.append(subprocess.Popen([program, "--port", device or self.device, *self.how(), *words], **how))
        return self.controllers[-1]

    def start(self, program, *words, **how):
        return self.tool(program, *START, *words, **how)

    def start_on_terminal(self, tool, *words, port=None, keys=()):
        return tool.on_terminal(*self.how(), *START, *words, port=port or self.device, keys=keys)

    def runs_by_another(self, hertz=SPEED):
        """Another program runs it; whether it does."""
        for word in (6, 7, 15):
            self.write(self.at.cmd, word)
        self.write(self.at.lfr, 10 * hertz)
        return soon(lambda: self.shown()[:2] == (RUNS, hertz))

    def reaches(self, hertz):
        return soon(lambda: self.shown()[1] == hertz)

    def has_stopped(self):
        state, frequency, _ = self.shown()
        return state != RUNS and frequency == 0


def at_once(one, cases):
    """Each case on a drive of its own."""
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        return list(pool.map(one, cases))


def end(process, limit=LIMIT):
    """Its status, its output and its error output, once it is gone."""
    try:
        out, error = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return "it does not end", "", ""
    return process.returncode, (out or b"").decode(), (error or b"").decode()


# Moments.

def requests_of(program, drive):
    """How many a whole `start --for 1s` makes, when nobody ends it."""
    with Motor(program, drive) as motor, CountedLine(motor.device) as line:
        end(motor.start(program, "--for", "1s", device=line.name))
        return line.requests


def kill_at(program, drive, name, number):
    """Whether it turned when the n-th request was on its way; what is wrong, or nothing. On a busy machine fewer are made
    in that second: then it has ended by itself."""
    is_killed = name == "KILL"
    turned = []
    has_begun = threading.Event()

    def kill():
        has_begun.wait()
        turned.append(motor.turns())
        process.send_signal(getattr(signal, "SIG" + name))

    with Motor(program, drive, tto=QUICK if is_killed else None) as motor, \
            CountedLine(motor.device, number, kill) as line:
        process = motor.start(program, "--for", "1s", device=line.name)
        has_begun.set()
        status, _, text = end(process)
        if status == "it does not end":
            return any(turned), status
        if is_killed:
            # Without its time-out it would turn for ever; how long that is, tests in virtual time tell.
            return any(turned), None if soon(motor.has_stopped, LIMIT) else f"turns on: {motor.shown()}"
        return any(turned), None if motor.stands() else f"{motor.shown()}, status {status}, {text}"


def moments(program, check, count=20):
    """The motor stops, whenever it comes; by KILL within the drive's time-out."""
    whole = {drive: requests_of(program, drive) for drive in ("atv320", "atv28")}
    runs = []
    for name in SIGNALS:
        for i in range(count):
            drive = list(whole)[i % 2] if name != "KILL" else "atv320" if i % 10 else "atv28"
            runs.append((drive, name, 1 + whole[drive] * i // count))
    ends = at_once(lambda run: kill_at(program, *run), runs)
    for name in SIGNALS:
        of_one = [(run, found) for run, found in zip(runs, ends) if run[1] == name]
        wrong = [(run, found[1]) for run, found in of_one if found[1]]
        check(not wrong, f"{name}: the motor stops in each of {len(of_one)} moments", wrong[:3])
    turned = sum(found[0] for found in ends)
    check(turned > len(ends) / 8, "it turned in many of them", f"{turned} of {len(ends)}, of {whole} requests")


# Ways out.

def ends_with(process, motor, check, what, status, says, stands=True):
    found, out, error = end(process)
    check(found == status, f"{what}: its status", (found, error))
    check(says in error, f"{what}: it says why", error)
    check(motor.stands() if stands else motor.has_stopped(), f"{what}: the motor stands", motor.shown())
    return out


def turning(motor, program, check, what, **how):
    """A start, once its motor turns."""
    process = motor.start(program, **how)
    check(soon(motor.turns), f"{what}: it turns")
    return process


def by_its_time(motor, program, check):
    process = motor.start(program, "--for", "0.5s", "--json")
    out = ends_with(process, motor, check, "--for", 0, "the time is over; the motor stands")
    lines = [json.loads(line) for line in out.splitlines()]
    check(lines[-1]["frequency"] == 0 and any(line["state"] == RUNS for line in lines), "--for: objects", lines)


def by_speed(motor, program, check):
    process = motor.tool(program, "--allow-run", "start", "--speed", "1200rpm", "--reverse")
    check(motor.reaches(-SPEED), "--speed: it runs so fast, and in reverse", motor.shown())
    process.send_signal(signal.SIGTERM)
    ends_with(process, motor, check, "--speed", 0, "the motor stands")


def by_fault(motor, program, check):
    process = turning(motor, program, check, "fault")
    motor.suffer("fault")
    ends_with(process, motor, check, "fault", 1, "the drive is in fault; fault: OCF", stands=False)


def by_lost_line(motor, program, check):
    process = turning(motor, program, check, "lost line")
    _, _, error = end(motor.tool(program, "stop"))
    check(f"held by rtuwire (process {process.pid}): two programs cannot share a port; end that first (Ctrl-C" in error, "who holds the line is told", error)
    motor.suffer("cut")
    found, _, error = end(process)
    check(found == 3 and "the link is lost" in error and re.search(r"own time-out of \d+\.\d s is over; `.* stop`", error),
          "lost line: it says so, and when the drive stops", (found, error))
    check(soon(motor.has_stopped, LIMIT), "lost line: the drive stops by itself", motor.shown())


def by_deaf_line(motor, program, check):
    """Its answers get lost: the drive hears the words that stop it."""
    process = turning(motor, program, check, "answers lost")
    motor.suffer("mute")
    found, _, error = end(process)
    check(found == 3, "answers lost: its status", (found, error))
    check(motor.has_stopped(), "answers lost: the motor was stopped", motor.shown())


def by_another_master(motor, program, check):
    process = turning(motor, program, check, "another master")
    soon(lambda: motor.write(8502, 100) or process.poll() is not None)
    ends_with(process, motor, check, "another master", 1, "another master commands the drive")


def by_a_word_of_another_master(motor, program, check):
    """It takes the motor's power away, and the drive's state is all that is read of it; between the two halves of an exchange
    one such word is overwritten unseen."""
    process = turning(motor, program, check, "a word of another master")

    def falls_back():
        motor.write(8501, 6)
        soon(lambda: process.poll() is not None or motor.shown()[0] == "operation enabled")
        return process.poll() is not None
    soon(falls_back)
    ends_with(process, motor, check, "a word of another master", 1, "another master")


def by_local(motor, program, check):
    process = turning(motor, program, check, "local control")
    motor.suffer("local")
    found, _, error = end(process)
    check(found == 1 and "local control" in error, "local control: it says so", (found, error))


def by_two_interrupts(motor, program, check):
    process = motor.start(program)
    check(motor.reaches(SPEED), "twice Ctrl-C: it turns")
    process.send_signal(signal.SIGINT)
    # By its ramp of 5 Hz a second, more than a second after the first.
    check(soon(lambda: motor.shown()[1] < 34) and motor.shown()[1] > 0, "twice Ctrl-C: it is on its ramp", motor.shown())
    process.send_signal(signal.SIGINT)
    found, out, error = end(process)
    check(found in (0, 1) and "power" in error or "stands" in error, "twice Ctrl-C: its status", (found, error))
    check("Ctrl-C again takes its power away: it coasts" in out, "twice Ctrl-C: it is told before", out)
    check(motor.has_no_power(), "twice Ctrl-C: the motor has no power", motor.shown())


def held(motor, process, line):
    """Ctrl-C again and again for 0.4 s of the motor's ramp; how long it took until the program has looked at the last."""
    began = time.monotonic()
    while motor.shown()[1] > SPEED - 2:
        process.send_signal(signal.SIGINT)
    seen = line.requests
    soon(lambda: line.requests > seen + 2 or process.poll() is not None)
    return time.monotonic() - began


def by_a_held_interrupt(motor, program, check):
    """A key that is held repeats itself: that is one Ctrl-C. What a busy machine draws out past its second is tried again."""
    for _ in range(10):
        with CountedLine(motor.device) as line:
            process = motor.start(program, device=line.name)
            check(motor.reaches(SPEED), "held Ctrl-C: it turns")
            took = held(motor, process, line)
            soon(lambda: motor.shown()[1] < 20)
            slows = motor.shown()[1] > 0
            status, _, error = end(process)
        if took < ONE_PRESS:
            break
    check(slows and status == 0 and "the motor stands" in error, "held Ctrl-C: it stops by its ramp", (took, status, error))
    check(motor.stands(), "held Ctrl-C: the motor stands", motor.shown())


def by_suspension(motor, program, check):
    process = turning(motor, program, check, "TSTP")
    process.send_signal(signal.SIGTSTP)
    _, status = os.waitpid(process.pid, os.WUNTRACED)
    check(os.WIFSTOPPED(status) and motor.stands(), "TSTP: the motor stands before it is suspended", motor.shown())
    process.send_signal(signal.SIGCONT)
    ends_with(process, motor, check, "TSTP", 1, "the motor stands")


def by_stop(motor, program, check, what="STOP, CONT", ignored=()):
    process = turning(motor, program, check, what, preexec_fn=lambda: own_group(*ignored))
    process.send_signal(signal.SIGSTOP)
    os.waitpid(process.pid, os.WUNTRACED)
    time.sleep(motor.tto / 30 + 0.3)  # more than a third of its time-out
    process.send_signal(signal.SIGCONT)
    ends_with(process, motor, check, what, 1, "the order to run is gone; the motor stands")


def by_a_long_stop(motor, program, check):
    """The drive trips meanwhile: no row says that it runs."""
    process = turning(motor, program, check, "a long STOP")
    process.send_signal(signal.SIGSTOP)
    os.waitpid(process.pid, os.WUNTRACED)
    check(soon(motor.has_stopped, LIMIT), "a long STOP: the drive trips", motor.shown())
    process.send_signal(signal.SIGCONT)
    out = ends_with(process, motor, check, "a long STOP", 1, "the order to run is gone; fault: SLF", stands=False)
    rows = [re.split(r"  +", row.strip())[:2] for row in out.splitlines()[1:]]
    behind = [state for seconds, state in rows if float(seconds) > QUICK / 10]
    check(behind and "operation enabled" not in behind, "a long STOP: nothing old is shown as if it were now", out)


def by_a_stop_on_the_ramp(motor, program, check):
    """Nobody looked meanwhile whether the motor follows."""
    process = turning(motor, program, check, "STOP on the ramp")
    check(motor.reaches(SPEED), "STOP on the ramp: it is fast", motor.shown())
    process.send_signal(signal.SIGINT)
    check(soon(lambda: motor.shown()[1] < SPEED), "STOP on the ramp: it slows down", motor.shown())
    process.send_signal(signal.SIGSTOP)
    os.waitpid(process.pid, os.WUNTRACED)
    time.sleep(UNFOLLOWED + 1)
    process.send_signal(signal.SIGCONT)
    ends_with(process, motor, check, "STOP on the ramp", 1, "ended: Interrupt; fault: SLF", stands=False)


def by_sleep(motor, program, check):
    by_stop(motor, program, check, "asleep", [signal.SIGCONT])


def by_abort(motor, program, check):
    process = turning(motor, program, check, "ABRT")
    process.send_signal(signal.SIGABRT)
    found, _, _ = end(process)
    check(found == -signal.SIGABRT and motor.has_no_power(), "ABRT: no power, and the signal ends it", motor.shown())


def by_a_full_disk(motor, program, check):
    with open("/dev/full", "wb") as out:
        process = motor.start(program, stdout=out)
        found, _, error = end(process)
    check(found == 4 and "No space left on device; the motor is not started" in error, "full disk: it says so", (found, error))
    check(motor.stands(), "full disk: the motor stands", motor.shown())


def by_its_reader(motor, program, check):
    head = subprocess.Popen(["head", "-n", "3"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    process = motor.start(program, stdout=head.stdin)
    head.stdin.close()
    ends_with(process, motor, check, "head", 4, "Broken pipe; the motor stands")
    head.wait()


def behind_a_full_pipe(motor, program, check):
    reader, writer = full_pipe()
    process = motor.start(program, stdout=writer)
    check(motor.reaches(SPEED), "full pipe: it turns", motor.shown())
    process.send_signal(signal.SIGTERM)
    ends_with(process, motor, check, "full pipe", 0, "the motor stands")
    os.close(reader)
    os.close(writer)


def by_its_terminal(motor, program, check):
    near, far = os.openpty()
    process = motor.start(program, stdout=far, stderr=far, preexec_fn=own_terminal(far))
    os.close(far)
    check(soon(motor.turns), "terminal: it turns")
    os.close(near)
    found, _, _ = end(process)
    check(found == 128 + signal.SIGHUP, "terminal: a shell is told that it was closed", found)
    check(motor.stands(), "terminal: the motor stands when it is closed", motor.shown())


def by_its_terminal_behind_nohup(motor, program, check):
    near, far = os.openpty()
    process = turning(motor, program, check, "nohup", preexec_fn=own_terminal(far, signal.SIGHUP))
    os.close(far)
    os.close(near)
    ends_with(process, motor, check, "nohup", 1, "or its terminal was closed: the order to run is gone; the motor stands")


def by_signals(motor, program, check):
    """INT and TERM are how it is meant to end; of any other a shell is told."""
    for name, status in (("INT", 0), ("TERM", 0), ("HUP", 129), ("USR1", 138), ("XCPU", 152)):
        process = turning(motor, program, check, name)
        process.send_signal(getattr(signal, "SIG" + name))
        ends_with(process, motor, check, name, status, "the motor stands")


def with_nothing_open(motor, program, check):
    with Line(motor.device) as line:
        process = motor.start(program, device=line.name, stdin=None, stdout=None, stderr=None, preexec_fn=closing((0, 1, 2)))
        found, _, _ = end(process)
        check(found == 4, "closed descriptors: nobody would see the motor", found)
        check(line.heard and are_frames(line.heard), "closed descriptors: nothing but frames", line.heard[:24])
    check(motor.stands(), "closed descriptors: the motor stands", motor.shown())


WAYS = (by_its_time, by_speed, by_fault, by_lost_line, by_deaf_line, by_another_master, by_a_word_of_another_master, by_local, by_two_interrupts,
        by_a_held_interrupt, by_signals, by_suspension, by_stop, by_a_long_stop, by_a_stop_on_the_ramp, by_sleep, by_abort, by_a_full_disk,
        by_its_reader, behind_a_full_pipe, by_its_terminal, by_its_terminal_behind_nohup, with_nothing_open)
TIMES = {by_lost_line: 60, by_deaf_line: 300, by_stop: 60, by_sleep: 60, by_a_long_stop: QUICK, by_a_stop_on_the_ramp: 60}
RAMPS = {by_two_interrupts: 100, by_a_held_interrupt: 100, by_a_stop_on_the_ramp: 500}


def ways(program, check):
    def one(way):
        with Motor(program, tto=TIMES.get(way), ramp=RAMPS.get(way, 5)) as motor:
            try:
                way(motor, program, check)
            except Exception as error:  # pylint: disable=broad-except
                check(False, way.__name__, repr(error))

    at_once(one, WAYS)


# Orders.

def refused(program, check):
    with Motor(program) as motor, Line(motor.device) as line:
        def asks(what, status, says, *words):
            found, _, error = end(motor.tool(program, *words, device=line.name))
            check(found == status and says in error, f"{what} is refused", (found, error))

        start = ("start", "--frequency")
        asks("start without --allow-run", 5, "--allow-run", *start, "40Hz")
        asks("no frequency", 2, "how fast?", "--allow-run", "start")
        asks("a wrong unit", 2, "in Hz", "--allow-run", *start, "40m")
        asks("a decimal comma", 2, "a number is written with a point: 1.3, not 1,3", "--allow-run", *start, "40,5Hz")
        asks("a speed as a frequency", 2, "--speed takes rpm; --frequency takes Hz, kHz, mHz, not rpm", "--allow-run", *start, "900rpm")
        asks("a frequency as a speed", 2, "--frequency takes Hz; --speed takes rpm, not Hz", "--allow-run", "start", "--speed", "40Hz")
        asks("two directions", 2, "say the direction once", "--allow-run", "start", "--frequency=-40Hz", "--reverse")
        asks("reset without --write", 5, "--write", "reset")
        check(not line.heard, "nothing was sent for that", line.heard)
        asks("above HSP", 2, "50.0 Hz (HSP)", "--allow-run", *start, "50.1Hz")
        asks("a speed above HSP", 2, "50.0 Hz (HSP)", "--allow-run", "start", "--speed", "1600rpm")
        asks("a speed a third of a step above HSP", 2, "(50.1 Hz): the drive is set to run from 0.0 Hz (LSP) to 50.0 Hz (HSP)",
             "--allow-run", "start", "--speed", "1501rpm")
        asks("a speed that no register takes", 2, "99999rpm: the drive is set to run from", "--allow-run", "start", "--speed", "99999rpm")
        asks("half a step", 2, "steps of 0.1 Hz", "--allow-run", *start, "40.05Hz")
        motor.write(LSP, 100)
        asks("below LSP", 2, "10.0 Hz (LSP)", "--allow-run", *start, "9.9Hz")
        motor.write(7010, 0)
        asks("an unsupervised drive", 5, "does not watch its link (SLL", "--allow-run", *start, "40Hz")
        frames = are_frames(line.heard)
        check(frames and motor.stands(), "and nothing moved", motor.shown())
        check(bytes([UNIT, 6, 8501 >> 8, 8501 & 255, 0, 15]) not in line.heard, "nothing was enabled")


def asked(program, check):
    """What is found before "run? (y/n)" may be over when somebody answers."""
    cmd, hsp = 8501, 3104
    cases = [("another program runs the motor", lambda motor: motor.runs_by_another(0), 5, "somebody else"),
             ("it falls into a fault", lambda motor: motor.suffer("fault"), 1, "in fault: OCF"),
             ("somebody takes it", lambda motor: motor.suffer("local"), 5, "in local control; its keypad or its terminals command it"),
             ("HSP is lowered", lambda motor: motor.write(hsp, 300), 2, "30.0 Hz (HSP)"),
             ("nothing happens", lambda motor: None, 0, "the motor stands")]
    with Tool(program) as tool:
        for what, happens, status, says in cases:
            with Motor(program) as motor, Line(motor.device) as line:
                def answer():
                    happens(motor)
                    return "y\n"

                ended = motor.start_on_terminal(tool, "--for", "1s", port=line.name, keys=[("(y/n)", answer)])
                check(ended.status == status and says in ended.output, f"defect: D24 behind the question {what}", ended)
                enabled = bytes([UNIT, 6, cmd >> 8, cmd & 255, 0, 15]) in line.heard or bytes([UNIT, 16, cmd >> 8, cmd & 255]) in line.heard
                check(enabled == (status == 0), f"behind the question {what}: whether it sends a word to run", enabled)


def not_asked(program, check):
    """Nobody is asked whether a motor shall run that cannot."""
    with Tool(program) as tool, Motor(program) as motor:
        motor.suffer("fault")
        ended = motor.start_on_terminal(tool, keys=[("(y/n)", "n\n")])
        check(ended.status == 1 and "in fault: OCF" in ended.output and "(y/n)" not in ended.output, "a fault: nobody is asked", ended)


def answered(program, check):
    """What starts the motor is an answer to the question, and to nothing else."""
    cases = [("typed before the question", [("", "y\n"), ("(y/n)", "n\n")], 5, "the motor is not started"),
             ("begun before the question", [("", "y"), ("(y/n)", "\n")], 5, "the motor is not started"),
             *((line, [("(y/n)", line + "\n")], 5, "the motor is not started")
               for line in ("y20Hz", "y 20Hz", "yy", "yesterday=1", "y; echo", "no, yes", "n", "", "j", "y" * 300)),
             *((line, [("(y/n)", line + "\n")], 0, "the motor stands") for line in ("y", "Y", "yes", "Yes")),
             ("y and an order in one paste", [("(y/n)", "y\n20Hz\n")], 0, "the motor stands")]
    typed_ahead = ("20Hz typed before a start with -y", [("", "20Hz\n")], 0, "the motor stands")

    def one(case):
        what, keys, status, says = case
        with Tool(program) as tool, Motor(program) as motor:
            ended = motor.start_on_terminal(tool, "--for", "0.5s", *(["-y"] if case is typed_ahead else []), keys=keys)
            check(ended.status == status and says in ended.output, f"the answer {what}", ended)
            check("goes to" not in ended.output and "stays at" not in ended.output, f"the answer {what}: it is no order", ended)
            check((RUNS in ended.output) == (status == 0), f"the answer {what}: whether it runs", ended)

    at_once(one, [*cases, typed_ahead])


def as_another_drive(program, check):
    """What was never read is not told."""
    with Motor(program, "atv12") as motor:
        found, _, error = end(motor.tool(program, "--drive", "atv320", "--allow-run", "start", "--frequency", "5Hz"))
        check(found == 5 and "no known value of ATR, register 7122: this drive may have no such register, and --drive atv320 may be wrong"
              in error, "a register that the drive does not have", (found, error))


def keeps_its_sign(program, check):
    """An ATV28 tells its frequency without a sign: what is shown of a motor in reverse is below zero to the end."""
    def one(_):
        with Tool(program) as tool, Motor(program, "atv28", ramp=10) as motor:
            ended = motor.start_on_terminal(tool, "-y", "--reverse", "--for", "0.5s")
            shown = [float(each) for each in re.findall(r"(-?\d+\.\d) Hz  ", ended.output)]
            check(min(shown, default=0) < -1 and max(shown, default=1) <= 0, "a motor in reverse is shown so to its end", shown)

    at_once(one, range(8))


def left_for_the_shell(program, check):
    """What is typed behind a no is no command for the shell either."""
    with Motor(program) as motor:
        near, far = os.openpty()
        process = motor.start(program, stdin=far, stdout=far, stderr=far)
        text = b""
        while b"(y/n)" not in text and select.select([near], [], [], LIMIT)[0]:
            text += os.read(near, 4096)
        os.write(near, b"no, echo HERE\necho THERE\n")
        process.wait(LIMIT)
        check(process.returncode == 5, "a no is a no", (process.returncode, text))
        check(not select.select([far], [], [], 0)[0], "nothing of the answer is left for the shell")
        os.close(near)
        os.close(far)


def typed(program, check):
    """A line that is typed while it runs changes its speed, or is refused with the reason."""
    def speed_is(hertz, then):
        def key():
            check(motor.reaches(hertz), f"it turns at {hertz} Hz", motor.shown())
            return then or tool.interrupt()

        return key

    keys = [("operation enabled", speed_is(40, "30Hz\n")), ("goes to 30.0 Hz", speed_is(30, "99999Hz\n")),
            ("99999Hz: above HSP, which is no more than", speed_is(30, "50.1\n")),
            ("highest frequency, HSP, 50.0 Hz: stays at 30.0 Hz", speed_is(30, "9rpm\n")),
            ("9rpm: it was ordered, and is changed, in Hz, kHz, mHz, not rpm: stays", speed_is(30, "22,5Hz\n")),
            ("1.3, not 1,3: stays", speed_is(30, "30.05\n")), ("steps of 0.1 Hz: stays", speed_is(30, "\n-20\n")),
            ("to turn it the other way: stays at 30.0 Hz; Ctrl-C stops it", speed_is(30, "10Hz\n15Hz\n")),
            ("goes to 15.0 Hz", speed_is(15, ""))]
    slow = [("operation enabled", speed_is(40, "5Hz\n")), ("5.0 Hz is outside of the drive's limits: it turns at LSP, 10.0 Hz", speed_is(10, ""))]
    reverse = [("operation enabled", speed_is(-40, "25Hz\n")), ("goes to 25.0 Hz, reverse", speed_is(-25, "0Hz\n")),
               ("goes to 0.0 Hz, reverse (0 has no direction: to keep this one it turns on", speed_is(-0.1, ""))]
    with Tool(program) as tool, Motor(program) as motor:
        check("on a terminal a line such as" in tool.run("start", "--help").output, "the help says so")
        ended = motor.start_on_terminal(tool, "-y", keys=keys)
        check(ended.status == 0 and all(text in ended.output for text, _ in keys), "what was typed is answered", ended)
        check("a line such as 30Hz changes that" in ended.output, "it says that before", ended)
        check("nothing read yet" in ended.output and "no link" not in ended.output, "before the first read nothing was read", ended)
        back = motor.start_on_terminal(tool, "-y", "--reverse", keys=reverse)
        check(back.status == 0 and all(text in back.output for text, _ in reverse), "it keeps its direction", back)
        motor.write(LSP, 100)
        limited = motor.start_on_terminal(tool, "-y", keys=slow)
        check(limited.status == 0 and all(text in limited.output for text, _ in slow), "that the drive limits it is said", limited)
        motor.write(LSP, 0)
        check(motor.stands(), "it stands at the end", motor.shown())
        script = motor.start(program, stdin=subprocess.PIPE)
        script.stdin.write(b"10Hz\n")
        script.stdin.flush()
        check(motor.reaches(SPEED), "what a script has on its standard input is not for the motor", motor.shown())
        script.terminate()
        end(script)


def stops(program, check):
    def one(case):
        name, words, is_named, state = case
        with Motor(program, name, ramp=30) as motor:  # long enough to be seen on its way
            what = f"stop {' '.join(words)} of {name}{' by its name' if is_named else ''}"
            runs = motor.runs_by_another()
            refusal = end(motor.start(program))
            process = motor.tool(program, *(("--drive", name) if is_named else ()), "stop", *words, "--json")
            seen = [motor.shown()]
            while process.poll() is None:
                seen.append(motor.shown())
            found, out, error = end(process)
            seen.append(motor.shown())  # what it ends in may last no longer than the program
            states = {each[0] for each in seen}
            slower = sum(0 < frequency < SPEED for _, frequency, _ in seen)
            check(runs, f"{what}: another runs it")
            check(refusal[0] == 5 and "somebody else" in refusal[2], f"{what}: a start is refused", refusal)
            says = "has no power, and coasts if it turned" if "--freewheel" in words else "the motor stands"
            check(found == 0 and says in json.loads(out)["outcome"], what, (found, out, error))
            check(motor.stands(), f"{what}: it stands", motor.shown())
            check(state in states, f"{what}: in its way", states)
            check((slower > 0) == ("--freewheel" not in words), f"{what}: with a ramp or without", slower)
            check("a motor that turns coasts" not in out, f"{what}: nothing else was sent", out)

    # The tool has read CHCF before its first word, so that each gets the stop that was asked for.
    cases = [("atv320", (), False, "switched on"), ("atv28", (), False, "switched on"), ("atv12", (), True, "switched on"),
             ("atv320", ("--freewheel",), True, DISABLED), ("atv28", ("--quick",), False, "quick stop active"),
             ("atv310", ("--quick",), True, DISABLED)]
    at_once(one, cases)


def stops_slowly(program, check):
    """Whoever waits for a long ramp sees it go on, and whoever ends the waiting is told what is known."""
    with Tool(program) as tool, Motor(program, ramp=150) as motor:
        check(motor.runs_by_another(), "another runs it")
        ended = tool.on_terminal(*motor.how(), "stop", port=motor.device, keys=[("waits", tool.interrupt)])
        check(re.search(r"told to stop, at \d+\.\d Hz; waits", ended.output), "the ramp is shown", ended)
        check(ended.status == -signal.SIGINT and "told to stop, not seen to stand" in ended.output, "Ctrl-C says how far it came", ended)
        check(0 < motor.shown()[1] < SPEED, "the motor goes on slowing", motor.shown())
        found, out, error = end(motor.tool(program, "stop"))
        check(found == 0 and "the motor stands" in out and motor.stands(), "whoever waits sees it stand", (found, out, error))


def by_a_wrong_name(program, check):
    """An ATV320 in its I/O profile, where every word that stops but 0000 is RUN, and drives of another family."""
    lfr, chcf, io_profile = 8502, 8401, 3

    def one(case):
        name, called, words, is_by_file = case
        with Motor(program, "atv320" if name == "io" else name, ramp=30) as motor, \
                tempfile.TemporaryDirectory() as folder:
            what = f"stop {' '.join(words)} of {name} called {called}{' in a file' if is_by_file else ''}"
            if name == "io":
                motor.write(chcf, io_profile)
                motor.write(lfr, 10 * SPEED)
            else:
                motor.runs_by_another()
            config = os.path.join(folder, "rtuwire.toml")
            with open(config, "w", encoding="utf-8") as file:
                file.write(f'name = ["motor={UNIT}:{called}"]\n')
            named = ("--config", config) if is_by_file else ("--drive", called)
            process = motor.tool(program, *named, "--json", "stop", *words)
            has_turned = False
            while process.poll() is None:
                has_turned = has_turned or motor.shown()[1] != 0
            found, out, error = end(process)
            stands = soon(lambda: motor.shown()[1] == 0, LIMIT)
            check(stands, f"{what}: it stands", motor.shown())
            check("coasts" in out, f"{what}: it is said that it coasts", (found, out, error))
            check(name != "io" or not has_turned, f"{what}: it never turns", motor.shown())
            check(name == "io" or found == 0, f"{what}: it was seen to stand", (found, out, error))

    cases = [("io", called, words, is_by_file) for called in ("atv12", "atv310", "atv320")
             for words, is_by_file in (((), False), (("--quick",), True))]
    cases += [("io", "atv310_2026", (), True), ("atv28", "atv12", (), False), ("atv12", "atv28", (), False)]
    at_once(one, cases)


def stops_beside_a_broken_file(program, check):
    """A register file that is wrong, or is none, keeps no stop from a motor."""
    with Motor(program) as motor, tempfile.TemporaryDirectory() as folder:
        motor.runs_by_another()
        config = os.path.join(folder, "rtuwire.toml")
        with open(config, "w", encoding="utf-8") as file:
            file.write(f'name = ["motor={UNIT}:{folder}/nothing.toml"]\n')
        found, out, error = end(motor.tool(program, "--config", config, "--json", "stop"))
        check(found == 0 and soon(lambda: motor.shown()[1] == 0, LIMIT), "a stop beside a broken register file", (found, out, error))


def stops_behind_a_full_pipe(program, check):
    """Nobody reads the error output: the stop goes out all the same."""
    with Motor(program) as motor:
        near, far = full_pipe()
        motor.runs_by_another()
        process = motor.tool(program, "-v", "--json", "stop", stderr=far)
        os.close(far)
        found, out, _ = end(process, 10)
        check(found == 0 and "the motor stands" in out and motor.stands(), "a stop whose error output is full", (found, out, motor.shown()))
        text = os.read(near, 1 << 20)
        os.close(near)
        check(text.strip(b"\0") == b"", "it says nothing there", text[-200:])


def ends_behind_a_full_pipe(program, check):
    """TERM ends a stop that says, behind a full pipe, how far it came; who reads on is told what is missing."""
    with Motor(program, ramp=150) as motor:
        near, far = full_pipe()
        motor.runs_by_another()
        process = motor.tool(program, "-v", "stop", stderr=far)
        check(soon(lambda: motor.shown()[1] < SPEED), "it was told to stop", motor.shown())
        os.read(near, 1 << 20)
        process.send_signal(signal.SIGTERM) if soon(lambda: select.select([near], [], [], 0)[0]) else None
        os.close(far)
        check(end(process, 10)[0] == -signal.SIGTERM, "TERM ends it", motor.shown())
        text = os.read(near, 1 << 20)
        os.close(near)
        check(re.search(rb"the standard error was blocked: \d+ lines were dropped\n", text), "it says what is missing", text[:300])
        near, far = full_pipe()
        process = motor.tool(program, "-v", "stop", stderr=far)
        os.close(far)
        time.sleep(0.5)
        process.send_signal(signal.SIGTERM)
        check(end(process, 10)[0] == -signal.SIGTERM, "TERM ends it while the pipe is full", motor.shown())
        os.close(near)


def stops_without_a_trace(program, check):
    """No file that cannot be written keeps a stop from a motor."""
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        os.mkfifo(place / "fifo")
        (place / "kept").write_text("a register file")
        traces = (place / "none" / "x", "/dev/full", place / "fifo", place, place / "kept", "/proc/x")

        def one(trace):
            with Motor(program) as motor:
                motor.runs_by_another()
                found, out, error = end(motor.tool(program, "--trace", str(trace), "--json", "stop"), 10)
                check(found == 0 and motor.stands(), f"a stop with --trace {trace}", (found, out, error))
                check(f"--trace {trace}" in error and "there is no trace" in error, f"no trace {trace} is told", error)

        at_once(one, traces)
        check((place / "kept").read_text() == "a register file", "what was there is kept", os.listdir(folder))


def shows_what_runs_a_motor(program, check):
    """-v and --trace have the frames that run it, watch it and stop it, as the line had them."""
    with Motor(program) as motor, CountedLine(motor.device) as line, tempfile.TemporaryDirectory() as folder:
        trace = os.path.join(folder, "start.pcapng")
        found, out, error = end(motor.start(program, "-v", "--trace", trace, "--for", "1s", device=line.name))
        shown = error.count("  > ")
        check(found == 0 and shown == line.requests, f"-v shows each of {line.requests} requests", (found, shown))
        replayed = subprocess.run([program, "--json", "replay", trace], capture_output=True, text=True, check=False).stdout
        kept = [json.loads(each) for each in replayed.splitlines()]
        check(sum(each.get("role") == "request" for each in kept) == shown, "--trace keeps as many", (len(kept), replayed[-500:]))


def shows_its_current(program, check):
    """12 steps of 0.1 A are 1.2 A, and not the nearest product of doubles."""
    with Motor(program) as motor:
        _, out, _ = end(motor.tool(program, "--csv", "--allow-run", "start", "--frequency", "25Hz", "--for", "1.5s"))
        shown = [row.split(",")[2:4] for row in out.splitlines()]
        check(["25", "1.2"] in shown, "a current has the digits of its steps", out)


def resets_and_misses(program, check):
    with Motor(program) as motor, tempfile.TemporaryDirectory() as folder:
        motor.suffer("fault")
        check(soon(lambda: motor.shown()[0] == "fault"), "a fault", motor.shown())
        home = {**os.environ, "XDG_STATE_HOME": folder}
        found, out, _ = end(motor.tool(program, "--json", "--write", "reset", env=home))
        check(found == 1 and "OCF" in out and "still in fault" in out, "a fault whose cause is there", (found, out))
        found, _, error = end(motor.start(program))
        check(found == 1 and "in fault: OCF" in error, "start refuses a drive in fault", (found, error))
        found, out, _ = end(motor.tool(program, "--json", "stop"))
        check(found == 0 and "in fault: OCF" in out, "stop says so", (found, out))
        motor.suffer("clear")
        found, out, _ = end(motor.tool(program, "--json", "--write", "reset", env=home))
        check(found == 0 and "OCF" in out and json.loads(out)["outcome"].startswith("reset"), "reset", (found, out))
        check(motor.shown()[0] == DISABLED, "it is reset", motor.shown())
        motor.suffer("cut")
        motor.timeout = 0.2
        found, out, _ = end(motor.tool(program, "--json", "stop"))
        check(found == 3 and "nothing confirmed it" in out, "stop of a drive that is off, which ends", (found, out))


def orders(program, check):
    for each in (refused, asked, not_asked, answered, left_for_the_shell, keeps_its_sign, as_another_drive, typed, stops,
                 stops_slowly, by_a_wrong_name, stops_beside_a_broken_file, stops_behind_a_full_pipe,
                 ends_behind_a_full_pipe, stops_without_a_trace, shows_what_runs_a_motor, shows_its_current,
                 resets_and_misses):
        each(program, check)


# Settings.

def keeps_speed(program, name, check):
    """A motor that runs keeps its speed and its ramps, and one that is enabled at 0 Hz stays there; a drive without power
    takes all of it."""
    words = ("LSP=10Hz", "HSP=45Hz", "ACC=1s", "DEC=1s", "LSP=5Hz DEC=2s", *(() if "310" in name else ("SP2=20Hz",)))
    with Motor(program, name) as motor, tempfile.TemporaryDirectory() as folder:
        home = {**os.environ, "XDG_STATE_HOME": folder}
        file = pathlib.Path(folder) / "wanted.csv"

        def tool(*words):
            return end(motor.tool(program, "--drive", name, "--json", *words, env=home))

        def held():
            _, out, _ = tool("read", "LSP", "HSP", "ACC", "DEC", "ITH")
            return [json.loads(line)["raw"] for line in out.splitlines()]

        before = held()
        for reference in (0, SPEED):
            check(motor.runs_by_another(reference), f"it runs at {reference} Hz", motor.shown())
            for each in words:
                found, out, error = tool("--write", "write", *each.split())
                is_told = each.split("=", maxsplit=1)[0] in error and RUNS in error and "--allow-run" in error
                check(found == 5 and is_told, f"{each} at {reference} Hz", (found, out, error))
            check(held() == before, "nothing was written", held())
            check(motor.shown()[:2] == (RUNS, reference), f"it still runs at {reference} Hz", motor.shown())
        found, out, error = tool("--write", "write", f"ITH=#{before[4]}")
        check(found == 0, "what moves nothing is written while it runs", (found, out, error))
        file.write_text("register,value\nHSP,45 Hz\n", encoding="utf-8")
        found, out, error = tool("--write", "--allow-run", "-y", "restore", str(file), "--with-inferred")
        check(found == 5 and held() == before, "nothing is restored while it runs", (found, out, error))
        found, out, error = tool("--write", "--allow-run", "write", "LSP=10Hz")
        check(found == 0 and held()[0] == 100, "--allow-run allows it", (found, out, error))
        motor.write(motor.at.cmd, 0)
        check(soon(lambda: motor.shown()[:2] == (DISABLED, 0)), "it stands", motor.shown())
        for each in words:
            found, out, error = tool("--write", "write", *each.split())
            check(found == 0, f"{each} at rest", (found, out, error))


def settings(program, check):
    def one(name):
        keeps_speed(program, name, lambda is_right, what, *details: check(is_right, f"{name}: {what}", *details))

    at_once(one, DRIVES)


def main(check, program, what, *words):
    {"moments": moments, "ways": ways, "orders": orders, "settings": settings}[what](program, check, *map(int, words))


runs(main)
