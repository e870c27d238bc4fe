# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Register files that come with the program, found by their names, and those that it writes of its drives."""
import pathlib
import shutil
import subprocess
import tomllib

from support import DIFFERS, DONE, USAGE, Tool, runs

SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "tools" / "devices"


def check_shipped(tool, check):
    """Each is found by its name, passes the check, and says where it is from; the user's own goes before."""
    for each in SHIPPED.glob("*.toml"):
        copy = pathlib.Path(tool.program).parents[1] / "share" / "rtuwire" / "devices" / each.name
        check(copy.read_bytes() == each.read_bytes(), f"{each.name} beside the program is that of the sources")
    names = sorted(each.stem for each in SHIPPED.glob("*.toml"))
    check(names == ["delta-dtb", "sdm630", "waveshare-io8ch"], "an energy meter, an I/O module, a temperature controller", names)
    for name in names:
        ended = tool.run("device", "check", name)
        check(ended.status == DONE, f"{name} passes the check", ended)
        check("# Source: " in (SHIPPED / f"{name}.toml").read_text(), f"{name} has a source")
    found = {row["register"]: row["place"] for row in tool.run("--csv", "device", "check", "sdm630").rows()}
    check((found["voltage_l1"], found["energy_import"]) == ("input:0:f32:1V", "input:72:f32:1kWh"), "places of a meter", found)
    ended = tool.run("device", "check", "sdm63")
    check(ended.status == USAGE and "did you mean 'sdm630'?" in ended.errors, "the nearest name", ended)
    ended = tool.run("-p", "sim:sdm360:1", "read", "4")
    check(all(name in ended.errors for name in names) and "did you mean sim:sdm630:1?" in ended.errors, "all are named for sim:", ended)
    meter = SHIPPED / "sdm630.toml"
    shown = {row["register"]: row["text"] for row in tool.run("-p", f"sim:{meter}:1", "--device", meter, "--json", "read", "*").objects()}
    check((shown["voltage_l1"], shown["current_l1"], shown["frequency"]) == ("230.1 V", "4.2 A", "50 Hz"), "a simulated meter has values", shown)
    alone = tool.place / "bin" / "rtuwire"
    alone.parent.mkdir()
    shutil.copy(tool.program, alone)
    for words in (["device", "check", "sdm630"], ["-p", "sim:sdm630:1", "read", "4"]):
        ended = subprocess.run([alone, *words], check=False, capture_output=True, text=True)
        check(f"looked for in {tool.place}/share/rtuwire/devices, which is not there" in ended.stderr, "a program without its files", ended)
    ended = tool.run("-p", f"sim:{meter}:1", "--device", meter, "read", "voltage")
    check(ended.status == USAGE and "did you mean" in ended.errors and "voltage_l1" in ended.errors, "the name that begins so", ended)
    for word in ("../devices/sdm630", "sdm630.toml", "./sdm630"):
        check(tool.run("device", "check", word).status == USAGE, f"{word} is a path", word)
    own = tool.place / ".local" / "share" / "rtuwire" / "devices"
    own.mkdir(parents=True)
    (own / "sdm630.toml").write_text('[[register]]\nname = "mine"\naddress = 1\n')
    check([row["register"] for row in tool.run("--csv", "device", "check", "sdm630").rows()] == ["mine"], "the user's own")
    ended = tool.run("--device", "delta-dtb", "--json", "read", "process_value", port="sim:atv12:3")
    check("process_value" in ended.output + ended.errors, "--device takes a name", ended)


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
        check_shipped(tool, check)
        check_export(tool, check)


runs(main)
