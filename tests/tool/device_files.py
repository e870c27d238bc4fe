# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Register files that the program writes of its drives."""
import tomllib

from support import DIFFERS, DONE, USAGE, Tool, runs


def check_export(tool, check):
    """A drive's registers: each is there, and what moves a motor is marked."""
    for drive in ("atv320", "atv12", "atv310", "atv28"):
        listed = {row["register"]: row for row in tool.run("--csv", "list", "-d", drive).rows()}
        ended = tool.run("device", "export", drive, "-o", f"{drive}.toml")
        check(ended.status in (DONE, DIFFERS) and "left out" not in ended.errors.replace("its unit is left out", ""), f"{drive} is exported whole",
              ended.errors[:300])
        checked = tool.run("device", "check", f"{drive}.toml")
        check(checked.status == DONE, f"the file of an {drive} passes the check", checked.errors)
        found = {each["address"]: each for each in tomllib.loads((tool.place / f"{drive}.toml").read_text())["register"]}
        check(set(found) == {int(row["address"]) for row in listed.values()}, "each register")
        for code in ("CMD", "LFR", "LFRD", "HSP", "LSP", "SLL"):
            if code in listed:
                check(found[int(listed[code]["address"])].get("moves") is True, f"{code} of an {drive} moves")
        wrong = [row["register"] for row in listed.values() for each in [found[int(row["address"])]]
                 if (each.get("access") == "write" and row["access"] == "read only") or
                 (each.get("setting") and (each.get("moves") or each.get("access") != "write"))]
        check(not wrong, f"what an {drive} only tells stays so, and no setting moves", wrong)
    check(tool.run("device", "export", "atv99").status == USAGE, "no such drive")


def main(check, program):
    with Tool(program) as tool:
        check_export(tool, check)


runs(main)
