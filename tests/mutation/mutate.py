# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Changes an operator or a constant in the codec, the framer, the client or the server, and looks whether
the tests see it.

    python3 tests/mutation/mutate.py [--sample N] [--seed S] [--jobs J] [headers, or folders of them]

Each change is tried in a copy of the headers with the tests of its room, one after the other: their proofs
run in the compiler, the rest in the program. The first that fails kills the change. Survivors that
survivors.txt does not explain are printed, and reasons there that are for nothing; either is a failure.
Without --sample all changes are tried.
"""
import argparse
import concurrent.futures
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = PROJECT / "include" / "rtuwire"
SURVIVORS = pathlib.Path(__file__).with_name("survivors.txt")
# Whose tests are asked, in this order.
TARGETS = {
    "core/crc16.hpp": ["core", "wire"],
    "core/crc16_algebra.hpp": ["core"],
    "core/crc16_carryless.hpp": ["core"],
    "core/crc16_tables.hpp": ["core"],
    "core/bytes.hpp": ["core", "wire"],
    "wire/adu.hpp": ["wire", "client"],
    "wire/answer.hpp": ["wire", "client"],
    "wire/frame_length.hpp": ["wire", "rtu"],
    "wire/register_view.hpp": ["wire"],
    "wire/pdu/device_identification.hpp": ["wire", "server"],
    "wire/pdu/diagnostics.hpp": ["wire", "server"],
    "wire/pdu/exception.hpp": ["wire", "server"],
    "wire/pdu/read_holding_registers.hpp": ["wire", "server"],
    "wire/pdu/read_write_multiple_registers.hpp": ["wire", "server"],
    "wire/pdu/write_multiple_registers.hpp": ["wire", "server"],
    "wire/pdu/write_single_register.hpp": ["wire", "server"],
    "rtu/exchange_of_others.hpp": ["rtu", "server", "defect"],
    "rtu/framer.hpp": ["rtu", "client", "server"],
    "rtu/line.hpp": ["rtu", "client"],
    "client/attempts.hpp": ["client"],
    "client/client.hpp": ["client", "scenario"],
    "client/echo.hpp": ["client"],
    "client/quarantine.hpp": ["client", "scenario"],
    "server/answer_frame.hpp": ["server"],
    "server/bank.hpp": ["server", "defect"],
    "server/identification.hpp": ["server", "wire"],
    "server/request.hpp": ["server", "scenario"],
    "server/respond.hpp": ["server", "scenario"],
    "server/serial_diagnostics.hpp": ["server"],
    "server/server.hpp": ["server", "scenario", "defect"],
    "server/typed_bank.hpp": ["server", "defect"],
}
# Flags for what only some processors have.
EXTRA = {"core/crc16_carryless.hpp": ["-mpclmul", "-DRTUWIRE_TEST_CARRYLESS"]}
CHANGES = [(r" == ", " != "), (r" != ", " == "), (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "),
           (r" >= ", " > "), (r" \+ ", " - "), (r" - ", " + "), (r" and ", " or "), (r" or ", " and "),
           (r"\bnot ", ""), (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
           (r"\b(\d+)U?\b", lambda match: str(int(match.group(1)) + 1) + match.group(0)[len(match.group(1)):]),
           (r"\+\+", "--")]
COMPILE = ["g++", "-std=c++20", "-w", "-O1"]
COMMON = ["algorithm", "array", "bit", "compare", "concepts", "cstddef", "cstdint", "optional", "ratio", "span",
          "string", "type_traits", "utility", "vector", "support/catch.hpp"]


def changes_of(header):
    """Each place in the code, with what it becomes."""
    found = []
    for number, line in enumerate((HEADERS / header).read_text(encoding="utf-8").splitlines()):
        code = line.split("//")[0]
        if not code.strip() or code.lstrip().startswith(("#", "static_assert", "template", "namespace")):
            continue
        if "if constexpr" in code:  # which of several equal ways a compiler takes
            continue
        for pattern, becomes in CHANGES:
            for match in re.finditer(pattern, code):
                new = becomes(match) if callable(becomes) else becomes
                found.append((header, number, code[:match.start()] + new + code[match.end():]))
    return found


def runs(command, limit):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=limit, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def sources(header):
    return [path for room in TARGETS[header]
            for path in sorted((PROJECT / "tests" / room).rglob("*.cpp"))
            if path.name != "random_drives.cpp"]


def ordered(header, seconds):
    """The header's own tests first: they see most. Then the fast ones."""
    stem = pathlib.Path(header).stem
    return sorted(sources(header), key=lambda path: (path.stem != stem, seconds[path]))


def precompiled(folder):
    """What every test includes and no change touches, translated once."""
    header = pathlib.Path(folder, "common.hpp")
    header.write_text("".join(f"#include <{name}>\n" for name in COMMON), encoding="utf-8")
    flags = [f"-I{PROJECT / 'tests'}"]
    subprocess.run([*COMPILE, *flags, "-x", "c++-header", "-o", f"{header}.gch", header], check=True)
    return [*flags, "-include", header]


def passes(path, flags, folder):
    """Whether a test's proofs hold in the compiler, and the rest of it when it runs."""
    program = pathlib.Path(folder, "test")
    return runs([*COMPILE, *flags, "-o", program, path, "-lCatch2WithMain"], 120) and \
        runs([program], 30)


def survives(change, common, order):
    """Asks the tests that killed most lately first."""
    header, number, line = change
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder, "include")
        shutil.copytree(PROJECT / "include", copy)
        place = copy / "rtuwire" / header
        lines = place.read_text(encoding="utf-8").splitlines()
        lines[number] = line
        place.write_text("\n".join(lines) + "\n", encoding="utf-8")
        flags = [*common, *EXTRA.get(header, []), f"-I{copy}"]
        for path in order[header]:
            if not passes(path, flags, folder):
                # A new list: another thread may be going through the old one.
                order[header] = sorted(order[header], key=lambda each: each != path)
                return False
    return True


def unchanged(common, targets, jobs):
    """How long each test takes where nothing was changed; all pass there, or nothing can be said."""
    def look(test):
        path, extra = test
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            if not passes(path, [*common, *extra, f"-I{PROJECT / 'include'}"], folder):
                raise SystemExit(f"mutate.py: {path.name} fails without any change")
        return path, time.monotonic() - start
    tests = sorted({(path, tuple(EXTRA.get(header, ()))) for header in targets for path in sources(header)})
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return dict(pool.map(look, tests))


def explained(targets):
    """The changes of these headers that no test can see."""
    rows = [row.split(" | ") for row in SURVIVORS.read_text(encoding="utf-8").splitlines()
            if row and not row.startswith("#")]
    return {(row[0], " | ".join(row[1:-1])) for row in rows if row[0] in targets}


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("headers", nargs="*", default=[""])
    chosen = options.parse_args()
    targets = [header for header in TARGETS if header.startswith(tuple(chosen.headers))]
    known = explained(targets)
    changes = [change for header in targets for change in changes_of(header)]
    tried = changes
    if chosen.sample:
        tried = random.Random(chosen.seed).sample(changes, chosen.sample)
    alive = []
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
        common = precompiled(folder)
        seconds = unchanged(common, targets, chosen.jobs)
        order = {header: ordered(header, seconds) for header in targets}
        outcomes = pool.map(lambda each: survives(each, common, order), tried)
        for change, lives in zip(tried, outcomes):
            header, number, line = change
            if lives:
                alive.append((header, line.strip()))
            if lives and alive[-1] not in known:
                print(f"survives: {header}:{number + 1}: {line.strip()}", flush=True)
    idle = [] if chosen.sample else sorted(known - set(alive))
    for header, line in idle:
        print(f"survivors.txt explains what is killed, or gone: {header} | {line}")
    killed = len(tried) - len(alive)
    new = sum(each not in known for each in alive)
    print(f"{killed} of {len(tried)} changes killed ({100 * killed / len(tried):.1f} %), "
          f"{len(alive) - new} explained, {new} not; {len(changes)} possible")
    return 1 if new or idle else 0


if __name__ == "__main__":
    sys.exit(main())
