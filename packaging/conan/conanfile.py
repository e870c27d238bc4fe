# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The recipe of Conan 2: headers only, one package for every setting."""
from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, get
from conan.tools.layout import basic_layout


class Rtuwire(ConanFile):
    name = "rtuwire"
    description = "Modbus RTU client and server for C++20, with the tables of Altivar drives; headers only"
    license = "BSL-1.0"
    author = "The rtuwire authors"
    homepage = "@HOME@"
    url = "@HOME@"
    topics = ("modbus", "rs-485", "embedded", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def layout(self):
        basic_layout(self, src_folder="src")

    def package_id(self):
        self.info.clear()

    def validate(self):
        check_min_cppstd(self, 20)

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def package(self):
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")
        copy(self, "*", f"{self.source_folder}/include", f"{self.package_folder}/include")

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "rtuwire")
        self.cpp_info.set_property("cmake_target_name", "rtuwire::rtuwire")
        self.cpp_info.set_property("pkg_config_name", "rtuwire")
