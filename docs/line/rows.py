# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the page knows beside its module, as a constant of JavaScript: the shipped register files as they are, and each error with its cause and
its remedy as errc.hpp documents them.

  /usr/bin/python3 -B docs/line/rows.py
"""
import json
import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent
def errors():
    header = (PROJECT / "include/rtuwire/wire/errc.hpp").read_text()
    found = {}
    for comment, number in re.findall(r"((?:^    /// .*\n)+)    \w+ = (0x[0-9A-F]+),", header, re.M):
        text = re.sub(r"\s*^    /// ", " ", comment, flags=re.M).replace("`", "").strip()
        cause, _, remedy = text.partition("Remedy: ")
        found[int(number, 16)] = [cause.strip(), remedy.strip()]
    return found


print("const rows = ", end="")
files = {each.stem: each.read_text() for each in sorted((PROJECT / "tools/devices").glob("*.toml"))}
json.dump({"files": files, "errors": errors()},
          sys.stdout, ensure_ascii=True, separators=(",", ":"))
print(";")
