# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds tables.cpp, runs it, and sorts its lines: the drives, their registers and the state machines."""
import concurrent.futures
import hashlib
import os
import subprocess
from dataclasses import dataclass, field

TOOL = "tools/rtuwire"
SOURCES = ("docs/generate/tables.cpp", f"{TOOL}/catalog/*.cpp", f"{TOOL}/words/words.cpp")
FLAGS = ("-std=c++20", "-O0", "-Iinclude", "-Itests", "-Itools/rtuwire")
DRIVE = ("name", "reference", "first_unit", "last_unit", "functions", "read", "write", "exchange_read", "exchange_write",
         "sll", "tto", "chcf", "longest_silence", "size")
REGISTER = ("code", "address", "name", "mode", "kind", "step", "lowest", "highest", "factory", "factory_raw", "source", "table")


@dataclass
class Facts:
    drives: dict = field(default_factory=dict)  # by name
    registers: dict = field(default_factory=dict)  # by drive, in the order of addresses
    meanings: dict = field(default_factory=dict)  # by drive and mnemonic
    profile: list = field(default_factory=list)  # number, from, cause, to
    transitions: dict = field(default_factory=dict)  # the same by drive
    steps: dict = field(default_factory=dict)  # by machine: from, input, to


def program(project, build):
    """Compiles the sources side by side."""
    place = build / "tables"
    place.mkdir(parents=True, exist_ok=True)

    def compiled(source):
        target = place / (source.replace("/", "_") + ".o")
        subprocess.run(["g++", *FLAGS, "-c", source, "-o", target], cwd=project, check=True)
        return target
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        sources = (str(path.relative_to(project)) for each in SOURCES for path in sorted(project.glob(each)))
        objects = list(pool.map(compiled, sources))
    subprocess.run(["g++", *objects, "-o", place / "tables"], check=True)
    return place / "tables"


def sorted_lines(lines):
    facts = Facts()
    for line in lines:
        kind, *words = line.split("\t")
        if kind == "drive":
            facts.drives[words[0]] = dict(zip(DRIVE, words, strict=True))
        elif kind == "register":
            facts.registers.setdefault(words[0], []).append(dict(zip(REGISTER, words[1:], strict=True)))
        elif kind in ("bit", "value"):
            facts.meanings.setdefault((words[0], words[1]), []).append((kind, *words[2:]))
        elif kind == "profile":
            facts.profile.append(words)
        elif kind == "transition":
            facts.transitions.setdefault(words[0], []).append(words[1:])
        elif kind == "step":
            facts.steps.setdefault(words[0], []).append(words[1:])
        else:
            raise ValueError(f"tables.cpp prints '{line}', which this does not know")
    for name, drive in facts.drives.items():
        if len(facts.registers[name]) != int(drive["size"]):
            raise ValueError(f"{name} has {drive['size']} registers, of which {len(facts.registers[name])} were printed")
    return facts


def sum_of(project):
    """Of all that the program is made of."""
    found = hashlib.sha256()
    for folder in ("include", "tests/support", "tests/rtu", "tests/server", "tests/client", "tools/rtuwire", "docs/generate"):
        for path in sorted((project / folder).rglob("*.[ch]pp")):
            found.update(path.read_bytes())
    return found.hexdigest()


def facts(project, build):
    """What the program prints, kept in the build tree as long as its sources stay."""
    kept = build / "tables" / f"{sum_of(project)}.txt"
    if not kept.exists():
        done = subprocess.run([program(project, build)], check=True, capture_output=True, text=True)
        kept.write_text(done.stdout, encoding="utf-8")
    return sorted_lines(kept.read_text(encoding="utf-8").splitlines())
