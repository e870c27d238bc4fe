# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The changes that are no switches: each is compiled, with the tests of its room and what they prove in the
compiler, until one fails."""
import pathlib
import re
import shutil
import sys
import tempfile
import threading

from programs import COMPILE, OWN_FILE, PROJECT, TESTS, complaints, escaped, included, runs, sources

sys.path.insert(0, str(TESTS / "fail"))
import refusal  # noqa: E402  pylint: disable=wrong-import-position

# Who else is asked, beside the tests of the header's own room.
ALSO = {"core": ["wire"], "wire": ["server"], "rtu": ["server"], "ask": ["client", "defect"], "client": ["defect"], "server": ["defect"],
        "table": ["client"], "altivar": ["motion_law"]}
PROOF = re.compile(r"\bstatic_assert|\bSTATIC_(?:REQUIRE|CHECK)")


def rooms_of(header):
    """The rooms whose tests see most of a header."""
    room = header.split("/")[0]
    return [room, *ALSO.get(room, [])]


class Compiler:
    """`too_long` are the test cases that are not run."""

    def __init__(self, folder, common, headers, too_long):
        self.folder, self.common, self.headers = folder, common, headers
        self.run = ["--abort", "".join(f'~"{escaped(name)}"' for name in too_long)]
        self.lock, self.kills = threading.Lock(), {}
        self.refused = sorted((TESTS / "fail").glob("*.cpp"))

    def survives(self, change, is_switch=False):
        """What ran as a switch has only the compiler's proofs left, which need no program, and no refusals."""
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            copy = pathlib.Path(place, "include")
            shutil.copytree(self.headers, copy / "rtuwire")
            changed = copy / "rtuwire" / change.header
            changed.write_text(change.apply(changed.read_text(encoding="utf-8")), encoding="utf-8")
            flags = [*COMPILE, *self.common, f"-I{copy}"]
            paths = self.ordered(change.header, [] if is_switch else self.refused)
            if is_switch:
                paths = [path for path in paths if PROOF.search(path.read_text(encoding="utf-8"))]
            # Most are refused by the first test's proofs, which need no program.
            if complaints([*flags, "-fsyntax-only", "-x", "c++", paths[0] if paths else changed]):
                return False
            for path in paths:
                if is_switch:
                    is_fine = not complaints([*flags, "-fsyntax-only", path])
                else:
                    is_fine = self.passes(path, flags, copy, pathlib.Path(place, "test"))
                if not is_fine:
                    with self.lock:
                        self.kills[path] = self.kills.get(path, 0) + 1
                    return False
        return True

    def passes(self, path, flags, copy, program):
        if path.parent.name == "fail":
            return not refusal.complaint("g++", str(copy), str(path))
        return not complaints([*flags, "-o", program, path, self.folder / OWN_FILE, "-lCatch2WithMain", "-pthread"]) and \
            runs([program, *self.run], 60)

    def ordered(self, header, refused):
        """The header's own tests first, by name or by what they include, then those that killed most."""
        stem = pathlib.Path(header).stem
        itself = f"<rtuwire/{header}>"
        tests = [path for path in sources(rooms_of(header)) + refused if header in included(path)]
        with self.lock:
            return sorted(tests, key=lambda path: (path.stem != stem, path.stem.split("_")[0] != stem.split("_")[0],
                                                   itself not in path.read_text(encoding="utf-8"),
                                                   -self.kills.get(path, 0), path.parent.name == "fail",
                                                   path.stat().st_size))
