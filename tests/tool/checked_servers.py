# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Our own servers, in their kinds, and the simulated drives keep every must of `check`.

    python3 checked_servers.py TOOL CHECKED_SERVER AGREEMENT_SERVER
"""
import threading

from support import DIFFERS, DONE, DRIVES, Simulator, Tool, runs

from pair import Programs  # noqa: I100

# Kind, what may be changed, how many clauses hold at least; without --disruptive where nothing counts.
KINDS = (("typed", ["--scratch", "8-15", "--readable", 8], 70), ("hooks", ["--scratch", "8-15", "--readable", 8], 70),
         ("units", ["--scratch", "8-15", "--scratch-coils", "0-15"], 110),
         ("counting", ["--scratch", "8-15", "--scratch-coils", "0-15", "--disruptive"], 120))


def judged(ended):
    """The musts that fail, and how many clauses hold."""
    rows = ended.objects() if ended.status in (DONE, DIFFERS) else []
    return ([(row["clause"], row["why"]) for row in rows if row["verdict"] == "fails" and row["level"] == "must"],
            sum(row["verdict"] == "holds" for row in rows))


def main(check, program, checked_server, agreement_server):
    with Tool(program) as tool, Programs() as others:
        found = {}

        def ask(name, port, unit, *words, before=()):
            found[name] = tool.run("--timeout", 0.5, "--no-listen", "-u", unit, "--json", *before, "check", *words,
                                   "--hostile", 5, port=port, limit=600)

        threads, least = [], {}
        for kind, words, holds in KINDS:
            near, far = others.line()
            others.serve(near, [checked_server, "@", kind])
            least[kind] = holds
            threads.append(threading.Thread(target=ask, args=(kind, far, 1, *words), kwargs={"before": ["--write"]}))
        near, far = others.line()
        others.serve(near, [agreement_server, "@"])
        least["all functions"] = 125
        threads.append(threading.Thread(target=ask, kwargs={"before": ["--write"]}, args=(
            "all functions", far, 1, "--scratch", "8-15", "--scratch-coils", "0-15", "--disruptive")))
        drives = {drive: Simulator(program, f"{drive}:3") for drive in DRIVES}
        for drive, simulator in drives.items():
            least[drive] = 45
            threads.append(threading.Thread(target=ask, args=(drive, simulator.__enter__(), 3), kwargs={"before": ["--yes"]}))
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for simulator in drives.values():
            simulator.__exit__()
    for name, ended in found.items():
        fails, holds = judged(ended)
        check(ended.status == DONE and not fails and holds >= least[name], f"{name}: every must holds",
              (ended.status, fails, holds, ended.errors[-300:]))


if __name__ == "__main__":
    runs(main)
