# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Flash, RAM and stack of small images for Cortex-M0+, M3 and rv32imc, each against an empty firmware; all by GCC.

    /usr/bin/python3 bench/size/sizes.py            a table; fails where a figure grew by over 2 % since reached.json
    /usr/bin/python3 bench/size/sizes.py --update   writes reached.json anew
    /usr/bin/python3 bench/size/sizes.py NAME...    these images alone

baseline.json stays: the bar is how much some images may gain over it.

rv32imc is measured where Debian's gcc-riscv64-unknown-elf is, with the C++ headers of the Arm toolchain and memory.cpp in
the place of a C library. It is linked: before that, each call takes 8 bytes instead of 2 or 4.

Stack is the deepest chain of calls that starts in the library, in the loop's pass over the line or in
what answers a frame or waits for the answer.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
IMAGES = HERE / "images"
INCLUDE = HERE.parent.parent / "include"
BASELINE = HERE / "baseline.json"
REACHED = HERE / "reached.json"
FLAGS = ["-std=c++20", "-Os", "-fno-exceptions", "-fno-rtti", "-ffunction-sections",
         "-fdata-sections", "-fno-threadsafe-statics", "-fno-use-cxa-atexit", f"-I{INCLUDE}"]
LINK = ["-nostartfiles", "--specs=nano.specs", "--specs=nosys.specs", "-Wl,--gc-sections",
        "-T", IMAGES / "image.ld"]
CPUS = ("cortex-m0plus", "cortex-m3")
RISCV = "rv32imc"
RISCV_GCC = "riscv64-unknown-elf-g++"
NAMES = ("server_frames", "server", "server_all", "client_frames", "client_encoding", "client",
         "client_counting", "client_counting_fixed", "client_traced", "typed_read",
         "monitor", "two_conversations", "two_conversations_four", "bus",
         "one_procedure", "two_procedures", "four_procedures", "six_procedures", "text",
         "crc_bitwise", "crc_nibble_table", "crc_byte_table")
# What this library wants to need at most: flash on a Cortex-M0+, RAM of an engine with its frame.
BARS = {"server_frames": 1000, "server_all": 3600, "client_frames": 1250, "text": 500}
STACK_BAR = 160
RAM_BAR = 256 + 64
# How much of flash these may gain over the baseline on a Cortex-M0+.
WATCHED = ("client_frames", "server", "client_counting_fixed")
WATCHED_GROWTH = 0.05
ALLOWED_GROWTH = 0.02
# Functions of the library, and those of the images that call into it: not `main`, which holds the frame.
POLL_PATH = re.compile(r"(^|:)_ZNK?7rtuwire|5board4pass|_16answer|9response_to")

# The steps of procedures are called through a pointer by this function alone, where it was not inlined.
STEP, STEPPER = re.compile(r"procedure_runner\S*4stepERN"), re.compile(r"22procedure_conversation4step\S*5eventE$")


def arm_headers():
    """Where the Arm toolchain has the headers of C++ and C, most of them the same for any 32-bit processor."""
    told = subprocess.run(["arm-none-eabi-g++", "-mthumb", "-mcpu=cortex-m0plus", "-E", "-v", "-x", "c++", "/dev/null"],
                          capture_output=True, text=True, check=True).stderr
    return re.findall(r"^ (/\S*(?:c\+\+\S*|/arm-none-eabi/include))$", told, re.MULTILINE)


def compiler_for(cpu):
    """The command that compiles for a processor; what links with it besides."""
    if cpu != RISCV:
        return ["arm-none-eabi-g++", *FLAGS, "-mthumb", f"-mcpu={cpu}"], LINK
    headers = [word for folder in arm_headers() for word in ("-isystem", folder)]
    return ([RISCV_GCC, *FLAGS, f"-march={RISCV}", "-mabi=ilp32", "-nostdinc++", *headers],
            ["-nostartfiles", "-nostdlib", "-Wl,--gc-sections", "-T", IMAGES / "image.ld", "-fno-builtin",
             "-fno-tree-loop-distribute-patterns", IMAGES / "memory.cpp"])


def build(place, cpu, name):
    elf = place / f"{name}.elf"
    source, _, form = name.partition("_") if name.startswith("crc_") else (name, "", "")
    chosen = [f"-DRTUWIRE_CRC_FORM={form}"] if form else []
    compiler, link = compiler_for(cpu)
    subprocess.check_call([*compiler, *chosen, "-fcallgraph-info=su", "-c", "-o", place / f"{name}.o",
                           IMAGES / f"{source}.cpp"], cwd=place)
    libraries = ["-lgcc"] if cpu == RISCV else []
    subprocess.check_call([*compiler, *link, "-o", elf, IMAGES / "start.cpp", place / f"{name}.o", *libraries], cwd=place)
    return elf


def sections_of(elf):
    text, data, bss = subprocess.check_output(["arm-none-eabi-size", elf], text=True).split()[6:9]
    return int(text), int(data), int(bss)


def taken_in(made):
    """The functions whose addresses an object file has as data: those that a call through a pointer may reach."""
    listing = subprocess.check_output(["arm-none-eabi-readelf", "--relocs", "--wide", made], text=True)
    taken, is_data = set(), False
    for row in listing.splitlines():
        if found := re.match(r"Relocation section '([^']*)'", row):
            is_data = re.match(r"\.rela?\.(rodata|data)", found[1]) is not None
        elif is_data and (found := re.search(r" R_(?:ARM_ABS32|RISCV_32) +\w+ +([\w.]+)", row)):
            taken.add(found[1])
    return taken


def stack_of(graph, taken):
    """The deepest chain in a call graph as GCC writes it; a call through a pointer may reach each function of `taken`."""
    own, calls = {}, {}
    for title, label in re.findall(r'node: \{ title: "([^"]*)" label: "([^"]*)"', graph):
        found = re.search(r"(\d+) bytes", label)
        own[title] = int(found[1]) if found else 0
    for caller, callee in re.findall(r'sourcename: "([^"]*)" targetname: "([^"]*)"', graph):
        calls.setdefault(caller, set()).add(callee)
    reached = {title for title in own if title.rpartition(":")[2] in taken}
    steps = set(filter(STEP.search, reached)) if any(map(STEPPER.search, own)) else set()
    for caller in [caller for caller, called in calls.items() if "__indirect_call" in called]:
        calls[caller] |= reached if STEPPER.search(caller) else reached - steps

    def deepest(title, seen=()):
        if title in seen:
            raise SystemExit(f"sizes.py: {title} calls itself")
        below = [deepest(callee, (*seen, title)) for callee in calls.get(title, ())]
        return own.get(title, 0) + max(below, default=0)

    return max((deepest(title) for title in own if POLL_PATH.search(title)), default=0)


def empty_of(name):
    """Which empty firmware an image is measured against: an engine's loop sleeps, too."""
    is_plain = name.startswith("crc_") or name == "text" or "_frames" in name or "_encoding" in name
    return "empty_frames" if is_plain else "empty"


def measure(cpu, names):
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        empty = {name: sections_of(build(place, cpu, name))[0] for name in ("empty", "empty_frames")}
        rows = {}
        for name in names:
            text, data, bss = sections_of(build(place, cpu, name))
            graph = (place / f"{name}.ci").read_text(encoding="utf-8")
            rows[name] = {"flash": text + data - empty[empty_of(name)], "data": data, "bss": bss,
                          "stack": stack_of(graph, taken_in(place / f"{name}.o"))}
        return rows


def engines():
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder, "engines.o")
        subprocess.check_call(["arm-none-eabi-g++", *FLAGS, "-mthumb", "-mcpu=cortex-m0plus", "-c", "-o", made,
                               IMAGES / "engines.cpp"])
        listing = subprocess.check_output(["arm-none-eabi-nm", "-S", made], text=True)
    return {name: int(size, 16)
            for size, name in re.findall(r"\S+ (\S+) . size_of_(\S+)", listing)}


def verdict(what, figure, bar):
    return f"   {what} at most {bar}: {'met' if figure <= bar else 'MISSED'}"


def over(figure, before):
    return f"{figure - before:+5} ({100 * (figure - before) / before:+5.1f} %)" if before else "  new"


def show(cpu, rows, before):
    print(f"{cpu:23} flash  .data   .bss  stack  flash over the baseline; bytes; stack at most {STACK_BAR}")
    for name, row in rows.items():
        bar = BARS.get(name) if cpu == "cortex-m0plus" else None
        held = "" if bar is None else verdict("flash", row["flash"], bar)
        old = before.get(name, {}).get("flash")
        if cpu == "cortex-m0plus" and name in WATCHED and old:
            held += verdict("over the baseline", row["flash"], int(old * (1 + WATCHED_GROWTH)))
        if row["stack"] > STACK_BAR:
            held += verdict("stack", row["stack"], STACK_BAR)
        print(f"  {name:21}{row['flash']:6}{row['data']:7}{row['bss']:7}{row['stack']:7}"
              f"  {over(row['flash'], before.get(name, {}).get('flash'))}{held}")


def show_engines(sizes):
    print("RAM of one, with its frame of 256")
    for name, size in sizes.items():
        bar = "" if "counting" in name else verdict("RAM", size, RAM_BAR)
        print(f"  {name:21}{size:6}{bar}")


def growths(before, now, path=()):
    """Each figure that grew by more than is allowed."""
    for key, value in now.items():
        old = before.get(key)
        if isinstance(value, dict):
            yield from growths(old or {}, value, (*path, key))
        elif old is not None and value > old * (1 + ALLOWED_GROWTH):
            yield f"{' '.join((*path, key))}: {old} -> {value}"


def main(options):
    cpus = CPUS + ((RISCV,) if shutil.which(RISCV_GCC) else ())
    chosen = [name for name in NAMES if name in options]
    found = {cpu: measure(cpu, chosen or NAMES) for cpu in cpus}
    found["RAM"] = {} if chosen else engines()
    before = json.loads(BASELINE.read_text(encoding="utf-8"))
    if RISCV not in cpus:
        print(f"{RISCV}: no {RISCV_GCC}, not measured")
    for cpu in cpus:
        show(cpu, found[cpu], before.get(cpu, {}))
    show_engines(found["RAM"])
    if "--update" in options and not chosen:
        REACHED.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
        return 0
    grown = list(growths(json.loads(REACHED.read_text(encoding="utf-8")), found))
    for line in grown:
        print("GREW", line)
    return 1 if grown else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
