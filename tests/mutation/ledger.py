# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What is known of changes: survivors.txt explains those that no test can see, open.txt lists those that nobody
has explained yet, tried.txt tells for each header what a whole run found, and of which text. One row stands for
one place: where two equal lines survive there are two rows."""
import collections
import pathlib
import zlib

FOLDER = pathlib.Path(__file__).parent
SURVIVORS, OPEN, TRIED = (FOLDER / f"{name}.txt" for name in ("survivors", "open", "tried"))


def read(path):
    """The rows, as lists of their columns."""
    return [row.split(" | ") for row in path.read_text(encoding="utf-8").splitlines()
            if row and not row.startswith("#")]


def replace(path, chosen, rows):
    """Puts these rows in the place of those about the chosen headers."""
    head = [row for row in path.read_text(encoding="utf-8").splitlines() if row.startswith("#")]
    kept = [" | ".join(row) for row in read(path) if row[0] not in chosen]
    path.write_text("\n".join(head + sorted(kept + rows)) + "\n", encoding="utf-8")


def stamp(text):
    """A header's text, comments aside: what tried.txt knows it by."""
    code = (line.split("//")[0].strip() for line in text.splitlines())
    return f"{zlib.crc32(' '.join(' '.join(code).split()).encode()):08x}"


class Ledger:
    def __init__(self, chosen):
        self.explained = collections.Counter((row[0], " | ".join(row[1:-1])) for row in read(SURVIVORS)
                                             if row[0] in chosen)
        self.open = collections.Counter((row[0], " | ".join(row[1:])) for row in read(OPEN) if row[0] in chosen)
        self.stamps = {row[0]: row[-1] for row in read(TRIED)}

    def sort(self, alive):
        """What the survivors are, by their keys: explained, open, new; and the rows that are for none."""
        left = [collections.Counter(self.explained), collections.Counter(self.open)]
        kinds = []
        for each in alive:
            kind = next((kind for kind in (0, 1) if left[kind][each] > 0), 2)
            if kind < 2:
                left[kind][each] -= 1
            kinds.append(("explained", "open", "new")[kind])
        return kinds, sorted((left[0] + left[1]).elements())

    def changed(self, texts):
        """The headers that are not as they were when all of their changes were tried, or never were."""
        return [header for header, text in texts.items() if self.stamps.get(header) != stamp(text)]

    def write(self, texts, counts, alive):
        """What a whole run of these headers found."""
        kinds, _ = self.sort(alive)
        replace(OPEN, texts, [" | ".join(what) for what, kind in zip(alive, kinds) if kind != "explained"])
        rows = []
        for header, count in counts.items():
            survived = count["explained"] + count["open"] + count["new"]
            rows.append(" | ".join(map(str, (header, count["tried"], count["tried"] - survived, count["explained"],
                                             survived - count["explained"], stamp(texts[header])))))
        replace(TRIED, texts, rows)
