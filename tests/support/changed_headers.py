# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Copies of the headers with an exact change, each of which a program has to report."""
import concurrent.futures
import pathlib
import shutil

PROJECT = pathlib.Path(__file__).resolve().parents[2]


def changed_copy(changes, folder):
    """The headers with changes, each a header below include/rtuwire, a text that stands there once, and what it becomes;
    a message where one cannot be made."""
    shutil.copytree(PROJECT / "include", folder)
    for header, text, becomes in changes:
        path = folder / "rtuwire" / header
        old = path.read_text(encoding="utf-8")
        if (found := old.count(text)) != 1:
            return f"{header} has the text {found} times, not once: {text}"
        path.write_text(old.replace(text, becomes), encoding="utf-8")
    return None


def try_all(wanted, attempt, jobs, kind):
    """Prints of each whether it was reported, as `attempt` tells, and how; 1 where one was not."""
    missed = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for each, (is_reported, says) in zip(wanted, pool.map(attempt, wanted)):
            print(f"{'reported' if is_reported else 'MISSED'}: {each.name}: {says}", flush=True)
            missed += not is_reported
    print(f"{len(wanted) - missed} of {len(wanted)} {kind} were reported")
    return 1 if missed else 0
