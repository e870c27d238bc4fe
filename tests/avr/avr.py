# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles the portable headers, and tests that prove at compile time, for a processor whose int has 16 bits.

    python3 avr.py

Clang 19 compiles for AVR; nobody ships a standard library of C++20 for it, so the one of arm-none-eabi lends its
headers, which do not know the processor. Nothing is linked or run.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "support"))
import join  # noqa: E402  pylint: disable=wrong-import-position

COMPILER, LENDER = "clang++-19", "arm-none-eabi-g++"
FLAGS = ["--target=avr", "-mmcu=atmega2560", "-std=c++20", "-fsyntax-only", "-ffreestanding", "-nostdinc",
         "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wshift-count-overflow", "-Werror"]
# Tests whose proofs hold for any size of int. Others compute in int themselves, or need threads.
PROOFS = """core/bytes core/crc16 core/crc16_forms core/hex core/literal core/quantity core/time core/units
 core/version
 trace/capture/pcapng_writer wire/adu wire/functions wire/golden_requests wire/golden_responses wire/response wire/sizes wire/views
 wire/foreign_exchange rtu/framer_place rtu/framer rtu/framer_silence rtu/framer_stream
 table/device table/enumeration table/plans table/snapshot table/write_plan cia402/state cia402/transition
 server/register_bank server/corners server/identification server/respond server/serial_diagnostics server/server
 server/typed_bank ask/access ask/wide_registers table/form/word_orders client/statistics
 altivar/device/layouts""".split()
WRAPS = "static_assert(65535U + 2U > 65535U);\n"


def lent_headers():
    """Where the lender's C++ and C headers are, without those that are its compiler's own."""
    said = subprocess.run([LENDER, "-x", "c++", "-E", "-v", os.devnull], text=True, check=True,
                          capture_output=True).stderr
    block = re.search(r"search starts here:\n(?: .*\n)*.*<\.\.\.> search starts here:\n((?: .*\n)+)", said)[1]
    return [os.path.normpath(line.strip()) for line in block.splitlines() if "/gcc/" not in os.path.normpath(line)]


def compile_one(text, places):
    own = subprocess.run([COMPILER, "-print-resource-dir"], text=True, check=True, capture_output=True).stdout.strip()
    lent = [word for place in (*places, f"{own}/include") for word in ("-isystem", place)]
    done = subprocess.run([COMPILER, *FLAGS, *lent, "-I", PROJECT / "include", "-isystem", PROJECT / "tests/avr", "-I",
                           PROJECT / "tests", "-x", "c++", "-"], input=text, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode == 0, done.stdout


def main():
    include = PROJECT / "include"
    headers = sorted(path.relative_to(include).as_posix() for path in include.rglob("*.hpp")
                     if path.relative_to(include / "rtuwire").parts[0] not in ("port", "port.hpp", "print.hpp"))
    places = lent_headers()
    # An int of 16 bits is what this is about.
    if compile_one(WRAPS, places)[0]:
        print("the target's unsigned int has more than 16 bits: nothing was shown")
        return 1
    # Most in one unit, which includes every header; what can't be joined is one of its own.
    *others, one = join.groups([PROJECT / "tests" / f"{name}.cpp" for name in PROOFS], len(PROOFS))
    headers = "".join(f"#include <{header}>\n" for header in headers)
    units = [headers + join.joined([PROJECT / "tests/symbols/uses_everything.cpp", *one])]
    units += [f'#include "{file}"\n' for group in others for file in group]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        done = list(pool.map(lambda each: compile_one(each, places), units))
    for is_compiled, said in done:
        if not is_compiled:
            print(said)
    failed = sum(not is_compiled for is_compiled, _ in done)
    print(f"{len(headers.splitlines())} headers, {len(PROOFS)} files of proofs: "
          f"{len(done) - failed} of {len(done)} units compile where an int has 16 bits")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
