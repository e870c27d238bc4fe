# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `check` says of clauses: their sections, and deviations and functions that a profile names.

    python3 check_profiles.py TOOL
"""
import re
import threading

from defective_servers import SCRATCH, SCRATCH_COILS, UNIT, FallsAsleep, LargestBlockRefused, Line, NothingIsAnswered
from support import DIFFERS, DONE, USAGE, Tool, runs

QUICK = ("--timeout", 0.3, "--no-listen", "-u", UNIT)

# The tables of contents of the two public documents: application protocol 1.1b3, serial line 1.02.
SECTIONS = {
    "AP": {"4.1": "Protocol description", "4.2": "Data encoding", "5.1": "Public function code definition",
           "6.1": "01 read coils", "6.2": "02 read discrete inputs", "6.3": "03 read holding registers",
           "6.4": "04 read input registers", "6.5": "05 write single coil", "6.6": "06 write single register",
           "6.8": "08 diagnostics", "6.11": "15 write multiple coils", "6.12": "16 write multiple registers",
           "6.16": "22 mask write register", "6.17": "23 read/write multiple registers", "6.18": "24 read FIFO queue",
           "6.19": "43 encapsulated interface transport", "6.21": "43/14 read device identification",
           "7": "Exception responses"},
    "SL": {"2.1": "Master/slaves protocol principle: unicast, broadcast", "2.2": "Addressing rules",
           "2.3": "Frame description: address, function, data, check", "2.4.1": "Master state diagram",
           "2.4.2": "Slave state diagram", "2.5.1": "RTU transmission mode: 256 bytes at most",
           "2.5.1.1": "Message RTU framing", "2.5.1.2": "CRC checking"}}


def sections_in(source):
    """"SL 2.1, AP 7; ..." -> document and number of each, of what stands before any words."""
    document, found = "", []
    for word in re.findall(r"AP|SL|\d+(?:\.\d+)*|[^\s,;]+", source):
        if word in SECTIONS:
            document = word
        elif re.fullmatch(r"\d+(\.\d+)*", word) and document:
            found.append((document, word))
        else:
            break
    return found


def check_sections(check, tool):
    rows = tool.run("--csv", "check", "--list").rows()
    check(len(rows) == 156, "the clauses", len(rows))
    wrong = [(row["clause"], row["source"]) for row in rows
             if not row["source"].startswith("field")
             and (not sections_in(row["source"]) or any(number not in SECTIONS[where] for where, number in sections_in(row["source"])))]
    check(not wrong, "each names sections that are there, or says that it comes from the field", wrong)
    titles = {row["clause"]: [SECTIONS[where][number] for where, number in sections_in(row["source"])] for row in rows}
    strange = [(clause, titles[clause]) for clause in titles if clause[0] == "F" and not any(
        title.startswith(clause[1:3]) or title.startswith("Exception") for title in titles[clause])]
    check(not strange, "those of a function name the function's own, or that of exceptions", strange)
    check(all(any("43" in title or "Exception" in title for title in titles[row["clause"]]) for row in rows if row["clause"][0] == "I")
          and all("08 diagnostics" in titles[row["clause"]] for row in rows if row["clause"][0] == "D"), "so do 43/14 and 08", titles)
    used = {each for row in rows for each in sections_in(row["source"])}
    check(used == {(document, number) for document, all in SECTIONS.items() for number in all}, "none is listed for nothing",
          {(document, number) for document, all in SECTIONS.items() for number in all} ^ used)


def check_deviations(check, tool, server, sleeper):
    def run(text, *words, port=server.name):
        (tool.place / "device.toml").write_text(text)
        ended = tool.run(*QUICK, "--json", "check", "--profile", "device.toml", *words, port=port)
        return ended, {row["clause"]: row for row in ended.objects()} if ended.status in (DONE, DIFFERS) else {}

    ended, rows = run("[deviations]\n\"F03.1\" = \"answers a read of none\"\n\"F03.2\" = \"once\"\n", "--only", "F03.1,F03.2")
    check(ended.status == DONE and rows["F03.1"]["verdict"] == "known deviation" and "answers a read of none" in rows["F03.1"]["why"]
          and "came to" in rows["F03.1"]["why"], "a known deviation has its reason, and does not decide", ended)
    check("known deviations by device.toml: F03.1" in ended.errors and "remove it from device.toml: F03.2" in ended.errors
          and rows["F03.2"]["verdict"] == "holds", "and one that holds is told to be removed", ended)
    ended = tool.run(*QUICK, "check", "--profile", "device.toml", "--only", "F03.1,F03.2", port=server.name)
    check("F03.1" in ended.output and "known deviation" in ended.output and "F03.2" not in ended.output, "a table shows it", ended)
    ended, rows = run("[deviations]\n\"F03.8\" = \"another\"\n", "--only", "F03.1,F03.8")
    check(ended.status == DIFFERS and rows["F03.1"]["verdict"] == "fails" and rows["F03.8"]["verdict"] == "known deviation",
          "a deviation excuses its own clause only", ended)
    ended, rows = run("[deviations]\nL01 = \"sleeps\"\n", "--only", "L01", port=sleeper.name)
    check(ended.status == DONE and rows["L01"]["verdict"] == "known deviation", "an id without a point needs no quotation marks", ended)

    for text, culprit in (("[deviations]\n\"L99\" = \"x\"\n", "device.toml:2:1: 'L99' is no clause"),
                          ("[deviations]\nF03.5 = \"x\"\n", "device.toml:2:1: the name of a clause with a point"),
                          ("[deviations]\nL16 = 3\n", "device.toml:2:7: L16 has a reason"),
                          ("[deviations]\nL16 = \"\"\n", "device.toml:2:7: L16 has a reason"),
                          ("functions = [3, 128]\n", "device.toml:1:17: a function is a number from 1 to 127"),
                          ("functions = 3\n", "device.toml:1:13: functions is a list"),
                          ("deviations = 3\n", "device.toml:1:14: deviations are a table"),
                          ("function = [3]\n", "device.toml:1:1: 'function' is no key here; did you mean 'functions'?"),
                          ("functions = [\n", "device.toml:")):
        ended, _ = run(text, "--only", "L01")
        check(ended.status == USAGE and culprit in ended.errors, f"{text!r}: {culprit}", ended)
    ended = tool.run(*QUICK, "check", "--profile", "none.toml", port=server.name)
    check(ended.status == USAGE and "none.toml" in ended.errors, "a file that is not there", ended)


def check_claims(check, tool, server):
    def run(functions, *words):
        (tool.place / "device.toml").write_text(f"functions = {functions}\n")
        ended = tool.run(*QUICK, "--json", *words, "--profile", "device.toml", "--only", "P01", port=server.name)
        return ended, (ended.objects() or [{}])[0]

    ended, row = run("[1, 2, 3, 4, 8, 0x18, 43]", "check")
    check(ended.status == DONE and row["verdict"] == "holds" and not row["why"], "all that is claimed is there", ended)
    ended, row = run("[3, 7]", "check")
    check(ended.status == DIFFERS and row["verdict"] == "fails" and "function 7 is claimed" in row["why"] and "01 87 01" in row["why"],
          "one that is refused by 01 is told", ended)
    ended, row = run("[3, 6, 100]", "check")
    check(ended.status == DONE and row["verdict"] == "holds" and row["why"].endswith(": 6, 100"),
          "what may write is not asked without a place for it", ended)
    scratch = ["--write", "check", "--scratch", SCRATCH, "--scratch-coils", SCRATCH_COILS]
    ended, row = run("[3, 5, 6, 15, 16, 22, 23]", *scratch)
    check(ended.status == DONE and row["verdict"] == "holds" and not row["why"], "and is with one", ended)
    del server.functions[22]
    ended, row = run("[6, 22]", *scratch)
    check(ended.status == DIFFERS and "function 22 is claimed, and not there" in row["why"], "which finds what is missing", ended)
    ended = tool.run(*QUICK, "--json", "check", "--only", "P01", port=server.name)
    check(ended.objects()[0]["verdict"] == "not tried" and ended.status == DONE, "without a profile nothing is claimed", ended)


def main(check, program):
    line, is_over = Line([NothingIsAnswered, FallsAsleep, LargestBlockRefused]), threading.Event()
    threading.Thread(target=line.run_until, args=(is_over.is_set,), daemon=True).start()
    with Tool(program) as tool:
        check_sections(check, tool)
        check_deviations(check, tool, line.servers[0], line.servers[1])
        check_claims(check, tool, line.servers[2])
    is_over.set()


if __name__ == "__main__":
    runs(main)
