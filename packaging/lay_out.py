# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lays the manifests where their registries want them, an archive for each registry.

    /usr/bin/python3 -B packaging/lay_out.py SOURCE ARCHIVE OUTPUT --url URL --home HOME --epoch SECONDS

SOURCE is the unpacked ARCHIVE of a release. The manifests name its version, its address below URL, its checksums, and HOME,
where the project is: its repository. Times,
owners and order in an archive are fixed, so that the same release gives the same bytes.
"""
import argparse
import gzip
import hashlib
import io
import json
import pathlib
import sys
import tarfile
import time
import zipfile

import single_header

# What a manifest of a microcontroller's tools brings along: the library as it is used.
LIBRARY = {"include": "include", "LICENSE": "LICENSE", "README.md": "README.md"}
# By registry: what stands where, from where in the project.
REGISTRIES = {
    "conan": {"recipes/rtuwire/config.yml": "packaging/conan/config.yml",
              "recipes/rtuwire/all/conanfile.py": "packaging/conan/conanfile.py",
              "recipes/rtuwire/all/conandata.yml": "packaging/conan/conandata.yml",
              "recipes/rtuwire/all/test_package": "packaging/conan/test_package"},
    "vcpkg": {"ports/rtuwire": "packaging/vcpkg"},
    "meson": {"subprojects/rtuwire.wrap": "packaging/meson/rtuwire.wrap",
              "subprojects/packagefiles/rtuwire/meson.build": "packaging/meson/meson.build"},
    "esp-idf": {f"rtuwire/{place}": source for place, source in (LIBRARY | {
        "CMakeLists.txt": "packaging/esp-idf/component.cmake", "idf_component.yml": "idf_component.yml",
        "examples/esp_idf": "packaging/esp-idf/example",
        "examples/esp_idf/main/esp_idf.cpp": "examples/boards/esp_idf.cpp"}).items()},
    "zephyr": {f"rtuwire/{place}": source for place, source in (LIBRARY | {"zephyr": "packaging/zephyr"}).items()},
    "platformio": LIBRARY | {"library.json": "library.json", "examples/boards": "examples/boards"},
    "arduino": {f"rtuwire/{place}": source for place, source in ({
        "src": "include", "LICENSE": "LICENSE", "README.md": "README.md", "src/rtuwire.h": "packaging/arduino/rtuwire.h",
        "library.properties": "packaging/arduino/library.properties"} |
        {f"examples/{name}/{name}.{kind}": source for name in ("arduino_stream", "arduino_esp32")
         for kind, source in (("ino", "packaging/arduino/sketch.ino"), ("cpp", f"examples/boards/{name}.cpp"))}).items()},
}


def files(source, laid):
    """Each file that a registry gets: where it stands, and its bytes."""
    for place, name in laid.items():
        origin = source / name
        if not origin.exists():
            raise FileNotFoundError(f"{name} is not in the release")
        for path in sorted(origin.rglob("*")) if origin.is_dir() else [origin]:
            if path.is_file():
                below = path.relative_to(origin).as_posix() if origin.is_dir() else ""
                yield f"{place}/{below}".rstrip("/"), path.read_bytes()


def filled(content, values):
    for name, value in values.items():
        content = content.replace(f"@{name}@".encode(), value.encode())
    return content


def with_home(place, content, home):
    """The manifests that serve a clone, too, which knows its own address: they get to know it here."""
    name = place.rpartition("/")[2]
    if name == "library.json":
        manifest = json.loads(content) | {"homepage": home, "repository": {"type": "git", "url": f"{home}.git"}}
        return (json.dumps(manifest, indent=2) + "\n").encode()
    if name == "idf_component.yml" and b"description:" in content:
        return content + f'url: "{home}"\nrepository: "{home}.git"\n'.encode()
    return content


def zipped(entries, epoch):
    """The same as what Arduino imports, which is a .zip."""
    plain = io.BytesIO()
    with zipfile.ZipFile(plain, mode="w", compression=zipfile.ZIP_DEFLATED) as archive:
        for place, content in sorted(entries):
            entry = zipfile.ZipInfo(place, date_time=time.gmtime(epoch)[:6])
            entry.create_system, entry.external_attr, entry.compress_type = 3, 0o100644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return plain.getvalue()


def packed(entries, epoch):
    """A compressed archive of these files, which differs only where they do."""
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for place, content in sorted(entries):
            entry = tarfile.TarInfo(place)
            entry.size, entry.mtime, entry.mode = len(content), epoch, 0o644
            archive.addfile(entry, io.BytesIO(content))
    return gzip.compress(plain.getvalue(), mtime=0)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    for name in ("source", "archive", "output"):
        arguments.add_argument(name, type=pathlib.Path)
    arguments.add_argument("--url", required=True)
    arguments.add_argument("--home", required=True)
    arguments.add_argument("--epoch", type=int, required=True)
    asked = arguments.parse_args()
    version, archive = single_header.version_of(asked.source / "include"), asked.archive.read_bytes()
    values = {"VERSION": version, "URL": asked.url, "HOME": asked.home, "SHA256": hashlib.sha256(archive).hexdigest(),
              "SHA512": hashlib.sha512(archive).hexdigest()}
    for registry, laid in REGISTRIES.items():
        entries = [(place, with_home(place, filled(content, values), asked.home)) for place, content in files(asked.source, laid)]
        kind, pack = ("zip", zipped) if registry == "arduino" else ("tar.gz", packed)
        (asked.output / f"rtuwire-{version}-{registry}.{kind}").write_bytes(pack(entries, asked.epoch))
    return 0


if __name__ == "__main__":
    sys.exit(main())
