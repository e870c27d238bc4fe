# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the sources say of the parameters of ATV12, ATV310 and ATV320, as facts: numbers, units, mnemonics, in facts.tsv. The
sources are the manuals (`manual`) and public parameter files (`public`)."""
import csv
import pathlib
from dataclasses import dataclass

TABLE = pathlib.Path(__file__).resolve().parent / "facts.tsv"
DRIVES = ("atv12", "atv310", "atv320")


@dataclass(frozen=True)
class Fact:
    """One row of a source; what it does not tell, or tells in words, is empty."""
    source: str
    drive: str
    code: str
    address: int
    access: str   # r, rw, conf
    kind: str     # u16, i16, enum, bits
    unit: str
    scale: str    # of one count in that unit
    least: str    # in counts, or a mnemonic
    most: str
    factory: str  # in counts, or the mnemonic of a value
    values: str   # of an enumeration "0=nO;1=YES", of a word of bits "0;3;15"

    @property
    def tells_nothing(self):
        """Whether no more is known than that there is a register: it is no parameter."""
        return not any((self.access, self.unit, self.has_scale, self.least, self.most, self.factory, self.values))

    @property
    def has_scale(self):
        return self.scale not in ("", "?")


def read_table():
    with open(TABLE, encoding="utf-8", newline="") as file:
        return [Fact(**{**row, "address": int(row["address"])})
                for row in csv.DictReader((line for line in file if line[0] != "#"), delimiter="\t",
                                          quoting=csv.QUOTE_NONE)]
