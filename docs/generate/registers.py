# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The tables of a drive's registers and limits, made of its descriptors."""
MODES = {"read only": "r", "read, write": "rw", "read, write at rest": "rw at rest"}


def cell(words):
    return words.replace("|", "\\|").replace("<", "&lt;")


def limits(drive):
    """What one request may do."""
    exchange = f"{drive['exchange_read']} read, {drive['exchange_write']} written" if drive["exchange_read"] != "0" else "no"
    rows = [("named", f"`rtuwire::altivar::{drive['name']}::device`" if drive["name"] != "atv310_2026" else
             "`rtuwire::altivar::atv310::device_2026`"),
            ("unit addresses", f"{drive['first_unit']} to {drive['last_unit']}"), ("functions", drive["functions"]),
            ("registers of one read (03)", drive["read"]), ("registers of one write (16)", drive["write"]),
            ("registers of one exchange (23)", exchange),
            ("longest time-out that can be set", f"{drive['longest_silence']} s"), ("registers known here", drive["size"])]
    return "\n".join(["| what | of this drive |", "| --- | --- |", *(f"| {what} | {cell(words)} |" for what, words in rows)])


def meaning(entries):
    """Bits and values in one cell."""
    return "; ".join(f"bit {words[0]}: {words[1].replace('_', ' ')}" if kind == "bit" else f"{words[0]}: {words[1]}"
                     for kind, *words in entries)


def table(drive, facts):
    lines = ["| register | address | name | lowest | highest | as delivered | step | access | source |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for each in facts.registers[drive]:
        words = (each["code"], each["address"], each["name"], each["lowest"], each["highest"], each["factory"],
                 each["step"] or each["kind"], MODES[each["mode"]], each["source"])
        lines.append("| " + " | ".join(cell(word) or "&nbsp;" for word in words) + " |")
    return "\n".join(lines)


def meanings(drive, facts):
    """Each list of meanings once, with the registers that have it."""
    shared = {}
    for each in facts.registers[drive]:
        if (drive, each["code"]) in facts.meanings:
            shared.setdefault(meaning(facts.meanings[drive, each["code"]]), []).append(each["code"])
    lines = ["| registers | what their words mean |", "| --- | --- |"]
    return "\n".join(lines + [f"| {', '.join(codes)} | {cell(words)} |" for words, codes in shared.items()])


def pages(facts):
    made = {}
    for name, drive in facts.drives.items():
        made[f"limits {name}"] = limits(drive)
        made[f"registers {name}"] = table(name, facts)
        made[f"meanings {name}"] = meanings(name, facts)
    return made
