# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the page knows beside its module, as a constant of JavaScript: the registers of the shipped register files, and each error with its cause and
its remedy as errc.hpp documents them. What the page could not read is an error of the build.

  /usr/bin/python3 -B docs/line/rows.py
"""
import json
import pathlib
import re
import sys
import tomllib

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent
LISTS = {0: "coil", 1: "discrete", 3: "input", 4: "holding"}
TYPES = {"u16", "i16", "u32", "i32", "f32", "hex", "bits"}
KEYS = {"name", "space", "address", "type", "order", "unit", "scale", "choices", "invalid", "access", "min", "max", "group", "moves", "stored",
        "setting", "simulated"}


def place_of(register):
    space, address = register.get("space", "holding"), register["address"]
    if space == "list":
        space, address = LISTS[address // 10000], address % 10000 - 1
    form = register.get("type", "" if space in ("coil", "discrete") else "u16")
    if form and form not in TYPES or not set(register) <= KEYS:
        raise ValueError(f"{register['name']}: the page does not read {set(register) - KEYS or form}")
    return ":".join(part for part in (space, str(address), form, register.get("order", "")) if part)


def point_of(register):
    choices = ",".join(f"{name}={number}" for name, number in register.get("choices", {}).items())
    return [register["name"], place_of(register), str(register.get("scale", "")), register.get("unit", ""), choices,
            ",".join(map(str, register.get("invalid", [])))]


def device_in(path):
    told = tomllib.loads(path.read_text())
    return {"name": path.stem, "points": [point_of(each) for each in told["register"]]}


def errors():
    header = (PROJECT / "include/rtuwire/wire/errc.hpp").read_text()
    found = {}
    for comment, number in re.findall(r"((?:^    /// .*\n)+)    \w+ = (0x[0-9A-F]+),", header, re.M):
        text = re.sub(r"\s*^    /// ", " ", comment, flags=re.M).replace("`", "").strip()
        cause, _, remedy = text.partition("Remedy: ")
        found[int(number, 16)] = [cause.strip(), remedy.strip()]
    return found


print("const rows = ", end="")
json.dump({"devices": [device_in(each) for each in sorted((PROJECT / "tools/devices").glob("*.toml"))], "errors": errors()},
          sys.stdout, ensure_ascii=True, separators=(",", ":"))
print(";")
