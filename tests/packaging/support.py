# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the tests of the packages share: where the project and the release are, programs that must succeed, archives."""
import os
import pathlib
import re
import subprocess
import tarfile
import tempfile
import unittest
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = PROJECT / "tests" / "packaging"
CONSUMER = HERE / "consumer"
# What packaging/release.sh made, and where the tests put what they make; run.sh says.
RELEASE = pathlib.Path(os.environ.get("RTUWIRE_RELEASE", PROJECT / "build" / "packaging" / "release"))
# The part of CMake's cache that keeps a library's own programs out.
LIBRARY_ALONE = ["-DRTUWIRE_BUILD_TESTS=OFF", "-DRTUWIRE_BUILD_EXAMPLES=OFF", "-DRTUWIRE_BUILD_TOOL=OFF"]


# Where the version is decided.
DECIDED = "include/rtuwire/core/version.hpp"


class InAFolder(unittest.TestCase):
    """Tests that write into `place`, which is gone afterwards."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = pathlib.Path(folder.name)


def version(root=PROJECT):
    """The version in figures, read from the header as the compiler reads it."""
    text = (root / DECIDED).read_text(encoding="utf-8")
    number = int(re.search(r"^#define RTUWIRE_VERSION (\d+)$", text, re.MULTILINE)[1])
    return f"{number // 10000}.{number // 100 % 100}.{number % 100}"


def archive(registry=""):
    """The release's archive, or that of a registry."""
    return RELEASE / f"rtuwire-{version()}{registry and '-' + registry}.{'zip' if registry == 'arduino' else 'tar.gz'}"


def unpack(path, place):
    with (zipfile.ZipFile if path.suffix == ".zip" else tarfile.open)(path) as packed:
        packed.extractall(place)
    return pathlib.Path(place)


def run(*command, cwd=None, **environment):
    """The output of a program that must succeed; what it said is part of the complaint."""
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **environment}, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def build(source, place, *options):
    """Configures and builds a project of CMake's; gives the folder of the build."""
    run("cmake", "-S", source, "-B", place, "-G", "Ninja", *options)
    run("cmake", "--build", place)
    return pathlib.Path(place)
