# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""As much of Conan 2 as the recipe imports, really copying files. `installed()` puts it where an import finds it."""
import fnmatch
import pathlib
import shutil
import sys
import tarfile
import types


class ConanFile:
    """What a recipe inherits: the folders, and notes of what it sets."""

    def __init__(self, version, conan_data, place, settings):
        self.version, self.conan_data, self.settings_at_hand = version, conan_data, settings
        self.source_folder, self.package_folder = str(place / "src"), str(place / "package")
        self.cpp_info = types.SimpleNamespace(bindirs=["bin"], libdirs=["lib"], includedirs=["include"], properties={})
        self.cpp_info.set_property = self.cpp_info.properties.__setitem__
        self.info = types.SimpleNamespace(settings=dict(settings))
        self.info.clear = self.info.settings.clear


class ConanInvalidConfiguration(Exception):
    """The settings do not suit the recipe."""


def modules(archives):
    """The modules, by name; what is fetched comes from the folder of archives, by its address's last part."""
    def get(recipe, url, sha256, strip_root):
        import hashlib
        packed = archives / url.rpartition("/")[2]
        assert hashlib.sha256(packed.read_bytes()).hexdigest() == sha256, f"{packed.name} has another sum"
        with tarfile.open(packed) as archive:
            for entry in archive.getmembers():
                assert strip_root and "/" in entry.name or entry.isdir(), entry.name
                entry.name = entry.name.partition("/")[2] or "."
                archive.extract(entry, recipe.source_folder)

    def copy(recipe, pattern, src, dst):
        copied = [path for path in sorted(pathlib.Path(src).rglob("*"))
                  if path.is_file() and fnmatch.fnmatch(path.relative_to(src).as_posix(), pattern)]
        for path in copied:
            target = pathlib.Path(dst) / path.relative_to(src)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
        return copied

    def check_min_cppstd(recipe, least):
        if int(recipe.settings_at_hand["compiler.cppstd"]) < least:
            raise ConanInvalidConfiguration(f"needs C++{least}")

    def basic_layout(recipe, src_folder):
        recipe.source_folder = str(pathlib.Path(recipe.source_folder).parent / src_folder)

    named = {"conan": {"ConanFile": ConanFile}, "conan.tools": {},
             "conan.tools.build": {"check_min_cppstd": check_min_cppstd}, "conan.tools.files": {"copy": copy, "get": get},
             "conan.tools.layout": {"basic_layout": basic_layout}}
    found = {}
    for name, contents in named.items():
        found[name] = types.ModuleType(name)
        vars(found[name]).update(contents)
    return found


def recipe_class(path, archives):
    """The recipe's class, with the stub in place of Conan while it is read."""
    mine = modules(archives)
    before = {name: sys.modules.get(name) for name in mine}
    sys.modules.update(mine)
    try:
        space = {}
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), space)
        return next(each for each in space.values() if isinstance(each, type) and issubclass(each, ConanFile)
                    and each is not ConanFile)
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module
