# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client without a defect, and clients with one each, as `check --client` starts them; each names the clauses that it breaks.

    python3 -S -E defective_clients.py NAME PORT TIMEOUT [read UNIT ADDRESS COUNT | write UNIT ADDRESS VALUE]...
"""
import os
import select
import socket
import sys
import time
import tty

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "interop"))
from frames import crc, with_crc  # noqa: E402

T35 = 0.0021  # s, at 19200 bit/s
STALE = 0.04  # s of silence that end what is no answer
BROADCAST = 0


class Failed(Exception):
    """No answer, or a refusal."""


class Refused(Failed):
    """An exception of the unit."""


class Client:
    """Without a defect."""

    musts = shoulds = ""
    unasked = ""  # clauses that do not apply then, or cannot be tried
    retries, repeats_writes = 1, False

    def __init__(self, port, timeout):
        if ":" in port:
            host, _, number = port.rpartition(":")
            self.line = socket.create_connection((host, int(number))).detach()
            os.set_blocking(self.line, True)
        else:
            self.line = os.open(port, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(self.line)
        self.timeout, self.buffer, self.heard_at, self.owes = timeout, b"", 0.0, False

    # The line.
    def flush(self):
        while self.read(0):
            pass
        self.buffer = b""

    def read(self, wait):
        ready, _, _ = select.select([self.line], [], [], max(0.0, wait))
        data = os.read(self.line, 512) if ready else b""
        self.heard_at = time.monotonic() if data else self.heard_at
        return data

    def keep_silence(self):
        time.sleep(max(0.0, self.heard_at + T35 - time.monotonic()))

    def absorb(self):
        """What is owed may come until then."""
        if self.owes:
            time.sleep(self.late())
        self.owes = False

    def late(self):
        return 0.4 * self.timeout

    def wait_time(self):
        return self.timeout

    def send(self, frame):
        self.keep_silence()
        self.flush()
        os.write(self.line, frame)

    # An answer.
    def size(self, request):
        return 5 + 2 * request[5] if request[1] == 3 else 8

    def has_right_crc(self, frame):
        return crc(frame) == 0

    def is_from(self, unit, frame):
        return frame[0] == unit

    def is_of_function(self, function, frame):
        return frame[1] == function

    def has_right_count(self, request, frame):
        return frame[2] == 2 * request[5]

    def confirms(self, request, frame):
        return frame == request

    def values(self, request, frame):
        return [int.from_bytes(frame[at:at + 2], "big") for at in range(3, 3 + 2 * request[5], 2)]

    def is_answer(self, request, frame):
        return (len(frame) == self.size(request) and self.is_from(request[0], frame) and self.is_of_function(request[1], frame)
                and self.has_right_crc(frame)
                and (self.has_right_count(request, frame) if request[1] == 3 else self.confirms(request, frame)))

    def is_refusal(self, request, frame):
        return (len(frame) == 5 and self.is_from(request[0], frame) and frame[1] == request[1] | 0x80
                and self.has_right_crc(frame))

    def answer_in(self, request):
        """The answer that the buffer begins with, None for none yet."""
        if self.is_answer(request, self.buffer[:self.size(request)]):
            return self.buffer[:self.size(request)]
        if self.is_refusal(request, self.buffer[:5]):
            raise Refused(f"exception {self.buffer[2]}")
        return None

    def drop_foreign(self, request):
        if len(self.buffer) > 4 and not self.is_from(request[0], self.buffer) and crc(self.buffer) == 0:
            self.buffer = b""

    def stale(self, request):
        """What the buffer holds came to its end, and is no answer."""
        self.buffer = b""

    def wait(self, request):
        end = time.monotonic() + self.wait_time()
        while time.monotonic() < end:
            data = self.read(min(end - time.monotonic(), STALE if self.buffer else 60))
            self.buffer += data
            answer = self.answer_in(request) if self.buffer else None
            if answer is None and not data and self.buffer:
                answer = self.stale(request)
            if answer is not None:
                return answer
            self.drop_foreign(request)
        raise Failed("no answer")

    # Requests.
    def times(self, request):
        return 1 + (self.retries if request[1] == 3 or self.repeats_writes else 0)

    def ask(self, request):
        self.absorb()
        times = self.times(request)
        for turn in range(times):
            self.send(request)
            try:
                answer = self.wait(request)
                self.owes = turn > 0
                return answer
            except Refused:
                if not self.asks_again(request) or turn + 1 == times:
                    raise
            except Failed:
                self.owes = True
                if turn + 1 == times:
                    raise
        return None

    def asks_again(self, request):
        """Behind a refusal."""
        return False

    def request_of(self, kind, unit, address, number):
        return with_crc(bytes([unit, 3 if kind == "read" else 6]) + address.to_bytes(2, "big") + number.to_bytes(2, "big"))

    def obey(self, kind, unit, address, number):
        request = self.request_of(kind, unit, address, number)
        if unit == BROADCAST:
            self.tell_all(request)
            return "ok"
        answer = self.ask(request)
        return "ok" if kind == "write" else " ".join(map(str, self.values(request, answer)))

    def tell_all(self, request):
        self.absorb()
        self.send(request)
        time.sleep(0.1)


# ------------------------------------------------------------------------------------------------------------- what is an answer
class NoCrc(Client):
    """Looks at no CRC."""
    musts = "K20 K21 K29"

    def has_right_crc(self, frame):
        return True


class CrcOfEitherOrder(Client):
    """Takes a CRC with its bytes exchanged."""
    musts = "K21"

    def has_right_crc(self, frame):
        return crc(frame[:-2]) in (int.from_bytes(frame[-2:], "little"), int.from_bytes(frame[-2:], "big"))


class CrcSwitchedOff(Client):
    """Takes FF FF for any CRC, as a unit whose check is switched off sends it."""
    musts = "K21"

    def has_right_crc(self, frame):
        return frame[-2:] == b"\xFF\xFF" or crc(frame) == 0


class HalfCrc(Client):
    """Compares the first byte of the CRC; that of a request and its own CRC's first byte is the second."""
    musts = "K20 K29"

    def has_right_crc(self, frame):
        return crc(frame[:-2]) & 0xFF == frame[-2]


class NoUnit(Client):
    """Does not look who answers."""
    musts, shoulds = "K23", "K50 K51"

    def is_from(self, unit, frame):
        return True


class NoFunction(Client):
    """Does not look which function is answered."""
    musts = "K24"

    def is_of_function(self, function, frame):
        return frame[1] < 0x80


class NoCount(Client):
    """Takes as many registers as come."""
    musts = "K25"

    def size(self, request):
        return super().size(request) if request[1] != 3 else 5 + self.buffer[2] if len(self.buffer) > 2 else 256

    def has_right_count(self, request, frame):
        return True

    def values(self, request, frame):
        return [int.from_bytes(frame[at:at + 2], "big") for at in range(3, len(frame) - 2, 2)]


class BelievesCount(Client):
    """Prints as many values as the byte count says, wherever they stand."""
    musts = "K26"

    def has_right_count(self, request, frame):
        return True

    def values(self, request, frame):
        return [int.from_bytes(frame[at:at + 2], "big") for at in range(3, 3 + frame[2], 2)]


class TakesHalf(Client):
    """What is missing is 0."""
    musts = "K27 K28"

    def stale(self, request):
        frame, self.buffer = self.buffer, b""
        is_begun = (frame[:2] == request[:2] and request[1] == 3 and self.has_right_count(request, frame)
                    and len(frame) < self.size(request))
        return frame.ljust(self.size(request), b"\0") if is_begun else None


class TakesEcho(Client):
    """Takes for an answer what it sent."""
    musts = "K28 K29"

    def answer_in(self, request):
        return request if request[1] == 3 and self.buffer.startswith(request) else super().answer_in(request)


class TakesRefusal(Client):
    """Takes an exception for an answer."""
    musts = "K40 K41"

    def answer_in(self, request):
        try:
            return super().answer_in(request)
        except Refused:
            return self.buffer.ljust(self.size(request), b"\0")


class TakesRefusedWrite(Client):
    """Takes any answer to a write for a confirmation, but a refusal."""
    musts = "K30 K31"

    def confirms(self, request, frame):
        return True


class ConfirmsItself(Client):
    """Takes a write for done that it has sent."""
    musts = "K16 K22 K30 K31 K41"

    def ask(self, request):
        if request[1] == 3:
            return super().ask(request)
        self.send(request)
        return request


# ------------------------------------------------------------------------------------------------------------------------ pieces
class NoPieces(Client):
    """An answer is what one read has."""
    musts, shoulds = "K05", "K06"

    def drop_foreign(self, request):
        if len(self.buffer) < 200:
            self.buffer = b""


class StrictGap(Client):
    """10 ms without a byte end a frame."""
    shoulds = "K06"

    def read(self, wait):
        data = super().read(min(wait, 0.01) if self.buffer else wait)
        if self.buffer and not data:
            self.buffer = b""
        return data


class ShortBuffer(Client):
    """Has room for 128 bytes."""
    musts = "K04"

    def read(self, wait):
        return super().read(wait)[:128 - len(self.buffer)]


class DiesOfNoise(Client):
    """Ends where more comes than fits into a frame."""
    musts = "K73"

    def stale(self, request):
        if len(self.buffer) > 256:
            raise MemoryError("the buffer is full")
        return super().stale(request)


# -------------------------------------------------------------------------------------------------------------------------- time
class NeverRepeats(Client):
    """Gives up at once."""
    shoulds, unasked = "K12", "K62"
    retries = 0


class GivesUpEarly(Client):
    """Waits less than half of what it was told."""
    musts, shoulds, unasked = "K10 K13", "K12", "K62"
    retries = 0

    def wait_time(self):
        return 0.4 * self.timeout

    def late(self):
        return 0.1 * self.timeout


class RepeatsEarly(Client):
    """Sends a read again after less than half of the time-out, and then waits on."""
    musts = "K13"

    def wait(self, request):
        self.is_first = not getattr(self, "is_first", False)
        return super().wait(request)

    def wait_time(self):
        return 0.4 * self.timeout if self.is_first else self.timeout


class WaitsForEver(Client):
    """Has no time-out."""
    musts = "K11"
    unasked = "*"

    def wait_time(self):
        return 3600


class SendsAtOnce(Client):
    """Keeps no silence before a request."""
    musts = "K63"

    def keep_silence(self):
        pass


class TakesLate(Client):
    """Asks the next question at once when it has given up."""
    musts = "K60 K62"

    def absorb(self):
        pass


class KeepsGhost(Client):
    """Waits for what is owed when it has given up, and not behind an answer to a repetition."""
    musts = "K62"

    def ask(self, request):
        answer = super().ask(request)
        self.owes = False
        return answer


class KeepsInput(Client):
    """Does not drop what came before it asked."""
    musts = "K60 K61 K62"

    def flush(self):
        pass

    def answer_in(self, request):
        try:
            answer = super().answer_in(request)
        except Refused:
            self.buffer = self.buffer[5:]
            raise
        self.buffer = self.buffer[len(answer):] if answer else self.buffer
        return answer


class LeavesTheWait(Client):
    """Ends its wait by a frame of another unit."""
    shoulds = "K50 K51"

    def drop_foreign(self, request):
        if len(self.buffer) > 4 and self.buffer[0] != request[0] and crc(self.buffer) == 0:
            raise Refused("of another unit")


class OutOfStep(Client):
    """Behind a question without an answer it asks nothing more."""
    musts, unasked = "K70 K71 K72 K73", "K60"
    is_lost = False

    def ask(self, request):
        if self.is_lost:
            raise Failed("lost")
        try:
            return super().ask(request)
        except Refused:
            raise
        except Failed:
            self.is_lost = True
            raise


# -------------------------------------------------------------------------------------------------------------------- repetitions
class EndsAtFailure(Client):
    """Is ended by its first error."""
    musts = "K70"
    unasked = "K60 K71 K72 K73 K74"

    def ask(self, request):
        try:
            return super().ask(request)
        except Failed as why:
            raise SystemExit(f"traceback: {why}") from why


class RepeatsRefused(Client):
    """Asks again for what is not there."""
    shoulds = "K42"

    def asks_again(self, request):
        return request[1] == 3


class RepeatsRefusedWrites(Client):
    """Writes again what the unit failed at, or does already."""
    shoulds, repeats_writes = "K43", True

    def asks_again(self, request):
        return request[1] == 6


class WaitsForAll(Client):
    """Waits for an answer of everybody."""
    shoulds = "K80"

    def tell_all(self, request):
        self.ask(request)


class RepeatsToAll(Client):
    """Tells all units twice, to be sure."""
    shoulds = "K81"

    def tell_all(self, request):
        super().tell_all(request)
        super().tell_all(request)


class NoTurnaround(Client):
    """Asks right behind a broadcast."""
    shoulds = "K82"

    def tell_all(self, request):
        self.send(request)


def main(name, port, timeout, *requests):
    client = globals()[name](port, int(timeout) / 1000)
    for at in range(0, len(requests), 4):
        try:
            print(client.obey(requests[at], *map(int, requests[at + 1:at + 4])), flush=True)
        except Failed as why:
            print("error:", why, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
