# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Puts together what Doxygen reads: pages, headers, what is made of tables and tests, and the menu.

    python3 stage.py PROJECT BUILD THEME
"""
import pathlib
import re
import shutil
import subprocess
import sys

import diagrams
import gallery
import headers
import mutation
import registers
import snippets
import tables
from pages import BrokenLink, Pages, headings, identifier, lines_with_code

CONTENTS = "docs/README.md"
APPS = (("playground", "Playground"), ("line", "The line"))
ENTRY = re.compile(r"^- \[([^\]]+)\]\(([^)]+)\)")
SCRIPTS = ("fragment-copy-button", "paragraph-link", "interactive-toc")
STYLES = ("doxygen-awesome.css", "doxygen-awesome-sidebar-only.css")


def contents(pages):
    """The menu: sections, each with its pages, as the contents page lists them."""
    found = []
    for line, is_code in lines_with_code(pages.texts[CONTENTS]):
        if line.startswith("## ") and not is_code:
            found.append((line[3:].strip(), []))
        entry = ENTRY.match(line)
        if entry and found:
            found[-1][1].append((entry[1], pages.target(CONTENTS, entry[2])))
    return found


def check_contents(pages, menu):
    """Each page is in the menu."""
    listed = {to.removeprefix("@ref ") for _, entries in menu for _, to in entries if to}
    missing = [page for page in pages.texts if identifier(page) not in listed | {identifier(CONTENTS)}]
    if missing:
        raise BrokenLink(f"{CONTENTS} does not list {', '.join(missing)}")


def tab(kind, url, title, inside=""):
    words = title.replace("&", "&amp;")
    return f'<tab type="{kind}" visible="yes" url="{url}" title="{words}"{f">{inside}</tab>" if inside else "/>"}\n'


def write_layout(build, menu, apps):
    """Doxygen's own layout, with our menu in place of its own."""
    subprocess.run(["doxygen", "-l", "layout.xml"], cwd=build, check=True)
    text = (build / "layout.xml").read_text(encoding="utf-8")
    tabs = tab("mainpage", "", "First page")
    for folder, title in apps:
        tabs += tab("user", f"{folder}/index.html", title)
    for section, entries in menu:
        inside = "".join(tab("user", to, words) for words, to in entries if to)
        if section == "Reference":
            inside += tab("classlist", "", "Types", " ") + tab("namespacemembers", "", "Names by letter", " ")
            inside += tab("filelist", "", "Headers", " ")
        tabs += tab("usergroup", f"@ref {identifier(CONTENTS)}", section, inside)
    text = re.sub(r"<navindex>.*?</navindex>", lambda _: f"<navindex>{tabs}</navindex>", text, flags=re.DOTALL)
    (build / "layout.xml").write_text(text, encoding="utf-8")


def write_settings(project, build, theme):
    site = project / "docs" / "site"
    styles = [theme / name for name in STYLES] + [site / "find.css", site / "site.css"]
    files = [theme / f"doxygen-awesome-{name}.js" for name in SCRIPTS] + [site / "site.js", site / "icon.svg"]
    settings = {
        "OUTPUT_DIRECTORY": build, "INPUT": f"{build}/pages {build}/include", "STRIP_FROM_PATH": f"{build}/include {build}/pages",
        "STRIP_FROM_INC_PATH": f"{build}/include", "EXAMPLE_PATH": f"{project}/examples {build}/regions {build}/diagrams", "GENERATE_TAGFILE": build / "tags.xml", "LAYOUT_FILE": build / "layout.xml",
        "HTML_HEADER": site / "header.html", "HTML_FOOTER": site / "footer.html", "HTML_EXTRA_STYLESHEET": " ".join(map(str, styles)),
        "HTML_EXTRA_FILES": " ".join(map(str, files)), "PROJECT_NUMBER": version(project),
        "INCLUDE_PATH": f"{build}/include"}
    text = (project / "docs" / "Doxyfile").read_text(encoding="utf-8")
    text += "".join(f"{name} = {value}\n" for name, value in settings.items())
    (build / "Doxyfile").write_text(text, encoding="utf-8")


def version(project):
    header = (project / "include/rtuwire/core/version.hpp").read_text(encoding="utf-8")
    number = int(re.search(r"^#define RTUWIRE_VERSION (\d+)$", header, re.MULTILINE)[1])
    return f"{number // 10000}.{number // 100 % 100}.{number % 100}"


def write_pages(project, build, pages):
    place = build / "pages"
    for page in pages.texts:
        target = place / page
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(pages.staged(page), encoding="utf-8")
    for program in sorted(pages.programs):
        name = pathlib.PurePath(program).stem
        use = (f"A file to copy: @ref {identifier('docs/boards.md')}." if program.startswith("examples/boards/") else
               f"`sh examples/run.sh {name}` builds this program and runs it.")
        (place / f"{identifier(program)}.md").write_text(
            f"# {name} {{#{identifier(program)}}}\n\n{use}\n\n"
            f"\\include {program.removeprefix('examples/')}\n", encoding="utf-8")
    write_regions(project, build / "regions", pages)
    unused = set(pages.made) - pages.used
    if unused:
        raise BrokenLink(f"no page shows {', '.join(sorted(unused))}")


def write_regions(project, place, pages):
    """The regions that pages show, without the indentation that Doxygen 1.9.4 would keep."""
    shutil.rmtree(place, ignore_errors=True)
    texts = {}
    for file, name in sorted(pages.regions):
        mark = f"//! [{name}]\n"
        texts[file] = texts.get(file, "") + mark + snippets.region(project, file, name) + mark
    for file, text in texts.items():
        (place / file).parent.mkdir(parents=True, exist_ok=True)
        (place / file).write_text(text, encoding="utf-8")


def main(project, build, theme):
    project, build, theme = (pathlib.Path(each).resolve() for each in (project, build, theme))
    for each in ("pages", "include", "html"):
        shutil.rmtree(build / each, ignore_errors=True)
    build.mkdir(parents=True, exist_ok=True)
    facts = tables.facts(project, build)
    made = {**registers.pages(facts), **diagrams.pages(facts, build), **gallery.pages(project, build),
            **mutation.pages(project)}
    pages = Pages(project, made)
    menu = contents(pages)
    check_contents(pages, menu)
    headers.stage(project, build / "include")
    write_pages(project, build, pages)
    write_layout(build, menu, [(folder, title) for folder, title in APPS if (project / "docs" / folder / "build.sh").exists()])
    write_settings(project, build, theme)
    print(f"{len(pages.texts)} pages, {len(pages.programs)} programs, {len(made)} parts made from tables and tests; "
          f"{sum(len(headings(text)) for text in pages.texts.values())} headings")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except BrokenLink as broken:
        sys.exit(f"docs: {broken}")
