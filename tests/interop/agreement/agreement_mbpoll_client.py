# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll sends random requests to our server, a process for each: agreement_mbpoll_client.py DEVICE SEED COUNT
FUNCTION...

mbpoll asks for 125 values at most, of bits too. It writes one value with 05 or 06 and several with 15 or 16. It takes
an identifier (17) for one byte and its run indicator, and shows what follows as text.
"""
import re
import subprocess
import sys

from agreement import Agreement, ID_AT, Lost

LINE = ["-m", "rtu", "-b", "115200", "-P", "none", "-0", "-1", "-q", "-a", "1", "-o", "1"]
TABLES = {1: "0", 2: "1", 3: "4", 4: "3"}
VALUE = re.compile(r"^\[(\d+)\]:\s+(\d+)", re.MULTILINE)
SHOWN = re.compile(r"^(Length|Id|Status|Data) *: (.*)$", re.MULTILINE)
LONGEST = 123


class Client:
    def __init__(self, device):
        self.device = device

    def run(self, *words):
        done = subprocess.run(["mbpoll", *LINE, *map(str, words)], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=60, check=False)
        if "timed out" in done.stdout:
            raise Lost
        if done.returncode != 0:
            print("     mbpoll:", done.stdout)
        return done.stdout

    def poll(self, table, start, *words):
        return self.run("-t", table, "-r", start, *words)

    def server_id(self):
        return dict(SHOWN.findall(self.run("-u", self.device)))

    def read(self, function, start, count):
        seen = VALUE.findall(self.poll(TABLES[function], start, "-c", count, self.device))
        numbers = [int(value) for _, value in seen]
        return numbers if [int(at) for at, _ in seen] == list(range(start, start + count)) else None

    def read_bits(self, function, start, count):
        # The test fills and sweeps by more than mbpoll asks for.
        bits = []
        for at in range(start, start + count, LONGEST):
            bits += self.read(function, at, min(LONGEST, start + count - at)) or []
        return [bit == 1 for bit in bits]

    read_words = read

    def write(self, table, start, values):
        done = self.poll(table, start, self.device, "--", *map(int, values))
        return f"Written {len(values)} reference" in done

    def write_bit(self, at, value):
        return self.write("0", at, [value])

    def write_word(self, at, value):
        return self.write("4", at, [value])

    def write_bits(self, start, bits):
        return all(self.write("0", start + at, bits[at:at + LONGEST]) for at in range(0, len(bits), LONGEST))

    def write_words(self, start, words):
        return self.write("4", start, words)


class MbpollAgreement(Agreement):
    """The function that only mbpoll shows as text."""

    def further(self, function):
        if function != 17:
            return super().further(function)
        number, runs = self.random.randrange(256), self.random.random() < 0.5
        # Letters are shown as they are, and bytes that are none as \XX.
        size = self.random.randrange(1, 119)
        text = self.random.choices((*b"AZaz09", 0x00, 0x0A, 0x1F, 0x80, 0xFF), k=size)
        told = [number, 0xFF if runs else 0, *text]
        self.write_words(ID_AT, [len(told), *(self.random.randrange(256) << 8 | byte for byte in told)])
        shown = "".join(chr(byte) if chr(byte).isalnum() and byte < 0x80 else f"\\{byte:02X}" for byte in text)
        expected = {"Length": str(len(told)), "Id": f"0x{number:02X}", "Status": "On" if runs else "Off", "Data": shown}
        return self.expect(self.ask(self.client.server_id) == expected, "17 tells", expected)


def main(device, seed, count, *functions):
    test = MbpollAgreement(Client(device), {1: 125, 2: 125, 15: LONGEST}, window=1024, seed=int(seed))
    test.run(int(count), list(map(int, functions)))
    return test.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
