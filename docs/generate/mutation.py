# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the last whole run of changed headers found, by room, from its own list."""


def pages(project):
    sums = {}
    for line in (project / "tests/mutation/tried.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        header, *counts = (word.strip() for word in line.split("|"))
        room = sums.setdefault(header.split("/")[0], [0] * 5)
        for at, count in enumerate([1, *map(int, counts[:4])]):
            room[at] += count
    total = [sum(column) for column in zip(*sums.values())]
    lines = ["| room | headers | changes tried | seen by a test | explained why none can | open |", "| --- | --- | --- | --- | --- | --- |"]
    for room, counts in [*sorted(sums.items()), ("**all**", total)]:
        lines.append(f"| {room} | " + " | ".join(map(str, counts)) + " |")
    return {"changes of the headers": "\n".join(lines)}
