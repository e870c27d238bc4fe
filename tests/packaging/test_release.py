# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""packaging/release.sh: nothing that it did not make is touched, its place is named in any way, settings of git change no
byte, and a signal leaves nothing behind. The workflow that runs it on a git host tells it all that it does not know itself."""
import os
import re
import signal
import subprocess
import unittest

import yaml

from support import PROJECT, InAFolder, run, unpack

QUICKLY = {"RTUWIRE_RELEASE_WITHOUT": "debian download docs"}


class Release(InAFolder):
    def setUp(self):
        super().setUp()
        self.clone = self.place / "clone"
        run("git", "clone", "-q", "--no-hardlinks", PROJECT, self.clone)

    def release(self, output, script="packaging/release.sh", **environment):
        return run("sh", script, output, cwd=self.clone, **QUICKLY, **environment)

    def refused(self, output, reason):
        before = self.everything()
        with self.assertRaisesRegex(AssertionError, reason):
            self.release(output)
        self.assertEqual(self.everything(), before)

    def everything(self):
        return {path: path.read_bytes() for path in self.place.rglob("*")
                if path.is_file() and self.clone not in path.parents}

    def sums(self, output):
        return (output / "SHA256SUMS").read_text(encoding="utf-8")

    def test_a_folder_that_is_no_release_stays(self):
        foreign = self.place / "downloads"
        foreign.mkdir()
        (foreign / "letter.txt").write_text("precious", encoding="utf-8")
        for sums in ("", "00  letter.txt\n", "00  letter.txt\n00  rtuwire.hpp\n"):
            with self.subTest(sums):
                (foreign / "SHA256SUMS").write_text(sums, encoding="utf-8")
                self.refused(foreign, "is no release")

    def test_a_release_with_a_file_of_somebody_else_stays(self):
        made = self.place / "made"
        self.release(made)
        (made / "notes.txt").write_text("precious", encoding="utf-8")
        self.refused(made, "holds more than one")

    def test_its_place_is_replaced_however_it_is_named(self):
        made = self.place / "made"
        beside = [self.place / "made.made", self.place / "made.work"]
        for folder in beside:
            folder.mkdir()
            (folder / "letter.txt").write_text("precious", encoding="utf-8")
        self.release(f"{made}/")
        first = self.sums(made)
        for name in (f"{made}/", f"../{made.name}", f"{self.place}/./made//"):
            with self.subTest(name):
                self.release(name)
                self.assertEqual(self.sums(made), first)
        self.assertEqual(sorted(path.name for path in self.place.iterdir()), ["clone", "made", "made.made", "made.work"])
        for folder in beside:
            self.assertEqual((folder / "letter.txt").read_text(encoding="utf-8"), "precious")

    def test_settings_of_git_change_no_byte(self):
        self.release(self.place / "plain")
        for setting, value in (("core.autocrlf", "true"), ("core.eol", "crlf"), ("tar.umask", "0077")):
            run("git", "config", setting, value, cwd=self.clone)
        self.release(self.place / "set")
        self.assertEqual(self.sums(self.place / "set"), self.sums(self.place / "plain"))

    def test_another_place_for_cd_changes_nothing(self):
        elsewhere = self.place / "elsewhere"
        (elsewhere / "packaging").mkdir(parents=True)
        self.release(self.place / "made", CDPATH=str(elsewhere))
        self.assertIn("  rtuwire.hpp\n", self.sums(self.place / "made"))

    def test_the_documentation_learns_its_address(self):
        """As docs/build.sh is told of it; that one has tests of its own."""
        (self.clone / "docs/build.sh").write_text('mkdir "$1"; echo "$SITE_ADDRESS" >"$1/address"\n', encoding="utf-8")
        run("git", "-c", "user.name=a", "-c", "user.email=a@b.invalid", "commit", "-aqm", "a", cwd=self.clone)
        home, site = "https://host.invalid/a/wire", "https://a.host.invalid/wire/"
        for number, (told, expected) in enumerate((({}, ""), ({"RTUWIRE_HOME": home}, home),
                                                   ({"RTUWIRE_HOME": home, "SITE_ADDRESS": site}, site))):
            with self.subTest(expected):
                made = self.place / f"made_{number}"
                run("sh", "packaging/release.sh", made, cwd=self.clone, RTUWIRE_RELEASE_WITHOUT="debian download", **told)
                place = unpack(next(made.glob("*-docs.tar.gz")), self.place / f"docs_{number}")
                self.assertEqual(next(place.glob("*/address")).read_text(encoding="utf-8"), f"{expected}\n")

    def test_an_archive_is_no_commit(self):
        self.release(self.place / "made")
        archive = next((self.place / "made").glob("rtuwire-[0-9.]*[0-9].tar.gz"))
        # Within another repository, too.
        for place in (self.place / "alone", self.clone / "unpacked"):
            place.mkdir()
            run("tar", "-xzf", archive, "-C", place, "--strip-components=1")
            with self.subTest(place), self.assertRaisesRegex(AssertionError, "finds no repository of its own"):
                run("sh", place / "packaging/release.sh", self.place / "again", **QUICKLY)

    def test_a_signal_leaves_nothing_behind(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number.name):
                output = self.place / f"cut_{number.name}"
                # What was started behind a shell's `&` ignores SIGINT, by nohup SIGHUP, and a shell cannot take that back.
                process = subprocess.Popen(["sh", "packaging/release.sh", str(output)], cwd=self.clone, start_new_session=True,
                                           env={**os.environ, **QUICKLY}, stdout=subprocess.PIPE, text=True,
                                           preexec_fn=lambda number=number: signal.signal(number, signal.SIG_DFL))
                self.addCleanup(process.stdout.close)
                # The first step is told when its folder is there.
                self.assertIn("archive", process.stdout.readline())
                os.killpg(process.pid, number)
                self.assertEqual(process.wait(60), 128 + number)
                self.assertEqual(list(self.place.glob("cut_*")), [])


class Workflow(unittest.TestCase):
    def setUp(self):
        super().setUp()
        self.told = yaml.safe_load((PROJECT / ".github/workflows/release.yml").read_text(encoding="utf-8"))

    def test_it_tells_each_address_that_has_none_here(self):
        script = (PROJECT / "packaging/release.sh").read_text(encoding="utf-8")
        unknown = re.findall(r"\$\{(RTUWIRE_\w+):-https://rtuwire\.invalid|\$\{(SITE_ADDRESS):-", script)
        unknown = ["".join(names) for names in unknown]
        self.assertEqual(len(unknown), 3)
        steps = [step for step in self.told["jobs"]["make"]["steps"] if "packaging/release.sh" in step.get("run", "")]
        self.assertEqual([set(step["env"]) for step in steps], [set(unknown)])

    def test_what_is_built_may_write_nothing(self):
        self.assertEqual(self.told["permissions"], {"contents": "read"})
        self.assertEqual({name: job.get("permissions") for name, job in self.told["jobs"].items()},
                         {"make": None, "publish": {"contents": "write"}})
        for step in self.told["jobs"]["make"]["steps"]:
            if "actions/checkout" in step.get("uses", ""):
                self.assertIs(step["with"]["persist-credentials"], False)
        self.assertNotIn("actions/checkout", str(self.told["jobs"]["publish"]))
