# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""State diagrams and tables of transitions, drawn from the tables that the tests hold. A diagram is part of its page, in the
colours of the page's text, so that it is legible in the dark as well."""
import re
import subprocess

HEAD = """digraph machine {{
rankdir={direction}; bgcolor="transparent"; nodesep=0.35; ranksep=0.45;
node [shape=box, style="rounded", fontname="sans-serif", fontsize=12, margin="0.14,0.07"];
edge [fontname="sans-serif", fontsize=10, arrowsize=0.7];
"""
# What happens without a command, which no table of commands has.
BY_THEMSELVES = (("power-up", "not ready to switch on", "0"), ("not ready to switch on", "switch on disabled", "1"),
                 ("quick stop active", "switch on disabled", "12: it stands"), ("any state", "fault reaction active", "13: fault"),
                 ("fault reaction active", "fault", "14"))
START = ("power-up", "any state")
NAMES = {"framer": "The framer's states", "server": "The server's phases", "client": "The client's phases"}


def quoted(words):
    return '"' + words.replace('"', "'") + '"'


def drawn(edges, direction="TB", starts=()):
    """The picture of (from, to, words) as SVG that takes its colours from the page."""
    text = HEAD.format(direction=direction)
    text += "".join(f"{quoted(name)} [shape=plaintext];\n" for name in starts)
    text += "".join(f"{quoted(begin)} -> {quoted(end)} [label={quoted(words)}];\n" for begin, end, words in edges) + "}\n"
    done = subprocess.run(["dot", "-Tsvg"], input=text, capture_output=True, text=True, check=True)
    picture = done.stdout[done.stdout.index("<svg"):]
    picture = re.sub(r"<!--.*?-->\n?", "", picture, flags=re.DOTALL)
    picture = re.sub(r"<title>.*?</title>\n?", "", picture)
    return recoloured(picture)


def recoloured(picture):
    picture = picture.replace('stroke="black"', 'stroke="currentColor"').replace('fill="black"', 'fill="currentColor"')
    return re.sub(r"<text ", '<text fill="currentColor" ', picture)


def merged(edges):
    """One arrow between two states, with all its words."""
    words = {}
    for begin, end, cause in edges:
        words.setdefault((begin, end), []).append(cause)
    return [(begin, end, "\\n".join(causes)) for (begin, end), causes in words.items()]


def joined(edges):
    """One arrow for all inputs that lead from a state to another; what changes nothing is left out."""
    changes = ((begin, end, cause) for begin, cause, end in edges if begin != end)
    return merged([word.replace("_", " ") for word in change] for change in changes)


def embedded(build, name, picture, words):
    """Doxygen takes the picture as it stands."""
    place = build / "diagrams"
    place.mkdir(parents=True, exist_ok=True)
    named = picture.replace("<svg ", f'<svg role="img" aria-label="{words}" ', 1)
    named = re.sub(r'width="(\d+)pt" height="\d+pt"', lambda found: f'width="{found[1]}"', named, count=1)
    (place / f"{name}.html").write_text(f'<div class="diagram">\n{named}</div>\n', encoding="utf-8")
    return f"\\htmlinclude[block] {name}.html"


def grid(edges):
    """The same as a table: a row for each state, a column for each input; a dot: it stays."""
    states = list(dict.fromkeys(begin for begin, _, _ in edges))
    causes = list(dict.fromkeys(cause for _, cause, _ in edges))
    leads = {(begin, cause): end for begin, cause, end in edges}
    lines = ["| in | " + " | ".join(cause.replace("_", " ") for cause in causes) + " |", "| --- " * (len(causes) + 1) + "|"]
    for state in states:
        ends = (leads[state, cause] for cause in causes)
        lines.append(f"| **{state.replace('_', ' ')}** | " +
                     " | ".join("." if end == state else end.replace("_", " ") for end in ends) + " |")
    return "\n".join(lines)


def profile_edges(transitions, automatic=True):
    edges = [(begin, end, f"{number}: {cause}") for number, begin, cause, end in transitions]
    return [*BY_THEMSELVES, *edges] if automatic else edges


def profile_table(facts):
    """Which drive has which transition."""
    drives = list(facts.transitions)
    lines = ["| number | from | command | to | " + " | ".join(drives) + " |", "| --- " * (4 + len(drives)) + "|"]
    for each in facts.profile:
        has = ("yes" if each in facts.transitions[drive] else "no" for drive in drives)
        lines.append("| " + " | ".join([*each, *has]) + " |")
    return "\n".join(lines)


def pages(facts, build):
    made = {"transitions of the drives": profile_table(facts)}
    made["diagram of a drive"] = embedded(build, "drive", drawn(merged(profile_edges(facts.profile)), starts=START),
                                          "States of the drive profile and the commands between them")
    for machine, steps in facts.steps.items():
        made[f"table of {machine}"] = grid(steps)
        if machine in NAMES:
            made[f"diagram of {machine}"] = embedded(build, machine, drawn(joined(steps)), NAMES[machine])
    return made
