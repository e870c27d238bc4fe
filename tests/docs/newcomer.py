# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Types what the pages of Start show, command by command, into a fresh Debian 12, and compares what comes with what they show.

    python3 newcomer.py PROJECT ROOT

A block ```console of a page has commands behind `$ `, and below each what it prints; a line `...` stands for any lines. ROOT is a
folder for the new system, which debootstrap fills from the mirror that apt uses here. It needs root.
"""
import pathlib
import re
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PROJECT = "/root/rtuwire"
MOUNTS = (("proc", "proc", "proc"), ("devpts", "devpts", "dev/pts"), ("tmpfs", "tmpfs", "dev/shm"))
LIMIT = 3 * 3600  # seconds for one command: a test of the tests, on a slow machine


def commands(text):
    """Each command of a page, with the lines that it shows."""
    found = []
    for block in BLOCK.finditer(text):
        for line in block[1].splitlines():
            if line.startswith("$ "):
                found.append((line[2:], []))
            elif found:
                found[-1][1].append(line)
    return found


def spelled(line):
    return " ".join(line.split())


def matches(shown, printed):
    """Whether lines are those that a page shows, where `...` stands for any number of them."""
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[at:]) for at in range(len(printed) + 1))
    if not printed:
        return False
    first = spelled(shown[0])
    is_same = spelled(printed[0]).startswith(first[:-4]) if first.endswith(" ...") else spelled(printed[0]) == first
    return is_same and matches(shown[1:], printed[1:])


def mirror():
    """The address of bookworm's packages that apt takes here."""
    done = subprocess.run(["apt-get", "indextargets", "--format", "$(SITE) $(CODENAME) $(COMPONENT)", "Created-By: Packages"],
                          check=True, capture_output=True, text=True)
    for line in done.stdout.splitlines():
        site, codename, component = line.split()
        if codename == "bookworm" and component == "main":
            return site
    raise SystemExit("newcomer: apt knows no packages of bookworm here")


class Root:
    """A fresh system; its mounts last as long as the `with`."""

    def __init__(self, project, place):
        self.project, self.place = project, place
        if place.exists() and any(place.iterdir()):
            raise SystemExit(f"newcomer: {place} is not empty")

    def __enter__(self):
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", self.place, mirror()], check=True,
                       stdout=subprocess.DEVNULL)
        # As on any machine: whoever is not root gets below it, too.
        self.place.chmod(0o755)
        for name in ("resolv.conf", "hosts"):
            shutil.copy(f"/etc/{name}", self.place / "etc" / name)
        # How apt gets out of here, where that is not by itself.
        for path in pathlib.Path("/etc/apt/apt.conf.d").glob("*prox*"):
            shutil.copy(path, self.place / "etc/apt/apt.conf.d" / path.name)
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=self.project, check=True, capture_output=True).stdout
        for name in filter(None, listed.decode().split("\0")):
            target = self.place / PROJECT[1:] / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(self.project / name, target)
        for kind, source, at in MOUNTS:
            (self.place / at).mkdir(parents=True, exist_ok=True)
            subprocess.run(["mount", "-t", kind, source, self.place / at], check=True)
        return self

    def __exit__(self, *_):
        for *_, at in reversed(MOUNTS):
            subprocess.run(["umount", "--lazy", self.place / at], check=False)

    def typed(self, command):
        return subprocess.run(["chroot", self.place, "/usr/bin/env", "-i", "HOME=/root", "LANG=C.UTF-8",
                               "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "sh", "-c", f"cd {PROJECT} && {command}"],
                              check=False, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=LIMIT)


def main(project, root):
    project = pathlib.Path(project).resolve()
    pages = sorted((project / "docs" / "start").glob("*.md"))
    typed, wrong = 0, []
    with Root(project, pathlib.Path(root).resolve()) as system:
        for page in pages:
            for command, shown in commands(page.read_text(encoding="utf-8")):
                done = system.typed(command)
                typed += 1
                is_right = done.returncode == 0 and matches(shown, done.stdout.splitlines())
                print(f"{page.stem}: {'as shown' if is_right else 'NOT as shown'}: {command}", flush=True)
                if not is_right:
                    wrong.append(f"{page.stem}: {command}\nstatus {done.returncode}, printed\n{done.stdout[-3000:]}{done.stderr[-3000:]}\nshown\n" + "\n".join(shown))
    print("\n".join(wrong) or f"{typed} commands give what the pages show")
    return 1 if wrong or not typed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
