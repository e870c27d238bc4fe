# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""PlatformIO's rules for a library of library.json, as its documentation gives them: which files it compiles, which folder it
adds for includes, and what a package of it has."""
import fnmatch
import re

# What PlatformIO compiles.
SOURCES = (".c", ".cc", ".cpp", ".cxx", ".c++", ".S", ".s", ".asm", ".ino")
ITEM = re.compile(r"([+-])<([^>]+)>")


def chosen(folder, rules):
    """The sources below a folder that a filter leaves: its items in their order, `+<pattern>` and `-<pattern>`."""
    found = set()
    for sign, pattern in ITEM.findall(rules):
        below = {path for path in folder.rglob("*") if path.is_file() and path.suffix in SOURCES
                 and (pattern == "*" or fnmatch.fnmatch(path.relative_to(folder).as_posix(), f"{pattern.rstrip('/')}*"))}
        found = found | below if sign == "+" else found - below
    return sorted(found)


def compiled(root, manifest):
    """The sources of the library. Without srcDir it is `src`, or where there is none, the whole library."""
    build = manifest.get("build", {})
    given = build.get("srcDir")
    folder = root / given if given else next((root / name for name in ("src", "Src") if (root / name).is_dir()), root)
    if not folder.is_dir():
        raise FileNotFoundError(f"srcDir is no folder: {given}")
    rules = build.get("srcFilter", "+<*> -<.git/> -<.svn/>")
    return chosen(folder, rules if isinstance(rules, str) else " ".join(rules))


def include_folder(root, manifest):
    folder = root / manifest.get("build", {}).get("includeDir", "include")
    if not folder.is_dir():
        raise FileNotFoundError(f"includeDir is no folder: {folder}")
    return folder


def exported(root, manifest):
    """The files of a package that is made of the library, by their place."""
    found = set()
    for pattern in manifest["export"]["include"]:
        matches = sorted(root.glob(pattern))
        if not matches:
            raise FileNotFoundError(f"export.include names nothing: {pattern}")
        for match in matches:
            found |= {path for path in match.rglob("*") if path.is_file()} if match.is_dir() else {match}
    return sorted(path.relative_to(root).as_posix() for path in found)
