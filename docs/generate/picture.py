# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Draws what TOOL, the program `rtuwire`, shows on a terminal of 88 columns, against simulated devices: docs/pictures/tool.svg.
The text stays text, and the colours follow the reader's.

    python3 picture.py PROJECT TOOL           reports whether the picture is still what the program shows
    python3 picture.py PROJECT TOOL --write   draws it
"""
import html
import os
import pathlib
import shlex
import sys
import tempfile

TITLE = "A terminal: rtuwire finds two simulated drives, reads one, refuses a value beyond its limits, reads a meter and explains a frame"
SESSION = ("rtuwire -p sim:atv320:7,atv12:3 scan --units 1-8",
           "rtuwire -p sim:atv320:7 -u 7 read RFR ULN HMIS",
           "rtuwire -p sim:atv320:7 -u 7 --write write HSP=700Hz",
           "rtuwire -p sim:sdm630:1 -u 1 --device sdm630 read voltage_l1 power_l1 frequency",
           "rtuwire decode 07 03 0C 82 00 01 27 14")
COLUMNS, ROWS = 88, 24
LETTER, LINE, EDGE = 8, 18, 16  # of the picture
STYLE = """
.back { fill: #f6f8fa; stroke: #d0d7de; }
text { fill: #1f2328; font: 13px ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; white-space: pre; }
.typed { font-weight: bold; }
.prompt { fill: #116329; }
@media (prefers-color-scheme: dark) {
.back { fill: #151b23; stroke: #3d444d; }
text { fill: #f0f6fc; }
.prompt { fill: #7ee787; }
}
"""


def shown_by(command, environment):
    """The lines that a command leaves on its terminal."""
    from screen import Screen
    with Screen(shlex.split(command), COLUMNS, ROWS, **environment) as screen:
        if screen.end() is None:
            raise TimeoutError(f"does not end: {command}")
        if screen.shown.cursor.y == ROWS - 1:
            raise ValueError(f"more than {ROWS - 1} lines: {command}")
        return screen.text.rstrip("\n").split("\n")


def played(tool):
    """The session: each command, and what it shows."""
    with tempfile.TemporaryDirectory() as place:
        (pathlib.Path(place) / "rtuwire").symlink_to(tool)
        os.chdir(place)  # where no configuration is
        environment = {"PATH": place, "HOME": place, "XDG_CONFIG_HOME": place, "XDG_DATA_HOME": place}
        found = [(command, shown_by(command, environment)) for command in SESSION]
        os.chdir("/")
    return found


def row(at, size, words):
    """A line of text, as wide as its letters are counted, whatever font the reader has."""
    return f'<text xml:space="preserve" x="{EDGE}" y="{EDGE + (at + 1) * LINE - 5}" textLength="{size * LETTER}" ' \
        f'lengthAdjust="spacingAndGlyphs">{words}</text>'


def drawn(session):
    rows, at = [], 0
    for command, lines in session:
        rows.append(row(at, len(command) + 2, f'<tspan class="prompt">$ </tspan><tspan class="typed">{html.escape(command)}</tspan>'))
        rows += [row(at + below, len(line), html.escape(line)) for below, line in enumerate(lines, 1) if line]
        at += len(lines) + 2
    width, height = COLUMNS * LETTER + 2 * EDGE, (at - 1) * LINE + 2 * EDGE
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" role="img" '
                      f'aria-labelledby="title">', f'<title id="title">{TITLE}</title>', f"<style>{STYLE}</style>",
                      f'<rect class="back" x="0.5" y="0.5" width="{width - 1}" height="{height - 1}" rx="8"/>', *rows, "</svg>", ""])


def main(project, tool, option=""):
    project, tool = pathlib.Path(project).resolve(), pathlib.Path(tool).resolve()
    sys.path.insert(0, str(project / "tests" / "tool"))
    picture = project / "docs" / "pictures" / "tool.svg"
    text = drawn(played(tool))
    if option == "--write":
        picture.write_text(text, encoding="utf-8")
    is_same = picture.read_text(encoding="utf-8") == text
    print(f"{len(SESSION)} commands, {len(text)} bytes" if is_same else f"{picture.relative_to(project)}: the program shows\n{text}")
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
