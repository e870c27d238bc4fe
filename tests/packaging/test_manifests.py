# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The forms whose tools are not at hand: their manifests are read and carried out by stubs of what those tools document,
from what the release laid out, and a program is built with the outcome and run."""
import json
import pathlib
import re
import sys

import yaml

import platformio_filter
from support import HERE, LIBRARY_ALONE, PROJECT, InAFolder, archive, build, run, unpack, version

STUBS = HERE / "stubs"
FIND = PROJECT / "tests" / "consumer" / "find_package"
MAIN = FIND / "main.cpp"
sys.path.insert(0, str(STUBS))

import conan_stub  # noqa: E402


# Where the project is, as the release was told.
HOME = r"^https://\S+/rtuwire$"


def board_compiles(board, source, *includes):
    """A file of examples/boards, with what stands for its maker's headers."""
    folders = [*includes, PROJECT / "tests/boards/stand_ins" / board]
    run("g++", "-std=c++20", "-fsyntax-only", *(word for folder in folders for word in ("-I", folder)), source)


class Form(InAFolder):
    def laid(self, registry):
        return unpack(archive(registry), self.place / registry)

    def project(self, template, **values):
        """A project of CMake's from a template."""
        text = (STUBS / template).read_text(encoding="utf-8")
        for name, value in values.items():
            text = text.replace(f"@{name}@", str(value))
        self.assertNotRegex(text, r"@[A-Z]+@")
        source = self.place / "firmware"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(text, encoding="utf-8")
        return source

    def compiles(self, include):
        run("g++", "-std=c++20", "-I", include, MAIN, "-o", self.place / "consumer")
        run(self.place / "consumer")


class Vcpkg(Form):
    def port(self):
        return self.laid("vcpkg") / "ports" / "rtuwire"

    def test_the_manifest(self):
        manifest = json.loads((self.port() / "vcpkg.json").read_text(encoding="utf-8"))
        self.assertEqual(set(manifest), {"name", "version", "description", "homepage", "license", "dependencies"})
        self.assertRegex(manifest["homepage"], HOME)
        self.assertEqual((manifest["name"], manifest["version"], manifest["license"]), ("rtuwire", version(), "BSL-1.0"))
        self.assertEqual([(each["name"], each["host"]) for each in manifest["dependencies"]],
                         [("vcpkg-cmake", True), ("vcpkg-cmake-config", True)])

    def install(self, port):
        packages = self.place / "packages"
        run("cmake", "-DPORT=rtuwire", f"-DPORTFILE={port / 'portfile.cmake'}", f"-DCURRENT_PACKAGES_DIR={packages}",
            f"-DDOWNLOADS={archive().parent}", f"-DWORK={self.place / 'work'}", "-P", STUBS / "vcpkg.cmake")
        return packages

    def test_the_port_installs_what_find_package_reads(self):
        packages = self.install(self.port())
        below = {path.relative_to(packages).parts[:2] for path in packages.rglob("*") if path.is_file()}
        self.assertEqual(below, {("include", "rtuwire"), ("share", "rtuwire"), ("share", "pkgconfig")})
        self.assertLessEqual({"copyright", "usage", "rtuwire-config.cmake", "rtuwire-config-version.cmake"},
                             {path.name for path in (packages / "share/rtuwire").iterdir()})
        run(build(FIND, self.place / "build", f"-DCMAKE_PREFIX_PATH={packages}") / "consumer")

    def test_another_archive_is_refused(self):
        port = self.port()
        file = port / "portfile.cmake"
        file.write_text(re.sub(r"SHA512 \w", "SHA512 x", file.read_text(encoding="utf-8")), encoding="utf-8")
        with self.assertRaisesRegex(AssertionError, "has the sum"):
            self.install(port)


class Conan(Form):
    def recipe(self, standard="20"):
        folder = self.laid("conan") / "recipes" / "rtuwire"
        versions = yaml.safe_load((folder / "config.yml").read_text(encoding="utf-8"))["versions"]
        self.assertEqual(versions, {version(): {"folder": "all"}})
        data = yaml.safe_load((folder / "all" / "conandata.yml").read_text(encoding="utf-8"))
        of = conan_stub.recipe_class(folder / "all" / "conanfile.py", archive().parent)
        recipe = of(version(), data, self.place, {"os": "Linux", "compiler.cppstd": standard})
        recipe.layout()
        return recipe

    def test_the_package(self):
        recipe = self.recipe()
        self.assertEqual((recipe.name, recipe.license, recipe.package_type), ("rtuwire", "BSL-1.0", "header-library"))
        self.assertRegex(recipe.homepage, HOME)
        self.assertEqual((recipe.url, recipe.author), (recipe.homepage, "The rtuwire authors"))
        recipe.validate()
        recipe.source()
        recipe.package()
        recipe.package_info()
        recipe.package_id()
        package = pathlib.Path(recipe.package_folder)
        self.assertEqual({path.name for path in package.iterdir()}, {"include", "licenses"})
        self.assertEqual((package / "licenses/LICENSE").read_bytes(), (PROJECT / "LICENSE").read_bytes())
        self.assertEqual((recipe.cpp_info.bindirs, recipe.cpp_info.libdirs, recipe.info.settings), ([], [], {}))
        self.assertEqual(recipe.cpp_info.properties["cmake_target_name"], "rtuwire::rtuwire")
        self.compiles(package / recipe.cpp_info.includedirs[0])

    def test_an_older_language_is_refused(self):
        with self.assertRaises(conan_stub.ConanInvalidConfiguration):
            self.recipe("17").validate()

    def test_the_program_that_tests_it(self):
        program = self.laid("conan") / "recipes/rtuwire/all/test_package"
        compile((program / "conanfile.py").read_text(encoding="utf-8"), "conanfile.py", "exec")
        prefix = self.place / "prefix"
        tree = self.place / "library"
        run("cmake", "-S", PROJECT, "-B", tree, "-G", "Ninja", *LIBRARY_ALONE)
        run("cmake", "--install", tree, "--prefix", prefix)
        run(build(program, self.place / "build", f"-DCMAKE_PREFIX_PATH={prefix}") / "consumer")


class EspIdf(Form):
    def check(self, component):
        manifest = yaml.safe_load((component / "idf_component.yml").read_text(encoding="utf-8"))
        self.assertLessEqual(set(manifest), {"version", "description", "license", "tags", "dependencies", "files", "url", "repository"})
        self.assertEqual((manifest["version"], manifest["dependencies"]), (version(), {"idf": ">=5.1"}))
        said = run("cmake", f"-DCOMPONENT={component}", "-P", STUBS / "esp_idf.cmake")
        self.assertIn("component registered, include include", said)
        source = self.project("esp_idf_project.txt", STUB=STUBS / "esp_idf.cmake", COMPONENT=component, MAIN=MAIN)
        run(build(source, self.place / "build") / "consumer")

    def test_the_component_of_the_release(self):
        component = self.laid("esp-idf") / "rtuwire"
        self.check(component)
        manifest = yaml.safe_load((component / "idf_component.yml").read_text(encoding="utf-8"))
        self.assertRegex(manifest["url"], HOME)
        self.assertEqual(manifest["repository"], manifest["url"] + ".git")

    def test_its_example_is_a_project(self):
        example = self.laid("esp-idf") / "rtuwire/examples/esp_idf"
        self.assertIn("include($ENV{IDF_PATH}/tools/cmake/project.cmake)", (example / "CMakeLists.txt").read_text(encoding="utf-8"))
        sources = re.findall(r'SRCS "([^"]+)"', (example / "main/CMakeLists.txt").read_text(encoding="utf-8"))
        self.assertEqual(sources, ["esp_idf.cpp"])
        needs = yaml.safe_load((example / "main/idf_component.yml").read_text(encoding="utf-8"))["dependencies"]
        self.assertEqual(needs["rtuwire"]["version"], version())
        component = (example / "main" / needs["rtuwire"]["override_path"]).resolve()
        board_compiles("esp_idf", example / "main/esp_idf.cpp", component / "include")

    def test_the_project_as_a_git_address(self):
        self.check(PROJECT)

    def test_what_is_left_out_is_there(self):
        manifest = yaml.safe_load((PROJECT / "idf_component.yml").read_text(encoding="utf-8"))
        for pattern in manifest["files"]["exclude"]:
            with self.subTest(pattern):
                folder = pattern.removesuffix("/**/*")
                self.assertTrue((PROJECT / folder).is_dir() or folder == ".github", f"{pattern} names nothing")


class Zephyr(Form):
    def check(self, module):
        described = yaml.safe_load((module / "zephyr/module.yml").read_text(encoding="utf-8"))
        self.assertEqual(set(described), {"name", "build"})
        cmake, kconfig = module / described["build"]["cmake"], module / described["build"]["kconfig"]
        self.assertRegex(kconfig.read_text(encoding="utf-8"), r"(?m)^config RTUWIRE$")
        source = self.project("zephyr_project.txt", MODULE=cmake, MAIN=MAIN, CONFIG="y")
        run(build(source, self.place / "build") / "consumer")

    def test_the_module_of_the_release(self):
        self.check(self.laid("zephyr") / "rtuwire")

    def test_a_clone_of_the_project(self):
        self.check(PROJECT / "packaging")

    def test_who_does_not_ask_gets_no_headers(self):
        source = self.project("zephyr_project.txt", MODULE=PROJECT / "packaging/zephyr", MAIN=MAIN, CONFIG="n")
        with self.assertRaisesRegex(AssertionError, "rtuwire/rtuwire.hpp: No such file"):
            build(source, self.place / "build")


class PlatformIO(Form):
    def manifest(self, root):
        return json.loads((root / "library.json").read_text(encoding="utf-8"))

    def check(self, root):
        manifest = self.manifest(root)
        for name, kind in {"name": str, "version": str, "description": str, "keywords": list, "license": str}.items():
            self.assertIsInstance(manifest[name], kind, name)
        self.assertLessEqual(len(manifest["description"]), 255)
        self.assertEqual(manifest["authors"], [{"name": "The rtuwire authors"}])
        self.assertNotIn("*", (*manifest["frameworks"], *manifest["platforms"]))
        for example in manifest["examples"]:
            for file in example["files"]:
                self.assertEqual(file, f"{example['name']}.cpp")
                self.assertTrue((root / example["base"] / file).is_file(), file)
        self.assertEqual(platformio_filter.compiled(root, manifest), [])
        include = platformio_filter.include_folder(root, manifest)
        for header in manifest["headers"]:
            self.assertTrue((include / header).is_file(), header)
        self.compiles(include)

    def test_the_project_as_a_git_address(self):
        self.check(PROJECT)

    def test_the_package_of_the_release(self):
        self.check(self.laid("platformio"))
        manifest = self.manifest(self.place / "platformio")
        self.assertRegex(manifest["homepage"], HOME)
        self.assertEqual(manifest["repository"], {"type": "git", "url": manifest["homepage"] + ".git"})

    def test_without_the_manifest_it_would_compile_everything(self):
        would = {path.relative_to(PROJECT).parts[0] for path in platformio_filter.compiled(PROJECT, {})}
        self.assertLessEqual({"bench", "fuzz", "tests", "tools"}, would)

    def test_a_package_has_what_the_manifest_says(self):
        has = platformio_filter.exported(PROJECT, self.manifest(PROJECT))
        self.assertLessEqual({"library.json", "LICENSE", "include/rtuwire/rtuwire.hpp"}, set(has))
        self.assertLessEqual({name.partition("/")[0] for name in has}, {"include", "docs", "examples", "library.json", "LICENSE", "README.md"})


class Arduino(Form):
    """By the specification of Arduino's libraries: sources and headers in src/, a library is found by a header that stands there
    itself, a sketch is a folder with an .ino of its name, whose .cpp files are compiled, too."""

    def library(self):
        return self.laid("arduino") / "rtuwire"

    def test_its_properties(self):
        lines = (self.library() / "library.properties").read_text(encoding="utf-8").splitlines()
        properties = dict(line.split("=", 1) for line in lines)
        self.assertEqual(set(properties), {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url",
                                           "architectures", "includes"})
        self.assertEqual((properties["name"], properties["version"]), ("rtuwire", version()))
        self.assertEqual(properties["category"], "Communication")  # one of those that it lists
        self.assertRegex(properties["url"], HOME)
        self.assertNotIn("*", properties["architectures"])

    def test_it_is_found_and_compiles_nothing(self):
        library = self.library()
        self.assertEqual([path.name for path in (library / "src").iterdir() if path.is_file()], ["rtuwire.h"])
        self.assertEqual([path for path in library.rglob("*") if path.suffix in (".c", ".cpp", ".S")
                          and "examples" not in path.relative_to(library).parts], [])
        self.assertEqual([path.name for path in library.iterdir() if path.is_dir() and path.name not in ("src", "examples")], [])

    def test_its_sketches(self):
        library = self.library()
        sketches = sorted((library / "examples").iterdir())
        self.assertEqual([path.name for path in sketches], ["arduino_esp32", "arduino_stream"])
        for sketch in sketches:
            ino = (sketch / f"{sketch.name}.ino").read_text(encoding="utf-8")
            found = re.findall(r"^#include <(\S+)>$", ino, re.MULTILINE)
            self.assertTrue(found and (library / "src" / found[0]).is_file(), f"{sketch.name} does not find the library")
            board_compiles(sketch.name, sketch / f"{sketch.name}.cpp", library / "src")

    def test_the_header_that_it_is_found_by(self):
        self.compiles(self.library() / "src")
        run("g++", "-std=c++20", "-fsyntax-only", "-I", self.library() / "src", "-include", "rtuwire.h", "-x", "c++", "/dev/null")
