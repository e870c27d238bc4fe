# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds the applications of bench/size/peers, and prints what they take; peers.sh, which has the checkouts, calls it."""
import pathlib
import subprocess
import sys
import tempfile

import sizes

PEERS = sizes.HERE / "peers"
BUILDS = (("cortex-m0plus", "-Os"), ("cortex-m3", "-O2"))
# What the applications leave out of a peer.
NO_SERVER = ["-DNMBS_SERVER_DISABLED", "-DNMBS_STRERROR_DISABLED"]
NO_CLIENT = ["-DNMBS_CLIENT_DISABLED", "-DNMBS_STRERROR_DISABLED", *(f"-DNMBS_SERVER_{function}_DISABLED" for function in (
    "READ_COILS", "READ_DISCRETE_INPUTS", "READ_INPUT_REGISTERS", "WRITE_SINGLE_COIL", "WRITE_MULTIPLE_COILS", "READ_FILE_RECORD",
    "WRITE_FILE_RECORD", "READ_DEVICE_IDENTIFICATION"))]
RTU_OF_FOUR = ["-DNDEBUG", "-DMB_ASCII_ENABLED=0", "-DMB_FUNC_HANDLERS_MAX=5", *(f"-DMB_FUNC_{function}_ENABLED=0" for function in (
    "OTHER_REP_SLAVEID", "READ_INPUT", "READ_COILS", "WRITE_COIL", "WRITE_MULTIPLE_COILS", "READ_DISCRETE_INPUTS"))]
NANOMODBUS = ("nanoMODBUS/nanomodbus.c",)
FREEMODBUS = tuple(f"freemodbus/modbus/{name}.c" for name in (
    "mb", "rtu/mbrtu", "rtu/mbcrc", "functions/mbfuncholding", "functions/mbutils"))
INCLUDES = ("nanoMODBUS", "freemodbus/modbus/include", "freemodbus/modbus/rtu")

# Title, application, its definitions and a peer's, the peer's sources.
ROWS = (
    ("client asking 03, 06, 16, 23", None, None, ()),
    ("rtuwire, requests constants", "client_rtuwire", ["-DLONGEST_FRAME=256"], ()),
    ("... its line constant, too", "client_rtuwire", ["-DLONGEST_FRAME=256", "-DLINE_IS_CONSTANT"], ()),
    ("... frames of up to 64 bytes", "client_rtuwire", ["-DLONGEST_FRAME=64", "-DLINE_IS_CONSTANT"], ()),
    ("rtuwire, requests encoded when asked", "client_rtuwire", ["-DLONGEST_FRAME=256", "-DENCODES"], ()),
    ("nanoMODBUS", "client_nanomodbus", NO_SERVER, NANOMODBUS),
    ("server of 03, 06, 16, 23", None, None, ()),
    ("rtuwire", "server_rtuwire", [], ()),
    ("... with 08 and 43/14, too", "server_rtuwire", ["-DALL_OF_REGISTERS"], ()),
    ("FreeMODBUS", "server_freemodbus", RTU_OF_FOUR, FREEMODBUS),
    ("nanoMODBUS", "server_nanomodbus", NO_CLIENT, NANOMODBUS),
)


def compiler_of(cpu, level, source):
    compiler, _ = sizes.compiler_for(cpu)
    compiler = [level if word == "-Os" else word for word in compiler]
    if source.suffix != ".c":
        return compiler
    only_cpp = ("-std=c++20", "-fno-rtti", "-fno-threadsafe-statics", "-fno-use-cxa-atexit")
    return ["arm-none-eabi-gcc", "-w", *(word for word in compiler[1:] if word not in only_cpp)]


def measure(checkouts, cpu, level, sources, defines):
    """Text, and the bytes of RAM: static ones, and an object on the stack of `main`."""
    includes = [f"-I{checkouts / name}" for name in INCLUDES] + [f"-I{PEERS}"]
    with tempfile.TemporaryDirectory() as folder:
        objects = []
        for source in (sizes.IMAGES / "start.cpp", *sources):
            objects.append(pathlib.Path(folder, f"{source.stem}.o"))
            subprocess.check_call([*compiler_of(cpu, level, source), *defines, *includes, "-c", "-o", objects[-1], source])
        elf = pathlib.Path(folder, "image.elf")
        compiler, link = sizes.compiler_for(cpu)
        subprocess.check_call([*compiler, *link, "-o", elf, *objects])
        text, data, bss = sizes.sections_of(elf)
        symbols = subprocess.check_output(["arm-none-eabi-nm", "-S", *objects[1:]], text=True)
    on_stack = sum(int(row.split()[1], 16) for row in symbols.splitlines() if row.endswith(" size_of_object"))
    return text + data, data + bss + on_stack


def main(checkouts):
    print(subprocess.check_output(["arm-none-eabi-gcc", "--version"], text=True).partition("\n")[0])
    print("bytes; flash over the board alone; RAM: static and the object, without the stack")
    print(f"{'':42}{'Cortex-M0+ -Os':>16}{'Cortex-M3 -O2':>18}\n{'':42}{'flash':>9}{'RAM':>7}{'flash':>11}{'RAM':>7}")
    empty = [measure(checkouts, *build, [sizes.IMAGES / "empty.cpp"], [])[0] for build in BUILDS]
    for title, name, defines, others in ROWS:
        if name is None:
            print(title)
            continue
        sources = [PEERS / f"{name}.cpp", *(checkouts / other for other in others)]
        (small, small_ram), (fast, fast_ram) = (measure(checkouts, *build, sources, defines) for build in BUILDS)
        print(f"  {title:40}{small - empty[0]:9}{small_ram:7}{fast - empty[1]:11}{fast_ram:7}", flush=True)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
