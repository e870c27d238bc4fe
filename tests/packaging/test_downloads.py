# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a release has for people without a compiler: the tool for each system, which needs nothing of it. It is unpacked and used
where nothing else is; root, and what tests/packaging/downloads.sh made, are needed."""
import contextlib
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import time
import zipfile

from support import HERE, PROJECT, RELEASE, InAFolder, run, version

# A Debian with apt and little else, as an archive.
DEBIAN = pathlib.Path(os.environ.get("RTUWIRE_BARE_DEBIAN", PROJECT / "build/packaging/root.tar"))
SCAN = ("-p", "sim:atv320:7", "scan", "--units", "1-10")
READ = ("-p", "sim:atv320:7", "-u", "7", "read", "RFR")
NAMES = ("127.0.0.1", "localhost", "gateway.example")
# What each part's terms say.
TERMS = {"libcli11": "Redistribution and use", "nlohmann-json3": "Permission is hereby granted",
         "libtomlplusplus": "Permission is hereby granted"}
TERMS_OF_LINUX = {"libc6": "GNU Lesser General Public", "libstdc++": "GCC Runtime Library Exception",
                  "libyaml-cpp": "Permission is hereby granted"}
TERMS_OF_WINDOWS = {"mingw-w64-common": "Permission is hereby granted", "gcc-mingw": "GCC Runtime Library Exception"}
# What each Windows brings. With user32.dll a program would hear of no log-off, which has to stop a motor.
LIBRARIES_OF_WINDOWS = {"kernel32.dll", "msvcrt.dll", "ws2_32.dll", "advapi32.dll"}


class Unpacked(InAFolder):
    """An archive of the release in a folder, of the system that a class below names."""
    system = machine = None
    runner = ()

    def setUp(self):
        super().setUp()
        self.name = f"rtuwire-{version()}-{self.system}"
        self.folder = self.place / self.name
        self.program = self.folder / "bin" / "rtuwire"
        self.unpack()

    def unpack(self):
        with tarfile.open(RELEASE / f"{self.name}.tar.gz") as packed:
            self.entries = packed.getmembers()
            packed.extractall(self.place)

    def text(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def said(self, *words):
        return run(*self.runner, self.program, *words)


class OfAny:
    """What each archive has to be."""

    def test_the_program_knows_no_place_where_it_was_made(self):
        content = self.program.read_bytes()
        for place in (PROJECT, RELEASE, pathlib.Path.home(), "/tmp/", "/build", "build-linux", "/release/"):
            self.assertNotIn(str(place).encode(), content, place)

    def test_it_says_what_is_linked_under_which_licence(self):
        said = self.text("README.txt")
        self.assertNotRegex(said, "@[A-Z]+@")
        self.assertIn("Boost Software License", self.text("LICENSE"))
        named = re.findall(r"^ +(licences/\S+\.txt) +\S+$", said, re.MULTILINE)
        self.assertEqual(set(named), {f"licences/{path.name}" for path in (self.folder / "licences").glob("*.txt")})
        for part, words in {**TERMS, **self.terms}.items():
            with self.subTest(part):
                name, = (name for name in named if f"/{part}" in name)
                self.assertIn(words, " ".join(self.text(name).split()))
        self.assertIn("GNU GENERAL PUBLIC LICENSE", self.text("licences/GPL-3"))
        self.assertIn("the gateway to MQTT", said)

    def test_it_finds_a_drive_and_reads_it(self):
        self.assertIn(version(), self.said("--version"))
        self.assertRegex(self.said(*SCAN), r"(?m)^.*\b7\b.*ATV320")
        self.assertRegex(self.said(*READ), r"RFR.*Hz")

    def test_its_readme_begins_with_values_of_simulated_devices(self):
        begun = re.findall(r"^    bin[/\\]rtuwire(?:\.exe)? (-p sim:.*?)  ", self.text("README.txt"), re.MULTILINE)
        for words, what in zip(begun, (r"RFR.* Hz", r"voltage_l1.* V"), strict=True):
            self.assertRegex(self.said(*words.split()), what)

    def test_it_finds_the_register_files_from_its_own_place(self):
        self.assertEqual({path.name for path in (self.folder / "share/rtuwire/devices").iterdir()},
                         {path.name for path in (PROJECT / "tools/devices").iterdir()})
        self.assertIn("voltage_l1", self.said("-p", "sim:sdm630:1", "--device", "sdm630", "read", "voltage_l1"))


class OfLinux(OfAny):
    terms = TERMS_OF_LINUX

    def test_all_is_in_one_folder_and_nobodys(self):
        self.assertEqual({entry.name.partition("/")[0] for entry in self.entries}, {self.name})
        self.assertEqual({(entry.uid, entry.gid, entry.uname, entry.gname) for entry in self.entries}, {(0, 0, "", "")})
        self.assertEqual(len({entry.mtime for entry in self.entries}), 1)
        self.assertEqual({entry.type for entry in self.entries}, {tarfile.DIRTYPE, tarfile.REGTYPE})

    def test_it_has_what_an_installation_has(self):
        for name in ("man/man1/rtuwire.1", "bash-completion/completions/rtuwire", "zsh/vendor-completions/_rtuwire"):
            self.assertGreater((self.folder / "share" / name).stat().st_size, 1000, name)

    def test_the_program_needs_nothing_of_its_system(self):
        header = run("readelf", "-hl", self.program)
        self.assertIn(self.machine, header)
        self.assertNotIn("INTERP", header)
        self.assertNotIn("NEEDED", run("readelf", "-d", self.program))
        self.assertNotRegex(run("readelf", "-S", self.program), r"\.symtab|\.debug")

    def test_the_sources_of_its_glibc_lie_beside_it(self):
        self.assertIn("GNU LESSER GENERAL PUBLIC LICENSE", self.text("licences/LGPL-2.1"))
        linked = re.search(r"libc6-dev\.txt +(\S+)$", self.text("README.txt"), re.MULTILINE)[1]
        description = (RELEASE / f"glibc_{linked}.dsc").read_text(encoding="utf-8")
        for line in re.search(r"^Checksums-Sha256:\n((?: .*\n)+)", description, re.MULTILINE)[1].splitlines():
            total, _, name = line.split()
            self.assertEqual(hashlib.sha256((RELEASE / name).read_bytes()).hexdigest(), total)


class Linux64(OfLinux, Unpacked):
    system = "linux-x86_64"
    machine = "Advanced Micro Devices X86-64"

    def chrooted(self, root, *words):
        """The program in another root, with devices, as a booted system has them; the mounts end with it."""
        return run("unshare", "--mount", "--propagation", "private", "sh", "-euc",
                   'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec env -i HOME=/root PATH="$PATH" chroot "$0" "$@"',
                   root, f"/{self.name}/bin/rtuwire", *words)

    def debian(self):
        """A Debian with little else in which the archive was unpacked."""
        root = self.place / "debian"
        root.mkdir()
        run("tar", "-xf", DEBIAN, "-C", root)
        shutil.copy(RELEASE / f"{self.name}.tar.gz", root)
        run("chroot", root, "tar", "-xzf", f"/{self.name}.tar.gz")
        return root

    def test_a_bare_debian_within_a_minute(self):
        began = time.monotonic()
        root = self.debian()
        self.assertRegex(self.chrooted(root, "scan", "sim:atv320:7"), "ATV320")
        self.assertRegex(self.chrooted(root, *READ), "RFR.*Hz")
        self.assertLess(time.monotonic() - began, 60)

    def test_hosts_by_name_and_users_by_files_alone(self):
        """With a module of the system's that ends whatever loads it, as one of another glibc does; and where no library is."""
        debian = self.debian()
        trap = self.place / "trap.cpp"
        trap.write_text('#include <cstdlib>\n[[gnu::constructor]] void trap() { std::abort(); }\n', encoding="utf-8")
        run("g++", "-shared", "-fPIC", trap, "-o", debian / "lib/x86_64-linux-gnu/libnss_trap.so.2")
        (debian / "etc/nsswitch.conf").write_text("passwd: trap files\nhosts: trap files dns\n", encoding="utf-8")
        self.assertNotEqual(subprocess.run(["chroot", debian, "id", "somebody"], check=False, capture_output=True).returncode, 1)
        (self.place / "etc").mkdir()
        for root in (debian, self.place):
            (root / "etc/hosts").write_text("127.0.0.1 localhost\n", encoding="utf-8")
            (root / "etc/resolv.conf").write_text("nameserver 127.0.0.1\n", encoding="utf-8")
            for name in NAMES:
                with self.subTest(name, root=root):
                    said = run("unshare", "--net", sys.executable, "-B", __file__, root, f"/{self.name}/bin/rtuwire", name)
                    self.assertRegex(said, "RFR.*Hz")
        self.chrooted(debian, "-p", "sim:atv320:7", "-u", "7", "-y", "--write", "write", "ACC=2s")
        self.assertIn("root", (debian / "root/.local/state/rtuwire/writes.log").read_text(encoding="utf-8"))


class LinuxArm64(OfLinux, Unpacked):
    system = "linux-arm64"
    machine = "AArch64"
    runner = ("qemu-aarch64-static",)


class Windows64(OfAny, Unpacked):
    """In Wine."""
    system = "windows-x86_64"
    runner = ("sh", PROJECT / "tests/windows/wine.sh")
    terms = TERMS_OF_WINDOWS

    def unpack(self):
        with zipfile.ZipFile(RELEASE / f"{self.name}.zip") as packed:
            self.assertEqual({name.partition("/")[0] for name in packed.namelist()}, {self.name})
            packed.extractall(self.place)
        self.program = self.folder / "bin" / "rtuwire.exe"

    def test_the_program_needs_nothing_but_windows(self):
        needed = re.findall(r"DLL Name: (\S+)", run("objdump", "-p", self.program))
        self.assertLessEqual({name.lower() for name in needed}, LIBRARIES_OF_WINDOWS)
        self.assertIn("SYMBOL TABLE:\nno symbols", run("objdump", "-t", self.program))


def read_by_name(root, program, host):
    """In a network of its own: a name server, a drive behind Modbus TCP, and the program, which reads it by its host's name."""
    subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
    beside = [[sys.executable, "-B", HERE / "name_server.py"],
              ["chroot", root, program, "-p", "mbap://127.0.0.1:1502", "simulate", "atv320:7"]]
    with contextlib.ExitStack() as ended:
        for words in beside:
            each = ended.enter_context(subprocess.Popen(words, stdout=subprocess.PIPE, text=True))
            ended.callback(each.kill)
            each.stdout.readline()
        subprocess.run(["chroot", root, program, "-p", f"mbap://{host}:1502", "-u", "7", "read", "RFR"], check=True)


if __name__ == "__main__":
    read_by_name(*sys.argv[1:])
