# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the sources say of the parameters of ATV12, ATV310 and ATV320, as facts: numbers, units, mnemonics. The sources are
two lists of registers, one of the manuals and one of public parameter files; where a checkout has no copy of them beside
it, the same facts stand in facts.tsv.

    python3 facts.py FOLDER     prints what facts.tsv has to hold
"""
import csv
import decimal
import pathlib
import re
import sys
from dataclasses import astuple, dataclass, fields

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE / "facts.tsv"
# Beside the checkout.
LISTS = HERE.parent.parent.parent / "shared" / "facts"
PUBLIC, MANUALS = "registers_public.csv", "registers.csv"
DRIVES = ("atv12", "atv310", "atv320")

AMOUNT = re.compile(r"(-?\d+(?:\.\d+)?)(?: (\S+))?")
NUMBERED = re.compile(r"(?:^|;)(b?)(\d+)=(\S*)")


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
    def has_scale(self):
        return self.scale not in ("", "?")


def counted(row, text, is_amount):
    """A number of the source in raw counts; empty where it is none, or one of another unit."""
    found = AMOUNT.fullmatch(text)
    if not found or (found[2] and found[2] != row["unit"]) or row["scale"] == "?":
        return ""
    number = decimal.Decimal(found[1])
    if is_amount and row["scale"]:
        number /= decimal.Decimal(row["scale"])
    if number != number.to_integral_value():
        raise ValueError(f"{row['drive']} {row['code']}: {text} is no whole number of {row['scale']} {row['unit']}")
    return str(int(number))


def values_of(row):
    held = NUMBERED.findall(row["enum"])
    if row["type"] == "enum":
        return ";".join(f"{number}={name}" for bit, number, name in held if not bit)
    return ";".join(number for bit, number, _ in held if bit) if row["type"] == "bits" else ""


def public_fact(row):
    is_number = row["type"] in ("u16", "i16")
    # The file of the ATV12 prints limits as amounts and factory values as counts, that of the ATV320 both as amounts.
    factory = counted(row, row["default"], row["drive"] == "atv320") if is_number else \
        (re.search(r"\(([^()]+)\)$|^\"(.+)\"$", row["default"]) or ["", "", ""])
    return Fact("public", row["drive"], row["code"], int(row["address_dec"]), row["access"], row["type"],
                "" if row["unit"] == "?" else row["unit"], row["scale"],
                counted(row, row["min"], True) if is_number else "", counted(row, row["max"], True) if is_number else "",
                factory if is_number else (factory[1] or factory[2] or "").strip(), values_of(row))


def manual_fact(row):
    number = re.compile(r"-?\d+|[A-Za-z]\w*").fullmatch
    return Fact("manual", row["drive"], row["code"].rpartition("/")[2].upper(), int(row["address_dec"]), row["access"],
                row["type"], row["unit"], row["scale"], *(row[key].upper() if number(row[key]) else ""
                                                          for key in ("min", "max")),
                re.match(r"\d*", row["default"])[0] if row["drive"] in DRIVES else "",
                values_of(row) if row["type"] == "bits" else "")


def read_lists(folder):
    found = []
    for name, fact in ((PUBLIC, public_fact), (MANUALS, manual_fact)):
        with open(pathlib.Path(folder, name), encoding="utf-8", newline="") as file:
            found += [fact(row) for row in csv.DictReader(file) if row["drive"] in DRIVES]
    return found


def read_table():
    with open(TABLE, encoding="utf-8", newline="") as file:
        return [Fact(**{**row, "address": int(row["address"])})
                for row in csv.DictReader((line for line in file if line[0] != "#"), delimiter="\t",
                                          quoting=csv.QUOTE_NONE)]


def written(facts):
    lines = ["\t".join(each.name for each in fields(Fact))]
    lines += ["\t".join(map(str, astuple(each))) for each in facts]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write("# SPDX-FileCopyrightText: 2026 The rtuwire authors\n# SPDX-License-Identifier: BSL-1.0\n")
    sys.stdout.write(written(read_lists(sys.argv[1])))
