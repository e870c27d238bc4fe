# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares two releases, file by file: python3 -B same_release.py WHOLE OTHER. The other may have left out parts; what it
has is the same, and its archive, single header and manifests are there."""
import pathlib
import sys

MUST = ("rtuwire.hpp", ".tar.gz", "-conan.tar.gz", "-esp-idf.tar.gz", "-meson.tar.gz", "-platformio.tar.gz", "-vcpkg.tar.gz",
        "-zephyr.tar.gz")


def complaints(whole, other):
    files = sorted(path.name for path in other.iterdir() if path.name != "SHA256SUMS")
    for ending in MUST:
        if not any(name.endswith(ending) for name in files):
            yield f"{other} has no file that ends with {ending}"
    for name in files:
        if not (whole / name).is_file():
            yield f"{whole} has no {name}"
        elif (whole / name).read_bytes() != (other / name).read_bytes():
            yield f"{name} differs"
    said = (other / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    if sorted(line.partition("  ")[2] for line in said) != files:
        yield f"{other}/SHA256SUMS does not list the files"


def main(whole, other):
    whole, other = pathlib.Path(whole), pathlib.Path(other)
    found = list(complaints(whole, other))
    print("\n".join(found) or f"{len(list(other.iterdir())) - 1} files are the same")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
