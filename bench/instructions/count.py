# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Instructions of single operations: on Cortex-M0+ and M3 by an emulator, on this host by callgrind.

    /usr/bin/python3 bench/instructions/count.py            a table, against baseline.json
    /usr/bin/python3 bench/instructions/count.py --update   writes baseline.json anew

Counts are exact and repeatable for the same compiler. Of others, measured the same way with the same
compilers: nanoMODBUS on a Cortex-M3 / M0+, libmodbus on a host.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
FIRMWARE = PROJECT / "examples" / "firmware"
FREE = ["-std=c++20", "-mthumb", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
        "-fno-use-cxa-atexit", "-ffunction-sections", "-fdata-sections", "-nostartfiles",
        "--specs=nano.specs", "--specs=nosys.specs", "-Wl,--gc-sections"]
HEADERS = [f"-I{PROJECT / 'include'}", f"-I{FIRMWARE}", f"-I{HERE}"]
ROUNDS = 1000
BASELINE = HERE / "baseline.json"
# At most, by machine; a sum of operations stands under its own name.
BARS = {
    # From the last byte: to the response that may leave when the line is silent.
    "cortex-m3": {"encode_read + decode_4": 420, "serve_read_4": 450, "serve_exchange_4": 680,
                  "client_read_4": 2780, "client_read_4_whole": 1490, "client_read_63_whole": 4100,
                  "server_read_4_whole": 1150, "server_exchange_4_whole": 1650,
                  "last_byte_read_4": 740, "last_byte_write_4": 520, "last_byte_exchange_4": 805},
    "cortex-m0plus": {"encode_read + decode_4": 620, "serve_read_4": 650, "serve_exchange_4": 1000},
    "host": {"encode_read": 60, "encode_known": 10, "decode_4": 150, "decode_63": 650,
             "serve_read_4": 260, "serve_write_4": 300, "serve_exchange_4": 400,
             "both_ends_4": 1540, "both_ends_63": 3590, "both_ends_125": 5540,
             "serve_read_100_of_1000": 2500,
             # Six for each slot more than a bus of one, and none where the loop asks first.
             "bus_pass_247": 1808, "asking_pass_247": 332},
}
OTHERS = {
    "cortex-m3": {"encode_read + decode_4": 1537, "serve_read_4": 1625, "serve_exchange_4": 2475},
    "cortex-m0plus": {"encode_read + decode_4": 1973, "serve_read_4": 2115,
                      "serve_exchange_4": 3210},
    "host": {"encode_read": 112, "decode_4": 656, "decode_63": 2199, "serve_read_4": 800,
             "serve_write_4": 844, "serve_exchange_4": 993},
}


# Programs of their own: where a compiler sees all, it inlines none as it would alone.
LISTS = ("operations.hpp", "transactions.hpp", "passes.hpp", "tables.hpp")


def on_board(cpu, place, optimise, operations):
    elf = place / "count.elf"
    subprocess.check_call(["arm-none-eabi-g++", *FREE, f"-mcpu={cpu}", optimise, *HEADERS,
                           f'-DRTUWIRE_OPERATIONS="{operations}"',
                           '-DRTUWIRE_BOARD="boards/mps2_an385.hpp"', f"-L{FIRMWARE / 'boards'}",
                           "-T", FIRMWARE / "boards" / "mps2_an385.ld", "-o", elf,
                           FIRMWARE / "startup.cpp", HERE / "count_arm.cpp"])
    told = subprocess.check_output(
        ["qemu-system-arm", "-M", "mps2-an385", "-icount", "shift=0", "-kernel", elf, "-display",
         "none", "-monitor", "none", "-serial", "none", "-serial", "stdio",
         "-semihosting-config", "enable=on,target=native"], stdin=subprocess.DEVNULL, text=True)
    return {name: int(count) for name, count in re.findall(r"(\w+) (\d+)", told)}


def callgrind(program, *words):
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                           program, *words], capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


def on_host(place, operations):
    program = place / "count"
    subprocess.check_call(["g++", "-std=c++20", "-O2", *HEADERS, "-o", program,
                           f'-DRTUWIRE_OPERATIONS="{operations}"', HERE / "count_host.cpp"])
    names = subprocess.check_output([program], text=True).split()
    found = {}
    for number, name in enumerate(names):
        run, less = (callgrind(program, str(number), which) for which in ("run", "less"))
        found[name] = round((run - less) / ROUNDS)
    return found


def show(machine, title, counts, before):
    print(f"{title:26} instructions  baseline   at most    others")
    counts["encode_read + decode_4"] = counts["encode_read"] + counts["decode_4"]
    for size in (4, 63, 125):
        counts[f"both_ends_{size}"] = counts[f"client_read_{size}_whole"] + counts[f"server_read_{size}_whole"]
    for name, count in counts.items():
        bar, other = BARS[machine].get(name), OTHERS[machine].get(name, "")
        verdict = "" if bar is None else "met" if count <= bar else "MISSED"
        print(f"  {name:24}{count:13}{before.get(name, ''):10}{bar or '':10}{other:10}  {verdict}")


def measure():
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        for cpu in ("cortex-m3", "cortex-m0plus"):
            for optimise in ("-Os", "-O2"):
                yield cpu, f"{cpu} {optimise}", {
                    name: count for each in LISTS
                    for name, count in on_board(cpu, place, optimise, each).items()}
        yield "host", "host, g++ -O2", {
            name: count for each in LISTS for name, count in on_host(place, each).items()}


def main(options):
    before = json.loads(BASELINE.read_text(encoding="utf-8")) if BASELINE.exists() else {}
    found = {}
    for machine, title, counts in measure():
        show(machine, title, counts, before.get(title, {}))
        found[title] = counts
    if "--update" in options:
        BASELINE.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
