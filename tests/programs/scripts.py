# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The project's scripts find their own folder where a shell has an exported CDPATH, which `cd` looks in first and then writes to
the output: python3 scripts.py PROJECT. The others of the same form are read."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PLAIN = re.compile(r"(?<!CDPATH='' )\bcd \"\$(?:\(dirname|[0-9])")
NO_EXAMPLE = 2


def scripts(project):
    yield from (project / ".ci" / name for name in ("run", "nightly", "parts", "cache"))
    for folder in ("bench", "docs", "examples", "fuzz", "packaging", "tests", "tools"):
        yield from sorted((project / folder).rglob("*.sh"))


def complaints(project):
    for script in scripts(project):
        for number, line in enumerate(script.read_text(encoding="utf-8").splitlines(), 1):
            if PLAIN.search(line):
                yield f"{script.relative_to(project)}:{number}: `cd` looks in CDPATH first"


def trial(project):
    """What is wrong with a script that is asked for no example, or an empty string."""
    with tempfile.TemporaryDirectory() as elsewhere:
        (pathlib.Path(elsewhere) / "examples").mkdir()
        done = subprocess.run(["sh", "examples/run.sh"], cwd=project, env={**os.environ, "CDPATH": elsewhere}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    is_right = done.returncode == NO_EXAMPLE and "\n    03_poll_a_drive\n" in done.stdout
    return "" if is_right else f"examples/run.sh: status {done.returncode}: {done.stdout}"


def main(project):
    found = [*complaints(project), *filter(None, [trial(project)])]
    print("\n".join(found) or "every script finds its folder")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
