# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Programs of users, each built with the library in one of the ways that it is given out, and run: their frame is the one
of the drive's manual, or they end with another status than 0."""
import hashlib

from support import CONSUMER, LIBRARY_ALONE, PROJECT, InAFolder, archive, build, run, unpack, version

FIND = PROJECT / "tests" / "consumer" / "find_package"


class Consumers(InAFolder):
    def setUp(self):
        super().setUp()
        self.source = unpack(archive(), self.place) / f"rtuwire-{version()}"

    def installed(self, *options):
        tree, prefix = self.place / "library", self.place / "prefix"
        run("cmake", "-S", self.source, "-B", tree, "-G", "Ninja", *LIBRARY_ALONE, *options)
        run("cmake", "--install", tree, "--prefix", prefix)
        return prefix

    def test_find_package(self):
        prefix = self.installed()
        # It does not matter where an installation is moved to.
        prefix = prefix.rename(self.place / "moved")
        run(build(FIND, self.place / "build", f"-DCMAKE_PREFIX_PATH={prefix}") / "consumer")
        self.assertTrue((prefix / "share/doc/rtuwire/LICENSE").read_text(encoding="utf-8").startswith("Boost"))

    def test_find_package_finds_nothing_that_is_not_there(self):
        with self.assertRaisesRegex(AssertionError, "rtuwire"):
            build(FIND, self.place / "build", f"-DCMAKE_PREFIX_PATH={self.place / 'empty'}")

    def test_add_subdirectory(self):
        run(build(PROJECT / "tests/consumer/add_subdirectory", self.place / "build",
                  f"-Drtuwire_source={self.source}") / "consumer")

    def test_fetch_content(self):
        digest = hashlib.sha256(archive().read_bytes()).hexdigest()
        run(build(CONSUMER / "fetch_content", self.place / "build", f"-Drtuwire_archive={archive()}",
                  f"-Drtuwire_sum={digest}") / "consumer")

    def test_pkg_config(self):
        prefix = self.installed()
        moved = prefix.rename(self.place / "moved")
        found = {"PKG_CONFIG_PATH": str(moved / "share/pkgconfig")}
        self.assertEqual(run("pkg-config", "--modversion", "rtuwire", **found).strip(), version())
        flags = run("pkg-config", "--cflags", "rtuwire", **found).split()
        run("g++", "-std=c++20", *flags, FIND / "main.cpp", "-o", self.place / "consumer")
        run(self.place / "consumer")

    def test_pkg_config_where_the_folders_have_other_names(self):
        prefix = self.installed("-DCMAKE_INSTALL_INCLUDEDIR=headers/of", "-DCMAKE_INSTALL_DATADIR=lib/data")
        flags = run("pkg-config", "--cflags", "rtuwire", PKG_CONFIG_PATH=str(prefix / "lib/data/pkgconfig")).split()
        run("g++", "-std=c++20", "-fsyntax-only", *flags, FIND / "main.cpp")

    def test_meson_with_the_wrap(self):
        project = self.place / "project"
        project.mkdir()
        for file in (CONSUMER / "meson").iterdir():
            (project / file.name).write_bytes(file.read_bytes())
        unpack(archive("meson"), project)
        # In place of a download.
        cache = project / "subprojects" / "packagecache"
        cache.mkdir()
        (cache / archive().name).write_bytes(archive().read_bytes())
        run("meson", "setup", "build", cwd=project)
        run("meson", "test", "-C", "build", cwd=project)

    def test_the_single_header(self):
        one = archive().parent / "rtuwire.hpp"
        (self.place / "include" / "rtuwire").mkdir(parents=True)
        (self.place / "include" / "rtuwire" / "rtuwire.hpp").write_bytes(one.read_bytes())
        run("g++", "-std=c++20", "-I", self.place / "include", FIND / "main.cpp", "-o", self.place / "consumer")
        run(self.place / "consumer")
