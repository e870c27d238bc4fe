# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares the parameters of the headers, as a program prints them that walks their rows, with what the sources say of
each: address, access, unit, step, limits, factory value, values of an enumeration, bits.

    python3 compare.py PRINT_ROWS
"""
import collections
import fractions
import re
import subprocess
import sys

import facts

COLUMNS = ("part group code address access source kind unit step least most factory mnemonics meanings steps_set_by "
           "name").split()
# At most so many rows of the public list may be absent.
FEWEST_OF_PUBLIC = 1146
# A unit of the source, in units of the library.
UNITS = {"kHz": ("Hz", "1000"), "ms": ("s", "1/1000"), "mA": ("A", "1/1000"), "min": ("s", "60"),
         "mOhm": ("Ohm", "1/1000"), "mH": ("H", "1/1000"), "mV/rpm": ("V/rpm", "1/1000"), "bit/s": ("", "1")}
# Bits that the family's words have beyond those of one drive: one type describes a word for all of them.
FAMILY_WORDS = {"CMD", "CMDD", "ETA", "ETAD", "ETI", "CMI", "IL1I", "IL1R", "CIC"}
PAST = re.compile(r"(CMP|EP|IP)\d")


# Bits of the family's words in a manual that mean nothing, or that it contradicts itself about.
BITS_NOT_USED = {"ETA": {12}, "CMD": {5, 9}}
# How the source writes some factory values.
OTHER_SPELLINGS = {("BFR", "50"): "50Hz", ("TBR", "19K2"): "19200", ("TBR", "19 2"): "19200", ("INR", "0.1"): "01",
                   ("BST", "UEr"): "VEr", ("BDCO", "125 "): "125"}
# Limits that are narrower than those of the public list, or that it gives in words.
BY_ANOTHER_REGISTER = {("LSP", "most"): "HSP", ("HSP", "least"): "LSP", ("HSP", "most"): "TFR"}
LEAST_OF_A_WORD = {("atv12", "LPI"): "-1"}
# Registers for driving, of which the headers say less than the public list: it is not their source.
SAYS_LESS = {
    "atv12": {"LFRD": "least most", "RFRD": "least most", "NCV": "factory", "VCAL": "factory", "CHCF": "factory",
              "CD1": "factory", "STT": "factory", "SLL": "factory", "FLO": "factory",
              **{f"NC{word}": "factory" for word in range(1, 5)}},
    "atv310": {"LFRD": "least most", "RFRD": "least most", "TFR": "least most", "SFR": "least most factory",
               "NCV": "factory", "VCAL": "factory", "CHCF": "factory", "CD1": "factory", "STT": "factory",
               "SLL": "factory", "FLO": "factory", "LSP": "factory"},
    "atv320": {"LFRD": "factory", "LFR": "factory", "TFR": "least most", "SFR": "least most factory",
               "CHCF": "factory", "CD1": "factory", "CD2": "factory", "STT": "factory",
               "SLL": "factory", "TBR": "factory", "TFO": "factory", "TTO": "factory", "INR": "factory",
               "LSP": "factory"},
}
# Status words that the public list has as plain numbers.
MORE_IS_KNOWN = {"ETAD"}
# A register for driving of which the public list tells nothing.
BESIDE_DRIVING = {"ETAD"}
# Registers for driving that no row of the sources has under this drive.
BESIDE_THE_SOURCES = {"atv12": set(), "atv310": {"AC2", "CIC", "CMDD", "DE2", "ETAD"}, "atv320": set()}


def rows_of(program, drive):
    lines = subprocess.run([program, drive], check=True, text=True, encoding="utf-8",
                           stdout=subprocess.PIPE).stdout.splitlines()
    return [dict(zip(COLUMNS, line.split("\t"), strict=True)) for line in lines]


class Difference(Exception):
    """What a row of the headers says, and what the source."""


def same(what, ours, theirs, allowed=()):
    if ours != theirs and ours not in allowed:
        raise Difference(f"{what} is {ours!r}, the source says {theirs!r}")


def step_of(fact):
    unit, factor = UNITS.get(fact.unit, (fact.unit, "1"))
    step = fractions.Fraction(factor) * fractions.Fraction(fact.scale)
    return unit, f"{step.numerator}/{step.denominator}"


def numbers_of(text):
    return dict((int(number), name) for number, _, name in (part.partition("=") for part in text.split(";") if part))


def compare_kind(row, fact):
    """Of a register about which too little is known, kind and values are a plain word's."""
    if fact.kind in ("u16", "i16"):
        if row["code"] in MORE_IS_KNOWN:
            return same("kind", row["kind"], "bits")
        same("kind", row["kind"], fact.kind)
        if fact.has_scale:
            same("unit and step", (row["unit"], row["step"]), step_of(fact))
    elif fact.kind == "enum":
        if fact.values:
            same("kind", row["kind"], "enum")
            same("enumeration", numbers_of(row["mnemonics"]), numbers_of(fact.values))
        if row["kind"] == "enum":
            same("words for values that are none", set(numbers_of(row["meanings"])) - set(numbers_of(row["mnemonics"])),
                 set())
    elif fact.values:
        same("kind", row["kind"], "bits")
        ours, theirs = set(numbers_of(row["meanings"])), {int(bit) for bit in fact.values.split(";")}
        if fact.source == "manual" or fact.code in FAMILY_WORDS or PAST.fullmatch(fact.code):
            same("bits that are missing", theirs - ours - BITS_NOT_USED.get(fact.code, set()), set())
        else:
            same("bits", ours, theirs)


def same_or_less(row, fact, what, theirs, allowed=()):
    """The same, unless the headers may say nothing there. `used` then has it, to find permissions that nobody needs."""
    if row[what] == "" and what in SAYS_LESS[fact.drive].get(fact.code, "").split():
        used.add((fact.drive, fact.code, what))
    else:
        same(f"the value of {what}", row[what], theirs, allowed)


used = set()


def compare_limits(row, fact):
    for what in ("least", "most"):
        theirs = getattr(fact, what)
        if theirs:
            same_or_less(row, fact, what, theirs, (BY_ANOTHER_REGISTER.get((fact.code, what)),))
        elif what == "least" and fact.source == "public" and fact.kind in ("u16", "i16"):
            known = LEAST_OF_A_WORD.get((fact.drive, fact.code))
            same(f"the value of {what}", row[what], known or "", () if known else ("0", "LSP"))


def compare_factory(row, fact):
    theirs = fact.factory
    if not theirs or row["access"] == "r":
        return
    if fact.kind == "enum":
        if not fact.values or not row["mnemonics"]:
            return
        by_name = {name.upper(): number for number, name in numbers_of(row["mnemonics"]).items()}
        spelled = OTHER_SPELLINGS.get((fact.code, theirs), theirs).upper()
        theirs = str(by_name.get(theirs.upper(), by_name.get(spelled, "unknown")))
    if fact.kind != "bits":
        same_or_less(row, fact, "factory", theirs)


def compare(row, fact):
    same("address", int(row["address"]), fact.address)
    if row["part"] == "unverified":
        same("access", row["access"], "r")
        same("provenance", row["source"], "doubtful")
    elif fact.access:
        same("access", row["access"], fact.access)
    compare_kind(row, fact)
    compare_limits(row, fact)
    compare_factory(row, fact)


def complaints(program):
    table = facts.read_table()
    found = collections.Counter()
    for drive in facts.DRIVES:
        rows = rows_of(program, drive)
        for key in ("code", "address", "name"):
            for value, times in collections.Counter(row[key] for row in rows).items():
                if times > 1:
                    yield f"{drive}: {times} rows have the {key} {value}"
        by_code = {row["code"]: row for row in rows}
        of_drive = [fact for fact in table if fact.drive == drive]
        for code in sorted(set(by_code) - {fact.code for fact in of_drive} - BESIDE_THE_SOURCES[drive]):
            yield f"{drive} {code}: no source has it"
        for fact in of_drive:
            if fact.tells_nothing and fact.code not in BESIDE_DRIVING:
                if fact.code in by_code:
                    yield f"{drive} {fact.code}: the source tells nothing of it"
                continue
            if fact.code not in by_code:
                yield f"{drive} {fact.code}: is missing ({fact.source})"
                continue
            found[fact.source] += 1
            try:
                compare(by_code[fact.code], fact)
            except Difference as difference:
                yield f"{drive} {fact.code} ({fact.source}): {difference}"
    for drive, codes in SAYS_LESS.items():
        for code, what in ((code, what) for code, parts in codes.items() for what in parts.split()):
            if (drive, code, what) not in used:
                yield f"{drive} {code}: says {what}, and needs no permission to say less"
    if found["public"] < FEWEST_OF_PUBLIC:
        yield f"only {found['public']} rows of the public list are there"
    print(f"{found['public']} rows of the public list, {found['manual']} of the manuals")


def main(program):
    found = list(complaints(program))
    print("\n".join(found) or "no difference")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
