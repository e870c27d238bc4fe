# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll sends random requests to our server, a process for each: agreement_mbpoll_client.py DEVICE SEED COUNT
FUNCTION...

mbpoll asks for 125 values at most, of bits too. It writes one value with 05 or 06 and several with 15 or 16.
"""
import re
import subprocess
import sys

from agreement import Agreement, Lost

LINE = ["-m", "rtu", "-b", "115200", "-P", "none", "-0", "-1", "-q", "-a", "1", "-o", "1"]
TABLES = {1: "0", 2: "1", 3: "4", 4: "3"}
VALUE = re.compile(r"^\[(\d+)\]:\s+(\d+)", re.MULTILINE)
LONGEST = 123


class Client:
    def __init__(self, device):
        self.device = device

    def poll(self, table, start, *words):
        done = subprocess.run(["mbpoll", *LINE, "-t", table, "-r", str(start), *map(str, words)], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=20, check=False)
        if "timed out" in done.stdout:
            raise Lost
        if done.returncode != 0:
            print("     mbpoll:", done.stdout)
        return done.stdout

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


def main(device, seed, count, *functions):
    test = Agreement(Client(device), {1: 125, 2: 125, 15: LONGEST}, window=1024, seed=int(seed))
    test.run(int(count), list(map(int, functions)))
    return test.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
